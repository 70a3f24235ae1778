use assur_words::Text;

use crate::catalogue::named;
use crate::{CataloguePlugin, CatalogueTable};

static TABLE: CatalogueTable = CatalogueTable::new(
    "designation,poles,rated_power_kw,synchronous_speed_rpm,rated_speed_rpm,source\n4А1У3,4,1,1500,1400,x\n",
);

const NONE: Text = Text::message("", Vec::new());

const fn plugin(name: &'static str, crate_name: &'static str) -> CataloguePlugin {
    CataloguePlugin { name, crate_name, summary: NONE, source: NONE, table: &TABLE }
}

static A: CataloguePlugin = plugin("4A", "crate-a");
static B: CataloguePlugin = plugin("b-IEC", "crate-b");
static C: CataloguePlugin = plugin("C", "crate-c");

#[test]
fn found_without_regard_to_case_else_the_nearest_first() {
    let all = [&A, &B, &C];
    assert_eq!(named(&all, "B-iec").unwrap().crate_name, "crate-b");
    assert_eq!(named(&all, "4А").unwrap().crate_name, "crate-a", "Cyrillic");
    assert_eq!(
        named(&all, "B-EC").unwrap_err().to_string(),
        "no motor catalogue `B-EC`; there are: b-IEC, C, 4A"
    );
}

#[test]
fn rows_are_read_once_and_found() {
    assert!(std::ptr::eq(A.rows().unwrap(), A.rows().unwrap()));
    assert_eq!(A.find("4a1").unwrap().poles, 4);
    assert!(A.find("5A1").unwrap_err().to_string().contains("no motor `5A1` in catalogue 4A"));
}

#[test]
fn a_broken_table_is_an_error_every_time() {
    let broken = CatalogueTable::new("nothing");
    assert!(broken.rows("broken").is_err());
    assert_eq!(broken.rows("broken"), broken.rows("broken"));
}
