//! The registry of the kinds of groups.

use std::{cmp::Ordering, f64::consts::FRAC_PI_2, sync::OnceLock};

use assur_number::elementary;
use assur_plugin::{Registered, RegistryError};
use assur_words::{Text, text};

use crate::{Body, Builders, GroupFrame, Pattern};

/// The assemblies of a kind: the ways in which its links can be put together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Assemblies {
    /// The greatest number at one position, at least 1.
    pub most: usize,
    /// Whether, at a position, some of the ways may exist and others not; otherwise either all of them exist or none.
    pub varies: bool,
    /// Description of the ways in their order.
    pub words: Text,
}

/// An angle that shows how well a group transmits forces, such as the transmission angle.
#[derive(Debug, Clone)]
pub struct ForceAngle {
    /// Its name: transmission angle between the links.
    pub words: Text,
    /// Its value (rad) from the placed group and the absolute value of its health.
    pub of: fn(&GroupFrame, &[Body<f64>], f64) -> f64,
    /// It is a pressure angle, which is best at 0; a transmission angle is best at 90 degrees.
    pub is_pressure: bool,
}

impl ForceAngle {
    /// The transmission angle, rad: the angle itself, or what a pressure angle lacks of a right angle.
    pub fn transmission(&self, frame: &GroupFrame, bodies: &[Body<f64>], health: f64) -> f64 {
        let angle = (self.of)(frame, bodies, health).abs();
        if self.is_pressure { FRAC_PI_2 - angle } else { angle }
    }

    /// An angle whose sine is the health.
    pub const fn of_sine(words: Text) -> Self {
        Self {
            words,
            of: |_, _, health| {
                let (sine, cosine) = sine_and_cosine(health);
                elementary::atan2(sine, cosine)
            },
            is_pressure: false,
        }
    }

    /// An angle whose cosine is the health.
    pub const fn of_cosine(words: Text) -> Self {
        Self {
            words,
            of: |_, _, health| {
                let (sine, cosine) = sine_and_cosine(health);
                elementary::atan2(cosine, sine)
            },
            is_pressure: true,
        }
    }

    /// For a kind without an angle of its own.
    pub const DEFAULT: Self = Self::of_sine(text!("group-default-angle"));
}

/// Sine and cosine of the angle whose sine is the health: the arc tangent of both is accurate near 0 and 90 degrees.
fn sine_and_cosine(health: f64) -> (f64, f64) {
    let sine = health.min(1.0);
    (sine, ((1.0 - sine) * (1.0 + sine)).sqrt())
}

/// Entry of a kind of group in the registry: `inventory::submit! { GroupPlugin { ... } }`.
#[derive(Debug, Clone)]
pub struct GroupPlugin {
    /// Stable identifier, lower case: `rrr`.
    pub name: &'static str,
    /// Name in results: `RRR`.
    pub kind: &'static str,
    /// Type within the class; 0 where the class has no numbered types.
    pub number: u8,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// Description in one line.
    pub summary: Text,
    /// Its links and pairs: a group of this pattern may be of this kind; `None`: any group may.
    pub pattern: Option<Pattern>,
    /// Of several kinds that fit a group the one with the lowest rank is taken; of one rank the one with the fewest pairs of
    /// either sort. The kinds of this repository have 10, its last resort 200.
    pub rank: u8,
    /// Its assemblies.
    pub ways: Assemblies,
    /// Whether the solution depends on the poses that the links have on entry, as with Newton's method; `false` for
    /// closed forms.
    pub iterates: bool,
    /// Description of its singular positions.
    pub singular: Text,
    /// The angle that shows how well it transmits forces.
    pub force_angle: ForceAngle,
    /// Source of the formulas.
    pub source: Text,
    /// Builders of the kernel.
    pub builders: Builders,
}

assur_plugin::registry!(GroupPlugin, text!("group-sort"), name);

/// Registers a dyad with closed forms, which are generic over the number: `text` is the identity of its texts, and `force_angle` makes the
/// angle of words.
#[macro_export]
macro_rules! dyad {
    ($form:ident {
        name: $name:literal, kind: $kind:literal, number: $number:literal, pattern: $pattern:expr,
        ways: $ways:literal, text: $text:literal, force_angle: $angle:expr $(,)?
    }) => {
        impl $crate::ClosedKind for $form<f64> {
            type Form<T: $crate::Number> = $form<T>;
        }

        $crate::inventory::submit! {
            $crate::GroupPlugin {
                name: $name,
                kind: $kind,
                number: $number,
                crate_name: env!("CARGO_PKG_NAME"),
                summary: ::assur_words::text!($text),
                pattern: Some($pattern),
                rank: 10,
                ways: $crate::Assemblies {
                    most: $ways,
                    varies: false,
                    words: ::assur_words::text!(concat!($text, ".ways")),
                },
                iterates: false,
                singular: ::assur_words::text!(concat!($text, ".singular")),
                force_angle: $angle(::assur_words::text!(concat!($text, ".angle"))),
                source: ::assur_words::text!(concat!($text, ".source")),
                builders: $crate::Builders::in_lanes::<$form<f64>>(),
            }
        }
    };
}

/// All registered kinds, sorted by name. They are collected once.
pub fn groups() -> Result<Vec<&'static GroupPlugin>, RegistryError> {
    registered().map(<[_]>::to_vec)
}

fn registered() -> Result<&'static [&'static GroupPlugin], RegistryError> {
    static ALL: OnceLock<Result<Vec<&'static GroupPlugin>, RegistryError>> = OnceLock::new();
    ALL.get_or_init(assur_plugin::all).as_deref().map_err(Clone::clone)
}

impl GroupPlugin {
    /// Whether a group may be of this kind.
    pub fn fits(&self, frame: &GroupFrame) -> bool {
        self.pattern.is_none_or(|pattern| pattern.find(frame).is_some())
    }

    /// What decides between several kinds that fit, the least first: the rank, then the number of pairs of either sort; a
    /// kind for any group comes last in its rank.
    fn precedence(&self) -> (u8, usize) {
        (self.rank, self.pattern.map_or(usize::MAX, |pattern| pattern.open_pairs()))
    }
}

/// The registered kind of a group; of several that fit, the one with the lowest rank, then the most specific one (with the
/// fewest pairs of either sort).
pub fn plugin_for(frame: &GroupFrame) -> Result<Option<&'static GroupPlugin>, RegistryError> {
    let mut best: Option<&'static GroupPlugin> = None;
    let mut rival = None;
    for &plugin in registered()? {
        let order = best.map_or(Ordering::Less, |best| plugin.precedence().cmp(&best.precedence()));
        if order == Ordering::Greater || !plugin.fits(frame) {
            continue;
        }
        rival = best.filter(|_| order == Ordering::Equal);
        best = Some(plugin);
    }
    match (rival, best) {
        (Some(first), Some(second)) => {
            let [first, second] = [first, second].map(|plugin| (plugin.name, plugin.crate_name));
            Err(RegistryError::Ambiguous { what: GroupPlugin::WHAT, first, second })
        }
        _ => Ok(best),
    }
}
