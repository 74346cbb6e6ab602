//! What is private in `mdr_cli::table`.

use super::*;

#[test]
fn a_table_that_is_too_wide_has_one_cell_a_line() {
    let mut wide = table(&["radius, m", "force, N", "why"]);
    wide.add_row(["0.1234567890123456789", "-1", ""]).add_row(["2", "", "none"]);
    let tall = " radius, m  0.1234567890123456789\n force, N   -1\n\n radius, m  2\n why        none";
    assert_eq!(render_whole(wide.set_width(30)), tall);
    assert_eq!(render_whole(wide.set_width(80)).lines().count(), 3);
}
