//! The input link and the groups.

use assur_mechanism::{GROUND, InputPair, LinkId};

use super::draft::{Draft, length, minus};

/// The five kinds of groups of class II.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Type 1.
    Rrr,
    /// Type 2.
    Rrp,
    /// Type 3.
    Rpr,
    /// Type 4.
    Prp,
    /// Type 5.
    Rpp,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Rrr, Self::Rrp, Self::Rpr, Self::Prp, Self::Rpp];

    /// The registered name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rrr => "rrr",
            Self::Rrp => "rrp",
            Self::Rpr => "rpr",
            Self::Prp => "prp",
            Self::Rpp => "rpp",
        }
    }
}

/// Outer pins closer than this part of the region make the group singular or its links too short.
const APART: f64 = 0.25;

/// Draws that are made before an arrangement is given up.
const TRIES: usize = 200;

impl Draft {
    /// The input link: pinned, or sliding on the ground; its pair and the coordinate of the first position.
    pub(crate) fn input(&mut self, sliding: bool) -> (InputPair, f64) {
        let link = self.link();
        if sliding {
            let direction = self.rng.angle();
            let slide = self.slide(link, GROUND, direction);
            let found = &self.slides[slide];
            let moved = minus(self.poses[link].world(found.point), found.through);
            let (s, c) = found.angle.sin_cos();
            return (InputPair::Slide(slide), c * moved[0] + s * moved[1]);
        }
        // The frame of a crank mostly has its origin in the pin, but need not.
        let world = if self.rng.chance(0.6) { self.poses[link].world([0.0; 2]) } else { self.place() };
        (InputPair::Pin(self.pin(link, GROUND, world)), self.poses[link].angle)
    }

    /// A group of this kind on two earlier bodies; `None` where no healthy arrangement was found.
    pub(crate) fn group(&mut self, kind: Kind, bodies: [LinkId; 2]) -> Option<[LinkId; 2]> {
        let links = [self.link(), self.link()];
        let [one, two] = links;
        let [first, second] = bodies;
        match kind {
            Kind::Rrr => {
                let ends = [self.hang(one, first), self.hang(two, second)];
                let elbow = self.elbow(ends)?;
                self.pin(one, two, elbow);
            }
            Kind::Rrp => {
                let outer = self.hang(one, first);
                let inner = self.distant(outer)?;
                self.pin(one, two, inner);
                let along = self.along(minus(inner, outer));
                self.slide(two, second, along);
            }
            Kind::Rpr => {
                let ends = [self.hang(one, first), self.hang(two, second)];
                let way = minus(ends[1], ends[0]);
                if length(way) < APART * self.size {
                    return None;
                }
                let along = self.along(way);
                self.slide(one, two, along);
            }
            Kind::Prp => {
                let inner = self.place();
                self.pin(one, two, inner);
                let direction = self.rng.angle();
                self.slide(one, first, direction);
                let other = self.across(direction);
                self.slide(two, second, other);
            }
            Kind::Rpp => {
                self.hang(one, first);
                let direction = self.rng.angle();
                self.slide(one, two, direction);
                let other = self.across(direction);
                self.slide(two, second, other);
            }
        }
        Some(links)
    }

    /// A place for the inner pin of RRR that leaves the triangle well open.
    fn elbow(&mut self, ends: [[f64; 2]; 2]) -> Option<[f64; 2]> {
        (length(minus(ends[1], ends[0])) >= APART * self.size).then_some(())?;
        for _ in 0..TRIES {
            let place = self.place();
            let (a, b) = (minus(place, ends[0]), minus(place, ends[1]));
            let sine = (a[0] * b[1] - a[1] * b[0]).abs() / (length(a) * length(b));
            if sine > 0.5 && length(a).min(length(b)) > APART * self.size {
                return Some(place);
            }
        }
        None
    }

    fn distant(&mut self, from: [f64; 2]) -> Option<[f64; 2]> {
        let mut draw = || self.place();
        let size = (0..TRIES).map(|_| draw()).collect::<Vec<_>>();
        size.into_iter().find(|place| length(minus(*place, from)) > APART * self.size)
    }
}
