//! The working of any group from its pairs alone: J u' = b, J u'' = b, and equilibrium of each link.
//!
//! The solution is given; each equation shows its two sides with the solution put in.

use assur_force::{UnitBalance, drive_of_pair};
use assur_group::plane::{length, minus};
use assur_group::{Pair, PairGeometry, Wrench};
use assur_words::{Text, text};
use assur_worksheet::dyad::{across, along};
use assur_worksheet::{Expr, Point, Pose, Symbol, WorkedLoad};

use crate::Work;

impl Work<'_> {
    /// Writes places and derivatives of the links as given, then both sides of the equations of each pair.
    pub(crate) fn general_motion(&mut self, group: usize) {
        let frame = self.linkage.structure.groups[group].frame.clone();
        let places = 3 * frame.links.len();
        self.sheet.note(text!("working-linear-system", equations = places));
        for &link in &frame.links {
            self.given_pose(link);
        }
        for pair in frame.pairs() {
            self.sheet.note(text!("working-pair-agrees", pair = self.sheet.pair_name(pair.id)));
            match pair.geometry {
                PairGeometry::Pin { at_a, at_b } => {
                    let place = self.bodies[pair.a].point(at_a);
                    self.side(pair.a, at_a, place);
                    self.side(pair.b, at_b, place);
                }
                PairGeometry::Slide { .. } => self.slide_sides(pair),
            }
            if frame.driven.iter().any(|driven| driven.pair.id == pair.id) {
                self.follows_coordinate(pair);
            }
        }
    }

    /// Writes what a driven pair adds: its angle or displacement, which is the coordinate, with the derivatives 1 and 0.
    fn follows_coordinate(&mut self, pair: &Pair) {
        let tag = self.sheet.pair_name(pair.id);
        self.sheet.note(text!("working-follows-coordinate", pair = &tag));
        let PairGeometry::Slide { point, through, angle, .. } = pair.geometry else {
            let [a, b] = [pair.a, pair.b].map(|link| self.sheet.angle(link));
            for (order, unit) in self.sheet.units.angle.into_iter().enumerate() {
                self.sheet.work(Symbol::from("θ").prime(order).of(&tag), &(&a[order] - &b[order]), unit);
            }
            return;
        };
        let [on_a, on_b] = [(pair.a, point), (pair.b, through)].map(|(link, at)| self.sheet.point(link, at));
        let t = self.sheet.guide(pair.id, pair.b, angle).t;
        let d = |order: usize| [0, 1].map(|i| &on_a.pf[order][i] - &on_b.pf[order][i]);
        // s' = t (A' - B'), s'' = t (A'' - B'') + w² s: the point of b turns with its line.
        let w = self.sheet.angle(pair.b)[1].clone();
        let way = [along(&t, &d(0)), along(&t, &d(1)), along(&t, &d(2)) + w.squared() * along(&t, &d(0))];
        for ((order, way), unit) in way.iter().enumerate().zip(self.sheet.units.length) {
            self.sheet.work(Symbol::from("s").prime(order).of(&tag), way, unit);
        }
    }

    fn given_pose(&mut self, link: usize) {
        let body = self.bodies[link];
        let named = crate::names::of(self.linkage).places;
        let at = named.iter().find(|(of, ..)| *of == link).map_or([0.0; 2], |(_, at, _)| *at);
        let (name, tag) = (self.sheet.place_name(link, at), self.sheet.body_name(link));
        let (units, angle) = (self.sheet.units.length, self.sheet.units.angle);
        let arm = body.arm(at);
        let values = [body.point(at), body.first(arm), body.second(arm)];
        let pf = [0, 1, 2].map(|order| {
            [0, 1].map(|i| {
                let symbol = Symbol::from(["x", "y"][i]).prime(order).of(&name).of(&tag);
                self.sheet.given(symbol, values[order][i], units[order], text!("working-solution"))
            })
        });
        let rates = [body.s.atan2(body.c), body.w1, body.w2];
        let phi = [0, 1, 2].map(|order| {
            let symbol = Symbol::from("φ").prime(order).of(&tag);
            self.sheet.given(symbol, rates[order], angle[order], text!("working-solution"))
        });
        let base = Point { name, pf };
        self.sheet.set_pose(link, Pose { base, at, phi });
    }

    /// Writes PF0, PF1, PF2 of a place as a point of a body.
    fn side(&mut self, body: usize, at: [f64; 2], place: [f64; 2]) -> [[Expr; 2]; 3] {
        let name = self.sheet.place_name(body, at).of(self.sheet.body_name(body));
        let Some(pose) = self.sheet.pose(body) else { return self.sheet.point(body, at).pf };
        // The place whose motion is given as the solution is not written again.
        if length(minus(at, pose.at)) == 0.0 {
            return pose.base.pf.clone();
        }
        let place = [0, 1].map(|i| {
            let symbol = Symbol::from(["x", "y"][i]).of(0).of(&name);
            self.sheet.given(symbol, place[i], "m", text!("working-place-in-solution"))
        });
        let pf = self.sheet.carried_by(body, at, &place);
        let mut order = 0;
        pf.map(|xy| {
            let written = self.sheet.vector(&name, order, &xy);
            order += 1;
            written
        })
    }

    /// Writes the equations of a slide: the point of `a` is on the line of `b`, and both have the same rotation.
    fn slide_sides(&mut self, pair: &Pair) {
        let PairGeometry::Slide { point, through, angle, tilt } = pair.geometry else { return };
        let place = self.bodies[pair.a].point(point);
        let on_a = self.side(pair.a, point, place);
        let on_b = self.side(pair.b, through, self.bodies[pair.b].point(through));
        let t = self.sheet.guide(pair.id, pair.b, angle).t;
        let tag = self.sheet.pair_name(pair.id);
        let units = (self.sheet.units.length, self.sheet.units.angle);
        let carrier = self.sheet.angle(pair.b);
        for (of, pf) in [("a", &on_a), ("b", &on_b)] {
            self.sheet.work(Symbol::from("n").of(of).of(&tag), &across(&t, &pf[0]), units.0[0]);
        }
        // n (A' - B') = w s and n (A'' - B'') = e s + 2 w t (A' - B') - w² n (A - B), where the last term is zero.
        let d = |order: usize| [0, 1].map(|i| &on_a[order][i] - &on_b[order][i]);
        let (d0, d1, d2) = (d(0), d(1), d(2));
        let sides = [
            (1, across(&t, &d1), &carrier[1] * along(&t, &d0)),
            (2, across(&t, &d2), {
                let two = Expr::number(2.0);
                let vr = along(&t, &d1);
                &carrier[2] * along(&t, &d0) + two * &carrier[1] * vr
            }),
        ];
        for (order, left, right) in sides {
            let side = |of: Text| Symbol::from("b").of(order).of(of).of(&tag);
            self.sheet.work(side(text!("working-left")), &left, units.0[order]);
            self.sheet.work(side(text!("working-right")), &right, units.0[order]);
        }
        let tilt = self.sheet.tilt(pair.id, pair.a, tilt);
        let what = text!("worksheet-guide-angle", link = self.sheet.body_name(pair.b));
        let gamma = self.sheet.fixed_angle(Symbol::from("γ").of(&tag), angle, what);
        let turn = Symbol::from("θ").of(&tag);
        self.sheet.work(&turn, &(&carrier[0] + gamma + tilt), units.1[0]);
        for (order, rate) in carrier.iter().enumerate().skip(1) {
            self.sheet.work(turn.clone().prime(order), rate, units.1[order]);
        }
    }

    /// Writes reactions as given, then the equilibrium of each link: the sum of its reactions against that of its
    /// loads.
    pub(crate) fn general_reactions(&mut self, group: usize) -> bool {
        let frame = self.linkage.structure.groups[group].frame.clone();
        let mut loads = self.numeric_loads();
        let mut found = vec![Wrench::ZERO; self.linkage.structure.pairs.len()];
        if self.linkage.groups()[group].reactions(self.bodies, &mut loads, &mut found).is_err() {
            return false;
        }
        self.sheet.note(text!("working-linear-reactions"));
        let mut acting: Vec<(usize, WorkedLoad)> = Vec::new();
        for driven in &frame.driven {
            let drive = drive_of_pair(&driven.pair, self.bodies, &mut found[driven.pair.id]);
            self.given_drive(&driven.pair, drive, &mut acting);
        }
        for pair in frame.pairs() {
            self.given_reaction(pair, &found[pair.id], &frame.links, &mut acting);
        }
        for &link in &frame.links {
            self.equilibrium(link, &acting);
        }
        true
    }

    /// The load of the drive on both links of a driven pair, which is the balancing load where that acts nowhere else.
    fn given_drive(&mut self, pair: &Pair, size: f64, acting: &mut Vec<(usize, WorkedLoad)>) {
        if UnitBalance::of(&self.linkage.mechanism).is_some() {
            // Idle: the balancing load acts elsewhere.
            self.pair_drive = Some(Expr::zero());
            return;
        }
        let symbol = self.balancing_at_input();
        let unit = self.sheet.units.moment;
        let size = self.sheet.given(symbol, size, unit, text!("working-solution"));
        let zero = || [Expr::zero(), Expr::zero()];
        let [(link, at), _] = pair.places();
        let at = self.sheet.point(link, at);
        let (force, moment) = match pair.geometry {
            PairGeometry::Pin { .. } => (zero(), size.clone()),
            PairGeometry::Slide { angle, .. } => {
                let t = self.sheet.guide(pair.id, pair.b, angle).t;
                (t.each_ref().map(|t| &size * t), Expr::zero())
            }
        };
        let opposite = ([-&force[0], -&force[1]], -&moment);
        for (link, (force, moment)) in [(pair.a, (force, moment)), (pair.b, opposite)] {
            acting.push((link, WorkedLoad { force: Some((force, at.clone())), moment, applied: false }));
        }
        self.pair_drive = Some(size);
    }

    fn given_reaction(
        &mut self,
        pair: &Pair,
        found: &Wrench<f64>,
        links: &[usize],
        acting: &mut Vec<(usize, WorkedLoad)>,
    ) {
        let [(link, at), _] = pair.places();
        let at = self.sheet.point(link, at);
        let of = self.sheet.acting(pair.id, pair.a);
        let mut given = |letter: &'static str, part: &'static str, value: f64, unit: &'static str| {
            let symbol = Symbol::from(letter).of(part).of(&of);
            self.sheet.given(symbol, value, unit, text!("working-solution"))
        };
        let force = [("x", found.fx), ("y", found.fy)].map(|(axis, size)| given("R", axis, size, "N"));
        let moment = if pair.is_slide() { given("M", "R", found.m, "N·m") } else { Expr::zero() };
        self.sheet.record(pair.id, pair.a, &force, &moment, &at);
        let on_b = WorkedLoad {
            force: Some(([-&force[0], -&force[1]], at.clone())),
            moment: -&moment,
            applied: false,
        };
        let on_a = WorkedLoad { force: Some((force, at)), moment, applied: false };
        for (body, load) in [(pair.a, on_a), (pair.b, on_b)] {
            if links.contains(&body) {
                acting.push((body, load));
            } else if body != 0 {
                self.sheet.load(body, load);
            }
        }
    }

    fn equilibrium(&mut self, link: usize, acting: &[(usize, WorkedLoad)]) {
        let Some(base) = self.sheet.pose(link).map(|pose| pose.base.clone()) else { return };
        self.sheet.resultant(link);
        self.sheet.moment_about(link, &base);
        let tag = self.sheet.body_name(link);
        let mut sum = [Expr::zero(), Expr::zero(), Expr::zero()];
        for load in acting.iter().filter(|(body, _)| *body == link).map(|(_, load)| load) {
            let Some((force, at)) = &load.force else { continue };
            let moment = at.moment_about(&base, force) + &load.moment;
            sum = [&sum[0] + &force[0], &sum[1] + &force[1], &sum[2] + moment];
        }
        let [x, y, m] = sum;
        let reaction = |of: &'static str| Symbol::from("R").of(of).of(&tag);
        self.sheet.work(reaction("X"), &x, "N");
        self.sheet.work(reaction("Y"), &y, "N");
        self.sheet.work(reaction("M").of(&base.name), &m, "N·m");
    }

    /// The loads on the sheet as wrenches about the origins of the bodies.
    fn numeric_loads(&self) -> Vec<Wrench<f64>> {
        let mut wrenches = vec![Wrench::ZERO; self.linkage.structure.links];
        for (body, wrench) in wrenches.iter_mut().enumerate() {
            for load in self.sheet.loads_on(body) {
                wrench.m += load.moment.value();
                if let Some((force, at)) = &load.force {
                    let origin = [self.bodies[body].x, self.bodies[body].y];
                    let arm = [0, 1].map(|i| at.pf[0][i].value() - origin[i]);
                    wrench.add_at(arm, force.each_ref().map(Expr::value), 0.0);
                }
            }
        }
        wrenches
    }
}
