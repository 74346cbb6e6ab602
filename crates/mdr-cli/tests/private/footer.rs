//! What is private in `mdr_cli::report::footer`.

use super::*;

#[test]
fn the_model_of_the_processor() {
    assert_eq!(model("processor\t: 0\nmodel name\t: Abacus 3000\n").as_deref(), Some("Abacus 3000"));
    assert_eq!(model("Hardware : unknown"), None);
}
