//! The dry friction of the pairs on the links between which it acts.

use assur_analysis::results::{Column, Owner, Quantity, Schema};
use assur_book::catalogue;
use assur_mechanism::{Friction, LinkId, Mechanism, PairId};
use assur_words::{Text, joined, name, text};

use crate::Results;

/// The dry friction of a pair on one of its links.
#[derive(Debug, Clone)]
pub(crate) struct Rubbing {
    /// The pair.
    pub(crate) pair: PairId,
    /// The link on which it acts, and the other one.
    pub(crate) links: [LinkId; 2],
    /// `M_f,A` of a pin, `F_f,A` of a slide.
    pub(crate) symbol: Text,
    /// What it is.
    pub(crate) told: Text,
    /// Of a pin the moment on the link, N m, counter-clockwise; of a slide the force along the guide on the sliding link, N.
    pub(crate) size: f64,
}

/// The dry friction in the pairs of some links in a position: of a pin on that of its links which is one of these, of a slide on the
/// sliding link; empty where it is not determined.
pub(crate) fn rubbing(results: &Results, position: usize, links: &[LinkId]) -> Vec<Rubbing> {
    let Some(found) = results.found.as_deref() else { return Vec::new() };
    let (table, _) = found.rows();
    let Some(row) = table.row_of(position) else { return Vec::new() };
    let mechanism = &found.linkage.mechanism;
    let of_pair = |friction: &Friction| {
        let (pair, bearings) = (friction.pair, mechanism.friction_links(friction));
        let several = bearings.len() > 1;
        let own = bearings.into_iter().filter(|two| two.iter().any(|link| links.contains(link)));
        let of = move |[link, on]: [LinkId; 2]| {
            let value = table.get(row, column(pair, link, several)).filter(|value| value.is_finite())?;
            // On the owner of the journal a moment has the other sign.
            let is_own = links.contains(&link) || matches!(pair, PairId::Slide(_));
            let (links, size) = if is_own { ([link, on], value) } else { ([on, link], -value) };
            let further = several.then(|| name(link.to_string()));
            let [symbol, told] = words(mechanism, pair, links[0], further);
            Some(Rubbing { pair, links, symbol, told, size })
        };
        own.filter_map(of).collect::<Vec<_>>()
    };
    mechanism.frictions.iter().flat_map(of_pair).collect()
}

/// The column of the friction of a pair on the link that turns or slides; a pin on which several links turn has one for each.
fn column(pair: PairId, link: LinkId, several: bool) -> Column {
    let quantity = match pair {
        PairId::Pin(_) => Quantity::FrictionMoment,
        PairId::Slide(_) => Quantity::FrictionForce,
    };
    Column::of(quantity, if several { Owner::PairOn(pair, link) } else { Owner::Pair(pair) })
}

/// The symbol of the friction of a pair with a further index, and what it is on a link.
fn words(mechanism: &Mechanism, pair: PairId, link: LinkId, further: Option<Text>) -> [Text; 2] {
    let schema = Schema::new(mechanism);
    let of = catalogue::owner(&schema, Column::of(Quantity::Force, Owner::PairOn(pair, link)));
    let (letter, named, told) = match pair {
        PairId::Pin(id) => ("M", &mechanism.points[id].name, text!("acting-friction", of)),
        PairId::Slide(id) => ("F", &mechanism.slides[id].name, text!("acting-friction-of-slide", of)),
    };
    let index = [text!("index-of-friction"), Text::from(named)].into_iter().chain(further);
    [name(letter).below(joined(",", index)), told]
}
