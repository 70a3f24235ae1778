//! The task: the mechanism as it is given.

use assur_mechanism::{Drive, Mechanism, Motion, Motor, Solve, Torque};

use super::Context;
use super::document::Block;
use super::loads::{self, number};
use crate::screen::state::View;
use crate::words::Words;

/// Page of a mechanism, mm.
const MECHANISM: [f64; 2] = [160.0, 110.0];

/// Heading, data of links, pairs, loads, motion and drive, and the mechanism drawn, moving.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let Some(scene) = &context.state.scene else { return Vec::new() };
    let mechanism = &scene.linkage.mechanism;
    let input = &mechanism.links[mechanism.input.link].name;
    let values = [("positions", mechanism.input.positions.to_string()), ("link", input.to_string())];
    let mut blocks = vec![Block::Heading(words.get("task")), Block::Text(words.with("task-text", &values))];
    let mut table = |caption: &str, head: &[&str], rows: Vec<Vec<String>>| {
        if !rows.is_empty() {
            blocks.push(Block::table(words, caption, head.iter().map(|id| words.get(id)), rows));
        }
    };
    table("points-of-links", &["link", "point", "x-mm", "y-mm"], points(words, mechanism));
    table("slides", &["pair", "link", "guide", "through", "direction"], slides(words, mechanism));
    table("masses", &["link", "mass", "center", "inertia"], masses(words, mechanism));
    table("loads", &["load", "what-acts", "value"], loads::rows(words, mechanism));
    table("motion-and-drive", &["quantity", "value", "unit"], motion(words, mechanism));
    blocks.extend(moving(context));
    blocks
}

fn mm(words: &Words, at: [f64; 2]) -> String {
    at.map(|x| number(words, 1e3 * x)).join("; ")
}

fn points(words: &Words, mechanism: &Mechanism) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for (link, of) in mechanism.links.iter().enumerate() {
        for (id, point) in mechanism.points.iter().enumerate() {
            if let Some(at) = mechanism.place_in(id, link) {
                let [x, y] = at.map(|x| number(words, 1e3 * x));
                rows.push(vec![words.name(&of.name), point.name.to_string(), x, y]);
            }
        }
    }
    rows
}

fn slides(words: &Words, mechanism: &Mechanism) -> Vec<Vec<String>> {
    let row = |slide: &assur_mechanism::Slide| {
        let [link, on] = [slide.link, slide.on].map(|link| words.name(&mechanism.links[link].name));
        let angle = number(words, slide.angle.to_degrees());
        vec![words.name(&slide.name), link, on, mm(words, slide.through), angle]
    };
    mechanism.slides.iter().map(row).collect()
}

fn masses(words: &Words, mechanism: &Mechanism) -> Vec<Vec<String>> {
    let heavy = mechanism.links.iter().filter(|link| link.mass > 0.0 || link.inertia > 0.0);
    heavy
        .map(|link| {
            let [mass, inertia] = [link.mass, link.inertia].map(|value| number(words, value));
            vec![link.name.to_string(), mass, mm(words, link.center), inertia]
        })
        .collect()
}

/// What the scene says about motion and drive.
fn motion(words: &Words, mechanism: &Mechanism) -> Vec<Vec<String>> {
    let angular = mechanism.input.is_angle();
    let [speed_unit, acceleration_unit] = if angular { ["rad/s", "rad/s2"] } else { ["m/s", "m/s2"] };
    let mut rows: Vec<Given> = Vec::new();
    match &mechanism.motion {
        Some(Motion::Prescribed { speed, acceleration }) => {
            rows.push(("given-speed", Ok(*speed), speed_unit));
            rows.push(("given-acceleration", Ok(*acceleration), acceleration_unit));
        }
        Some(Motion::Transient { speed, .. }) => rows.push(("initial-speed", Ok(*speed), speed_unit)),
        Some(Motion::Steady { mean_speed, unevenness }) => {
            rows.push(("mean-speed", Ok(*mean_speed), speed_unit));
            rows.extend(unevenness.map(|unevenness| ("unevenness", wanted(unevenness), "")));
        }
        None => {}
    }
    rows.extend(mechanism.drive.iter().flat_map(drive));
    let shown = |value: Result<f64, String>| match value {
        Ok(value) => number(words, value),
        Err(text) => words.get(&text),
    };
    rows.into_iter().map(|(id, value, unit)| vec![words.get(id), shown(value), words.unit(unit)]).collect()
}

/// Identifier, number or identifier of a text (a name stands for itself), and unit of what is given.
type Given = (&'static str, Result<f64, String>, &'static str);

fn wanted(number: Solve) -> Result<f64, String> {
    match number {
        Solve::Given(value) => Ok(value),
        Solve::Wanted => Err("wanted".to_owned()),
    }
}

fn drive(drive: &Drive) -> Vec<Given> {
    let mut rows: Vec<Given> = Vec::new();
    if let Torque::Constant(moment) = drive.torque {
        rows.push(("driving-moment", Ok(moment), "N m"));
    }
    if let Torque::Motor { motor, .. } = &drive.torque {
        match motor {
            Motor::Auto => rows.push(("motor", Err("chosen".to_owned()), "")),
            Motor::Designation(name) => rows.push(("motor", Err(name.clone()), "")),
            Motor::Rated(rated) => {
                rows.push(("motor-power", Ok(rated.power), "W"));
                rows.push(("synchronous-speed", Ok(rated.synchronous_speed), "rad/s"));
                rows.push(("rated-speed", Ok(rated.rated_speed), "rad/s"));
                rows.extend(rated.max_torque_ratio.map(|value| ("breakdown", Ok(value), "")));
                rows.extend(rated.inertia.map(|value| ("rotor", Ok(value), "kg m2")));
            }
        }
        rows.push(("ratio", wanted(drive.ratio), ""));
        rows.push(("efficiency", Ok(drive.efficiency), ""));
    }
    rows.extend(drive.flywheel.map(|flywheel| ("flywheel", wanted(flywheel), "kg m2")));
    rows
}

/// The mechanism over one cycle.
fn moving(context: &mut Context<'_>) -> Option<Block> {
    let scene = context.state.scene.as_ref()?;
    let scene_coordinate = scene.coordinate(scene.first_position()).render(context.words.spoken());
    let exist: Vec<usize> =
        (0..scene.positions()).filter(|position| scene.poses[*position].is_some()).collect();
    let frames: Option<Vec<_>> = exist
        .into_iter()
        .map(|position| context.figure(View::Mechanism, position, |_| {}).map(|(figure, _)| figure))
        .collect();
    let frames = frames.filter(|frames| !frames.is_empty())?;
    let values = [("at", scene_coordinate)];
    let caption = context.words.with("mechanism-moving", &values);
    Some(Block::Picture { frames, size: MECHANISM, caption })
}
