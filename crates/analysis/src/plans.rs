//! Plans of a position, reactions by cause and over the cycle, geometry of the contacts.

use std::sync::Arc;

use crate::results::{Analysis, ByCause, Cycle, Named, PairReaction, PositionResult};
use assur_diagram::{
    Enveloping, Hodograph, JointForce, PlansError, Sample, Share, Sheet, SignChange, Solver, constructions,
    enveloping, extremes, hodograph, sheet, sign_changes, split,
};
use assur_force::{AnalyzerPlugin, Construction, Loads};
use assur_group::{Order, Wrench};
use assur_mechanism::PairId;

use crate::Calculation;

/// A guide whose force stays below this part of the greatest reaction bears nothing but rounding.
const LEAST_FORCE: f64 = 1e-9;

impl Calculation {
    /// All plans of a position in its motion: prescribed, or of the steady regime. In a transient motion, and where no regime
    /// is found, forces do not belong to the positions and theirs are left out.
    ///
    /// Needs the whole mechanism: see [`Plan::is_partial`](crate::plan::Plan::is_partial).
    ///
    /// # Errors
    ///
    /// [`PlansError`] where the position can't be assembled, or has no reactions.
    pub fn sheet(&self, index: usize) -> Result<Sheet, PlansError> {
        // Told with the number of the position, where it can't be taken.
        self.linkage.solve_index(index, Order::Place, &mut self.linkage.position())?;
        let state = self.state(self.linkage.mechanism.input.coordinate(index));
        // At rest the plans are those for unit speed.
        let moves = state.speed != 0.0 || state.acceleration != 0.0;
        let own;
        let loads = if let Some(loads) = &self.loads {
            loads
        } else {
            own = Loads::compile(&self.linkage)?;
            &own
        };
        let found = sheet(&self.linkage, loads, &state, moves, self.reaction_analyzer()?)?;
        if self.positions_have_forces() {
            return Ok(found);
        }
        Ok(Sheet { polygons: Vec::new(), constructions: Vec::new(), by_cause: None, ..found })
    }

    /// The constructions on paper of the force analyzers at a position, step by step; none where forces do not belong to it.
    ///
    /// # Errors
    ///
    /// [`PlansError`] where the position can't be assembled.
    pub fn constructions(&self, index: usize) -> Result<Vec<Construction>, PlansError> {
        let mut position = self.linkage.position();
        self.linkage.solve_index(index, Order::Second, &mut position)?;
        let Some(loads) = self.loads.as_ref().filter(|_| self.positions_have_forces()) else {
            return Ok(Vec::new());
        };
        let state = self.state(position.coordinate);
        let mut wrenches = vec![Wrench::ZERO; self.linkage.structure.links];
        loads.apply(&state, &position.bodies, &mut wrenches);
        loads.inertia(&state, &position.bodies, &mut wrenches);
        constructions(&self.linkage, &position, &wrenches)
    }

    /// The analyzer of the study, where it gives reactions; else the default one.
    fn reaction_analyzer(&self) -> Result<&'static AnalyzerPlugin, PlansError> {
        match self.analyzer.filter(|analyzer| analyzer.gives_reactions) {
            Some(analyzer) => Ok(analyzer),
            None => Ok(assur_force::choose(None)?),
        }
    }

    /// Adds reactions by cause to every position that has reactions, and the polar diagrams of all reactions.
    ///
    /// # Errors
    ///
    /// [`PlansError`] where a cause alone has no reactions.
    pub fn add_causes(&self, analysis: &mut Analysis) -> Result<(), PlansError> {
        let Some(loads) = &self.loads else { return Ok(()) };
        let instance = self.reaction_analyzer()?.instance;
        let mut solved = self.linkage.position();
        for position in &mut analysis.positions {
            let Some(reactions) = &position.reactions else { continue };
            let state = self.state(position.coordinate);
            self.linkage.solve_index(position.index, Order::Second, &mut solved)?;
            let found = split(&self.linkage, &solved, loads, &state, instance)?;
            position.by_cause = Some(by_cause(&found.shares, reactions));
        }
        analysis.cycle.hodographs = self.hodographs(analysis)?;
        Ok(())
    }

    fn hodographs(&self, analysis: &Analysis) -> Result<Vec<Hodograph>, PlansError> {
        let samples = samples(&analysis.positions);
        let each = analysis.cycle.reaction_extremes.iter();
        each.map(|one| hodograph(&self.linkage, &samples, &one.joint, &one.on)).collect()
    }

    /// What follows from the reactions of all positions, and the geometry of the contacts.
    pub(crate) fn cycle(&self, positions: &[PositionResult]) -> Cycle {
        Cycle {
            reaction_extremes: extremes(&self.linkage, &samples(positions)),
            sign_changes: self.sign_changes(positions),
            enveloping: self.enveloping(),
            ..Cycle::default()
        }
    }

    /// A contact whose arc can't be followed through its interval is left out; the positions tell why.
    fn enveloping(&self) -> Vec<Enveloping> {
        if self.plan.is_partial() {
            return Vec::new();
        }
        let mechanism = &self.linkage.mechanism;
        let count = mechanism.input.positions.max(2);
        let contacts = 0..mechanism.contacts.len();
        contacts.filter_map(|contact| enveloping(&self.linkage, contact, count).ok()).collect()
    }

    /// Of the guides with a force; none where a position is missing, as the force can't be followed there.
    fn sign_changes(&self, positions: &[PositionResult]) -> Named<Vec<SignChange>> {
        let (Some(loads), Ok(analyzer)) = (&self.loads, self.reaction_analyzer()) else {
            return Named::default();
        };
        let state_at = |coordinate: f64| self.state(coordinate);
        let slides = self.plan.wanted.reactions.iter().filter_map(|pair| match pair {
            PairId::Slide(slide) => Some(*slide),
            PairId::Pin(_) => None,
        });
        let least = LEAST_FORCE * sizes(positions, |_| true);
        let solver = Solver {
            linkage: &self.linkage,
            loads,
            analyzer: analyzer.instance,
            order: self.plan.order,
            carrying: &self.plan.groups_carrying,
        };
        slides
            .filter_map(|slide| {
                let name = self.linkage.mechanism.slides[slide].name.as_str();
                if sizes(positions, |pair| pair == name) <= least {
                    return None;
                }
                let changes = sign_changes(&solver, slide, &state_at);
                changes.ok().map(|changes| (Arc::from(name), changes))
            })
            .collect()
    }
}

/// Greatest force in the pairs of these names, N.
fn sizes(positions: &[PositionResult], wanted: impl Fn(&str) -> bool) -> f64 {
    let pairs = positions.iter().flat_map(|position| &position.reactions).flat_map(Named::iter);
    let forces = pairs.filter(|(name, _)| wanted(name)).flat_map(|(_, reaction)| &reaction.forces);
    forces.map(|(_, [x, y])| x.hypot(*y)).fold(0.0, f64::max)
}

/// The reactions of the positions that have them.
fn samples(positions: &[PositionResult]) -> Vec<Sample> {
    let each = positions.iter().filter_map(|position| {
        let reactions = position.reactions.as_ref()?.iter();
        Some(Sample {
            index: position.index,
            coordinate: position.coordinate,
            reactions: reactions.flat_map(|(joint, reaction)| joint_forces(joint, reaction)).collect(),
            balancing: position.balancing.unwrap_or_default(),
        })
    });
    each.collect()
}

fn joint_forces(joint: &str, reaction: &PairReaction) -> Vec<JointForce> {
    let each = reaction.forces.iter().enumerate().map(|(nth, (link, force))| JointForce {
        joint: joint.to_owned(),
        on: link.to_string(),
        force: *force,
        moment: reaction.moment.filter(|_| nth == 0),
    });
    each.collect()
}

/// The shares in the order and for the pairs of the whole.
fn by_cause(shares: &[Share], whole: &Named<PairReaction>) -> ByCause {
    let mut found = ByCause::default();
    for share in shares {
        let mut cause = share.cause.clone();
        // A load may be called `weight` too.
        while found.balancing_by_cause.get(&cause).is_some() {
            cause.push_str(" (load)");
        }
        let cause: Arc<str> = cause.into();
        let pairs = whole.0.iter().map(|(name, _)| (Arc::clone(name), pair(share, name)));
        found.reactions_by_cause.push(Arc::clone(&cause), pairs.collect());
        found.balancing_by_cause.push(cause, share.balancing);
    }
    found
}

fn pair(share: &Share, name: &str) -> PairReaction {
    let forces = || share.reactions.iter().filter(|reaction| reaction.joint == name);
    PairReaction {
        forces: forces().map(|reaction| (reaction.on.as_str().into(), reaction.force)).collect(),
        moment: forces().find_map(|reaction| reaction.moment),
        offset: None,
    }
}
