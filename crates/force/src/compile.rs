//! From the loads of a scene to flat compiled ones.

use std::{f64::consts::TAU, mem::discriminant, sync::Arc};

use assur_formula::Formula;
use assur_group::Body;
use assur_kinematics::{AssemblyRange, Linkage};
use assur_mechanism::{
    Contact, Direction, Driver, Force, GROUND, InputPair, LawTable, LinkId, Load, LoadId, LoadKind,
    Mechanism, Over, Place, Value,
};
use assur_number::elementary;
use assur_words::{Text, text};

use crate::grid::{Bodies, GRID, Span, rests};
use crate::loads::{Action, Along, Applied, ArcContact, Mass, PointForce, Shoe};
use crate::place::PlaceCourse;
use crate::sliding::{Rate, Sliding};
use crate::stroke::{Stroke, Travel};
use crate::{
    Bearing, Block, Frictions, LoadError, LoadFault, LoadState, Loads, Unknown, breaks::Breaks, curve::Curve,
    formula::FormulaLaw, law::Law,
};

/// How far from the first position the search over a cycle starts, as part of the cycle: much less than a cell of the
/// grid.
pub(crate) const BESIDE: f64 = 3.819_660_112_501_05e-4;

/// Fraction of the range that is skipped at each end, where the mechanism is nearly singular.
const AT_ENDS: f64 = 1e-9;

/// Of more cycles than these the cells in which a switch is looked for grow.
const MOST_CYCLES: u32 = 100;

/// Angles of a contact nearer to each other than this are the same, rad.
const SAME_ANGLE: f64 = 1e-9;

struct Compiler<'a> {
    linkage: &'a Linkage,
    mechanism: &'a Mechanism,
    /// A mechanism with the same positions, and its loads.
    earlier: Option<(&'a Mechanism, &'a Loads)>,
}

impl Loads {
    /// Compiles the loads of a mechanism.
    ///
    /// A stroke is the one over the cycle; if the mechanism can't turn fully and the scene gives a range, the one over
    /// the range. Its extremes, and the places where it passes the rows of its tables, are found to rounding.
    pub fn compile(linkage: &Linkage) -> Result<Self, LoadError> {
        Self::varied(linkage, None)
    }

    /// Compiles the loads of a mechanism, except those that it has in common with an `earlier` one: with the same positions,
    /// and with loads that differ from its own in numbers only.
    pub fn varied(linkage: &Linkage, earlier: Option<(&Mechanism, &Self)>) -> Result<Self, LoadError> {
        let (mechanism, scale) = (&linkage.mechanism, linkage.structure.scale);
        let input = &mechanism.input;
        let standing = if input.is_angle() { 1e-14 * scale } else { 1e-14 };
        let crank = input.sole().filter(|driver| !driver.is_relative());
        let pin = |driver: &Driver| match driver.pair {
            InputPair::Pin(point) => mechanism.place_in(point, driver.link),
            InputPair::Slide(_) => None,
        };
        let mut loads = Self {
            masses: Mass::all(mechanism),
            gravity: mechanism.gravity.unwrap_or_default(),
            applied: Vec::new(),
            frictions: None,
            sense: input.sign(),
            period: input.period(),
            law: input.drivers[0].law.clone().filter(|_| input.drivers.len() == 1),
            standing,
            inertia_constant: mechanism.has_constant_reduced_inertia(),
            links: mechanism.links.len(),
            input: crank.map(|driver| (driver.link, pin(driver))),
        };
        let compiler = Compiler { linkage, mechanism, earlier };
        for (id, load) in mechanism.loads.iter().enumerate() {
            // Nothing on the ground moves; a spring on it pulls at its other end.
            if load.kind.links().any(|link| link != GROUND) {
                let applied = compiler.load(id, load, &loads);
                loads.applied.push(applied.map_err(|fault| LoadError { load: (&load.name).into(), fault })?);
            }
        }
        compiler.frictions(&mut loads);
        Ok(loads)
    }
}

impl<'a> Compiler<'a> {
    /// Whether the motion is given, so that nothing steps along it.
    fn is_given(&self) -> bool {
        !self.mechanism.has_equation_of_motion()
    }

    fn needs_motion(&self, what: Text) -> Result<(), LoadFault> {
        if self.mechanism.motion.is_some() { Ok(()) } else { Err(LoadFault::NeedsMotion(what)) }
    }

    /// A load as it was compiled before, if nothing that it depends on has changed.
    fn same(&self, id: LoadId) -> Option<&'a Applied> {
        let (mechanism, loads) = self.earlier?;
        let load = mechanism.loads.get(id)?;
        let [before, now] = [mechanism, self.mechanism].map(|mechanism| mechanism.motion.as_ref());
        let same_motion = before == now
            || before.map(discriminant) == now.map(discriminant)
                && !load.kind.laws().any(Value::follows_motion);
        let found = loads.applied.binary_search_by_key(&id, |load| load.id).ok()?;
        (same_motion && *load == self.mechanism.loads[id]).then(|| &loads.applied[found])
    }

    fn load(&self, id: LoadId, load: &Load, loads: &Loads) -> Result<Applied, LoadFault> {
        if let Some(same) = self.same(id) {
            return Ok(same.clone());
        }
        let place = match &load.kind {
            LoadKind::Force(Force { at, .. }) | LoadKind::Contact(Contact { center: at, .. }) => Some(*at),
            LoadKind::Moment(_) | LoadKind::Brake(_) | LoadKind::Spring(_) => None,
        };
        let size = load.kind.law().map_or(Ok(Law::Constant(0.0)), |value| self.law(place, value))?;
        Ok(Applied { id, size, action: self.action(&load.kind, loads)? })
    }

    fn action(&self, load: &LoadKind, loads: &Loads) -> Result<Action, LoadFault> {
        Ok(match load {
            LoadKind::Force(Force { at, direction, .. }) => {
                let (at, mut rests) = (*at, Breaks::default());
                let along = match direction {
                    Direction::Ground(angle) => {
                        Along::Ground([elementary::cos(*angle), elementary::sin(*angle)])
                    }
                    Direction::Link(angle) => Along::Link([elementary::cos(*angle), elementary::sin(*angle)]),
                    Direction::AgainstMotion => {
                        self.needs_motion(text!("force-against-motion"))?;
                        let motion = |body: &Body<f64>| body.motion(body.arm(at.at));
                        rests = self.rests(motion, at.link);
                        Along::AgainstMotion
                    }
                };
                Action::Force(PointForce { at, along, rests })
            }
            LoadKind::Moment(moment) if moment.against_motion => {
                self.needs_motion(text!("force-moment-against-motion"))?;
                Action::Brake(self.shoe(moment.link, 1.0))
            }
            LoadKind::Moment(moment) => Action::Moment(moment.link),
            LoadKind::Brake(brake) => {
                self.needs_motion(text!("force-brake"))?;
                Action::Brake(self.shoe(brake.link, brake.moment_of_unit_force()))
            }
            LoadKind::Spring(spring) => {
                if spring.damping != 0.0 {
                    self.needs_motion(text!("force-damping"))?;
                }
                Action::Spring(*spring)
            }
            LoadKind::Contact(contact) => Action::Contact(Box::new(self.contact(contact, loads)?)),
        })
    }

    /// What is against the rotation of a link; `lever`: its moment where its law gives 1.
    fn shoe(&self, link: LinkId, lever: f64) -> Shoe {
        let rests = self.rests(|body| [[body.w1, 0.0], [body.w2, 0.0]], link);
        Shoe { link, reach: self.linkage.structure.scale, lever, rests }
    }

    fn contact(&self, contact: &Contact, loads: &Loads) -> Result<ArcContact, LoadFault> {
        let (breaks, touching) = contact_breaks(contact.during, loads.period);
        let angle = self.law(None, &contact.angle)?;
        let sliding =
            if contact.against_sliding { Some(self.sliding(loads, contact, &angle)?) } else { None };
        let &Contact { center, radius, friction, .. } = contact;
        Ok(ArcContact { center, radius, angle, friction, sliding, breaks, touching })
    }

    /// The dry friction of the pairs, if there is any.
    fn frictions(&self, loads: &mut Loads) {
        if self.mechanism.frictions.is_empty() {
            return;
        }
        let (bearings, structure) =
            (Bearing::all(self.linkage, &self.span_of_friction()), &self.linkage.structure);
        let unknowns = Unknown::all(self.mechanism, structure, &bearings);
        let (blocks, whole) = Block::all(structure, &self.mechanism.input, &bearings, &unknowns);
        loads.frictions = Some(Arc::new(Frictions { bearings, unknowns, blocks, whole }));
    }

    /// Where the senses of friction are looked for: over the cycle, or where an input that can't turn fully may be. Positions of a
    /// given motion beyond the gap are there again, perhaps by a whole turn, so that the cycle is looked at with its gap.
    fn span_of_friction(&self) -> Span {
        let whole = self.linkage.range.filter(|range| !range.full && self.linkage.kind().is_angle());
        let listed = self.positions();
        let leaves =
            |range: &AssemblyRange| listed.from < range.low || listed.from + listed.length > range.high;
        let goes_beyond =
            |range: &AssemblyRange| self.is_given() && leaves(range) && range.high - range.low < TAU;
        if let Some(range) = whole.filter(|range| !goes_beyond(range)) {
            let length = range.high - range.low;
            let from = range.low + AT_ENDS * length;
            return Span { from, length: (1.0 - 2.0 * AT_ENDS) * length, periodic: false, cells: GRID };
        }
        self.spans().first().map_or_else(|| self.positions(), |span| self.reach(span))
    }

    /// In which sense the arc of a contact slides, found before the motion.
    fn sliding(&self, loads: &Loads, contact: &Contact, angle: &Law) -> Result<Sliding, LoadFault> {
        let angle = |q: f64| loads.value_of(angle, &LoadState::prescribed(self.mechanism, q));
        let cycle = self.spans().first().map(|span| self.reach(span));
        let repeats = |span: &Span| {
            let again = |q: f64| (angle(q + span.length) - angle(q)).abs() <= SAME_ANGLE;
            !span.periodic || (0..span.cells).all(|cell| again(span.at(cell)))
        };
        let span = match cycle.filter(repeats) {
            Some(span) => span,
            None if !self.is_given() => return Err(LoadFault::UnlocatedSliding),
            None => self.positions(),
        };
        let (center, step) = (contact.center, 1e-3 * span.length / f64::from(span.cells));
        let mut bodies = Bodies::new(self.linkage, span);
        let mut rate = |q: f64| {
            let body = bodies.at(q, center.link)?;
            let turning = (angle(q + step) - angle(q - step)) / (2.0 * step);
            Ok(Rate::of(&body, center.at, contact.radius, [angle(q), turning]))
        };
        let found = Sliding::find(&mut rate, &span);
        if !found.never_moves() {
            return Ok(found);
        }
        // A mechanism that can be assembled over less than a cell of the grid is met at the positions of the scene alone.
        let listed = self.positions();
        let steps = u32::try_from(self.mechanism.input.positions).unwrap_or(u32::MAX).saturating_sub(1);
        Ok(Sliding::find(&mut rate, &Span { cells: steps.clamp(1, listed.cells), ..listed }))
    }

    fn law(&self, at: Option<Place>, value: &Value) -> Result<Law, LoadFault> {
        match value {
            Value::Constant(value) => Ok(Law::Constant(*value)),
            Value::Table { over: Over::Coordinate, table, repeat } => {
                let period = if *repeat { self.mechanism.input.period() } else { None };
                let table = Curve::of(table);
                let breaks = Breaks::new(table.arguments().to_vec(), period);
                Ok(Law::Coordinate(table, breaks))
            }
            Value::Table { over: Over::Speed, table, .. } => {
                self.needs_motion(text!("force-over-speed"))?;
                Ok(Law::Speed(Curve::of(table)))
            }
            Value::Table { over: Over::Time, table, .. } => {
                self.needs_motion(text!("force-over-time"))?;
                Ok(Law::Time(Curve::of(table)))
            }
            Value::Formula { formula, factor, axis } => self.formula(at, formula, *factor, *axis),
            Value::Stroke { axis, forward, back } => {
                let at = at.ok_or(LoadFault::StrokeOfMoment)?;
                self.stroke(at, *axis, [forward, back])
            }
        }
    }

    fn formula(
        &self,
        at: Option<Place>,
        formula: &Formula,
        factor: f64,
        axis: Option<f64>,
    ) -> Result<Law, LoadFault> {
        let used = formula.used();
        if used.speed || used.time {
            self.needs_motion(text!("force-formula-of-motion"))?;
        }
        let steps = !self.is_given();
        let mut law = FormulaLaw::new(formula.clone(), factor, steps);
        let motion = |q: f64| LoadState::prescribed(self.mechanism, q);
        let of_drive = self.mechanism.input.first().law.as_ref();
        law.check_changes(self.cycle(), |q| {
            of_drive.map_or_else(|| motion(q), |law| motion(q).of_drive(law))
        })?;
        if let (Some(axis), true) = (axis, used.place) {
            let at = at.ok_or(LoadFault::StrokeOfMoment)?;
            let scale = self.linkage.structure.scale;
            law = self.over_stroke(at, axis, |bodies, span| {
                let travel = Travel::find(&mut |q| bodies.at(q, at.link), at.at, axis, span, scale)?;
                let along = |span: Span| {
                    let mut bodies = Bodies::new(self.linkage, span);
                    let point = |q: f64| {
                        let body = bodies
                            .at(q, at.link)
                            .map_err(|reason| LoadFault::NoPosition(q, Box::new(reason)))?;
                        Ok((motion(q), body.point(at.at)))
                    };
                    law.clone().along(travel, &span, point)
                };
                // What does not repeat with the cycle changes along the positions. Nothing is known of the switches in a cell.
                let reach = Span { cells: GRID, ..self.reach(span) };
                let repeating = if law.mixes_place() { None } else { along(reach)? };
                let found = match repeating {
                    Some(found) => found,
                    None => along(self.positions())?.unwrap_or_else(|| law.clone()),
                };
                if !found.meets_places() {
                    return Ok(found);
                }
                let course = PlaceCourse::fit(&reach, |q| travel.motion(bodies, (q, at)))?;
                Ok(found.with_places(course))
            })?;
        }
        Ok(Law::Formula(Box::new(law)))
    }

    fn stroke(&self, at: Place, axis: f64, tables: [&LawTable; 2]) -> Result<Law, LoadFault> {
        let scale = self.linkage.structure.scale;
        let find = |bodies: &mut Bodies<'_>, span: &Span| {
            let spans = [span, &self.reach(span)];
            Stroke::find(&mut |q| bodies.at(q, at.link), at.at, axis, tables, spans, scale)
        };
        self.over_stroke(at, axis, find).map(|stroke| Law::Stroke(Box::new(stroke)))
    }

    /// What is found over the cycle or, where the mechanism can't take all its positions, over the range of the scene.
    fn over_stroke<T>(
        &self,
        at: Place,
        axis: f64,
        mut find: impl FnMut(&mut Bodies<'_>, &Span) -> Result<T, LoadFault>,
    ) -> Result<T, LoadFault> {
        let mut outcome = Err(LoadFault::NoStroke(0.0));
        for span in self.spans().into_iter().map(|span| span.for_stroke(self.linkage, at, axis)) {
            outcome = find(&mut Bodies::new(self.linkage, span), &span);
            // A range may be all that the mechanism can do of its turn.
            if !matches!(outcome, Err(LoadFault::NoPosition(..))) {
                break;
            }
        }
        outcome
    }

    /// Where the motion may be, of which the span of a stroke is a part: a range lists places, and a motion that an equation
    /// determines may leave it.
    fn reach(&self, span: &Span) -> Span {
        let stays = self.is_given() || span.periodic;
        let Some(whole) = self.linkage.range.filter(|_| !stays) else { return *span };
        if whole.full {
            return Span { length: TAU, periodic: true, cells: GRID, ..*span };
        }
        let beside = AT_ENDS * (whole.high - whole.low);
        let from = span.from.min(whole.low + beside);
        let length = (span.from + span.length).max(whole.high - beside) - from;
        if length.is_finite() { Span { from, length, cells: GRID, ..*span } } else { *span }
    }

    /// Rests are needed only for the integration: at a single position the velocity itself is known.
    fn rests(&self, motion: impl Fn(&Body<f64>) -> [[f64; 2]; 2], link: LinkId) -> Breaks {
        if self.is_given() {
            return Breaks::default();
        }
        let Some(span) = self.spans().first().map(|span| self.reach(span)) else { return Breaks::default() };
        let mut bodies = Bodies::new(self.linkage, span);
        rests(&mut |q| bodies.at(q, link).map(|body| motion(&body)), &span)
    }

    /// A cycle from the first position; where the input has none, its range.
    fn cycle(&self) -> [f64; 2] {
        let input = &self.mechanism.input;
        match input.period() {
            Some(period) if input.turns_wholly() => [input.from, input.from + period],
            _ => sorted(input.ends()),
        }
    }

    /// The interval of the positions of the scene, in as many cells a cycle as any other.
    fn positions(&self) -> Span {
        let input = &self.mechanism.input;
        let ends = [input.from, input.coordinate(input.positions.saturating_sub(1))];
        let (from, length) = (ends[0].min(ends[1]), (ends[1] - ends[0]).abs());
        let covers = |cycles: &u32| input.period().is_none_or(|period| f64::from(*cycles) * period >= length);
        let cycles = (1..MOST_CYCLES).find(covers).unwrap_or(MOST_CYCLES);
        Span { from, length, periodic: false, cells: GRID * cycles }
    }

    /// The interval of a stroke: a cycle of whole turns and, where the scene gives a range or another cycle, that.
    fn spans(&self) -> Vec<Span> {
        let input = &self.mechanism.input;
        // Dead points are often at round coordinates; a reversal on a grid point would be bracketed by rounding alone.
        let beside = |length: f64| input.from + BESIDE * length;
        let turns = input.period().filter(|_| input.turns_wholly());
        let cycle = turns.map(|length| Span { from: beside(length), length, periodic: true, cells: GRID });
        let [low, high] = sorted(input.ends());
        let listed = Span { from: low, length: high - low, periodic: false, cells: GRID };
        let own = (cycle.is_none() || !input.is_cycle()).then_some(listed);
        cycle.into_iter().chain(own).collect()
    }
}

fn sorted([one, other]: [f64; 2]) -> [f64; 2] {
    [one.min(other), one.max(other)]
}

/// The ends of a contact's interval, and which interval between them is the one with contact.
fn contact_breaks(during: Option<[f64; 2]>, period: Option<f64>) -> (Breaks, usize) {
    match (during, period) {
        (None, _) => (Breaks::default(), 0),
        (Some([from, to]), Some(period)) if to - from >= period => (Breaks::default(), 0),
        (Some([from, to]), Some(_)) => (Breaks::new(vec![from, to], period), 0),
        (Some([from, to]), None) => (Breaks::new(vec![from, to], None), 1),
    }
}
