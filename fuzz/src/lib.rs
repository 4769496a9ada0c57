//! What the targets share: doubles from the fuzzer's bytes, and the law every kernel obeys.

use archerfish::batch::{BINARY, TERNARY, UNARY};

/// The doubles in the bytes, bit for bit.
pub fn doubles(bytes: &[u8]) -> Vec<f64> {
    bytes.chunks_exact(8).map(|chunk| f64::from_le_bytes(chunk.try_into().unwrap())).collect()
}

/// Two columns, from every other double.
pub fn pairs(bytes: &[u8]) -> (Vec<f64>, Vec<f64>) {
    doubles(bytes).chunks_exact(2).map(|pair| (pair[0], pair[1])).unzip()
}

/// A function of one number over a slice, by name: an element's value depends on nothing else.
pub fn unary(name: &str, x: &[f64]) -> Vec<f64> {
    let function = UNARY.iter().find(|row| row.0 == name).unwrap().1;
    let mut out = vec![0.0; x.len()];
    function(x, &mut out);
    for i in 0..x.len() {
        let mut alone = [0.0];
        function(&x[i..=i], &mut alone);
        assert_same(name, &[x[i]], out[i], alone[0]);
    }
    out
}

/// A function of two numbers over slices, by name.
pub fn binary(name: &str, x: &[f64], y: &[f64]) -> Vec<f64> {
    let function = BINARY.iter().find(|row| row.0 == name).unwrap().1;
    let mut out = vec![0.0; x.len()];
    function(x, y, &mut out);
    for i in 0..x.len() {
        let mut alone = [0.0];
        function(&x[i..=i], &y[i..=i], &mut alone);
        assert_same(name, &[x[i], y[i]], out[i], alone[0]);
    }
    out
}

/// A function of three numbers over slices, by name.
pub fn ternary(name: &str, x: &[f64], y: &[f64], z: &[f64]) -> Vec<f64> {
    let function = TERNARY.iter().find(|row| row.0 == name).unwrap().1;
    let mut out = vec![0.0; x.len()];
    function(x, y, z, &mut out);
    for i in 0..x.len() {
        let mut alone = [0.0];
        function(&x[i..=i], &y[i..=i], &z[i..=i], &mut alone);
        assert_same(name, &[x[i], y[i], z[i]], out[i], alone[0]);
    }
    out
}

fn assert_same(name: &str, at: &[f64], among: f64, alone: f64) {
    let same = among.to_bits() == alone.to_bits() || (among.is_nan() && alone.is_nan());
    assert!(same, "{name} at {at:?}: {among:?} among others, {alone:?} alone");
}

/// NaN outside the domain, and nowhere else.
pub fn assert_domain(name: &str, at: &[f64], inside: bool, value: f64) {
    assert_eq!(inside, !value.is_nan(), "{name} at {at:?} is {value:?}");
}
