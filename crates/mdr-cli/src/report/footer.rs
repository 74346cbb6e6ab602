//! The machine and the build with which a report was made.

/// The machine and the program, in a sentence or two.
pub(super) fn machine() -> String {
    let processor = std::fs::read_to_string("/proc/cpuinfo").ok().as_deref().and_then(model);
    let processor = processor.unwrap_or_else(|| "a processor whose model the system does not tell".to_owned());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "not optimised: do not compare its times" } else { "optimised" };
    let lock = option_env!("MDR_LOCK").unwrap_or("unknown");
    format!(
        "Machine: {processor}; hardware threads: {threads}; {}, {}. Program: mdr {}, {build}; {}; FNV-1a hash of Cargo.lock: \
         {lock}.",
        std::env::consts::OS,
        std::env::consts::ARCH,
        env!("CARGO_PKG_VERSION"),
        env!("MDR_COMPILER"),
    )
}

/// The model in the text of /proc/cpuinfo.
fn model(text: &str) -> Option<String> {
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

#[cfg(test)]
#[path = "../../tests/private/footer.rs"]
mod tests;
