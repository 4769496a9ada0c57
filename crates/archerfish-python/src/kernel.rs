//! One shape for the core's slice functions of one, two and three numbers.

use archerfish::batch::{BinaryBatch, TernaryBatch, UnaryBatch, holds_nan};

/// Most inputs a kernel takes.
pub const MAX_INPUTS: usize = 3;

/// A slice function of the core, by its number of inputs.
#[derive(Clone, Copy)]
pub enum Kernel {
    Unary(UnaryBatch),
    Binary(BinaryBatch),
    Ternary(TernaryBatch),
}

impl Kernel {
    /// How many inputs it takes.
    pub fn inputs(self) -> usize {
        match self {
            Kernel::Unary(_) => 1,
            Kernel::Binary(_) => 2,
            Kernel::Ternary(_) => 3,
        }
    }

    /// Fills `out` from the first [`inputs`](Kernel::inputs) slices of `x`, and says whether a NaN
    /// was born: an output is NaN where no input is.
    pub fn fill(self, x: [&[f64]; MAX_INPUTS], out: &mut [f64]) -> bool {
        match self {
            Kernel::Unary(function) => function(x[0], out),
            Kernel::Binary(function) => function(x[0], x[1], out),
            Kernel::Ternary(function) => function(x[0], x[1], x[2], out),
        }
        // The second pass, over the inputs too, only where the first, cheap one found something.
        holds_nan(out) && (0..out.len()).any(|i| out[i].is_nan() && !self.any_nan(x, i))
    }

    fn any_nan(self, x: [&[f64]; MAX_INPUTS], i: usize) -> bool {
        x[..self.inputs()].iter().any(|input| input[i].is_nan())
    }
}
