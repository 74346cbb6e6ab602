//! The records themselves.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::HashSet;
use std::f64::consts::PI;

use approx::assert_relative_eq;
use mdr_reference::{Decimal, Difficulty, DifficultyInputs, Filter, Record, Status, data_sets, lines, record, records};

#[test]
fn every_line_is_a_record() {
    for line in lines() {
        let record = Record::from_json(line).unwrap_or_else(|error| panic!("{error}: {line}"));
        assert_eq!(record.to_json(), line, "a record is written as it was read");
    }
    assert_eq!(records().len(), lines().count());
}

#[test]
fn identifiers_are_unique() {
    let ids: HashSet<_> = records().iter().map(|record| &record.id).collect();
    assert_eq!(ids.len(), records().len());
}

/// One changed digit is detected.
#[test]
fn a_changed_line_is_refused() {
    let line = lines().nth(1).unwrap();
    let (before, after) = line.split_once("\"mid\":\"0.7").unwrap();
    let changed = format!("{before}\"mid\":\"0.8{after}");
    assert!(Record::from_json(&changed).is_err());
    let changed = line.replace("\"C\":\"0.5\"", "\"C\":\"0.6\"");
    assert!(Record::from_json(&changed).unwrap_err().starts_with("the hash"));
}

/// An unreadable number is rejected before the hash is checked.
#[test]
fn a_number_that_is_none_is_refused() {
    let line = lines().find(|line| line.contains("\"scale\":\"") && line.contains("\"C\":\"")).unwrap();
    for key in ["mid", "rad", "scale", "C"] {
        let (before, after) = line.split_once(&format!("\"{key}\":\"")).unwrap();
        for junk in ["x", "nan"] {
            let changed = format!("{before}\"{key}\":\"{junk}{after}");
            let error = Record::from_json(&changed).unwrap_err();
            assert!(error.starts_with(&format!("{key} is not a number")), "{key}: {error}");
        }
    }
}

#[test]
fn values_are_certified_by_a_rigorous_and_a_second_method() {
    for record in records() {
        let Some(value) = &record.value else { continue };
        let [mid, rad]: [Decimal; 2] = [&value.mid, &value.rad].map(|text| text.parse().unwrap());
        let digits = f64::from(value.digits);
        assert!(rad.is_zero() || rad.log10() < mid.log10() - digits + 1.0, "{}", record.id);
        assert!(record.methods.len() >= 2 && record.methods[0].rigorous, "{}", record.id);
        assert_eq!(mid.is_zero(), record.log10.is_none(), "{}", record.id);
        assert!(!mid.is_zero() || record.scale.is_some(), "{}", record.id);
        assert!(!record.condition.is_empty() && record.total_condition().is_finite(), "{}", record.id);
    }
}

/// A value representable as a double is `ok`; any other has a status.
#[test]
fn statuses_are_those_of_doubles() {
    for record in records().iter().filter(|record| record.value.is_some()) {
        let size = record.nearest().abs();
        let expected = match size {
            f64::INFINITY => Status::Overflow,
            size if size < f64::MIN_POSITIVE && record.log10.is_some() => Status::Underflow,
            _ => Status::Ok,
        };
        assert!(record.status == expected || record.status == Status::Fold, "{}", record.id);
        assert_eq!(record.hexadecimal().is_some(), expected == Status::Ok, "{}", record.id);
    }
}

/// Johnson, Kendall & Roberts 1971, Maugis & Barquins 1978, Popov 2025.
#[test]
fn known_values() {
    let value = |id: &str| record(id).unwrap_or_else(|| panic!("{id}")).nearest();
    assert_relative_eq!(value("critical/jkr-unit/force/force"), -1.5 * PI, max_relative = 1e-15);
    assert_relative_eq!(value("critical/jkr-unit/indentation/force"), -PI * 5.0 / 6.0, max_relative = 1e-15);
    assert_relative_eq!(value("critical/jkr-unit/indentation/contact_radius").powi(3), PI / 8.0, max_relative = 1e-15);
    assert_relative_eq!(value("critical/cone-unit/indentation/indentation"), -1.0, max_relative = 1e-15);
    assert_eq!(value("kappa/n=2/kappa"), 2.0);
    assert_eq!(value("critical/n=1.5/force/indentation"), 0.0);
}

#[test]
fn a_pair_of_doubles_has_thirty_digits() {
    for record in records().iter().filter(|record| record.status == Status::Ok && record.log10.is_some()) {
        let (high, low) = record.pair();
        let sum = &Decimal::from_double(high).unwrap() + &Decimal::from_double(low).unwrap();
        let mid = record.decimal().unwrap();
        let digits = mid.log10() - (&sum - &mid).log10();
        // Unless the remainder is itself below the normal doubles.
        assert!(digits > 31.0 || high.abs() < 1e-290, "{}: {digits}", record.id);
        let spacing = high.abs().next_up() - high.abs();
        assert!(low.abs() <= spacing / 2.0, "{}", record.id);
    }
}

#[test]
fn filters() {
    let count = |filter: &str| filter.parse::<Filter>().unwrap().select().count();
    assert_eq!(count(""), records().len());
    let by_difficulty = Difficulty::ALL.map(|level| count(&format!("difficulty={level}")));
    assert!(by_difficulty.iter().all(|count| *count > 20), "{by_difficulty:?}");
    assert_eq!(by_difficulty.iter().sum::<usize>(), records().len());
    assert_eq!(count("control=force") + count("control!=force"), records().len());
    assert_eq!(count("id=critical/jkr-unit/force/force"), 1);
    assert!(count("id~n=2,control=none") > 0);
    for bad in ["colour=red", "profile", "profile=", "=x", "profile!power"] {
        let error = bad.parse::<Filter>().unwrap_err().to_string();
        assert!(error.contains(bad) && error.contains("difficulty"), "{error}");
    }
    for (bad, hint) in [
        ("profile=sfere", "sphere"),
        ("control==force", "indentation"),
        ("status!=okay", "no-equilibrium"),
        ("flag~proven", "all-folds-proved"),
        ("id=critical/jkr-unit", "no such id"),
        ("control=force control=machine", "no record meets all terms"),
    ] {
        let error = bad.parse::<Filter>().unwrap_err().to_string();
        assert!(error.contains(bad) && error.contains(hint), "{error}");
    }
}

/// Condition, distance to a fold, decades and |n − 1/2|, computed from the records, give the published difficulty; a fit has the
/// level of its data set.
#[test]
fn difficulties_are_those_of_their_measures() {
    let mut near = 0;
    for record in records().iter().filter(|record| record.formula != "fit") {
        let half = record.input_f64("n").map_or(f64::INFINITY, |n| (n - 0.5).abs());
        let measured = DifficultyInputs {
            condition: record.total_condition(),
            fold_distance: record.fold_distance().unwrap_or(f64::INFINITY),
            decades: record.decades(),
            from_half: if half == 0.0 { f64::INFINITY } else { half },
            is_number: record.value.is_some(),
        };
        assert_eq!(measured.difficulty(), record.difficulty, "{}: {measured:?}", record.id);
        near += usize::from(record.fold_distance().is_some_and(|distance| distance < 1e-6));
        assert_eq!(record.fold_distance().is_some(), record.formula.starts_with("equilibrium"), "{}", record.id);
    }
    assert!(near > 50, "{near}");
}

/// The 2 of a sphere is not rounded and does not count: in SI units, n of this one has a condition of 40.
#[test]
fn a_whole_exponent_costs_nothing() {
    let of = |id: &str| mdr_reference::record(id).unwrap();
    let tip = of("critical/afm-tip/force/force");
    assert!(tip.condition.iter().any(|(name, condition)| name == "n" && *condition > 40.0), "{:?}", tip.condition);
    assert_eq!((tip.total_condition(), tip.difficulty.name()), (2.0, "lower"));
    let near = of("critical/half+2^-10/force/force");
    assert!(near.condition.iter().any(|(name, condition)| name == "n" && near.total_condition() > *condition));
}

/// Every data set has certified values, and every fit its data.
#[test]
fn fits_have_their_data() {
    let mut count = 0;
    for set in data_sets() {
        let records: Vec<_> = set.records().collect();
        count += records.len();
        assert!(records.len() >= 5 && records.len() % 2 == 1, "{}", set.name);
        assert!(records.iter().all(|record| record.difficulty == set.level), "{}", set.name);
        assert!(
            set.fit.contains(&format!("file = \"{}.csv\"", set.name)) && set.curve.lines().count() > 30,
            "{}",
            set.name
        );
    }
    assert_eq!(count, records().iter().filter(|record| record.formula == "fit").count());
}

/// A row contains everything of a line of JSON, in the same order.
#[test]
fn a_row_has_every_field() {
    let record = mdr_reference::record("critical/n=1.5/force/indentation").unwrap();
    let json = record.to_json();
    let (row, mut from) = (record.to_csv(), 0);
    for (name, field) in Record::CSV_HEADER.into_iter().zip(row) {
        let at = json[from..].find(&format!("\"{name}\":")).unwrap_or_else(|| panic!("{name}"));
        from += at;
        let first = field.split(['=', ' ', ';']).next().unwrap();
        assert!(json[from..].contains(first), "{name}: {field}");
        // Exactly zero: the reference magnitude must be present.
        assert!(name != "scale" || !field.is_empty());
    }
}
