//! Forces: every registered analyzer, and the groups in other forms and numbers.

use assur_force::{AnalyzerPlugin, LoadState, Loads, Reactions, Unsolved, analyzers, group_by_group};
use assur_group::{AssurGroup, Body, Number, Order, Wrench, reactions_generally};
use assur_kinematics::{Chain, Linkage, Position};
use assur_mechanism::{Mechanism, Motion};
use assur_number::{Dd, Real, greater};
use assur_words::{Describe, Text, text};

use super::data::GIVES;
use super::race::{Entry, Field};
use super::work::{Work, difference};
use super::{ChartError, Measurement, Reference, Setting, SettingValue, Stage};

/// The positions with their loads, and the reference reactions.
pub(crate) struct Loaded<'a> {
    pub(super) work: &'a Work<'a>,
    pub(super) positions: Vec<Position>,
    /// By position: all loads about the origins of the links.
    pub(super) loads: Vec<Vec<Wrench<f64>>>,
    truth: Vec<Reactions<Dd>>,
    /// Greatest force, moment and balancing load over the work.
    sizes: [f64; 3],
    reference: Reference,
}

/// The state in which forces are compared: the prescribed motion, or the initial or mean speed without acceleration.
pub(crate) fn state(mechanism: &Mechanism, coordinate: f64) -> LoadState {
    match mechanism.motion {
        Some(Motion::Transient { speed, .. } | Motion::Steady { mean_speed: speed, .. }) => {
            LoadState { coordinate, speed, ..LoadState::default() }
        }
        _ => LoadState::prescribed(mechanism, coordinate),
    }
}

impl<'a> Loaded<'a> {
    /// Loads all positions, and finds their reactions in extended precision.
    pub(crate) fn new(work: &'a Work<'a>, loads: &Loads) -> Result<Self, ChartError> {
        let mechanism = &work.linkage.mechanism;
        let mut positions = vec![work.linkage.position(); work.coordinates.len()];
        let mut wrenches = Vec::with_capacity(positions.len());
        for (position, q) in positions.iter_mut().zip(&work.coordinates) {
            work.linkage.solve(*q, Order::Second, position)?;
            let state = state(mechanism, position.coordinate);
            loads.finite(mechanism, &state, &position.bodies)?;
            wrenches.push(loads.total(&state, &position.bodies));
        }
        let mut loaded = Self {
            work,
            positions,
            loads: wrenches,
            truth: Vec::new(),
            sizes: [0.0; 3],
            reference: Reference { how: Text::default(), error: 0.0 },
        };
        loaded.find_truth()?;
        Ok(loaded)
    }

    pub(crate) fn state(&self, index: usize) -> LoadState {
        state(&self.work.linkage.mechanism, self.positions[index].coordinate)
    }

    /// Whether all loads are zero: then there are no forces to find.
    pub(crate) fn is_idle(&self) -> bool {
        self.loads.iter().flatten().all(|load| *load == Wrench::ZERO)
    }

    fn find_truth(&mut self) -> Result<(), ChartError> {
        let (linkage, groups) = (self.work.linkage, &self.work.extended.groups);
        let mut other = Vec::with_capacity(self.positions.len());
        for (index, bodies) in self.work.truth.iter().enumerate() {
            let coordinate = self.work.coordinates[index];
            let solve = |generally| {
                let mut own = vec![Wrench::ZERO; linkage.structure.links];
                let mut out = Reactions::new(linkage);
                solve(linkage, groups, bodies, &self.loads[index], generally, &mut own, &mut out)
                    .map_err(|_| ChartError::NoReference { coordinate })?;
                Ok::<_, ChartError>(out)
            };
            self.truth.push(solve(true)?);
            other.push(solve(false)?);
        }
        self.sizes = sizes(&self.truth, linkage.structure.scale);
        let errors =
            other.iter().enumerate().map(|(i, other)| self.deviation(i, &other.pairs, other.balancing));
        let error = errors.fold(Dd::EPSILON, greater);
        self.reference = Reference { how: text!("chart-reference-forces"), error };
        Ok(())
    }

    /// Largest relative deviation of one position; without pairs, of the balancing load alone.
    fn deviation<T: Real>(&self, index: usize, pairs: &[Wrench<T>], balancing: T) -> f64 {
        let truth = &self.truth[index];
        let [force, moment, balance] = self.sizes;
        let mut worst = difference(balancing, truth.balancing).abs() / balance;
        for (right, found) in truth.pairs.iter().zip(pairs) {
            worst = greater(worst, difference(found.fx, right.fx).abs() / force);
            worst = greater(worst, difference(found.fy, right.fy).abs() / force);
            worst = greater(worst, difference(found.m, right.m).abs() / moment);
        }
        worst
    }
}

/// Greatest force, moment (at least a force on a typical arm) and balancing load.
fn sizes(truth: &[Reactions<Dd>], scale: f64) -> [f64; 3] {
    let most =
        |of: &dyn Fn(&Wrench<Dd>) -> f64| truth.iter().flat_map(|t| &t.pairs).map(of).fold(0.0, f64::max);
    let positive = |size: f64, instead: f64| if size > 0.0 { size } else { instead };
    let force = positive(most(&|w| w.fx.to_f64().hypot(w.fy.to_f64())), 1.0);
    let moment = most(&|w| w.m.to_f64().abs()).max(force * scale);
    let balancing = truth.iter().map(|t| t.balancing.to_f64().abs()).fold(0.0, f64::max);
    [force, moment, positive(balancing, moment)]
}

pub(crate) fn field<'a>(loaded: &'a Loaded<'a>) -> Result<Field<'a>, ChartError> {
    let linkage = loaded.work.linkage;
    let mut entries = Vec::new();
    let all = analyzers()?;
    for plugin in &all {
        let mut row = row(plugin.name, "f64");
        if !plugin.gives_reactions {
            row.setting.0.push((GIVES, SettingValue::Word("balancing load only")));
        }
        entries.push(match plugin.supports(linkage) {
            Ok(()) => loaded.work.entry(row, 1, registered(loaded, plugin)),
            Err(why) => Entry::refused(row, why),
        });
    }
    let by_rank = all.iter().filter(|plugin| plugin.by_groups).min_by_key(|plugin| plugin.rank);
    let name = by_rank.map_or("by groups", |plugin| plugin.name);
    entries.push(loaded.work.entry(row(name, "f32"), 1, by_groups::<f32>(loaded, false)?));
    let general = by_groups::<f64>(loaded, true)?;
    entries.push(loaded.work.entry(row("groups-general", "f64"), 1, general));
    Ok(Field { reference: loaded.reference.clone(), entries })
}

fn row(method: &str, number: &'static str) -> Measurement {
    Measurement::new(Stage::Forces, method, Setting::word("number", number))
}

fn registered<'a>(
    loaded: &'a Loaded<'a>,
    plugin: &'static AnalyzerPlugin,
) -> impl FnMut(usize, bool) -> Result<f64, Text> + 'a {
    let linkage = loaded.work.linkage;
    let mut loads = vec![Wrench::ZERO; linkage.structure.links];
    let mut out = Reactions::new(linkage);
    move |index, judged| {
        loads.copy_from_slice(&loaded.loads[index]);
        let solved = plugin.instance.solve(linkage, &loaded.positions[index], &mut loads, &mut out);
        solved.map_err(|error| error.describe())?;
        let pairs = if plugin.gives_reactions { &out.pairs[..] } else { &[] };
        Ok(if judged { loaded.deviation(index, pairs, out.balancing) } else { 0.0 })
    }
}

/// Group by group in another number or form, see [`solve`].
fn by_groups<'a, T: Number>(
    loaded: &'a Loaded<'a>,
    generally: bool,
) -> Result<impl FnMut(usize, bool) -> Result<f64, Text> + 'a, ChartError> {
    let linkage = loaded.work.linkage;
    let groups = Chain::<T>::compile(&linkage.mechanism, &linkage.structure)?.groups;
    let of = |position: &Position| position.bodies.iter().map(|body| body.map(T::from_f64)).collect();
    let bodies: Vec<Vec<Body<T>>> = loaded.positions.iter().map(of).collect();
    let mut own = vec![Wrench::ZERO; linkage.structure.links];
    let mut out = Reactions::new(linkage);
    Ok(move |index: usize, judged| {
        let solved =
            solve(linkage, &groups, &bodies[index], &loaded.loads[index], generally, &mut own, &mut out);
        solved.map_err(|reason| reason.explain(linkage, loaded.work.coordinates[index]).describe())?;
        Ok(if judged { loaded.deviation(index, &out.pairs, out.balancing) } else { 0.0 })
    })
}

/// Solves one position. `loads`: about the origins of the bodies; `generally`: the reactions of a group from the transposed linear
/// system of its constraints, otherwise by the closed forms of its kind; `own`: scratch memory, one wrench for each body.
pub(crate) fn solve<T: Number>(
    linkage: &Linkage,
    groups: &[Box<dyn AssurGroup<T>>],
    bodies: &[Body<T>],
    loads: &[Wrench<f64>],
    generally: bool,
    own: &mut [Wrench<T>],
    out: &mut Reactions<T>,
) -> Result<(), Unsolved> {
    for (own, load) in own.iter_mut().zip(loads) {
        *own = load.map(T::from_f64);
    }
    group_by_group(linkage, groups, bodies, own, out, |group, bodies, loads, pairs| {
        if generally {
            reactions_generally(group.frame(), bodies, loads, pairs, 1)
        } else {
            group.reactions(bodies, loads, pairs)
        }
    })
}
