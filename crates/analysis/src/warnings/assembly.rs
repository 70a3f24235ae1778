//! Warnings about the assembly: where assembly modes meet or end, or positions become unbounded.

use assur_group::{GroupError, Order};
use assur_mechanism::{Motion, Range};
use assur_words::{Describe, Text, degrees, joined, list, millimeters, number, ordinal, quantity, text};

use super::Listed;
use crate::Calculation;
use crate::results::{Extreme, Owner, Survey};

/// Change points of several groups nearer than this count as one, rad or m.
const SAME: f64 = 1e-6;

/// A group with a greater condition number than this is nearly singular: PF1 and reactions lose as many digits as it has, PF2
/// twice as many.
const ILL: f64 = 1e3;

impl Calculation {
    /// Groups that are nearly singular in a position and not interpolated there: two of their modes meet or begin next to it.
    pub(super) fn nearly_singular(&self, survey: &Survey) -> Vec<Text> {
        let linkage = &self.linkage;
        let mut found = linkage.position();
        let mut notes = Vec::new();
        let worst = survey.statistics.iter().filter_map(|(column, of)| match column.owner {
            Owner::Group(group) => Some((group, of.greatest()?)),
            _ => None,
        });
        for (group, Extreme { value: condition, number: index }) in
            worst.filter(|(_, worst)| worst.value > ILL)
        {
            let coordinate = linkage.mechanism.input.coordinate(index);
            if linkage.is_interpolated(coordinate)
                || linkage.solve_index(index, Order::Place, &mut found).is_err()
            {
                continue;
            }
            let name = linkage.structure.group_name(&linkage.mechanism, group);
            let (position, place) = (number(index), self.show(coordinate));
            let condition = number(format_args!("{condition:.3e}"));
            let modes = linkage.modes(group, &found).ok().flatten();
            notes.push(
                match modes.and_then(|modes| {
                    Some([modes.present, modes.rival(linkage)?].map(|index| modes.number(index)))
                }) {
                    Some([one, other]) => text!(
                        "analysis-nearly-singular-modes",
                        group = name,
                        position,
                        place,
                        condition,
                        one = ordinal(one),
                        other = ordinal(other)
                    ),
                    None => text!("analysis-nearly-singular", group = name, position, place, condition),
                },
            );
        }
        notes
    }

    /// Where assembly modes meet; the motion passes through without any sign in the numbers but a great condition
    /// number.
    pub(super) fn change_points(&self) -> Option<Text> {
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
        if places.is_empty() {
            return None;
        }
        let words = places.iter().map(|(at, groups)| self.change_point(*at, groups));
        let mut note = vec![text!("analysis-change-points", places = joined("; ", words))];
        let input = &linkage.mechanism.input;
        let across = |index: &usize| linkage.is_interpolated(input.coordinate(*index));
        let positions: Listed = (0..input.positions).filter(across).collect();
        note.extend(positions.note(|positions| text!("analysis-interpolated", positions)));
        Some(joined(" ", note))
    }

    /// Positions that can be assembled, but are beyond a gap, seen from the first position. The gap may be too narrow
    /// to contain a position; if it contains one, the error of that position says where the mechanism can be assembled.
    pub(super) fn barriers(&self) -> Option<Text> {
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
            GroupError::NoAssembly { gap_m } if gap_m > 0.0 => {
                text!("analysis-misses", gap = quantity(format_args!("{:.3e}", gap_m * 1e3), "mm"))
            }
            other => other.describe(),
        };
        let group = linkage.structure.group_name(&linkage.mechanism, failure.group);
        let mut note = vec![text!("analysis-barrier", end = self.show(end), group, gap)];
        if !back.is_empty() {
            note.push(text!("analysis-turning-back", count = back.count(), numbers = back.words()));
        }
        if !beyond.is_empty() {
            note.push(text!("analysis-other-motion", count = beyond.count(), numbers = beyond.words()));
        }
        Some(joined(" ", note))
    }

    /// Where positions become unbounded, since guides become parallel: beyond it, the positions belong to another assembly.
    pub(super) fn poles(&self) -> Option<Text> {
        let linkage = &self.linkage;
        let poles = linkage.poles();
        let poles = poles.iter().filter(|(at, _)| self.visits(*at));
        let places: Vec<Text> = poles.map(|(at, group)| self.change_point(*at, &[*group])).collect();
        (!places.is_empty()).then(|| text!("analysis-poles", places = joined("; ", places)))
    }

    /// Whether two coordinates are one place of the input link. A mechanism whose cycle takes several turns passes each
    /// of its change points in several of them.
    fn are_one(&self, a: f64, b: f64) -> bool {
        let apart = (a - b).abs();
        if !self.linkage.kind().is_angle() {
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
        let next = if self.linkage.kind().is_angle() {
            coordinate + turn * ((low - coordinate) / turn).ceil()
        } else {
            coordinate
        };
        matches!(mechanism.motion, Some(Motion::Transient { .. })) || (low..=high).contains(&next)
    }

    /// A coordinate as shown to a reader.
    fn show(&self, coordinate: f64) -> Text {
        if !self.linkage.kind().is_angle() {
            return millimeters(coordinate, 4);
        }
        // A place within rounding of a whole turn is 0.
        let within = coordinate.rem_euclid(std::f64::consts::TAU);
        degrees(if within.to_degrees() > 359.999_95 { 0.0 } else { within }, 4)
    }

    /// A place where something happens in some groups.
    fn change_point(&self, coordinate: f64, groups: &[usize]) -> Text {
        let linkage = &self.linkage;
        let place = self.show(coordinate);
        let group = linkage.structure.group_name(&linkage.mechanism, groups[0]);
        match groups.len() {
            1 => text!("analysis-place", place, group),
            count => {
                text!("analysis-place-of-several", place, group, more = count - 1)
            }
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

    /// How many positions; 2 stands for more of them.
    fn count(&self) -> usize {
        if matches!(self.0[..], [[first, last]] if first == last) { 1 } else { 2 }
    }

    /// "3, 11 to 47".
    fn words(&self) -> Text {
        list(self.0.iter().map(|[first, last]| {
            if first == last {
                number(first)
            } else {
                text!("analysis-run", first = number(first), last = number(last))
            }
        }))
    }
}
