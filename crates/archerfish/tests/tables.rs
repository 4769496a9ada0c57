//! Every public function against the exact values of `reference/tables`.

mod common;

use archerfish::{batch, real};
use common::{Row, table};

/// The errors demanded, in ulp: of a function of one number, and of a shot.
const ONE_NUMBER: f64 = 1.0;
const MOTION: f64 = 2.0;

/// Compares a whole table with the values computed for its rows.
fn compare(name: &str, bound: f64, evaluate: impl Fn(&[Row]) -> Vec<f64>) {
    let rows = table(name);
    let values = evaluate(&rows);
    let mut compared = 0;
    for (row, &got) in rows.iter().zip(&values) {
        let error = row.error(got);
        assert!(
            error <= bound,
            "{name}{:?}: got {got:e}, exact {:e}, {error} ulp",
            row.arguments,
            row.value
        );
        compared += 1;
    }
    assert_eq!(compared, rows.len(), "{name}: rows compared against rows in the file");
    assert!(compared > 200, "{name}: only {compared} rows");
}

fn argument(rows: &[Row], index: usize) -> Vec<f64> {
    rows.iter().map(|row| row.arguments[index]).collect()
}

fn unary(name: &str, function: fn(f64) -> f64) {
    compare(name, ONE_NUMBER, |rows| argument(rows, 0).into_iter().map(function).collect());
}

#[test]
fn real_functions() {
    unary("exp", real::exp);
    unary("ln", real::ln);
    unary("ln_1p", real::ln_1p);
    unary("exp_m1", real::exp_m1);
    unary("sin", |x| real::sin_cos(x).0);
    unary("cos", |x| real::sin_cos(x).1);
    unary("tan", real::tan);
    unary("atan", real::atan);
    compare("atan2", ONE_NUMBER, |rows| {
        rows.iter().map(|row| real::atan2(row.arguments[0], row.arguments[1])).collect()
    });
}

#[test]
fn functions_of_one_number() {
    assert_eq!(batch::UNARY.len(), 7);
    for (name, function) in batch::UNARY {
        compare(name, ONE_NUMBER, |rows| {
            let mut out = vec![0.0; rows.len()];
            function(&argument(rows, 0), &mut out);
            out
        });
    }
}

#[test]
fn functions_of_two_numbers() {
    assert_eq!(batch::BINARY.len(), 14);
    for (name, function) in batch::BINARY {
        compare(name, MOTION, |rows| {
            let mut out = vec![0.0; rows.len()];
            function(&argument(rows, 0), &argument(rows, 1), &mut out);
            out
        });
    }
}

#[test]
fn functions_of_three_numbers() {
    assert_eq!(batch::TERNARY.len(), 5);
    for (name, function) in batch::TERNARY {
        compare(name, MOTION, |rows| {
            let mut out = vec![0.0; rows.len()];
            function(&argument(rows, 0), &argument(rows, 1), &argument(rows, 2), &mut out);
            out
        });
    }
}
