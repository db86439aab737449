"""Checks of results by the files or objects alone."""
from typing import Callable, Union

import numpy as np

from ._diagram import Diagram
from ._files import BEFORE_ROUNDING, arguments_of, head_of
from ._mesh import Mesh
from ._persist import diagram_of_points
from .errors import CheckFailed, InvalidArgument


def check(result, points=None, *, progress: Union[bool, Callable, None] = None) -> None:
    """Checks a result, and raises :class:`netmesh.errors.CheckFailed` where it is not what it says.

    A :class:`netmesh.Mesh` is checked exactly, by code that shares nothing with what made it: the triangulation is
    Delaunay, its cells have the quality that was promised.

    A :class:`netmesh.Diagram`, made here or read by :func:`netmesh.load`, is made again from ``points`` [n, D] in the
    way that its head says: every bar, and what is certified of it, has to be the same to the last bit. That is the same
    engine run again; ``netmesh check`` of the tool adds a second opinion by other code. A file of version 0.2.0 or
    before whose births and deaths were not rounded to nearest is refused.
    """
    if isinstance(result, Mesh):
        result.check(progress=progress)
        return
    if not isinstance(result, Diagram):
        raise InvalidArgument("result: neither a Mesh nor a Diagram", "result")
    if points is None:
        raise InvalidArgument("points: those that the diagram is of are needed", "points")
    head = getattr(result, "_head", None) or head_of(result)
    if not head:
        raise InvalidArgument("result: nothing says how this diagram is made", "result")
    if {"radii", "weights", "box", "cell"} & set(dict(head)):
        raise InvalidArgument("result: diagrams of points with radii, weights or a cell are not made again here",
                              "result")
    if "value-error" in dict(head):
        raise CheckFailed("result: this file was " + BEFORE_ROUNDING, "result")
    again = diagram_of_points(points, arguments_of(head), dict(head).get("memory"), progress)
    _compare_bars(result, again)
    lines, due = dict(head), dict(head_of(again))
    for key in ("dim", "points", "duplicates", "input", "domain", "certified-ratio", "certified-from", "reference"):
        if lines.get(key) != due.get(key):
            raise CheckFailed("%s: %s where %s is due" % (key, lines.get(key), due.get(key)), "result")


def _compare_bars(result, again):
    have, due = result.pairs, again.pairs
    shared = min(len(have), len(due))
    differ = np.flatnonzero((have[:shared] != due[:shared]).any(axis=1))
    if len(differ) or len(have) != len(due):
        row = int(differ[0]) if len(differ) else shared
        texts = [("bar " + " ".join("%r" % x for x in rows[row].tolist())) if row < len(rows) else "no bar"
                 for rows in (have, due)]
        raise CheckFailed("result, row %d: %s where %s is due" % (row, *texts), "result", row)
