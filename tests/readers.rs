//! The fuzz targets of `fuzz/` over their corpus, and over random changes of it: some seconds here, and longer on request.
//!
//! `MDR_FUZZ_SECONDS=120 cargo test -p mdr-tests --test readers` changes the corpus of each target for two minutes, from a seed that is
//! printed; `MDR_FUZZ_SEED` repeats it. An input that fails is printed, and becomes a file of `fuzz/corpus`.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    reason = "a test may panic, and say what it did"
)]

#[path = "../fuzz/src/lib.rs"]
#[allow(unreachable_pub, reason = "a library where it is fuzzed")]
mod targets;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `end`, which is not 0.
    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }
}

/// Pieces that readers treat in a way of their own.
const PIECES: [&str; 24] = [
    "0",
    "-",
    "e",
    "E+",
    "1e999999999",
    "-1e-999999999",
    "1/0",
    ".",
    "\"",
    "'",
    "\\",
    "[",
    "]",
    "{",
    "}",
    "=",
    ",",
    "\n",
    "nan",
    "inf",
    "µm",
    "(((((((((",
    "\u{feff}",
    "^-1/2",
];

/// One to four changes: a byte flipped or replaced, a part cut, doubled, or replaced by a part of another seed, a piece put in.
fn changed(random: &mut Random, seeds: &[Vec<u8>]) -> Vec<u8> {
    let mut input = seeds[random.below(seeds.len())].clone();
    for _ in 0..=random.below(4) {
        let (at, length) = (random.below(input.len() + 1), 1 + random.below(16));
        let end = (at + length).min(input.len());
        let part: Vec<u8> = match random.below(6) {
            0 => input[at..end].iter().map(|byte| byte ^ (1 << random.below(8))).collect(),
            1 => input[at..end].iter().map(|_| b' ' + random.below(95) as u8).collect(),
            2 => Vec::new(),
            3 => input[at..end].repeat(2 + random.below(3)),
            4 => {
                let other = &seeds[random.below(seeds.len())];
                let from = random.below(other.len() + 1);
                other[from..(from + 4 * length).min(other.len())].to_vec()
            }
            _ => PIECES[random.below(PIECES.len())].as_bytes().to_vec(),
        };
        input.splice(at..end, part);
    }
    input
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files of a folder with this ending, or all.
fn read(folder: &str, ending: &str) -> Vec<Vec<u8>> {
    let entries = fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.retain(|path| path.to_str().unwrap().ends_with(ending));
    paths.into_iter().map(|path| fs::read(path).unwrap()).collect()
}

/// Runs a target over its seeds and over changes of them: at least this many, and for as long as `MDR_FUZZ_SECONDS` says.
fn run(name: &str, target: fn(&[u8]), seeds: &[Vec<u8>], least: u32) {
    assert!(seeds.len() >= 4, "{name}: {} seeds", seeds.len());
    let variable = |name: &str| std::env::var(name).ok().and_then(|value| value.parse::<u64>().ok());
    let (seconds, seed) = (variable("MDR_FUZZ_SECONDS").unwrap_or(0), variable("MDR_FUZZ_SEED").unwrap_or(0));
    let (begin, mut random) = (Instant::now(), Random(seed));
    let (mut runs, mut slowest) = (0, (Duration::ZERO, Vec::new()));
    let mut one = |input: &[u8]| {
        let started = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| target(input)));
        assert!(outcome.is_ok(), "{name}, seed {seed}: {:?}", String::from_utf8_lossy(input));
        if started.elapsed() > slowest.0 {
            slowest = (started.elapsed(), input.to_vec());
        }
    };
    seeds.iter().for_each(|input| one(input));
    while runs < least || begin.elapsed() < Duration::from_secs(seconds) {
        one(&changed(&mut random, seeds));
        runs += 1;
    }
    println!(
        "{name}: {runs} changes from seed {seed}; the slowest took {:?}: {:?}",
        slowest.0,
        String::from_utf8_lossy(&slowest.1)
    );
}

#[test]
fn scenes() {
    let mut seeds = read("fuzz/corpus/scene", "");
    seeds.extend(read("examples/scenes", ".toml"));
    seeds.extend(read("tests/command_line/bad_scenes", ".toml"));
    run("scene", targets::scene, &seeds, 500);
}

#[test]
fn formulas() {
    run("formula", targets::formula, &read("fuzz/corpus/formula", ""), 5000);
}

#[test]
fn literals() {
    run("literal", targets::literal, &read("fuzz/corpus/literal", ""), 5000);
}

#[test]
fn answers_of_other_programs() {
    run("jsonl", targets::jsonl, &read("fuzz/corpus/jsonl", ""), 200);
}

/// The driver can fail.
#[test]
fn a_broken_target_is_found() {
    let broken = |input: &[u8]| assert!(!input.contains(&b'!'), "an exclamation mark");
    let seeds = vec![b"1!".to_vec(); 4];
    assert!(catch_unwind(|| run("broken", broken, &seeds, 10)).is_err());
}
