//! Drawings explain themselves: the lever with its arms, hodographs with axes and numbers, reductions at their instants; and they fill
//! their pages.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_figure::{Bounds, Figure, Frame, Ink, Item, Page, Sign, svg};
use assur_group::plane::{cross, length, minus, plus};
use assur_picture::{Look, Picture, Results, ViewPart, forces};
use assur_words::{Language, Text};

use super::vectors::analyzed;

fn drawn(results: &Results, (view, part): (Picture, ViewPart), look: &Look<'_>) -> Figure {
    view.figure(results, look, part)
}

/// The number behind a sign in a text: `h = 0.1 m/rad`.
fn number_behind(text: &str, sign: &str) -> f64 {
    text.split_once(sign).unwrap().1.split(' ').next().unwrap().parse().unwrap()
}

#[test]
fn the_lever_is_in_balance_and_tells_the_arms_of_its_forces() {
    for scene in ["shaper-drive", "slider-crank", "six-links", "press", "rolling-press"] {
        let results = analyzed(scene);
        let found = results.found.as_ref().unwrap();
        for position in [2, 5] {
            let lever = found.plans.at(position);
            let index =
                lever.constructions.iter().position(|(method, _)| *method == "virtual-power").unwrap();
            let step = lever.steps_of(index).last().unwrap();
            let look = Look { position, step, ..Look::default() };
            let figure = drawn(&results, (Picture::Plans, ViewPart::Construction), &look);
            let Frame::Plane { bounds, scales } = &figure.panels[0].frame else { panic!() };
            let newtons = scales[1].size;
            let items = &figure.panels[0].items;
            let is_force = |ink: &Ink| matches!(ink, Ink::First | Ink::Second);
            let forces: Vec<[[f64; 2]; 2]> = items
                .iter()
                .filter_map(|item| match item {
                    Item::Arrow { from, to, ink, .. } if is_force(ink) => Some([*from, minus(*to, *from)]),
                    Item::Line { points, ink, .. } if is_force(ink) => {
                        Some([points[0], minus(points[1], points[0])])
                    }
                    _ => None,
                })
                .collect();
            // Their moments about the pole sum to zero.
            let moments: Vec<f64> = forces.iter().map(|[at, force]| newtons * cross(*at, *force)).collect();
            let most = moments.iter().fold(0.0_f64, |most, moment| most.max(moment.abs()));
            assert!(moments.iter().sum::<f64>().abs() < 1e-9 * most, "{scene} {position}: {moments:?}");
            // The balancing load is its force times its arm.
            let told = |start: &str| {
                let mut texts = figure.legend.iter().map(|key| key.text.to_string());
                texts.find(|text| text.starts_with(start)).unwrap()
            };
            // Of many entries the first ones are shown, this one in any case; there it is a force of its own.
            if scene != "rolling-press" {
                let balance = told("F_bal ");
                let size = number_behind(&balance[..balance.find(" N").unwrap()].replace("  ", "#"), "#");
                let moment = found.balancing().unwrap().at(position).abs();
                let arm = number_behind(&balance, "h = ");
                assert!((size * arm - moment).abs() < 1e-3 * moment, "{scene}: {balance}, {moment}");
            }
            // The arm of each force that is drawn with its name is told.
            let mut arms = 0;
            for item in items {
                let Item::Name { at, text, .. } = item else { continue };
                let start = format!("{text} ");
                let told = figure.legend.iter().map(|key| key.text.to_string());
                let told: Vec<String> =
                    told.filter(|told| told.starts_with(&start) && told.contains("h = ")).collect();
                let tip = |[from, along]: &&[[f64; 2]; 2]| length(minus(plus(*from, *along), *at)) < 1e-12;
                // A couple has its symbol on each of its forces.
                let (Some(&[at, force]), [told]) = (forces.iter().find(tip), &told[..]) else { continue };
                let arm = cross(at, force).abs() / length(force);
                let error = (number_behind(told, "h = ") - arm).abs();
                assert!(error <= 1e-4 * arm.max(1e-9), "{scene} {position}: {told}, not {arm}");
                arms += 1;
            }
            assert!(arms > 0, "{scene} {position}");
            // Nothing but what is seen takes room: each side of the drawing is met by a line that is not too short.
            let seen = items.iter().map(Item::points).filter(|points| {
                let [from, to] = [points[0], points[points.len() - 1]];
                length(minus(to, from)) > 0.01 * bounds.size()[0]
            });
            let seen = Bounds::around(seen.flatten()).size();
            for (seen, whole) in seen.into_iter().zip(bounds.size()) {
                assert!(seen > 0.95 * whole, "{scene} {position}: {seen} of {whole}");
            }
        }
    }
}

#[test]
fn a_hodograph_has_axes_in_newtons_and_marks_positions_by_their_numbers() {
    let results = analyzed("shaper-drive");
    let found = results.found.as_ref().unwrap();
    for (reaction, of) in found.reactions.iter().enumerate().filter(|(_, of)| of.series.len() == 3) {
        let look = Look { reaction, position: 5, ..Look::default() };
        let figure = forces::figure(&results, &look, ViewPart::Hodograph);
        let Frame::Plane { bounds, .. } = &figure.panels[0].frame else { panic!() };
        let items = &figure.panels[0].items;
        let tip = |number: usize| [0, 1].map(|axis| found.series[of.series[axis]].at(number));
        let mut marked = Vec::new();
        for two in items.windows(2) {
            if let [Item::Sign { at, sign: Sign::Node, .. }, Item::Name { at: beside, text, .. }] = two {
                let number: usize = text.to_string().parse().unwrap();
                assert!(
                    length(minus(*at, *beside)) + length(minus(*at, tip(number))) < 1e-9 * length(*at),
                    "{number}: {at:?}"
                );
                marked.push((number, *at));
            }
        }
        let size = bounds.size().into_iter().fold(0.0, f64::max);
        let apart = |one: &[f64; 2], other: &[f64; 2]| length(minus(*one, *other)) > 0.1 * size;
        for (index, (_, one)) in marked.iter().enumerate() {
            assert!(marked[..index].iter().all(|(_, other)| apart(one, other)), "{}", of.name);
        }
        // The guide of the ram carries its weight alone, which is constant.
        let least = if of.name.to_string().starts_with("ram/ground") { 1 } else { 3 };
        assert!(marked[0].0 == 5 && marked.len() >= least && marked.len() < 20, "{}: {marked:?}", of.name);
        // Each number of an axis stands at its place on it.
        let names = items.iter().filter_map(|item| match item {
            Item::Name { at, text, ink: Ink::Dim, .. } => Some((*at, text.to_string())),
            _ => None,
        });
        let (numbers, axes): (Vec<_>, Vec<_>) = names.partition(|(_, text)| text.parse::<f64>().is_ok());
        assert_eq!(axes.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>(), ["R_x, N", "R_y, N"]);
        assert!(numbers.len() >= least.min(2), "{}: {numbers:?}", of.name);
        for (at, text) in numbers {
            let value: f64 = text.parse().unwrap();
            let place = if at[1] == 0.0 { at[0] } else { at[1] };
            assert!(at.contains(&0.0) && (place - value).abs() < 1e-9 * value.abs(), "{text} {at:?}");
        }
    }
}

#[test]
fn a_transient_motion_is_reduced_at_its_instants() {
    for (scene, instants) in
        [("brake", [0, 5, 20]), ("compressor-start", [1, 5, 30]), ("disc-case-5", [0, 3, 7])]
    {
        let results = analyzed(scene);
        let table = &results.found.as_ref().unwrap().analysis.trajectory;
        let of_loads = table.schema().owners(Quantity::ReducedLoad).into_iter();
        let of_loads: Vec<Owner> = of_loads.filter(|owner| *owner != Owner::Input).collect();
        for position in instants {
            let look = Look { position, ..Look::default() };
            let shown = (Picture::Motion, ViewPart::Reduction);
            let figure = drawn(&results, shown, &look);
            let told = figure.panels[3].title.to_string();
            let moment = number_behind(&told, "M = ");
            let column =
                |owner: &Owner| table.get(position, Column::of(Quantity::ReducedLoad, *owner)).unwrap();
            let expected: f64 = of_loads.iter().map(column).sum();
            assert!(
                (moment - expected).abs() <= 1e-4 * expected.abs(),
                "{scene} {position}: {told}, not {expected}"
            );
            let place = results.place(position).to_string();
            let time = table.get(position, Column::of(Quantity::Time, Owner::Input)).unwrap();
            assert!((number_behind(&place, ", ") - time).abs() <= 1e-3 * time, "{place}, not {time} s");
        }
    }
    // f 2 P R = 0.2 * 40 N * 0.1 m against the motion.
    let brake = drawn(
        &analyzed("brake"),
        (Picture::Motion, ViewPart::Reduction),
        &Look { position: 5, ..Look::default() },
    );
    assert!(brake.panels[3].title.to_string().contains("M = -0.80000 N·m"), "{}", brake.panels[3].title);
}

/// How much of the tighter side of its panel a drawing of one plane fills.
fn filled(figure: Figure) -> Option<f64> {
    let bare = Figure { title: Text::default(), legend: Vec::new(), ..figure };
    let [panel] = &bare.panels[..] else { return None };
    let Frame::Plane { bounds, scales } = &panel.frame else { return None };
    let mut panel = panel.clone();
    panel.title = Text::default();
    let bare = Figure { panels: vec![panel.clone()], ..bare };
    let (text, page) =
        svg::animate(std::slice::from_ref(&bare), Page::Within([160.0, 120.0]), 0.0, Language::english());
    // The factor behind the first symbol: units of the plane in a millimeter.
    let factor: f64 = text.split_once('μ')?.1.split(" = ").nth(1)?.split(' ').next()?.parse().ok()?;
    let factor = factor / scales[0].size;
    let drawn = bounds.size().map(|side| side / factor);
    let rows = 1.5 * svg::EM * scales.len() as f64;
    let room = [page[0] - 5.0, page[1] - 5.0 - rows];
    (drawn[0].max(drawn[1]) > 0.0).then_some((drawn[0] / room[0]).max(drawn[1] / room[1]))
}

#[test]
fn a_drawing_fills_most_of_its_panel() {
    use ViewPart::{Accelerations, Construction, Forces, Hodograph, Overview, Velocities};
    let (mut count, mut small) = (0, Vec::new());
    for scene in
        ["shaper-drive", "six-links", "triad", "brake", "rolling-press", "slider-crank", "contour", "watt"]
    {
        let results = analyzed(scene);
        for (view, part) in [
            (Picture::Mechanism, Overview),
            (Picture::Forces, Hodograph),
            (Picture::Plans, Forces),
            (Picture::Plans, Velocities),
            (Picture::Plans, Accelerations),
            (Picture::Plans, Construction),
        ] {
            for position in [0, 5, 11] {
                let look = Look { position, step: usize::MAX, alone: true, ..Look::default() };
                let Some(filled) = filled(drawn(&results, (view, part), &look)) else { continue };
                count += 1;
                if filled < 0.6 {
                    small.push(format!("{scene} {view:?} {part:?} {position}: {filled:.3}"));
                }
            }
        }
    }
    assert!(small.is_empty() && count > 90, "{count} drawings\n{}", small.join("\n"));
}
