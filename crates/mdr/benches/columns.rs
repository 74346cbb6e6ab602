//! The stable state at each of many values, in one long column, which is answered from a table of the branch, and in short ones,
//! which are searched; and a history of as many samples: `cargo bench -p mdr-contact --bench columns`.
//!
//! The passes are interleaved in short windows, and the least time of each is reported: ratios hold within one run.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use std::hint::black_box;
use std::time::Instant;

use mdr::columns::{Choice, ContactColumns};
use mdr::prelude::*;

const PASSES: usize = 30;
const LONG: usize = 100_000;
const SHORT: usize = 200;

fn shapes() -> [(&'static str, Shape<&'static str>); 5] {
    [
        ("paraboloid", Shape::Paraboloid { radius: "1" }),
        ("hyperboloid", Shape::Hyperboloid { flank: Flank::Slope("1"), lateral: "0.3" }),
        ("sphere", Shape::Sphere { radius: "1" }),
        ("rounded punch", Shape::RoundedPunch { radius: "1", flat: "0.2" }),
        ("wavy paraboloid", Shape::WavyParaboloid { radius: "1", amplitude: "5e-4", wavelength: "0.1" }),
    ]
}

/// The time of a question in nanoseconds per value, if it is less than before.
fn least(known: &mut f64, values: usize, ask: impl FnOnce() -> bool) {
    let begin = Instant::now();
    assert!(black_box(ask()), "answered");
    *known = known.min(begin.elapsed().as_nanos() as f64 / values as f64);
}

fn main() -> Result<(), Error> {
    println!(
        "{:>16} {:>12} {:>9} {:>10} {:>7} {:>11}",
        "profile", "control", "long, ns", "short, ns", "ratio", "follow, ns"
    );
    for (name, shape) in shapes() {
        let contact = ContactColumns::new(&Scene::new(shape, Elasticity::effective("1")?, "1e-3")?)?;
        for control in [Control::Indentation, Control::Force, Control::machine(0.1)?] {
            let folds = contact.folds(&control)?;
            let low = folds.iter().map(|fold| control.controlled(&fold.indentation, &fold.force)).fold(0.0, f64::min);
            let share = |i: usize| i as f64 * 0.618_033_988_749_894_9 % 1.0;
            let values: Vec<f64> = (0..LONG).map(|i| low * (0.999 - 5.0 * share(i))).collect();
            let ramp: Vec<f64> = (0..LONG).map(|i| low * (0.999 - 5.0 * (i as f64 / LONG as f64))).collect();
            let mut times = [f64::INFINITY; 3];
            for pass in 0..PASSES {
                let short = &values[pass * SHORT..(pass + 1) * SHORT];
                least(&mut times[0], LONG, || contact.states(&control, &values, Choice::Largest).is_ok());
                least(&mut times[1], SHORT, || contact.states(&control, short, Choice::Largest).is_ok());
                least(&mut times[2], LONG, || contact.follow(&control, &ramp, &Start::Largest).is_ok());
            }
            let [long, short, follow] = times;
            let symbol = control.kind().symbol();
            println!("{name:>16} {symbol:>12} {long:>9.1} {short:>10.1} {:>7.1} {follow:>11.1}", short / long);
        }
    }
    Ok(())
}
