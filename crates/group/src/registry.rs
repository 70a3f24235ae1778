//! The registry of the kinds of groups.

use assur_plugin::{Registered, RegistryError};

use crate::builders::{Builders, Number};
use crate::{AssurGroup, Body, BuildError, GroupFrame, Pattern};

/// The assemblies of a kind: the ways in which given links can be put together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ways {
    /// The greatest number at one position, at least 1.
    pub most: usize,
    /// Whether some of them may be missing at a position where another one exists; if not, there are all or none.
    pub varies: bool,
    /// The ways in their order, in words.
    pub words: &'static str,
}

/// An angle by which designers judge how forces pass through a group, such as the transmission angle.
#[derive(Debug, Clone, Copy)]
pub struct ForceAngle {
    /// What it is: `transmission angle between the links`.
    pub words: &'static str,
    /// Its value (rad) from the placed group and the absolute value of its health.
    pub of: fn(&GroupFrame, &[Body<f64>], f64) -> f64,
}

impl ForceAngle {
    /// The angle whose sine is the health.
    pub const fn of_sine(words: &'static str) -> Self {
        Self {
            words,
            of: |_, _, health| {
                let (sine, cosine) = sine_and_cosine(health);
                sine.atan2(cosine)
            },
        }
    }

    /// The angle whose cosine is the health.
    pub const fn of_cosine(words: &'static str) -> Self {
        Self {
            words,
            of: |_, _, health| {
                let (sine, cosine) = sine_and_cosine(health);
                cosine.atan2(sine)
            },
        }
    }

    /// For a kind without an angle of its own.
    pub const DEFAULT: Self = Self::of_sine("sine of the determinant");
}

/// Sine and cosine of the angle whose sine is the health; the arc tangent of both keeps its digits near 0 and 90 degrees.
fn sine_and_cosine(health: f64) -> (f64, f64) {
    let sine = health.min(1.0);
    (sine, ((1.0 - sine) * (1.0 + sine)).sqrt())
}

/// Entry of a kind of group in the registry: `inventory::submit! { GroupPlugin { ... } }`.
#[derive(Debug, Clone, Copy)]
pub struct GroupPlugin {
    /// Stable identifier, lower case: `rrr`.
    pub name: &'static str,
    /// As results print it: `RRR`.
    pub kind: &'static str,
    /// Type within the class; 0 where the class has no numbered types.
    pub number: u8,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// One line.
    pub summary: &'static str,
    /// Its links and pairs: a group of this pattern is of this kind.
    pub pattern: Pattern,
    /// Its assemblies.
    pub ways: Ways,
    /// Whether the place found depends on the one that the links have on entry, as with Newton's method; `false` for
    /// closed forms.
    pub iterates: bool,
    /// Where it is singular, in words.
    pub singular: &'static str,
    /// The angle that says how forces pass through it.
    pub force_angle: ForceAngle,
    /// Where the formulas are from.
    pub source: &'static str,
    /// Builders of the kernel.
    pub builders: Builders,
}

inventory::collect!(GroupPlugin);

impl Registered for GroupPlugin {
    const WHAT: &'static str = "group";

    fn name(&self) -> &'static str {
        self.name
    }

    fn crate_name(&self) -> &'static str {
        self.crate_name
    }
}

/// All registered kinds, sorted by name.
///
/// # Errors
///
/// [`RegistryError`] where two have one name or none is registered.
pub fn groups() -> Result<Vec<&'static GroupPlugin>, RegistryError> {
    assur_plugin::all()
}

/// The registered kind of a group; of two that match, the one with fewer pairs of any sort, then the first name.
///
/// # Errors
///
/// [`RegistryError`] where the registry is faulty.
pub fn plugin_for(frame: &GroupFrame) -> Result<Option<&'static GroupPlugin>, RegistryError> {
    let all = groups()?;
    Ok(all
        .into_iter()
        .filter(|plugin| plugin.pattern.find(frame).is_some())
        .min_by_key(|plugin| (plugin.pattern.open_pairs(), plugin.name)))
}

/// The kernel of a group in one number type.
///
/// # Errors
///
/// [`BuildError`] where the lengths make no group of this kind.
pub fn kernel_of<T: Number>(
    plugin: &GroupPlugin,
    frame: &GroupFrame,
) -> Result<Box<dyn AssurGroup<T>>, BuildError> {
    T::build(&plugin.builders, frame)
}
