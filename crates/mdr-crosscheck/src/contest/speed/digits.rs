//! Enclosures of many digits beside Arb.

use super::super::outside::question;
use super::super::precision::{EXPONENT, Other, Question, enough};
use super::super::{Arithmetic, Effort};
use super::{Hall, Lane};

/// Further exponents: terms of other sizes, and four of which Arb has Γ as a constant.
const MORE: [(i64, i64); 5] = [(7, 5), (1, 4), (1, 3), (2, 3), (1, 1)];

/// Digits from which on a race takes its time.
const LONG: u32 = 10_000;

/// κ_n and the critical state for rational n, κ_n for irrational n, all against the fastest way of Arb; κ_n against a single Γ;
/// and the first answer of a process, which needs constants.
pub(super) fn races(hall: &mut Hall<'_>, effort: Effort, questions: &[Question]) {
    let ladder: &[u32] = if effort == Effort::Full { &[50, 200, 1000, 10_000] } else { &[50, 200] };
    let precision = enough(ladder.last().copied().unwrap_or_default());
    let more: Vec<Question> = if effort == Effort::Full {
        let of = |n| [Question::kappa(n, precision), Question::critical(n, precision)];
        MORE.into_iter().flat_map(of).collect()
    } else {
        Vec::new()
    };
    let mut all: Vec<&Question> = questions.iter().chain(&more).collect();
    // All of one kind together.
    all.sort_by_key(|question| ["kappa-rational", "critical"].iter().position(|id| *id == question.id).unwrap_or(2));
    for question in all {
        hall.outsiders.begin();
        for &digits in ladder {
            against_arb(hall, question, digits, false);
        }
    }
    for question in questions.iter().chain(more.iter().filter(|question| question.title.ends_with("1/3"))) {
        hall.outsiders.begin();
        for &digits in ladder {
            against_arb(hall, question, digits, true);
        }
    }
    for question in questions.iter().filter(|question| question.id == "kappa-rational") {
        for &digits in ladder {
            against_gamma(hall, question, digits);
        }
    }
}

/// Against the fastest way of Arb; `fresh` without constants from earlier answers.
fn against_arb(hall: &mut Hall<'_>, question: &Question, digits: u32, fresh: bool) {
    let aim = match (question.id, digits) {
        _ if fresh => None,
        ("kappa-irrational", _) => Some(1.0),
        (_, LONG..) => Some(5.0),
        _ => Some(3.0),
    };
    let title = if fresh { format!("{}, the first answer", question.short()) } else { question.short() };
    let race = |&(theirs, by): &Other| {
        let mut asked = question.asked(by, digits);
        asked.insert("fresh".to_owned(), fresh.into());
        run(hall, question, digits, &title, (theirs, asked, true), aim, fresh)
    };
    // Of many digits Γ of a rational is by far the fastest, and named first.
    let ways = if digits < LONG { question.arb } else { &question.arb[..1] };
    let found: Vec<_> = ways.iter().map(race).collect();
    hall.keep(found);
}

/// κ_n against one of the two Γ that Arb needs for it.
fn against_gamma(hall: &mut Hall<'_>, question: &Question, digits: u32) {
    let (p, q) = EXPONENT;
    let asked = question! { "ask": "gamma", "by": "arb", "n": format!("{p}/{q}"), "digits": digits };
    let title = format!("{} beside Γ(1 + n/2) alone", question.short());
    let aim = if digits < LONG { 3.0 } else { 5.0 };
    let found = run(hall, question, digits, &title, ("one Γ of a rational", asked, false), Some(aim), false);
    hall.keep(vec![found]);
}

/// The name, the question, and whether it is all that this side answers.
type Theirs<'a> = (&'a str, serde_json::Map<String, serde_json::Value>, bool);

fn run(
    hall: &mut Hall<'_>,
    question: &Question,
    digits: u32,
    title: &str,
    (theirs, asked, whole): Theirs<'_>,
    aim: Option<f64>,
    fresh: bool,
) -> Result<super::Race, String> {
    let entry = question.entries.first().ok_or("nobody answers here")?;
    let solver = (entry.solver)(digits).map_err(|error| error.to_string())?;
    hall.race(&Lane {
        question: title,
        setting: &format!("{digits} digits"),
        ours: entry.name,
        solver: &*solver,
        theirs: (theirs, "python-flint", asked),
        arithmetic: Arithmetic::Certified,
        truths: &question.truths,
        whole,
        fresh,
        count: 1,
        aim,
    })
}
