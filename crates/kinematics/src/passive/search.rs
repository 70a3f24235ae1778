//! Which parts are passive.

use assur_group::{Mode, Order};
use assur_mechanism::{Balance, GROUND, LinkId, Mechanism, PairId, PointId, Slide};
use assur_number::elementary;
use assur_structure::{Excess, PassivePart, Structure};
use assur_words::{Text, millimeters, text};

use crate::ways::{END_ROUNDING, Transition};
use crate::{Linkage, passive::hang::Hanging};

/// Most surplus constraints that are treated.
const MOST_SURPLUS: usize = 1000;
/// Most mechanisms that are compiled in the search.
const MOST_COMPILED: usize = 48;
/// Most counts of equations in the search, by link of the mechanism.
const MOST_COUNTED: usize = 20_000_000;
/// Two guides of one link on another are meant to be parallel below this sine of the angle between them.
const MEANT_PARALLEL: f64 = 0.02;
/// Up to this part of the size, what misses is meant to fit even if no single length closes it.
const MEANT_TO_FIT: f64 = 0.01;

/// The structure without its passive parts: the last link in the order of the scene (else the last pair) without which the
/// mobility is the same and the surplus smaller, one after another.
///
/// # Errors
///
/// Why nothing is passive, as the rest of a sentence; may be empty.
pub(super) fn without_passive(mechanism: &Mechanism) -> Result<Structure, Text> {
    let surplus = Excess::of(mechanism, &[]).surplus;
    if surplus > MOST_SURPLUS {
        return Err(text!("kinematics-too-many-surplus", surplus, most = MOST_SURPLUS));
    }
    let candidates = candidates(mechanism);
    let counted = MOST_COUNTED / mechanism.links.len() + 2 * candidates.len().min(MOST_SURPLUS);
    let doubled = doubled(mechanism);
    let mut search = Search { mechanism, candidates, doubled, counted, compiled: MOST_COMPILED, best: None };
    search.go(&mut Vec::new(), 0);
    match search.best {
        Some(Choice { linkage, rank: Rank::Fits | Rank::Closes | Rank::Near, .. }) => Ok(linkage.structure),
        Some(Choice { misfit, .. }) => {
            let misfit = millimeters(misfit, 3);
            Err(text!("kinematics-misses", misfit))
        }
        None => Err(Text::default()),
    }
}

/// How well the parts fit that are left out, best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    Fits,
    /// Each part that does not fit would fit with one other length.
    Closes,
    /// The parts nearly fit.
    Near,
    /// The parts don't fit: the mechanism is locked.
    Misses,
}

/// The best choice so far.
struct Choice {
    rank: Rank,
    /// The greatest misfit, m.
    misfit: f64,
    linkage: Linkage,
}

/// A search through the parts, last ones first.
struct Search<'a> {
    mechanism: &'a Mechanism,
    candidates: Vec<PassivePart>,
    /// Slides that repeat another one between the same links.
    doubled: Vec<PassivePart>,
    /// Counts of equations that are left.
    counted: usize,
    /// Mechanisms that may still be compiled.
    compiled: usize,
    best: Option<Choice>,
}

impl Search<'_> {
    /// Leaves out further parts, from a candidate on; whether a choice was found that fits.
    fn go(&mut self, chosen: &mut Vec<PassivePart>, from: usize) -> bool {
        let now = self.excess(chosen);
        if now.loose {
            return false;
        }
        if now.surplus == 0 {
            return self.try_out(chosen);
        }
        for k in from..self.candidates.len() {
            let part = self.candidates[k];
            if self.compiled == 0 || self.counted == 0 {
                return false;
            }
            if !self.is_placed_by_others(part, chosen) {
                continue;
            }
            self.counted -= 1;
            chosen.push(part);
            let then = self.excess(chosen);
            if !then.loose && then.surplus < now.surplus && self.go(chosen, k + 1) {
                return true;
            }
            chosen.pop();
        }
        false
    }

    /// The parts that are left out: the chosen ones, and doubled slides of other links.
    fn parts(&self, chosen: &[PassivePart]) -> Vec<PassivePart> {
        let stays = |part: &&PassivePart| match **part {
            PassivePart::Pair(PairId::Slide(slide), _) => {
                let Slide { link, on, .. } = self.mechanism.slides[slide];
                ![link, on].iter().any(|link| chosen.contains(&PassivePart::Link(*link)))
                    && !chosen.contains(part)
            }
            _ => true,
        };
        chosen.iter().copied().chain(self.doubled.iter().filter(stays).copied()).collect()
    }

    fn excess(&self, chosen: &[PassivePart]) -> Excess {
        Excess::of(self.mechanism, &self.parts(chosen))
    }

    /// Whether the pairs of a link with those that remain could place it.
    fn is_placed_by_others(&self, part: PassivePart, chosen: &[PassivePart]) -> bool {
        let PassivePart::Link(link) = part else { return !self.doubled.contains(&part) };
        let remains = |other: LinkId| other != link && !chosen.contains(&PassivePart::Link(other));
        let mechanism = self.mechanism;
        let pins = mechanism.points.iter().filter(|point| {
            let links = || point.places.iter().map(|place| place.link);
            links().any(|other| other == link) && links().any(remains)
        });
        let slides = mechanism.slides.iter().filter(|slide| {
            slide.link == link && remains(slide.on) || slide.on == link && remains(slide.link)
        });
        pins.take(2).count() + slides.take(2).count() >= 2
    }

    /// Compiles the mechanism without the chosen parts; whether all of them fit.
    fn try_out(&mut self, chosen: &[PassivePart]) -> bool {
        let Ok(structure) = Structure::without(self.mechanism, &self.parts(chosen)) else { return false };
        let hangs = |frame| Hanging::<f64>::of(frame).is_some();
        if !structure.passive.iter().all(|one| one.frame.links.is_empty() || hangs(&one.frame)) {
            return false;
        }
        let Some(mut found) = self.compile(structure) else { return false };
        // A group that the scene leaves free is assembled as the parts need it.
        for group in 0..found.linkage.structure.groups.len() {
            for structure in others(&found.linkage, group) {
                if found.rank == Rank::Fits || self.compiled == 0 {
                    break;
                }
                found = self.compile(structure).filter(|other| other.is_better(&found)).unwrap_or(found);
            }
        }
        let fits = found.rank == Rank::Fits;
        if self.best.as_ref().is_none_or(|best| found.is_better(best)) {
            self.best = Some(found);
        }
        fits
    }

    fn compile(&mut self, structure: Structure) -> Option<Choice> {
        self.compiled = self.compiled.saturating_sub(1);
        let all = vec![true; structure.groups.len()];
        let linkage = Linkage::compile_for(self.mechanism.clone(), structure, &all).ok()?;
        linkage.range?;
        let misfit = linkage.misfits.iter().map(|one| one.misfit).fold(0.0, f64::max);
        let closes = linkage.misfits.iter().all(|one| one.fits() || one.closes.is_some());
        let rank = match (linkage.misfits.iter().all(super::Misfit::fits), closes) {
            (true, _) => Rank::Fits,
            (false, true) => Rank::Closes,
            _ if misfit <= MEANT_TO_FIT * linkage.structure.scale => Rank::Near,
            _ => Rank::Misses,
        };
        Some(Choice { rank, misfit, linkage })
    }
}

impl Choice {
    fn is_better(&self, other: &Self) -> bool {
        self.rank < other.rank
            || self.rank == other.rank && self.rank == Rank::Misses && self.misfit < other.misfit
    }
}

/// The structure with each of the other assemblies of a group in the first position: its modes where they meet there, else the places of
/// its points; none where the scene places one of them.
fn others(linkage: &Linkage, group: usize) -> Vec<Structure> {
    let from = linkage.mechanism.input.from;
    let meets = |point: &Transition| {
        let away = linkage.ways.offset(from, point.coordinate).abs();
        point.group == group && away < END_ROUNDING * linkage.coordinate_unit()
    };
    if !linkage.structure.groups[group].plugin.iterates && linkage.change_points().any(meets) {
        let present = linkage.ways.at(from)[group];
        let ways = (0..linkage.groups()[group].ways()).filter_map(|way| u8::try_from(way).ok());
        let with = |way| {
            let mut structure = linkage.structure.clone();
            structure.ways.retain(|one| one.0 != group);
            structure.ways.push((group, way));
            structure
        };
        return ways.filter(|way| *way != present).map(with).collect();
    }
    let with = |placed| {
        let mut structure = linkage.structure.clone();
        structure.placed.extend::<Vec<_>>(placed);
        structure
    };
    other_places(linkage, group).into_iter().map(with).collect()
}

/// The places of a group's points in its other assemblies in the first position; none where the scene places one of them.
fn other_places(linkage: &Linkage, group: usize) -> Vec<Vec<(PointId, [f64; 2])>> {
    let (mechanism, frame) = (&linkage.mechanism, &linkage.structure.groups[group].frame);
    let is_outer = |id: PointId| {
        let mut outer = frame.outer.iter().map(|pair| linkage.structure.pairs[pair.id].source);
        outer.any(|source| source == PairId::Pin(id))
    };
    let of_group = |id: PointId| {
        let mut places = mechanism.points[id].places.iter().filter(|_| !is_outer(id));
        places.find_map(|place| Some((frame.column(place.link)?, place.at)))
    };
    let mut position = linkage.position();
    let is_free = |(id, _): &(PointId, [f64; 2])| of_group(*id).is_none();
    if !mechanism.assembly.iter().all(is_free) || linkage.solve_index(0, Order::Place, &mut position).is_err()
    {
        return Vec::new();
    }
    let Ok(Some(modes)) = linkage.modes(group, &position) else { return Vec::new() };
    let placed = |mode: &Mode<f64>| {
        let place = |id| of_group(id).map(|(column, at)| (id, mode.bodies[column].point(at)));
        (0..mechanism.points.len()).filter_map(place).collect()
    };
    let present = modes.present;
    modes.all.iter().enumerate().filter(|(k, _)| *k != present).map(|(_, mode)| placed(mode)).collect()
}

/// Links from the last to the first, then slides, then pins likewise; without the input and the link that balances.
fn candidates(mechanism: &Mechanism) -> Vec<PassivePart> {
    let input = &mechanism.input;
    let balanced = match mechanism.balance {
        Some(Balance::Moment(link)) => Some(link),
        Some(Balance::Force { at, .. }) => Some(at.link),
        None => None,
    };
    let links = (1..mechanism.links.len()).rev();
    let is_driven = |link: usize| input.drivers.iter().any(|driver| [driver.link, driver.on].contains(&link));
    let is_kept = |link: &usize| Some(*link) == balanced || is_driven(*link);
    let links = links.filter(|link| !is_kept(link)).map(PassivePart::Link);
    let slides = mechanism.slides.iter().enumerate().rev();
    let slides = slides
        .filter(|(id, _)| !input.drives(PairId::Slide(*id)))
        .map(|(id, slide)| PassivePart::Pair(PairId::Slide(id), slide.link));
    let pins = mechanism.points.iter().enumerate().rev();
    let pins = pins.filter(|(id, point)| point.is_pin() && !input.drives(PairId::Pin(*id)));
    let pins = pins.flat_map(|(id, point)| {
        let moving = point.places.iter().skip(1).rev().filter(|place| place.link != GROUND);
        moving.map(move |place| PassivePart::Pair(PairId::Pin(id), place.link))
    });
    links.chain(slides).chain(pins).collect()
}

/// Slides that repeat another one between the same links, of which the input's or else the first one stays.
fn doubled(mechanism: &Mechanism) -> Vec<PassivePart> {
    // Ends in a fixed order, and the direction of the guide in the first of them.
    let seen = |slide: &Slide| {
        if slide.link < slide.on {
            (slide.link, slide.on, slide.tilt)
        } else {
            (slide.on, slide.link, slide.angle)
        }
    };
    let is_input = |id: usize| mechanism.input.drives(PairId::Slide(id));
    let slides = || mechanism.slides.iter().enumerate();
    let repeats = |id: usize, slide: &Slide| {
        let (one, other, angle) = seen(slide);
        slides().any(|(earlier, kept)| {
            let (a, b, turn) = seen(kept);
            let before = if is_input(id) { false } else { earlier < id || is_input(earlier) };
            before && (a, b) == (one, other) && elementary::sin(turn - angle).abs() < MEANT_PARALLEL
        })
    };
    slides()
        .rev()
        .filter(|(id, slide)| repeats(*id, slide))
        .map(|(id, slide)| PassivePart::Pair(PairId::Slide(id), slide.link))
        .collect()
}
