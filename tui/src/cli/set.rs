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
use super::table::Table;
use crate::files;

#[derive(Debug, Clone, Args)]
pub(crate) struct SetArgs {
    /// Scene file; `-` is standard input
    scene: PathBuf,
    /// Values by key, such as "link.crank.points.A=120 mm" or motion.speed=6.28; a number alone is SI
    #[arg(value_name = "KEY=VALUE", required_unless_present = "row")]
    values: Vec<String>,
    /// The parameters of a row of a sweep: its number, as the column `row` has it, and the file (*.csv or *.parquet)
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
        for (column, value) in parameters(row, Path::new(result))? {
            let unknown =
                |problem: Text| Fault::Other(text!("cli-set", value = name(column.clone()), problem));
            let (key, dimension) = assur_sweep::parameter(&document, &column).map_err(unknown)?;
            for place in document.find(&key).map_err(unknown)? {
                let number = value.parse::<f64>().ok();
                let toml =
                    number.map_or_else(|| quoted(&value), |number| in_unit_of(&place, number, dimension));
                places.push((place, toml));
            }
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

/// The parameters of a row of a sweep: names of the columns before `status`, and their values. Rows of earlier versions have no
/// numbers, and are counted.
fn parameters(row: &str, result: &Path) -> Result<Vec<(String, String)>, Fault> {
    let refused = |problem: Text| Fault::from(files::FileError::read(result, problem));
    let row: usize =
        row.parse().map_err(|_| Fault::Other(text!("cli-row-number", row = name(row.to_owned()))))?;
    let mut table = Table::open(result)?;
    if !table.is_result() {
        return Err(refused(text!("cli-no-sweep")));
    }
    table.header.pop();
    let is_numbered = table.header.first().is_some_and(|first| first == "row");
    for (count, read) in table.rows.enumerate() {
        let (_, mut cells) = read?;
        let number = if is_numbered { cells.first().and_then(|cell| cell.parse().ok()) } else { Some(count) };
        if number == Some(row) {
            cells.truncate(table.header.len());
            if cells.len() < table.header.len() || cells.iter().any(String::is_empty) {
                return Err(refused(text!("cli-no-sweep")));
            }
            return Ok(table.header.into_iter().zip(cells).skip(usize::from(is_numbered)).collect());
        }
    }
    Err(refused(text!("cli-no-row", row = assur_words::number(row))))
}

#[cfg(test)]
mod tests;
