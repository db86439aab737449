"""Series of numbers as points."""
from typing import Sequence

import numpy as np

from ._arrays import doubles, whole
from .errors import InvalidArgument


def delay(x: Sequence[float], lag: int, dimension: int = 2) -> np.ndarray:
    """The delay embedding of a series x: the points (x[i], x[i + lag], ..., x[i + (dimension - 1) * lag]), one for each
    i that has them all. A series that repeats runs around a loop.

    x: [n], finite numbers at equal steps of time; without a trend, which draws the loop out to a spiral.
    lag: how many samples later the next coordinate is. A quarter of the period makes the loop of a sine a circle, half
        of the period makes it a line.
    dimension: how many coordinates a point has.

    Returns float64 [n - (dimension - 1) * lag, dimension].
    """
    series = doubles(x, "x", 1)
    lag, dimension = whole(lag, "lag", 1), whole(dimension, "dimension", 1)
    count = len(series) - (dimension - 1) * lag
    if count < 1:
        raise InvalidArgument("x: %d numbers; %d coordinates with a lag of %d take %d at least" % (
            len(series), dimension, lag, len(series) + 1 - count), "x")
    return np.stack([series[k * lag:k * lag + count] for k in range(dimension)], axis=1)
