//! What is private in `mdr_reference::json`.

use super::*;
use proptest::prelude::*;
use serde_json::Value;

/// Whether a value equals the one that serde_json reads.
fn agrees(ours: &Json<'_>, theirs: &Value) -> bool {
    match (ours, theirs) {
        (Json::Null, Value::Null) => true,
        (Json::Bool(a), Value::Bool(b)) => a == b,
        (Json::Number(a), Value::Number(b)) => a.parse::<f64>().ok() == b.as_f64(),
        (Json::Text(a), Value::String(b)) => a == b,
        (Json::List(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| agrees(a, b)),
        (Json::Object(_), Value::Object(b)) => b.iter().all(|(key, b)| ours.get(key).is_some_and(|a| agrees(a, b))),
        _ => false,
    }
}

fn any_value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        any::<String>().prop_map(Value::from),
    ];
    leaf.prop_recursive(4, 32, 6, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..6).prop_map(Value::from),
            prop::collection::btree_map(any::<String>(), inner, 0..6)
                .prop_map(|map| Value::from(map.into_iter().collect::<serde_json::Map<_, _>>())),
        ]
    })
}

proptest! {
    #[test]
    fn reads_what_others_write(value in any_value()) {
        let text = value.to_string();
        let ours = read(&text).unwrap();
        prop_assert!(agrees(&ours, &value), "{text}");
        let written = ours.to_string();
        prop_assert_eq!(read(&written), Ok(ours.clone()));
        prop_assert_eq!(read_tolerant(&text), Ok(ours));
    }

    /// Every line is read or rejected.
    #[test]
    fn any_line_is_read_or_refused(text in "[\\[\\]{}\",:\\\\0-9eE+.#()ntrufals \\PC-]{0,40}") {
        let refused = read_tolerant(&text).is_err();
        prop_assert!(!refused || read(&text).is_err(), "{}", text);
    }

    #[test]
    fn others_read_what_is_quoted(text in any::<String>()) {
        prop_assert_eq!(serde_json::from_str::<String>(&quoted(&text)).unwrap(), text);
    }

    /// Never panics and never accepts what serde_json rejects.
    #[test]
    fn as_strict_as_others(text in "[\\[\\]{}\",:\\\\0-9eE+.ntrufals -]{0,24}") {
        let theirs = serde_json::from_str::<Value>(&text);
        match (read(&text), theirs) {
            (Ok(ours), Ok(theirs)) => prop_assert!(agrees(&ours, &theirs), "{}", text),
            (Ok(_), Err(error)) => prop_assert!(error.to_string().contains("out of range"), "{}: {}", text, error),
            (Err(error), Ok(_)) => prop_assert!(false, "{}: {}", text, error),
            (Err(_), Err(_)) => {}
        }
    }
}

#[test]
fn words_without_quotation_marks() {
    for word in ["NaN", "-nan(ind)", "1.#QNAN", "-inf", "0x1.8p-3", "5.", ".5", "+1", "1e5"] {
        assert_eq!(read_tolerant(word), Ok(Json::Number(word.into())));
        assert_eq!(read(word).is_ok(), word == "1e5", "{word}");
    }
    let line = read_tolerant("{\"value\":-nan,\"error\": null ,\"list\":[inf,true]}").unwrap();
    assert_eq!(line.get("value"), Some(&Json::Number("-nan".into())));
    assert_eq!(line.get("error"), Some(&Json::Null));
    assert_eq!(line.get("list"), Some(&Json::List(vec![Json::Number("inf".into()), Json::Bool(true)])));
    assert!(read_tolerant("{\"value\":}").is_err() && read_tolerant("{\"value\":nan inf}").is_err());
}

#[test]
fn surrogates_and_depth() {
    assert_eq!(read(r#""\ud83d\ude00""#), Ok(Json::Text("😀".into())));
    assert!(read(r#""\ud83d""#).is_err() && read(&"[".repeat(10_000)).is_err());
}
