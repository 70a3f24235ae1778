//! What a reader calls a quantity of an owner.

use assur_analysis::results::{Column, Owner, Quantity, Schema};
use assur_mechanism::GROUND;
use assur_words::{Text, joined, name, text};

use super::{axis, of};

/// Several texts with a space between them, without the empty ones.
fn spaced(parts: impl IntoIterator<Item = Text>) -> Text {
    joined(" ", parts.into_iter().filter(|part| !part.is_empty()))
}

/// What a column belongs to: `point D`, `A on rod`, `load gas`; empty for the input.
pub fn owner(schema: &Schema, column: Column) -> Text {
    let of = |owner| schema.named(owner).map_or_else(Text::default, Text::from);
    let own = || of(column.owner);
    match column.owner {
        // Results of the ground are those of the whole.
        Owner::Input | Owner::Link(GROUND) => Text::default(),
        Owner::Link(_) => text!("owner-link", name = own()),
        Owner::Point(_) => text!("owner-point", name = own()),
        Owner::Slide(_) => text!("owner-slide", name = own()),
        Owner::PairOn(_, link) => {
            text!("owner-pair-on", name = own(), link = of(Owner::Link(link)))
        }
        // Results count groups from 0, readers from 1.
        Owner::Group(group) => text!("owner-group", number = group + 1),
        Owner::Load(_) => text!("owner-load", name = own()),
        Owner::Drive(_) => text!("owner-drive", name = own()),
        _ => own(),
    }
}

/// The symbol of a column with the axis of a projection: `vx`.
fn symbol(column: Column) -> String {
    of(column).symbol.to_owned() + axis(column.part)
}

/// A column as a head among the columns of its owner: `PF1 x`, `vx`, `F`; what it is in words where it has no symbol.
pub fn head(column: Column) -> Text {
    let symbol = symbol(column);
    match column.quantity {
        Quantity::Transfer(0) => name(symbol),
        Quantity::Transfer(_) => spaced([kind(column), name(symbol)]),
        _ if symbol.is_empty() => kind(column),
        _ => name(symbol),
    }
}

/// What a column is, in words: `velocity`, `PF1`; empty for a load, whose name says all.
pub fn kind(column: Column) -> Text {
    let id = of(column).name;
    if id.is_empty() { Text::default() } else { text!(id) }
}

/// Whether owner and symbol alone don't tell what a column is: the input needs no name, and F of a link may be a reaction.
const fn needs_its_kind(column: Column) -> bool {
    use Quantity::{Balancing, Condition, InertiaForce, InertiaMoment, ReducedLoad, Residual, Work};
    // The work of the weights is of the ground, that of a load of the load.
    matches!(column.owner, Owner::Input)
        || matches!(column.quantity, Work | ReducedLoad | Balancing)
        || matches!(column.quantity, InertiaForce | InertiaMoment | Condition | Residual(_))
}

/// A column by owner and symbol, `point D vx`, and what it is in words where these don't tell: `link rod inertia force Fx`.
pub fn subject(schema: &Schema, column: Column) -> Text {
    let kind = if needs_its_kind(column) { kind(column) } else { Text::default() };
    spaced([owner(schema, column), kind, name(symbol(column))])
}

/// The quantity of a column in words, to be written after its [`subject`]: `velocity`, `PF1`; empty where the subject contains it.
pub fn further(column: Column) -> Text {
    if needs_its_kind(column) { Text::default() } else { kind(column) }
}

/// The name of an owner, which a reader has by its label.
fn named(schema: &Schema, owner: Owner) -> Text {
    schema.named(owner).map_or_else(|| name(schema.name(owner).into_owned()), Text::from)
}

/// A column as the head of a table: `D.x'`, `A>rod.Fx`; no two columns have the same.
pub fn short(schema: &Schema, column: Column) -> Text {
    let own = || named(schema, column.owner);
    // As it is typed; reactions keep the letter by which files and scenes name them.
    let symbol = symbol(column).replace('ω', "w").replace('ε', "e");
    let symbol = if column.quantity == Quantity::Force { symbol.replace('R', "F") } else { symbol };
    let dotted = |of: Text, symbol: &str| {
        if symbol.is_empty() { of } else { joined("", [of, name(format!(".{symbol}"))]) }
    };
    match (column.quantity, column.owner) {
        (Quantity::Transfer(order), Owner::Point(_) | Owner::Link(_) | Owner::Slide(_)) => {
            let primes = "'".repeat(order.into());
            joined("", [dotted(own(), &symbol), name(primes)])
        }
        (_, Owner::PairOn(_, link)) => dotted(joined(">", [own(), (&schema.links[link]).into()]), &symbol),
        (Quantity::Work | Quantity::ReducedLoad, Owner::Input | Owner::Link(_)) => kind(column),
        (Quantity::InertiaForce | Quantity::InertiaMoment, _) => spaced([own(), kind(column), name(symbol)]),
        (Quantity::Partial { drive, order }, _) => {
            let primes = "'".repeat(order.into());
            let by = named(schema, Owner::Drive(drive));
            joined("", [dotted(own(), &symbol), name(primes + "("), by, name(")")])
        }
        (Quantity::Balancing, Owner::Drive(drive)) => {
            let turns = schema.drives.get(drive).is_some_and(|(_, is_angle)| *is_angle);
            dotted(own(), if turns { "M" } else { "F" })
        }
        (
            _,
            Owner::Link(_)
            | Owner::Point(_)
            | Owner::Slide(_)
            | Owner::Pair(_)
            | Owner::Method(_)
            | Owner::Drive(_),
        ) => dotted(own(), &symbol),
        (Quantity::ShakingForce | Quantity::ShakingMoment, _) | (_, Owner::Load(_) | Owner::Group(_)) => {
            spaced([owner(schema, column), kind(column), name(symbol)])
        }
        _ if symbol.is_empty() => kind(column),
        _ => name(symbol),
    }
}
