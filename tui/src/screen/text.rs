//! Every text of the terminal UI. Another language is another [`Texts`]; no view holds words of its own.

use std::fmt::Display;

macro_rules! texts {
    ($($field:ident: $english:literal,)*) => {
        /// The texts of one language.
        #[derive(Debug)]
        pub(crate) struct Texts {
            $(pub(crate) $field: &'static str,)*
            /// Name of a command, its line of help, its word in the last row.
            pub(crate) commands: &'static [(&'static str, &'static str, &'static str)],
        }

        /// English.
        pub(crate) static ENGLISH: Texts = Texts { $($field: $english,)* commands: COMMANDS };
    };
}

texts! {
    position: "position {0} of {1}",
    no_assembly: "no assembly",
    no_assembly_here: "no assembly in this position",
    no_position: "there is no position {0}: the last one is {1}",
    needs: "needs {0} x {1}, has {2} x {3}",
    reloaded: "the scene was read again",
    keys_more: "? all keys",
    mechanism: "Mechanism",
    curves: "Curves",
    structure: "Structure",
    table: "Table",
    menu: "Scenes",
    coordinate: "coordinate",
    speed: "speed",
    point: "point",
    links: "links",
    slides: "slides",
    path_scale: "scale",
    velocity_by: "PF1 arrow",
    acceleration_by: "PF2 arrow",
    angle: "angle",
    help_title: "Help: every key, by what it does",
    help_filter: "type to search",
    help_linear: "The same as plain lines: assur analyze, assur check, assur explain SCENE",
    group_move: "Position",
    group_choose: "Choose",
    group_view: "Views",
    group_look: "Drawing",
    group_program: "Program",
    unknown_command: "there is no command `{0}`{1}",
    did_you_mean: "; did you mean `{0}`?",
    unknown_name: "there is no `{0}` here{1}",
    unknown_value: "`{0}` takes {1}, not `{2}`",
    not_found: "`{0}` was not found",
    exists: "{0} exists: overwrite it? y / n",
    written: "written: {0}",
    not_written: "{0} could not be written: {1}",
    kept: "{0} was left as it is",
    nothing_to_write: "this view has nothing to write",
    no_file: "a shipped scene has no file to read again",
    unreadable: "{0} could not be read: {1}",
    worker_failed: "the calculation stopped unexpectedly: {0}",
    fault_title: "The scene was not taken; the old result stays. Any key goes on.",
    extremes: "o extreme",
    zero: "x zero",
    inflection: "+ inflection",
    mobility: "mobility W = 3 n - 2 p = 3 * {0} - 2 * {1} = {2}",
    class_of: "mechanism of class {0}",
    class_and_order: "class {0}, type {1}, order {2}",
    links_of: "links: {0}",
    inner_pairs: "inner pairs: {0}",
    outer_pairs: "outer pairs: {0}",
    ways: "assembly: way {0} of {1}",
    plugin: "plugin: {0} ({1})",
    source: "source: {0}",
    singular: "singular: {0}",
    health: "determinant here: {0}",
    input_link: "input link {0} on {1}",
    menu_title: "Shipped scenes: Enter opens one, ? shows all keys, q leaves",
    opening: "reading {0} ...",
    sorted_by: "sorted by {0}",
    number: "No",
    off: "off",
    on: "on",
}

/// Puts the arguments for `{0}`, `{1}`, ...
pub(crate) fn fill(text: &str, arguments: &[&dyn Display]) -> String {
    let mut filled = text.to_owned();
    for (index, argument) in arguments.iter().enumerate() {
        filled = filled.replace(&format!("{{{index}}}"), &argument.to_string());
    }
    filled
}

const COMMANDS: &[(&str, &str, &str)] = &[
    ("next-position", "the next position", "step"),
    ("previous-position", "the position before", ""),
    ("first-position", "the first position", ""),
    ("last-position", "the last position", ""),
    ("forward", "an eighth of the cycle on", ""),
    ("back", "an eighth of the cycle back", ""),
    ("play", "start and stop the motion", "play"),
    ("next-row", "the next position (a row of the table)", "row"),
    ("previous-row", "the position before", ""),
    ("next-item", "the next quantity: point, link or slide", "quantity"),
    ("previous-item", "the quantity before", ""),
    ("next-group", "the next group; it is marked in the drawing", "group"),
    ("previous-group", "the group before", ""),
    ("next-column", "the next column", "column"),
    ("previous-column", "the column before", ""),
    ("sort", "sort by this column: up, down, by number", "sort"),
    ("next-scene", "the next scene", "choose"),
    ("previous-scene", "the scene before", ""),
    ("open-scene", "open the scene", "open"),
    ("mechanism", "the mechanism, drawn to scale", ""),
    ("curves", "PF0, PF1, PF2 over the positions", ""),
    ("structure", "groups, formula, what belongs to what", ""),
    ("table", "all numbers as a table", ""),
    ("menu", "the shipped scenes", ""),
    ("arrows", "arrows: velocity, acceleration, both, none", "arrows"),
    ("trace", "paths: of all points, of the chosen one, none", "paths"),
    ("zoom-in", "larger", ""),
    ("zoom-out", "smaller", ""),
    ("whole", "the whole again", ""),
    ("pan-left", "shift the drawing to the left", ""),
    ("pan-right", "shift the drawing to the right", ""),
    ("pan-up", "shift the drawing up", ""),
    ("pan-down", "shift the drawing down", ""),
    ("marker", "dots: Braille, half blocks, ASCII", ""),
    ("ascii", "only ASCII characters, or all", ""),
    ("theme", "colors: default, mono, okabe-ito", ""),
    ("help", "this help; typing searches it", ""),
    ("command", "command line: :42, :point D, :view table, :set theme mono; Tab completes", "command"),
    ("search", "search: a number is a position, a word is a column or quantity", "search"),
    ("reload", "read the scene again", ""),
    ("write", "write this view to a file: SVG of the drawing, CSV of the rest", "write"),
    ("redraw", "write the whole screen anew", ""),
    ("suspend", "back to the shell; fg returns", ""),
    ("close", "close what is open", ""),
    ("quit", "leave", "quit"),
];
