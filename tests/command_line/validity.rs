//! `range_of_adhesion`: whether the theory holds, of `mdr critical` and `mdr solve`.

use crate::{critical, mdr, number, output, solved, text};

const TIP: &str = "--sphere 1e-8 --e-star 5e9 --work 0.05 --control force";

const SCENE: &str = "[material]\ne_star = 5e9\nwork_of_adhesion = 0.05\nrange_of_adhesion = \"0.3 nm\"\n\
                     [profile]\nkind = \"paraboloid\"\nradius = 1e-8\n[output]\nwant = [\"folds\"]\n";

#[test]
fn a_critical_state_with_a_range() {
    let answer = critical(&format!("{TIP} --range-of-adhesion 0.3nm"));
    let validity = &answer["validity"];
    assert_eq!(text(validity, "tabor"), "0.33333333333333333333");
    assert_eq!(text(validity, "regime"), "transition");
    assert_eq!(answer["promise"]["validity"], "certified");
    let correction = number(&validity["maugis_dugdale_pull_off"]) / number(&validity["jkr_pull_off"]) - 1.0;
    assert!((number(&validity["correction"]) - correction).abs() < 1e-12);
    assert!(critical(TIP).get("validity").is_none(), "without the range nothing changes");

    let in_units = output(&format!("critical {TIP} --range-of-adhesion 3e-10 --f64 --units nm,nN"));
    let range = in_units.lines().find(|line| line.contains("range of adhesion, nm")).unwrap();
    assert!(range.ends_with(" 0.3"), "{range}");
    let table = output(&format!("critical {TIP} --range-of-adhesion 3e-10 --f64"));
    assert!(table.contains("Tabor number") && table.contains("Does the theory hold? Neither limit holds"), "{table}");
    let csv = output(&format!("critical {TIP} --range-of-adhesion 3e-10 --f64 --format csv"));
    assert!(csv.lines().next().unwrap().contains("validity_tabor,validity_regime"), "{csv}");
    let several = output("critical --n 1:2:0.5 --c 1 --e-star 1 --work 1e-4 --range-of-adhesion 1e-3 --f64");
    assert!(several.contains("regime"), "{several}");
}

#[test]
fn a_scene_with_a_range() {
    for (flags, promise) in [("", "certified"), ("--f64", "f64")] {
        let answer = solved(SCENE, flags);
        assert_eq!(answer["promise"]["validity"], promise);
        assert!((number(&answer["validity"]["tabor"]) - 1.0 / 3.0).abs() < 1e-12);
        assert_eq!(answer["validity"]["admissible"], true);
    }
    let table = mdr("solve - --f64").stdin(SCENE).assert().success();
    assert!(String::from_utf8_lossy(&table.get_output().stdout).contains("Maugis-Dugdale pull-off force, N"));
    let csv = mdr("solve - --f64 --format csv").stdin(SCENE).assert().success();
    assert!(String::from_utf8_lossy(&csv.get_output().stdout).contains("\nvalidity,f64,"));
}

#[test]
fn a_bad_range_names_its_flag() {
    for bad in ["0", "-1", "x", "0nm", "3s"] {
        let refused = mdr(&format!("critical {TIP} --range-of-adhesion {bad}")).assert().failure().code(2);
        let message = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
        assert!(message.starts_with("error: ") && message.contains("--range-of-adhesion"), "{message}");
    }
}
