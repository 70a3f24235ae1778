//! Mistakes that are planted in analyzers, integrators and catalogues: the suites catch each.

use assur_all as _;
use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, Reactions};
use assur_group::Wrench;
use assur_integrator::{
    EquationOfMotion, IntegrationError, Integrator, IntegratorPlugin, Knob, Request, Trajectory,
};
use assur_kinematics::{Linkage, Position};
use assur_motor::{CataloguePlugin, CatalogueTable};
use assur_words::Text;

use crate::{judge_forces, judge_method, judge_table};

/// The first registered analyzer that gives reactions and treats ideal pairs alone.
fn honest() -> &'static AnalyzerPlugin {
    let all = assur_force::analyzers().unwrap();
    all.into_iter()
        .find(|plugin| plugin.gives_reactions && plugin.by_groups && !plugin.treats_friction)
        .unwrap()
}

#[derive(Debug)]
struct Spoiled(fn(&mut Reactions, &[Wrench<f64>]));

impl ForceAnalyzer for Spoiled {
    fn supports(&self, linkage: &Linkage) -> Result<(), Text> {
        honest().instance.supports(linkage)
    }

    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        let given = loads.to_vec();
        honest().instance.solve(linkage, position, loads, out)?;
        (self.0)(out, &given);
        Ok(())
    }
}

fn spoiled(instance: &'static Spoiled) -> AnalyzerPlugin {
    AnalyzerPlugin { instance, ..honest().clone() }
}

#[test]
fn mistakes_of_analyzers_are_caught() {
    static PLANTED: [(&str, Spoiled); 5] = [
        ("virtual power", Spoiled(|out, _| out.balancing = -out.balancing)),
        ("virtual power", Spoiled(|out, _| out.balancing *= 1.0 + 1e-6)),
        ("equilibrium", Spoiled(|out, _| out.pairs.iter_mut().for_each(|pair| pair.fx = -pair.fx))),
        (
            "equilibrium",
            Spoiled(|out, _| out.pairs.iter_mut().for_each(|pair| pair.m += 1e-3 * (1.0 + pair.m.abs()))),
        ),
        ("virtual power", Spoiled(|out, loads| out.balancing += 1e-3 * loads[1].m.abs().max(1.0).powi(2))),
    ];
    judge_forces(honest()).unwrap();
    for (check, planted) in &PLANTED {
        let fault = judge_forces(&spoiled(planted)).unwrap_err();
        assert!(fault.check == *check || fault.check == "guides", "{check}: {fault}");
    }
    let silent = AnalyzerPlugin { gives_reactions: false, ..honest().clone() };
    assert_eq!(judge_forces(&silent).unwrap_err().check, "reactions");
}

struct Wrong(fn(&mut Trajectory));

impl Integrator for Wrong {
    fn solve(
        &self,
        motion: &mut dyn EquationOfMotion,
        request: &Request,
    ) -> Result<Trajectory, IntegrationError> {
        let mut found = exact().method.solve(motion, request)?;
        (self.0)(&mut found);
        Ok(found)
    }
}

/// The first registered method that controls its error and takes equations of any kind.
fn exact() -> &'static IntegratorPlugin {
    let all = assur_integrator::integrators().unwrap();
    let takes = |plugin: &&&IntegratorPlugin| plugin.supports(&assur_problems::VARIABLE).is_ok();
    all.iter().filter(takes).find(|plugin| plugin.knob == Knob::Tolerance).unwrap()
}

#[test]
fn mistakes_of_integrators_are_caught() {
    static PLANTED: [(&str, Wrong); 4] = [
        ("answers", Wrong(|found| found.end.speed *= 1.0 + 1e-4)),
        ("answers", Wrong(|found| found.end.time *= 1.0 + 1e-4)),
        ("samples", Wrong(|found| found.samples.truncate(3))),
        ("samples", Wrong(|found| found.samples.swap(1, 2))),
    ];
    judge_method(exact()).unwrap();
    for (check, planted) in &PLANTED {
        let fault = judge_method(&IntegratorPlugin { method: planted, ..exact().clone() }).unwrap_err();
        assert_eq!(fault.check, *check, "{fault}");
    }
    let boasting = IntegratorPlugin { order: 9, knob: Knob::Step, ..fixed().clone() };
    assert!(["order", "answers"].contains(&judge_method(&boasting).unwrap_err().check));
}

/// The first registered method with a fixed step.
fn fixed() -> &'static IntegratorPlugin {
    let all = assur_integrator::integrators().unwrap();
    all.iter().find(|plugin| plugin.knob == Knob::Step).unwrap()
}

/// A catalogue of one motor.
fn catalogue(row: &str) -> Result<(), crate::Fault> {
    let head = "designation,poles,rated_power_kw,synchronous_speed_rpm,rated_speed_rpm,max_torque_ratio,rotor_inertia_kg_m2,source\n";
    let csv: &'static str = Box::leak(format!("{head}{row}\n").into_boxed_str());
    let table: &'static CatalogueTable = Box::leak(Box::new(CatalogueTable::new(csv)));
    let nothing = || Text::message("test", Vec::new());
    judge_table(&CataloguePlugin {
        name: "planted",
        crate_name: "test",
        summary: nothing(),
        source: nothing(),
        table,
    })
}

#[test]
fn mistakes_of_catalogues_are_caught() {
    catalogue("M4-1,4,1.1,1500,1420,2.2,0.002,own").unwrap();
    for row in [
        "",
        "M4-1,4,1.1,1500,1500,2.2,0.002,own",
        "M4-1,4,1.1,1000,900,2.2,0.002,own",
        "M4-1,4,1.1,1500,900,2.2,0.002,own",
        "M4-1,4,1.1,1500,1420,0.8,0.002,own",
        "M4-1,4,-1.1,1500,1420,2.2,0.002,own",
        "M4-1,4,1.1,1500,1420,2.2,0.002,own\nM4-1,4,1.1,1500,1420,2.2,0.002,own",
    ] {
        assert!(catalogue(row).is_err(), "{row}");
    }
}
