//! What the rows of a sweep are made of.

use std::collections::BTreeMap;

use assur_words::{Text, name, text};

use crate::{Measure, Points, Sweep};

/// Key of the text of the scene.
const SCENE: &str = "scene";

/// What rows are made of, by key, as files with rows say it: they are of one sweep exactly where this is the same.
pub type Origin = BTreeMap<String, String>;

impl Sweep {
    /// What its rows are made of: the version of the program, the scene, what is varied, tied and measured, the methods. Parameters,
    /// ties, measures and targets stand one a line, as they are given; what does not apply has no key.
    pub fn origin(&self) -> Origin {
        let ranges = |tied: bool| {
            let of = self.axes.iter().zip(self.ranges()).filter(|(axis, _)| axis.follows.is_some() == tied);
            of.map(|(_, range)| range).collect::<Vec<_>>().join("\n")
        };
        let place = |(_, point, [x, y]): &(usize, String, [f64; 2])| format!("{point}={x} m,{y} m");
        let sample = match self.points {
            Points::Sample { count, seed } => [count.to_string(), seed.to_string()],
            Points::Grid => Default::default(),
        };
        let [sample, seed] = sample;
        let lines = |all: Vec<String>| all.join("\n");
        let all = [
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            (SCENE, self.variants.scene.clone()),
            ("vary", ranges(false)),
            ("tie", ranges(true)),
            ("sample", sample),
            ("seed", seed),
            ("measure", lines(self.measures.iter().map(Measure::full_name).collect())),
            ("between", if self.between { "yes".to_owned() } else { String::new() }),
            ("target", self.layout.targets.iter().map(place).collect::<Vec<_>>().join("\n")),
            ("analyzer", self.layout.analyzer.unwrap_or_default().to_owned()),
            ("integrator", self.options.integrator.clone().unwrap_or_default()),
        ];
        let all = all.into_iter().map(|(key, value)| (key.to_owned(), value));
        all.filter(|(_, value)| !value.is_empty()).collect()
    }
}

/// In what the origin of rows that were found differs from that of the rows that are wanted; `None` where both are one.
pub fn difference(found: &Origin, wanted: &Origin) -> Option<Text> {
    let differs = |key: &&String| found.get(*key) != wanted.get(*key);
    let key = found.keys().chain(wanted.keys()).find(differs)?;
    if key == SCENE {
        return Some(text!("sweep-other-scene"));
    }
    let of = |origin: &Origin| {
        origin
            .get(key)
            .map_or_else(|| text!("sweep-nothing"), |value| name(format!("`{}`", value.replace('\n', ", "))))
    };
    Some(text!("sweep-other-origin", key = name(key.clone()), was = of(found), is = of(wanted)))
}
