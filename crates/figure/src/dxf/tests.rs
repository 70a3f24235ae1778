//! A DXF is read back: groups in pairs, entities on layers, coordinates in millimeters.

use assur_words::{Language, name, unit};

use super::write;
use crate::model::{Cursor, Figure, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use crate::{Axis, Bounds, Scale};

/// An entity: its kind and its groups.
type Entity = Vec<(i32, String)>;

/// The sections of a file, read without anything of the writer.
fn entities(text: &str) -> Vec<Entity> {
    assert!(text.is_ascii());
    let lines: Vec<&str> = text.split("\r\n").collect();
    assert_eq!(lines.len() % 2, 1, "groups are pairs of lines");
    let groups: Vec<(i32, String)> =
        lines.chunks_exact(2).map(|two| (two[0].trim().parse().unwrap(), two[1].to_owned())).collect();
    assert_eq!(groups.last().unwrap(), &(0, "EOF".to_owned()));
    let opens = groups.iter().filter(|group| group.1 == "SECTION").count();
    assert_eq!((opens, groups.iter().filter(|group| group.1 == "ENDSEC").count()), (3, 3));
    let begin = groups.iter().position(|group| *group == (2, "ENTITIES".to_owned())).unwrap();
    let mut found: Vec<Entity> = Vec::new();
    for group in &groups[begin + 1..] {
        match group {
            (0, kind) if kind == "ENDSEC" => break,
            (0, _) => found.push(vec![group.clone()]),
            _ => found.last_mut().unwrap().push(group.clone()),
        }
    }
    let layers: Vec<&String> =
        groups.windows(2).filter(|two| two[0] == (0, "LAYER".to_owned())).map(|two| &two[1].1).collect();
    for entity in &found {
        assert!(layers.contains(&&value(entity, 8)), "{entity:?}");
    }
    found
}

fn value(entity: &Entity, code: i32) -> String {
    entity.iter().find(|group| group.0 == code).unwrap_or_else(|| panic!("{code} of {entity:?}")).1.clone()
}

fn number(entity: &Entity, code: i32) -> f64 {
    value(entity, code).parse().unwrap()
}

fn of_kind<'a>(all: &'a [Entity], kind: &str) -> Vec<&'a Entity> {
    all.iter().filter(|entity| entity[0].1 == kind).collect()
}

fn near(entity: &Entity, codes: [i32; 2], at: Point) {
    for (code, at) in codes.into_iter().zip(at) {
        assert!((number(entity, code) - at).abs() < 1e-9, "{code} is not {at} in {entity:?}");
    }
}

fn plane(items: Vec<Item>, scale: Scale) -> Figure {
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    Figure::of(Panel::plane(bounds, scale, items))
}

fn drawn(figure: &Figure) -> Vec<Entity> {
    entities(&write(std::slice::from_ref(figure), Language::english()).unwrap())
}

fn meters() -> Scale {
    Scale::of("l", "m")
}

#[test]
fn a_meter_is_a_thousand_units_at_its_own_place() {
    let items = vec![
        Item::line([[0.1, -0.2], [1.0 / 3.0, 0.25]], Stroke::Thick, Ink::Link(2)),
        Item::line([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1]], Stroke::Dashed, Ink::Trace),
        Item::sign([0.1, -0.2], Sign::Pin, Ink::Ground),
    ];
    let all = drawn(&plane(items, meters()));
    let line = of_kind(&all, "LINE")[0];
    near(line, [10, 20], [100.0, -200.0]);
    near(line, [11, 21], [1000.0 / 3.0, 250.0]);
    assert_eq!(value(line, 8), "LINK_2");
    let path = of_kind(&all, "POLYLINE")[0];
    assert_eq!(
        (value(path, 8), value(path, 6), value(path, 70)),
        ("PATHS".to_owned(), "DASHED".to_owned(), "0".to_owned())
    );
    let corners = of_kind(&all, "VERTEX");
    assert_eq!(corners.len(), 3);
    near(corners[2], [10, 20], [100.0, 100.0]);
    near(of_kind(&all, "CIRCLE")[0], [10, 20], [100.0, -200.0]);
}

#[test]
fn a_plan_has_a_round_scale_that_it_tells() {
    // 7 m/s on at most 140 mm: 0.05 m/s a mm.
    let all = drawn(&plane(
        vec![Item::line([[0.0, 0.0], [7.0, 0.0]], Stroke::Solid, Ink::Velocity)],
        Scale::of("v", "m/s"),
    ));
    near(of_kind(&all, "LINE")[0], [11, 21], [140.0, 0.0]);
    let texts: Vec<String> = of_kind(&all, "TEXT").into_iter().map(|text| value(text, 1)).collect();
    assert!(texts.iter().any(|text| text.ends_with("\\U+03BC_v = 0.05 (m/s)/mm")), "{texts:?}");
}

#[test]
fn a_circle_and_an_arc_are_found_in_their_points_and_a_path_is_not() {
    let around = |from: f64, to: f64, steps: u32| -> Vec<Point> {
        (0..=steps)
            .map(|step| {
                let angle = (from + (to - from) * f64::from(step) / f64::from(steps)).to_radians();
                [0.5 + 0.2 * angle.cos(), 0.1 + 0.2 * angle.sin()]
            })
            .collect()
    };
    let mut bent = around(0.0, 90.0, 20);
    bent[7][0] += 1e-6;
    let items = vec![
        Item::circle([0.5, 0.1], 0.2, Stroke::Solid, Ink::Text),
        Item::line(around(30.0, 75.0, 20), Stroke::Solid, Ink::Text),
        Item::line(around(75.0, -15.0, 20), Stroke::Solid, Ink::Text),
        Item::line(bent, Stroke::Solid, Ink::Text),
    ];
    let all = drawn(&plane(items, meters()));
    let [circle] = of_kind(&all, "CIRCLE")[..] else { panic!("{all:?}") };
    near(circle, [10, 20], [500.0, 100.0]);
    assert!((number(circle, 40) - 200.0).abs() < 1e-6);
    let [left, right] = of_kind(&all, "ARC")[..] else { panic!("{all:?}") };
    near(left, [50, 51], [30.0, 75.0]);
    near(right, [50, 51], [345.0, 75.0]);
    assert_eq!(of_kind(&all, "POLYLINE").len(), 1);
}

#[test]
fn letters_are_ascii_and_signs_of_their_own_stay_letters() {
    let items = vec![
        Item::line([[0.0, 0.0], [1.0, 0.0]], Stroke::Solid, Ink::Text),
        Item::name([0.0, 0.0], name("Ї𝛼 50%%\n1"), Ink::Title),
    ];
    let all = drawn(&plane(items, meters()));
    let texts = of_kind(&all, "TEXT");
    assert!(texts.iter().any(|text| value(text, 1) == "\\U+0407\\U+D835\\U+DEFC 50%%%%%%1"), "{texts:?}");
}

#[test]
fn further_planes_stand_beside_and_below_the_first() {
    let line = |to: f64| plane(vec![Item::line([[0.0, 0.0], [to, to]], Stroke::Solid, Ink::First)], meters());
    let mut pair = line(1.0);
    pair.panels.extend(line(0.5).panels);
    let text = write(&[pair, line(2.0)], Language::english()).unwrap();
    let all = entities(&text);
    let lines = of_kind(&all, "LINE");
    near(lines[0], [10, 20], [0.0, 0.0]);
    let length =
        |line: &Entity| (number(line, 11) - number(line, 10)).hypot(number(line, 21) - number(line, 20));
    for (line, to) in lines.iter().zip([1.0, 0.5, 2.0]) {
        assert!((length(line) - 1000.0 * to * f64::sqrt(2.0)).abs() < 1e-6);
    }
    assert!(number(lines[1], 10) > 1000.0 && number(lines[2], 21) < 0.0);
}

#[test]
fn plots_and_nothing_are_refused() {
    let axis = || Axis::around(unit("N"), [0.0, 1.0], 0.0);
    let frame = Frame::Axes { x: axis(), y: axis(), cursor: None::<Cursor> };
    let plot = Figure::of(Panel { title: name("F"), frame, items: Vec::new() });
    for figures in [vec![plot], Vec::new()] {
        assert!(write(&figures, Language::english()).unwrap_err().to_string().contains("no plots over axes"));
    }
}

#[test]
fn what_is_not_finite_interrupts_a_line() {
    let gap = [f64::NAN, 0.0];
    let items =
        vec![Item::line([[0.0, 0.0], [1.0, 0.0], gap, [2.0, 0.0], [3.0, 0.0]], Stroke::Solid, Ink::Text)];
    let all = drawn(&plane(items, meters()));
    assert_eq!(of_kind(&all, "LINE").len(), 2);
}
