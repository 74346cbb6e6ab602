//! Struve functions against references computed independently with mpmath 1.3 (`mp.dps = 60`).
#![cfg(feature = "mp")]

use mdr_analytic::struve::Struve;
use mdr_core::number::{Dual, Interval, Precision, Real};
use rug::Float;

/// z, struveh(0, z), struveh(1, z)
const REFERENCES: &[(&str, &str, &str)] = &[
    (
        "1e-20",
        "6.36619772367581343075535053490057448137831509408799488531302e-21",
        "2.12206590789193781025178351163352482712611446276670003705016e-41",
    ),
    (
        "0.001",
        "0.000636619701632053909432094157725056277874961455404437424080148",
        "0.000000212206576642088132615283274885235916670736724272624372928944",
    ),
    (
        "0.5",
        "0.309555914583754718164073156748678025772304881089182244710199",
        "0.052173744242341070375597894712576000410454991431399628242124",
    ),
    (
        "1",
        "0.568656627048287950986422886322353274302677827255558738111195",
        "0.198457336201944398935338132648023772046057451200861170002744",
    ),
    (
        "2.999",
        "0.574689521418371269968046370560086539290808145649808995950652",
        "1.0198751254672444287116231988179451739108714859608048079406",
    ),
    (
        "3.001",
        "0.573922541940811581678456260356264716623718090942811900151298",
        "1.0203436646715171516481929807724043349347072107515481433036",
    ),
    (
        "4.33",
        "0.00120450917778055981932185602547294682405684585605789054797389",
        "1.00900788510909636005463070661409072509049695109989244751756",
    ),
    (
        "5.5",
        "-0.226849905430592349460543566561543156826316208993809735907996",
        "0.632381026387672731750632586539629343782661782219218748716509",
    ),
    (
        "10",
        "0.118743683687461268138511717884393960827597282135005967148111",
        "0.891832492094538111110267096186170110527208702638369234586934",
    ),
    (
        "20",
        "0.0943936980813234508965521881203605022797305522073260802653326",
        "0.472688184291042879880707194329464335573850395384868404057084",
    ),
    (
        "37",
        "-0.11352142638124542430323986437591997042931765620970548284212",
        "0.624454333726816730423591043634335621826693385136793071102196",
    ),
    (
        "47.123",
        "0.0959799809086981798713986392008423289234016836634324180710239",
        "0.719679826400071732658930469180745650515842131175343499865037",
    ),
    (
        "63",
        "-0.0482419313128014975088896963557596956169359158086633379801618",
        "0.554456763963860277727301020289775151153363347479378429167523",
    ),
    (
        "100",
        "-0.0708787516896473432040319780781936264983952919683455675788526",
        "0.616311103272013384540096712996346460192856348929038012535751",
    ),
    (
        "130",
        "-0.0228909580937887652078677523989488036608710515824008983190456",
        "0.700776266825809290136159006901225200056908575088006591491504",
    ),
    (
        "1000",
        "0.00535253711337635180998633105754389593621520583899558488822892",
        "0.611836077693092101071800172460768656062259524220391121673361",
    ),
    (
        "31415.9",
        "-0.00324618415598567932046663004544481526479976275193777529049478",
        "0.633522210955894317351179096894551157415395345340433393164334",
    ),
    (
        "1e8",
        "0.0000730702778529407467900015266330250994003677811128367039540127",
        "0.63658771207260631421735045227665292592736576689285172075207",
    ),
];

fn number(bits: u32, text: &str) -> Float {
    Real::from_literal(Precision::new(bits), &text.parse().expect("a decimal"))
}

#[test]
fn enclosures_contain_the_references_and_are_tight() {
    for (z, h0, h1) in REFERENCES {
        for bits in [30, 53, 120, 160] {
            let z: Interval = Real::from_literal(Precision::new(bits), &z.parse().expect("a decimal"));
            for (value, reference) in [(z.struve_h0(), h0), (z.struve_h1(), h1)] {
                let reference = number(230, reference);
                assert!(value.contains(&reference), "z = {z:?} at {bits} bits: {value:?} against {reference}");
                // A 50-digit argument has an error of z·2^−bits; slopes are below 2/π. Then a few roundings of numbers
                // below 2.
                let size = z.mid().to_f64().max(1.0);
                assert!(value.radius().to_f64() <= (size + 8.0) * 2f64.powi(1 - bits as i32), "z = {z:?}: {value:?}");
            }
        }
    }
}

#[test]
fn doubles_are_good_to_a_few_units_of_their_scale() {
    for (z, _, _) in REFERENCES {
        let z: f64 = z.parse().expect("a double");
        // Exact at the double itself.
        let exact = Interval::point(Float::with_val(120, z));
        for (value, exact) in [(z.struve_h0(), exact.struve_h0()), (z.struve_h1(), exact.struve_h1())] {
            let error = (Float::with_val(120, value) - exact.mid()).to_f64().abs();
            // Relative for small z, where H ~ z or z²; absolute 4·2⁻⁵² for the rest.
            let scale = exact.mid().to_f64().abs().max(if z > 1.0 { 0.5 } else { 0.0 });
            assert!(error <= 8.0 * f64::EPSILON / 2.0 * scale, "z = {z}: {value}, error {error:e}");
        }
    }
}

/// Two algorithms meet at z = 0.7 p + 10, and more bits select the other one: enclosures of all precisions overlap, are
/// tight, and are equal whether computed one by one or together.
#[test]
fn precisions_and_algorithms_agree() {
    let mut state = 1u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 2f64.powi(53)
    };
    for case in 0..400 {
        let bits = [24, 53, 64, 72, 108, 300, 1000][case % 7];
        let edge = 0.7 * f64::from(bits) + 10.0;
        let z = match case % 4 {
            0 => edge + random() - 0.5,
            1 => edge * random(),
            2 => edge * (1.0 + 3.0 * random()),
            _ => 10f64.powf(40.0 * random() - 20.0),
        };
        let at = |bits: u32| Interval::point(Float::with_val(bits, Float::with_val(24, z)));
        let (coarse, fine) = (at(bits), at(4 * bits));
        let (pair, truth) = (coarse.struve(), fine.struve());
        assert!(pair[0].lower() == coarse.struve_h0().lower() && pair[1].upper() == coarse.struve_h1().upper());
        for (order, (value, truth)) in pair.iter().zip(&truth).enumerate() {
            assert!(value.overlaps(truth), "H{order}({z}) at {bits} bits: {value} {truth}");
            // Of the magnitude of H itself near 0, of one elsewhere.
            let size = z.min(1.0).powi(order as i32 + 1);
            assert!(
                value.radius().to_f64() <= size * 2f64.powi(2 - bits as i32),
                "H{order}({z}) at {bits} bits: {value}"
            );
            assert!(truth.radius().to_f64() <= size * 2f64.powi(2 - 4 * bits as i32), "H{order}({z}): {truth}");
        }
    }
}

#[test]
fn wide_arguments_enclose_every_point() {
    for (low, high) in [(0.0, 0.5), (1.0, 1.25), (3.9, 4.6), (20.0, 21.0), (100.0, 100.5), (1.0, 12.0), (2.5, 400.0)] {
        let wide = Interval::new(Float::with_val(80, low), Float::with_val(80, high));
        let (h0, h1) = (wide.struve_h0(), wide.struve_h1());
        for step in 0..=32 {
            let z = Interval::point(Float::with_val(80, low + (high - low) * f64::from(step) / 32.0));
            assert!(h0.contains(&z.struve_h0().mid()) && h1.contains(&z.struve_h1().mid()), "[{low}, {high}] at {z:?}");
        }
    }
    assert!(Interval::new(Float::with_val(80, -1), Float::with_val(80, 1)).struve_h0().is_entire());
}

#[test]
fn derivatives_agree_with_differences() {
    for z in [0.2, 2.9, 3.1, 17.0, 250.0] {
        let z = Float::with_val(200, z);
        let step = Float::with_val(200, 1) >> 60;
        let dual = Dual::variable(z.clone());
        let difference = |f: fn(&Float) -> Float| {
            let above = f(&Float::with_val(200, &z + &step));
            (above - f(&Float::with_val(200, &z - &step))) / Float::with_val(200, &step * 2u32)
        };
        // Third derivatives are below one: the error of the central difference is at most 2⁻¹²⁰.
        let bound = 2f64.powi(-118);
        assert!((difference(Float::struve_h0) - dual.struve_h0().slope).to_f64().abs() < bound);
        assert!((difference(Float::struve_h1) - dual.struve_h1().slope).to_f64().abs() < bound);
    }
}
