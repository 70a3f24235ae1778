//! The glossary: the words of the field with their meaning, formula and source, and where they stand in the note. Everything
//! that explains a word takes it from here.
//!
//! What is shown finds its words by identity, never by its letters: a quantity ([`of_column`]), a fact ([`of_fact`]), a check
//! ([`of_check`]), a key of the scene ([`of_key`]).

mod subjects;

#[cfg(test)]
mod tests;

use assur_words::{Text, name, text};

pub use subjects::{of_check, of_column, of_fact, of_key, subjects};

use Chapter::{Checks, Dynamics, Forces, Kinematics, Results, Structure, Task};
use Source::{
    Artobolevsky, Differential, Energy, EnergyExample, EnergyFigure, Longitudinal, LongitudinalFigure,
    Ortega, Stage,
};

/// A word of the field.
#[derive(Debug)]
pub struct Entry {
    /// Its identity, by which [`find`] finds it.
    id: &'static str,
    /// The word, with its symbol where it has one.
    pub word: Text,
    /// What it is, in one sentence.
    pub meaning: Text,
    /// Its formula in the symbols that the program prints; empty where it has none.
    pub formula: &'static str,
    /// Where the formula comes from; `None` where none of the papers and textbooks that the program follows has it.
    pub source: Option<Source>,
    /// The part of the note that has it; `None` where it is not part of the note.
    pub chapter: Option<Chapter>,
}

/// Where a formula comes from, with the number of its place there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// A stage of the paper of Sychov and Vadimov.
    Stage(&'static str),
    /// An equation of the paper of Ladikov and Bychkov.
    Energy(&'static str),
    /// A figure of the same.
    EnergyFigure(&'static str),
    /// An example of the same.
    EnergyExample(&'static str),
    /// A section of the paper on the equation of motion in differential form.
    Differential(&'static str),
    /// An equation of the paper of Vladimirov and Kuznetsov on longitudinal reactions.
    Longitudinal(&'static str),
    /// A figure of the same.
    LongitudinalFigure(&'static str),
    /// The textbook of Artobolevsky, the chapter on friction in pairs.
    Artobolevsky,
    /// The theorem on contractions of Ortega and Rheinboldt.
    Ortega,
}

/// A part of the note.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Chapter {
    /// The results that are asked for first.
    Results,
    /// The mechanism and its loads as they are given.
    Task,
    /// Mobility, formula, groups.
    Structure,
    /// Places, transfer functions, velocities and accelerations.
    Kinematics,
    /// Reactions and the balancing load.
    Forces,
    /// The regime, the drive and its flywheel.
    Dynamics,
    /// The proofs of the numbers.
    Checks,
}

impl Source {
    /// The source as it is printed.
    pub fn text(self) -> Text {
        match self {
            Stage(place) => text!("glossary-s", place = name(place)),
            Energy(place) => text!("glossary-e", place = name(place)),
            EnergyFigure(place) => text!("glossary-e-figure", place = name(place)),
            EnergyExample(place) => text!("glossary-e-example", place = name(place)),
            Differential(place) => text!("glossary-d", place = name(place)),
            Longitudinal(place) => text!("glossary-l", place = name(place)),
            LongitudinalFigure(place) => text!("glossary-l-figure", place = name(place)),
            Artobolevsky => text!("glossary-artobolevsky"),
            Ortega => text!("glossary-ortega"),
        }
    }
}

/// The entry of an identity; `None` where there is no such word, which tests exclude for all that the program asks for.
pub fn find(id: &str) -> Option<&'static Entry> {
    ENTRIES.iter().find(|entry| entry.id == id)
}

/// Makes the table: identity, formula, source, chapter.
macro_rules! entries {
    ($($id:literal $formula:literal, $source:expr, $chapter:expr;)*) => {
        /// All words, those of a chapter beside each other.
        pub static ENTRIES: &[Entry] = &[$(Entry {
            id: $id,
            word: text!($id),
            meaning: text!(concat!($id, ".meaning")),
            formula: $formula,
            source: $source,
            chapter: $chapter,
        }),*];
    };
}

entries! {
    "word-mobility" "W = 3*n - 2*p", Some(Stage("1")), Some(Structure);
    "word-input" "", Some(Stage("1")), Some(Structure);
    "word-coordinate" "ω = dq/dt, ε = dω/dt", None, Some(Kinematics);
    "word-group" "3*n - 2*p = 0", Some(Stage("1")), Some(Structure);
    "word-class" "", Some(Stage("1")), Some(Structure);
    "word-dyad" "n = 2, p = 3", Some(Stage("2")), Some(Structure);
    "word-formula" "I -> II1 -> II2", Some(Stage("1")), Some(Structure);
    "word-mode" "", None, Some(Structure);
    "word-circuit" "", None, None;
    "word-passive" "", None, Some(Structure);
    "word-driven" "", None, Some(Structure);
    "word-determinant" "D = sin(φ_2 - φ_1)", Some(Stage("2")), None;
    "word-condition" "1/|D|", None, None;
    "word-grashof" "a + d ≤ b + c, |b - c| ≤ |d - a|", None, Some(Results);
    "word-guide" "", None, Some(Task);
    "word-tilt" "", None, Some(Task);
    "word-center-of-mass" "", None, Some(Task);
    "word-contact" "F_x = N*(sin(a) + f*cos(a)), F_y = N*(cos(a) - f*sin(a))", Some(Longitudinal("2")), Some(Task);
    "word-spring" "F = k*(l - l_0) + c*dl/dt", None, Some(Task);
    "word-pf0" "x = x(q), φ = φ(q)", Some(Stage("2")), Some(Kinematics);
    "word-pf1" "x′ = dx/dq, x″ = dx′/dq; v = x′*ω, a = x″*ω² + x′*ε", Some(Stage("2")), Some(Kinematics);
    "word-testpf" "x′ = (x(q + h) - x(q - h))/(2*h)", Some(Stage("3")), Some(Checks);
    "word-stroke" "s = max(x) - min(x)", Some(Stage("3")), Some(Results);
    "word-dead-point" "x′ = 0", Some(Stage("3")), Some(Results);
    "word-time-ratio" "k = q_1/q_2", None, Some(Results);
    "word-transmission" "sin(γ) = |D|", Some(Stage("2")), Some(Results);
    "word-pressure" "θ = 90° - γ", Some(Stage("2")), None;
    "word-plan" "v_B = v_A + v_BA", Some(EnergyFigure("1")), Some(Kinematics);
    "word-hodograph" "", None, Some(Forces);
    "word-center" "v_P = 0", Some(LongitudinalFigure("1")), None;
    "word-centrode" "", None, None;
    "word-coupler-curve" "", None, Some(Kinematics);
    "word-instant" "", None, Some(Kinematics);
    "word-inertia-load" "F = -m*a_S, M = -I*ε", Some(Stage("7")), Some(Forces);
    "word-kinetostatics" "sum(F) = 0, sum(M) = 0", Some(Stage("9")), Some(Forces);
    "word-polygon" "sum(F) = 0", Some(Stage("9")), Some(Forces);
    "word-reaction" "R_12 = -R_21", Some(Stage("9")), Some(Forces);
    "word-slide-moment" "M = s*F", None, Some(Forces);
    "word-balance" "M_b = J*ε + J′*ω²/2 - Q", Some(Stage("10")), Some(Forces);
    "word-virtual-power" "sum(F*v*cos(α)) + sum(M*ω) = 0", Some(Stage("8")), Some(Checks);
    "word-lever" "sum(F*h) = 0", Some(LongitudinalFigure("1")), Some(Forces);
    "word-longitudinal" "F + F_b + R_P = 0, R_P = R_1 + R_3", Some(Longitudinal("3-12")), Some(Forces);
    "word-shaking" "F = -sum(m*a_S)", None, None;
    "word-friction-angle" "tan(α) = f", Some(Artobolevsky), Some(Forces);
    "word-friction-circle" "h = f*r, M = h*R", Some(Artobolevsky), Some(Forces);
    "word-self-braking" "", Some(Artobolevsky), Some(Results);
    "word-dead-angle" "", Some(Artobolevsky), Some(Results);
    "word-jamming" "", Some(Artobolevsky), Some(Forces);
    "word-efficiency" "1 - |A_f|/A_d", Some(Artobolevsky), Some(Results);
    "word-certificate" "z = |a + W*z|", Some(Ortega), Some(Forces);
    "word-inertia" "J = sum(m*(x_S′² + y_S′²) + I*φ′²)", Some(Stage("4")), Some(Dynamics);
    "word-moment" "Q = sum(F_x*x′ + F_y*y′ + M*φ′)", Some(Stage("4")), Some(Dynamics);
    "word-motion" "J*ε + J′*ω²/2 = Q + M_d", Some(Differential("3.10")), Some(Dynamics);
    "word-energy" "T - T_0 = A, ω = sqrt((J_0*ω_0² + 2*A)/J)", Some(Energy("1")), Some(Dynamics);
    "word-regime" "ω(q + 2*π) = ω(q)", Some(Stage("6")), Some(Dynamics);
    "word-multiplier" "dω(q + 2*π)/dω(q)", Some(Stage("6")), Some(Dynamics);
    "word-unevenness" "δ = (max(ω) - min(ω))/ω_m", Some(Energy("7")), Some(Results);
    "word-dynamic-unevenness" "2*δ/(φ_2 - φ_1)", Some(EnergyExample("2")), Some(Results);
    "word-required-power" "P = |A_c|/(T*e)", Some(Stage("5")), Some(Dynamics);
    "word-excess" "A_e = max(A) - min(A)", Some(Energy("10")), Some(Results);
    "word-energy-mass" "ω² = 2*T/J", Some(Energy("10")), Some(Dynamics);
    "word-flywheel" "J = A_e/(ω_m²*δ)", Some(Energy("10")), Some(Dynamics);
    "word-gear-ratio" "u = ω_d/ω", Some(Stage("6")), Some(Dynamics);
    "word-kloss" "M = 2*M_k/(s/s_k + s_k/s)", Some(Stage("5")), Some(Dynamics);
    "word-slip" "s = 1 - ω/ω_s", Some(Stage("5")), Some(Dynamics);
    "word-starting-torque" "M_0 = 2*M_k/(1/s_k + s_k)", Some(Stage("5")), Some(Dynamics);
    "word-rms" "sqrt(mean(M²))", None, Some(Dynamics);
    "word-residual" "", None, Some(Checks);
    "word-remainder" "M_b + Q - J*ε - J′*ω²/2", Some(Stage("8")), Some(Checks);
    "word-global" "M_b = M_d - J_d*ε", Some(Stage("10")), Some(Checks);
}
