//! All stability ladders, worst first: `cargo run --release -p mdr-crosscheck --example ladders`. With `--quick` few rungs,
//! with a word after it, such as `-- Sphere`, those of functions with that word, and with `--worst` the list of worst inputs
//! is brought up to date.

#![allow(clippy::print_stdout, reason = "an example talks")]

use std::fs;

use mdr_crosscheck::Level;
use mdr_crosscheck::ladders::{Ladder, Worst, ladders_of, worst_inputs};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let asked = |flag: &str| std::env::args().any(|argument| argument == flag);
    let word = std::env::args().skip(1).find(|argument| !argument.starts_with("--")).unwrap_or_default();
    let mut all = ladders_of(if asked("--quick") { Level::Quick } else { Level::Full }, &word);
    if asked("--worst") {
        let worst = Worst::found(&all, &worst_inputs()?);
        let lines: Result<Vec<_>, _> = worst.iter().map(serde_json::to_string).collect();
        fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/data/worst.jsonl"), lines?.join("\n") + "\n")?;
    }
    all.sort_by(|a, b| key(b).total_cmp(&key(a)));
    for ladder in &all {
        let Some(rung) = ladder.worst() else { continue };
        let open = ladder.rungs.iter().filter(|rung| !rung.accepted()).count();
        println!(
            "{open:2}/{:2} {} | {} | {:?}, condition {:?} at {:?}; naive {:?} ulp",
            ladder.rungs.len(),
            ladder.function,
            ladder.toward,
            rung.found,
            rung.condition,
            rung.inputs,
            ladder.worst_naive()
        );
    }
    Ok(())
}

/// The excess loss of the worst rung; what is not accepted otherwise comes first.
fn key(ladder: &Ladder) -> f64 {
    ladder.worst().map_or(f64::NEG_INFINITY, |rung| match rung.excess() {
        Some(excess) => excess,
        None if rung.accepted() => f64::NEG_INFINITY,
        None => f64::INFINITY,
    })
}
