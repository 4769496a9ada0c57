"""Arrays that are not plain: each keeps its kind, its labels and its mask."""

import dask.array
import numpy as np
import pandas as pd
import pytest
import xarray as xr
from numpy.testing import assert_array_equal


class Marked(np.ndarray):
    """A subclass that carries a mark along."""

    mark = None

    def __array_finalize__(self, source):
        self.mark = getattr(source, "mark", None)


def test_subclass(ufunc, draw):
    inputs = draw(10)
    marked = inputs[0].view(Marked)
    marked.mark = "locus"
    result = ufunc(marked, *inputs[1:])
    assert type(result) is Marked
    assert result.mark == "locus"
    assert_array_equal(np.asarray(result), ufunc(*inputs))
    assert type(ufunc(marked, *inputs[1:], subok=False)) is np.ndarray


def test_masked_array(ufunc, draw):
    inputs = draw(10)
    mask = np.arange(10) % 3 == 0
    result = ufunc(np.ma.array(inputs[0], mask=mask), *inputs[1:])
    assert isinstance(result, np.ma.MaskedArray)
    assert_array_equal(result.mask, mask)
    assert_array_equal(result.compressed(), ufunc(*inputs)[~mask])


def test_pandas_series(ufunc, draw):
    index = pd.Index(list("abcdefghij"), name="shot")
    inputs = draw(10)
    result = ufunc(*(pd.Series(x, index, name="given") for x in inputs))
    assert isinstance(result, pd.Series)
    assert result.index.equals(index)
    assert_array_equal(result.to_numpy(), ufunc(*inputs))


def test_pandas_aligns_by_label(ufunc, draw):
    if ufunc.nin == 1:
        frame = pd.DataFrame({"x": draw(4)[0]})
        assert isinstance(ufunc(frame), pd.DataFrame)
        return
    left, *others = draw(4)
    mirrored = [pd.Series(x[::-1], list("dcba")) for x in others]
    if ufunc.nin > 2:  # pandas itself takes no more than two to align
        mirrored = [series[list("abcd")] for series in mirrored]
    result = ufunc(pd.Series(left, list("abcd")), *mirrored)
    assert_array_equal(result[list("abcd")].to_numpy(), ufunc(left, *others))


def test_xarray(ufunc, draw):
    inputs = draw(6)
    names = ["first", "second", "third"]
    arrays = [xr.DataArray(x, dims=n, coords={n: x}) for x, n in zip(inputs, names, strict=False)]
    result = ufunc(*arrays)
    assert isinstance(result, xr.DataArray)
    assert result.dims == tuple(names[: ufunc.nin])
    expected = ufunc(*np.ix_(*inputs))
    assert_array_equal(result.to_numpy(), expected)


def test_dask(ufunc, draw):
    inputs = draw((60, 50))
    result = ufunc(*(dask.array.from_array(x, chunks=(25, 50)) for x in inputs))
    assert isinstance(result, dask.array.Array)
    assert result.dtype == np.float64
    assert_array_equal(result.compute(scheduler="threads"), ufunc(*inputs))


@pytest.mark.parametrize("given", [list, tuple])
def test_sequences(ufunc, draw, given):
    inputs = draw(5)
    assert_array_equal(ufunc(*(given(x) for x in inputs)), ufunc(*inputs))
