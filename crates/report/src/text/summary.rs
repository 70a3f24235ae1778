//! The results that are asked for first: structure, strokes, greatest loads, the drive, whether the checks hold.

use assur_analysis::results::{Analysis, Column, Dynamics, Owner, Quantity};
use assur_geometry::output_strokes;
use assur_kinematics::Linkage;
use assur_mechanism::Range;

use super::forces::shown;
use super::number::short;
use super::units::{FORCE, LENGTH, MOMENT, POWER, SECOND, Units};

/// One result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// What it is, in English.
    pub what: String,
    /// Its value with six significant digits, or words.
    pub value: String,
    /// Unit of the value; may be empty.
    pub unit: &'static str,
    /// The coordinate at which it occurs, with its unit; empty where it belongs to the whole motion.
    pub at: String,
}

/// The results that are asked for first. Greatest values are those of the positions of the scene, strokes are found between
/// them.
pub fn summary(analysis: &Analysis, linkage: &Linkage) -> Vec<Finding> {
    let mut list = List { units: Units::of(analysis.input.angular), findings: Vec::new() };
    list.structure(analysis);
    list.strokes(linkage);
    list.reactions(analysis, linkage);
    list.balancing(analysis, linkage);
    if let Some(dynamics) = &analysis.dynamics {
        list.dynamics(dynamics);
    }
    list.lost(analysis);
    list.checks(analysis);
    list.findings
}

struct List {
    units: Units,
    findings: Vec<Finding>,
}

impl List {
    fn add(&mut self, what: impl Into<String>, value: String, unit: &'static str, at: &[f64]) {
        let place = self.units.coordinate;
        let at = match at.iter().map(|q| short(q * place.factor)).collect::<Vec<_>>().join("; ") {
            none if none.is_empty() => none,
            some => format!("{some} {}", place.name),
        };
        self.findings.push(Finding { what: what.into(), value, unit, at });
    }

    fn structure(&mut self, analysis: &Analysis) {
        let structure = &analysis.structure;
        self.add("formula of structure", structure.formula.clone(), "", &[]);
        self.add("class of the mechanism", assur_structure::roman(structure.class).to_owned(), "", &[]);
        self.add("mobility", structure.mobility.to_string(), "", &[]);
        if let Some(found) = &analysis.integration {
            self.add(
                "time of the end of the motion",
                short(found.end.time),
                SECOND.name,
                &[found.end.coordinate],
            );
            self.add("speed at the end of the motion", short(found.end.speed), self.units.rates[0].name, &[]);
        }
    }

    /// A mechanism that can't be assembled everywhere has no strokes.
    fn strokes(&mut self, linkage: &Linkage) {
        for (slide, stroke) in output_strokes(linkage).unwrap_or_default() {
            let name = &linkage.mechanism.slides[slide].name;
            let size = short(stroke.stroke * LENGTH.factor);
            self.add(format!("stroke of {name}, dead points"), size, LENGTH.name, &stroke.dead_points);
            if let Some(ratio) = stroke.time_ratio {
                self.add(format!("time ratio of {name}"), short(ratio), "", &[]);
            }
        }
    }

    fn reactions(&mut self, analysis: &Analysis, linkage: &Linkage) {
        let schema = analysis.positions.schema();
        for (pair, links) in shown(&analysis.positions) {
            let name = schema.name(Owner::Pair(pair));
            for on in links.into_iter().map(|link| schema.link(link)) {
                let all = &analysis.cycle.reaction_extremes;
                let here = all.iter().find(|one| one.joint == name && one.on == on);
                let Some(found) = here.filter(|one| one.greatest > 0.0) else { continue };
                let what = format!("greatest reaction of {name} on {on}");
                self.add(what, short(found.greatest), FORCE.name, &[found.coordinate]);
            }
            let moments = &analysis.survey.greatest_moments;
            let found = moments.iter().find(|(guide, (_, moment))| *guide == pair && *moment != 0.0);
            if let Some((_, (number, moment))) = found {
                let at = linkage.mechanism.input.coordinate(*number);
                self.add(format!("greatest moment of {name}"), short(*moment), MOMENT.name, &[at]);
            }
        }
    }

    fn balancing(&mut self, analysis: &Analysis, linkage: &Linkage) {
        let greatest = analysis.survey.greatest_balancing.filter(|(_, load)| *load != 0.0);
        let Some((number, greatest)) = greatest else { return };
        let moment = analysis.input.balancing_is_moment;
        let (name, unit) = if moment { ("moment", MOMENT.name) } else { ("force", FORCE.name) };
        let at = linkage.mechanism.input.coordinate(number);
        self.add(format!("greatest balancing {name}"), short(greatest), unit, &[at]);
        let table = &analysis.positions;
        let (Some(load), true) =
            (table.schema().find(Column::BALANCING), linkage.mechanism.balance.is_none())
        else {
            return;
        };
        let loads: Vec<f64> = table.each(load).flatten().collect();
        if analysis.dynamics.is_some() {
            return;
        }
        // Equal steps over a whole cycle; a part of a cycle has no mean of this kind. The mean moment of a regime is that of
        // its works, which the positions give to the step of the positions only.
        if matches!(linkage.mechanism.input.range, Range::Cycle(_)) && loads.len() == table.len() {
            let mean = loads.iter().sum::<f64>() / loads.len() as f64;
            self.add(format!("mean of the balancing {name} at the positions"), short(mean), unit, &[]);
        }
        let speed = Column::of(Quantity::Velocity, Owner::Input);
        let power = |row: usize| Some((row, table.at(row, load)? * table.get(row, speed)?));
        let greatest =
            (0..table.len()).filter_map(power).max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()));
        if let Some((row, power)) = greatest {
            let at = linkage.mechanism.input.coordinate(table.numbers()[row]);
            self.add("greatest power of the balancing load", short(power), POWER, &[at]);
        }
    }

    fn dynamics(&mut self, found: &Dynamics) {
        let (rate, inertia) = (self.units.rates[0].name, self.units.reduced[0].name);
        self.add("mean speed", short(found.figures.mean_speed), rate, &[]);
        self.add("unevenness", short(found.figures.unevenness), "", &[]);
        self.add("required power", short(found.figures.required_power), POWER, &[]);
        if let Some(motor) = &found.motor {
            if !motor.designation.is_empty() {
                self.add("motor", motor.designation.clone(), "", &[]);
            }
            self.add("rated power of the motor", short(motor.rated.power), POWER, &[]);
        }
        for (what, value, unit) in [
            ("gear ratio", found.figures.ratio, ""),
            ("constant driving moment", found.figures.torque, self.units.reduced[2].name),
            ("moment of inertia of the flywheel", found.flywheel, inertia),
        ] {
            if let Some(value) = value {
                self.add(what, short(value), unit, &[]);
            }
        }
    }

    /// What has no solution, so that nothing after it speaks of everything.
    fn lost(&mut self, analysis: &Analysis) {
        let lost = analysis.survey.failures;
        if lost > 0 {
            self.add("positions without a solution", lost.to_string(), "", &[]);
        }
        if analysis.no_motion.is_some() {
            self.add("motion that the scene asks for", "not found".to_owned(), "", &[]);
        }
    }

    fn checks(&mut self, analysis: &Analysis) {
        let checks = &analysis.checks;
        if checks.is_empty() {
            return;
        }
        let failed: Vec<&str> =
            checks.iter().filter(|check| check.failed()).map(|check| check.name).collect();
        let judged = checks.iter().filter(|check| check.verdict().is_some()).count();
        if failed.is_empty() {
            let whole = analysis.survey.failures == 0 && analysis.no_motion.is_none();
            let what = if whole { "checks that hold" } else { "checks that hold for what there is" };
            self.add(what, format!("{judged} / {}", checks.len()), "", &[]);
        } else {
            self.add("checks that FAIL", failed.join(", "), "", &[]);
        }
    }
}
