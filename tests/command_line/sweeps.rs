//! Arrays of Slurm jobs, with the variables that Slurm sets: shares of the cross-check and of many fits.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{mdr, root};

/// Runs a script as one task of an array.
fn task(folder: &Path, script: &str, number: u32, of: u32, arguments: &[String]) {
    let mut command = Command::new("sh");
    command.arg(root().join("examples/sweeps").join(script)).args(arguments).current_dir(folder);
    command.env("MDR", env!("CARGO_BIN_EXE_mdr")).env("ARGS", "--quick --only jkr");
    command.env("SLURM_ARRAY_TASK_ID", number.to_string()).env("SLURM_ARRAY_TASK_COUNT", of.to_string());
    let done = command.output().unwrap();
    assert!(done.status.success(), "{script}: {}", String::from_utf8_lossy(&done.stderr));
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
#[cfg(unix)]
fn shares_of_fits_are_all_fits() {
    let folder = folder("sweep-fits");
    std::fs::create_dir_all(folder.join("curves")).unwrap();
    let curve = root().join("examples/fits/tip.csv");
    for name in ["a", "b", "c"] {
        std::fs::copy(&curve, folder.join("curves").join(name).with_extension("csv")).unwrap();
    }
    let fit = root().join("examples/fits/tip.toml").display().to_string();
    let mut files = Vec::new();
    for number in 1..=2 {
        task(&folder, "fits.slurm", number, 2, &[fit.clone(), "curves/*.csv".to_owned()]);
        let table = std::fs::read_to_string(folder.join(format!("fits-{number}.csv"))).unwrap();
        let name = |line: &str| line.split(',').next().unwrap().to_owned();
        files.extend(table.lines().skip(1).map(name));
    }
    files.sort();
    files.dedup();
    assert_eq!(files, ["curves/a.csv", "curves/b.csv", "curves/c.csv"]);
}

#[test]
#[cfg(unix)]
fn shares_of_the_cross_check_are_all_of_it() {
    let folder = folder("sweep-verify");
    let result = |number: u32| folder.join(format!("verify-{number}.jsonl")).display().to_string();
    for number in 1..=2 {
        task(&folder, "verify.slurm", number, 2, &[]);
    }
    mdr(&format!("verify --merge {} {}", result(1), result(2))).assert().success();
    // One share is not all.
    mdr(&format!("verify --merge {}", result(1))).assert().failure();
}
