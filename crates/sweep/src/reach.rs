//! Dependency analysis by structure: which positions and reactions the parameters of a sweep can affect. A link moves differently if a length of its group or
//! of a group solved before it changes, and a reaction changes with the motion or with a load that reaches it.

use assur_analysis::results::Owner;
use assur_kinematics::decompose;
use assur_mechanism::{GROUND, LinkId, Mechanism, Motion, PairId, Place};
use assur_structure::Structure;

use crate::axis::Axis;
use crate::variants::Variants;

/// What the parameters of a sweep can change; everything where that is not known.
#[derive(Debug, Clone)]
pub(crate) struct Reach {
    /// Whether all positions can change.
    everywhere: bool,
    /// Whether all reactions can change.
    all_forces: bool,
    /// Of each link whether its position can change, and whether what acts on it can.
    places: Vec<bool>,
    forces: Vec<bool>,
    /// Of each point whether it can change its position on its link.
    points: Vec<bool>,
    /// Of each link the number of its group from 1; 0 for the ground and the input link.
    stage: Vec<usize>,
}

impl Reach {
    /// What parameters change between the ends of their ranges.
    pub(crate) fn of(base: &Mechanism, variants: &Variants, axes: &[Axis]) -> Self {
        let mut reach = Self {
            everywhere: true,
            all_forces: true,
            places: vec![false; base.links.len()],
            forces: vec![false; base.links.len()],
            points: vec![false; base.points.len()],
            stage: vec![0; base.links.len()],
        };
        let mut numbers: Vec<f64> = axes.iter().map(|axis| axis.from).collect();
        let (Ok(structure), Ok(first)) = (decompose(base), variants.at(axes, &numbers)) else {
            return reach;
        };
        // A range of one value is calculated for what there is.
        if !structure.passive.is_empty() || axes.iter().all(|axis| axis.from.total_cmp(&axis.to).is_eq()) {
            return reach;
        }
        reach.count_stages(&structure);
        // Where the motion follows from the loads, each of them is felt everywhere, and so it is through friction and a balancing
        // load far from the input.
        reach.all_forces = matches!(base.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }))
            || !base.frictions.is_empty()
            || base.balance.is_some();
        reach.everywhere = false;
        for (index, axis) in axes.iter().enumerate() {
            numbers[index] = axis.to;
            let Ok(other) = variants.at(axes, &numbers) else { return Self { everywhere: true, ..reach } };
            numbers[index] = axis.from;
            reach.compare(&first, &other);
        }
        reach.spread(base);
        reach
    }

    fn count_stages(&mut self, structure: &Structure) {
        for (index, group) in structure.groups.iter().enumerate() {
            for link in &group.frame.links {
                self.stage[*link] = index + 1;
            }
        }
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
            self.forces[link] |= a != b;
        }
        for (a, b) in one.loads.iter().zip(&other.loads).filter(|(a, b)| a != b) {
            a.kind.links().chain(b.kind.links()).for_each(|link| self.forces[link] = true);
        }
        for (id, (a, b)) in one.points.iter().zip(&other.points).enumerate() {
            for (place, _) in a.places.iter().zip(&b.places).filter(|(a, b)| a != b) {
                self.points[id] |= self.first(&a.places) == Some(place.link);
                a.places
                    .iter()
                    .filter(|next| next.link != place.link)
                    .for_each(|next| self.moves(place.link, next.link));
            }
        }
        for (a, _) in one.slides.iter().zip(&other.slides).filter(|(a, b)| a != b) {
            self.moves(a.link, a.on);
        }
    }

    /// The link that carries a point before all others: the ground, the input link, that of the first group.
    fn first(&self, places: &[Place]) -> Option<LinkId> {
        places.iter().map(|place| place.link).min_by_key(|link| (self.stage[*link], *link != GROUND))
    }

    /// Marks the later placed one of two links whose pair has another position on one of them.
    fn moves(&mut self, one: LinkId, other: LinkId) {
        match self.stage[one].max(self.stage[other]) {
            0 => self.everywhere = true,
            stage => self.mark(stage),
        }
    }

    fn mark(&mut self, stage: usize) {
        for (link, own) in self.stage.iter().enumerate() {
            self.places[link] |= *own == stage;
        }
    }

    /// Passes changes of positions from group to group in solving order, changes of forces in the opposite one.
    fn spread(&mut self, mechanism: &Mechanism) {
        let pins = mechanism.points.iter().flat_map(|point| {
            let places = &point.places;
            places.iter().flat_map(move |a| places.iter().map(move |b| [a.link, b.link]))
        });
        let slides =
            mechanism.slides.iter().flat_map(|slide| [[slide.link, slide.on], [slide.on, slide.link]]);
        let joined: Vec<[LinkId; 2]> =
            pins.chain(slides).filter(|[a, b]| *a != GROUND && *b != GROUND).collect();
        let last = self.stage.iter().copied().max().unwrap_or(0);
        for stage in 1..=last {
            if joined
                .iter()
                .any(|[from, to]| self.stage[*to] == stage && self.stage[*from] < stage && self.places[*from])
            {
                self.mark(stage);
            }
        }
        for stage in (0..=last).rev() {
            let is_felt = self.forces.iter().zip(&self.stage).any(|(felt, own)| *felt && *own == stage)
                || joined.iter().any(|[from, to]| {
                    self.stage[*to] == stage && self.stage[*from] > stage && self.forces[*from]
                });
            for (felt, _) in self.forces.iter_mut().zip(&self.stage).filter(|(_, own)| **own == stage) {
                *felt |= is_felt;
            }
        }
    }

    /// Whether any position changes.
    pub(crate) fn moves_anything(&self) -> bool {
        self.everywhere || self.places.contains(&true)
    }

    /// Whether a number of a point, link, slide or pair changes. The reaction of a pair of the input link changes with every load, those
    /// of a group with the loads on it and on the groups placed after it; a pair belongs to the groups that are placed after its first
    /// link.
    pub(crate) fn has(&self, owner: Owner, mechanism: &Mechanism) -> bool {
        let moves = |link: LinkId| self.everywhere || self.places[link];
        let links = |pair| match pair {
            PairId::Pin(point) => mechanism.points[point].places.iter().map(|place| place.link).collect(),
            PairId::Slide(slide) => vec![mechanism.slides[slide].link, mechanism.slides[slide].on],
        };
        match owner {
            Owner::Point(point) => {
                let carrier = self.first(&mechanism.points[point].places).filter(|link| *link != GROUND);
                self.points[point] || carrier.is_some_and(moves)
            }
            Owner::Link(link) => moves(link),
            Owner::Slide(slide) => links(PairId::Slide(slide)).into_iter().any(moves),
            Owner::Pair(pair) => {
                let mut stages: Vec<usize> = links(pair).into_iter().map(|link| self.stage[link]).collect();
                stages.sort_unstable();
                let mut felt =
                    self.forces.iter().zip(&self.stage).filter(|(_, own)| stages[1..].contains(own));
                self.all_forces || self.moves_anything() || felt.any(|(felt, _)| *felt)
            }
            _ => true,
        }
    }
}
