//! Every number that is reported in several places is one fact, shown the same everywhere.

use assur_figure::letters::{Level, indexed, levels};
use assur_report::json::analysis::to_json;
use assur_report::text::{Style, report};
use assur_report::topic::{regime_facts, summary};
use assur_words::{LANGUAGES, Language};
use serde_json::Value;

use super::{Form, of, results};

/// Scenes with a prescribed motion, a regime with a motor, a regime without, and a motion over time, in each language.
const SCENES: [&str; 6] = ["shaper", "shaper-drive", "press", "slider-crank", "conveyor", "run-up"];

/// A text as HTML has it, the number of a letter as its subscript.
fn escaped(text: &str) -> String {
    let escaped = |part: &str| part.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let written = |(part, level): (&str, Level)| match level {
        Level::Line => escaped(part),
        Level::Below => format!("<sub>{}</sub>", escaped(part)),
        Level::Above => format!("<sup>{}</sup>", escaped(part)),
    };
    levels(&indexed(text)).map(written).collect()
}

fn in_language(code: &str) -> Style {
    Style { language: Language::find(code).unwrap(), ascii: false }
}

/// Fails where the results that are asked for first are wider than a terminal.
fn assert_is_a_page(scene: &str, text: &str) {
    let mut first = text.lines().take_while(|line| !line.starts_with("2. ")).skip(2);
    let wide = first.find(|line| line.chars().count() > 78);
    assert!(wide.is_none(), "{scene}: {wide:?}");
}

#[test]
fn text_and_note_tell_every_fact_with_the_same_number() {
    let mut compared = 0;
    for (number, (scene, _)) in assur_fixtures::SCENES.iter().enumerate() {
        let results = results(scene);
        let (analysis, linkage) = (&results.found.as_ref().unwrap().analysis, &results.linkage);
        let facts = [summary(analysis, linkage), regime_facts(analysis)].concat();
        for code in LANGUAGES {
            assert_is_a_page(scene, &report(analysis, linkage, Some(&[0]), in_language(code)).unwrap());
        }
        // A note takes its time: of most scenes in one language each.
        let languages = LANGUAGES.into_iter().enumerate();
        let chosen = languages.filter(|(at, _)| SCENES.contains(scene) || number % LANGUAGES.len() == *at);
        for (_, code) in chosen {
            let language = Language::find(code).unwrap();
            let text = report(analysis, linkage, Some(&[0]), in_language(code)).unwrap();
            let html = of(scene, code, Form::Html).text;
            for fact in &facts {
                let [what, value, unit] = [fact.what(), fact.value(), assur_words::unit(fact.unit.name)]
                    .map(|text| text.render(language));
                // A long name goes on in the next line of its row.
                let told = |line: &str| {
                    let end =
                        line.find("  ").map_or(line.len(), |gap| gap.min(line.find(": ").unwrap_or(gap)));
                    let (name, rest) = line.split_at(end);
                    let rest = rest.trim_start_matches([' ', ':']);
                    !name.is_empty()
                        && what.starts_with(name)
                        && rest.starts_with(&value)
                        && rest.contains(&unit)
                };
                let words = value.split_whitespace().next().unwrap();
                assert!(
                    text.lines().any(told) || text.contains(&format!("{what}: {words}")),
                    "{scene} {code}: {what} {value} {unit}"
                );
                // The note has digits of its own.
                let of_note = language.with_digits(assur_scene::Note::default().digits);
                // The links of a formula of structure have their numbers in it.
                let numbers = assur_picture::mechanism::numbers(&linkage.mechanism);
                let value = match fact.id {
                    "fact-formula" => fact.value().render(&of_note.with_marks(numbers)),
                    _ => fact.value().render(&of_note),
                };
                let cell = |text: &str| format!(">{}</td>", escaped(&text.replace("->", "→")));
                let row =
                    html.split("<tr>").find(|row| row.contains(&cell(&what)) && row.contains(&cell(&value)));
                let unit = if unit.is_empty() { "–" } else { &unit };
                assert!(row.is_some_and(|row| row.contains(&cell(unit))), "{scene} {code}: {what} {value}");
                compared += 1;
            }
        }
    }
    assert!(compared > 400, "{compared}");
}

#[test]
fn the_facts_of_a_regime_are_those_of_the_json() {
    let results = results("shaper-drive");
    let analysis = &results.found.as_ref().unwrap().analysis;
    let json: Value = serde_json::from_str(&to_json(analysis, false).unwrap()).unwrap();
    let facts = regime_facts(analysis);
    for (id, pointer) in [
        ("fact-mean-speed", "mean_speed"),
        ("fact-unevenness", "unevenness"),
        ("fact-least-speed", "speed_min"),
        ("fact-greatest-speed", "speed_max"),
        ("fact-excess-work", "excess_work"),
        ("fact-required-power", "required_power"),
        ("fact-gear-ratio", "ratio"),
        ("fact-flywheel", "flywheel"),
        ("fact-cycle-time", "regime/cycle_time"),
        ("fact-mean-resistance", "regime/mean_resistance"),
        ("fact-multiplier", "regime/multiplier"),
        ("fact-shaft-inertia", "regime/shaft_inertia"),
        ("fact-rated-power", "motor/power"),
    ] {
        let fact = facts.iter().find(|fact| fact.id == id).unwrap_or_else(|| panic!("{id}"));
        let wanted = json.pointer(&format!("/dynamics/{pointer}")).and_then(Value::as_f64);
        let (assur_book::Value::Number(found), Some(wanted)) = (&fact.value, wanted) else {
            panic!("{id}: {fact:?}, {wanted:?}")
        };
        // The reader of the test rounds the last digit.
        assert!((found - wanted).abs() <= 1e-15 * wanted.abs(), "{id}: {found}, {wanted}");
    }
}
