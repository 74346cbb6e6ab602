//! No call of the engine may trap: in a page a trap ends the engine for good. Whatever comes in, an answer comes out, or a
//! failure with words.

use std::cell::RefCell;
use std::io::Write as _;
use std::sync::Once;

use mdr_wasm::{
    Failure, advance, advancing_curve, advancing_equilibria, balance, contact, curve, equilibria, input, kappa, pinned,
    surface, verify,
};

/// Splitmix64: the same numbers on every machine.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Between 0 and 1.
    fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[(self.bits() % of.len() as u64) as usize]
    }

    /// A length or a value as the page asks for, and one time in three a number that it never would.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        if self.bits().is_multiple_of(3) { self.pick(EXTREMES) } else { self.between(low, high) }
    }

    fn count(&mut self) -> u32 {
        self.pick(&[0, 1, 2, 3, 7, 110, 300, 100_000, u32::MAX])
    }
}

const EXTREMES: &[f64] = &[
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    -1.0,
    5e-324,
    -1e-300,
    f64::MIN_POSITIVE,
    1e-30,
    1e30,
    1e150,
    -1e200,
    f64::MAX,
    f64::MIN,
];

/// A parameter of a profile as text; one time in eight it is out of its domain, or far beyond what the page allows.
fn parameter(random: &mut Random, low: f64, high: f64) -> String {
    const WRONG: &[&str] = &["0", "-1", "nan", "inf", "\"1/0\"", "\"\"", "[1]"];
    const FAR: &[&str] = &["1e-300", "1e300", "1e-30", "1e30"];
    if random.bits().is_multiple_of(16) {
        return random.pick(WRONG).to_owned();
    }
    if random.bits().is_multiple_of(16) {
        return random.pick(FAR).to_owned();
    }
    format!("{}", low * (high / low).powf(random.share()))
}

/// A profile as the page writes it, or one of the others that a scene may have; and its table.
fn profile(random: &mut Random) -> (String, String) {
    let kinds = "power power power paraboloid ellipsoid wavy-paraboloid wavy-paraboloid table sphere cone flat-punch \
        truncated-cone truncated-paraboloid cone-parabolic-cap cone-spherical-cap hyperboloid rounded-punch \
        displaced-paraboloid parabolic-dimple elliptical-dimple expression wave wave";
    let kinds: Vec<&str> = kinds.split_whitespace().collect();
    let kind = random.pick(&kinds);
    let mut lines = format!("kind = \"{kind}\"\n");
    let set = |lines: &mut String, random: &mut Random, key: &str, low: f64, high: f64| {
        *lines += &format!("{key} = {}\n", parameter(random, low, high));
    };
    match kind {
        "power" => {
            // Half of them close to n = 1/2, where radii leave every range; ρ of the page is κ_n C.
            let n = if random.bits().is_multiple_of(2) { random.between(0.45, 0.55) } else { random.between(0.1, 4.0) };
            let c = 0.4 * 10f64.powf(random.share()) / kappa(n);
            set(&mut lines, random, "n", n, n);
            set(&mut lines, random, "c", c, c);
        }
        "wave" => set(&mut lines, random, "amplitude", 0.1, 3.0),
        "ellipsoid" => ["lateral", "height"].iter().for_each(|key| set(&mut lines, random, key, 0.5, 36.0)),
        "wavy-paraboloid" => {
            // Waves without end are a search without end: they stay within what the page allows.
            for (key, low, high) in [("radius", 0.25, 2.5), ("amplitude", 1e-4, 0.2), ("wavelength", 0.25, 2.0)] {
                lines += &format!("{key} = {}\n", random.between(low, high));
            }
        }
        "table" => {
            lines += "file = \"profile.csv\"\n";
            return (lines, table(random));
        }
        "expression" => {
            let formulas = [
                "r^2",
                "r^2/(1 + r)",
                "sqrt(4 - r^2) - 2",
                "abs(r - 1) - 1",
                "0*r",
                "-(r^2)",
                "r^0.51",
                "1/r",
                "exp(r) - 1",
            ];
            lines += &format!("formula = \"{}\"\n", random.pick(&formulas));
        }
        _ => {
            let keys = [
                (
                    "radius",
                    "paraboloid sphere flat-punch truncated-paraboloid cone-spherical-cap rounded-punch displaced-paraboloid parabolic-dimple elliptical-dimple",
                ),
                ("slope", "cone truncated-cone cone-parabolic-cap cone-spherical-cap hyperboloid"),
                ("flat", "truncated-cone truncated-paraboloid rounded-punch"),
                ("cap", "cone-parabolic-cap"),
                ("lateral", "hyperboloid"),
                ("offset", "displaced-paraboloid"),
                ("depth", "parabolic-dimple elliptical-dimple"),
            ];
            for (key, kinds) in keys {
                if kinds.split(' ').any(|one| one == kind) {
                    set(&mut lines, random, key, 0.1, 5.0);
                }
            }
        }
    }
    (lines, String::new())
}

/// A tip with and without bumps, and now and then a table that is none.
fn table(random: &mut Random) -> String {
    let (count, bump) = (random.pick(&[4, 5, 12, 33]), random.pick(&[0.0, 0.0, 0.1, 0.4]));
    let mut rows: Vec<String> = (0..count)
        .map(|i| 3.0 * f64::from(i) / f64::from(count - 1))
        .map(|r| format!("{r},{}", 0.3 * r * r + bump * r * (3.0 * r).sin().abs()))
        .collect();
    if random.bits().is_multiple_of(6) {
        let broken = ["", "nan,1", "0,0", "1e400,1", "2,-5", "a;b", "3,1e308"];
        let at = (random.bits() % count as u64) as usize;
        rows[at] = random.pick(&broken).to_owned();
    }
    rows.join("\n")
}

/// A medium as the page writes it: a half-space most of the time, and off it power laws alone.
fn medium(random: &mut Random, profile: &str) -> String {
    if profile.starts_with("kind = \"wave\"") {
        return format!("[medium]\nkind = \"periodic\"\nwavelength = {}\n", parameter(random, 1.0, 4.0));
    }
    let law = ["power", "paraboloid"].iter().any(|kind| profile.starts_with(&format!("kind = \"{kind}\"")));
    match random.bits() % 3 {
        0 if law => format!("[medium]\nkind = \"winkler\"\nmodulus = {}\n", parameter(random, 0.1, 1.0)),
        1 if law => {
            let (k, c) = (random.between(-0.95, 0.95), parameter(random, 0.5, 2.0));
            format!("[medium]\nkind = \"graded\"\nexponent = {k}\ncoefficient = {c}\n")
        }
        _ => String::new(),
    }
}

/// Writes a scene with E* = 1 and w = 1/2π, most of the time; its bytes, without its table.
fn open(random: &mut Random) -> usize {
    let (profile, table) = profile(random);
    let control = match random.bits() % 3 {
        0 => "kind = \"indentation\"".to_owned(),
        1 => "kind = \"force\"".to_owned(),
        _ => format!("kind = \"machine\"\nstiffness = {}", parameter(random, 0.03, 100.0)),
    };
    let [modulus, mut work] = [1.0, 0.5 / std::f64::consts::PI].map(|usual| parameter(random, usual, usual));
    if random.bits().is_multiple_of(3) {
        let advancing = parameter(random, 1e-3, 0.5 / std::f64::consts::PI);
        work = format!("{{ advancing = {advancing}, receding = {work} }}");
    }
    let medium = medium(random, &profile);
    let scene = format!(
        "[material]\ne_star = {modulus}\nwork_of_adhesion = {work}\n{medium}[control]\n{control}\n[profile]\n{profile}\n[output]\nwant = [\"folds\"]\n"
    );
    input(scene.len() + table.len());
    mdr_wasm::write(&[scene.as_bytes(), table.as_bytes()].concat());
    let length = scene.len();
    CALLED.set([scene + &table, "contact".to_owned()]);
    length
}

thread_local! {
    /// The scene that is open, and the call. A panic cannot leave an exported function: it ends the program, and the hook tells
    /// what led there.
    static CALLED: RefCell<[String; 2]> = RefCell::default();
}

fn tell_what_panicked() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let before = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            let [scene, call] = CALLED.with_borrow(Clone::clone);
            let _ = writeln!(std::io::stderr(), "{info}\nin {call} of\n{scene}");
            before(info);
        }));
    });
}

/// Rows without numbers that are none; but for the states of surfaces that touch everywhere, or are apart under a dead load.
fn checked(count: i32, width: usize, unknown: bool) {
    if count < 0 {
        let known = [Failure::Refused, Failure::Undecided, Failure::Empty, Failure::Unanswered];
        assert!(known.iter().any(|failure| *failure as i32 == count), "{count} is no failure");
        assert!(mdr_wasm::message_length() > 0, "a failure without words");
        return;
    }
    let rows = mdr_wasm::read(usize::MAX);
    assert_eq!(rows.len(), count as usize * width);
    assert!(unknown || !rows.iter().any(|x| x.is_nan()), "{rows:?}");
}

/// One call with numbers that are right, wrong or absurd.
fn ask(random: &mut Random) {
    let value = random.number(-1.5, 1.5);
    let [low, high] = [random.number(1e-6, 3.0), random.number(1e-6, 6.0)];
    let (count, power) = (random.count(), random.pick(&[0.0, 1.0, 2.0, 2.0, -1.0, 1e-300, f64::NAN, f64::INFINITY]));
    let note = |text: String| CALLED.with_borrow_mut(|[_, call]| *call = text);
    match random.bits() % 9 {
        0 => {
            note(format!("curve({low:?}, {high:?}, {count}, {power:?})"));
            checked(curve(low, high, count, power), 6, false);
        }
        1 => {
            note(format!("balance({value:?}, {low:?}, {high:?}, {count}, {power:?})"));
            checked(balance(value, low, high, count, power), 4, false);
        }
        2 => {
            note(format!("equilibria({value:?})"));
            checked(equilibria(value), 4, false);
        }
        3 | 4 => {
            let to = random.number(-1.5, 1.5);
            note(format!("advance({low:?}, {value:?}, {to:?})"));
            checked(advance(low, value, to), 10, true);
        }
        5 => {
            note(format!("surface({low:?}, {value:?}, {high:?}, {count})"));
            checked(surface(low, value, high, count), 3, false);
        }
        6 => {
            note(format!("advancing_curve({low:?}, {high:?}, {count}, {power:?})"));
            checked(advancing_curve(low, high, count, power), 6, false);
        }
        7 => {
            note(format!("advancing_equilibria({value:?}), pinned({low:?}, {value:?})"));
            checked(advancing_equilibria(value), 4, false);
            checked(pinned(low, value), 2, false);
        }
        _ => {
            note(format!("verify({low:?}), kappa({value:?}), outer_radius()"));
            checked(verify(low), 3, false);
            assert!(kappa(value) > 0.0 || kappa(value).is_nan());
            assert!(mdr_wasm::outer_radius() > 0.0 || mdr_wasm::outer_radius().is_nan());
        }
    }
}

/// Scenes and the calls of each, from one seed.
fn fuzz(seed: u64, scenes: u32, calls: u32) {
    tell_what_panicked();
    let mut random = Random(seed);
    for _ in 0..scenes {
        let length = open(&mut random);
        checked(contact(length), 4, false);
        (0..calls).for_each(|_| ask(&mut random));
    }
}

#[test]
fn room_is_given_up_to_a_stated_size() {
    assert!(!input(mdr_wasm::MOST_BYTES).is_null() && input(mdr_wasm::MOST_BYTES + 1).is_null());
    assert!(input(usize::MAX).is_null() && mdr_wasm::message_length() > 0);
    // What was not written is no scene.
    assert_eq!(contact(usize::MAX), Failure::Refused as i32);
}

/// *Through n = ½*, ρ = 2, n = 0.514: radii around a state far beyond those that are shown, from large to small.
#[test]
fn radii_in_descending_order_are_refused() {
    let scene = format!(
        "[material]\ne_star = 1\nwork_of_adhesion = 0.159\n[profile]\nkind = \"power\"\nn = 0.514\nc = {}\n[output]\nwant = [\"folds\"]\n",
        2.0 / kappa(0.514)
    );
    input(scene.len());
    mdr_wasm::write(scene.as_bytes());
    assert_eq!(contact(scene.len()), 1);
    for count in [balance(0.1, 40.0, 6.0, 60, 0.0), balance(0.1, 40.0, 6.0, 60, 2.0), curve(1.0, f64::NAN, 3, 2.0)] {
        assert_eq!(count, Failure::Refused as i32);
    }
    assert_eq!(balance(0.1, 4.0, 6.0, 60, 2.0), 60, "and the engine lives");
}

/// The calls of `MDR_FUZZ` scenes a seed, by default 300.
fn scenes() -> u32 {
    std::env::var("MDR_FUZZ").ok().and_then(|count| count.parse().ok()).unwrap_or(300)
}

#[test]
fn no_call_traps_whatever_comes_in_1() {
    fuzz(1, scenes(), 8);
}

#[test]
fn no_call_traps_whatever_comes_in_2() {
    fuzz(2, scenes(), 8);
}

#[test]
fn no_call_traps_whatever_comes_in_3() {
    fuzz(3, scenes(), 8);
}

#[test]
fn no_call_traps_whatever_comes_in_4() {
    fuzz(4, scenes(), 8);
}
