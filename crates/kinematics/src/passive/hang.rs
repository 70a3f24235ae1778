//! Places a passive link by its pairs with links that are placed before it.

use assur_group::plane::{cross, dot, length, meet, minus, perp, plus, scaled, times};
use assur_group::{Body, GroupFrame, Order, PinJoint, SlideJoint};
use assur_number::{Real, elementary};

/// Two guides whose directions differ by less than this (the sine of the angle) place no link between them.
const PARALLEL: f64 = 1e-9;

/// A passive link: as many of its pairs as place it. The other pairs are compared with it, not solved.
#[derive(Debug, Clone)]
pub(crate) struct Hanging<T> {
    link: usize,
    by: By<T>,
}

/// What places the link.
#[derive(Debug, Clone)]
enum By<T> {
    /// A pin gives the position of the link, the direction towards another pin its angle.
    Pins([PinJoint<T>; 2]),
    /// A slide gives the angle of the link, a pin its position.
    Guided(SlideJoint<T>, PinJoint<T>),
    /// Two slides that are not parallel give position and angle.
    Guides([SlideJoint<T>; 2]),
}

impl<T: Real> Hanging<T> {
    /// Reads the pairs of a passive link; `None` where they don't place it.
    pub(crate) fn of(frame: &GroupFrame) -> Option<Self> {
        let &[link] = &frame.links[..] else { return None };
        let own = || frame.outer.iter().map(|pair| pair.seen_from(link));
        let guides: Vec<SlideJoint<T>> = own().filter_map(|seen| SlideJoint::new(&seen).ok()).collect();
        let pins: Vec<PinJoint<T>> = own().filter_map(|seen| PinJoint::new(&seen).ok()).collect();
        let by = match (&guides[..], &pins[..]) {
            ([guide, ..], [pin, ..]) => By::Guided(*guide, *pin),
            ([], [first, others @ ..]) => {
                let apart = |pin: &PinJoint<T>| length(minus(pin.own, first.own));
                let far = others.iter().max_by(|a, b| apart(a).total_cmp(&apart(b)));
                By::Pins([*first, *far.filter(|far| apart(far) > 0.0)?])
            }
            ([first, others @ ..], []) => {
                // Seen from the link itself.
                let crosses = |other: &&SlideJoint<T>| {
                    elementary::sin(other.tilt_angle - first.tilt_angle).abs() > PARALLEL
                };
                By::Guides([*first, *others.iter().find(crosses)?])
            }
            ([], []) => return None,
        };
        Some(Self { link, by })
    }

    /// Places the link and derives its motion from that of the others.
    pub(crate) fn solve(&self, bodies: &mut [Body<T>], order: Order) {
        let mut body = bodies[self.link];
        match &self.by {
            By::Pins([first, far]) => {
                let [place, end] = [first, far].map(|pin| pin.place(bodies));
                let (d, own) = (minus(end, place), minus(far.own, first.own));
                let square = dot(d, d);
                let turn = times(d, [own[0], -own[1]]);
                let arm = body.put(scaled(T::ONE / dot(turn, turn).sqrt(), turn), first.own, place);
                if order >= Order::First {
                    let [[first1, first2], [far1, far2]] = [first, far].map(|pin| motion(pin, bodies));
                    let (d1, d2) = (minus(far1, first1), minus(far2, first2));
                    body.w1 = cross(d, d1) / square;
                    body.w2 = (cross(d, d2) - (dot(d, d1) * body.w1).twice()) / square;
                    body.hang_first(arm, first1);
                    body.hang_second(arm, first2);
                }
            }
            By::Guided(guide, pin) => {
                let arm = body.put(guide.carried(bodies, guide.turn), pin.own, pin.place(bodies));
                if order >= Order::First {
                    let [first, second] = motion(pin, bodies);
                    (body.w1, body.w2) = (bodies[guide.body].w1, bodies[guide.body].w2);
                    body.hang_first(arm, first);
                    body.hang_second(arm, second);
                }
            }
            By::Guides(guides) => by_guides(guides, bodies, &mut body, order),
        }
        bodies[self.link] = body;
    }
}

/// Places a link where both guides let its points be.
fn by_guides<T: Real>(guides: &[SlideJoint<T>; 2], bodies: &[Body<T>], body: &mut Body<T>, order: Order) {
    [body.c, body.s] = guides[0].carried(bodies, guides[0].turn);
    let normals = guides.map(|guide| perp(guide.guide(bodies)));
    let arms = guides.map(|guide| body.arm(guide.own));
    let place = |k: usize| dot(normals[k], minus(bodies[guides[k].body].point(guides[k].through), arms[k]));
    [body.x, body.y] = meet(normals, [place(0), place(1)]);
    if order < Order::First {
        return;
    }
    let carriers = guides.map(|guide| &bodies[guide.body]);
    (body.w1, body.w2) = (carriers[0].w1, carriers[0].w2);
    // The points of the carriers that lie under the points of the link.
    let under = [0, 1].map(|k| minus(plus([body.x, body.y], arms[k]), carriers[k].origin()));
    let first =
        |k: usize| dot(normals[k], minus(carriers[k].first(under[k]), scaled(body.w1, perp(arms[k]))));
    [body.x1, body.y1] = meet(normals, [first(0), first(1)]);
    let second = |k: usize| {
        let relative = minus(body.first(arms[k]), carriers[k].first(under[k]));
        let along = cross(relative, normals[k]);
        let own = minus(scaled(body.w2, perp(arms[k])), scaled(body.w1 * body.w1, arms[k]));
        dot(normals[k], minus(carriers[k].second(under[k]), own)) + (carriers[k].w1 * along).twice()
    };
    [body.x2, body.y2] = meet(normals, [second(0), second(1)]);
}

/// PF1 and PF2 of a pin.
fn motion<T: Real>(pin: &PinJoint<T>, bodies: &[Body<T>]) -> [[T; 2]; 2] {
    let body = &bodies[pin.body];
    body.motion(body.arm(pin.at))
}
