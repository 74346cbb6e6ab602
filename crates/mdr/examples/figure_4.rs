//! Figure 4 of the paper from its scene file: where the contact jumps, and how much energy it loses.

use mdr::answer::Dissipation;
use mdr::prelude::*;

#[allow(clippy::print_stdout)] // what an example is for
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Scene::open(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes/figure-4.toml"))?;
    let answer = scene.solve()?;
    let path = answer.path().ok_or("the scene wants a path")?;
    for event in path.events.items.iter().filter(|event| event.event == EventKind::Jump) {
        if let (Some(from), Some(to), Some(Dissipation::Finite(lost))) =
            (&event.contact_radius, &event.to_contact_radius, &event.dissipated)
        {
            println!("a jumps from {from} m to {to} m and loses {lost} J");
        }
    }
    Ok(())
}
