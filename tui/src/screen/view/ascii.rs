//! The last pass: no character beyond ASCII is written.

#[cfg(test)]
mod tests;

use ratatui::buffer::Buffer;

/// Replaces every character beyond ASCII by the nearest ASCII character.
pub(crate) fn replace(buffer: &mut Buffer) {
    for cell in &mut buffer.content {
        if cell.symbol().is_ascii() {
            continue;
        }
        let first = cell.symbol().chars().next().unwrap_or(' ');
        cell.set_char(nearest(first));
    }
}

pub(crate) fn nearest(c: char) -> char {
    match c {
        c if c.is_ascii() => c,
        '─' | '━' | '–' | '—' | '╌' | '−' => '-',
        '│' | '┃' | '╎' => '|',
        '┌' | '┐' | '└' | '┘' | '├' | '┤' | '┬' | '┴' | '┼' | '╭' | '╮' | '╰' | '╯' => {
            '+'
        }
        '█' | '▀' | '▄' | '▌' | '▐' => '#',
        '░' | '▒' | '▓' => ':',
        '→' | '▶' => '>',
        '←' | '◀' => '<',
        '↑' | '▲' => '^',
        '↓' | '▼' => 'v',
        '╱' => '/',
        '╲' => '\\',
        '°' => 'o',
        '²' => '2',
        '³' => '3',
        '×' => 'x',
        '·' | '•' | '∙' | '…' => '.',
        '’' | '‘' => '\'',
        '“' | '”' => '"',
        '\u{2801}'..='\u{28ff}' => '*',
        '\u{2800}' => ' ',
        other => cyrillic(other),
    }
}

/// Cyrillic letters that look like Latin ones, as in the designations of motors; anything else is a question mark.
fn cyrillic(c: char) -> char {
    const TWINS: &str = "АAВBЕEКKМMНHОOРPСCТTУYХXаaеeоoрpсcуyхxіiІI";
    let mut twins = TWINS.chars();
    while let (Some(from), Some(to)) = (twins.next(), twins.next()) {
        if from == c {
            return to;
        }
    }
    '?'
}
