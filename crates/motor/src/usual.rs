//! The unevenness that kinds of machines usually have.

/// Admissible unevenness (max - min)/mean of the speed of a kind of machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UsualUnevenness {
    /// The kind of machine.
    pub machine: &'static str,
    /// Least and greatest usual value.
    pub range: [f64; 2],
}

/// Where [`USUAL_UNEVENNESS`] is printed.
pub const USUAL_SOURCE: &str = "R. S. Khurmi, J. K. Gupta: A Textbook of Machine Design, table 22.2";

/// The usual unevenness by kind of machine, the least uniform ones first; from [`USUAL_SOURCE`].
pub const USUAL_UNEVENNESS: [UsualUnevenness; 11] = {
    const fn usual(machine: &'static str, least: f64, greatest: f64) -> UsualUnevenness {
        UsualUnevenness { machine, range: [least, greatest] }
    }
    [
        usual("crushing machines", 0.2, 0.2),
        usual("hammering machines", 0.2, 0.2),
        usual("punching, shearing and power presses", 0.10, 0.15),
        usual("pumps", 0.03, 0.05),
        usual("machine tools", 0.03, 0.03),
        usual("engines with belt transmission", 0.03, 0.03),
        usual("paper, textile and weaving machines", 0.025, 0.025),
        usual("rolling mills and mining machines", 0.025, 0.025),
        usual("gear wheel transmissions", 0.02, 0.02),
        usual("electrical machines", 0.003, 0.003),
        usual("electrical machines, driven directly", 0.002, 0.002),
    ]
};
