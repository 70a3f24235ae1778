//! What a column of a table holds.

use assur_mechanism::{LinkId, PairId, PointId, SlideId};

use super::Residual;

/// What a number measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Time from the start of the motion.
    Time,
    /// PF0, PF1, PF2: a value that depends on the input coordinate alone, and its derivatives with respect to it. Of the
    /// input (PF0 only): the coordinate itself. Of a link: its angle, continuous from row to row. Of a point: its
    /// projections in the frame of the ground. Of a slide: its displacement.
    Transfer(u8),
    /// Over time PF1 or PF2 of a link, a point or a slide with respect to the coordinate of one drive, by its index among
    /// [`Schema::drives`](super::Schema::drives), the others at rest.
    Partial {
        /// The drive.
        drive: usize,
        /// 1 or 2.
        order: u8,
    },
    /// First derivative with respect to time of PF0 of the input, a link, a point or a slide.
    Velocity,
    /// Second derivative with respect to time.
    Acceleration,
    /// Moment of inertia (mass) of all moving links, or of one, reduced to the input.
    ReducedInertia,
    /// Derivative of the reduced inertia with respect to the coordinate.
    ReducedInertiaDerivative,
    /// Moment (force) of all loads, reduced to the input; no motor, no balancing load.
    ReducedMoment,
    /// Work since the first sample of the drive and of all loads whose power is positive.
    DrivingWork,
    /// Work since the first sample of the drive and of all loads whose power is negative; itself negative, so that both works
    /// together are the change of the kinetic energy.
    ResistingWork,
    /// Work of the dry friction of all pairs since the start of the motion, J; never positive.
    FrictionWork,
    /// Kinetic energy of the mechanism with flywheel and rotor; or of one link.
    KineticEnergy,
    /// Work since the first sample of one load; of the input: of its drive; of the ground: of all weights.
    Work,
    /// One load, reduced to the input: its share of the reduced moment (force); of the input: the moment of its drive; of the
    /// ground: that of all weights.
    ReducedLoad,
    /// Force that a pair exerts on a link, in the frame of the ground.
    Force,
    /// Moment of a slide on its sliding link about its point.
    Moment,
    /// Where along the guide, from the point of the sliding link, the force alone is equivalent to force and moment.
    Offset,
    /// Moment (force) that maintains the motion of the mechanism.
    Balancing,
    /// A force that the analyzer finds beside the reactions.
    OfMethod,
    /// What holds the motion at rest or at a speed: moment (force) on the input.
    Holding,
    /// The greatest size that [`Holding`](Self::Holding) can have.
    HoldingBound,
    /// Moment (N m) of the dry friction of a pin, on the link that turns on the journal.
    FrictionMoment,
    /// Force (N) of the dry friction of a slide along its guide, on the sliding link.
    FrictionForce,
    /// Power of the dry friction of a pair; without a motion per unit of travel of the input along its direction.
    FrictionPower,
    /// The balancing load without dry friction.
    IdealBalancing,
    /// Efficiency with dry friction.
    Efficiency,
    /// Spectral radius of the friction of a group: below 1 there is exactly one solution.
    FrictionCertificate,
    /// Value of a load: of a force along its direction, of a moment counter-clockwise, of a spring its tension.
    Load,
    /// Principal vector of the inertia loads of a link, at its center of mass: -m a.
    InertiaForce,
    /// Principal moment of the inertia loads of a link: -I e.
    InertiaMoment,
    /// Force on the ground of all inertia loads.
    ShakingForce,
    /// Moment on the ground of all inertia loads, about the origin.
    ShakingMoment,
    /// How far a position is from fulfilling a check.
    Residual(Residual),
    /// 1 / |dimensionless determinant| of a group: infinite at a singular position.
    Condition,
}

/// What a number belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Owner {
    /// The input link, to which the whole mechanism is reduced.
    Input,
    /// A link.
    Link(LinkId),
    /// A named point.
    Point(PointId),
    /// A slide.
    Slide(SlideId),
    /// A pin or slide.
    Pair(PairId),
    /// A pin or slide, and the link on which it acts.
    PairOn(PairId, LinkId),
    /// A group, by its index in solving order.
    Group(usize),
    /// A load of the scene, by its index among [`Schema::loads`](super::Schema::loads).
    Load(usize),
    /// What is driven over time, by its index among [`Schema::drives`](super::Schema::drives).
    Drive(usize),
    /// A further force of the analyzer, by its index among [`Schema::further`](super::Schema::further).
    Method(usize),
}

/// Which part of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// All of it: a number.
    Whole,
    /// Projection of a vector on the x axis of the ground.
    X,
    /// Projection on the y axis.
    Y,
    /// Length of a vector. No table stores it: it is that of both projections.
    Modulus,
}

/// One column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Column {
    /// What it measures.
    pub quantity: Quantity,
    /// What it belongs to.
    pub owner: Owner,
    /// Which part of it.
    pub part: Part,
    /// The share of this cause alone, by its index in [`Schema::causes`](super::Schema::causes); `None`: under all loads.
    pub cause: Option<usize>,
}

impl Column {
    /// A number under all loads.
    pub const fn of(quantity: Quantity, owner: Owner) -> Self {
        Self { quantity, owner, part: Part::Whole, cause: None }
    }

    /// The coordinate of the input, rad or m.
    pub const COORDINATE: Self = Self::of(Quantity::Transfer(0), Owner::Input);
    /// Time from the start of the motion, s.
    pub const TIME: Self = Self::of(Quantity::Time, Owner::Input);
    /// The balancing moment (N m) or force (N).
    pub const BALANCING: Self = Self::of(Quantity::Balancing, Owner::Input);

    /// Another part of the same quantity.
    #[must_use]
    pub const fn part(self, part: Part) -> Self {
        Self { part, ..self }
    }

    /// Both projections of a vector.
    pub const fn vector(quantity: Quantity, owner: Owner) -> [Self; 2] {
        let whole = Self::of(quantity, owner);
        [whole.part(Part::X), whole.part(Part::Y)]
    }
}
