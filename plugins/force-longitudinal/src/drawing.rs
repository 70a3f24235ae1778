//! The construction as L draws it: the pole, F resolved along KA and KP, the polygon that closes in P.

use assur_force::{Construction, Drawing, Step, VectorKind};
use assur_group::plane::{cross, dot, minus, opposite, perp, plus, scaled};
use assur_group::{Body, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::Value;

use crate::deliver::{at_a, at_b};
use crate::layout::{End, Layout};
use crate::setting::{Setting, Unknowns};

/// Sines below this count as parallel in the drawing.
const PARALLEL: f64 = 1e-12;

/// What the drawing needs besides [`Setting`] and [`Unknowns`].
#[derive(Debug)]
pub(crate) struct Scene<'a> {
    coupler: &'a str,
    third: &'a str,
    a: &'a str,
    b: &'a str,
    o: &'a str,
    end: &'a str,
    /// Points of action of the coupler's loads, m: K is one of them where possible.
    places: Vec<[f64; 2]>,
    /// Force directly on the ground, N.
    crank_load: [f64; 2],
    third_load: [f64; 2],
}

impl<'a> Scene<'a> {
    pub(crate) fn of(
        layout: &Layout,
        linkage: &'a Linkage,
        bodies: &[Body<f64>],
        loads: &[Wrench<f64>],
    ) -> Self {
        let mechanism = &linkage.mechanism;
        let name = |link: usize| mechanism.links[link].name.as_str();
        let pair = |id: usize| linkage.structure.pair_name(mechanism, id);
        let forces = mechanism.forces.iter().filter(|force| force.at.link == layout.coupler);
        let mut places: Vec<_> = forces.map(|force| bodies[layout.coupler].point(force.at.at)).collect();
        for contact in mechanism.contacts.iter().filter(|contact| contact.center.link == layout.coupler) {
            let center = bodies[layout.coupler].point(contact.center.at);
            // Of a coupler without other loads; where there are others, the place lies on no line of action and is not taken, nor is
            // that of the other sense of a friction against the sliding.
            let [fx, fy] = loads[layout.coupler].force();
            for friction in [contact.friction, -contact.friction] {
                let angle = match contact.angle {
                    Value::Constant(angle) => angle,
                    _ => fx.atan2(fy) - friction.atan(),
                };
                let (s, c) = angle.sin_cos();
                places.push(plus(center, [-contact.radius * s, -contact.radius * c]));
            }
        }
        places.push(bodies[layout.coupler].point(mechanism.links[layout.coupler].center));
        places.push(bodies[layout.coupler].point(layout.b.own));
        let end = match layout.end {
            End::Guide(guide) => guide.id,
            End::Pin(pin) => pin.id,
        };
        Self {
            coupler: name(layout.coupler),
            third: name(layout.third),
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
        (self.weight.abs() > PARALLEL).then(|| plus(at.o, scaled(1.0 / self.weight, self.xy)))
    }

    /// Direction from a point to the pole; finite for a pole at infinity too.
    fn from(self, point: [f64; 2], at: &Setting) -> [f64; 2] {
        minus(self.xy, scaled(self.weight, minus(point, at.o)))
    }
}

/// Adds steps of one kind to a drawing; for each: name, start, vector, note.
fn push<const N: usize>(
    draft: &mut Vec<Step>,
    (drawing, kind): (Drawing, VectorKind),
    steps: [(&str, [f64; 2], [f64; 2], String); N],
) {
    let unit = if matches!(kind, VectorKind::Point | VectorKind::Line) { "m" } else { "N" };
    draft.extend(steps.map(|(name, start, vector, note)| Step {
        name: name.to_owned(),
        kind,
        drawing,
        start,
        vector,
        unit,
        note,
    }));
}

/// All steps in order.
pub(crate) fn draw(scene: &Scene<'_>, at: &Setting, found: &Unknowns) -> Construction {
    let mut draft = Vec::new();
    let pole = Pole::of(at);
    loads(&mut draft, scene, at);
    lines(&mut draft, scene, at, pole);
    resolution(&mut draft, scene, at, found, pole);
    polygon(&mut draft, at, found);
    reactions(&mut draft, scene, at, found);
    let (_, crank) = at.crank();
    // A pole far off the paper is of no use to lay forces off from.
    let near = |place: &[f64; 2]| (place[0] - at.a[0]).hypot(place[1] - at.a[1]) < 100.0 * crank;
    let corner = pole.place(at).filter(near).unwrap_or(at.a);
    let title =
        format!("Longitudinal reactions: pole of `{}`, balancing force at {}", scene.coupler, scene.a);
    Construction { title, corner, steps: draft }
}

/// F and its components.
fn loads(draft: &mut Vec<Step>, scene: &Scene<'_>, at: &Setting) {
    let (third, b) = (scene.third, scene.b);
    if at.known != [0.0, 0.0] {
        let (name, what) = if at.slider {
            ("F3", format!("the loads of `{third}` along its guide act on the coupler at {b}"))
        } else {
            let end = scene.end;
            (
                "R3t",
                format!(
                    "moments about {end}: the loads of `{third}` put this across it on the coupler at {b}"
                ),
            )
        };
        push(draft, (Drawing::Mechanism, VectorKind::Load), [(name, at.b, at.known, what)]);
    }
    let (k, couple) = point_of_action(scene, at);
    let rest = if couple == 0.0 { String::new() } else { format!("; a couple of {couple:.6e} N m remains") };
    let what = "the point at which the loads of the coupler are taken".to_owned();
    push(draft, (Drawing::Mechanism, VectorKind::Point), [("K", k, [0.0; 2], what)]);
    let what = format!("all that loads the coupler `{}`, as one force through K{rest}", scene.coupler);
    push(draft, (Drawing::Mechanism, VectorKind::Load), [("F", k, at.force, what)]);
}

/// K: a point of action of a load, if it is on the line of F and off the line KP; and the remaining couple.
fn point_of_action(scene: &Scene<'_>, at: &Setting) -> ([f64; 2], f64) {
    let action = at.action();
    if action.couple != 0.0 || at.force == [0.0, 0.0] {
        return (action.at, action.couple);
    }
    let rod = minus(at.b, at.a);
    let (length, size) = (rod[0].hypot(rod[1]), at.force[0].hypot(at.force[1]));
    let shift = scaled(length / size, at.force);
    let miss = |place: &[f64; 2]| (cross(minus(*place, at.a), at.force) - at.moment_a).abs();
    let real = scene.places.iter().copied().filter(|place| miss(place) <= 1e-9 * length * size);
    let made = [action.at, plus(action.at, shift), minus(action.at, shift)];
    let sound = |place: &[f64; 2]| {
        let (to_a, to_p) = (minus(at.a, *place), Pole::of(at).from(*place, at));
        cross(to_a, to_p).abs() > 0.02 * to_a[0].hypot(to_a[1]) * to_p[0].hypot(to_p[1])
    };
    (real.chain(made).find(sound).unwrap_or(action.at), 0.0)
}

fn lines(draft: &mut Vec<Step>, scene: &Scene<'_>, at: &Setting, pole: Pole) {
    let third = if at.slider { "the normal to the guide" } else { "the line of the rocker" };
    let Some(place) = pole.place(at) else {
        let (crank, length) = at.crank();
        let along = scaled(2.0 * length, crank);
        let first =
            "the line of the crank; it is parallel to the other line, so that the pole P is at infinity"
                .to_owned();
        let second = format!("{third}; P is at infinity along it");
        push(
            draft,
            (Drawing::Mechanism, VectorKind::Line),
            [("OP", at.o, along, first), ("BP", at.b, along, second)],
        );
        return;
    };
    let first = format!("the line of the crank, {}{}", scene.o, scene.a);
    let second = format!("{third} through {}", scene.b);
    let lines = [("OP", at.o, minus(place, at.o), first), ("BP", at.b, minus(place, at.b), second)];
    push(draft, (Drawing::Mechanism, VectorKind::Line), lines);
    let what = format!("the pole: instant center of the coupler `{}`, where both lines meet", scene.coupler);
    push(draft, (Drawing::Mechanism, VectorKind::Point), [("P", place, [0.0; 2], what)]);
}

/// F along KA and KP, and the balancing force.
fn resolution(draft: &mut Vec<Step>, scene: &Scene<'_>, at: &Setting, found: &Unknowns, pole: Pole) {
    let (k, couple) = point_of_action(scene, at);
    let (to_a, to_p) = (minus(at.a, k), pole.from(k, at));
    let turn = cross(to_a, to_p);
    let (mut part_a, mut part_p) = (at.force, [0.0; 2]);
    if turn != 0.0 {
        part_a = scaled(cross(at.force, to_p) / turn, to_a);
        part_p = minus(at.force, part_a);
        let unit = scaled(to_a[0].hypot(to_a[1]) / to_p[0].hypot(to_p[1]), to_p);
        let line = pole.place(at).map_or(unit, |place| minus(place, k));
        let lines = [
            ("KA", k, to_a, format!("from K to {}", scene.a)),
            ("KP", k, line, "from K to the pole".to_owned()),
        ];
        push(draft, (Drawing::Mechanism, VectorKind::Line), lines);
    }
    let (along, _) = at.crank();
    let across = scaled(dot(part_a, perp(along)), perp(along));
    let through_pole = "the part of F along KP: it goes through the pole and does no work".to_owned();
    let moved = format!("the part of F along KA, moved along its line to {}", scene.a);
    let cancelled = "its component across the crank, which the balancing force cancels".to_owned();
    let parts = [
        ("F(KP)", k, part_p, through_pole),
        ("F(KA)", at.a, part_a, moved),
        ("F(KA) across", at.a, across, cancelled),
    ];
    push(draft, (Drawing::Mechanism, VectorKind::Part), parts);
    let rest = if couple == 0.0 { "" } else { " together with the couple of the coupler" };
    let what =
        format!("the balancing force at {}, opposite to the component across the crank{rest}", scene.a);
    push(draft, (Drawing::Mechanism, VectorKind::Balancing), [("Fb", at.a, found.fb, what)]);
}

/// F + Fb + RP = 0, RP = R1 + R3, drawn head to tail.
fn polygon(draft: &mut Vec<Step>, at: &Setting, found: &Unknowns) {
    let after = plus(at.force, found.fb);
    let last = plus(after, found.r1);
    let mut side = |kind, name, start, vector, note: &str| {
        push(draft, (Drawing::Polygon, kind), [(name, start, vector, note.to_owned())]);
    };
    side(VectorKind::Load, "F", [0.0; 2], at.force, "laid off from the pole: the force F");
    side(VectorKind::Balancing, "Fb", at.force, found.fb, "from its end the balancing force");
    let closing = "the closing side: the polar reaction, F + Fb + RP = 0";
    side(VectorKind::Closing, "RP", after, opposite(after), closing);
    let along = "RP resolved: along the crank, the longitudinal reaction R1";
    side(VectorKind::Reaction, "R1", after, found.r1, along);
    let other = "and along the other line, the longitudinal reaction R3; it ends in the pole";
    side(VectorKind::Reaction, "R3", last, found.r3, other);
}

fn reactions(draft: &mut Vec<Step>, scene: &Scene<'_>, at: &Setting, found: &Unknowns) {
    let Scene { third, a, b, o, end, .. } = scene;
    let (ra, rb) = (at_a(found), at_b(at, found));
    let on_b = if at.known == [0.0, 0.0] {
        format!("R3: the pin {b} on the coupler")
    } else {
        format!("R3 with what the loads of `{third}` put there: the pin {b} on the coupler")
    };
    let (name, kind, at_end) = if at.slider {
        ("RG", "guide", scaled(dot(minus(found.r3, scene.third_load), at.line), at.line))
    } else {
        ("RC", "pin", minus(rb, scene.third_load))
    };
    let steps = [
        ("R1", at.a, found.r1, "longitudinal reaction of the crank".to_owned()),
        ("R3", at.b, found.r3, format!("longitudinal reaction of `{third}`")),
        ("RA", at.a, ra, format!("Fb + R1: the pin {a} on the coupler")),
        ("RB", at.b, rb, on_b),
        (
            "RO",
            at.o,
            minus(ra, scene.crank_load),
            format!("RA less the loads of the crank: the pin {o} on the crank"),
        ),
        (name, at.c, at_end, format!("the {kind} {end} on `{third}`")),
    ];
    push(draft, (Drawing::Mechanism, VectorKind::Reaction), steps);
}
