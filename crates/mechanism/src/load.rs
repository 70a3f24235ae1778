//! Loads that act on the links.

use crate::{LinkId, Name, Place, Value};

/// A load of the scene: what acts on the links besides weights, inertia and the drive.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Name in reports: the one in the scene, or one derived from what it acts on.
    pub name: Name,
    /// What it is, where it acts, and by which law.
    pub kind: LoadKind,
}

/// The kinds of loads.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadKind {
    /// A force at a point of a link.
    Force(Force),
    /// A moment on a link.
    Moment(Moment),
    /// A brake on a link.
    Brake(Brake),
    /// A spring with a damper between points of two links.
    Spring(Spring),
    /// An arc of a link on a straight line of the ground.
    Contact(Contact),
}

/// A force at a point of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Force {
    /// Point of application.
    pub at: Place,
    /// Direction of the force.
    pub direction: Direction,
    /// Its size, N.
    pub value: Value,
}

/// Direction of a force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Direction {
    /// Angle in the frame of the ground, rad.
    Ground(f64),
    /// Angle in the frame of the loaded link, rad.
    Link(f64),
    /// Always opposite to the velocity of the point; no force while the point is at rest.
    AgainstMotion,
}

/// A moment on a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// The link.
    pub link: LinkId,
    /// Its size, N m, counter-clockwise positive; against the motion, positive where it resists.
    pub value: Value,
    /// Whether it is always against the rotation of the link, and none at rest.
    pub against_motion: bool,
}

/// The shoe on the disc of a brake: its moment is against the rotation of the link, and none at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Brake {
    /// The link that it brakes.
    pub link: LinkId,
    /// Force on its lever, N.
    pub force: Value,
    /// Radius of the disc, m.
    pub radius: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Ratio of the lever: the shoe presses with this many times the force (D fig. 3.19).
    pub lever: f64,
}

impl Brake {
    /// Braking moment of a force of 1 N, m.
    pub fn moment_of_unit_force(&self) -> f64 {
        self.friction * self.lever * self.radius
    }
}

/// A spring with a damper between points of two links.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Its ends.
    pub ends: [Place; 2],
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Unstressed length, m.
    pub length: f64,
    /// Damping along the line between the ends, N s/m.
    pub damping: f64,
}

/// An arc of a link that rolls and slides along a straight line of the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Center N of the arc.
    pub center: Place,
    /// Radius R, m.
    pub radius: f64,
    /// Angle a, rad: the force acts at K = N + R (-sin a, -cos a).
    pub angle: Value,
    /// Contact force F, N, which acts along (sin a, cos a) on the link.
    pub force: Value,
    /// Coefficient of friction f, which adds f F along (cos a, -sin a).
    pub friction: f64,
    /// Whether the friction is against the sliding of K, so that its sign follows from the motion; else it is the one given.
    pub against_sliding: bool,
    /// Interval of the input coordinate with contact; `None`: always.
    pub during: Option<[f64; 2]>,
}

impl Load {
    /// A load of this name.
    pub fn new(name: impl Into<Name>, kind: impl Into<LoadKind>) -> Self {
        Self { name: name.into(), kind: kind.into() }
    }
}

impl LoadKind {
    /// The number under a key of the scene, if any other one may stand there as well.
    pub fn number(&mut self, key: &str) -> Option<&mut f64> {
        use Value::{Constant, Formula, Stroke};
        match self {
            Self::Force(Force { value, direction, at: _ }) => match (key, value, direction) {
                ("value", Constant(number), _)
                | ("value.axis", Stroke { axis: number, .. } | Formula { axis: Some(number), .. }, _)
                | ("angle", _, Direction::Ground(number) | Direction::Link(number)) => Some(number),
                _ => None,
            },
            Self::Moment(Moment { value: Constant(number), .. }) => (key == "value").then_some(number),
            Self::Moment(_) => None,
            Self::Brake(Brake { force, radius, friction, lever, link: _ }) => match (key, force) {
                ("force", Constant(number)) => Some(number),
                ("radius", _) => Some(radius),
                ("friction", _) => Some(friction),
                ("lever", _) => Some(lever),
                _ => None,
            },
            Self::Spring(Spring { stiffness, length, damping, ends: _ }) => match key {
                "stiffness" => Some(stiffness),
                "length" => Some(length),
                "damping" => Some(damping),
                _ => None,
            },
            Self::Contact(Contact { radius, angle, force, friction, .. }) => match (key, angle, force) {
                ("angle", Constant(number), _) | ("force", _, Constant(number)) => Some(number),
                ("radius", ..) => Some(radius),
                ("friction" | "friction.against_sliding", ..) => Some(friction),
                _ => None,
            },
        }
    }

    /// The list of the scene in which it stands.
    pub fn list(&self) -> &'static str {
        match self {
            Self::Force(_) => "force",
            Self::Moment(_) => "moment",
            Self::Brake(_) => "brake",
            Self::Spring(_) => "spring",
            Self::Contact(_) => "contact",
        }
    }

    /// The links on which it acts; none for a spring between points of one link, whose two forces cancel.
    pub fn links(&self) -> impl Iterator<Item = LinkId> {
        let links = match self {
            Self::Force(Force { at: Place { link, .. }, .. })
            | Self::Moment(Moment { link, .. })
            | Self::Brake(Brake { link, .. })
            | Self::Contact(Contact { center: Place { link, .. }, .. }) => [Some(*link), None],
            Self::Spring(Spring { ends: [one, other], .. }) if one.link == other.link => [None; 2],
            Self::Spring(Spring { ends, .. }) => ends.map(|end| Some(end.link)),
        };
        links.into_iter().flatten()
    }

    /// The law of its size: force, moment, pressing force of a brake, contact force. A spring has none.
    pub fn law(&self) -> Option<&Value> {
        match self {
            Self::Force(Force { value, .. })
            | Self::Moment(Moment { value, .. })
            | Self::Brake(Brake { force: value, .. })
            | Self::Contact(Contact { force: value, .. }) => Some(value),
            Self::Spring(_) => None,
        }
    }

    /// The law of its size, to be changed; a spring has none.
    pub fn law_mut(&mut self) -> Option<&mut Value> {
        match self {
            Self::Force(Force { value, .. })
            | Self::Moment(Moment { value, .. })
            | Self::Brake(Brake { force: value, .. })
            | Self::Contact(Contact { force: value, .. }) => Some(value),
            Self::Spring(_) => None,
        }
    }

    /// The laws of its numbers that may vary: of its size and, of a contact, of the angle at which it acts.
    pub fn laws(&self) -> impl Iterator<Item = &Value> {
        self.law().into_iter().chain(self.contact().map(|contact| &contact.angle))
    }

    /// Whether it is always against the motion of a point or of a link, and so has none at rest.
    pub fn is_against_motion(&self) -> bool {
        match self {
            Self::Force(force) => force.direction == Direction::AgainstMotion,
            Self::Moment(moment) => moment.against_motion,
            Self::Brake(_) => true,
            Self::Spring(_) | Self::Contact(_) => false,
        }
    }

    /// Unit of its value in results: that of a force or of a moment.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Moment(_) | Self::Brake(_) => "N m",
            Self::Force(_) | Self::Spring(_) | Self::Contact(_) => "N",
        }
    }
}

macro_rules! kinds {
    ($($kind:ident $get:ident $get_mut:ident),*) => {$(
        impl From<$kind> for LoadKind {
            fn from(load: $kind) -> Self {
                Self::$kind(load)
            }
        }

        impl LoadKind {
            /// The load, if it is of this kind.
            pub fn $get(&self) -> Option<&$kind> {
                if let Self::$kind(load) = self { Some(load) } else { None }
            }

            /// The load to be changed, if it is of this kind.
            pub fn $get_mut(&mut self) -> Option<&mut $kind> {
                if let Self::$kind(load) = self { Some(load) } else { None }
            }
        }
    )*};
}

kinds!(Force force force_mut, Moment moment moment_mut, Brake brake brake_mut, Spring spring spring_mut, Contact contact contact_mut);

/// Point of application of the balancing load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Balance {
    /// A force at a point, along this direction of the ground, rad.
    Force {
        /// Point of application.
        at: Place,
        /// Direction, rad.
        angle: f64,
    },
    /// A moment on a link.
    Moment(LinkId),
}
