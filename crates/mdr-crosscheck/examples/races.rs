//! This workspace beside other projects, as ratios: `MDR_PYTHON=… cargo run --release -p mdr-crosscheck --example races`.
#![allow(clippy::print_stdout, reason = "an example prints")]

use mdr_crosscheck::contest::speed::races;
use mdr_crosscheck::contest::{Clock, Effort};

fn main() {
    let effort = if std::env::args().any(|argument| argument == "--quick") { Effort::Quick } else { Effort::Full };
    let (races, omissions) = races(effort, &Clock::Runs(9));
    for race in races {
        let (ours, theirs) = (&race.ours, &race.theirs);
        println!("{}", race.question);
        for side in [ours, theirs] {
            println!("    {:40} {:11.3e} s  {:?}", side.name, side.time.median, side.outcome);
        }
        println!("    {:.2} times faster, aim {}", race.ratio(), race.aim);
    }
    omissions.iter().for_each(|sentence| println!("{sentence}"));
}
