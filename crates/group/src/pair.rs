//! What a group consists of.

/// The pair between two bodies, in the numbers of the compiled chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Index of the pair in the chain; its reaction is stored there.
    pub id: usize,
    /// First body; the sliding link of a slide. Reactions are those that act on it.
    pub a: usize,
    /// Second body; the link that carries the guide of a slide.
    pub b: usize,
    /// Geometry.
    pub geometry: PairGeometry,
}

/// Geometry of a pair, lengths in m, angles in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PairGeometry {
    /// Revolute pair R.
    Pin {
        /// The pin in the frame of `a`.
        at_a: [f64; 2],
        /// The pin in the frame of `b`.
        at_b: [f64; 2],
    },
    /// Prismatic pair P.
    Slide {
        /// Point of `a` that stays on the guide line, in the frame of `a`.
        point: [f64; 2],
        /// Point of `b` on the guide line, in the frame of `b`.
        through: [f64; 2],
        /// Direction of the guide line in the frame of `b`.
        angle: f64,
        /// Angle of the x axis of `a` from the guide direction.
        tilt: f64,
    },
}

impl Pair {
    /// Whether it is a slide.
    pub fn is_slide(&self) -> bool {
        matches!(self.geometry, PairGeometry::Slide { .. })
    }

    /// Whether it joins this body.
    pub fn joins(&self, body: usize) -> bool {
        self.a == body || self.b == body
    }

    /// The body at the other end.
    pub fn other(&self, body: usize) -> usize {
        if self.a == body { self.b } else { self.a }
    }

    /// The same pair with the roles of its bodies exchanged; a slide's guide is then carried by `a`.
    ///
    /// A point of `a` on a line of `b` is as well a point of `b` on a line of `a`, because `a` does not turn against `b`.
    #[must_use]
    pub fn turned_round(&self) -> Self {
        let geometry = match self.geometry {
            PairGeometry::Pin { at_a, at_b } => PairGeometry::Pin { at_a: at_b, at_b: at_a },
            PairGeometry::Slide { point, through, angle, tilt } => {
                PairGeometry::Slide { point: through, through: point, angle: -tilt, tilt: -angle }
            }
        };
        Self { id: self.id, a: self.b, b: self.a, geometry }
    }
}

/// A group in the numbers of the compiled chain: its links and pairs, inner and outer.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupFrame {
    /// Bodies of the group, in the order of the scene.
    pub links: Vec<usize>,
    /// Pairs between two links of the group.
    pub inner: Vec<Pair>,
    /// Pairs to bodies solved before; `a` or `b` may be the link of the group.
    pub outer: Vec<Pair>,
    /// A length typical of the mechanism, m: makes determinants dimensionless where the group has no length of its own.
    pub scale: f64,
}

impl GroupFrame {
    /// All pairs: the inner ones, then the outer ones.
    pub fn pairs(&self) -> impl Iterator<Item = &Pair> {
        self.inner.iter().chain(&self.outer)
    }

    /// Column block of a body in the group's unknowns, or `None` for a body solved before.
    pub fn column(&self, body: usize) -> Option<usize> {
        self.links.iter().position(|&link| link == body)
    }
}
