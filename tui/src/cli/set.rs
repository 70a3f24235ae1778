//! `assur set`: a scene with other numbers, its comments kept.

use std::path::{Path, PathBuf};

use assur_mechanism::Key;
use assur_scene::edit::{ParsedText, TextPlace, quoted, replaced, split};
use assur_scene::{Dimension, Unit};
use assur_words::{Text, name, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::files;

#[derive(Debug, Clone, Args)]
pub(crate) struct SetArgs {
    /// Scene file; `-` is standard input
    scene: PathBuf,
    /// Values by key, such as "link.crank.points.A=120 mm" or motion.speed=6.28; a number alone is SI
    #[arg(value_name = "KEY=VALUE", required_unless_present = "row")]
    values: Vec<String>,
    /// The parameters of a row of a sweep, the first is 0: its number, and the file (*.csv or *.parquet)
    #[arg(long, num_args = 2, value_names = ["N", "RESULT"])]
    row: Option<Vec<String>>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(crate) fn run(args: &SetArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.scene)?;
    let text = scene::open(&args.scene, Style { strict: false, ..style })?.text;
    let document = ParsedText::of(&text);
    let mut places: Vec<(TextPlace, String)> = Vec::new();
    if let Some([row, result]) = args.row.as_deref().and_then(|row| <&[String; 2]>::try_from(row).ok()) {
        for (column, number) in parameters(row, Path::new(result))? {
            let (found, dimension) = measured(&document, &column)?;
            places.extend(found.into_iter().map(|place| {
                let toml = in_unit_of(&place, number, dimension);
                (place, toml)
            }));
        }
    }
    for value in &args.values {
        let problem =
            |problem: Text| Fault::Other(text!("cli-set", value = name(value.clone()), problem = problem));
        let (key, value) = value.split_once('=').ok_or_else(|| problem(text!("cli-write-set")))?;
        let key = Key::parse(key).map_err(problem)?;
        let found = document.find(&key).map_err(problem)?;
        // A later value of a key counts.
        places.retain(|(place, _)| found.iter().all(|new| new.span != place.span));
        places.extend(found.into_iter().map(|place| (place, toml(value.trim()))));
    }
    let text = replaced(&text, places.iter().map(|(place, toml)| (&place.span, toml.as_str())));
    let file = files::shown(&args.scene);
    let mechanism = assur_scene::read(&file, &text).map_err(Fault::scene)?;
    let warnings = mechanism.warnings.iter().map(|one| text!("cli-note", note = one));
    scene::tell_all(warnings.collect(), style)?;
    output.write(&text, Status::Done)
}

/// A value as TOML: a number alone as a number, everything else as a text.
fn toml(value: &str) -> String {
    let number = value.parse::<f64>().is_ok_and(f64::is_finite) || value.parse::<i64>().is_ok();
    if number { value.to_owned() } else { quoted(value) }
}

/// Digits behind the first with which every number is written.
const MOST_DIGITS: usize = 17;

/// The number, SI, as it is written in the unit of a place of the scene: with the fewest digits that are read back as the same number.
/// Some numbers none of another unit is read as; these are in the SI unit.
fn in_unit_of(place: &TextPlace, number: f64, dimension: Option<Dimension>) -> String {
    let unit = place.text.as_deref().and_then(split).map(|(_, unit)| unit).unwrap_or_default();
    let scale =
        dimension.filter(|_| !unit.is_empty()).and_then(|kind| Some((kind, Unit::of(&unit, kind).ok()?)));
    let Some((kind, scale)) = scale else { return number.to_string() };
    let near = number / scale.si(1.0);
    let rounded = (0..MOST_DIGITS).filter_map(|digits| format!("{near:.digits$e}").parse::<f64>().ok());
    let mut all = rounded.chain([near.next_down(), near.next_up()]);
    match all.find(|written| scale.si(*written).total_cmp(&number).is_eq()) {
        Some(written) => quoted(&format!("{written} {unit}")),
        None => quoted(format!("{number} {}", kind.si()).trim_end()),
    }
}

/// The places of a parameter that a column holds, and what it measures: its name is the key, with the unit where it has one.
fn measured(document: &ParsedText<'_>, column: &str) -> Result<(Vec<TextPlace>, Option<Dimension>), Fault> {
    let find = |key: &str| Key::parse(key).and_then(|key| document.find(&key));
    let first = match find(column) {
        Ok(places) => return Ok((places, None)),
        Err(problem) => problem,
    };
    for (dimension, suffix) in assur_sweep::suffixes() {
        if let Some(Ok(places)) = column.strip_suffix(&format!("_{suffix}")).map(find) {
            return Ok((places, Some(dimension)));
        }
    }
    Err(Fault::Other(text!("cli-set", value = name(column.to_owned()), problem = first)))
}

/// The parameters of a row of a sweep: names of the columns before `status`, and their numbers.
fn parameters(row: &str, result: &Path) -> Result<Vec<(String, f64)>, Fault> {
    let refused = |problem: Text| Fault::from(files::FileError::read(result, problem));
    let row: usize =
        row.parse().map_err(|_| Fault::Other(text!("cli-row-number", row = name(row.to_owned()))))?;
    let missing = || refused(text!("cli-no-row", row = assur_words::number(row)));
    if result.extension().is_some_and(|end| end.eq_ignore_ascii_case("parquet")) {
        let file = std::fs::File::open(result)
            .map_err(|error| files::FileError::read(result, assur_words::text_of(&error)))?;
        let found = assur_parquet::sweep::parameters(file, row).map_err(Fault::told)?;
        return found.ok_or_else(missing);
    }
    let table = files::read(result)?;
    let mut lines = table.trim_start_matches('\u{feff}').lines();
    let cells = |line: &str| -> Vec<String> {
        line.split(',').map(|cell| cell.trim_matches('"').to_owned()).collect()
    };
    let header = lines.next().map(cells).unwrap_or_default();
    let count = header.iter().position(|name| name == "status").ok_or_else(|| {
        let semicolons = header.iter().any(|cell| cell.contains(';'));
        refused(if semicolons { text!("cli-semicolons") } else { text!("cli-no-sweep") })
    })?;
    let line = lines.nth(row).map(cells).ok_or_else(missing)?;
    let numbers = line.iter().take(count).map(|cell| cell.parse::<f64>().ok());
    let numbers = numbers.collect::<Option<Vec<_>>>().ok_or_else(|| refused(text!("cli-no-sweep")))?;
    Ok(header.into_iter().zip(numbers).collect())
}

#[cfg(test)]
mod tests;
