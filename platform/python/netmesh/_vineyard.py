"""Vineyards: diagrams over a range of k, or over a sequence of filtrations, and the classes that they share."""
import ctypes
from typing import Callable, List, Optional, Tuple, Union

import numpy as np

from ._arrays import address, doubles, points_of, whole
from ._diagram import Diagram
from ._library import FILTER_NAMES, FILTERS, lib
from ._options import fill, known, request_of
from ._persist import put_simplices
from ._session import Session, figures
from .errors import InvalidArgument


class Vineyard:
    """The points of vines, sorted by vine and k. Each k's points are that k's diagram."""

    def __init__(self, session):
        report = session.report()
        part = report.vineyard
        count = part.points
        #: int32 [m]: which vine a point is of.
        self.vines: np.ndarray = np.empty(count, dtype=np.int32)
        #: int32 [m]: the degree of homology.
        self.degrees: np.ndarray = np.empty(count, dtype=np.int32)
        #: int32 [m]: k, or the number of the step, from 1 on.
        self.ks: np.ndarray = np.empty(count, dtype=np.int32)
        #: float64 [m, 2]: birth and death, radii.
        self.intervals: np.ndarray = np.empty((count, 2))
        session.call(lib.netmesh_array_vines, session.context, count, address(self.vines), address(self.degrees),
                     address(self.ks), address(self.intervals))
        #: The first and the last k.
        self.k: Tuple[int, int] = (part.k_first, part.k_last)
        #: How many vines there are.
        self.count: int = part.vines
        #: The highest degree of homology.
        self.max_degree: int = part.max_degree
        ratio = ctypes.c_double()
        ratios = []
        for k in range(part.k_first, part.k_last + 1):
            session.call(lib.netmesh_get_vine_ratio, session.context, k, ctypes.addressof(ratio))
            ratios.append(ratio.value)
        #: float64 [ks]: the certified ratio of each k's diagram, from the first k on.
        self.ratios: np.ndarray = np.array(ratios)
        self._filter = FILTER_NAMES.get(part.filter, "")
        self._dim = report.input.dim
        self._report = report

    @property
    def fingerprint(self) -> str:
        """16 hexadecimal digits, the same on every platform."""
        return "%016x" % self._report.fingerprint

    @property
    def report(self) -> dict:
        """All figures of the run by name."""
        return figures(self._report)

    def diagram(self, k: int) -> Diagram:
        """The diagram at one k."""
        whole(k, "k", *self.k)
        at = self.ks == k
        degrees, intervals = self.degrees[at], self.intervals[at]
        order = np.lexsort((intervals[:, 1], intervals[:, 0], degrees))
        starts = np.searchsorted(degrees[order], np.arange(self.max_degree + 2)).tolist()
        row = FILTERS.get(self._filter)
        reference = row.reference if row else "filtered complex"
        facts = {"filter": self._filter, "certified_ratio": float(self.ratios[k - self.k[0]]), "certified_from": 0.0,
                 "certified_error": 0.0, "fingerprint": "",
                 "reference": reference.replace("{k}", str(k)).replace("{D}", str(self._dim))}
        return Diagram(np.ascontiguousarray(intervals[order]), starts, facts)

    def vine(self, number: int) -> Tuple[np.ndarray, np.ndarray]:
        """The path of one vine: its ks, int32 [l], and births and deaths, float64 [l, 2]."""
        whole(number, "number", 0, max(0, self.count - 1))
        at = self.vines == number
        return self.ks[at], self.intervals[at]

    def __repr__(self) -> str:
        return "<netmesh.Vineyard: %d vines, k from %d to %d>" % (self.count, *self.k)


def asked(k, filter, max_degree, values):
    """Options of the table for a range of k."""
    try:
        first, last = k
    except (TypeError, ValueError):
        raise InvalidArgument("k: (first, last) is due", "k") from None
    return dict(filter=filter, k=first, k_last=last, max_degree=max_degree, values=values, vines=True)


def vineyard(points=None, k: Tuple[int, int] = (1, 2), filter: str = "knn", max_degree: Optional[int] = None, *,
             values: Optional[str] = None, tau: Optional[float] = None, seed: int = 1,
             simplices: Optional[List] = None, steps=None, by_vertex: bool = False,
             memory: Union[int, str, None] = None, progress: Union[bool, Callable, None] = None,
             **others) -> Vineyard:
    """The diagrams of a filter for every k of a range, and the vines through them.

    points: [n, D], D from 2 to 6.
    k: (first, last).
    filter: "knn" or "kdistance" on a mesh of aspect ratio ``tau``; "barycentric-cech" or "barycentric-rips" on the
        points themselves.
    simplices, steps: in place of points a filtered complex and its values at each step, [s, m]; ``by_vertex``: [s, v],
        values of the vertices alone.
    others: options of the mesh by the engine's names, as of :func:`netmesh.persist`.
    """
    if simplices is None and points is None:
        raise InvalidArgument("points: give points, or simplices and steps", "points")
    if simplices is None:
        session = Session(memory, progress)
        read = points_of(points)
        request = request_of(session, read)
        fill(session, dict(asked(k, filter, max_degree, values), tau=tau, seed=seed, **known(vineyard, others)))
    else:
        session = Session(memory, progress, rows="simplices", renamed={"entries": "steps", "step_count": "steps"})
        request = request_of(session)
        fill(session, dict(filter="simplices", max_degree=max_degree, vines=True, **known(vineyard, others)))
        put_simplices(session, simplices, doubles(steps, "steps", 2), by_vertex)
    at = ctypes.addressof(request)
    try:
        session.run(lib.netmesh_plan(at), lambda: session.call(lib.netmesh_persist, session.context, at))
        return Vineyard(session)
    finally:
        session.end()
