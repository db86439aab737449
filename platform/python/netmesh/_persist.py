"""Points or distances in, a diagram out."""
import concurrent.futures
import ctypes
import math
import os
import warnings
from typing import Any, Callable, Optional, Sequence, Tuple, Union

import numpy as np

from . import _declarations as c
from . import _diagram
from ._arrays import atoms_of, doubles, lattice_of, points_of, weights_of
from ._diagram import Diagram
from ._library import OPTIONS, lib, sized
from ._options import (as_asked, fill, focus_of, known, put_function, put_lattice, put_weights, request_of,
                       settled)
from ._session import Session
from .errors import InvalidArgument

LONGER_THAN = 1.5  # of focus="auto", as of the tool


def persist(points, filter: str = "auto", max_degree: Optional[int] = None, *, k: Optional[int] = None,
            ratio: Optional[float] = None, focus: Union[str, Tuple[float, ...], None] = None,
            longer_than: Optional[float] = None, eps: Optional[float] = None, theta: Optional[float] = None,
            values: Optional[str] = None, tau: Optional[float] = None, method: Optional[str] = None,
            finish: bool = False, whole_cells: bool = False, function: Optional[Callable] = None,
            lipschitz: Optional[float] = None, cut: Optional[float] = None, error: Optional[float] = None,
            distance_factor: Optional[float] = None, keep_zero_pairs: bool = False, bounds: bool = False,
            representatives: bool = False, seed: Optional[int] = None, memory: Union[int, str, None] = None,
            fit: bool = False, progress: Union[bool, Callable, None] = None, pieces: Union[int, str, None] = None,
            executor: Optional[concurrent.futures.Executor] = None,
            scratch: Union[str, os.PathLike, None] = None, radii: Optional[Sequence[float]] = None,
            weights: Optional[Sequence[float]] = None, squares: bool = False, cell: Any = None,
            pbc: Union[bool, Sequence[bool], None] = None, **others) -> Diagram:
    """The persistence diagram of points, over Z/2, with a certificate.

    points: [n, D], any array of numbers. float64 and float32 are read where they lie, also with gaps between rows;
        anything else is copied. D is from 2 to 6; for "rips" up to 65,536. Or what is like ASE's ``Atoms``: its
        positions, which repeat by its cell where its ``pbc`` is true.
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
    max_degree: the highest degree of homology; by default D - 1, with a cell D, for complexes on points 1.
    ratio: the certified ratio to refine to, of "complete", "tight" and "scales"; 1.4143 or more.
    focus: (ratio, from, to): a better ratio at radii between two bounds; "auto": where bars are undecided, until each
        is certified to exist or surely not ``longer_than`` (1.5) times its birth, or ``memory`` is full.
    eps, theta: of "tight" and "scales".
    values: "certified" or "thesis", the filter's own.
    whole_cells: refine for whole Voronoi cells, not for cells clipped to a ball around the points: more vertices for
        the same ratio, as "complete" was up to version 0.2.0.
    tau, method, finish: a quality mesh in place of one refined by the certificate: see :func:`netmesh.mesh`.
    function, lipschitz, cut: a function of x, float64 [D], with abs(f(x) - f(y)) <= lipschitz * norm(x - y), and at
        least ``cut`` outside of a ball around the points; sublevel sets up to the cut. A value that contradicts that
        leaves nothing certified, with a warning. ``error``: how far births and deaths may be off;
        ``distance_factor``: a c with f >= (distance to the second nearest point) / c.
    keep_zero_pairs: pairs of length zero are kept.
    bounds: also where each true birth and death surely is: ``Diagram.bounds``.
    representatives: also a cycle for each bar: ``Diagram.representatives``, by rows of ``points``; of filters on
        meshes by vertices of the mesh.
    seed: of every random choice; by default 1.
    memory: bytes of the one block that all of it happens in, a number or "64M"; by default as much as it takes.
    fit: the best ratio that ``memory`` holds.
    progress: True for tqdm, or a function (stage, done, total, vertices, cells) that is called about every tenth of a
        second, and stops the job when it returns something true.
    pieces: of "alpha": so many pieces, a power of 2, or "auto": the same diagram, in the memory of a piece. ``points``
        may be a ``numpy.memmap``. ``memory`` is that of a task.
    executor: a ``concurrent.futures.Executor`` that runs the tasks, of processes on this machine or on any that see
        ``scratch``: ``ProcessPoolExecutor``, ``dask.distributed.Client.get_executor()``,
        ``mpi4py.futures.MPIPoolExecutor``; by default they run one after the other.
    scratch: the folder for the pieces' files. It stays, and the same call goes on with what it finds; by default one
        that does not stay.
    radii: [n], of "alpha": balls of different radii about the points, which grow together: at a the radius of ball i is
        the root of a^2 + radii[i]^2, for a below 0 of radii[i]^2 - a^2. Births and deaths are these a, and births of
        components are no longer 0. Points whose balls make no difference are hidden: ``report["input"]["hidden"]``.
    weights: [n], in place of radii: their squares, of any sign.
    squares: with these, births and deaths are a^2 with the sign of a, as GUDHI has them.
    cell: of "alpha": points repeat by these vectors, a crystal or a box with periodic boundaries: D sides of a box, or
        [D, D], the vectors in rows, or in space three sides and three angles in degrees, a along x, b in the plane of x
        and y. The diagram is that of the union of balls modulo these vectors, one period with its opposite sides glued.
        Points may lie anywhere. ``report["input"]`` has ``periods``, ``copies``, how many points were triangulated
        beside those given, and ``moved``, by how much numbers were moved at most so that copies are exact.
    pbc: with a cell, or ``Atoms``: whether points repeat, or whether by each vector; by default by all of a cell.
    others: further options of the engine, by its names: ``threshold``, ``domain_factor``, ``net_spacing``,
        ``size_eps``, ``size_at_inputs``, ``size_growth``, ``audit``.

    Births and deaths are radii, in units of the coordinates.
    Raises exceptions of :mod:`netmesh.errors`, which name the argument and the row, and KeyboardInterrupt.
    """
    given = dict(filter=filter, max_degree=max_degree, k=k, ratio=ratio, longer_than=longer_than, eps=eps, theta=theta,
                 values=values, tau=tau, method=method, finish=finish, whole_cells=whole_cells, error=error,
                 keep_zero_pairs=keep_zero_pairs, bounds=bounds, cycles=representatives, seed=seed, fit=fit,
                 squares=squares, **known(persist, others))
    if k is not None and filter == "auto":
        raise InvalidArgument('k: of the distance to the k-th nearest point: filter="knn" or "kdistance"', "k")
    if k is None and filter in ("knn", "kdistance"):
        warnings.warn('k: 1, with which "%s" is the distance to the points, outliers and all; k=4 does not see single '
                      "ones" % filter, stacklevel=2)
    balls = weights_of(radii, weights)
    points, cell, pbc = atoms_of(points, cell, pbc)
    likeness = _likeness_to_distances(points_of(points)[0]) if _is_square(points) else ""
    if likeness:
        _warn_of_distances(likeness)
    if pieces is None and (executor is not None or scratch is not None):
        argument = "executor" if executor is not None else "scratch"
        raise InvalidArgument('%s: goes with pieces, as with pieces="auto"' % argument, argument)
    if pieces is not None:
        if balls is not None:
            raise InvalidArgument("%s: does not go with pieces, which are of points alone" % balls[0], balls[0])
        if cell is not None:
            raise InvalidArgument("cell: does not go with pieces, which are of points alone", "cell")
        return _in_pieces(points, given, pieces, executor, scratch, memory, (focus, function, progress))
    if filter in ("auto", "alpha") and cell is None:
        points = _without_constant(points)
    is_auto = isinstance(focus, str) and focus == "auto"
    if is_auto:
        given.update(fit=True, bounds=True, longer_than=LONGER_THAN if longer_than is None else longer_than)
    else:
        given.update(focus_of(focus, fit))
    diagram = diagram_of_points(points, given, memory, progress, (function, lipschitz, cut, distance_factor),
                                {"fit": "focus"} if is_auto else None, balls, (cell, pbc))
    if filter == "auto" and diagram._report.diagram.why == c.NETMESH_WHY_FLAT:
        _warn_of_flat(np.asarray(points))
    _diagram.warn_of_function(diagram)
    return diagram


def _without_constant(points):
    """The points without coordinates that are the same in all of them: an isometric copy."""
    try:
        array = np.asarray(points)
    except ValueError:  # ragged: said where points are read
        return points
    if array.ndim != 2 or array.shape[0] < 2 or array.shape[1] < 3 or array.dtype.kind not in "fiu":
        return points
    others = (array != array[:1]).any(axis=0)
    if others.all() or others.sum() < 2:
        return points
    warnings.warn("points: coordinate%s the same in all of them, left out: the diagram is that of points[:, %s]"
                  % (" %d is" % np.flatnonzero(~others)[0] if (~others).sum() == 1 else
                     "s %s are" % ", ".join(str(k) for k in np.flatnonzero(~others)),
                     [int(k) for k in np.flatnonzero(others)]), stacklevel=3)
    return array[:, others]


def _warn_of_flat(points):
    """Points in a plane have no exact diagram as they are: what makes it exact."""
    dim = points.shape[1]
    remedy = 'filter="%s" is exact, for few points' % ("rips" if dim == 2 else "cech")
    warnings.warn("points: they lie in a hyperplane, where their diagram is that of the filter complete; " + remedy,
                  stacklevel=3)


def _in_pieces(points, given, pieces, executor, scratch, memory, others):
    from . import _pieces
    if given["filter"] not in ("auto", "alpha"):
        raise InvalidArgument('pieces: of the filter "alpha" alone', "pieces")
    taken = ("filter", "max_degree", "keep_zero_pairs", "seed")
    for name, value in list(given.items()) + list(zip(("focus", "function", "progress"), others)):
        if name not in taken and value is not None and value is not False:
            argument = "representatives" if name == "cycles" else name
            raise InvalidArgument("%s: does not go with pieces, which keep bars alone" % argument, argument)
    return _pieces.persist_in_pieces(points, pieces, executor, scratch, memory,
                                     given["max_degree"], given["keep_zero_pairs"])


def diagram_of_points(points, given, memory, progress, function=(), renamed=None, balls=None, repeats=(None, None)):
    """The diagram of points by options of the table; ``balls`` as ``weights_of`` gives them, ``repeats``: cell and
    pbc."""
    read = points_of(points) if balls is None else points_of(doubles(points, "points", 2))
    session = Session(memory, progress, renamed=renamed)
    request = request_of(session, read)
    put_weights(session, balls)
    put_lattice(session, lattice_of(*repeats, read[2]))
    fill(session, given)
    put_function(session, read[2], *function)
    if request.fit and memory is None:
        argument = session.renamed.get("fit", "fit")
        raise InvalidArgument("%s: needs memory=, the size to fit in" % argument, argument)
    if request.filter == OPTIONS["filter"].words["auto"]:
        try:
            settled(session, request)
            is_open = given.get("values") is None
        except InvalidArgument:  # something of a mesh
            is_open = False
        if not is_open:
            request.filter = OPTIONS["filter"].words["complete"]
    return _made(session, request, read[0])


def _made(session, request, points=None):
    asked = settled(session, request)
    at = ctypes.addressof(request)
    try:
        session.run(lib.netmesh_plan(at), lambda: session.call(lib.netmesh_persist, session.context, at))
        diagram = _diagram.read(session, points)
    finally:
        session.end()
    if asked.points.dim:
        diagram._asked = as_asked(session, asked, diagram._report), session.bytes
    return diagram


def rips(points=None, threshold: float = math.inf, max_degree: int = 1, *, distances=None,
         keep_zero_pairs: bool = False, representatives: bool = False, memory: Union[int, str, None] = None,
         progress: Union[bool, Callable, None] = None, **unknown) -> Diagram:
    """The Vietoris-Rips diagram of points, or of anything that is known by its distances.

    points: [n, D], any D; Euclidean distances.
    distances: instead of points: [n, n], symmetric but for rounding noise, up to 2^-36 of the largest distance, which
        is taken off with a warning; [n (n - 1) / 2], the condensed form of
        ``scipy.spatial.distance.pdist``; or a sparse matrix of scipy, whose missing entries are never joined.
    threshold: a radius, as all values are: points farther apart than twice that are not joined.
    max_degree: the highest degree of homology.
    representatives: also a cycle for each bar, by rows of the input, of equal points the first.

    Births and deaths are radii, half of the distances at which GUDHI and ripser have them.
    """
    known(rips, unknown, set())
    if (points is None) == (distances is None):
        raise InvalidArgument("points: give points or distances", "points")
    given = dict(filter="rips", threshold=threshold, max_degree=max_degree, keep_zero_pairs=keep_zero_pairs,
                 cycles=representatives)
    if points is not None:
        read = points_of(points)
        likeness = _likeness_to_distances(read[0])
        if likeness == "same":
            raise InvalidArgument("points: a square with 0 on its diagonal and equal halves looks like distances: "
                                  'rips(distances=...); persist(points, "rips") takes it for points', "points")
        if likeness:
            _warn_of_distances(likeness)
        if read[2] == 1:  # the library's points have two coordinates at least
            points = np.column_stack((read[0], np.zeros(read[1])))
        return diagram_of_points(points, given, memory, progress)
    session = Session(memory, progress, rows="distances")
    request = request_of(session)
    fill(session, given)
    made = sized(c.netmesh_distances)
    session.kept += [made, (_put_sparse if hasattr(distances, "tocoo") else _put_matrix)(made, distances)]
    request.distances = ctypes.addressof(made)
    return _made(session, request)


LIKENESS = 2.0 ** -10  # over the largest entry: how near a matrix is to one of distances that looks like it


def _is_square(points):
    """Whether there are as many points as coordinates; no where that is not to be seen."""
    shape = getattr(points, "shape", None)
    try:
        return len(points) == len(points[0]) if shape is None else len(set(shape)) == 1
    except (TypeError, LookupError):
        return False


def _likeness_to_distances(array):
    """Of points: "same" of a square with 0 on its diagonal and equal halves but for rounding noise, none below 0;
    "near" where it is that but for more noise; else nothing."""
    if array.ndim != 2 or array.shape[0] < 3 or array.shape[0] != array.shape[1] or not np.isfinite(array).all():
        return ""
    most = np.abs(array).max()
    if most == 0:
        return ""
    off = max(np.abs(array / 2 - array.T / 2).max() * 2, np.abs(np.diagonal(array)).max(), -array.min())
    return "same" if off <= NOISE_SHARE * most else "near" if off <= LIKENESS * most else ""


def _warn_of_distances(likeness):
    nearly, before = "", ""
    if likeness == "near":
        nearly, before = "nearly ", "; before that D = (D + D.T) / 2 and numpy.fill_diagonal(D, 0) take the noise off"
    warnings.warn("points: a square with %s0 on its diagonal and %sequal halves looks like distances, and is taken for "
                  "coordinates; rips(distances=D) takes it for distances%s" % (nearly, nearly, before), stacklevel=3)


def _put_matrix(made, distances):
    shape = np.shape(distances)
    if len(shape) == 1:
        return _put_condensed(made, doubles(distances, "distances", 1))
    array = doubles(distances, "distances", 2)
    if array.shape[0] != array.shape[1]:
        raise InvalidArgument("distances: [%d, %d] is not square" % array.shape, "distances")
    array = _evened(array)
    made.layout = c.NETMESH_DISTANCES_FULL
    made.numbers = array.ctypes.data or 8
    made.count = array.shape[0]
    return array


NOISE_SHARE = 2.0 ** -36  # as of the tool


def _refuse_matrix(array, noise, off):
    """What is wrong with a matrix, the first place of the worst fault: its values, and what helps."""
    diagonal = np.diagonal(array)
    if (diagonal == 1).all():
        raise InvalidArgument("distances: the distance of a point to itself is 1, not 0; of similarities S give 1 - S",
                              "distances", 0)

    def refuse(where, words):
        i, j = map(int, where[0])
        raise InvalidArgument("distances, row %d: the distance to %s is %r%s" % (
            i, "itself" if i == j else j, float(array[i, j]), words), "distances", i)

    places = np.argwhere(np.isnan(array))
    if len(places):
        refuse(places, ", not a number; numpy.inf stands for pairs that are never joined")
    places = np.argwhere(np.diag(~(np.abs(diagonal) <= noise)))
    if len(places):
        is_even = (off == 0).all()
        refuse(places, ", not 0; " + ("numpy.fill_diagonal(D, 0) takes" if is_even else
                                      "D = (D + D.T) / 2 and numpy.fill_diagonal(D, 0) take") + " noise off")
    places = np.argwhere(array < -noise)
    if len(places):
        refuse(places, ", and below 0")
    places = [(i, j) for i, j in np.argwhere(~(off <= noise)) if j < i]
    i, j = places[0]
    refuse(places, ", and %r the other way round; (D + D.T) / 2 makes a matrix symmetric" % float(array[j, i]))


def _evened(array):
    """Without the noise that products of matrices leave: sides that differ in the last digits, a diagonal near 0."""
    diagonal = np.diagonal(array)
    if np.array_equal(array, array.T) and not diagonal.any() and not (array < 0).any():
        return array
    finite = np.isfinite(array)
    noise = NOISE_SHARE * np.abs(array[finite]).max(initial=0)
    with np.errstate(invalid="ignore"):
        off = np.where(array == array.T, 0, np.abs(array - array.T))
    mean = np.where(off == 0, array, array / 2 + array.T / 2)
    if (np.abs(diagonal) > noise).any() or not (off <= noise).all() or (mean < -noise).any():
        _refuse_matrix(array, noise, off)
    np.fill_diagonal(mean, 0)
    mean = np.maximum(mean, 0)
    warnings.warn("distances: took rounding noise off, at most %.3g" % np.abs(mean - array)[finite].max(initial=0),
                  stacklevel=4)
    return mean


def _put_condensed(made, condensed):
    """pdist goes by rows of the upper triangle, the library by rows of the lower one."""
    count = int(round((1 + math.sqrt(1 + 8 * len(condensed))) / 2))
    if count * (count - 1) // 2 != len(condensed):
        raise InvalidArgument("distances: %d numbers are no condensed matrix" % len(condensed), "distances")
    rows, columns = np.tril_indices(count, -1)
    array = condensed[columns * (2 * count - columns - 1) // 2 + rows - columns - 1]
    made.layout = c.NETMESH_DISTANCES_LOWER
    made.numbers = array.ctypes.data or 8
    made.count = count
    return array


def _put_sparse(made, matrix):
    matrix = matrix.tocoo()
    if matrix.shape[0] != matrix.shape[1]:
        raise InvalidArgument("distances: [%d, %d] is not square" % matrix.shape, "distances")
    entries = np.zeros(len(matrix.data), dtype=[("i", "u4"), ("j", "u4"), ("distance", "f8")])
    entries["i"], entries["j"], entries["distance"] = matrix.row, matrix.col, matrix.data
    made.layout = c.NETMESH_DISTANCES_SPARSE
    made.entries = entries.ctypes.data
    made.entry_count = len(entries)
    made.count = matrix.shape[0]
    return entries


def homology(simplices, values, max_degree: Optional[int] = None, *, keep_zero_pairs: bool = False,
             representatives: bool = False, memory: Union[int, str, None] = None,
             progress: Union[bool, Callable, None] = None) -> Diagram:
    """The diagram of any filtered simplicial complex.

    simplices: a list of lists of vertices, in any order; every face has to be there.
    values: [m], when each simplex enters: finite, and no face later than what it is a face of.
    """
    session = Session(memory, progress, rows="simplices")
    request = request_of(session)
    fill(session, dict(filter="simplices", max_degree=max_degree, keep_zero_pairs=keep_zero_pairs,
                       cycles=representatives))
    put_simplices(session, simplices, doubles(values, "values", 1))
    return _made(session, request)


def put_simplices(session, simplices, entries, by_vertex=False):
    """A filtered complex; with two axes of entries a complex and its steps."""
    vertices, starts = _flat(simplices)
    sizes = np.diff(starts.astype(np.int64))
    due = int((sizes == 1).sum()) if by_vertex else len(sizes)
    argument = session.renamed.get("entries", "values")
    if entries.shape[-1] != due:
        raise InvalidArgument("%s: %d of them, where %d are due" % (argument, entries.shape[-1], due), argument)
    made = sized(c.netmesh_simplices)
    made.vertices, made.starts, made.entries = vertices.ctypes.data, starts.ctypes.data, entries.ctypes.data
    made.simplex_count, made.vertex_count = len(sizes), len(vertices)
    made.step_count, made.by_vertex = (len(entries), bool(by_vertex)) if entries.ndim == 2 else (0, 0)
    session.request.simplices = ctypes.addressof(made)
    session.kept += [made, vertices, starts, entries]


def _flat(simplices):
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
