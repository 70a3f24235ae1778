//! The quantities of the program: one row for each, from which everything that shows a quantity takes its words, symbol and
//! unit, its place in the JSON and its name in a table.

mod path;
mod unit;
mod words;

use assur_analysis::results::{Column, Owner, Part, Quantity, Residual, Schema};
use assur_mechanism::{GROUND, LinkId, PairId};

pub use path::{KEYS, PathStep, csv, csv_of, path};
pub use unit::{Unit, unit};
pub use words::{further, head, kind, owner, short, subject};

use Owner::{Drive, Input, Link, PairOn, Slide};
use Quantity as Q;
use unit::Measure as M;

/// What is known of a quantity.
#[derive(Debug, Clone, Copy)]
struct Entry {
    /// Identity of its name in words; empty where the name of the owner says all.
    name: &'static str,
    /// Its symbol, to which the axis of a projection is added.
    symbol: &'static str,
    /// What it measures, from which its unit follows.
    measure: M,
    /// Its keys in the JSON of a row; empty where it has none. `*` stands for the name of the owner, `+` for the link on which a
    /// force acts, `@` for the name of a drive where results name each.
    json: &'static str,
    /// Its name in CSV and Parquet without the unit; empty where these don't have it. `%` stands for the axis of a projection.
    csv: &'static str,
    /// Whether its sign says in which sense it acts.
    sense: bool,
}

/// Its sign says in which sense it acts.
const SENSE: bool = true;
/// A place with a sign, or a value that can't be negative: its greatest value is its maximum, not its greatest magnitude.
const PLAIN: bool = false;

/// Makes the function that finds the row of a quantity and its kind of owner: name, symbol, measure, keys in the JSON, name in CSV.
macro_rules! rows {
    ($($quantity:pat, $owner:pat => $sense:ident
        $name:expr, $symbol:literal, $measure:expr, $json:literal, $csv:literal;)*) => {
        /// The keys in the JSON of all rows.
        #[cfg(test)]
        pub(crate) const PATHS: &[&str] = &[$($json),*];

        fn of(column: Column) -> Entry {
            match (column.quantity, column.owner) {
                $(($quantity, $owner) => {
                    Entry { name: $name, symbol: $symbol, measure: $measure, json: $json, csv: $csv, sense: $sense }
                })*
            }
        }
    };
}

rows! {
    Q::Time, _ => PLAIN "quantity-time", "t", M::In(Unit::SECOND), "time", "time";
    Q::Transfer(_), Input => PLAIN "quantity-coordinate", "q", M::Transfer(0), "coordinate", "coordinate";
    Q::Transfer(_), Drive(_) => PLAIN "quantity-coordinate", "q", M::Transfer(0), "coordinates.@", "coordinate_@";
    Q::Velocity, Drive(_) => SENSE "quantity-speed", "ω", M::Rate(0), "speeds.@", "speed_@";
    Q::Acceleration, Drive(_) => SENSE "quantity-input-acceleration", "ε", M::Rate(1),
        "accelerations_of_inputs.@", "acceleration_@";
    Q::Partial { order: 1, .. }, Link(_) => SENSE "quantity-pf1", "", M::Partial, "links.*.pf1.@", "*_angle_pf1_@";
    Q::Partial { .. }, Link(_) => SENSE "quantity-pf2", "", M::Partial, "links.*.pf2.@", "*_angle_pf2_@";
    Q::Partial { order: 1, .. }, Slide(_) => SENSE "quantity-pf1", "", M::Partial,
        "slides.*.pf1.@", "*_displacement_pf1_@";
    Q::Partial { .. }, Slide(_) => SENSE "quantity-pf2", "", M::Partial, "slides.*.pf2.@", "*_displacement_pf2_@";
    Q::Partial { order: 1, .. }, _ => SENSE "quantity-pf1", "", M::Partial, "points.*.pf1.@", "*_%_pf1_@";
    Q::Partial { .. }, _ => SENSE "quantity-pf2", "", M::Partial, "points.*.pf2.@", "*_%_pf2_@";
    Q::Velocity, Input => SENSE "quantity-speed", "ω", M::Rate(0), "speed", "speed";
    Q::Acceleration, Input => SENSE "quantity-input-acceleration", "ε", M::Rate(1), "acceleration", "acceleration";
    Q::DrivingWork, _ => PLAIN "quantity-work-driving", "", M::In(Unit::JOULE), "work_driving", "work_driving";
    Q::ResistingWork, _ => PLAIN "quantity-work-resisting", "", M::In(Unit::JOULE), "work_resisting", "work_resisting";
    Q::FrictionWork, _ => PLAIN "quantity-work-friction", "", M::In(Unit::JOULE), "work_friction", "work_friction";
    Q::KineticEnergy, Link(_) => PLAIN "quantity-kinetic-energy", "T", M::In(Unit::JOULE),
        "kinetic_energies.*", "*_kinetic_energy";
    Q::Work, Input => PLAIN "quantity-work-drive", "", M::In(Unit::JOULE), "works.drive", "work_drive";
    Q::Work, Link(_) => PLAIN "quantity-work-weights", "", M::In(Unit::JOULE), "works.weights", "work_weights";
    Q::Work, _ => PLAIN "quantity-work", "A", M::In(Unit::JOULE), "works.loads.*", "work_*";
    Q::ReducedLoad, Input => SENSE "quantity-reduced-drive", "", M::OnInput, "reduced_loads.drive", "reduced_drive";
    Q::ReducedLoad, Link(_) => SENSE "quantity-reduced-weights", "", M::OnInput,
        "reduced_loads.weights", "reduced_weights";
    Q::ReducedLoad, _ => SENSE "quantity-reduced-load", "", M::OnInput, "reduced_loads.loads.*", "reduced_load_*";
    Q::KineticEnergy, _ => PLAIN "quantity-kinetic-energy", "T", M::In(Unit::JOULE), "kinetic_energy", "kinetic_energy";
    Q::Transfer(0), Link(_) => PLAIN "quantity-pf0", "", M::Transfer(0), "links.*.pf0", "*_angle";
    Q::Transfer(1), Link(_) => SENSE "quantity-pf1", "", M::Transfer(1), "links.*.pf1", "*_angle_pf1";
    Q::Transfer(order), Link(_) => SENSE "quantity-pf2", "", M::Transfer(order), "links.*.pf2", "*_angle_pf2";
    Q::Transfer(0), Slide(_) => PLAIN "quantity-pf0", "", M::Transfer(0), "slides.*.pf0", "*_displacement";
    Q::Transfer(1), Slide(_) => SENSE "quantity-pf1", "", M::Transfer(1), "slides.*.pf1", "*_displacement_pf1";
    Q::Transfer(order), Slide(_) => SENSE "quantity-pf2", "", M::Transfer(order),
        "slides.*.pf2", "*_displacement_pf2";
    Q::Transfer(0), _ => PLAIN "quantity-pf0", "", M::Transfer(0), "points.*.pf0", "*_%";
    Q::Transfer(1), _ => SENSE "quantity-pf1", "", M::Transfer(1), "points.*.pf1", "*_%_pf1";
    Q::Transfer(order), _ => SENSE "quantity-pf2", "", M::Transfer(order), "points.*.pf2", "*_%_pf2";
    Q::Velocity, Link(_) => SENSE "quantity-velocity", "ω", M::Rate(0), "velocities.links.*", "*_w";
    Q::Velocity, Slide(_) => SENSE "quantity-velocity", "v", M::Rate(0), "velocities.slides.*", "*_v";
    Q::Velocity, _ => SENSE "quantity-velocity", "v", M::Rate(0), "velocities.points.*", "*_v%";
    Q::Acceleration, Link(_) => SENSE "quantity-acceleration", "ε", M::Rate(1), "accelerations.links.*", "*_e";
    Q::Acceleration, Slide(_) => SENSE "quantity-acceleration", "a", M::Rate(1), "accelerations.slides.*", "*_a";
    Q::Acceleration, _ => SENSE "quantity-acceleration", "a", M::Rate(1), "accelerations.points.*", "*_a%";
    Q::ReducedInertia, Link(_) => PLAIN "quantity-reduced-inertia", "J", M::Inertia(0),
        "reduced.inertia_of_links.*", "*_reduced_inertia";
    Q::ReducedInertia, _ => PLAIN "quantity-reduced-inertia", "J", M::Inertia(0), "reduced.inertia", "reduced_inertia";
    Q::ReducedInertiaDerivative, _ => SENSE "quantity-reduced-inertia-derivative", "J'", M::Inertia(1),
        "reduced.inertia_derivative", "reduced_inertia_derivative";
    Q::ReducedMoment, _ => SENSE "quantity-reduced-moment", "Q", M::OnInput, "reduced.moment", "reduced_moment";
    Q::Load, _ => SENSE "", "", M::Load, "loads.*", "load_*";
    Q::InertiaForce, _ => SENSE "quantity-inertia-force", "F", M::In(Unit::FORCE), "inertia_loads.*.force", "*_inertia_f%";
    Q::InertiaMoment, _ => SENSE "quantity-inertia-moment", "M", M::In(Unit::MOMENT),
        "inertia_loads.*.moment", "*_inertia_moment";
    Q::ShakingForce, _ => SENSE "quantity-shaking-force", "F", M::In(Unit::FORCE), "shaking.force", "shaking_f%";
    Q::ShakingMoment, _ => SENSE "quantity-shaking-moment", "M", M::In(Unit::MOMENT), "shaking.moment", "shaking_moment";
    Q::Force, PairOn(..) => SENSE "quantity-reaction", "R", M::In(Unit::FORCE), "reactions.*.+", "*_+_f%";
    Q::Force, _ => SENSE "quantity-reaction", "R", M::In(Unit::FORCE), "", "";
    Q::Moment, _ => SENSE "quantity-moment", "M", M::In(Unit::MOMENT), "reactions.*.moment", "*_moment";
    Q::Offset, _ => PLAIN "quantity-offset", "s", M::In(Unit::LENGTH), "", "";
    Q::Balancing, Drive(_) => SENSE "quantity-balancing", "", M::Balancing, "balancing.@", "balancing_@";
    Q::Balancing, _ => SENSE "quantity-balancing", "", M::Balancing, "balancing", "balancing";
    Q::OfMethod, _ => SENSE "quantity-force", "", M::In(Unit::FORCE), "method.*", "method_*";
    Q::FrictionMoment, PairOn(..) => SENSE "quantity-friction-moment", "Mf", M::In(Unit::MOMENT),
        "friction.*.moments.+", "*_+_friction_moment";
    Q::FrictionMoment, _ => SENSE "quantity-friction-moment", "Mf", M::In(Unit::MOMENT),
        "friction.*.moment", "*_friction_moment";
    Q::FrictionForce, _ => SENSE "quantity-friction-force", "Ff", M::In(Unit::FORCE), "friction.*.force", "*_friction_force";
    Q::FrictionPower, _ => SENSE "quantity-friction-power", "Pf", M::Power, "friction.*.power", "*_friction_power";
    Q::IdealBalancing, _ => SENSE "quantity-ideal-balancing", "", M::Balancing,
        "balancing_without_friction", "balancing_without_friction";
    Q::Efficiency, _ => PLAIN "quantity-efficiency", "", M::In(Unit::NONE), "efficiency", "efficiency";
    Q::FrictionCertificate, _ => PLAIN "quantity-friction-certificate", "", M::In(Unit::NONE),
        "friction_certificate.*", "friction_certificate_*";
    Q::Holding, _ => SENSE "quantity-holding", "", M::OnInput, "holding.moment", "";
    Q::HoldingBound, _ => SENSE "quantity-holding-bound", "", M::OnInput, "holding.bound", "";
    Q::Condition, _ => PLAIN "quantity-condition", "", M::In(Unit::NONE), "condition.*", "condition_*";
    Q::Residual(Residual::Remainder), _ => SENSE residual(Residual::Remainder), "Pogr1", M::OnInput, "residuals.*", "residual_*";
    Q::Residual(of), _ => PLAIN residual(of), "", M::In(Unit::NONE), "residuals.*", "residual_*";
}

/// The identity of the name of a residual.
const fn residual(of: Residual) -> &'static str {
    match of {
        Residual::TestPf => "quantity-residual-test-pf",
        Residual::Equilibrium => "quantity-residual-equilibrium",
        Residual::Dynamics => "quantity-residual-dynamics",
        Residual::Remainder => "quantity-remainder",
        Residual::Global => "quantity-residual-global",
    }
}

/// Whether the sign of a quantity says in which sense it acts, so that the greatest value is the one of greatest magnitude: a
/// moment of -90 N m loads a guide more than one of 30 N m. The sign of a place, of an energy or of a magnitude says where it is or
/// that it can't be negative.
pub fn sign_is_sense(column: Column) -> bool {
    of(column).sense && column.part != Part::Modulus
}

/// Whether a small one beside a great one is no rounding of zero: a plain number as a condition number, or a residual.
pub fn is_ratio(column: Column) -> bool {
    matches!(column.quantity, Q::Residual(_))
        || matches!(of(column).measure, M::In(unit) if unit.name.is_empty())
}

/// The pairs that have reactions, each with the links on which its force is [shown].
pub fn reactions(schema: &Schema) -> Vec<(PairId, LinkId)> {
    let pair_on = |owner| if let PairOn(pair, link) = owner { Some((pair, link)) } else { None };
    shown(&schema.owners(Q::Force).into_iter().filter_map(pair_on).collect::<Vec<_>>())
}

/// Of pairs with the links that they join, pair by pair, those that are shown: of two links the first that moves, since the force
/// on the other is opposite; of more links all.
pub fn shown(all: &[(PairId, LinkId)]) -> Vec<(PairId, LinkId)> {
    let of_pair = |links: &[(PairId, LinkId)]| match *links {
        [(pair, GROUND), (_, moving)] => vec![(pair, moving)],
        [first, _] => vec![first],
        _ => links.to_vec(),
    };
    all.chunk_by(|one, other| one.0 == other.0).flat_map(of_pair).collect()
}

/// The letter of the axis of a projection; empty for a whole quantity or a magnitude.
const fn axis(part: Part) -> &'static str {
    match part {
        Part::X => "x",
        Part::Y => "y",
        Part::Whole | Part::Modulus => "",
    }
}
