//! What a reader calls the parts of a scene, and other texts for readers: in one language, or a table of languages.

use assur_mechanism::{Name, PointId};
use assur_words::{LANGUAGES, Text, labelled, name, text};

use crate::linkage::SceneLinks;
use crate::text::is_unprintable;
use crate::walk::{Entry, Section};

/// A text by the codes of languages.
pub(crate) type Labels = Vec<(&'static str, String)>;

/// Reads a text of one line; one without languages is that of all of them. `read`: one text.
fn by_language<'a>(entry: &Entry<'a>, read: impl Fn(&Entry<'a>) -> Option<String>) -> Option<Labels> {
    if entry.value.is_str() {
        let text = read(entry)?;
        return Some(LANGUAGES.map(|code| (code, text.clone())).into());
    }
    if !entry.value.is_table() {
        entry.wrong(text!("scene-a-text-by-language"), text!("scene-in-quotes"));
        return None;
    }
    let section = entry.section(crate::reference::table("label = { ... }"))?;
    let given = LANGUAGES.iter().filter_map(|code| Some((*code, section.get(code)?)));
    let texts: Labels = given.filter_map(|(code, entry)| Some((code, read(&entry)?))).collect();
    if section.entries().is_empty() {
        entry.wants(text!("scene-a-text-by-language"), text!("scene-an-empty-table"), Text::default());
    }
    (!texts.is_empty()).then_some(texts)
}

/// A name for readers: one line, not empty, no longer than other names.
fn label(entry: &Entry<'_>) -> Option<Labels> {
    by_language(entry, |entry| {
        let label = entry.text(text!("scene-a-text"))?;
        entry.faults.check_name(&entry.span, label);
        Some(label.to_owned())
    })
}

impl Section<'_> {
    /// A name with the labels that the section gives it.
    pub(crate) fn labelled(&self, name: Name) -> Name {
        match self.get("label").and_then(|entry| label(&entry)) {
            Some(labels) => name.with_labels(labels),
            None => name,
        }
    }

    /// The title of the scene; files have the English one, or else the first.
    pub(crate) fn title(&self) -> Name {
        let title = |entry: &Entry<'_>| {
            let title = entry.line()?;
            entry.faults.check_name(&entry.span, &title);
            Some(title)
        };
        let labels = self.get("title").and_then(|entry| by_language(&entry, title)).unwrap_or_default();
        Name::from(first(&labels)).with_labels(labels)
    }

    /// A text for readers of one line, which may be empty; in a language that is left out the English one, or else the first.
    pub(crate) fn words(&self, key: &str) -> Option<Text> {
        whole(by_language(&self.get(key)?, Entry::line)?)
    }

    /// A text for readers of several paragraphs.
    pub(crate) fn paragraphs(&self, key: &str) -> Option<Text> {
        let paragraphs = |entry: &Entry<'_>| {
            let kept = |c: char| if is_unprintable(c) && c != '\n' { ' ' } else { c };
            Some(entry.value.as_str()?.chars().map(kept).collect())
        };
        whole(by_language(&self.get(key)?, paragraphs)?)
    }
}

fn whole(labels: Labels) -> Option<Text> {
    Some(labelled(name(first(&labels)), labels)).filter(|text| !text.is_empty())
}

/// English is the first of the languages.
fn first(labels: &Labels) -> String {
    labels.first().map(|(_, text)| text.clone()).unwrap_or_default()
}

/// Reads `[labels]`: what readers call the points.
pub(crate) fn of_points(root: &Section<'_>, linkage: &mut SceneLinks) {
    let Some(entry) = root.get("labels") else { return };
    for given in entry.named(text!("scene-table-of-labels"), text!("scene-write-labels")) {
        let at_key = Entry { name: "labels".to_owned(), span: given.key.clone(), ..given.clone() };
        let point: Option<PointId> = linkage.point_of(&at_key, &given.name);
        if let (Some(point), Some(labels)) = (point, label(&given)) {
            let name = &mut linkage.points[point].name;
            *name = name.clone().with_labels(labels);
        }
    }
}
