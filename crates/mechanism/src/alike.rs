//! Names that look alike.

/// Letters of the Cyrillic and Greek alphabets that look like Latin ones, each beside its likeness.
const LIKENESSES: &str = "АAВBЕEКKМMНHОOРPСCТTУYХXІIЈJЅSаaеeоoрpсcуyхxіiјjѕs\
                          ΑAΒBΕEΖZΗHΙIΚKΜMΝNΟOΡPΤTΥYΧXοoνv";

/// A name with Latin letters for those of other alphabets that look like them: names with the same appearance look the same on
/// a screen.
pub fn appearance(name: &str) -> String {
    let latin = |letter: char| {
        let mut pairs = LIKENESSES.chars();
        while let (Some(foreign), Some(latin)) = (pairs.next(), pairs.next()) {
            if foreign == letter {
                return latin;
            }
        }
        letter
    };
    if name.is_ascii() { name.to_owned() } else { name.chars().map(latin).collect() }
}

/// What names have in common that are easily taken for one: without the difference of capital letters, alphabets, and signs
/// between letters and digits.
pub fn likeness(name: &str) -> String {
    let letters = appearance(name).to_lowercase();
    letters.chars().filter(|letter| letter.is_alphanumeric()).collect()
}

#[cfg(test)]
mod tests;
