//! How the tests of another crate use the records: a double-precision solver for the equilibria of an adhesive sphere,
//! judged in one call.
//!
//! `cargo run --package mdr-reference --example jkr`

#![allow(clippy::print_stdout, reason = "an example talks")]

use std::f64::consts::PI;

use mdr_reference::{Answer, Filter, Status, judge};

/// The contact radius of a paraboloid f = C r² at the indentation d, on the branch that is stable under fixed grips: the
/// larger root of 2Ca² − √(2πaw/E*) = d, by Newton's method in √a from above, where the function is convex.
fn contact_radius(c: f64, e_star: f64, work: f64, d: f64) -> Option<f64> {
    let root = (2.0 * PI * work / e_star).sqrt();
    // With s = √a: 2Cs⁴ − root·s − d = 0, a minimum at 8Cs³ = root.
    let lowest = (root / (8.0 * c)).cbrt();
    let excess = |s: f64| 2.0 * c * s.powi(4) - root * s - d;
    if excess(lowest) > 0.0 {
        return None;
    }
    // Both roots are below this sum of scales.
    let mut s = (root / c).cbrt() + (d.abs() / c).sqrt().sqrt() + lowest;
    for _ in 0..100 {
        let next = s - excess(s) / (8.0 * c * s.powi(3) - root);
        if !(next < s) {
            break;
        }
        s = next;
    }
    Some(s * s)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let questions: Filter = "formula=equilibrium control=indentation quantity=contact_radius flag=outer".parse()?;
    let report = judge(questions.select(), |question| {
        let input = |name| question.input_f64(name);
        let radius = contact_radius(input("C")?, input("E*")?, input("w")?, input("d")?);
        // Only spheres: a question that is not answered does not count.
        (input("n")? == 2.0).then(|| radius.map_or(Status::NoEquilibrium.into(), Answer::from))
    });
    println!("{report}");
    if report.passed() { Ok(()) } else { Err(report.failures().join("; ").into()) }
}
