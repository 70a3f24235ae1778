//! The working of a position as typeset equations.

use std::fmt::Write;

use assur_figure::svg::escaped;
use assur_force::{Loads, State as Instant};
use assur_mechanism::Motion;
use assur_working::Working;
use assur_worksheet::{Entry, Line};

use super::Context;
use super::document::Block;

/// The equations of the first chosen position.
pub(super) fn blocks(context: &mut Context<'_>) -> Result<Vec<Block>, String> {
    let words = context.words;
    let (Some(scene), Some(&position)) = (&context.state.scene, context.positions.first()) else {
        return Ok(Vec::new());
    };
    let linkage = &scene.linkage;
    let mechanism = &linkage.mechanism;
    let found = matches!(mechanism.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }));
    let forces = !found && (mechanism.motion.is_some() || mechanism.has_loads()) && linkage.range.is_some();
    let loads = if forces { Loads::compile(linkage).ok() } else { None };
    let state = Instant::prescribed(mechanism, mechanism.input.coordinate(position));
    let working = Working::of(linkage, loads.as_ref(), state, position).map_err(|error| error.to_string())?;
    let mut blocks = vec![Block::Heading(words.with("working", &[("position", position.to_string())]))];
    for section in &working.sections {
        // Remarks are written in English alone.
        let lines = section.entries.iter().filter_map(|entry| match entry {
            Entry::Note(text) => (words.language == "en").then(|| Block::Text(text.clone())),
            Entry::Given { name, result, unit, .. } => {
                let text = format!("{} = {} {unit}", symbols(name), words.number(result));
                Some(Block::Equation(text))
            }
            Entry::Line(line) => Some(Block::Equation(equation(context, line))),
        });
        let lines: Vec<Block> = lines.collect();
        if !lines.is_empty() {
            blocks.push(Block::Subheading(words.phrase(&section.title)));
            blocks.extend(lines);
        }
    }
    Ok(blocks)
}

fn equation(context: &Context<'_>, line: &Line) -> String {
    let words = context.words;
    let mut text = symbols(&line.name);
    let substituted = if line.substituted == line.text { "" } else { &line.substituted };
    for part in [line.text.as_str(), substituted].into_iter().filter(|part| !part.is_empty()) {
        text.push_str(" = ");
        text.push_str(&words.number(&symbols(part)));
    }
    if line.substituted != line.result {
        text.push_str(" = ");
        text.push_str(&words.number(&line.result));
    }
    if !line.unit.is_empty() {
        text.push(' ');
        text.push_str(&escaped(&line.unit));
    }
    text
}

/// An expression with Greek letters, subscripts and powers: `x_A` becomes an x with the subscript A.
fn symbols(text: &str) -> String {
    let mut html = String::new();
    let mut rest = text;
    while let Some(letter) = rest.chars().next() {
        let name_ends = |c: char| !(c.is_alphanumeric() || c == '_' || c == '\'');
        if letter.is_alphabetic() {
            let end = rest.find(name_ends).unwrap_or(rest.len());
            html.push_str(&symbol(&rest[..end]));
            rest = &rest[end..];
            continue;
        }
        rest = &rest[letter.len_utf8()..];
        match letter {
            '*' => html.push('·'),
            '-' => html.push('−'),
            '^' => {
                let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
                let _ = write!(html, "<sup>{}</sup>", &rest[..end]);
                rest = &rest[end..];
            }
            other => html.push_str(&escaped(&other.to_string())),
        }
    }
    html
}

/// A name: its letter, and what follows the first low line as a subscript.
fn symbol(name: &str) -> String {
    let (base, below) = name.split_once('_').unwrap_or((name, ""));
    let letters = base.trim_end_matches('\'');
    let primes = base[letters.len()..].replace("''", "″").replace('\'', "′");
    let letters = match letters {
        "phi" => "φ",
        "alpha" => "α",
        "beta" => "β",
        "pi" => "π",
        "sqrt" => "√",
        function @ ("sin" | "cos" | "tan" | "atan2" | "asin" | "acos" | "abs" | "sign") => {
            return function.to_owned();
        }
        other => other,
    };
    let below = below.replace('_', ", ");
    let sub = if below.is_empty() { String::new() } else { format!("<sub>{}</sub>", escaped(&below)) };
    format!("<i>{}</i>{primes}{sub}", escaped(letters))
}
