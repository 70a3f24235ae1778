//! The names in pictures: none lies on another one, or on a support.

use std::path::Path;

use assur_analysis::{Options, unwatched};
use assur_figure::svg;
use assur_picture::Picture;
use strum::VariantNames;

use crate::screen::state::{Scene, State, View};
use crate::screen::view;
use crate::session::{Session, Source};
use crate::still::PAGE;

/// Left, top, right, bottom, mm.
type Spot = [f64; 4];

/// The value of an attribute of an element.
fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    element.split_once(&format!(" {name}=\""))?.1.split('"').next()
}

/// The room that the letters of a name take at least: `DejaVu` Sans has none narrower.
fn room(text: &str) -> f64 {
    let of = |letter: char| if "ijltfrI .,:;'|()/".contains(letter) { 0.27 } else { 0.55 };
    svg::EM * text.chars().map(of).sum::<f64>()
}

/// The names of a picture with their rooms, and the rooms of its supports.
fn rooms(picture: &str) -> (Vec<(String, Spot)>, Vec<Spot>) {
    let number =
        |element: &str, name: &str| attribute(element, name).and_then(|value| value.parse::<f64>().ok());
    let names = picture.lines().filter(|line| attribute(line, "visibility") == Some("visible"));
    let names = names.filter_map(|line| {
        let (x, y) = (number(line, "x")?, number(line, "y")?);
        let text = line.split_once('>')?.1.split_once("</text>")?.0.to_owned();
        // Of a subscript only the letters count.
        let letters = text
            .split('<')
            .map(|part| part.split_once('>').map_or(part, |(_, rest)| rest))
            .collect::<String>();
        let spot = [x, y - 0.7 * svg::EM, x + room(&letters), y];
        Some((letters, spot))
    });
    let triangles =
        picture.lines().filter(|line| line.starts_with("<polygon") && line.contains("fill=\"#ffffff\""));
    let supports = triangles.filter_map(|line| {
        let points: Vec<(f64, f64)> = attribute(line, "points")?
            .split(' ')
            .filter_map(|point| point.split_once(','))
            .filter_map(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)))
            .collect();
        let [tip, left, right] = points[..] else { return None };
        Some([left.0.min(right.0), tip.1, left.0.max(right.0), left.1])
    });
    (names.collect(), supports.collect())
}

fn meet(one: &Spot, other: &Spot) -> bool {
    (0..2).all(|axis| one[axis] < other[axis + 2] && other[axis] < one[axis + 2])
}

/// The faults of the picture of a view.
fn faults(state: &State, view: View) -> Vec<String> {
    let Some(figure) = view::figure(state, view) else { return Vec::new() };
    let (names, supports) = rooms(&svg::write(&figure, PAGE, state.language()));
    let mut faults = Vec::new();
    for (index, (name, spot)) in names.iter().enumerate() {
        let others = names[..index].iter().filter(|(_, other)| meet(spot, other));
        faults.extend(others.map(|(other, _)| format!("`{name}` lies on `{other}`")));
        if supports.iter().any(|support| meet(spot, support)) {
            faults.push(format!("`{name}` lies on a support"));
        }
    }
    faults
}

#[test]
fn no_name_lies_on_another_one_or_on_a_support() {
    let folder = assur_fixtures::path("");
    let mut scenes: Vec<_> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        // Chains of as many links as a program can have are no drawings.
        .filter(|path| !path.to_string_lossy().contains("n-four-bar-40"))
        .collect();
    scenes.sort();
    let (mut count, mut found) = (0, Vec::new());
    for scene in scenes {
        let session = Session::open(Source::File(scene.clone())).unwrap();
        let results = session.analyzed(&Options::default(), false, &mut unwatched).unwrap();
        let mut state = super::empty(Some(Scene { results, ..Scene::of(session).unwrap() }));
        for view in Picture::VARIANTS.iter().map(|view| view.parse::<View>().unwrap()) {
            state.view = view;
            let parts = state.available_parts(view);
            let parts = if parts.is_empty() { vec![None] } else { parts.into_iter().map(Some).collect() };
            for part in parts {
                if let Some(part) = part {
                    state.parts.insert(view, part);
                    state.chosen.step = 10_000;
                }
                for position in [0, 5, state.positions() / 2] {
                    state.position = position.min(state.positions() - 1);
                    let file = Path::new(&scene).file_stem().unwrap().to_string_lossy().into_owned();
                    let at = format!("{file}, {view:?}, {part:?}, position {}", state.position);
                    found.extend(faults(&state, view).into_iter().map(|fault| format!("{at}: {fault}")));
                    count += 1;
                }
            }
        }
    }
    assert!(found.is_empty() && count > 500, "{count} pictures\n{}", found.join("\n"));
}
