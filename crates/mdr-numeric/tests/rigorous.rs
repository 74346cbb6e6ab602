//! Energies and fields as enclosures, against quadratures of f, and at so few bits that a missing error term would show.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use mdr_core::contact::{Control, Equilibrium, Error, Expression, Material, Stability, Transform};
use mdr_core::number::{Interval, Literal, Precision, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::fields::Fields;
use mdr_numeric::proof::{Continuation, EnclosedEnergy, EnclosedFields};
use mdr_numeric::transform::{Enclosed, Quadrature};

/// A smooth tip, waves, an end of the profile, a tip of another order, and kinks of f and of f'. With a radius of contact, and one
/// within and one outside, and the bits of a truth: each value of g of a tip of another order takes many pieces.
const CASES: [(&str, [&str; 3], u32); 8] = [
    ("r^2/2", ["1", "0.5", "1.5"], 400),
    ("r^2/2 + 5e-4*(1 - cos(20*pi*r))", ["0.09", "0.031", "0.1"], 120),
    ("1 - sqrt(1 - r^2)", ["0.7", "0.2", "0.71"], 120),
    ("r^1.5", ["0.4", "0.3", "0.9"], 60),
    ("sqrt(r^2 + 0.01) - 0.1", ["0.3", "0.1", "0.31"], 120),
    ("r^2/2 - 0.1*max(0, r - 0.1)", ["0.2", "0.05", "0.25"], 120),
    ("0.3*max(0, r - 0.1)", ["0.15", "0.12", "0.4"], 120),
    ("max(r^2 - 0.01, 0) + max(r - 0.2, 0)^2", ["0.3", "0.15", "0.5"], 120),
];

struct Case {
    contact: Contact<Interval>,
    profile: Continuation,
    state: Equilibrium<Interval>,
}

fn number(text: &str, bits: u32) -> Interval {
    Interval::from_literal(Precision::new(bits), &text.parse::<Literal>().unwrap())
}

/// The equilibrium with this radius.
fn case(formula: &str, a: &str, bits: u32) -> Case {
    let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
    let precision = Precision::new(bits);
    let bound = || formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
    let transform = Arc::new(Enclosed::new(bound(), precision));
    let material = Material::new(number("2", bits), number("1e-3", bits)).unwrap();
    let contact = Contact::half_space(&transform, &material, &Control::Indentation);
    let profile = Continuation::new(vec![bound()]).unwrap();
    let contact_radius = number(a, bits);
    let (indentation, force) = contact.state(&contact_radius).unwrap();
    Case { contact, profile, state: Equilibrium { contact_radius, indentation, force, stability: Stability::Stable } }
}

/// Energy, stiffness, pressure, displacement and gap.
fn all(formula: &str, [a, within, outside]: [&str; 3], bits: u32) -> [Result<Interval, Error>; 5] {
    let Case { contact, profile, state } = case(formula, a, bits);
    let energy = EnclosedEnergy::new(&contact, &profile).unwrap();
    let fields = || EnclosedFields::new(&contact, &profile, &state);
    let [within, outside] = [within, outside].map(|r| number(r, bits));
    [
        energy.potential(&state.contact_radius, &state.indentation),
        fields().and_then(|fields| fields.stiffness()),
        fields().and_then(|fields| fields.pressure(&within)),
        fields().and_then(|fields| fields.displacement(&outside)),
        fields().and_then(|fields| fields.gap(&outside)),
    ]
}

#[test]
fn enclosures_hold_what_quadratures_find() {
    for (formula, radii, bits) in CASES {
        let bits = bits.min(80);
        let parsed: Expression = formula.parse().unwrap();
        let none = Default::default();
        let breaks = parsed.breaks(&none).unwrap();
        let profile = parsed.bind::<f64>((), &none).unwrap().broken_at((), &breaks);
        let transform = Arc::new(Quadrature::new(profile));
        let contact = Contact::half_space(&transform, &Material::new(2.0, 1e-3).unwrap(), &Control::Indentation);
        let [a, within, outside] = radii.map(|r| r.parse::<f64>().unwrap());
        let fields = Fields::new(contact.clone(), a).unwrap();
        let d = *fields.indentation();
        let energy = Energy::new(contact).unwrap().potential(&a, &d).unwrap();
        let wanted = [
            energy,
            fields.stiffness().unwrap(),
            fields.pressure(&within).unwrap(),
            fields.displacement(&outside).unwrap(),
            fields.gap(&outside).unwrap(),
        ];
        // Each is a sum of terms of these sizes.
        let sizes = [1e-3, 1.0, 1.0, transform.g(&a).unwrap().abs() + d.abs(), outside.powi(2) + outside.sqrt()];
        for (index, found) in all(formula, radii, bits).into_iter().enumerate() {
            let found = found.unwrap_or_else(|error| panic!("{formula}, {index}: {error}"));
            let apart = (found.approx() - wanted[index]).abs();
            assert!(
                apart < 1e-10 * (sizes[index] + wanted[index].abs()),
                "{formula}, {index}: {found}, {}",
                wanted[index]
            );
            assert!(found.accuracy_bits() > i64::from(bits) - 40, "{formula}, {index}: {found}");
        }
    }
}

/// The truth is that of 120 bits or 400; it lies within what is said with few.
#[test]
fn few_bits_contain_the_truth() {
    for (formula, radii, most) in CASES {
        let truth = all(formula, radii, most);

        for bits in [8, 11, 16, 24] {
            for (index, (found, truth)) in all(formula, radii, bits).into_iter().zip(&truth).enumerate() {
                // So few bits may not locate a kink, nor have rules with enough nodes.
                // So few bits may not locate a kink, nor have rules with enough nodes.
                let Ok(found) = found else {
                    assert!(bits < 20, "{formula}, {index} at {bits} bits");
                    continue;
                };
                let truth = truth.as_ref().unwrap();
                assert!(found.overlaps(truth), "{formula}, {index} at {bits} bits: {found} without {truth}");
            }
        }
    }
}

/// The sphere, E* = 1, w = 1e-6, at d = 0.001: Π = 1.27164829e-8 J at a = 0.0386250.
#[test]
fn a_sphere_as_a_formula_has_its_energy() {
    let Case { profile, .. } = case("1 - sqrt(1 - r^2)", "0.0386250", 120);
    let (formula, none) = ("1 - sqrt(1 - r^2)".parse::<Expression>().unwrap(), Default::default());
    let precision = Precision::new(120);
    let bound = formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
    let transform = Arc::new(Enclosed::new(bound, precision));
    let material = Material::new(number("1", 120), number("1e-6", 120)).unwrap();
    let contact = Contact::half_space(&transform, &material, &Control::Indentation);
    let energy = EnclosedEnergy::new(&contact, &profile).unwrap();
    let found = energy.potential(&number("0.0386250", 120), &number("0.001", 120)).unwrap();
    assert!((found.approx() - 1.27164829e-8).abs() < 1e-16, "{found}");
}

#[test]
fn a_tip_with_a_slope_has_an_infinite_pressure() {
    let Case { contact, profile, state } = case("0.3*r", "0.2", 100);
    let fields = EnclosedFields::new(&contact, &profile, &state).unwrap();
    let error = fields.pressure(&number("0", 100)).unwrap_err();
    assert!(matches!(error, Error::Domain { .. }), "{error}");
    assert!(fields.pressure(&number("1e-9", 100)).is_ok());
}

/// Formulas on a graded half-space and on a Winkler foundation.
mod springs {
    use mdr_numeric::medium::{Adhesion, Medium};
    use mdr_numeric::transform::Weighted;

    use super::*;

    /// Smooth tips, one of them with an end, and waves, with a radius of contact.
    const CASES: [(&str, &str); 4] = [
        ("1 - sqrt(1 - r^2)", "0.6"),
        ("sqrt(r^2 + 0.01) - 0.1", "0.3"),
        ("r^2/2 + 5e-4*(1 - cos(20*pi*r))", "0.09"),
        ("0.2*r + r^2*exp(-r)", "0.8"),
    ];
    const MEDIA: [&str; 4] = ["0.3", "-0.45", "0.9", "winkler"];

    /// Energy at a depth of 0.05.
    fn enclosed(formula: &str, medium: &str, a: &str, bits: u32) -> Result<Interval, Error> {
        let (formula, none) = (formula.parse::<Expression>().unwrap(), Default::default());
        let precision = Precision::new(bits);
        let bound = || formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
        let (transform, medium) = match medium {
            "winkler" => (Enclosed::winkler(bound(), precision), Medium::winkler(number("2", bits))?),
            k => (
                Enclosed::graded(bound(), precision, number(k, bits)),
                Medium::graded(number("2", bits), number(k, bits))?,
            ),
        };
        let adhesion = Adhesion::new(number("1e-3", bits))?;
        let contact = Contact::new(transform, medium, adhesion, Control::Indentation);
        let profile = Continuation::new(vec![bound()]).unwrap().on(contact.medium()).unwrap();
        EnclosedEnergy::new(&contact, &profile)?.potential(&number(a, bits), &number("0.05", bits))
    }

    #[test]
    fn enclosures_hold_what_quadratures_find() {
        let mut compared = 0;
        for (formula, a) in CASES {
            for medium in MEDIA {
                let (parsed, none) = (formula.parse::<Expression>().unwrap(), Default::default());
                let profile = parsed.bind::<f64>((), &none).unwrap();
                let (transform, springs): (Box<dyn Transform<f64>>, _) = match medium {
                    "winkler" => (Box::new(Weighted::winkler(profile, 1.0)), Medium::winkler(2.0).unwrap()),
                    k => {
                        let k = k.parse().unwrap();
                        (Box::new(Weighted::graded(profile, k)), Medium::graded(2.0, k).unwrap())
                    }
                };
                let adhesion = Adhesion::new(1e-3).unwrap();
                let contact = Contact::sharing(Arc::from(transform), springs, adhesion, Control::Indentation);
                let wanted = Energy::new(contact).and_then(|energy| energy.potential(&a.parse().unwrap(), &0.05));
                // Doubles do not reach some of them.
                let Ok(wanted) = wanted else { continue };
                compared += 1;
                let found =
                    enclosed(formula, medium, a, 64).unwrap_or_else(|error| panic!("{formula}, {medium}: {error}"));
                let apart = (found.approx() - wanted).abs();
                assert!(apart < 1e-10 * (1e-3 + wanted.abs()), "{formula}, {medium}: {found}, {wanted}");
                assert!(found.accuracy_bits() > 30, "{formula}, {medium}: {found}");
            }
        }
        assert!(compared >= 12, "{compared}");
    }

    /// The truth is that of 48 bits; it lies within what is said with few.
    #[test]
    fn few_bits_contain_the_truth() {
        let mut held = 0;
        for (formula, a) in &CASES[1..3] {
            for medium in MEDIA {
                let truth = enclosed(formula, medium, a, 48).unwrap();
                for bits in [8, 12, 16, 24] {
                    let Ok(found) = enclosed(formula, medium, a, bits) else { continue };
                    assert!(found.overlaps(&truth), "{formula}, {medium} at {bits} bits: {found} without {truth}");
                    held += 1;
                }
            }
        }
        assert!(held >= 24, "{held}");
    }

    #[test]
    fn a_profile_on_another_medium_is_refused() {
        let (bits, none) = (80, Default::default());
        let formula: Expression = "r^2/2".parse().unwrap();
        let bound = || formula.enclosed(&none, &formula.breaks(&none).unwrap(), Precision::new(bits)).unwrap();
        let medium = |k: &str| Medium::graded(number("2", bits), number(k, bits)).unwrap();
        let transform = Enclosed::graded(bound(), Precision::new(bits), number("0.3", bits));
        let adhesion = Adhesion::new(number("1e-3", bits)).unwrap();
        let contact = Contact::new(transform, medium("0.3"), adhesion, Control::Indentation);
        let on = |other: &Medium<Interval>| Continuation::new(vec![bound()]).unwrap().on(other).unwrap();
        assert!(EnclosedEnergy::new(&contact, &on(&medium("0.3"))).is_ok());
        assert!(EnclosedEnergy::new(&contact, &on(&medium("0.4"))).is_err());
        assert!(EnclosedEnergy::new(&contact, &Continuation::new(vec![bound()]).unwrap()).is_err());
    }
}

/// Measured tables, cubic by cubic.
mod tables {
    use mdr_numeric::table::Table;

    use super::*;

    /// A wavy paraboloid whose g falls in places, in rows up to 1, with a radius of contact, one within and one outside.
    const CASES: [(usize, [&str; 3]); 3] =
        [(6, ["0.43", "0.11", "0.71"]), (14, ["0.62", "0.3", "0.64"]), (41, ["0.931", "0", "0.99"])];

    fn table(rows: usize) -> Table {
        let row = |i: usize| {
            let r = i as f64 / (rows - 1) as f64;
            format!("{r:.6},{:.6}\n", r * r / 2.0 + 0.02 * (1.0 - (9.0 * r).cos()))
        };
        let csv: String = std::iter::once("r,f\n".to_owned()).chain((0..rows).map(row)).collect();
        Table::from_csv(csv.as_bytes()).unwrap()
    }

    /// Energy, pressure, displacement and gap.
    fn all(rows: usize, [a, within, outside]: [&str; 3], bits: u32) -> [Result<Interval, Error>; 4] {
        let transform = Arc::new(table(rows).profile::<Interval>(Precision::new(bits)).unwrap());
        let material = Material::new(number("2", bits), number("1e-3", bits)).unwrap();
        let contact = Contact::half_space(&transform, &material, &Control::Indentation);
        let profile = Continuation::new(vec![transform.enclosed()]).unwrap();
        let contact_radius = number(a, bits);
        let state = contact.state(&contact_radius).map(|(indentation, force)| Equilibrium {
            contact_radius,
            indentation,
            force,
            stability: Stability::Stable,
        });
        let energy = EnclosedEnergy::new(&contact, &profile).unwrap();
        let fields = || EnclosedFields::new(&contact, &profile, state.as_ref().map_err(Clone::clone)?);
        let [within, outside] = [within, outside].map(|r| number(r, bits));
        [
            state.as_ref().map_err(Clone::clone).and_then(|at| energy.potential(&at.contact_radius, &at.indentation)),
            fields().and_then(|fields| fields.pressure(&within)),
            fields().and_then(|fields| fields.displacement(&outside)),
            fields().and_then(|fields| fields.gap(&outside)),
        ]
    }

    #[test]
    fn enclosures_hold_what_quadratures_find() {
        for (rows, radii) in CASES {
            let transform = Arc::new(table(rows).profile::<f64>(()).unwrap());
            let contact = Contact::half_space(&transform, &Material::new(2.0, 1e-3).unwrap(), &Control::Indentation);
            let [a, within, outside] = radii.map(|r| r.parse::<f64>().unwrap());
            let fields = Fields::new(contact.clone(), a).unwrap();
            let energy = Energy::new(contact).unwrap().potential(&a, fields.indentation()).unwrap();
            let wanted = [
                energy,
                fields.pressure(&within).unwrap(),
                fields.displacement(&outside).unwrap(),
                fields.gap(&outside).unwrap(),
            ];
            for (index, found) in all(rows, radii, 80).into_iter().enumerate() {
                let found = found.unwrap_or_else(|error| panic!("{rows}, {index}: {error}"));
                // Each is a sum of terms of the size of 1.
                assert!((found.approx() - wanted[index]).abs() < 1e-10, "{rows}, {index}: {found}, {}", wanted[index]);
                assert!(found.accuracy_bits() > 40, "{rows}, {index}: {found}");
            }
        }
    }

    /// The truth is that of 120 bits; it lies within what is said with few.
    #[test]
    fn few_bits_contain_the_truth() {
        let mut held = 0;
        for (rows, radii) in CASES {
            let truth = all(rows, radii, 120);
            for bits in [14, 18, 24, 32] {
                for (index, (found, truth)) in all(rows, radii, bits).into_iter().zip(&truth).enumerate() {
                    // So few bits may not tell a radius from a row.
                    let Ok(found) = found else { continue };
                    let truth = truth.as_ref().unwrap();
                    assert!(found.overlaps(truth), "{rows}, {index} at {bits} bits: {found} without {truth}");
                    held += 1;
                }
            }
        }
        assert!(held >= 36, "{held}");
    }

    #[test]
    fn a_gap_beyond_the_last_row_is_out_of_its_domain() {
        let [_, _, displacement, gap] = all(14, ["0.62", "0.3", "1.5"], 80);
        assert!(displacement.is_ok() && matches!(gap, Err(Error::Domain { .. })), "{gap:?}");
    }
}

/// Energies by the mean of g² as a closed form.
mod closed {
    use mdr_numeric::medium::{Adhesion, Medium};
    use mdr_numeric::transform::{Powers, Wave};

    use super::*;

    /// A cubic polynomial without its square on graded half-spaces and springs, and a wave.
    const CONTACTS: [&str; 4] = ["graded", "softer", "winkler", "wave"];

    fn contact<R: Real>(medium: &str, number: impl Fn(&str) -> R) -> Contact<R> {
        let terms = || [(number("1"), number("0.3")), (number("3"), number("0.7"))];
        let (modulus, adhesion) = (number("2"), Adhesion::new(number("1e-2")).unwrap());
        let graded = |k: &str| {
            let k = number(k);
            // Of any G xⁿ the mean is (1 + k)/(n + 1 + k).
            let term = |(n, factor): (R, R)| {
                let order = k.lit(1) + &k;
                let mean = order.clone() / (order + &n);
                [n, factor, mean]
            };
            let transform = Powers::new(terms().map(term)).unwrap();
            (Box::new(transform) as Box<dyn Transform<R>>, Medium::graded(number("2"), k).unwrap())
        };
        let (transform, medium) = match medium {
            "graded" => graded("0.3"),
            "softer" => graded("-0.45"),
            "winkler" => (Box::new(Powers::winkler(terms()).unwrap()) as _, Medium::winkler(modulus).unwrap()),
            _ => {
                let wave = Wave::new(number("0.1"), number("1.5")).unwrap();
                (Box::new(wave) as _, Medium::periodic(modulus, number("1.5")).unwrap())
            }
        };
        Contact::sharing(Arc::from(transform), medium, adhesion, Control::Indentation)
    }

    fn enclosed(medium: &str, bits: u32) -> Interval {
        let contact = contact(medium, |text| number(text, bits));
        EnclosedEnergy::closed(&contact).potential(&number("0.37", bits), &number("0.05", bits)).unwrap()
    }

    /// The integrals over the springs, and over the loading of a wave, find what the closed forms do.
    #[test]
    fn integrals_over_the_springs_find_them() {
        for medium in CONTACTS {
            let contact = contact(medium, |text| text.parse::<f64>().unwrap());
            let found = Energy::new(contact).unwrap().potential(&0.37, &0.05).unwrap();
            let proved = enclosed(medium, 120);
            assert!(proved.accuracy_bits() > 100, "{medium}: {proved}");
            assert!((proved.approx() - found).abs() < 1e-14, "{medium}: {proved} {found}");
        }
    }

    #[test]
    fn few_bits_contain_the_truth() {
        for medium in CONTACTS {
            let truth = enclosed(medium, 400);
            for bits in 8..30 {
                let found = enclosed(medium, bits);
                assert!(found.overlaps(&truth), "{medium} at {bits} bits: {found} without {truth}");
            }
        }
    }

    /// Along a path of states ½S(d² − 2d·ḡ + q) − Aw is stationary where the contact is in equilibrium, also where q is of several terms.
    #[test]
    fn they_are_stationary_in_equilibrium() {
        for medium in CONTACTS {
            let contact = contact(medium, |text| number(text, 200));
            let (a, step) = (number("0.37", 200), number("1e-12", 200));
            let d = contact.indentation(&a).unwrap();
            let energy = EnclosedEnergy::closed(&contact);
            let at = |a: Interval| energy.potential(&a, &d).unwrap();
            let [above, below] = [at(a.clone() + &step), at(a.clone() - &step)];
            let slope = (above - below) / step.times(2);
            assert!(slope.approx().abs() < 1e-20, "{medium}: {slope}");
        }
    }

    /// What complete contact stores is the limit of what contacts store that close.
    #[test]
    fn complete_contact_is_the_limit() {
        let contact = contact("wave", |text| number(text, 200));
        let [depth, _] = contact.transform().complete_contact().unwrap();
        let energy = EnclosedEnergy::closed(&contact);
        let near = energy.potential(&number("1e20", 200), &depth).unwrap();
        let complete = energy.complete_contact(&depth).unwrap();
        let apart = near - complete.energy().unwrap();
        assert!(apart.approx().abs() < 1e-19, "{apart}");
        assert!((complete.energy().unwrap().approx() - (2.0 * std::f64::consts::PI * 0.01 / 6.0 - 0.01)).abs() < 1e-16);
    }
}
