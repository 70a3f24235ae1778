//! Constructs the input link and the groups of a specimen.

use assur_group::Pattern;
use assur_mechanism::{GROUND, InputPair, LinkId};

use super::draft::Draft;
use crate::arrangement::{Join, constraints, drawn_pairs, regularity};

/// Least ratio of singular values of a group's constraints in the first position.
const LEAST_REGULARITY: f64 = 0.05;

/// Greatest number of arrangements of the pairs that are tried for a group.
const TRIES: usize = 60;

impl Draft {
    /// Adds the input link, pinned or sliding on the ground; its pair and the coordinate of the first position.
    pub(crate) fn input(&mut self, sliding: bool) -> (InputPair, f64) {
        let link = self.link();
        if sliding {
            let direction = self.rng.angle();
            let slide = self.slide(link, GROUND, direction);
            let found = &self.slides[slide];
            let start = self.poses[link].world(found.point);
            let (s, c) = found.angle.sin_cos();
            let way = c * (start[0] - found.through[0]) + s * (start[1] - found.through[1]);
            return (InputPair::Slide(slide), way);
        }
        // The origin of a crank's frame is usually, but not always, in the pin.
        let world = if self.rng.chance(0.6) { self.poses[link].world([0.0; 2]) } else { self.place() };
        (InputPair::Pin(self.pin(link, GROUND, world)), self.poses[link].angle)
    }

    /// Adds a group of this pattern on these earlier bodies, one for each outer pair; `None` if no arrangement of its
    /// pairs was found that is well away from a singular position.
    pub(crate) fn group(&mut self, pattern: &Pattern, outside: &[LinkId]) -> Option<()> {
        let links: Vec<LinkId> = (0..pattern.links).map(|_| self.link()).collect();
        let (points, slides) = (self.points.clone(), self.slides.clone());
        for _ in 0..TRIES {
            let pairs = drawn_pairs(&mut self.rng, pattern, &links, outside);
            let joins: Vec<Join> =
                pairs.into_iter().map(|(bodies, is_slide)| self.join(bodies, is_slide, &links)).collect();
            let origin = |link: LinkId| [self.poses[link].x, self.poses[link].y];
            if regularity(&constraints(&links, &joins, origin, self.size)) > LEAST_REGULARITY {
                return Some(());
            }
            (self.points, self.slides) = (points.clone(), slides.clone());
        }
        None
    }

    /// Joins the first body to the second: by a slide, by a new pin, or by an existing pin of a body outside the
    /// group.
    fn join(&mut self, bodies: [LinkId; 2], is_slide: bool, group: &[LinkId]) -> Join {
        let [link, body] = bodies;
        if is_slide {
            let guide = self.rng.angle();
            let slide = self.slide(link, body, guide);
            let found = &self.slides[slide];
            return Join { bodies, at: self.poses[found.link].world(found.point), guide: Some(guide) };
        }
        if !group.contains(&body) {
            return Join { bodies, at: self.hang(link, body), guide: None };
        }
        let at = self.place();
        self.pin(link, body, at);
        Join { bodies, at, guide: None }
    }
}
