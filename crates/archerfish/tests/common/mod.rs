//! The tables of exact values in `reference/tables`, which the Python tests read too.

use std::fs;
use std::path::Path;

/// One row: the arguments, the nearest double, what is left of the exact value in ulp, and the ulp.
pub struct Row {
    pub arguments: Vec<f64>,
    pub value: f64,
    pub rest: f64,
    pub ulp: f64,
}

impl Row {
    /// The error of a computed value in ulp; infinite where only one of the two is special.
    pub fn error(&self, got: f64) -> f64 {
        if got == self.value || (got.is_nan() && self.value.is_nan()) {
            self.rest.abs()
        } else if !got.is_finite() || !self.value.is_finite() {
            f64::INFINITY
        } else {
            ((got - self.value) / self.ulp - self.rest).abs()
        }
    }
}

/// All rows of the table of a function.
pub fn table(name: &str) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../reference/tables")
        .join(format!("{name}.csv"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let columns = lines.next().expect("a line of column names").split(',').count();
    lines
        .map(|line| {
            let numbers: Vec<f64> = line.split(',').map(number).collect();
            assert_eq!(numbers.len(), columns, "{name}: {line}");
            let (arguments, answer) = numbers.split_at(columns - 3);
            Row { arguments: arguments.to_vec(), value: answer[0], rest: answer[1], ulp: answer[2] }
        })
        .collect()
}

/// A double in decimal, or in hexadecimal as `-0x1.8p-3`, `inf` and `nan` among them.
fn number(text: &str) -> f64 {
    let (sign, size) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text),
    };
    let Some(digits) = size.strip_prefix("0x") else {
        return sign * size.parse::<f64>().unwrap_or_else(|_| panic!("not a number: {text}"));
    };
    let (mantissa, exponent) = digits.split_once('p').expect("an exponent");
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let bits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("hexadecimal digits");
    let power = exponent.parse::<i32>().expect("an exponent") - 4 * fraction.len() as i32;
    // Two factors, each a power of two in range, so that the product is exact down to subnormals.
    let half = power / 2;
    sign * (bits as f64 * 2f64.powi(half)) * 2f64.powi(power - half)
}

#[test]
fn numbers_are_read_exactly() {
    assert_eq!(number("0x1.8p+1"), 3.0);
    assert_eq!(number("-0x1.0000000000001p+0"), -1.0 - f64::EPSILON);
    assert_eq!(number("0x0.0000000000001p-1022"), 5e-324);
    assert_eq!(number("0x1.fffffffffffffp+1023"), f64::MAX);
    assert_eq!(number("-inf"), f64::NEG_INFINITY);
    assert!(number("nan").is_nan());
    assert!(number("-0x0.0p+0").is_sign_negative());
}
