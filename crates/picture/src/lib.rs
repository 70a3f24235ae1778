//! Pictures of results: each is a function from what was calculated, and from what of it is shown, to panels of a
//! [`Figure`](assur_figure::Figure).
//!
//! * [`plots`]: curves over the positions or over time, and vectors in a plane of their own.
//! * [`regime`]: the steady regime with its motor, the energy-mass diagram, the reduced inertia.
//! * [`motion`]: a motion over time.
//! * [`places`]: the drive with its flywheel in its two places.
//! * [`friction`]: a reaction beside the friction of its pair.
//!
//! Knows no terminal, no file and no state of a screen.

mod found;
pub mod friction;
mod gather;
pub mod motion;
mod outline;
pub mod places;
mod planner;
pub mod plots;
mod probe;
pub mod regime;
mod results;
mod series;
mod transfer;

pub use found::Found;
pub use gather::Reaction;
pub use outline::Outline;
pub use planner::{Planner, Plans};
pub use probe::Probe;
pub use results::{Broken, Compared, Results};
pub use series::{Series, Transfer};

use assur_book::Unit;
use assur_kinematics::Linkage;

assur_words::resources!();

/// What of the results is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Number of the position, from 0.
    pub position: usize,
    /// Part of the way to the next position that the motion has gone, 0 to 1.
    pub part: f64,
}

impl Look {
    /// The place in the motion as a number of a position, with a fraction between two of them.
    pub fn at(self) -> f64 {
        self.position as f64 + self.part
    }
}

/// Unit in which the coordinate is shown, and its factor from SI.
pub fn coordinate_unit(linkage: &Linkage) -> (&'static str, f64) {
    let unit = Unit::place(linkage.angular());
    (unit.name, unit.factor)
}

/// The coordinate at a number of a position, also between two or after the last one, in the unit that is shown.
pub fn coordinate_at(linkage: &Linkage, at: f64) -> f64 {
    let [first, next] = [0, 1].map(|index| linkage.mechanism.input.coordinate(index));
    coordinate_unit(linkage).1 * (first + at * (next - first))
}
