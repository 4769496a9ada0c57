//! Which instruction set: one inlined body, compiled once for each, chosen once at start.

#[cfg(target_arch = "x86_64")]
use std::sync::OnceLock;

/// Instruction sets a kernel is compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Isa {
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

/// The widest instruction set this machine has, or the one `ARCHERFISH_ISA` names.
#[cfg(target_arch = "x86_64")]
pub(crate) fn isa() -> Isa {
    static ISA: OnceLock<Isa> = OnceLock::new();
    *ISA.get_or_init(|| choose(std::env::var("ARCHERFISH_ISA").ok().as_deref()))
}

#[cfg(target_arch = "x86_64")]
fn choose(wanted: Option<&str>) -> Isa {
    let fused = is_x86_feature_detected!("fma");
    let avx512 = fused
        && is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512vl");
    let avx2 = fused && is_x86_feature_detected!("avx2");
    match wanted {
        Some("baseline") => Isa::Baseline,
        Some("avx2") if avx2 => Isa::Avx2,
        _ if avx512 => Isa::Avx512,
        _ if avx2 => Isa::Avx2,
        _ => Isa::Baseline,
    }
}

/// The only one there is.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn isa() -> Isa {
    Isa::Baseline
}

/// Name of the instruction set in use: `baseline`, `avx2` or `avx512`.
pub fn isa_name() -> &'static str {
    match isa() {
        Isa::Baseline => "baseline",
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => "avx2",
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => "avx512",
    }
}

/// Elements computed at once in a browser.
#[cfg(target_arch = "wasm32")]
pub(crate) const BLOCK: usize = 8;

/// Goes through the slices in blocks, the last one padded, and leaves each to `compute`.
///
/// A loop of unknown length would be compiled twice, for pairs of elements and for a last one, and
/// a page has to fetch that.
#[cfg(target_arch = "wasm32")]
#[inline(never)]
pub(crate) fn in_blocks<const INPUTS: usize>(
    inputs: [&[f64]; INPUTS],
    out: &mut [f64],
    compute: fn(&[[f64; BLOCK]; INPUTS], &mut [f64; BLOCK]),
) {
    let mut x = [[0.0; BLOCK]; INPUTS];
    let mut values = [0.0; BLOCK];
    for first in (0..out.len()).step_by(BLOCK) {
        let n = BLOCK.min(out.len() - first);
        for (block, input) in x.iter_mut().zip(inputs) {
            block[..n].copy_from_slice(&input[first..first + n]);
        }
        compute(&x, &mut values);
        out[first..first + n].copy_from_slice(&values[..n]);
    }
}

/// Defines a function that fills one slice with the values of a kernel at others.
macro_rules! each {
    ($name:ident, $kernel:path, $($x:ident),+) => {
        #[inline(always)]
        fn $name($($x: &[f64],)+ out: &mut [f64]) {
            let n = out.len();
            $(let $x = &$x[..n];)+
            for i in 0..n {
                out[i] = $kernel($($x[i]),+);
            }
        }
    };
}
pub(crate) use each;

/// Defines a slice function whose loop body is compiled once per instruction set.
macro_rules! batch {
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident, $($x:ident),+) => {
        $(#[$doc])*
        pub fn $name($($x: &[f64],)+ out: &mut [f64]) {
            #[cfg(not(target_arch = "wasm32"))]
            $crate::dispatch::each!(body, $crate::$module::$kernel, $($x),+);
            #[cfg(target_arch = "x86_64")]
            $crate::dispatch::each!(fused, $crate::fused::$module::$kernel, $($x),+);
            #[cfg(target_arch = "wasm32")]
            fn body($($x: &[f64],)+ out: &mut [f64]) {
                use $crate::dispatch::{BLOCK, in_blocks};
                in_blocks([$($x),+], out, |[$($x),+]: &[[f64; BLOCK]; _], out| {
                    for i in 0..BLOCK {
                        out[i] = $crate::$module::$kernel($($x[i]),+);
                    }
                });
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma")]
            fn avx2($($x: &[f64],)+ out: &mut [f64]) {
                fused($($x,)+ out)
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512dq,avx512vl,fma")]
            fn avx512($($x: &[f64],)+ out: &mut [f64]) {
                fused($($x,)+ out)
            }
            match $crate::dispatch::isa() {
                $crate::dispatch::Isa::Baseline => body($($x,)+ out),
                // SAFETY: `isa` returns a set only after finding it on this machine.
                #[cfg(target_arch = "x86_64")]
                $crate::dispatch::Isa::Avx2 => unsafe { avx2($($x,)+ out) },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                $crate::dispatch::Isa::Avx512 => unsafe { avx512($($x,)+ out) },
            }
        }
    };
}
pub(crate) use batch;
