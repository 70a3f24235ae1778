//! Exploration.
use super::examples::{forms, scenes};
use super::*;
use crate::{added, made, put, sections};

#[test]
fn explore() {
    for scene in scenes() {
        let title = scene.lines().find(|l| l.starts_with("title")).unwrap_or_default().to_owned();
        for (header, form) in forms(&scene, &[]) {
            for field in &form.fields {
                if field.value.is_some() && !field.is_table() {
                    let same = put(&scene, field, &field.shown());
                    if same.here.is_some() || !same.elsewhere.is_empty() || format!("{:?}", read(&same.text)) != format!("{:?}", read(&scene)) {
                        println!("SHOWN {title} {} {:?} -> {:?}", field.key, field.value, same.here);
                    }
                }
                for opening in &field.opens {
                    let change = made(&scene, &field.key, opening);
                    if change.here.is_some() || !change.elsewhere.is_empty() {
                        println!("MADE {title} {header} {} {} : here {:?} else {:?} also {:?}", field.key, opening.label, change.here.map(|f| f.message.to_string()), change.elsewhere.iter().map(|f| f.message.to_string()).collect::<Vec<_>>(), change.also.iter().map(|k|k.to_string()).collect::<Vec<_>>());
                    } else if title.contains("Shaper with rocker") { 
                        println!("OK {} {}: {:?}", field.key, opening.label, crate::field(&change.text, &field.key, &[]).unwrap().value);
                    }
                }
            }
        }
        for section in sections(&scene) {
            if section.can_add {
                let change = added(&scene, section.header);
                if change.here.is_some() || !change.elsewhere.is_empty() {
                    println!("ADDED {title} {} : here {:?} else {:?} also {:?}", section.header, change.here.map(|f| f.message.to_string()), change.elsewhere.iter().map(|f| f.message.to_string()).collect::<Vec<_>>(), change.also.iter().map(|k|k.to_string()).collect::<Vec<_>>());
                }
            }
        }
    }
}
