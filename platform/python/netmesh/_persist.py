"""Points or distances in, a diagram out."""
import ctypes
import math
from typing import Callable, Optional, Tuple, Union

import numpy as np

from . import _declarations as c
from . import _diagram
from ._arrays import doubles, number, points_of, put_points, whole
from ._diagram import Diagram
from ._library import FILTERS, lib, requested
from ._mesh import bound_here, function_of, persist_here, represent_here
from ._options import OF_EITHER, Options
from ._session import Session
from .errors import InvalidArgument


def persist(points, filter: str = "auto", max_degree: Optional[int] = None, *, k: Optional[int] = None,
            ratio: Optional[float] = None, focus: Union[str, Tuple[float, ...], None] = None,
            longer_than: Optional[float] = None, eps: Optional[float] = None, theta: Optional[float] = None,
            values: Optional[str] = None, tau: Optional[float] = None, method: Optional[str] = None,
            finish: bool = False, whole_cells: bool = False, function: Optional[Callable] = None,
            lipschitz: Optional[float] = None, cut: Optional[float] = None, error: Optional[float] = None,
            distance_factor: Optional[float] = None, keep_zero_pairs: bool = False, bounds: bool = False,
            representatives: bool = False, seed: Optional[int] = None, memory: Union[int, str, None] = None,
            fit: bool = False, progress: Union[bool, Callable, None] = None) -> Diagram:
    """The persistence diagram of points, over Z/2, with a certificate.

    points: [n, D], any array of numbers. float64 and float32 are read where they lie, also with gaps between rows;
        anything else is copied. D is from 2 to 6; for "rips" up to 65,536.
    filter: what grows around the points.
        "auto"        "alpha" where it is affordable, else "complete", as the engine finds; "complete" when an argument
                      asks for a mesh
        "alpha"       the union of balls, exactly
        "complete"    the union of balls within a ratio, on a mesh: any D
        "tight", "scales"   the same within 1 + ``eps``; "scales" for any spread of distances
        "knn", "kdistance"  the distance to the ``k``-th nearest point, the root mean square of the ``k`` nearest
        "function"    sublevel sets of ``function``
        "basic"       as "complete", from a radius on
        "rips", "cech"      complexes on the points themselves
        "barycentric-cech", "barycentric-rips"   sublevel sets of the distance to the ``k``-th nearest point
    max_degree: the highest degree of homology; by default D - 1, for complexes on points 1.
    ratio: the certified ratio to refine to, of "complete", "tight" and "scales"; above sqrt 2.
    focus: (ratio, from, to): a better ratio at radii between two bounds; "auto": where bars are undecided, until each
        is surely real or surely not ``longer_than`` (1.5) times its birth, or ``memory`` is full.
    eps, theta: of "tight" and "scales".
    values: "certified" or "thesis", the filter's own.
    tau, method, finish: a quality mesh in place of one refined by the certificate: see :func:`netmesh.mesh`.
    function, lipschitz, cut: a function of x, float64 [D], with abs(f(x) - f(y)) <= lipschitz * norm(x - y), and at
        least ``cut`` outside of a ball around the points; sublevel sets up to the cut. ``error``: how far births and
        deaths may be off; ``distance_factor``: a c with f >= (distance to the second nearest point) / c.
    keep_zero_pairs: pairs of length zero are kept.
    bounds: also where each true birth and death surely is: ``Diagram.bounds``.
    representatives: also a cycle for each bar: ``Diagram.representatives``.
    seed: of every random choice; by default 1.
    memory: bytes of the one block that all of it happens in, a number or "64M"; by default as much as it takes.
    fit: the best ratio that ``memory`` holds.
    progress: True for tqdm, or a function (stage, done, total, vertices, cells) that is called about every tenth of a
        second, and stops the job when it returns something true.

    Births and deaths are radii, in units of the coordinates.
    Raises exceptions of :mod:`netmesh.errors`, which name the argument and the row, and KeyboardInterrupt.
    """
    read = points_of(points)
    given = dict(max_degree=max_degree, k=k, ratio=ratio, focus=focus, longer_than=longer_than, eps=eps, theta=theta,
                 values=values, tau=tau, method=method, finish=finish, whole_cells=whole_cells, function=function,
                 lipschitz=lipschitz, cut=cut, error=error, distance_factor=distance_factor,
                 keep_zero_pairs=keep_zero_pairs, bounds=bounds, representatives=representatives, seed=seed, fit=fit,
                 memory=memory)
    if isinstance(filter, str) and filter == "auto":
        asked = {name for name, value in given.items() if value is not None and value is not False}
        if asked <= OF_EITHER:
            return _chosen(read, given, progress)
        filter = "complete"
    return _run(read, Options(read[2], filter, given), progress)


def _chosen(read, given, progress):
    """By the filter that the engine chooses."""
    asked = Options(read[2], "complete", given)
    session = Session(asked.memory, progress)
    request = requested(c.netmesh_auto_request, read[2])
    request.max_degree = asked.max_degree
    request.keep_zero_pairs = asked.keep_zero_pairs
    at = _prepared(session, request, read, asked)
    taken = []

    def work():
        session.call(lib.netmesh_persist_auto, session.context, at)
        chosen = session.report().diagram.filter
        taken[:] = [Options(read[2], name, given) for name, row in FILTERS.items() if row.filter == chosen]
        if asked.bounds:
            bound_here(session)
        if asked.representatives:
            represent_here(session)

    session.request = request
    try:
        session.run(lib.netmesh_plan_auto(at), work)
        diagram = _diagram.read(session, taken[0], asked.representatives)
    finally:
        session.end()
    return diagram


def _run(read, options, progress, threshold=math.inf):
    session = Session(options.memory, progress)
    source = options.filter.source
    if source == c.NETMESH_SOURCE_POINTS:
        plan, work = _on_points(session, options, read, threshold)
    elif source == c.NETMESH_SOURCE_SCALES:
        plan, work = _by_scales(session, options, read)
    elif source == c.NETMESH_SOURCE_DELAUNAY:
        plan, work = (_represented_alpha if options.representatives else _alpha)(session, options, read)
    elif options.fit or options.longer_than:
        plan, work = _fitted(session, options, read)
    else:
        plan, work = _on_mesh(session, options, read)
    try:
        session.run(plan, work)
        diagram = _diagram.read(session, options, options.representatives)
    finally:
        session.end()
    return diagram


def _prepared(session, request, read, options):
    request.dim = read[2]
    request.monitor = session.monitor
    put_points(request, read)
    if hasattr(request, "seed"):
        request.seed = options.seed
    return ctypes.addressof(request)


def _alpha(session, options, read):
    request = requested(c.netmesh_alpha_request, read[2])
    request.max_degree = options.max_degree
    request.keep_zero_pairs = options.keep_zero_pairs
    at = _prepared(session, request, read, options)

    def work():
        session.call(lib.netmesh_persist_alpha, session.context, at)
        if options.bounds:
            bound_here(session)

    session.request = request
    return lib.netmesh_plan_alpha(at), work


def _represented_alpha(session, options, read):
    request = requested(c.netmesh_delaunay_request, read[2])
    request.purpose = c.NETMESH_PURPOSE_PERSIST
    at = _prepared(session, request, read, options)

    def work():
        session.call(lib.netmesh_delaunay, session.context, at)
        persist_here(session, options)

    session.request = request
    return lib.netmesh_plan_delaunay(at), work


def _on_points(session, options, read, threshold):
    request = requested(c.netmesh_points_request, read[2], options.filter.filter)
    options.put_diagram(request)
    if options.filter.needs_k:
        request.k = options.k
    request.representatives = options.representatives
    request.threshold = threshold if threshold != 0 else 5e-324  # 0 is no limit there
    at = _prepared(session, request, read, options)

    def work():
        session.call(lib.netmesh_persist_points, session.context, at)
        if options.bounds:
            bound_here(session)

    session.request = request
    return lib.netmesh_plan_points(at), work


def _by_scales(session, options, read):
    request = requested(c.netmesh_scales_request, read[2])
    options.put_diagram(request)
    request.tau = options.tau_given
    request.eps = options.eps
    request.ratio = options.ratio or 0.0
    request.theta = options.theta
    request.bounds = options.bounds
    request.representatives = options.representatives
    at = _prepared(session, request, read, options)
    session.request = request
    return lib.netmesh_plan_scales(at), lambda: session.call(lib.netmesh_persist_scales, session.context, at)


def _on_mesh(session, options, read):
    request = options.mesh_request()
    at = _prepared(session, request, read, options)
    function = function_of(session, options)
    if options.error:
        sizes = c.netmesh_python_sizes(ctypes.addressof(function), options.error)
        request.sizes.size = lib.addresses["netmesh_python_size"]
        request.sizes.user = ctypes.addressof(sizes)
        session.callbacks.append(sizes)

    def work():
        session.call(lib.netmesh_mesh, session.context, at)
        persist_here(session, options, function)

    session.request = request
    return lib.netmesh_plan_mesh(at), work


def _fitted(session, options, read):
    request = options.fit_request()
    at = _prepared(session, request, read, options)
    function = function_of(session, options)
    if function is not None:
        request.function = ctypes.addressof(function)
        session.callbacks.append(function)

    def work():
        session.call(lib.netmesh_fit, session.context, at)
        if options.longer_than:
            options.take_goal(session.report().mesh.certificate)
        if options.representatives:
            represent_here(session)

    session.request = request
    return 0, work


def rips(points=None, threshold: float = math.inf, max_degree: int = 1, *, distances=None,
         keep_zero_pairs: bool = False, representatives: bool = False, memory: Union[int, str, None] = None,
         progress: Union[bool, Callable, None] = None) -> Diagram:
    """The Vietoris-Rips diagram of points, or of anything that is known by its distances.

    points: [n, D], any D; Euclidean distances.
    distances: instead of points: [n, n], symmetric; [n (n - 1) / 2], the condensed form of
        ``scipy.spatial.distance.pdist``; or a sparse matrix of scipy, whose missing entries are never joined.
    threshold: a radius, as all values are: points farther apart than twice that are not joined.
    max_degree: the highest degree of homology.
    representatives: also a cycle for each bar, by the rows of the input (of points: after merging duplicates).

    Births and deaths are radii, half of the distances at which GUDHI and ripser have them.
    """
    if (points is None) == (distances is None):
        raise InvalidArgument("points: give points or distances", "points")
    threshold = number(threshold, "threshold")
    if points is not None:
        read = points_of(points)
        if read[2] == 1:  # the library's points have two coordinates at least
            read = points_of(np.column_stack((read[0], np.zeros(read[1]))))
        given = dict(max_degree=max_degree, keep_zero_pairs=keep_zero_pairs, representatives=representatives,
                     memory=memory)
        return _run(read, Options(read[2], "rips", given), progress, threshold)
    session = Session(memory, progress, rows="distances")
    request = requested(c.netmesh_distances_request)
    request.monitor = session.monitor
    request.threshold = threshold
    request.max_degree = whole(max_degree, "max_degree", 0, 30)
    request.keep_zero_pairs = bool(keep_zero_pairs)
    request.representatives = bool(representatives)
    if hasattr(distances, "tocoo"):
        kept = _put_sparse(request, distances)
    else:
        kept = _put_matrix(request, distances)
    at = ctypes.addressof(request)
    try:
        session.run(lib.netmesh_plan_distances(at),
                    lambda: session.call(lib.netmesh_persist_distances, session.context, at))
        diagram = _diagram.read(session, None, representatives)
    finally:
        session.end()
    del kept
    return diagram


def _put_matrix(request, distances):
    shape = np.shape(distances)
    if len(shape) == 1:
        return _put_condensed(request, doubles(distances, "distances", 1))
    array = doubles(distances, "distances", 2)
    if array.shape[0] != array.shape[1]:
        raise InvalidArgument("distances: [%d, %d] is not square" % array.shape, "distances")
    request.layout = c.NETMESH_DISTANCES_FULL
    request.numbers = array.ctypes.data or 8
    request.point_count = array.shape[0]
    return array


def _put_condensed(request, condensed):
    """pdist goes by rows of the upper triangle, the library by rows of the lower one."""
    count = int(round((1 + math.sqrt(1 + 8 * len(condensed))) / 2))
    if count * (count - 1) // 2 != len(condensed):
        raise InvalidArgument("distances: %d numbers are no condensed matrix" % len(condensed), "distances")
    rows, columns = np.tril_indices(count, -1)
    array = condensed[columns * (2 * count - columns - 1) // 2 + rows - columns - 1]
    request.layout = c.NETMESH_DISTANCES_LOWER
    request.numbers = array.ctypes.data or 8
    request.point_count = count
    return array


def _put_sparse(request, matrix):
    matrix = matrix.tocoo()
    if matrix.shape[0] != matrix.shape[1]:
        raise InvalidArgument("distances: [%d, %d] is not square" % matrix.shape, "distances")
    entries = np.zeros(len(matrix.data), dtype=[("i", "u4"), ("j", "u4"), ("distance", "f8")])
    entries["i"], entries["j"], entries["distance"] = matrix.row, matrix.col, matrix.data
    request.layout = c.NETMESH_DISTANCES_SPARSE
    request.entries = entries.ctypes.data
    request.entry_count = len(entries)
    request.point_count = matrix.shape[0]
    return entries


def homology(simplices, values, max_degree: Optional[int] = None, *, keep_zero_pairs: bool = False,
             representatives: bool = False, memory: Union[int, str, None] = None,
             progress: Union[bool, Callable, None] = None) -> Diagram:
    """The diagram of any filtered simplicial complex.

    simplices: a list of lists of vertices, in any order; every face has to be there.
    values: [m], when each simplex enters: finite, and no face later than what it is a face of.
    """
    vertices, starts = flat_simplices(simplices)
    entries = doubles(values, "values", 1)
    if len(entries) != len(starts) - 1:
        raise InvalidArgument("values: %d numbers for %d simplices" % (len(entries), len(starts) - 1), "values")
    session = Session(memory, progress, rows="simplices")
    request = requested(c.netmesh_homology_request)
    request.monitor = session.monitor
    if max_degree is not None:
        request.max_degree = whole(max_degree, "max_degree", 0, c.NETMESH_DEGREE_MAX)
    request.vertices, request.starts = vertices.ctypes.data, starts.ctypes.data
    request.entries = entries.ctypes.data
    request.simplex_count, request.vertex_count = len(entries), len(vertices)
    request.keep_zero_pairs = bool(keep_zero_pairs)
    request.representatives = bool(representatives)
    at = ctypes.addressof(request)
    try:
        session.run(lib.netmesh_plan_homology(at), lambda: session.call(lib.netmesh_homology, session.context, at))
        diagram = _diagram.read(session, None, representatives)
    finally:
        session.end()
    return diagram


def flat_simplices(simplices):
    """uint32 vertices one simplex after the other, uint64 where each begins."""
    try:
        lists = [[int(v) for v in simplex] for simplex in simplices]
        vertices = np.array([v for simplex in lists for v in simplex], dtype=np.int64)
    except (TypeError, ValueError, OverflowError):
        raise InvalidArgument("simplices: not lists of vertices", "simplices") from None
    if len(vertices) and (vertices.min() < 0 or vertices.max() > 2 ** 32 - 1):
        raise InvalidArgument("simplices: vertices are numbers from 0 to 2^32 - 1", "simplices")
    starts = np.zeros(len(lists) + 1, dtype=np.uint64)
    np.cumsum([len(simplex) for simplex in lists], out=starts[1:])
    return vertices.astype(np.uint32), starts
