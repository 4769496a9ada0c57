//! Derivatives of the launch angle by the elevation: equation (18) and the one after.
//!
//! Method: `θ′ = P/Q` with `P = G + cos²α a` and `Q = cos²α + G² sin²α`, both positive sums;
//! `P′ = cos α p` and `Q′ = cos α w` with, for b = ε(1 − σ)²/2 (so that dG/dα = cos α b ρ),
//!
//! - `p = b [ρ + cos²α (1/(1 + σ) − (2 − σ) ρ)] − 2 sin α a`,
//! - `w = 2 sin α [sin α G b ρ − (1 − G²)]`,
//!
//! and `d²α/dθ² = −θ″/θ′³ = cos α (w P − p Q) Q / P³`.

use super::launch::{Launch, within_domain};
use super::locus::launch_at_elevation;
use crate::real::double_double::DoubleDouble;

const ONE: DoubleDouble = DoubleDouble { hi: 1.0, lo: 0.0 };

impl Launch {
    /// `P`, positive; dθ/dα is P/Q
    #[inline(always)]
    fn slope(&self) -> DoubleDouble {
        self.drag.gain().add(self.cos.square().mul(self.drag.a))
    }

    /// `dα/dθ`
    #[inline(always)]
    pub fn launch_angle_d1(&self) -> DoubleDouble {
        self.stretch().div(self.slope())
    }

    /// `d²α/dθ²`
    #[inline(always)]
    pub fn launch_angle_d2(&self) -> DoubleDouble {
        let drag = &self.drag;
        let (gain, rho) = (drag.gain(), drag.rho);
        let b = drag.sigma_rest.square().scale(0.5).mul_double(self.epsilon);
        let bend = ONE.div(drag.sigma_plus_one()).sub(drag.sigma_rest.add_double(1.0).mul(rho));
        let p = b.mul(rho.add(self.cos.square().mul(bend))).sub(self.sin.mul(drag.a).scale(2.0));
        let one_less_gain = ONE.sub(gain).mul(gain.add_double(1.0));
        let w = self.sin.scale(2.0).mul(self.sin.mul(gain).mul(b).mul(rho).sub(one_less_gain));
        let (slope, stretch) = (self.slope(), self.stretch());
        let difference = w.mul(slope).sub(p.mul(stretch));
        self.cos.mul(difference).mul(stretch).div(slope.square().mul(slope))
    }
}

/// First derivative of the launch angle by the elevation, dα/dθ.  [Eq. 18]
///
/// 2 at θ = 0 for every drag; between 1/2 and 2 without drag.
#[inline(always)]
pub fn locus_launch_angle_d1(theta: f64, eps: f64) -> f64 {
    within_domain(theta, eps, launch_at_elevation(theta, eps).launch.launch_angle_d1().round())
}

/// Second derivative of the launch angle by the elevation, d²α/dθ².
///
/// −8ε/3 at θ = 0, 0 at θ = π/2.
#[inline(always)]
pub fn locus_launch_angle_d2(theta: f64, eps: f64) -> f64 {
    within_domain(theta, eps, launch_at_elevation(theta, eps).launch.launch_angle_d2().round())
}
