//! Prints answers to scene files.
fn main() {
    for file in std::env::args().skip(1) {
        match mdr::Scene::open(&file).and_then(|scene| scene.solve()) {
            Ok(answer) => println!("{file}: {}", answer.to_json()),
            Err(error) => println!("{file}: error: {error}"),
        }
    }
}
