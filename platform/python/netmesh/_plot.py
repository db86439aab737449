"""Pictures of diagrams, by matplotlib."""
import numpy as np

from .errors import InvalidArgument


def draw(diagram, axes, kind):
    if kind not in ("diagram", "barcode"):
        raise InvalidArgument("kind: %r is neither diagram nor barcode" % (kind,), "kind")
    if axes is None:
        import matplotlib.pyplot as plt
        axes = plt.gca()
    finite = diagram._intervals[np.isfinite(diagram._intervals)]
    low, high = (finite.min(), finite.max()) if len(finite) else (0.0, 1.0)
    top = high + 0.08 * ((high - low) or 1.0)  # where what never dies is drawn
    (_points if kind == "diagram" else _bars)(diagram, axes, min(low, 0.0), top)
    axes.legend(loc="lower right")
    return axes


def _points(diagram, axes, low, top):
    axes.plot([low, top], [low, top], color="0.7", linewidth=1, zorder=1)
    axes.axhline(top, color="0.7", linewidth=1, linestyle="--", zorder=1)
    for degree in range(diagram.max_degree + 1):
        bars = diagram.intervals(degree)
        axes.scatter(bars[:, 0], np.minimum(bars[:, 1], top), s=14, label="H%d" % degree, zorder=2 + degree)
    axes.set_xlabel("birth")
    axes.set_ylabel("death")
    axes.set_aspect("equal")


def _bars(diagram, axes, low, top):
    row = 0
    for degree in range(diagram.max_degree + 1):
        bars = diagram.intervals(degree)
        axes.hlines(np.arange(row, row + len(bars)), bars[:, 0], np.minimum(bars[:, 1], top), label="H%d" % degree,
                    color="C%d" % degree)
        row += len(bars)
    axes.set_xlim(low, top)
    axes.set_xlabel("radius")
    axes.set_yticks([])
