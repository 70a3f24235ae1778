//! The resources of all languages, and the translation of texts from elsewhere.

use super::Words;

#[test]
fn both_translations_have_every_phrase_with_all_its_places() {
    let phrases = |text: &str| -> toml::Table {
        let table: toml::Table = text.parse().unwrap();
        table["phrases"].as_table().unwrap().clone()
    };
    let [uk, ru] = [include_str!("../../lang/uk.toml"), include_str!("../../lang/ru.toml")].map(phrases);
    assert!(uk.keys().eq(ru.keys()));
    for (english, own) in uk.iter().chain(&ru) {
        let places = |text: &str| text.matches("{}").count();
        assert_eq!(places(english), places(own.as_str().unwrap()), "{english}");
    }
}

#[test]
fn a_phrase_of_a_figure_is_translated_whole_and_names_are_not() {
    let words = Words::of("uk");
    assert_eq!(words.phrase("velocity: 0.5 m/s"), "швидкість: 0,5 м/с");
    assert_eq!(words.phrase("speed of the motor, rad/s"), "швидкість двигуна, рад/с");
    assert_eq!(words.phrase("motorway on_mean 1.2.3"), "motorway on_mean 1,2,3");
    assert_eq!(words.phrase("μ_{v} = 0.0075 m/s/mm"), "μ_{v} = 0,0075 (м/с)/мм");
    assert_eq!(
        words
            .phrase("outer pin A: PF0 (-0.02, 1) m, PF1 (0, 0) m/rad, PF2 (0, 0) m/rad²")
            .matches('м')
            .count(),
        3
    );
    assert_eq!(
        words.phrase("Input link crank: reaction and balancing load").split(' ').nth(2),
        Some("crank:")
    );
    assert_eq!(
        words.name("I(ground,crank) -> II2(grounded,ram/ground)"),
        "I(стояк,crank) -> II2(grounded,ram/стояк)"
    );
    assert_eq!(Words::of("en").phrase("load on `ram`, 5 N m"), "load on ram, 5 N·m");
}
