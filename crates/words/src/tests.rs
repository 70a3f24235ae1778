//! Numbers, units, counts and lists in each language.

use fluent_bundle::FluentResource;

use crate::{
    Describe, LANGUAGES, Language, Resource, Text, Told, count, exact, joined, labelled, list, measured,
    name, number, quantity, unit,
};

fn in_all(text: &Text) -> [String; 3] {
    LANGUAGES.map(|code| text.render(Language::find(code).unwrap()))
}

#[test]
fn a_number_has_the_signs_of_its_language() {
    assert_eq!(in_all(&number("-1.50e-15")), ["-1.50e-15", "−1,50·10⁻¹⁵", "−1,50·10⁻¹⁵"]);
    assert_eq!(in_all(&number("0.00e0")), ["0.00e0", "0,00", "0,00"]);
    assert_eq!(in_all(&number("1,000,000")), ["1,000,000", "1\u{a0}000\u{a0}000", "1\u{a0}000\u{a0}000"]);
}

#[test]
fn a_unit_has_the_letters_of_its_language_and_a_name_stays() {
    assert_eq!(in_all(&unit("kg m2/rad")), ["kg·m²/rad", "кг·м²/рад", "кг·м²/рад"]);
    assert_eq!(in_all(&unit("m/s/mm")), ["(m/s)/mm", "(м/с)/мм", "(м/с)/мм"]);
    assert_eq!(in_all(&quantity(-2, "rpm")), ["-2 rpm", "−2 об/хв", "−2 об/мин"]);
    assert_eq!(in_all(&quantity(0.5, "")), ["0.5", "0,5", "0,5"]);
    assert_eq!(in_all(&name("m")), ["m"; 3]);
    assert_eq!(in_all(&list([count(2), name("rod")])), ["2, rod"; 3]);
    assert!(list([Text::default(), number("")]).is_empty() && !count(0).is_empty());
}

#[test]
fn a_result_is_rounded_once_to_the_digits_of_a_language() {
    let (value, uk) = (0.123_449_9, Language::find("uk").unwrap());
    assert_eq!(exact(value, "0.12345").render(uk), "0,12345");
    assert_eq!(exact(value, "0.12345").render(&uk.with_digits(4)), "0,1234");
    assert_eq!(exact(-1.23456e9, "-1.23456e9").render(&uk.with_digits(4)), "−1,235·10⁹");
    assert_eq!(number("0.12345").render(&uk.with_digits(4)), "0,12345");
}

#[test]
fn a_label_is_for_readers_in_their_language_and_files_have_the_name() {
    let crank = labelled(name("crank"), [("uk", "кривошип".to_owned()), ("en", "driver".to_owned())]);
    let of = list([crank.clone(), name("A")]);
    assert_eq!(in_all(&of), ["driver, A", "кривошип, A", "crank, A"]);
    assert_eq!(of.to_string(), "crank, A");
    assert_eq!(of.names(), ["crank", "A"]);
}

#[test]
fn an_identity_that_no_language_has_is_shown_itself() {
    assert_eq!(in_all(&crate::text!("no-such-text", of = 2)), ["no-such-text"; 3]);
    assert!(Language::find("tlh").is_none());
}

#[test]
fn a_text_without_a_short_form_is_shown_whole() {
    assert_eq!(in_all(&crate::text!("unit-min").short()), ["min", "хв", "мин"]);
    assert_eq!(in_all(&name("rod").short()), ["rod"; 3]);
}

#[test]
fn every_language_is_read_without_a_fault() {
    for resource in inventory::iter::<Resource> {
        assert!(FluentResource::try_new(resource.texts.to_owned()).is_ok(), "{resource:?}");
    }
}

#[test]
fn an_error_of_main_reads_as_it_is_shown() {
    #[derive(Clone)]
    struct Own(Told);
    impl Describe for Own {
        fn describe(&self) -> Text {
            crate::text!("unit-min").clone()
        }
    }
    impl From<Told> for Own {
        fn from(told: Told) -> Self {
            Self(told)
        }
    }
    crate::errors!(Own);
    let own = Own::from(Told(name("rod")));
    assert_eq!([format!("{own:?}"), format!("{own:#?}"), format!("{:?}", own.0)], ["min", "min", "rod"]);
}

#[test]
fn marks_stand_for_names_and_labels() {
    let crank = || labelled(name("crank"), [("uk", "кривошип".to_owned())]);
    let marks = [("crank".to_owned(), "1".to_owned())];
    for code in LANGUAGES {
        let marked = Language::find(code).unwrap().with_marks(marks.clone());
        assert_eq!(joined("/", [crank(), name("rod")]).render(&marked), "1/rod", "{code}");
        assert_eq!(name("crank").render(&marked), "1", "{code}");
        let in_indices = Language::find(code).unwrap().with_marks_in_indices(marks.clone());
        let symbol = name("S").below(crank());
        assert_eq!(joined(" ", [name("crank"), symbol]).typeset(&in_indices), "crank S_{1}", "{code}");
    }
    // Files keep the name.
    assert_eq!(crank().to_string(), "crank");
}

#[test]
fn a_subscript_is_one_word_with_its_letter_and_marked_for_print_alone() {
    let english = Language::english();
    let normal = || name("a").above(name("n")).below(joined("", [name("B"), name("A")]));
    assert_eq!(normal().to_string(), "a^n_BA");
    assert_eq!(normal().typeset(english), "a^{n}_{BA}");
    // Within a message, a heading and a part with a label as by itself; a name is no markup.
    let part = labelled(normal(), [("uk", "прискорення".to_owned())]).heading();
    assert_eq!(part.typeset(english), "a^{n}_{BA}");
    let quoted = joined(" ", [name("x_{1}"), name("R").below(name("ram/ground, rod"))]);
    assert_eq!(quoted.render(english), "x_{1} R_ram_ground_rod");
    assert_eq!(name("F").below(name("")), name("F"));
}

#[test]
fn a_heading_begins_with_a_capital_and_a_symbol_stays() {
    for (text, told) in [
        ("speed, m/s", "Speed, m/s"),
        ("v, m/s", "v, m/s"),
        ("з групою 1", "З групою 1"),
        ("φ, rad", "φ, rad"),
    ] {
        assert_eq!(name(text).heading().to_string(), told);
    }
}

#[test]
fn a_measured_value_has_the_digits_of_the_language() {
    let value = measured(1234.5678, 6, "N");
    assert_eq!(value.to_string(), "1234.57 N");
    assert_eq!(value.render(&Language::english().with_digits(4)), "1235 N");
}
