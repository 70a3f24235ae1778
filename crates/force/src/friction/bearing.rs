//! A bearing: a link that turns or slides on another with friction.

use assur_group::Body;
use assur_group::plane::{direction, dot, minus, perp, vector};
use assur_kinematics::Linkage;
use assur_mechanism::{LinkId, PairId, Surfaces};
use assur_number::Real;
use assur_structure::Structure;

use crate::breaks::tolerance;
use crate::grid::{Bodies, Span};
use crate::sliding::{Rate, Sliding};

/// A link that turns or slides on another in a pair with friction.
#[derive(Debug, Clone, PartialEq)]
pub struct Bearing {
    /// Index among the frictions of the mechanism.
    pub friction: usize,
    /// The pin or slide.
    pub pair: PairId,
    /// The link that turns or slides.
    pub link: LinkId,
    /// The owner of the journal, or the link that carries the guide.
    pub on: LinkId,
    /// The coefficient.
    pub coefficient: f64,
    /// The surfaces that slide on each other.
    pub surfaces: Surfaces,
    /// Of a slide: the point of the sliding link, and a point and the direction of the guide.
    pub(crate) guide: [[f64; 2]; 3],
    /// The pairs of the structure from the link to the other, each with 1 where the load on its body `a` is that on the link, else
    /// -1.
    pub path: Vec<(usize, f64)>,
    pub(crate) sliding: Sliding,
}

impl Bearing {
    /// All bearings of a mechanism, with their senses over a span of the coordinate.
    pub(crate) fn all(linkage: &Linkage, span: &Span) -> Vec<Self> {
        let mechanism = &linkage.mechanism;
        let mut bodies = Bodies::new(linkage, *span);
        let mut all = Vec::new();
        for (index, friction) in mechanism.frictions.iter().enumerate() {
            for [link, on] in mechanism.friction_links(friction) {
                let guide = match friction.pair {
                    PairId::Pin(_) => [[0.0; 2]; 3],
                    PairId::Slide(id) => {
                        let slide = &mechanism.slides[id];
                        [slide.point, slide.through, direction(slide.angle)]
                    }
                };
                let slides = matches!(friction.pair, PairId::Slide(_));
                let mut rate = |q: f64| {
                    let [a, b] = [bodies.at(q, link)?, bodies.at(q, on)?];
                    Ok(if slides { along(&a, &b, guide) } else { turning(&a, &b) })
                };
                let sliding = Sliding::find(&mut rate, span);
                let path = path(&linkage.structure, friction.pair, link, on);
                let (coefficient, surfaces) = (friction.coefficient, friction.surfaces);
                all.push(Self {
                    friction: index,
                    pair: friction.pair,
                    link,
                    on,
                    coefficient,
                    surfaces,
                    guide,
                    path,
                    sliding,
                });
            }
        }
        all
    }

    /// Whether the pair is a slide.
    pub fn slides(&self) -> bool {
        matches!(self.pair, PairId::Slide(_))
    }

    /// Whether it slides on faces offset from the guide line, so that its friction has a moment about the line.
    pub fn is_shifted(&self) -> bool {
        matches!(self.surfaces, Surfaces::Faces { offset, .. } if offset != 0.0)
    }

    /// Whether the two links never move on each other.
    pub fn rests(&self) -> bool {
        self.sliding.never_moves()
    }

    /// Whether the sense changes at a coordinate; `period`: of the input.
    pub fn turns_at(&self, coordinate: f64, period: Option<f64>) -> bool {
        let near = tolerance(coordinate, period);
        let index = |side: f64| self.sliding.at(coordinate + side * near).0.index;
        index(-1.0) != index(1.0)
    }

    /// Relative speed at dq/dt = 1, of the turning (rad) or of the sliding along the guide (m).
    #[inline(always)]
    pub fn relative<T: Real>(&self, bodies: &[Body<T>]) -> T {
        let (link, on) = (&bodies[self.link], &bodies[self.on]);
        match self.pair {
            PairId::Pin(_) => link.w1 - on.w1,
            PairId::Slide(_) => {
                let [point, through, along] = self.guide.map(vector);
                dot(minus(link.first(link.arm(point)), on.first(on.arm(through))), on.turned(along))
            }
        }
    }

    /// The unit vector along the guide of a slide.
    #[inline(always)]
    pub fn along<T: Real>(&self, bodies: &[Body<T>]) -> [T; 2] {
        bodies[self.on].turned(vector(self.guide[2]))
    }

    /// Displacement of a slide: the distance of its point from that of the guide, m.
    #[inline(always)]
    pub fn displacement<T: Real>(&self, bodies: &[Body<T>]) -> T {
        let [point, through, _] = self.guide.map(vector);
        let [point, through] = [bodies[self.link].point(point), bodies[self.on].point(through)];
        dot(minus(point, through), self.along(bodies))
    }

    /// Arms of the point of a slide, from the origin of the sliding link and of the link that carries the guide.
    #[inline(always)]
    pub fn arms<T: Real>(&self, bodies: &[Body<T>]) -> [[T; 2]; 2] {
        let (link, on) = (&bodies[self.link], &bodies[self.on]);
        let arm = link.arm(vector(self.guide[0]));
        [arm, [link.x + arm[0] - on.x, link.y + arm[1] - on.y]]
    }
}

fn turning(link: &Body<f64>, on: &Body<f64>) -> Rate {
    Rate { first: link.w1 - on.w1, slope: link.w2 - on.w2, size: link.w1.abs() + on.w1.abs() }
}

/// The sliding of a link along the guide of another.
fn along(link: &Body<f64>, on: &Body<f64>, [point, through, guide]: [[f64; 2]; 3]) -> Rate {
    let guide = on.turned(guide);
    let [v, a] = link.motion(link.arm(point));
    let [v_on, a_on] = on.motion(on.arm(through));
    let (relative, change) = (minus(v, v_on), minus(a, a_on));
    let slope = dot(change, guide) + on.w1 * dot(relative, perp(guide));
    Rate { first: dot(relative, guide), slope, size: dot(v, guide).abs() + dot(v_on, guide).abs() }
}

/// The pairs of a joint that lead from one of its links to another.
fn path(structure: &Structure, joint: PairId, from: LinkId, to: LinkId) -> Vec<(usize, f64)> {
    let of_joint: Vec<_> =
        structure.pairs.iter().filter(|named| named.source == joint).map(|named| named.pair).collect();
    let mut ways = vec![(from, Vec::new())];
    while let Some((at, way)) = ways.pop() {
        if at == to {
            return way;
        }
        let known = |pair: usize| way.iter().any(|(known, _)| *known == pair);
        for pair in of_joint.iter().filter(|pair| pair.joins(at) && !known(pair.id)) {
            let mut on: Vec<(usize, f64)> = way.clone();
            on.push((pair.id, if pair.a == at { 1.0 } else { -1.0 }));
            ways.push((pair.other(at), on));
        }
    }
    Vec::new()
}
