//! Names for readers and the texts of the note: one text or a table of languages.

use assur_words::{LANGUAGES, Language, Text};

use crate::{Chapter, read, read_with_note};

const SCENE: &str = "
title = { uk = 'Механізм', ru = 'Механизм' }
[labels]
A = 'A₁'
[ground]
label = { uk = 'стояк' }
points = { O = 0 }
[link.arm]
label = 'важіль'
points = { O = 0, A = 1 }
[input]
link = 'arm'
[[moment]]
name = 'load'
label = { en = 'pull', uk = 'натяг' }
link = 'arm'
value = 1
[note]
author = { uk = 'Студент' }
year = '2026'
task = '''One.

Two.'''
curves = ['A.x, A.y']
chapters = ['task', 'sources']
digits = 5
";

fn in_all(text: impl Into<Text>) -> [String; 3] {
    let text = text.into();
    LANGUAGES.map(|code| text.render(Language::find(code).unwrap()))
}

#[test]
fn readers_have_labels_and_files_have_names() {
    let scene = read("a", SCENE).unwrap();
    assert_eq!(in_all(&scene.title), ["Механізм", "Механізм", "Механизм"]);
    assert_eq!(in_all(&scene.links[0].name), ["ground", "стояк", "стойка"]);
    assert_eq!(in_all(&scene.links[1].name), ["важіль"; 3]);
    assert_eq!(in_all(&scene.points[1].name), ["A₁"; 3]);
    assert_eq!(in_all(&scene.loads[0].name), ["pull", "натяг", "load"]);
    let names = [
        &scene.title,
        &scene.links[0].name,
        &scene.links[1].name,
        &scene.points[1].name,
        &scene.loads[0].name,
    ];
    assert_eq!(names.map(ToString::to_string), ["Механізм", "ground", "arm", "A", "load"]);
    assert!(scene.has_structure_of(&read("a", &SCENE.replace("важіль", "arm")).unwrap()));
}

#[test]
fn a_note_has_texts_in_languages_chapters_and_digits() {
    let (_, note) = read_with_note("a", SCENE).unwrap();
    assert_eq!(in_all(note.author.clone().unwrap()), ["Студент"; 3]);
    assert_eq!(note.task.clone().unwrap().to_string(), "One.\n\nTwo.");
    assert_eq!(note.curves, [["A.x", "A.y"]]);
    assert!(note.has(Chapter::Task) && !note.has(Chapter::Forces) && note.supervisor.is_none());
    assert_eq!((note.digits, note.language), (5, None));
}

#[track_caller]
fn fails(from: &str, to: &str, line: usize, told: &str) {
    let errors = read("a", &SCENE.replace(from, to)).unwrap_err();
    let [error] = &errors.errors[..] else { panic!("{errors}") };
    assert_eq!(error.line, line, "{errors}");
    assert!(errors.to_string().contains(told), "{errors}");
}

#[test]
fn a_wrong_label_is_told_at_its_place() {
    fails("label = 'важіль'", "label = 5", 9, "`label` wants a text or a table of languages");
    fails("label = 'важіль'", "label = {}", 9, "an empty table");
    fails("label = 'важіль'", "label = ''", 9, "an empty text");
    fails("{ uk = 'стояк' }", "{ de = 'Gestell' }", 6, "unknown key `de`");
    fails("A = 'A₁'", "B = 'A₁'", 4, "point `B`");
    fails("'task', 'sources'", "'task', 'source'", 25, "did you mean `sources`?");
    fails("digits = 5", "digits = 1", 26, "from 2 to 12");
}
