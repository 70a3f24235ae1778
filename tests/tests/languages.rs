//! What the calculating crates and the plugins say has no English left in another language.

use std::collections::BTreeSet;

use assur_all as _;
use assur_analysis::results::Analysis;
use assur_analysis::{Calculation, Coverage, Options, unwatched};
use assur_force::{ForceError, LoadError, LoadFault};
use assur_group::{BuildError, GroupError, RegistryError};
use assur_integrator::{Dependence, FixedStep, IntegrationError, MotionError, Request, State, Until};
use assur_kinematics::{CompileError, PositionError};
use assur_mechanism::CoordinateKind::{Angle, Length, Time};
use assur_motor::{
    Characteristic, CharacteristicKind, RatedMotor, SelectionRequest, check_breakdown, check_rms,
    check_rotor_inertia, check_starting, find_designation, parse_table, select,
};
use assur_words::{Describe, LANGUAGES, Language, Text, name, text};

/// Signs of formulas, which are the same in every language.
const SYMBOLS: [&str; 6] = ["sin", "cos", "max", "min", "dw", "inf"];

/// Words in English letters, of two letters and more, but for what is quoted, bracketed or allowed.
fn english(shown: &str, allowed: &[&str]) -> Vec<String> {
    let mut rest = String::new();
    let mut quote = None;
    for letter in shown.chars() {
        match (quote, letter) {
            (None, '`' | '"' | '[') => quote = Some(if letter == '[' { ']' } else { letter }),
            (Some(end), _) if letter == end => quote = None,
            (Some(_), _) => {}
            (None, _) => rest.push(letter),
        }
    }
    let words = rest.split(|letter: char| !(letter.is_alphanumeric() || "'-_.".contains(letter)));
    let words = words.map(|word| word.trim_matches(|letter: char| !letter.is_alphanumeric()));
    // A symbol or a name of a method has a capital letter, a digit or one letter only.
    let is_word = |word: &&str| {
        word.len() > 1 && word.chars().all(|letter| letter.is_ascii_lowercase() || letter == '-')
    };
    words
        .filter(is_word)
        .filter(|word| !SYMBOLS.contains(word) && !allowed.contains(word))
        .map(str::to_owned)
        .collect()
}

/// Holds each text in both languages: it differs from English, and has no English words.
fn hold<'a>(texts: impl IntoIterator<Item = &'a Text>, allowed: &[&str]) {
    for text in texts {
        for code in &LANGUAGES[1..] {
            let shown = text.render(Language::find(code).unwrap_or_else(|| panic!("{code}")));
            let left = english(&shown, allowed);
            assert!(left.is_empty(), "{code}: {left:?} in \"{shown}\"");
        }
    }
}

/// A fault of the syntax takes a text away, and nothing else tells.
#[test]
fn every_linked_text_is_read() {
    let mut count = 0;
    for resource in assur_words::inventory::iter::<assur_words::Resource> {
        let language = Language::find(resource.language).unwrap();
        let heads =
            resource.texts.lines().filter(|line| line.starts_with(|letter: char| letter.is_alphabetic()));
        for id in heads.filter_map(|line| line.split_once(" =")).map(|(id, _)| id) {
            assert!(
                language.own(id).is_some(),
                "{} of {} has a fault: `{id}`",
                resource.language,
                resource.crate_name
            );
            count += 1;
        }
    }
    assert!(count > 1000);
}

#[test]
fn english_words_are_seen() {
    assert_eq!(english("звено `rod` на ground, J(q), sin(phi2), TestPf", &[]), ["ground"]);
    assert!(english("PF0, 4A, t = 1 с; радиус [input] \"turn\" dopri5", &[]).is_empty());
}

#[test]
fn plugins_describe_themselves() {
    let mut all = Vec::new();
    for kind in assur_group::groups().unwrap() {
        all.extend([&kind.summary, &kind.singular, &kind.ways.words, &kind.force_angle.words, &kind.source]);
    }
    for method in assur_force::analyzers().unwrap() {
        all.extend([&method.summary, &method.source]);
    }
    for method in assur_integrator::integrators().unwrap() {
        all.extend([&method.summary, &method.source]);
    }
    // Where numbers are printed is quoted as it is printed: authors, makers, titles.
    let catalogues = assur_motor::catalogues().unwrap();
    all.extend(catalogues.iter().map(|catalogue| &catalogue.summary));
    all.extend(assur_motor::USUAL_UNEVENNESS.iter().map(|usual| &usual.machine));
    assert!(all.len() > 70);
    hold(all, &[]);
}

#[test]
fn reasons_for_a_method_and_refusals() {
    let mut all = Vec::new();
    for [constant, q, w, t] in (0..16).map(|bits| [0, 1, 2, 3].map(|bit| bits >> bit & 1 == 1)) {
        let dependence = Dependence {
            inertia_constant: constant,
            moment_on_coordinate: q,
            moment_on_speed: w,
            moment_on_time: t,
            ..Dependence::default()
        };
        all.push(dependence.describe());
        for method in assur_integrator::integrators().unwrap() {
            let suits = (method.suitability)(&dependence, 1e-9);
            all.push(suits.map_or_else(|why| why, |suits| suits.reason));
        }
        all.push(assur_integrator::choose("auto", &dependence, 1e-6).unwrap().first.reason);
    }
    hold(&all, &[]);
}

#[test]
fn errors_of_an_integrator() {
    let at = State { time: 1e9, coordinate: -0.5, speed: f64::NAN };
    let source = || MotionError::Inertia(-1.5e-7);
    let request = |until, step| Request {
        fixed_step: step,
        ..Request::new(State { time: 0.0, coordinate: 1.0, speed: 2.0 }, until)
    };
    let refused = [
        Request { tolerance: 0.0, ..request(Until::Turn, None) },
        Request { samples: 0, ..request(Until::Rest, None) },
        Request { time_limit: -1.0, ..request(Until::Turn, None) },
        Request { initial: at, ..request(Until::Turn, None) },
        request(Until::Turn, Some(FixedStep::Time(-1.0))),
        request(Until::Time(-1.0), None),
        request(Until::Coordinate(1.0), None),
        request(Until::Coordinate(1.0 + 1e-15), None),
        request(Until::Coordinate(f64::INFINITY), None),
    ];
    let mut all: Vec<Text> = refused.iter().map(|request| request.check().unwrap_err().describe()).collect();
    let steps = |stiffness| IntegrationError::TooManySteps { at, steps: 21, step: 1e-9, stiffness };
    let errors = [
        steps(None),
        steps(Some(0.1)),
        steps(Some(3.3)),
        IntegrationError::StepTooSmall { at, step: 1e-15 },
        IntegrationError::Unstable { at, step: 0.1, product: 5.0, allowed: 2.8 },
        IntegrationError::EndOfRange { at, source: source() },
        IntegrationError::Equation { at, source: MotionError::OutOfRange },
        IntegrationError::Equation { at, source: MotionError::NotFinite { inertia: 0.0, moment: f64::NAN } },
        IntegrationError::EmptyPiece { at },
        IntegrationError::NoMethod(Dependence::default()),
        IntegrationError::Registry(RegistryError::Empty(text!("integrator-sort"))),
    ];
    all.extend(errors.iter().map(Describe::describe));
    let why = ["integrator-creeps", "integrator-swings", "integrator-endless", "integrator-rests"];
    for (why, until) in
        why.into_iter().zip([Until::Time(1.0), Until::Coordinate(2.0), Until::Turn, Until::Rest])
    {
        let why = Text::message(why, Vec::new());
        all.push(IntegrationError::NotReached { goal: until, at, why }.describe());
    }
    hold(&all, &[]);
}

#[test]
fn errors_of_groups_positions_and_loads() {
    let gap = GroupError::NoAssembly { gap_m: 12.0 };
    let groups = [
        gap,
        GroupError::Singular { health: 1e-17 },
        GroupError::Singular { health: f64::NAN },
        GroupError::SingularStart { health: 0.0 },
        GroupError::Unfit { links: 2, pairs: 4 },
        GroupError::Unfit { links: 12, pairs: 18 },
    ];
    let mut all: Vec<Text> = groups.iter().map(Describe::describe).collect();
    let group = text!("structure-group", number = 1, kind = name("RRR"), links = name("А"));
    let position = |range, kind| {
        let (group_name, index) = (Box::new(group.clone()), Some(3));
        PositionError {
            group: 0,
            group_name,
            index,
            coordinate: 1.0,
            kind,
            source: gap,
            range,
            elsewhere: range.map(Box::new),
            by_default: None,
            parallel: None,
        }
    };
    let positions = [(None, Angle), (Some([0.1, 0.2]), Length), (Some([0.0, 2.0]), Time)];
    all.extend(positions.map(|(range, kind)| position(range, kind).describe()));
    let source = BuildError::new(text!("group-rrr-no-link", link = 1));
    all.push(CompileError::Build { group: Box::new(group.clone()), source, link: None }.describe());
    let load = || name("Б");
    let function = || "sign".to_owned();
    let loads = [
        LoadFault::NeedsMotion(text!("force-damping")),
        LoadFault::StrokeOfMoment,
        LoadFault::NoStroke(1e-9),
        LoadFault::InfiniteStroke(1.0),
        LoadFault::NotFinite(1.0),
        LoadFault::UnlocatedSliding,
        LoadFault::ChangesTooOften { function: function(), column: 7, most: 10 },
        LoadFault::NoPosition(1.0, Box::new(position(None, Angle))),
    ];
    all.extend(loads.map(|fault| LoadError { load: load(), fault }.describe()));
    let lines = text!("force-longitudinal-lines-guide", crank = name("А"), third = name("Б"));
    let forces = [
        ForceError::ChangePoint(1.0),
        ForceError::Group { group, coordinate: 1.0, source: gap },
        ForceError::Singular { coordinate: 1.0, health: 1e-17 },
        ForceError::IdleBalance { load: load(), coordinate: 1.0, share: 0.0 },
        ForceError::Parallel { coordinate: 1.0, lines, angle: 1e-9, instead: "longitudinal" },
        ForceError::Unsupported { analyzer: "groups", reason: load() },
    ];
    all.extend(forces.iter().map(Describe::describe));
    hold(&all, &[]);
}

#[test]
fn errors_and_warnings_of_motors() {
    let table = |rows: &str| {
        let head =
            "designation,poles,rated_power_kw,synchronous_speed_rpm,rated_speed_rpm,max_torque_ratio,source";
        parse_table("4A", &format!("{head}\n{rows}"))
    };
    let rows =
        table("4A100,4,1.1,1500,1410,2,p1\n4A100 K,4,1.1,1500,1410,,p1\n4A100 L,4,1.1,1500,1410,,p1\n")
            .unwrap();
    let mut all = Vec::new();
    // Nothing alike, something alike, a power, several of one type.
    for (rows, designation) in [(&rows[..], "7"), (&rows, "4A100M"), (&rows, "1.1 kW"), (&rows[1..], "4A100")]
    {
        let error = find_designation(rows, designation, &text!("motor-in-any-catalogue")).unwrap_err();
        all.push(error.describe());
    }
    all.push(assur_motor::find_catalogue("Б").unwrap_err().describe());
    let most = Some(100.0);
    let requests = [
        (&rows[..], -1.0, None),
        (&[], 1.0, None),
        (&rows[1..], 1.0, None),
        (&rows, 1.0, most),
        (&rows, 9e9, None),
    ];
    for (rows, required_power, max_motor_speed) in requests {
        let (input_speed, characteristic) = (1.0, CharacteristicKind::Kloss);
        let request = SelectionRequest { required_power, input_speed, max_motor_speed, characteristic };
        all.push(select(rows, &request).unwrap_err().describe());
    }
    let good = rows[0].rated_data();
    let data = [
        RatedMotor { inertia: Some(0.0), ..good },
        RatedMotor { rated_speed: 200.0, ..good },
        RatedMotor { max_torque_ratio: Some(0.5), ..good },
        RatedMotor { max_torque_ratio: None, ..good },
    ];
    let refused = |data| Characteristic::new(CharacteristicKind::Kloss, data).unwrap_err().describe();
    all.extend(data.iter().map(refused));
    let identities: BTreeSet<_> = all.iter().map(Text::identity).collect();
    assert_eq!(identities.len(), 12, "{identities:?}");
    let kloss = Characteristic::new(CharacteristicKind::Kloss, &good).unwrap();
    let warnings = [
        check_breakdown(&kloss, [0.0]),
        check_starting(&kloss, None, 1e3),
        check_rms(&kloss, 1e3),
        check_rotor_inertia(None, name("4A100")),
    ];
    all.extend(warnings.into_iter().flatten().map(|warning| warning.text));
    hold(&all, &[]);
}

/// A scene's results with all checks.
fn calculated(scene: &str) -> Analysis {
    let mechanism = assur_scene::read("scene.toml", scene).unwrap_or_else(|error| panic!("{error}"));
    let found = Calculation::of(mechanism, &Options::default(), &mut unwatched)
        .unwrap_or_else(|error| panic!("{error}"));
    let mut analysis = found.analyze(&mut unwatched).unwrap_or_else(|error| panic!("{error}"));
    let checks = found.checks(Coverage::Sample, &mut unwatched);
    analysis.add_checks(checks.unwrap_or_else(|error| panic!("{error}")));
    analysis
}

#[test]
fn checks_notes_and_failures_of_shipped_scenes() {
    let mut checks = std::collections::BTreeSet::new();
    for scene in ["slider-crank", "shaper-drive", "run-up"] {
        let text = assur_fixtures::scene(scene);
        let allowed: Vec<&str> =
            text.split(|letter: char| !(letter.is_alphanumeric() || "-_".contains(letter))).collect();
        let found = calculated(text);
        let methods = assur_force::analyzers().unwrap();
        let allowed: Vec<&str> =
            allowed.into_iter().chain(methods.iter().map(|method| method.name)).collect();
        let told = found
            .checks
            .iter()
            .flat_map(|check| [&check.name, &check.finding.place, &check.reason, &check.finding.why]);
        hold(told, &allowed);
        hold(
            found
                .warnings
                .iter()
                .map(|note| &note.text)
                .chain(found.failures.iter().map(|failure| &failure.message)),
            &allowed,
        );
        checks.extend(found.checks.iter().map(|check| check.name.to_string()));
    }
    assert!(checks.len() >= 10, "{checks:?}");
}
