//! What is claimed of a g that rises: of all radii, or not at all.

use mdr::answer::Admission;
use mdr::prelude::*;
use mdr_numeric::admissible::Basis;

use crate::{GRIPS, LOAD, scene, solve};

const GRADED: &str = "kind = \"graded\"\nexponent = \"0.3\"\ncoefficient = 1";
const WINKLER: &str = "kind = \"winkler\"\nmodulus = 1";

fn formula(text: &str) -> String {
    format!("kind = \"expression\"\nformula = \"{text}\"")
}

/// Whether all folds are said to be admissible.
fn all_admissible(medium: &str, profile: &str, control: &str, range: &str) -> bool {
    let answer = solve(&scene(medium, &formula(profile), control, &format!("want = [\"folds\"]\n{range}\ndigits = 8")));
    let folds = &answer.folds().expect("wanted").items;
    assert!(!folds.is_empty(), "{profile}");
    folds.iter().all(|fold| matches!(fold.admissible, Admission::Admissible))
}

#[test]
fn a_rise_is_proved_where_r_f_falls() {
    // (r f')' = 2r + 2.5r cos 10r + 0.25 sin 10r is negative somewhere; on springs that do not couple g is f, which rises.
    assert!(all_admissible(WINKLER, "r^2/2 + 0.025*(1 - cos(10*r))", LOAD, ""));
    // 4 in the place of 2.5: f falls too.
    assert!(!all_admissible(WINKLER, "r^2/2 + 0.2*(1 - cos(10*r))", LOAD, ""));
}

/// r^60 falls beyond the range of the proof, before the root ends the profile.
#[test]
fn a_fall_beyond_the_range_is_no_rise() {
    let profile = "r^2/2 - r^60 + 1e-9*(1 - sqrt(1 - r^2))";
    assert!(!all_admissible(GRADED, profile, GRIPS, "folds.range = [\"1e-3\", \"0.5\"]"));
    assert!(!all_admissible(GRADED, profile, GRIPS, ""));
}

/// f = r²/2 − r²/(1000r² + 1) falls next to the tip, below the range of the proof: the surfaces touch first on the ring with
/// (1000r² + 1)² = 2.
#[test]
fn a_fall_below_the_range_is_no_rise() {
    let way = "kind = \"indentation\"\npath = [\"-0.1\", \"0.01\"]\nstart = \"detached\"";
    let want = "want = [\"path\"]\nfolds.range = [\"0.05\", \"10\"]\ndigits = 8";
    let answer = solve(&scene(WINKLER, &formula("r^2/2 - r^2/(1000*r^2 + 1)"), way, want));
    let events = &answer.path().expect("wanted").events.items;
    let kinds: Vec<_> = events.iter().map(|event| event.event.name()).collect();
    assert_eq!(kinds, ["start", "not-admissible"]);
    let root = 2.0_f64.sqrt();
    let depth = events[1].indentation.as_ref().and_then(Value::to_f64).expect("a depth");
    assert!((depth / ((root - 1.0) / 1000.0 * (0.5 - 1.0 / root)) - 1.0).abs() < 1e-7, "{depth}");
}

/// A flat that a dimple surrounds ends before the range of its folds does.
#[test]
fn a_profile_that_ends_within_the_range_has_its_fold() {
    let sum = "kind = \"sum\"\n[[profile.term]]\nkind = \"flat-punch\"\nradius = 1\n[[profile.term]]\nkind = \"parabolic-dimple\"\n\
               depth = \"0.1\"\nradius = 8";
    let answer = solve(&scene(WINKLER, sum, LOAD, "want = [\"folds\"]\ndigits = 8"));
    let [fold] = answer.folds().expect("wanted").items.as_slice() else { panic!("{answer:?}") };
    assert_eq!(fold.contact_radius.to_f64(), Some(1.0));
}

/// Far below a dip f has its slope, e⁻⁶⁴ times that beside it, so that f is lowest on a ring of 10⁻²⁸: at which depth the surfaces touch is
/// proved by none, and doubles take the tip.
#[test]
fn a_dimple_below_all_radii_is_the_tip() {
    let way = "kind = \"indentation\"\npath = [\"-1\", \"0.5\"]\nstart = \"detached\"";
    let dip = formula("0.1*r^2 - 2.5e-4*(exp(-((r - 0.16)/0.02)^2) - exp(-64))");
    for medium in [GRADED, "kind = \"half-space\""] {
        let modulus = if medium == GRADED { "" } else { "e_star = 1\n" };
        let text = scene(medium, &dip, way, "want = [\"path\"]\ndigits = 40");
        let answer = solve(&text.replace("work_of", &format!("{modulus}work_of")).replace("1/100", "1e-4"));
        let events = &answer.path().expect("wanted").events;
        let kinds: Vec<_> = events.items.iter().map(|event| event.event.name()).collect();
        assert_eq!((events.promise, kinds.as_slice()), (Promise::F64, &["start", "jump-in", "end"][..]), "{medium}");
    }
}

/// A small contact on the tip within a dimple overlaps at its rim, which the formula of all of the dimple does not show: it has two kinks there.
#[test]
fn a_contact_within_a_dimple_is_not_admissible() {
    let dimple = "kind = \"elliptical-dimple\"\ndepth = \"0.1\"\nradius = 1";
    let bump = formula("-0.1*(1 - exp(-r^2))");
    for profile in [dimple, &bump] {
        let want = "want = [\"equilibria\"]\nequilibria.at = [\"-0.001\"]\ndigits = 8";
        let text = scene("kind = \"half-space\"", profile, GRIPS, want).replace("1/100", "1e-4");
        let answer = solve(&text.replace("work_of", "e_star = 1\nwork_of"));
        let states = answer.equilibria().expect("wanted");
        let state = &states.items[0].items[0];
        assert!(matches!(state.admissible, Admission::Interpenetrating { .. }), "{profile} {state:?}");
        assert_eq!(answer.admissibility, Some(Basis::Proved));
    }
}

/// In doubles the kink is anywhere within a millionth of its radius, and nothing is seen above it: there may be a state to start from.
#[test]
fn a_start_that_is_not_found_is_not_denied() {
    let graded = "kind = \"graded\"\nexponent = \"-0.5\"\ncoefficient = 1";
    let (way, want) =
        ("kind = \"indentation\"\npath = [\"-0.05\", \"-0.2\"]", "want = [\"energy\"]\narithmetic = \"f64\"");
    let text = scene(graded, &formula("max((r + 1000) - 1000.17283, 0)^1.5"), way, want);
    for work in ["\"1/100\"", "{ advancing = \"1/1000\", receding = \"1/100\" }"] {
        let answer = solve(&text.replace("\"1/100\"", work));
        let [start] = answer.energy().expect("wanted").items.as_slice() else { panic!("{answer:?}") };
        assert_eq!(start.status, Status::Undecided, "{work}");
    }
}

/// Of a profile that is lowest on a ring the surfaces first touch there, on every medium; a path to that depth ends, and what came before is
/// known. Enclosures of a formula tell the ring, and shapes have it by their form; of a sum of shapes nothing is known.
#[test]
fn a_path_ends_where_surfaces_come_to_touch_on_a_ring() {
    let way = "kind = \"indentation\"\npath = [\"0.1\", \"-0.5\", \"0.1\"]";
    let displaced = "kind = \"displaced-paraboloid\"\nradius = 1\noffset = \"0.04\"";
    let sum = format!("kind = \"sum\"\n[[profile.term]]\n{displaced}");
    let ends = [
        (formula("(r - 0.04)^2/2 - 0.0008"), "not-admissible", -8e-4),
        (displaced.to_owned(), "not-admissible", -8e-4),
        (sum, "undecided", 0.1),
    ];
    for (profile, end, depth) in &ends {
        for (digits, promise) in [("digits = 12", Promise::Certified), ("arithmetic = \"f64\"", Promise::F64)] {
            let answer = solve(&scene(GRADED, profile, way, &format!("want = [\"path\"]\n{digits}")));
            let events = &answer.path().expect("wanted").events;
            let kinds: Vec<_> = events.items.iter().map(|event| event.event.name()).collect();
            assert_eq!((events.promise, kinds.as_slice()), (promise, &["start", "detached", "way-point", end][..]));
            let last = events.items[3].indentation.as_ref().and_then(Value::to_f64).expect("a depth");
            assert!((last / depth - 1.0).abs() < 1e-12, "{last}");
            assert_eq!(answer.admissibility.map(|basis| matches!(basis, Basis::Unknown(_))), Some(true));
        }
    }
}

/// Over a dimple the surfaces first touch on its rim, at its depth, which is certified without an integral.
#[test]
fn surfaces_first_touch_on_the_rim_of_a_dimple() {
    let way = "kind = \"indentation\"\npath = [\"-1\", \"0.1\"]\nstart = \"detached\"";
    for kind in ["parabolic-dimple", "elliptical-dimple"] {
        let dimple = format!("kind = \"{kind}\"\ndepth = \"0.02\"\nradius = \"0.3\"");
        let text = scene("kind = \"half-space\"", &dimple, way, "want = [\"path\"]\ndigits = 20");
        let answer = solve(&text.replace("work_of", "e_star = 1\nwork_of"));
        let events = &answer.path().expect("wanted").events;
        let kinds: Vec<_> = events.items.iter().map(|event| event.event.name()).collect();
        assert_eq!(
            (events.promise, kinds.as_slice()),
            (Promise::Certified, &["start", "not-admissible"][..]),
            "{kind}"
        );
        let end = events.items[1].indentation.as_ref().map(ToString::to_string);
        assert_eq!(end.as_deref(), Some("-0.020000000000000000000"), "{kind}");
    }
}
