//! The picture on the first page that moves: a ball is pressed on and pulled off, every frame an answer of the library.

use std::f64::consts::TAU;

use maud::{Markup, PreEscaped, html};
use mdr::columns::{ContactColumns, States};
use mdr::prelude::*;

use crate::error::{Error, Result};

/// Frames from one end of the path to the other.
const FRAMES: u32 = 60;

/// The indentation depths between which the ball moves, in units in which E* = 1, w = 1/2π, so that Δl = √a, and R = 1.
const DEPTHS: [f64; 2] = [-0.7, 1.2];

/// The frame that is shown first: the load-free depth on the way back.
const FIRST: usize = 97;

/// The balance at the edge of the contact beside the force over the depth, with the controls that move them.
///
/// # Errors
/// When the library refuses the scene.
pub(crate) fn picture() -> Result<Markup> {
    let cycle = cycle().map_err(|error| Error::page("index", error.to_string()))?;
    let frames: Vec<String> = cycle.frames.iter().map(|[d, a, force]| format!("[{d:.4},{a:.4},{force:.4}]")).collect();
    let [shifted, elongation] = [|a: f64| a * a, f64::sqrt].map(|height| {
        let points: Vec<[f64; 2]> = (0..=95).map(|i| f64::from(i) * 0.02).map(|a| [a, height(a)]).collect();
        line(&points)
    });
    Ok(html! {
        figure.moving data-frames={ "[" (frames.join(",")) "]" } {
            svg viewBox="0 0 640 300" role="img" aria-label="Two curves over the contact radius, and force over indentation depth, of a ball that is pressed on and pulled off" {
                (panel("translate(50 175) scale(115 -75)", &html! {
                    path.axis d="M0 -1.3V2M0 0H1.9" {}
                    path.adh d=(elongation) {}
                    path.ela data-moves="depth" d=(shifted) {}
                    path.dot data-moves="edge" {}
                }))
                text.adh x="274" y="78" { "Δ" tspan font-style="italic" { "l" } }
                text x="268" y="292" text-anchor="end" { "contact radius " tspan font-style="italic" { "a" } }
                (panel("translate(450 150) scale(110 -80)", &html! {
                    path.axis d="M-.8 0H1.4M0 -1.2V1.4" {}
                    @for (points, stable) in &cycle.branches { path.unstable[!stable] d=(line(points)) {} }
                    path.dot data-moves="force" {}
                }))
                text x="438" y="24" text-anchor="end" { "force " tspan font-style="italic" { "F" } }
                text x="630" y="292" text-anchor="end" { "indentation depth " tspan font-style="italic" { "d" } }
            }
            p.controls {
                button type="button" data-play="" hidden { "Play" }
                input type="range" min="0" max=(cycle.frames.len() - 1) value=(FIRST) aria-label="Time" hidden;
                output {}
            }
            figcaption {
                span.adh { "Δ" i { "l" } } ": what adhesion can hold. " span.ela { i { "g" } " − " i { "d" } } ": what elasticity asks for. "
                "Where the curves meet, the contact rests. Pulled up, " i { "g" } " − " i { "d" } " leaves Δ" i { "l" } ": the contact breaks."
            }
        }
    })
}

/// A panel in the units of its axes.
fn panel(transform: &str, content: &Markup) -> Markup {
    html! { g transform=(transform) { (content) } }
}

/// A polyline as the data of an SVG path.
fn line(points: &[[f64; 2]]) -> PreEscaped<String> {
    let points: Vec<String> = points.iter().map(|[x, y]| format!("{x:.4} {y:.4}")).collect();
    PreEscaped(format!("M{}", points.join("L")))
}

struct Cycle {
    /// Depth, contact radius and force; apart both are 0.
    frames: Vec<[f64; 3]>,
    /// Force over depth, and whether it is stable.
    branches: Vec<(Vec<[f64; 2]>, bool)>,
}

fn cycle() -> mdr::Result<Cycle> {
    let material = Elasticity::effective("1")?;
    let scene = Scene::new(Shape::Paraboloid { radius: 1.0 }, material, (1.0 / TAU).exact()?)?
        .arithmetic(Arithmetic::F64)
        .path(["-0.7", "1.2", "-0.7"])?
        .start(Start::Detached);
    let diagram = scene.diagram()?;
    let branches = diagram.branches.iter().map(|branch| {
        (branch.samples.iter().map(|sample| [sample.indentation, sample.force]).collect(), branch.stable)
    });
    let depth = |frame: u32| DEPTHS[0] + (DEPTHS[1] - DEPTHS[0]) * f64::from(frame) / f64::from(FRAMES);
    let depths: Vec<f64> = (0..=FRAMES).chain((0..FRAMES).rev()).map(depth).collect();
    let history = ContactColumns::new(&scene)?.follow(&Control::Indentation, &depths, &Start::Detached)?;
    let States { contact_radius, force, .. } = history.states;
    let frames = depths.iter().zip(contact_radius.iter().zip(&force)).map(|(d, (a, force))| [*d, *a, *force]);
    Ok(Cycle { frames: frames.collect(), branches: branches.collect() })
}
