//! A planar linkage as plain data: links, points, pairs, loads, motion, drive.
//!
//! Units are SI (m, kg, s, rad, N), angles are counter-clockwise, y points up. Nothing here reads a file, solves an
//! equation or prints. Link 0 is always the ground; links, points and slides are in the order of the scene.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod drive;
mod friction;
mod inertia;
mod input;
mod key;
mod law;
mod load;
mod name;
mod numbers;
mod point;
mod size;
mod time_law;
mod warning;

pub use assur_words::CoordinateKind;
pub use drive::{
    CharacteristicKind, Drive, FlywheelPlace, Motion, MotorChoice, RatedMotor, Solve, StepLength, Torque,
    Until, passage,
};
pub use friction::{Friction, Middle, Surfaces};
pub use inertia::{Inertia, VaryingInertia};
pub use input::{Driver, Input, InputPair, Range, Sense};
pub use key::{Key, Step};
pub use law::{LawTable, Over, Shape, Value};
pub use load::{Balance, Brake, Contact, Direction, Force, Load, LoadKind, Moment, Spring};
pub use name::{Name, Named, appearance, likeness};
pub use numbers::links_of_length_zero;
pub use point::ReductionPoint;
pub use size::{
    LONGEST_NAME, MOST_KEPT, MOST_LINKS, MOST_LOADS, MOST_PARTS_DRAWN, MOST_PARTS_KEPT, MOST_PARTS_SAMPLED,
    MOST_PLACES, MOST_SAMPLES, MOST_SLIDES, MOST_STEPS_KEPT,
};
pub use time_law::{Pieces, TimeLaw};
pub use warning::{Warning, WarningKind};

assur_words::resources!();

/// Index of a link in [`Mechanism::links`]; [`GROUND`] is the ground.
pub type LinkId = usize;
/// Index of a point in [`Mechanism::points`].
pub type PointId = usize;
/// Index of a slide in [`Mechanism::slides`].
pub type SlideId = usize;
/// Index of a load in [`Mechanism::loads`].
pub type LoadId = usize;

/// The ground, the fixed link of the mechanism.
pub const GROUND: LinkId = 0;

/// A mechanism with its loads, motion and drive.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mechanism {
    /// Title in one line, for headers; may be empty.
    pub title: Name,
    /// The ground, then the moving links.
    pub links: Vec<Link>,
    /// Every named point; one that belongs to two or more links is a pin.
    pub points: Vec<Point>,
    /// The prismatic pairs.
    pub slides: Vec<Slide>,
    /// The input link and the positions to calculate.
    pub input: Input,
    /// Rough positions (m, ground frame) of points in the first position, which choose the assembly.
    pub assembly: Vec<(PointId, [f64; 2])>,
    /// Acceleration of gravity, m/s², ground frame; `None`: links have no weight.
    pub gravity: Option<[f64; 2]>,
    /// The loads: of a scene its forces, moments, brakes, springs and contacts, in this order.
    pub loads: Vec<Load>,
    /// Dry friction in pairs; none in the others.
    pub frictions: Vec<Friction>,
    /// The load that keeps the mechanism in its prescribed motion, if it does not act on the input link.
    pub balance: Option<Balance>,
    /// Motion of the input; `None`: only transfer functions and statics are calculated.
    pub motion: Option<Motion>,
    /// Motor, reducer and flywheel.
    pub drive: Option<Drive>,
    /// The wanted results; `None`: everything.
    pub output: Option<Output>,
    /// What is probably not meant, as far as reading the scene tells.
    pub warnings: Vec<Warning>,
}

/// A rigid link.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Name, unique in the mechanism; the ground is `ground`.
    pub name: Name,
    /// Mass, kg; 0 for a massless link.
    pub mass: f64,
    /// Center of mass in the frame of the link, m. Without meaning if mass and inertia are 0.
    pub center: [f64; 2],
    /// Moment of inertia about the center of mass.
    pub inertia: Inertia,
}

impl Link {
    /// Whether it has a mass or a moment of inertia.
    pub fn is_heavy(&self) -> bool {
        self.mass > 0.0 || !self.inertia.is_none()
    }
}

/// A point fixed in one link (a point of interest) or in several (a pin that joins them).
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Name, unique in the mechanism.
    pub name: Name,
    /// Its position in each link it belongs to, in the order of the scene. Never empty.
    pub places: Vec<Place>,
}

impl Point {
    /// Its place on a link, m; `None` where it does not belong to the link.
    pub fn on(&self, link: LinkId) -> Option<[f64; 2]> {
        self.places.iter().find(|place| place.link == link).map(|place| place.at)
    }

    /// Whether the point is a revolute pair: it belongs to two links or more.
    pub fn is_pin(&self) -> bool {
        self.places.len() > 1
    }
}

/// A point fixed in a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The link.
    pub link: LinkId,
    /// Coordinates in the frame of the link, m.
    pub at: [f64; 2],
}

/// A prismatic pair: `point` of `link` stays on a line of `on`, and `link` does not rotate relative to `on`.
#[derive(Debug, Clone, PartialEq)]
pub struct Slide {
    /// Name, unique among the slides.
    pub name: Name,
    /// The link that slides.
    pub link: LinkId,
    /// The link that carries the guide.
    pub on: LinkId,
    /// Point of `link` that stays on the line, in the frame of `link`, m.
    pub point: [f64; 2],
    /// Point of `on` on the guide line, in the frame of `on`, m.
    pub through: [f64; 2],
    /// Direction of the guide line in the frame of `on`, rad.
    pub angle: f64,
    /// Angle of the x axis of `link` relative to the guide direction, rad.
    pub tilt: f64,
}

/// The wanted results of a scene; an empty list selects nothing of its kind.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Output {
    /// Points.
    pub points: Vec<PointId>,
    /// Links.
    pub links: Vec<LinkId>,
    /// Slides.
    pub slides: Vec<SlideId>,
    /// Pins and slides whose reactions are wanted.
    pub reactions: Vec<PairId>,
}

/// A pair as the scene names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PairId {
    /// A pin, with all its links.
    Pin(PointId),
    /// A slide.
    Slide(SlideId),
}

impl Mechanism {
    /// Where the scene has a load: its list, and its number there, from 0.
    pub fn key_of_load(&self, load: LoadId) -> Key {
        let list = self.loads[load].kind.list();
        Key::of(list).at(self.loads[..load].iter().filter(|before| before.kind.list() == list).count())
    }

    /// Whether its links have the same positions at every coordinate as those of another mechanism: lengths, pairs, input and
    /// assembly are the same. Masses, loads and motion may differ.
    pub fn has_positions_of(&self, other: &Self) -> bool {
        self.points == other.points
            && self.slides == other.slides
            && self.input == other.input
            && self.assembly == other.assembly
    }

    /// Whether it has the links, pins, slides and input of another mechanism, so that it is decomposed into the same groups;
    /// lengths, masses and loads may differ.
    pub fn has_structure_of(&self, other: &Self) -> bool {
        let same_links = |(one, other): (&Point, &Point)| {
            let links = |point: &Point| point.places.iter().map(|place| place.link).collect::<Vec<_>>();
            links(one) == links(other)
        };
        let same_guide = |(one, other): (&Slide, &Slide)| (one.link, one.on) == (other.link, other.on);
        [self.links.len(), self.points.len(), self.slides.len()]
            == [other.links.len(), other.points.len(), other.slides.len()]
            && self.points.iter().zip(&other.points).all(same_links)
            && self.slides.iter().zip(&other.slides).all(same_guide)
            && self.input.drivers.len() == other.input.drivers.len()
            && self.input.drivers.iter().zip(&other.input.drivers).all(|(one, other)| one.drives_as(other))
    }

    /// The point of this name.
    pub fn point(&self, name: &str) -> Option<PointId> {
        self.points.iter().position(|point| point.name == name)
    }

    /// The link of this name.
    pub fn link(&self, name: &str) -> Option<LinkId> {
        self.links.iter().position(|link| link.name == name)
    }

    /// Coordinates of a named point in the frame of a link, m.
    pub fn place_in(&self, point: PointId, link: LinkId) -> Option<[f64; 2]> {
        self.points[point].on(link)
    }

    /// Whether the part of a link in the reduced moment of inertia is the same at every coordinate, by structure: the
    /// link has no mass; or it is the input link, which turns about its pin (or slides), wherever its center of mass
    /// is; or its mass is concentrated at a pin on the ground. A moment of inertia by a formula varies.
    pub fn has_constant_inertia(&self, link: LinkId) -> bool {
        let found = &self.links[link];
        let center = found.center.map(f64::to_bits);
        let rests = |point: &Point| {
            let at = |body: LinkId| point.places.iter().find(|place| place.link == body);
            at(GROUND).is_some() && at(link).is_some_and(|place| place.at.map(f64::to_bits) == center)
        };
        if found.inertia.varying().is_some() {
            return false;
        }
        let inertia = found.inertia.constant();
        let massless = found.mass <= 0.0 && inertia <= 0.0;
        massless || self.input.crank() == Some(link) || inertia <= 0.0 && self.points.iter().any(rests)
    }

    /// Whether the reduced moment of inertia J of all moving links is the same at every coordinate, by structure. It
    /// is for a single crank; a parallelogram, whose J is constant because of its lengths, is not recognized.
    pub fn has_constant_reduced_inertia(&self) -> bool {
        (1..self.links.len()).all(|link| self.has_constant_inertia(link))
    }

    /// Whether the balancing load is a moment (N m); otherwise it is a force (N).
    pub fn balances_by_moment(&self) -> bool {
        match self.balance {
            Some(balance) => matches!(balance, Balance::Moment(_)),
            None => self.input.first().is_angle(),
        }
    }

    /// Whether its motion is found from an equation of motion; otherwise it is given, or there is none.
    pub fn has_equation_of_motion(&self) -> bool {
        matches!(self.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }))
    }

    /// The moving links with mass or moment of inertia.
    pub fn heavy_links(&self) -> impl Iterator<Item = LinkId> {
        (1..self.links.len()).filter(|link| self.links[*link].is_heavy())
    }

    /// Whether any load acts on the links besides the drive.
    pub fn has_loads(&self) -> bool {
        let weights = self.gravity.is_some() && self.links.iter().skip(1).any(|link| link.mass > 0.0);
        weights || !self.loads.is_empty()
    }
}

#[cfg(test)]
mod tests;
