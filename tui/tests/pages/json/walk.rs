//! A walk through a result and its schema together. It knows what docs/schema.json has of JSON Schema, and it says which parts of the
//! schema occurred, which validators don't.

use std::collections::HashSet;

use serde_json::Value;

/// The parts of a schema that occurred.
#[derive(Debug, Default)]
pub(super) struct Seen(HashSet<*const Value>);

impl Seen {
    /// The keys of a schema that never occurred.
    pub(super) fn never(&self, schema: &Value) -> Vec<String> {
        let mut missing = Vec::new();
        self.below(schema, "", &mut missing);
        for (name, part) in schema["$defs"].as_object().into_iter().flatten() {
            self.below(part, name, &mut missing);
        }
        missing
    }

    fn below(&self, part: &Value, path: &str, missing: &mut Vec<String>) {
        for (key, part) in part["properties"].as_object().into_iter().flatten() {
            let path = format!("{path}.{key}");
            if !self.0.contains(&std::ptr::from_ref(part)) {
                missing.push(path.clone());
            }
            self.below(part, &path, missing);
        }
        for below in ["items", "additionalProperties"].iter().filter_map(|key| part.get(key)) {
            self.below(below, path, missing);
        }
        for alternative in part["anyOf"].as_array().into_iter().flatten() {
            self.below(alternative, path, missing);
        }
    }
}

/// A part, or the definition to which it refers.
pub(super) fn resolved<'a>(schema: &'a Value, part: &'a Value) -> &'a Value {
    let name = part["$ref"].as_str().and_then(|reference| reference.strip_prefix("#/$defs/"));
    name.map_or(part, |name| &schema["$defs"][name])
}

/// The alternatives of a part: itself where it has none.
fn alternatives<'a>(schema: &'a Value, part: &'a Value) -> Vec<&'a Value> {
    let part = resolved(schema, part);
    part["anyOf"].as_array().map_or_else(|| vec![part], |all| all.iter().collect())
}

/// The part of a key of an object.
pub(super) fn child<'a>(schema: &'a Value, part: &'a Value, key: &str) -> Option<&'a Value> {
    let of = |part: &'a Value| {
        part["properties"].get(key).or(Some(&part["additionalProperties"]).filter(|all| all.is_object()))
    };
    alternatives(schema, part).into_iter().find_map(of)
}

/// Of a part that may be a number or an object the number.
pub(super) fn number<'a>(schema: &'a Value, part: &'a Value) -> &'a Value {
    alternatives(schema, part).into_iter().find(|one| one.get("unit").is_some()).unwrap_or(part)
}

/// Whether a value has a type of JSON Schema.
fn is(value: &Value, kind: &str) -> bool {
    match kind {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("type {other}"),
    }
}

/// Whether a value is of the type, the length and the choices of a part.
fn suits(part: &Value, value: &Value) -> bool {
    let kinds = match &part["type"] {
        Value::Array(kinds) => kinds.iter().filter_map(Value::as_str).collect(),
        kind => Vec::from_iter(kind.as_str()),
    };
    let is_choice = |choices: &Value| choices.as_array().is_none_or(|choices| choices.contains(value));
    let length = value.as_array().map(Vec::len);
    let is_long =
        |bound: &Value| bound.as_u64().zip(length).is_none_or(|(bound, length)| length as u64 == bound);
    (kinds.is_empty() || kinds.iter().any(|kind| is(value, kind)))
        && part.get("const").is_none_or(|only| only == value)
        && is_choice(&part["enum"])
        && is_long(&part["minItems"])
        && is_long(&part["maxItems"])
}

/// Goes through a result; an error says where it is not as its schema.
pub(super) fn walk(schema: &Value, result: &Value, seen: &mut Seen) -> Result<(), String> {
    go(schema, schema, result, seen)
}

fn go(schema: &Value, part: &Value, value: &Value, seen: &mut Seen) -> Result<(), String> {
    let mut refused = Ok(());
    for alternative in alternatives(schema, part) {
        refused = parts(schema, alternative, value, seen);
        if refused.is_ok() {
            return Ok(());
        }
    }
    refused
}

/// The parts of a value.
fn parts(schema: &Value, part: &Value, value: &Value, seen: &mut Seen) -> Result<(), String> {
    if !suits(part, value) {
        return Err(format!(" is {value}"));
    }
    for (number, item) in value.as_array().into_iter().flatten().enumerate() {
        go(schema, &part["items"], item, seen).map_err(|error| format!("/{number}{error}"))?;
    }
    let Some(object) = value.as_object() else { return Ok(()) };
    for key in part["required"].as_array().into_iter().flatten().filter_map(Value::as_str) {
        object.get(key).ok_or_else(|| format!(" lacks {key}"))?;
    }
    for (key, value) in object {
        let below = child(schema, part, key).ok_or_else(|| format!("/{key} is not in the schema"))?;
        seen.0.insert(std::ptr::from_ref(below));
        go(schema, below, value, seen).map_err(|error| format!("/{key}{error}"))?;
    }
    Ok(())
}
