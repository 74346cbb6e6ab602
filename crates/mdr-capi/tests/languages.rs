//! The library from other languages: programs are compiled, linked with it and run, where there is a compiler. Those for which there
//! is none are said to be skipped; a build machine without `cc` has no Rust either.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Where cargo has put the libraries of this build.
fn libraries() -> PathBuf {
    let program = std::env::current_exe().expect("a path");
    program.parent().expect("a folder").to_owned()
}

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn there_is(compiler: &str) -> bool {
    let found = Command::new(compiler).arg("--version").output().is_ok_and(|output| output.status.success());
    if !found {
        eprintln!("skipped: there is no {compiler}");
    }
    found
}

/// Compiles a program with the arguments, runs it, and returns what it has printed.
fn run(compiler: &str, name: &str, arguments: &[&str]) -> String {
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let folder = libraries();
    let built = Command::new(compiler)
        .args(arguments)
        .arg(format!("-I{}", file("include").display()))
        .arg(format!("-L{}", folder.display()))
        .arg(format!("-Wl,-rpath,{}", folder.display()))
        .args(["-lmdr_c", "-lm", "-pthread", "-o"])
        .arg(&program)
        .output()
        .expect("the compiler starts");
    assert!(built.status.success(), "{compiler}: {}", String::from_utf8_lossy(&built.stderr));
    let ran = Command::new(&program).output().expect("the program starts");
    let printed = String::from_utf8_lossy(&ran.stdout).into_owned();
    assert!(ran.status.success(), "{name}: {printed}{}", String::from_utf8_lossy(&ran.stderr));
    printed
}

const STRICT: [&str; 4] = ["-Wall", "-Wextra", "-pedantic", "-Werror"];

fn path(name: &str) -> String {
    file(name).display().to_string()
}

#[test]
fn each_function_from_c() {
    if there_is("cc") {
        let source = path("tests/border.c");
        let printed = run("cc", "border-c", &[&["-std=c99", &source][..], &STRICT].concat());
        assert!(printed.contains(" 0 failed"), "{printed}");
        let printed = run("cc", "states-c", &[&["-std=c99", &path("examples/states.c")][..], &STRICT].concat());
        assert!(printed.contains("no-equilibrium"), "{printed}");
    }
}

#[test]
fn each_function_from_cpp() {
    if there_is("c++") {
        let source = path("tests/border.c");
        run("c++", "border-cpp", &[&["-std=c++11", "-x", "c++", &source, "-x", "none"][..], &STRICT].concat());
        let printed = run("c++", "states-cpp", &[&["-std=c++17", &path("examples/states.cpp")][..], &STRICT].concat());
        assert!(printed.contains("breaks at the pull-off force of JKR: yes"), "{printed}");
    }
}

/// A program with the static library needs no file of this build when it runs.
#[test]
fn the_static_library_from_c() {
    let archive = libraries().join("libmdr_c.a");
    if there_is("cc") {
        assert!(archive.is_file(), "{} is not built", archive.display());
        let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("border-static");
        let built = Command::new("cc")
            .arg(path("tests/border.c"))
            .arg(format!("-I{}", path("include")))
            .arg(&archive)
            .args(["-lm", "-pthread", "-ldl", "-o"])
            .arg(&program)
            .output()
            .expect("the compiler starts");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        assert!(Command::new(&program).status().expect("the program starts").success());
    }
}

#[test]
fn states_from_fortran() {
    if there_is("gfortran") {
        run("gfortran", "states-fortran", &["-std=f2008", &path("examples/states.f90")]);
    }
}

#[test]
fn states_from_julia() {
    if there_is("julia") {
        let library =
            libraries().join(format!("{}mdr_c{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX));
        let ran = Command::new("julia").arg(path("examples/states.jl")).arg(library).output().expect("julia starts");
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    }
}

/// What the header declares is what the library has, no more and no less.
#[test]
fn the_header_declares_each_function_and_no_other() {
    let header = std::fs::read_to_string(file("include/mdr.h")).expect("the header");
    let code: String = header.split("/*").map(|part| part.split_once("*/").map_or(part, |(_, code)| code)).collect();
    let mut declared: Vec<&str> = code.split('(').filter_map(|before| before.rsplit([' ', '*', '\n']).next()).collect();
    declared.retain(|name| name.starts_with("mdr_"));
    declared.sort_unstable();
    let mut exported = Vec::new();
    for source in ["src/lib.rs", "src/scene.rs", "src/contact.rs"] {
        let text = std::fs::read_to_string(file(source)).expect("a source");
        let names = text.split("extern \"C\" fn ").skip(1).filter_map(|rest| rest.split('(').next());
        exported.extend(names.map(str::to_owned));
    }
    exported.sort_unstable();
    assert_eq!(declared, exported);
    assert!(exported.len() > 15);
}
