"""`invalid` is raised exactly when a NaN is born; no other flag is ever raised."""

import warnings

import numpy as np
import pytest

import archerfish

#: The second of each is outside the domain in float32 too.
OUTSIDE = {
    "lambertw0": [-0.37, -1.0, -np.inf],
    "lambertwm1": [-0.37, 1e-30, np.inf],
    "lambertw0_offset": [-1e-300, -1.0],
    "lambertwm1_offset": [-1e-300, 0.37],
    "tree": [0.37, np.inf],
    "log1pmx": [-1.5, -np.inf],
    "optimal_angle": [-1e-300, -1.0, np.inf],
}
OUTSIDE_ANGLE = [-1e-300, -1.0, 3.15, np.inf]
OUTSIDE_EPS = [-1e-300, -1.0, -np.inf]

#: As above, of the functions whose arguments are not an angle and ε.
OUTSIDE_FLIGHT = {
    "envelope_height": [(10.1, 0.1), (-3.0, 0.5), (np.inf, 0.0), (0.5, -1e-300), (0.5, np.inf)],
    "flight_x": [(-1e-300, 1.0, 0.1), (-1.0, 1.0, 0.1), (1.0, 6.3, 0.1), (1.0, 1.0, -1.0)],
    "flight_y": [(-1e-300, 1.0, 0.1), (-1.0, 1.0, 0.1), (1.0, 6.3, 0.1), (1.0, 1.0, -1.0)],
    "aim_low": [(0.5, np.inf, 0.1), (0.5, 0.5, 0.1), (10.1, -1.0, 0.1), (0.1, 0.1, -1.0)],
    "aim_high": [(0.5, np.inf, 0.1), (0.5, 0.5, 0.1), (10.1, -1.0, 0.1), (0.1, 0.1, -1.0)],
    "trajectory_height": [(10.1, 0.0, 0.1), (-1.0, 1.0, 0.1), (1.0, 6.3, 0.1), (0.1, 1.0, -1.0)],
}

#: Longer than a block, and with a gap after each row: NumPy calls the loop once a row.
ROWS, COLUMNS = 3, 400


def outside(name, ufunc):
    """Arguments outside the domain, one wrong at a time."""
    if ufunc.nin == 1:
        return [(value,) for value in OUTSIDE[name]]
    if name in OUTSIDE_FLIGHT:
        return OUTSIDE_FLIGHT[name]
    return [(a, 0.1) for a in OUTSIDE_ANGLE] + [(0.5, e) for e in OUTSIDE_EPS]


def test_born_nan_warns_once(name, ufunc):
    for arguments in outside(name, ufunc):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            assert np.isnan(ufunc(*arguments))
        assert [str(w.message) for w in caught] == [f"invalid value encountered in {name}"]
        assert caught[0].category is RuntimeWarning


def test_errstate_raises(name, ufunc):
    for arguments in outside(name, ufunc):
        with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match="invalid"):
            ufunc(*arguments)


def test_given_nan_passes_quietly(ufunc, draw):
    with np.errstate(all="raise"):
        for k in range(ufunc.nin):
            inputs = draw(1000)
            inputs[k][::7] = np.nan
            result = ufunc(*inputs)
            assert np.array_equal(np.isnan(result), np.arange(1000) % 7 == 0)
            assert np.isnan(ufunc(*(x[0] for x in inputs)))


def test_given_nan_hides_no_other_argument(ufunc):
    if ufunc.nin > 1:
        with np.errstate(all="raise"):
            assert np.isnan(ufunc(np.nan, *[-1.0] * (ufunc.nin - 1)))
            assert np.isnan(ufunc(*[-1.0] * (ufunc.nin - 1), np.nan))


@pytest.mark.parametrize("position", [0, 255, 256, 999])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_one_born_among_many_given(name, ufunc, draw, position, dtype):
    inputs = [np.minimum(x, 3.14).astype(dtype) for x in draw(1000)]
    inputs[0][:] = np.nan
    wrong = outside(name, ufunc)[1]
    for x, value in zip(inputs, wrong, strict=True):
        x[position] = value
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        ufunc(*inputs)


@pytest.mark.parametrize("row", range(ROWS))
def test_born_in_any_stretch_of_the_array(name, ufunc, draw, row):
    inputs = [x[:, :COLUMNS] for x in draw((ROWS, COLUMNS + 1))]
    out = np.empty((ROWS, COLUMNS + 1))[:, :COLUMNS]
    ufunc(*inputs, out=out)
    for x, value in zip(inputs, outside(name, ufunc)[1], strict=True):
        x[row, 5] = value
    with pytest.warns(RuntimeWarning, match="invalid"):
        ufunc(*inputs, out=out)


def test_not_computed_is_not_born(name, ufunc, draw):
    inputs = draw(10)
    for x, value in zip(inputs, outside(name, ufunc)[1], strict=True):
        x[4] = value
    with np.errstate(all="raise"):
        ufunc(*inputs, where=np.arange(10) != 4, out=np.zeros(10))


def test_no_flag_for_any_legal_number(name, ufunc, draw):
    tiny = [0.0, 5e-324, 1e-310, 2.3e-308, 1e-200, 1e-16]
    huge = [1.0, 1e16, 1e154, 1e155, 1e200, 1e300]
    with np.errstate(all="raise"):
        ufunc(*draw(1000))
        angles = np.array([*tiny, 0.5, np.pi / 4, np.pi / 2, 3.0, np.pi])
        if name == "envelope_height":
            ufunc(np.array(tiny)[:, None], np.array([*tiny, 1.0, 1e15]))
        elif name == "trajectory_height":
            ufunc(np.array(tiny)[:, None], 0.5, np.array([*tiny, 1.0, 1e15]))
        elif name in {"aim_low", "aim_high"}:
            ufunc(np.array(tiny)[:, None, None], np.array(tiny)[:, None], [*tiny, 1.0, 1e15])
        elif ufunc.nin == 3:
            ufunc(np.array([*tiny, 1.0, 1e150])[:, None, None], angles[:, None], tiny + huge)
        elif ufunc.nin == 2:
            ufunc(angles[:, None], np.array(tiny + huge))
        elif name in {"lambertw0", "lambertw0_offset", "log1pmx"}:
            ufunc(np.array([*tiny, *huge, np.inf]))
        elif name == "lambertwm1":
            ufunc(-np.array(tiny))
        else:
            ufunc(np.array(tiny))


def test_narrowing_raises_no_flag():
    with np.errstate(all="raise"):
        assert archerfish.log1pmx(np.float32(1e-30)) == 0.0


def test_flags_raised_by_numpy_itself_survive():
    with pytest.warns(RuntimeWarning, match="overflow encountered in cast"):
        archerfish.log1pmx(np.array([1e300]), dtype=np.float32)
