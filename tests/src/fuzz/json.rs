//! JSON in which no key of an object may stand twice, and only what may be undetermined is null.

use std::collections::BTreeSet;
use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Unexpected, Visitor};

/// Keys whose value is null where a check is not conclusive, or has no reason for that; where its residual or limit is no number; where a note is about no key; where a kind of
/// groups can't list its modes, or one of them is singular; where a position without a solution has no limit, or an efficiency is undetermined; where
/// dry friction holds a motion at rest; where no length of a passive part has to change.
const MAY_BE_NULL: [&str; 12] = [
    "ok",
    "why",
    "key",
    "way",
    "ways",
    "modes",
    "condition",
    "residual",
    "limit",
    "efficiency",
    "balancing",
    "closes",
];

/// Keys under which, at any depth, values are null that dry friction at rest leaves undetermined.
const UNDETERMINED: [&str; 2] = ["reactions", "friction"];

/// Reads a value and keeps nothing of it.
#[derive(Clone, Copy, Default)]
struct Unique {
    may_be_null: bool,
    /// Whether each value of the object may be: the works of pairs, where a position of the cycle has no solution.
    each_may_be_null: bool,
    /// Whether all values under it may be.
    undetermined: bool,
}

impl<'de> DeserializeSeed<'de> for Unique {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Unique {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value without null")
    }

    fn visit_unit<E: Error>(self) -> Result<(), E> {
        if self.may_be_null { Ok(()) } else { Err(E::invalid_type(Unexpected::Unit, &self)) }
    }

    fn visit_bool<E>(self, _: bool) -> Result<(), E> {
        Ok(())
    }

    fn visit_i64<E>(self, _: i64) -> Result<(), E> {
        Ok(())
    }

    fn visit_u64<E>(self, _: u64) -> Result<(), E> {
        Ok(())
    }

    fn visit_f64<E>(self, _: f64) -> Result<(), E> {
        Ok(())
    }

    fn visit_str<E>(self, _: &str) -> Result<(), E> {
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        while list.next_element_seed(Self::default())?.is_some() {}
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        let mut keys = BTreeSet::new();
        while let Some(key) = map.next_key::<String>()? {
            let may_be_null =
                self.each_may_be_null || self.undetermined || MAY_BE_NULL.contains(&key.as_str());
            let each_may_be_null = key == "friction_work";
            let undetermined = self.undetermined || UNDETERMINED.contains(&key.as_str());
            map.next_value_seed(Self { may_be_null, each_may_be_null, undetermined })?;
            if let Some(twice) = keys.replace(key) {
                return Err(A::Error::custom(format!("the key `{twice}` stands twice")));
            }
        }
        Ok(())
    }
}

/// Whether a text is JSON without a null where none may be and without a key that stands twice in its object.
///
/// # Errors
///
/// What is wrong, and where.
pub(super) fn check(text: &str) -> Result<(), serde_json::Error> {
    let mut deserializer = serde_json::Deserializer::from_str(text);
    Unique::default().deserialize(&mut deserializer)?;
    deserializer.end()
}

#[test]
fn a_key_that_stands_twice_is_found() {
    assert!(check(r#"{"a": [1, {"b": 2.5}], "c": "x", "d": true}"#).is_ok());
    assert!(check(r#"{"a": [{"b": 1, "c": 2, "b": 3}]}"#).unwrap_err().to_string().contains("`b`"));
    assert!(check(r#"{"a": null}"#).is_err() && check(r#"{"ok": [null]}"#).is_err() && check("{}x").is_err());
    assert!(check(r#"{"reactions": {"A": {"crank": null}}}"#).is_ok());
    assert!(check(r#"{"a": [{"ok": null, "why": "so"}, {"ok": true, "why": null}]}"#).is_ok());
}
