"""Triangulations and quality meshes."""
import contextlib
import ctypes
from typing import Callable, Optional, Sequence, Tuple, Union

import numpy as np

from . import _declarations as c
from . import _diagram
from ._arrays import address, choice, doubles, points_of, weights_of
from ._diagram import Diagram
from ._library import lib, sized
from ._options import fill, focus_of, put_function, put_weights, request_of
from ._session import Session, figures
from .errors import InvalidArgument

PURPOSES = {"mesh": None, "persist": "complete", "tight": "tight"}  # the filter that it is for
CHECKS = {"combinatorial": c.NETMESH_CHECK_COMBINATORIAL, "geometric": c.NETMESH_CHECK_GEOMETRIC,
          "delaunay": c.NETMESH_CHECK_DELAUNAY, "quality": c.NETMESH_CHECK_QUALITY, "bounds": c.NETMESH_CHECK_BOUNDS,
          "all": c.NETMESH_CHECK_ALL}


class Mesh:
    """A Delaunay triangulation, or a quality mesh, and the memory that it lives in. Arrays are read when they are first
    asked for, and stay the same arrays."""

    def __init__(self, session, dim, request=None):
        self._session = session
        self._request = request  # what the mesh promises
        self._kept = session.callbacks[:]  # which its sizes may be among
        self._report = session.report()
        self._arrays = {}
        self._written = (self._report.memory.peak_bytes,)  # None: not known
        #: D, the number of coordinates of a vertex.
        self.dim: int = dim

    def _read(self, name):
        if name not in self._arrays:
            part = self._report.mesh
            if name in ("vertices", "markers"):
                vertices = np.empty((part.vertices, self.dim))
                markers = np.empty(part.vertices, dtype=np.uint8)
                self._call(lib.netmesh_array_vertices, self.dim, part.vertices, address(vertices), address(markers),
                           None)
                self._arrays.update(vertices=vertices, markers=markers)
            elif name == "values":
                values = np.empty(part.vertices)
                self._call(lib.netmesh_array_vertices, self.dim, part.vertices, None, None, address(values))
                self._arrays["values"] = values
            elif name == "cages":
                count = part.hierarchy.cages
                cages = np.empty(count, dtype=[("centre", "i4"), ("parent", "i4"), ("radius", "f8")])
                arrays = [np.empty(count, dtype=kind) for kind in ("i4", "i4", "f8")]
                self._call(lib.netmesh_array_cages, count, *map(address, arrays))
                for field, array in zip(cages.dtype.names, arrays):
                    cages[field] = array
                self._arrays["cages"] = cages
            else:
                cells = np.empty((part.cells, self.dim + 1), dtype=np.int32)
                neighbours = np.empty_like(cells) if name == "neighbours" else None
                self._call(lib.netmesh_array_cells, self.dim, part.cells, address(cells), address(neighbours))
                self._arrays.setdefault("cells", cells)
                if neighbours is not None:
                    self._arrays["neighbours"] = neighbours
        return self._arrays[name]

    def _call(self, function, *arguments):
        session = self._session
        session.enter()
        try:
            if session.context is None:
                raise InvalidArgument("the mesh is closed")
            session.call(function, session.context, *arguments)
        finally:
            session.lock.release()

    @contextlib.contextmanager
    def _opened(self, progress):
        """The session, for one call at a time."""
        session = self._session
        session.enter()
        try:
            if session.context is None:
                raise InvalidArgument("the mesh is closed")
            session.unwatch()
            if progress is not None:
                session.show(progress)
            self._written = None
            yield session
        finally:
            session.lock.release()

    @property
    def vertices(self) -> np.ndarray:
        """float64 [v, D]. The input points come first, in input order after merging duplicates, bit for bit; Steiner
        points follow."""
        return self._read("vertices")

    @property
    def markers(self) -> np.ndarray:
        """uint8 [v]: 0 an input, 1 a Steiner point, 2 one that is exempt from quality."""
        return self._read("markers")

    @property
    def cells(self) -> np.ndarray:
        """int32 [c, D + 1]: the vertices of each cell, positively oriented."""
        return self._read("cells")

    @property
    def neighbours(self) -> np.ndarray:
        """int32 [c, D + 1]: ``neighbours[i, j]`` is the cell opposite vertex ``cells[i, j]``, -1 outside."""
        return self._read("neighbours")

    @property
    def values(self) -> Optional[np.ndarray]:
        """float64 [v]: the filter value of each vertex, a radius, after :meth:`persist` with a filter on meshes; else
        None."""
        row = self._report.diagram
        return self._read("values") if row.present and row.filter and self._report.mesh.is_mesh else None

    @property
    def cages(self) -> np.ndarray:
        """[g] of centre (a vertex), parent (a cage, -1 for none) and radius: of method "netmesh" without finish."""
        return self._read("cages")

    @property
    def domain(self) -> Optional[Tuple[np.ndarray, float]]:
        """Centre [D] and radius of the ball that was meshed; None of a triangulation."""
        if not self._report.mesh.is_mesh:
            return None
        ball = self._report.mesh.domain
        return np.array(ball[:self.dim]), ball[self.dim]

    @property
    def aspect_ratio_max(self) -> float:
        """The worst aspect ratio of a clipped Voronoi cell."""
        return self._report.mesh.aspect_ratio_max

    @property
    def fingerprint(self) -> str:
        """16 hexadecimal digits for mesh and diagram, the same on every platform."""
        return "%016x" % self._report.fingerprint

    @property
    def report(self) -> dict:
        """All figures of the run by name, as ``netmesh mesh --json`` has them."""
        return figures(self._report)

    def __repr__(self) -> str:
        part = self._report.mesh
        kind = "mesh" if part.is_mesh else "triangulation"
        return "<netmesh.Mesh: %s of %d points in R^%d, %d vertices, %d cells>" % (
            kind, part.inputs, self.dim, part.vertices, part.cells)

    def persist(self, filter: Optional[str] = None, max_degree: Optional[int] = None, *, k: Optional[int] = None,
                values: Optional[str] = None, function: Optional[Callable] = None, lipschitz: Optional[float] = None,
                cut: Optional[float] = None, distance_factor: Optional[float] = None, keep_zero_pairs: bool = False,
                bounds: bool = False, representatives: bool = False,
                progress: Union[bool, Callable, None] = None) -> Diagram:
        """The diagram of a filter on this mesh ("complete", "basic", "knn", "kdistance", "function", "tight") or
        triangulation ("alpha"). Arguments are those of :func:`netmesh.persist`."""
        filter = filter or ("complete" if self._report.mesh.is_mesh else "alpha")
        given = dict(filter=filter, max_degree=max_degree, k=k, values=values, keep_zero_pairs=keep_zero_pairs,
                     bounds=bounds, cycles=representatives)
        diagram = self._made(given, (function, lipschitz, cut, distance_factor), progress, _diagram.read)
        _diagram.warn_of_function(diagram)
        return diagram

    def _made(self, given, function, progress, read):
        """What is asked of the mesh by options of the table."""
        with self._opened(progress) as session:
            self._arrays.pop("values", None)
            request = request_of(session)
            fill(session, given)
            put_function(session, self.dim, *function)
            try:
                session.call(lib.netmesh_persist, session.context, ctypes.addressof(request))
                return read(session)
            finally:
                self._report = session.report()

    def vineyard(self, k: Tuple[int, int], filter: str = "knn", max_degree: Optional[int] = None, *,
                 values: Optional[str] = None, progress: Union[bool, Callable, None] = None):
        """The diagrams of "knn" or "kdistance" for k from ``k[0]`` to ``k[1]`` on this mesh, and the vines through
        them: see :func:`netmesh.vineyard`."""
        from . import _vineyard
        return self._made(_vineyard.asked(k, filter, max_degree, values), (), progress, _vineyard.Vineyard)

    def check(self, what: str = "all", *, progress: Union[bool, Callable, None] = None) -> None:
        """Checks the mesh anew, exactly, by code that shares nothing with what made it: "combinatorial", "geometric",
        "delaunay", "quality", "bounds" or "all". Raises :class:`netmesh.errors.CheckFailed`."""
        request = sized(c.netmesh_check_request)
        request.what = choice(what, "what", CHECKS)
        if self._request is not None:
            request.promised = ctypes.addressof(self._request)
        with self._opened(progress) as session:
            request.monitor = session.monitor
            session.call(lib.netmesh_check, session.context, ctypes.addressof(request))

    def close(self) -> None:
        """Gives the memory back; arrays that were read stay."""
        session = self._session
        session.enter()
        try:
            session.end(*self._written or ())
        finally:
            session.lock.release()

    def __del__(self) -> None:
        session = getattr(self, "_session", None)
        if session is not None:
            session.end(*self._written or ())

    def __enter__(self) -> "Mesh":
        return self

    def __exit__(self, *_) -> None:
        self.close()


def delaunay(points, *, purpose: str = "mesh", seed: int = 1, memory: Union[int, str, None] = None,
             progress: Union[bool, Callable, None] = None, radii: Optional[Sequence[float]] = None,
             weights: Optional[Sequence[float]] = None) -> Mesh:
    """The Delaunay triangulation of points, exact for all finite numbers, ties by index.

    ``points``: [n, D], D from 2 to 6; float64 or float32 is read where it lies. Duplicates are merged. ``purpose``:
    "persist" plans for an alpha diagram. ``radii``, ``weights``: [n], the regular triangulation of balls; hidden points
    are in no cell. These, ``seed`` and ``memory``: see :func:`netmesh.persist`. Raises
    :class:`netmesh.errors.Flat` where there are fewer than D + 1 affinely independent points.
    """
    plan = choice(purpose, "purpose", {"mesh": lib.netmesh_plan_mesh, "persist": lib.netmesh_plan})
    session = Session(memory, progress)
    balls = weights_of(radii, weights)
    read = points_of(points) if balls is None else points_of(doubles(points, "points", 2))
    request = request_of(session, read)
    put_weights(session, balls)
    fill(session, dict(seed=seed, method="delaunay", filter="alpha", keep_mesh=True))
    return _meshed(session, request, plan)


def _meshed(session, request, plan, promised=None):
    at = ctypes.addressof(request)
    session.run(plan(at), lambda: session.call(lib.netmesh_mesh, session.context, at), True)
    made = Mesh(session, request.points.dim, promised)
    request.points.coordinates = request.points.weights = None
    session.kept.clear()
    return made


def mesh(points, tau: Optional[float] = None, *, method: Optional[str] = None, purpose: str = "mesh",
         eps: Optional[float] = None, size: Optional[Callable] = None, size_at_inputs: Optional[float] = None,
         size_growth: Optional[float] = None, ratio: Optional[float] = None,
         focus: Optional[Tuple[float, float, float]] = None, whole_cells: bool = False,
         domain_factor: Optional[float] = None, finish: bool = False, cages: Optional[str] = None,
         net_spacing: Optional[float] = None, audit: Union[str, Sequence[str], None] = None, seed: int = 1,
         memory: Union[int, str, None] = None, progress: Union[bool, Callable, None] = None) -> Mesh:
    """A quality mesh of points: the Delaunay triangulation of them and of Steiner points whose Voronoi cells, clipped
    to a ball around the points, have aspect ratios of at most ``tau``.

    points: [n, D], D from 2 to 6; float64 or float32 is read where it lies.
    tau: above 2; by default 2.5 (D = 2, 3), 3.08 (4), 4 (5, 6).
    method: "svr"; "netmesh", a hierarchical mesh with cages, of linear size whatever the spread, ``finish`` turns it
        into one without, and ``cages="thesis"`` takes the cages of the thesis; "refine"; with a ratio "certificate".
    purpose: "persist" meshes a shell around the domain too, for :meth:`Mesh.persist`; "tight" for the tight filter.
    eps: no clipped cell reaches farther than eps times the distance to the second nearest input.
    size: a function of x, float64 [D], the farthest that a cell at x may reach; in units of the coordinates.
    size_at_inputs, size_growth: none reaches farther than the one plus the other times the distance to the nearest
        input.
    ratio, focus: a mesh refined by the certificate of the complete filter in place of one by aspect ratios, with
        ``purpose="persist"``: see :func:`netmesh.persist`.
    domain_factor: the radius of the domain over that of the smallest ball around the points, 1 to 8.
    net_spacing: of "refine", how far apart the vertices of its boundary net are, over the diameter of the points.
    audit: "location", "quality" or both: measures every intermediate mesh, for :attr:`Mesh.report`.
    seed, memory, progress: see :func:`netmesh.persist`.
    """
    filter = choice(purpose, "purpose", PURPOSES)
    of_diagram = filter == "tight"
    session = Session(memory, progress, renamed={} if of_diagram else {"size_eps": "eps"})
    read = points_of(points)
    request = request_of(session, read)
    if cages is not None and choice(cages, "cages", {"compact": "netmesh", "thesis": "thesis"}) == "thesis":
        if method != "netmesh":
            raise InvalidArgument('cages: go with method="netmesh"', "cages")
        method = "thesis"
    given = dict(filter=filter, method=method or ("svr" if ratio is None else "certificate"), tau=tau, ratio=ratio,
                 whole_cells=whole_cells, domain_factor=domain_factor, finish=finish, net_spacing=net_spacing,
                 audit=audit, size_at_inputs=size_at_inputs, size_growth=size_growth, seed=seed, **focus_of(focus))
    given["eps" if of_diagram else "size_eps"] = eps
    fill(session, given)
    if size is not None:
        request.mesh.sizes.size = session.evaluation(size, read[2], "size")
    return _meshed(session, request, lib.netmesh_plan_mesh, request)
