//! What had to be left out, and what of a request has no use.

mod springs;

use std::fmt::Write;

use assur_group::{GroupError, Order};
use assur_mechanism::{InputPair, Mechanism, Motion, Range};

use crate::trajectory::WithoutForces;
use crate::{Calculation, InputMotion, Options};

/// Change points of several groups nearer than this are one, rad or m.
const SAME: f64 = 1e-6;

/// Why no reactions are given at a change point.
const LOST: &str = "the mechanism stands at a change point (determinant of a group below 1e-5): constraints of a group \
                    coincide there and its reactions are not determined";

impl Calculation {
    /// Notes for the results; `positions` at which forces are not determined, and `samples` of a motion without them.
    pub(crate) fn notes(&self, positions: &[usize], samples: &WithoutForces) -> Vec<String> {
        let mut notes = self.unused.clone();
        notes.extend(self.change_points());
        notes.extend(self.poles());
        notes.extend(self.barriers());
        notes.extend(self.regime_notes());
        notes.extend(self.springs_without_direction());
        if let InputMotion::Transient(found) = &self.motion {
            let unrest = found.unrest.as_ref();
            notes.extend(unrest.map(|why| {
                format!(
                    "The motion does not come to rest for good ({why}); it ends at its first turning point, as with \
                     `until = \"turn\"`."
                )
            }));
        }
        if !positions.is_empty() {
            notes.push(format!("No reactions in {}: {LOST}.", listed("position", positions)));
        }
        if samples.at_change_points > 0 {
            let count = counted("sample", samples.at_change_points);
            notes.push(format!("No reactions at {count} of the motion: {LOST}."));
        }
        if let Some(reason) = &samples.reason {
            notes.push(format!(
                "No forces at {} of the motion; at the first: {reason}.",
                counted("sample", samples.refused)
            ));
        }
        notes
    }
}

impl Calculation {
    /// What of the wishes for a regime is not met, and whether its loads drive.
    fn regime_notes(&self) -> Vec<String> {
        /// Mean speeds are found to 1e-10.
        const MET: f64 = 1e-9;
        let InputMotion::Steady(found) = &self.motion else { return Vec::new() };
        let (mechanism, regime) = (&self.linkage.mechanism, &found.regime);
        let Some(Motion::Steady { mean_speed: wanted, .. }) = mechanism.motion else { return Vec::new() };
        let mut notes = Vec::new();
        let unit = if self.linkage.angular() { "rad/s" } else { "m/s" };
        if ((regime.mean_speed - wanted) / wanted).abs() > MET {
            let given = if regime.ratio.is_some() { "ratio" } else { "moment" };
            notes.push(format!(
                "The wanted mean speed of {wanted:.6} {unit} is not met: with the given {given} it is {:.6} {unit}. Power, \
                 flywheel and the course are those of the regime found.",
                regime.mean_speed
            ));
        }
        if regime.required_power < 0.0 {
            notes.push(format!(
                "The loads drive: over a cycle they do {:.6} J of work, and the motor has to brake with {:.6} W.",
                -found.resistance_work, -regime.required_power
            ));
        }
        notes
    }

    /// Where ways of assembly meet, which the motion goes through without a sign in the numbers but a great condition.
    fn change_points(&self) -> Option<String> {
        let linkage = &self.linkage;
        let mut places: Vec<(f64, Vec<usize>)> = Vec::new();
        for point in linkage.change_points().filter(|point| self.visits(point.coordinate)) {
            let (coordinate, group) = (point.coordinate, point.group);
            match places.iter_mut().find(|(at, _)| self.are_one(*at, coordinate)) {
                Some((_, groups)) if groups.contains(&group) => {}
                Some((_, groups)) => groups.push(group),
                None => places.push((coordinate, vec![group])),
            }
        }
        let words: Vec<String> = places.iter().map(|(at, groups)| self.change_point(*at, groups)).collect();
        let input = &linkage.mechanism.input;
        let across = |index: &usize| linkage.is_interpolated(input.coordinate(*index));
        let positions: Vec<usize> = (0..input.positions).filter(across).collect();
        let interpolated = match &positions[..] {
            [] => String::new(),
            numbers => format!(
                " In {} the equations of the group say nothing or little (0/0): the motion there is interpolated \
                 from both sides.",
                listed("position", numbers)
            ),
        };
        (!words.is_empty()).then(|| {
            format!(
                "Change points, where two ways of assembly meet: {}. A real mechanism may go on in either way there; \
                 calculated is the smooth motion.{interpolated}",
                words.join("; ")
            )
        })
    }

    /// Positions that can be assembled, but lie behind a gap, seen from the first one: it may be too narrow for a position to
    /// fall into it. Where one falls into it, its error says where the mechanism can be assembled.
    fn barriers(&self) -> Option<String> {
        let linkage = &self.linkage;
        let input = &linkage.mechanism.input;
        // Nothing is solved again where nothing is behind a gap.
        (0..input.positions).find(|index| linkage.barrier(input.coordinate(*index)).is_some())?;
        let mut position = linkage.position();
        let mut solves = |index: usize| linkage.solve_index(index, Order::Place, &mut position).is_ok();
        let solved: Vec<bool> = (0..input.positions).map(&mut solves).collect();
        let behind = |index: &usize| solved[*index] && linkage.barrier(input.coordinate(*index)).is_some();
        let behind: Vec<usize> = (0..input.positions).filter(behind).collect();
        let (end, failure) = linkage.barrier(input.coordinate(*behind.first()?))?;
        let (back, beyond): (Vec<usize>, Vec<usize>) =
            behind.into_iter().partition(|index| linkage.reaches(input.coordinate(*index)));
        if beyond.is_empty() && solved.contains(&false) {
            return None;
        }
        let gap = match failure.source {
            GroupError::NoAssembly { gap_m } => format!("it misses by {:.3e} mm or more", gap_m * 1e3),
            other => other.to_string(),
        };
        let mut note = format!(
            "Behind {} {} can't be assembled ({gap}): the motion from the first position ends there.",
            self.show(end),
            linkage.structure.group_name(&linkage.mechanism, failure.group)
        );
        if !back.is_empty() {
            let are = if back.len() == 1 { "is" } else { "are" };
            let _ = write!(note, " {} {are} reached by turning back only.", runs(&back));
        }
        if !beyond.is_empty() {
            let are = if beyond.len() == 1 { "is a place" } else { "are places" };
            let _ = write!(note, " {} {are} of the mechanism, but not of that motion.", runs(&beyond));
        }
        Some(note)
    }

    /// Where links run through infinity: what is calculated behind is another assembly.
    fn poles(&self) -> Option<String> {
        let linkage = &self.linkage;
        let words: Vec<String> = linkage
            .poles()
            .iter()
            .filter(|(at, _)| self.visits(*at))
            .map(|(at, group)| {
                let name = linkage.structure.group_name(&linkage.mechanism, *group);
                format!("{} ({name})", self.show(*at))
            })
            .collect();
        (!words.is_empty()).then(|| {
            format!(
                "Links run through infinity, since guides turn parallel: {}. No mechanism gets from one side to the other; \
                 positions on both are calculated.",
                words.join("; ")
            )
        })
    }

    /// Whether two coordinates are one place of the input link. A mechanism whose cycle takes several turns comes to each of
    /// its change points in several of them.
    fn are_one(&self, a: f64, b: f64) -> bool {
        let apart = (a - b).abs();
        if !self.linkage.angular() {
            return apart < SAME;
        }
        let turn = std::f64::consts::TAU;
        let within = apart.rem_euclid(turn);
        within.min(turn - within) < SAME
    }

    /// Whether the scene may come to a coordinate, in any turn.
    fn visits(&self, coordinate: f64) -> bool {
        let mechanism = &self.linkage.mechanism;
        let input = &mechanism.input;
        let Range::To(to) = input.range else { return true };
        let (low, high) = (input.from.min(to) - SAME, input.from.max(to) + SAME);
        let turn = std::f64::consts::TAU;
        let next = if self.linkage.angular() {
            coordinate + turn * ((low - coordinate) / turn).ceil()
        } else {
            coordinate
        };
        matches!(mechanism.motion, Some(Motion::Transient { .. })) || (low..=high).contains(&next)
    }

    /// A coordinate as a reader wants it.
    fn show(&self, coordinate: f64) -> String {
        if self.linkage.angular() {
            // A place within rounding of a whole turn is 0.
            let degrees = coordinate.rem_euclid(std::f64::consts::TAU).to_degrees();
            format!("{:.4} deg", if degrees > 359.999_95 { 0.0 } else { degrees })
        } else {
            format!("{:.4} mm", coordinate * 1e3)
        }
    }

    fn change_point(&self, coordinate: f64, groups: &[usize]) -> String {
        let linkage = &self.linkage;
        let place = self.show(coordinate);
        let group = linkage.structure.group_name(&linkage.mechanism, groups[0]);
        match groups.len() {
            1 => format!("{place} ({group})"),
            count => format!("{place} ({group} and {} more)", count - 1),
        }
    }
}

/// A number of things: "1 sample", "3 samples".
fn counted(thing: &str, count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}

/// Numbered things: "position 3", "positions 3, 11".
fn listed(thing: &str, numbers: &[usize]) -> String {
    let plural = if numbers.len() == 1 { "" } else { "s" };
    let numbers: Vec<_> = numbers.iter().map(ToString::to_string).collect();
    format!("{thing}{plural} {}", numbers.join(", "))
}

/// Increasing numbers of positions in words: "Positions 3, 11 to 47", "Position 3".
fn runs(numbers: &[usize]) -> String {
    let parts = numbers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [first, .., last] => format!("{first} to {last}"),
        _ => run.iter().map(ToString::to_string).collect(),
    });
    let plural = if numbers.len() == 1 { "" } else { "s" };
    format!("Position{plural} {}", parts.collect::<Vec<_>>().join(", "))
}

/// Parts of the scene and of the choice of methods that are not used.
pub(crate) fn unused(mechanism: &Mechanism, options: &Options) -> Vec<String> {
    let transient = matches!(mechanism.motion, Some(Motion::Transient { .. }));
    let steady = matches!(mechanism.motion, Some(Motion::Steady { .. }));
    let mut notes: Vec<String> = idle_crank(mechanism).into_iter().collect();
    if mechanism.drive.is_some() && !transient && !steady {
        notes.push(
            "`[drive]` is not used: the motion is prescribed or absent; take `kind = \"steady\"` or \"transient\"."
                .to_owned(),
        );
    }
    if let Some(name) = options.integrator.as_ref().filter(|_| !transient) {
        let why = if steady {
            "the steady regime is found by collocation over the cycle, not by steps in time"
        } else {
            "the scene asks for no motion from an initial state"
        };
        notes.push(format!("Integrator `{name}` is not used: {why}."));
    }
    notes
}

/// An input link whose pairs all lie on its axis moves nothing; a length was probably forgotten.
fn idle_crank(mechanism: &Mechanism) -> Option<String> {
    let InputPair::Pin(axis) = mechanism.input.pair else { return None };
    let crank = mechanism.input.link;
    if mechanism.slides.iter().any(|slide| slide.link == crank || slide.on == crank) {
        return None;
    }
    let at =
        |point: usize| mechanism.points[point].places.iter().find(|place| place.link == crank).map(|p| p.at);
    let center = at(axis)?;
    let pins: Vec<usize> = (0..mechanism.points.len())
        .filter(|id| *id != axis && mechanism.points[*id].is_pin() && at(*id).is_some())
        .collect();
    let idle = !pins.is_empty() && pins.iter().all(|id| at(*id) == Some(center));
    idle.then(|| {
        let (name, point) = (&mechanism.links[crank].name, &mechanism.points[pins[0]].name);
        format!(
            "The input link `{name}` moves nothing: `{point}` lies on its axis `{}`; give `{name}` a length.",
            mechanism.points[axis].name
        )
    })
}
