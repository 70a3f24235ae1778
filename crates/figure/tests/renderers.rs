//! What cells and SVG show of one figure.

use assur_figure::cells::{self, Look, Marker, Spot};
use assur_figure::{
    Axis, Bounds, Figure, Frame, Ink, Item, Key, Page, Panel, Sample, Scale, Sign, Stroke, Zoom, svg,
};
use assur_words::{Language, name, unit};

fn look(marker: Marker) -> Look {
    Look { marker, ratio: 2.0, zoom: Zoom::WHOLE, language: Language::english() }
}

fn plane(items: Vec<Item>) -> Figure {
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    Figure::of(Panel::plane(bounds, Scale::of("v", "m/s"), items))
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
    // The line, and the bar of the scale.
    assert_eq!([text.matches("<circle").count(), text.matches("<polyline").count()], [2, 2]);
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

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

/// Left, right of the last bar of a scale on a page, and what is written beside it.
fn bar(text: &str) -> ([f64; 2], String) {
    let lines: Vec<&str> = text.lines().collect();
    let (at, numbers) = lines
        .iter()
        .enumerate()
        .filter_map(|(at, line)| {
            let points = attributes(line, "polyline", "points").pop()?;
            let numbers: Vec<f64> = points.split([' ', ',']).map(number).collect();
            (numbers.len() == 8 && (numbers[0] - numbers[2]).abs() <= 0.0).then_some((at, numbers))
        })
        .next_back()
        .expect("a page with a scale");
    ([numbers[2], numbers[4]], lines[at + 1].to_owned())
}

#[test]
fn a_scale_has_a_bar_as_long_as_it_says_and_a_factor_that_fits_it() {
    for force in [3.0, 77.0, 1.2e4] {
        // 0.4 m on the page, and a force that is 0.25 m long in it at most.
        let mut figure = plane(vec![Item::line([[0.0; 2], [0.4, 0.1]], Stroke::Solid, Ink::First)]);
        let Frame::Plane { scales, .. } = &mut figure.panels[0].frame else { panic!() };
        let forces = Scale::vectors("F", "N", force / 0.25);
        // Round: a multiple of a power of ten by 1, 2, 2.5, 4 or 5, and not much above what is asked for.
        assert!(forces.size >= force / 0.25 && forces.size < 2.0 * force / 0.25, "{}", forces.size);
        *scales = vec![Scale::of("l", "m"), forces.clone()];
        let text = svg::write(&figure, [160.0, 120.0], Language::english());
        let ([left, right], told) = bar(&text);
        let told = told.split_once('>').unwrap().1;
        let length: f64 = told.split(' ').next().unwrap().parse().unwrap();
        let factor: f64 = told.split(" = ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
        assert!(told.contains("N/mm") && told.contains(" N "), "{told}");
        assert!((factor * (right - left) - length).abs() < 0.01 * length, "{told}: {left} to {right} mm");
        // The line is 0.4 m long along x.
        let line = attributes(&text, "polyline", "points").remove(0);
        let numbers: Vec<f64> = line.split([' ', ',']).map(|number| number.parse().unwrap()).collect();
        let meter = (numbers[2] - numbers[0]) / 0.4;
        assert!((forces.size / meter - factor).abs() < 1e-3 * factor, "{told}");
        // Cells have a bar for each scale, too, beside each other where there is room.
        let spots = cells::draw(&figure, [60, 20], look(Marker::Braille));
        let bars = row(&spots, 19);
        assert!(bars.matches("|-").count() == 2 && bars.contains(" mm ") && bars.ends_with('N'), "{bars}");
        let spots = cells::draw(&figure, [40, 20], look(Marker::Braille));
        assert!(row(&spots, 18).ends_with("mm") && row(&spots, 19).ends_with('N'));
    }
}

/// Width and height of a page, mm.
fn page(text: &str) -> [f64; 2] {
    ["width", "height"].map(|side| number(attributes(text, "svg", side)[0].trim_end_matches("mm")))
}

#[test]
fn a_page_that_may_shrink_fits_its_drawing_and_another_one_is_kept() {
    let is_whole = |text: &str| text.contains("width=\"160mm\" height=\"120mm\"");
    for [width, height] in [[1.0, 1.0], [1.1, 0.01], [0.3, 2.9], [77.0, 41.0]] {
        let figure = plane(vec![Item::line([[0.0; 2], [width, height]], Stroke::Solid, Ink::First)]);
        let within = svg::write(&figure, Page::Within([160.0, 120.0]), Language::english());
        let line = attributes(&within, "polyline", "points").remove(0);
        let numbers: Vec<f64> = line.split([' ', ',']).map(|number| number.parse().unwrap()).collect();
        let drawn = [numbers[2] - numbers[0], numbers[1] - numbers[3]].map(f64::abs);
        let page_of = page(&within);
        // But for a page that would be too narrow for a legend.
        let filled = [drawn[0] / page_of[0], drawn[1] / (page_of[1] - 4.5)];
        assert!(filled.into_iter().fold(0.0, f64::max) > 0.6, "{width} x {height}: {drawn:?} on {page_of:?}");
        assert!(page_of[0] <= 160.0 && page_of[1] <= 120.0);
        assert!(is_whole(&svg::write(&figure, [160.0, 120.0], Language::english())));
    }
    // Curves have the whole page.
    let curves = chart("", &[1.0, 2.0], 0.0);
    assert!(is_whole(&svg::write(&curves, Page::Within([160.0, 120.0]), Language::english())));
}

#[test]
fn all_of_a_long_legend_is_on_the_page() {
    let key = |at: usize| Key {
        sample: Sample::Line(Stroke::Solid, Ink::First),
        text: name(format!("F{at}_a_load_of_some_length_1234.5_N")),
    };
    for legend in [2, 12, 24] {
        let high = plane(vec![Item::line([[0.0; 2], [0.3, 1.0]], Stroke::Solid, Ink::First)]);
        let figure = Figure { legend: (0..legend).map(key).collect(), ..high };
        let text = svg::write(&figure, Page::Within([160.0, 120.0]), Language::english());
        let [width, height] = page(&text);
        let places = |name| attributes(&text, "text", name).into_iter().map(|at| number(&at));
        assert!(places("x").zip(places("y")).all(|(x, y)| x < width - 30.0 && y < height), "{text}");
        assert_eq!(text.matches("a_load_of_some_length").count(), legend);
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
        let bounds = Bounds { low: [0.0; 2], high: [2.0, 1.0] };
        Figure::of(Panel::plane(bounds, Scale::of("l", "m"), items))
    };
    let frames = [frame(0.0), frame(1.0), frame(2.0)];
    let (text, _) = svg::animate(&frames, [100.0, 80.0], 3.0, Language::english());
    assert_eq!(text.matches("<animate ").count(), 1, "{text}");
    // Both lines, and the bar of the scale.
    assert_eq!(text.matches("<polyline").count(), 3, "{text}");
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
