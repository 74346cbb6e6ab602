//! Formulas that a search in f64 does not resolve, and searches that would not end: within a budget, an open result is not stated
//! and takes nothing else with it.
#![cfg(all(feature = "mp", feature = "serde", feature = "toml"))]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use mdr::no_files;
use mdr::prelude::*;
use serde_json::Value;

fn scene(text: &str) -> Scene {
    Scene::from_toml(text, "scene.toml", &no_files).unwrap_or_else(|error| panic!("{error}"))
}

fn solved(text: &str) -> Value {
    let answer = scene(text).solve().unwrap_or_else(|error| panic!("{error}"));
    serde_json::from_str(&answer.to_json()).unwrap()
}

fn formula(formula: &str, rest: &str) -> String {
    format!(
        "material = {{ e_star = 1, work_of_adhesion = \"1e-4\" }}
        profile = {{ kind = \"expression\", formula = \"{formula}\" }}\n{rest}"
    )
}

fn dip(s: &str) -> String {
    format!("r^2/2 - 0.2*(exp(-((r-0.5037)/{s})^2) - exp(-(0.5037/{s})^2))")
}

/// The surfaces overlap by 0.073 at the bottom of the dip, whose width is 10⁻³ … 10⁻⁹ of its radius.
#[test]
fn no_state_beside_a_narrow_dip_is_called_admissible() {
    for s in ["5e-4", "1e-6", "1e-9"] {
        let answer = |arithmetic: &str| {
            let rest = format!("output = {{ want = [\"equilibria\"], equilibria.at = [0], {arithmetic} }}");
            solved_within(&formula(&dip(s), &rest), 3.0)
        };
        let searched = answer("arithmetic = \"f64\"");
        for state in searched["equilibria"][0]["equilibria"].as_array().unwrap() {
            assert!(state["admissible"] != true, "{searched}");
            assert!(state["admissible"] == false || state["why"].as_str().unwrap().contains("formula"), "{searched}");
        }
        assert!(searched["admissibility"].as_str().unwrap().contains("not decided"), "{searched}");
        let width = searched["admissibility_resolved_width"].as_f64().unwrap();
        assert!(width > 1e-6 && width < 10.0, "{width}");
        // Enclosures of the gap prove it.
        let proved = answer("digits = 5");
        let states = proved["equilibria"][0]["equilibria"].as_array().unwrap();
        // A contact that has closed the dip has none outside.
        let radius = |state: &Value| state["contact_radius"].as_str().map(|radius| radius.parse::<f64>().unwrap());
        let beside = |state: &&Value| radius(state).is_none_or(|radius| radius < 0.5037);
        assert!(states.iter().any(|state| beside(&state)), "{proved}");
        assert!(states.iter().filter(beside).all(|state| state["admissible"] == false), "{proved}");
        assert_eq!(proved["promise"]["admissible"], "certified", "{proved}");
    }
}

/// Separated surfaces first touch at min f, not at the tip.
#[test]
fn surfaces_first_touch_in_a_narrow_dip() {
    for s in ["5e-4", "1e-6", "1e-9"] {
        let rest = "control = { kind = \"indentation\", path = [-1, 0.01], start = \"detached\" }
            output = { want = [\"path\"], arithmetic = \"f64\" }";
        let answer = solved(&formula(&dip(s), rest));
        let event = &answer["path"][1];
        assert_eq!((&event["event"], &event["admissible"]), (&"not-admissible".into(), &false.into()), "{answer}");
        let depth = event["indentation"].as_f64().unwrap();
        let c: f64 = 0.5037;
        assert!((depth - (c * c / 2.0 - 0.2)).abs() < 1e-6, "{depth}");
        let ring = event["interpenetration"]["r"].as_str().map_or_else(
            || event["interpenetration"][0]["r"].as_str().unwrap().parse::<f64>().unwrap(),
            |text| text.parse::<f64>().unwrap(),
        );
        assert!((ring - c).abs() < 1e-5, "{answer}");
    }
}

/// Where surfaces first touch is proved without a fold: a path of surfaces that stay apart comes to none.
#[test]
fn surfaces_that_stay_apart_need_no_folds() {
    for (s, end) in [("1e-6", "0.01"), ("1e-9", "0.01"), ("1e-9", "-0.1")] {
        let rest = format!(
            "control = {{ kind = \"indentation\", path = [-1, \"{end}\"], start = \"detached\" }}
            output = {{ want = [\"path\"], digits = 15 }}"
        );
        let answer = solved(&formula(&dip(s), &rest));
        assert_eq!(answer["promise"]["path"], "certified", "{answer}");
        assert_eq!(answer["complete"]["path"]["proved"], true, "{answer}");
        let event = &answer["path"][1];
        if end == "-0.1" {
            assert_eq!(event["event"], "end", "{answer}");
            continue;
        }
        assert_eq!(event["event"], "not-admissible", "{answer}");
        // f(c + ε) = c²/2 − 0.2 + cε + ε²/2 + 0.2ε²/s² − …, least at ε = −cs²/0.4.
        let [c, s]: [f64; 2] = [0.5037, s.parse().unwrap()];
        let lowest = c * c / 2.0 - 0.2 - (c * s).powi(2) / 0.8;
        let depth: f64 = event["indentation"].as_str().unwrap().parse().unwrap();
        assert!((depth - lowest).abs() < 1e-15, "{depth} {lowest}");
    }
}

/// Rings of one height without end: where the surfaces touch is not decided, and the path has that status.
#[test]
fn an_unknown_first_touch_is_undecided() {
    let rest = "control = { kind = \"indentation\", path = [-3, 0.01], start = \"detached\" }
        output = { want = [\"path\", \"transform\"], transform.at = [0.1], arithmetic = \"f64\" }";
    let answer = solved_within(&formula("cos(r) - 1", rest), 1.0);
    let last = answer["path"].as_array().unwrap().last().unwrap();
    assert_eq!(last["event"], "undecided", "{answer}");
    assert_eq!(answer["transform"][0]["status"], "ok", "{answer}");
}

/// r² grows in the profile and below it: far out neither says anything alone.
#[test]
fn a_quotient_that_levels_off_is_known_far_out() {
    let rest = "output = { want = [\"equilibria\"], equilibria.at = [\"0.001\"], digits = 5 }";
    for text in ["r^2/(1 + r^2)", "1 - 1/(1 + r^2)"] {
        let answer = solved(&formula(text, rest));
        assert_eq!(answer["equilibria"][0]["equilibria"][0]["admissible"], true, "{answer}");
    }
}

/// f' + r f'' ≥ 0: every state is admissible, by a proof.
#[test]
fn formulas_that_rise_are_admissible() {
    for text in ["r^2/2", "r^2/2 + 0.001*(1-cos(10*r))", "max(0.02*r, r^2/2) + 0.2*max(0, r - 0.1)"] {
        let rest = "output = { want = [\"equilibria\"], equilibria.at = [\"0.01\"], arithmetic = \"f64\" }";
        let answer = solved(&formula(text, rest));
        assert_eq!(answer["equilibria"][0]["equilibria"][0]["admissible"], true, "{answer}");
        assert!(answer["admissibility"].as_str().unwrap().contains("falls nowhere"), "{answer}");
        assert!(answer["admissibility_resolved_width"].is_null(), "{answer}");
    }
}

/// The contact ceases to be admissible at a = 0.0922972, d = 0.00775725, because of the ring at r = 0.12309. The other output is
/// there whatever becomes of the path.
#[test]
fn a_path_that_leaves_admissibility_takes_nothing_with_it() {
    for arithmetic in ["arithmetic = \"f64\"", "digits = 6"] {
        let text = format!(
            "material = {{ e_star = 1, work_of_adhesion = \"1e-6\" }}
            profile = {{ kind = \"expression\", formula = \"r^2/2 - 0.1*max(0,r-0.1)\" }}
            control = {{ kind = \"indentation\", path = [0, 1], start = \"smallest\" }}
            output = {{ want = [\"path\", \"transform\"], transform.at = [\"0.05\"], {arithmetic} }}"
        );
        let answer = solved(&text);
        assert_eq!(answer["transform"][0]["status"], "ok");
        let last = answer["path"].as_array().unwrap().last().unwrap();
        let number = |key: &str| match &last[key] {
            Value::String(text) => text.parse::<f64>().unwrap(),
            value => value.as_f64().unwrap_or(f64::NAN),
        };
        match last["event"].as_str().unwrap() {
            "not-admissible" => {
                assert!((number("contact_radius") / 0.092_297_2 - 1.0).abs() < 1e-5, "{answer}");
                assert!((number("indentation") / 0.007_757_25 - 1.0).abs() < 1e-5, "{answer}");
            }
            other => assert_eq!(other, "undecided", "{answer}"),
        }
    }
}

/// Searches that did not end. The budget is of work, so that a test may bound it tightly.
#[test]
fn searches_end_within_their_budget() {
    for (material, profile, path) in [
        ("e_star = \"1e6\", work_of_adhesion = \"1e-4\"", "kind = \"expression\", formula = \"sin(r)\"", "1, 5"),
        (
            "e_star = 1, work_of_adhesion = \"1e-4\"",
            "kind = \"wavy-paraboloid\", radius = 1, amplitude = \"1e6\", wavelength = \"0.1\"",
            "0, 1",
        ),
    ] {
        let text = format!(
            "material = {{ {material} }}\nprofile = {{ {profile} }}
            control = {{ kind = \"indentation\", path = [{path}] }}
            output = {{ want = [\"path\", \"transform\"], transform.at = [\"0.05\"], arithmetic = \"f64\" }}"
        );
        let answer = scene(&text).solve_with(&mut Run::new(&mut (), Stop::default()).within(0.1));
        let answer: Value = serde_json::from_str(&answer.unwrap().to_json()).unwrap();
        assert_eq!(answer["transform"][0]["status"], "ok", "{answer}");
        assert!(!answer["path"].as_array().unwrap().is_empty(), "{answer}");
        assert_eq!(answer["complete"]["path"]["proved"], false, "{answer}");
        let why = answer["complete"]["path"]["why"].as_str().unwrap();
        assert!(why.contains("not resolved everywhere") || why.contains("budget"), "{why}");
    }
}

/// Waves without end lie beyond the contact: on the way of a path the folds of F are resolved, and F has its minimum at that of
/// the shape.
#[test]
fn a_wave_as_a_formula_has_a_minimum_force() {
    let rest = "control = { kind = \"indentation\", path = [\"0.004\", \"-0.005\"] }
        output = { want = [\"force-curve\"], points = 20, arithmetic = \"f64\" }";
    let shape = "kind = \"wavy-paraboloid\", radius = 1, amplitude = \"5e-4\", wavelength = \"0.1\"";
    let wave = formula("r^2/2 + 5e-4*(1 - cos(2*pi*r/0.1))", rest);
    let of_shape = format!("material = {{ e_star = 1, work_of_adhesion = \"1e-4\" }}\nprofile = {{ {shape} }}\n{rest}");
    let [one, other] = [wave, of_shape].map(|text| solved(&text)["force-curve-summary"].clone());
    let [least, of_shape] = [&one, &other].map(|summary| summary["minimum_force"].as_f64().expect("a minimum"));
    assert!((least / of_shape - 1.0).abs() < 1e-12, "{one} {other}");
    // Below every sample.
    assert!(least < -0.00067, "{least}");
}

/// In doubles r² of a small contact is 0, and with it the slope of √(r²) infinite: what is not seen is not denied. A proof sees the plain
/// cone of slope 1, at the radius 8w/πE*.
#[test]
fn a_height_whose_parts_underflow_leaves_the_start_open() {
    for (formula, modulus, budget, first) in [
        ("(r^2)^0.5", "1e300", 10.0, "start"),
        ("sqrt(r^2 + r^4)", "1e200", 10.0, "start"),
        ("(r^4)^0.25", "1e200", 1.0, "undecided"),
    ] {
        let text = format!(
            "material = {{ e_star = \"{modulus}\", work_of_adhesion = \"1e-4\" }}
            profile = {{ kind = \"expression\", formula = \"{formula}\" }}
            control = {{ kind = \"indentation\", path = [0, \"-0.01\"] }}
            output = {{ want = [\"folds\", \"path\"], arithmetic = \"f64\" }}"
        );
        let answer = solved_within(&text, budget);
        let start = &answer["path"][0];
        assert_eq!(start["event"], first, "{answer}");
        if first == "start" {
            let radius = 8e-4 / (std::f64::consts::PI * modulus.parse::<f64>().unwrap());
            assert_eq!(answer["complete"]["path"]["proved"], true, "{answer}");
            assert!((start["contact_radius"].as_f64().unwrap() / radius - 1.0).abs() < 1e-12, "{answer}");
        }
        let why = answer["complete"]["folds"]["why"].as_str().unwrap();
        assert!(why.contains("not resolved everywhere"), "{why}");
    }
}

/// Of w/E* that no double holds, nothing is searched.
#[test]
fn ratios_out_of_range_are_refused() {
    for (modulus, work) in [("1e300", "1e-300"), ("1e-200", "1e200")] {
        let text = format!(
            "material = {{ e_star = \"{modulus}\", work_of_adhesion = \"{work}\" }}
            profile = {{ kind = \"expression\", formula = \"r^2/2\" }}
            control = {{ kind = \"indentation\", path = [1, 5] }}
            output = {{ want = [\"path\"], arithmetic = \"f64\" }}"
        );
        let error = scene(&text).solve().unwrap_err().to_string();
        assert!(error.contains("material.work_of_adhesion") && error.contains("ratio to E*"), "{error}");
    }
}

/// A formula that is a sum of powers has the closed forms of the shapes: all digits, each certified, as those of a sum of shapes.
#[test]
fn sums_of_powers_are_closed_forms() {
    let rest = "control = { kind = \"indentation\", path = [0, \"0.3\"] }
        output = { want = [\"folds\", \"path\", \"equilibria\", \"energy\"], equilibria.at = [\"0.01\"] }";
    let power = |n: &str, c: &str| format!("{{ kind = \"power\", n = \"{n}\", c = \"{c}\" }}");
    let sum = |terms: &[String]| format!("{{ kind = \"sum\", term = [{}] }}", terms.join(", "));
    for (text, shapes) in [
        ("r^(7/3)", power("7/3", "1")),
        ("r^2+0.1*r^0.7", sum(&[power("0.7", "0.1"), power("2", "1")])),
        ("sqrt(r)*(r/4 + r^2)", sum(&[power("3/2", "1/4"), power("5/2", "1")])),
    ] {
        let (written, shaped) = (
            formula(text, rest),
            formula(text, rest).replace(&format!("{{ kind = \"expression\", formula = \"{text}\" }}"), &shapes),
        );
        let [mut answer, other] = [&written, &shaped].map(|text| solved(text));
        assert_eq!(answer["profile"], "expression");
        for (output, promise) in answer["promise"].as_object().unwrap() {
            assert_eq!(promise, "certified", "{text}: {output}");
        }
        answer["profile"] = other["profile"].clone();
        assert_eq!(answer, other, "{text}");
    }
}

/// A bend and a kink that are written in different ways, at one radius.
#[test]
fn kinks_at_one_radius_are_proved() {
    let answer =
        solved(&formula("min(r^2, 0.04) + 0.2*max(0, r - 1/5)", "output = { want = [\"folds\"], digits = 5 }"));
    assert_eq!(answer["promise"]["folds"], "certified", "{answer}");
    assert_eq!(answer["complete"]["folds"]["proved"], true, "{answer}");
}

/// A wave without end has folds without number; those in a range need no search, and neither do their gaps.
#[test]
fn folds_of_an_endless_wave_are_proved_in_a_range() {
    let answer = solved(&formula("1 - cos(r)", "output = { want = [\"folds\"], digits = 5, folds.range = [2, 3] }"));
    assert_eq!(answer["promise"]["folds"], "certified", "{answer}");
    let [fold] = answer["folds"].as_array().unwrap().as_slice() else { panic!("{answer}") };
    // The next crest is above the indentation: f(2π) = 0 < d.
    assert_eq!((&fold["kind"], &fold["admissible"]), (&"maximum".into(), &false.into()), "{answer}");
}

/// Terms that cancel at the tip hide there in doubles, and in any precision at a radius small enough, that the profile tends to 0.
#[test]
fn formulas_that_cancel_at_the_tip_are_read() {
    let read = |text: &str| Formula::new(text, std::collections::BTreeMap::new()).map_err(|error| error.to_string());
    for text in [
        "(exp(r^2)-1-r^2)/r^2",
        "(exp(r^2)-1-r^2-r^4/2)/r^3",
        "(1-cos(r))/r",
        "1-sin(r)/r",
        "r-tanh(r)",
        "sin(r)/cos(r)-r",
        "ln(cosh(r))",
        "(cosh(r)-1)/r",
        "r^2/(1+sqrt(1-r^2))",
        "sqrt(1+r^2)-1",
        "exp(r)-1-r",
        "(1-cos(r)*exp(r^2))/r",
        "r*ln(1+1/r)",
    ] {
        assert!(read(text).is_ok(), "{text}: {:?}", read(text));
    }
    for text in ["1+r^2", "cos(r)", "(1+r^2)/(1+r)", "sin(r)/r", "1/r", "ln(r)", "1e-40*sin(r)/r + r"] {
        let error = read(text).expect_err(text);
        assert!(error.contains("not zero at the tip") || error.contains("not seen to tend to 0"), "{error}");
    }
}

/// In doubles such terms are lost next to the tip: enclosures have the number, or there is none.
#[test]
fn numbers_that_cancel_in_doubles_are_no_numbers() {
    let near: [(&str, [f64; 2]); 4] = [
        // C x^n times √π Γ(n/2 + 1)/Γ((n + 1)/2), and the slope: g of the leading term.
        ("exp(r)-1-r", [1.0, 2.0]),
        ("(exp(r^2)-1-r^2)/r^2", [1.0, 2.0]),
        ("1-sin(r)/r", [1.0 / 3.0, 2.0]),
        ("r-tanh(r)", [std::f64::consts::PI / 4.0, 3.0]),
    ];
    let mut proved = 0;
    for (text, [factor, n]) in near {
        let rest =
            "output = { want = [\"transform\"], transform.at = [\"1e-5\", \"1e-8\", \"1e-12\"], arithmetic = \"f64\" }";
        let answer = solved(&formula(text, rest));
        for sample in answer["transform"].as_array().unwrap() {
            let x: f64 = sample["x"].as_str().unwrap().parse().unwrap();
            let Some(g) = sample["g"].as_f64() else {
                assert_eq!(sample["status"], "undecided", "{text}: {sample}");
                continue;
            };
            assert!((g / (factor * x.powf(n)) - 1.0).abs() < 1e-4, "{text}: {sample}");
            proved += 1;
        }
    }
    assert!(proved >= 6, "{proved}");
}

/// g of ln(1 + r²) rises, though ever slower: the form tells what enclosures over all radii do not.
#[test]
fn a_logarithm_rises_by_its_form() {
    let rest = "output = { want = [\"equilibria\"], equilibria.at = [\"0.1\"], arithmetic = \"f64\" }";
    let answer = solved(&formula("ln(1 + r^2)", rest));
    let states = answer["equilibria"][0]["equilibria"].as_array().unwrap();
    assert!(states.len() == 2 && states.iter().all(|state| state["admissible"] == true), "{answer}");
}

fn solved_within(text: &str, seconds: f64) -> Value {
    let answer = scene(text).solve_with(&mut Run::new(&mut (), Stop::default()).within(seconds));
    serde_json::from_str(&answer.unwrap().to_json()).unwrap()
}

/// Folds that a search has found are there when the budget does not suffice to prove them.
#[test]
fn folds_that_are_not_proved_are_doubles() {
    let answer = solved_within(&formula("1 - cos(r)", "output = { want = [\"folds\"] }"), 0.65);
    assert_eq!(answer["promise"]["folds"], "f64", "{answer}");
    assert_eq!(answer["complete"]["folds"]["undecided"], true, "{answer}");
    let why = answer["complete"]["folds"]["why"].as_str().unwrap();
    assert!(why.contains("the budget was spent before this was proved"), "{why}");
    // The one of the paraboloid r²/2 at w/E* = 1e-4, nearly: πwR/3 of the force at the pull-off in depth is 5/6.
    let folds = answer["folds"].as_array().unwrap();
    let jkr = -std::f64::consts::PI * 1e-4 * 5.0 / 6.0;
    assert!(folds.len() > 80 && (folds[0]["force"].as_f64().unwrap() / jkr - 1.0).abs() < 1e-3, "{}", folds[0]);
}

/// Of folds that are proved, but not to all digits, those that are known are printed.
#[test]
fn proved_folds_have_the_digits_that_the_budget_allows() {
    let wave = formula("r^2/2 + 0.01*(1 - cos(20*r))", "output = { want = [\"folds\"], digits = 300 }");
    let answer = solved_within(&wave, 0.95);
    let folds = answer["folds"].as_array().unwrap();
    let digits =
        |fold: &Value| ["contact_radius", "indentation", "force"].map(|key| fold[key].as_str().expect("digits").len());
    assert!(folds[0]["contact_radius"].as_str().unwrap().starts_with("0.01170028112263"), "{answer}");
    assert_eq!(answer["promise"]["folds"], "certified", "{answer}");
    assert!(
        digits(&folds[0]).iter().all(|count| *count > 300) && digits(&folds[2]).iter().all(|count| *count < 30),
        "{answer}"
    );
}

/// Folds that are proved stand when the budget is spent before all radii were looked at.
#[test]
fn folds_that_are_proved_outlast_the_budget() {
    let text = "material = { e_star = \"1e6\", work_of_adhesion = \"0.05\" }
        profile = { kind = \"wavy-paraboloid\", radius = 1, amplitude = \"1e-8\", wavelength = \"1e-4\" }
        output = { want = [\"folds\"] }";
    let [all, part] = [10.0, 0.06].map(|seconds| solved_within(text, seconds));
    let [all_folds, folds] = [&all, &part].map(|answer| answer["folds"].as_array().unwrap());
    assert!(all["complete"]["folds"]["proved"] == true && part["complete"]["folds"]["undecided"] == true);
    assert!(!folds.is_empty() && folds.len() < all_folds.len(), "{} of {}", folds.len(), all_folds.len());
    let is_known = |fold: &Value| all_folds.iter().any(|other| other["contact_radius"] == fold["contact_radius"]);
    assert!(folds.iter().all(is_known), "{part}");
    assert!(part["complete"]["folds"]["why"].as_str().unwrap().contains("the budget was spent before"), "{part}");
}

/// Beside a dip of 10 nm, which no search sees, more is not looked at within a tenth of the budget: what is proved elsewhere stands, and the
/// answer names the radii that are left.
#[test]
fn what_is_proved_beside_a_narrow_dip_outlasts_the_budget() {
    let found =
        |output: &str| solved_within(&formula(&dip("1e-8"), &format!("output = {{ {output}, digits = 12 }}")), 1.0);
    let equilibria = found("want = [\"equilibria\"], equilibria.at = [\"0\"]");
    let folds = found("want = [\"folds\"]");
    // Of the paraboloid r²/2, where g = x²: at d = 0 a² = √(2πaw/E*), and at the fold 2a = √(πw/2aE*).
    let [held, fold] = [2.0, 0.125].map(|share: f64| (std::f64::consts::PI * 1e-4 * share).cbrt());
    let state = &equilibria["equilibria"][0]["equilibria"][0];
    for (answer, list, found, paraboloid) in
        [(&equilibria, "equilibria", state, held), (&folds, "folds", &folds["folds"][0], fold)]
    {
        let radius: f64 = found["contact_radius"].as_str().expect("certified").parse().unwrap();
        assert!((radius / paraboloid - 1.0).abs() < 1e-6, "{radius} {paraboloid}");
        let complete = &answer["complete"][list];
        assert!(answer["promise"][list] == "certified" && complete["undecided"] == true, "{answer}");
        let left = complete["why"].as_str().unwrap();
        let ranges = left.strip_prefix("undecided at contact radii ").and_then(|left| left.split(':').next());
        let ranges =
            ranges.expect("radii that are left").split(", ").map(|range| range.split_once(" to ").expect("two radii"));
        let ranges: Vec<[f64; 2]> = ranges.map(|(from, to)| [from, to].map(|end| end.parse().unwrap())).collect();
        let [from, to] = [ranges[0][0], ranges[ranges.len() - 1][1]];
        assert!(from > 0.4 && from < 0.5037 && to > 0.5037 && to < 1.0, "{left}");
    }
    assert_eq!(state["admissible"], false, "{equilibria}");
}

/// A step by tanh, or as a logistic function, leaves g = x² before it: cosh and exp have no bound among doubles there.
#[test]
fn profiles_with_steps_are_proved() {
    for step in
        ["0.01*(tanh((r-0.5)/1e-3) + tanh(0.5/1e-3))", "0.02/(1 + exp((0.5-r)/5e-4)) - 0.02/(1 + exp(0.5/5e-4))"]
    {
        let rest = "output = { want = [\"folds\"], digits = 12, folds.range = [\"1e-3\", \"0.49\"] }";
        let answer = solved_within(&formula(&format!("r^2/2 + {step}"), rest), 3.0);
        let fold: f64 = answer["folds"][0]["contact_radius"].as_str().expect("certified").parse().unwrap();
        assert!((fold / (0.125 * std::f64::consts::PI * 1e-4).cbrt() - 1.0).abs() < 1e-10, "{step}: {fold}");
        assert_eq!(answer["complete"]["folds"]["proved"], true, "{answer}");
    }
}

/// A state whose energy is not enclosed within the budget takes that of the others with it no longer: all are doubles, from what is kept of
/// the budget.
#[test]
fn an_energy_that_is_not_enclosed_is_a_double() {
    let rest = "output = { want = [\"energy\"], equilibria.at = [\"0.1\"], digits = 5 }";
    let answer = solved_within(&formula("ln(1 + r^2)", rest), 5.0);
    let [one, other] = answer["energy"][0]["states"].as_array().unwrap().as_slice() else { panic!("{answer}") };
    let energy = one["energy"].as_f64().unwrap();
    assert!((energy / 0.001_183_556_1 - 1.0).abs() < 1e-7 && one["status"] == "ok", "{answer}");
    assert!(answer["promise"]["energy"] == "f64" && other["energy"].is_f64() && other["status"] == "ok", "{answer}");
}

/// exp(r²) − 1 is the paraboloid of R = 1/2 with a relative error of r²/2. Its fold is far above w/E* = 1e-8, where doubles lose r² beside 1.
#[test]
fn a_fold_is_not_lost_where_terms_cancel() {
    let text = "material = { e_star = \"1e6\", work_of_adhesion = \"0.01\" }
        profile = { kind = \"expression\", formula = \"exp(r^2) - 1\" }
        control = { kind = \"force\" }
        output = { want = [\"folds\"], digits = 8 }";
    let answer = solved(text);
    let [fold] = answer["folds"].as_array().unwrap().as_slice() else { panic!("{answer}") };
    let number = |key: &str| fold[key].as_str().unwrap().parse::<f64>().unwrap();
    let jkr = [(9.0 * std::f64::consts::PI * 0.01 * 0.25 / 8e6).cbrt(), -0.75 * std::f64::consts::PI * 0.01];
    for (found, jkr) in [number("contact_radius"), number("force")].into_iter().zip(jkr) {
        assert!((found / jkr - 1.0).abs() < 1e-5, "{found} {jkr}");
    }
    assert_eq!(answer["promise"]["folds"], "certified", "{answer}");
}

/// Whether the tip is a dimple is asked where the terms that cancel there leave something.
#[test]
fn paths_begin_apart_where_terms_cancel_at_the_tip() {
    for text in ["exp(r^2) - 1 - r^2", "r - tanh(r)", "exp(r) - 1 - r"] {
        let rest = "control = { kind = \"indentation\", path = [\"-0.01\", \"0.02\", \"-0.05\"], start = \"detached\" }
            output = { want = [\"path\"], digits = 6 }";
        let answer = solved(&formula(text, rest));
        let events: Vec<_> = answer["path"].as_array().unwrap().iter().map(|event| event["event"].clone()).collect();
        assert_eq!(events, ["start", "jump-in", "way-point", "detached", "end"], "{answer}");
        assert_eq!(answer["promise"]["path"], "certified", "{answer}");
    }
}

/// g of r² ln(1/r) is x²(1 − 2 ln 2x); that of (exp(r²) − 1)/√r begins as those of r^1.5 + r^3.5/2, of which the second has 1.4 times the κ.
#[test]
fn quotients_and_logarithms_at_the_axis_are_proved() {
    let of = |text: &str| {
        let rest = "output = { want = [\"folds\"], digits = 12, folds.range = [\"1e-3\", \"0.1\"] }";
        let answer = solved(&formula(text, rest));
        let [fold] = answer["folds"].as_array().unwrap().as_slice() else { panic!("{answer}") };
        assert_eq!(answer["promise"]["folds"], "certified", "{answer}");
        fold["contact_radius"].as_str().unwrap().parse::<f64>().unwrap()
    };
    let held = |a: f64| (std::f64::consts::PI * 1e-4 / (2.0 * a)).sqrt();
    let a = of("r^2*ln(1/r)");
    assert!((-4.0 * a * (2.0 * a).ln() / held(a) - 1.0).abs() < 1e-9, "{a}");
    let a = of("(exp(r^2) - 1)/sqrt(r)");
    // κ of n = 3/2 by mpmath.
    let kappa = 1.797_210_352_103_388_3;
    let slope = 1.5 * kappa * a.sqrt() * (1.0 + a * a * 3.5 * 1.4 / 3.0);
    assert!((slope / held(a) - 1.0).abs() < 4.0 * a.powi(4), "{a}");
}

/// Of waves without end the first folds are proved, and the answer says that there are more.
#[test]
fn the_first_folds_of_an_endless_wave_are_proved() {
    let answer = solved(&formula("1 - cos(r)", "output = { want = [\"folds\"], digits = 5 }"));
    assert_eq!(
        (answer["folds"].as_array().unwrap().len(), &answer["promise"]["folds"]),
        (8, &"certified".into()),
        "{answer}"
    );
    let complete = &answer["complete"]["folds"];
    assert!(complete["proved"] == true && complete["why"].as_str().unwrap().contains("sees more"), "{answer}");
}

/// Behind a singular kink g does not converge in f64: whether the contact comes to rest there is open, and no contact is complete.
#[test]
fn no_contact_is_complete_where_g_does_not_converge() {
    let rest = "control = { kind = \"indentation\", path = [\"-0.01\", \"0.05\"], start = \"detached\" }
        output = { want = [\"path\"], digits = 6 }";
    let answer = solved(&formula("r^2/2 + sqrt(max(0, r - 0.05))", rest));
    let events: Vec<_> = answer["path"].as_array().unwrap().iter().map(|event| event["event"].clone()).collect();
    assert_eq!(events, ["start", "undecided"], "{answer}");
}

/// Whether a contact of 40 km within a bump of 3 km overlaps takes more heights than there are: the states have their digits all the same.
#[test]
fn states_outlast_the_heights_of_their_gaps() {
    let rest = "material = { e_star = \"3.5476\", work_of_adhesion = \"4.0709e-05\" }\ncontrol = { kind = \"indentation\" }\n\
                output = { want = [\"equilibria\"], equilibria = { at = [\"-1.71597\", \"-1.42447\"] }, digits = 12 }";
    let text =
        format!("profile = {{ kind = \"expression\", formula = \"2.45*(r/2.45)^1.5*exp(-(r/2.45)/10)\" }}\n{rest}");
    let answer = solved_within(&text, 2.0);
    assert_eq!(answer["promise"]["equilibria"], "certified", "{answer}");
    for at in answer["equilibria"].as_array().unwrap() {
        assert_eq!(at["equilibria"].as_array().unwrap().len(), 3, "{answer}");
    }
}
