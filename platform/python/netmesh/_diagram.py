"""Persistence diagrams."""
import os
import warnings
from typing import Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._arrays import address, first_rows, whole
from ._library import FILTER_NAMES, FILTERS, lib
from ._session import figures
from .errors import InvalidArgument


class Bounds(NamedTuple):
    """Where the true bars surely are, a row for each bar of the diagram, in its order."""

    birth: np.ndarray          #: float64 [m, 2], the true birth is between the two; radii
    death: np.ndarray          #: float64 [m, 2], the true death is between the two
    certain: np.ndarray        #: bool [m], certified to exist in the true diagram, however short
    certain_after: np.ndarray  #: float64 [m], a bar of this birth that dies later is certain
    #: float64 [s, 6]: the certificate by scale, from, low, high, reach, ratio, error (netmesh_scale_step)
    steps: np.ndarray

    def __repr__(self) -> str:
        return "<netmesh.Bounds of %d bars, %d certified to exist>" % (len(self.certain), self.certain.sum())


class Representatives:
    """A cycle for each bar, in the order of the diagram: ``representatives[i]`` is an array int32
    [simplices, degree + 1] of vertices. Of a bar of degree 0: a vertex, and one that it is then connected to.

    Vertices are rows of the points or distances, of equal rows the first: ``points[representatives[i]]`` are the
    corners. Of filters on meshes, and of :meth:`Mesh.persist`, they are vertices of the mesh, ``Mesh.vertices``: first
    the points without those that are equal to an earlier one. Of simplices they are these one's labels.

    With periods ``representatives.translations[i]`` is an array int32 [simplices, degree + 1, vectors]: a vertex is
    where its row says, and that often each vector of the cell farther; the first of a simplex is at its own place.
    Otherwise ``translations`` is None."""

    def __init__(self, cycles: List[np.ndarray], translations: Optional[List[np.ndarray]] = None):
        self._cycles = cycles
        self.translations = translations

    def __len__(self) -> int:
        return len(self._cycles)

    def __getitem__(self, index: int) -> np.ndarray:
        return self._cycles[index]

    def __iter__(self) -> Iterator[np.ndarray]:
        return iter(self._cycles)


class Diagram:
    """A persistence diagram: bars sorted by degree, birth and death. Births and deaths are radii; the death of a class
    that never dies is infinite."""

    def __init__(self, intervals, starts, facts, report=None, bounds=None, representatives=None):
        self._intervals = intervals
        self._starts = starts
        self._facts = facts
        self._report = report
        self._asked = None  # how it is made, where a file can say that
        #: :class:`Bounds`, where ``bounds=True`` asked for them, else None.
        self.bounds: Optional[Bounds] = bounds
        #: :class:`Representatives`, where ``representatives=True`` asked for them, else None.
        self.representatives: Optional[Representatives] = representatives

    def __getstate__(self):
        """Requests hold addresses; another process gets what a file would say of them."""
        from . import _files
        return dict(self.__dict__, _asked=_files.options_of(self))

    @property
    def max_degree(self) -> int:
        """The highest degree of homology that was computed."""
        return len(self._starts) - 2

    def intervals(self, degree: int) -> np.ndarray:
        """The bars of one degree: float64 [m, 2], birth and death, radii; not a copy."""
        if not 0 <= degree <= self.max_degree:
            raise InvalidArgument("degree: %r is not from 0 to %d" % (degree, self.max_degree), "degree")
        return self._intervals[self._starts[degree]:self._starts[degree + 1]]

    def longest(self, degree: int = 1, count: int = 1) -> np.ndarray:
        """The longest bars of one degree by death - birth, the longest first: float64 [at most count, 2]. What never
        dies is longer than all others; of bars as long as each other the first in the diagram comes first."""
        bars = self.intervals(degree)
        count = whole(count, "count", 1)
        with np.errstate(over="ignore"):
            order = np.argsort(bars[:, 0] - bars[:, 1], kind="stable")
        return bars[order[:count]]

    def rows(self, degree: int) -> slice:
        """Where the bars of one degree stand in :attr:`bounds` and :attr:`representatives`."""
        self.intervals(degree)
        return slice(self._starts[degree], self._starts[degree + 1])

    @property
    def pairs(self) -> np.ndarray:
        """All bars: float64 [m, 3], degree, birth, death."""
        return np.column_stack((self._degrees(), self._intervals))

    def _degrees(self):
        return np.repeat(np.arange(self.max_degree + 1), np.diff(self._starts))

    def __array__(self, dtype=None, copy=None) -> np.ndarray:
        """:attr:`pairs`, as ``save("d.npy")`` writes them."""
        if copy is False:
            raise ValueError("the array of a diagram is always a copy")
        return self.pairs if dtype is None else self.pairs.astype(dtype)

    def betti(self, radius: Union[float, Sequence[float]]) -> Union[Tuple[int, ...], np.ndarray]:
        """How many bars of each degree are alive at a radius: birth <= radius < death. Of an array of radii an int
        array, with an axis more for degrees."""
        if np.ndim(radius) > 0:
            radii = np.asarray(radius, dtype=np.float64)
            counts = [_alive(self.intervals(k), radii) for k in range(self.max_degree + 1)]
            return np.stack(counts, axis=-1)
        alive = (self._intervals[:, 0] <= radius) & (radius < self._intervals[:, 1])
        return tuple(int(alive[self.rows(k)].sum()) for k in range(self.max_degree + 1))

    def __len__(self) -> int:
        return len(self._intervals)

    def __iter__(self) -> Iterator[Tuple[int, float, float]]:
        for degree, (birth, death) in zip(self._degrees().tolist(), self._intervals.tolist()):
            yield degree, birth, death

    def __eq__(self, other) -> bool:
        """Whether two diagrams have the same bars, bit for bit."""
        if not isinstance(other, Diagram):
            return NotImplemented
        if self._intervals.tobytes() != other._intervals.tobytes():
            return False
        return np.array_equal(self._degrees(), other._degrees())

    __hash__ = None

    def __repr__(self) -> str:
        counts = ", ".join("%d of degree %d" % (n, k) for k, n in enumerate(np.diff(self._starts)))
        return "<netmesh.Diagram %s: %s; certified ratio %.6g>" % (self.filter, counts, self.certified_ratio)

    @property
    def filter(self) -> str:
        """The filter's name, "" for a complex given by its simplices."""
        return self._facts["filter"]

    @property
    def certified_ratio(self) -> float:
        """c >= 1: the diagram is within the factor c of that of :attr:`reference`, by the log-bottleneck distance."""
        return self._facts["certified_ratio"]

    @property
    def certified_from(self) -> float:
        """The radius from which the ratio holds."""
        return self._facts["certified_from"]

    @property
    def certified_error(self) -> float:
        """Of the filter "function": no birth or death is farther off than this; 0 for other filters."""
        return self._facts["certified_error"]

    @property
    def reference(self) -> str:
        """The function that the certificate is about."""
        return self._facts["reference"]

    @property
    def fingerprint(self) -> str:
        """16 hexadecimal digits for the whole result, the same on every platform; "" of a file."""
        return self._facts["fingerprint"]

    @property
    def report(self) -> dict:
        """All figures of the run by name, as ``netmesh persist --json`` has them; empty for a file."""
        return figures(self._report) if self._report is not None else {}

    def to_gudhi(self, units: str = "radius") -> List[Tuple[int, Tuple[float, float]]]:
        """The list of (degree, (birth, death)) that GUDHI's functions take, degrees descending as in
        ``SimplexTree.persistence``. ``units``: "radius", "diameter" (GUDHI's Rips complexes) or "squared" (its alpha
        complexes)."""
        scale = {"radius": lambda x: x, "diameter": lambda x: 2 * x, "squared": lambda x: x * abs(x)}.get(units)
        if scale is None:
            raise InvalidArgument("units: %r is none of radius, diameter, squared" % (units,), "units")
        in_squares = self._facts.get("squares")
        found = []
        for degree in range(self.max_degree, -1, -1):
            bars = self.intervals(degree)
            if in_squares and units != "squared":
                bars = np.sign(bars) * np.sqrt(np.abs(bars))
            bars = bars if in_squares and units == "squared" else scale(bars)
            found += [(degree, (b, d)) for b, d in bars.tolist()]
        return found

    def plot(self, axes=None, kind: str = "diagram"):
        """Draws the diagram with matplotlib, by ``kind`` as points ("diagram") or bars ("barcode"). Returns the
        axes."""
        from . import _plot
        return _plot.draw(self, axes, kind)

    def _repr_svg_(self) -> str:
        """Its barcode, where a notebook shows it."""
        from . import _svg
        return _svg.barcode(self)

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Writes the diagram, by the ending: .pers as ``netmesh check`` reads it, .csv, .npy (float64 [m, 3]), or .svg,
        a picture of its barcode."""
        from . import _files
        _files.save(self, path)


def _alive(bars, radii):
    """At each radius the number of bars: those born by then less those dead by then."""
    return (np.searchsorted(np.sort(bars[:, 0]), radii, side="right") -
            np.searchsorted(np.sort(bars[:, 1]), radii, side="right"))


def read(session, points=None):
    """The diagram that a session's context holds, with what its request wants besides. Of points whose filter is on no
    mesh cycles are of their rows."""
    report, request = session.report(), session.request
    part = report.diagram
    degrees = part.max_degree + 1
    counts = part.pairs[:degrees]
    starts = [0]
    for count in counts:
        starts.append(starts[-1] + count)
    count = starts[-1]
    intervals = np.empty((count, 2))
    session.call(lib.netmesh_array_pairs, session.context, count, address(intervals), None)
    name = FILTER_NAMES.get(part.filter, "")
    reference = FILTERS[name].reference if name else "filtered complex"
    if report.input.weighting:
        reference = "unions of balls about the points in R^{D}"
    if report.input.periods:
        reference += " modulo the lattice"
    facts = {
        "filter": name, "certified_ratio": part.certified_ratio, "certified_from": part.certified_from,
        "certified_error": part.certified_error,
        "reference": reference.replace("{k}", str(part.k)).replace("{D}", str(report.input.dim)),
        "fingerprint": "%016x" % report.fingerprint,
        "squares": bool(request.squares) if name else None,  # None: not known
    }
    bounds = _read_bounds(session, count, report.bounds.steps) if request.bounds else None
    cycles = _read_cycles(session, starts, report.input.periods) if request.cycles else None
    is_merged = report.input.duplicates and not report.input.periods  # of which cycles have rows already
    if cycles is not None and points is not None and is_merged and not FILTERS[name].is_on_mesh:
        rows = first_rows(points)
        cycles = Representatives([rows[cycle] for cycle in cycles])
    return Diagram(intervals, starts, facts, report, bounds, cycles)


def warn_of_function(diagram):
    """Where values contradict what is said of the function: the caller's caller is told."""
    if diagram.filter == "function" and np.isinf(diagram.certified_error):
        warnings.warn("function: nothing is certified, certified_error is infinite: some value contradicts lipschitz "
                      "and cut; where function(x) is below cut outside of the ball around the points, take a lower cut",
                      stacklevel=3)


def _read_bounds(session, count, step_count):
    numbers = np.empty((count, 5))
    certain = np.empty(count, dtype=np.uint8)
    steps = np.empty((step_count, 6))
    session.call(lib.netmesh_array_bounds, session.context, count, address(numbers), address(certain))
    session.call(lib.netmesh_array_steps, session.context, step_count, address(steps))
    return Bounds(numbers[:, 0:2], numbers[:, 2:4], certain.view(bool), numbers[:, 4], steps)


def _read_cycles(session, starts, axes):
    count = starts[-1]
    begins = np.empty(count + 1, dtype=np.uint64)
    session.call(lib.netmesh_array_cycle_starts, session.context, count, address(begins))
    sizes = np.diff(begins.astype(np.int64)).tolist()
    cycles, translations = [], []
    for degree in range(len(starts) - 1):
        for pair in range(starts[degree], starts[degree + 1]):
            # In degree 0 a simplex is a vertex.
            cycle = np.empty((sizes[pair], degree + 1), dtype=np.int32)
            session.call(lib.netmesh_array_cycle, session.context, pair, degree, sizes[pair], address(cycle), None)
            cycles.append(cycle)
            if axes:
                times = np.empty((sizes[pair], degree + 1, axes), dtype=np.int32)
                session.call(lib.netmesh_array_cycle_translations, session.context, pair, degree, sizes[pair], axes,
                             address(times))
                translations.append(times)
    return Representatives(cycles, translations if axes else None)


def top_degree_of(diagram):
    """The highest degree of what bars_of takes; None where that is not known."""
    if isinstance(diagram, Diagram):
        return diagram.max_degree
    if _is_by_degree(diagram):
        return len(diagram) - 1 if diagram else None
    shape = np.shape(diagram)
    return 0 if len(shape) == 2 and shape[1] == 2 else None


def _is_by_degree(diagram):
    return isinstance(diagram, (list, tuple)) and all(getattr(part, "ndim", 0) == 2 for part in diagram)


def bars_of(diagram, argument):
    """The bars of a Diagram, of an array [m, 2] or [m, 3], or of a list of arrays [m, 2] by degree, as the library's
    pairs."""
    if isinstance(diagram, Diagram):
        rows = diagram.pairs
    elif _is_by_degree(diagram):
        rows = [np.column_stack((np.full(len(part), k), part)) for k, part in enumerate(diagram)]
        rows = np.concatenate(rows) if rows else np.empty((0, 3))
    else:
        try:
            rows = np.asarray(diagram, dtype=np.float64)
        except (TypeError, ValueError):
            _refuse_bars(diagram, argument)
        if rows.size == 0:
            rows = np.empty((0, 3))
        if rows.ndim == 2 and rows.shape[1] == 2:
            rows = np.column_stack((np.zeros(len(rows)), rows))
    if rows.ndim != 2 or rows.shape[1] != 3:
        _refuse_bars(diagram, argument)
    degrees = rows[:, 0]
    wrong = np.flatnonzero(~((degrees >= 0) & (degrees <= 1000) & (degrees == np.floor(degrees))))
    if len(wrong):
        raise InvalidArgument("%s, row %d: not a degree" % (argument, wrong[0]), argument, int(wrong[0]))
    wrong = np.flatnonzero(~(np.isfinite(rows[:, 1]) & (rows[:, 2] >= rows[:, 1])))
    if len(wrong):
        raise InvalidArgument("%s, row %d: births are finite, deaths not before them" % (argument, wrong[0]), argument,
                              int(wrong[0]))
    pairs = np.zeros(len(rows), dtype=[("struct_bytes", "u4"), ("degree", "u4"), ("birth", "f8"), ("death", "f8")])
    pairs["struct_bytes"] = pairs.itemsize
    pairs["degree"], pairs["birth"], pairs["death"] = degrees, rows[:, 1], rows[:, 2]
    return pairs


def _refuse_bars(diagram, argument):
    text = "%s: no Diagram, no bars [m, 2] or [m, 3], no list of arrays [m, 2] by degree" % argument
    try:
        is_of_gudhi = all(len(bar) == 2 and np.ndim(bar[0]) == 0 and len(bar[1]) == 2 for bar in diagram)
    except TypeError:
        is_of_gudhi = False
    if is_of_gudhi:
        text += "; of a list of GUDHI, (degree, (birth, death)), numpy.array([(k, *bar) for k, bar in %s])" % argument
    raise InvalidArgument(text, argument) from None
