//! Sheets of shipped scenes: nothing overlaps, nothing leaves the frame, texts are large enough, little paper stays empty.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

mod common;

use assur_figure::Form as Outline;
use assur_sheet::{Form, Page};
use common::{SCENES, results_and_pages, texts};

fn pages<const N: usize>(scene: &str, languages: [&str; N]) -> [Vec<Page>; N] {
    results_and_pages(scene, languages).1
}

#[test]
fn fields_have_paper_of_their_own_and_cover_most_of_it() {
    for scene in SCENES {
        let languages = ["en", "uk", "ru"];
        for (language, pages) in languages.into_iter().zip(pages(scene, languages)) {
            for (number, page) in pages.iter().enumerate() {
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
        for element in pages(scene, ["uk"]).iter().flatten().flat_map(Page::elements) {
            match element.form {
                Outline::Text { size, .. } => assert!(size >= 3.5, "{scene}: {element:?}"),
                _ => assert!([0.2, 0.4, 0.8].contains(&element.width), "{scene}: {element:?}"),
            }
        }
    }
}

#[test]
fn no_text_is_cut_off() {
    for scene in SCENES {
        for part in pages(scene, ["en", "uk", "ru"]).iter().flatten().flat_map(|page| &page.parts) {
            let cut: Vec<_> = texts(part).into_iter().filter(|text| text.ends_with('…')).collect();
            assert!(cut.is_empty(), "{scene} {:?}: {cut:?}", part.field);
        }
    }
}
