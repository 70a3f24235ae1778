//! `assur explain`.

use assur_analysis::plan::Plan;
use assur_analysis::{method_of_motion, methods};
use assur_force::{LoadError, Loads, State};
use assur_kinematics::Linkage;
use assur_mechanism::{Mechanism, Motion};
use assur_structure::Structure;
use assur_working::{Working, WorkingError};

use super::args::ExplainArgs;
use super::fault::{Fault, Status};
use super::style::Style;
use super::{output, scene};

pub(crate) fn run(args: &ExplainArgs, style: Style) -> Result<Status, Fault> {
    let options = scene::options(&args.scene.methods)?;
    let mechanism = scene::read(&args.scene.scene, style)?;
    if let Some(position) = args.position {
        return working(args, mechanism, position, style);
    }
    let path = &args.scene.scene;
    let fault = |error: &dyn std::fmt::Display| scene::in_file(path, &error.to_string());
    let structure = Structure::of(&mechanism).map_err(|error| fault(&error))?;
    let methods = methods(&mechanism, &options);
    let plan = Plan::of(&mechanism, &structure, methods.by_groups);
    let equation = method_of_motion(&mechanism, structure.clone(), &options)
        .map_err(|error| scene::fault(path, &error, style))?;
    let text = assur_report::explain(&mechanism, &structure, &plan, &methods, equation.as_deref());
    output::print(&style.text(&text))?;
    Ok(Status::Done)
}

/// Every equation of one position with its numbers.
fn working(args: &ExplainArgs, mechanism: Mechanism, index: usize, style: Style) -> Result<Status, Fault> {
    let fault = |error: &dyn std::fmt::Display| scene::in_file(&args.scene.scene, &error.to_string());
    let linkage = Linkage::compile(mechanism).map_err(|error| fault(&error))?;
    let mechanism = &linkage.mechanism;
    let found = matches!(mechanism.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }));
    let wants_forces = !found && (mechanism.motion.is_some() || mechanism.has_loads());
    let of_loads = |error: LoadError| scene::fault(&args.scene.scene, &error.into(), style);
    let wants_forces = wants_forces && linkage.range.is_some();
    let loads = if wants_forces { Some(Loads::compile(&linkage).map_err(of_loads)?) } else { None };
    if found {
        style.tell(
            "note: the working shows places and transfer functions; the speed of this scene follows from the equation of \
             motion (`assur analyze`), and its forces with it",
        );
    }
    let state = State::prescribed(mechanism, mechanism.input.coordinate(index));
    match Working::of(&linkage, loads.as_ref(), state, index) {
        Ok(working) => {
            output::print(&style.text(&working.text()))?;
            Ok(Status::Done)
        }
        Err(error @ WorkingError::Position(_)) => {
            style.tell(&fault(&error).to_string());
            Ok(Status::Failed)
        }
        Err(error) => Err(fault(&error)),
    }
}
