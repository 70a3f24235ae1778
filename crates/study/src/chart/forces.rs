//! Forces: every registered analyzer, and the groups in other forms and numbers.

use std::hint::black_box;

use assur_force::{AnalyzerPlugin, Loads, Reactions, State, UnitBalance, analyzers};
use assur_group::{AssurGroup, Body, GroupError, Number, Wrench};
use assur_kinematics::{Chain, Linkage, Position};
use assur_mechanism::{Mechanism, Motion};
use assur_number::{Dd, Real};

use super::data::GIVES;
use super::entry::{Contestant, Entry, Field, Verdict};
use super::reaction::{Answer, Forms};
use super::ruler::greater;
use super::work::{Work, partial, positions};
use super::{ChartError, Reference, Row, Setting, Stage, Unit, Value};

/// The positions with their loads, and the true reactions.
pub(crate) struct Loaded<'a> {
    work: &'a Work<'a>,
    positions: Vec<Position>,
    /// By position: all loads about the origins of the links.
    loads: Vec<Vec<Wrench<f64>>>,
    /// By position: the balancing load of size 1, where it is not the drive's.
    units: Vec<Option<UnitBalance>>,
    truth: Vec<Truth>,
    /// Greatest force, moment and balancing load over the work.
    sizes: [f64; 3],
    reference: Reference,
}

/// Reactions in extended precision.
struct Truth {
    pairs: Vec<Wrench<Dd>>,
    balancing: Dd,
}

/// The state in which forces are compared: the prescribed motion, or the initial or mean speed without acceleration.
fn state(mechanism: &Mechanism, coordinate: f64) -> State {
    match mechanism.motion {
        Some(Motion::Transient { speed, .. } | Motion::Steady { mean_speed: speed, .. }) => {
            State { coordinate, speed, ..State::default() }
        }
        _ => State::prescribed(mechanism, coordinate),
    }
}

impl<'a> Loaded<'a> {
    /// Loads all positions, and finds their reactions in extended precision.
    pub(crate) fn new(work: &'a Work<'a>, loads: &Loads) -> Result<Self, ChartError> {
        let mechanism = &work.linkage.mechanism;
        let positions = positions(work)?;
        let mut wrenches = Vec::with_capacity(positions.len());
        for position in &positions {
            let state = state(mechanism, position.coordinate);
            let mut sum = vec![Wrench::ZERO; work.linkage.structure.links];
            loads.apply(&state, &position.bodies, &mut sum);
            loads.inertia(&state, &position.bodies, &mut sum);
            wrenches.push(sum);
        }
        let units = positions.iter().map(|position| UnitBalance::of(mechanism, &position.bodies)).collect();
        let mut loaded = Self {
            work,
            positions,
            loads: wrenches,
            units,
            truth: Vec::new(),
            sizes: [0.0; 3],
            reference: Reference { how: String::new(), error: 0.0 },
        };
        loaded.find_truth()?;
        Ok(loaded)
    }

    /// Whether nothing acts anywhere: then there are no forces to find.
    pub(crate) fn is_idle(&self) -> bool {
        self.loads.iter().flatten().all(|load| *load == Wrench::ZERO)
    }

    fn find_truth(&mut self) -> Result<(), ChartError> {
        let (linkage, groups) = (self.work.linkage, &self.work.extended.groups);
        let mut other = Vec::with_capacity(self.positions.len());
        for (index, bodies) in self.work.truth.iter().enumerate() {
            let coordinate = self.work.coordinates[index];
            let solve = |forms| {
                let mut answer = Answer::<Dd>::new(linkage);
                let (loads, unit) = (&self.loads[index], self.units[index]);
                answer
                    .solve(linkage, groups, bodies, loads, unit, forms)
                    .map_err(|_| ChartError::NoReference { coordinate })?;
                Ok::<_, ChartError>(Truth { pairs: answer.pairs, balancing: answer.balancing })
            };
            self.truth.push(solve(Forms::General)?);
            other.push(solve(Forms::Closed)?);
        }
        self.sizes = sizes(&self.truth, linkage.structure.scale);
        let errors = other.iter().enumerate().map(|(i, other)| {
            self.deviation(
                i,
                Some(other.pairs.iter().map(|pair| [pair.fx, pair.fy, pair.m])),
                other.balancing,
            )
        });
        let error = errors.fold(Dd::EPSILON, greater);
        let how = "loads as the program finds them; reactions by the transposed linear system of each group in double-double \
                   arithmetic (about 32 digits); own error by the closed forms of the groups in the same arithmetic";
        self.reference = Reference { how: how.to_owned(), error };
        Ok(())
    }

    /// Largest relative deviation of one position.
    fn deviation(&self, index: usize, pairs: Option<impl Iterator<Item = [Dd; 3]>>, balancing: Dd) -> f64 {
        let truth = &self.truth[index];
        let [force, moment, balance] = self.sizes;
        let mut worst = (balancing - truth.balancing).to_f64().abs() / balance;
        for (right, got) in truth.pairs.iter().zip(pairs.into_iter().flatten()) {
            worst = greater(worst, (got[0] - right.fx).to_f64().abs() / force);
            worst = greater(worst, (got[1] - right.fy).to_f64().abs() / force);
            worst = greater(worst, (got[2] - right.m).to_f64().abs() / moment);
        }
        worst
    }

    /// Judges a method over all positions.
    fn verdict(&self, evaluations: u64, mut solve: impl FnMut(usize) -> Result<f64, String>) -> Verdict {
        let (mut worst, mut failures, mut first) = (None, 0, None);
        for index in 0..self.positions.len() {
            match solve(index) {
                Ok(error) => worst = Some(greater(worst.unwrap_or(0.0), error)),
                Err(why) => {
                    failures += 1;
                    first.get_or_insert(why);
                }
            }
        }
        let failure = partial(failures, self.positions.len(), first);
        Verdict { evaluations: Some(evaluations), error: worst, failure }
    }
}

/// Greatest force, moment (at least a force on a typical arm) and balancing load.
fn sizes(truth: &[Truth], scale: f64) -> [f64; 3] {
    let most =
        |of: &dyn Fn(&Wrench<Dd>) -> f64| truth.iter().flat_map(|t| &t.pairs).map(of).fold(0.0, f64::max);
    let positive = |size: f64, instead: f64| if size > 0.0 { size } else { instead };
    let force = positive(most(&|w| w.fx.to_f64().hypot(w.fy.to_f64())), 1.0);
    let moment = most(&|w| w.m.to_f64().abs()).max(force * scale);
    let balancing = truth.iter().map(|t| t.balancing.to_f64().abs()).fold(0.0, f64::max);
    [force, moment, positive(balancing, moment)]
}

/// All that can give forces.
pub(crate) fn field<'a>(loaded: &'a Loaded<'a>) -> Result<Field<'a>, ChartError> {
    let linkage = loaded.work.linkage;
    let mut entries = Vec::new();
    let all = analyzers()?;
    for plugin in &all {
        let mut row = row(plugin.name, "f64");
        if !plugin.gives_reactions {
            row.setting.0.push((GIVES, Value::Word("balancing load only")));
        }
        entries.push(match plugin.instance.supports(linkage) {
            Ok(()) => Entry::new(row, loaded.positions.len(), Registered::new(loaded, plugin)),
            Err(why) => Entry::refused(row, &why),
        });
    }
    let single = ByGroups::<f32>::new(loaded, Forms::Closed)?;
    let by_groups = all.iter().find(|plugin| plugin.by_groups).map_or("by groups", |plugin| plugin.name);
    entries.push(Entry::new(row(by_groups, "f32"), loaded.positions.len(), single));
    let general = ByGroups::<f64>::new(loaded, Forms::General)?;
    entries.push(Entry::new(row("groups-general", "f64"), loaded.positions.len(), general));
    Ok(Field { reference: loaded.reference.clone(), entries })
}

fn row(method: &str, number: &'static str) -> Row {
    Row::new(Stage::Forces, Unit::Position, method, Setting::word("number", number))
}

/// A registered analyzer.
struct Registered<'a> {
    loaded: &'a Loaded<'a>,
    plugin: &'static AnalyzerPlugin,
    loads: Vec<Wrench<f64>>,
    out: Reactions,
}

impl<'a> Registered<'a> {
    fn new(loaded: &'a Loaded<'a>, plugin: &'static AnalyzerPlugin) -> Self {
        let linkage = loaded.work.linkage;
        Self {
            loaded,
            plugin,
            loads: vec![Wrench::ZERO; linkage.structure.links],
            out: Reactions::new(linkage),
        }
    }

    fn solve(&mut self, index: usize) -> Result<(), assur_force::ForceError> {
        self.loads.copy_from_slice(&self.loaded.loads[index]);
        let (linkage, position) = (self.loaded.work.linkage, &self.loaded.positions[index]);
        self.plugin.instance.solve(linkage, position, &mut self.loads, &mut self.out)
    }
}

impl Contestant for Registered<'_> {
    fn run(&mut self) {
        for index in 0..self.loaded.positions.len() {
            let _ = black_box(self.solve(index));
        }
    }

    fn judge(&mut self) -> Verdict {
        let loaded = self.loaded;
        let groups = loaded.work.linkage.groups().len() as u64;
        loaded.verdict(groups, |index| {
            self.solve(index).map_err(|error| error.to_string())?;
            let pairs = self.plugin.gives_reactions.then(|| self.out.pairs.iter().map(exact));
            Ok(loaded.deviation(index, pairs, Dd::from_f64(self.out.balancing)))
        })
    }
}

fn exact<T: Real>(wrench: &Wrench<T>) -> [Dd; 3] {
    [wrench.fx, wrench.fy, wrench.m].map(|x| Dd::from_f64(x.to_f64()))
}

/// Group by group in another number or form.
struct ByGroups<'a, T: Number> {
    loaded: &'a Loaded<'a>,
    groups: Vec<Box<dyn AssurGroup<T>>>,
    bodies: Vec<Vec<Body<T>>>,
    forms: Forms,
    answer: Answer<T>,
}

impl<'a, T: Number> ByGroups<'a, T> {
    fn new(loaded: &'a Loaded<'a>, forms: Forms) -> Result<Self, ChartError> {
        let linkage = loaded.work.linkage;
        let chain = Chain::<T>::compile(&linkage.mechanism, &linkage.structure)?;
        let bodies =
            loaded.positions.iter().map(|position| position.bodies.iter().map(to).collect()).collect();
        Ok(Self { loaded, groups: chain.groups, bodies, forms, answer: Answer::new(linkage) })
    }

    fn solve(&mut self, index: usize) -> Result<(), GroupError> {
        let linkage: &Linkage = self.loaded.work.linkage;
        let (loads, unit) = (&self.loaded.loads[index], self.loaded.units[index]);
        self.answer.solve(linkage, &self.groups, &self.bodies[index], loads, unit, self.forms)
    }
}

/// A body in another number.
fn to<T: Real>(body: &Body<f64>) -> Body<T> {
    body.map(T::from_f64)
}

impl<T: Number> Contestant for ByGroups<'_, T> {
    fn run(&mut self) {
        for index in 0..self.loaded.positions.len() {
            let _ = black_box(self.solve(index));
        }
    }

    fn judge(&mut self) -> Verdict {
        let loaded = self.loaded;
        loaded.verdict(self.groups.len() as u64, |index| {
            self.solve(index).map_err(|error| error.to_string())?;
            let pairs = Some(self.answer.pairs.iter().map(exact));
            Ok(loaded.deviation(index, pairs, Dd::from_f64(self.answer.balancing.to_f64())))
        })
    }
}
