//! The last pass: no character beyond ASCII is written.

#[cfg(test)]
mod tests;

use assur_words::to_ascii;
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

/// The nearest character in one cell: of what the screen draws, else the first letter of its spelling in ASCII.
fn nearest(c: char) -> char {
    match c {
        '─' => '-',
        '┌' | '┐' | '└' | '┘' => '+',
        '█' | '▀' | '▄' => '#',
        '→' => '>',
        '←' => '<',
        '↑' => '^',
        '↓' => 'v',
        '╱' => '/',
        '°' => 'o',
        '²' => '2',
        '³' => '3',
        '×' => 'x',
        '·' | '•' => '.',
        '\u{2800}' => ' ',
        '\u{2801}'..='\u{28ff}' => '*',
        other => to_ascii(&other.to_string()).chars().next().unwrap_or(' '),
    }
}
