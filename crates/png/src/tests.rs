use assur_figure::{Axis, Figure, Frame, Ink, Item, Panel, Stroke, svg};
use assur_words::{Language, name, unit};

use super::PngError;

fn write(figure: &Figure, size: [f64; 2], language: &Language) -> Result<Vec<u8>, PngError> {
    super::write(&svg::write(figure, size, language), size)
}

fn chart(title: &str, values: &[f64], floor: f64) -> Figure {
    let points: Vec<_> = values.iter().enumerate().map(|(at, value)| [at as f64, *value]).collect();
    let frame = Frame::Axes {
        x: Axis::around(name("time, s"), points.iter().map(|at| at[0]), 0.0),
        y: Axis::around(unit("N"), values.iter().copied(), floor),
        cursor: Some(0.0.into()),
    };
    let items = vec![Item::line(points, Stroke::Solid, Ink::First)];
    Figure::of(Panel { title: name(title.to_owned()), frame, items })
}

#[test]
fn a_picture_has_ten_pixels_a_millimeter_and_is_not_empty() {
    let figure = chart("силы, μ", &[1.0, 2.0], 0.0);
    let bytes = write(&figure, [50.0, 40.0], Language::english()).unwrap();
    let side = |at: usize| u32::from_be_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
    assert_eq!([side(16), side(20)], [500, 400]);
    let blank = write(&chart("", &[f64::NAN], 0.0), [50.0, 40.0], Language::english()).unwrap();
    assert!(bytes.len() > blank.len() + 500, "{} and {}", bytes.len(), blank.len());
    // 64 million pixels are 800 mm square; as wide as an svg may be, a picture is flat.
    let error = write(&figure, [800.1, 800.1], Language::english()).unwrap_err().to_string();
    assert!(
        error.ends_with("a png has at most 64 million, such as 800 x 800 mm; an svg may be larger"),
        "{error}"
    );
    assert!(
        write(&figure, [0.0, 40.0], Language::english()).is_err()
            && write(&figure, [f64::NAN, 40.0], Language::english()).is_err()
    );
}
