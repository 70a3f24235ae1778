use assur_figure::{Anchor, Element, Ink};

use super::{Page, text_width, write};

fn pages() -> Vec<u8> {
    let elements = [
        Element::text([10.0, 20.0], "Сила μ_{F}, ω²", 5.0, Anchor::Start, Ink::Text),
        Element::line([[10.0, 30.0], [60.0, 30.0]], 0.4, Ink::First),
    ];
    let page = Page { size: [210.0, 297.0], elements: &elements };
    write("Аркуш", &[page, page]).unwrap()
}

#[test]
fn a_file_has_its_pages_and_the_letters_used_and_is_the_same_each_time() {
    let bytes = pages();
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.starts_with("%PDF-") && text.trim_end().ends_with("%%EOF"));
    assert!(text.contains("/Count 2"));
    // A4 in points: 210 / 25.4 * 72 and 297 / 25.4 * 72.
    assert!(text.contains("595.27") && text.contains("841.88"), "{text}");
    // The whole font alone has 38 kB.
    assert!(bytes.len() < 12_000, "{}", bytes.len());
    assert_eq!(bytes, pages());
}

#[test]
fn widths_are_those_of_the_font() {
    // DejaVu Sans: a digit is 1303 of 2048 units wide, a subscript 0.7 as large.
    let digit = 1303.0 / 2048.0;
    assert!((text_width("12", 10.0) - 20.0 * digit).abs() < 0.01);
    assert!((text_width("1_{2}", 10.0) - 17.0 * digit).abs() < 0.01);
}
