//! The equations of L with the numbers of a position: (2) to (12) with the pole, and without it from moments about A.
//!
//! Axes of L: origin O, y along the guide (across the rocker), so that B is below O; x to the right of it. f1 is the angle of the
//! crank from -y towards x. Fb > 0 acts against the turning of A towards x, R1 > 0 from O to A, R3 > 0 towards -x on the coupler.

use assur_group::Body;
use assur_group::plane::{dot, length, minus};
use assur_kinematics::Linkage;
use assur_mechanism::GROUND;
use assur_number::elementary;
use assur_words::{Text, text, unit};
use assur_working::{AnalyzerWorking, FoundForces};
use assur_worksheet::dyad::{along, minus as less};
use assur_worksheet::{Expr, Point, Sheet, Symbol, WorkedLoad};

use crate::Longitudinal;
use crate::layout::{End, Layout, Setting};

assur_working::inventory::submit! {
    AnalyzerWorking {
        analyzer: Longitudinal::Stable.name(),
        crate_name: env!("CARGO_PKG_NAME"),
        forces: |sheet, linkage, bodies| forces(sheet, linkage, bodies, Longitudinal::Stable),
    }
}

assur_working::inventory::submit! {
    AnalyzerWorking {
        analyzer: Longitudinal::Published.name(),
        crate_name: env!("CARGO_PKG_NAME"),
        forces: |sheet, linkage, bodies| forces(sheet, linkage, bodies, Longitudinal::Published),
    }
}

/// |cos f1| at or below this leaves no digits of the pole that are worth writing.
const PARALLEL: f64 = 1e-9;

struct Unknowns {
    fb: Expr,
    r1: Expr,
    r3: Expr,
}

/// A force on the coupler in the axes of L, at a point; with it a moment, N m, counter-clockwise.
struct Acts {
    /// Name of the point of action.
    name: Symbol,
    at: [Expr; 2],
    force: [Expr; 2],
    moment: Expr,
}

struct Axes {
    x: [Expr; 2],
    y: [Expr; 2],
    o: Point,
    a: [Expr; 2],
    b: [Expr; 2],
    r1: Expr,
    f1: Expr,
}

fn forces(
    sheet: &mut Sheet,
    linkage: &Linkage,
    bodies: &[Body<f64>],
    form: Longitudinal,
) -> Result<FoundForces, Text> {
    let layout = Layout::of(linkage)?;
    sheet.section(text!("force-longitudinal-working"));
    let axes = Axes::of(sheet, &layout, bodies);
    let (acts, third) = loads(sheet, &layout, &axes);
    let total = [0, 1].map(|axis| acts.iter().fold(Expr::zero(), |sum, one| sum + &one.force[axis]));
    let total = if acts.len() == 1 { total } else { written(sheet, &Symbol::from("F"), &total) };
    let parallel = axes.f1.cos().value().abs() <= PARALLEL;
    if parallel && form == Longitudinal::Published {
        return Err(text!("force-longitudinal-working-parallel"));
    }
    let mut found = None;
    if parallel {
        sheet.note(text!("force-longitudinal-working-parallel"));
    } else {
        found = Some(with_pole(sheet, &axes, &acts, (&total, arc(linkage, &layout))));
    }
    if form == Longitudinal::Stable {
        found = Some(without_pole(sheet, &axes, &acts, &total));
    }
    let found = found.ok_or_else(|| text!("force-longitudinal-working-parallel"))?;
    Ok(reactions(sheet, &layout, &axes, (&found, &third)))
}

/// Both components of a vector in the axes of L, `F_x` and `F_y`.
fn written(sheet: &mut Sheet, of: &Symbol, parts: &[Expr; 2]) -> [Expr; 2] {
    let mut part = |axis: &'static str, value: &Expr| sheet.work_unless_zero(of.clone().of(axis), value, "N");
    [part("x", &parts[0]), part("y", &parts[1])]
}

impl Axes {
    /// Writes the axes, the crank angle and the places of A and B.
    fn of(sheet: &mut Sheet, layout: &Layout, bodies: &[Body<f64>]) -> Self {
        sheet.note(text!("force-longitudinal-working-axes", angle = &Symbol::from("φ").of(1)));
        let setting = Setting::of(layout, bodies, &vec![assur_group::Wrench::ZERO; bodies.len()]);
        let [o, a, b] =
            [(layout.crank, layout.o.own), (layout.coupler, layout.a.own), (layout.coupler, layout.b.own)]
                .map(|(link, at)| sheet.point(link, at));
        // The direction in which B is below O.
        let down = dot(minus(setting.b, setting.o), assur_group::plane::perp(setting.line));
        let sign = |v: [Expr; 2], positive: bool| if positive { v } else { v.map(|part| -part) };
        let x = match &layout.end {
            End::Guide(guide) => {
                // The line 3 is the guide's direction turned by a right angle.
                let [tx, ty] = sheet.guide_of(guide).t;
                sign([-ty, tx], down < 0.0)
            }
            End::Pin(pin) => {
                let c = sheet.point(GROUND, pin.at);
                let [u, v] = b.from(&c, 0);
                let length = sheet.work(
                    Symbol::from("l").of(&c.name).of(&b.name),
                    &(u.squared() + v.squared()).sqrt(),
                    "m",
                );
                sign([u / &length, v / &length], down < 0.0)
            }
        };
        let [x, y] = x;
        let mut unit_vector = |axis: &'static str, part| sheet.work(Symbol::from("i").of(axis), &part, "");
        let x = [unit_vector("x", x), unit_vector("y", y)];
        let y = [-&x[1], x[0].clone()];
        let mut place = |point: &Point| {
            let from = point.from(&o, 0);
            [("X", &x), ("Y", &y)].map(|(letter, axis)| {
                sheet.work(Symbol::from(letter).of(&point.name), &along(axis, &from), "m")
            })
        };
        let (at_a, at_b) = (place(&a), place(&b));
        let r1 = sheet.work(Symbol::from("r").of(1), &(at_a[0].squared() + at_a[1].squared()).sqrt(), "m");
        let f1 = sheet.work(Symbol::from("φ").of(1), &at_a[0].atan2(&-&at_a[1]), "rad");
        sheet.work(Symbol::from("φ").of(1).of(unit("deg")), &(&f1 * Expr::number(180.0) / Expr::pi()), "deg");
        Self { x, y, o, a: at_a, b: at_b, r1, f1 }
    }

    /// A vector of the ground in these axes.
    fn turned(&self, v: &[Expr; 2]) -> [Expr; 2] {
        [along(&self.x, v), along(&self.y, v)]
    }

    /// A vector of these axes in the axes of the ground.
    fn back(&self, [u, v]: &[Expr; 2]) -> [Expr; 2] {
        [0, 1].map(|axis| u * &self.x[axis] + v * &self.y[axis])
    }
}

/// The applied loads of a link; reactions that other groups have handed on are none.
fn applied(sheet: &Sheet, link: usize) -> Vec<WorkedLoad> {
    sheet.loads_on(link).iter().filter(|load| load.applied).cloned().collect()
}

/// The moment of some loads about a point.
fn moment_about(point: &Point, loads: &[WorkedLoad]) -> Expr {
    let of = |load: &WorkedLoad| {
        let force = load.force.as_ref().map(|(force, at)| at.moment_about(point, force));
        force.unwrap_or_else(Expr::zero) + &load.moment
    };
    loads.iter().map(of).fold(Expr::zero(), |sum, moment| sum + moment)
}

/// Writes each force on the coupler in the axes of L (eq. 2), and what the loads of the third link put on it at B,
/// along y.
fn loads(sheet: &mut Sheet, layout: &Layout, axes: &Axes) -> (Vec<Acts>, Expr) {
    sheet.note(text!("force-longitudinal-working-loads"));
    let own = applied(sheet, layout.coupler);
    let many = own.len() > 1;
    let mut acts = Vec::new();
    for load in own {
        let Some((force, at)) = load.force else {
            let zero = || [Expr::zero(), Expr::zero()];
            let name = Symbol::from("M");
            acts.push(Acts { name, at: axes.a.clone(), force: zero(), moment: load.moment });
            continue;
        };
        let of = if many { Symbol::from("F").of(&at.name) } else { Symbol::from("F") };
        let force = written(sheet, &of, &axes.turned(&force));
        let from = axes.turned(&at.from(&axes.o, 0));
        let place = ["X", "Y"].map(|letter| Symbol::from(letter).of(&at.name));
        let [x, y] = place;
        let place = [sheet.work(x, &from[0], "m"), sheet.work(y, &from[1], "m")];
        acts.push(Acts { name: at.name, at: place, force, moment: load.moment });
    }
    let third = third(sheet, layout, axes);
    if !third.is_zero() {
        let name = sheet.place_name(layout.coupler, layout.b.own);
        acts.push(Acts {
            name,
            at: axes.b.clone(),
            force: [Expr::zero(), third.clone()],
            moment: Expr::zero(),
        });
    }
    (acts, third)
}

/// What the loads of the third link put on the coupler at B, along y: of a slider their part along the guide, of a rocker that of
/// their moment about C.
fn third(sheet: &mut Sheet, layout: &Layout, axes: &Axes) -> Expr {
    let all = applied(sheet, layout.third);
    let symbol = Symbol::from("S").of(3);
    match &layout.end {
        End::Guide(_) => {
            let forces = all.iter().filter_map(|load| load.force.as_ref());
            let sum = forces.fold(Expr::zero(), |sum, (force, _)| sum + along(&axes.y, force));
            sheet.work_unless_zero(symbol, &sum, "N")
        }
        End::Pin(pin) => {
            let c = sheet.point(GROUND, pin.at);
            let moment = moment_about(&c, &all);
            // From C to B, along x or against it.
            let reach = &axes.b[0] - along(&axes.x, &c.from(&axes.o, 0));
            sheet.work_unless_zero(symbol, &(moment / reach), "N")
        }
    }
}

/// Eqs. (3) to (11): the moment about the pole, the balancing force, the longitudinal reactions.
fn with_pole(
    sheet: &mut Sheet,
    axes: &Axes,
    acts: &[Acts],
    ([fx, fy], arc): (&[Expr; 2], Option<Arc>),
) -> Unknowns {
    let (sin, cos) = (axes.f1.sin(), axes.f1.cos());
    sheet.note(text!("force-longitudinal-working-pole"));
    let yp = sheet.work(Symbol::from("Y").of("P"), &axes.b[1], "m");
    let xp = sheet.work(Symbol::from("X").of("P"), &-(&yp * &sin / &cos), "m");
    let ap = sheet.work(Symbol::from("l").of("AP"), &-(&yp / &cos + &axes.r1), "m");
    sheet.note(text!("force-longitudinal-working-moment"));
    let mut moment = Expr::zero();
    for one in acts {
        if one.force.iter().all(Expr::is_zero) {
            moment = moment - &one.moment;
            continue;
        }
        let of = |letter: &'static str| {
            let symbol = Symbol::from(letter).of(2);
            if acts.len() == 1 { symbol } else { symbol.of(&one.name) }
        };
        let y2 = sheet.work_unless_zero(of("Y"), &(&one.at[1] - &yp), "m");
        let x2 = sheet.work_unless_zero(of("X"), &(&xp - &one.at[0]), "m");
        moment = moment + &one.force[1] * x2 + &one.force[0] * y2 - &one.moment;
    }
    if let (Some(arc), [one]) = (arc, acts) {
        closed(sheet, axes, one, &arc);
    }
    let mc = sheet.work(Symbol::from("M").of("c"), &moment, "N·m");
    let mb = sheet.work(Symbol::from("M").of("b"), &(mc * &axes.r1 / ap), "N·m");
    let fb = sheet.work(Symbol::from("F").of("b"), &(mb / &axes.r1), "N");
    sheet.note(text!("force-longitudinal-working-equilibrium"));
    let unknown = |number: usize| Expr::symbol(Symbol::from("R").of(number), f64::NAN);
    sheet.equation(fy - &fb * &sin - unknown(1) * &cos, Expr::zero());
    sheet.equation(fx - &fb * &cos + unknown(1) * &sin - unknown(3), Expr::zero());
    let r1 = sheet.work(Symbol::from("R").of(1), &((fy - &fb * &sin) / &cos), "N");
    let r3 = sheet.work(Symbol::from("R").of(3), &(fx - &fb * &cos + &r1 * &sin), "N");
    Unknowns { fb, r1, r3 }
}

/// An arc whose center N lies on the line BA beyond A, on the rod of a slider-crank: what eqs. (8) and (9) are for.
struct Arc {
    /// AN, AB and the radius, m.
    r2: f64,
    b: f64,
    radius: f64,
}

/// The only contact of the coupler, if its center lies so.
fn arc(linkage: &Linkage, layout: &Layout) -> Option<Arc> {
    let own = linkage.mechanism.loads.iter().filter_map(|load| load.kind.contact());
    let mut own = own.filter(|contact| contact.center.link == layout.coupler);
    let contact = own.next().filter(|_| own.next().is_none() && matches!(layout.end, End::Guide(_)))?;
    let [n, to_a] = [minus(contact.center.at, layout.a.own), minus(layout.a.own, layout.b.own)];
    let [r2, b] = [n, to_a].map(length);
    let beyond = dot(n, to_a) > 0.0 && assur_group::plane::cross(n, to_a).abs() <= PARALLEL * r2 * b;
    beyond.then_some(Arc { r2, b, radius: contact.radius })
}

/// Eqs. (8) and (9) as L prints them, by the angles alone; of a guide that leads past O there are none.
fn closed(sheet: &mut Sheet, axes: &Axes, k: &Acts, arc: &Arc) {
    let [[xa, ya], [xb, yb], [xk, yk]] = [&axes.a, &axes.b, &k.at].map(|at| [at[0].value(), at[1].value()]);
    if xb.abs() > PARALLEL * arc.b {
        return;
    }
    let [x, y] = [xa + (xa - xb) * arc.r2 / arc.b - xk, ya + (ya - yb) * arc.r2 / arc.b - yk];
    sheet.note(text!("force-longitudinal-working-closed", length = &Symbol::from("r").of(2)));
    let mut given = |symbol: Symbol, value, unit| sheet.given(symbol, value, unit, Text::default());
    let r2 = given(Symbol::from("r").of(2), arc.r2, "m");
    let b = given("b".into(), arc.b, "m");
    let radius = given("R".into(), arc.radius, "m");
    let a = given("a".into(), elementary::atan2(x, y), "rad");
    let (sin, cos) = (axes.f1.sin(), axes.f1.cos());
    let one = || Expr::number(1.0);
    let sin_rod = sheet.work(Symbol::from("sin").of("ψ"), &(&axes.r1 * &sin / &b), "");
    let cos_rod = sheet.work(Symbol::from("cos").of("ψ"), &(one() - sin_rod.squared()).sqrt(), "");
    let y2 = (&r2 + &b) * &cos_rod - &radius * a.cos();
    sheet.work(Symbol::from("Y").of("KP"), &y2, "m");
    let x2 =
        (&axes.r1 * &cos + &b * cos_rod) * &sin / cos - &axes.r1 * sin * (one() + r2 / b) + radius * a.sin();
    sheet.work(Symbol::from("X").of("KP"), &x2, "m");
    sheet.note(text!("force-longitudinal-working-closed-same"));
}

/// The same unknowns from moments about A, which no pole at infinity disturbs.
fn without_pole(sheet: &mut Sheet, axes: &Axes, acts: &[Acts], [fx, fy]: &[Expr; 2]) -> Unknowns {
    let (sin, cos) = (axes.f1.sin(), axes.f1.cos());
    sheet.note(text!("force-longitudinal-working-without-pole"));
    let about = |one: &Acts| {
        let [u, v] = less(&one.at, &axes.a);
        u * &one.force[1] - v * &one.force[0] + &one.moment
    };
    let moment = acts.iter().map(about).fold(Expr::zero(), |sum, moment| sum + moment);
    let moment = sheet.work_unless_zero(Symbol::from("M").of("A"), &moment, "N·m");
    let r3 = sheet.work(Symbol::from("R").of(3).of("A"), &(moment / (&axes.a[1] - &axes.b[1])), "N");
    let fb = sheet.work(Symbol::from("F").of("b").of("A"), &((fx - &r3) * &cos + fy * &sin), "N");
    let r1 = sheet.work(Symbol::from("R").of(1).of("A"), &((&r3 - fx) * &sin + fy * &cos), "N");
    Unknowns { fb, r1, r3 }
}

/// Eq. (12), and the forces of the pairs in the axes of the ground.
fn reactions(sheet: &mut Sheet, layout: &Layout, axes: &Axes, (found, s): (&Unknowns, &Expr)) -> FoundForces {
    let (sin, cos) = (axes.f1.sin(), axes.f1.cos());
    let Unknowns { fb, r1, r3 } = found;
    sheet.note(text!("force-longitudinal-working-reactions"));
    sheet.work(Symbol::from("R").of("A"), &(fb.squared() + r1.squared()).sqrt(), "N");
    sheet.work(Symbol::from("R").of("B"), r3, "N");
    let sum = |loads: &[WorkedLoad]| {
        let forces = loads.iter().filter_map(|load| load.force.as_ref());
        forces
            .fold([Expr::zero(), Expr::zero()], |sum, (force, _)| [&sum[0] + &force[0], &sum[1] + &force[1]])
    };
    let (on_crank, on_third) = (applied(sheet, layout.crank), applied(sheet, layout.third));
    let at_a = axes.back(&[r1 * &sin - fb * &cos, -(fb * &sin) - r1 * &cos]);
    let at_b = axes.back(&[-r3, s.clone()]);
    let (end, at_end) = match &layout.end {
        End::Guide(guide) => {
            let across = -(r3 + along(&axes.x, &sum(&on_third)));
            (guide.id, axes.back(&[across, Expr::zero()]))
        }
        End::Pin(pin) => (pin.id, less(&at_b, &sum(&on_third))),
    };
    let at_o = less(&at_a, &sum(&on_crank));
    let all = [
        (layout.a.id, layout.coupler, at_a),
        (layout.b.id, layout.coupler, at_b),
        (layout.o.id, layout.crank, at_o),
        (end, layout.third, at_end),
    ];
    let reactions = all.into_iter().map(|(pair, on, force)| {
        let of = sheet.acting(pair, on).of(text!("force-longitudinal-working-of"));
        (pair, on, sheet.components("R", of, &force, "N"))
    });
    let reactions = reactions.collect();
    let own = moment_about(&axes.o, &on_crank);
    let symbol = Symbol::from("M").of(text!("force-longitudinal-working-of"));
    let balancing = sheet.work(symbol, &-(fb * &axes.r1 + own), "N·m");
    FoundForces { reactions, balancing }
}
