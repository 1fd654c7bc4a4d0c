//! The JSON schema of manifests, `docs/manifest.schema.json`: what the code says, and what manifests follow.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use terrane_codegen::manifest;

use super::accepted;
use super::texts::compare;

fn schema() -> Value {
    serde_json::from_str(&manifest::schema()).expect("a schema is JSON")
}

#[test]
fn the_schema_in_the_repository_is_that_of_the_code() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/manifest.schema.json");
    compare(&path, &manifest::schema()).unwrap_or_else(|report| panic!("{report}"));
}

#[test]
fn manifests_follow_the_schema() {
    for name in ["alpine.json", "dunes.json"] {
        let text = fs::read_to_string(accepted("snapshots").join(name)).expect("it is accepted");
        let manifest: Value = serde_json::from_str(&text).expect("a manifest is JSON");
        let schema = schema();
        assert_eq!(faults(&schema, &schema, &manifest, name), Vec::<String>::new());
    }
}

/// Everywhere that a value does not follow a schema. A keyword that is not known here is a fault too, and so is a member
/// that the schema does not tell of: JSON Schema itself would let both pass.
fn faults(root: &Value, schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let Some(schema) = schema.as_object() else { return Vec::new() };
    let mut found = Vec::new();
    for (keyword, rule) in schema {
        let holds = match keyword.as_str() {
            "$schema" | "$defs" | "title" | "description" | "default" | "required" => true,
            "$ref" => {
                let pointer = rule.as_str().and_then(|rule| rule.strip_prefix('#')).expect("within the schema");
                let target = root.pointer(pointer).unwrap_or_else(|| panic!("{pointer} leads nowhere"));
                found.extend(faults(root, target, value, at));
                true
            }
            "anyOf" => list(rule).iter().any(|one| faults(root, one, value, at).is_empty()),
            "type" => list(rule).iter().chain([rule]).any(|name| is(value, name)),
            "format" => fits(value, rule),
            "minimum" => value.as_f64().is_none_or(|number| Some(number) >= rule.as_f64()),
            "maximum" => value.as_f64().is_none_or(|number| Some(number) <= rule.as_f64()),
            "minItems" => list(value).len() as u64 >= rule.as_u64().unwrap_or(0),
            "maxItems" => list(value).len() as u64 <= rule.as_u64().unwrap_or(0),
            "items" => {
                let items = list(value).iter().enumerate();
                found.extend(items.flat_map(|(index, item)| faults(root, rule, item, &format!("{at}[{index}]"))));
                true
            }
            "properties" => {
                found.extend(members(root, rule, &schema.get("required").cloned().unwrap_or(json!([])), value, at));
                true
            }
            _ => false,
        };
        if !holds {
            found.push(format!("{at}: {value} breaks {keyword} {rule}"));
        }
    }
    found
}

fn members(root: &Value, properties: &Value, required: &Value, value: &Value, at: &str) -> Vec<String> {
    let Some(object) = value.as_object() else { return Vec::new() };
    let needed = list(required).iter().filter_map(Value::as_str).filter(|name| !object.contains_key(*name));
    let mut found: Vec<String> = needed.map(|name| format!("{at} has no {name}")).collect();
    for (name, member) in object {
        match properties.get(name) {
            Some(schema) => found.extend(faults(root, schema, member, &format!("{at}.{name}"))),
            None => found.push(format!("{at}.{name} is not in the schema")),
        }
    }
    found
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn is(value: &Value, name: &Value) -> bool {
    match name.as_str() {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("boolean") => value.is_boolean(),
        Some("integer") => value.is_i64() || value.is_u64(),
        Some("number") => value.is_number(),
        Some("null") => value.is_null(),
        _ => false,
    }
}

/// The formats that schemars gives to numbers.
fn fits(value: &Value, format: &Value) -> bool {
    match format.as_str() {
        Some("float" | "double") => true,
        Some("uint32") => value.as_u64().is_none_or(|number| u32::try_from(number).is_ok()),
        Some("uint16") => value.as_u64().is_none_or(|number| u16::try_from(number).is_ok()),
        _ => false,
    }
}

#[test]
fn a_manifest_that_does_not_follow_it_is_found_out() {
    let text = fs::read_to_string(accepted("snapshots").join("dunes.json")).expect("it is accepted");
    let manifest: Value = serde_json::from_str(&text).expect("a manifest is JSON");
    let broken = |pointer: &str, value: Value| {
        let mut manifest = manifest.clone();
        *manifest.pointer_mut(pointer).expect("it is there") = value;
        faults(&schema(), &schema(), &manifest, "dunes").len()
    };
    assert_eq!(broken("/version", json!("1")), 1);
    assert_eq!(broken("/terrain/size", json!([1.0])), 1);
    assert_eq!(broken("/textures/0/width", json!(-1)), 1);
    assert_eq!(broken("/samplers/0/max_anisotropy", json!(65536)), 2, "too large for the format and the maximum");
    assert_eq!(broken("/permutations/0/core", json!({ "path": "a", "hash": "b" })), 2, "one is missing, one unknown");
}
