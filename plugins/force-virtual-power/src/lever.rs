//! The turned velocity plan with the forces on it.

use assur_force::{
    Acting, Construction, ConstructionStep, Drawing, UnitBalance, VectorKind, drive_direction,
};
use assur_group::Body;
use assur_group::plane::{length, minus, opposite, perp, scaled};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Balance, GROUND, InputPair, LinkId};
use assur_number::ROUNDING;
use assur_words::{Text, joined, name, quantity, text};

/// The lever: images of the points turned clockwise by a right angle, then each load in the image of the point where it acts.
pub(crate) fn draw(linkage: &Linkage, position: &Position, loads: &[Acting], balancing: f64) -> Construction {
    let lever = Lever { linkage, bodies: &position.bodies };
    let mut steps = lever.images(position);
    for (number, load) in loads.iter().enumerate() {
        let what = Text::from(load.cause.name(&linkage.mechanism));
        let symbol = name(format!("F{}", number + 1));
        steps.extend(lever.load(load, VectorKind::Load, &symbol, &what));
    }
    // Beside the loads it may be rounding.
    let scale = linkage.structure.scale;
    let moments =
        loads.iter().map(|load| load.couple(lever.bodies).abs() + scale * length(load.wrench.force()));
    let is_rounding = balancing.abs() <= ROUNDING * moments.fold(0.0, f64::max);
    steps.extend(lever.balance(if is_rounding { 0.0 } else { balancing }));
    Construction { title: text!("force-lever-title"), corner: [0.0; 2], steps }
}

/// PF1 turned clockwise: the moment about the pole of a force there is its power.
fn turned(first: [f64; 2]) -> [f64; 2] {
    opposite(perp(first))
}

/// A force with its symbol and the load that it is, from its start.
fn force(
    [name, of]: [Text; 2],
    kind: VectorKind,
    [start, vector]: [[f64; 2]; 2],
    note: Text,
) -> ConstructionStep {
    let (drawing, after) = (Drawing::Lever, [0.0; 2]);
    ConstructionStep { name, of, kind, drawing, start, after, vector, unit: "N", note }
}

struct Lever<'a> {
    linkage: &'a Linkage,
    bodies: &'a [Body<f64>],
}

impl Lever<'_> {
    /// The image of a point of a link, which is at a place of the ground.
    fn image(&self, link: LinkId, at: [f64; 2]) -> [f64; 2] {
        let body = &self.bodies[link];
        turned(body.first(minus(at, [body.x, body.y])))
    }

    /// The velocity of a point for dq = 1, turned, from the pole.
    fn image_step(&self, name: Text, vector: [f64; 2], note: Text) -> ConstructionStep {
        let unit = if self.linkage.kind().is_angle() { "m/rad" } else { "m/m" };
        let names = [name, Text::default()];
        let kind = VectorKind::Absolute;
        ConstructionStep { unit, ..force(names, kind, [[0.0; 2], vector], note) }
    }

    /// The images of the points from the pole, and each link between the images of its points.
    fn images(&self, position: &Position) -> Vec<ConstructionStep> {
        let mechanism = &self.linkage.mechanism;
        let moving = mechanism
            .points
            .iter()
            .enumerate()
            .filter(|(_, point)| point.places.iter().all(|place| place.link != GROUND));
        let mut steps: Vec<ConstructionStep> = moving
            .map(|(id, point)| {
                let image = turned(self.linkage.point_motion(id, position).pf1);
                let letter = name(point.name.to_lowercase());
                let note = text!("force-lever-image", point = &point.name);
                self.image_step(letter, image, note)
            })
            .collect();
        for link in 1..mechanism.links.len() {
            let places = self.places(link);
            for (from, to) in
                places.iter().zip(places.iter().skip(1)).filter(|(one, two)| !one.rests && !two.rests)
            {
                let [start, end] = [from, to].map(|place| self.image(link, place.at));
                let note = text!("force-lever-link", link = &mechanism.links[link].name);
                let letters = joined("", [from, to].map(|place| name(place.name.to_lowercase())));
                let line = ConstructionStep {
                    kind: VectorKind::Line,
                    start,
                    ..self.image_step(letters, minus(end, start), note)
                };
                steps.push(line);
            }
        }
        steps
    }

    fn places(&self, link: LinkId) -> Vec<Named<'_>> {
        let points = self.linkage.mechanism.points.iter();
        let own = points.filter_map(|point| {
            let place = point.places.iter().find(|place| place.link == link)?;
            let rests = point.places.iter().any(|place| place.link == GROUND);
            Some(Named { name: &point.name, at: self.bodies[link].point(place.at), rests })
        });
        own.collect()
    }

    /// A load in the image of the point where it acts, and its moment as a couple.
    fn load(&self, load: &Acting, kind: VectorKind, symbol: &Text, what: &Text) -> Vec<ConstructionStep> {
        let (force_of, couple) = (load.wrench.force(), load.couple(self.bodies));
        let mut steps = Vec::new();
        if let Some(at) = load.at.filter(|_| force_of != [0.0, 0.0]) {
            if load.parts(&self.linkage.mechanism, self.bodies).is_some() {
                steps.push(self.image_step(
                    name("k"),
                    self.image(load.link, at),
                    text!("force-lever-contact", what),
                ));
            }
            let note = text!("force-lever-at", what);
            let names = [symbol, what].map(Text::clone);
            steps.push(force(names, kind, [self.image(load.link, at), force_of], note));
        }
        // What is left of the moment of a force about its own point is rounding.
        let size = self.linkage.structure.scale * length(force_of);
        if couple.abs() > 1e-12 * size {
            // Its force has the symbol already.
            let primed = joined("", [symbol.clone(), name("′")]);
            let symbol = if steps.is_empty() { symbol } else { &primed };
            steps.extend(self.couple(load.link, couple, kind, symbol, what));
        }
        steps
    }

    /// A moment on a link as two opposite forces across the line of two of its points. One in a point at rest has no moment about
    /// the pole and is not drawn: a moment on the crank is a force across it at its pin.
    fn couple(
        &self,
        link: LinkId,
        moment: f64,
        kind: VectorKind,
        symbol: &Text,
        what: &Text,
    ) -> Vec<ConstructionStep> {
        let (body, places) = (&self.bodies[link], self.places(link));
        if places.len() < 2 {
            // A slider turns as the link on whose guide it slides, and with the ground not at all.
            let mut slides = self.linkage.mechanism.slides.iter();
            match slides.find_map(|slide| (slide.link == link).then_some(slide.on)) {
                Some(GROUND) => return Vec::new(),
                Some(on) if self.places(on).len() > 1 => return self.couple(on, moment, kind, symbol, what),
                _ => {}
            }
        }
        let far = |from: &Named<'_>, to: &Named<'_>| length(minus(to.at, from.at));
        let from = places.iter().find(|place| place.rests).or(places.first());
        let to = from.and_then(|from| places.iter().max_by(|a, b| far(from, a).total_cmp(&far(from, b))));
        // A link without two points has an arm of 1 m.
        let ends = from.zip(to).filter(|(from, to)| far(from, to) > 0.0);
        let origin = [body.x, body.y];
        let [(at_from, rests), (at_to, _)] = match ends {
            Some((from, to)) => [(from.at, from.rests), (to.at, to.rests)],
            None => [(origin, false), ([origin[0] + 1.0, origin[1]], false)],
        };
        let arm = minus(at_to, at_from);
        let across = scaled(moment / (arm[0] * arm[0] + arm[1] * arm[1]), perp(arm));
        let told = if moment == 0.0 { "0".to_owned() } else { format!("{moment:.6e}") };
        let told = quantity(told, "N m");
        let at = |end: Option<&Named<'_>>| end.map_or_else(Text::default, |end| Text::from(end.name));
        let step = |place: [f64; 2], vector, end: Text, symbol: Text| {
            let note = text!("force-lever-couple", couple = &told, what, point = end);
            force([symbol, what.clone()], kind, [self.image(link, place), vector], note)
        };
        let mut steps = vec![step(at_to, across, at(ends.map(|(_, to)| to)), symbol.clone())];
        if !rests {
            let second = joined("", [symbol.clone(), name("′")]);
            steps.push(step(at_from, opposite(across), at(ends.map(|(from, _)| from)), second));
        }
        steps
    }

    /// The balancing load where it acts; a moment on the crank as a force at its pin.
    fn balance(&self, size: f64) -> Vec<ConstructionStep> {
        let (mechanism, bodies) = (&self.linkage.mechanism, self.bodies);
        let (kind, symbol) = (VectorKind::Balancing, name("F").below(text!("force-lever-index")));
        let on_input = text!("force-lever-balancing-load");
        let driver = mechanism.input.first();
        let input = driver.link;
        match (UnitBalance::of(mechanism), mechanism.balance, driver.pair) {
            (Some(unit), Some(Balance::Force { at, .. }), _) => {
                let vector = scaled(size, unit.wrench(bodies).force());
                let image = self.image(at.link, bodies[at.link].point(at.at));
                let what = text!("force-lever-balancing-force");
                vec![force([symbol, what.clone()], kind, [image, vector], what)]
            }
            (Some(unit), ..) => {
                let what = text!("force-lever-balancing-moment");
                self.couple(unit.link, size * unit.wrench(bodies).m, kind, &symbol, &what)
            }
            (None, _, pair) => {
                // A drive between two links acts on the other one too, by the opposite load.
                let ends = [(input, size), (driver.on, -size)];
                let moving = ends.into_iter().filter(|(link, _)| *link != GROUND);
                let drawn = moving.flat_map(|(link, size)| {
                    let InputPair::Slide(slide) = pair else {
                        return self.couple(link, size, kind, &symbol, &on_input);
                    };
                    let (slide, along) =
                        (&mechanism.slides[slide], drive_direction(mechanism, driver, bodies));
                    let image = self.image(link, bodies[slide.link].point(slide.point));
                    let vector = scaled(size, along.unwrap_or_default());
                    let named = [symbol.clone(), on_input.clone()];
                    vec![force(named, kind, [image, vector], on_input.clone())]
                });
                drawn.collect()
            }
        }
    }
}

/// A named point of a link.
struct Named<'a> {
    name: &'a assur_mechanism::Name,
    /// Its place in the ground's frame, m.
    at: [f64; 2],
    /// Whether it is a point of the ground.
    rests: bool,
}
