//! What in a scene is probably not meant, as far as its motion tells: assemblies that nothing chooses, places that are missed, links
//! that rest, loads that do no work.

use std::collections::BTreeMap;

use assur_force::{Cause, LoadState, power};
use assur_group::{Body, Order};
use assur_kinematics::{Position, ScalarMotion};
use assur_mechanism::{GROUND, Key, LoadId, Mechanism, Motion, Warning};
use assur_number::elementary;
use assur_words::{Text, joined, millimeters, name, quantity, text};

use crate::{Calculation, InputMotion};

/// A transfer function below this part of what the size of the mechanism gives is rounding.
const STILL: f64 = 1e-9;
/// A place in `[assembly]` that is missed by more than this part of the size of the mechanism was meant for another assembly.
const FAR: f64 = 0.1;
/// Of more positions than this no motion is judged: a load may act in few of them.
const MOST_POSITIONS: usize = 3600;
/// In fewer positions than this a link may rest and a load do no work by chance.
const FEWEST_POSITIONS: usize = 3;

impl Calculation {
    /// What the motion shows to be probably not meant in the scene, beside what reading it tells
    /// ([`Mechanism::warnings`]).
    pub fn mistakes(&self) -> Vec<Warning> {
        let mut warnings: Vec<_> = self.never_starts().into_iter().collect();
        let mut first = self.linkage.position();
        if self.linkage.solve_index(0, Order::Place, &mut first).is_ok() {
            warnings.extend(self.groups_in_any_way(&first));
            warnings.extend(self.missed_places(&first));
        }
        if !self.plan.is_partial() && self.linkage.mechanism.input.positions <= MOST_POSITIONS {
            warnings.extend(self.without_motion());
        }
        warnings
    }

    /// A transient motion that stays where it begins.
    fn never_starts(&self) -> Option<Warning> {
        let InputMotion::Transient(found) = &self.motion else { return None };
        let samples = &found.trajectory.samples;
        let stays = samples.iter().all(|sample| sample.speed == 0.0);
        stays.then(|| Warning::mistake(Key::of("motion"), text!("analysis-never-starts")))
    }

    /// Groups with several ways of which no place in `[assembly]` chooses one.
    fn groups_in_any_way(&self, first: &Position) -> Vec<Warning> {
        let (linkage, mechanism) = (&self.linkage, &self.linkage.mechanism);
        // A place adds to what the links before a group already determine.
        let is_placed_before = |group: usize, link: usize| {
            let mut later = linkage.groups()[group..].iter();
            !later.any(|kernel| kernel.frame().links.contains(&link))
        };
        let is_hinted = |group: usize, links: &[usize]| {
            mechanism.assembly.iter().any(|(point, _)| {
                let mut places = mechanism.points[*point].places.iter().map(|place| place.link);
                places.clone().any(|link| links.contains(&link))
                    && places.all(|link| !is_placed_before(group, link))
            })
        };
        let mut warnings = Vec::new();
        for (group, kernel) in
            linkage.groups().iter().enumerate().filter(|(group, _)| linkage.chain.needed[*group])
        {
            let links = &kernel.frame().links;
            if kernel.ways() < 2 || is_hinted(group, links) {
                continue;
            }
            let mut poses = vec![first.bodies.clone()];
            for way in 0..kernel.ways() {
                let mut bodies = first.bodies.clone();
                if kernel.place(&mut bodies, way).is_ok() {
                    poses.push(bodies);
                }
            }
            if let Some((point, places)) =
                parted(mechanism, links, &poses, FAR * STILL * linkage.structure.scale)
            {
                let [taken, others @ ..] = &places[..] else { continue };
                let text = text!(
                    "analysis-any-way",
                    group = linkage.structure.group_name(mechanism, group),
                    point = Text::from(&mechanism.points[point].name),
                    taken = shown(*taken),
                    others = joined(", ", others.iter().map(|place| shown(*place)))
                );
                warnings.push(Warning::mistake(Key::of("assembly"), text));
            }
        }
        warnings
    }

    /// Places in `[assembly]` that the assembly taken misses by far.
    fn missed_places(&self, first: &Position) -> Vec<Warning> {
        let mechanism = &self.linkage.mechanism;
        let places = mechanism.points.iter().flat_map(|point| &point.places);
        let size = diagonal(places.map(|place| first.bodies[place.link].point(place.at)));
        let groups =
            || self.linkage.groups().iter().enumerate().map(|(group, kernel)| (group, kernel.frame()));
        let is_placed = |link: usize| {
            groups().all(|(group, frame)| self.linkage.chain.needed[group] || !frame.links.contains(&link))
        };
        let missed = mechanism.assembly.iter().filter_map(|&(point, wanted)| {
            let (place, name) = (mechanism.points[point].places.first()?, &mechanism.points[point].name);
            let found = first.bodies[place.link].point(place.at);
            let away = elementary::hypot(found[0] - wanted[0], found[1] - wanted[1]);
            (away > FAR * size && is_placed(place.link)).then(|| {
                let text = text!(
                    "analysis-place-missed",
                    point = Text::from(name),
                    wanted = shown(wanted),
                    found = shown(found),
                    distance = millimeters(away, 4)
                );
                Warning::mistake(Key::of("assembly").at(name), text)
            })
        });
        missed.collect()
    }

    /// Links and slides that never move, and loads that never do work, where the motion is that of the positions.
    fn without_motion(&self) -> Vec<Warning> {
        let linkage = &self.linkage;
        let count = linkage.mechanism.input.positions;
        let mut seen = Seen::of(&linkage.mechanism, self.unit());
        let mut position = linkage.position();
        for index in 0..count {
            if linkage.solve_index(index, Order::First, &mut position).is_err() {
                // Where the mechanism can't go, nothing is known of what moves.
                return Vec::new();
            }
            self.see(&position, &mut seen);
        }
        if seen.loads.values().any(|seen| seen.contains(&false)) {
            for place in self.between_changes() {
                if linkage.solve(place, Order::First, &mut position).is_ok() {
                    self.see(&position, &mut seen);
                }
            }
        }
        if count < FEWEST_POSITIONS { Vec::new() } else { seen.warnings() }
    }

    fn see(&self, position: &Position, seen: &mut Seen<'_>) {
        seen.motion(&position.bodies);
        // The loads of the positions are those of the scene's motion, or of no motion.
        let is_prescribed = matches!(self.linkage.mechanism.motion, None | Some(Motion::Prescribed { .. }));
        let Some(loads) = self.loads.as_ref().filter(|_| is_prescribed) else { return };
        let state = LoadState::prescribed(&self.linkage.mechanism, position.coordinate);
        loads.by_cause(&state, &position.bodies, &mut |cause, link, wrench| {
            let body = &position.bodies[link];
            let terms = [wrench.fx * body.x1, wrench.fy * body.y1, wrench.m * body.w1];
            let size =
                elementary::hypot(wrench.fx, wrench.fy) * seen.unit + wrench.m.abs() * seen.unit / seen.size;
            let terms = terms.iter().map(|term| term.abs()).sum::<f64>().max(size);
            seen.load(cause, power(&wrench, body), terms);
        });
    }

    /// A place in each of the parts into which the positions and the places where loads change divide the motion: a load may act
    /// between the positions only.
    fn between_changes(&self) -> Vec<f64> {
        // Formulas vanish in the middle of positions for the same reason as in them.
        const PART: f64 = 0.381_966;
        let input = &self.linkage.mechanism.input;
        let last = if input.is_cycle() { input.positions } else { input.positions.saturating_sub(1) };
        let mut places: Vec<f64> = (0..=last).map(|index| input.coordinate(index)).collect();
        places.extend(self.known_places([0, last].map(|index| input.coordinate(index))));
        places.sort_by(f64::total_cmp);
        places.windows(2).map(|two| two[0] + PART * (two[1] - two[0])).collect()
    }

    /// What a point of the mechanism moves per unit of the coordinate: m/rad, or 1.
    fn unit(&self) -> [f64; 2] {
        let size = self.linkage.structure.scale;
        [size, if self.linkage.kind().is_angle() { size } else { 1.0 }]
    }
}

/// The point of some links that lies farthest apart in different poses, and its different places: the first pose's first.
/// `None` where all lie within `same`, m.
fn parted(
    mechanism: &Mechanism,
    links: &[usize],
    poses: &[Vec<Body<f64>>],
    same: f64,
) -> Option<(usize, Vec<[f64; 2]>)> {
    let apart = |a: [f64; 2], b: [f64; 2]| elementary::hypot(a[0] - b[0], a[1] - b[1]);
    let each = mechanism.points.iter().enumerate().filter_map(|(id, point)| {
        let place = point.places.iter().find(|place| links.contains(&place.link))?;
        let mut places: Vec<[f64; 2]> = Vec::new();
        for pose in poses {
            let at = pose[place.link].point(place.at);
            if !places.iter().any(|other| apart(*other, at) <= same) {
                places.push(at);
            }
        }
        let most = places.iter().map(|at| apart(*at, places[0])).fold(0.0, f64::max);
        (most > same).then_some((most, id, places))
    });
    each.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, id, places)| (id, places))
}

/// The diagonal of the rectangle around some places, m.
fn diagonal(places: impl Iterator<Item = [f64; 2]>) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for place in places {
        low = [low[0].min(place[0]), low[1].min(place[1])];
        high = [high[0].max(place[0]), high[1].max(place[1])];
    }
    elementary::hypot(high[0] - low[0], high[1] - low[1])
}

/// A place as it may be written in a scene.
fn shown(place: [f64; 2]) -> Text {
    let [x, y] = place.map(|at| {
        let rounded = (at * 1e4).round() / 10.0;
        quantity(rounded + 0.0, "mm")
    });
    joined("", [name("["), x, name(", "), y, name("]")])
}

/// What moves and what does work in the positions seen so far.
struct Seen<'m> {
    mechanism: &'m Mechanism,
    /// Size of the mechanism, m.
    size: f64,
    /// What a point of it moves per unit of the coordinate, m/rad or 1.
    unit: f64,
    links: Vec<bool>,
    slides: Vec<bool>,
    /// Of each load: whether it ever acts, and whether it ever does work.
    loads: BTreeMap<LoadId, [bool; 2]>,
}

impl<'m> Seen<'m> {
    fn of(mechanism: &'m Mechanism, [size, unit]: [f64; 2]) -> Self {
        let (links, slides) = (vec![false; mechanism.links.len()], vec![false; mechanism.slides.len()]);
        Self { mechanism, size, unit, links, slides, loads: BTreeMap::new() }
    }

    fn motion(&mut self, bodies: &[Body<f64>]) {
        let least = STILL * self.unit;
        for (moves, body) in self.links.iter_mut().zip(bodies) {
            *moves |= elementary::hypot(body.x1, body.y1) > least || body.w1.abs() * self.size > least;
        }
        for (moves, slide) in self.slides.iter_mut().zip(&self.mechanism.slides) {
            *moves |= ScalarMotion::of_slide(slide, bodies).pf1.abs() > least;
        }
    }

    fn load(&mut self, cause: Cause, power: f64, terms: f64) {
        let Cause::Load(load) = cause else { return };
        let [acts, works] = self.loads.entry(load).or_default();
        // A load without a value is no load of zero.
        let unknown = terms.is_nan();
        *acts |= unknown || terms > 0.0;
        *works |= unknown || power.abs() > STILL * terms;
    }

    fn warnings(&self) -> Vec<Warning> {
        let mechanism = self.mechanism;
        let mut warnings = Vec::new();
        for (link, _) in self.links.iter().enumerate().skip(GROUND + 1).filter(|(_, moves)| !**moves) {
            let name = &mechanism.links[link].name;
            warnings.push(Warning::mistake(
                Key::of("link").at(name),
                text!("analysis-link-rests", link = Text::from(name)),
            ));
        }
        for (index, _) in self.slides.iter().enumerate().filter(|(_, moves)| !**moves) {
            let slide = &mechanism.slides[index];
            if self.links[slide.link] || slide.on != GROUND {
                let text = text!("analysis-slide-rests", slide = Text::from(&slide.name));
                warnings.push(Warning::mistake(Key::of("slide").at(index), text));
            }
        }
        for (load, [acts, works]) in &self.loads {
            let name = Text::from(&mechanism.loads[*load].name);
            let text = match (acts, works) {
                (false, _) => text!("analysis-load-idle", load = name),
                (true, false) => text!("analysis-load-without-work", load = name),
                (true, true) => continue,
            };
            let key = mechanism.key_of_load(*load);
            // A spring without stiffness was reported when the scene was read.
            let is_of =
                |note: &Warning| note.key.as_ref().is_some_and(|of| of.steps().starts_with(key.steps()));
            if !acts && mechanism.warnings.iter().any(is_of) {
                continue;
            }
            warnings.push(Warning::mistake(key, text));
        }
        warnings
    }
}
