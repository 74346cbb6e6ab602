//! How far a long computation is, on standard error where that is a terminal that can take a line back.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressFinish, ProgressStyle};

use crate::table::is_dumb;

/// A bar that fills up, with the current task and its duration.
pub(crate) fn bar(total: usize) -> ProgressBar {
    styled(ProgressBar::new(total as u64), "{bar:40.green} {pos} of {len}  {elapsed} / {duration}  {msg}")
}

/// A spinner, for work of unknown length.
pub(crate) fn spinner(what: &'static str) -> ProgressBar {
    let spinner = styled(ProgressBar::new_spinner(), "{spinner} {msg} {elapsed}").with_message(what);
    spinner.enable_steady_tick(Duration::from_millis(200));
    spinner
}

/// A bar that leaves nothing behind, even if its task fails.
fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    if is_dumb() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    let bar = bar.with_finish(ProgressFinish::AndClear);
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
