//! From the loads of a scene to flat compiled ones.

use assur_formula::Formula;
use assur_group::Body;
use assur_kinematics::Linkage;
use assur_mechanism::{
    Contact, Direction, GROUND, InputPair, LinkId, Mechanism, Motion, Name, Over, Place, Range, Spring,
    Table, Value,
};
use assur_words::{Describe, Text, text};

use crate::breaks::Breaks;
use crate::curve::Curve;
use crate::formula::{FormulaLaw, Unlocated};
use crate::grid::{Bodies, GRID, Span, rests};
use crate::law::Law;
use crate::loads::{Along, ArcContact, LinkMoment, Mass, PointForce, SpringDamper};
use crate::sliding::{Rate, Sliding};
use crate::stroke::{NoStroke, Stroke, Travel};
use crate::{LoadError, Loads, State};

/// How far from the first position the search over a cycle starts, as part of the cycle: much less than a cell of the
/// grid.
const BESIDE: f64 = 3.819_660_112_501_05e-4;

/// How often a formula may change in a cycle: what follows its changes takes time and memory with their number.
const MOST_CHANGES: usize = 10_000;

/// Of more cycles than these the cells in which a switch is looked for grow.
const MOST_CYCLES: u32 = 100;

/// Angles of a contact nearer to each other than this are the same, rad.
const SAME_ANGLE: f64 = 1e-9;

/// What compiling needs.
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
    ///
    /// # Errors
    ///
    /// [`LoadError`] for a load that needs a motion or a stroke which the scene does not define.
    pub fn compile(linkage: &Linkage) -> Result<Self, LoadError> {
        Self::varied(linkage, None)
    }

    /// Compiles the loads of a mechanism, except those that it has in common with an `earlier` one: with the same positions,
    /// and with loads that differ from its own in numbers only.
    ///
    /// # Errors
    ///
    /// Those of [`compile`](Self::compile).
    pub fn varied(linkage: &Linkage, earlier: Option<(&Mechanism, &Self)>) -> Result<Self, LoadError> {
        let (mechanism, scale) = (&linkage.mechanism, linkage.structure.scale);
        let input = &mechanism.input;
        let (pin, standing) = match input.pair {
            InputPair::Pin(point) => (mechanism.place_in(point, input.link), 1e-14 * scale),
            InputPair::Slide(_) => (None, 1e-14),
        };
        let mut loads = Self {
            masses: Mass::all(mechanism),
            gravity: mechanism.gravity.unwrap_or_default(),
            forces: Vec::new(),
            moments: Vec::new(),
            springs: springs(mechanism)?,
            contacts: Vec::new(),
            laws: Vec::new(),
            sense: input.sign(),
            period: input.period(),
            standing,
            inertia_constant: mechanism.has_constant_reduced_inertia(),
            input: (input.link, pin),
        };
        let compiler = Compiler { linkage, mechanism, earlier };
        compiler.forces(&mut loads)?;
        compiler.moments(&mut loads)?;
        compiler.contacts(&mut loads)?;
        Ok(loads)
    }
}

fn springs(mechanism: &Mechanism) -> Result<Vec<SpringDamper>, LoadError> {
    let mut compiled = Vec::new();
    for (id, spring) in mechanism.springs.iter().enumerate() {
        if spring.damping != 0.0 {
            needs_motion(mechanism, &spring.name, text!("force-damping"))?;
        }
        // Between points of one link the two forces cancel.
        if spring.ends[0].link != spring.ends[1].link {
            let &Spring { ends, stiffness, length, damping, .. } = spring;
            compiled.push(SpringDamper { id, ends, stiffness, length, damping });
        }
    }
    Ok(compiled)
}

fn needs_motion(mechanism: &Mechanism, name: &Name, what: Text) -> Result<(), LoadError> {
    if mechanism.motion.is_some() {
        return Ok(());
    }
    Err(LoadError::NeedsMotion { name: name.into(), what })
}

impl<'a> Compiler<'a> {
    /// Whether the motion is given, so that nothing steps along it.
    fn is_given(&self) -> bool {
        matches!(self.mechanism.motion, None | Some(Motion::Prescribed { .. }))
    }

    /// The earlier loads, if this part of the mechanism was the same.
    fn same<T: PartialEq + 'a>(&self, part: impl Fn(&'a Mechanism) -> &'a T) -> Option<&'a Loads> {
        let (mechanism, loads) = self.earlier?;
        (part(mechanism) == part(self.mechanism)).then_some(loads)
    }

    fn forces(&self, loads: &mut Loads) -> Result<(), LoadError> {
        let mechanism = self.mechanism;
        for (id, force) in mechanism.forces.iter().enumerate().filter(|(_, force)| force.at.link != GROUND) {
            if let Some(same) = self.same(|mechanism| &mechanism.forces[id]) {
                loads.laws.push(same.laws[loads.laws.len()].clone());
                loads.forces.push(same.forces[loads.forces.len()].clone());
                continue;
            }
            let along = match force.direction {
                Direction::Ground(angle) => Along::Ground([angle.cos(), angle.sin()]),
                Direction::Link(angle) => Along::Link([angle.cos(), angle.sin()]),
                Direction::AgainstMotion => Along::AgainstMotion,
            };
            let mut breaks = Breaks::default();
            if along == Along::AgainstMotion {
                needs_motion(mechanism, &force.name, text!("force-against-motion"))?;
                let at = force.at.at;
                breaks = self
                    .rests(move |body| (body.first(body.arm(at)), body.second(body.arm(at))), force.at.link);
            }
            loads.laws.push(self.law(&force.name, Some(force.at), &force.value)?);
            loads.forces.push(PointForce { id, at: force.at, along, rests: breaks });
        }
        Ok(())
    }

    fn moments(&self, loads: &mut Loads) -> Result<(), LoadError> {
        let mechanism = self.mechanism;
        for (id, moment) in mechanism.moments.iter().enumerate().filter(|(_, moment)| moment.link != GROUND) {
            if let Some(same) = self.same(|mechanism| &mechanism.moments[id]) {
                loads.laws.push(same.laws[loads.laws.len()].clone());
                loads.moments.push(same.moments[loads.moments.len()].clone());
                continue;
            }
            loads.laws.push(self.law(&moment.name, None, &moment.value)?);
            let mut brake = None;
            if let Some(found) = moment.brake {
                needs_motion(mechanism, &moment.name, text!("force-brake"))?;
                brake = Some((found, self.rests(|body| ([body.w1, 0.0], [body.w2, 0.0]), moment.link)));
            }
            loads.moments.push(LinkMoment { id, link: moment.link, brake });
        }
        Ok(())
    }

    fn contacts(&self, loads: &mut Loads) -> Result<(), LoadError> {
        let mechanism = self.mechanism;
        for (id, contact) in mechanism.contacts.iter().enumerate().filter(|(_, c)| c.center.link != GROUND) {
            let (breaks, touching) = contact_breaks(contact.during, loads.period);
            loads.laws.push(self.law(&contact.name, Some(contact.center), &contact.force)?);
            let &Contact { center, radius, friction, .. } = contact;
            loads.contacts.push(ArcContact { id, center, radius, friction, sliding: None, breaks, touching });
        }
        for index in 0..loads.contacts.len() {
            let contact = &mechanism.contacts[loads.contacts[index].id];
            let angle = self.law(&contact.name, None, &contact.angle)?;
            if contact.against_sliding {
                loads.contacts[index].sliding = Some(self.sliding(loads, contact, &angle)?);
            }
            loads.laws.push(angle);
        }
        Ok(())
    }

    /// In which sense the arc of a contact slides, found before the motion.
    fn sliding(&self, loads: &Loads, contact: &Contact, angle: &Law) -> Result<Sliding, LoadError> {
        let angle = |q: f64| loads.value_of(angle, &State::prescribed(self.mechanism, q));
        let cycle = self.spans().first().map(|span| self.reach(span));
        let repeats = |span: &Span| {
            let again = |q: f64| (angle(q + span.length) - angle(q)).abs() <= SAME_ANGLE;
            !span.periodic || (0..span.cells).all(|cell| again(span.at(cell)))
        };
        let span = match cycle.filter(repeats) {
            Some(span) => span,
            None if !self.is_given() => return Err(LoadError::UnlocatedSliding(Text::from(&contact.name))),
            None => self.positions(),
        };
        let (center, step) = (contact.center, 1e-3 * span.length / f64::from(span.cells));
        let mut bodies = Bodies::new(self.linkage, span);
        let mut rate = |q: f64| {
            let body = bodies.at(q, center.link)?;
            let turning = (angle(q + step) - angle(q - step)) / (2.0 * step);
            Ok(Rate::of(&body, center.at, contact.radius, [angle(q), turning]))
        };
        Ok(Sliding::find(&mut rate, &span))
    }

    fn law(&self, name: &Name, at: Option<Place>, value: &Value) -> Result<Law, LoadError> {
        match value {
            Value::Constant(value) => Ok(Law::Constant(*value)),
            Value::Table { over: Over::Coordinate, table, repeat } => {
                let period = if *repeat { self.mechanism.input.period() } else { None };
                Ok(Law::over_coordinate(Curve::of(table), period))
            }
            Value::Table { over: Over::Speed, table, .. } => {
                needs_motion(self.mechanism, name, text!("force-over-speed"))?;
                Ok(Law::Speed(Curve::of(table)))
            }
            Value::Table { over: Over::Time, table, .. } => {
                needs_motion(self.mechanism, name, text!("force-over-time"))?;
                Ok(Law::Time(Curve::of(table)))
            }
            Value::Formula { formula, factor, axis } => self.formula(name, at, formula, *factor, *axis),
            Value::Stroke { axis, forward, back } => {
                let at = at.ok_or_else(|| LoadError::StrokeOfMoment(name.into()))?;
                self.stroke(name, at, *axis, [forward, back])
            }
        }
    }

    fn formula(
        &self,
        name: &Name,
        at: Option<Place>,
        formula: &Formula,
        factor: f64,
        axis: Option<f64>,
    ) -> Result<Law, LoadError> {
        let used = formula.used();
        if used.speed || used.time {
            needs_motion(self.mechanism, name, text!("force-formula-of-motion"))?;
        }
        let steps = !self.is_given();
        let place = |index: usize| {
            let span = &formula.switches()[index].span;
            (name.into(), formula.text()[span.clone()].to_owned(), span.start + 1)
        };
        let unlocated = |Unlocated(index)| {
            let (name, function, column) = place(index);
            LoadError::Unlocated { name, function, column }
        };
        let mut law = FormulaLaw::new(formula.clone(), factor, steps).map_err(unlocated)?;
        let motion = |q: f64| State::prescribed(self.mechanism, q);
        if let Some(index) = law.changing_too_often(self.cycle(), MOST_CHANGES, motion) {
            let (name, function, column) = place(index);
            return Err(LoadError::ChangesTooOften { name, function, column, most: MOST_CHANGES });
        }
        if let (Some(axis), true) = (axis, used.place) {
            let at = at.ok_or_else(|| LoadError::StrokeOfMoment(name.into()))?;
            let scale = self.linkage.structure.scale;
            let found = self.over_stroke(name, at, axis, |bodies, span| {
                let travel = Travel::find(&mut |q| bodies.at(q, at.link), at.at, axis, span, scale)?;
                let along = |span: Span| {
                    let mut bodies = Bodies::new(self.linkage, span);
                    let point = |q: f64| {
                        let body = bodies.at(q, at.link).map_err(|reason| NoStroke::NoPosition(q, reason))?;
                        Ok((motion(q), body.point(at.at)))
                    };
                    law.clone().along(travel, &span, point)
                };
                // Nothing is known of the switches in a cell.
                let repeated = if law.mixes_place() {
                    None
                } else {
                    Some(along(Span { cells: GRID, ..self.reach(span) })?)
                };
                match repeated {
                    Some(found) if steps || found.is_ok() => Ok(found),
                    // What does not repeat with the cycle changes along the positions.
                    _ => along(self.positions()),
                }
            })?;
            law = found.map_err(unlocated)?;
        }
        Ok(Law::Formula(Box::new(law)))
    }

    fn stroke(&self, name: &Name, at: Place, axis: f64, tables: [&Table; 2]) -> Result<Law, LoadError> {
        let scale = self.linkage.structure.scale;
        let find = |bodies: &mut Bodies<'_>, span: &Span| {
            let spans = [span, &self.reach(span)];
            Stroke::find(&mut |q| bodies.at(q, at.link), at.at, axis, tables, spans, scale)
        };
        self.over_stroke(name, at, axis, find).map(|stroke| Law::Stroke(Box::new(stroke)))
    }

    /// What is found over the cycle or, where the mechanism can't take all its positions, over the range of the scene.
    fn over_stroke<T>(
        &self,
        name: &Name,
        at: Place,
        axis: f64,
        mut find: impl FnMut(&mut Bodies<'_>, &Span) -> Result<T, NoStroke>,
    ) -> Result<T, LoadError> {
        let mut outcome = Err(NoStroke::Stands(0.0));
        for span in self.spans().into_iter().map(|span| span.for_stroke(self.linkage, at, axis)) {
            outcome = find(&mut Bodies::new(self.linkage, span), &span);
            // A range may be all that the mechanism can do of its turn.
            if !matches!(outcome, Err(NoStroke::NoPosition(..))) {
                break;
            }
        }
        let name = name.into();
        match outcome {
            Ok(found) => Ok(found),
            Err(NoStroke::Stands(travel)) => Err(LoadError::NoStroke { name, travel }),
            Err(NoStroke::Infinite(coordinate)) => Err(LoadError::InfiniteStroke { name, coordinate }),
            Err(NoStroke::NoPosition(coordinate, error)) => {
                Err(LoadError::NoPosition { name, coordinate, reason: error.describe() })
            }
        }
    }

    /// Where the motion may be, of which the span of a stroke is a part: a range lists places, and a motion that an equation
    /// determines may leave it.
    fn reach(&self, span: &Span) -> Span {
        /// At its ends the mechanism just holds together: part of the whole that is left out there.
        const BESIDE: f64 = 1e-9;
        let stays = self.is_given();
        let whole = self.linkage.range.filter(|range| !(stays || span.periodic || range.full));
        let Some(whole) = whole else { return *span };
        let beside = BESIDE * (whole.high - whole.low);
        let from = span.from.min(whole.low + beside);
        let length = (span.from + span.length).max(whole.high - beside) - from;
        if length.is_finite() { Span { from, length, cells: GRID, ..*span } } else { *span }
    }

    /// Rests are needed only for the integration: at a single position the velocity itself is known.
    fn rests(&self, motion: impl Fn(&Body<f64>) -> ([f64; 2], [f64; 2]), link: LinkId) -> Breaks {
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
        match (input.period(), input.range) {
            (Some(period), _) => [input.from, input.from + period],
            (None, Range::To(to)) => [input.from.min(to), input.from.max(to)],
            (None, Range::Cycle(_)) => [input.from; 2],
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

    /// The interval of a stroke: a cycle and, where the scene gives a range, the range.
    fn spans(&self) -> Vec<Span> {
        let input = &self.mechanism.input;
        // Dead points are often at round coordinates; a reversal on a grid point would be bracketed by rounding alone.
        let beside = |length: f64| input.from + BESIDE * length;
        let cycle =
            input.period().map(|length| Span { from: beside(length), length, periodic: true, cells: GRID });
        let range = match input.range {
            Range::To(to) => {
                let length = (to - input.from).abs();
                Some(Span { from: to.min(input.from), length, periodic: false, cells: GRID })
            }
            Range::Cycle(_) => None,
        };
        cycle.into_iter().chain(range).collect()
    }
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
