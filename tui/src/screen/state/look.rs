//! How things are drawn, and what of it a user may set. Color is never the only sign: each role also has a modifier or a word.

use std::ops::RangeInclusive;

use assur_figure::Ink;
use assur_figure::cells::Marker;
use assur_words::{LANGUAGES, Text, list, name, number, text};
use ratatui::style::{Color, Modifier, Style};
use strum::{EnumString, IntoStaticStr, VariantArray, VariantNames};

use super::kinds::View;

/// The views that are shown beside the chosen one where there is room.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Panels {
    pub(crate) shown: bool,
    /// The views, the most wanted first.
    pub(crate) views: Vec<View>,
}

impl Default for Panels {
    fn default() -> Self {
        Self { shown: true, views: vec![View::Mechanism, View::Curves, View::Plans, View::Table] }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Look {
    /// Characters beyond ASCII are replaced.
    pub(crate) ascii: bool,
    pub(crate) marker: Marker,
    pub(crate) theme: Theme,
    pub(crate) ratio: f64,
    pub(crate) fps: u8,
    pub(crate) mouse: bool,
    /// A language, or [`AUTO`].
    pub(crate) language: &'static str,
    /// Whether figures are drawn as pixels, if the terminal can.
    pub(crate) pixels: bool,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Pictures {
    /// Nobody has asked it.
    #[default]
    Unknown,
    Asked,
    None,
    /// By kitty's protocol.
    Kitty,
    /// By that of iTerm2.
    Iterm,
}

/// The language that the scene wants for its note.
pub(crate) const AUTO: &str = "auto";
const CHOICES: [&str; 4] = [AUTO, LANGUAGES[0], LANGUAGES[1], LANGUAGES[2]];

impl Default for Look {
    fn default() -> Self {
        Self {
            ascii: false,
            marker: Marker::Braille,
            theme: Theme::Default,
            ratio: 2.0,
            fps: 10,
            mouse: false,
            language: AUTO,
            pixels: false,
        }
    }
}

/// Something that a user may set, in the configuration and by `:set`.
#[derive(Debug)]
pub(crate) struct Setting {
    /// Its name in the configuration; `:set` takes its beginning too.
    pub(crate) name: &'static str,
    /// The identity of what it is.
    pub(crate) text: &'static str,
    pub(crate) kind: Kind,
    pub(crate) get: fn(&Look) -> String,
    /// Sets it by a word that its kind allows.
    set: fn(&mut Look, &str) -> Option<()>,
}

#[derive(Debug)]
pub(crate) enum Kind {
    Choice(&'static [&'static str]),
    Flag,
    Count(RangeInclusive<usize>),
    Number(RangeInclusive<f64>),
}

impl Kind {
    /// What it takes, in words; a number has no list.
    pub(crate) fn words(&self) -> &'static [&'static str] {
        match self {
            Self::Choice(words) => words,
            Self::Flag => &["on", "off"],
            Self::Count(_) | Self::Number(_) => &[],
        }
    }

    /// What it takes, for a reader: `default, mono`, `1 to 60`.
    pub(crate) fn told(&self) -> Text {
        let range = |from: Text, to: Text| text!("setting-range", from = from, to = to);
        match self {
            Self::Count(all) => range(number(all.start()), number(all.end())),
            Self::Number(all) => range(number(all.start()), number(all.end())),
            _ => list(self.words().iter().map(|word| name(*word))),
        }
    }
}

impl Setting {
    /// Sets it; `None` for a word that it does not take.
    pub(crate) fn take(&self, look: &mut Look, word: &str) -> Option<()> {
        let allowed = match &self.kind {
            Kind::Count(range) => word.parse().is_ok_and(|count| range.contains(&count)),
            Kind::Number(range) => word.parse().is_ok_and(|number| range.contains(&number)),
            kind => kind.words().contains(&word),
        };
        allowed.then(|| (self.set)(look, word))?
    }
}

fn on_off(on: bool) -> String {
    if on { "on" } else { "off" }.to_owned()
}

#[rustfmt::skip]
pub(crate) const SETTINGS: [Setting; 8] = [
    Setting { name: "theme", text: "config-theme", kind: Kind::Choice(<Theme as VariantNames>::VARIANTS),
              get: |look| <&str>::from(look.theme).to_owned(),
              set: |look, word| word.parse().ok().map(|theme| look.theme = theme) },
    Setting { name: "marker", text: "config-marker", kind: Kind::Choice(<Marker as VariantNames>::VARIANTS),
              get: |look| <&str>::from(look.marker).to_owned(),
              set: |look, word| word.parse().ok().map(|marker| look.marker = marker) },
    Setting { name: "ascii", text: "config-ascii", kind: Kind::Flag, get: |look| on_off(look.ascii),
              set: |look, word| { look.ascii = word == "on"; Some(()) } },
    Setting { name: "fps", text: "config-fps", kind: Kind::Count(1..=60), get: |look| look.fps.to_string(),
              set: |look, word| word.parse().ok().map(|fps| look.fps = fps) },
    Setting { name: "cell_ratio", text: "config-cell-ratio", kind: Kind::Number(0.5..=5.0), get: |look| format!("{:?}", look.ratio),
              set: |look, word| word.parse().ok().map(|ratio| look.ratio = ratio) },
    Setting { name: "language", text: "config-language", kind: Kind::Choice(&CHOICES), get: |look| look.language.to_owned(),
              set: |look, word| CHOICES.into_iter().find(|known| *known == word).map(|own| look.language = own) },
    Setting { name: "pixels", text: "config-pixels", kind: Kind::Flag, get: |look| on_off(look.pixels),
              set: |look, word| { look.pixels = word == "on"; Some(()) } },
    Setting { name: "mouse", text: "config-mouse", kind: Kind::Flag, get: |look| on_off(look.mouse),
              set: |look, word| { look.mouse = word == "on"; Some(()) } },
];

impl Look {
    /// Sets what a name that is known takes; a word that it does not take changes nothing.
    pub(crate) fn with(mut self, name: &str, word: Option<String>) -> Self {
        let setting = SETTINGS.iter().find(|setting| setting.name == name);
        if let (Some(setting), Some(word)) = (setting, word) {
            setting.take(&mut self, &word);
        }
        self
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumString, VariantArray, VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum Theme {
    /// The 16 colors of the terminal, which follow its light or dark scheme.
    Default,
    Mono,
    /// Okabe and Ito's palette, distinguished by most color-blind readers.
    OkabeIto,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    Plain,
    Dim,
    Header,
    Tab,
    Key,
    Chosen,
    Cursor,
    Good,
    Bad,
    /// What has an ink of its own in a figure.
    Drawn(Ink),
}

impl Theme {
    pub(crate) fn style(self, role: Role) -> Style {
        let style = Style::new().add_modifier(modifier(role));
        match self {
            Self::Mono => style,
            Self::Default => colors(role).map_or(style, |[color, _]| style.fg(color)),
            Self::OkabeIto => colors(role).map_or(style, |[_, color]| style.fg(color)),
        }
    }
}

/// Colors of the links in turn; none is that of an arrow.
const LINKS: [Color; 6] =
    [Color::Blue, Color::Red, Color::Cyan, Color::LightBlue, Color::LightRed, Color::LightCyan];
/// Colors of the links in Okabe and Ito's palette.
const OKABE_ITO_LINKS: [Color; 4] =
    [Color::Rgb(0, 114, 178), Color::Rgb(213, 94, 0), Color::Rgb(86, 180, 233), Color::Rgb(240, 228, 66)];

fn modifier(role: Role) -> Modifier {
    match role {
        Role::Header | Role::Key | Role::Bad => Modifier::BOLD,
        Role::Tab | Role::Cursor => Modifier::REVERSED,
        Role::Chosen => Modifier::BOLD.union(Modifier::REVERSED),
        _ => Modifier::empty(),
    }
}

/// The color of a role among the 16 of the terminal, and in Okabe and Ito's palette.
fn colors(role: Role) -> Option<[Color; 2]> {
    Some(match role {
        Role::Dim | Role::Drawn(Ink::Trace) => [Color::DarkGray, Color::Indexed(245)],
        Role::Key | Role::Drawn(Ink::First) => [Color::Cyan, Color::Rgb(86, 180, 233)],
        Role::Good | Role::Drawn(Ink::Velocity | Ink::Second) => [Color::Green, Color::Rgb(0, 158, 115)],
        Role::Drawn(Ink::Acceleration | Ink::Third) => [Color::Magenta, Color::Rgb(204, 121, 167)],
        Role::Bad => [Color::Red, Color::Rgb(213, 94, 0)],
        Role::Chosen => [Color::Yellow, Color::Rgb(230, 159, 0)],
        Role::Drawn(Ink::Link(number)) => {
            let nth = number.saturating_sub(1);
            [LINKS[nth % LINKS.len()], OKABE_ITO_LINKS[nth % OKABE_ITO_LINKS.len()]]
        }
        _ => return None,
    })
}
