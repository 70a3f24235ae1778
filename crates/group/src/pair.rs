//! The links and pairs of a group.

/// The pair between two bodies, with its indices and lengths in the compiled chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Index of the pair in the chain; its reaction is stored there.
    pub id: usize,
    /// First body: of a slide, the sliding link. Stored reactions act on it.
    pub a: usize,
    /// Second body: of a slide, the link that carries the guide.
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
        /// Angle of the x axis of `a` relative to the guide direction.
        tilt: f64,
    },
}

impl Pair {
    /// Whether it is a slide.
    pub fn is_slide(&self) -> bool {
        matches!(self.geometry, PairGeometry::Slide { .. })
    }

    /// Where it lies in each of its bodies.
    pub fn places(&self) -> [(usize, [f64; 2]); 2] {
        let (PairGeometry::Pin { at_a, at_b } | PairGeometry::Slide { point: at_a, through: at_b, .. }) =
            self.geometry;
        [(self.a, at_a), (self.b, at_b)]
    }

    /// Whether it joins this body.
    pub fn joins(&self, body: usize) -> bool {
        self.a == body || self.b == body
    }

    /// The body at the other end.
    pub fn other(&self, body: usize) -> usize {
        if self.a == body { self.b } else { self.a }
    }

    /// The same pair with `a` and `b` exchanged; the guide of a slide is then carried by the former `a`.
    ///
    /// This is possible because `a` does not rotate relative to `b`: a point of `a` on a line of `b` is also a point
    /// of `b` on a line of `a`.
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

/// A driven pair of a link of a group: its motion relative to another link of the group, or to an outer body, follows a coordinate, so
/// that both are one rigid link whose shape depends on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Driven {
    /// The pair; `a` is the link that is driven, `b` the one against which it is.
    pub pair: Pair,
    /// The body that holds the coordinate: of a pin its direction is the angle of `a` counted from `b`, of a slide the x of its origin
    /// is the way of the point of `a` along the guide from the point of `b`.
    pub coordinate: usize,
}

/// The links and pairs (inner and outer) of a group, as indices and lengths in the compiled chain.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GroupFrame {
    /// Bodies of the group, in the order of the scene.
    pub links: Vec<usize>,
    /// Pairs between two links of the group.
    pub inner: Vec<Pair>,
    /// Pairs to outer bodies, which are solved before the group; `a` or `b` may be the link of the group.
    pub outer: Vec<Pair>,
    /// Driven pairs of its links with each other, or of one with an outer body; they are not among the inner and outer pairs.
    pub driven: Vec<Driven>,
    /// A typical length of the mechanism, m. It makes determinants dimensionless where the group has no length of its
    /// own.
    pub scale: f64,
}

impl GroupFrame {
    /// All pairs: first the inner, then the outer ones, then the driven ones.
    pub fn pairs(&self) -> impl Iterator<Item = &Pair> {
        self.inner.iter().chain(&self.outer).chain(self.driven.iter().map(|driven| &driven.pair))
    }

    /// The bodies outside of the group from whose poses its own follow, the ground excepted; one may stand several times.
    pub fn carriers(&self) -> impl Iterator<Item = usize> {
        let ends = self.outer.iter().flat_map(|pair| [pair.a, pair.b]);
        let driven = self.driven.iter().flat_map(|driven| [driven.pair.a, driven.pair.b, driven.coordinate]);
        let bodies = ends.chain(driven);
        bodies.filter(|body| *body != 0 && self.column(*body).is_none())
    }

    /// Number of scalar equations: two of each pair, and one more of a driven one.
    pub fn equations(&self) -> usize {
        2 * self.pairs().count() + self.driven.len()
    }

    /// Index of a body among the group's links, which is its column block among the unknowns; `None` for an outer
    /// body.
    pub fn column(&self, body: usize) -> Option<usize> {
        self.links.iter().position(|&link| link == body)
    }
}
