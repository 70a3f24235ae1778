//! Notes on the assembly: where assembly modes meet, end, or run through infinity.

use std::fmt::Write;

use assur_group::{GroupError, Order};
use assur_mechanism::{Motion, Range};

use super::Listed;
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
        let positions: Listed = (0..input.positions).filter(across).collect();
        let interpolated = if positions.is_empty() {
            String::new()
        } else {
            format!(
                " In {} the equations of the group say nothing or little (0/0): the motion there is interpolated \
                 from both sides.",
                positions.words()
            )
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
        let (mut back, mut beyond, mut unsolved, mut first) = (Runs::default(), Runs::default(), false, None);
        for index in 0..input.positions {
            if linkage.solve_index(index, Order::Place, &mut position).is_err() {
                unsolved = true;
            } else if linkage.barrier(input.coordinate(index)).is_some() {
                first.get_or_insert(index);
                let reached = linkage.reaches(input.coordinate(index));
                if reached { &mut back } else { &mut beyond }.add(index);
            }
        }
        let (end, failure) = linkage.barrier(input.coordinate(first?))?;
        if beyond.is_empty() && unsolved {
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
            let are = if back.is_single() { "is" } else { "are" };
            let _ = write!(note, " {} {are} reached by turning back only.", back.words());
        }
        if !beyond.is_empty() {
            let are = if beyond.is_single() { "is a place" } else { "are places" };
            let _ = write!(note, " {} {are} of the mechanism, but not of that motion.", beyond.words());
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

/// Increasing numbers of positions, as runs of consecutive ones.
#[derive(Debug, Default)]
struct Runs(Vec<[usize; 2]>);

impl Runs {
    fn add(&mut self, number: usize) {
        match self.0.last_mut() {
            Some([_, last]) if *last + 1 == number => *last = number,
            _ => self.0.push([number; 2]),
        }
    }

    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn is_single(&self) -> bool {
        matches!(self.0[..], [[first, last]] if first == last)
    }

    /// "Positions 3, 11 to 47", "Position 3".
    fn words(&self) -> String {
        let part = |[first, last]: &[usize; 2]| {
            if first == last { first.to_string() } else { format!("{first} to {last}") }
        };
        let plural = if self.is_single() { "" } else { "s" };
        format!("Position{plural} {}", self.0.iter().map(part).collect::<Vec<_>>().join(", "))
    }
}
