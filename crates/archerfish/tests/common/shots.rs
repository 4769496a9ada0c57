//! Arguments of shots, for properties.

use core::f64::consts::FRAC_PI_2;
use proptest::prelude::*;

/// A few units in the last place, for relations between values that are each rounded.
pub const ULPS: f64 = 8.0 * f64::EPSILON;

/// Drag parameters, the extreme ones among them.
pub fn drag() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => Just(0.0),
        6 => (-7.0..7.0f64).prop_map(f64::exp2),
        2 => (-1074.0..996.0f64).prop_map(f64::exp2),
    ]
}

/// Launch angles up to the vertical, tiny ones among them.
pub fn rising_angle() -> impl Strategy<Value = f64> {
    prop_oneof![6 => 0.0..=FRAC_PI_2, 1 => (-1074.0..0.0f64).prop_map(f64::exp2)]
}
