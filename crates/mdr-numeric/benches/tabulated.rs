//! A stable state at each of many values: by a table of the branch, its building included, and by a search for each:
//! `cargo bench -p mdr-numeric --bench tabulated`.
//!
//! The passes of both are interleaved in short windows, and the least time of each is reported: ratios hold within one run.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use std::hint::black_box;
use std::time::Instant;

use mdr_core::contact::{Control, Flank, Result, Shape};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::medium::{Adhesion, Medium};
use mdr_numeric::tabulated::TabulatedBranch;
use mdr_numeric::transform::Quadrature;

const PASSES: usize = 20;
const SEARCHED: usize = 1000;

fn shapes() -> [(&'static str, Shape<f64>); 5] {
    [
        ("paraboloid", Shape::Paraboloid { radius: 1.0 }),
        ("hyperboloid", Shape::Hyperboloid { flank: Flank::Slope(1.0), lateral: 0.3 }),
        ("sphere", Shape::Sphere { radius: 1.0 }),
        ("rounded punch", Shape::RoundedPunch { radius: 1.0, flat: 0.2 }),
        ("wavy paraboloid", Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }),
    ]
}

/// The least time of both in nanoseconds per value.
fn least(values: &[f64], branches: &SearchedBranches<f64>, branch: usize, range: [f64; 2]) -> Result<[f64; 2]> {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..PASSES {
        let begin = Instant::now();
        let table = TabulatedBranch::new(branches, branch, range, usize::MAX)?;
        let at = |value: &f64| table.as_ref().and_then(|table| table.at(*value)).map_or(f64::NAN, |rest| rest.force);
        black_box(values.iter().map(at).sum::<f64>());
        least[0] = least[0].min(begin.elapsed().as_nanos() as f64 / values.len() as f64);
        let begin = Instant::now();
        for value in values.iter().take(SEARCHED) {
            black_box(branches.on_branch(branch, value)?);
        }
        least[1] = least[1].min(begin.elapsed().as_nanos() as f64 / SEARCHED as f64);
    }
    Ok(least)
}

fn main() -> Result<()> {
    println!(
        "{:>16} {:>12} {:>8} {:>10} {:>10} {:>7}",
        "profile", "control", "values", "table, ns", "search, ns", "ratio"
    );
    for (name, shape) in shapes() {
        for control in [Control::Indentation, Control::Force, Control::machine(0.1)?] {
            let transform = Quadrature::of([shape.clone()])?;
            let contact = Contact::new(transform, Medium::half_space(1.0)?, Adhesion::new(1e-3)?, control.clone());
            let branches = SearchedBranches::new(contact)?;
            let branch = branches.folds().len();
            let Some(fold) = branches.folds().last() else { continue };
            let low = control.controlled(&fold.indentation, &fold.force);
            let range = [low, low + 5.0 * low.abs()];
            for len in [2000, 100_000] {
                let share = |i: usize| 0.001 + 0.999 * (i as f64 * 0.618_033_988_749_894_9 % 1.0);
                let values: Vec<f64> = (0..len).map(|i| low + (range[1] - low) * share(i)).collect();
                let [table, search] = least(&values, &branches, branch, range)?;
                let control = format!("{}", control.kind().symbol());
                println!("{name:>16} {control:>12} {len:>8} {table:>10.1} {search:>10.1} {:>7.1}", search / table);
            }
        }
    }
    Ok(())
}
