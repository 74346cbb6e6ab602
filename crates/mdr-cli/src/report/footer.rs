//! Where and with what a report was made.

use serde::{Deserialize, Serialize};

/// A machine and the program on it.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Machine {
    /// The model of the processor, where the system tells.
    processor: Option<String>,
    /// Threads that run at once.
    threads: usize,
    /// Operating system and instruction set.
    system: String,
    /// The version of this program.
    version: String,
    /// Whether it was compiled for speed.
    optimised: bool,
    /// What `rustc --version` says of the compiler.
    #[serde(default)]
    compiler: String,
    /// The FNV-1a hash of the Cargo.lock with which it was built, where there was one.
    lock: Option<String>,
}

impl Machine {
    /// This one.
    pub(super) fn here() -> Self {
        Machine {
            processor: std::fs::read_to_string("/proc/cpuinfo").ok().as_deref().and_then(model),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            system: format!("{}, {}", std::env::consts::OS, std::env::consts::ARCH),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            optimised: !cfg!(debug_assertions),
            compiler: env!("MDR_COMPILER").to_owned(),
            lock: option_env!("MDR_LOCK").map(str::to_owned),
        }
    }

    /// As a sentence or two.
    pub(super) fn told(&self) -> String {
        let processor = self.processor.as_deref().unwrap_or("a processor whose model the system does not tell");
        let threads = if self.threads == 1 { "1 thread".to_owned() } else { format!("{} threads", self.threads) };
        let build = if self.optimised { "optimised" } else { "not optimised: do not compare its times" };
        let lock = match &self.lock {
            Some(hash) => format!("Cargo.lock has the FNV-1a hash {hash}"),
            None => "there was no Cargo.lock".to_owned(),
        };
        let Machine { system, version, compiler, .. } = self;
        format!("Machine: {processor}; {threads}; {system}. Program: mdr {version}, {build}; {compiler}; {lock}.")
    }
}

/// The model in the text of /proc/cpuinfo.
fn model(text: &str) -> Option<String> {
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_model_of_the_processor() {
        assert_eq!(model("processor\t: 0\nmodel name\t: Abacus 3000\n").as_deref(), Some("Abacus 3000"));
        assert_eq!(model("Hardware : unknown"), None);
    }
}
