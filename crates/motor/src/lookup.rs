//! Finding one motor among rows by what someone typed.

use assur_mechanism::appearance;
use assur_words::{Text, name, text, to_ascii};

use crate::{Motor, MotorError, error::names};

/// How many designations an error shows.
const SHOWN: usize = 5;
/// How many similar designations an error suggests.
const SUGGESTED: usize = 3;

/// The motor of that designation. Without regard to case, spaces and script, in this order:
///
/// 1. the whole designation;
/// 2. without the climatic version on either side (`4A100L4` finds `4А100L4У3`);
/// 3. the leading words of a designation that consists of several (`LSES 250 MZ` finds `LSES 250 MZ 2p 55 kW`).
///
/// `place` names the origin of the rows in words, for errors.
///
/// # Errors
///
/// [`MotorError`] with the nearest designations if none fits, with the first of them if several do.
pub fn find_designation<'a, I>(rows: I, designation: &str, place: &Text) -> Result<&'a Motor, MotorError>
where
    I: IntoIterator<Item = &'a Motor> + Clone,
{
    let ways: [fn(&str, &str) -> bool; 3] = [same_designation, same_base, is_leading_words];
    for way in ways {
        let fits = |m: &&Motor| way(&m.designation, designation);
        let found: Vec<&Motor> = rows.clone().into_iter().filter(fits).collect();
        match found[..] {
            [] => {}
            [motor] => return Ok(motor),
            _ => return Err(ambiguous(&found, designation, place)),
        }
    }
    let hint = hint(rows, designation);
    let designation = name(designation.to_owned());
    Err(MotorError(text!("motor-not-found", designation, catalogue = place, hint)))
}

/// What may have been meant: motors of a power that was given in place of a designation, else those named alike.
fn hint<'a>(rows: impl IntoIterator<Item = &'a Motor> + Clone, designation: &str) -> Text {
    if let Some(power) = power(designation) {
        // Up to the rounding of the units.
        let same = |m: &&Motor| (m.rated_power - power).abs() <= 1e-9 * power;
        let found: Vec<&Motor> = rows.clone().into_iter().filter(same).collect();
        if !found.is_empty() {
            // As the command line reads it, in every language; to a milliwatt, without the rounding of the units.
            let power = name(((power * 1e3).round() / 1e6).to_string());
            let shown: Vec<_> = found.iter().take(SHOWN).map(|m| m.designation.clone()).collect();
            let (candidates, more) = (names(&shown), more(found.len()));
            return text!("motor-hint-power", power, count = found.len(), candidates, more);
        }
    }
    match nearest(rows, designation) {
        none if none.is_empty() => text!("motor-hint-list"),
        alike => text!("motor-hint-nearest", nearest = names(&alike)),
    }
}

/// What follows a list of so many of which not all are shown.
fn more(count: usize) -> Text {
    name(if count > SHOWN { ", ..." } else { "" })
}

/// The power that a text names, W.
fn power(text: &str) -> Option<f64> {
    const UNITS: [(&str, f64); 6] =
        [("kW", 1e3), ("MW", 1e6), ("W", 1.0), ("кВт", 1e3), ("МВт", 1e6), ("Вт", 1.0)];
    let (digits, size) = UNITS.iter().find_map(|&(unit, size)| Some((text.strip_suffix(unit)?, size)))?;
    Some(digits.trim().replace(',', ".").parse::<f64>().ok()? * size)
}

fn same_base(row: &str, asked: &str) -> bool {
    let same = |row: &str, asked: &str| without_climate(row) == without_climate(asked);
    same(&normalize_designation(row), &normalize_designation(asked))
        || same(&normalize_latin(row), &normalize_latin(asked))
}

fn is_leading_words(row: &str, asked: &str) -> bool {
    let ends = row.char_indices().filter(|(_, c)| c.is_whitespace()).map(|(at, _)| at);
    ends.into_iter().any(|end| same_designation(&row[..end], asked))
}

fn ambiguous(found: &[&Motor], designation: &str, place: &Text) -> MotorError {
    // Rows of several catalogues may share a designation: then only the catalogue tells them apart.
    let several_places = found.iter().any(|m| m.catalogue != found[0].catalogue);
    let show = |m: &&Motor| {
        if several_places { format!("{} ({})", m.designation, m.catalogue) } else { m.designation.clone() }
    };
    let designation = name(designation.to_owned());
    let (count, more) = (found.len(), more(found.len()));
    let candidates = names(&found.iter().take(SHOWN).map(show).collect::<Vec<_>>());
    MotorError(text!("motor-ambiguous", designation, count, catalogue = place, candidates, more))
}

/// The rows whose designations need the fewest edits to become the requested one.
fn nearest<'a>(rows: impl IntoIterator<Item = &'a Motor>, designation: &str) -> Vec<String> {
    let asked = normalize_latin(designation);
    let asked = without_climate(&asked);
    // Designations further away than that are not similar.
    let most = asked.chars().count() / 2;
    let distance = |m: &Motor| {
        let key = normalize_latin(&m.designation);
        let row = without_climate(&key);
        // The difference of the lengths is a lower bound, and cheap to compute.
        let near = row.len().abs_diff(asked.len()) <= most;
        near.then(|| strsim::osa_distance(row, asked)).filter(|&d| d <= most)
    };
    let mut alike: Vec<(usize, &Motor)> = rows.into_iter().filter_map(|m| Some((distance(m)?, m))).collect();
    alike.sort_by_key(|&(d, _)| d);
    alike.into_iter().take(SUGGESTED).map(|(_, m)| m.designation.clone()).collect()
}

/// Designation by look: upper case, without spaces, every Cyrillic letter that looks like a Latin one
/// replaced by it. `4а 100l4` and `4A100L4` become `4A100L4`.
pub fn normalize_designation(text: &str) -> String {
    let letters = text.chars().filter(|c| !c.is_whitespace());
    appearance(&letters.flat_map(char::to_uppercase).collect::<String>())
}

/// Designation in ASCII, by sound: `АИР71В4` becomes `AIR71B4`. Case and spacing stay. The Cyrillic letter В
/// becomes B, as Latin name plates have it; a character without a Latin form becomes `?`.
pub fn latin_designation(text: &str) -> String {
    text.chars().map(latin).collect()
}

/// Whether two designations are the same without regard to case, spaces and script.
pub fn same_designation(a: &str, b: &str) -> bool {
    normalize_designation(a) == normalize_designation(b) || normalize_latin(a) == normalize_latin(b)
}

/// Designation by sound, made comparable: upper case, without spaces.
pub(crate) fn normalize_latin(text: &str) -> String {
    normalize_designation(&latin_designation(text))
}

/// The key (a normalized designation) without the climatic version: `4A100L4U3` gives `4A100L4`.
///
/// The climatic version (У, УХЛ, Т and the category of placing 1-5, GOST 15150) does not change the ratings.
pub(crate) fn without_climate(key: &str) -> &str {
    let Some(body) = key.strip_suffix(['1', '2', '3', '4', '5']) else { return key };
    let base = ["UHL", "YXЛ", "U", "Y", "T"].iter().find_map(|letters| body.strip_suffix(letters));
    // A climatic version follows the number of poles.
    base.filter(|base| base.ends_with(|c: char| c.is_ascii_digit())).unwrap_or(key)
}

/// A character of a designation in ASCII. A few letters are written otherwise than in words.
fn latin(c: char) -> String {
    let upper = match c.to_uppercase().next().unwrap_or(c) {
        'В' => "B".to_owned(),
        'Ї' => "I".to_owned(),
        'Й' => "J".to_owned(),
        'Х' => "H".to_owned(),
        'Ц' => "C".to_owned(),
        'Щ' => "SCH".to_owned(),
        upper => to_ascii(&upper.to_string()).to_ascii_uppercase(),
    };
    if c.is_lowercase() { upper.to_ascii_lowercase() } else { upper }
}
