//! The construction as L draws it: the pole, F resolved along KA and KP, the polygon that closes in P.

use assur_force::{Acting, Construction, ConstructionStep, Drawing, VectorKind};
use assur_group::plane::{cross, dot, length, minus, opposite, perp, plus, scaled};
use assur_group::{Body, Wrench};
use assur_kinematics::Linkage;
use assur_number::ROUNDING;
use assur_words::{Text, joined, name, number, quantity, text};

use crate::layout::{End, Layout, Setting, Unknowns, at_a, at_b};

/// What the drawing needs besides [`Setting`] and [`Unknowns`].
#[derive(Debug)]
pub(crate) struct Scene {
    coupler: Text,
    third: Text,
    a: Text,
    b: Text,
    o: Text,
    end: Text,
    /// Points of action of the coupler's loads, m: K is one of them where possible.
    places: Vec<[f64; 2]>,
    /// Force directly on the ground, N.
    crank_load: [f64; 2],
    third_load: [f64; 2],
}

impl Scene {
    pub(crate) fn of(
        layout: &Layout,
        linkage: &Linkage,
        bodies: &[Body<f64>],
        (acting, loads): (&[Acting], &[Wrench<f64>]),
    ) -> Self {
        let mechanism = &linkage.mechanism;
        let link = |link: usize| Text::from(&mechanism.links[link].name);
        let pair = |id: usize| Text::from(linkage.structure.pair_name(mechanism, id));
        let own = acting.iter().filter(|load| load.link == layout.coupler);
        let mut places: Vec<_> = own.filter_map(|load| load.at).collect();
        places.push(bodies[layout.coupler].point(mechanism.links[layout.coupler].center));
        places.push(bodies[layout.coupler].point(layout.b.own));
        let end = match layout.end {
            End::Guide(guide) => guide.id,
            End::Pin(pin) => pin.id,
        };
        Self {
            coupler: link(layout.coupler),
            third: link(layout.third),
            a: pair(layout.a.id),
            b: pair(layout.b.id),
            o: pair(layout.o.id),
            end: pair(end),
            places,
            crank_load: loads[layout.crank].force(),
            third_load: loads[layout.third].force(),
        }
    }
}

/// The pole in homogeneous coordinates: finite where the weight is not zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pole {
    /// (X, Y), relative to O: the weight times the place, or the direction.
    pub(crate) xy: [f64; 2],
    /// Sine of the angle between crank and line 3.
    pub(crate) weight: f64,
}

impl Pole {
    pub(crate) fn of(at: &Setting) -> Self {
        let (crank, _) = at.crank();
        Self { xy: scaled(cross(minus(at.b, at.o), at.line), crank), weight: cross(crank, at.line) }
    }

    fn place(self, at: &Setting) -> Option<[f64; 2]> {
        (self.weight.abs() > ROUNDING).then(|| plus(at.o, scaled(1.0 / self.weight, self.xy)))
    }

    /// Direction from a point to the pole; finite for a pole at infinity too.
    fn from(self, point: [f64; 2], at: &Setting) -> [f64; 2] {
        minus(self.xy, scaled(self.weight, minus(point, at.o)))
    }
}

/// Adds steps of one kind to a drawing; for each: name, start, vector, note.
fn push<const N: usize>(
    draft: &mut Vec<ConstructionStep>,
    (drawing, kind): (Drawing, VectorKind),
    steps: [(&'static str, [f64; 2], [f64; 2], Text); N],
) {
    let unit = if matches!(kind, VectorKind::Point | VectorKind::Line) { "m" } else { "N" };
    draft.extend(steps.map(|(symbol, start, vector, note)| ConstructionStep {
        of: Text::default(),
        name: lettered(symbol),
        kind,
        drawing,
        start,
        after: [0.0; 2],
        vector,
        unit,
        note,
    }));
}

/// Adds a line from the end of a force that begins at a point, as long as another force is drawn.
fn push_line(
    draft: &mut Vec<ConstructionStep>,
    symbol: &'static str,
    start: [f64; 2],
    [after, vector]: [[f64; 2]; 2],
    note: Text,
) {
    push(draft, (Drawing::Mechanism, VectorKind::Line), [(symbol, start, vector, note)]);
    if let Some(line) = draft.last_mut() {
        (line.after, line.unit) = (after, "N");
    }
}

/// The symbol of a step; some have letters of their own in each language.
fn lettered(symbol: &'static str) -> Text {
    match symbol {
        "Fb" => text!("force-longitudinal-fb"),
        "FA across" => text!("force-longitudinal-across"),
        "across OP" => text!("force-longitudinal-across-crank"),
        "along OP" => text!("force-longitudinal-along-crank"),
        "along KA" => text!("force-longitudinal-along-moved"),
        "along KP" => text!("force-longitudinal-along-pole"),
        _ => name(symbol),
    }
}

/// All steps in order.
pub(crate) fn draw(scene: &Scene, at: &Setting, found: &Unknowns) -> Construction {
    let mut draft = Vec::new();
    let pole = Pole::of(at);
    loads(&mut draft, scene, at);
    lines(&mut draft, scene, at, pole);
    resolution(&mut draft, scene, at, found, pole);
    polygon(&mut draft, at, found);
    reactions(&mut draft, scene, at, found);
    let (_, crank) = at.crank();
    // A pole far off the paper is of no use to lay forces off from.
    let near = |place: &[f64; 2]| length(minus(*place, at.a)) < 100.0 * crank;
    let corner = pole.place(at).filter(near).unwrap_or(at.a);
    let title = text!("force-longitudinal-title", coupler = &scene.coupler, point = &scene.a);
    Construction { title, corner, steps: draft }
}

/// F and its components.
fn loads(draft: &mut Vec<ConstructionStep>, scene: &Scene, at: &Setting) {
    let Scene { third, b, end, coupler, .. } = scene;
    if at.known != [0.0, 0.0] {
        let (symbol, what) = if at.slider {
            ("F3", text!("force-longitudinal-along-guide", third, point = b))
        } else {
            ("R3t", text!("force-longitudinal-across-rocker", end, third, point = b))
        };
        push(draft, (Drawing::Mechanism, VectorKind::Load), [(symbol, at.b, at.known, what)]);
    }
    let (k, couple) = point_of_action(scene, at);
    let what = text!("force-longitudinal-point");
    push(draft, (Drawing::Mechanism, VectorKind::Point), [("K", k, [0.0; 2], what)]);
    let mut what = text!("force-longitudinal-load", coupler);
    if couple != 0.0 {
        let couple = quantity(format_args!("{couple:.6e}"), "N m");
        what = joined("; ", [what, text!("force-longitudinal-couple", couple)]);
    }
    push(draft, (Drawing::Mechanism, VectorKind::Load), [("F", k, at.force, what)]);
}

/// K: a point of action of a load, if it is on the line of F and off the line KP; and the remaining couple.
fn point_of_action(scene: &Scene, at: &Setting) -> ([f64; 2], f64) {
    let action = at.action();
    if action.couple != 0.0 || at.force == [0.0, 0.0] {
        return (action.at, action.couple);
    }
    let rod = minus(at.b, at.a);
    let (rod, size) = (length(rod), length(at.force));
    let shift = scaled(rod / size, at.force);
    let miss = |place: &[f64; 2]| (cross(minus(*place, at.a), at.force) - at.moment_a).abs();
    let real = scene.places.iter().copied().filter(|place| miss(place) <= 1e-9 * rod * size);
    let made = [action.at, plus(action.at, shift), minus(action.at, shift)];
    let sound = |place: &[f64; 2]| {
        let (to_a, to_p) = (minus(at.a, *place), Pole::of(at).from(*place, at));
        cross(to_a, to_p).abs() > 0.02 * length(to_a) * length(to_p)
    };
    (real.chain(made).find(sound).unwrap_or(action.at), 0.0)
}

fn lines(draft: &mut Vec<ConstructionStep>, scene: &Scene, at: &Setting, pole: Pole) {
    let third =
        if at.slider { text!("force-longitudinal-normal") } else { text!("force-longitudinal-rocker") };
    let Some(place) = pole.place(at) else {
        let (crank, length) = at.crank();
        let along = scaled(2.0 * length, crank);
        let first = text!("force-longitudinal-crank-parallel");
        let second = text!("force-longitudinal-at-infinity", line = third);
        push(
            draft,
            (Drawing::Mechanism, VectorKind::Line),
            [("OP", at.o, along, first), ("BP", at.b, along, second)],
        );
        return;
    };
    let first = text!("force-longitudinal-crank-line", line = joined("", [scene.o.clone(), scene.a.clone()]));
    let second = text!("force-longitudinal-through", line = third, point = &scene.b);
    let lines = [("OP", at.o, minus(place, at.o), first), ("BP", at.b, minus(place, at.b), second)];
    push(draft, (Drawing::Mechanism, VectorKind::Line), lines);
    let what = text!("force-longitudinal-pole", coupler = &scene.coupler);
    push(draft, (Drawing::Mechanism, VectorKind::Point), [("P", place, [0.0; 2], what)]);
}

/// F along KA and KP, and the balancing force.
fn resolution(draft: &mut Vec<ConstructionStep>, scene: &Scene, at: &Setting, found: &Unknowns, pole: Pole) {
    let (k, couple) = point_of_action(scene, at);
    let (to_a, to_p) = (minus(at.a, k), pole.from(k, at));
    let turn = cross(to_a, to_p);
    let (mut part_a, mut part_p) = (at.force, [0.0; 2]);
    if turn != 0.0 {
        part_a = scaled(cross(at.force, to_p) / turn, to_a);
        part_p = minus(at.force, part_a);
        let unit = scaled(length(to_a) / length(to_p), to_p);
        let line = pole.place(at).map_or(unit, |place| minus(place, k));
        let to_pole = match pole.place(at) {
            Some(place) => {
                let [kp, ap] = [k, at.a].map(|from| minus(place, from)).map(length);
                let ratio = number(format_args!("{:.6}", kp / ap));
                text!("force-longitudinal-lever", ratio = ratio, point = &scene.a)
            }
            None => text!("force-longitudinal-to-pole"),
        };
        let lines = [
            ("KA", k, to_a, text!("force-longitudinal-to-point", point = &scene.a)),
            ("KP", k, line, to_pole),
        ];
        push(draft, (Drawing::Mechanism, VectorKind::Line), lines);
        let side = text!("force-longitudinal-parallelogram", line = name("KP"), other = name("KA"));
        push_line(draft, "along KP", k, [at.force, scaled(-1.0, part_p)], side);
        let side = text!("force-longitudinal-parallelogram", line = name("KA"), other = name("KP"));
        push_line(draft, "along KA", k, [at.force, scaled(-1.0, part_a)], side);
    }
    let (along, _) = at.crank();
    let across = scaled(dot(part_a, perp(along)), perp(along));
    let through_pole = text!("force-longitudinal-part-pole");
    let moved = text!("force-longitudinal-part-moved", point = &scene.a);
    let parts = [
        ("FP", k, part_p, through_pole),
        ("FA", k, part_a, text!("force-longitudinal-part-along")),
        ("FA", at.a, part_a, moved),
    ];
    push(draft, (Drawing::Mechanism, VectorKind::Part), parts);
    let upright = text!("force-longitudinal-upright", point = &scene.a);
    push_line(draft, "across OP", at.a, [[0.0; 2], across], upright);
    let back = text!("force-longitudinal-parallel-to-crank");
    push_line(draft, "along OP", at.a, [part_a, minus(across, part_a)], back);
    let cancelled = text!("force-longitudinal-part-across");
    push(draft, (Drawing::Mechanism, VectorKind::Part), [("FA across", at.a, across, cancelled)]);
    let what = if couple == 0.0 {
        text!("force-longitudinal-balancing", point = &scene.a)
    } else {
        text!("force-longitudinal-balancing-with-couple", point = &scene.a)
    };
    push(draft, (Drawing::Mechanism, VectorKind::Balancing), [("Fb", at.a, found.fb, what)]);
}

/// F + Fb + RP = 0, RP = R1 + R3, drawn head to tail.
fn polygon(draft: &mut Vec<ConstructionStep>, at: &Setting, found: &Unknowns) {
    let after = plus(at.force, found.fb);
    let last = plus(after, found.r1);
    let mut side = |kind, symbol, start, vector, note| {
        push(draft, (Drawing::Polygon, kind), [(symbol, start, vector, note)]);
    };
    side(VectorKind::Load, "F", [0.0; 2], at.force, text!("force-longitudinal-polygon-load"));
    side(VectorKind::Balancing, "Fb", at.force, found.fb, text!("force-longitudinal-polygon-balancing"));
    let closing = text!("force-longitudinal-polygon-closing");
    side(VectorKind::Closing, "RP", after, opposite(after), closing);
    let along = text!("force-longitudinal-polygon-crank");
    side(VectorKind::Reaction, "R1", after, found.r1, along);
    let other = text!("force-longitudinal-polygon-other");
    side(VectorKind::Reaction, "R3", last, found.r3, other);
}

fn reactions(draft: &mut Vec<ConstructionStep>, scene: &Scene, at: &Setting, found: &Unknowns) {
    let Scene { third, a, b, o, end, .. } = scene;
    let (ra, rb) = (at_a(found), at_b(at, found));
    let on_b = if at.known == [0.0, 0.0] {
        text!("force-longitudinal-on-b", pin = b)
    } else {
        text!("force-longitudinal-on-b-loaded", third, pin = b)
    };
    let (symbol, at_end, what) = if at.slider {
        let across = scaled(dot(minus(found.r3, scene.third_load), at.line), at.line);
        ("RG", across, text!("force-longitudinal-guide-on", end, third))
    } else {
        let what = text!("force-longitudinal-pin-on", end, third);
        ("RC", minus(rb, scene.third_load), what)
    };
    let steps = [
        ("R1", at.a, found.r1, text!("force-longitudinal-of-crank")),
        ("R3", at.b, found.r3, text!("force-longitudinal-of-third", third)),
        ("RA", at.a, ra, text!("force-longitudinal-on-a", pin = a)),
        ("RB", at.b, rb, on_b),
        ("RO", at.o, minus(ra, scene.crank_load), text!("force-longitudinal-on-o", pin = o)),
        (symbol, at.c, at_end, what),
    ];
    push(draft, (Drawing::Mechanism, VectorKind::Reaction), steps);
}
