//! Loads and reactions of solved positions, one at a time or eight at once.

use std::collections::BTreeSet;

use assur_group::{Body, Wrench};
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_number::{Lanes, Real};

use crate::group_by_group::drives;
use crate::sharing::size;
use crate::{ForceAnalyzer, ForceError, FrictionIteration, LoadState, Loads, Reactions, applicable};

/// A reaction that changes by less than this part of loads that exchange their shares does not depend on them.
const LEAST_RESPONSE: f64 = 1e-9;

/// Finds reactions and balancing load by a method, and over time the load of each drive.
pub fn solve_by(
    analyzer: &dyn ForceAnalyzer,
    linkage: &Linkage,
    position: &Position,
    loads: &mut [Wrench<f64>],
    out: &mut Reactions,
) -> Result<(), ForceError> {
    if !linkage.kind().is_time() {
        return analyzer.solve(linkage, position, loads, out);
    }
    let given = loads.to_vec();
    let found = analyzer.solve(linkage, position, loads, out);
    out.find_drives(linkage, &position.bodies, &given);
    found
}

/// The force analysis of a mechanism by one method, with its memory: one position after the other.
#[derive(Debug, Clone)]
pub struct Kinetostatics<'a> {
    linkage: &'a Linkage,
    loads: &'a Loads,
    analyzer: &'a dyn ForceAnalyzer,
    wrenches: Vec<Wrench<f64>>,
    /// The result of the position solved last.
    pub reactions: Reactions,
}

impl<'a> Kinetostatics<'a> {
    /// Memory for the reactions in all pairs whose groups are placed and carry a load; `carrying`: whether a group does.
    pub fn new(
        linkage: &'a Linkage,
        loads: &'a Loads,
        analyzer: &'a dyn ForceAnalyzer,
        carrying: &[bool],
    ) -> Self {
        let wrenches = vec![Wrench::ZERO; linkage.structure.links];
        let reactions = Reactions::new(linkage).without_idle(carrying).with_friction(loads, linkage);
        Self { linkage, loads, analyzer, wrenches, reactions }
    }

    /// The same without the certificates of friction, which take time: they may be NaN.
    #[must_use]
    pub fn without_certificates(mut self) -> Self {
        if let Some(friction) = &mut self.reactions.friction {
            friction.are_certificates_wanted = false;
        }
        self
    }

    /// Finds the reactions and the balancing load of a state; the position is solved up to PF2.
    #[inline]
    pub fn solve(&mut self, state: &LoadState, position: &Position) -> Result<(), ForceError> {
        let at_change_point = self.linkage.is_at_change_point(position);
        // A passive part may hold the mechanism where the ways of a group meet.
        if at_change_point && self.linkage.structure.passive.is_empty() {
            return Err(ForceError::ChangePoint(position.coordinate));
        }
        self.load(state, position);
        let found = solve_by(self.analyzer, self.linkage, position, &mut self.wrenches, &mut self.reactions);
        if found.is_ok() && self.reactions.balancing.is_finite() {
            return found;
        }
        if at_change_point && matches!(found, Err(ForceError::Singular { .. })) {
            return Err(ForceError::ChangePoint(position.coordinate));
        }
        // Whatever a method says of loads without a value: the load is the reason.
        self.loads.finite(&self.linkage.mechanism, state, &position.bodies)?;
        found
    }

    /// Evaluates the loads of a state, with the senses of friction.
    #[inline]
    fn load(&mut self, state: &LoadState, position: &Position) {
        self.loads.evaluate(state, &position.bodies, &mut self.wrenches);
        if let Some(friction) = &mut self.reactions.friction {
            self.loads.senses(state, &position.bodies, &mut friction.senses);
            friction.drive = state.drive;
            if friction.senses.iter().any(|sense| sense.is_nan()) {
                self.loads.leave_open(&mut self.wrenches);
            }
        }
    }

    /// The pairs whose reactions depend on how loads that hold a motion at rest together share in it, which the equilibrium leaves open;
    /// none in another state, and where dry friction holds it, whose reactions are unknown anyway.
    fn shared(&self, state: &LoadState, position: &Position) -> Result<Vec<usize>, ForceError> {
        if !Loads::holds_at_rest(state) || self.reactions.friction.is_some() {
            return Ok(Vec::new());
        }
        let scale = self.linkage.structure.scale;
        let mut response = self.reactions.clone();
        let mut open = BTreeSet::new();
        for (mut wrenches, sum) in self.loads.exchanges(state, &position.bodies, scale) {
            response.pairs.fill(Wrench::ZERO);
            self.analyzer.solve(self.linkage, position, &mut wrenches, &mut response)?;
            let pairs = response.pairs.iter().enumerate();
            let felt = pairs.filter(|(_, pair)| size(pair, scale) > LEAST_RESPONSE * sum);
            open.extend(felt.map(|(index, _)| index));
        }
        Ok(open.into_iter().collect())
    }

    /// Where dry friction leaves no solution at a state: see [`FrictionAnalysis::jamming_limit`](crate::FrictionAnalysis).
    pub fn jamming_limit(&mut self, state: &LoadState, position: &Position) -> Option<f64> {
        self.load(state, position);
        let friction = self.analyzer.friction(self.linkage, position, &self.reactions)?;
        Some(friction.jamming_limit(&self.wrenches))
    }

    /// How friction is found at a state: see [`FrictionAnalysis::iteration`](crate::FrictionAnalysis).
    pub fn iteration(&mut self, state: &LoadState, position: &Position) -> Vec<FrictionIteration> {
        self.load(state, position);
        let friction = self.analyzer.friction(self.linkage, position, &self.reactions);
        friction.map_or_else(Vec::new, |friction| friction.iteration(&self.wrenches))
    }

    /// The balancing load at a change point, where the reactions are not determined but the powers of the loads are: by a
    /// method that finds it without reactions; `None` where there is none.
    pub fn balancing_alone(&self, state: &LoadState, position: &Position) -> Option<f64> {
        let without_reactions = applicable(self.linkage).into_iter().filter(|plugin| !plugin.gives_reactions);
        let method = without_reactions.min_by_key(|plugin| plugin.rank)?;
        let mut wrenches = self.loads.total(state, &position.bodies);
        let mut found = Reactions::new(self.linkage);
        method.instance.solve(self.linkage, position, &mut wrenches, &mut found).ok()?;
        Some(found.balancing)
    }
}

/// The force analysis of a mechanism by one method, with its memory: eight positions at once.
#[derive(Debug, Clone)]
pub struct LaneKinetostatics<'a> {
    wrenches: Vec<Wrench<Lanes>>,
    /// The result of the eight positions solved last; a lane without solution holds any numbers.
    pub reactions: Reactions<Lanes>,
    /// For the lanes that are solved one at a time.
    single: Kinetostatics<'a>,
    position: Position,
}

impl<'a> LaneKinetostatics<'a> {
    /// Memory as for one position at a time.
    pub fn new(single: Kinetostatics<'a>) -> Self {
        let linkage = single.linkage;
        let mut reactions = Reactions::new(linkage)
            .without_idle(&single.reactions.solved)
            .with_friction(single.loads, linkage);
        if let (Some(all), Some(one)) = (&mut reactions.friction, &single.reactions.friction) {
            all.are_certificates_wanted = one.are_certificates_wanted;
        }
        Self {
            wrenches: vec![Wrench::ZERO; linkage.structure.links],
            reactions,
            position: linkage.position(),
            single,
        }
    }

    /// Finds the reactions and the balancing loads of eight states; the positions are solved up to PF2. Every lane gets
    /// the bits that [`Kinetostatics::solve`] gives.
    ///
    /// # Errors
    ///
    /// The lanes whose reactions are not determined, each with the reason; the others are solved.
    #[inline]
    pub fn solve(
        &mut self,
        states: &[LoadState; Lanes::WIDTH],
        position: &LanePosition,
    ) -> Result<(), Vec<(usize, ForceError)>> {
        let Kinetostatics { linkage, loads, analyzer, .. } = self.single;
        loads.evaluate(states, &position.bodies, &mut self.wrenches);
        if let Some(friction) = &mut self.reactions.friction {
            friction.doubts.clear();
            loads.write_relative(&position.bodies, &mut friction.senses);
            for (lane, state) in states.iter().enumerate() {
                loads.turn_to_senses(state, &mut friction.senses, |all| &mut all.0[lane]);
            }
        }
        let is_timed = linkage.kind().is_time();
        let given = if is_timed { self.wrenches.clone() } else { Vec::new() };
        let together = analyzer.solve_lanes(linkage, position, &mut self.wrenches, &mut self.reactions);
        if is_timed {
            self.reactions.find_drives(linkage, &position.bodies, &given);
        }
        let near = position.coordinates.0.map(|coordinate| linkage.is_interpolated(coordinate));
        let valueless = self.reactions.balancing.0.map(|load| !load.is_finite());
        if together && (near, valueless) == ([false; Lanes::WIDTH], [false; Lanes::WIDTH]) {
            return Ok(());
        }
        let alone = std::array::from_fn(|lane| near[lane] || valueless[lane] || !together);
        self.solve_alone(alone, states, position)
    }

    /// Makes the reactions in a lane unknown (NaN) that depend on how several loads, such as two brakes, share in holding the motion at
    /// rest; for a state that was solved.
    pub fn leave_shares_open(
        &mut self,
        lane: usize,
        state: &LoadState,
        position: &LanePosition,
    ) -> Result<(), ForceError> {
        position.copy_lane(lane, &mut self.position);
        for pair in self.single.shared(state, &self.position)? {
            let Wrench { fx, fy, m } = &mut self.reactions.pairs[pair];
            (fx.0[lane], fy.0[lane], m.0[lane]) = (f64::NAN, f64::NAN, f64::NAN);
        }
        Ok(())
    }

    /// The [balancing load at a change point](Kinetostatics::balancing_alone) in a lane.
    pub fn balancing_alone(
        &mut self,
        lane: usize,
        state: &LoadState,
        position: &LanePosition,
    ) -> Option<f64> {
        position.copy_lane(lane, &mut self.position);
        self.single.balancing_alone(state, &self.position)
    }

    /// Where dry friction leaves no solution in a lane.
    pub fn jamming_limit(&mut self, lane: usize, state: &LoadState, position: &LanePosition) -> Option<f64> {
        position.copy_lane(lane, &mut self.position);
        self.single.jamming_limit(state, &self.position)
    }

    /// Solves some of the lanes one at a time.
    #[cold]
    fn solve_alone(
        &mut self,
        alone: [bool; Lanes::WIDTH],
        states: &[LoadState; Lanes::WIDTH],
        position: &LanePosition,
    ) -> Result<(), Vec<(usize, ForceError)>> {
        let mut failures = Vec::new();
        for lane in (0..Lanes::WIDTH).filter(|&lane| alone[lane]) {
            position.copy_lane(lane, &mut self.position);
            match self.single.solve(&states[lane], &self.position) {
                Ok(()) => self.reactions.put(lane, &self.single.reactions),
                Err(error) => failures.push((lane, error)),
            }
        }
        if failures.is_empty() { Ok(()) } else { Err(failures) }
    }
}

impl<T: Real> Reactions<T> {
    /// Finds the load of each drive over time from the reactions, under these loads; none where the balancing load acts elsewhere.
    fn find_drives(&mut self, linkage: &Linkage, bodies: &[Body<T>], loads: &[Wrench<T>]) {
        if self.unit.is_some() {
            return;
        }
        drives(linkage, bodies, loads, &self.pairs, &mut self.drives);
    }
}

impl Reactions<Lanes> {
    /// Puts the reactions of one position into a lane.
    fn put(&mut self, lane: usize, one: &Reactions) {
        let put = |all: &mut [Lanes], one: &[f64]| {
            all.iter_mut().zip(one).for_each(|(all, one)| all.0[lane] = *one);
        };
        self.balancing.0[lane] = one.balancing;
        self.drives.resize(one.drives.len(), Lanes::ZERO);
        put(&mut self.drives, &one.drives);
        self.further.resize(one.further.len(), Lanes::ZERO);
        put(&mut self.further, &one.further);
        self.pairs.iter_mut().zip(&one.pairs).for_each(|(all, one)| all.set_lane(lane, one));
        self.open.resize(one.open.len(), Lanes::ZERO);
        put(&mut self.open, &one.open);
        if let (Some(all), Some(one)) = (&mut self.friction, &one.friction) {
            put(&mut all.forces, &one.forces);
            put(&mut all.certificates, &one.certificates);
            all.doubts.extend(one.doubts.iter().map(|(_, doubt)| (lane, doubt.clone())));
        }
    }
}
