//! The real branches of the Lambert W function, the inverse of `w eʷ`.
//!
//! Right to within one unit in the last place everywhere, next to the branch point too. Worst
//! errors: reference/accuracy.toml.
//!
//! Reference: R. M. Corless et al., "On the Lambert W function", Adv. Comput. Math. 5 (1996).

mod branch;
mod lower;
mod principal;
mod start;
mod step;

pub use lower::{lambertwm1, lambertwm1_offset};
pub use principal::{lambertw0, lambertw0_offset, tree};
