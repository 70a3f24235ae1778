//! A plan as data.

use assur_force::VectorKind;
use assur_group::plane::{minus, plus};
use assur_words::Text;
use serde::Serialize;

/// Width of a drawing for which the scale is suggested, mm.
const PAPER: f64 = 150.0;

/// One vector of a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanVector {
    /// Short name: `R(A)`, `v(B)`.
    pub name: Text,
    /// Its symbol in print, with the points in a subscript: `v_B`, `a^n_BA`; of a load in a force polygon `F4`, with the
    /// number that it has on the links; else its name.
    #[serde(skip)]
    pub symbol: Text,
    /// The small letter of its tip in a plan of velocities or accelerations: `a`; of the point of a guide under `A` it is
    /// `a'`. Empty for vectors that have none.
    #[serde(skip)]
    pub image: String,
    /// What it represents.
    pub kind: VectorKind,
    /// Where it begins, in the unit of the plan.
    pub start: [f64; 2],
    /// Where it ends, in the unit of the plan.
    pub end: [f64; 2],
    /// Its size in `unit`: the distance of start and end, except for forces that are drawn into a plan of lengths.
    pub size: f64,
    /// Unit of the size.
    pub unit: String,
    /// What it means.
    pub note: Text,
}

/// A named point of a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanPoint {
    /// Its name.
    pub name: Text,
    /// Its place, in the unit of the plan.
    pub at: [f64; 2],
}

/// Vectors and points in one drawing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct VectorPlan {
    /// One line.
    pub title: Text,
    /// Unit of the coordinates.
    pub unit: String,
    /// Suggested scale, units for 1 mm of paper: 1, 2 or 5 by a power of ten; 0 for an empty plan.
    pub scale: f64,
    /// The vectors in the order in which they are drawn.
    pub items: Vec<PlanVector>,
    /// The points.
    pub points: Vec<PlanPoint>,
    /// Closure error relative to the greatest vector: how far a polygon is from closing, or the image of a point from
    /// the end of its components.
    pub residual: f64,
}

/// A part of a plan: its kind, its name, the vector, its meaning.
pub(crate) type Component = (VectorKind, Text, [f64; 2], Text);

impl VectorPlan {
    pub(crate) fn new(title: Text, unit: &str) -> Self {
        let unit = unit.to_owned();
        Self { title, unit, scale: 0.0, items: Vec::new(), points: Vec::new(), residual: 0.0 }
    }

    /// Adds a vector in the unit of the plan from a point; returns its end.
    pub(crate) fn push(&mut self, start: [f64; 2], (kind, name, vector, note): Component) -> [f64; 2] {
        let end = plus(start, vector);
        let (size, unit) = (length(vector), self.unit.clone());
        let (symbol, image) = (name.clone(), String::new());
        self.items.push(PlanVector { name, symbol, image, kind, start, end, size, unit, note });
        end
    }

    /// Adds a vector that has a symbol of its own; returns its end.
    pub(crate) fn push_as(&mut self, symbol: Text, start: [f64; 2], component: Component) -> [f64; 2] {
        let end = self.push(start, component);
        if let Some(item) = self.items.last_mut() {
            item.symbol = symbol;
        }
        end
    }

    /// Adds a point.
    pub(crate) fn point(&mut self, name: Text, at: [f64; 2]) {
        self.points.push(PlanPoint { name, at });
    }

    /// Length of the greatest vector as it is drawn.
    pub fn greatest(&self) -> f64 {
        self.items.iter().map(|item| length(minus(item.end, item.start))).fold(0.0, f64::max)
    }

    /// Sets residual and scale of a complete plan. `open`: the absolute closure error.
    pub(crate) fn finish(mut self, open: f64) -> Self {
        let greatest = self.greatest();
        self.residual = if greatest > 0.0 { open / greatest } else { open };
        let ends = self.items.iter().flat_map(|item| [item.start, item.end]);
        let all: Vec<_> = ends.chain(self.points.iter().map(|point| point.at)).collect();
        let along = |axis: usize, best: fn(f64, f64) -> f64| all.iter().map(|at| at[axis]).reduce(best);
        let extent =
            [0, 1].map(|axis| along(axis, f64::max).zip(along(axis, f64::min)).map_or(0.0, |(a, b)| a - b));
        self.scale = round_scale(extent[0].max(extent[1]) / PAPER);
        self
    }
}

/// The least of 1, 2, 5 times a power of ten that is not smaller than the value.
pub(crate) fn round_scale(least: f64) -> f64 {
    if least <= 0.0 || !least.is_finite() {
        return 0.0;
    }
    let power = 10.0_f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * power);
    steps.into_iter().find(|step| *step >= least * (1.0 - 1e-12)).unwrap_or(10.0 * power)
}

pub(crate) fn length(v: [f64; 2]) -> f64 {
    v[0].hypot(v[1])
}
