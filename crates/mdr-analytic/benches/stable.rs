//! The stable equilibrium of power laws at many values beside a cube root: `cargo bench -p mdr-analytic --bench stable`.
//!
//! JKR under a dead load, the cone and n = 1/4 at given depths are quadratic equations; the others are solved by steps. The passes
//! are interleaved in short windows, and the least time of each is reported: ratios hold within one run.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use std::hint::black_box;
use std::time::Instant;

use mdr_analytic::double::grid::InstructionSet;
use mdr_analytic::double::{self, BranchSlices, Inverse};
use mdr_core::contact::{Control, Error, Material, Quantity, Status};

const VALUES: usize = 4096;
const PASSES: usize = 300;

struct Route {
    name: String,
    inverse: Inverse,
    values: Vec<f64>,
    least: f64,
}

fn routes() -> Result<Vec<Route>, Error> {
    let material = Material::new(1e6, 0.05)?;
    let (depth, force) = (Control::Indentation, Control::Force);
    let laws =
        [(2.0, &force), (1.0, &depth), (0.25, &depth), (2.0, &depth), (1.0, &force), (0.25, &force), (1.7, &force)];
    let mut routes = Vec::new();
    for (n, control) in laws {
        let fold = double::critical(n, 50.0, &material, control)?;
        let held = if *control == Control::Force { fold.force } else { fold.indentation };
        let at_fold = held.value(Quantity::Force)?;
        // Half of them between the fold and 0 for n < 1/2, where the stable branch ends at 0; else to four times as far.
        let reach = if n < 0.5 { 0.999 } else { 5.0 };
        let values = (0..VALUES).map(|i| at_fold * (0.999 - reach * (i as f64 * 0.618_033_988_749_894_9 % 1.0)));
        let values: Vec<f64> = values.collect();
        for path in InstructionSet::available() {
            let inverse = Inverse::new(n, 50.0, &material, control)?.with_instructions(path);
            let name = format!("n = {n:4}, at a given {}, {path}", control.kind().symbol());
            routes.push(Route { name, inverse, values: values.clone(), least: f64::INFINITY });
        }
    }
    Ok(routes)
}

fn main() -> Result<(), Error> {
    let mut routes = routes()?;
    let ([mut a, mut other], mut status) = ([(); 2].map(|()| vec![0.0; VALUES]), vec![Status::Ok; VALUES]);
    let mut of_cube_root = f64::INFINITY;
    for _ in 0..PASSES {
        for Route { inverse, values, least, .. } in &mut routes {
            let found = &mut BranchSlices { contact_radius: &mut a, uncontrolled: &mut other };
            let start = Instant::now();
            let report = inverse.stable(black_box(values), found, &mut status)?;
            *least = least.min(start.elapsed().as_secs_f64() * 1e9 / VALUES as f64);
            assert_eq!(report.passed_on, 0, "ordinary values");
        }
        let start = Instant::now();
        for (root, value) in a.iter_mut().zip(black_box(&routes[0].values)) {
            *root = value.cbrt();
        }
        black_box(&a);
        of_cube_root = of_cube_root.min(start.elapsed().as_secs_f64() * 1e9 / VALUES as f64);
    }
    println!("{:40} {:>9} {:>8}", "stable equilibrium", "ns", "ratio");
    println!("{:40} {of_cube_root:9.1} {:8.2}", "f64::cbrt", 1.0);
    for Route { name, least, .. } in &routes {
        println!("{name:40} {least:9.1} {:8.2}", least / of_cube_root);
    }
    Ok(())
}
