//! What stands in the mechanism, by hand from the files.

#![expect(clippy::float_cmp, reason = "numbers that stand in the file are read to the last bit")]

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq as close;
use assur_mechanism::{
    Balance, CharacteristicKind, Direction, FlywheelPlace, InputPair, LawTable, Mechanism, Motion,
    MotorChoice, Over, PairId, Range, Sense, Shape, Solve, StepLength, Torque, Until, Value,
};

use super::{BASE, fixture, fixtures, steady};
use crate::{STARTER, read};

fn good(text: &str) -> Mechanism {
    read("scene.toml", text).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn every_fixture_and_the_starter_read() {
    assert!(fixtures().len() >= 13);
    for (name, text) in fixtures() {
        read(&name, &text).unwrap_or_else(|errors| panic!("{errors}"));
    }
    let starter = good(STARTER);
    assert_eq!(starter.links.len(), 4);
    assert_eq!(starter.slides[0].name, "piston/ground");
}

#[test]
fn links_points_and_slides_of_the_shaper() {
    let scene = fixture("shaper.toml");
    let names: Vec<&str> = scene.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(names, ["ground", "crank", "stone2", "rocker", "stone4", "ram"]);
    let points: Vec<&str> = scene.points.iter().map(|point| point.name.as_str()).collect();
    assert_eq!(points, ["O", "C", "A", "S3", "D", "E", "K"]);
    assert_eq!(scene.gravity, Some([0.0, -9.81]));
    assert_eq!(scene.points[1].places[0].at, [0.0, -0.4]);
    let pins: Vec<&str> =
        scene.points.iter().filter(|point| point.is_pin()).map(|point| point.name.as_str()).collect();
    assert_eq!(pins, ["O", "C", "A", "D"]);
    assert_eq!(
        (scene.links[3].mass, scene.links[3].center, scene.links[3].inertia.constant()),
        (12.0, [0.375, 0.0], 0.6)
    );
    assert_eq!(scene.links[2].center, [0.0, 0.0]);
    assert_eq!(scene.links[5].center, [0.1, 0.02]);
    let slides: Vec<_> =
        scene.slides.iter().map(|slide| (slide.name.as_str(), slide.link, slide.on)).collect();
    assert_eq!(slides, [("stone2/rocker", 2, 3), ("stone4/ram", 4, 5), ("ram/ground", 5, 0)]);
    assert_eq!(scene.slides[1].angle, PI / 2.0);
    assert_eq!(scene.slides[2].through, [0.0, 0.27]);
    assert_eq!(scene.assembly, [(4, [0.17, 0.28])]);
}

#[test]
fn a_place_of_a_point_on_the_ground_may_be_told_too() {
    let scene = good(&BASE.replace("B = [0, 0.23]", "B = [0, 0.23]\nO = [0, 0]"));
    let names = scene.assembly.iter().map(|(point, place)| (scene.points[*point].name.as_str(), *place));
    assert!(names.eq([("B", [0.0, 0.23]), ("O", [0.0, 0.0])]));
}

/// The law of the first load.
fn first_law(scene: &Mechanism) -> Value {
    scene.loads[0].kind.law().expect("a load with a law").clone()
}

#[test]
fn input_motion_and_force_of_the_shaper() {
    let scene = fixture("shaper.toml");
    assert_eq!(
        (scene.input.first().link, scene.input.first().pair, scene.input.positions),
        (1, InputPair::Pin(0), 48)
    );
    assert_eq!((scene.input.range, scene.input.direction), (Range::Cycle(TAU), Sense::Ccw));
    assert_eq!(scene.motion, Some(Motion::Prescribed { speed: TAU, acceleration: 0.0 }));
    let force = scene.loads[0].kind.force().unwrap();
    assert_eq!((scene.loads[0].name.as_str(), force.at.link, force.at.at), ("cutting", 5, [0.25, -0.05]));
    assert_eq!(force.direction, Direction::Ground(0.0));
    let forward = LawTable {
        rows: vec![[0.05, 0.0], [0.05, 1500.0], [0.95, 1500.0], [0.95, 0.0]],
        shape: Shape::Linear,
    };
    assert_eq!(force.value, Value::Stroke { axis: PI, forward, back: LawTable::constant(0.0) });
}

#[test]
fn drive_of_the_shaper() {
    let scene = fixture("shaper-drive.toml");
    assert_eq!(scene.motion, Some(Motion::Steady { mean_speed: TAU, unevenness: Some(Solve::Given(0.05)) }));
    let drive = scene.drive.unwrap();
    assert_eq!((drive.ratio, drive.efficiency), (Solve::Wanted, 0.95));
    assert_eq!((drive.flywheel, drive.flywheel_on), (Some(Solve::Wanted), FlywheelPlace::Crank));
    let Torque::Motor { motor: MotorChoice::Rated(motor), catalogue: None, max_speed: None, characteristic } =
        drive.torque
    else {
        panic!("{:?}", drive.torque)
    };
    assert_eq!(characteristic, CharacteristicKind::Kloss);
    assert_eq!((motor.power, motor.max_torque_ratio, motor.inertia), (1100.0, Some(2.2), Some(0.0045)));
    close!(motor.synchronous_speed, 50.0 * PI, max_relative = 1e-15);
    close!(motor.rated_speed, 47.0 * PI, max_relative = 1e-15);
}

/// `w` is the speed along the direction of the input, as in a table over the speed; `q` is the coordinate itself.
#[test]
fn the_speed_of_a_formula_is_counted_along_the_direction() {
    use assur_formula::Variables;
    let at = Variables { coordinate: 3.0, speed: -10.0, ..Variables::default() };
    for (direction, wanted) in [("cw", 13.0), ("ccw", -7.0)] {
        let text = fixtures().into_iter().find(|(name, _)| name == "run-up.toml").unwrap().1;
        let text = text.replace("value = -10", "value = { formula = \"q + w\", unit = \"N*m\" }").replace(
            "link = \"AB\"\n\n[motion]",
            &format!("link = \"AB\"\ndirection = \"{direction}\"\n\n[motion]"),
        );
        let scene = read("test", &text).unwrap();
        let moment = scene.loads.iter().filter_map(|load| load.kind.moment()).nth(1).unwrap();
        let Value::Formula { formula, .. } = &moment.value else { panic!() };
        close!(formula.value(&at), wanted);
    }
}

/// The unevenness by the motor needs a motor, and a flywheel that is to be found.
#[test]
fn the_unevenness_by_the_motor_needs_a_drive_for_it() {
    let text = fixtures().into_iter().find(|(name, _)| name == "shaper-drive.toml").unwrap().1;
    let text = text.replace("unevenness = 0.05", "unevenness = \"motor\"");
    let Some(Motion::Steady { unevenness, .. }) = read("test", &text).unwrap().motion else { panic!() };
    assert_eq!(unevenness, Some(Solve::Wanted));
    let (without, _) = text.split_once("[drive]").unwrap();
    for scene in [without.to_owned(), text.replace("flywheel = \"solve\"", "flywheel = 2")] {
        let error = read("test", &scene).unwrap_err().to_string();
        assert!(error.contains("`unevenness = \"motor\"` needs a [drive] with a motor"), "{error}");
    }
}

#[test]
fn steps_are_times_or_displacements() {
    let text = fixtures().into_iter().find(|(name, _)| name == "run-up.toml").unwrap().1;
    for (step, wanted) in [
        ("\"1 ms\"", Some(StepLength::Time(1e-3))),
        ("0.5", Some(StepLength::Time(0.5))),
        ("\"2 rad\"", Some(StepLength::Way(2.0))),
    ] {
        let scene = read("test", &format!("{text}\nstep = {step}\n")).unwrap();
        let Some(Motion::Transient { step: found, .. }) = scene.motion else { panic!() };
        assert_eq!(found, wanted);
    }
    let error = read("test", &format!("{text}\nstep = \"1 kg\"\n")).unwrap_err().to_string();
    assert!(
        error.contains(
            "`step` wants a time (s, ms, min, h) or an angle (rad, mrad, deg, rev), got `kg`, a mass"
        ),
        "{error}"
    );
}

#[test]
fn ends_of_transient_motions() {
    let Some(Motion::Transient { speed, until, samples, integrator, tolerance, step: None, max_steps: None }) =
        fixture("andrews.toml").motion
    else {
        panic!()
    };
    assert_eq!(
        (speed, until, samples, integrator.as_str(), tolerance),
        (0.0, Until::Time(0.03), 4, "auto", 1e-9)
    );
    let motion = |name| match fixture(name).motion {
        Some(Motion::Transient { speed, until, samples, .. }) => (speed, until, samples),
        other => panic!("{other:?}"),
    };
    assert_eq!(motion("run-up.toml"), (0.0, Until::Way(5.0 * TAU), 100));
    assert_eq!(motion("brake.toml"), (100.0, Until::Rest, 100));
    assert_eq!(motion("n-four-bar-2.toml"), (-1.0, Until::Time(10.0), 400));
}

#[test]
fn a_range_against_the_clock_keeps_the_direction_of_the_scene() {
    let scene = fixture("press.toml");
    close!(scene.input.from, -70.0 * PI / 180.0, max_relative = 1e-15);
    let Range::To(to) = scene.input.range else { panic!() };
    close!(to, -110.0 * PI / 180.0, max_relative = 1e-15);
    assert_eq!((scene.input.positions, scene.input.sign()), (33, -1.0));
    let Some(Motion::Prescribed { speed, .. }) = scene.motion else { panic!() };
    close!(speed, -PI / 3.0, max_relative = 1e-15);
    let contact = scene.loads[0].kind.contact().unwrap();
    assert_eq!((contact.center.link, contact.center.at, contact.radius), (2, [-0.64, 0.0], 0.75));
    assert_eq!((&contact.force, contact.friction, contact.during), (&Value::Constant(20_000.0), 0.1, None));
    assert_eq!((scene.loads[0].name.as_str(), contact.against_sliding), ("contact 1 on rod", false));
    let scene = fixture("press-compression.toml");
    let found = scene.loads[0].kind.contact().unwrap();
    assert_eq!((found.friction, found.against_sliding), (0.1, true));
}

#[test]
fn direction_cw_turns_speed_and_acceleration() {
    let scene = fixture("conveyor.toml");
    let Some(Motion::Prescribed { speed, acceleration }) = scene.motion else { panic!() };
    close!(speed, -2.5 * PI, max_relative = 1e-15);
    assert_eq!(acceleration, 0.0);
    assert_eq!(scene.loads[0].kind.force().unwrap().direction, Direction::AgainstMotion);
    assert_eq!(scene.loads[0].name, "force 1 on trough");
    assert_eq!(scene.links[3].center, [0.17, 0.01]);
    let text = BASE.replace("speed = \"900 rpm\"", "speed = 3\nacceleration = 2");
    let scene = good(&text.replace("positions = 24", "direction = \"cw\""));
    assert_eq!(scene.motion, Some(Motion::Prescribed { speed: -3.0, acceleration: -2.0 }));
}

#[test]
fn a_table_over_the_speed_counts_it_along_the_direction() {
    let value = |table: &str| {
        let text = BASE.replace("value = 700", &format!("value = {{ over = \"speed\", {table} }}"));
        match first_law(&good(&text.replace("positions = 24", "direction = \"cw\""))) {
            Value::Table { over: Over::Speed, table, .. } => table,
            other => panic!("{other:?}"),
        }
    };
    let lines = value("table = [[0, 60], [5, 40], [5, 20], [8, 0]]");
    let steps = value("table = [[0, 60], [5, 40], [8, 0]], shape = \"step\"");
    for (along, line, step) in [(-1.0, 60.0, 60.0), (2.5, 50.0, 60.0), (6.5, 10.0, 40.0), (9.0, 0.0, 0.0)] {
        assert_eq!((lines.at(-along), steps.at(-along)), (line, step), "{along}");
    }
}

#[test]
fn loads_in_links_springs_and_tables() {
    let scene = fixture("stephenson3.toml");
    close!(scene.slides[0].tilt, 25.0 * PI / 180.0, max_relative = 1e-15);
    let force = scene.loads[0].kind.force().unwrap();
    assert!(matches!(force.direction, Direction::Link(angle) if (angle + PI / 3.0).abs() < 1e-15));
    let last = scene.loads.last().unwrap();
    let spring = last.kind.spring().unwrap();
    assert_eq!((spring.ends[0].link, spring.ends[0].at), (0, [0.5, 0.05]));
    assert_eq!((spring.ends[1].link, spring.ends[1].at), (5, [0.05, 0.1]));
    assert_eq!((spring.stiffness, spring.length, spring.damping), (800.0, 0.3, 25.0));
    assert_eq!(last.name, "spring 1");
    let table = LawTable { rows: vec![[0.0, 0.0], [PI, 40.0], [TAU, 0.0]], shape: Shape::Linear };
    let law = first_law(&fixture("flywheel.toml"));
    assert_eq!(law, Value::Table { over: Over::Coordinate, table, repeat: true });
    assert!(matches!(first_law(&fixture("run-up.toml")), Value::Table { repeat: false, .. }));
}

#[test]
fn a_sliding_input_is_measured_in_meters() {
    let text = BASE
        .replace("link = \"crank\"\npositions = 24", "link = \"piston\"\nfrom = \"300 mm\"\nto = \"200 mm\"");
    let text = text.replace("\"900 rpm\"", "\"0.2 m/s\"").replace("\"180 deg\"", "\"80 mm\"");
    let scene = good(&text.replace("[\"-30 deg\", \"30 deg\"]", "[\"200 mm\", 0.25]"));
    assert_eq!(scene.input.first().pair, InputPair::Slide(0));
    assert_eq!((scene.input.from, scene.input.range), (0.3, Range::To(0.2)));
    assert_eq!(scene.motion, Some(Motion::Prescribed { speed: 0.2, acceleration: 0.0 }));
    let contact = scene.loads.iter().find_map(|load| load.kind.contact()).unwrap();
    assert_eq!(contact.during, Some([0.2, 0.25]));
    // A range of a sliding input is no cycle, so that nothing can repeat with it.
    let moment = scene.loads.iter().find_map(|load| load.kind.moment()).unwrap();
    assert!(matches!(moment.value, Value::Table { repeat: false, .. }));
}

#[test]
fn scale_is_a_factor_on_the_size_of_every_sort_of_load() {
    let loads = |scale: &str| {
        let text = BASE.to_owned()
            + &format!(
                "[[force]]\nlink = \"rod\"\nat = \"B\"\nangle = 0\nvalue = \"2 kN\"\n{scale}\n\
                 [[force]]\nlink = \"rod\"\nat = \"B\"\nangle = 0\n{scale}\nvalue = {{ over = \"stroke\", axis = 0, forward = [[0, 1], [1, 3]], back = 5 }}\n\
                 [[moment]]\nlink = \"rod\"\n{scale}\nvalue = {{ formula = \"q\", unit = \"kN*m\" }}\n\
                 [[brake]]\nlink = \"crank\"\n{scale}\nradius = 0.1\nfriction = 0.2\nforce = {{ over = \"time\", table = [[0, 10], [1, 20]] }}\n\
                 [[contact]]\nlink = \"rod\"\n{scale}\ncenter = \"B\"\nradius = 0.1\nangle = 0.5\nforce = 40\n"
            );
        let scene = good(&text);
        let forces: Vec<_> = scene.loads.iter().filter_map(|load| load.kind.force()).collect();
        let moment = scene.loads.iter().filter_map(|load| load.kind.moment()).next_back().unwrap();
        let brake = scene.loads.iter().find_map(|load| load.kind.brake()).unwrap();
        let contact = scene.loads.last().unwrap().kind.contact().unwrap();
        assert_eq!(contact.angle, Value::Constant(0.5), "an angle is no size");
        let [.., one, other] = forces[..] else { panic!() };
        let values = [&one.value, &other.value, &moment.value, &brake.force, &contact.force];
        values.map(|value| value.sizes().collect::<Vec<f64>>())
    };
    let plain = [vec![2000.0], vec![1.0, 3.0, 5.0], vec![1000.0], vec![10.0, 20.0], vec![40.0]];
    assert_eq!(loads(""), plain);
    assert_eq!(loads("scale = 1"), plain);
    let halves = [vec![-1000.0], vec![-0.5, -1.5, -2.5], vec![-500.0], vec![-5.0, -10.0], vec![-20.0]];
    assert_eq!(loads("scale = -0.5"), halves);
    let text = BASE.to_owned() + "[[moment]]\nlink = \"rod\"\nvalue = 1e12\nscale = 1e12\n";
    let errors = read("scene.toml", &text).unwrap_err();
    assert!(errors.to_string().contains("`scale` makes the size of the load"), "{errors}");
}

#[test]
fn wishes_and_the_other_drives() {
    let text = steady()
        + "[balance]\nlink = \"piston\"\nat = [0, \"10 mm\"]\nangle = \"90 deg\"\n"
        + "[output]\npoints = [\"S2\"]\nlinks = [\"rod\"]\nslides = [\"piston/ground\"]\nreactions = [\"A\", \"piston/ground\"]\n"
        + "[drive]\nmotor = \"4A100L4\"\ncatalogue = \"4A\"\nmax_motor_speed = \"1500 rpm\"\ncharacteristic = \"linear\"\nratio = 25\nflywheel = 3\nflywheel_on = \"motor\"\n";
    let scene = good(&text);
    assert!(
        matches!(scene.balance, Some(Balance::Force { at, angle }) if at.link == 3 && at.at == [0.0, 0.01] && angle == PI / 2.0)
    );
    let output = scene.output.unwrap();
    assert_eq!((output.points, output.links, output.slides), (vec![3], vec![2], vec![0]));
    assert_eq!(output.reactions, [PairId::Pin(2), PairId::Slide(0)]);
    let drive = scene.drive.unwrap();
    assert_eq!(
        (drive.ratio, drive.efficiency, drive.flywheel),
        (Solve::Given(25.0), 1.0, Some(Solve::Given(3.0)))
    );
    assert_eq!(drive.flywheel_on, FlywheelPlace::Motor);
    let Torque::Motor { motor, catalogue, max_speed, characteristic } = drive.torque else { panic!() };
    assert_eq!((motor, catalogue.as_deref()), (MotorChoice::Designation("4A100L4".to_owned()), Some("4A")));
    close!(max_speed.unwrap(), 50.0 * PI, max_relative = 1e-15);
    assert_eq!(characteristic, CharacteristicKind::Linear);
    let torque = |line: &str| good(&(steady() + "[drive]\n" + line)).drive.unwrap().torque;
    assert_eq!(torque("torque = \"balance\""), Torque::Balance);
    assert_eq!(torque("torque = \"25 N*m\""), Torque::Constant(25.0));
    assert_eq!(torque("flywheel = 2"), Torque::None);
    assert!(matches!(torque("motor = \"auto\""), Torque::Motor { motor: MotorChoice::Auto, .. }));
}

#[test]
fn tables_over_time_speed_and_steps() {
    let value = |text: &str| first_law(&good(&BASE.replace("value = 700", &format!("value = {text}"))));
    let table = LawTable { rows: vec![[0.0, 1.0], [0.5, 2000.0]], shape: Shape::Step };
    let read = value("{ over = \"time\", table = [[0, 1], [\"500 ms\", \"2 kN\"]], shape = \"step\" }");
    assert_eq!(read, Value::Table { over: Over::Time, table, repeat: false });
    let read = value("{ over = \"speed\", table = [[0, 60], [\"60 rpm\", 0]] }");
    let table = LawTable { rows: vec![[0.0, 60.0], [TAU, 0.0]], shape: Shape::Linear };
    assert_eq!(read, Value::Table { over: Over::Speed, table, repeat: false });
}

#[test]
fn order_is_that_of_the_file_not_of_the_alphabet() {
    let scene = good(
        "[link.z]\npoints = { b = 0, a = 1 }\n[link.c]\npoints = { a = 2 }\n[ground]\npoints = { q = 0, b = 0 }\n[input]\nlink = \"z\"",
    );
    let links: Vec<&str> = scene.links.iter().map(|link| link.name.as_str()).collect();
    let points: Vec<&str> = scene.points.iter().map(|point| point.name.as_str()).collect();
    assert_eq!((links, points), (vec!["ground", "z", "c"], vec!["q", "b", "a"]));
    assert_eq!((scene.input.positions, scene.motion, scene.title.as_str()), (12, None, ""));
}

#[test]
fn a_slide_leads_the_first_point_of_its_link() {
    let text = BASE.replace("points = { B = 0 }", "points = { T = [0.1, 0.2], B = 0 }\ncenter = \"B\"");
    assert_eq!(good(&text).slides[0].point, [0.1, 0.2]);
    let text = text.replace("angle = \"90 deg\"\n", "angle = \"90 deg\"\npoint = \"B\"\nthrough = \"C\"\n");
    assert_eq!((good(&text).slides[0].point, good(&text).slides[0].through), ([0.0, 0.0], [0.0, -0.4]));
}

#[test]
fn numbers_beyond_all_measure_are_refused() {
    for (given, words) in [
        ("1e308", "`mass` is too large: `1e308`, at most 1e12 kg"),
        ("\"1e10 t\"", "`mass` is too large: `1e10 t`"),
        ("1e-320", "`mass` is too small: `1e-320`, at least 1e-30 kg or 0"),
    ] {
        let text = BASE.replacen("\"3 kg\"", given, 1);
        let shown = crate::read("huge.toml", &text).unwrap_err().to_string();
        assert!(shown.contains(words), "{shown}");
    }
    assert!(crate::read("large.toml", &BASE.replacen("\"3 kg\"", "1e12", 1)).is_ok());
}

#[test]
fn a_formula_has_a_unit_and_faults_with_their_column() {
    let with = |value: &str| BASE.replace("value = 700", &format!("value = {value}"));
    let law = first_law(&good(&with("{ formula = \"2*q\", unit = \"kN\" }")));
    let Value::Formula { formula, factor, axis } = law else { panic!() };
    assert_eq!((formula.text(), factor, axis), ("2*q", 1000.0, None));
    let fault = |value: &str| {
        let text = with(value);
        let errors = read("a.toml", &text).unwrap_err();
        let start = text.find(value).unwrap();
        let line_start = text[..start].rfind('\n').unwrap() + 1;
        (errors.errors[0].message.to_string(), errors.errors[0].column - 1 - (start - line_start))
    };
    let (message, column) = fault("{ formula = \"2*speed\" }");
    assert!(message.contains("`speed` is unknown"), "{message}");
    assert_eq!(column, 15);
    assert_eq!(fault("{ formula = '2*(q' }").1, 17);
    assert!(fault("{ formula = \"q\", unit = \"N*m\" }").0.contains("wants a force"));
    assert!(fault("{ formula = \"x\" }").0.contains("needs `axis`"));
    assert!(fault("{ formula = \"q\", axis = 0 }").0.contains("no use"));
    assert!(fault("{ formula = \"q\", table = 0 }").0.contains("unknown key"));
}

#[test]
fn friction_against_the_sliding_is_a_table_of_one_number() {
    let shipped = fixtures();
    let press = &shipped.iter().find(|(name, _)| name.starts_with("press-compression")).unwrap().1;
    let formula = "{ formula = \"8*(-70*pi/180 - q)*9/(2*pi)\", unit = \"deg\" }";
    let refused = |friction: &str, angle: &str| {
        let text = press.replace("{ against_sliding = 0.1 }", friction).replace(formula, angle);
        read("test.toml", &text).unwrap_err().to_string()
    };
    assert!(refused("{ against_sliding = -0.1 }", "0").contains("`against_sliding`"));
    assert!(refused("{ against = 0.1 }", "0").contains("unknown key `against`"));
    assert!(refused("{}", "0").contains("friction against the sliding needs `against_sliding`"));
    let follows = "{ over = \"time\", table = [[0, 0], [1, 0.1]] }";
    assert!(
        refused("{ against_sliding = 0.1 }", follows)
            .contains("`angle` depends on more than the input coordinate")
    );
    assert!(refused("{ against_sliding = 0.1 }", "{ formula = \"0.01*w\" }").contains("depends on more"));
    let table = "{ over = \"angle\", table = [[-2, 0.1], [-1, 0]] }";
    let scene = read("test.toml", &press.replace(formula, table)).unwrap();
    assert!(scene.loads[0].kind.contact().unwrap().against_sliding);
}
