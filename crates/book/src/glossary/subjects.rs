//! Which words of the glossary what is shown is about: tables of identities.

use assur_analysis::results::{Column, Owner, Quantity, Residual};

use super::{Entry, find};

/// Identities of what is shown, with those of the words that it is about.
type Table = &'static [(&'static [&'static str], &'static [&'static str])];

/// The entries of several identities, in their order.
fn entries(ids: &[&str]) -> Vec<&'static Entry> {
    ids.iter().filter_map(|id| find(id)).collect()
}

/// The entries of what belongs to an identity in a table; none where the table lacks it.
fn of(table: Table, id: &str) -> Vec<&'static Entry> {
    let row = table.iter().find(|(of, _)| of.contains(&id));
    row.map(|(_, words)| entries(words)).unwrap_or_default()
}

/// The words that a quantity is about, the nearest one first.
pub fn of_column(column: Column) -> Vec<&'static Entry> {
    use Quantity as Q;
    entries(match (column.quantity, column.owner) {
        (Q::Time, _) => &["word-instant"],
        (Q::Transfer(_) | Q::Velocity | Q::Acceleration, Owner::Input | Owner::Drive(_)) => {
            &["word-coordinate"]
        }
        (Q::Transfer(0), _) => &["word-pf0"],
        (Q::Transfer(_) | Q::Partial { .. } | Q::Velocity | Q::Acceleration, _) => &["word-pf1"],
        (Q::ReducedInertia | Q::ReducedInertiaDerivative, _) => &["word-inertia"],
        (Q::ReducedMoment | Q::ReducedLoad | Q::Load, _) => &["word-moment"],
        (Q::DrivingWork | Q::ResistingWork | Q::Work | Q::KineticEnergy, _) => &["word-energy"],
        (Q::FrictionWork | Q::Efficiency, _) => &["word-efficiency"],
        (Q::Force | Q::OfMethod, _) => &["word-reaction"],
        (Q::Moment | Q::Offset, _) => &["word-slide-moment"],
        (Q::Balancing | Q::IdealBalancing | Q::Holding | Q::HoldingBound, _) => &["word-balance"],
        (Q::FrictionMoment, _) => &["word-friction-circle"],
        (Q::FrictionForce, _) => &["word-friction-angle"],
        (Q::FrictionPower, _) => &["word-efficiency", "word-friction-circle", "word-friction-angle"],
        (Q::FrictionCertificate, _) => &["word-certificate"],
        (Q::InertiaForce | Q::InertiaMoment, _) => &["word-inertia-load"],
        (Q::ShakingForce | Q::ShakingMoment, _) => &["word-shaking"],
        (Q::Condition, _) => &["word-condition", "word-determinant"],
        (Q::Residual(Residual::TestPf), _) => &["word-testpf", "word-residual"],
        (Q::Residual(Residual::Equilibrium), _) => &["word-kinetostatics", "word-residual"],
        (Q::Residual(Residual::Dynamics | Residual::Remainder), _) => &["word-remainder", "word-residual"],
        (Q::Residual(Residual::Global), _) => &["word-global", "word-residual"],
    })
}

/// Facts, with the words that they are about.
const FACTS: Table = &[
    (&["fact-formula"], &["word-formula", "word-group"]),
    (&["fact-class"], &["word-class", "word-mobility"]),
    (&["fact-change-points"], &["word-mode", "word-determinant"]),
    (&["fact-stroke", "fact-swing"], &["word-stroke", "word-dead-point"]),
    (&["fact-travel"], &["word-stroke"]),
    (&["fact-time-ratio"], &["word-time-ratio"]),
    (&["fact-transmission"], &["word-transmission", "word-pressure", "word-determinant"]),
    (&["fact-crank-condition"], &["word-grashof"]),
    (&["fact-solved-positions"], &["word-mode", "word-determinant"]),
    (&["fact-forceless-positions"], &["word-kinetostatics", "word-jamming"]),
    (&["fact-greatest-power", "fact-greatest-load-of-drive"], &["word-balance"]),
    (&["fact-efficiency", "fact-friction-work"], &["word-efficiency"]),
    (&["fact-self-braking", "fact-self-braking-narrow"], &["word-self-braking"]),
    (&["fact-dead-angle"], &["word-dead-angle", "word-jamming"]),
    (&["fact-end-time", "fact-turns", "fact-end-speed", "fact-wanted-motion"], &["word-motion"]),
    (&["fact-unevenness"], &["word-unevenness"]),
    (&["fact-dynamic-unevenness"], &["word-dynamic-unevenness", "word-unevenness"]),
    (&["fact-multiplier"], &["word-multiplier", "word-regime"]),
    (&["fact-required-power", "fact-power-taken"], &["word-required-power", "word-energy"]),
    (&["fact-rms-torque"], &["word-rms", "word-kloss"]),
    (&["fact-starting-torque", "fact-starting-load"], &["word-starting-torque", "word-kloss"]),
    (
        &["fact-mean-speed", "fact-least-speed", "fact-greatest-speed", "fact-cycle-time"],
        &["word-regime", "word-unevenness"],
    ),
    (&["fact-excess-work"], &["word-excess", "word-energy-mass"]),
    (
        &["fact-mean-resistance", "fact-mean-driving", "fact-driving-moment", "fact-braking-moment"],
        &["word-moment", "word-motion"],
    ),
    (
        &["fact-resistance-work", "fact-net-driving-work", "fact-driving-work", "fact-resisting-work"],
        &["word-energy"],
    ),
    (&["fact-kinetic-energy"], &["word-energy"]),
    (
        &["fact-motor", "fact-characteristic", "fact-breakdown-ratio", "fact-breakdown-torque"],
        &["word-kloss", "word-slip"],
    ),
    (
        &["fact-synchronous-speed", "fact-rated-speed", "fact-rated-torque", "fact-working-speed"],
        &["word-slip", "word-kloss"],
    ),
    (&["fact-working-torque"], &["word-kloss"]),
    (&["fact-gear-ratio"], &["word-gear-ratio"]),
    (&["fact-flywheel", "fact-flywheel-of", "fact-shaft-inertia", "fact-rotor"], &["word-flywheel"]),
    (&["fact-checks-hold", "fact-checks-hold-partly", "fact-checks-fail"], &["word-residual"]),
];

/// The words that a fact is about, by the identity of what it says, or else by its quantity.
pub fn of_fact(id: &str, column: Option<Column>) -> Vec<&'static Entry> {
    let own = of(FACTS, id);
    if own.is_empty() { column.map(of_column).unwrap_or_default() } else { own }
}

/// Checks, with the words that they are about beside the residual.
const CHECKS: Table = &[
    (&["check-closure-pf0"], &["word-pf0"]),
    (&["check-closure-pf1", "check-closure-pf2"], &["word-pf1"]),
    (&["check-testpf-pf1", "check-testpf-pf2"], &["word-testpf", "word-pf1"]),
    (&["check-testpf-inertia"], &["word-testpf", "word-inertia"]),
    (&["check-loads"], &["word-moment"]),
    (&["check-equilibrium"], &["word-kinetostatics"]),
    (&["check-joints"], &["word-reaction"]),
    (&["check-slides"], &["word-reaction", "word-guide"]),
    (&["check-friction"], &["word-friction-angle", "word-friction-circle"]),
    (&["check-agreement"], &["word-kinetostatics", "word-virtual-power"]),
    (&["check-reduced"], &["word-inertia", "word-moment"]),
    (&["check-lagrange"], &["word-remainder"]),
    (&["check-virtual-power"], &["word-virtual-power", "word-balance"]),
    (&["check-drive"], &["word-global"]),
    (&["analysis-work", "analysis-energy"], &["word-energy"]),
    (&["analysis-cycle", "analysis-periodicity", "analysis-mean-speed"], &["word-regime"]),
    (&["analysis-unevenness", "analysis-unevenness-of-motor"], &["word-unevenness"]),
];

/// The words that a check is about, by the identity of its name: the residual in the end.
pub fn of_check(id: &str) -> Vec<&'static Entry> {
    let mut all = of(CHECKS, id);
    all.extend(find("word-residual"));
    all
}

/// Keys of the scene, by the identities of the sentences on them, with the words that they are about.
const KEYS: Table = &[
    (&["scene-key-input-link", "scene-key-input-name", "scene-key-input-direction"], &["word-input"]),
    (&["scene-key-input-slide", "scene-key-input-pin"], &["word-driven"]),
    (&["scene-key-input-from", "scene-key-input-to", "scene-key-input-cycle"], &["word-coordinate"]),
    (&["scene-key-inputs-from", "scene-key-input-rate", "scene-key-motion-speed"], &["word-coordinate"]),
    (&["scene-key-motion-acceleration"], &["word-coordinate"]),
    (&["scene-key-assembly-point"], &["word-mode"]),
    (&["scene-key-center", "scene-key-mass"], &["word-center-of-mass", "word-inertia-load"]),
    (&["scene-key-inertia", "scene-key-inertia-formula"], &["word-inertia-load", "word-inertia"]),
    (&["scene-key-slide-on", "scene-key-slide-through", "scene-key-slide-angle"], &["word-guide"]),
    (&["scene-key-slide-tilt"], &["word-tilt"]),
    (&["scene-key-friction-coefficient"], &["word-friction-angle", "word-friction-circle"]),
    (&["scene-key-friction-radius", "scene-key-friction-owner"], &["word-friction-circle"]),
    (
        &["scene-key-friction-length", "scene-key-friction-middle", "scene-key-friction-offset"],
        &["word-friction-angle", "word-slide-moment"],
    ),
    (
        &["scene-key-spring-stiffness", "scene-key-spring-length", "scene-key-spring-damping"],
        &["word-spring"],
    ),
    (&["scene-key-contact-center", "scene-key-contact-radius", "scene-key-contact-angle"], &["word-contact"]),
    (
        &["scene-key-contact-force", "scene-key-contact-friction", "scene-key-contact-during"],
        &["word-contact"],
    ),
    (&["scene-key-against-sliding"], &["word-contact"]),
    (&["scene-key-balance-link", "scene-key-balance-at", "scene-key-balance-angle"], &["word-balance"]),
    (&["scene-key-motion-unevenness"], &["word-unevenness"]),
    (&["scene-key-motion-mean-speed"], &["word-regime"]),
    (&["scene-key-motion-until", "scene-key-motion-samples"], &["word-motion", "word-instant"]),
    (&["scene-key-drive-characteristic", "scene-key-motor-max-torque-ratio"], &["word-kloss"]),
    (&["scene-key-motor-rated-speed", "scene-key-motor-synchronous-speed"], &["word-slip"]),
    (&["scene-key-drive-ratio"], &["word-gear-ratio"]),
    (&["scene-key-drive-efficiency"], &["word-efficiency"]),
    (&["scene-key-drive-flywheel", "scene-key-drive-flywheel-on"], &["word-flywheel"]),
];

/// The words that a key of the scene is about, by the identity of the sentence on it; none where it is about no word of the
/// field.
pub fn of_key(about: &str) -> Vec<&'static Entry> {
    of(KEYS, about)
}

/// The tables: identities, with the words that they are about.
pub(super) const TABLES: [Table; 3] = [FACTS, CHECKS, KEYS];

/// The identities of all facts, checks and sentences on keys that have words.
pub fn subjects() -> impl Iterator<Item = &'static str> {
    TABLES.into_iter().flatten().flat_map(|(of, _)| *of).copied()
}
