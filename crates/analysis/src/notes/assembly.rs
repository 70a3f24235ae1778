//! Notes on the assembly: where assembly modes meet, end, or run through infinity.

use std::fmt::Write;

use assur_group::{GroupError, Order};
use assur_mechanism::{Motion, Range};

use super::listed;
use crate::Calculation;

/// Change points of several groups nearer than this count as one, rad or m.
const SAME: f64 = 1e-6;

impl Calculation {
    /// Where assembly modes meet; the motion passes through without any sign in the numbers but a great condition
    /// number.
    pub(super) fn change_points(&self) -> Option<String> {
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

    /// Positions that can be assembled, but are beyond a gap, seen from the first position. The gap may be too narrow
    /// to contain a position; if it contains one, the error of that position says where the mechanism can be assembled.
    pub(super) fn barriers(&self) -> Option<String> {
        let linkage = &self.linkage;
        let input = &linkage.mechanism.input;
        // Nothing is solved again if no position is beyond a gap.
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

    /// Where links run through infinity: beyond it, the positions belong to another assembly.
    pub(super) fn poles(&self) -> Option<String> {
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

    /// Whether two coordinates are one place of the input link. A mechanism whose cycle takes several turns passes each
    /// of its change points in several of them.
    fn are_one(&self, a: f64, b: f64) -> bool {
        let apart = (a - b).abs();
        if !self.linkage.angular() {
            return apart < SAME;
        }
        let turn = std::f64::consts::TAU;
        let within = apart.rem_euclid(turn);
        within.min(turn - within) < SAME
    }

    /// Whether the scene may reach a coordinate, in any turn.
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

    /// A coordinate as shown to a reader.
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

/// Increasing numbers of positions in words: "Positions 3, 11 to 47", "Position 3".
fn runs(numbers: &[usize]) -> String {
    let parts = numbers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [first, .., last] => format!("{first} to {last}"),
        _ => run.iter().map(ToString::to_string).collect(),
    });
    let plural = if numbers.len() == 1 { "" } else { "s" };
    format!("Position{plural} {}", parts.collect::<Vec<_>>().join(", "))
}
