//! Every published line is valid against the published JSON Schema.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use regex_lite::Regex;
use serde_json::Value;

const SCHEMA: &str = include_str!("../../../docs/reference/record.schema.json");

/// The keywords that the schema uses; another one would not be checked here, so it fails the test.
const KEYWORDS: [&str; 16] = [
    "$schema",
    "$defs",
    "$ref",
    "title",
    "description",
    "type",
    "required",
    "properties",
    "additionalProperties",
    "minProperties",
    "pattern",
    "minimum",
    "enum",
    "anyOf",
    "items",
    "minItems",
];

/// The errors of a value, with their location.
fn errors(root: &Value, schema: &Value, value: &Value, at: &str, found: &mut Vec<String>) {
    for key in schema.as_object().unwrap().keys() {
        assert!(KEYWORDS.contains(&key.as_str()), "{key} is not understood");
    }
    let mut report = |holds: bool, keyword: &str| {
        if !holds {
            found.push(format!("{at}: {keyword}: {value}"));
        }
    };
    if let Some(kind) = schema.get("type") {
        let kinds: Vec<_> = kind.as_array().map_or(vec![kind], |kinds| kinds.iter().collect());
        report(kinds.iter().any(|kind| is_a(value, kind.as_str().unwrap())), "type");
    }
    if let Some(allowed) = schema.get("enum") {
        report(allowed.as_array().unwrap().contains(value), "enum");
    }
    if let (Some(pattern), Some(text)) = (schema.get("pattern"), value.as_str()) {
        report(Regex::new(pattern.as_str().unwrap()).unwrap().is_match(text), "pattern");
    }
    if let (Some(minimum), Some(number)) = (schema.get("minimum"), value.as_f64()) {
        report(number >= minimum.as_f64().unwrap(), "minimum");
    }
    if let (Some(least), Some(object)) = (schema.get("minProperties"), value.as_object()) {
        report(object.len() as u64 >= least.as_u64().unwrap(), "minProperties");
    }
    if let (Some(least), Some(list)) = (schema.get("minItems"), value.as_array()) {
        report(list.len() as u64 >= least.as_u64().unwrap(), "minItems");
    }
    if let (Some(required), Some(object)) = (schema.get("required"), value.as_object()) {
        report(required.as_array().unwrap().iter().all(|key| object.contains_key(key.as_str().unwrap())), "required");
    }
    if let Some(choices) = schema.get("anyOf") {
        let fits = |choice: &Value| {
            let mut wrong = Vec::new();
            errors(root, choice, value, at, &mut wrong);
            wrong.is_empty()
        };
        report(choices.as_array().unwrap().iter().any(fits), "anyOf");
    }
    if let Some(reference) = schema.get("$ref") {
        let target = root.pointer(reference.as_str().unwrap().strip_prefix('#').unwrap()).unwrap();
        errors(root, target, value, at, found);
    }
    members(root, schema, value, at, found);
}

/// The members of objects and lists.
fn members(root: &Value, schema: &Value, value: &Value, at: &str, found: &mut Vec<String>) {
    for (key, member) in value.as_object().into_iter().flatten() {
        let at = format!("{at}/{key}");
        match (schema.get("properties").and_then(|known| known.get(key)), schema.get("additionalProperties")) {
            (Some(schema), _) => errors(root, schema, member, &at, found),
            (None, Some(Value::Bool(false))) => found.push(format!("{at}: not in the schema")),
            (None, Some(schema)) => errors(root, schema, member, &at, found),
            (None, None) => {}
        }
    }
    if let (Some(schema), Some(list)) = (schema.get("items"), value.as_array()) {
        list.iter().for_each(|member| errors(root, schema, member, at, found));
    }
}

fn is_a(value: &Value, kind: &str) -> bool {
    match kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "integer" => value.is_u64() || value.is_i64(),
        "number" => value.is_number(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        _ => panic!("{kind} is not understood"),
    }
}

fn wrong(line: &str) -> Vec<String> {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let mut found = Vec::new();
    errors(&schema, &schema, &serde_json::from_str(line).unwrap(), "", &mut found);
    found
}

#[test]
fn every_line_is_valid() {
    for line in mdr_reference::lines() {
        assert_eq!(wrong(line), [""; 0]);
    }
}

#[test]
fn what_is_not_a_record_is_noticed() {
    let line = mdr_reference::lines().next().unwrap();
    for (from, to) in [
        ("\"status\":\"ok\"", "\"status\":\"fine\""),
        ("\"mid\":\"2.", "\"mid\":\"two."),
        ("\"digits\":50", "\"digits\":\"50\""),
        ("\"control\":null", "\"control\":\"weight\""),
        ("\"release\":1,", ""),
        ("\"release\":1,", "\"release\":1,\"colour\":\"red\","),
        ("\"rigorous\":true", "\"rigorous\":1"),
    ] {
        assert!(line.contains(from) && !wrong(&line.replace(from, to)).is_empty(), "{from} -> {to}");
    }
}
