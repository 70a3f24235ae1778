//! The loads of each link in this position.

use assur_force::{Cause, Loads};
use assur_group::{Wrench, plane::direction};
use assur_mechanism::{Brake, Contact, Direction, Force, GROUND, Inertia, LinkId, LoadKind, Place, Spring};
use assur_words::{Text, name, text};
use assur_worksheet::{Expr, Point, Symbol, WorkedLoad};

use crate::Work;

impl Work<'_> {
    /// Writes every load and adds it to its link.
    pub(crate) fn loads(&mut self, loads: &Loads) {
        let mut each: Vec<(Cause, usize, Wrench<f64>)> = Vec::new();
        loads.by_cause(&self.state, self.bodies, &mut |cause, link, wrench| {
            // Force and moment of one inertia load are separate entries, and so are the two ends of a spring.
            if each.last().is_none_or(|(last, ..)| *last != cause) {
                each.push((cause, link, Wrench::ZERO));
            }
            if let Some((_, first, sum)) = each.last_mut().filter(|(_, first, _)| *first == link) {
                debug_assert_eq!(*first, link);
                sum.add_at([0.0; 2], wrench.force(), wrench.m);
            }
        });
        self.sheet.section(text!("working-loads"));
        if (self.state.speed, self.state.acceleration) != (0.0, 0.0) {
            let [_, w, e] = self.sheet.units.input;
            self.sheet.given("ω", self.state.speed, w, text!("working-speed"));
            if self.drive.is_none() {
                self.sheet.given("ε", self.state.acceleration, e, text!("working-acceleration"));
            }
        }
        let mechanism = &self.linkage.mechanism;
        let mut reduced = false;
        for (cause, link, wrench) in each {
            if matches!(cause, Cause::Inertia(_)) && !reduced {
                // Inertia loads come last and need the acceleration.
                self.equation_of_motion();
                self.sheet.section(text!("working-inertia-loads"));
                reduced = true;
            }
            let name = Text::from(cause.name(mechanism));
            self.sheet.note(text!("working-load-of", load = &name));
            match cause {
                Cause::Weight(link) => self.weight(link),
                Cause::Inertia(link) => {
                    let before = self.written();
                    self.inertia(link);
                    if self.written() == before {
                        self.sheet.note(text!("working-none-here"));
                    }
                }
                Cause::Load(id) => match &mechanism.loads[id].kind {
                    LoadKind::Force(force) => self.point_force(&name, force, &wrench),
                    LoadKind::Moment(_) => self.moment(&name, link, wrench.m),
                    LoadKind::Brake(brake) => self.brake(&name, brake, wrench.m),
                    LoadKind::Spring(spring) => self.spring(&name, spring),
                    LoadKind::Contact(contact) => {
                        self.contact(&name, contact, loads.contact(id, &self.state), &wrench);
                    }
                },
            }
        }
        // Massless links have no inertia loads.
        if !reduced {
            self.equation_of_motion();
        }
    }

    /// How many entries the last section has.
    fn written(&self) -> usize {
        self.sheet.sections.last().map_or(0, |section| section.entries.len())
    }

    /// Applies a moment to a link; the ground bears any.
    pub(crate) fn turn(&mut self, link: LinkId, moment: Expr) {
        if link != GROUND {
            self.sheet.load(link, WorkedLoad { force: None, moment, applied: true });
        }
    }

    pub(crate) fn apply(&mut self, link: LinkId, force: [Expr; 2], at: Point) {
        self.sheet.load(link, WorkedLoad { force: Some((force, at)), moment: Expr::zero(), applied: true });
    }

    pub(crate) fn mass(&mut self, link: LinkId) -> Expr {
        let found = &self.linkage.mechanism.links[link];
        let symbol = Symbol::from("m").of(self.sheet.body_name(link));
        if found.mass == 0.0 {
            return Expr::zero();
        }
        self.sheet.given(symbol, found.mass, "kg", text!("working-mass"))
    }

    /// The moment of inertia of a link, and its derivative with respect to the coordinate; zero where there is none.
    pub(crate) fn own_inertia(&mut self, link: LinkId) -> [Expr; 2] {
        let found = self.linkage.mechanism.links[link].inertia.clone();
        let symbol = Symbol::from("I").of(self.sheet.body_name(link));
        match &found {
            _ if found.is_none() => [Expr::zero(), Expr::zero()],
            Inertia::Constant(inertia) => {
                [self.sheet.given(symbol, *inertia, "kg·m²", text!("working-own-inertia")), Expr::zero()]
            }
            Inertia::Varying(law) => {
                let [inertia, slope] = law.at(self.state.coordinate);
                let what = text!("working-inertia-here", formula = name(law.formula.text().to_owned()));
                let inertia = self.sheet.given(symbol, inertia, "kg·m²", what);
                let symbol = Symbol::from("I").prime(1).of(self.sheet.body_name(link));
                let unit = if self.linkage.kind().is_angle() { "kg·m²/rad" } else { "kg·m" };
                [inertia, self.sheet.given(symbol, slope, unit, text!("working-inertia-slope-here"))]
            }
        }
    }

    fn weight(&mut self, link: LinkId) {
        let m = self.mass(link);
        let gravity = self.linkage.mechanism.gravity.unwrap_or_default();
        let g = [0, 1].map(|i| {
            if gravity[i] == 0.0 {
                return Expr::zero();
            }
            let symbol = Symbol::from("g").of(["x", "y"][i]);
            self.sheet.given(symbol, gravity[i], "m/s²", text!("working-gravity"))
        });
        let at = self.sheet.point(link, self.linkage.mechanism.links[link].center);
        let tag = self.sheet.body_name(link);
        let force = self.sheet.components("G", tag, &[&m * &g[0], &m * &g[1]], "N");
        self.apply(link, force, at);
    }

    fn inertia(&mut self, link: LinkId) {
        let found = &self.linkage.mechanism.links[link];
        let center = found.center;
        let m = self.mass(link);
        let at = self.sheet.point(link, center);
        let tag = Symbol::from(text!("working-of-inertia")).of(self.sheet.body_name(link));
        let w = self.sheet.find("ω").unwrap_or_else(Expr::zero);
        let e = if self.drive.is_none() && self.state.acceleration == 0.0 {
            Expr::zero()
        } else {
            self.sheet.find("ε").unwrap_or_else(Expr::zero)
        };
        let by_time = |first: &Expr, second: &Expr| second * w.squared() + first * &e;
        if !m.is_zero() {
            let a = [0, 1].map(|i| by_time(&at.pf[1][i], &at.pf[2][i]));
            let a = self.sheet.components("a", Symbol::from("t").of(&at.name), &a, "m/s²");
            let force = self.sheet.components("F", &tag, &[-(&m * &a[0]), -(&m * &a[1])], "N");
            self.apply(link, force, at);
        }
        let [_, first, second] = self.sheet.angle(link);
        let [i, slope] = self.own_inertia(link);
        if !i.is_zero() {
            let changing = slope * &first * w.squared() / Expr::number(2.0);
            let moment = -(i * by_time(&first, &second)) - changing;
            let moment = self.sheet.work_unless_zero(Symbol::from("M").of(tag), &moment, "N·m");
            self.turn(link, moment);
        }
    }

    fn point_force(&mut self, name: &Text, force: &Force, wrench: &Wrench<f64>) {
        let link = force.at.link;
        let at = self.sheet.point(link, force.at.at);
        let toward = match force.direction {
            Direction::Ground(angle) => {
                let angle =
                    self.sheet.given(Symbol::from("α").of(name), angle, "rad", text!("working-direction"));
                [angle.cos(), angle.sin()]
            }
            Direction::Link(angle) => {
                let what = text!("working-direction-in-link");
                let own = self.sheet.fixed_angle(Symbol::from("α").of(name), angle, what);
                let angle = &self.sheet.angle(link)[0] + own;
                [angle.cos(), angle.sin()]
            }
            Direction::AgainstMotion => {
                let [x, y] = at.pf[1].clone();
                let length = (x.squared() + y.squared()).sqrt();
                let back = [-(x / &length), -(y / &length)];
                if self.state.speed < 0.0 { back.map(|part| -part) } else { back }
            }
        };
        let numbers = toward.each_ref().map(Expr::value);
        let size = wrench.fx * numbers[0] + wrench.fy * numbers[1];
        if !size.is_finite() || (wrench.fx == 0.0 && wrench.fy == 0.0) {
            self.sheet.note(text!("working-none-here"));
            return;
        }
        let size = self.sheet.given(Symbol::from("F").of(name), size, "N", text!("working-size-here"));
        let force = self.sheet.components("F", name, &[&size * &toward[0], &size * &toward[1]], "N");
        self.apply(link, force, at);
    }

    fn moment(&mut self, name: &Text, link: LinkId, value: f64) {
        let symbol = Symbol::from("M").of(name);
        let what = text!("working-on-link-here", link = self.sheet.body_name(link));
        let moment = self.sheet.given(symbol, value, "N·m", what);
        self.turn(link, moment);
    }

    /// M = -f k P R against the rotation, from the force P on the lever.
    fn brake(&mut self, name: &Text, brake: &Brake, moment: f64) {
        let unit_moment = brake.moment_of_unit_force();
        let size = moment / unit_moment;
        if moment == 0.0 || !size.is_finite() {
            return self.moment(name, brake.link, moment);
        }
        let of = |letter: &'static str| Symbol::from(letter).of(name);
        let f = self.sheet.given(of("f"), brake.friction, "", text!("working-friction"));
        let k = self.sheet.given(of("k"), brake.lever, "", text!("working-brake-lever"));
        let p = self.sheet.given(of("P"), size.abs(), "N", text!("working-brake-force"));
        let r = self.sheet.given(of("R"), brake.radius, "m", text!("working-radius"));
        let resisting = f * k * p * r;
        let signed = if moment < 0.0 { -resisting } else { resisting };
        let moment = self.sheet.work(of("M"), &signed, "N·m");
        self.turn(brake.link, moment);
    }

    fn spring(&mut self, name: &Text, spring: &Spring) {
        let of = |letter: &'static str| Symbol::from(letter).of(name);
        let [p, q] = spring.ends.map(|Place { link, at }| self.sheet.point(link, at));
        let d = q.from(&p, 0);
        let length = self.sheet.work(of("L"), &(d[0].squared() + d[1].squared()).sqrt(), "m");
        if length.value() == 0.0 {
            self.sheet.note(text!("working-spring-of-no-length"));
            return;
        }
        let stiffness = self.sheet.given(of("c"), spring.stiffness, "N/m", text!("working-stiffness"));
        let symbol = Symbol::from("L").of(0).of(name);
        let free = self.sheet.given(symbol, spring.length, "m", text!("working-free-length"));
        let mut tension = stiffness * (&length - free);
        if spring.damping != 0.0 {
            let damping = self.sheet.given(of("k"), spring.damping, "N·s/m", text!("working-damping"));
            let v = q.from(&p, 1);
            let rate = (&d[0] * &v[0] + &d[1] * &v[1]) / &length;
            let w = self.sheet.find("ω").unwrap_or_else(Expr::zero);
            tension = tension + damping * rate * w;
        }
        let tension = self.sheet.work(of("T"), &tension, "N");
        let pull = [&tension * &d[0] / &length, &tension * &d[1] / &length];
        let pull = self.sheet.components("F", name, &pull, "N");
        let back = pull.each_ref().map(|part| -part);
        for (end, force, at) in [(spring.ends[0], pull, p), (spring.ends[1], back, q)] {
            if end.link != 0 {
                self.apply(end.link, force, at);
            }
        }
    }

    /// K = N + R (-sin a, -cos a); F along (sin a, cos a), friction along (cos a, -sin a).
    fn contact(&mut self, name: &Text, contact: &Contact, found: Option<[f64; 2]>, wrench: &Wrench<f64>) {
        let [angle, friction] = found.unwrap_or_default();
        let link = contact.center.link;
        let of = |letter: &'static str| Symbol::from(letter).of(name);
        let center = self.sheet.point(link, contact.center.at);
        let a = self.sheet.fixed_angle(of("α"), angle, text!("working-where-the-force-acts"));
        let radius = self.sheet.given(of("R"), contact.radius, "m", text!("working-radius"));
        let f = if friction == 0.0 {
            Expr::zero()
        } else {
            self.sheet.given(of("f"), friction, "", text!("working-friction"))
        };
        let [c, s]: [f64; 2] = direction(angle);
        let along = [s + friction * c, c - friction * s];
        let size =
            (wrench.fx * along[0] + wrench.fy * along[1]) / (along[0] * along[0] + along[1] * along[1]);
        let size = self.sheet.given(Symbol::from("F").of(name), size, "N", text!("working-size-here"));
        let [xn, yn] = &center.pf[0];
        let place = [xn - &radius * a.sin(), yn - &radius * a.cos()];
        let k = of("K");
        let place = self.sheet.vector(&k, 0, &place);
        let [first, second] = [1, 2].map(|order| self.sheet.under(link, &center, &place, order));
        let first = self.sheet.vector(&k, 1, &first);
        let force = [&size * (a.sin() + &f * a.cos()), &size * (a.cos() - &f * a.sin())];
        let force = self.sheet.components("F", name, &force, "N");
        self.apply(link, force, Point { name: k, pf: [place, first, second] });
    }
}
