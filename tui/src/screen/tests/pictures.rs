//! Pictures of the views without a terminal.

use std::path::Path;

use assur_analysis::results::{Column, Owner, Quantity};
use assur_analysis::{Options, unwatched};
use assur_figure::{Item, Sample};
use assur_mechanism::Surfaces;
use assur_picture::{Arrows, Picture, Results};
use assur_words::Language;
use strum::VariantNames;

use super::{View, opened, press};
use crate::screen::draw::cells;
use crate::screen::state::Zoom;
use crate::screen::view;
use crate::session::{Session, Source};
use crate::still::{self, PictureArgs, StillError};

pub(super) fn request(view: &str) -> PictureArgs {
    PictureArgs {
        view: Some(view.parse().unwrap()),
        part: None,
        show: None,
        step: None,
        position: vec![5],
        size: None,
        animate: false,
        arrows: None,
    }
}

fn analyzed(name: &str, request: &PictureArgs) -> Results {
    let session = Session::open(Source::File(assur_fixtures::path(&format!("{name}.toml")))).unwrap();
    session.analyzed(&Options::default(), request.shows_checks(), &mut unwatched).unwrap()
}

fn draw(results: &Results, request: &PictureArgs) -> Result<Vec<u8>, StillError> {
    still::draw(results, request, Path::new("x.svg"), Language::english())
}

fn picture(request: &PictureArgs, output: &str) -> Result<String, StillError> {
    let results = analyzed("shaper-drive", request);
    still::draw(&results, request, Path::new(output), Language::english())
        .map(|bytes| String::from_utf8(bytes).unwrap())
}

#[test]
fn every_view_with_a_figure_has_a_picture() {
    for view in Picture::VARIANTS {
        let text = picture(&request(view), "x.svg").unwrap();
        assert!(text.contains("<polyline") && text.ends_with("</svg>\n"), "{view}");
    }
}

#[test]
fn a_request_without_a_meaning_is_refused_in_words() {
    let refused = |request: PictureArgs, output: &str| match picture(&request, output) {
        Err(StillError::Request(text)) => text.to_string(),
        other => panic!("{other:?}"),
    };
    assert!(refused(PictureArgs { position: vec![48], ..request("curves") }, "x.svg").contains("0 to 47"));
    let part = PictureArgs { part: Some("hodgraph".into()), ..request("forces") };
    assert!(refused(part, "x.svg").contains("hodograph"));
    assert!(
        refused(PictureArgs { show: Some("nothing".into()), ..request("forces") }, "x.svg")
            .contains("nothing")
    );
    // What there is, the most similar first, each once and not all of very many.
    let absent = PictureArgs { show: Some("rockers".into()), ..request("curves") };
    let told = refused(absent, "x.svg");
    let (_, names) = told.split_once(": ").unwrap();
    let listed: Vec<_> = names.split(" and ").next().unwrap().split(", ").collect();
    assert!(listed.len() == 12 && listed[0].contains("rocker") && names.ends_with(" more"), "{told}");
    assert!((1..listed.len()).all(|index| !listed[..index].contains(&listed[index])), "{told}");
    assert!(refused(request("curves"), "x.pdf").contains(".svg, .png or .dxf"));
    assert!(refused(PictureArgs { animate: true, ..request("mechanism") }, "x.png").contains("SVG"));
}

#[test]
fn a_view_without_a_figure_says_what_the_scene_lacks() {
    let request = request("drive");
    match draw(&analyzed("four-bar", &request), &request) {
        Err(StillError::Nothing(text)) => assert!(text.to_string().contains("no steady regime"), "{text}"),
        other => panic!("{other:?}"),
    }
    let crank = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[input]\nlink = \"crank\"\n";
    let state = super::scene(crank);
    match draw(state.scene.as_ref().unwrap(), &self::request("forces")) {
        Err(StillError::Nothing(text)) => assert!(text.to_string().contains("no loads"), "{text}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn only_a_scene_without_loads_is_told_to_have_none() {
    let first_lost = super::random::lost("-90 deg", "1.5");
    let mut states = vec![("without any position", super::scene(&super::random::lost("0 deg", "0.1")))];
    states.push(("some lost", super::scene(&super::random::lost("0 deg", "1.5"))));
    states.push(("the first lost", super::scene(&first_lost)));
    states.extend(["shaper-friction", "press", "brake", "andrews"].map(|name| (name, opened(name))));
    for (name, state) in &states {
        for (view, part) in Picture::VARIANTS.iter().flat_map(|view| {
            let parts = view.parse::<View>().unwrap().parts();
            std::iter::once((view, None))
                .chain(parts.iter().map(move |part| (view, Some(<&str>::from(part)))))
        }) {
            for position in [0, state.positions() / 2] {
                let part = part.map(str::to_owned);
                let request = PictureArgs { part, position: vec![position], ..request(view) };
                if let Err(StillError::Nothing(why)) = draw(state.scene.as_ref().unwrap(), &request) {
                    assert!(!why.to_string().contains("no loads"), "{name} {view} {request:?}: {why}");
                }
            }
        }
    }
    // Positions 2 to 16 of the one whose first position is lost have forces, which the moment of 3 N m needs.
    let forces = &states[2].1.found().unwrap().reactions;
    assert_eq!(forces.len(), 5, "{forces:?}");
    let series = states[2].1.found().unwrap().balancing().unwrap();
    assert!((0..36).all(|position| series.at(position).is_finite() == (2..=16).contains(&position)));
    // No equilibrium without a load.
    let text = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n[input]\nlink = \"crank\"\n";
    let state = super::scene(text);
    match draw(state.scene.as_ref().unwrap(), &PictureArgs { position: vec![0], ..request("forces") }) {
        Err(StillError::Nothing(why)) => assert!(why.to_string().contains("no loads"), "{why}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn an_animation_moves_the_links_and_not_the_ground() {
    let text = picture(&PictureArgs { animate: true, ..request("mechanism") }, "x.svg").unwrap();
    let moving = text.lines().filter(|line| line.contains("<animate")).count();
    let still = text.lines().filter(|line| line.starts_with("<p") && !line.contains("<animate")).count();
    assert!(moving > 10 && still > 10, "{moving} {still}");
    let values = text.split("values=\"").nth(1).unwrap().split('"').next().unwrap();
    assert_eq!(values.split(';').count(), 49, "48 positions, and the first one again");
}

#[test]
fn the_screen_and_the_file_show_the_same_signs_of_a_curve() {
    let mut state = opened("shaper");
    press(&mut state, "2");
    let figure = view::figure(&state, View::Curves).unwrap();
    let spots = assur_figure::cells::draw(&figure, [200, 60], cells(&state, Zoom::WHOLE));
    let on_screen = |text: &str| spots.iter().filter(|spot| spot.text == text).count();
    let svg = assur_figure::svg::write(&figure, [160.0, 120.0], assur_words::Language::english());
    // A ring is the only circle of a curve; one stands in the legend.
    assert_eq!(on_screen("o"), svg.matches("<circle").count() - 1);
}

/// The texts of a picture of a scene.
fn texts(scene: &str, request: &PictureArgs) -> Vec<String> {
    let bytes = draw(&analyzed(scene, request), request).unwrap();
    let svg = String::from_utf8(bytes).unwrap();
    let texts = svg.split("<text").skip(1).filter_map(|rest| rest.split_once('>')?.1.split_once("</text>"));
    // Subscripts have tags of their own.
    let untagged = |text: &str| {
        let mut parts = text.split('<');
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |text, part| text + part.split_once('>').map_or("", |(_, rest)| rest))
    };
    texts.map(|(text, _)| untagged(text)).collect()
}

#[test]
fn the_press_is_drawn_with_its_contact() {
    for scene in ["press", "press-compression"] {
        let shown = texts(scene, &request("mechanism"));
        for name in ["K", "N", "F", "Fc", "Ff"] {
            assert!(shown.iter().any(|text| text == name), "{scene} {name}: {shown:?}");
        }
    }
    assert!(!texts("slider-crank", &request("mechanism")).contains(&"K".to_owned()));
}

/// The texts of a picture of the shaper that begin so.
fn beginning(words: &str, request: &PictureArgs) -> Vec<String> {
    let all = texts("shaper-drive", request).into_iter();
    all.filter(|text| text.starts_with(words)).collect()
}

/// The texts of a picture, each line and each subscript by itself; without its title, which no reader sees.
fn words_of(svg: &str) -> Vec<String> {
    let parts =
        svg.split('<').filter(|part| !part.starts_with("title")).filter_map(|part| part.split_once('>'));
    parts.map(|(_, text)| text.trim().to_owned()).filter(|text| !text.is_empty()).collect()
}

#[test]
fn force_polygons_follow_each_other_group_by_group_with_the_input_link_last() {
    let of =
        |show: Option<&str>, step| PictureArgs { show: show.map(str::to_owned), step, ..request("plans") };
    let told = |request: &PictureArgs| {
        // A long heading has several lines.
        let svg = words_of(&picture(request, "x.svg").unwrap()).join(" ");
        let heads =
            ["of group 2", "of group 1", "of the input"].map(|of| svg.find(&format!("Force polygon {of}")));
        heads.into_iter().flatten().collect::<Vec<_>>()
    };
    let all = told(&of(None, None));
    assert!(all.len() == 3 && all.is_sorted(), "{all:?}");
    assert_eq!(told(&of(None, Some(2))).len(), 2);
    assert_eq!(told(&of(Some("group 1"), None)).len(), 1);
    for (wrong, why) in [
        (of(None, Some(4)), "1 to 3"),
        (of(None, Some(0)), "1 to 3"),
        (of(Some("group 1"), Some(1)), "--step"),
    ] {
        match picture(&wrong, "x.svg") {
            Err(StillError::Request(text)) => assert!(text.to_string().contains(why), "{text}"),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn several_positions_stand_beside_each_other_to_one_scale() {
    let of = |position: &[usize]| PictureArgs {
        show: Some("group 2".into()),
        position: position.to_vec(),
        ..request("plans")
    };
    // In position 35 the group has no cutting force: its polygon alone would have another scale.
    let scale = |position: &[usize]| {
        let svg = picture(&of(position), "x.svg").unwrap();
        words_of(&svg).into_iter().filter(|text| text.ends_with("N/mm")).collect::<Vec<_>>()
    };
    let both = scale(&[12, 35]);
    assert_eq!(both, [scale(&[12]), scale(&[12])].concat());
    assert_ne!(scale(&[35]), scale(&[12]));
    let svg = picture(&PictureArgs { size: Some([320.0, 120.0]), ..of(&[12, 35]) }, "x.svg").unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("width=\"320mm\" height=\"120mm\""));
    assert!(svg.contains("translate(0 0)") && svg.contains("translate(160 0)"), "beside each other");
    assert!(svg.find("position 12, 90 deg") < svg.find("position 35, 262.5 deg"));
}

#[test]
fn a_strip_of_the_motion_is_drawn_by_its_name() {
    let of = |show: &str| PictureArgs {
        view: None,
        part: Some("course".into()),
        show: Some(show.into()),
        ..request("motion")
    };
    let strips = |show: &str| {
        let all = ["input speed", "moments on the input"];
        all.map(|strip| beginning(strip, &of(show)).len())
    };
    assert_eq!(
        [strips("input speed"), strips("moments"), strips("moments, input speed")],
        [[1, 0], [0, 1], [1, 1]]
    );
    match picture(&of("input sped"), "x.svg") {
        Err(StillError::Request(text)) => assert!(text.to_string().contains("input speed"), "{text}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_construction_is_drawn_step_by_step() {
    let of = |step| PictureArgs {
        part: Some("construction".into()),
        show: Some("longitudinal".into()),
        step,
        ..request("plans")
    };
    let drawn = |step| texts("press", &of(step));
    let has = |texts: &[String], name: &str| texts.iter().any(|text| text == name);
    let (first, pole, whole) = (drawn(Some(1)), drawn(Some(5)), drawn(None));
    assert!(has(&first, "K") && !has(&first, "P") && !has(&first, "Fb"), "{first:?}");
    assert!(has(&pole, "P") && !has(&pole, "Fb"), "{pole:?}");
    assert!(
        has(&whole, "Fb") && has(&whole, "RP") && whole.iter().any(|line| line.ends_with("step 27")),
        "{whole:?}"
    );
    assert_eq!(drawn(Some(27)), whole);
    for (request, why) in [(of(Some(28)), "steps 1 to 27"), (of(Some(0)), "steps 1 to 27")] {
        match draw(&analyzed("press", &request), &request) {
            Err(StillError::Request(text)) => assert!(text.to_string().contains(why), "{text}"),
            other => panic!("{other:?}"),
        }
    }
    let lever = PictureArgs { show: Some("virtual-power".into()), ..of(None) };
    assert!(has(&texts("press", &lever), "k") && has(&texts("press", &lever), "Fbal"));
}

#[test]
fn quantities_of_one_unit_lie_over_each_other_in_a_picture() {
    let names = "A>crank.F,B>rod.Fx,balancing load";
    let request = PictureArgs { show: Some(names.into()), ..request("curves") };
    let shown = texts("press", &request);
    for name in ["1 A on crank R reaction, N", "2 B on rod Rx reaction, N", "3 balancing load, N·m"] {
        assert!(shown.iter().any(|text| text.starts_with(&format!("{name}: "))), "{name}: {shown:?}");
    }
    let unknown = PictureArgs { show: Some("A>crank.F,nothing".into()), ..request };
    match draw(&analyzed("press", &unknown), &unknown) {
        Err(StillError::Request(text)) => assert!(text.to_string().contains("nothing"), "{text}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn reactions_are_drawn_with_what_keeps_up_the_motion() {
    let request = PictureArgs { arrows: Some(Arrows::Reactions), ..request("mechanism") };
    for (scene, keeps) in [("shaper", "balancing load"), ("shaper-drive", "moment of the drive")] {
        let shown = texts(scene, &request);
        assert!(shown.iter().any(|text| text.contains(keeps)), "{scene}: {shown:?}");
    }
}

#[test]
fn a_legend_has_the_colors_of_the_drawing() {
    for (scene, view) in
        [("jansen", View::Structure), ("six-links", View::Structure), ("four-bar", View::Mechanism)]
    {
        let figure = view::figure(&opened(scene), view).unwrap();
        let drawn: Vec<_> = figure.panels[0]
            .items
            .iter()
            .filter_map(|item| match item {
                Item::Line { ink, .. } | Item::Area { ink, .. } | Item::Arrow { ink, .. } => Some(*ink),
                _ => None,
            })
            .collect();
        for key in &figure.legend {
            let Sample::Line(_, ink) = key.sample else { continue };
            assert!(drawn.contains(&ink), "{scene}: {} {ink:?}", key.text);
        }
    }
}

#[test]
fn a_reaction_with_friction_is_drawn_at_the_distance_and_with_the_parts_that_were_found() {
    let scene = analyzed("shaper-friction", &request("forces"));
    let (found, mechanism) = (scene.found.as_ref().unwrap(), &scene.linkage.mechanism);
    let line = |item: &Item| match item {
        Item::Line { points, .. } => [points[0], *points.last().unwrap()],
        Item::Arrow { from, to, .. } => [*from, *to],
        other => panic!("{other:?}"),
    };
    let mut drawn = 0;
    for position in 0..scene.positions() {
        for reaction in &found.reactions {
            let Some(panel) = assur_picture::forces::beside_friction(found, position, reaction) else {
                continue;
            };
            let (pair, link) = reaction.of.as_ref().unwrap();
            let own = mechanism.frictions.iter().find(|friction| friction.pair == pair.id).unwrap();
            let value = |index: usize| found.series[reaction.series[index]].course.get(position).unwrap();
            let [x, y, size] = [0, 1, 2].map(value);
            if let Surfaces::Journal { radius, owner } = own.surfaces {
                // The moment about the center is f r |R| against the turning of the other link.
                let [from, to] = line(&panel.items[3]);
                let length = (to[0] - from[0]).hypot(to[1] - from[1]);
                let [u, v] = [0, 1].map(|axis| (to[axis] - from[axis]) / length);
                assert!((u * size - x).abs().max((v * size - y).abs()) < 1e-9 * size);
                let moment = size * (from[0] * v - from[1] * u);
                let bodies = &scene.pose(position, 0.0).unwrap().bodies;
                let other = mechanism.friction_links(own)[0][0];
                let turning = (bodies[other].w1 - bodies[owner].w1).signum();
                let sign = if link.id == owner { 1.0 } else { -1.0 };
                let expected = sign * turning * own.coefficient * radius * size;
                assert!((moment - expected).abs() < 1e-9 * expected.abs(), "{position} {reaction:?}");
            } else {
                let [[_, across], [_, whole]] = [line(&panel.items[3]), line(&panel.items[5])];
                assert!((whole[0] - x).hypot(whole[1] - y) < 1e-12 * size);
                let share = Column::of(Quantity::FrictionForce, Owner::Pair(pair.id));
                let table = &found.analysis.positions;
                let share = table.get(table.row_of(position).unwrap(), share).unwrap();
                let along = (whole[0] - across[0]).hypot(whole[1] - across[1]);
                assert!((along - share.abs()).abs() < 1e-9 * size, "{position} {reaction:?}");
            }
            drawn += 1;
        }
    }
    assert_eq!(drawn, 7 * scene.positions());
}
