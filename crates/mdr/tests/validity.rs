//! Whether the theory holds: the same answer through every interface, and the answers at its limits.

use std::f64::consts::PI;

use mdr::critical::{PowerLaw, critical};
use mdr::prelude::*;
use mdr::validity::AdhesionRegime;
use mdr::{Validity, no_files};

fn contact<X: Exact + Clone>(shape: Shape<X>, e_star: &str, work: &str) -> Scene {
    let elasticity = Elasticity::effective(e_star).expect("a number");
    Scene::new(shape, elasticity, work).expect("a contact").arithmetic(Arithmetic::F64)
}

fn validity<X: Exact + Clone>(shape: Shape<X>, e_star: &str, work: &str, range: &str) -> Validity {
    let scene = contact(shape, e_star, work).range_of_adhesion(range).expect("a range");
    scene.validity().expect("an answer")
}

fn double(value: &Value) -> f64 {
    value.to_f64().expect("a number")
}

const SCENE: &str = "[material]\ne_star = 5e9\nwork_of_adhesion = 0.05\nrange_of_adhesion = \"0.3 nm\"\n\
                     [profile]\nkind = \"paraboloid\"\nradius = 1e-8\n[output]\nwant = [\"folds\"]\n";

#[test]
fn a_scene_says_it_wherever_the_range_stands() {
    let moved = SCENE.replace("range_of_adhesion = \"0.3 nm\"\n", "") + "range_of_adhesion = 3e-10\n";
    let built = validity(Shape::Paraboloid { radius: "1e-8" }, "5e9", "0.05", "3e-10");
    for text in [SCENE, &moved] {
        let scene =
            Scene::from_toml(text, "tip.toml", &no_files).expect("a scene").in_arithmetic(Some(Arithmetic::F64));
        let answer = scene.solve().expect("an answer");
        let found = answer.validity.as_deref().expect("asked for");
        assert_eq!(found.tabor, built.tabor);
        assert_eq!(found.maugis_dugdale_pull_off, built.maugis_dugdale_pull_off);
        assert_eq!(found.regime, AdhesionRegime::Transition);
        assert!(answer.to_json().contains(r#""validity":{"range_of_adhesion":""#));
    }
    let without = Scene::from_toml(&SCENE.replace("range_of_adhesion = \"0.3 nm\"\n", ""), "tip.toml", &no_files);
    let without = without.expect("a scene").in_arithmetic(Some(Arithmetic::F64));
    assert!(without.solve().expect("an answer").validity.is_none());
}

#[cfg(feature = "mp")]
#[test]
fn digits_are_those_of_doubles_and_more() {
    let scene = Scene::from_toml(SCENE, "tip.toml", &no_files).expect("a scene");
    let answer = scene.solve().expect("an answer");
    let found = answer.validity.expect("asked for");
    assert_eq!(found.promise(), Promise::Certified);
    // Maugis 1992, solved for the least force with 30 digits by other means.
    assert_eq!(found.tabor.to_string(), "0.33333333333333333333");
    assert_eq!(found.maugis_dugdale_pull_off.to_string(), "-2.7780704315163099417e-9");
    let double = validity(Shape::Paraboloid { radius: "1e-8" }, "5e9", "0.05", "0.3e-9");
    let ratio =
        found.maugis_dugdale_pull_off.to_f64().unwrap_or(0.0) / double.maugis_dugdale_pull_off.to_f64().unwrap_or(1.0);
    assert!((ratio - 1.0).abs() < 1e-13, "{ratio}");
}

/// Profiles with E* = 1 and w = 1e-5, ranges, and the Tabor number, F, a, c and d on which two precisions agree that take g from
/// its closed form over the ring.
#[cfg(feature = "mp")]
const DIGITS: [(&str, &str, [&str; 5]); 14] = [
    (
        "kind = \"power\"\nn = \"1/4\"\nc = 1",
        "1e-3",
        [
            "1533.6836160512862042",
            "-2.6779222661423983460e-26",
            "1.1023229694287871193e-22",
            "9.1400253437546237854e-13",
            "0.0000037703194804851034039",
        ],
    ),
    (
        "kind = \"power\"\nn = 2.5\nc = 1",
        "1e-5",
        [
            "55.342824482034162972",
            "-0.000091290829028743317367",
            "0.046649268863541987136",
            "0.046656717765107611916",
            "-0.00068486822529321504232",
        ],
    ),
    (
        "kind = \"cone\"\nslope = 0.5",
        "1e-4",
        [
            "0.38788910321758915520",
            "-2.1958368931213062755e-8",
            "0.00016073600730280018318",
            "0.00036887799750013980895",
            "0.000058065905619807458116",
        ],
    ),
    (
        "kind = \"sphere\"\nradius = 1",
        "1e-3",
        [
            "0.46404785009801209584",
            "-0.000053517450469713000116",
            "0.020174976607871125418",
            "0.045608948444288952702",
            "-0.00043283527502295247259",
        ],
    ),
    (
        "kind = \"hyperboloid\"\nslope = 0.5\nlateral = 0.1",
        "1e-2",
        [
            "0.027220573951388647354",
            "-0.000013716853780092085646",
            "0.00076235082371772733808",
            "0.065219685102776819604",
            "-0.00013100633776686598762",
        ],
    ),
    (
        "kind = \"hyperboloid\"\nslope = 0.5\nlateral = 0.1",
        "1e-6",
        [
            "272.20573951388647354",
            "-0.0000094725568338923055956",
            "0.011286522812546079592",
            "0.011286597320565110943",
            "-0.00020786511173139724080",
        ],
    ),
    (
        "kind = \"truncated-cone\"\nslope = 0.5\nflat = 0.1",
        "1e-4",
        [
            "8.1024482795539297462",
            "-0.00049976808715697899260",
            "0.099253049041879585702",
            "0.10000000000000000000",
            "-0.0025050682986292135488",
        ],
    ),
    (
        "kind = \"truncated-cone\"\nslope = 0.5\nflat = 0.1",
        "1e-2",
        [
            "0.081024482795539297462",
            "-0.000045907761904177910197",
            "0.00076532101543602592135",
            "0.11930197318247736003",
            "-0.00024496821025406533460",
        ],
    ),
    (
        "kind = \"flat-punch\"\nradius = 1",
        "1e-4",
        [
            "25.622191187103111630",
            "-0.015848387102173244302",
            "0.99925472644011190915",
            "1.0000000000000000000",
            "-0.0079261623105633577272",
        ],
    ),
    (
        "kind = \"cone-parabolic-cap\"\ncap = 0.1\nslope = 0.5",
        "1e-5",
        [
            "27.144176165949065715",
            "-0.0000094258199195713971690",
            "0.011218483088047576070",
            "0.011225925742850703738",
            "-0.00020997376567970905159",
        ],
    ),
    (
        "kind = \"rounded-punch\"\nradius = 1\nflat = 0.1",
        "1e-3",
        [
            "0.83421298077402723279",
            "-0.00047635655383859978191",
            "0.072211625254379567247",
            "0.12717534118764661732",
            "-0.0021495990669858571445",
        ],
    ),
    (
        "kind = \"sum\"\nterm = [{ kind = \"paraboloid\", radius = 1 }, { kind = \"cone\", slope = 0.01 }]",
        "1e-4",
        [
            "4.2721528032539272439",
            "-0.000032856380738343339548",
            "0.027345307884470747316",
            "0.028059321587535798803",
            "-0.00011420375518545664905",
        ],
    ),
    (
        "kind = \"wavy-paraboloid\"\nradius = 1\namplitude = 5e-4\nwavelength = 0.1",
        "1e-5",
        [
            "34.421901316971045992",
            "-0.000017639423909191637603",
            "0.018043560249974627736",
            "0.018051006012846837472",
            "-0.00018346335520089538418",
        ],
    ),
    (
        "kind = \"paraboloid\"\nradius = 1",
        "1e-4",
        [
            "4.6415888336127788924100763509194465765513491250112",
            "-0.000047297416992735897674234371727454315515431176611591",
            "0.032355385610447536768968729529139320469176708472200",
            "0.033073918993533301097082142859096893974070392833977",
            "-0.00036105773586546511207840983158995656760964058388644",
        ],
    ),
];

#[cfg(feature = "mp")]
fn certified(profile: &str, range: &str, digits: usize) -> Validity {
    let text = format!(
        "[material]\ne_star = 1\nwork_of_adhesion = 1e-5\nrange_of_adhesion = {range}\n[profile]\n{profile}\n\
         [output]\nwant = [\"folds\"]\ndigits = {digits}\n"
    );
    let scene = Scene::from_toml(&text, "tip.toml", &no_files).expect("a scene");
    scene.validity().unwrap_or_else(|error| panic!("{profile}, {range}: {error}"))
}

#[cfg(feature = "mp")]
#[test]
fn proved_digits_are_those_of_two_precisions() {
    for (profile, range, digits) in DIGITS {
        let found = certified(profile, range, if digits[0].len() > 40 { 50 } else { 20 });
        let Validity { maugis_dugdale_pull_off: force, maugis_dugdale_contact_radius: a, .. } = &found;
        let (c, d) = (&found.maugis_dugdale_outer_radius, &found.maugis_dugdale_indentation);
        assert_eq!([&found.tabor, force, a, c, d].map(ToString::to_string), digits, "{profile}, {range}");
        assert_eq!(found.promise(), Promise::Certified, "{profile}, {range}");
    }
}

/// A formula in certified digits has those of the shape that it is, and of doubles.
#[cfg(feature = "mp")]
#[test]
fn formulas_are_proved() {
    let waves = "kind = \"wavy-paraboloid\"\nradius = 1\namplitude = 1e-5\nwavelength = 0.1";
    let shape = certified(waves, "1e-3", 20);
    let formula = "kind = \"expression\"\nformula = \"r^2/2 + 1e-5*(1 - cos(20*pi*r))\"";
    let formula = certified(formula, "1e-3", 20);
    assert_eq!(formula.promise(), Promise::Certified);
    assert_eq!(formula.maugis_dugdale_pull_off, shape.maugis_dugdale_pull_off);
    assert_eq!(formula.maugis_dugdale_indentation, shape.maugis_dugdale_indentation);
    assert_eq!((formula.slope, formula.tabor), (shape.slope, shape.tabor));
    // The ring holds a kink.
    let kinked = certified("kind = \"expression\"\nformula = \"r^2/2 + 0.1*max(0, r - 0.03)^2\"", "1e-3", 20);
    assert_eq!((kinked.promise(), kinked.row().status()), (Promise::Certified, Status::Ok));
    assert_ne!(kinked.maugis_dugdale_pull_off, shape.maugis_dugdale_pull_off);
}

/// Where no proof succeeds the numbers are doubles; without a pull-off the others are proved.
#[cfg(feature = "mp")]
#[test]
fn no_number_is_lost_without_a_proof() {
    // √r² is not analytic at the axis: it is bounded beside it.
    let cone = certified("kind = \"expression\"\nformula = \"sqrt(r^2 + r^3)\"", "1e-3", 20);
    assert_eq!((cone.promise(), cone.maugis_dugdale_pull_off.status()), (Promise::Certified, Status::Ok));
    // The gap at the edge of a punch is below h₀ for the narrowest contact.
    let punch = certified("kind = \"flat-punch\"\nradius = 1", "1e-2", 20);
    assert_eq!(punch.promise(), Promise::F64);
    assert!((double(&punch.tabor) - 0.256_221_911_871_031_1).abs() < 1e-15);
    // A ring that would reach beyond the equator.
    let ball = certified("kind = \"sphere\"\nradius = 1", "10", 20);
    assert_eq!((ball.promise(), ball.tabor.status()), (Promise::Certified, Status::Ok));
    assert_eq!(ball.maugis_dugdale_pull_off.status(), Status::DomainError);
}

#[test]
fn regimes_and_limits_of_a_sphere() {
    let at = |range: &str| validity(Shape::Paraboloid { radius: "1" }, "1", "1e-6", range);
    let [short, middle, long] = ["1e-6", "1e-4", "1e-2"].map(at);
    let regimes = [&short, &middle, &long].map(|validity| validity.regime.name());
    assert_eq!(regimes, ["JKR", "transition", "DMT"]);
    let share = |validity: &Validity| -double(&validity.maugis_dugdale_pull_off) / (PI * 1e-6);
    assert!((share(&short) - 1.5).abs() < 1e-4 && (share(&long) - 2.0).abs() < 0.01);
    let correction = double(middle.correction.as_ref().expect("a number"));
    assert!((share(&middle) / 1.5 - 1.0 - correction).abs() < 1e-12);
    // g' = 2a/R.
    let a_over_r = double(middle.a_over_r.0.as_ref().expect("R is known"));
    assert!((double(&middle.slope) / a_over_r - 2.0).abs() < 1e-14);
}

#[test]
fn every_profile_has_an_answer() {
    let parameter = |shape: &str, key: &str| match (shape, key) {
        (_, "n") => "2",
        (_, "slope" | "c") => "0.5",
        (_, "flat" | "cap" | "offset") => "0.1",
        (_, "depth") => "1e-2",
        (_, "amplitude") => "1e-4",
        ("elliptical-dimple" | "parabolic-dimple", "radius") => "0.2",
        (_, "wavelength") => "0.2",
        _ => "1",
    };
    for name in Shape::names() {
        let shape = Shape::by_name(name).expect("a name").map(|key, ()| parameter(name, key));
        let found = validity(shape, "1", "1e-4", "1e-4");
        let [tabor, force] = [&found.tabor, &found.maugis_dugdale_pull_off].map(Value::to_f64);
        assert!(tabor.is_some_and(|tabor| tabor > 0.0), "{name}: {:?}", found.tabor);
        // At a sharp edge g' has an inverse root, and of a dimple g has no value: a ring over it may stay undecided.
        let sharp = name.starts_with("truncated") || name.ends_with("dimple");
        let undecided = sharp && found.maugis_dugdale_pull_off.status() == Status::Undecided;
        let known = undecided || force.is_some_and(|force| force < 0.0);
        assert!(known, "{name}: {:?}", found.maugis_dugdale_pull_off);
    }
}

#[test]
fn a_formula_and_a_table_have_an_answer() {
    let paraboloid = validity(Shape::Paraboloid { radius: "1" }, "1", "1e-4", "1e-3");
    let scene = SCENE.replace("5e9", "1").replace("0.05", "1e-4").replace("0.3 nm", "1e-3");
    let formula = scene.replace("kind = \"paraboloid\"\nradius = 1e-8", "kind = \"expression\"\nformula = \"r^2/2\"");
    let table = scene.replace("kind = \"paraboloid\"\nradius = 1e-8", "kind = \"table\"\nfile = \"tip.csv\"");
    let rows: String = (0..=200).map(|i| f64::from(i) / 200.0).map(|r| format!("{r},{}\n", r * r / 2.0)).collect();
    let files = |_: &str| Ok(rows.clone().into_bytes());
    for text in [formula, table] {
        let scene = Scene::from_toml(&text, "tip.toml", &files).expect("a scene").arithmetic(Arithmetic::F64);
        let found = scene.validity().expect("an answer");
        let ratio = double(&found.maugis_dugdale_pull_off) / double(&paraboloid.maugis_dugdale_pull_off);
        assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
    }
}

#[test]
fn exactly_zero_is_the_limit_of_short_range() {
    let found = validity(Shape::Power { n: "1/4", c: "1" }, "1", "1e-4", "1e-3");
    assert_eq!(found.jkr_pull_off, Some(Value::Given(0.into())));
    assert!(found.correction.is_none());
    assert!(double(&found.maugis_dugdale_pull_off) < 0.0);
    assert!(found.advice().contains("exactly 0 is the limit of short range"), "{}", found.advice());
    // n = 1/2 has no instability under a dead load, and no Tabor number.
    let found = validity(Shape::Power { n: "1/2", c: "1" }, "1", "1e-4", "1e-3");
    assert_eq!((found.regime, found.tabor.status()), (AdhesionRegime::Unknown, Status::NoEquilibrium));
    assert!(double(&found.maugis_dugdale_pull_off) < 0.0);
}

#[test]
fn a_power_law_has_it_beside_its_critical_state() {
    let [n, c, work, range] = ["2", "5e7", "0.05", "3e-10"].map(|text| text.parse::<Literal>().expect("a number"));
    let elasticity = Elasticity::effective("5e9").expect("a number");
    let law = PowerLaw { n, c, elasticity, work_of_adhesion: work, control: Control::Indentation };
    let answer = critical(&law, Arithmetic::F64).expect("an answer");
    assert!(answer.validity.is_none());
    let found = answer.with_range(&range).expect("an answer").validity.expect("asked for");
    let paraboloid = validity(Shape::Paraboloid { radius: "1e-8" }, "5e9", "0.05", "3e-10");
    assert!((double(&found.tabor) / double(&paraboloid.tabor) - 1.0).abs() < 1e-14);
}

#[test]
fn a_bad_range_is_refused_where_it_stands() {
    let complaint = |text: &str| Scene::from_toml(text, "tip.toml", &no_files).expect_err("refused").to_string();
    let negative = complaint(&SCENE.replace("0.3 nm", "-0.3 nm"));
    assert_eq!(negative, "tip.toml:4: material.range_of_adhesion: must be positive, got -0.3e-9");
    let second = complaint(&SCENE.replace("0.3 nm", "0.3 s"));
    assert!(second.contains("material.range_of_adhesion") && second.contains("unknown unit `s`"), "{second}");
    assert!(complaint(&format!("{SCENE}range_of_adhesion = 1e-9\n")).contains("is given in [material], too"));
    let alone = "[profile]\nkind = \"paraboloid\"\nradius = 1\n[output]\nwant = [\"transform\"]\ntransform.at = [1]\n\
                 range_of_adhesion = 1e-9\n";
    assert!(complaint(alone).contains("output.range_of_adhesion: needs a material"));
    let scene = contact(Shape::Paraboloid { radius: "1" }, "1", "1");
    assert!(scene.clone().range_of_adhesion("0").expect_err("refused").to_string().contains("must be positive, got 0"));
    assert!(scene.validity().expect_err("refused").to_string().contains("missing"));
    // A ring that would reach beyond the equator of the ball.
    let found = validity(Shape::Sphere { radius: "1" }, "1", "1e-4", "10");
    assert_eq!(found.maugis_dugdale_pull_off.status(), Status::DomainError);
}
