//! Dependency analysis by structure: which positions and reactions the parameters of a sweep can affect. A link moves differently if a length of its group or
//! of a group solved before it changes, and a reaction changes with the motion or with a load that reaches it.

use assur_analysis::results::Owner;
use assur_kinematics::decompose;
use assur_mechanism::{GROUND, LinkId, Mechanism, Motion, PairId, Place};

use crate::{axis::Axis, variants::Variants};

/// What the parameters of a sweep can change; everything where that is not known.
#[derive(Debug, Clone)]
pub(crate) struct Reach {
    /// Whether all positions can change.
    everywhere: bool,
    /// Whether all reactions can change.
    all_forces: bool,
    /// Of each link the number of its group from 1; 0 for the ground and the input link.
    stage: Vec<usize>,
    /// By stage: whether the positions of its links can change, and whether the loads on them can.
    moves: Vec<bool>,
    felt: Vec<bool>,
    /// Of each point whether it can change its position on its link.
    points: Vec<bool>,
}

impl Reach {
    /// What parameters change between the ends of their ranges.
    pub(crate) fn of(base: &Mechanism, variants: &Variants, axes: &[Axis]) -> Self {
        let structure = decompose(base).ok();
        let groups = structure.as_ref().map_or(&[][..], |structure| &structure.groups);
        let mut reach = Self {
            everywhere: true,
            all_forces: true,
            stage: vec![0; base.links.len()],
            moves: vec![false; groups.len() + 1],
            felt: vec![false; groups.len() + 1],
            points: vec![false; base.points.len()],
        };
        for (index, group) in groups.iter().enumerate() {
            group.frame.links.iter().for_each(|link| reach.stage[*link] = index + 1);
        }
        let mut numbers: Vec<f64> = axes.iter().map(|axis| axis.from).collect();
        let (Some(structure), Ok(first)) = (&structure, variants.at(axes, &numbers)) else { return reach };
        // A range of one value is calculated for what there is.
        if !structure.passive.is_empty() || axes.iter().all(|axis| axis.from.total_cmp(&axis.to).is_eq()) {
            return reach;
        }
        // Where the motion follows from the loads, each of them is felt everywhere, and so it is through friction and a balancing
        // load far from the input.
        reach.all_forces = matches!(base.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }))
            || !base.frictions.is_empty()
            || base.balance.is_some();
        reach.everywhere = false;
        for (index, axis) in axes.iter().enumerate() {
            for number in axis.compared().into_iter().skip(1) {
                numbers[index] = number;
                let Ok(other) = variants.at(axes, &numbers) else {
                    return Self { everywhere: true, ..reach };
                };
                reach.compare(&first, &other);
            }
            numbers[index] = axis.from;
        }
        reach.spread(base);
        reach
    }

    /// Notes what differs between two mechanisms of one structure.
    fn compare(&mut self, one: &Mechanism, other: &Mechanism) {
        let same_parts = one.links.len() == other.links.len()
            && one.points.len() == other.points.len()
            && one.slides.len() == other.slides.len()
            && one.loads.len() == other.loads.len();
        self.everywhere |= !same_parts || one.input != other.input || one.assembly != other.assembly;
        self.all_forces |= one.gravity != other.gravity
            || one.motion != other.motion
            || one.drive != other.drive
            || one.balance != other.balance
            || one.frictions != other.frictions;
        for (link, (a, b)) in one.links.iter().zip(&other.links).enumerate() {
            self.felt[self.stage[link]] |= a != b;
        }
        for (a, b) in one.loads.iter().zip(&other.loads).filter(|(a, b)| a != b) {
            a.kind.links().chain(b.kind.links()).for_each(|link| self.felt[self.stage[link]] = true);
        }
        for (id, (a, b)) in one.points.iter().zip(&other.points).enumerate() {
            for (place, _) in a.places.iter().zip(&b.places).filter(|(a, b)| a != b) {
                self.points[id] |= self.first(&a.places) == Some(place.link);
                let others = a.places.iter().filter(|next| next.link != place.link);
                others.for_each(|next| self.shift(place.link, next.link));
            }
        }
        for (a, _) in one.slides.iter().zip(&other.slides).filter(|(a, b)| a != b) {
            self.shift(a.link, a.on);
        }
    }

    /// The link that carries a point before all others: the ground, the input link, that of the first group.
    fn first(&self, places: &[Place]) -> Option<LinkId> {
        places.iter().map(|place| place.link).min_by_key(|link| (self.stage[*link], *link != GROUND))
    }

    /// Notes that two links are joined elsewhere on one of them: the one that is placed later moves.
    fn shift(&mut self, one: LinkId, other: LinkId) {
        match self.stage[one].max(self.stage[other]) {
            0 => self.everywhere = true,
            stage => self.moves[stage] = true,
        }
    }

    /// Passes changes of positions from group to group in solving order, changes of forces in the opposite one.
    fn spread(&mut self, mechanism: &Mechanism) {
        let pins = mechanism.points.iter().flat_map(|point| {
            let places = &point.places;
            places.iter().flat_map(move |a| places.iter().map(move |b| [a.link, b.link]))
        });
        let slides = mechanism.slides.iter().map(|slide| [slide.link, slide.on]);
        let joined = pins.chain(slides).filter(|links| !links.contains(&GROUND));
        let stages = joined.map(|links| links.map(|link| self.stage[link]));
        let mut joined: Vec<[usize; 2]> = stages.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        joined.sort_unstable_by_key(|[_, later]| *later);
        for [earlier, later] in &joined {
            self.moves[*later] |= self.moves[*earlier];
        }
        joined.sort_unstable();
        for [earlier, later] in joined.iter().rev() {
            self.felt[*earlier] |= self.felt[*later];
        }
    }

    /// Whether any position changes.
    pub(crate) fn moves_anything(&self) -> bool {
        self.everywhere || self.moves.contains(&true)
    }

    /// Whether a number of a point, link, slide or pair changes. The reaction of a pair of the input link changes with every load, those
    /// of a group with the loads on it and on the groups placed after it; a pair belongs to the groups that are placed after its first
    /// link.
    pub(crate) fn has(&self, owner: Owner, mechanism: &Mechanism) -> bool {
        let moves = |link: LinkId| self.everywhere || self.moves[self.stage[link]];
        match owner {
            Owner::Point(point) => {
                let carrier = self.first(&mechanism.points[point].places).filter(|link| *link != GROUND);
                self.points[point] || carrier.is_some_and(moves)
            }
            Owner::Link(link) => moves(link),
            Owner::Slide(slide) => moves(mechanism.slides[slide].link) || moves(mechanism.slides[slide].on),
            Owner::Pair(pair) => {
                let links: Vec<LinkId> = match pair {
                    PairId::Pin(point) => {
                        mechanism.points[point].places.iter().map(|place| place.link).collect()
                    }
                    PairId::Slide(slide) => vec![mechanism.slides[slide].link, mechanism.slides[slide].on],
                };
                let mut stages: Vec<usize> = links.into_iter().map(|link| self.stage[link]).collect();
                stages.sort_unstable();
                self.all_forces || self.moves_anything() || stages[1..].iter().any(|stage| self.felt[*stage])
            }
            _ => true,
        }
    }
}
