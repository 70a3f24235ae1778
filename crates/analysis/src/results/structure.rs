//! Mobility, groups and formula as results show them.

use serde::Serialize;

/// Mobility, groups and formula.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StructureReport {
    /// Mobility by Chebyshev's formula.
    pub mobility: i64,
    /// Mobility by the rank of the constraints in the first position, where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mobility_by_rank: Option<usize>,
    /// What a difference of the two means, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// Class of the mechanism.
    pub class: u8,
    /// `I(ground,crank) -> II3(stone2,rocker)`.
    pub formula: String,
    /// Number of moving links.
    pub moving_links: usize,
    /// Number of pairs (a joint of k links counts k - 1).
    pub pairs: usize,
    /// The groups in solving order.
    pub groups: Vec<GroupReport>,
}

/// One group.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct GroupReport {
    /// The registered kind: `RPR`.
    pub kind: String,
    /// Class.
    pub class: u8,
    /// Type within the class; 0 where the class has no numbered types.
    #[serde(rename = "type")]
    pub number: u8,
    /// Order.
    pub order: u8,
    /// Its links.
    pub links: Vec<String>,
    /// Pairs between its links.
    pub inner: Vec<String>,
    /// Pairs to links solved before.
    pub outer: Vec<String>,
    /// The assembly in the first position, counted as the kind documents.
    pub way: u8,
    /// In how many ways it can be assembled.
    pub ways: usize,
}
