//! The English words of a text in another language, for tests of what a person reads.

use std::collections::BTreeSet;

/// Authors and makers, as the sources of methods and motors name them.
const AUTHORS: &str = "Ortega Rheinboldt Hairer rsett Wanner Leroy Somer IMfinity Innomotics Motive rev Bonfiglioli \
     Linkage linkage2 PMKS PMKSWeb Web GitHub Windows Copy URL";
/// Symbols, signs of files and programs: no registry has them.
const SYMBOLS: &str = "phi1 phi2 rpm slug sum max abs sin cos tan atan2 sign step rms kor phi alpha beta delta sigma pi dq dw dt PF0 PF1 PF2 TestPf Pogr1 \
                       Mmax Mn Typst Markdown HTML SVG PNG DXF CSV JSON TOML Parquet UTF ASCII Braille Sobol kitty iTerm2 XDG_CONFIG_HOME HOME \
                       NO_COLOR FILE SCENE KEY FOLDER NAME toml csv svg png pdf dxf txt html md typ parquet json new fg assur Ctrl \
                       true false auto off on open set compare";

/// The words of a text: runs of Latin letters, digits and underscores.
pub(crate) fn words(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '_'));
    words.filter(|word| word.contains(|letter: char| letter.is_ascii_alphabetic()))
}

/// Whether a word is a symbol, of one or two letters with digits; or symbols and signs side by side in a drawing.
fn is_symbol(word: &str) -> bool {
    let letters = || word.chars().filter(char::is_ascii_alphabetic);
    let drawn = word.contains(|letter: char| letter.is_ascii_digit() || letter.is_ascii_uppercase());
    let others: BTreeSet<char> = letters().filter(|letter| !"ovx".contains(*letter)).collect();
    // A symbol of the working has subscripts: l_A_B.
    let parts = || word.split('_').all(|part| part.len() <= 2);
    // Of a plan: the normal part of the acceleration of C relative to A, a^n_CA, behind its letter.
    let relative = ["n_", "t_", "r_", "c_", "v_", "a_"]
        .iter()
        .filter_map(|kind| word.trim_matches(['o', 'v', 'x']).strip_prefix(kind));
    let is_relative =
        |points: &str| points.chars().all(|letter| letter.is_ascii_uppercase() || letter.is_ascii_digit());
    letters().count() <= 2
        || relative.into_iter().any(is_relative)
        || others.is_empty()
        || drawn && others.len() <= 2
        || parts()
}

/// A text without what it quotes: lines of files in quotes and brackets, examples that are indented, keys before `=`.
fn unquoted(text: &str) -> String {
    let mut kept = String::new();
    let mut end = None;
    for letter in text.chars() {
        match (end, letter) {
            (Some(sign), _) if letter == sign || letter == '\n' => end = None,
            (Some(_), _) => {}
            (None, '`' | '"') => end = Some(letter),
            (None, '[') => end = Some(']'),
            (None, _) => kept.push(letter),
        }
    }
    let before_sign = |line: &str| match line.split_once(" = ") {
        Some((head, rest)) => format!("{} {rest}", head.rsplit_once(' ').map_or("", |(head, _)| head)),
        None => line.to_owned(),
    };
    kept.lines().map(before_sign).collect::<Vec<_>>().join("\n")
}

/// What the registries name, the symbols, and the names of authors.
pub(crate) fn of_the_registries() -> String {
    let mut all = format!("{SYMBOLS} {AUTHORS}");
    let mut add = |text: &str| all.extend([" ", text]);
    for plugin in assur_group::groups().unwrap() {
        for text in [plugin.name, plugin.kind, plugin.crate_name] {
            add(text);
        }
    }
    for plugin in assur_force::analyzers().unwrap() {
        for text in [plugin.name, plugin.crate_name] {
            add(text);
        }
    }
    for plugin in assur_integrator::integrators().unwrap() {
        for text in [plugin.name, plugin.crate_name] {
            add(text);
        }
    }
    let catalogues = assur_motor::catalogues().unwrap();
    for plugin in &catalogues {
        for text in [plugin.name, plugin.crate_name] {
            add(text);
        }
    }
    for motor in assur_motor::list_motors(&catalogues, &assur_motor::MotorFilter::default()).unwrap() {
        for text in [&motor.designation, &motor.catalogue] {
            add(text);
        }
    }
    all
}

/// The English words of a text: what is neither quoted, nor a symbol, nor known.
pub(crate) fn english(text: &str, known: impl Fn(&str) -> bool) -> Vec<String> {
    let text = unquoted(text);
    words(&text).filter(|word| !is_symbol(word) && !known(&word.to_lowercase())).map(str::to_owned).collect()
}
