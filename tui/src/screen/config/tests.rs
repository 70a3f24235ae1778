//! The default read back, and the text of each fault.

use super::default::kept;
use super::{Config, default_text};
use crate::screen::command::COMMANDS;
use crate::screen::state::{Key, Look, Marker, Panels, SETTINGS, Theme, View};

fn read(text: &str) -> Config {
    Config::read("config.toml", text).unwrap_or_else(|errors| panic!("{errors}"))
}

fn faults(text: &str) -> String {
    Config::read("config.toml", text).unwrap_err().to_string()
}

/// What stands below `[keys]`.
fn keys_of(text: &str) -> &str {
    text.split_once("[keys]\n").unwrap().1
}

#[test]
fn the_printed_default_is_the_default_and_says_all() {
    let text = default_text(assur_words::Language::english());
    assert_eq!(read(&text), Config::default());
    assert!(text.is_ascii());
    // A key that the text leaves out, or writes wrongly, shows when each line is read alone against other keys.
    for command in COMMANDS {
        let line =
            keys_of(&text).lines().find(|line| line.starts_with(&format!("{} = ", command.name))).unwrap();
        let keys = line.split_once('[').unwrap().1.rsplit_once("]  ").unwrap().0;
        assert_eq!(keys.matches('"').count(), 2 * command.default_keys().len(), "{line}");
        assert!(line.contains("# "), "{line}");
    }
    for setting in SETTINGS {
        assert!(
            text.lines().any(|line| line.starts_with(&format!("{} = ", setting.name))),
            "{}",
            setting.name
        );
    }
}

#[test]
fn the_lines_of_the_default_are_live() {
    // Each changed line of the default changes what is read, so that none of them is a comment.
    let text = default_text(assur_words::Language::english());
    for (from, to) in [
        ("theme = \"default\"", "theme = \"mono\""),
        ("marker = \"braille\"", "marker = \"ascii\""),
        ("ascii = false", "ascii = true"),
        ("fps = 10", "fps = 11"),
        ("cell_ratio = 2.0", "cell_ratio = 2.5"),
        ("mouse = false", "mouse = true"),
        ("language = \"auto\"", "language = \"ru\""),
        ("pixels = false", "pixels = true"),
        ("panels = [\"mechanism\", ", "panels = ["),
        ("play = [\"Space\"]", "play = [\"y\"]"),
    ] {
        assert!(text.contains(from), "{from}");
        assert_ne!(read(&text.replace(from, to)), Config::default(), "{to}");
    }
}

#[test]
fn an_empty_file_is_the_default() {
    assert_eq!(read(""), Config::default());
}

#[test]
fn every_setting_is_taken() {
    let config = read(
        "theme = 'mono'\nmarker = 'half-block'\nascii = true\nfps = 25\ncell_ratio = 1.9\nmouse = true\nlanguage = 'uk'\npixels = true\n\
         [keys]\nplay = 'y'\nnext-position = ['i', 'C-n', 'F5']\nwrite = []\n",
    );
    let look = Look {
        ascii: true,
        marker: Marker::HalfBlock,
        theme: Theme::Mono,
        ratio: 1.9,
        fps: 25,
        mouse: true,
        language: "uk",
        pixels: true,
    };
    assert_eq!(config.look, look);
    let keys = |name: &str| config.keys.keys(name).to_vec();
    assert_eq!(keys("play"), [Key::parse("y").unwrap()]);
    assert_eq!(keys("next-position"), ["i", "C-n", "F5"].map(|key| Key::parse(key).unwrap()));
    assert_eq!(keys("write"), []);
    assert_eq!(keys("quit"), ["q", "C-c"].map(|key| Key::parse(key).unwrap()));
}

#[test]
fn two_commands_on_one_key_are_refused_by_name() {
    assert_eq!(
        faults("[keys]\nforward = \"x\"\n"),
        "error: `x` means both `forward` and `trace` in Mechanism\n  config.toml, line 2, column 11\n  \
         |\n2 | forward = \"x\"\n  |           ^^^ a default key of `trace`\n  \
         = give one of them another key, or none at all: trace = []\n"
    );
    let both = faults("[keys]\ntheme = \"y\"\nplay = [\"p\", \"y\"]\n");
    assert!(both.contains("`y` means both `play` and `theme`"), "{both}");
    assert!(both.contains("line 3, column 14") && both.contains("also a key of `theme`"), "{both}");
    // Another view, another meaning: that is no clash; and the two are reported once, not for each view.
    assert_eq!(read("[keys]\nsort = \"b\"\n").keys.keys("sort").len(), 1);
    assert_eq!(faults("[keys]\nforward = \"?\"\n").matches("error:").count(), 1);
}

#[test]
fn a_swap_of_keys_is_no_clash() {
    let config = read("[keys]\nplay = 'w'\nwrite = 'Space'\n");
    assert_eq!(config.keys.first("play"), "w");
    assert_eq!(config.keys.first("write"), "Space");
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    for (text, place, words) in [
        ("thme = 'mono'", "line 1, column 1", "did you mean `theme`?"),
        ("theme = 'pink'", "line 1, column 9", "`theme` wants one of: default, mono, okabe-ito, got `pink`"),
        ("fps = 0", "line 1, column 7", "`fps` wants a whole number from 1 to 60, got 0"),
        ("cell_ratio = 9", "line 1, column 14", "`cell_ratio` wants a number from 0.5 to 5, got 9"),
        ("\n[keys]\nnext-postion = 'n'", "line 3, column 1", "did you mean `next-position`?"),
        ("[keys]\nplay = 'Spce'", "line 2, column 8", "`play`: there is no key `Spce`"),
        ("[keys]\nplay = 3", "line 2, column 8", "`play` wants the name of a key, got an integer"),
        ("[keys]\nquit = []", "line 2, column 8", "`quit` needs a key"),
        ("keys = 3", "line 1, column 8", "`keys` wants a table, got an integer"),
        ("panels = ['curvs']", "line 1, column 11", "`panels` wants one of"),
        ("mouse = 'yes'", "line 1, column 9", "`mouse` wants true or false, got a text"),
        ("fps = = 3", "line 1, column 7", "not TOML"),
    ] {
        let faults = faults(text);
        assert!(faults.contains(place) && faults.contains(words) && faults.contains('^'), "{text}: {faults}");
    }
}

#[test]
fn what_is_kept_is_read_again_and_the_rest_stays() {
    let changed = [
        ("theme", "\"mono\"".to_owned()),
        ("fps", "25".to_owned()),
        ("panels", "[\"plans\", \"working\"]".to_owned()),
    ];
    let look = Look { theme: Theme::Mono, fps: 25, ..Look::default() };
    let panels = Panels { shown: true, views: vec![View::Plans, View::Working] };
    let own = "# mine\nfps = 5\n\n[keys]\nplay = 'y' # y\n";
    for old in [own, "", &default_text(assur_words::Language::english())] {
        let text = kept(old, &changed).unwrap();
        let config = read(&text);
        assert_eq!((config.look, &config.panels), (look, &panels));
        assert_eq!(config.keys, read(old).keys);
        assert_eq!(kept(&text, &changed).unwrap(), text);
    }
    assert!(kept(own, &changed).unwrap().ends_with("# mine\nfps = 25\n\n[keys]\nplay = 'y' # y\n"));
    // A value over several lines is left to the user.
    assert!(kept("panels = [\n'plans',\n]\n", &changed).is_err());
}
