#![no_main]

use archerfish_fuzz::{assert_domain, doubles, unary};
use libfuzzer_sys::fuzz_target;

/// The double nearest 1/e, which counts as the branch point.
const INVERSE_E: f64 = 0.36787944117144233;

fuzz_target!(|bytes: &[u8]| {
    let z = doubles(bytes);
    let negated: Vec<f64> = z.iter().map(|z| -z).collect();
    let upper = unary("lambertw0", &z);
    let lower = unary("lambertwm1", &z);
    let upper_offset = unary("lambertw0_offset", &z);
    let lower_offset = unary("lambertwm1_offset", &z);
    let tree = unary("tree", &negated);
    for i in 0..z.len() {
        let z = z[i];
        assert_domain("lambertw0", &[z], z >= -INVERSE_E, upper[i]);
        assert_domain("lambertwm1", &[z], (-INVERSE_E..=0.0).contains(&z), lower[i]);
        assert_domain("lambertw0_offset", &[z], z >= 0.0, upper_offset[i]);
        assert_domain("lambertwm1_offset", &[z], (0.0..=INVERSE_E).contains(&z), lower_offset[i]);
        assert!(!(upper[i] < -1.0 || lower[i] > -1.0), "branches at {z:e}");
        assert!(!(upper_offset[i] < 0.0 || lower_offset[i] > 0.0), "offsets at {z:e}");
        // W eᵂ has the sign of z, and |W| < |z| where W > 0
        assert!(upper[i].is_nan() || (upper[i] < 0.0) == (z < 0.0), "sign at {z:e}");
        assert!(!(upper[i] > z.max(0.0)), "bound at {z:e}");
        assert!(tree[i].is_nan() == upper[i].is_nan(), "tree at {z:e}");
        assert!(tree[i].is_nan() || tree[i] == -upper[i], "tree at {z:e}");
    }
});
