//! What the rows of a sweep are made of.

use std::collections::BTreeMap;

use assur_words::{Text, name, text};

use crate::axis::Axis;
use crate::{Measure, Points, Sweep};

/// Key of the text of the scene.
const SCENE: &str = "scene";

/// What rows are made of, by key, as files with rows say it: they are of one sweep exactly where this is the same.
pub type Origin = BTreeMap<String, String>;

impl Sweep {
    /// What its rows are made of: the version of the program, the scene, what is varied, tied and measured, the methods. Parameters,
    /// ties, measures and targets stand one a line, as they are given; what does not apply has no key. Of a table of points the rows
    /// have the numbers, and the origin says which table it was.
    pub fn origin(&self) -> Origin {
        let lines = |all: Vec<String>| all.join("\n");
        let is_table = self.points == Points::Table;
        let ranges = |tied: bool| {
            let of = self.axes.iter().zip(self.ranges());
            let of = of.filter(|(axis, _)| axis.follows().is_some() == tied);
            let shown = |(axis, range): (&Axis, String)| {
                if is_table && !tied { axis.key.clone() } else { range }
            };
            lines(of.map(shown).collect())
        };
        let place = |(_, point, [x, y]): &(usize, String, [f64; 2])| format!("{point}={x} m,{y} m");
        let [sample, seed] = match self.points {
            Points::Sample { count, seed } => [count.to_string(), seed.to_string()],
            Points::Grid | Points::Table => Default::default(),
        };
        let all = [
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            (SCENE, self.variants.scene.clone()),
            ("vary", ranges(false)),
            ("tie", ranges(true)),
            ("table", if is_table { self.table() } else { String::new() }),
            ("sample", sample),
            ("seed", seed),
            ("measure", lines(self.measures.iter().map(Measure::full_name).collect())),
            ("between", if self.between { "yes".to_owned() } else { String::new() }),
            ("target", lines(self.layout.targets.iter().map(place).collect())),
            ("where", lines(self.conditions.iter().map(|test| test.condition.to_string()).collect())),
            ("analyzer", self.layout.analyzer.unwrap_or_default().to_owned()),
            ("integrator", self.options.integrator.clone().unwrap_or_default()),
        ];
        let all = all.into_iter().map(|(key, value)| (key.to_owned(), value));
        all.filter(|(_, value)| !value.is_empty()).collect()
    }

    /// The number of points of a table, and a hash of its keys and values (FNV-1a, 64 bits).
    fn table(&self) -> String {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for range in self.ranges() {
            for byte in range.bytes().chain([b'\n']) {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
        format!("{} points, hash {hash:016x}", self.points())
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
