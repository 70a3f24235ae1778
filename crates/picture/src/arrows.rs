//! Vectors on the mechanism: velocities and accelerations of its points, per unit time if the positions move, else per unit speed of the
//! coordinate; loads or reactions; the contacts of a position in any case. All of one kind have one scale, the same in all positions,
//! so that lengths can be compared; a position that is drawn alone has its own.

use std::collections::HashSet;
use std::sync::Arc;

use assur_book::Unit;
use assur_figure::{Bounds, Frame, Ink, Item, Key, Panel, Point, Sample, Scale, Stroke};
use assur_force::LoadState;
use assur_group::plane::{length, minus, plus, scaled};
use assur_kinematics::Position;
use assur_mechanism::{GROUND, LinkId, PairId};
use assur_words::{Text, measured, name, text};

use crate::acting::Acting;
use crate::plans::SMALL;
use crate::rubbing::{Rubbing, rubbing};
use crate::{Arrows, Look, Picture, Results, ViewPart, plots};

/// Longest vector, as part of the size of the drawing.
const LONGEST: f64 = 0.35;
/// Least part of the greater side of a drawing that counts as its smaller side.
const FLAT: f64 = 0.5;
/// Radius of the arc of a moment, and what each further one closer to it than this radius has more, as parts of the size of the drawing.
const ARC: [f64; 2] = [0.08, 0.03];
/// Positions that are looked at for the greatest vectors.
const LOOKED_AT: usize = 96;
/// A force below this part of the greatest is rounding.
const LEAST: f64 = 1e-9;
/// Symbols of the scales of velocities, accelerations and forces.
const SYMBOLS: [&str; 3] = ["v", "a", "F"];

/// What a vector is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Of a point: PF1, or the velocity.
    Velocity,
    /// Of a point: PF2, or the acceleration.
    Acceleration,
    Force,
    /// The first number is its size, N m, counter-clockwise.
    Moment,
}

/// A vector at its place; one without a size marks the place.
#[derive(Debug, Clone)]
pub(crate) struct Arrow {
    pub(crate) at: Point,
    pub(crate) kind: Kind,
    pub(crate) vector: [f64; 2],
    pub(crate) name: Text,
    /// What it is, in the legend beside its size.
    pub(crate) told: Text,
    pub(crate) style: (Stroke, Ink),
    /// Whether a pair exerts it.
    pub(crate) of_pair: bool,
}

/// The scale of each kind that there is, and the length, m, of a vector of size 1 in SI.
type Scales = [Option<(Scale, f64)>; 3];

/// The mechanism with its vectors, in one position or at one instant.
pub(crate) struct Shown {
    pub(crate) pose: Position,
    arrows: Vec<Arrow>,
    scales: Scales,
    /// What the vectors of all positions need.
    bounds: Bounds,
    /// Size of the drawing, m.
    size: f64,
}

impl Shown {
    /// Where the mechanism is now; `None` where it can't be assembled.
    pub(crate) fn of(results: &Results, look: &Look<'_>) -> Option<Self> {
        let (pose, own) = arrows(results, look, look.position, look.part)?;
        let count = results.positions();
        let numbers = (0..count).step_by(count.div_ceil(LOOKED_AT).max(1)).filter(|_| !look.alone);
        let others =
            || numbers.filter_map(|number| arrows(results, look, number, 0.0)).flat_map(|(_, all)| all);
        let key = (look.arrows, look.alone, results.found.is_some());
        let known = Arc::clone(results.arrows.borrow_mut().entry(key).or_insert_with(|| others().collect()));
        Some(Self::scaled(results, pose, own, &known))
    }

    /// Some links with what acts on them from outside of them, in a position; `None` where it can't be assembled.
    pub(crate) fn on_links(results: &Results, position: usize, links: &[LinkId]) -> Option<Self> {
        let (pose, state) = results.moving(position, 0.0)?;
        let mut own = Acting::on(results, links, &pose, &state);
        own.extend(of_friction(results, position, links, &pose));
        Some(Self::scaled(results, pose, own, &[]))
    }

    /// The vectors of a position, to the scales that these and the known ones need.
    fn scaled(results: &Results, pose: Position, mut own: Vec<Arrow>, known: &[Arrow]) -> Self {
        let all = || known.iter().chain(&own);
        let most = |kind: usize| {
            let of_kind = all().filter(|arrow| arrow.kind as usize == kind);
            of_kind.map(|arrow| length(arrow.vector)).fold(0.0, f64::max)
        };
        let [width, height] = results.outline.bounds.size();
        let size = width.min(height).max(FLAT * width.max(height));
        let derivatives = [1, 2].map(|order| Unit::transfer(false, results.linkage.kind(), order));
        let [first, second] = if has_motion(results) { Unit::MOVING } else { derivatives };
        let units = [first, second, Unit::FORCE];
        let scales = [0, 1, 2].map(|kind| {
            let Unit { name, factor, .. } = units[kind];
            let scale = Scale::vectors(SYMBOLS[kind], name, factor * most(kind) / (LONGEST * size));
            let length = factor / scale.size;
            (most(kind) > 0.0).then_some((scale, length))
        });
        // A moment is rounding beside what the greatest force has about the drawing, too.
        let [force, moment] = [Kind::Force, Kind::Moment].map(|kind| most(kind as usize));
        let least = [0.0, 0.0, LEAST * force, LEAST * moment.max(force * size)];
        // Vectors that are zero everywhere are left out, but not what marks a place.
        let is_seen =
            |arrow: &&Arrow| arrow.told.is_empty() || length(arrow.vector) > least[arrow.kind as usize];
        let bounds = Bounds::around(all().map(|arrow| tip(&scales, arrow)));
        let names: HashSet<Text> = all().filter(is_seen).map(|arrow| arrow.name.clone()).collect();
        own.retain(|arrow| names.contains(&arrow.name));
        Self { pose, arrows: own, scales, bounds, size }
    }

    /// All vectors.
    pub(crate) fn all(&self) -> &[Arrow] {
        &self.arrows
    }

    /// The vectors with their names.
    pub(crate) fn items(&self) -> Vec<Item> {
        self.items_longer(0.0)
    }

    /// The vectors with their names in a drawing of this size, m, but for those that would be specks in it; and the names of these.
    pub(crate) fn items_apart(&self, drawn: f64) -> (Vec<Item>, Vec<Text>) {
        let [width, height] = self.bounds.size();
        let least = SMALL * drawn.max(width).max(height);
        let is_small = |arrow: &&Arrow| {
            let long = length(minus(tip(&self.scales, arrow), arrow.at));
            arrow.kind != Kind::Moment && length(arrow.vector) > 0.0 && long < least
        };
        let small = self.arrows.iter().filter(is_small).map(|arrow| arrow.name.clone());
        (self.items_longer(least), small.collect())
    }

    /// The moments, the marks of places, and the vectors that are at least so long in the drawing, m, with their names.
    fn items_longer(&self, least: f64) -> Vec<Item> {
        let mut items = Vec::new();
        let is_seen = |arrow: &Arrow| {
            let long = length(minus(tip(&self.scales, arrow), arrow.at));
            arrow.kind == Kind::Moment || length(arrow.vector) == 0.0 || long >= least
        };
        for (index, arrow) in self.arrows.iter().enumerate().filter(|(_, arrow)| is_seen(arrow)) {
            let Arrow { at, kind, vector, name, style: (stroke, ink), .. } = arrow;
            let end = if *kind == Kind::Moment {
                // An arc goes around those that it would cross.
                let near = self.size * ARC[0];
                let here =
                    |other: &&Arrow| other.kind == Kind::Moment && length(minus(other.at, *at)) <= near;
                let before = self.arrows[..index].iter().filter(here).count();
                let radius = self.size * (ARC[0] + ARC[1] * before as f64);
                let (arc, middle) = plots::moment(*at, radius, 0.0, vector[0], *ink);
                items.extend(arc);
                middle
            } else {
                let to = tip(&self.scales, arrow);
                items.push(Item::Arrow { from: *at, to, stroke: *stroke, ink: *ink });
                to
            };
            items.push(Item::name(end, name.clone(), *ink));
        }
        items
    }

    /// What the vectors are, each force and moment with its size.
    pub(crate) fn legend(&self, results: &Results) -> Vec<Key> {
        let derivatives = ["arrow-first", "arrow-second"];
        let rates = if has_motion(results) { ["arrow-velocity", "arrow-acceleration"] } else { derivatives };
        let mut keys = Vec::new();
        for Arrow { kind, vector, name, told, style, .. } in &self.arrows {
            let size = match kind {
                Kind::Force if length(*vector) > 0.0 => measured(length(*vector), 5, "N"),
                Kind::Moment => measured(vector[0], 5, "N m"),
                Kind::Force => continue,
                // Their sizes are those of the plans.
                Kind::Velocity | Kind::Acceleration => {
                    let text = text!(rates[*kind as usize]);
                    keys.push(Key { sample: Sample::Line(style.0, style.1), text });
                    continue;
                }
            };
            keys.push(plots::key([name, told], size, None, *style));
        }
        keys.dedup();
        plots::limited(keys)
    }

    /// Gives a panel room for the vectors of all positions, and their scales.
    pub(crate) fn fit(&self, panel: &mut Panel) {
        let Frame::Plane { bounds, scales } = &mut panel.frame else { return };
        bounds.add(self.bounds.low);
        bounds.add(self.bounds.high);
        scales.extend(self.scales.iter().flatten().map(|(scale, _)| scale.clone()));
    }
}

/// The moments of the dry friction that other bodies exert on some links in their pins.
fn of_friction(results: &Results, position: usize, links: &[LinkId], pose: &Position) -> Vec<Arrow> {
    let arrow = |own: Rubbing| {
        let PairId::Pin(point) = own.pair else { return None };
        let [link, other] = own.links;
        let is_outer = links.contains(&link) && !links.contains(&other);
        is_outer.then(|| Arrow {
            at: results.linkage.point_motion(point, pose).pf0,
            kind: Kind::Moment,
            vector: [own.size, 0.0],
            name: own.symbol,
            told: own.told,
            style: (Stroke::Solid, Ink::First),
            of_pair: false,
        })
    };
    rubbing(results, position, links).into_iter().filter_map(arrow).collect()
}

/// Where a vector ends in the drawing; a moment has no end.
fn tip(scales: &Scales, Arrow { at, kind, vector, .. }: &Arrow) -> Point {
    let scale = scales.get(*kind as usize).and_then(Option::as_ref);
    scale.map_or(*at, |(_, length)| plus(*at, scaled(*length, *vector)))
}

fn has_motion(results: &Results) -> bool {
    let moves = || results.found.as_deref().is_some_and(|found| found.plans.calculation().positions_move());
    results.samples().is_some() || moves()
}

/// Why the loads or reactions that are wanted can't be drawn; `None` where they are.
pub fn missing(results: &Results, look: &Look<'_>) -> Option<Text> {
    if !matches!(look.arrows, Arrows::Applied | Arrows::Loads | Arrows::Reactions) {
        return None;
    }
    let (_, all) = arrows(results, look, look.position, look.part)?;
    all.is_empty().then(|| Picture::Forces.missing(results, look, ViewPart::Overview).0)
}

/// The mechanism and the vectors that are wanted, in a position or at an instant.
fn arrows(results: &Results, look: &Look<'_>, number: usize, part: f64) -> Option<(Position, Vec<Arrow>)> {
    let (pose, state) = results.moving(number, part)?;
    let rests = results.linkage.kind().is_time() && results.linkage.mechanism.motion.is_none();
    let kinds: &[Kind] = match look.arrows {
        _ if rests => &[],
        Arrows::Velocity => &[Kind::Velocity],
        Arrows::Acceleration => &[Kind::Acceleration],
        Arrows::Both => &[Kind::Velocity, Kind::Acceleration],
        _ => &[],
    };
    let rates = kinds.iter().flat_map(|kind| rates(results, &pose, &state, *kind));
    let all = rates.chain(Acting::of(results, look.arrows, &pose, &state)).collect();
    Some((pose, all))
}

/// v = PF1 w, a = PF2 w² + PF1 e of the moving points; without a motion PF1, PF2. Velocities are full arrows, accelerations dashed ones:
/// distinguished without color.
fn rates(results: &Results, pose: &Position, state: &LoadState, kind: Kind) -> Vec<Arrow> {
    let points = results.linkage.mechanism.points.iter().enumerate();
    let moving = points.filter(|(_, point)| point.places.iter().all(|place| place.link != GROUND));
    let given = [state.speed, state.acceleration];
    let [speed, acceleration] = if has_motion(results) { given } else { [1.0, 0.0] };
    let arrow = |(id, point): (usize, &assur_mechanism::Point)| {
        let motion = results.linkage.point_motion(id, pose);
        let (vector, style) = if kind == Kind::Velocity {
            (scaled(speed, motion.pf1), (Stroke::Solid, Ink::Velocity))
        } else {
            let vector = plus(scaled(speed * speed, motion.pf2), scaled(acceleration, motion.pf1));
            (vector, (Stroke::Dashed, Ink::Acceleration))
        };
        let name = name(SYMBOLS[kind as usize]).below(&point.name);
        Arrow { at: motion.pf0, kind, vector, name, told: Text::default(), style, of_pair: false }
    };
    moving.map(arrow).collect()
}
