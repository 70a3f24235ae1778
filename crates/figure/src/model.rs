//! What is drawn: figures, panels, items.

use std::f64::consts::TAU;

use assur_words::{Text, joined};

use crate::axis::Axis;
use crate::bounds::Bounds;
use crate::scale::Scale;

/// A point of a panel, in the units of its frame.
pub type Point = [f64; 2];

/// Panels that belong together, row by row.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Figure {
    /// Heading of the whole; may be empty.
    pub title: Text,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
    /// Panels beside each other in a row; at least 1.
    pub columns: usize,
    /// Explanations of signs and strokes, for all panels.
    pub legend: Vec<Key>,
}

impl Figure {
    /// A figure of one panel.
    pub fn of(panel: Panel) -> Self {
        Self { panels: vec![panel], columns: 1, ..Self::default() }
    }

    /// Number of rows of panels.
    pub fn rows(&self) -> usize {
        self.panels.len().div_ceil(self.columns.max(1))
    }

    /// Whether a row of panels has the numbers of a horizontal axis below it.
    pub(crate) fn has_axis_below(&self, row: usize) -> bool {
        let first = row * self.columns.max(1);
        let is_plot = |panel: &Panel| matches!(panel.frame, Frame::Axes { .. });
        self.panels.get(first).is_some_and(is_plot) && self.shows_axis(first)
    }

    /// Whether a panel shows the numbers of its horizontal axis: not where the panel below has the same axis.
    pub(crate) fn shows_axis(&self, index: usize) -> bool {
        let axis = |at: usize| match self.panels.get(at).map(|panel| &panel.frame) {
            Some(Frame::Axes { x, .. }) => Some(x),
            _ => None,
        };
        axis(index).is_none_or(|own| axis(index + self.columns.max(1)) != Some(own))
    }
}

/// One drawing with its own scale.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Heading; may be empty.
    pub title: Text,
    /// What its coordinates are.
    pub frame: Frame,
    /// What is drawn; later items lie over earlier ones.
    pub items: Vec<Item>,
}

/// What the coordinates of a panel are.
#[derive(Debug, Clone, PartialEq)]
pub enum Frame {
    /// One scale for both directions, x to the right, y up.
    Plane {
        /// The part of the plane that is shown.
        bounds: Bounds,
        /// Its own scale, then those of what else is drawn in it.
        scales: Vec<Scale>,
    },
    /// Two axes of their own.
    Axes {
        /// The horizontal axis.
        x: Axis,
        /// The vertical axis.
        y: Axis,
        /// Where a vertical line marks the present position.
        cursor: Option<Cursor>,
    },
}

/// The present position in a plot.
#[derive(Debug, Clone, PartialEq)]
pub struct Cursor {
    /// Where it is on the horizontal axis.
    pub at: f64,
    /// The value there, shown behind the heading; may be empty.
    pub value: Text,
}

impl From<f64> for Cursor {
    fn from(at: f64) -> Self {
        Self { at, value: Text::default() }
    }
}

impl Panel {
    /// A plane without a heading.
    pub fn plane(bounds: Bounds, scale: Scale, items: Vec<Item>) -> Self {
        Self { title: Text::default(), frame: Frame::Plane { bounds, scales: vec![scale] }, items }
    }

    /// A plot whose vertical axis has numbers in this unit.
    #[must_use]
    pub fn measuring(mut self, unit: &str) -> Self {
        if let Frame::Axes { y, .. } = &mut self.frame {
            *y = y.clone().measuring(unit);
        }
        self
    }

    pub(crate) fn heading(&self) -> Text {
        let value = match &self.frame {
            Frame::Axes { cursor: Some(cursor), .. } => Some(&cursor.value),
            _ => None,
        };
        let parts = std::iter::once(&self.title).chain(value).filter(|part| !part.is_empty());
        joined("  ", parts.cloned())
    }
}

/// What something that is drawn stands for; each renderer has a color for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ink {
    /// Texts and signs.
    Text,
    /// Headings and names of points.
    Title,
    /// Axes, scales, remarks.
    Dim,
    /// The ground.
    Ground,
    /// A moving link, by its number.
    Link(usize),
    /// Whatever is chosen.
    Marked,
    /// Paths of points, lines of a construction.
    Trace,
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
    /// The first of several curves.
    First,
    /// The second of several curves.
    Second,
    /// The third of several curves.
    Third,
    /// The present position.
    Cursor,
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// A line.
    Solid,
    /// A thick line, for a link.
    Thick,
    /// A fine line, for what stands behind.
    Fine,
    /// Short dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dashes and dots in turn.
    Chain,
    /// Stars along a faint line.
    Stars,
}

/// A sign of a fixed size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// A pin between moving links.
    Pin,
    /// A pin on the ground, with its hatched base.
    Bearing,
    /// A slider.
    Block,
    /// One stroke of the hatching of the ground.
    Hatch,
    /// The head of an arrow; a point where it has no direction.
    Head,
    /// A point of a link that is not a pin.
    Dot,
    /// An extreme of a curve, the pole of a plan.
    Ring,
    /// A zero of a curve, the tip of a vector.
    Cross,
    /// An inflection of a curve, an origin.
    Plus,
    /// A point of a curve drawn in stars.
    Star,
    /// A position on a curve.
    Node,
}

/// Straight pieces of a circle.
const PIECES: usize = 48;

/// One thing that is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Straight pieces from point to point; a point that is not finite interrupts them.
    Line {
        /// The points.
        points: Vec<Point>,
        /// How it is drawn.
        stroke: Stroke,
        /// What it stands for.
        ink: Ink,
    },
    /// The closed outline of a body.
    Area {
        /// Its corners.
        outline: Vec<Point>,
        /// What it stands for.
        ink: Ink,
    },
    /// A vector with its head.
    Arrow {
        /// Its foot.
        from: Point,
        /// Its tip.
        to: Point,
        /// How its shaft is drawn.
        stroke: Stroke,
        /// What it stands for.
        ink: Ink,
    },
    /// A line of the ground, hatched on its lower side (a vertical one: on its right side).
    Ground {
        /// The ends of the line, or of the path of a slider.
        ends: [Point; 2],
        /// Whether it guides a slider along its path; else something rolls or slides on the line itself.
        guides: bool,
    },
    /// A spring, a damper, or both beside each other between two points.
    Spring {
        /// One end.
        from: Point,
        /// The other end.
        to: Point,
        /// Whether it has a spring.
        elastic: bool,
        /// Whether it has a damper.
        damped: bool,
    },
    /// A sign at a point.
    Sign {
        /// The point.
        at: Point,
        /// Its direction, a unit vector of the plane; only blocks have one.
        along: Point,
        /// Which sign.
        sign: Sign,
        /// What it stands for.
        ink: Ink,
    },
    /// A name beside a point.
    Name {
        /// The point.
        at: Point,
        /// The name.
        text: Text,
        /// What it stands for.
        ink: Ink,
        /// Whether it is written even where it covers something.
        needed: bool,
    },
}

impl Item {
    /// A sign without a direction.
    pub fn sign(at: Point, sign: Sign, ink: Ink) -> Self {
        Self::Sign { at, along: [1.0, 0.0], sign, ink }
    }

    /// A name that is always written.
    pub fn name(at: Point, text: Text, ink: Ink) -> Self {
        Self::Name { at, text, ink, needed: true }
    }

    /// A line from point to point.
    pub fn line(points: impl Into<Vec<Point>>, stroke: Stroke, ink: Ink) -> Self {
        Self::Line { points: points.into(), stroke, ink }
    }

    /// A circle.
    pub fn circle([x, y]: Point, radius: f64, stroke: Stroke, ink: Ink) -> Self {
        let points = (0..=PIECES).map(|piece| {
            let (s, c) = (TAU * piece as f64 / PIECES as f64).sin_cos();
            [x + radius * c, y + radius * s]
        });
        Self::line(points.collect::<Vec<_>>(), stroke, ink)
    }

    /// What of it lies in a part of the plane.
    pub fn within(self, bounds: &Bounds) -> Vec<Self> {
        let cut = |ends: [Point; 2]| bounds.cut(ends);
        match self {
            Self::Line { points, stroke, ink } => {
                let pieces = points.windows(2).filter_map(|two| cut([two[0], two[1]]));
                pieces.map(|piece| Self::line(piece, stroke, ink)).collect()
            }
            Self::Area { ref outline, ink } if !outline.iter().all(|at| bounds.holds(*at)) => {
                let ends = outline.iter().zip(outline.iter().skip(1).chain(outline.first()));
                let sides = ends.filter_map(|(from, to)| cut([*from, *to]));
                sides.map(|side| Self::line(side, Stroke::Thick, ink)).collect()
            }
            Self::Ground { ends, guides } => {
                cut(ends).map(|ends| Self::Ground { ends, guides }).into_iter().collect()
            }
            whole => {
                let inside = whole.points().iter().all(|at| bounds.holds(*at));
                inside.then_some(whole).into_iter().collect()
            }
        }
    }

    /// The points that a drawing of it must show.
    pub fn points(&self) -> Vec<Point> {
        match self {
            Self::Line { points, .. } => points.clone(),
            Self::Area { outline, .. } => outline.clone(),
            Self::Sign { at, .. } | Self::Name { at, .. } => vec![*at],
            Self::Ground { ends, .. } => ends.to_vec(),
            Self::Arrow { from, to, .. } | Self::Spring { from, to, .. } => vec![*from, *to],
        }
    }
}

/// An entry of a legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    /// What is explained.
    pub sample: Sample,
    /// The explanation.
    pub text: Text,
}

/// What an entry of a legend explains.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sample {
    /// A sign.
    Sign(Sign, Ink),
    /// A stroke.
    Line(Stroke, Ink),
    /// Nothing that is drawn: the entry is a remark.
    None,
}
