//! `assur plugins` and `assur motors`.

use std::path::Path;

use assur_analysis::Options;
use assur_book::{Cell, Column, Table, row};
use assur_motor::{Motor, MotorFilter, catalogues, flag_meaning, list_motors, rpm};
use assur_report::text::{told, told_within};
use assur_report::topic;
use assur_scene::{Dimension, quantity};
use assur_words::{Text, joined, name, number, text, unit};

use super::args::MotorArgs;
use super::fault::{Fault, Status};
use super::style::Style;
use super::{output, scene};

/// Every registered plugin: kind, name, crate, one line, and the source of its formulas or numbers.
pub(crate) fn plugins(style: Style) -> Result<Status, Fault> {
    let mut rows = Vec::new();
    let mut add = |sort: &'static str, of: [&'static str; 2], told: [&Text; 2]| {
        rows.push(row![text!(sort), name(of[0]), name(of[1]), told[0].clone(), told[1].clone()]);
    };
    for plugin in assur_group::groups().map_err(Fault::told)? {
        add("cli-plugin-group", [plugin.name, plugin.crate_name], [&plugin.summary, &plugin.source]);
    }
    for plugin in assur_force::analyzers().map_err(Fault::told)? {
        add("cli-plugin-analyzer", [plugin.name, plugin.crate_name], [&plugin.summary, &plugin.source]);
    }
    for plugin in assur_integrator::integrators().map_err(Fault::told)? {
        add("cli-plugin-integrator", [plugin.name, plugin.crate_name], [&plugin.summary, &plugin.source]);
    }
    for plugin in catalogues().map_err(Fault::told)? {
        add("cli-plugin-catalogue", [plugin.name, plugin.crate_name], [&plugin.summary, &plugin.source]);
    }
    for plugin in assur_import::importers().map_err(Fault::told)? {
        add("cli-plugin-importer", [plugin.name, plugin.crate_name], [&plugin.summary, &plugin.source]);
    }
    let head =
        ["cli-plugin-sort", "cli-plugin-name", "cli-plugin-crate", "cli-plugin-what", "cli-plugin-source"];
    print(Table::list(Text::default(), head.map(|id| Column::of(text!(id)))).rows(rows), style)?;
    Ok(Status::Done)
}

/// Prints a list, each row in one line.
fn print(table: Table, style: Style) -> Result<(), Fault> {
    output::print(&told_within(u16::MAX.into(), style.words(), |page| page.table(table)))
}

pub(crate) fn motors(args: &MotorArgs, style: Style) -> Result<Status, Fault> {
    if let Some(scene) = &args.advise {
        return advise(scene, style);
    }
    let filter = MotorFilter {
        catalogue: args.catalogue.clone(),
        min_power: args.min_power.as_deref().map(power).transpose()?,
        max_power: args.max_power.as_deref().map(power).transpose()?,
        max_speed: args.max_speed.as_deref().map(speed).transpose()?,
        poles: args.poles,
        designation: args.designation.clone(),
    };
    let all = catalogues().map_err(Fault::told)?;
    let motors = list_motors(&all, &filter).map_err(Fault::told)?;
    let rounded = |speed: f64| number(format_args!("{:.0}", rpm(speed)));
    let designation = |motor: &Motor| {
        Cell::from(&if style.ascii { motor.latin_designation() } else { motor.designation.clone() })
    };
    let table = Table::each(Text::default(), motors.iter().copied())
        .column(text!("cli-plugin-catalogue"), |motor| Cell::from(&motor.catalogue))
        .column(text!("cli-motor-motor"), |motor| designation(motor))
        .column(text!("cli-motor-poles"), |motor| number(motor.poles))
        .column(unit("kW"), |motor| number(motor.rated_power / 1e3))
        .column(text!("cli-motor-sync"), |motor| rounded(motor.synchronous_speed))
        .column(unit("rpm"), |motor| rounded(motor.rated_speed))
        .column(text!("cli-motor-breakdown"), |motor| motor.max_torque_ratio.map(number))
        .column(joined(" ", [name("J"), unit("kg m^2")]), |motor| motor.rotor_inertia.map(number))
        .column(text!("cli-motor-remarks"), |motor| name(motor.flags.join(" ")));
    print(table.table(), style)?;
    output::print(&remarks(&motors, style))?;
    if motors.is_empty() {
        style.tell(text!("cli-no-motor"));
    }
    Ok(Status::Done)
}

fn advise(path: &Path, style: Style) -> Result<Status, Fault> {
    const MOST: usize = 20;
    let session = scene::open(path, style)?;
    let study = scene::calculation(&session, &Options::default(), style)?;
    let (motors, count) = study.advice(MOST).map_err(|error| Fault::Scene(session.fault(&error)))?;
    output::print(&told(style.words(), |page| topic::advice(&motors, count, page)))?;
    Ok(Status::Done)
}

/// The meaning of the remarks on these motors, one line each, below the list.
fn remarks(motors: &[&Motor], style: Style) -> String {
    let mut flags: Vec<&str> = motors.iter().flat_map(|motor| &motor.flags).map(String::as_str).collect();
    flags.sort_unstable();
    flags.dedup();
    let line = |flag: &str| {
        flag_meaning(flag).map(|meaning| format!("  {flag}: {}\n", meaning.render(style.language)))
    };
    let lines: String = flags.into_iter().filter_map(line).collect();
    if lines.is_empty() {
        lines
    } else {
        format!("\n{}\n{lines}", text!("cli-motor-remarks").render(style.language))
    }
}

fn speed(text: &str) -> Result<f64, Fault> {
    quantity(text, Dimension::AngularSpeed).map_err(Fault::other)
}

fn power(text: &str) -> Result<f64, Fault> {
    quantity(text, Dimension::Power).map_err(Fault::told)
}
