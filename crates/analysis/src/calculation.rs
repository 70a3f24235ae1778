//! A mechanism with its plan, compiled.

use std::sync::{Arc, OnceLock};

use assur_dynamics::equation;
use assur_force::{AnalyzerPlugin, LoadState, Loads, Side};
use assur_group::Order;
use assur_kinematics::{Linkage, decompose};
use assur_mechanism::{Mechanism, Motion};
use assur_structure::Structure;
use assur_words::Text;

use crate::{AnalysisError, InputMotion, plan::Plan, progress::Watch};

/// The integrator that is used where none is named.
pub const DEFAULT_INTEGRATOR: &str = assur_integrator::AUTO;

/// Methods that a user may choose.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Options {
    /// Force analyzer by name; `None`: the preferred one.
    pub analyzer: Option<String>,
    /// Integrator by name; `None`: the scene's.
    pub integrator: Option<String>,
    /// All results, whatever the scene requests.
    pub whole: bool,
    /// Reactions that passive parts leave undetermined are given as those of least norm.
    pub least_norm: bool,
}

/// A scene ready to be calculated.
#[derive(Debug)]
pub struct Calculation {
    /// The compiled mechanism; groups that the plan does not need are left out.
    pub linkage: Arc<Linkage>,
    /// What is to be calculated.
    pub plan: Plan,
    /// The loads, where the plan needs them.
    pub loads: Option<Loads>,
    /// The force analyzer, where the plan needs one.
    pub analyzer: Option<&'static AnalyzerPlugin>,
    /// How the input moves.
    pub motion: InputMotion,
    /// Why the requested motion is not found; results that do not depend on it are calculated nevertheless.
    pub no_motion: Option<AnalysisError>,
    /// Whether undetermined reactions are given as those of least norm.
    pub least_norm: bool,
    /// Whether notes say where links run through infinity, which may take long to find; not unless a caller asks for it.
    pub tells_poles: bool,
    /// Whether dry friction over the whole cycle is among the results; to be found it takes many positions more.
    pub tells_friction_cycle: bool,
    /// Parts of the request that have no use in this scene.
    pub(crate) unused: Vec<Text>,
    /// The numbers of the positions, and of the samples of the motion, in which rounding is greatest, once all are calculated.
    pub(crate) notable: OnceLock<[Vec<usize>; 2]>,
}

/// A calculation that was made from another one.
#[derive(Debug)]
pub struct Varied {
    /// The calculation.
    pub calculation: Calculation,
    /// The mechanism of the other one.
    pub before: Mechanism,
    /// Whether both have the same positions, up to the same order.
    pub same_positions: bool,
}

impl Calculation {
    /// Decomposes a mechanism into groups, plans and compiles it, and finds its motion. `watch` receives the progress
    /// of the motion, and may stop it; [`unwatched`](crate::unwatched) lets it run.
    pub fn of(mechanism: Mechanism, options: &Options, watch: &mut Watch<'_>) -> Result<Self, AnalysisError> {
        let structure = decompose(&mechanism).map_err(assur_kinematics::CompileError::from)?;
        let plan = plan(&mechanism, &structure, options);
        let linkage = Linkage::compile_for(mechanism, structure, &plan.groups_needed)?;
        Self::planned(Arc::new(linkage), plan, None, options, watch)
    }

    /// The calculation of a mechanism that differs in numbers only, with what it has in common with this one: structure and
    /// plan; where the positions are the same, positions and loads too.
    pub fn varied(
        self,
        mechanism: Mechanism,
        options: &Options,
        watch: &mut Watch<'_>,
    ) -> Result<Varied, AnalysisError> {
        let Self { linkage, mut plan, loads, .. } = self;
        let order = plan.order;
        plan.fit(&mechanism, &linkage.structure);
        let (linkage, before, same) = Arc::unwrap_or_clone(linkage).varied(mechanism, &plan.groups_needed)?;
        let same_positions = same && plan.order == order;
        let earlier = loads.as_ref().filter(|_| same).map(|loads| (&before, loads));
        let calculation = Self::planned(Arc::new(linkage), plan, earlier, options, watch)?;
        Ok(Varied { calculation, before, same_positions })
    }

    /// The calculation of a plan on a linkage that is compiled for the groups that the plan needs; `earlier`: a mechanism with the
    /// same positions, and its loads.
    pub fn planned(
        linkage: Arc<Linkage>,
        plan: Plan,
        earlier: Option<(&Mechanism, &Loads)>,
        options: &Options,
        watch: &mut Watch<'_>,
    ) -> Result<Self, AnalysisError> {
        let find = |linkage: &Linkage, loads: Option<&Loads>| match InputMotion::of(
            linkage, loads, options, watch,
        ) {
            Ok(motion) => Ok((motion, None)),
            Err(error) if error.is_no_solution() => Ok((InputMotion::Prescribed, Some(error))),
            Err(error) => Err(error),
        };
        Self::moving(linkage, plan, earlier, options, find)
    }

    /// All results of the scene, whatever it requests, with the motion that was found; `linkage`: the same with all groups.
    pub fn whole(&self, linkage: Arc<Linkage>, options: &Options) -> Result<Self, AnalysisError> {
        let options = Options { whole: true, ..options.clone() };
        let plan = plan(&linkage.mechanism, &linkage.structure, &options);
        Self::moving(linkage, plan, None, &options, |_, _| Ok((self.motion.clone(), self.no_motion.clone())))
    }

    /// The calculation of a plan with a motion that is found from the linkage and its loads, or why there is none.
    fn moving(
        linkage: Arc<Linkage>,
        plan: Plan,
        earlier: Option<(&Mechanism, &Loads)>,
        options: &Options,
        find: impl FnOnce(&Linkage, Option<&Loads>) -> Result<(InputMotion, Option<AnalysisError>), AnalysisError>,
    ) -> Result<Self, AnalysisError> {
        let wants_loads = (plan.forces || plan.reduction || plan.dynamics) && can_be_loaded(&linkage);
        let loads = if wants_loads { Some(Loads::varied(&linkage, earlier)?) } else { None };
        let analyzer = if plan.forces { Some(analyzer(&linkage, options)?) } else { None };
        let (motion, no_motion) = find(&linkage, loads.as_ref())?;
        let unused = crate::warnings::unused(&linkage.mechanism, options);
        let least_norm = options.least_norm;
        let notable = OnceLock::new();
        Ok(Self {
            linkage,
            plan,
            loads,
            analyzer,
            motion,
            no_motion,
            least_norm,
            tells_poles: false,
            tells_friction_cycle: true,
            unused,
            notable,
        })
    }

    /// Whether forces belong to the positions: not where the motion is transient, or not found.
    pub fn positions_have_forces(&self) -> bool {
        match self.linkage.mechanism.motion {
            None | Some(Motion::Prescribed { .. }) => true,
            Some(Motion::Steady { .. }) => self.no_motion.is_none(),
            Some(Motion::Transient { .. }) => false,
        }
    }

    /// Relative tolerance of a transient motion; 0 for another one.
    pub(crate) fn tolerance(&self) -> f64 {
        match self.linkage.mechanism.motion {
            Some(Motion::Transient { tolerance, .. }) => tolerance,
            _ => 0.0,
        }
    }

    /// State of the input at the coordinate of a position: as prescribed, or in the steady regime.
    pub fn state(&self, coordinate: f64) -> LoadState {
        self.motion.state(&self.linkage.mechanism, coordinate)
    }

    /// A sample of a transient motion by its number, and how many there are.
    pub fn sample(&self, number: usize) -> (Option<LoadState>, usize) {
        match &self.motion {
            InputMotion::Transient(found) => {
                (found.instants.get(number).map(|instant| instant.state), found.instants.len())
            }
            _ => (None, 0),
        }
    }

    /// Moment of the drive on the input link (N m; force, N), and moment of inertia (mass) of flywheel and rotor reduced to it,
    /// in a state of a motion that follows from its equation; `None` where the motion is prescribed, or held by the loads.
    pub fn drive_in(&self, state: &LoadState) -> Option<[f64; 2]> {
        match &self.motion {
            InputMotion::Prescribed => None,
            _ if matches!(state.side, Side::Held { .. }) => None,
            InputMotion::Transient(_) => {
                let motion = equation(&self.linkage, self.loads.as_ref()?).ok()?;
                Some([motion.drive.torque(state), motion.drive.inertia])
            }
            InputMotion::Steady(found) => {
                let regime = &found.regime;
                Some([regime.state(state.coordinate).drive, regime.drive_inertia])
            }
        }
    }
}

/// Whether there is a position that loads can act in; without one no load can be compiled, and the positions themselves report
/// why. A motion that follows from its equation begins in the first one.
fn can_be_loaded(linkage: &Linkage) -> bool {
    let (mechanism, mut position) = (&linkage.mechanism, linkage.position());
    let mut exists = |index| linkage.solve_index(index, Order::Place, &mut position).is_ok();
    linkage.range.is_some()
        || !mechanism.has_equation_of_motion() && (0..mechanism.input.positions).any(&mut exists)
}

/// The methods of a calculation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Methods {
    /// Force analyzer.
    pub analyzer: String,
    /// Whether this analyzer solves group by group, so that groups without a load can be left out.
    pub by_groups: bool,
    /// Integrator of a motion that is not prescribed.
    pub integrator: String,
}

/// The methods that a calculation of this mechanism uses.
pub fn methods(mechanism: &Mechanism, structure: &Structure, options: &Options) -> Methods {
    let own = match &mechanism.motion {
        Some(Motion::Transient { integrator, .. }) => integrator.as_str(),
        _ => DEFAULT_INTEGRATOR,
    };
    let (named, friction) = (options.analyzer.as_deref(), !mechanism.frictions.is_empty());
    let chosen = assur_force::choose(named, friction, !structure.passive.is_empty());
    Methods {
        // A name that is not registered is an error only where the method is needed.
        analyzer: chosen.as_ref().map_or(named.unwrap_or_default(), |plugin| plugin.name).to_owned(),
        // Friction may load any group, and its sense needs the motion of all.
        by_groups: !friction && chosen.is_ok_and(|plugin| plugin.by_groups),
        integrator: options.integrator.clone().unwrap_or_else(|| own.to_owned()),
    }
}

/// What a calculation of this mechanism does.
pub fn plan(mechanism: &Mechanism, structure: &Structure, options: &Options) -> Plan {
    let output = mechanism.output.as_ref().filter(|_| !options.whole);
    Plan::of(mechanism, structure, output, methods(mechanism, structure, options).by_groups)
}

fn analyzer(linkage: &Linkage, options: &Options) -> Result<&'static AnalyzerPlugin, AnalysisError> {
    let plugin = assur_force::choose(
        options.analyzer.as_deref(),
        !linkage.mechanism.frictions.is_empty(),
        !linkage.structure.passive.is_empty(),
    )?;
    match plugin.supports(linkage) {
        Ok(()) => Ok(plugin),
        Err(reason) => Err(AnalysisError::Unfit { analyzer: plugin.name, reason }),
    }
}
