"""Apexes as named columns: the one place that knows units and names of what is written."""

from __future__ import annotations

import csv
import io
import json
import math
from typing import Any

import numpy as np

from archerfish.launcher import Launcher
from archerfish.locus import ApexLocus, ApexPoints

#: The apexes of a locus that have a name, by their attribute.
NAMED_APEXES = ("highest", "rightmost", "farthest", "max_curvature")

Columns = dict[str, list[Any]]


def columns(points: ApexPoints) -> Columns:
    """Column name, with its unit, to values. Angles in degrees."""
    quantities = {
        "launch_angle_deg": np.degrees(points.launch_angle),
        "elevation_deg": np.degrees(points.elevation),
        "x_m": points.x,
        "y_m": points.y,
        "distance_m": points.distance,
        "time_s": points.time,
        "curvature_per_m": points.curvature,
    }
    return {name: np.atleast_1d(values).tolist() for name, values in quantities.items()}


def to_csv(table: Columns) -> str:
    """A header line and one line a row; every number with the digits that give it back exactly."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(table)
    writer.writerows(zip(*(map(_text, values) for values in table.values()), strict=True))
    return stream.getvalue()


def _text(value: Any) -> str:
    return value if isinstance(value, str) else repr(value)


def to_json(launcher: Launcher, table: Columns) -> str:
    """The launcher, its summary and the points; what is infinite or undefined is null."""
    document = {
        "launcher": {
            "speed_m_per_s": launcher.speed,
            "gravity_m_per_s2": launcher.gravity,
            "epsilon": launcher.epsilon,
            "drag_rate_per_s": launcher.drag_rate,
            "terminal_speed_m_per_s": launcher.terminal_speed,
            "length_scale_m": launcher.length_scale,
            "time_scale_s": launcher.time_scale,
        },
        "summary": {
            "with_drag": _summary(launcher.locus),
            "drag_free": _summary(launcher.locus.drag_free),
        },
        "points": [dict(zip(table, row, strict=True)) for row in zip(*table.values(), strict=True)],
    }
    return json.dumps(_finite(document), indent=2, allow_nan=False) + "\n"


def _summary(locus: ApexLocus) -> dict[str, Any]:
    named = {
        name: {column: values[0] for column, values in columns(getattr(locus, name)).items()}
        for name in NAMED_APEXES
    }
    return named | {"arc_length_m": locus.arc_length(), "area_m2": locus.area}


def _finite(node: Any) -> Any:
    """The same document with null where a number is infinite or undefined: JSON has neither."""
    if isinstance(node, dict):
        return {key: _finite(value) for key, value in node.items()}
    if isinstance(node, list):
        return [_finite(value) for value in node]
    return node if math.isfinite(node) else None
