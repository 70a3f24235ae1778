//! Sheets of shipped scenes: nothing overlaps, nothing leaves the frame, texts are large enough, little paper stays empty.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::sync::Arc;

use assur_all as _;
use assur_analysis::{Calculation, Options, plan, unwatched};
use assur_figure::Form as Outline;
use assur_kinematics::{Linkage, decompose};
use assur_picture::{Found, Results};
use assur_sheet::{Form, Page, sheet};
use assur_words::Language;

const SCENES: [&str; 5] = ["shaper-drive", "press", "shaper-friction", "triad", "brake"];

fn pages(scene: &str, language: &str) -> Vec<Page> {
    let text = assur_fixtures::scene(scene);
    let (mechanism, note) = assur_scene::read_with_note(scene, text).unwrap();
    let structure = decompose(&mechanism).unwrap();
    let all = vec![true; structure.groups.len()];
    let options = Options::default();
    let plan = plan(&mechanism, &structure, &options);
    let linkage = Arc::new(Linkage::compile_for(mechanism, structure, &all).unwrap());
    let calculation =
        Calculation::planned(Arc::clone(&linkage), plan, None, &options, &mut unwatched).unwrap();
    let found = Found::of(calculation, Arc::clone(&linkage), &options, &mut unwatched).unwrap();
    let mut results = Results::of(linkage).unwrap();
    results.take(Box::new(found));
    sheet(&results, &note, Language::find(language).unwrap()).unwrap()
}

#[test]
fn fields_have_paper_of_their_own_and_cover_most_of_it() {
    for scene in SCENES {
        for language in ["en", "uk", "ru"] {
            for (number, page) in pages(scene, language).iter().enumerate() {
                let place = format!("{scene} {language} {number} {:?}", page.format);
                if let Ok(folder) = std::env::var("SHEETS") {
                    let pdf = Form::Pdf.write(scene, std::slice::from_ref(page)).unwrap().remove(0);
                    std::fs::write(format!("{folder}/{scene}-{language}-{number}.pdf"), pdf).unwrap();
                    println!("{place} {:.3}", page.covered());
                }
                assert!(page.covered() >= 0.6, "{place}: {}", page.covered());
                let [frame, title] = page.frame;
                let fields: Vec<_> = page.parts.iter().filter(|part| part.field.is_some()).collect();
                let areas: Vec<_> =
                    fields.iter().filter_map(|part| Some((part.field, part.area()?))).collect();
                for (index, (field, area)) in areas.iter().enumerate() {
                    let others = areas[..index].iter().map(|(_, area)| area).chain([&title]);
                    for other in others {
                        let meets =
                            (0..2).all(|axis| area[axis] < other[axis + 2] && other[axis] < area[axis + 2]);
                        assert!(!meets, "{place} {field:?}: {area:?} meets {other:?}");
                    }
                    let inside =
                        (0..2).all(|axis| area[axis] >= frame[axis] && area[axis + 2] <= frame[axis + 2]);
                    assert!(inside, "{place} {field:?}: {area:?} leaves {frame:?}");
                }
            }
        }
    }
}

#[test]
fn texts_are_large_enough_and_lines_have_three_widths() {
    for scene in SCENES {
        for element in pages(scene, "uk").iter().flat_map(Page::elements) {
            match element.form {
                Outline::Text { size, .. } => assert!(size >= 3.5, "{scene}: {element:?}"),
                _ => assert!([0.2, 0.4, 0.8].contains(&element.width), "{scene}: {element:?}"),
            }
        }
    }
}
