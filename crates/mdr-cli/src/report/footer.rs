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
    /// The FNV-1a hash of Cargo.lock, where the command was given in a folder that has one.
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
            lock: std::fs::read("Cargo.lock").ok().map(|bytes| format!("{:016x}", fnv(&bytes))),
        }
    }

    /// As a sentence or two.
    pub(super) fn told(&self) -> String {
        let processor = self.processor.as_deref().unwrap_or("a processor whose model the system does not tell");
        let threads = if self.threads == 1 { "1 thread".to_owned() } else { format!("{} threads", self.threads) };
        let build = if self.optimised { "optimised" } else { "not optimised: do not compare its times" };
        let lock = match &self.lock {
            Some(hash) => format!("Cargo.lock has the FNV-1a hash {hash}"),
            None => "there was no Cargo.lock in the folder of the command".to_owned(),
        };
        let (system, version, rust) = (&self.system, &self.version, env!("CARGO_PKG_RUST_VERSION"));
        format!(
            "Machine: {processor}; {threads}; {system}. Program: mdr {version}, {build}; built with some rustc of at least \
             {rust}, which the program does not know; {lock}."
        )
    }
}

/// The model in the text of /proc/cpuinfo.
fn model(text: &str) -> Option<String> {
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// FNV-1a (Fowler, Noll & Vo), 64 bits.
fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_its_authors() {
        // Published test vectors.
        assert_eq!(fnv(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn the_model_of_the_processor() {
        assert_eq!(model("processor\t: 0\nmodel name\t: Abacus 3000\n").as_deref(), Some("Abacus 3000"));
        assert_eq!(model("Hardware : unknown"), None);
    }
}
