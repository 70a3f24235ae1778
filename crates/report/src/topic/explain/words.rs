//! Links and groups in words; stages and remarks.

use assur_book::link_name;
use assur_mechanism::{LinkId, Mechanism};
use assur_structure::Structure;
use assur_words::{Text, list};

/// Names of links.
pub(super) fn links(mechanism: &Mechanism, ids: &[LinkId]) -> Text {
    list(ids.iter().map(|&id| link_name(mechanism, id)))
}

/// The names of the groups that are not selected; of many only the first ones.
pub(super) fn others(mechanism: &Mechanism, structure: &Structure, chosen: &[bool]) -> Text {
    let left = (0..chosen.len()).filter(|index| !chosen[*index]);
    super::first_of(left.map(|index| structure.group_name(mechanism, index)).collect())
}

/// One stage of the calculation.
pub(super) struct Stage {
    /// The result of the stage.
    pub(super) name: Text,
    /// Why it is run; or why not, and what would make it run.
    pub(super) reason: Text,
    /// The method; `None` for a stage that is not run.
    pub(super) method: Option<Text>,
}

pub(super) fn run(name: Text, reason: Text, method: Text) -> Stage {
    Stage { name, reason, method: Some(method) }
}

pub(super) fn left_out(name: Text, reason: Text) -> Stage {
    Stage { name, reason, method: None }
}

/// One thing that is or is not modelled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Remark {
    /// The thing.
    pub(super) what: Text,
    /// How it is modelled; or why it is not, and how it could be included.
    pub(super) how: Text,
}

pub(super) fn remark(what: Text, how: Text) -> Remark {
    Remark { what, how }
}
