"""Which element types go in, and which come out."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import archerfish


@pytest.mark.parametrize("size", [1, 255, 600])
def test_float32_stays_float32_and_is_the_rounded_double(ufunc, draw, size):
    inputs = [x.astype(np.float32) for x in draw(size)]
    # Rounding up to float32 may carry an angle past π, where there is no answer.
    inputs[0] = np.minimum(inputs[0], np.float32(3.14159))
    result = ufunc(*inputs)
    assert result.dtype == np.float32
    assert_array_equal(result, ufunc(*(x.astype(np.float64) for x in inputs)).astype(np.float32))


@pytest.mark.parametrize(
    ("name", "edge"),
    [("apex_x", np.pi), ("locus_radius", np.pi), ("lambertw0", -1 / np.e), ("tree", 1 / np.e)],
)
def test_float32_is_not_rounded_into_the_domain(name, edge):
    ufunc = getattr(archerfish, name)
    assert abs(float(np.float32(edge))) > abs(edge)
    with pytest.warns(RuntimeWarning, match="invalid"):
        assert np.isnan(ufunc(np.float32(edge), *[np.float32(0.5)] * (ufunc.nin - 1)))
    assert "nearest π lies above π" in ufunc.__doc__


def test_float32_strided_in_place_and_misaligned(ufunc, draw):
    inputs = [np.minimum(x.astype(np.float32), np.float32(3.14159))[::-2] for x in draw(1200)]
    expected = ufunc(*inputs)
    room = np.empty(4 * 600 + 1, np.uint8)
    misaligned = np.ndarray(600, np.float32, room, offset=1)
    ufunc(*inputs, out=misaligned)
    assert_array_equal(misaligned, expected)
    ufunc(*inputs, out=inputs[-1])
    assert_array_equal(inputs[-1], expected)


def test_python_numbers_do_not_widen_float32(ufunc):
    array = np.full(3, 0.3, np.float32) * (-1 if ufunc.__name__ == "lambertwm1" else 1)
    with np.errstate(invalid="ignore"):  # a target this high is out of reach
        assert ufunc(array, *[0.5] * (ufunc.nin - 1)).dtype == np.float32


def test_float64_beside_float32_is_float64(ufunc, draw):
    inputs = draw(5)
    inputs[0] = np.minimum(inputs[0].astype(np.float32), np.float32(3.14159))
    expected = np.float32 if ufunc.nin == 1 else np.float64
    assert ufunc(*inputs).dtype == expected


@pytest.mark.parametrize(
    ("given", "result"),
    [
        (np.bool_, np.float32),
        (np.int8, np.float32),
        (np.uint16, np.float32),
        (np.int32, np.float64),
        (np.int64, np.float64),
        (np.float16, np.float32),
    ],
)
def test_other_numbers_are_cast(ufunc, given, result):
    zeros = [np.zeros(4, given)] * ufunc.nin
    assert ufunc(*zeros).dtype == result


def test_integers_give_what_their_floats_give(ufunc):
    zero = {"lambertwm1", "lambertwm1_offset", "tree", "trajectory_height", "aim_low", "aim_high"}
    number = 0 if ufunc.__name__ in zero else 1
    assert ufunc(*[number] * ufunc.nin) == ufunc(*[float(number)] * ufunc.nin)


@pytest.mark.parametrize("given", [np.object_, np.complex128, np.longdouble, "U3", "M8[s]"])
def test_what_has_no_loop_is_refused(ufunc, given):
    with pytest.raises(TypeError, match=ufunc.__name__):
        ufunc(*[np.zeros(3, given)] * ufunc.nin)


def test_dtype_chooses_the_loop(ufunc, draw):
    inputs = [np.minimum(x, 3.14) for x in draw(5)]
    assert ufunc(*inputs, dtype=np.float32).dtype == np.float32
