//! The pictures of every view of every shipped scene, and those of its note, have their hashes.

use std::path::{Path, PathBuf};

use assur_analysis::{Options, unwatched};
use assur_note::Form;
use assur_picture::{Picture, Results};
use assur_testkit::guard::{self, Hash};
use assur_words::Language;
use strum::VariantNames;

use crate::session::{Session, Source};
use crate::still::{self, PictureArgs};

/// Scenes with so many positions or links that their notes take seconds.
const WITHOUT_NOTE: &[&str] = &["n-four-bar-40", "disc-case-4", "disc-case-5"];

/// A position that is special in no scene.
const POSITION: usize = 5;

/// The pictures of all views and their parts, and all figures of the note.
fn pictures((scene, has_note): &(PathBuf, bool)) -> Vec<(String, String)> {
    let session = Session::open(Source::File(scene.clone())).unwrap();
    let own = session.note.clone();
    let results = session.analyzed(&Options::default(), true, &mut unwatched).unwrap();
    let written = has_note.then(|| assur_note::write(&results, &own, Form::Markdown, "").ok()).flatten();
    let mut found: Vec<_> = Picture::VARIANTS.iter().flat_map(|view| of_view(&results, view)).collect();
    found.extend(written.map(|written| {
        let figures = written.figures.iter().map(|(name, figure)| [name.as_str(), figure]);
        let all = figures.flatten().chain([written.text.as_str()]);
        ("note".to_owned(), Hash::of(all.collect::<String>().as_bytes()))
    }));
    found
}

/// The picture of each part of a view, of those that there are.
fn of_view(results: &Results, view: &str) -> Vec<(String, String)> {
    let picture: Picture = view.parse().unwrap();
    let parts = picture.parts();
    let parts: Vec<Option<&str>> = parts.iter().map(|part| Some(part.into())).collect();
    let parts = if parts.is_empty() { vec![None] } else { parts };
    let picture = |part: Option<&str>| {
        let request = PictureArgs {
            view: Some(picture),
            part: part.map(str::to_owned),
            show: None,
            step: None,
            position: vec![POSITION.min(results.positions() - 1)],
            size: None,
            animate: false,
            arrows: None,
        };
        let drawn = still::draw(results, &request, Path::new("a.svg"), Language::english()).ok()?;
        Some((part.map_or(view.to_owned(), |part| format!("{view}-{part}")), Hash::of(&drawn)))
    };
    parts.into_iter().filter_map(picture).collect()
}

#[test]
fn guard_of_pictures() {
    let scenes = guard::scenes("fixtures").into_iter();
    let jobs: Vec<_> = scenes
        .map(|(name, path)| {
            let has_note = !WITHOUT_NOTE.contains(&name.as_str());
            (name, (path, has_note))
        })
        .collect();
    guard::compare("guard-pictures.txt", &guard::hashes(&jobs, pictures));
}
