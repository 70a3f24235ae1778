//! A mechanism with its plan, compiled.

use assur_force::{AnalyzerPlugin, Loads};
use assur_kinematics::Linkage;
use assur_mechanism::{Mechanism, Motion};
use assur_plan::{Methods, Plan};
use assur_structure::Structure;

use crate::AnalysisError;

/// The force analyzer that is taken where none is named.
pub const DEFAULT_ANALYZER: &str = "groups";
/// The integrator that is taken where none is named.
pub const DEFAULT_INTEGRATOR: &str = "auto";

/// What a user may choose.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Options {
    /// Force analyzer by name; `None`: [`DEFAULT_ANALYZER`].
    pub analyzer: Option<String>,
    /// Integrator by name; `None`: the scene's.
    pub integrator: Option<String>,
}

/// A scene ready to be calculated.
#[derive(Debug)]
pub struct Study {
    /// The compiled mechanism; groups that the plan does not need are left out.
    pub linkage: Linkage,
    /// What is calculated.
    pub plan: Plan,
    /// The loads, where the plan needs them.
    pub loads: Option<Loads>,
    /// The force analyzer, where the plan needs one.
    pub analyzer: Option<&'static AnalyzerPlugin>,
}

impl Study {
    /// Takes a mechanism apart, plans and compiles it.
    ///
    /// # Errors
    ///
    /// [`AnalysisError`] where the scene as a whole can't be calculated.
    pub fn of(mechanism: Mechanism, options: &Options) -> Result<Self, AnalysisError> {
        let structure = Structure::of(&mechanism).map_err(assur_kinematics::CompileError::from)?;
        let plan = Plan::of(&mechanism, &structure, &methods(&mechanism, options));
        refuse_unavailable(&mechanism)?;
        let linkage = Linkage::compile_for(mechanism, structure, &plan.groups_needed)?;
        // A load that can't be compiled for want of a position is told by the positions themselves.
        let wants_loads = (plan.forces || plan.reduction) && linkage.range.is_some();
        let loads = if wants_loads { Some(Loads::compile(&linkage)?) } else { None };
        let analyzer = if plan.forces { Some(analyzer(&linkage, options)?) } else { None };
        Ok(Self { linkage, plan, loads, analyzer })
    }
}

/// The methods that a calculation of this mechanism takes.
pub fn methods(mechanism: &Mechanism, options: &Options) -> Methods {
    let own = match &mechanism.motion {
        Some(Motion::Transient { integrator, .. }) => integrator.as_str(),
        _ => DEFAULT_INTEGRATOR,
    };
    Methods {
        analyzer: options.analyzer.clone().unwrap_or_else(|| DEFAULT_ANALYZER.to_owned()),
        integrator: options.integrator.clone().unwrap_or_else(|| own.to_owned()),
    }
}

fn refuse_unavailable(mechanism: &Mechanism) -> Result<(), AnalysisError> {
    let what = match (&mechanism.motion, &mechanism.drive) {
        (Some(Motion::Transient { .. }), _) => "motion of kind `transient`",
        (Some(Motion::Steady { .. }), _) => "motion of kind `steady`",
        (_, Some(_)) => "`[drive]`",
        _ => return Ok(()),
    };
    Err(AnalysisError::NotAvailable { what })
}

fn analyzer(linkage: &Linkage, options: &Options) -> Result<&'static AnalyzerPlugin, AnalysisError> {
    let plugin = assur_force::find(options.analyzer.as_deref().unwrap_or(DEFAULT_ANALYZER))?;
    match plugin.instance.supports(linkage) {
        Ok(()) => Ok(plugin),
        Err(reason) => Err(AnalysisError::Unfit { analyzer: plugin.name, reason }),
    }
}
