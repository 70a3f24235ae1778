//! Names of links, points, pairs and loads, and those that look alike.

use std::borrow::{Borrow, Cow};
use std::{fmt, ops::Deref};

use assur_words::{Text, labelled, name, text};
use serde::Serialize;

use crate::{LinkId, Mechanism, PairId, PointId, SlideId};

/// A name of the scene, or one that the program gives, which has its own words in each language (`force 1 on rod`).
///
/// As a string it is English: what results are found by, and files have. As a text it is what a person reads: of a part with labels
/// that of the language.
#[derive(Clone, Default, Eq, Serialize)]
#[serde(transparent)]
pub struct Name {
    english: String,
    #[serde(skip)]
    text: Text,
}

impl Name {
    /// The name of the fixed link.
    pub fn ground() -> Self {
        text!("mechanism-ground").into()
    }

    /// The same name with what a reader calls it, by the code of a language.
    #[must_use]
    pub fn with_labels(self, labels: impl IntoIterator<Item = (&'static str, String)>) -> Self {
        Self { text: labelled(self.text, labels), english: self.english }
    }

    /// The name in English.
    pub fn as_str(&self) -> &str {
        &self.english
    }
}

impl Deref for Name {
    type Target = str;

    fn deref(&self) -> &str {
        &self.english
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.english, f)
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.english)
    }
}

impl PartialEq for Name {
    /// What is found by the same letters is the same.
    fn eq(&self, other: &Self) -> bool {
        self.english == other.english
    }
}

impl std::hash::Hash for Name {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.english.hash(state);
    }
}

impl PartialEq<str> for Name {
    fn eq(&self, other: &str) -> bool {
        self.english == other
    }
}

impl PartialEq<&str> for Name {
    fn eq(&self, other: &&str) -> bool {
        self.english == *other
    }
}

impl From<Text> for Name {
    fn from(text: Text) -> Self {
        Self { english: text.to_string(), text }
    }
}

impl From<&str> for Name {
    fn from(given: &str) -> Self {
        name(given.to_owned()).into()
    }
}

impl From<String> for Name {
    fn from(given: String) -> Self {
        name(given).into()
    }
}

impl From<&Name> for Text {
    fn from(name: &Name) -> Self {
        name.text.clone()
    }
}

impl From<Name> for Text {
    fn from(name: Name) -> Self {
        name.text
    }
}

impl From<Name> for Cow<'static, str> {
    fn from(name: Name) -> Self {
        Self::Owned(name.english)
    }
}

impl From<Name> for String {
    fn from(name: Name) -> Self {
        name.english
    }
}

/// A link, point, slide or pair: who looks for it has its id, and who writes it has its name. As a key it is its name, which no
/// other part of its kind has.
#[derive(Debug, Clone, Eq, Serialize)]
#[serde(transparent)]
pub struct Named<I> {
    /// Which one it is.
    #[serde(skip)]
    pub id: I,
    /// Its name.
    pub name: Name,
}

impl<I> Deref for Named<I> {
    type Target = Name;

    fn deref(&self) -> &Name {
        &self.name
    }
}

impl<I> fmt::Display for Named<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.name, f)
    }
}

impl<I> PartialEq for Named<I> {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl<I> PartialEq<&str> for Named<I> {
    fn eq(&self, other: &&str) -> bool {
        self.name == **other
    }
}

impl<I> std::hash::Hash for Named<I> {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl<I> Borrow<str> for Named<I> {
    fn borrow(&self) -> &str {
        &self.name
    }
}

impl<I> From<&Named<I>> for Text {
    fn from(named: &Named<I>) -> Self {
        Self::from(&named.name)
    }
}

impl Mechanism {
    /// A link with its name.
    pub fn named_link(&self, id: LinkId) -> Named<LinkId> {
        Named { id, name: self.links[id].name.clone() }
    }

    /// A point with its name.
    pub fn named_point(&self, id: PointId) -> Named<PointId> {
        Named { id, name: self.points[id].name.clone() }
    }

    /// A slide with its name.
    pub fn named_slide(&self, id: SlideId) -> Named<SlideId> {
        Named { id, name: self.slides[id].name.clone() }
    }

    /// A pin or slide with its name.
    pub fn named_pair(&self, id: PairId) -> Named<PairId> {
        Named { id, name: self.pair_name(id).clone() }
    }

    /// The name of a pin or slide.
    pub fn pair_name(&self, id: PairId) -> &Name {
        match id {
            PairId::Pin(point) => &self.points[point].name,
            PairId::Slide(slide) => &self.slides[slide].name,
        }
    }
}

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
