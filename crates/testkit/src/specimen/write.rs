//! Writes a mechanism as the text of a scene, from which the same mechanism is read again.

use std::fmt::Write;

use assur_mechanism::{
    Balance, Contact, Direction, Driver, GROUND, Inertia, InputPair, LawTable, LinkId, LoadKind, Mechanism,
    Motion, Name, Over, Place, Range, Sense, Shape, TimeLaw, Value, VaryingInertia,
};

/// The text of a scene, all numbers in SI with all their digits.
///
/// Covers only what specimens have: a prescribed motion, several inputs that move evenly, no drive and no output.
pub fn scene_text(mechanism: &Mechanism) -> String {
    let mut text = String::new();
    // Writing to a string can't fail.
    let _ = write_scene(&mut text, mechanism);
    text
}

type Out = std::fmt::Result;

fn write_scene(text: &mut String, m: &Mechanism) -> Out {
    writeln!(text, "title = {:?}", m.title)?;
    if let Some(g) = m.gravity {
        writeln!(text, "gravity = {}", pair(g))?;
    }
    for link in 0..m.links.len() {
        write_link(text, m, link)?;
    }
    for slide in &m.slides {
        writeln!(text, "\n[[slide]]\nname = {:?}", slide.name)?;
        writeln!(text, "link = {:?}\non = {:?}", m.links[slide.link].name, m.links[slide.on].name)?;
        writeln!(text, "through = {}\nangle = {:?}", pair(slide.through), slide.angle)?;
        writeln!(text, "point = {}\ntilt = {:?}", pair(slide.point), slide.tilt)?;
    }
    write_input(text, m)?;
    if !m.assembly.is_empty() {
        writeln!(text, "\n[assembly]")?;
    }
    for (point, place) in &m.assembly {
        writeln!(text, "{} = {}", m.points[*point].name, pair(*place))?;
    }
    write_loads(text, m)?;
    write_motion(text, m)
}

fn pair(at: [f64; 2]) -> String {
    format!("[{:?}, {:?}]", at[0], at[1])
}

fn write_link(text: &mut String, m: &Mechanism, id: LinkId) -> Out {
    let link = &m.links[id];
    let stand = |point: &assur_mechanism::Point| {
        let place = point.places.iter().find(|place| place.link == id)?;
        Some(format!("{} = {}", point.name, pair(place.at)))
    };
    let points: Vec<_> = m.points.iter().filter_map(stand).collect();
    let points = points.join(", ");
    if id == GROUND {
        return writeln!(text, "\n[ground]\npoints = {{ {points} }}");
    }
    writeln!(text, "\n[link.{}]\npoints = {{ {points} }}", link.name)?;
    writeln!(text, "mass = {:?}\ncenter = {}", link.mass, pair(link.center))?;
    match &link.inertia {
        Inertia::Constant(inertia) => writeln!(text, "inertia = {inertia:?}"),
        Inertia::Varying(VaryingInertia { formula, factor }) => {
            // A specimen has SI units.
            debug_assert_eq!(factor.to_bits(), 1.0_f64.to_bits());
            writeln!(text, "inertia = {{ formula = \"{}\" }}", formula.text())
        }
    }
}

/// What is driven.
fn driven(m: &Mechanism, driver: &Driver) -> String {
    let [link, on] = [driver.link, driver.on].map(|link| &m.links[link].name);
    match (driver.is_relative(), driver.pair) {
        (false, _) => format!("link = {link:?}"),
        (true, InputPair::Slide(slide)) => format!("slide = {:?}", m.slides[slide].name),
        (true, InputPair::Pin(pin)) => {
            format!("pin = {:?}\nof = {link:?}\non = {on:?}", m.points[pin].name)
        }
    }
}

fn write_input(text: &mut String, m: &Mechanism) -> Out {
    let input = &m.input;
    for driver in input.drivers.iter().filter(|_| input.is_list) {
        writeln!(text, "\n[[input]]\n{}", driven(m, driver))?;
        // Drives of specimens move evenly.
        if let Some(TimeLaw::Uniform { from, rate }) = driver.law {
            writeln!(text, "from = {from:?}\nrate = {rate:?}")?;
        }
    }
    if input.is_list {
        return Ok(());
    }
    writeln!(text, "\n[input]\n{}", driven(m, input.first()))?;
    writeln!(text, "from = {:?}\npositions = {}", input.from, input.positions)?;
    match input.range {
        Range::To(to) => writeln!(text, "to = {to:?}"),
        Range::Cycle(cycle) => {
            let direction = if input.direction == Sense::Cw { "cw" } else { "ccw" };
            writeln!(text, "cycle = {cycle:?}\ndirection = {direction:?}")
        }
    }
}

fn rows(table: &LawTable) -> String {
    let rows: Vec<_> = table.rows.iter().map(|row| pair(*row)).collect();
    format!("[{}]", rows.join(", "))
}

fn shape(shape: Shape) -> &'static str {
    if shape == Shape::Step { "step" } else { "linear" }
}

fn value(m: &Mechanism, value: &Value) -> String {
    match value {
        Value::Constant(size) => format!("{size:?}"),
        Value::Table { over, table, repeat } => {
            let shape = shape(table.shape);
            let (over, repeat) = match over {
                Over::Coordinate => ("angle", format!(", repeat = {repeat}")),
                Over::Time => ("time", String::new()),
                Over::Speed => ("speed", String::new()),
            };
            // In the scene the speed is counted in the direction of the input.
            let turned =
                matches!(value, Value::Table { over: Over::Speed, .. }) && m.input.direction == Sense::Cw;
            let table = if turned { &table.mirrored() } else { table };
            format!("{{ over = {over:?}, table = {}, shape = {shape:?}{repeat} }}", rows(table))
        }
        Value::Formula { formula, axis, .. } => {
            let axis = axis.map_or_else(String::new, |axis| format!(", axis = {axis:?}"));
            format!("{{ formula = {:?}{axis} }}", formula.text())
        }
        Value::Stroke { axis, forward, back } => {
            // A table of one row is written as a number, with the default shape.
            let side = |table: &LawTable| match table.rows[..] {
                [[_, size]] => format!("{size:?}"),
                _ => rows(table),
            };
            let shape = shape(forward.shape);
            let (forward, back) = (side(forward), side(back));
            format!(
                "{{ over = \"stroke\", axis = {axis:?}, forward = {forward}, back = {back}, shape = {shape:?} }}"
            )
        }
    }
}

fn on(m: &Mechanism, place: &Place) -> String {
    format!("link = {:?}\nat = {}", m.links[place.link].name, pair(place.at))
}

fn write_loads(text: &mut String, m: &Mechanism) -> Out {
    for load in &m.loads {
        let name = &load.name;
        match &load.kind {
            LoadKind::Force(force) => {
                writeln!(text, "\n[[force]]\nname = {name:?}\n{}", on(m, &force.at))?;
                match force.direction {
                    Direction::Ground(angle) => writeln!(text, "angle = {angle:?}")?,
                    Direction::Link(angle) => writeln!(text, "angle = {angle:?}\nframe = \"link\"")?,
                    Direction::AgainstMotion => writeln!(text, "against_motion = true")?,
                }
                writeln!(text, "value = {}", value(m, &force.value))?;
            }
            LoadKind::Moment(moment) => {
                let link = &m.links[moment.link].name;
                writeln!(text, "\n[[moment]]\nname = {name:?}\nlink = {link:?}")?;
                if moment.against_motion {
                    writeln!(text, "against_motion = true")?;
                }
                writeln!(text, "value = {}", value(m, &moment.value))?;
            }
            LoadKind::Brake(brake) => {
                let link = &m.links[brake.link].name;
                writeln!(text, "\n[[brake]]\nname = {name:?}\nlink = {link:?}")?;
                writeln!(text, "radius = {:?}\nfriction = {:?}", brake.radius, brake.friction)?;
                writeln!(text, "force = {}", value(m, &brake.force))?;
            }
            LoadKind::Spring(spring) => {
                let ends = spring.ends.each_ref().map(|place| end(m, place));
                writeln!(text, "\n[[spring]]\nname = {name:?}\nbetween = {ends:?}")?;
                writeln!(text, "stiffness = {:?}\nlength = {:?}", spring.stiffness, spring.length)?;
                writeln!(text, "damping = {:?}", spring.damping)?;
            }
            LoadKind::Contact(contact) => write_contact(text, m, name, contact)?,
        }
    }
    Ok(())
}

/// The name of the point at a place, with its link.
fn end(m: &Mechanism, place: &Place) -> String {
    let point = m.points.iter().find(|point| point.places.contains(place));
    format!("{}.{}", m.links[place.link].name, point.map_or("?", |point| point.name.as_str()))
}

fn write_contact(text: &mut String, m: &Mechanism, name: &Name, contact: &Contact) -> Out {
    writeln!(text, "\n[[contact]]\nname = {name:?}")?;
    let center = &contact.center;
    writeln!(text, "link = {:?}\ncenter = {}", m.links[center.link].name, pair(center.at))?;
    writeln!(text, "radius = {:?}\nangle = {}", contact.radius, value(m, &contact.angle))?;
    writeln!(text, "force = {}", value(m, &contact.force))?;
    let friction = contact.friction;
    if contact.against_sliding {
        writeln!(text, "friction = {{ against_sliding = {friction:?} }}")?;
    } else {
        writeln!(text, "friction = {friction:?}")?;
    }
    if let Some(during) = contact.during {
        writeln!(text, "during = {}", pair(during))?;
    }
    Ok(())
}

fn write_motion(text: &mut String, m: &Mechanism) -> Out {
    match &m.balance {
        Some(Balance::Moment(link)) => writeln!(text, "\n[balance]\nlink = {:?}", m.links[*link].name)?,
        Some(Balance::Force { at, angle }) => {
            writeln!(text, "\n[balance]\n{}\nangle = {angle:?}", on(m, at))?;
        }
        None => {}
    }
    if m.input.kind().is_time() {
        if let Range::To(until) = m.input.range {
            writeln!(text, "\n[motion]\nuntil = {until:?}\nsamples = {}", m.input.positions - 1)?;
        }
    } else if let Some(Motion::Prescribed { speed, acceleration }) = m.motion {
        // In the scene speed and acceleration are counted in the direction of the input.
        let [speed, acceleration] = [speed, acceleration].map(|value| m.input.sign() * value);
        writeln!(text, "\n[motion]\nspeed = {speed:?}\nacceleration = {acceleration:?}")?;
    }
    Ok(())
}
