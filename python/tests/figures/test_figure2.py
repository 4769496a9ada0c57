import numpy as np

from archerfish import apex_elevation, locus_launch_angle
from archerfish.figures import figure2_data


def test_the_two_are_inverse():
    data = figure2_data([0.0, 0.1, 10.0])
    column = data.epsilon[:, np.newaxis]
    np.testing.assert_allclose(
        apex_elevation(data.launch_angle, column), np.tile(data.angle, (3, 1)), rtol=1e-14
    )
    np.testing.assert_allclose(
        locus_launch_angle(data.elevation, column), np.tile(data.angle, (3, 1)), rtol=1e-14
    )


def test_drag_free_is_the_arctangent():
    data = figure2_data([0.0])
    np.testing.assert_allclose(
        data.launch_angle[0, :-1], np.arctan(2.0 * np.tan(data.angle[:-1])), rtol=1e-14
    )


def test_lie_between_the_diagonal_and_the_drag_free_curve():
    data = figure2_data()
    inside = slice(1, -1)
    angle = data.angle[inside]
    assert np.all(data.launch_angle[:, inside] > angle)
    assert np.all(data.launch_angle[:, inside] < np.arctan(2.0 * np.tan(angle)))
    assert np.all(np.diff(data.elevation, axis=1) > 0.0)


def test_ends():
    data = figure2_data()
    for curve in (data.elevation, data.launch_angle):
        np.testing.assert_array_equal(curve[:, 0], 0.0)
        np.testing.assert_allclose(curve[:, -1], np.pi / 2, rtol=1e-15)
