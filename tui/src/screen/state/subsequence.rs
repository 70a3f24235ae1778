//! How well a typed word suits a text in which its letters stand in order, not necessarily side by side.

/// For a letter that begins the text.
const FIRST: u32 = 3;

/// For a letter that begins another word of the text.
const START: u32 = 2;

/// For a letter that follows the one before it directly.
const ADJACENT: u32 = 3;

/// The best score of several words in a text, whatever their case; `None` where the letters of one are not in it. Each word is
/// looked for on its own.
pub(super) fn score(words: &[&str], text: &str) -> Option<u32> {
    let letters = |text: &str| text.chars().flat_map(char::to_lowercase).collect::<Vec<char>>();
    let text = letters(text);
    words.iter().map(|word| of_word(&letters(word), &text)).sum()
}

fn of_word(word: &[char], text: &[char]) -> Option<u32> {
    if word.len() > text.len() {
        return None;
    }
    let worth = |at: usize| match at.checked_sub(1).map(|before| text[before].is_alphanumeric()) {
        None => FIRST,
        Some(false) => START,
        Some(true) => 0,
    };
    // The best score with the letters so far, the last of them at each place of the text.
    let mut best: Vec<Option<u32>> = vec![None; text.len()];
    let mut earlier = Some(0);
    for letter in word {
        let mut before = None;
        for at in 0..text.len() {
            let reached = earlier.max(before.map(|score: u32| score + ADJACENT));
            earlier = earlier.max(best[at]);
            before = best[at];
            best[at] = reached.filter(|_| text[at] == *letter).map(|score| score + worth(at));
        }
        earlier = None;
    }
    best.into_iter().flatten().max()
}

#[cfg(test)]
mod tests;
