//! What the cross-check costs by the number of its cases, on one thread and on more.

use rayon::ThreadPoolBuilder;

use super::{Arithmetic, Clock, Curve, Diagram, Effort, Outcome, Point, Setup, Task, View};
use crate::{Level, Options, run};

/// The task.
pub(super) const GRID: Task = Task {
    name: "grid",
    claim: "the whole of `mdr verify` over more and more cases of its grid, on one thread and on two",
    diagrams,
};

/// Nothing but time is to be found here: without a clock there is nothing.
fn diagrams(setup: &mut Setup) -> Vec<Diagram> {
    let Setup { effort, clock, .. } = *setup;
    if clock == Clock::Off {
        return Vec::new();
    }
    // Once is enough for runs of seconds.
    let clock = Clock::Runs(1);
    let limits: &[usize] = match effort {
        Effort::Quick => &[1, 3],
        Effort::Full => &[1, 3, 10, 30],
    };
    let curve = |threads: usize| {
        let points = limits.iter().map(|limit| point(*limit, threads, &clock)).collect();
        let name = if threads == 1 { "one thread".to_owned() } else { format!("{threads} threads") };
        Curve::new(name, Arithmetic::Mp, points)
    };
    let omissions = vec!["grid: more than two threads; shards on several machines, which share nothing.".to_owned()];
    vec![Diagram {
        id: "grid".to_owned(),
        task: GRID.name.to_owned(),
        title: "the cross-check: time against cases".to_owned(),
        truth: "none is needed: every case must hold its allowed error".to_owned(),
        view: View::Size,
        ceiling: None,
        shipped: "one thread".to_owned(),
        curves: vec![curve(1), curve(2)],
        omissions,
    }]
}

/// All checks with at most so many cases each.
fn point(limit: usize, threads: usize, clock: &Clock) -> Point {
    let setting = format!("at most {limit} a check");
    let options = Options { limit: Some(limit), ..Options::at(Level::Quick) };
    let pool = match ThreadPoolBuilder::new().num_threads(threads).build() {
        Ok(pool) => pool,
        Err(error) => {
            return Point { setting, outcome: Outcome::Failed(error.to_string()), evaluations: None, time: None };
        }
    };
    let mut last = None;
    let time = clock.time(|| last = Some(pool.install(|| run(&options, &|_| ()))));
    let cases = last.as_ref().map(|report| report.cases() as u64);
    let outcome = match last {
        Some(report) if report.passed() => Outcome::Passed,
        _ => Outcome::Failed("a check failed".to_owned()),
    };
    Point { setting, outcome, evaluations: cases, time }
}
