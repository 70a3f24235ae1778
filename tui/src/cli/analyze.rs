//! `assur analyze` and `assur check`.

use std::io::{self, Write};

use assur_analysis::results::{Analysis, Table};
use assur_analysis::{Calculation, Options};
use assur_mechanism::Warning;
use assur_parquet as parquet;
use assur_report::{csv, json, text as report, topic};
use assur_words::{Describe, Text, Told, text};

use super::args::AnalyzeArgs;
use super::fault::{Fault, Status};
use super::options::{CheckedArgs, Format};
use super::output::{self, Output};
use super::style::Style;
use super::{plans, scene};
use crate::progress::ProgressLine;
use crate::verdict::Verdict;

pub(crate) fn run(args: &AnalyzeArgs, style: Style) -> Result<Status, Fault> {
    let form = Form::of(args)?;
    let mut kept = Vec::new();
    let done = analyze(args, form, style, &mut kept);
    for mistake in kept {
        style.tell(mistake);
    }
    done
}

/// Calculates and writes results. What is probably not meant in the scene is told, or, where the results have it themselves, `kept` until
/// they are written.
fn analyze(args: &AnalyzeArgs, form: Form, style: Style, kept: &mut Vec<Text>) -> Result<Status, Fault> {
    let scene = &args.checked.scene;
    let output = Output::of(args.output.as_deref(), &scene.scene)?;
    let options = args.checked.options(false)?;
    let session = scene::read(&scene.scene)?;
    let mut tell = |warnings: &[Warning]| -> Result<(), Fault> {
        let mistakes = scene::mistakes(&session, warnings, style)?;
        if form == Form::Json {
            kept.extend(mistakes);
        } else {
            for mistake in mistakes {
                style.tell(mistake);
            }
        }
        Ok(())
    };
    tell(&session.mechanism.warnings)?;
    let mut study = scene::calculated(&session, &options, style)?;
    tell(&study.mistakes())?;
    study.tells_poles = matches!(form, Form::Text | Form::Json);
    study.tells_friction_cycle = study.tells_poles;
    args.plans.refuse(args.format, &study)?;
    let line = ProgressLine::new(style.language);
    let mut analysis = study.analyze(&mut line.watch()).map_err(Fault::told)?;
    let checks = study.checks(args.checked.checks.into(), &mut line.watch());
    analysis.add_checks(checks.map_err(Fault::told)?);
    let count = study.linkage.mechanism.input.positions;
    let positions = plans::chosen(&args.positions, form == Form::Text, &analysis, count)?;
    let whole = || scene::calculated(&session, &Options { whole: true, ..options }, style);
    let added = args.plans.add(&study, whole, style, &mut analysis)?;
    let verdict = Verdict::of(&analysis, &study, Some(&session));
    if !verdict.writable {
        verdict.tell(style);
        return Ok(verdict.status());
    }
    let status = verdict.status().or(added);
    let only = positions.as_deref();
    let results = |analysis| Results { study: &study, analysis, only, line: &line, style };
    let written = match form {
        Form::Json => results(&analysis).json(output, status),
        Form::Csv => results(&analysis).csv(output, status),
        Form::Parquet => results(&analysis).parquet(output, status),
        Form::Text => {
            analysis.peaks =
                assur_book::peaks(&study, &analysis.positions, &study.edges(&analysis.positions));
            let report = report::report(&analysis, &study.linkage, positions.as_deref(), style.words());
            output.write(report.map_err(Fault::told)?, status)
        }
    };
    drop(line);
    if form == Form::Json && written.is_ok() {
        kept.clear();
    }
    if form == Form::Parquet && !analysis.trajectory.is_empty() {
        style.tell(text!("cli-parquet-motion"));
    }
    verdict.tell(style);
    written
}

pub(crate) fn check(args: &CheckedArgs, style: Style) -> Result<Status, Fault> {
    // The whole mechanism is checked, whatever results the scene requests.
    let options = args.options(true)?;
    let session = scene::open(&args.scene.scene, style)?;
    let mut study = scene::calculation(&session, &options, style)?;
    study.tells_friction_cycle = false;
    let line = ProgressLine::new(style.language);
    let mut analysis = study.analyze(&mut line.watch()).map_err(Fault::told)?;
    let checks = study.checks(args.checks.into(), &mut line.watch()).map_err(Fault::told)?;
    drop(line);
    analysis.add_checks(checks);
    output::print(&report::told(style.words(), |page| topic::checks(&analysis.checks, page)))?;
    let verdict = Verdict::of(&analysis, &study, Some(&session));
    verdict.tell(style);
    Ok(verdict.proved())
}

/// Form of the results, by the format and the name of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Text,
    Json,
    Csv,
    Parquet,
}

impl Form {
    fn of(args: &AnalyzeArgs) -> Result<Self, Fault> {
        let ending = args.output.as_deref().and_then(|path| path.extension());
        let ends_in = |form: &str| ending.is_some_and(|ending| ending.eq_ignore_ascii_case(form));
        match (args.format, ends_in("parquet")) {
            (Format::Text, false) if ends_in("json") => Ok(Self::Json),
            (Format::Text, true) => Ok(Self::Parquet),
            (_, true) => Err(Fault::Other(text!("cli-parquet-form"))),
            (Format::Csv, _) if args.output.is_none() => Err(Fault::Other(text!("cli-csv-folder"))),
            (Format::Csv, _) => Ok(Self::Csv),
            (Format::Json, _) => Ok(Self::Json),
            (Format::Text, _) => Ok(Self::Text),
        }
    }
}

/// Results to be written: positions that are not kept are calculated once more, block by block.
struct Results<'a> {
    study: &'a Calculation,
    analysis: &'a Analysis,
    /// The positions whose rows are written; `None`: all.
    only: Option<&'a [usize]>,
    line: &'a ProgressLine,
    style: Style,
}

impl Results<'_> {
    fn each<T: Send>(
        &self,
        work: impl Fn(&Table) -> T + Sync,
        take: impl FnMut(T) -> io::Result<()>,
    ) -> io::Result<()> {
        let wanted = |table: &Table| match self.only {
            Some(only) => work(&table.only(|number| only.contains(&number))),
            None => work(table),
        };
        let done = self.study.each_block(self.analysis, &mut self.line.watch(), wanted, take);
        done.map_err(other)?
    }

    fn json(&self, output: Output<'_>, status: Status) -> Result<Status, Fault> {
        let around = json::analysis::Around::of(self.analysis, self.style.ascii_data).map_err(Fault::told)?;
        output.write_by(status, |out| {
            out.write_all(&around.before)?;
            // Each row stands after a comma, but the first of all.
            let mut skipped = 1;
            self.each(
                |table| around.rows(table),
                |parts| {
                    let mut parts = parts.iter().filter(|part| !part.is_empty());
                    parts.try_for_each(|part| out.write_all(&part[std::mem::take(&mut skipped)..]))
                },
            )?;
            around.after.iter().try_for_each(|part| out.write_all(part))
        })
    }

    fn csv(&self, output: Output<'_>, status: Status) -> Result<Status, Fault> {
        let ascii = self.style.ascii_data;
        let sheets = csv::of_positions(self.analysis, ascii);
        let trajectory = csv::of_trajectory(self.analysis, ascii);
        let headers = sheets.iter().chain(&trajectory).map(csv::CsvTable::header);
        let headers = headers.collect::<Result<Vec<_>, _>>().map_err(Fault::told)?;
        let names: Vec<&str> = sheets.iter().chain(&trajectory).map(|sheet| sheet.file).collect();
        output.write_folder(status, &csv::FILES, &names, |outs| {
            outs.iter_mut().zip(&headers).try_for_each(|(out, header)| out.write_all(header))?;
            if let (Some(sheet), Some(out)) = (&trajectory, outs.last_mut()) {
                out.write_all(&sheet.rows(&self.analysis.trajectory))?;
            }
            self.each(
                |table| sheets.iter().map(|sheet| sheet.rows(table)).collect::<Vec<_>>(),
                |texts| outs.iter_mut().zip(&texts).try_for_each(|(out, text)| out.write_all(text)),
            )
        })
    }

    fn parquet(&self, output: Output<'_>, status: Status) -> Result<Status, Fault> {
        output.write_by(status, |out| {
            let mut writer = parquet::Writer::new(self.analysis, out).map_err(other)?;
            self.each(Table::clone, |table| writer.add(&table).map_err(other))?;
            writer.finish().map_err(other)
        })
    }
}

/// An error where errors of writing are expected.
#[expect(clippy::needless_pass_by_value, reason = "takes errors as `map_err` hands them over")]
fn other(error: impl Describe) -> io::Error {
    io::Error::other(Told(error.describe()))
}
