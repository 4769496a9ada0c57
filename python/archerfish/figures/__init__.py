"""Publication-quality figures: each from a data function that knows nothing of matplotlib.

``figureN_data(...)`` returns arrays, ``draw_figureN(ax, data)`` only draws them, and
``save(number, path)`` does both into a PNG, SVG or PDF file. ``python -m archerfish.figures DIR``
draws them all. Importing this package does not import matplotlib.
"""

from .figure1 import Figure1Data, draw_figure1, figure1_data
from .figure2 import Figure2Data, draw_figure2, figure2_data
from .figure3 import Figure3Data, draw_figure3, figure3_data
from .figure4 import Figure4Data, draw_figure4, figure4_data
from .figure5 import Figure5Data, draw_figure5, figure5_data
from .figure6 import Figure6Data, draw_figure6, figure6_data
from .registry import FIGURES
from .save import caption, save

__all__ = [
    "FIGURES",
    "Figure1Data",
    "Figure2Data",
    "Figure3Data",
    "Figure4Data",
    "Figure5Data",
    "Figure6Data",
    "caption",
    "draw_figure1",
    "draw_figure2",
    "draw_figure3",
    "draw_figure4",
    "draw_figure5",
    "draw_figure6",
    "figure1_data",
    "figure2_data",
    "figure3_data",
    "figure4_data",
    "figure5_data",
    "figure6_data",
    "save",
]
