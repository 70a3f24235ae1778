//! Roles and their styles. Color is never the only sign: each role also has a modifier or a word.

use assur_figure::Ink;
use ratatui::style::{Color, Modifier, Style};
use strum::{EnumString, IntoStaticStr, VariantArray, VariantNames};

/// A palette.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumString, VariantArray, VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum Theme {
    /// The 16 colors of the terminal, which follow its light or dark scheme.
    Default,
    /// No color at all.
    Mono,
    /// Okabe and Ito's palette, distinguished by most color-blind readers.
    OkabeIto,
}

/// The purpose of a style.
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
    /// The style of a role.
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
