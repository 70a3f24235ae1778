//! Dry friction: the methods that solve it, against the textbook iteration after so many steps and against a regularized law.

use assur_force::{
    AnalyzerPlugin, Frictions, Kinetostatics, LoadState, Loads, Reactions, RegistryError, Unknown, analyzers,
    choose,
};
use assur_kinematics::{Linkage, Position};
use assur_words::{Describe, Text, text};

use super::{ChartError, Measurement, Reference, Setting, Stage, forces::Loaded, race::Field};

const STEPS: [u32; 5] = [1, 2, 4, 8, 16];

/// Widths of a regularized law: the relative speed, as part of its greatest, below which its friction is less.
const WIDTHS: [f64; 3] = [1e-1, 1e-2, 1e-3];

pub(crate) struct FrictionMethods<'a> {
    loaded: &'a Loaded<'a>,
    frictions: &'a Frictions,
    loads: &'a Loads,
    /// The method without friction in which the iteration solves each step.
    ideal: &'static AnalyzerPlugin,
    states: Vec<LoadState>,
    /// By position: the sense of each bearing, and its relative speed as part of its greatest.
    senses: Vec<Vec<[f64; 2]>>,
    /// By position: forces of friction, then the balancing load; `None` where there is no solution.
    truth: Vec<Option<Vec<f64>>>,
    reference: Reference,
}

impl<'a> FrictionMethods<'a> {
    /// `None` where the pairs are ideal.
    pub(crate) fn new(loaded: &'a Loaded<'a>, loads: &'a Loads) -> Result<Option<Self>, ChartError> {
        let Some(frictions) = loads.frictions() else { return Ok(None) };
        let linkage = loaded.work.linkage;
        let states: Vec<LoadState> = (0..loaded.positions.len()).map(|index| loaded.state(index)).collect();
        let mut senses = vec![vec![0.0; frictions.bearings.len()]; states.len()];
        for ((state, position), senses) in states.iter().zip(&loaded.positions).zip(&mut senses) {
            loads.senses(state, &position.bodies, senses);
        }
        let speed = |position: &Position, bearing: usize| {
            frictions.bearings[bearing].relative(&position.bodies).abs()
        };
        let most =
            |bearing: usize| loaded.positions.iter().map(|one| speed(one, bearing)).fold(0.0, f64::max);
        let most: Vec<f64> = (0..frictions.bearings.len()).map(most).collect();
        let senses = senses.iter().zip(&loaded.positions).map(|(senses, position)| {
            let each = senses.iter().enumerate();
            each.map(|(bearing, sense)| {
                [*sense, speed(position, bearing) / most[bearing].max(f64::MIN_POSITIVE)]
            })
            .collect()
        });
        let mut found = Self {
            loaded,
            frictions,
            loads,
            ideal: choose(None, false, !linkage.structure.passive.is_empty())?,
            senses: senses.collect(),
            states,
            truth: Vec::new(),
            reference: Reference { how: text!("chart-reference-friction"), error: 0.0 },
        };
        let treating = treating(linkage)?;
        // The last in rank is independent of the one that is used.
        let Some(judge) = treating.iter().max_by_key(|plugin| plugin.rank) else { return Ok(None) };
        let mut forces = found.method(judge);
        found.truth = (0..found.states.len()).map(|index| found.solved(&mut forces, index).ok()).collect();
        if let Some(other) = treating.iter().min_by_key(|plugin| plugin.rank) {
            let mut forces = found.method(other);
            let each = (0..found.states.len()).filter_map(|index| {
                let own = found.solved(&mut forces, index).ok()?;
                Some(found.deviation(index, &own))
            });
            found.reference.error = each.collect::<Vec<_>>().into_iter().fold(f64::EPSILON, f64::max);
        }
        Ok(Some(found))
    }

    fn linkage(&self) -> &'a Linkage {
        self.loaded.work.linkage
    }

    fn method(&self, plugin: &AnalyzerPlugin) -> Kinetostatics<'a> {
        let carrying = vec![true; self.linkage().groups().len()];
        Kinetostatics::new(self.linkage(), self.loads, plugin.instance, &carrying)
    }

    fn solved(&self, forces: &mut Kinetostatics<'_>, index: usize) -> Result<Vec<f64>, Text> {
        friction_and_balancing(forces, &self.states[index], &self.loaded.positions[index])
    }

    /// Greatest deviation of the balancing load, as part of what friction makes of it; 0 where there is no reference.
    fn deviation(&self, index: usize, found: &[f64]) -> f64 {
        let Some(truth) = &self.truth[index] else { return 0.0 };
        let [Some(own), Some(known)] = [found.last(), truth.last()] else { return 0.0 };
        let size = truth.iter().fold(0.0_f64, |most, force| most.max(force.abs())).max(f64::MIN_POSITIVE);
        (own - known).abs() / size
    }

    /// The balancing load after some steps of the iteration; `width` of a regularized law, 0 of the law itself.
    fn iterated(&self, index: usize, steps: u32, width: f64, out: &mut Reactions) -> Result<f64, Text> {
        let position = &self.loaded.positions[index];
        let mut sizes = vec![0.0; self.frictions.unknowns.len()];
        for step in 0..=steps {
            let mut own = self.loaded.loads[index].clone();
            for (unknown, size) in self.frictions.unknowns.iter().zip(&sizes) {
                let bearing = &self.frictions.bearings[unknown.bearing];
                let [sense, speed] = self.senses[index][unknown.bearing];
                let smooth = if width > 0.0 { speed / speed.hypot(width) } else { 1.0 };
                unknown.kind.load(
                    bearing,
                    &position.bodies,
                    sense * smooth * bearing.coefficient * size,
                    &mut own,
                );
            }
            let solved = self.ideal.instance.solve(self.linkage(), position, &mut own, out);
            solved.map_err(|error| error.describe())?;
            if step < steps {
                let size = |unknown: &Unknown| {
                    let bearing = &self.frictions.bearings[unknown.bearing];
                    let [x, y] = unknown.vector(bearing, &position.bodies, &out.pairs);
                    if unknown.is_modulus() { x.hypot(y) } else { x }
                };
                sizes = self.frictions.unknowns.iter().map(size).collect();
            }
        }
        Ok(out.balancing)
    }
}

pub(crate) fn treating(linkage: &Linkage) -> Result<Vec<&'static AnalyzerPlugin>, RegistryError> {
    let mut all = analyzers()?;
    all.retain(|plugin| plugin.treats_friction && plugin.supports(linkage).is_ok());
    Ok(all)
}

pub(crate) fn friction_and_balancing(
    forces: &mut Kinetostatics<'_>,
    state: &LoadState,
    position: &Position,
) -> Result<Vec<f64>, Text> {
    forces.solve(state, position).map_err(|error| error.describe())?;
    let friction = forces.reactions.friction.iter().flat_map(|friction| &friction.forces);
    Ok(friction.copied().chain([forces.reactions.balancing]).collect())
}

/// The methods that treat friction, and those of textbooks and of multibody programs.
pub(crate) fn field<'a>(methods: &'a FrictionMethods<'a>) -> Result<Field<'a>, ChartError> {
    let row = |method: &str, setting| Measurement::new(Stage::Friction, method, setting);
    let mut entries = Vec::new();
    for plugin in treating(methods.linkage())? {
        let mut forces = methods.method(plugin);
        entries.push(methods.loaded.work.entry(
            row(plugin.name, Setting::default()),
            1,
            move |index, judged| {
                let found = methods.solved(&mut forces, index)?;
                Ok(if judged { methods.deviation(index, &found) } else { 0.0 })
            },
        ));
    }
    let mut iterated = |name: &str, setting, steps: u32, width: f64| {
        let mut out = Reactions::new(methods.linkage());
        entries.push(methods.loaded.work.entry(row(name, setting), 1, move |index, judged| {
            let found = methods.iterated(index, steps, width, &mut out)?;
            Ok(if judged { methods.deviation(index, &[found]) } else { 0.0 })
        }));
    };
    for steps in STEPS {
        iterated("iteration", Setting::number("steps", f64::from(steps)), steps, 0.0);
    }
    for width in WIDTHS {
        iterated("regularized", Setting::number("width", width), STEPS[STEPS.len() - 1], width);
    }
    Ok(Field { reference: methods.reference.clone(), entries })
}
