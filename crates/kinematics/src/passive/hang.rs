//! Places a passive link by its pairs with links that are placed before it.

use assur_group::plane::{cross, direction, dot, minus, perp, plus, scaled, times, vector};
use assur_group::{Body, GroupFrame, Order, Pair, PairGeometry};
use assur_number::Real;

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
    Pins([Pin<T>; 2]),
    /// A slide gives the angle of the link, a pin its position.
    Guided(Guide<T>, Pin<T>),
    /// Two slides that are not parallel give position and angle.
    Guides([Guide<T>; 2]),
}

/// A pin on another body.
#[derive(Debug, Clone, Copy)]
struct Pin<T> {
    own: [T; 2],
    body: usize,
    at: [T; 2],
}

/// A slide of the link along a line of another body.
#[derive(Debug, Clone, Copy)]
struct Guide<T> {
    point: [T; 2],
    body: usize,
    through: [T; 2],
    /// Direction of the guide, and that of the link's x axis, both in the frame of the other body.
    along: [T; 2],
    axis: [T; 2],
}

impl<T: Real> Hanging<T> {
    /// Reads the pairs of a passive link; `None` where they don't place it.
    pub(crate) fn of(frame: &GroupFrame) -> Option<Self> {
        let &[link] = &frame.links[..] else { return None };
        let own = frame.outer.iter().map(|pair| if pair.a == link { *pair } else { pair.turned_round() });
        let (guides, pins): (Vec<Pair>, Vec<Pair>) = own.partition(Pair::is_slide);
        let by = match (&guides[..], &pins[..]) {
            ([guide, ..], [pin, ..]) => By::Guided(Guide::of(guide)?, Pin::of(pin)?),
            ([], [first, others @ ..]) => {
                let apart = |pair: &Pair| {
                    let [a, b] = [pair, first].map(|pair| pair.places()[0].1);
                    (a[0] - b[0]).hypot(a[1] - b[1])
                };
                let far = others.iter().max_by(|a, b| apart(a).total_cmp(&apart(b)));
                let far = far.filter(|far| apart(far) > 0.0)?;
                By::Pins([Pin::of(first)?, Pin::of(far)?])
            }
            ([first, others @ ..], []) => {
                let turn = |pair: &Pair| match pair.geometry {
                    // Seen from the link itself.
                    PairGeometry::Slide { tilt, .. } => tilt,
                    PairGeometry::Pin { .. } => 0.0,
                };
                let other = others.iter().find(|other| (turn(other) - turn(first)).sin().abs() > PARALLEL)?;
                By::Guides([Guide::of(first)?, Guide::of(other)?])
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
                    let [[first1, first2], [far1, far2]] = [first, far].map(|pin| pin.motion(bodies));
                    let (d1, d2) = (minus(far1, first1), minus(far2, first2));
                    body.w1 = cross(d, d1) / square;
                    body.w2 = (cross(d, d2) - (dot(d, d1) * body.w1).twice()) / square;
                    body.hang_first(arm, first1);
                    body.hang_second(arm, first2);
                }
            }
            By::Guided(guide, pin) => {
                let arm = body.put(guide.turn(bodies), pin.own, pin.place(bodies));
                if order >= Order::First {
                    let [first, second] = pin.motion(bodies);
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
fn by_guides<T: Real>(guides: &[Guide<T>; 2], bodies: &[Body<T>], body: &mut Body<T>, order: Order) {
    [body.c, body.s] = guides[0].turn(bodies);
    let normals = guides.map(|guide| perp(bodies[guide.body].turned(guide.along)));
    // n1 x = r1, n2 x = r2.
    let meet = |right: [T; 2]| {
        let by = T::ONE / cross(normals[0], normals[1]);
        let [[a, b], [c, d]] = normals;
        [(right[0] * d - right[1] * b) * by, (right[1] * a - right[0] * c) * by]
    };
    let arms = guides.map(|guide| body.arm(guide.point));
    let place = |k: usize| dot(normals[k], minus(bodies[guides[k].body].point(guides[k].through), arms[k]));
    [body.x, body.y] = meet([place(0), place(1)]);
    if order < Order::First {
        return;
    }
    let carriers = guides.map(|guide| &bodies[guide.body]);
    (body.w1, body.w2) = (carriers[0].w1, carriers[0].w2);
    // The points of the carriers that lie under the points of the link.
    let under = [0, 1].map(|k| minus(plus([body.x, body.y], arms[k]), carriers[k].origin()));
    let first =
        |k: usize| dot(normals[k], minus(carriers[k].first(under[k]), scaled(body.w1, perp(arms[k]))));
    [body.x1, body.y1] = meet([first(0), first(1)]);
    let second = |k: usize| {
        let relative = minus(body.first(arms[k]), carriers[k].first(under[k]));
        let along = cross(relative, normals[k]);
        let own = minus(scaled(body.w2, perp(arms[k])), scaled(body.w1 * body.w1, arms[k]));
        dot(normals[k], minus(carriers[k].second(under[k]), own)) + (carriers[k].w1 * along).twice()
    };
    [body.x2, body.y2] = meet([second(0), second(1)]);
}

impl<T: Real> Pin<T> {
    fn of(pair: &Pair) -> Option<Self> {
        let PairGeometry::Pin { at_a, at_b } = pair.geometry else { return None };
        Some(Self { own: vector(at_a), body: pair.b, at: vector(at_b) })
    }

    fn place(&self, bodies: &[Body<T>]) -> [T; 2] {
        bodies[self.body].point(self.at)
    }

    fn motion(&self, bodies: &[Body<T>]) -> [[T; 2]; 2] {
        let body = &bodies[self.body];
        body.motion(body.arm(self.at))
    }
}

impl<T: Real> Guide<T> {
    fn of(pair: &Pair) -> Option<Self> {
        let PairGeometry::Slide { point, through, angle, tilt } = pair.geometry else { return None };
        let along: [T; 2] = direction(angle);
        let axis = times(along, direction(tilt));
        Some(Self { point: vector(point), body: pair.b, through: vector(through), along, axis })
    }

    /// Direction of the link's x axis.
    fn turn(&self, bodies: &[Body<T>]) -> [T; 2] {
        bodies[self.body].turned(self.axis)
    }
}
