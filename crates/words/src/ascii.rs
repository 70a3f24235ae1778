//! Text without characters beyond ASCII.

use std::borrow::Cow;

/// The ASCII spelling of signs of units and formulas, and of letters that have one.
fn twin(c: char) -> Option<&'static str> {
    Some(match c {
        '·' | '×' => "*",
        '²' => "^2",
        '³' => "^3",
        '°' => " deg",
        'µ' | 'μ' => "u",
        '−' | '–' | '—' | '\u{2011}' => "-",
        '≤' => "<=",
        '│' => "|",
        '…' => "...",
        '“' | '”' | '„' | '«' | '»' => "\"",
        '‘' | '’' | '′' => "'",
        '″' => "''",
        'ä' => "ae",
        'ö' => "oe",
        'ü' => "ue",
        'ß' => "ss",
        'é' | 'è' => "e",
        'à' => "a",
        'ω' => "omega",
        'φ' => "phi",
        'ψ' => "psi",
        'δ' => "delta",
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'ε' => "epsilon",
        'θ' => "theta",
        'π' => "pi",
        'σ' => "sigma",
        'і' => "i",
        'ї' => "yi",
        'є' => "ye",
        'ґ' => "g",
        'І' => "I",
        'Ї' => "Yi",
        'Є' => "Ye",
        'Ґ' => "G",
        c if c.is_whitespace() => " ",
        _ => return None,
    })
}

/// Latin for the Cyrillic letters from а to я, in their order.
const CYRILLIC: [&str; 32] = [
    "a", "b", "v", "g", "d", "e", "zh", "z", "i", "y", "k", "l", "m", "n", "o", "p", "r", "s", "t", "u", "f",
    "kh", "ts", "ch", "sh", "shch", "", "y", "", "e", "yu", "ya",
];

/// The text with each character beyond ASCII replaced: signs by their usual spelling, Cyrillic by Latin letters, others by
/// a question mark.
pub fn to_ascii(text: &str) -> Cow<'_, str> {
    if text.is_ascii() {
        return Cow::Borrowed(text);
    }
    let mut folded = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_ascii() {
            folded.push(c);
        } else if let Some(twin) = twin(c) {
            folded.push_str(twin);
        } else if let Some(latin) = cyrillic(c) {
            folded.push_str(&latin);
        } else {
            folded.push('?');
        }
    }
    Cow::Owned(folded)
}

/// The text with Cyrillic letters replaced by Latin ones.
pub fn latin(text: &str) -> Cow<'_, str> {
    if text.is_ascii() {
        return Cow::Borrowed(text);
    }
    let is_cyrillic = |c: char| ('\u{400}'..='\u{4ff}').contains(&c);
    let letter = |c: char| if is_cyrillic(c) { to_ascii(&c.to_string()).into_owned() } else { c.to_string() };
    Cow::Owned(text.chars().map(letter).collect())
}

fn cyrillic(c: char) -> Option<String> {
    let small = match c {
        'ё' | 'Ё' => 'е',
        'А'..='Я' => char::from_u32(u32::from(c) + 32)?,
        _ => c,
    };
    let index = u32::from(small).checked_sub(u32::from('а'))?;
    let latin = *CYRILLIC.get(usize::try_from(index).ok()?)?;
    if small == c || c == 'ё' {
        return Some(latin.to_owned());
    }
    let mut letters = latin.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    Some(first.into_iter().chain(letters).collect())
}
