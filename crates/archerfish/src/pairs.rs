//! Slice functions in a browser: two elements at a time, whatever the length.

type Pair = [f64; 2];

/// Leaves the pairs of elements to `compute`, and a last single element as a pair with a zero.
///
/// A loop of unknown length would be compiled twice, for pairs and for a last element, and a page has
/// to fetch that.
#[inline(never)]
pub(crate) fn in_pairs<const INPUTS: usize, const OUTPUTS: usize>(
    inputs: [&[f64]; INPUTS],
    mut outputs: [&mut [f64]; OUTPUTS],
    compute: fn([&[Pair]; INPUTS], [&mut [Pair]; OUTPUTS]),
) {
    let count = outputs[0].len();
    let (pairs, single) = (count / 2, count % 2 == 1);
    compute(
        inputs.map(|x| &x.as_chunks().0[..pairs]),
        outputs.each_mut().map(|out| &mut out.as_chunks_mut().0[..pairs]),
    );
    if single {
        let last = inputs.map(|x| [[x[count - 1], 0.0]]);
        let mut values = [[[0.0; 2]]; OUTPUTS];
        compute(last.each_ref().map(|x| &x[..]), values.each_mut().map(|out| &mut out[..]));
        for (out, [[value, _]]) in outputs.iter_mut().zip(values) {
            out[count - 1] = value;
        }
    }
}

/// Defines a function that fills slices with the values of a kernel at others.
macro_rules! batch {
    ($(#[$doc:meta])* $name:ident, $module:ident::$kernel:ident, $($x:ident),+ => ($($out:ident),+)) => {
        $(#[$doc])*
        pub fn $name($($x: &[f64],)+ $($out: &mut [f64]),+) {
            // as arguments of a function, slices are known not to overlap
            fn compute($($x: &[[f64; 2]],)+ $($out: &mut [[f64; 2]]),+) {
                // known to be even and not to wrap: else a loop for a last element is compiled as well
                let n = 2 * [$($out.len()),+][0].min(1 << 28);
                $(let $x = &$x.as_flattened()[..n];)+
                $(let $out = &mut $out.as_flattened_mut()[..n];)+
                for i in 0..n {
                    ($($out[i]),+) = $crate::$module::$kernel($($x[i]),+);
                }
            }
            $crate::pairs::in_pairs([$($x),+], [$($out),+], |[$($x),+], [$($out),+]| {
                compute($($x,)+ $($out),+)
            });
        }
    };
}
pub(crate) use batch;
