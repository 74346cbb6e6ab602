//! What comes in by any door is bounded, what is said of it is short and printable, and what goes out is checked.

#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::root;

/// An empty folder for one test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("doors").join(name);
    drop(std::fs::remove_dir_all(&folder));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// A script in that folder, in which `$MDR` is the program; with at most 1.5 GB of memory and two minutes.
fn sh(folder: &Path, script: &str) -> Output {
    let bounded = format!("ulimit -v 1500000; mdr() {{ timeout 120 \"$MDR\" \"$@\"; }}; {script}");
    let mut command = Command::new("sh");
    command.arg("-c").arg(bounded).env("MDR", env!("CARGO_BIN_EXE_mdr")).current_dir(folder);
    command.output().unwrap()
}

/// Standard error, which is short, printable and a refusal.
fn refusal(folder: &Path, script: &str) -> String {
    let output = sh(folder, script);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{script}: {said}");
    assert!(said.starts_with("error: ") && !said.contains("panicked"), "{script}: {said}");
    assert!(said.len() < 1500 && !said.contains(|c: char| c.is_control() && c != '\n'), "{script}: {said:?}");
    said
}

fn refused(folder: &Path, script: &str, parts: &[&str]) {
    let said = refusal(folder, script);
    for part in parts {
        assert!(said.contains(part), "{script} should say {part:?}: {said}");
    }
}

const CONE: &str = r#"{"kind":"cone","slope":1}"#;

fn scene(profile: &str) -> String {
    let material = r#""material":{"e_star":1,"work_of_adhesion":1e-4}"#;
    format!(r#"{{"profile":{profile},{material},"output":{{"want":["folds"],"arithmetic":"f64"}}}}"#)
}

fn sums(count: usize) -> String {
    format!("{}{CONE}{}", r#"{"kind":"sum","term":["#.repeat(count), "]}".repeat(count))
}

#[test]
fn nesting_is_refused_at_a_stated_depth() {
    let folder = folder("depth");
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    write("flat.json", &scene(&sums(25)));
    assert!(sh(&folder, "mdr solve flat.json").status.success());
    let (open, close) = ("[".repeat(100_000), "]".repeat(100_000));
    let mut inline = "1".to_owned();
    for _ in 0..70 {
        inline = format!("{{{}={inline}}}", ["a"; 70].join("."));
    }
    let files = [
        ("sums.json", scene(&sums(3000))),
        ("brackets.json", format!("{open}{close}")),
        ("unclosed.json", open.clone()),
        ("objects.json", r#"{"a":"#.repeat(100_000)),
        ("value.json", format!(r#"{{"profile":{open}{close}}}"#)),
        ("mixed.toml", format!("x={inline}")),
    ];
    for (name, text) in files {
        write(name, &text);
        for script in [&format!("mdr solve {name}"), &format!("mdr fit {name}")] {
            refused(&folder, script, &["nested deeper than 64"]);
        }
        refused(&folder, &format!("mdr solve - < {name}"), &["<stdin>:1: not "]);
    }
    for (name, text) in
        [("list.toml", format!("x={open}{close}")), ("dots.toml", format!("{}=1", vec!["a"; 50_000].join(".")))]
    {
        write(name, &text);
        refused(&folder, &format!("mdr solve {name}"), &["not TOML"]);
    }
    for formula in ["-".repeat(100_000) + "r", "(".repeat(100_000), ["2"; 1500].join("^"), "sqrt(".repeat(300) + "r"] {
        write("formula.json", &scene(&format!(r#"{{"kind":"expression","formula":"{formula}"}}"#)));
        refused(&folder, "mdr solve formula.json", &["profile.formula: column "]);
    }
    // A line of answers, and of questions, that is no answer or question leaves the others alone.
    write("lines.jsonl", &format!("{open}{close}\n{{\"id\":{open}{close}}}\n{{\"n\":{open}{close}}}\n"));
    let judged = sh(&folder, "mdr judge lines.jsonl");
    assert_eq!(judged.status.code(), Some(1));
    assert!(judged.stdout.len() < 3000 && judged.stderr.is_empty());
    write("batch.jsonl", &format!("{{\"n\":{open}{close}}}\n{{\"n\":2,\"c\":1,\"e_star\":1,\"work\":1}}\n"));
    let asked = sh(&folder, "mdr critical --f64 --batch batch.jsonl");
    assert_eq!((asked.status.code(), asked.stdout.iter().filter(|byte| **byte == b'\n').count()), (Some(1), 2));
    refused(&folder, "mdr verify --merge lines.jsonl", &["line 1 is no line of a verification"]);
}

#[test]
fn devices_and_pipes_are_bounded() {
    let folder = folder("devices");
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    assert!(Command::new("mkfifo").arg(folder.join("fifo")).status().unwrap().success());
    for (file, why) in [("/dev/zero", "a device or a pipe"), ("fifo", "a device or a pipe"), (".", "a folder")] {
        let table = format!(
            "[profile]\nkind = \"table\"\nfile = \"{file}\"\n[output]\nwant = [\"transform\"]\ntransform.at = [1]\n"
        );
        write("scene.toml", &table);
        refused(&folder, "mdr solve scene.toml", &["scene.toml:3: profile.file: ", why]);
        refused(&folder, "mdr solve - < scene.toml", &["profile.file: ", why]);
        write(
            "fit.toml",
            &format!("[profile]\nkind = \"sphere\"\nradius = 1\n[data]\nobservation = \"F(d)\"\nfile = \"{file}\"\n"),
        );
        refused(&folder, "mdr fit fit.toml", &["fit.toml:6: data.file: ", why]);
    }
    let tip = root().join("examples/fits/tip.toml").display().to_string();
    for command in ["solve", "fit", "judge", "critical --batch", "verify --merge", &format!("fit {tip}")] {
        refused(
            &folder,
            &format!("mdr {command} /dev/zero"),
            &["/dev/zero"].map(|name| if command == "judge" { "256 MiB" } else { name }),
        );
    }
    let curve = root().join("examples/fits/tip.csv").display().to_string();
    let piped = sh(&folder, &format!("cat {curve} | mdr fit {tip} /dev/stdin --format csv"));
    assert!(piped.status.success(), "{}", String::from_utf8_lossy(&piped.stderr));
    write("scene.json", &scene(CONE));
    for script in ["cat scene.json | mdr solve /dev/stdin", "cat scene.json > fifo & mdr solve fifo"] {
        assert!(sh(&folder, script).status.success(), "{script}");
    }
    let twice = sh(&folder, &format!("cat {tip} | mdr fit /dev/stdin {curve} {curve} --format csv"));
    assert_eq!(String::from_utf8_lossy(&twice.stdout).lines().count(), 1 + 2 * 4);
    std::fs::rename(folder.join("fifo"), folder.join("fifo.csv")).unwrap();
    refused(&folder, &format!("mdr fit {tip} --batch ."), &["--batch: no regular file"]);
}

#[test]
fn lists_and_tables_have_a_stated_length() {
    let folder = folder("lists");
    let list = |count: usize| (0..count).map(|i| (i % 7).to_string()).collect::<Vec<_>>().join(",");
    let outputs = |control: &str, output: &str| {
        format!(
            "[profile]\nkind = \"cone\"\nslope = 1\n[material]\ne_star = 1\nwork_of_adhesion = 1e-4\n[control]\nkind = \"indentation\"\n{control}\n[output]\narithmetic = \"f64\"\n{output}\n"
        )
    };
    let refuse = |text: &str, parts: &[&str]| {
        std::fs::write(folder.join("long.toml"), text).unwrap();
        refused(&folder, "mdr solve long.toml", parts);
    };
    let path = format!("path = [{}]", list(100_000));
    refuse(
        &outputs(&path, "want = [\"path\"]"),
        &["long.toml:9: control.path: a list of 100000 entries; at most 10000 are"],
    );
    let at = |count| format!("want = [\"curve\"]\ncurve.at = [{}]", list(count));
    refuse(&outputs("", &at(100_001)), &["output.curve.at: a list of 100001 entries; at most 100000 are"]);
    let fields = format!("want = [\"pressure\"]\nequilibria.at = [{}]\npressure.at = [{}]", list(101), list(1000));
    refuse(&outputs("", &fields), &["output.want: `pressure` would have 101000 rows; at most 100000"]);
    refuse(
        &outputs("path = [0, 1]", "want = [\"force-curve\"]\npoints = 100001"),
        &["output.points: must be a whole number from 2"],
    );
    let rows: String = (0..200_000).map(|i| format!("{i},{i}\n")).collect();
    std::fs::write(folder.join("rows.csv"), format!("r,f\n{rows}")).unwrap();
    let table =
        "[profile]\nkind = \"table\"\nfile = \"rows.csv\"\n[output]\nwant = [\"transform\"]\ntransform.at = [1]\n";
    refuse(table, &["profile.file: rows.csv: 200000 rows; at most 100000 are read"]);
}

#[test]
fn messages_repeat_little_and_nothing_that_steers_a_terminal() {
    let folder = folder("echo");
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    let rest = "[output]\nwant = [\"transform\"]\ntransform.at = [1]\n";
    let strange =
        ["\\u001b[31m\\u0007".to_owned(), "7".repeat(90_000), "z".repeat(1_000_000), "\\u202e\\r\\n".repeat(1000)];
    for text in &strange {
        for scene in [
            format!("[profile]\nkind = \"{text}\"\n{rest}"),
            format!("[profile]\nkind = \"sphere\"\n\"{text}\" = 1\nradius = 1\n{rest}"),
            format!("[\"{text}\"]\na = 1\n[profile]\nkind = \"sphere\"\nradius = 1\n{rest}"),
            format!("[profile]\nkind = \"sphere\"\nradius = \"-{text}\"\n{rest}"),
            format!("[profile]\nkind = \"table\"\nfile = \"{text}\"\n{rest}"),
            format!("[profile]\nkind = \"expression\"\nformula = \"r*x{text}\"\n{rest}"),
            format!("[profile]\nkind = \"expression\"\nformula = \"x{text}(r)\"\n{rest}"),
            format!("[profile]\nkind = \"expression\"\nformula = \"r\"\nparameters = {{ \"{text}\" = 1 }}\n{rest}"),
            format!("[profile]\nkind = \"sphere\"\nradius = 1\n[output]\nwant = [\"{text}\"]\n"),
        ] {
            write("scene.toml", &scene);
            refusal(&folder, "mdr solve scene.toml");
        }
    }
    let raw = ["\u{1b}[31m\u{7}", &"7".repeat(900_000), &"z".repeat(900_000)];
    for text in raw {
        for csv in [
            format!("r,{text}\n1,2\n"),
            format!("r,f\nm,{text}\n1,2\n"),
            format!("r,f\n1,2\n{text}q,3\n"),
            format!("r,f\n-{text},2\n"),
        ] {
            write("rows.csv", &csv);
            write("scene.toml", &format!("[profile]\nkind = \"table\"\nfile = \"rows.csv\"\n{rest}"));
            refusal(&folder, "mdr solve scene.toml");
            refusal(&folder, &format!("mdr fit {} rows.csv", root().join("examples/fits/tip.toml").display()));
        }
        write("batch.csv", &format!("n,{text}\n1,2\n"));
        refusal(&folder, "mdr critical --batch batch.csv");
        write("batch.csv", &format!("n,c,e_star,work\n2,{text},1,1\n2,1,{text},1\n"));
        let answers = sh(&folder, "mdr critical --batch batch.csv").stdout;
        assert!(answers.len() < 2000 && !answers.contains(&0x1b), "{}", String::from_utf8_lossy(&answers));
        write("batch.jsonl", &format!("{{\"{text}\":1}}\n\"{text}\"\n{{\"n\":\"{text}\"}}\n"));
        let answers = sh(&folder, "mdr critical --batch batch.jsonl").stdout;
        assert!(answers.len() < 2000 && !answers.contains(&0x1b), "{}", String::from_utf8_lossy(&answers));
        write("merge.jsonl", &format!("{{\"schema\":\"{text}\"}}\n"));
        refusal(&folder, "mdr verify --merge merge.jsonl");
    }
    for argument in [
        "\u{1b}[31m\u{7}".to_owned(),
        "--\u{1b}]0;x\u{7}".to_owned(),
        "q".repeat(100_000),
        format!("--{}", "q".repeat(100_000)),
    ] {
        for command in [
            "",
            "solve",
            "fit",
            "judge",
            "derive",
            "critical --n",
            "critical --format",
            "fit x --digits",
            "reference --filter",
            "figures --theme",
            "solve x --units",
        ] {
            let mut line = std::process::Command::new(env!("CARGO_BIN_EXE_mdr"));
            let output = line.args(command.split_whitespace()).arg(&argument).current_dir(&folder).output().unwrap();
            let said = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(2), "{command} {argument:.20}: {said:.300}");
            assert!(said.len() < 1500 && !said.contains(['\u{1b}', '\u{7}']), "{command}: {said:?}");
        }
    }
}

/// What is written is named in messages as it is, but for what steers a terminal.
#[cfg(unix)]
#[test]
fn names_of_files_steer_no_terminal() {
    let folder = folder("names");
    let strange = "a\u{1b}[31m\u{7}b";
    let scene = root().join("examples/scenes/paraboloid.toml");
    let fit = std::fs::read_to_string(root().join("examples/fits/tip.toml")).unwrap();
    std::fs::copy(&scene, folder.join(format!("{strange}.toml"))).unwrap();
    std::fs::write(folder.join(format!("fit{strange}.toml")), fit).unwrap();
    for (curve, file) in [("one", "tip.csv"), ("two", "tip.csv")] {
        std::fs::copy(root().join("examples/fits").join(file), folder.join(format!("{curve}{strange}.csv"))).unwrap();
    }
    for (arguments, is_fine) in [
        (vec!["solve", "S.toml", "--out", "S", "--digits", "6"], true),
        (vec!["solve", "S.toml", "--plot", "S.svg", "--digits", "6"], true),
        (vec!["solve", "S.toml", "--plot", "S.txt"], false),
        (vec!["solve", "S.toml", "--certificate", "S/S/S"], false),
        (vec!["solve", "S.tom"], false),
        (vec!["reference", "--export", "S.csv"], true),
        (vec!["reference", "--export", "S"], false),
        (vec!["reference", "--data-sets", "S"], true),
        (vec!["reference", "--table", "jkr-sphere", "--export", "S.h"], true),
        (vec!["judge", "S"], false),
        (vec!["cite", "S"], false),
        (vec!["cite", "S.toml"], false),
        (vec!["verify", "--merge", "S"], false),
        (vec!["critical", "--batch", "S"], false),
        (vec!["fit", "fitS.toml", "oneS.csv", "twoS.csv"], true),
        (vec!["fit", "fitS.toml", "--batch", "S/no"], false),
    ] {
        let line: Vec<String> = arguments.iter().map(|word| word.replace('S', strange)).collect();
        let output =
            std::process::Command::new(env!("CARGO_BIN_EXE_mdr")).args(&line).current_dir(&folder).output().unwrap();
        for said in [&output.stdout, &output.stderr] {
            let said = String::from_utf8_lossy(said);
            assert!(!said.contains(['\u{1b}', '\u{7}']), "{line:?}: {said:?}");
        }
        assert_eq!(output.status.success(), is_fine, "{line:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
    let svg = std::fs::read_to_string(folder.join(format!("{strange}.svg"))).unwrap();
    assert!(svg.contains("[31m") && !svg.contains(['\u{1b}', '\u{7}']), "no XML holds such characters");
}

#[test]
fn line_numbers_do_not_depend_on_marks_and_line_ends() {
    let folder = folder("lines");
    let bad =
        "# made\n\n[profile]\nkind = \"sphere\"\nradius = -1\n[output]\nwant = [\"transform\"]\ntransform.at = [1]\n";
    let json = "{\n\"profile\": {\"kind\": \"sphere\",\n\"radius\": -1},\n\"output\": {\"want\": [\"transform\"], \"transform\": {\"at\": [1]}}}";
    let rows = "# made\n\nr,f\n# rows\n0,0\n\n1,1\n2,x\n3,9\n";
    let data = "# made\n\nposition,deflection,leg\nnm,nm,\n# rows\n1,1,retract\n\n2,x,retract\n";
    let table =
        "[profile]\nkind = \"table\"\nfile = \"rows.csv\"\n[output]\nwant = [\"transform\"]\ntransform.at = [1]\n";
    std::fs::write(folder.join("table.toml"), table).unwrap();
    let tip = root().join("examples/fits/tip.toml").display().to_string();
    for mark in ["", "\u{feff}"] {
        for end in ["\n", "\r\n"] {
            let write = |name: &str, text: &str| {
                std::fs::write(folder.join(name), format!("{mark}{}", text.replace('\n', end))).unwrap();
            };
            write("bad.toml", bad);
            write("bad.json", json);
            write("rows.csv", rows);
            write("data.csv", data);
            refused(&folder, "mdr solve bad.toml", &["bad.toml:5: profile.radius"]);
            refused(&folder, "mdr solve - < bad.toml", &["<stdin>:5: profile.radius"]);
            refused(&folder, "mdr solve bad.json", &["bad.json:3: profile.radius"]);
            refused(&folder, "mdr solve table.toml", &["line 8, column f"]);
            refused(&folder, &format!("mdr fit {tip} data.csv"), &["line 8: `x` in the column `deflection`"]);
        }
    }
}

#[test]
fn a_bad_curve_ends_with_status_two() {
    let folder = folder("curve");
    let tip = root().join("examples/fits/tip.toml").display().to_string();
    for format in ["table", "json", "csv"] {
        refused(&folder, &format!("mdr fit {tip} no-such.csv --format {format}"), &["error: no-such.csv: "]);
        let good = tip.replace(".toml", ".csv");
        refused(&folder, &format!("mdr fit {tip} {good} no-such.csv --format {format}"), &["1 of 2", "no-such.csv"]);
    }
}

#[test]
fn what_cannot_be_written_is_said() {
    let folder = folder("full");
    std::fs::write(folder.join("scene.json"), scene(CONE)).unwrap();
    std::fs::write(folder.join("batch.csv"), "n,c,e_star,work\n2,1,1,1\n").unwrap();
    std::fs::write(folder.join("batch.jsonl"), "{\"n\":2,\"c\":1,\"e_star\":1,\"work\":1}\n").unwrap();
    std::fs::write(folder.join("answers.jsonl"), "").unwrap();
    for command in [
        "--help",
        "--version",
        "help",
        "solve --help",
        "completions bash",
        "completions zsh",
        "man",
        "reference",
        "solve scene.json",
        "solve scene.json --format json",
        "solve scene.json --format csv",
        "judge answers.jsonl",
        "critical --f64 --batch batch.csv",
        "critical --f64 --batch batch.jsonl",
        "reference --table",
        "derive 1.4",
    ] {
        refused(&folder, &format!("mdr {command} > /dev/full"), &["error: standard output: "]);
        // A reader that has seen enough is no failure.
        let early = sh(&folder, &format!("mdr {command} | true"));
        assert!(early.stderr.is_empty(), "{command}: {}", String::from_utf8_lossy(&early.stderr));
    }
}

#[test]
fn files_are_there_as_a_whole_or_not_at_all() {
    let folder = folder("whole");
    let text = scene(CONE).replace("[\"folds\"]", "[\"curve\"]");
    std::fs::write(folder.join("scene.json"), text).unwrap();
    let names = || {
        let mut names: Vec<_> = std::fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    };
    // Files of at most one block: what does not fit is refused as by a full disk.
    let small = "trap '' XFSZ; ulimit -f 1;";
    refused(&folder, &format!("{small} mdr solve scene.json --out ."), &["--out ./curve.csv: "]);
    refused(&folder, &format!("{small} mdr reference --export all.csv"), &["--export all.csv: "]);
    refused(
        &folder,
        &format!("{small} mdr solve scene.json --plot picture.svg > /dev/null"),
        &["--plot picture.svg: "],
    );
    assert_eq!(names(), ["scene.json"]);
    // What was there stays.
    std::fs::write(folder.join("all.csv"), "before").unwrap();
    refused(&folder, &format!("{small} mdr reference --export all.csv"), &["--export all.csv: "]);
    assert_eq!(std::fs::read_to_string(folder.join("all.csv")).unwrap(), "before");
    // A link stays one, and what it leads to is replaced.
    std::os::unix::fs::symlink("all.csv", folder.join("link.csv")).unwrap();
    assert!(sh(&folder, "mdr reference --export link.csv --filter control=machine").status.success());
    assert!(folder.join("link.csv").is_symlink());
    assert!(std::fs::read_to_string(folder.join("all.csv")).unwrap().starts_with("id,"));
    // Before anything is computed, since nothing is printed.
    for plot in ["no/such/picture.svg", "scene.json/picture.svg"] {
        let script = format!("mdr solve scene.json --plot {plot}");
        refused(&folder, &script, &[&format!("--plot {plot}: ")]);
        assert!(sh(&folder, &script).stdout.is_empty());
    }
    refused(&folder, "mdr solve scene.json --out scene.json", &["--out scene.json: "]);
    assert_eq!(names(), ["all.csv", "link.csv", "scene.json"]);
}
