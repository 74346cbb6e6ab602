//! Which mistaken convention the judge names: each is planted in answers by formulas of this file.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::f64::consts::PI;

use mdr_reference::{Answer, Explanation, Record, Status, judge, record, records};

/// A contact f = r²/(2R) or f = r tanθ of the records.
#[derive(Clone, Copy)]
struct Contact {
    radius: f64,
    slope: Option<f64>,
    modulus: f64,
    work: f64,
}

impl Contact {
    /// Of the questions about critical states; none for other profiles, and for scales that leave the doubles.
    fn of(record: &Record) -> Option<Contact> {
        let input = |name: &str| record.input_f64(name);
        let plain =
            record.formula == "critical" && record.flags.iter().all(|flag| flag == "si") && record.status == Status::Ok;
        let (c, modulus, work) = (input("C")?, input("E*")?, input("w")?);
        let slope = match record.input("n")? {
            "1" => Some(c),
            "2" => None,
            _ => return None,
        };
        plain.then_some(Contact { radius: 0.5 / c, slope, modulus, work })
    }

    /// The contact radius, the indentation or the force at the fold under this control.
    fn fold(self, control: &str, quantity: &str) -> f64 {
        let Contact { radius, slope, modulus, work } = self;
        let at_load = if control == "force" { 9.0 } else { 1.0 };
        let a = match slope {
            Some(slope) => at_load * PI * work / (2.0 * modulus) / (PI / 2.0 * slope).powi(2),
            None => (at_load * PI * work / (8.0 * modulus) * radius * radius).cbrt(),
        };
        let (g, integral) = match slope {
            Some(slope) => (PI / 2.0 * slope * a, PI / 4.0 * slope * a * a),
            None => (a * a / radius, a * a * a / (3.0 * radius)),
        };
        let d = g - (2.0 * PI * a * work / modulus).sqrt();
        match quantity {
            "contact_radius" => a,
            "indentation" => d,
            _ => 2.0 * modulus * (a * d - integral),
        }
    }
}

/// What the judge finds in these answers about critical states of spheres, and of cones where the change is none of R.
fn found(answer: impl Fn(&Record, Contact) -> f64) -> Vec<Explanation> {
    explained(|question| Some(answer(question, Contact::of(question)?)))
}

fn explained(answer: impl Fn(&Record) -> Option<f64>) -> Vec<Explanation> {
    judge(records(), |question| answer(question).map(Answer::from)).explanations()
}

fn fold(question: &Record, contact: Contact) -> f64 {
    contact.fold(question.control.as_deref().unwrap(), &question.quantity)
}

/// One explanation, of every answer that is not right, by the convention of this name.
fn assert_names(found: &[Explanation], name: &str) {
    let [only] = found else { panic!("{name}: {found:?}") };
    assert!(only.names.iter().any(|known| known == name), "{name}: {only:?}");
    assert_eq!((only.explained, only.applicable), (only.not_right, only.not_right), "{name}");
    assert!(only.digits >= 13 && only.inputs >= 3, "{name}: {only:?}");
}

#[test]
fn the_formulas_of_this_file_are_right() {
    assert_eq!(found(fold), []);
    let report = judge(records(), |question| Contact::of(question).map(|contact| fold(question, contact).into()));
    assert!(report.passed() && report.answered() > 30, "{report}");
}

#[test]
fn work_of_adhesion() {
    for (name, factor) in [("work-halved", 0.5), ("work-doubled", 2.0), ("work-mJ", 1e3)] {
        let found = found(|question, c| fold(question, Contact { work: factor * c.work, ..c }));
        assert_names(&found, name);
        assert_eq!(found[0].names, [name]);
    }
}

#[test]
fn radius() {
    let units = [("radius-mm", 1e3), ("radius-µm", 1e6), ("radius-nm", 1e9)];
    for (name, factor) in [("radius-halved", 0.5), ("radius-doubled", 2.0)].into_iter().chain(units) {
        let planted = |question: &Record, c: Contact| fold(question, Contact { radius: factor * c.radius, ..c });
        let spheres = |question: &Record| Contact::of(question).filter(|contact| contact.slope.is_none());
        assert_names(&explained(|question| Some(planted(question, spheres(question)?))), name);
    }
}

#[test]
fn modulus() {
    let planted = |name: &str, factor: f64| {
        let found = found(|question, c| fold(question, Contact { modulus: factor * c.modulus, ..c }));
        assert_names(&found, name);
    };
    planted("modulus-k", 4.0 / 3.0);
    planted("modulus-from-k", 0.75);
    planted("modulus-two-bodies", 0.5);
    planted("modulus-one-of-two", 2.0);
    planted("modulus-kPa", 1e-3);
    planted("modulus-MPa", 1e-6);
    planted("modulus-GPa", 1e-9);
    planted("modulus-from-kPa", 1e3);
    planted("modulus-from-MPa", 1e6);
    planted("modulus-from-GPa", 1e9);
    for (text, ratio) in [("0.2", 0.2), ("0.25", 0.25), ("0.28", 0.28), ("0.3", 0.3), ("0.33", 0.33)]
        .into_iter()
        .chain([("0.35", 0.35), ("0.4", 0.4), ("0.45", 0.45), ("0.49", 0.49), ("0.5", 0.5_f64)])
    {
        let flat = 1.0 - ratio * ratio;
        planted(&format!("modulus-one-body-{text}"), 1.0 / flat);
        planted(&format!("modulus-two-bodies-{text}"), 0.5 / flat);
        planted(&format!("modulus-of-one-{text}"), flat);
        planted(&format!("modulus-one-of-two-{text}"), 2.0 * flat);
        planted(&format!("modulus-shear-{text}"), (1.0 - ratio) / 2.0);
    }
}

#[test]
fn signs_and_units() {
    let planted = |name: &str, quantities: &[&str], factor: f64| {
        let found = found(|question, contact| {
            let changed = quantities.contains(&question.quantity.as_str());
            fold(question, contact) * if changed { factor } else { 1.0 }
        });
        assert_names(&found, name);
        assert_eq!(found[0].names, [name]);
    };
    planted("force-sign", &["force"], -1.0);
    planted("indentation-sign", &["indentation"], -1.0);
    let lengths = ["contact_radius", "indentation"];
    for (name, factor) in [("mm", 1e3), ("µm", 1e6), ("nm", 1e9)] {
        planted(name, &lengths, factor);
    }
    for (name, factor) in [("mN", 1e3), ("µN", 1e6), ("nN", 1e9), ("pN", 1e12)] {
        planted(name, &["force"], factor);
    }
}

/// Lengths in mm make areas in mm², and leave slopes alone.
#[test]
fn units_of_transforms() {
    let found = explained(|question| {
        let plain = question.formula == "transform" && question.status == Status::Ok && question.log10?.abs() < 200.0;
        let factor = match question.unit.as_str() {
            "m" => 1e3,
            "m^2" => 1e6,
            _ => 1.0,
        };
        plain.then(|| factor * question.nearest())
    });
    assert_names(&found, "mm");
}

/// Lengths in nm and forces in nN: two conventions, each of its answers. A sign beside them is a third.
#[test]
fn several_units() {
    let planted = |question: &Record, contact: Contact| {
        let factor = if question.quantity == "force" { 1e9 } else { 1e6 };
        factor * fold(question, contact)
    };
    let mut names: Vec<_> = found(planted).into_iter().map(|found| found.names).collect();
    names.sort();
    assert_eq!(names, [["nN"], ["µm"]]);
    let with_sign = |question: &Record, contact: Contact| match question.quantity.as_str() {
        "indentation" => -fold(question, contact),
        "force" => 1e3 * fold(question, contact),
        _ => fold(question, contact),
    };
    let mut names: Vec<_> = found(with_sign).into_iter().map(|found| found.names).collect();
    names.sort();
    assert_eq!(names, [["indentation-sign"], ["mN"]]);
}

/// π stands beside w in every critical state of a sphere; a cone has another in κ.
#[test]
fn rounded_pi() {
    let spheres = |question: &Record| Contact::of(question).filter(|contact| contact.slope.is_none());
    for (name, pi) in [("pi-3.14", 314.0 / 100.0), ("pi-22-over-7", 22.0 / 7.0)] {
        let planted = |question: &Record, c: Contact| fold(question, Contact { work: c.work * pi / PI, ..c });
        assert_names(&explained(|question| Some(planted(question, spheres(question)?))), name);
    }
}

/// What explains one answer of a state and not the others is no explanation: w or R a thousand times too large makes forces that
/// look like mN, and w/2 with 2R makes contact radii like those of E*/2.
#[test]
fn wrong_answers_contradict() {
    let spheres = |question: &Record| Contact::of(question).filter(|contact| contact.slope.is_none());
    for (work, radius, looks_like) in
        [(1e3, 1.0, "mN"), (1.0, 1e3, "mN"), (1e9, 1.0, "nN"), (0.5, 2.0, "modulus-two-bodies")]
    {
        let planted = |question: &Record| {
            let c = spheres(question)?;
            Some(fold(question, Contact { work: work * c.work, radius: radius * c.radius, ..c }))
        };
        let found = explained(planted);
        assert!(
            found.iter().all(|found| !found.names.iter().any(|name| name == looks_like)),
            "{work} {radius}: {found:?}"
        );
        // Without the answers that contradict it, it would be named.
        let quantity = if looks_like == "modulus-two-bodies" { "contact_radius" } else { "force" };
        let part = explained(|question| planted(question).filter(|_| question.quantity == quantity));
        assert!(
            part.iter().any(|found| found.names.iter().any(|name| name == looks_like)),
            "{work} {radius}: {part:?}"
        );
    }
    let both = explained(|question| {
        let c = spheres(question)?;
        Some(fold(question, Contact { work: 0.5 * c.work, radius: 2.0 * c.radius, ..c }))
    });
    assert_eq!(both, []);
}

/// In the units of Maugis every sphere has the same critical states: F = −3/2, a³ = 3/2 under a dead load, F = −5/6,
/// a³ = 1/6 at fixed grips, and d = a² − √(8a/3).
#[test]
fn units_of_maugis() {
    let maugis = |question: &Record| {
        Contact::of(question).filter(|contact| contact.slope.is_none())?;
        let (cube, force) = match question.control.as_deref() {
            Some("force") => (1.5_f64, -1.5),
            _ => (1.0 / 6.0, -5.0 / 6.0),
        };
        let a = cube.cbrt();
        Some(match question.quantity.as_str() {
            "contact_radius" => a,
            "indentation" => a * a - (8.0 / 3.0 * a).sqrt(),
            _ => force,
        })
    };
    assert_names(&explained(maugis), "maugis-units");
}

#[test]
fn the_fold_of_the_other_control() {
    for control in ["force", "indentation"] {
        let planted = |question: &Record, contact: Contact| contact.fold(control, &question.quantity);
        assert_names(&found(planted), &format!("control-{control}"));
    }
}

/// Folds of waves and machines, and equilibria at a share of the fold, have the record of the other control as sibling.
#[test]
fn siblings() {
    let folds = explained(|question| {
        let machine = question.formula == "folds" && question.control.as_deref() == Some("machine");
        let sibling = || question.id.split('/').nth(1).map(|case| case.to_owned());
        let of_case = |other: &&Record| {
            other.formula == "folds"
                && other.control.as_deref() == Some("force")
                && other.quantity == question.quantity
                && other.input("fold") == question.input("fold")
                && other.id.split('/').nth(1).map(str::to_owned) == sibling()
        };
        machine.then(|| records().iter().find(of_case).map(Record::nearest)).flatten()
    });
    assert_eq!(folds.first().map(|found| found.names.as_slice()), Some(&["control-force".to_owned()][..]), "{folds:?}");
    let shares = explained(|question| {
        let far = question.formula == "equilibrium-share" && question.total_condition() < 1e4;
        let id = question.id.replace("/outer/indentation/", "/outer/force/");
        (far && id != question.id).then(|| record(&id).map(Record::nearest)).flatten()
    });
    assert_names(&shares, "control-force");
    let other = explained(|question| {
        let far = question.formula == "equilibrium-share" && question.total_condition() < 1e4;
        let id = question.id.replace("/inner/", "/outer/");
        (far && id != question.id).then(|| record(&id).map(Record::nearest)).flatten()
    });
    assert_eq!(
        other.first().map(|found| found.names.as_slice()),
        Some(&["other-equilibrium".to_owned()][..]),
        "{other:?}"
    );
}

/// Questions other than critical states: a flat punch, the threshold at n = 1/2, energies, g of a paraboloid.
#[test]
fn other_monomials() {
    let halved_work = |question: &Record| {
        let (e, w) = (question.input_f64("E*")?, question.input_f64("w")? / 2.0);
        let radius = question.input_f64("radius");
        if question.status != Status::Ok {
            return None;
        }
        match (question.formula.as_str(), question.quantity.as_str()) {
            ("flat-punch-pull-off", "force") => Some(-(8.0 * PI * radius?.powi(3) * e * w).sqrt()),
            ("flat-punch-pull-off", "indentation") => Some(-(2.0 * PI * radius? * w / e).sqrt()),
            ("threshold", quantity) => {
                let share = if question.control.as_deref() == Some("force") { 3.0 } else { 1.0 };
                let threshold = share * 0.762_759_763_501_813_2 * (2.0 * PI * w / e).sqrt();
                Some(if quantity == "ratio" { question.input_f64("C")? / threshold } else { threshold })
            }
            ("work-lost-at-pull-off" | "work-lost-at-jump-in", _) if question.input("n") == Some("2") => {
                let radius = 0.5 / question.input_f64("C")?;
                // a³ = πwR²/(8E*) where it breaks, 2πwR²/E* at d = 0; 2/5 and 3/5 of πwa², with the a of each.
                let (share, cube) = if question.formula.ends_with("jump-in") { (0.6, 2.0) } else { (0.4, 0.125) };
                Some(share * PI * w * (cube * PI * w * radius * radius / e).cbrt().powi(2))
            }
            _ => None,
        }
    };
    let found = explained(halved_work);
    assert_names(&found, "work-halved");
    assert!(found[0].explained >= 15, "{found:?}");
    let g = |question: &Record| {
        let is_asked = question.profile == "paraboloid" && question.quantity == "g";
        let (x, radius) = (question.input_f64("x")?, question.input_f64("radius")?);
        is_asked.then_some(x * x / (2.0 * radius)).filter(|value| value.is_normal())
    };
    assert_names(&explained(g), "radius-doubled");
}

/// What is certain is said in one sentence; six printed digits are enough, and so is a part of the answers.
#[test]
fn a_sentence() {
    let halved = |question: &Record, c: Contact| fold(question, Contact { work: 0.5 * c.work, ..c });
    let text = found(halved)[0].to_string();
    assert!(
        text.starts_with("all ") && text.ends_with("digits if your work of adhesion is w/2 (γ taken for w)"),
        "{text}"
    );
    let printed = found(|question, contact| format!("{:.5e}", halved(question, contact)).parse().unwrap());
    assert_eq!((printed[0].names[0].as_str(), printed[0].digits), ("work-halved", 5));
    let spheres = |question: &Record, contact: Contact| match contact.slope {
        None => halved(question, contact),
        Some(_) => 7.0 * fold(question, contact),
    };
    let found = found(spheres);
    assert_eq!(found[0].names, ["work-halved"]);
    assert!(found[0].explained < found[0].not_right, "{found:?}");
    assert!(found[0].to_string().contains("can be tested"), "{}", found[0]);
}

/// The force of a sphere alone cannot tell 2w from 2R: both are named.
#[test]
fn alternatives() {
    let found = explained(|question| {
        let contact = Contact::of(question).filter(|contact| contact.slope.is_none())?;
        (question.quantity == "force").then(|| 2.0 * fold(question, contact))
    });
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].names, ["work-doubled", "radius-doubled"]);
    assert!(found[0].to_string().contains("; or if your radius is 2R"), "{}", found[0]);
}

/// Twice the force is no 2w where radius and depth are right: with 2w they would not be.
#[test]
fn right_answers_contradict() {
    let doubled = found(|question, contact| {
        let factor = if question.quantity == "force" { 2.0 } else { 1.0 };
        factor * fold(question, contact)
    });
    assert_eq!(doubled, []);
    // A mistake in the spheres alone is one, whatever is right of the cones.
    let spheres = found(|question, c| {
        let work = if c.slope.is_none() { c.work / 2.0 } else { c.work };
        fold(question, Contact { work, ..c })
    });
    assert_names(&spheres, "work-halved");
}

/// Two contacts are a coincidence, however many answers they have.
#[test]
fn a_coincidence_is_no_accusation() {
    for contacts in [["critical/jkr-unit/"; 2], ["critical/jkr-unit/", "critical/afm-tip/"]] {
        let of = |question: &Record| contacts.iter().any(|case| question.id.starts_with(case));
        let found = found(|question, c| {
            let factor = if of(question) { 0.5 } else { 1.0 };
            fold(question, Contact { work: factor * c.work, ..c })
        });
        assert_eq!(found, []);
    }
}

/// Neither right answers, nor other theories, nor nonsense.
#[test]
fn nothing_is_said_of_other_mistakes() {
    assert_eq!(explained(|question| question.value.as_ref().map(|_| question.nearest())), []);
    for nonsense in [0.0, 1.0, -1.0, 1e-9, f64::NAN, f64::INFINITY] {
        assert_eq!(explained(|_| Some(nonsense)), [], "{nonsense}");
    }
    // −2πwR of Bradley, and of Derjaguin, Muller and Toporov.
    let rigid = |question: &Record| {
        let contact = Contact::of(question).filter(|contact| contact.slope.is_none())?;
        (question.quantity == "force").then_some(-2.0 * PI * contact.work * contact.radius)
    };
    assert_eq!(explained(rigid), []);
    // Right answers, printed to six digits, are inaccurate, and what some conventions hardly change.
    let printed =
        |question: &Record| format!("{:.5e}", question.nearest()).parse().ok().filter(|x: &f64| x.is_finite());
    assert_eq!(explained(printed), []);
    // Inputs of the next question.
    let mut last = 1.0;
    let next = std::cell::RefCell::new(&mut last);
    let shifted = explained(|question| Some(std::mem::replace(*next.borrow_mut(), question.nearest())));
    assert_eq!(shifted, []);
}

/// Errors of any size and sign.
#[test]
fn nothing_is_said_of_random_errors() {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    for _ in 0..20 {
        let random = std::cell::RefCell::new(&mut state);
        let uniform = || {
            let mut state = random.borrow_mut();
            **state ^= **state << 13;
            **state ^= **state >> 7;
            **state ^= **state << 17;
            (**state >> 11) as f64 / 2_f64.powi(53)
        };
        let erring = explained(|question| {
            let factor = 10_f64.powf(4.0 * uniform() - 2.0);
            Some(question.nearest() * if uniform() < 0.5 { -factor } else { factor })
        });
        assert_eq!(erring, []);
    }
}

/// Names of what is found in answers, which may be none.
fn names(answer: impl Fn(&Record) -> Option<f64>) -> Vec<String> {
    explained(answer).into_iter().flat_map(|found| found.names).collect()
}

/// A certified double, of the questions that have one.
fn certified(record: &Record) -> Option<f64> {
    let plain = record.status == Status::Ok && record.formula == "critical";
    Some(record.nearest()).filter(|value| plain && value.is_normal() && value.abs() < 1e30 && value.abs() > 1e-30)
}

#[test]
fn single_precision_is_seen() {
    let single = |record: &Record| certified(record).map(|value| f64::from(value as f32));
    assert_eq!(names(single), ["float32"]);
    // As printed to nine digits, and with the rounding errors of single precision.
    let printed = |record: &Record| certified(record).map(|value| format!("{:.8e}", value as f32).parse().unwrap());
    assert_eq!(names(printed), ["float32"]);
    let rough = |record: &Record| certified(record).map(|value| f64::from((value as f32) * (1.0 + 3.0 * f32::EPSILON)));
    assert_eq!(names(rough), ["float32"]);
    // One answer of double precision, right or not, contradicts it; so does an error that is none of rounding.
    let once = |other: f64| {
        move |record: &Record| {
            let value = certified(record)?;
            Some(if record.id == "critical/jkr-unit/force/force" { value * other } else { f64::from(value as f32) })
        }
    };
    assert!(names(once(1.0)).is_empty());
    assert!(names(once(1.0 + 1e-9)).is_empty());
    assert!(names(once(0.5)).is_empty());
    // Where products leave its range there is 0, infinity, or what follows from them.
    let flushed = |record: &Record| {
        let plain = record.status == Status::Ok && record.formula == "critical";
        plain.then(|| if record.decades() > 12.5 { 0.0 } else { f64::from(record.nearest() as f32) })
    };
    assert_eq!(names(flushed), ["float32"]);
    // Six printed digits are no single precision.
    let six = |record: &Record| certified(record).map(|value| format!("{value:.5e}").parse().unwrap());
    assert!(names(six).is_empty());
}

#[test]
fn clamped_values_are_seen() {
    let clamped = |low: f64, high: f64| {
        move |record: &Record| {
            certified(record).map(|value| if record.unit == "N" { value.clamp(low, high) } else { value })
        }
    };
    let found = explained(clamped(-1.0, f64::INFINITY));
    let [only] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!((only.names[0].as_str(), only.explained), ("clamped", only.not_right));
    assert!(only.statements[0].contains("clamped to at least -1 N"), "{}", only.statements[0]);
    // No tension at all.
    let found = explained(clamped(0.0, f64::INFINITY));
    assert!(found.iter().any(|found| found.statements[0].contains("clamped to at least 0 N")), "{found:?}");
    let small =
        |record: &Record| certified(record).map(|value| if record.unit == "m" { value.min(1e-6) } else { value });
    assert!(explained(small).iter().any(|found| found.statements[0].contains("clamped to at most 1e-6 m")));
    // An answer beyond the bound contradicts it.
    let broken = |record: &Record| {
        let value = certified(record)?;
        let kept = record.id == "critical/jkr-unit/force/force";
        Some(if record.unit == "N" && !kept { value.max(-1.0) } else { value })
    };
    assert!(names(broken).is_empty(), "{:?}", explained(broken));
    assert!(certified(record("critical/jkr-unit/force/force").unwrap()).unwrap() < -1.0);
}

#[test]
fn an_absolute_tolerance_is_seen() {
    let radius = |record: &Record| certified(record).filter(|_| record.quantity == "contact_radius");
    // Bisection to 10⁻¹² m.
    let bisected = |record: &Record| radius(record).map(|value| (value / 1e-12).round() * 1e-12);
    let found = explained(bisected);
    assert!(found.iter().any(|found| found.names == ["absolute-tolerance"]), "{found:?}");
    // A relative error is none.
    let relative = |record: &Record| radius(record).map(|value| value * (1.0 + 1e-9));
    assert!(names(relative).is_empty(), "{:?}", explained(relative));
}
