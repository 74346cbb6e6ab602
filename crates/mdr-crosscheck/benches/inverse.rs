//! Both equilibria of a power law at a given indentation depth, by closed form and by the branches of the numerical route:
//! `cargo bench -p mdr-crosscheck --bench inverse`.
//!
//! The passes of all routes are interleaved in short windows, and the least time of each is reported: ratios hold within
//! one run.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use std::hint::black_box;
use std::time::Instant;

use mdr_analytic::double::{self, Inverse};
use mdr_analytic::{Contact, PowerLaw};
use mdr_core::contact::{Control, Error, Material, Quantity};
use mdr_numeric::branch::Branched;
use mdr_numeric::curve::Curve;
use mdr_numeric::equilibrium::Branches;

const VALUES: usize = 64;
const PASSES: usize = 300;

/// A way to count the equilibria at a depth; what it finds beside their number is kept from being optimised away.
type Route<'a> = (&'static str, Box<dyn Fn(f64) -> usize + 'a>);

fn main() -> Result<(), Error> {
    let (material, control) = (Material::new(1e6, 0.05)?, Control::Indentation);
    println!("{:4} {:34} {:>9} {:>8}", "n", "both equilibria at a depth", "ns", "ratio");
    for n in [0.25, 0.75, 1.0, 1.7, 2.0, 4.0] {
        let c = 50.0;
        let at_fold = double::critical(n, c, &material, &control)?.indentation.value(Quantity::Indentation)?;
        let ready = Inverse::new(n, c, &material, &control)?;
        let contact = Contact::new(PowerLaw::new(n, c)?, material.clone());
        let branches = Branches::new(Curve::new(contact.profile(), &material, &control))?;
        let routes: [Route<'_>; 4] = [
            (
                "double::Inverse, ready",
                Box::new(|d| black_box(ready.equilibria(d)).map_or(0, |found| found.as_slice().len())),
            ),
            (
                "double::equilibria",
                Box::new(|d| {
                    black_box(double::equilibria(n, c, &material, &control, d))
                        .map_or(0, |found| found.as_slice().len())
                }),
            ),
            (
                "Contact::equilibria in f64",
                Box::new(|d| black_box(contact.equilibria(&control, &d)).map_or(0, |found| found.as_slice().len())),
            ),
            ("branches, folds known", Box::new(|d| black_box(branches.equilibria(&d)).map_or(0, |found| found.len()))),
        ];
        let mut least = [f64::INFINITY; 4];
        for _ in 0..PASSES {
            for ((_, route), least) in routes.iter().zip(&mut least) {
                let start = Instant::now();
                for i in 0..VALUES {
                    let found = route(black_box(at_fold * (i as f64 + 0.5) / VALUES as f64));
                    assert_eq!(found, 2, "between the fold and zero");
                }
                *least = least.min(start.elapsed().as_secs_f64() * 1e9 / VALUES as f64);
            }
        }
        for ((name, _), time) in routes.iter().zip(least) {
            println!("{n:4} {name:34} {time:9.0} {:8.2}", time / least[0]);
        }
    }
    Ok(())
}
