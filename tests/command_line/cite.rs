//! What to cite, and the files that tell archives the same.

use serde_json::Value;

use crate::{mdr, output, raw, root};

fn json(arguments: &str) -> Value {
    serde_json::from_str(&output(arguments)).unwrap()
}

/// The answer of a command, in a file of its own.
fn answer(name: &str, command: &str) -> String {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cite-{name}.json"));
    std::fs::write(&file, output(command)).unwrap();
    file.display().to_string()
}

#[test]
fn program_records_and_theory() {
    let text = output("cite");
    for part in
        [&format!("version {}", env!("CARGO_PKG_VERSION")), "release 4", "V. L. Popov", "No DOI is assigned yet"]
    {
        assert!(text.contains(part), "{part} in {text}");
    }
    let cited = json("cite --format json");
    assert_eq!(cited["schema"], "mdr.cite/1");
    assert_eq!(cited["program"]["doi"], Value::Null);
    assert_eq!(cited["works"].as_array().unwrap().len(), 1);
    let newest = mdr_reference::records().iter().map(|record| record.release).max().unwrap();
    assert_eq!(cited["records"]["release"], newest);
}

/// The program that gave an answer need not be the one that is asked.
#[test]
fn an_answer_names_its_program() {
    let file = answer("other", "critical --cone 70 --e-star 5e9 --work 0.05 --format json");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replacen('{', "{\"program\":\"mdr 0.0.9 (0123456789ab)\",", 1)).unwrap();
    assert!(
        raw(&format!("cite {file}"))
            .contains("Answer: mdr.critical/1, certified, 20 digits, by mdr 0.0.9 (0123456789ab).")
    );
    assert!(raw(&format!("cite {file} --format json")).contains("\"program\":\"mdr 0.0.9 (0123456789ab)\""));
}

#[test]
fn an_answer_asks_for_the_sources_of_its_profile() {
    let sphere = answer("sphere", "critical --sphere 1e-8 --e-star 5e9 --work 0.05 --digits 30 --format json");
    let cited = json(&format!("cite {sphere} --format json"));
    let said = &cited["answers"][0];
    assert_eq!(
        (&said["schema"], &said["arithmetic"], &said["digits"]),
        (&"mdr.critical/1".into(), &"certified".into(), &30.into())
    );
    let keys =
        |cited: &Value| cited["works"].as_array().unwrap().iter().map(|work| work["key"].clone()).collect::<Vec<_>>();
    assert_eq!(keys(&cited), ["Popov", "JKR1971"]);
    let cone = answer("cone", "critical --cone 70 --e-star 5e9 --work 0.05 --format json");
    assert_eq!(keys(&json(&format!("cite {cone} --format json"))), ["Popov"]);
    let short =
        answer("short", "critical --sphere 1e-8 --e-star 5e9 --work 0.05 --range-of-adhesion 0.3nm --format json");
    assert_eq!(keys(&json(&format!("cite {short} --format json"))), ["Popov", "JKR1971", "Maugis1992"]);
    let waves = root().join("examples/scenes/figure-4.toml").display().to_string();
    let waves = answer("waves", &format!("solve {waves} --f64 --format json"));
    let bibtex = output(&format!("cite {waves} --format bibtex"));
    assert!(
        bibtex.contains("@article{Guduru2007,") && bibtex.contains("release 4") && !bibtex.contains("JKR1971"),
        "{bibtex}"
    );
    assert_eq!(bibtex.matches('{').count(), bibtex.matches('}').count());
}

/// Many lines that say the same are one answer; records have no schema, and say their release.
#[test]
fn many_answers_are_cited_once() {
    let law = output("critical --n 1,2,3 --c 1 --e-star 1 --work 1 --format json");
    assert_eq!(law.lines().count(), 3);
    let law = answer("laws", "critical --n 1,2,3 --c 1 --e-star 1 --work 1 --format json");
    assert_eq!(json(&format!("cite {law} --format json"))["answers"].as_array().unwrap().len(), 1);
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("cite-records.jsonl").display().to_string();
    output(&format!("reference --filter profile=sphere --export {file}"));
    assert!(output(&format!("cite {file}")).contains("record of release "));
}

#[test]
fn what_is_no_answer_is_refused() {
    let table = answer("table", "critical --sphere 1 --e-star 1 --work 1");
    let empty = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("cite-empty.json");
    std::fs::write(&empty, "\n").unwrap();
    let other = empty.with_file_name("cite-other.json");
    std::fs::write(&other, "{\"id\":\"x\"}\n").unwrap();
    let cases = [
        (table, "line 1 is no answer of mdr"),
        (empty.display().to_string(), "there is no answer in it"),
        (other.display().to_string(), "it has no schema"),
        ("/no/such/answer.json".to_owned(), "/no/such/answer.json"),
    ];
    for (file, part) in cases {
        let refused = mdr(&format!("cite {file}")).assert().code(2);
        let said = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(said.starts_with("error: ") && said.contains(part), "{said}");
    }
}

/// Title, version, abstract, keywords and authors are the same everywhere, and what needs a human is blank.
#[test]
fn the_files_for_archives_agree() {
    let read = |name: &str| std::fs::read_to_string(root().join(name)).unwrap();
    let parsed = |name: &str| serde_json::from_str::<Value>(&read(name)).unwrap();
    let (cff, codemeta, zenodo) = (read("CITATION.cff"), parsed("codemeta.json"), parsed(".zenodo.json"));
    let program = &json("cite --format json")["program"];
    let title = program["title"].as_str().unwrap();
    assert!(
        cff.contains(&format!("\ntitle: \"{title}\"\n"))
            && cff.contains(&format!("\nversion: {}\n", env!("CARGO_PKG_VERSION")))
    );
    // The schema of CFF takes identifiers of SPDX, of which a list means a choice, and no expression.
    let licenses = program["license"].as_str().unwrap().replace(" OR ", "\n  - ");
    assert!(cff.contains(&format!("\nlicense:\n  - {licenses}\n")));
    assert_eq!((&codemeta["name"], &zenodo["title"]), (&program["title"], &program["title"]));
    assert_eq!((&codemeta["version"], &zenodo["version"]), (&program["version"], &program["version"]));
    assert_eq!((&codemeta["description"], &codemeta["keywords"]), (&zenodo["description"], &zenodo["keywords"]));
    let (_, abstracted) = cff.split_once("abstract: >-\n").unwrap();
    let abstracted: Vec<_> = abstracted.lines().take_while(|line| line.starts_with("  ")).map(str::trim).collect();
    assert_eq!(codemeta["description"], abstracted.join(" "));
    let keywords: Vec<_> = zenodo["keywords"].as_array().unwrap().iter().map(|word| word.as_str().unwrap()).collect();
    assert!(cff.contains(&format!("keywords: [{}]", keywords.join(", "))));
    assert!(cff.contains(program["authors"][0].as_str().unwrap()));
    assert_eq!(codemeta["author"][0]["name"], program["authors"][0]);
    // Blanks, by name.
    for field in ["identifier", "codeRepository", "datePublished", "maintainer", "funder"] {
        assert_eq!(codemeta[field], "", "{field}");
    }
    for field in ["doi", "publication_date"] {
        assert_eq!(zenodo[field], "", "{field}");
    }
    for field in ["date-released", "doi", "orcid", "repository-code", "url"] {
        assert!(cff.contains(&format!("\n# {field}:\n")), "{field}");
    }
}
