//! Which instruction set: one inlined body, compiled once for each, chosen once at start.
//!
//! In a browser there is one alone: pairs.rs.

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

/// Whether a slice holds a NaN. (A fold, not `any`: without a way out in the middle it is vectorised.)
#[inline(always)]
fn any_nan(values: &[f64]) -> bool {
    values.iter().fold(false, |found, value| found | value.is_nan())
}

/// Whether a slice holds a NaN.
pub fn holds_nan(values: &[f64]) -> bool {
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn avx2(values: &[f64]) -> bool {
        any_nan(values)
    }
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
    fn avx512(values: &[f64]) -> bool {
        any_nan(values)
    }
    match isa() {
        Isa::Baseline => any_nan(values),
        // SAFETY: `isa` returns a set only after finding it on this machine.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => unsafe { avx2(values) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => unsafe { avx512(values) },
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

/// Whether an ordinary kernel declined one of these.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(crate) fn declined(values: &[f64]) -> bool {
    // (a loop to the end: `any` leaves it early, and is not vectorised)
    values.iter().fold(false, |declined, y| declined | (*y == f64::INFINITY))
}

/// Fills a slice by `$whole`; if there is an ordinary kernel, only where that one declines an element.
macro_rules! short {
    ($whole:ident; $($x:ident),+ => $out:ident) => {
        $whole($($x,)+ $out)
    };
    ($whole:ident or $module:ident::$ordinary:ident; $($x:ident),+ => $out:ident) => {
        $crate::dispatch::each!(ordinary, $crate::fused::$module::$ordinary, $($x),+);
        ordinary($($x,)+ $out);
        if $crate::dispatch::declined($out) {
            $whole($($x,)+ $out)
        }
    };
}
pub(crate) use short;

/// Fills block k: both halves in step, each of the compiler's vectors; or by vectors written down.
macro_rules! block {
    (twins, $block:expr, $k:ident; $module:ident::$kernel:ident, $($x:ident),+ => $out:ident) => {
        const HALF: usize = $block / 2;
        for i in 0..HALF {
            let values = $crate::twins::$module::$kernel(
                $($crate::twin::Twin([$x[$k][i], $x[$k][HALF + i]])),+
            );
            [$out[$k][i], $out[$k][HALF + i]] = values.0;
        }
    };
    (wides, $block:expr, $k:ident; $module:ident::$kernel:ident, $($x:ident),+ => $out:ident) => {
        $crate::wides::$module::$kernel($((&$x[$k]).into()),+).store(&mut $out[$k]);
    };
}
pub(crate) use block;

/// Defines `$name`, a loop over blocks of so many elements. With an ordinary kernel that one goes first,
/// and blocks where it declines an element go through the whole one.
macro_rules! in_blocks {
    ($how:ident, $name:ident, $whole:ident, $features:literal, $block:expr;
     $module:ident::$kernel:ident or $ordinary:ident, $($x:ident),+) => {
        $crate::dispatch::in_blocks!(
            @ $how, $whole, $features, $block; $module::$kernel, $($x),+
        );
        $crate::dispatch::in_blocks!(
            @ $how, $name, $features, $block; $module::$ordinary, $($x),+ => |k, out| {
                if $crate::dispatch::declined(&out[k]) {
                    $whole($(&$x[k..=k],)+ &mut out[k..=k]);
                }
            }
        );
    };
    ($how:ident, $name:ident, $whole:ident, $features:literal, $block:expr;
     $module:ident::$kernel:ident, $($x:ident),+) => {
        $crate::dispatch::in_blocks!(@ $how, $name, $features, $block; $module::$kernel, $($x),+);
    };
    (@ $how:ident, $name:ident, $features:literal, $block:expr;
     $module:ident::$kernel:ident, $($x:ident),+
     $(=> |$k:ident, $done:ident| $then:block)?) => {
        // (inlined, its arguments would no longer be known not to overlap)
        #[inline(never)]
        #[target_feature(enable = $features)]
        fn $name($($x: &[[f64; $block]],)+ out: &mut [[f64; $block]]) {
            let n = out.len();
            $(let $x = &$x[..n];)+
            for k in 0..n {
                $crate::dispatch::block!($how, $block, k; $module::$kernel, $($x),+ => out);
                $({
                    let $k = k;
                    let $done = &mut *out;
                    $then
                })?
            }
        }
    };
}
pub(crate) use in_blocks;

/// Fills whole blocks by `$name`, if there are some, and leaves the rest of the slices.
macro_rules! blocks {
    ($name:ident, $block:expr; $($x:ident),+ => $out:ident) => {
        let n = $out.len();
        let whole = if n < $crate::twins::SHORT { 0 } else { n - n % $block };
        $(let $x = $x.split_at(whole);)+
        let (blocks, $out) = $out.split_at_mut(whole);
        $name($($x.0.as_chunks().0,)+ blocks.as_chunks_mut().0);
        $(let $x = $x.1;)+
    };
}
pub(crate) use blocks;

/// Defines a slice function whose loop body is compiled once per instruction set.
macro_rules! batch {
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident $(or $ordinary:ident)?, $($x:ident),+ => (out)) => {
        $(#[$doc])*
        pub fn $name($($x: &[f64],)+ out: &mut [f64]) {
            $crate::dispatch::each!(body, $crate::$module::$kernel, $($x),+);
            #[cfg(target_arch = "x86_64")]
            $crate::dispatch::each!(fused, $crate::fused::$module::$kernel, $($x),+);
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma")]
            fn avx2($($x: &[f64],)+ out: &mut [f64]) {
                $crate::dispatch::short!(fused $(or $module::$ordinary)?; $($x),+ => out);
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512dq,avx512vl,fma")]
            fn avx512($($x: &[f64],)+ out: &mut [f64]) {
                $crate::dispatch::short!(fused $(or $module::$ordinary)?; $($x),+ => out);
            }
            #[cfg(target_arch = "x86_64")]
            $crate::dispatch::in_blocks!(
                twins, twins_avx2, whole_avx2, "avx2,fma", $crate::twins::BLOCK;
                $module::$kernel $(or $ordinary)?, $($x),+
            );
            #[cfg(target_arch = "x86_64")]
            $crate::dispatch::in_blocks!(
                wides, wides_avx512, whole_avx512, "avx512f,avx512dq,avx512vl,fma",
                $crate::wide::BLOCK;
                $module::$kernel $(or $ordinary)?, $($x),+
            );
            match $crate::dispatch::isa() {
                $crate::dispatch::Isa::Baseline => body($($x,)+ out),
                // SAFETY: `isa` returns a set only after finding it on this machine.
                #[cfg(target_arch = "x86_64")]
                $crate::dispatch::Isa::Avx2 => unsafe {
                    $crate::dispatch::blocks!(
                        twins_avx2, $crate::twins::BLOCK; $($x),+ => out
                    );
                    avx2($($x,)+ out)
                },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                $crate::dispatch::Isa::Avx512 => unsafe {
                    $crate::dispatch::blocks!(
                        wides_avx512, $crate::wide::BLOCK; $($x),+ => out
                    );
                    avx512($($x,)+ out)
                },
            }
        }
    };
}
pub(crate) use batch;

/// The instructions that `wide.rs` computes with, as functions.
#[cfg(target_arch = "x86_64")]
pub(crate) mod avx512 {
    use core::arch::x86_64::*;

    macro_rules! instructions {
        ($($name:ident($($x:ident: $of:ty),+) -> $to:ty = $call:expr;)+) => {$(
            #[inline(always)]
            pub(crate) fn $name($($x: $of),+) -> $to {
                // SAFETY: only what `batch` compiles for AVX-512, and calls where there is AVX-512,
                // computes with its vectors.
                unsafe { $call }
            }
        )+};
    }

    /// The same number in every place, for constants.
    pub(crate) const fn spread_constant(x: f64) -> __m512d {
        // SAFETY: eight doubles are what a vector is.
        unsafe { core::mem::transmute([x; 8]) }
    }

    instructions! {
        spread(x: f64) -> __m512d = _mm512_set1_pd(x);
        // SAFETY: and the array is as long as a vector.
        load(from: &[f64; 8]) -> __m512d = _mm512_loadu_pd(from.as_ptr());
        // SAFETY: as the last.
        store(to: &mut [f64; 8], x: __m512d) -> () = _mm512_storeu_pd(to.as_mut_ptr(), x);
        to_bits(x: __m512d) -> __m512i = _mm512_castpd_si512(x);
        from_bits(x: __m512i) -> __m512d = _mm512_castsi512_pd(x);
        add(a: __m512d, b: __m512d) -> __m512d = _mm512_add_pd(a, b);
        sub(a: __m512d, b: __m512d) -> __m512d = _mm512_sub_pd(a, b);
        mul(a: __m512d, b: __m512d) -> __m512d = _mm512_mul_pd(a, b);
        div(a: __m512d, b: __m512d) -> __m512d = _mm512_div_pd(a, b);
        sqrt(a: __m512d) -> __m512d = _mm512_sqrt_pd(a);
        abs(a: __m512d) -> __m512d = _mm512_abs_pd(a);
        neg(a: __m512d) -> __m512d = _mm512_xor_pd(a, _mm512_set1_pd(-0.0));
        mul_add(a: __m512d, b: __m512d, c: __m512d) -> __m512d = _mm512_fmadd_pd(a, b, c);
        copysign(a: __m512d, sign: __m512d) -> __m512d = {
            let bit = _mm512_set1_pd(-0.0);
            _mm512_or_pd(_mm512_andnot_pd(bit, a), _mm512_and_pd(bit, sign))
        };
        is_nan(a: __m512d) -> __mmask8 = _mm512_cmp_pd_mask::<_CMP_UNORD_Q>(a, a);
        is_below(a: __m512d, b: __m512d) -> __mmask8 = _mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b);
        is_above(a: __m512d, b: __m512d) -> __mmask8 = _mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b);
        is_at_most(a: __m512d, b: __m512d) -> __mmask8 = _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b);
        is_at_least(a: __m512d, b: __m512d) -> __mmask8 = _mm512_cmp_pd_mask::<_CMP_GE_OQ>(a, b);
        equals(a: __m512d, b: __m512d) -> __mmask8 = _mm512_cmp_pd_mask::<_CMP_EQ_OQ>(a, b);
        is_at_most_unsigned(a: __m512i, b: __m512i) -> __mmask8 = _mm512_cmple_epu64_mask(a, b);
        select(condition: __mmask8, a: __m512d, b: __m512d) -> __m512d =
            _mm512_mask_blend_pd(condition, b, a);
        lesser(a: __m512d, b: __m512d) -> __m512d = _mm512_min_pd(a, b);
        greater(a: __m512d, b: __m512d) -> __m512d = _mm512_max_pd(a, b);
        exponent(a: __m512d) -> __m512d = _mm512_getexp_pd(a);
        look_up(low: __m512d, index: __m512i, high: __m512d) -> __m512d =
            _mm512_permutex2var_pd(low, index, high);
        // two vectors' doubles side by side, and back
        narrow(a: __m512d, b: __m512d) -> __m512 = {
            let low = _mm512_castps256_ps512(_mm512_cvtpd_ps(a));
            _mm512_insertf32x8::<1>(low, _mm512_cvtpd_ps(b))
        };
        widen_low(a: __m512) -> __m512d = _mm512_cvtps_pd(_mm512_castps512_ps256(a));
        widen_high(a: __m512) -> __m512d = _mm512_cvtps_pd(_mm512_extractf32x8_ps::<1>(a));
        spread_single(x: f32) -> __m512 = _mm512_set1_ps(x);
        add_single(a: __m512, b: __m512) -> __m512 = _mm512_add_ps(a, b);
        sub_single(a: __m512, b: __m512) -> __m512 = _mm512_sub_ps(a, b);
        mul_single(a: __m512, b: __m512) -> __m512 = _mm512_mul_ps(a, b);
        div_single(a: __m512, b: __m512) -> __m512 = _mm512_div_ps(a, b);
        sqrt_single(a: __m512) -> __m512 = _mm512_sqrt_ps(a);
        spread_bits(bits: u64) -> __m512i = _mm512_set1_epi64(bits as i64);
        has(bits: __m512i, bit: __m512i) -> __mmask8 =
            _mm512_cmpeq_epi64_mask(_mm512_and_si512(bits, bit), bit);
        when(condition: __mmask8, bits: __m512i) -> __m512i =
            _mm512_maskz_mov_epi64(condition, bits);
        wrapping_add(a: __m512i, b: __m512i) -> __m512i = _mm512_add_epi64(a, b);
        wrapping_sub(a: __m512i, b: __m512i) -> __m512i = _mm512_sub_epi64(a, b);
        bitand(a: __m512i, b: __m512i) -> __m512i = _mm512_and_si512(a, b);
        bitor(a: __m512i, b: __m512i) -> __m512i = _mm512_or_si512(a, b);
        bitxor(a: __m512i, b: __m512i) -> __m512i = _mm512_xor_si512(a, b);
        shift_left(bits: __m512i, by: u32) -> __m512i =
            _mm512_sllv_epi64(bits, _mm512_set1_epi64(i64::from(by)));
        shift_right(bits: __m512i, by: u32) -> __m512i =
            _mm512_srlv_epi64(bits, _mm512_set1_epi64(i64::from(by)));
    }
}
