//! What acts on the links in a state of the motion: loads with the contacts and the drive, the reactions of the pairs with the balancing load.

use assur_analysis::results::{Column, Owner, Quantity, Schema};
use assur_book::catalogue;
use assur_figure::{Ink, Point, Stroke};
use assur_force::{Cause, LoadState, UnitBalance, drive_direction};
use assur_kinematics::Position;
use assur_mechanism::{Balance, Driver, GROUND, InputPair, LinkId, PairId};
use assur_words::{Text, joined, name, text};

use crate::arrows::{Arrow, Kind};
use crate::{Arrows, Results};

/// The forces and moments in a state, each with its symbol.
pub(crate) struct Acting<'a> {
    results: &'a Results,
    pose: &'a Position,
    state: &'a LoadState,
    /// What acts on these links alone; `None`: on all.
    links: Option<&'a [LinkId]>,
    all: Vec<Arrow>,
}

impl<'a> Acting<'a> {
    /// The contacts in any case; the loads of the scene, all loads with the moment of the drive, or the reactions with that of the drive
    /// or the balancing load, where they are wanted.
    pub(crate) fn of(
        results: &'a Results,
        wanted: Arrows,
        pose: &'a Position,
        state: &'a LoadState,
    ) -> Vec<Arrow> {
        let mut own = Self { results, pose, state, links: None, all: Vec::new() };
        own.loads(wanted);
        if wanted == Arrows::Reactions {
            own.reactions();
        }
        own.all
    }

    /// The loads on some links that are taken out of the mechanism, and what the bodies that stay do to them.
    pub(crate) fn on(
        results: &'a Results,
        links: &'a [LinkId],
        pose: &'a Position,
        state: &'a LoadState,
    ) -> Vec<Arrow> {
        let mut own = Self { results, pose, state, links: Some(links), all: Vec::new() };
        own.loads(Arrows::Loads);
        own.reactions();
        own.all
    }

    /// Whether what acts on a link is wanted.
    fn concerns(&self, link: LinkId) -> bool {
        self.links.is_none_or(|links| links.contains(&link))
    }

    fn push(
        &mut self,
        at: Point,
        kind: Kind,
        vector: [f64; 2],
        [name, told]: [Text; 2],
        style: (Stroke, Ink),
    ) {
        let of_pair = style.1 == Ink::First;
        self.all.push(Arrow { at, kind, vector, name, told, style, of_pair });
    }

    /// A force and a moment at a place, with their symbols and what they are.
    fn act(&mut self, at: Point, force: [f64; 2], moment: f64, symbols: [Text; 2], told: &Text, ink: Ink) {
        let parts = [(Kind::Force, force), (Kind::Moment, [moment, 0.0])];
        for ((kind, vector), symbol) in parts.into_iter().zip(symbols) {
            self.push(at, kind, vector, [symbol, told.clone()], (Stroke::Solid, ink));
        }
    }

    /// A load has the number that it has in the constructions; a contact its point K, the normal force and the friction, dashed, and their
    /// sum.
    fn loads(&mut self, wanted: Arrows) {
        let all_wanted = wanted == Arrows::Loads;
        let (mechanism, bodies) = (&self.results.linkage.mechanism, &self.pose.bodies);
        let Some(found) = self.results.found.as_deref().map(|found| found.plans.calculation()) else {
            return;
        };
        let are_wanted =
            |cause: Cause| all_wanted || wanted == Arrows::Applied && matches!(cause, Cause::Load(_));
        let loads = found.loads.as_ref();
        let loads =
            loads.filter(|_| found.positions_have_forces() || all_wanted || wanted == Arrows::Applied);
        let list = loads.map_or_else(Vec::new, |loads| loads.acting(self.state, bodies));
        let contacts = mechanism.loads.iter().filter(|load| load.kind.contact().is_some()).count();
        let mut nth = 0;
        for (number, load) in list.iter().enumerate() {
            if !self.concerns(load.link) {
                continue;
            }
            let (told, force) = (Text::from(load.cause.name(mechanism)), load.wrench.force());
            if let (Some([normal, friction]), Some(at)) = (load.parts(mechanism, bodies), load.at) {
                nth += 1;
                let suffix = if contacts > 1 { nth.to_string() } else { String::new() };
                let numbered = |symbol| joined("", [symbol, name(suffix.clone())]);
                let part = |index| [name("F").below(numbered(index)), Text::default()];
                let [line, dashed] = [Stroke::Solid, Stroke::Dashed].map(|stroke| (stroke, Ink::Second));
                self.push(at, Kind::Force, [0.0; 2], [numbered(name("K")), Text::default()], line);
                self.push(at, Kind::Force, normal, part(name("c")), dashed);
                self.push(at, Kind::Force, friction, part(text!("index-of-friction")), dashed);
                self.push(at, Kind::Force, force, [numbered(name("F")), told], line);
            } else if are_wanted(load.cause) {
                let at = load.at.unwrap_or_else(|| self.anchor(load.link));
                let symbols = ["F", "M"].map(|letter| name(format!("{letter}{}", number + 1)));
                self.act(at, force, load.couple(bodies), symbols, &told, Ink::Second);
            }
        }
        let drives = mechanism.input.placed().any(|link| self.concerns(link));
        // A drive keeps up the motion in the place of a balancing load.
        let is_wanted = drives && (all_wanted || wanted == Arrows::Reactions);
        if let Some([drive, inertia]) = found.drive_in(self.state).filter(|_| is_wanted) {
            let told = catalogue::kind(Column::of(Quantity::ReducedLoad, Owner::Input));
            self.on_input(None, drive, &text!("index-of-drive"), &told);
            // No link has the inertia of flywheel and rotor; with their load the moments on the input link balance.
            if inertia > 0.0 {
                let load = -inertia * self.state.acceleration;
                self.on_input(None, load, &text!("index-of-flywheel"), &text!("acting-flywheel"));
            }
        }
    }

    /// The reactions on the links on which they are shown, and the balancing load; none where they are not determined.
    fn reactions(&mut self) {
        let (linkage, pose) = (&self.results.linkage, self.pose);
        let mechanism = &linkage.mechanism;
        let Some(calculation) = self.results.found.as_deref().map(|found| found.plans.calculation()) else {
            return;
        };
        let Some(found) = calculation.reactions(self.state, pose) else { return };
        let schema = Schema::new(mechanism);
        let pairs: Vec<_> = found.reactions.iter().map(|force| (force.joint.id, force.on.id)).collect();
        let shown = self.links.map_or_else(|| catalogue::shown(&pairs), |links| outer(&pairs, links));
        for force in found.reactions.iter().filter(|force| shown.contains(&(force.joint.id, force.on.id))) {
            let (pair, on) = (force.joint.id, force.on.id);
            let at = match pair {
                PairId::Pin(point) => linkage.point_motion(point, pose).pf0,
                PairId::Slide(id) => pose.bodies[mechanism.slides[id].link].point(mechanism.slides[id].point),
            };
            let told = catalogue::owner(&schema, Column::of(Quantity::Force, Owner::PairOn(pair, on)));
            // Of several links each has its own force.
            let several = shown.iter().filter(|(own, _)| *own == pair).count() > 1;
            let link = if several { format!(",{on}") } else { String::new() };
            let index = joined("", [Text::from(&force.joint.name), name(link)]);
            let symbols = ["R", "M"].map(|letter| name(letter).below(&index));
            self.act(at, force.force, force.moment.unwrap_or_default(), symbols, &told, Ink::First);
        }
        let balanced = |link| self.concerns(link);
        let acts = match mechanism.balance {
            Some(Balance::Moment(link)) => balanced(link),
            Some(Balance::Force { at, .. }) => balanced(at.link),
            None => mechanism.input.placed().any(balanced),
        };
        if acts && calculation.drive_in(self.state).is_none() {
            let told = catalogue::kind(Column::BALANCING);
            if mechanism.input.sole().is_some() {
                self.on_input(
                    UnitBalance::of(mechanism),
                    found.balancing,
                    &text!("index-of-balancing"),
                    &told,
                );
            }
            for ((index, driver), size) in mechanism.input.drivers.iter().enumerate().zip(&found.drives) {
                let index = joined("", [text!("index-of-balancing"), name((index + 1).to_string())]);
                self.by_driver(driver, *size, &index, &told);
            }
        }
    }

    /// The load of a drive on its link; of a slide between two moving links on both.
    fn by_driver(&mut self, driver: &Driver, size: f64, index: &Text, told: &Text) {
        let (mechanism, bodies) = (&self.results.linkage.mechanism, &self.pose.bodies);
        let along = drive_direction(mechanism, driver, bodies).map_or([0.0, 0.0, 1.0], |[x, y]| [x, y, 0.0]);
        let [x, y, moment] = along;
        let at = self.of_driver(driver);
        let symbols = with_index(index);
        // A cylinder pushes both of its links.
        let is_pair = driver.is_relative() && !driver.is_angle();
        for size in [size, -size].into_iter().take(if is_pair { 2 } else { 1 }) {
            self.act(at, [size * x, size * y], size * moment, symbols.clone(), told, Ink::Second);
        }
    }

    /// What acts on the input along its coordinate, or where the scene has its balancing load.
    fn on_input(&mut self, unit: Option<UnitBalance>, size: f64, index: &Text, told: &Text) {
        let results = self.results;
        let (mechanism, bodies) = (&results.linkage.mechanism, &self.pose.bodies);
        let (at, [x, y, moment]) = match (unit.map(|unit| unit.wrench(bodies)), mechanism.balance) {
            (Some(unit), Some(Balance::Force { at, .. })) => {
                (bodies[at.link].point(at.at), [unit.fx, unit.fy, 0.0])
            }
            (Some(unit), Some(Balance::Moment(link))) => (self.anchor(link), [0.0, 0.0, unit.m]),
            _ => return self.by_driver(mechanism.input.first(), size, index, told),
        };
        let symbols = with_index(index);
        self.act(at, [size * x, size * y], size * moment, symbols, told, Ink::Second);
    }

    /// Where the load of a drive is drawn: at the pair between two moving links, else at the input link.
    fn of_driver(&self, driver: &Driver) -> Point {
        let mechanism = &self.results.linkage.mechanism;
        match driver.pair {
            _ if !driver.is_relative() => self.anchor(driver.link),
            InputPair::Pin(pin) => self.results.linkage.point_motion(pin, self.pose).pf0,
            InputPair::Slide(slide) => {
                let slide = &mechanism.slides[slide];
                self.pose.bodies[slide.link].point(slide.point)
            }
        }
    }

    /// Where a moment on a link is drawn: at its point on the ground, or at its first one.
    fn anchor(&self, link: LinkId) -> Point {
        let points = self.results.linkage.mechanism.points.iter().filter(|point| point.on(link).is_some());
        let found = points.min_by_key(|point| point.on(GROUND).is_none());
        self.pose.bodies[link].point(found.and_then(|point| point.on(link)).unwrap_or_default())
    }
}

/// The symbols of a force and of a moment with an index.
fn with_index(index: &Text) -> [Text; 2] {
    ["F", "M"].map(|letter| name(letter).below(index))
}

/// The pairs of some links with other bodies, each with the link on which its force is told.
fn outer(pairs: &[(PairId, LinkId)], links: &[LinkId]) -> Vec<(PairId, LinkId)> {
    let is_outer = |(pair, on): &&(PairId, LinkId)| {
        let mut others = pairs.iter().filter(|(other, link)| other == pair && link != on).peekable();
        links.contains(on) && (others.peek().is_none() || others.any(|(_, link)| !links.contains(link)))
    };
    pairs.iter().filter(is_outer).copied().collect()
}
