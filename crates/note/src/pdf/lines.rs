//! Texts in lines.

/// A text in lines of at most this width, mm, divided between its words, a word that is wider between its letters; no line of an empty
/// text. Subscripts, `_{...}`, stay whole.
pub(super) fn wrapped(words: &str, width: f64, size: f64) -> Vec<String> {
    let fits = |line: &str| assur_pdf::text_width(line, size) <= width;
    let mut lines: Vec<String> = Vec::new();
    for word in apart(words) {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match longer.filter(|line| fits(line)) {
            Some(longer) => *lines.last_mut().expect("a line is longer") = longer,
            None => lines.push(word),
        }
        while let Some(rest) = lines.last_mut().filter(|line| !fits(line)).and_then(|line| cut(line, fits)) {
            lines.push(rest);
        }
    }
    lines
}

/// Leaves of a line what fits, and gives the rest; `None` where nothing of it can be cut off.
fn cut(line: &mut String, fits: impl Fn(&str) -> bool) -> Option<String> {
    let ends: Vec<usize> = line.char_indices().map(|(at, _)| at).skip(1).collect();
    let outside = |at: &&usize| {
        let before = &line[..**at];
        before.matches("_{").count() == before.matches('}').count() && !before.ends_with('_')
    };
    let fitting = || ends.iter().filter(outside).take_while(|at| fits(&line[..**at]));
    // Behind a stroke rather than within a word.
    let stroke = |at: &&usize| line[..**at].ends_with(['/', '–']);
    let at = *fitting().filter(stroke).last().or_else(|| fitting().last())?;
    let rest = line[at..].to_owned();
    line.truncate(at);
    Some(rest)
}

/// The words of a text; a space within a subscript divides none.
fn apart(words: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let mut inside = false;
    for piece in words.split(' ') {
        match all.last_mut().filter(|_| inside) {
            Some(last) => {
                last.push(' ');
                last.push_str(piece);
            }
            None => all.push(piece.to_owned()),
        }
        let opened = piece.rfind("_{").map_or(-1, |at| i64::try_from(at).unwrap_or(i64::MAX));
        let closed = piece.rfind('}').map_or(-1, |at| i64::try_from(at).unwrap_or(i64::MAX));
        inside = if opened == closed { inside } else { opened > closed };
    }
    all.retain(|word| !word.is_empty());
    all
}
