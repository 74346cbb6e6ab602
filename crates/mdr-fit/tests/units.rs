//! Numbers with units in fits: every key reads as its SI number does, and a unit of another dimension is refused.
#![cfg(feature = "serde")]
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr::no_files;
use mdr_fit::Problem;

/// A fit in which every key has a number, in SI and with units: JSON, because a scene in JSON has the same keys.
const FITS: [&str; 2] = [
    r#"{"profile": {"kind": "hyperboloid", "slope": 0.36, "lateral": 1e-8}, "control": {"kind": "machine", "stiffness": 0.4},
        "data": {"observation": "F(D)", "sigma": {"x": 0, "y": 1e-10},
                 "x": [2e-8, 1e-8, 5e-9, 0, -5e-9, -3e-7], "y": [7e-9, 3e-9, 1e-9, -4e-10, -2e-9, 0]},
        "fit": {"free": ["e_star", "work_of_adhesion"], "fixed": {"contact_point": 1e-9, "baseline": 1e-11},
                "start": {"e_star": 3e6}, "prior": {"stiffness": {"mean": 0.4, "sd": 0.02}},
                "bounds": {"profile.lateral": [1e-9, 1e-6], "work_of_adhesion": [1e-3, 1]}},
        "events": {"pull_off": -1e-8, "sigma": 1e-9}, "output": {"range_of_adhesion": 3e-10}}"#,
    r#"{"profile": {"kind": "hyperboloid", "slope": 0.36, "lateral": "10 nm"},
        "control": {"kind": "machine", "stiffness": "400 mN/m"},
        "data": {"observation": "F(D)", "sigma": {"x": "0 nm", "y": "0.1nN"},
                 "x": ["20 nm", "10 nm", "5 nm", "0 nm", "-5 nm", "-0.3 um"], "y": ["7 nN", "3 nN", "1 nN", "-400 pN", "-2 nN", 0]},
        "fit": {"free": ["e_star", "work_of_adhesion"], "fixed": {"contact_point": "1 nm", "baseline": "10 pN"},
                "start": {"e_star": "3 MPa"}, "prior": {"stiffness": {"mean": "0.4 nN/nm", "sd": "20 mN/m"}},
                "bounds": {"profile.lateral": ["1 nm", "1 um"], "work_of_adhesion": ["1 mJ/m^2", "1 N/m"]}},
        "events": {"pull_off": "-10 nm", "sigma": "1 nm"}, "output": {"range_of_adhesion": "0.3 nm"}}"#,
];

#[test]
fn every_key_of_a_fit_may_have_its_unit() {
    let [si, units] = FITS.map(|text| format!("{:?}", Problem::from_json(text, "fit.json", &no_files).unwrap()));
    // What is read is the same but for the places and the notation of the shape.
    let read = |text: &str| text.split_once("observation").map(|(_, rest)| rest.to_owned()).unwrap();
    let [si, units] = [si, units].map(|text| read(&text));
    let without_place = |text: &str| text.split_once("place: Location").map(|(before, _)| before.to_owned()).unwrap();
    assert_eq!(without_place(&si), without_place(&units));
    for (from, to, parts) in [
        ("\"20 mN/m\"", "\"20 nm\"", &["sd is in N/m; got \"20 nm\""][..]),
        ("\"3 MPa\"", "\"3 mpa\"", &["fit.start.e_star", "did you mean `MPa`?"]),
        ("\"1 um\"]", "\"1 uN\"]", &["profile.lateral", "is in m; got \"1 uN\""]),
        ("\"0.1nN\"", "\"0.1nm\"", &["data.sigma.y", "is in N"]),
        ("\"10 pN\"", "\"10 pm\"", &["baseline is in N"]),
        ("\"-10 nm\"", "\"-10 nN\"", &["pull_off is in m"]),
    ] {
        assert!(FITS[1].contains(from), "{from}");
        let error =
            Problem::from_json(&FITS[1].replacen(from, to, 1), "fit.json", &no_files).expect_err(to).to_string();
        for part in parts {
            assert!(error.contains(part), "{to}: {error}");
        }
    }
}
