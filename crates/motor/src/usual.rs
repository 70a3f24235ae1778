//! The unevenness that kinds of machines usually have.

use assur_words::{Text, text};

/// Admissible unevenness (max - min)/mean of the speed of a kind of machine.
#[derive(Debug, Clone, PartialEq)]
pub struct UsualUnevenness {
    /// The kind of machine.
    pub machine: Text,
    /// Least and greatest usual value.
    pub range: [f64; 2],
}

/// Where [`USUAL_UNEVENNESS`] is printed.
pub const USUAL_SOURCE: &str = "R. S. Khurmi, J. K. Gupta: A Textbook of Machine Design, table 22.2";

/// The usual unevenness by kind of machine, the least uniform ones first; from [`USUAL_SOURCE`].
pub static USUAL_UNEVENNESS: [UsualUnevenness; 11] = {
    const fn usual(machine: Text, least: f64, greatest: f64) -> UsualUnevenness {
        UsualUnevenness { machine, range: [least, greatest] }
    }
    [
        usual(text!("motor-usual-crushing"), 0.2, 0.2),
        usual(text!("motor-usual-hammering"), 0.2, 0.2),
        usual(text!("motor-usual-presses"), 0.10, 0.15),
        usual(text!("motor-usual-pumps"), 0.03, 0.05),
        usual(text!("motor-usual-tools"), 0.03, 0.03),
        usual(text!("motor-usual-belt"), 0.03, 0.03),
        usual(text!("motor-usual-paper"), 0.025, 0.025),
        usual(text!("motor-usual-rolling"), 0.025, 0.025),
        usual(text!("motor-usual-gears"), 0.02, 0.02),
        usual(text!("motor-usual-electrical"), 0.003, 0.003),
        usual(text!("motor-usual-electrical-direct"), 0.002, 0.002),
    ]
};
