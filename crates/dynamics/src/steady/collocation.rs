//! The rule of all panels of the path: Radau IIA of order 15. A steep motor characteristic on a small inertia is no obstacle.

use std::sync::LazyLock;

use assur_number::panel::Radau;

/// Number of nodes in (0, 1].
pub(crate) const S: usize = 8;

/// One number for the start of a panel and one for each node.
pub(crate) type Values = [f64; S + 1];

/// The rule, computed once.
pub(crate) static RULE: LazyLock<Radau<S, { S + 1 }>> = LazyLock::new(Radau::new);
