//! The engine as the page calls it, by its exported functions, without a browser.

use std::f64::consts::PI;

use mdr::columns::ContactColumns;
use mdr::prelude::*;
use mdr::scene;

use mdr_wasm::{
    Failure, advance, advancing_curve, advancing_equilibria, contact, curve, equilibria, input, kappa, message_length,
    pinned, surface, verify,
};

/// Reads the rows of the last answer as the page does: by copying `count` rows from the buffer. Here through `read`, as a
/// test has no view of the memory.
fn rows<const N: usize>(count: i32) -> Vec<[f64; N]> {
    let count = usize::try_from(count).expect("an answer");
    mdr_wasm::read(count * N).as_chunks().0.to_vec()
}

/// Opens a contact with E* = 1 and w = 1/2π, where Δl(a) = √a.
fn opened(profile: &str, control: &str, table: &str) -> i32 {
    let work = PI.recip() / 2.0;
    opened_with(&format!("e_star = 1\nwork_of_adhesion = {work}"), profile, control, table)
}

fn opened_with(material: &str, profile: &str, control: &str, table: &str) -> i32 {
    let scene =
        format!("[material]\n{material}\n[control]\n{control}\n[profile]\n{profile}\n[output]\nwant = [\"folds\"]\n");
    input(scene.len() + table.len());
    mdr_wasm::write(&[scene.as_bytes(), table.as_bytes()].concat());
    contact(scene.len())
}

fn close(x: f64, y: f64, tolerance: f64) {
    assert!((x - y).abs() <= tolerance * y.abs().max(1e-300), "{x} is not {y}");
}

/// The gap of the picture beside that of the library's fields, for the equilibrium with a = 0.6, up to a radius.
fn gaps_of_the_library(scene: &Scene, high: f64) {
    let columns = ContactColumns::new(scene).expect("a contact");
    let d = columns.curve(&[0.6]).expect("a state").indentation[0];
    let rows: Vec<[f64; 3]> = rows(surface(0.6, d, high, 40));
    let beyond: Vec<[f64; 3]> = rows.into_iter().filter(|[r, ..]| *r > 0.62).collect();
    let radii: Vec<f64> = beyond.iter().map(|[r, ..]| *r).collect();
    let known = columns.field(mdr::answer::Field::Gap, 0.6, &radii).expect("gaps");
    assert!(radii.len() > 10);
    let size = known.iter().copied().fold(0.0, f64::max);
    for ([r, _, gap], known) in beyond.iter().zip(known) {
        assert!((gap - known).abs() < 1e-2 * size, "r = {r}: {gap} is not {known}");
    }
}

const SPHERE: &str = "kind = \"paraboloid\"\nradius = 1";
const DEPTH: &str = "kind = \"indentation\"";
const FORCE: &str = "kind = \"force\"";

#[test]
fn a_sphere_comes_off_at_the_fold_and_the_loop_is_the_sum_of_both_losses() {
    let folds: Vec<[f64; 4]> = rows(opened(SPHERE, DEPTH, ""));
    assert_eq!(folds.len(), 1);
    // (1.13): g' = Δl', 2a = 1/(2√a).
    let a = 0.25f64.powf(2.0 / 3.0);
    close(folds[0][0], a, 1e-14);
    close(folds[0][1], a * a - a.sqrt(), 1e-13);
    let off: Vec<[f64; 10]> = rows(advance(1.0, 0.0, -0.6));
    assert_eq!(off.iter().map(|row| row[0]).collect::<Vec<_>>(), [4.0, 10.0]);
    close(off[0][8], a * a / 5.0, 1e-12); // (2/5)πa²w
    let on: Vec<[f64; 10]> = rows(advance(-1.0, -0.6, 0.2));
    assert_eq!(on.iter().map(|row| row[0]).collect::<Vec<_>>(), [2.0, 10.0]);
    close(on[0][8], 0.3, 1e-12);
}

#[test]
fn a_dead_load_pulls_the_sphere_off_at_three_quarters() {
    // −(3/2)πwR with w = 1/2π and R = 1.
    let folds: Vec<[f64; 4]> = rows(opened(SPHERE, FORCE, ""));
    close(folds[0][2], -0.75, 1e-14);
    let off: Vec<[f64; 10]> = rows(advance(1.0, 0.0, -0.8));
    assert_eq!((off[0][0], off[0][8]), (4.0, f64::INFINITY));
}

#[test]
fn three_folds_come_and_go_with_the_stiffness_of_the_machine() {
    let c = 1.82 / kappa(0.65);
    for (stiffness, count) in [(0.03, 1), (0.891, 3), (100.0, 1)] {
        let control = format!("kind = \"machine\"\nstiffness = {stiffness}");
        assert_eq!(opened(&format!("kind = \"power\"\nn = 0.65\nc = {c}"), &control, ""), count, "k = {stiffness}");
    }
}

#[test]
fn waves_make_it_jump_and_both_routes_agree() {
    let folds = opened("kind = \"wavy-paraboloid\"\nradius = 1\namplitude = 0.06816\nwavelength = 1.16754", DEPTH, "");
    assert!(folds > 2);
    let jumps: Vec<[f64; 10]> = rows(advance(1.0, 0.0, -0.4));
    assert_eq!(jumps.iter().map(|row| row[0]).collect::<Vec<_>>(), [3.0, 4.0, 10.0]);
    for a in [0.1, 0.7, 1.3] {
        let [[_, _, difference]] = rows::<3>(verify(a))[..] else { panic!("one row") };
        assert!(difference < 1e-13, "{difference}");
    }
}

#[test]
fn a_table_is_a_profile_like_any_other_and_a_bad_one_is_refused_in_words() {
    let parabola: String = (0..60).map(|i| f64::from(i) / 20.0).map(|r| format!("{r},{}\n", r * r / 2.0)).collect();
    let of_table: Vec<[f64; 4]> = rows(opened("kind = \"table\"\nfile = \"profile.csv\"", DEPTH, &parabola));
    close(of_table[0][0], 0.25f64.powf(2.0 / 3.0), 1e-2);
    assert_eq!(mdr_wasm::outer_radius(), 2.95);
    let refused = opened("kind = \"table\"\nfile = \"profile.csv\"", DEPTH, "0,0\n1,x\n2,3\n3,4\n");
    assert_eq!(refused, Failure::Refused as i32);
    assert!(message_length() > 10);
    assert_eq!(equilibria(-0.2), 2, "the contact that was open stays so");
}

/// w₂ = 1/2π and w₁ = w₂/4, so that Δl₂ = √a and Δl₁ = √a/2.
#[test]
fn between_two_works_of_adhesion_the_edge_is_pinned() {
    let work = PI.recip() / 2.0;
    let material = format!("e_star = 1\nwork_of_adhesion = {{ advancing = {}, receding = {work} }}", work / 4.0);
    let folds: Vec<[f64; 4]> = rows(opened_with(&material, SPHERE, DEPTH, ""));
    assert_eq!(folds.iter().map(|fold| fold[3]).collect::<Vec<_>>(), [0.0, 2.0]);
    close(folds[0][0], 0.25f64.powf(2.0 / 3.0), 1e-13);
    close(folds[1][0], 0.125f64.powf(2.0 / 3.0), 1e-13); // 2a = 1/(4√a)
    for [a, g, elongation, d, ..] in rows::<6>(advancing_curve(0.2, 2.0, 9, 2.0)) {
        close(elongation, a.sqrt() / 2.0, 1e-13);
        close(d, g - elongation, 1e-13);
    }
    let [a, ..] = rows::<4>(advancing_equilibria(0.1))[0];
    close(a * a - a.sqrt() / 2.0, 0.1, 1e-12);
    // Drawn back from there the radius stays, and dF = 2a dd.
    let force = |d: f64| 2.0 * a * (d - a * a / 3.0);
    for [d, found] in rows::<2>(pinned(a, 0.05)) {
        close(d, 0.05, 1e-15);
        close(found, force(0.05), 1e-12);
    }
    let events: Vec<[f64; 10]> = rows(advance(a, 0.1, -0.4));
    assert_eq!(events.iter().map(|row| row[0]).collect::<Vec<_>>(), [11.0, 12.0, 10.0]);
    close(events[1][1], a * a - a.sqrt(), 1e-12);
    // (w₂ − w₁) times the area that the edge has left.
    let [from, to] = [a, events[2][5]];
    close(events[2][9], 0.75 * work * PI * (from * from - to * to), 1e-12);
}

/// A Winkler foundation with K = 1/π and a half-space with E ∝ √z and c = 1: Δl = 1 and a^(1/4).
#[test]
fn springs_and_graded_half_spaces_are_media_like_any_other() {
    let work = PI.recip() / 2.0;
    let on = |medium: &str| opened_with(&format!("work_of_adhesion = {work}\n[medium]\n{medium}"), SPHERE, DEPTH, "");
    assert_eq!(on(&format!("kind = \"winkler\"\nmodulus = {}", PI.recip())), 0);
    for [a, g, elongation, ..] in rows::<6>(curve(0.2, 2.0, 9, 2.0)) {
        close(g, a * a / 2.0, 1e-13);
        close(elongation, 1.0, 1e-13);
    }
    assert_eq!(verify(0.5), Failure::Refused as i32, "(1.1) is that of a half-space");
    assert_eq!(on("kind = \"graded\"\nexponent = 0.5\ncoefficient = 1"), 1);
    for [a, _, elongation, ..] in rows::<6>(curve(0.2, 2.0, 9, 2.0)) {
        close(elongation, a.powf(0.25), 1e-13);
    }
    // The gap is that of the library's fields, here for d = g − Δl at a = 0.8.
    let scene = Scene::new(Shape::Paraboloid { radius: 1.0 }, Elasticity::effective(1).expect("E*"), work);
    let graded = ExactMedium::Graded {
        exponent: "0.5".parse().expect("k"),
        stiffness: Grading::Coefficient("1".parse().expect("c")),
    };
    gaps_of_the_library(&scene.and_then(|scene| scene.medium(graded)).expect("a scene"), 2.0);
}

#[test]
fn a_wave_comes_into_complete_contact_and_ends_at_half_of_its_length() {
    let work = PI.recip() / 2.0;
    let material = format!("e_star = 1\nwork_of_adhesion = {work}\n[medium]\nkind = \"periodic\"\nwavelength = 2");
    assert_eq!(opened_with(&material, "kind = \"wave\"\namplitude = 0.6", FORCE, ""), 2);
    assert_eq!(mdr_wasm::outer_radius(), 1.0);
    let events: Vec<[f64; 10]> = rows(advance(-1.0, -0.1, 2.0));
    assert_eq!(events.iter().map(|row| row[0]).collect::<Vec<_>>(), [2.0, 5.0]);
    assert_eq!(equilibria(2.0), 0, "complete contact is no state of an edge");
    let wave = Scene::new(scene::Profile::Wave("0.6".parse().expect("h")), Elasticity::effective(1).expect("E*"), work);
    let periodic = ExactMedium::Periodic { wavelength: "2".parse().expect("λ"), flaw: None };
    gaps_of_the_library(&wave.and_then(|scene| scene.medium(periodic)).expect("a scene"), 0.999);
    for [r, height, _] in rows::<3>(surface(0.3, 0.0, 1.0, 20)) {
        close(height, 0.6 * (1.0 - (PI * r).cos()), 1e-12);
    }
    assert_eq!(opened(SPHERE, DEPTH, ""), 1);
}

#[test]
fn at_the_threshold_of_one_half_nothing_is_decided() {
    assert_eq!(curve(0.1, 1.0, 5, 1.0), Failure::Empty as i32, "each test has an engine of its own");
    let c = 1.0 / kappa(0.5);
    assert_eq!(opened(&format!("kind = \"power\"\nn = 0.5\nc = {c}"), DEPTH, ""), Failure::Undecided as i32);
}

#[test]
fn stable_states_lie_beyond_the_fold_and_the_surfaces_meet_at_the_edge() {
    opened(SPHERE, DEPTH, "");
    for [a, g, elongation, d, _, stable] in rows::<6>(curve(0.01, 2.0, 50, 2.0)) {
        close(g - elongation, d, 1e-12);
        assert_eq!(stable == 1.0, a > 0.25f64.powf(2.0 / 3.0), "a = {a}");
    }
    // Of a sphere without adhesion the gap is that of Hertz: a = 1, d = 1, gap(r) = r²/2 − 1 + u(r).
    let hertz = |r: f64| (r * r - 2.0) / 2.0 + ((2.0 - r * r) * (1.0 / r).asin() + (r * r - 1.0).sqrt()) / PI;
    for [r, height, gap] in rows::<3>(surface(1.0, 1.0, 2.0, 60)) {
        close(height, r * r / 2.0, 1e-12);
        assert!((gap - if r > 1.0 { hertz(r) } else { 0.0 }).abs() < 1e-4, "r = {r}: {gap}");
    }
}
