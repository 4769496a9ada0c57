//! Which instruction set: one inlined body, compiled once for each, chosen once at start.

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
pub(crate) fn isa() -> Isa {
    static ISA: OnceLock<Isa> = OnceLock::new();
    *ISA.get_or_init(|| choose(std::env::var("ARCHERFISH_ISA").ok().as_deref()))
}

#[cfg(target_arch = "x86_64")]
fn choose(wanted: Option<&str>) -> Isa {
    let avx512 = is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512vl");
    let avx2 = is_x86_feature_detected!("avx2");
    match wanted {
        Some("baseline") => Isa::Baseline,
        Some("avx2") if avx2 => Isa::Avx2,
        _ if avx512 => Isa::Avx512,
        _ if avx2 => Isa::Avx2,
        _ => Isa::Baseline,
    }
}

#[cfg(not(target_arch = "x86_64"))]
fn choose(_wanted: Option<&str>) -> Isa {
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

/// Defines a slice function whose loop body is compiled once per instruction set.
macro_rules! batch {
    ($(#[$doc:meta])* $name:ident, $kernel:path, $($x:ident),+) => {
        $(#[$doc])*
        pub fn $name($($x: &[f64],)+ out: &mut [f64]) {
            #[inline(always)]
            fn body($($x: &[f64],)+ out: &mut [f64]) {
                let n = out.len();
                $(let $x = &$x[..n];)+
                for i in 0..n {
                    out[i] = $kernel($($x[i]),+);
                }
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2")]
            fn avx2($($x: &[f64],)+ out: &mut [f64]) {
                body($($x,)+ out)
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
            fn avx512($($x: &[f64],)+ out: &mut [f64]) {
                body($($x,)+ out)
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
