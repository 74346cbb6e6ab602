//! Both equilibria of a power law at a given indentation depth, by closed form and by the branches of the numerical route:
//! `cargo bench -p mdr-crosscheck --bench inverse`.
//!
//! The passes of all routes are interleaved in short windows, and the least time of each is reported: ratios hold within
//! one run.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use std::array::from_fn;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use mdr_analytic::double::grid::InstructionSet;
use mdr_analytic::double::{self, BranchSlices, Inverse, InverseBatch as Found};
use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Error, Material, Quantity, Status};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;

const VALUES: usize = 64;
const PASSES: usize = 300;

/// A way to count the equilibria at depths; what it finds beside their number is kept from being optimised away.
type Route<'a> = (String, Box<dyn Fn(&[f64]) -> usize + 'a>);

/// One depth after the other.
fn each<'a>(name: &str, count: impl Fn(f64) -> usize + 'a) -> Route<'a> {
    (name.to_owned(), Box::new(move |depths| depths.iter().map(|&d| count(black_box(d))).sum()))
}

/// All depths in one call.
fn at_once<'a>(inverse: &Inverse, path: InstructionSet) -> Route<'a> {
    let inverse = inverse.clone().with_instructions(path);
    let count = move |depths: &[f64]| {
        let ([mut a0, mut f0, mut a1, mut f1], mut status) = ([[0.0; VALUES]; 4], [Status::Ok; VALUES]);
        let mut found = Found {
            smaller: BranchSlices { contact_radius: &mut a0, uncontrolled: &mut f0 },
            larger: BranchSlices { contact_radius: &mut a1, uncontrolled: &mut f1 },
            status: &mut status,
        };
        let tally = inverse.branches(black_box(depths), &mut found);
        black_box((&a0, &f0, &a1, &f1));
        tally.map_or(0, |_| 2 * status.iter().filter(|&&status| status == Status::Ok).count())
    };
    (format!("Inverse::branches, {path}"), Box::new(count))
}

/// The stable one of both at all depths in one call.
fn stable_at_once<'a>(inverse: &Inverse, path: InstructionSet) -> Route<'a> {
    let inverse = inverse.clone().with_instructions(path);
    let count = move |depths: &[f64]| {
        let ([mut a, mut force], mut status) = ([[0.0; VALUES]; 2], [Status::Ok; VALUES]);
        let mut found = BranchSlices { contact_radius: &mut a, uncontrolled: &mut force };
        let tally = inverse.stable(black_box(depths), &mut found, &mut status);
        black_box((&a, &force));
        tally.map_or(0, |_| 2 * status.iter().filter(|&&status| status == Status::Ok).count())
    };
    (format!("Inverse::stable, {path}"), Box::new(count))
}

fn main() -> Result<(), Error> {
    let (material, control) = (Material::new(1e6, 0.05)?, Control::Indentation);
    println!("{:4} {:34} {:>9} {:>8}", "n", "both equilibria at a depth", "ns", "ratio");
    for n in [0.25, 0.3, 0.75, 1.0, 1.7, 2.0, 4.0] {
        let c = 50.0;
        let at_fold = double::critical(n, c, &material, &control)?.indentation.value(Quantity::Indentation)?;
        let ready = Inverse::new(n, c, &material, &control)?;
        let contact = PowerLawContact::new(PowerLaw::new(n, c)?, material.clone());
        let branches =
            SearchedBranches::new(Contact::half_space(&Arc::new(contact.profile().clone()), &material, &control))?;
        let one_by_one = |path: InstructionSet| {
            let ready = ready.clone().with_instructions(path);
            each(&format!("Inverse::equilibria, {path}"), move |d| {
                black_box(ready.equilibria(d)).map_or(0, |found| found.as_slice().len())
            })
        };
        let mut routes: Vec<Route<'_>> = InstructionSet::available().map(one_by_one).collect();
        routes.extend(InstructionSet::available().map(|path| at_once(&ready, path)));
        routes.extend(InstructionSet::available().map(|path| stable_at_once(&ready, path)));
        routes.extend([
            each("double::equilibria", |d| {
                black_box(double::equilibria(n, c, &material, &control, d)).map_or(0, |found| found.as_slice().len())
            }),
            each("PowerLawContact::equilibria in f64", |d| {
                black_box(contact.equilibria(&control, &d)).map_or(0, |found| found.as_slice().len())
            }),
            each("branches, folds known", |d| black_box(branches.equilibria(&d)).map_or(0, |found| found.len())),
        ]);
        let depths: [f64; VALUES] = from_fn(|i| at_fold * (i as f64 + 0.5) / VALUES as f64);
        let mut least = vec![f64::INFINITY; routes.len()];
        for _ in 0..PASSES {
            for ((_, route), least) in routes.iter().zip(&mut least) {
                let start = Instant::now();
                let found = route(&depths);
                *least = least.min(start.elapsed().as_secs_f64() * 1e9 / VALUES as f64);
                assert_eq!(found, 2 * VALUES, "between the fold and zero");
            }
        }
        for ((name, _), time) in routes.iter().zip(&least) {
            println!("{n:4} {name:34} {time:9.0} {:8.2}", time / least[0]);
        }
    }
    Ok(())
}
