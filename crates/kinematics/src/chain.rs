//! The compiled chain: input and groups as flat data.

use assur_group::plane::{plus, scaled, vector};
use assur_group::{Anchor, AssurGroup, Body, GroupError, Number, Order};
use assur_mechanism::{Driver, InputPair, Mechanism, TimeLaw};
use assur_number::Real;
use assur_structure::Structure;

use crate::{CompileError, passive::hang::Hanging};

/// What is driven, in one number type.
#[derive(Debug, Clone, Copy)]
pub enum ChainInput<T> {
    /// Pinned to the ground; the coordinate is its angle.
    Crank {
        /// Index of the link.
        link: usize,
        /// The pin in the ground's frame, m.
        ground: [T; 2],
        /// The pin on the link.
        own: Anchor<T>,
    },
    /// Sliding on the ground; the coordinate is the displacement of its slide.
    Slider {
        /// Index of the link.
        link: usize,
        /// Direction of its x axis.
        axis: [T; 2],
        /// d(origin)/dq: the unit vector along which the origin moves as the coordinate grows.
        along: [T; 2],
        /// Origin of the link at the coordinate 0, m.
        origin: [T; 2],
    },
    /// A pair between two moving links, which belong to a group: the coordinate has a body of its own (see [`assur_group::Driven`]).
    Relative {
        /// Index of this body.
        body: usize,
        /// Whether the coordinate is an angle; otherwise a length.
        is_angle: bool,
    },
}

impl<T> ChainInput<T> {
    /// Index of the body whose pose follows from the coordinate alone.
    pub(crate) fn body(&self) -> usize {
        match self {
            Self::Crank { link: body, .. }
            | Self::Slider { link: body, .. }
            | Self::Relative { body, .. } => *body,
        }
    }
}

/// A group that has no solution, by its index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChainError {
    /// Index of the group.
    pub group: usize,
    /// Why it has no solution.
    pub source: GroupError,
}

/// Input and groups in one number type.
#[derive(Debug)]
pub struct Chain<T: Number> {
    /// What is driven, in the order of the scene.
    pub inputs: Vec<ChainInput<T>>,
    /// The coordinate of each over time; empty where the only one has that of the chain.
    laws: Vec<TimeLaw>,
    /// The groups in solving order.
    pub groups: Vec<Box<dyn AssurGroup<T>>>,
    /// Whether each group is solved; all are at first. No needed group may depend on one that is not.
    pub needed: Vec<bool>,
    bodies: usize,
    /// Passive links, placed after the groups.
    hanging: Vec<Hanging<T>>,
}

impl<T: Number> Chain<T> {
    /// Builds the kernels of all groups.
    pub fn compile(mechanism: &Mechanism, structure: &Structure) -> Result<Self, CompileError> {
        let mut groups = Vec::with_capacity(structure.groups.len());
        for (i, group) in structure.groups.iter().enumerate() {
            let kernel = T::build(&group.plugin.builders, &group.frame).map_err(|source| {
                let link = source.link.map(|link| mechanism.links[link].name.to_string());
                CompileError::Build { group: Box::new(structure.group_name(mechanism, i)), source, link }
            })?;
            groups.push(kernel);
        }
        let needed = vec![true; groups.len()];
        let hanging = structure.passive.iter().filter_map(|passive| Hanging::of(&passive.frame)).collect();
        let drivers = mechanism.input.drivers.iter();
        let inputs: Vec<_> = drivers.clone().enumerate().map(|of| input_of(mechanism, of)).collect();
        let laws = drivers.filter_map(|driver| driver.law.clone()).collect();
        let bodies = inputs.iter().map(|input| input.body() + 1).fold(structure.links, usize::max);
        Ok(Self { inputs, laws, groups, needed, bodies, hanging })
    }

    /// Bodies at rest at the origin, as storage for a solution: one for each link, and after them one for the coordinate of each drive
    /// between two moving links.
    pub fn bodies(&self) -> Vec<Body<T>> {
        vec![Body::ground(); self.bodies]
    }

    /// The laws of a motion over time as they are at an instant, each continued beyond where another polynomial begins.
    pub fn continue_laws(&mut self, mechanism: &Mechanism, time: f64) {
        let laws = mechanism.input.drivers.iter().filter_map(|driver| driver.law.as_ref());
        self.laws = laws.map(|law| law.continued(time)).collect();
    }

    /// Places what is driven; the derivatives are exact.
    #[inline]
    pub fn set_input(&self, coordinate: T, bodies: &mut [Body<T>]) {
        if let (true, [input]) = (self.laws.is_empty(), &self.inputs[..]) {
            return Self::drive(*input, [coordinate, T::ONE, T::ZERO], bodies);
        }
        for (input, law) in self.inputs.iter().zip(&self.laws) {
            Self::drive(*input, coordinate.along(law), bodies);
        }
    }

    /// Places what is driven by laws at a time, so that derivatives are with respect to the coordinate of one of the drives, the
    /// others at rest.
    pub fn set_input_of(&self, driver: usize, time: T, bodies: &mut [Body<T>]) {
        for (index, (input, law)) in self.inputs.iter().zip(&self.laws).enumerate() {
            let rate = if index == driver { T::ONE } else { T::ZERO };
            let [place, ..] = time.along(law);
            Self::drive(*input, [place, rate, T::ZERO], bodies);
        }
    }

    /// Places one link, or the body of a coordinate, at a coordinate with its first and second derivative.
    #[inline(always)]
    fn drive(input: ChainInput<T>, [coordinate, first, second]: [T; 3], bodies: &mut [Body<T>]) {
        T::evaluate(
            #[inline(always)]
            move || match input {
                ChainInput::Crank { link, ground, own } => {
                    let (s, c) = coordinate.sin_cos();
                    let body = &mut bodies[link];
                    // PF1 and PF2 of a body that turns about a fixed point by the coordinate as its angle.
                    let arm = own.put(body, [c, s], ground);
                    own.put_first(body, first, arm, [T::ZERO; 2]);
                    own.put_second(body, second, arm, [T::ZERO; 2]);
                }
                ChainInput::Slider { link, axis, along, origin } => {
                    let body = &mut bodies[link];
                    [body.c, body.s] = axis;
                    [body.x, body.y] = plus(origin, scaled(coordinate, along));
                    [body.x1, body.y1] = scaled(first, along);
                    // No zero has a sign.
                    [body.x2, body.y2] = scaled(second, along).map(|part| part + T::ZERO);
                }
                ChainInput::Relative { body, is_angle: true } => {
                    let ((s, c), body) = (coordinate.sin_cos(), &mut bodies[body]);
                    (body.c, body.s, body.w1, body.w2) = (c, s, first, second);
                }
                ChainInput::Relative { body, is_angle: false } => {
                    let body = &mut bodies[body];
                    (body.x, body.x1, body.x2) = (coordinate, first, second);
                }
            },
        );
    }

    /// Solves all needed groups of the chain at one coordinate, each group in the mode given.
    ///
    /// # Errors
    ///
    /// [`ChainError`] with the first group that has no solution; groups before it are solved.
    #[inline]
    pub fn solve(
        &self,
        coordinate: T,
        ways: &[u8],
        order: Order,
        bodies: &mut [Body<T>],
        health: &mut [T],
    ) -> Result<(), ChainError> {
        self.solve_except(coordinate, ways, order, bodies, health, |_, _| None)
    }

    /// Derives all placed links at a time with respect to the coordinate of one drive, the others at rest.
    ///
    /// # Errors
    ///
    /// [`ChainError`] of a group in a singular position.
    pub fn derive_by(&self, drive: usize, time: T, bodies: &mut [Body<T>]) -> Result<(), ChainError> {
        self.set_input_of(drive, time, bodies);
        for (group, kernel) in self.groups.iter().enumerate().filter(|(group, _)| self.needed[*group]) {
            kernel.derive(bodies, Order::Second).map_err(|source| ChainError { group, source })?;
        }
        self.hang(bodies, Order::Second);
        Ok(())
    }

    /// Solves the needed groups at one coordinate; a group that `instead` places itself is skipped: `instead` returns
    /// the determinant of such a group, and `None` for a group that is to be solved.
    #[inline]
    pub(crate) fn solve_except(
        &self,
        coordinate: T,
        ways: &[u8],
        order: Order,
        bodies: &mut [Body<T>],
        health: &mut [T],
        instead: impl Fn(usize, &mut [Body<T>]) -> Option<T>,
    ) -> Result<(), ChainError> {
        self.set_input(coordinate, bodies);
        for (group, kernel) in self.groups.iter().enumerate() {
            if !self.needed[group] {
                continue;
            }
            if let Some(found) = instead(group, bodies) {
                health[group] = found;
                continue;
            }
            match kernel.solve(bodies, usize::from(ways[group]), order) {
                Ok(found) => health[group] = found,
                Err(source) => return Err(ChainError { group, source }),
            }
        }
        self.hang(bodies, order);
        Ok(())
    }

    /// Places the passive links by the bodies that carry them.
    pub fn hang(&self, bodies: &mut [Body<T>], order: Order) {
        self.hanging.iter().for_each(|link| link.solve(bodies, order));
    }
}

fn input_of<T: Real>(mechanism: &Mechanism, (index, driver): (usize, &Driver)) -> ChainInput<T> {
    let link = driver.link;
    if driver.is_relative() {
        return ChainInput::Relative { body: mechanism.links.len() + index, is_angle: driver.is_angle() };
    }
    match driver.pair {
        InputPair::Pin(point) => {
            let at = |body| vector(mechanism.place_in(point, body).unwrap_or_default());
            ChainInput::Crank { link, ground: at(assur_mechanism::GROUND), own: Anchor::new(at(link)) }
        }
        InputPair::Slide(slide) => slider_of(mechanism, slide),
    }
}

/// A sliding input; the guide is on the ground or on the input link.
fn slider_of<T: Real>(mechanism: &Mechanism, slide: usize) -> ChainInput<T> {
    let found = &mechanism.slides[slide];
    let (point, through) = (vector::<T>(found.point), vector::<T>(found.through));
    let (s, c) = T::from_f64(found.angle).sin_cos();
    let turned = T::from_f64(found.angle) + T::from_f64(found.tilt);
    // Where the guide is on the input link, the ground is what "slides" on it: displacement = (ground's point - through) along the
    // guide.
    let is_guide = found.on != assur_mechanism::GROUND;
    let (link, turned, own, at) =
        if is_guide { (found.on, -turned, through, point) } else { (found.link, turned, point, through) };
    let (ts, tc) = turned.sin_cos();
    let mut body = Body { c: tc, s: ts, ..Body::ground() };
    let along = if is_guide { body.turned([c, s]).map(|part| -part) } else { [c, s] };
    let arm = body.arm(own);
    body.hang_place(arm, at);
    ChainInput::Slider { link, axis: [tc, ts], along, origin: [body.x, body.y] }
}
