//! The text of a new scene, which has an input and nothing else.

use crate::number::{degrees, millimeters, rounded};

/// What moves in a new scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// A crank on a pivot.
    Crank {
        /// The place of the pivot, m.
        pivot: [f64; 2],
        /// The length of the crank, m.
        length: f64,
        /// Its angle in the first position, rad.
        angle: f64,
    },
    /// A block that slides on the ground.
    Slide {
        /// A point of the guide, from which the displacement counts, m.
        through: [f64; 2],
        /// The direction of the guide, rad.
        angle: f64,
        /// The displacements of the first and of the last position, m; not equal.
        ends: [f64; 2],
    },
}

impl Start {
    /// A crank of 100 mm on a pivot at the origin.
    pub const CRANK: Self = Self::Crank { pivot: [0.0; 2], length: 0.1, angle: 0.0 };

    /// A block that slides along the x axis, from 50 to 150 mm beside the origin.
    pub const SLIDE: Self = Self::Slide { through: [0.0; 2], angle: 0.0, ends: [0.05, 0.15] };
}

/// The text of a scene with an input.
pub fn start(start: Start) -> String {
    let length = |length: f64| millimeters(rounded(length, 1e-6));
    let ground =
        |[x, y]: [f64; 2]| format!("[ground]\npoints = {{ O = [{}, {}] }}\n\n", length(x), length(y));
    let angle_line = |key: &str, angle: f64| match rounded(angle.to_degrees(), 0.01) {
        0.0 => String::new(),
        _ => format!("{key} = {}\n", degrees(angle)),
    };
    match start {
        Start::Crank { pivot, length: radius, angle } => format!(
            "{}[link.crank]\npoints = {{ O = 0, A = {} }}\n\n[input]\nlink = \"crank\"\n{}positions = 24\n",
            ground(pivot),
            length(radius),
            angle_line("from", angle)
        ),
        Start::Slide { through, angle, ends: [from, to] } => format!(
            "{}[link.slider]\npoints = {{ A = 0 }}\n\n[[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = \"O\"\n{}\n\
             [input]\nlink = \"slider\"\nfrom = {}\nto = {}\npositions = 24\n",
            ground(through),
            angle_line("angle", angle),
            length(from),
            length(to)
        ),
    }
}
