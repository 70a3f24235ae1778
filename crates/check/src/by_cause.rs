//! Something for each load on each link.

use assur_force::Cause;

/// A load and the link on which it acts.
pub(crate) type Key = (Cause, usize);

/// Values in the order of their keys.
#[derive(Debug, Clone)]
pub(crate) struct ByCause<T>(Vec<(Key, T)>);

impl<T> ByCause<T> {
    /// From values in any order; `add` joins a value to another one of the same key.
    pub(crate) fn of(mut all: Vec<(Key, T)>, mut add: impl FnMut(&mut T, &T)) -> Self {
        all.sort_by_key(|(key, _)| *key);
        all.dedup_by(|other, kept| {
            let same = other.0 == kept.0;
            if same {
                add(&mut kept.1, &other.1);
            }
            same
        });
        Self(all)
    }

    /// The value of a load on a link; `None` where it does not act on it.
    pub(crate) fn get(&self, key: &Key) -> Option<&T> {
        self.0.binary_search_by(|(other, _)| other.cmp(key)).ok().map(|found| &self.0[found].1)
    }

    /// Keys and values in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (&Key, &T)> {
        self.0.iter().map(|(key, value)| (key, value))
    }

    /// The values in the order of their keys.
    pub(crate) fn values(&self) -> impl Iterator<Item = &T> {
        self.0.iter().map(|(_, value)| value)
    }
}
