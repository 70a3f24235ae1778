//! The place where the balancing load acts.

use assur_group::plane::{self, vector};
use assur_group::{Body, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::{Balance, Driver, InputPair, LinkId, Mechanism};
use assur_number::{ROUNDING, Real, elementary};
use assur_words::text;

use crate::{ForceError, FrictionForces, Loads, power};

/// A balancing load of size 1 on a link that is not the drive's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitBalance {
    /// The loaded link.
    pub link: LinkId,
    load: UnitLoad,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum UnitLoad {
    /// 1 N m, counter-clockwise.
    Moment,
    /// 1 N at a point of the link, along a unit vector of the ground.
    Force { at: [f64; 2], along: [f64; 2] },
}

/// The direction of the force of a drive on the link that it drives, in the ground's frame; `None` where it is a moment.
pub fn drive_direction<T: Real>(
    mechanism: &Mechanism,
    driver: &Driver,
    bodies: &[Body<T>],
) -> Option<[T; 2]> {
    let InputPair::Slide(slide) = driver.pair else { return None };
    let slide = &mechanism.slides[slide];
    let along = bodies[slide.on].turned(plane::direction(slide.angle));
    Some(if slide.link == driver.link { along } else { plane::opposite(along) })
}

/// The balancing load does no work at a position (in a lane), so that it can't balance anything there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IdleBalance {
    unit: UnitBalance,
    /// Its transfer function, as part of a typical displacement.
    share: f64,
}

impl UnitBalance {
    /// The load of `[balance]`; `None` where the balancing load acts on the input link with its coordinate.
    pub fn of(mechanism: &Mechanism) -> Option<Self> {
        match mechanism.balance? {
            Balance::Moment(link) => {
                let drives = mechanism.input.is_angle() && mechanism.input.crank() == Some(link);
                (!drives).then_some(Self { link, load: UnitLoad::Moment })
            }
            Balance::Force { at, angle } => {
                let along = [elementary::cos(angle), elementary::sin(angle)];
                Some(Self { link: at.link, load: UnitLoad::Force { at: at.at, along } })
            }
        }
    }

    /// The load about the origin of the link's frame.
    #[inline(always)]
    pub fn wrench<T: Real>(&self, bodies: &[Body<T>]) -> Wrench<T> {
        let mut wrench = Wrench::ZERO;
        match self.load {
            UnitLoad::Moment => wrench.m = T::ONE,
            UnitLoad::Force { at, along } => {
                wrench.add_at(bodies[self.link].arm(vector(at)), vector(along), T::ZERO);
            }
        }
        wrench
    }

    /// Virtual power of the load for dq = 1.
    #[inline(always)]
    pub fn power<T: Real>(&self, bodies: &[Body<T>]) -> T {
        power(&self.wrench(bodies), &bodies[self.link])
    }

    /// The size of the balancing load at which the drive is idle: `others` is the drive's load under all other loads,
    /// `unit` that under a balancing load of size 1.
    ///
    /// # Errors
    ///
    /// [`IdleBalance`] where the load does no work in a lane.
    pub fn size<T: Real>(&self, others: T, unit: T, linkage: &Linkage) -> Result<T, IdleBalance> {
        let scale = linkage.structure.scale;
        let typical = match (self.load, linkage.mechanism.input.first().pair) {
            (UnitLoad::Force { .. }, InputPair::Pin(_)) => scale,
            (UnitLoad::Force { .. }, InputPair::Slide(_)) | (UnitLoad::Moment, InputPair::Pin(_)) => 1.0,
            (UnitLoad::Moment, InputPair::Slide(_)) => 1.0 / scale,
        };
        let share = unit.abs().least() / typical;
        if share > ROUNDING { Ok(-others / unit) } else { Err(IdleBalance { unit: *self, share }) }
    }
}

impl IdleBalance {
    /// The error in words, for one position.
    #[cold]
    pub fn explain(&self, linkage: &Linkage, coordinate: f64) -> ForceError {
        let link = &linkage.mechanism.links[self.unit.link].name;
        let load = match self.unit.load {
            UnitLoad::Force { .. } => text!("force-balancing-force", link),
            UnitLoad::Moment => text!("force-balancing-moment", link),
        };
        ForceError::IdleBalance { load, coordinate, share: self.share }
    }
}

/// Reactions in all pairs, and the balancing load: the result of an analyzer, with its scratch memory.
#[derive(Debug, Clone, PartialEq)]
pub struct Reactions<T = f64> {
    /// For each pair of the structure: force (N) and moment (N m) on its body `a`, about the pin or about the point of the sliding
    /// link. NaN where the method gives no reactions.
    pub pairs: Vec<Wrench<T>>,
    /// Moment (N m, counter-clockwise) or force (N, along the slide or along the direction of `[balance]`) that keeps the
    /// mechanism in its motion; over time the power of all drives, W.
    pub balancing: T,
    /// Over time the load of each drive in the order of the scene: a moment (N m) or a force (N). Empty otherwise.
    pub drives: Vec<T>,
    /// The balancing load of size 1; `None` where the drive balances.
    pub unit: Option<UnitBalance>,
    /// For each group, whether its equations are solved. The reactions of the others stay exactly zero: those of a
    /// group that carries no load, or is not placed. Respected by methods that solve [by
    /// groups](crate::AnalyzerPlugin::by_groups).
    pub solved: Vec<bool>,
    /// For each end of each joint in the order of [`joints`](crate::joints()), and then for the moment of a slide: 1 where passive
    /// parts leave that reaction undetermined, else 0. Empty where nothing is passive.
    pub open: Vec<T>,
    /// Dry friction in pairs; `None` where all are ideal, and where it is to be left out.
    pub friction: Option<FrictionForces<T>>,
    /// The further forces of the method, N, in the order of [`AnalyzerPlugin::further`](crate::AnalyzerPlugin::further).
    pub further: Vec<T>,
    /// Scratch of a method: one wrench for each pair.
    pub scratch_pairs: Vec<Wrench<T>>,
    /// Scratch of a method: one wrench for each body.
    pub scratch_bodies: Vec<Wrench<T>>,
}

impl<T: Real> Reactions<T> {
    /// Memory for the reactions of a mechanism, of all groups that are placed.
    pub fn new(linkage: &Linkage) -> Self {
        let groups = 0..linkage.groups().len();
        let pairs = vec![Wrench::ZERO; linkage.structure.pairs.len()];
        Self {
            balancing: T::from_f64(f64::NAN),
            drives: Vec::new(),
            unit: UnitBalance::of(&linkage.mechanism),
            solved: groups.map(|group| linkage.chain.needed[group]).collect(),
            open: Vec::new(),
            friction: None,
            further: Vec::new(),
            scratch_pairs: pairs.clone(),
            pairs,
            scratch_bodies: vec![Wrench::ZERO; linkage.structure.links],
        }
    }

    /// Each drive with its load; none where the balancing load acts elsewhere.
    pub fn of_drives<'a>(&'a self, mechanism: &'a Mechanism) -> impl Iterator<Item = (&'a Driver, T)> {
        let sole = mechanism.input.sole().map(|driver| (driver, self.balancing));
        let several = mechanism.input.drivers.iter().zip(self.drives.iter().copied());
        sole.into_iter().chain(several).filter(|_| self.unit.is_none())
    }

    /// Memory for the reactions with the dry friction of the mechanism, if it has any.
    #[must_use]
    pub fn with_friction(mut self, loads: &Loads, linkage: &Linkage) -> Self {
        self.friction = loads.frictions().map(|frictions| FrictionForces::new(frictions.clone(), linkage));
        self
    }

    /// Memory for the reactions, without the groups of these indices, which carry no load: their reactions stay zero.
    #[must_use]
    pub fn without_idle(mut self, carrying: &[bool]) -> Self {
        for (solved, carrying) in self.solved.iter_mut().zip(carrying) {
            *solved &= *carrying;
        }
        self
    }
}
