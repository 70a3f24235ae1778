//! What friction depends on, and the loads that it gives.

use assur_group::plane::{dot, perp, scaled};
use assur_group::{Body, Wrench};
use assur_mechanism::{Mechanism, Middle, Surfaces};
use assur_number::Real;
use assur_structure::Structure;

use super::Bearing;
use crate::joints;

/// A magnitude of a reaction (or a normal force itself) on which the friction of a bearing depends.
#[derive(Debug, Clone, PartialEq)]
pub struct Unknown {
    /// Index of the bearing.
    pub bearing: usize,
    /// What it is.
    pub kind: UnknownKind,
    /// The pairs of the structure from which its force follows, and the factor of each: 1 or -1.
    pub pairs: Vec<(usize, f64)>,
}

/// What friction depends on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum UnknownKind {
    /// |R| of a pin.
    Force,
    /// |N| of a slide.
    Normal,
    /// |N/2 + M/l| or, with the sign -1, |N/2 - M/l| of a slide.
    End(f64),
    /// N itself: the friction of faces offset from the guide line has a moment that is linear in it.
    Shift,
}

impl Unknown {
    /// All that the friction of some bearings depends on. Those that never move have none.
    pub(crate) fn all(mechanism: &Mechanism, structure: &Structure, bearings: &[Bearing]) -> Vec<Self> {
        let joints = joints(mechanism, structure);
        let mut all = Vec::new();
        for (index, bearing) in bearings.iter().enumerate() {
            let Some(joint) = joints.iter().find(|joint| joint.id == bearing.pair) else { continue };
            let nth = joint.links.iter().position(|link| *link == bearing.link).unwrap_or_default();
            if bearing.rests() || bearing.coefficient == 0.0 {
                continue;
            }
            let mut add = |kind| all.push(Self { bearing: index, kind, pairs: joint.pairs[nth].clone() });
            match bearing.surfaces {
                Surfaces::Journal { .. } => add(UnknownKind::Force),
                Surfaces::Place => add(UnknownKind::Normal),
                Surfaces::Faces { .. } => {
                    add(UnknownKind::End(1.0));
                    add(UnknownKind::End(-1.0));
                    if bearing.is_shifted() {
                        add(UnknownKind::Shift);
                    }
                }
            }
        }
        all
    }

    /// Whether it is a magnitude.
    pub fn is_modulus(&self) -> bool {
        self.kind != UnknownKind::Shift
    }

    /// The vector whose magnitude it is, from reactions without the loads of friction; of a slide its first component.
    #[inline(always)]
    pub fn vector<T: Real>(&self, bearing: &Bearing, bodies: &[Body<T>], reactions: &[Wrench<T>]) -> [T; 2] {
        let (parts, normal) = self.pressing(bearing, bodies).of(&self.load_on(reactions));
        match self.kind {
            UnknownKind::Force => parts,
            UnknownKind::Normal | UnknownKind::Shift => [normal, T::ZERO],
            UnknownKind::End(sign) => [parts[usize::from(sign < 0.0)], T::ZERO],
        }
    }

    /// The load on the link of its bearing, from reactions.
    #[inline(always)]
    pub fn load_on<T: Real>(&self, reactions: &[Wrench<T>]) -> Wrench<T> {
        let mut sum = Wrench::ZERO;
        for &(pair, factor) in &self.pairs {
            let (factor, one) = (T::from_f64(factor), &reactions[pair]);
            sum.fx += factor * one.fx;
            sum.fy += factor * one.fy;
            sum.m += factor * one.m;
        }
        sum
    }

    /// How a load presses in its bearing.
    #[inline(always)]
    pub fn pressing<T: Real>(&self, bearing: &Bearing, bodies: &[Body<T>]) -> Pressing<T> {
        match bearing.surfaces {
            Surfaces::Journal { .. } => Pressing::Pin,
            Surfaces::Place => Pressing::Place { across: perp(bearing.along(bodies)) },
            Surfaces::Faces { length, middle, .. } => Pressing::Ends {
                across: perp(bearing.along(bodies)),
                shift: match middle {
                    Middle::Point => T::ZERO,
                    Middle::Through => bearing.displacement(bodies),
                },
                length,
            },
        }
    }

    /// The moment (force) of the bearing that an unknown of size 1 gives, as [`load`](UnknownKind::load) counts it: the moment of a
    /// journal on the link that turns, the force of a slide along its guide.
    pub fn share(&self, bearing: &Bearing) -> f64 {
        match (self.kind, bearing.surfaces) {
            (UnknownKind::Force, Surfaces::Journal { radius, .. }) => -radius,
            (UnknownKind::Shift, _) => 0.0,
            _ => -1.0,
        }
    }

    /// The moment about the point of a slide that an unknown of size 1 gives to the reaction of its pair, as
    /// [`load`](UnknownKind::load) counts it: of the friction of a journal the moment on its link.
    pub fn moment(&self, bearing: &Bearing) -> f64 {
        match (self.kind, bearing.surfaces) {
            (UnknownKind::Force, Surfaces::Journal { radius: lever, .. })
            | (UnknownKind::Shift, Surfaces::Faces { offset: lever, .. }) => -lever,
            _ => 0.0,
        }
    }
}

impl UnknownKind {
    /// Adds the loads that it gives where it has size 1, the coefficient is 1 and the relative speed positive, times a factor.
    #[inline(always)]
    pub fn load<T: Real>(self, bearing: &Bearing, bodies: &[Body<T>], factor: T, loads: &mut [Wrench<T>]) {
        match (self, bearing.surfaces) {
            (UnknownKind::Force, Surfaces::Journal { radius: lever, .. })
            | (UnknownKind::Shift, Surfaces::Faces { offset: lever, .. }) => {
                let moment = -(factor * T::from_f64(lever));
                loads[bearing.link].m += moment;
                loads[bearing.on].m += -moment;
            }
            (UnknownKind::Normal | UnknownKind::End(_), _) => {
                let force = scaled(-factor, bearing.along(bodies));
                let [arm, arm_on] = bearing.arms(bodies);
                loads[bearing.link].add_at(arm, force, T::ZERO);
                loads[bearing.on].add_at(arm_on, [-force[0], -force[1]], T::ZERO);
            }
            _ => {}
        }
    }
}

/// How a load presses in a bearing.
#[derive(Debug, Clone, Copy)]
pub enum Pressing<T> {
    /// By its force.
    Pin,
    /// By its component across the guide.
    Place {
        /// The left normal of the guide.
        across: [T; 2],
    },
    /// By the forces on both ends.
    Ends {
        /// The left normal of the guide.
        across: [T; 2],
        /// From the middle of the contact to the point of the slide, m.
        shift: T,
        /// Length of the contact, m.
        length: f64,
    },
}

impl<T: Real> Pressing<T> {
    /// What presses without the loads of friction: the force of a pin, or the forces on both ends of a slide (all of it first where
    /// it is pressed at one point); and the normal force of a slide.
    #[inline(always)]
    pub fn of(&self, load: &Wrench<T>) -> ([T; 2], T) {
        match *self {
            Self::Pin => ([load.fx, load.fy], T::ZERO),
            Self::Place { across } => {
                let normal = dot(across, load.force());
                ([normal, T::ZERO], normal)
            }
            Self::Ends { across, shift, length } => {
                let normal = dot(across, load.force());
                let part = (load.m + shift * normal) * T::from_f64(1.0 / length);
                ([normal.half() + part, normal.half() - part], normal)
            }
        }
    }
}
