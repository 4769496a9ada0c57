//! Evaluates one function of the crate on doubles from standard input: the reference's way in.
//!
//! `evaluate NAME`: arguments as little-endian f64 (a function of several takes them in turn), values likewise on
//! standard output, bit for bit.

use archerfish::{batch, real};
use std::io::{Read, Write, stdin, stdout};

type Unary = fn(f64) -> f64;
type Binary = fn(f64, f64) -> f64;

/// The functions of [`real`] that are not ufuncs.
const REAL_UNARY: &[(&str, Unary)] = &[
    ("exp", real::exp),
    ("ln", real::ln),
    ("ln_1p", real::ln_1p),
    ("exp_m1", real::exp_m1),
    ("sin", |x| real::sin_cos(x).0),
    ("cos", |x| real::sin_cos(x).1),
    ("tan", real::tan),
    ("atan", real::atan),
];
const REAL_BINARY: &[(&str, Binary)] = &[("atan2", real::atan2)];

fn find<F: Copy>(table: &[(&str, F)], name: &str) -> Option<F> {
    table.iter().find(|row| row.0 == name).map(|row| row.1)
}

fn evaluate(name: &str, arguments: &[f64]) -> Option<Vec<f64>> {
    if let Some(function) = find(REAL_UNARY, name) {
        return Some(arguments.iter().map(|&x| function(x)).collect());
    }
    if let Some(function) = find(batch::UNARY, name) {
        let mut out = vec![0.0; arguments.len()];
        function(arguments, &mut out);
        return Some(out);
    }
    let (first, second): (Vec<f64>, Vec<f64>) =
        arguments.chunks_exact(2).map(|pair| (pair[0], pair[1])).unzip();
    if let Some(function) = find(REAL_BINARY, name) {
        return Some(first.iter().zip(&second).map(|(&a, &b)| function(a, b)).collect());
    }
    if let Some(function) = find(batch::BINARY, name) {
        let mut out = vec![0.0; first.len()];
        function(&first, &second, &mut out);
        return Some(out);
    }
    let function = find(batch::TERNARY, name)?;
    let column = |k| arguments.chunks_exact(3).map(|row| row[k]).collect::<Vec<f64>>();
    let mut out = vec![0.0; arguments.len() / 3];
    function(&column(0), &column(1), &column(2), &mut out);
    Some(out)
}

fn main() -> std::io::Result<()> {
    let name = std::env::args().nth(1).unwrap_or_default();
    let mut bytes = Vec::new();
    stdin().read_to_end(&mut bytes)?;
    let arguments: Vec<f64> =
        bytes.chunks_exact(8).map(|chunk| f64::from_le_bytes(chunk.try_into().unwrap())).collect();
    let Some(values) = evaluate(&name, &arguments) else {
        eprintln!("no function is named {name:?}");
        std::process::exit(2);
    };
    let out: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    stdout().write_all(&out)
}
