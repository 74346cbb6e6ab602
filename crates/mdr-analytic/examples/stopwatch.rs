//! How long an enclosure takes. Reads one question a line from standard input, `task n digits loops`, and answers with the
//! microseconds of one evaluation, the least of five series of so many loops. `scripts/beside_arb.py` asks the questions.
//!
//! Tasks: `kappa` (κ_n for rational n, enclosed), `irrational` (κ at √2 n, an interval at the working precision), `critical`
//! (κ, a, d and F, enclosed), and the same with decimals: `kappa-decimals`, `critical-decimals`.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a measuring tool: it fails by panicking, and prints")]

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::time::Instant;

use mdr_analytic::certified::{Elasticity, Question, kappa};
use mdr_analytic::{Kappa, kappa_enclosure};
use mdr_core::contact::Control;
use mdr_core::number::{Interval, Literal, Precision, Real};

/// Microseconds on the processor where Linux tells them, since some point in time elsewhere.
fn now(start: Instant) -> f64 {
    // Brings the statistics up to date.
    std::thread::yield_now();
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = statistics.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64() * 1e6, |time| time / 1e3)
}

fn main() {
    let start = Instant::now();
    for line in std::io::stdin().lock().lines() {
        let line = line.unwrap();
        let words: Vec<&str> = line.split_whitespace().collect();
        let [task, n, digits, loops] = words[..] else { continue };
        let (digits, loops): (u32, u32) = (digits.parse().unwrap(), loops.parse().unwrap());
        let [n, c, e_star, work] = [n, "1.5", "1e6", "0.05"].map(|text| text.parse::<Literal>().unwrap());
        let precision = Precision::from_digits(digits);
        let exact = n.to_rational();
        let irrational = Interval::from_int(precision, 2).sqrt() * Interval::from_rational(precision, &exact);
        let elasticity = Elasticity::Effective(e_star);
        let question = Question::new(&n, &c, &elasticity, &work, &Control::Indentation).unwrap();
        let run = || {
            let begin = now(start);
            for _ in 0..loops {
                match task {
                    "kappa" => drop(black_box(kappa_enclosure(precision, black_box(&exact)))),
                    "irrational" => drop(black_box(Interval::kappa(black_box(&irrational)))),
                    "critical" => drop(black_box(black_box(&question).enclosures(precision))),
                    "kappa-decimals" => drop(black_box(kappa(black_box(&n), digits))),
                    "critical-decimals" => drop(black_box(black_box(&question).answer(digits))),
                    _ => panic!("no such task: {task}"),
                }
            }
            (now(start) - begin) / f64::from(loops)
        };
        let least = (0..5).map(|_| run()).fold(f64::INFINITY, f64::min);
        println!("{least}");
        std::io::stdout().flush().unwrap();
    }
}
