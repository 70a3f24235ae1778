use assur_words::name;
use proptest::prelude::*;

use super::motors;
use crate::{find_designation, latin_designation, normalize_designation, same_designation};

#[test]
fn script_case_and_spaces_do_not_matter() {
    // Cyrillic, Latin, mixed, typed by look or by sound.
    for alike in ["4А100L4", "4A100L4", "4а100l4", "4 А 100 L 4", "4A\u{a0}100L4"] {
        assert!(same_designation("4А100L4", alike), "{alike}");
    }
    for alike in ["АИР71В4", "AIR71B4", "aир71b4", "AИP71B4", "air 71 b4"] {
        assert!(same_designation("АИР71В4", alike), "{alike}");
    }
    assert!(same_designation("4А112МА6У3", "4A112MA6Y3"), "by look");
    assert!(same_designation("4А112МА6У3", "4A112MA6U3"), "by sound");
    assert!(!same_designation("4А100L4", "4А100L2"));
    assert!(!same_designation("4А100L4", "4А100S4"));
}

#[test]
fn latin_form_is_ascii() {
    assert_eq!(latin_designation("4А112МВ8У3"), "4A112MB8U3");
    assert_eq!(latin_designation("АИР100S4"), "AIR100S4");
    assert_eq!(latin_designation("LSES 80 LG 4p 0.9 kW"), "LSES 80 LG 4p 0.9 kW");
    assert_eq!(latin_designation("4а"), "4a");
    assert_eq!(latin_designation("日"), "?");
}

#[test]
fn the_climatic_version_may_be_left_out_or_added() {
    let rows = motors(&[
        "4А100L4У3,4,4,1500,1430,2.2",
        "4А100L2У3,2,5.5,3000,2880,2.2",
        "АИР71В4,4,0.75,1500,1390,2.2",
    ]);
    let find =
        |text: &str| find_designation(&rows, text, &name("catalogue TEST")).unwrap().designation.clone();
    assert_eq!(find("4A100L4"), "4А100L4У3");
    assert_eq!(find("4А100l4 у3"), "4А100L4У3");
    assert_eq!(find("4A100L4UHL4"), "4А100L4У3");
    assert_eq!(find("АИР71В4У2"), "АИР71В4");
}

#[test]
fn what_was_appended_to_a_type_may_be_left_out_where_one_row_remains() {
    let rows = motors(&[
        "LSES 80 LG 4p 0.75 kW,4,0.75,1500,1430,2.2",
        "LSES 80 LG 4p 0.9 kW,4,0.9,1500,1430,2.2",
        "LSES 80 L 2p 0.75 kW,2,0.75,3000,2850,2.2",
    ]);
    let find = |text| find_designation(&rows, text, &name("catalogue TEST"));
    assert_eq!(find("lses80l").unwrap().designation, "LSES 80 L 2p 0.75 kW");
    assert_eq!(
        find("LSES 80 LG").unwrap_err().to_string(),
        "`LSES 80 LG` names 2 motors in catalogue TEST: LSES 80 LG 4p 0.75 kW, LSES 80 LG 4p 0.9 kW; \
         give the whole designation"
    );
    // A part of a word is not a type.
    assert_eq!(find("LSES 8").unwrap_err().0.identity(), Some("motor-not-found"));
}

#[test]
fn an_unknown_designation_suggests_the_nearest() {
    let rows =
        motors(&["4А90L4У3,4,2.2,1500,1425,2.2", "4А100L4У3,4,4,1500,1430,2.2", "4А250М8У3,8,45,750,740,2"]);
    let error = find_designation(&rows, "4A100L5", &name("catalogue TEST")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "no motor `4A100L5` in catalogue TEST; the nearest are: 4А100L4У3, 4А90L4У3"
    );
    let error = find_designation(&rows, "", &name("catalogue TEST")).unwrap_err();
    assert_eq!(error.to_string(), "no motor `` in catalogue TEST; `assur motors` lists them all");
}

#[test]
fn a_power_in_place_of_a_designation_is_answered_with_its_motors() {
    let rows = motors(&["A4,4,1.1,1500,1425,2.2", "B2,2,1.1,3000,2850,2.2", "C4,4,2.2,1500,1430,2.2"]);
    let tell = |text| find_designation(&rows, text, &name("catalogue TEST")).unwrap_err().to_string();
    for text in ["1.1 kW", "1.1kW", "1,1 kW", "1100 W", "1.1 кВт"] {
        let told = tell(text);
        assert!(told.contains("of 1.1 kW there are 2") && told.ends_with(": A4, B2"), "{told}");
    }
    // What is to be typed is the same in a language with a decimal comma.
    let error = find_designation(&rows, "1,1 kW", &name("TEST")).unwrap_err();
    let told = assur_words::Describe::describe(&error).render(assur_words::Language::find("uk").unwrap());
    assert!(told.contains("--min-power \"1.1 kW\" --max-power \"1.1 kW\"`"), "{told}");
    // No motor has that power.
    assert!(tell("5 kW").ends_with("lists them all"));
}

proptest! {
    #[test]
    fn normalizing_twice_is_normalizing_once(text in "\\PC{0,20}") {
        let once = normalize_designation(&text);
        prop_assert_eq!(&normalize_designation(&once), &once);
    }

    #[test]
    fn latin_is_always_ascii_and_lookup_never_panics(text in "\\PC{0,20}") {
        prop_assert!(latin_designation(&text).is_ascii());
        let rows = motors(&["4А100L4У3,4,4,1500,1430,2.2", "ТИП Ж 2p,2,4,3000,2880,2.2"]);
        let _ = find_designation(&rows, &text, &name("catalogue TEST"));
    }
}
