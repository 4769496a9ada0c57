//! All functions once more, from the same files, for processors with a fused multiply-add.
//!
//! Only the exact error of a product uses it (`real/double_double.rs`), so the bits are the same. A
//! function cannot ask which instructions it is compiled for, but it can be compiled twice.

// what no batch needs, as `tan`, and files of two modules, on purpose
#![allow(dead_code, unused_imports, clippy::duplicate_mod)]

pub(crate) use crate::{Integer, Mask, Number, Single, constant};

pub(crate) const FUSED: bool = true;

#[path = "flight/mod.rs"]
pub mod flight;
#[path = "lambert/mod.rs"]
pub mod lambert;
#[path = "motion/mod.rs"]
pub mod motion;
#[path = "real/mod.rs"]
pub mod real;

#[cfg(test)]
mod tests {
    use crate::batch::{BINARY, TERNARY, UNARY};

    /// Arguments in and out of every domain, the ends of the range among them.
    struct Arguments(u64);

    impl Arguments {
        fn bits(&mut self) -> u64 {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            self.0 ^ (self.0 >> 29)
        }

        fn next(&mut self) -> f64 {
            let unit = (self.bits() >> 11) as f64 / 9007199254740992.0;
            match self.bits() % 8 {
                0 => 3.2 * unit,
                1 => 2.0 * unit - 1.0,
                2 => (40.0 * unit - 20.0).exp(),
                3 => -0.3678794411714423 + (-40.0 * unit).exp(),
                4 => [0.0, -0.0, f64::INFINITY, f64::NAN, 5e-324, 1e300, 1e-300, -1.0]
                    [(self.bits() % 8) as usize],
                5 => core::f64::consts::FRAC_PI_2 * (1.0 + (-60.0 * unit).exp()),
                6 => (690.0 * (2.0 * unit - 1.0)).exp(),
                _ => f64::from_bits(self.bits() >> 1).min(1e300),
            }
        }
    }

    macro_rules! compare {
        ($($module:ident::$name:ident($($x:ident),+);)+) => {{
            let mut names = Vec::new();
            $(
                let mut arguments = Arguments(1);
                for _ in 0..if cfg!(miri) { 5 } else { 100_000 } {
                    $(let $x = arguments.next();)+
                    let plain = crate::$module::$name($($x),+);
                    let fused = crate::fused::$module::$name($($x),+);
                    assert!(
                        plain.to_bits() == fused.to_bits() || (plain.is_nan() && fused.is_nan()),
                        "{}{:?}: {plain:e}, fused {fused:e}", stringify!($name), ($($x,)+)
                    );
                }
                names.push(stringify!($name));
            )+
            names
        }};
    }

    #[test]
    fn fused_instructions_change_no_bit() {
        let names = compare! {
            lambert::lambertw0(z);
            lambert::lambertwm1(z);
            lambert::lambertw0_offset(d);
            lambert::lambertwm1_offset(d);
            lambert::tree(z);
            real::log1pmx(x);
            flight::optimal_angle(eps);
            motion::apex_x(alpha, eps);
            motion::apex_y(alpha, eps);
            motion::apex_time(alpha, eps);
            motion::apex_distance(alpha, eps);
            motion::apex_elevation(alpha, eps);
            motion::apex_curvature(alpha, eps);
            motion::locus_launch_angle(theta, eps);
            motion::locus_launch_angle_d1(theta, eps);
            motion::locus_launch_angle_d2(theta, eps);
            motion::locus_radius(theta, eps);
            motion::locus_curvature(theta, eps);
            flight::flight_time(alpha, eps);
            flight::flight_range(alpha, eps);
            flight::envelope_height(x, eps);
            flight::flight_x(t, alpha, eps);
            flight::flight_y(t, alpha, eps);
            flight::trajectory_height(x, alpha, eps);
            flight::aim_low(x, y, eps);
            flight::aim_high(x, y, eps);
        };
        let tables = UNARY.iter().map(|entry| entry.0);
        let tables = tables.chain(BINARY.iter().map(|entry| entry.0));
        assert_eq!(names, tables.chain(TERNARY.iter().map(|entry| entry.0)).collect::<Vec<_>>());
    }

    /// Each part gives bit for bit what stands in its place of `joint`.
    fn are_parts_of<const N: usize>(
        joint: fn(f64, f64) -> [f64; N],
        parts: [fn(f64, f64) -> f64; N],
    ) {
        let mut arguments = Arguments(2);
        for _ in 0..if cfg!(miri) { 5 } else { 100_000 } {
            let (angle, eps) = (arguments.next(), arguments.next());
            for (value, part) in joint(angle, eps).into_iter().zip(parts) {
                let alone = part(angle, eps);
                assert!(
                    value.to_bits() == alone.to_bits() || (value.is_nan() && alone.is_nan()),
                    "({angle:e}, {eps:e}): {value:e}, alone {alone:e}"
                );
            }
        }
    }

    #[test]
    fn functions_computed_together_are_those_alone() {
        use crate::motion::*;
        are_parts_of(
            |alpha, eps| apex(alpha, eps).into(),
            [apex_x, apex_y, apex_elevation, apex_curvature],
        );
        are_parts_of(
            |theta, eps| locus_launch_angle_derivatives(theta, eps).into(),
            [locus_launch_angle_d1, locus_launch_angle_d2],
        );
    }
}
