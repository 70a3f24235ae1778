//! Comparison of motor designations, regardless of spelling.
//!
//! The series 4А and АИР are printed with Cyrillic letters; people type them with Latin ones, by look (`АИР` as `AИP`)
//! or by sound (`AIR`). So two forms of a designation are compared: by look and by sound.

/// Designation by look: upper case, without spaces, every Cyrillic letter that looks like a Latin one
/// replaced by it. `4а 100l4` and `4A100L4` become `4A100L4`.
pub fn normalize_designation(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_uppercase).map(look_alike).collect()
}

/// Designation in ASCII, by sound: `АИР71В4` becomes `AIR71B4`. Case and spacing stay. The Cyrillic letter В
/// becomes B, as Latin name plates have it; a character without a Latin form becomes `?`.
pub fn latin_designation(text: &str) -> String {
    let mut latin = String::with_capacity(text.len());
    for c in text.chars() {
        push_latin(&mut latin, c);
    }
    latin
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

/// The Latin letter that looks like this Cyrillic one; every other character as it is.
fn look_alike(c: char) -> char {
    let pair = "АВЕЁЅІЇЈКМНОРСТУХ".chars().zip("ABEESIIJKMHOPCTYX".chars()).find(|pair| pair.0 == c);
    pair.map_or(c, |pair| pair.1)
}

fn push_latin(latin: &mut String, c: char) {
    if c.is_ascii() {
        latin.push(c);
    } else if c.is_whitespace() {
        latin.push(' ');
    } else if c.is_lowercase() {
        latin.extend(
            c.to_uppercase().flat_map(|upper| by_sound(upper).chars()).map(|l| l.to_ascii_lowercase()),
        );
    } else {
        latin.push_str(by_sound(c));
    }
}

/// Latin letters of an upper-case Cyrillic one by its sound.
fn by_sound(upper: char) -> &'static str {
    const CYRILLIC: &str = "АБВГҐДЕЁЭЗИІЇЙЈКЛМНОПРСЅТУФХЦЫ";
    const LATIN: &str = "ABBGGDEEEZIIIJJKLMNOPRSSTUFHCY";
    if let Some(at) = CYRILLIC.chars().position(|c| c == upper) {
        return &LATIN[at..=at];
    }
    match upper {
        'Ж' => "ZH",
        'Ч' => "CH",
        'Ш' => "SH",
        'Щ' => "SCH",
        'Ъ' | 'Ь' => "",
        'Ю' => "YU",
        'Я' => "YA",
        'Є' => "YE",
        '·' => "*",
        '–' | '—' | '\u{2011}' => "-",
        _ => "?",
    }
}
