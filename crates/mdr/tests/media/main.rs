//! Scenes on other media than the half-space, against values that were computed elsewhere to thirty digits.

#![cfg(feature = "mp")]

mod depths;
mod rises;
mod scans;
mod shapes;
mod waves;

use mdr::answer::{Admission, Fold};
use mdr::no_files;
use mdr::prelude::*;

/// A scene of a medium, with E* where it needs one, and w = 1/100 unless the material says more.
fn scene(medium: &str, profile: &str, control: &str, want: &str) -> String {
    let modulus = if medium.contains("plane") || medium.contains("periodic") { "e_star = 1" } else { "" };
    let work = if profile.contains("wave") { ALPHA_3 } else { "1/100" };
    format!(
        "[medium]\n{medium}\n[material]\n{modulus}\nwork_of_adhesion = \"{work}\"\n[profile]\n{profile}\n\
         [control]\n{control}\n[output]\n{want}\n"
    )
}

/// π²·0.09/2, which with E* = λ = h₀ = 1 is α = 0.3.
const ALPHA_3: &str = "0.44413219804902113784755209499442680108911647332584";

const SQUARE: &str = "kind = \"power\"\nn = 2\nc = 1";
const WAVE: &str = "kind = \"wave\"\namplitude = 1";
const PERIODIC: &str = "kind = \"periodic\"\nwavelength = 1";
const LOAD: &str = "kind = \"force\"";
const GRIPS: &str = "kind = \"indentation\"";

fn solve(text: &str) -> Answer {
    Scene::from_toml(text, "scene.toml", &no_files)
        .and_then(|scene| scene.solve())
        .unwrap_or_else(|why| panic!("{why}\n{text}"))
}

fn complaint(text: &str) -> String {
    let answer = Scene::from_toml(text, "scene.toml", &no_files).and_then(|scene| scene.solve());
    answer.expect_err("a bad scene").to_string()
}

fn folds(medium: &str, profile: &str, control: &str) -> Vec<Fold> {
    let answer = solve(&scene(medium, profile, control, "want = [\"folds\"]\ndigits = 20"));
    let list = answer.folds().expect("wanted");
    assert_eq!(list.promise, Promise::Certified, "{medium} {profile}");
    assert!(list.complete.as_ref().is_some_and(|complete| complete.proved), "{medium} {profile}");
    list.items.clone()
}

/// The digits of a value, without its point, sign and leading zeros.
fn digits(value: &Value) -> String {
    let text = value.number().unwrap_or_else(|| panic!("{value:?}")).to_string();
    text.trim_start_matches(['-', '0', '.']).replace('.', "")
}

/// Whether a value in twenty digits is the rounded expected one, which has more.
fn assert_digits(value: &Value, expected: &str) {
    let found = value.number().unwrap_or_else(|| panic!("{value:?}")).to_string();
    assert_eq!(found.starts_with('-'), expected.starts_with('-'), "{found} {expected}");
    let long = expected.trim_start_matches(['-', '0', '.']).replace('.', "");
    let (number, reference) = (digits(value), &long[..20]);
    let tail: u32 = long[20..21].parse().expect("a digit");
    let rounded = reference.parse::<u128>().expect("digits") + u128::from(tail >= 5);
    assert_eq!(number.parse::<u128>().expect("digits"), rounded, "{found} {expected}");
}

/// The critical states of MEDIA for n = 2, k = 0.3, c = C = 1, w = 1/100.
#[test]
fn graded_half_space() {
    let medium = "kind = \"graded\"\nexponent = \"0.3\"\ncoefficient = 1";
    let grips = &folds(medium, SQUARE, GRIPS)[0];
    assert_digits(&grips.contact_radius, "0.115787430901046546678802709324");
    assert_digits(&grips.indentation, "-0.0972356180448203840687689439159");
    assert_digits(&grips.force, "-0.00982937701464079248094751300981");
    let load = &folds(medium, SQUARE, LOAD)[0];
    assert_digits(&load.contact_radius, "0.296341357698877810555154994338");
    assert_digits(&load.indentation, "-0.0286586201389137402805809379837");
    assert_digits(&load.force, "-0.0259181393921157942173168079121");
}

/// A ball breaks at −(3 + k)/2·πwR on any graded medium, here −2πwR at the depth 0; under fixed grips it does not jump.
#[test]
fn winkler_foundation() {
    let medium = "kind = \"winkler\"\nmodulus = 7";
    let ball = "kind = \"paraboloid\"\nradius = 2";
    let load = &folds(medium, ball, LOAD)[0];
    assert_digits(&load.force, "-0.12566370614359172953850573533");
    assert_eq!(load.indentation.to_f64(), Some(0.0));
    assert!(folds(medium, ball, GRIPS).is_empty());
}

/// The springs of a Winkler foundation hold to d = −√(2w/K_w): a loop loses the energy of the jump into contact at d = 0, where
/// g(a) = Δl, wA − πK_w∫x g² dx.
#[test]
fn a_loop_on_a_winkler_foundation() {
    let way = "kind = \"indentation\"\npath = [\"-1\", \"0.1\", \"-1\"]\nstart = \"detached\"";
    let text = scene(
        "kind = \"winkler\"\nmodulus = 2",
        "kind = \"paraboloid\"\nradius = 1",
        way,
        "want = [\"path\"]\ndigits = 20",
    );
    let answer = solve(&text);
    let path = answer.path().expect("wanted");
    let kinds: Vec<EventKind> = path.events.items.iter().map(|event| event.event).collect();
    use EventKind::{Detached, End, JumpIn, Start, WayPoint};
    assert_eq!(kinds, [Start, JumpIn, WayPoint, Detached, End]);
    let detached = &path.events.items[3];
    // Δl = √(2·0.01/2) = 1/10.
    assert_eq!(detached.indentation.as_ref().and_then(Value::to_f64), Some(-0.1));
    let balance = path.balance.as_ref().expect("finite");
    // With a² = 2RΔl: πK_w∫x(x²/2)² dx = πK_w a⁶/24.
    let (k, w, l) = (2.0, 0.01, 0.1_f64);
    let square = 2.0 * l;
    let lost = std::f64::consts::PI * (w * square - k * square.powi(3) / 24.0);
    let found = balance.dissipated.to_f64().expect("a number");
    assert!((found / lost - 1.0).abs() < 1e-14, "{found} {lost}");
    assert_eq!(answer.promise(), Promise::Certified);
}

/// Of powers and of a wave every number is proved: losses, balances, energies and stiffnesses.
#[test]
fn energies_of_closed_forms_are_proved() {
    let media = [
        ("kind = \"graded\"\nexponent = 0.3\ncoefficient = 2", SQUARE),
        ("kind = \"graded\"\nexponent = -0.4\ncoefficient = 2", "kind = \"cone\"\nslope = 0.3"),
        ("kind = \"winkler\"\nmodulus = 3", SQUARE),
        (PERIODIC, WAVE),
    ];
    let ways = [
        "kind = \"indentation\"\npath = [-1, 0.1, -1]",
        "kind = \"force\"\npath = [0, 0.2, -1]",
        "kind = \"machine\"\nstiffness = 0.7\npath = [-1, 0.1, -4]",
    ];
    for (medium, profile) in media {
        for way in ways {
            let want = "want = [\"path\", \"energy\"]\ndigits = 20\nequilibria = { at = [\"0.05\"] }";
            let text = scene(medium, profile, &format!("{way}\nstart = \"detached\""), want);
            let answer = solve(&text);
            assert_eq!(answer.promise(), Promise::Certified, "{text}");
            let in_f64 = solve(&text.replace("digits = 20", "arithmetic = \"f64\""));
            let energies = |answer: &Answer| -> Vec<f64> {
                let of = |at: &mdr::answer::AtValue<mdr::answer::EnergyState>| {
                    at.items
                        .iter()
                        .flat_map(|state| [&state.energy, &state.stiffness])
                        .filter_map(Value::to_f64)
                        .collect()
                };
                answer.energy().expect("wanted").items.iter().flat_map::<Vec<f64>, _>(of).collect()
            };
            let [proved, found] = [&answer, &in_f64].map(energies);
            assert!(!proved.is_empty() && proved.len() == found.len(), "{proved:?} {found:?}\n{text}");
            let close = |(one, other): (&f64, &f64)| (one / other - 1.0).abs() < 1e-9;
            assert!(proved.iter().zip(&found).all(close), "{proved:?} {found:?}\n{text}");
        }
    }
}

/// (E* = 1, w = 1/100, C = 1; b, F) of MEDIA.
#[test]
fn line_contact() {
    let rows = [
        ("kind = \"power\"\nn = 1\nc = 1", "0.0157079632679489661923132169164", "-0.0157079632679489661923132169164"),
        (SQUARE, "0.11675443249407359924094248537", "-0.0642373898770883625007337513968"),
        (
            "kind = \"power\"\nn = \"1/4\"\nc = 1",
            "0.205379013679104853025403034976",
            "0.113597288750726217274819194434",
        ),
        ("kind = \"paraboloid\"\nradius = 1", "0.185336108963042562922120435725", "-0.0809340396964474671233119722858"),
    ];
    for (profile, radius, force) in rows {
        let fold = &folds("kind = \"plane\"", profile, LOAD)[0];
        assert_digits(&fold.contact_radius, radius);
        assert_digits(&fold.force, force);
        assert!(fold.indentation.number().is_none() && fold.indentation.status() == Status::Ok);
    }
    let answer = solve(&scene("kind = \"plane\"", SQUARE, LOAD, "want = [\"folds\"]"));
    assert_eq!(answer.force_unit, "N/m");
    assert_eq!(answer.title(&answer.outputs[0], "force"), ("force", "N/m"));
    let why = complaint(&scene("kind = \"plane\"", SQUARE, GRIPS, "want = [\"folds\"]"));
    assert!(why.contains("reference") && why.starts_with("scene.toml:"), "{why}");
}

/// Against a reference the fold of δ_L is where its numerical derivative vanishes, δ_L and F from their formulas for a cylinder.
#[test]
fn line_contact_against_a_reference() {
    let medium = "kind = \"plane\"\nreference = 10";
    let cylinder = "kind = \"paraboloid\"\nradius = 1";
    let fold = &folds(medium, cylinder, GRIPS)[0];
    let pi = std::f64::consts::PI;
    // δ_L = (2/π)∫arcosh(L/c)N' dc − (2/π)arcosh(L/b)Δl with N = πb²/4: ∫₀ᵇ arcosh(L/c)c dc = ½[b² arcosh(L/b) + L²(1 − √(1 − b²/L²))].
    let depth = |b: f64| {
        let (l, arcosh) = (10.0_f64, (10.0 / b).acosh());
        let far = l * l * (1.0 - (1.0 - (b / l).powi(2)).sqrt());
        0.5 * (b * b * arcosh + far) - 2.0 / pi * arcosh * (2.0 * pi * 0.01 * b).sqrt()
    };
    let b = fold.contact_radius.to_f64().expect("a number");
    let d = fold.indentation.to_f64().expect("a number");
    assert!((depth(b) / d - 1.0).abs() < 1e-11, "{} {d}", depth(b));
    assert!(depth(0.98 * b) > d && depth(1.02 * b) > d);
    let force = pi / 4.0 * b * b - (2.0 * pi * 0.01 * b).sqrt();
    assert!((fold.force.to_f64().expect("a number") / force - 1.0).abs() < 1e-13);
}

/// α = 0.3 of MEDIA: forces over p* = π, contact radii as angles over π.
#[test]
fn johnsons_wave_under_a_load() {
    let folds = folds(PERIODIC, WAVE, LOAD);
    // P = −0.0959440263420646401834393766371 and 0.387727760720551064348407731248, times π.
    assert_digits(&folds[0].force, "-0.301417048312055876458813186605");
    assert_digits(&folds[1].force, "1.21808268467250442150553066913");
    // 1 − H.
    assert_digits(&folds[0].indentation, "-0.29244079277598441516112033957");
    assert_digits(&folds[1].indentation, "0.9197966698103662848699010301809");
    let way = "kind = \"force\"\npath = [\"-2\", \"2\"]\nstart = \"detached\"";
    let answer = solve(&scene(PERIODIC, WAVE, way, "want = [\"path\"]\ndigits = 20"));
    let events = &answer.path().expect("wanted").events.items;
    let kinds: Vec<EventKind> = events.iter().map(|event| event.event).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::JumpIn, EventKind::CompleteContact]);
    let losses: Vec<f64> = events[1..]
        .iter()
        .map(|event| match &event.dissipated {
            Some(mdr::answer::Dissipation::Finite(loss)) => loss.to_f64().expect("a number"),
            other => panic!("{other:?}"),
        })
        .collect();
    for (loss, expected) in losses.iter().zip([0.031_839_855_235_911_49, 0.012_359_791_681_897_145]) {
        assert!((loss / (std::f64::consts::PI * expected) - 1.0).abs() < 1e-15, "{loss}");
    }
    assert!(answer.notes.iter().any(|note| note.contains("never detaches")), "{:?}", answer.notes);
    assert_eq!(answer.force_unit, "Pa");
}

/// P = cos²(πc/λ) − α√cot(πc/λ) at a flaw of the half-width c.
#[test]
fn a_flaw_opens_the_complete_contact() {
    let way = "kind = \"force\"\npath = [\"-2\", \"2\"]\nstart = \"detached\"";
    let flawed = format!("{PERIODIC}\nflaw = \"0.05\"");
    let want = "want = [\"path\", \"curve\"]\ncurve = { at = [\"0.45\"] }\narithmetic = \"f64\"";
    let answer = solve(&scene(&flawed, WAVE, way, want));
    let angle = std::f64::consts::PI * 0.05;
    let expected = std::f64::consts::PI * (angle.cos().powi(2) - 0.3 / angle.tan().sqrt());
    assert!(answer.notes.iter().any(|note| note.contains(&format!("{expected:.6e} Pa"))), "{:?}", answer.notes);
    let why = complaint(&scene(&format!("{PERIODIC}\nflaw = \"0.5\""), WAVE, way, want));
    assert!(why.starts_with("scene.toml:") && why.contains("half of the wavelength"), "{why}");
}

/// κ = 0: one fold; κ = 2: two, at the angles of MEDIA.
#[test]
fn johnsons_wave_by_its_approach() {
    let grips = &folds(PERIODIC, WAVE, GRIPS)[..];
    assert_eq!(grips.len(), 1);
    let angle = |fold: &Fold| std::f64::consts::PI * fold.contact_radius.to_f64().expect("a number");
    assert!((angle(&grips[0]) / 0.070_734_343_797_838_03 - 1.0).abs() < 1e-15);
    assert_digits(&grips[0].indentation, "-0.39170871811427556509813294049");
    // K = πE*/(κλ) = π/2.
    let machine = "kind = \"machine\"\nstiffness = \"1.5707963267948966192313216916397514420985846996875529\"";
    let pair = folds(PERIODIC, WAVE, machine);
    let angles = [0.098_122_737_754_104_06, 1.229_819_869_496_210_4];
    assert_eq!(pair.len(), 2);
    for (fold, expected) in pair.iter().zip(angles) {
        assert!((angle(fold) / expected - 1.0).abs() < 1e-15);
    }
}

/// α → 0 is the cylinder of the curvature of the crests, R = λ²/(4π²h₀): the pull-off force per period.
#[test]
fn a_weak_wave_is_a_row_of_cylinders() {
    let text = scene(PERIODIC, WAVE, LOAD, "want = [\"folds\"]").replace(ALPHA_3, "1e-12");
    let wave = solve(&text).folds().expect("wanted").items[0].force.to_f64().expect("a number");
    let (pi, w) = (std::f64::consts::PI, 1e-12_f64);
    let cylinder = -3.0 * (pi * w * w / (16.0 * 4.0 * pi * pi)).cbrt();
    // s ~ (α/4)^(4/3) is of the order of 1e-8 there.
    assert!((wave / cylinder - 1.0).abs() < 1e-7, "{wave} {cylinder}");
}

/// Every digit and every bit of the half-space.
#[test]
fn no_grading_is_the_half_space() {
    for arithmetic in ["digits = 30", "arithmetic = \"f64\""] {
        let want = format!(
            "want = [\"folds\", \"equilibria\", \"energy\"]\n{arithmetic}\n[output.equilibria]\nat = [0, \"0.1\"]"
        );
        for profile in [SQUARE, "kind = \"hyperboloid\"\nslope = 1\nlateral = 2"] {
            let graded = scene("kind = \"graded\"\nexponent = 0\ncoefficient = 3", profile, GRIPS, &want);
            let half_space = scene("kind = \"half-space\"", profile, GRIPS, &want)
                .replace("[material]\n", "[material]\ne_star = 3\n");
            assert_eq!(solve(&graded).to_json(), solve(&half_space).to_json());
        }
    }
}

/// In other units of length and force the digits stay.
#[test]
fn digits_do_not_depend_on_units() {
    let graded =
        |exponent: &str, c: &str| format!("kind = \"graded\"\nexponent = \"{exponent}\"\ncoefficient = \"{c}\"");
    let ball = |radius: &str| format!("kind = \"paraboloid\"\nradius = \"{radius}\"");
    // Lengths times 10³ at the same w: c, in N/m^(2+k), is divided by 10^(3(1 + k)), and forces are multiplied by 10³.
    let [one, other] = [
        folds(&graded("-1/3", "100"), &ball("1e-3"), GRIPS).remove(0),
        folds(&graded("-1/3", "1"), &ball("1"), GRIPS).remove(0),
    ];
    for (one, other) in [
        (&one.contact_radius, &other.contact_radius),
        (&one.indentation, &other.indentation),
        (&one.force, &other.force),
    ] {
        assert_eq!(digits(one), digits(other));
    }
    let [wave, wide] = ["1", "1000"].map(|length| {
        let text = scene(&PERIODIC.replace('1', length), &WAVE.replace('1', length), LOAD, "want = [\"folds\"]");
        // w scales with the lengths at a constant E*.
        let work = if length == "1" { ALPHA_3.to_owned() } else { ALPHA_3.replacen("0.444", "444.", 1) };
        solve(&text.replace(ALPHA_3, &work)).folds().expect("wanted").items[1].clone()
    });
    assert_eq!(digits(&wave.force), digits(&wide.force));
    assert_eq!(digits(&wave.contact_radius), digits(&wide.contact_radius));
    // Springs in Pa/m are divided by 10⁶ and forces multiplied by 10³; on a half-plane w and F, per length, grow as lengths do.
    let springs = ["2e6", "2"].map(|modulus| format!("kind = \"winkler\"\nmodulus = \"{modulus}\""));
    let planes = ["0.01", "10"].map(|reference| format!("kind = \"plane\"\nreference = \"{reference}\""));
    for (media, control) in [(&springs, LOAD), (&planes, LOAD), (&planes, GRIPS)] {
        let [one, other] = ["1e-3", "1"].map(|radius| {
            let medium = &media[usize::from(radius == "1")];
            let text = scene(medium, &ball(radius), control, "want = [\"folds\"]\ndigits = 20");
            let work = if radius == "1" || medium.contains("winkler") { "1/100" } else { "1/100000" };
            solve(&text.replace("1/100", work)).folds().expect("wanted").items[0].clone()
        });
        assert_eq!(digits(&one.force), digits(&other.force), "{control}");
        assert_eq!(digits(&one.contact_radius), digits(&other.contact_radius), "{control}");
        assert_eq!(digits(&one.indentation), digits(&other.indentation), "{control}");
    }
}

/// The coefficient c from moduli where the field of a point force is known in closed form: with ν = 1/(2 + k) the stress is radial,
/// σ = −(3 + k)P cos^(1+k)θ/(2πR²), and the surface sinks by (3 + k)P/(2π(1 + k)(2 + k)E₀r^(1+k)), which is P cos(πk/2)/(πc r^(1+k)); and
/// an incompressible half-space whose shear modulus grows as G = mz is a Winkler foundation, K_w = 2m (R. E. Gibson, Géotechnique 17
/// (1967) 58).
#[test]
fn moduli_of_a_graded_half_space() {
    let pi = std::f64::consts::PI;
    let coefficient = |exponent: &str, nu: &str| {
        let body = mdr_core::contact::Body {
            youngs_modulus: "3".parse().expect("a number"),
            poissons_ratio: nu.parse().expect("a number"),
        };
        let stiffness = Grading::Moduli { depth: "2".parse().expect("a number"), bodies: vec![body] };
        let medium = ExactMedium::Graded { exponent: exponent.parse().expect("a number"), stiffness };
        medium.own_modulus::<f64>(()).expect("in its domain").expect("of its own")
    };
    for tenths in [1, 3, 6, 9] {
        let k = f64::from(tenths) / 10.0;
        let found = coefficient(&format!("{tenths}/10"), &format!("10/{}", 20 + tenths));
        let expected = 2.0 * (pi * k / 2.0).cos() * (1.0 + k) * (2.0 + k) / (3.0 + k) * 3.0 / 2f64.powf(k);
        assert!((found / expected - 1.0).abs() < 1e-13, "k = {k}: {found} {expected}");
    }
    // E = 3z/2 and ν = 1/2: G = z/2, K_w = 1, c = πK_w.
    let found = coefficient("0.9999999999", "1/2");
    assert!((found / pi - 1.0).abs() < 1e-8, "{found}");
}

/// u = d − f + gap: the displacement by the loads within the contact, the gap by those outside of it.
#[test]
fn displacements_close_the_gap() {
    let (line, cylinder) = ("kind = \"plane\"\nreference = 10", "kind = \"paraboloid\"\nradius = 1");
    let wave = |r: f64| 1.0 - (2.0 * std::f64::consts::PI * r).cos();
    type Case<'a> = (&'a str, &'a str, f64, &'a dyn Fn(f64) -> f64);
    let cases: [Case<'_>; 2] = [(line, cylinder, 0.9, &|r| r * r / 2.0), (PERIODIC, WAVE, 0.498, &wave)];
    for (medium, profile, r, height) in cases {
        let want = format!(
            "want = [\"gap\", \"displacement\"]\nequilibria = {{ at = [\"0.1\"] }}\ngap = {{ at = [\"{r}\"] }}\n\
             displacement = {{ at = [\"{r}\"] }}\ndigits = 16"
        );
        let answer = solve(&scene(medium, profile, LOAD, &want)).to_json();
        let answer: serde_json::Value = serde_json::from_str(&answer).expect("JSON");
        let states = |name: &str| answer[name][0]["states"].as_array().expect("states").clone();
        let number =
            |value: &serde_json::Value| value.as_f64().or_else(|| value.as_str().and_then(|text| text.parse().ok()));
        let mut seen = 0;
        for (gap, moved) in states("gap").iter().zip(&states("displacement")) {
            let numbers = [&gap["indentation"], &gap["gap"][0]["gap"], &moved["displacement"][0]["displacement"]];
            let [Some(d), Some(gap), Some(moved)] = numbers.map(number) else { continue };
            assert!((d - height(r) + gap - moved).abs() < 1e-12, "{medium}: {d} {gap} {moved}");
            seen += 1;
        }
        assert!(seen > 0, "{answer}");
    }
    let want =
        "want = [\"displacement\"]\nequilibria = { at = [\"0.1\"] }\ndisplacement = { at = [\"2\"] }\ndigits = 8";
    assert!(solve(&scene("kind = \"plane\"", cylinder, LOAD, want)).to_json().contains("without a reference"));
}

/// The examples are scenes with answers.
#[test]
fn examples() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/media");
    for name in ["graded", "winkler", "cylinder", "wave"] {
        let answer = Scene::open(folder.join(format!("{name}.toml"))).and_then(|scene| scene.solve());
        let path = answer.unwrap_or_else(|why| panic!("{why}"));
        assert!(path.path().expect("wanted").events.items.len() > 2, "{name}");
        assert!(!path.to_json().contains("undecided"), "{name}");
    }
}

/// A wave as a formula, through the quadrature of any periodic profile, in digits on which two precisions agree.
#[test]
fn a_periodic_formula_is_the_wave() {
    let formula = "kind = \"expression\"\nformula = \"1 - cos(2*pi*r)\"";
    let text = scene(PERIODIC, WAVE, LOAD, "want = [\"folds\"]\ndigits = 16").replace(WAVE, formula);
    let found = solve(&text);
    let closed = folds(PERIODIC, WAVE, LOAD);
    let found = &found.folds().expect("wanted").items;
    assert_eq!(found.len(), 2);
    for (one, other) in found.iter().zip(&closed) {
        let [one, other] = [one, other].map(|fold| fold.force.to_f64().expect("a number"));
        assert!((one / other - 1.0).abs() < 1e-15, "{one} {other}");
    }
    let why = complaint(&text.replace("2*pi*r", "4*pi*r"));
    assert!(why.contains("more than one contact"), "{why}");
    let why = complaint(&text.replace("2*pi*r", "3*r"));
    assert!(why.contains("not periodic"), "{why}");
}

/// A scene of measured rows on a periodic medium of the wavelength 1.
fn rows_on_waves(rows: &[(f64, f64)], output: &str) -> Result<Answer, mdr::Error> {
    let csv: String = rows.iter().map(|(r, f)| format!("{r},{f:e}\n")).collect();
    let text = scene(PERIODIC, "kind = \"table\"\nfile = \"rows.csv\" # a wave", LOAD, output);
    let files = move |_: &str| Ok(csv.clone().into_bytes());
    Scene::from_toml(&text, "scene.toml", &files).and_then(|scene| scene.solve())
}

/// Rows of a wave, from crest to trough or over one and a half periods, have the folds of the wave but for their interpolation.
#[test]
fn a_table_of_half_a_period_is_the_wave() {
    let row = |step: u32| {
        let r = f64::from(step) / 40.0;
        (r, 1.0 - (2.0 * std::f64::consts::PI * r).cos())
    };
    let half: Vec<(f64, f64)> = (0..=20).map(row).collect();
    let longer: Vec<(f64, f64)> = (0..=60).map(row).collect();
    let closed = folds(PERIODIC, WAVE, LOAD);
    for rows in [&half, &longer] {
        let answer = rows_on_waves(
            rows,
            "want = [\"folds\", \"energy\"]\nequilibria = { at = [\"0.1\"] }\narithmetic = \"f64\"",
        )
        .expect("rows of a wave");
        let found = &answer.folds().expect("wanted").items;
        assert_eq!(found.len(), 2);
        for (one, other) in found.iter().zip(&closed) {
            let [one, other] = [one, other].map(|fold| fold.force.to_f64().expect("a number"));
            assert!((one / other - 1.0).abs() < 1e-2, "{one} {other}");
        }
    }
}

/// Rows of another wavelength, and rows that end before the trough, are refused with the remedy.
#[test]
fn a_table_that_is_not_periodic_is_refused() {
    let of = |period: f64, last: u32| {
        let row = move |step: u32| {
            let r = f64::from(step) / 200.0;
            (r, 1.0 - (2.0 * std::f64::consts::PI * r / period).cos())
        };
        (0..=last).map(row).collect::<Vec<_>>()
    };
    let want = "want = [\"folds\"]\narithmetic = \"f64\"";
    let cases =
        [(of(1.0, 80), "measure as far"), (of(1.4, 130), "not periodic"), (of(0.7, 100), "more than one contact")];
    for (rows, expected) in cases {
        let why = rows_on_waves(&rows, want).expect_err("a bad table").to_string();
        assert!(why.starts_with("scene.toml:") && why.contains(expected), "{why}");
    }
}

/// The depth of a cylinder close to its reference, against ½[b² arcosh(L/b) + L²(1 − √(1 − b²/L²))].
#[test]
fn depths_close_to_the_reference() {
    let want = "want = [\"transform\"]\ntransform = { at = [\"2\", \"2.2\", \"2.9\", \"2.999999\"] }\ndigits = 12";
    let text = scene("kind = \"plane\"\nreference = 3", "kind = \"paraboloid\"\nradius = 1", GRIPS, want);
    let answer = solve(&text);
    for item in &answer.transform().expect("wanted").items {
        let b: f64 = item.x.nearest_f64();
        let depth = 0.5 * (b * b * (3.0 / b).acosh() + 9.0 * (1.0 - (1.0 - (b / 3.0).powi(2)).sqrt()));
        let g = item.g.to_f64().expect("a number");
        assert!((g / depth - 1.0).abs() < 1e-11, "{b} {g} {depth}");
    }
}

/// Where surfaces first touch is a matter of f: a periodic formula begins apart, and so does a wavy cylinder against a reference.
#[test]
fn paths_begin_apart_where_g_is_not_searched() {
    let way = "kind = \"indentation\"\npath = [\"-0.1\", \"0.02\", \"-0.2\"]\nstart = \"detached\"";
    let want = "want = [\"path\"]\narithmetic = \"f64\"";
    let waves = "kind = \"expression\"\nformula = \"0.05*(1 - cos(2*pi*r)) + 0.01*sin(pi*r)^4\"";
    let wavy = "kind = \"wavy-paraboloid\"\nradius = 1\namplitude = \"5e-4\"\nwavelength = \"0.1\"";
    let plane = "kind = \"plane\"\nreference = 3";
    for (medium, profile) in [(PERIODIC, waves), (plane, wavy)] {
        let text = scene(medium, profile, way, want).replace("1/100", "1e-3").replace(ALPHA_3, "1e-3");
        let answer = solve(&text);
        let kinds: Vec<EventKind> =
            answer.path().expect("wanted").events.items.iter().map(|event| event.event).collect();
        use EventKind::{Detached, End, JumpIn, Start, WayPoint};
        assert_eq!(kinds, [Start, JumpIn, WayPoint, Detached, End], "{medium} {:?}", answer.path());
    }
}

/// The gap of a half-space says nothing of another medium: where g falls there, states are neither admissible nor not.
#[test]
fn a_falling_g_decides_nothing_off_the_half_space() {
    let deep = "kind = \"wavy-paraboloid\"\nradius = 1\namplitude = \"2e-3\"\nwavelength = \"0.1\"";
    let graded = "kind = \"graded\"\nexponent = \"0.3\"\ncoefficient = 1";
    let answer = solve(&scene(graded, deep, GRIPS, "want = [\"folds\"]\ndigits = 8").replace(ALPHA_3, "1e-4"));
    let admissible =
        answer.folds().expect("wanted").items.iter().all(|fold| !matches!(fold.admissible, Admission::Unknown { .. }));
    assert!(!admissible, "g falls, and the gap is not searched");
}

/// Bad input names its place and the remedy.
#[test]
fn complaints() {
    let want = "want = [\"folds\"]";
    let cases = [
        (scene("kind = \"graded\"\nexponent = 1\ncoefficient = 1", SQUARE, LOAD, want), "winkler"),
        (scene("kind = \"graded\"\nexponent = \"-1\"\ncoefficient = 1", SQUARE, LOAD, want), "within (-1, 1)"),
        (scene("kind = \"graded\"\nexponent = 0.5\ncoefficient = 0", SQUARE, LOAD, want), "positive"),
        (scene("kind = \"graded\"\nexponent = 0.5", SQUARE, LOAD, want), "coefficient"),
        (scene("kind = \"winkler\"\nmodulus = \"1 MPa\"", SQUARE, LOAD, want), "Pa/m"),
        (scene("kind = \"wobbly\"", SQUARE, LOAD, want), "periodic"),
        (scene("kind = \"plane\"", WAVE, LOAD, want), "periodic"),
        (scene(PERIODIC, SQUARE, LOAD, want), "wave"),
        (scene("kind = \"periodic\"", WAVE, LOAD, want), "wavelength"),
        (scene("kind = \"periodic\"\nwavelength = 0", WAVE, LOAD, want), "medium.wavelength: must be positive"),
        (scene("kind = \"winkler\"\nmodulus = -1", SQUARE, LOAD, want), "medium.modulus: must be positive"),
        (scene("kind = \"plane\"", SQUARE, GRIPS, want), "reference = its distance"),
        (
            scene(PERIODIC, "kind = \"expression\"\nformula = \"1 - cos(4*pi*r)\"", LOAD, want),
            "more than one contact in a period",
        ),
        (scene(PERIODIC, "kind = \"expression\"\nformula = \"r^2\"", LOAD, want), "kind = \"wave\""),
        (
            scene("kind = \"plane\"", SQUARE, LOAD, "want = [\"energy\"]\nequilibria = { at = [0] }"),
            "that of a line contact grows without bound",
        ),
        (
            scene(
                "kind = \"graded\"\nexponent = \"0.3\"\ncoefficient = 1",
                "kind = \"power\"\nn = \"0.1\"\nc = 1",
                "kind = \"force\"\npath = [\"0\", \"1\"]",
                "want = [\"path\"]",
            ),
            "(1 − k)/2",
        ),
    ];
    for (text, part) in cases {
        let why = complaint(&text);
        assert!(why.starts_with("scene.toml:") && why.contains(part), "{why}\n{text}");
    }
}

/// S of a small contact on a Winkler foundation leaves the doubles before its radius does: what is beyond them is no fold. The springs
/// elongate alike at every radius, so that a machine has one fold, at g' = S'Δl/(K + S), whatever its stiffness.
#[test]
fn a_machine_on_a_winkler_foundation_has_one_fold_in_f64() {
    for stiffness in ["0.01", "1", "100"] {
        let text = format!(
            "medium = {{ kind = \"winkler\", modulus = \"0.5\" }}
            material = {{ work_of_adhesion = \"0.006\" }}
            profile = {{ kind = \"power\", n = \"2.06\", c = \"0.3\" }}
            control = {{ kind = \"machine\", stiffness = \"{stiffness}\" }}
            output = {{ want = [\"folds\"], arithmetic = \"f64\" }}"
        );
        let folds = solve(&text).folds().unwrap().items.clone();
        assert_eq!(folds.len(), 1, "{folds:?}");
        let a = folds[0].contact_radius.to_f64().unwrap();
        let k: f64 = stiffness.parse().unwrap();
        let pi = std::f64::consts::PI;
        // On a Winkler foundation g is f, S = πK_w a², and Δl = √(2w/K_w).
        let (left, lag) = (2.06 * 0.3 * a.powf(1.06), (2.0f64 * 0.006 / 0.5).sqrt());
        let right = 2.0 * pi * 0.5 * a * lag / (k + pi * 0.5 * a * a);
        assert!((left / right - 1.0).abs() < 1e-12, "{stiffness}: {left:e} and {right:e}");
    }
}
