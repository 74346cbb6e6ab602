//! The tables to copy: the files of docs/reference, and that other languages read them.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs};

use mdr_reference::{Table, TableFormat};

fn jkr_sphere() -> Table {
    Table::named("jkr-sphere").unwrap()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference")
}

/// The output of a program; `None` if it is not installed.
fn run(program: &str, arguments: &[&str]) -> Option<Output> {
    Command::new(program).args(arguments).output().ok()
}

/// `MDR_RENEW=1 cargo test -p mdr-reference --test tables` writes them anew.
#[test]
fn the_files_are_what_is_written() {
    for (format, extension) in TableFormat::ALL {
        let file = folder().join(format!("jkr-sphere.{extension}"));
        let written = jkr_sphere().write(format);
        if env::var_os("MDR_RENEW").is_some() {
            fs::write(&file, &written).unwrap();
        }
        assert_eq!(fs::read_to_string(&file).unwrap(), written, "{}", file.display());
    }
}

/// The rows obey the equations of JKR, within their tolerance: a²/R − √(2πaw/E*) = d, 2E*(ad − a³/(3R)) = F.
#[test]
fn the_rows_are_states_of_a_sphere() {
    let table = jkr_sphere();
    let header = table.header();
    let (mut numbers, mut past) = (0, 0);
    for row in table.rows() {
        let cell = |name: &str| row[header.iter().position(|known| *known == name).unwrap()].as_str();
        let number = |name: &str| cell(name).parse::<f64>().unwrap();
        let (radius, e_star, w) = (number("radius"), number("e_star"), number("work_of_adhesion"));
        if cell("status") == "no-equilibrium" {
            past += 1;
            assert_eq!((cell("contact_radius"), cell("branch"), cell("maugis_contact_radius")), ("", "", ""));
            continue;
        }
        numbers += 1;
        let (a, d, force) = (number("contact_radius"), number("indentation"), number("force"));
        let (pressed, stretched) = (a / radius * a, (2.0 * std::f64::consts::PI * (a / e_star) * w).sqrt());
        let size = pressed.max(stretched);
        let near = |x: f64, y: f64, size: f64| ((x - y) / size).abs() < number("tolerance").max(1e-14);
        assert!(near(pressed - stretched, d, size), "{}", row[0]);
        assert!(near(2.0 * e_star * a * (d - pressed / 3.0), force, 2.0 * e_star * a * size), "{}", row[0]);
        // The unit of a force is πwR, and d = a² − √(8a/3) in the units of Maugis.
        let force_unit = std::f64::consts::PI * w * radius;
        assert!(near(number("maugis_force"), force / force_unit, number("maugis_force").abs() * 1e3), "{}", row[0]);
        let a = number("maugis_contact_radius");
        let (pressed, stretched) = (a * a, (8.0 * a / 3.0).sqrt());
        assert!(
            ((pressed - stretched - number("maugis_indentation")) / pressed.max(stretched)).abs() < 1e-11,
            "{}",
            row[0]
        );
    }
    assert_eq!((numbers, past), (36, 7));
}

/// As C and as C++ with all warnings, where there are compilers.
#[test]
fn a_compiler_takes_the_header() {
    let source = env::temp_dir().join(format!("mdr-table-{}.c", std::process::id()));
    let program = format!(
        "#include \"{}\"\nint main(void) {{ return sizeof mdr_jkr_sphere_rows / sizeof *mdr_jkr_sphere_rows != \
         MDR_JKR_SPHERE_ROWS || mdr_jkr_sphere_rows[0].force != {}; }}\n",
        folder().join("jkr-sphere.h").display(),
        mdr_reference::record("critical/jkr-unit/force/force").unwrap().nearest()
    );
    fs::write(&source, program).unwrap();
    let (text, binary) = (source.display().to_string(), source.with_extension("").display().to_string());
    let warnings = ["-Wall", "-Wextra", "-Werror", "-pedantic"];
    for (compiler, language) in [("cc", ["-std=c99", "-xc"]), ("c++", ["-std=c++11", "-xc++"])] {
        let arguments = [&language[..], &warnings, &[&text, "-o", &binary]].concat();
        let Some(compiled) = run(compiler, &arguments) else { continue };
        assert!(compiled.status.success(), "{compiler}: {}", String::from_utf8_lossy(&compiled.stderr));
        assert!(Command::new(&binary).status().unwrap().success(), "{compiler}: the program found other values");
        fs::remove_file(&binary).unwrap();
    }
    fs::remove_file(&source).unwrap();
}

/// The module is imported, and holds what the JSON file and the CSV file hold.
#[test]
fn python_takes_the_files() {
    let folder = folder().display().to_string();
    let program = r##"
import csv, json, runpy, sys
rows = runpy.run_path(sys.argv[1] + "/jkr-sphere.py")["JKR_SPHERE"]
document = json.load(open(sys.argv[1] + "/jkr-sphere.json"))
lines = [line for line in open(sys.argv[1] + "/jkr-sphere.csv") if not line.startswith("#")]
cells = list(csv.reader(lines))
assert rows == document["rows"], "json"
assert [name.split(" ")[0] for name in cells[0]] == list(rows[0]), "header"
for row, cell in zip(rows, cells[1:], strict=True):
    for value, text in zip(row.values(), cell, strict=True):
        assert (text == "") if value is None else (value == type(value)(text)), (value, text)
"##;
    if let Some(output) = run("python3", &["-c", program, &folder]) {
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

/// The module is compiled with all warnings and holds what the CSV file holds, where there is a compiler.
#[test]
fn fortran_takes_the_module() {
    let scratch = env::temp_dir().join(format!("mdr-table-f90-{}", std::process::id()));
    fs::create_dir_all(&scratch).unwrap();
    let (main, binary) = (scratch.join("main.f90"), scratch.join("main"));
    let program = "program main\n  use mdr_jkr_sphere\n  implicit none\n  integer :: i\n  do i = 1, rows\n    print '(a, 3es25.16e3)', \
                   trim(id(i)), force(i), tolerance(i), contact_radius(i)\n  end do\nend program main\n";
    fs::write(&main, program).unwrap();
    let [module, main, out] = [&folder().join("jkr-sphere.f90"), &main, &binary].map(|path| path.display().to_string());
    let folder = scratch.display().to_string();
    let flags = ["-std=f2008", "-Wall", "-Wextra", "-Werror", "-J", &folder, &module, &main, "-o", &out];
    if let Some(compiled) = run("gfortran", &flags) {
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        let printed = String::from_utf8(Command::new(&binary).output().unwrap().stdout).unwrap();
        let (table, header) = (jkr_sphere(), jkr_sphere().header());
        let place = |name: &str| header.iter().position(|known| *known == name).unwrap();
        let mut count = 0;
        for (line, row) in printed.lines().zip(table.rows()) {
            let cells: Vec<&str> = line.split_whitespace().collect();
            assert_eq!(cells[0], row[place("id")]);
            for (cell, name) in [(cells[1], "force"), (cells[2], "tolerance"), (cells[3], "contact_radius")] {
                let own = &row[place(name)];
                assert!(
                    if own.is_empty() { cell == "NaN" } else { cell.parse::<f64>().unwrap() == own.parse().unwrap() },
                    "{line}"
                );
            }
            count += 1;
        }
        assert_eq!(count, table.rows().count());
    }
    fs::remove_dir_all(&scratch).unwrap();
}

/// Where there is no Julia: every row is a tuple of the columns, no line is longer than Fortran reads, and nothing is interpolated.
#[test]
fn julia_and_fortran_have_every_row() {
    let table = jkr_sphere();
    let julia = table.write(TableFormat::Julia);
    let rows: Vec<&str> = julia.lines().filter(|line| line.starts_with("    (")).collect();
    assert_eq!(rows.len(), table.rows().count());
    for (line, row) in rows.iter().zip(table.rows()) {
        for (name, cell) in table.header().into_iter().zip(row) {
            let value = if cell.is_empty() { "NaN".to_owned() } else { cell };
            let given = [format!("{name} = {value}"), format!("{name} = \"{value}\""), format!("{name} = \"\"")];
            assert!(given.iter().any(|given| line.contains(given)), "{name}: {line}");
        }
        assert!(!line.replace("\\$", "").contains('$'), "{line}");
    }
    assert!(table.write(TableFormat::Fortran).lines().all(|line| line.chars().count() <= 132));
    if let Some(output) = run(
        "julia",
        &[
            "-e",
            "include(ARGS[1]); @assert length(JKR_SPHERE) == 43",
            &folder().join("jkr-sphere.jl").display().to_string(),
        ],
    ) {
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}
