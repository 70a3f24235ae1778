//! What cells and SVG show of one figure.

use assur_figure::cells::{self, Look, Marker, Spot};
use assur_figure::{Axis, Bounds, Figure, Frame, Ink, Item, Panel, Sign, Stroke, Zoom, svg};
use assur_words::{Language, Text, name, unit};

fn look(marker: Marker) -> Look {
    Look { marker, ratio: 2.0, zoom: Zoom::WHOLE, language: Language::english() }
}

fn plane(items: Vec<Item>) -> Figure {
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    let frame = Frame::Plane { bounds, unit: "m/s".into(), factor: 1.0, scale: ("v", "m/s".into()) };
    Figure::of(Panel { title: Text::default(), frame, items })
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

fn place(spots: &[Spot], text: &str) -> Option<u16> {
    spots.iter().find(|spot| spot.text == text).map(|spot| spot.column)
}

fn row(spots: &[Spot], row: u16) -> String {
    let mut cells = [' '; 60];
    for spot in spots.iter().filter(|spot| spot.row == row) {
        for (ahead, letter) in spot.text.chars().enumerate() {
            cells[usize::from(spot.column) + ahead] = letter;
        }
    }
    cells.iter().collect::<String>().trim_end().to_owned()
}

#[test]
fn an_arrow_has_its_head_at_the_tip_and_its_name_beside_it() {
    let arrow = Item::Arrow { from: [0.0; 2], to: [1.0, 0.0], stroke: Stroke::Solid, ink: Ink::Velocity };
    let pole = [Item::sign([0.0; 2], Sign::Ring, Ink::Title), Item::name([0.0; 2], name("p"), Ink::Title)];
    let tip = Item::name([1.0, 0.0], name("a"), Ink::Title);
    let figure = plane([arrow, tip].into_iter().chain(pole).collect());
    let spots = cells::draw(&figure, [40, 9], look(Marker::Braille));
    let [Some(name), Some(pole), Some(tip)] = ["a", "p", ">"].map(|text| place(&spots, text)) else {
        panic!("a sign is missing: {spots:?}")
    };
    assert!(name.abs_diff(tip) <= 2 && pole + 20 < tip, "{name} {pole} {tip}");
}

#[test]
fn a_chart_keeps_to_its_place_and_rounding_is_zero() {
    let figure = chart("piston/ground on piston F  133.269 N and more", &[1.27e-14, 367.0, 100.0], 0.0);
    let spots = cells::draw(&figure, [40, 6], look(Marker::Braille));
    assert!(row(&spots, 0).ends_with("133.269 N a…"), "{}", row(&spots, 0));
    // Where the curve has rows enough, the title takes two.
    let spots = cells::draw(&figure, [40, 8], look(Marker::Braille));
    assert!(row(&spots, 0).ends_with("on piston F"), "{}", row(&spots, 0));
    assert!(row(&spots, 1).ends_with("133.269 N and more"), "{}", row(&spots, 1));
    assert!(row(&spots, 5).starts_with("         0│"), "{}", row(&spots, 5));
    assert!(spots.iter().all(|spot| spot.column + 1 < 41 && spot.row < 8));
}

#[test]
fn a_column_of_a_chart_leads_back_to_its_value() {
    let figure = chart("", &[0.0, 1.0, 4.0, 9.0, 16.0], 0.0);
    let value = |column| cells::value_at(&figure, [52, 10], [column, 4]);
    assert_eq!(value(11), Some(0.0));
    assert_eq!(value(50), Some(4.0));
    assert_eq!([value(3), value(51)], [None, None]);
}

#[test]
fn a_name_is_not_beyond_the_neighbors_of_its_line() {
    // Too close for a name between them; beyond its neighbors it would seem to be theirs.
    let line = |y: f64| Item::line(vec![[0.0, y], [5.0, y], [10.0, y]], Stroke::Solid, Ink::First);
    let items = [0.25, 0.0, -0.25].map(line).into_iter();
    let figure = plane(items.chain([Item::name([5.0, 0.0], name("2"), Ink::Title)]).collect());
    let text = svg::write(&figure, [160.0, 120.0], Language::english());
    let baseline = text.lines().find(|line| line.contains(">2<")).unwrap();
    let of = |text: &str, name: &str| attributes(text, "text", name)[0].parse::<f64>().unwrap();
    // The middle of the page without the line of the scale, and its neighbors at 2.5 mm.
    assert!((of(baseline, "y") - 0.4 * svg::EM - 57.75).abs() < 2.5, "{baseline}");
}

#[test]
fn a_value_without_neighbors_is_a_dot() {
    let alone = [[0.0, 1.0], [f64::NAN; 2], [1.0, 2.0], [f64::NAN; 2], [2.0, 0.0], [3.0, 1.0]];
    let figure = plane(vec![Item::line(alone, Stroke::Solid, Ink::First)]);
    let text = svg::write(&figure, [160.0, 120.0], Language::english());
    assert_eq!([text.matches("<circle").count(), text.matches("<polyline").count()], [2, 1]);
}

/// The numbers of an attribute of the elements of a name.
fn attributes(text: &str, element: &str, attribute: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| line.starts_with(&format!("<{element} ")));
    let value = |line: &str| {
        let start = line.find(&format!(" {attribute}=\""))? + attribute.len() + 3;
        Some(line[start..].split('"').next()?.to_owned())
    };
    lines.filter_map(value).collect()
}

#[test]
fn a_length_on_paper_times_the_scale_is_the_true_length() {
    for length in [0.0137, 0.4, 3.0, 77.7, 1.2e4] {
        let ends = [[0.0, 0.0], [0.6 * length, 0.8 * length]];
        let text = svg::write(
            &plane(vec![Item::line(ends, Stroke::Solid, Ink::First)]),
            [160.0, 120.0],
            Language::english(),
        );
        let points = &attributes(&text, "polyline", "points")[0];
        let numbers: Vec<f64> = points.split([' ', ',']).map(|number| number.parse().unwrap()).collect();
        let drawn = (numbers[2] - numbers[0]).hypot(numbers[3] - numbers[1]);
        let told = text.split("</tspan> = ").nth(1).or(text.split(" = ").nth(1)).unwrap();
        let scale: f64 = told.split(' ').next().unwrap().trim_end_matches("</tspan>").parse().unwrap();
        // Places are written to a hundredth of a millimeter.
        assert!((drawn * scale - length).abs() < 0.02 * scale, "{length}: {drawn} mm at {scale}");
        assert!(drawn > 40.0, "{length} is drawn {drawn} mm long");
    }
}

#[test]
fn the_same_figure_has_the_same_bytes_and_its_texts_are_no_markup() {
    let figure = Figure { title: name("a < b & \"c\""), ..chart("1 > 0", &[1.0, 2.0], 0.0) };
    let text = svg::write(&figure, [100.0, 80.0], Language::english());
    assert_eq!(text, svg::write(&figure, [100.0, 80.0], Language::english()));
    assert!(text.contains("a &lt; b &amp; &quot;c&quot;") && text.contains("1 &gt; 0"), "{text}");
}

#[test]
fn an_animation_moves_what_changes_and_writes_the_rest_once() {
    let frame = |x: f64| {
        let items = vec![
            Item::line([[0.0, 0.0], [x, 1.0]], Stroke::Solid, Ink::First),
            Item::line([[0.0, 0.0], [2.0, 0.0]], Stroke::Solid, Ink::Ground),
        ];
        let frame = Frame::Plane {
            bounds: Bounds { low: [0.0; 2], high: [2.0, 1.0] },
            unit: "m".into(),
            factor: 1.0,
            scale: ("l", "m".into()),
        };
        Figure::of(Panel { title: Text::default(), frame, items })
    };
    let text = svg::animate(&[frame(0.0), frame(1.0), frame(2.0)], [100.0, 80.0], 3.0, Language::english());
    assert_eq!(text.matches("<animate ").count(), 1, "{text}");
    assert_eq!(text.matches("<polyline").count(), 2, "{text}");
    // Three frames, and the first one again.
    let values = text.split("values=\"").nth(1).unwrap().split('"').next().unwrap();
    assert_eq!(values.split(';').count(), 4);
    assert_eq!(values.split(';').next(), values.split(';').next_back());
}

#[test]
fn any_size_and_any_number_is_drawn_without_a_fault() {
    let odd = [f64::NAN, f64::INFINITY, -1e300, 1e-300, 0.0, 1.0];
    for value in odd {
        let figures = [
            chart("title", &[value, 1.0, value], 0.0),
            plane(vec![
                Item::Arrow { from: [0.0; 2], to: [value, 1.0], stroke: Stroke::Dashed, ink: Ink::First },
                Item::Spring { from: [value, 0.0], to: [1.0, value], elastic: true, damped: true },
                Item::Ground { ends: [[0.0; 2], [value, value]], guides: true },
                Item::sign([value, 0.0], Sign::Bearing, Ink::Ground),
                Item::name([value, 0.0], name("name"), Ink::Title),
            ]),
        ];
        for figure in figures {
            for size in [[0, 0], [1, 1], [12, 4], [13, 2], [80, 24], [300, 2]] {
                for marker in <Marker as strum::VariantArray>::VARIANTS.iter().copied() {
                    cells::draw(&figure, size, look(marker));
                }
            }
            let text = svg::write(&figure, [100.0, 80.0], Language::english());
            assert!(!text.contains("NaN") && !text.contains("inf"), "{value}: {text}");
        }
    }
}
