//! Geometry and loads of one position, reduced to the case of L: one load on the coupler. Which link is the crank, the coupler, the slider or rocker; and why another mechanism has no such links.

use assur_force::Reactions;
use assur_group::plane::{cross, dot, length, minus, perp, plus, scaled};
use assur_group::{Body, Pair, PinJoint, SlideJoint, Wrench};
use assur_kinematics::Linkage;
use assur_mechanism::{Balance, GROUND, LinkId};
use assur_words::{Text, name, text};

/// The roles of links and pairs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Layout {
    pub(crate) crank: LinkId,
    pub(crate) coupler: LinkId,
    /// Slider or rocker.
    pub(crate) third: LinkId,
    /// Crank and ground, seen from the crank.
    pub(crate) o: PinJoint<f64>,
    /// Coupler and crank, seen from the coupler.
    pub(crate) a: PinJoint<f64>,
    /// Coupler and third link, seen from the coupler.
    pub(crate) b: PinJoint<f64>,
    /// Third link and ground, seen from the third link.
    pub(crate) end: End,
}

/// How the third link is joined to the ground.
#[derive(Debug, Clone, Copy)]
pub(crate) enum End {
    Guide(SlideJoint<f64>),
    Pin(PinJoint<f64>),
}

impl Layout {
    /// # Errors
    ///
    /// Why the mechanism has no such layout, as a clause.
    pub(crate) fn of(linkage: &Linkage) -> Result<Self, Text> {
        let (mechanism, structure) = (&linkage.mechanism, &linkage.structure);
        let driver = mechanism.input.first();
        let crank = driver.link;
        let link = |id: LinkId| &mechanism.links[id].name;
        if driver.is_relative() || !mechanism.input.is_angle() {
            return Err(text!("force-longitudinal-no-crank", link = link(crank)));
        }
        if mechanism.balance.is_some_and(|balance| balance != Balance::Moment(crank)) {
            return Err(text!("force-longitudinal-balance", link = link(crank)));
        }
        let [group] = structure.groups.as_slice() else {
            return Err(text!("force-longitudinal-groups", groups = structure.groups.len()));
        };
        if !matches!(group.plugin.name, "rrp" | "rrr") {
            return Err(text!("force-longitudinal-kind", kind = name(group.plugin.kind)));
        }
        let frame = &group.frame;
        let (Some(inner), Some(first), Some(last)) =
            (frame.inner.first(), outer_at(&frame.outer, crank), outer_at(&frame.outer, GROUND))
        else {
            return Err(text!("force-longitudinal-bodies", link = link(crank)));
        };
        if first.is_slide() {
            return Err(text!("force-longitudinal-slide", link = link(crank)));
        }
        let coupler = first.other(crank);
        let third = last.other(GROUND);
        let input = &structure.pairs[0].pair;
        let end =
            if last.is_slide() { slide(last, third).map(End::Guide) } else { pin(last, third).map(End::Pin) };
        let layout = Self {
            crank,
            coupler,
            third,
            o: pin(input, crank)?,
            a: pin(first, coupler)?,
            b: pin(inner, coupler)?,
            end: end?,
        };
        let [x, y] = minus(layout.a.at, layout.o.own);
        if x == 0.0 && y == 0.0 {
            return Err(text!("force-longitudinal-no-length", link = link(crank)));
        }
        Ok(layout)
    }
}

fn outer_at(outer: &[Pair], body: LinkId) -> Option<&Pair> {
    outer.iter().find(|pair| pair.joins(body))
}

fn pin(pair: &Pair, link: LinkId) -> Result<PinJoint<f64>, Text> {
    PinJoint::new(&pair.seen_from(link)).map_err(|error| error.what)
}

fn slide(pair: &Pair, link: LinkId) -> Result<SlideJoint<f64>, Text> {
    SlideJoint::new(&pair.seen_from(link)).map_err(|error| error.what)
}

/// A moment is shown as the arm of the force up to this many lengths of the coupler; beyond, it stays a couple.
const FAR: f64 = 1e3;

/// One position, in the ground's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Setting {
    /// The pins, m. C is the pin of the rocker; of a slider, B again.
    pub(crate) o: [f64; 2],
    pub(crate) a: [f64; 2],
    pub(crate) b: [f64; 2],
    pub(crate) c: [f64; 2],
    /// Unit vector of line 3: across the guide, or along the rocker from C to B.
    pub(crate) line: [f64; 2],
    /// Whether the third link is a slider.
    pub(crate) slider: bool,
    /// Force of the third link's loads on the coupler at B, N: of a slider along the guide, of a rocker across it.
    pub(crate) known: [f64; 2],
    /// F: the sum of both, N.
    pub(crate) force: [f64; 2],
    /// Moment of F with all moments on the coupler about A, N m.
    pub(crate) moment_a: f64,
    /// Moment of the crank's loads about O, N m.
    pub(crate) moment_o: f64,
}

/// The unknown forces: what keeps the coupler in equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unknowns {
    /// Fb, the balancing force at A, across the crank, N.
    pub(crate) fb: [f64; 2],
    /// R1 at A, along the crank, N.
    pub(crate) r1: [f64; 2],
    /// R3 at B, along line 3, N.
    pub(crate) r3: [f64; 2],
}

/// A force through a point, and a couple.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Action {
    /// K, m.
    pub(crate) at: [f64; 2],
    /// Couple, N m; zero where the force alone is equivalent to the load.
    pub(crate) couple: f64,
}

impl Setting {
    pub(crate) fn of(layout: &Layout, bodies: &[Body<f64>], loads: &[Wrench<f64>]) -> Self {
        let [crank, coupler, third] = [layout.crank, layout.coupler, layout.third].map(|link| &bodies[link]);
        let (own, rest) = (&loads[layout.coupler], &loads[layout.third]);
        let [a, b] = [layout.a.own, layout.b.own].map(|at| coupler.point(at));
        let (c, line, known) = match &layout.end {
            End::Guide(guide) => {
                let along = bodies[GROUND].turned(guide.along);
                // The part along the guide goes through the pin B to the coupler.
                (b, perp(along), scaled(dot(rest.force(), along), along))
            }
            End::Pin(pin) => {
                let c = bodies[GROUND].point(pin.at);
                let rocker = minus(b, c);
                let length = length(rocker);
                let line = scaled(1.0 / length, rocker);
                // Moments about C: M3 - |CB| S = 0, S across the rocker on the coupler.
                let tangential = rest.about(third.arm(pin.own)) / length;
                (c, line, scaled(tangential, perp(line)))
            }
        };
        Self {
            o: bodies[GROUND].point(layout.o.at),
            a,
            b,
            c,
            line,
            slider: matches!(layout.end, End::Guide(_)),
            known,
            force: plus(own.force(), known),
            moment_a: own.about(coupler.arm(layout.a.own)) + cross(minus(b, a), known),
            moment_o: loads[layout.crank].about(crank.arm(layout.o.own)),
        }
    }

    /// Unit vector from O to A, and the length of the crank, m.
    pub(crate) fn crank(&self) -> ([f64; 2], f64) {
        let crank = minus(self.a, self.o);
        let length = length(crank);
        (scaled(1.0 / length, crank), length)
    }

    /// The loads of the coupler as F through a point K: the point of its line of action that is nearest to A.
    ///
    /// A couple without a force, or with a very small one, stays a couple at A.
    pub(crate) fn action(&self) -> Action {
        let rod = minus(self.b, self.a);
        let square = dot(self.force, self.force);
        let reach = FAR * length(rod);
        if square > 0.0 && self.moment_a.abs() <= reach * square.sqrt() {
            let arm = scaled(-self.moment_a / square, perp(self.force));
            return Action { at: plus(self.a, arm), couple: 0.0 };
        }
        Action { at: self.a, couple: self.moment_a }
    }
}

/// Force of the pin A on the coupler, N.
pub(crate) fn at_a(found: &Unknowns) -> [f64; 2] {
    plus(found.fb, found.r1)
}

/// Force of the pin B on the coupler, N.
pub(crate) fn at_b(at: &Setting, found: &Unknowns) -> [f64; 2] {
    plus(at.known, found.r3)
}

/// Fb, R1, R3 with the signs of L: Fb against the turning of A towards x, R1 from O to A, R3 towards -x on the coupler, where y goes
/// along the guide (across the rocker) so that B is below O, and x to the right of it.
pub(crate) fn in_axes(at: &Setting, found: &Unknowns) -> [f64; 3] {
    let (crank, _) = at.crank();
    let x = if dot(minus(at.b, at.o), perp(at.line)) < 0.0 { at.line } else { scaled(-1.0, at.line) };
    [-dot(found.fb, perp(crank)), dot(found.r1, crank), -dot(found.r3, x)]
}

/// Stores every reaction and the balancing moment.
pub(crate) fn store(
    layout: &Layout,
    at: &Setting,
    found: &Unknowns,
    bodies: &[Body<f64>],
    loads: &[Wrench<f64>],
    out: &mut Reactions,
) {
    let (at_a, at_b) = (at_a(found), at_b(at, found));
    layout.a.store(at_a, &mut out.pairs);
    layout.b.store(at_b, &mut out.pairs);
    // Loads of the crank change only what follows.
    layout.o.store(minus(at_a, loads[layout.crank].force()), &mut out.pairs);
    out.balancing = cross(minus(at.a, at.o), at_a) - at.moment_o;
    out.further.clear();
    out.further.extend(in_axes(at, found));
    let third = &loads[layout.third];
    match &layout.end {
        End::Pin(pin) => pin.store(minus(at_b, third.force()), &mut out.pairs),
        End::Guide(guide) => {
            let body = &bodies[layout.third];
            let own = body.point(guide.own);
            let across = dot(minus(found.r3, third.force()), at.line);
            let moment = cross(minus(at.b, own), at_b) - third.about(body.arm(guide.own));
            guide.store(bodies, scaled(across, at.line), moment, &mut out.pairs);
        }
    }
}
