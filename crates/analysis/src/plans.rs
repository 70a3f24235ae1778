//! Plans of a position, reactions by cause and over the cycle, geometry of the contacts.

use std::sync::Arc;

use crate::results::{Analysis, ByCause, Cycle, Named, PairReaction, PositionResult};
use assur_diagram::{
    DiagramError, Enveloping, Hodograph, Share, Sheet, SignChange, Solver, constructions, enveloping, sheet,
    sign_changes, split,
};
use assur_force::{AnalyzerPlugin, Construction, Loads};
use assur_group::Order;
use assur_mechanism::{PairId, Range};

use crate::Calculation;

/// A guide whose force stays below this part of the greatest reaction is unloaded: the force is rounding.
const LEAST_FORCE: f64 = 1e-9;

impl Calculation {
    /// All plans of a position in its motion: prescribed, or of the steady regime. In a transient motion, and where no
    /// regime is found, the positions have no forces, and plans of forces are left out.
    ///
    /// Needs the whole mechanism: see [`Plan::is_partial`](crate::plan::Plan::is_partial).
    ///
    /// # Errors
    ///
    /// [`DiagramError`] where the position can't be assembled, or has no reactions.
    pub fn sheet(&self, index: usize) -> Result<Sheet, DiagramError> {
        // An error names the number of the position.
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

    /// The constructions on paper of the force analyzers at a position, step by step; none where the position has no
    /// forces.
    ///
    /// # Errors
    ///
    /// [`DiagramError`] where the position can't be assembled.
    pub fn constructions(&self, index: usize) -> Result<Vec<Construction>, DiagramError> {
        let mut position = self.linkage.position();
        self.linkage.solve_index(index, Order::Second, &mut position)?;
        let Some(loads) = self.loads.as_ref().filter(|_| self.positions_have_forces()) else {
            return Ok(Vec::new());
        };
        let state = self.state(position.coordinate);
        constructions(&self.linkage, &position, &loads.total(&state, &position.bodies))
    }

    /// The analyzer of the calculation, where it gives reactions; else the default one.
    fn reaction_analyzer(&self) -> Result<&'static AnalyzerPlugin, DiagramError> {
        match self.analyzer.filter(|analyzer| analyzer.gives_reactions) {
            Some(analyzer) => Ok(analyzer),
            None => Ok(assur_force::choose(None)?),
        }
    }

    /// Adds reactions by cause to every position that has reactions, and the polar diagrams of all reactions.
    ///
    /// # Errors
    ///
    /// [`DiagramError`] where a single cause has no reactions.
    pub fn add_causes(&self, analysis: &mut Analysis) -> Result<(), DiagramError> {
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
        analysis.cycle.hodographs = self.hodographs(&analysis.positions);
        Ok(())
    }

    /// Results from the reactions of all positions, and the geometry of the contacts.
    pub(crate) fn cycle(&self, positions: &[PositionResult]) -> Cycle {
        let with_forces = positions.iter().filter(|position| position.reactions.is_some());
        let indices: Vec<usize> = with_forces.map(|position| position.index).collect();
        Cycle {
            reaction_extremes: self
                .hodographs(positions)
                .iter()
                .map(|curve| curve.extreme(&indices))
                .collect(),
            sign_changes: self.sign_changes(positions),
            enveloping: self.enveloping(),
            ..Cycle::default()
        }
    }

    /// The polar diagrams of all reactions, over the positions that have them.
    fn hodographs(&self, positions: &[PositionResult]) -> Vec<Hodograph> {
        let each =
            positions.iter().filter_map(|position| Some((position.coordinate, position.reactions.as_ref()?)));
        let all: Vec<_> = each.collect();
        let Some((_, first)) = all.first() else { return Vec::new() };
        let ends =
            first.iter().flat_map(|(joint, reaction)| reaction.forces.iter().map(move |(on, _)| (joint, on)));
        let curve = |(joint, on): (&str, &Arc<str>)| {
            let force = |reactions: &Named<PairReaction>| {
                let forces = &reactions.get(joint)?.forces;
                forces.iter().find(|(link, _)| link == on).map(|(_, force)| *force)
            };
            Hodograph {
                joint: joint.to_owned(),
                on: on.to_string(),
                coordinates: all.iter().map(|(coordinate, _)| *coordinate).collect(),
                points: all.iter().map(|(_, reactions)| force(reactions).unwrap_or([f64::NAN; 2])).collect(),
                closed: matches!(self.linkage.mechanism.input.range, Range::Cycle(_)),
            }
        };
        ends.map(curve).collect()
    }

    /// A contact whose arc has no position somewhere in its interval is left out: the failures of the positions say
    /// why.
    fn enveloping(&self) -> Vec<Enveloping> {
        if self.plan.is_partial() {
            return Vec::new();
        }
        let mechanism = &self.linkage.mechanism;
        let each = mechanism.contacts.iter();
        each.filter_map(|contact| enveloping(&self.linkage, contact, mechanism.input.positions).ok())
            .collect()
    }

    /// Of the guides with a force; none where a position is missing, because the force is unknown there.
    fn sign_changes(&self, positions: &[PositionResult]) -> Named<Vec<SignChange>> {
        let (Some(loads), Ok(analyzer)) = (&self.loads, self.reaction_analyzer()) else {
            return Named::default();
        };
        let state_at = |coordinate: f64| self.state(coordinate);
        let least = LEAST_FORCE * sizes(positions, |_| true);
        let name = |slide: usize| self.linkage.mechanism.slides[slide].name.as_str();
        let slides = self.plan.wanted.reactions.iter().filter_map(|pair| match pair {
            PairId::Slide(slide) => Some(*slide),
            PairId::Pin(_) => None,
        });
        let slides: Vec<usize> =
            slides.filter(|slide| sizes(positions, |pair| pair == name(*slide)) > least).collect();
        if slides.is_empty() {
            return Named::default();
        }
        let solver = Solver {
            linkage: &self.linkage,
            loads,
            analyzer: analyzer.instance,
            order: self.plan.order,
            carrying: &self.plan.groups_carrying,
        };
        let changes = sign_changes(&solver, &slides, &state_at).unwrap_or_default();
        slides.into_iter().map(|slide| Arc::from(name(slide))).zip(changes).collect()
    }
}

/// Greatest force in the pairs of these names, N.
fn sizes(positions: &[PositionResult], wanted: impl Fn(&str) -> bool) -> f64 {
    let pairs = positions.iter().flat_map(|position| &position.reactions).flat_map(Named::iter);
    let forces = pairs.filter(|(name, _)| wanted(name)).flat_map(|(_, reaction)| &reaction.forces);
    forces.map(|(_, [x, y])| x.hypot(*y)).fold(0.0, f64::max)
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
