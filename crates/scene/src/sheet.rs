//! Reads `[sheet]`: what the scene says about its drawing sheet.

use assur_words::{Text, name, text};

use crate::walk::Section;

/// A format of ISO 216, A0 to A4.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SheetFormat {
    /// 297 x 210 mm.
    A4,
    /// 420 x 297 mm.
    A3,
    /// 594 x 420 mm.
    A2,
    /// 841 x 594 mm.
    A1,
    /// 1189 x 841 mm.
    A0,
}

/// A field of the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SheetField {
    /// The mechanism in all positions over each other, and its groups.
    Mechanism,
    /// Displacement, velocity and acceleration over one abscissa.
    Diagrams,
    /// Plans of velocities.
    Velocities,
    /// Plans of accelerations.
    Accelerations,
    /// Groups with their loads and reactions, and their polygons.
    Forces,
    /// Zhukovsky's lever.
    Lever,
    /// Reduced moments and inertia, energies, the drive.
    Dynamics,
    /// The table of results.
    Results,
}

/// The fields by their words in a scene, in the order of a sheet whose scene does not say.
pub const SHEET_FIELDS: [(&str, SheetField); 8] = [
    ("mechanism", SheetField::Mechanism),
    ("diagrams", SheetField::Diagrams),
    ("velocities", SheetField::Velocities),
    ("accelerations", SheetField::Accelerations),
    ("forces", SheetField::Forces),
    ("lever", SheetField::Lever),
    ("dynamics", SheetField::Dynamics),
    ("results", SheetField::Results),
];

const FORMATS: [(&str, SheetFormat); 5] = [
    ("A0", SheetFormat::A0),
    ("A1", SheetFormat::A1),
    ("A2", SheetFormat::A2),
    ("A3", SheetFormat::A3),
    ("A4", SheetFormat::A4),
];

/// Positions that are drawn over each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SheetPositions {
    /// So many, equally spaced over the cycle.
    Count(usize),
    /// Those of these numbers.
    Numbers(Vec<usize>),
}

/// What a scene says about its drawing sheet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sheet {
    /// Its format; `None`: the smallest that holds the fields.
    pub format: Option<SheetFormat>,
    /// The positions that are drawn over each other.
    pub positions: SheetPositions,
    /// Numbers of the positions of plans and polygons; empty: those of the note.
    pub plans: Vec<usize>,
    /// The fields in their order; `None`: those that the scene has.
    pub fields: Option<Vec<SheetField>>,
    /// The number of the drawing, for the title block.
    pub number: Option<Text>,
}

impl Default for Sheet {
    fn default() -> Self {
        const POSITIONS: usize = 12;
        Self {
            format: None,
            positions: SheetPositions::Count(POSITIONS),
            plans: Vec::new(),
            fields: None,
            number: None,
        }
    }
}

/// Most positions over each other, and most whose plans are drawn.
const MOST_POSITIONS: usize = 60;
const MOST_PLANS: usize = 12;

/// Reads `[sheet]`; `positions` is the number of positions of the scene, where it is known.
pub(crate) fn read(root: &Section<'_>, positions: Option<usize>) -> Sheet {
    let mut sheet = Sheet::default();
    let Some(section) = root.inner("sheet") else { return sheet };
    let last = positions.unwrap_or(usize::MAX).saturating_sub(1);
    let numbers = |key: &'static str, most: usize| {
        let Some(entry) = section.get(key) else { return Vec::new() };
        let listed = entry.list(text!("scene-list-of-positions"));
        if listed.len() > most {
            let message = text!("scene-many-positions-of-sheet", key = name(key), most);
            entry.fault(message, text!("scene-here-are", count = listed.len()));
        }
        listed.iter().filter_map(|entry| entry.count(0, last)).collect()
    };
    sheet.format = section.get("format").and_then(|entry| entry.choice(&FORMATS));
    sheet.positions = match section.get("positions") {
        Some(entry) if !entry.is_list() => {
            entry.count(1, MOST_POSITIONS).map_or(sheet.positions, SheetPositions::Count)
        }
        Some(_) => SheetPositions::Numbers(numbers("positions", MOST_POSITIONS)),
        None => sheet.positions,
    };
    sheet.plans = numbers("plans", MOST_PLANS);
    sheet.fields = section.get("fields").map(|entry| {
        let listed = entry.list(text!("scene-list-of-fields"));
        listed.iter().filter_map(|entry| entry.choice(&SHEET_FIELDS)).collect()
    });
    sheet.number = section.words("number");
    sheet
}
