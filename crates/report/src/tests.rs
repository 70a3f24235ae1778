//! Forms of the results: what is written reads back, and nothing wrong is written silently.

use std::sync::Arc;

use crate::csv::{CsvCell, CsvError, CsvTable, of_positions, write};
use crate::json::analysis::to_json;
use assur_analysis::results::{
    Analysis, Column, Cycle, InputReport, Owner, Peaks, Quantity, Schema, Section, Starts, StructureReport,
    Survey, Table,
};
use assur_mechanism::{Mechanism, Named, PairId};
use assur_words::to_ascii;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

/// A link called `größe`, and a slide.
fn mechanism() -> Mechanism {
    let scene = "[ground]\npoints = { O = 0 }\n[link.\"größe\"]\npoints = { O = 0, A = 1 }\n\
        [link.rod]\npoints = { A = 0, B = 4 }\n[link.ram]\npoints = { B = 0 }\n\
        [[slide]]\nlink = \"ram\"\non = \"ground\"\n[input]\nlink = \"größe\"\n";
    assur_scene::read("test", scene).unwrap()
}

/// The columns of a position: coordinate, a link, a point, the forces of the slide, the balancing load, a condition.
fn schema(mechanism: &Mechanism) -> Schema {
    let mut schema = Schema::new(mechanism);
    let transfer = |owner| (0..=2).map(move |order| Column::of(Quantity::Transfer(order), owner));
    schema.add(Section::ALWAYS, [Column::COORDINATE]);
    schema.add(Section::ALWAYS, transfer(Owner::Link(1)));
    let point = Owner::Point(mechanism.point("A").unwrap());
    schema.add(Section::ALWAYS, (0..=2).flat_map(|order| Column::vector(Quantity::Transfer(order), point)));
    let (forces, offset, balancing, condition) =
        (schema.section(), schema.section(), schema.section(), schema.section());
    let slide = PairId::Slide(0);
    for link in [3, 0] {
        schema.add(forces, Column::vector(Quantity::Force, Owner::PairOn(slide, link)));
    }
    schema.add(forces, [Column::of(Quantity::Moment, Owner::Pair(slide))]);
    schema.add(offset, [Column::of(Quantity::Offset, Owner::Pair(slide))]);
    schema.add(balancing, [Column::BALANCING]);
    schema.add(condition, [Column::of(Quantity::Condition, Owner::Group(0))]);
    schema
}

fn analysis(angle: f64) -> Analysis {
    let mechanism = mechanism();
    let mut positions = Table::new(Arc::new(schema(&mechanism)));
    let motion = [0.1 + 0.2, angle, 1.0, 0.0, 1e-300, 2.0 / 3.0, 0.0, 0.0, 0.0, 0.0];
    let forces = [1.0, -2.0, -1.0, 2.0, 0.5, 0.25, 3.0, 2.0];
    positions.push(0, motion.into_iter().chain(forces).map(Some));
    // A singular position without reactions.
    positions.push(5, [Some(7.0); 10].into_iter().chain([None; 6]).chain([Some(4.0), None]));
    let mut motion = Schema::new(&mechanism);
    motion.add(Section::ALWAYS, [Column::of(Quantity::Time, Owner::Input), Column::COORDINATE]);
    Analysis {
        title: "a \"title\", with Ж and 🦀".into(),
        input: InputReport {
            link: Named { id: 1, name: "größe".into() },
            pair: None,
            kind: assur_mechanism::CoordinateKind::Angle,
            angular: true,
            balancing_is_moment: true,
        },
        structure: StructureReport {
            mobility: 1,
            mobility_by_rank: None,
            passive: Vec::new(),
            note: None,
            class: 2,
            formula: "".into(),
            moving_links: 1,
            pairs: 1,
            groups: Vec::new(),
        },
        survey: Survey::over(&positions),
        starts: Starts::default(),
        peaks: Peaks::default(),
        positions,
        failures: Vec::new(),
        trajectory: Table::new(Arc::new(motion)),
        dynamics: None,
        integration: None,
        no_motion: None,
        warnings: Vec::new(),
        friction: None,
        several: Vec::new(),
        cycle: Cycle::default(),
        checks: Vec::new(),
        residuals: Table::default(),
    }
}

#[test]
fn json_has_the_shapes_of_the_contract_and_all_digits() {
    let text = to_json(&analysis(1.5), false).unwrap();
    let read: serde_json::Value = serde_json::from_str(&text).unwrap();
    let position = &read["positions"][0];
    assert_eq!(position["coordinate"].as_f64().map(f64::to_bits), Some((0.1_f64 + 0.2).to_bits()));
    assert_eq!(position["points"]["A"]["pf0"], serde_json::json!([1e-300, 2.0 / 3.0]));
    let reaction = serde_json::json!({ "ram": [1.0, -2.0], "ground": [-1.0, 2.0], "moment": 0.5 });
    assert_eq!(position["reactions"]["ram/ground"], reaction);
    assert_eq!(position["links"], serde_json::json!({ "größe": { "pf0": 1.5, "pf1": 1.0, "pf2": 0.0 } }));
    assert_eq!((&position["slides"], &position["index"]), (&serde_json::json!({}), &serde_json::json!(0)));
    let singular = &read["positions"][1];
    assert_eq!((&singular["condition"], &singular["index"]), (&serde_json::json!({}), &serde_json::json!(5)));
    assert!(singular.get("reactions").is_none() && singular["balancing"] == 4.0);
    let absent = ["speed", "acceleration", "velocities", "accelerations", "reduced"];
    assert!(absent.iter().all(|key| position.get(key).is_none()));
    assert!(["failures", "trajectory", "dynamics", "checks"].iter().all(|key| read.get(key).is_none()));
}

#[test]
fn ascii_json_reads_back_the_same() {
    let (plain, ascii) = (to_json(&analysis(1.5), false).unwrap(), to_json(&analysis(1.5), true).unwrap());
    assert!(ascii.is_ascii() && !plain.is_ascii());
    let read = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    assert_eq!(read(&plain), read(&ascii));
}

#[test]
fn numbers_that_are_not_finite_are_never_written() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let fault = to_json(&analysis(bad), false).unwrap_err().to_string();
        assert!(fault.contains("`positions[0].links.größe.pf0` is not finite"), "{fault}");
        let fault = write(&["a", "b"], [[CsvCell::Empty, CsvCell::Number(bad)]], false).unwrap_err();
        assert!(matches!(&fault, CsvError::NotFinite { column, row: 1 } if column == "b"), "{fault}");
        let scene = assur_scene::read("shaper", assur_fixtures::scene("shaper")).unwrap();
        let linkage = assur_kinematics::Linkage::compile(scene).unwrap();
        let fault =
            crate::text::report(&analysis(bad), &linkage, None, crate::text::Style::english()).unwrap_err();
        assert_eq!(fault.place, "positions[0].links.größe.pf0");
    }
}

#[test]
fn a_quantity_of_which_no_topic_tells_stands_in_the_text() {
    let mut schema = Schema::new(&mechanism());
    let efficiency = Column::of(Quantity::Efficiency, Owner::Input);
    schema.add(Section::ALWAYS, [Column::COORDINATE, efficiency]);
    let mut positions = Table::new(Arc::new(schema));
    positions.push(0, [0.0, 0.375].map(Some));
    // Without friction nothing tells of efficiencies.
    let analysis = Analysis { positions, ..analysis(1.5) };
    let scene = assur_scene::read("shaper", assur_fixtures::scene("shaper")).unwrap();
    let linkage = assur_kinematics::Linkage::compile(scene).unwrap();
    let english = crate::text::Style::english();
    let text = crate::text::report(&analysis, &linkage, None, english).unwrap();
    // The note tells of it alone, among other topics than those of the report.
    let source = crate::topic::Source::of(&analysis, &linkage, None);
    let alone = crate::text::told(english, |page| crate::topic::further(&source, page));
    for text in [text, alone] {
        let (_, further) = text.split_once("Further quantities").unwrap();
        assert!(further.contains("efficiency") && further.contains("0.375"), "{further}");
    }
}

#[test]
fn csv_reads_back() {
    let analysis = analysis(1.5);
    let sheets = of_positions(&analysis, false);
    assert_eq!(sheets.iter().map(|sheet| sheet.file).collect::<Vec<_>>(), ["positions.csv", "reactions.csv"]);
    let text = |sheet: &CsvTable| {
        let text = [sheet.header().unwrap(), sheet.rows(&analysis.positions)].concat();
        String::from_utf8(text).unwrap()
    };
    let texts: Vec<String> = sheets.iter().map(text).collect();
    let mut reader = ::csv::Reader::from_reader(texts[0].as_bytes());
    let header = reader.headers().unwrap().clone();
    let row = reader.records().next().unwrap().unwrap();
    let cell =
        |name: &str| row[header.iter().position(|found| found == name).unwrap()].parse::<f64>().unwrap();
    assert_eq!(cell("coordinate_rad").to_bits(), (0.1_f64 + 0.2).to_bits());
    assert_eq!(cell("A_x_m").to_bits(), 1e-300_f64.to_bits());
    assert_eq!(cell("A_y_m").to_bits(), (2.0_f64 / 3.0).to_bits());
    assert!(texts[1].starts_with("index,coordinate_rad,balancing_Nm,ram/ground_ram_fx_N,"));
    assert!(texts[0].ends_with("\n5,7,7,7,7,7,7,7,7,7,7,\n"), "{}", texts[0]);
    assert!(texts[1].ends_with("\n5,7,4,,,,,\n"), "{}", texts[1]);
}

#[test]
fn numbers_are_the_shortest_that_read_back() {
    let mut bits = 0x0123_4567_89ab_cdef_u64;
    for _ in 0..20_000 {
        bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let small = f64::from_bits(bits >> 12 | 0x3ff0_0000_0000_0000) - 1.5;
        for value in [f64::from_bits(bits), small, (small * 1e17).trunc(), small * 1e-5, small.trunc()] {
            if value.is_finite() {
                let mut text = Vec::new();
                crate::csv::number(value, &mut text);
                let whole = value == 0.0 || (1e-5..1e15).contains(&value.abs());
                let known = if whole { format!("{value}") } else { format!("{value:e}") };
                let text = String::from_utf8(text).unwrap();
                // Of two shortest texts as near either may be taken.
                assert_eq!((text.len(), text.parse()), (known.len(), Ok(value)), "{text} for {known}");
            }
        }
    }
}

#[test]
fn parquet_reads_back_over_groups() {
    let analysis = analysis(1.5);
    let mut bytes = Vec::new();
    let mut writer = assur_parquet::Writer::new(&analysis, &mut bytes).unwrap();
    // Two rows of 18 columns: a group is full after 349,526 tables.
    let tables = 360_000;
    for _ in 0..tables {
        writer.add(&analysis.positions).unwrap();
    }
    writer.finish().unwrap();
    let reader = SerializedFileReader::new(bytes::Bytes::from(bytes)).unwrap();
    assert_eq!(reader.metadata().file_metadata().num_rows(), 2 * tables);
    assert!(reader.num_row_groups() > 1);
    let last = reader.get_row_iter(None).unwrap().last().unwrap().unwrap();
    let cell = |name: &str| last.get_column_iter().find(|(found, _)| *found == name).unwrap().1.clone();
    assert_eq!((cell("index"), cell("coordinate_rad")), (Field::Long(5), Field::Double(7.0)));
    assert_eq!((cell("balancing_Nm"), cell("condition_0")), (Field::Double(4.0), Field::Null));
    let first = reader.get_row_iter(None).unwrap().next().unwrap().unwrap();
    let cell = |name: &str| first.get_column_iter().find(|(found, _)| *found == name).unwrap().1.clone();
    assert_eq!((cell("coordinate_rad"), cell("A_x_m")), (Field::Double(0.1 + 0.2), Field::Double(1e-300)));
    assert_eq!((cell("ram/ground_moment_Nm"), cell("condition_0")), (Field::Double(0.5), Field::Double(2.0)));
}

#[test]
fn ascii_spells_signs_and_letters() {
    assert_eq!(to_ascii("kg·m², 5°"), "kg*m^2, 5 deg");
    assert_eq!(to_ascii("Жёлтый Щит"), "Zheltyy Shchit");
    assert_eq!(to_ascii("漢 crank"), "? crank");
}

#[test]
fn columns_are_harmless_and_have_one_name_each() {
    let cells = [CsvCell::Number(1.0), CsvCell::Text("-sum(A1)"), CsvCell::Number(3.0), CsvCell::Empty];
    let text = write(&["=a", "b", "ä", "ae"], [cells], true).unwrap();
    assert_eq!(text, "_=a,b,ae,ae_2\n1,_-sum(A1),3,\n");
    // Full and small width, which some spreadsheets take for the common sign; after a letter it is a name's own.
    for begins in ["＝1", "＋1", "－1", "＠a", "﹦1", "﹢1", "﹣1", "﹫a", "−1"] {
        let text = write(&[begins], [[CsvCell::Text(begins)], [CsvCell::Text("a＝1")]], false).unwrap();
        assert_eq!(text, format!("_{begins}\n_{begins}\na＝1\n"));
    }
}
