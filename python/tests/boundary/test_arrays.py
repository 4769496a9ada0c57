"""Every shape, stride and placing of the operands gives what one element after another gives."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

#: Across the block of 256 elements that the loops work in.
SIZES = [0, 1, 2, 255, 256, 257, 1000]


@pytest.mark.parametrize("size", SIZES)
def test_contiguous(ufunc, draw, elementwise, size):
    inputs = draw(size)
    assert_array_equal(ufunc(*inputs), elementwise(*inputs))


def test_number_in_number_out(ufunc, draw):
    inputs = draw(1)
    result = ufunc(*(float(x[0]) for x in inputs))
    assert type(result) is np.float64
    assert result == ufunc(*inputs)[0]


def test_zero_dimensional(ufunc, draw):
    result = ufunc(*(x.reshape(()) for x in draw(1)))
    assert np.ndim(result) == 0


def test_empty_of_several_dimensions(ufunc, draw):
    assert ufunc(*draw((3, 0, 2))).shape == (3, 0, 2)


@pytest.mark.parametrize("step", [2, -1, -3])
def test_strided(ufunc, draw, elementwise, step):
    inputs = [x[::step] for x in draw(1500)]
    assert_array_equal(ufunc(*inputs), elementwise(*inputs))


def test_strided_output(ufunc, draw, elementwise):
    inputs = draw(500)
    room = np.full(1500, 7.0)
    ufunc(*inputs, out=room[::-3])
    assert_array_equal(room[::-3], elementwise(*inputs))
    assert np.count_nonzero(room == 7.0) == 1000


def test_transposed_and_three_dimensional(ufunc, draw, elementwise):
    inputs = [x.transpose(2, 0, 1)[:, ::-1] for x in draw((3, 5, 70))]
    assert_array_equal(ufunc(*inputs), elementwise(*inputs))


def test_zero_strides(ufunc, draw, elementwise):
    inputs = [np.broadcast_to(x, 600) for x in draw(1)]
    assert_array_equal(ufunc(*inputs), elementwise(*inputs))


def test_broadcast_of_a_number_and_of_a_row(ufunc, draw, elementwise):
    if ufunc.nin == 1:
        with pytest.raises(ValueError, match="broadcast"):
            ufunc(*draw(5), out=np.empty(3))
        return
    for left, right in [((700,), ()), ((), (700,)), ((40, 1), (30,)), ((1, 30), (40, 1))]:
        inputs = [draw(left)[0], *draw(right)[1:]]
        assert_array_equal(ufunc(*inputs), elementwise(*inputs))


@pytest.mark.parametrize("shift", range(1, 8))
def test_misaligned(ufunc, draw, elementwise, shift):
    def misaligned(values):
        room = np.empty(values.nbytes + shift, np.uint8)
        array = np.ndarray(values.shape, np.float64, room, offset=shift)
        array[...] = values
        return array

    inputs = [misaligned(x) for x in draw(300)]
    out = misaligned(np.zeros(300))
    ufunc(*inputs, out=out)
    assert_array_equal(out, elementwise(*inputs))


def test_byte_swapped(ufunc, draw, elementwise):
    inputs = [x.astype(x.dtype.newbyteorder()) for x in draw(300)]
    out = np.zeros(300, inputs[0].dtype)
    ufunc(*inputs, out=out)
    assert_array_equal(out, elementwise(*inputs))


def test_out_is_returned_and_filled(ufunc, draw, elementwise):
    inputs = draw(300)
    out = np.empty(300)
    assert ufunc(*inputs, out=out) is out
    assert_array_equal(out, elementwise(*inputs))


def test_out_of_wrong_shape_or_type(ufunc, draw):
    with pytest.raises(ValueError, match="broadcast"):
        ufunc(*draw(3), out=np.empty(2))
    with pytest.raises(TypeError, match="cast"):
        ufunc(*draw(3), out=np.empty(3, np.int64))


def test_where(ufunc, draw, elementwise):
    inputs = draw(1000)
    where = np.random.default_rng(1).random(1000) < 0.3
    out = np.full(1000, 7.0)
    ufunc(*inputs, out=out, where=where)
    assert_array_equal(out, np.where(where, elementwise(*inputs), 7.0))


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("position", [0, -1])
def test_in_place(ufunc, draw, elementwise, size, position):
    inputs = draw(size)
    expected = elementwise(*inputs)
    ufunc(*inputs, out=inputs[position])
    assert_array_equal(inputs[position], expected)


@pytest.mark.parametrize("shift", [1, 3, 100, 300])
@pytest.mark.parametrize("direction", [1, -1])
def test_output_overlaps_the_input_out_of_step(ufunc, draw, elementwise, shift, direction):
    room, *others = draw(1000)
    early, late = room[:-shift], room[shift:]
    source, target = (early, late) if direction == 1 else (late, early)
    others = [x[: source.size] for x in others]
    expected = elementwise(source, *others)
    ufunc(source, *others, out=target)
    assert_array_equal(target, expected)


def test_reversed_onto_itself(ufunc, draw, elementwise):
    room, *others = draw(1000)
    expected = elementwise(room[::-1], *others)
    ufunc(room[::-1], *others, out=room)
    assert_array_equal(room, expected)


def test_accumulate_and_reduce_go_element_by_element(ufunc):
    values = np.random.default_rng(3).uniform(0.1, 0.5, 700)
    if ufunc.nin != 2:
        with pytest.raises(ValueError, match="binary"):
            ufunc.accumulate(values)
        return
    with np.errstate(invalid="ignore"):
        expected = [values[0]]
        for value in values[1:]:
            expected.append(ufunc(expected[-1], value))
        assert_array_equal(ufunc.accumulate(values), expected)
        assert_array_equal(ufunc.reduce(values), expected[-1])
        backwards = np.empty(700)[::-1]
        assert_array_equal(ufunc.accumulate(values, out=backwards), expected)


def test_outer_and_at(ufunc, draw, elementwise):
    inputs = draw(20)
    if ufunc.nin == 2:
        left, right = inputs
        assert_array_equal(ufunc.outer(left, right), elementwise(left[:, None], right))
        return
    if ufunc.nin > 2:
        for method in (ufunc.outer, ufunc.at):
            with pytest.raises((ValueError, TypeError)):
                method(*inputs)
        return
    expected = inputs[0].copy()
    expected[[3, 5]] = elementwise(expected[[3, 5]])
    ufunc.at(inputs[0], [3, 5])
    assert_array_equal(inputs[0], expected)
