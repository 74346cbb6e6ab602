//! Three ways to compute the contact radius of a JKR sphere at a given indentation, judged by the certified records.
//! The numbers of docs/judged.md: `cargo run --package mdr-crosscheck --example judged`; with a directory as argument, the
//! answers go there as files for `mdr judge`.

#![allow(clippy::print_stdout, reason = "an example talks")]

use std::f64::consts::PI;
use std::path::PathBuf;
use std::sync::Arc;

use mdr_analytic::PowerLaw;
use mdr_core::contact::{Control, Error, Material, Stability};
use mdr_numeric::equilibrium::equilibria;
use mdr_reference::{Answer, Filter, Judged, Record, Status, judge};

/// R, E*, w and d of a question about a sphere.
struct Sphere {
    radius: f64,
    e_star: f64,
    work: f64,
    d: f64,
}

/// A way to answer a question about a sphere.
type Way = fn(&Sphere) -> Answer;

impl Sphere {
    fn of(question: &Record) -> Option<Self> {
        let input = |name| question.input_f64(name);
        let sphere = Sphere { radius: 0.5 / input("C")?, e_star: input("E*")?, work: input("w")?, d: input("d")? };
        (input("n")? == 2.0).then_some(sphere)
    }

    /// (a²/R − d)² = 2πwa/E* is a quartic for a. Ferrari's solution, as discrete element codes use it (Parteli et al.,
    /// Sci. Rep. 4 (2014) 6227).
    fn ferrari(&self) -> f64 {
        let Sphere { radius, e_star, work, d } = self;
        let c0 = (radius * d).powi(2);
        let c1 = -2.0 * PI * work * radius.powi(2) / e_star;
        let c2 = -2.0 * d * radius;
        let p = -c2 * c2 / 12.0 - c0;
        let q = -c2.powi(3) / 108.0 + c0 * c2 / 3.0 - c1 * c1 / 8.0;
        let u = (-q / 2.0 + (q * q / 4.0 + p.powi(3) / 27.0).sqrt()).cbrt();
        let s = if p == 0.0 { -5.0 * c2 / 6.0 - q.cbrt() } else { -5.0 * c2 / 6.0 + u - p / (3.0 * u) };
        let w = (c2 + 2.0 * s).sqrt();
        let lambda = c1 / (2.0 * w);
        (w + (w * w - 4.0 * (c2 + s + lambda)).sqrt()) / 2.0
    }

    /// Newton's method for a²/R − √(2πwa/E*) = d from the radius at zero load, until a step is below 10⁻¹² m.
    fn newton(&self) -> f64 {
        let Sphere { radius, e_star, work, d } = self;
        let mut a = (4.5 * PI * work * radius.powi(2) / e_star).cbrt();
        for _ in 0..100 {
            let elongation = (2.0 * PI * work * a / e_star).sqrt();
            let step = (a * a / radius - elongation - d) / (2.0 * a / radius - elongation / (2.0 * a));
            a -= step;
            if step.abs() < 1e-12 {
                break;
            }
        }
        a
    }

    /// The equilibria of this workspace in f64: the stable one.
    fn workspace(&self) -> Result<Option<f64>, Error> {
        let profile = Arc::new(PowerLaw::new(2.0, 0.5 / self.radius)?);
        let material = Material::new(self.e_star, self.work)?;
        let found = equilibria(&profile, &material, &Control::Indentation, &self.d)?;
        Ok(found.iter().rfind(|state| state.stability == Stability::Stable).map(|state| state.contact_radius))
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let directory = std::env::args().nth(1).map(PathBuf::from);
    let questions: Filter =
        "formula=equilibrium control=indentation quantity=contact_radius flag=outer flag!=worst".parse()?;
    let ways: [(&str, &str, Way); 3] = [
        ("quartic", "Ferrari's solution of the quartic", |sphere| sphere.ferrari().into()),
        ("newton", "Newton's method, absolute tolerance 1e-12 m", |sphere| sphere.newton().into()),
        ("workspace", "this workspace, f64", |sphere| match sphere.workspace() {
            Ok(Some(a)) => a.into(),
            Ok(None) => Status::NoEquilibrium.into(),
            Err(_) => Status::DomainError.into(),
        }),
    ];
    for (stem, name, way) in ways {
        let mut lines = String::new();
        let report = judge(questions.select(), |question| {
            let answer = way(&Sphere::of(question)?);
            lines += &format!("{}\n", answer.to_json(&question.id));
            Some(answer)
        });
        println!("{name}\n{report}");
        report.judged.iter().for_each(print);
        if let Some(directory) = &directory {
            std::fs::write(directory.join(stem).with_extension("jsonl"), lines)?;
        }
    }
    Ok(())
}

fn print(Judged { record, mark, .. }: &Judged<'_>) {
    let digits = mark.lre.map_or(String::new(), |lre| format!("{:.1}", lre.low));
    let loss = mark.excess_loss.map_or(String::new(), |loss| format!("{:.1}", loss.low));
    println!("  {:<70} {digits:>5} digits, loss {loss:>5}: {}", record.id, mark.verdict.name());
}
