//! The conformance suite of force analyzers: virtual power, equilibrium of every link, proportion, lanes.

use assur_force::{AnalyzerPlugin, ForceError, LoadState, Loads, Reactions, power};
use assur_group::plane::{cross, vector};
use assur_group::{Order, PairGeometry, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_number::{Lanes, Real as _};

use crate::Fault;
use crate::specimen::Recipe;

/// Mechanisms that are tried, and fewest that must be suitable: otherwise the suite proves nothing.
const MECHANISMS: u64 = 60;
const FEWEST: usize = 12;
/// The rounding that a method may have, in parts of the greatest force (at the size of the mechanism): the mechanisms stay away from
/// singular positions.
const ROUNDING: f64 = 1e-9;

/// Tests a registered force analyzer with the whole suite, and returns a failure as a value.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge_analyzer(name: &str) -> Result<(), Fault> {
    let plugin = assur_force::find(name).map_err(|error| Fault {
        check: "registry",
        seed: None,
        what: error.to_string(),
    })?;
    judge_forces(plugin)
}

/// Tests the entry of a force analyzer with the whole suite, on random mechanisms of the registered kinds of groups.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge_forces(plugin: &AnalyzerPlugin) -> Result<(), Fault> {
    let mut tried = 0;
    for seed in 0..MECHANISMS {
        let groups = 1 + usize::try_from(seed % 4).unwrap_or_default();
        let Some(specimen) = Recipe::of(groups).specimen(seed) else { continue };
        let mut mechanism = specimen.mechanism;
        mechanism.frictions.clear();
        if seed % 2 == 0 {
            mechanism.balance = None;
        }
        let fault = |check, what| Fault { check, seed: Some(seed), what };
        let linkage = Linkage::compile(mechanism).map_err(|error| fault("compile", error.to_string()))?;
        if plugin.instance.supports(&linkage).is_ok() {
            tried += usize::from(Case::judge(plugin, &linkage, seed)?);
        }
    }
    if tried < FEWEST {
        let what = format!("only {tried} of {MECHANISMS} random mechanisms were suitable, wanted {FEWEST}");
        return Err(Fault { check: "mechanisms", seed: None, what });
    }
    Ok(())
}

/// A mechanism in a position, with all loads.
struct Case<'l> {
    linkage: &'l Linkage,
    position: Position,
    loads: Vec<Wrench<f64>>,
    seed: u64,
}

impl Case<'_> {
    /// Whether the mechanism was suitable, or the first fault.
    fn judge(plugin: &AnalyzerPlugin, linkage: &Linkage, seed: u64) -> Result<bool, Fault> {
        let coordinate = linkage.mechanism.input.coordinate(0);
        let mut position = linkage.position();
        let Ok(loads) = Loads::compile(linkage) else { return Ok(false) };
        if linkage.solve(coordinate, Order::Second, &mut position).is_err() {
            return Ok(false);
        }
        let state = LoadState {
            speed: 3.0,
            acceleration: 2.0,
            ..LoadState::prescribed(&linkage.mechanism, coordinate)
        };
        let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
        loads.evaluate(&state, &position.bodies, &mut wrenches);
        let case = Case { linkage, position, loads: wrenches, seed };
        let found = match case.solved(plugin, 1.0) {
            Ok(found) => found,
            // A load that does no work balances nothing, whatever the method; a method's own singular position has no answer.
            Err(
                ForceError::IdleBalance { .. } | ForceError::Parallel { .. } | ForceError::ChangePoint(_),
            ) => return Ok(false),
            Err(error) => return Err(case.fault("solve", error.to_string())),
        };
        case.power(&found)?;
        if plugin.gives_reactions {
            case.equilibrium(&found)?;
        } else if !found.pairs.iter().all(|pair| [pair.fx, pair.fy, pair.m].iter().all(|part| part.is_nan()))
        {
            return Err(case.fault("reactions", "the method gives none, so they must be NaN".to_owned()));
        }
        case.proportion(plugin, &found)?;
        case.lanes(plugin, &found)?;
        Ok(true)
    }

    fn fault(&self, check: &'static str, what: String) -> Fault {
        Fault { check, seed: Some(self.seed), what }
    }

    fn solved(&self, plugin: &AnalyzerPlugin, factor: f64) -> Result<Reactions, ForceError> {
        let mut out = Reactions::new(self.linkage);
        let scaled = |load: &Wrench<f64>| load.map(|part| factor * part);
        let mut loads: Vec<Wrench<f64>> = self.loads.iter().map(scaled).collect();
        plugin.instance.solve(self.linkage, &self.position, &mut loads, &mut out)?;
        Ok(out)
    }

    /// The balancing load and all others together do no work.
    fn power(&self, found: &Reactions) -> Result<(), Fault> {
        let bodies = &self.position.bodies;
        let of_unit = found.unit.as_ref().map_or(1.0, |unit| unit.power(bodies));
        let powers = self.loads.iter().zip(bodies).map(|(load, body)| power(load, body));
        let (sum, size) = powers.fold((0.0, 0.0), |(sum, size): (f64, f64), p| (sum + p, size + p.abs()));
        let left = found.balancing * of_unit + sum;
        if left.abs() <= ROUNDING * size.max((found.balancing * of_unit).abs()) {
            return Ok(());
        }
        let what =
            format!("the balancing load {} leaves the power {left:.3e} of {size:.3e}", found.balancing);
        Err(self.fault("virtual power", what))
    }

    /// Loads, reactions and the balancing load of each moving link add up to nothing; a slide does not push along its guide.
    fn equilibrium(&self, found: &Reactions) -> Result<(), Fault> {
        let (linkage, bodies, scale) = (self.linkage, &self.position.bodies, self.linkage.structure.scale);
        let mut left = self.loads.clone();
        let balance = |along: [f64; 2]| along.map(|part| found.balancing * part);
        let mut greatest =
            left.iter().map(|load| load.fx.hypot(load.fy).max(load.m.abs() / scale)).fold(0.0, f64::max);
        if let Some(unit) = &found.unit {
            let wrench = unit.wrench(bodies).map(|part| found.balancing * part);
            add(&mut left[unit.link], wrench);
        }
        for (named, reaction) in linkage.structure.pairs.iter().zip(&found.pairs) {
            let (a, b) = (&bodies[named.pair.a], &bodies[named.pair.b]);
            let (point, guide) = match named.pair.geometry {
                PairGeometry::Pin { at_a, .. } => (at_a, None),
                PairGeometry::Slide { point, angle, .. } => {
                    (point, Some(b.turned([angle.cos(), angle.sin()])))
                }
            };
            let (place, mut force, mut moment) =
                (a.point(vector(point)), [reaction.fx, reaction.fy], reaction.m);
            greatest = greatest.max(force[0].hypot(force[1])).max(moment.abs() / scale);
            let along = guide.map_or(0.0, |guide| guide[0] * force[0] + guide[1] * force[1]);
            if along.abs() > ROUNDING * greatest {
                return Err(self.fault(
                    "guides",
                    format!("pair {} pushes along its guide with {along:.3e} N", named.pair.id),
                ));
            }
            // The drive acts in the pair of the input: a moment, or a force along the guide.
            if found.unit.is_none() && named.pair.id == linkage.structure.pairs[0].pair.id {
                match guide {
                    None => moment += sign_of_input(linkage, named.pair.a) * found.balancing,
                    Some(guide) => {
                        let drive = balance(guide);
                        force = [force[0] + drive[0], force[1] + drive[1]];
                    }
                }
            }
            for (link, body, sign) in [(named.pair.a, a, 1.0), (named.pair.b, b, -1.0)] {
                let arm = [place[0] - body.x, place[1] - body.y];
                let (fx, fy) = (sign * force[0], sign * force[1]);
                add(&mut left[link], Wrench { fx, fy, m: cross(arm, [fx, fy]) + sign * moment });
            }
        }
        for (link, rest) in left.iter().enumerate().skip(1) {
            let size = rest.fx.hypot(rest.fy).max(rest.m.abs() / scale);
            if size.is_nan() || size > ROUNDING * greatest {
                let name = &linkage.mechanism.links[link].name;
                return Err(self.fault(
                    "equilibrium",
                    format!("link `{name}` is left with {rest:?}, forces are up to {greatest:.3e} N"),
                ));
            }
        }
        Ok(())
    }

    /// Twice the loads give twice the answer.
    fn proportion(&self, plugin: &AnalyzerPlugin, found: &Reactions) -> Result<(), Fault> {
        let twice = self.solved(plugin, 2.0).map_err(|error| self.fault("proportion", error.to_string()))?;
        let off = (twice.balancing - 2.0 * found.balancing).abs();
        if off <= ROUNDING * found.balancing.abs() {
            return Ok(());
        }
        Err(self.fault(
            "proportion",
            format!("twice the loads change the balancing load by {off:.3e} from twice itself"),
        ))
    }

    /// A lane has the bits of its position.
    fn lanes(&self, plugin: &AnalyzerPlugin, found: &Reactions) -> Result<(), Fault> {
        let mut position = self.linkage.lane_position();
        let at = Lanes::from_f64(self.position.coordinate);
        if self.linkage.solve_lanes(at, Order::Second, &mut position).is_err() {
            return Ok(());
        }
        let mut loads: Vec<Wrench<Lanes>> = self.loads.iter().map(|load| load.map(Lanes::from_f64)).collect();
        let mut out = Reactions::<Lanes>::new(self.linkage);
        if !plugin.instance.solve_lanes(self.linkage, &position, &mut loads, &mut out) {
            return Ok(());
        }
        let same = |lanes: Lanes, one: f64| lanes.0.iter().all(|lane| lane.to_bits() == one.to_bits());
        let pairs = out.pairs.iter().zip(&found.pairs);
        let mut pairs = pairs
            .map(|(lanes, one)| same(lanes.fx, one.fx) && same(lanes.fy, one.fy) && same(lanes.m, one.m));
        if same(out.balancing, found.balancing) && pairs.all(|same| same) {
            return Ok(());
        }
        Err(self.fault("lanes", format!("{:?} is not {} in every lane", out.balancing, found.balancing)))
    }
}

fn add(to: &mut Wrench<f64>, wrench: Wrench<f64>) {
    (to.fx, to.fy, to.m) = (to.fx + wrench.fx, to.fy + wrench.fy, to.m + wrench.m);
}

/// Whether the first body of the input's pair is the input link, 1, or the ground, -1.
fn sign_of_input(linkage: &Linkage, first: usize) -> f64 {
    if first == linkage.mechanism.input.first().link { 1.0 } else { -1.0 }
}
