"""numpy arrays in and out."""
import math

import numpy as np

from . import _declarations as c
from ._hints import did_you_mean, is_diagram, of_no_numbers
from .errors import InvalidArgument

_FORMATS = {np.dtype(np.float64): c.NETMESH_POINTS_FLOAT64, np.dtype(np.float32): c.NETMESH_POINTS_FLOAT32}


def address(array):
    """Where the numbers of an array are; null for None."""
    return None if array is None else array.ctypes.data


def doubles(values, argument, ndim):
    """An array of float64 in C order with ``ndim`` axes; the same one where it is that already."""
    array = _array(values, argument)
    if array.ndim != ndim:
        raise InvalidArgument("%s: %d axes, where %d are due" % (argument, array.ndim, ndim), argument)
    if array.dtype.kind in "iu" and array.size and (array.max() > 2 ** 53 or array.min() < -2 ** 53):
        raise InvalidArgument("%s: integers beyond 2^53, which a double does not hold" % argument, argument)
    return np.ascontiguousarray(array, dtype=np.float64)


def _array(values, argument):
    if np.ma.isMaskedArray(values) and np.ma.count_masked(values):
        raise InvalidArgument("%s: masked values" % argument, argument)
    try:
        array = values if type(values) is np.ndarray else np.asarray(values)
        if array.dtype.kind not in "fiu" or is_diagram(values):
            if array.dtype.kind in "bcMmV" or is_diagram(values):
                raise TypeError
            array = array.astype(np.float64)
    except (TypeError, ValueError):
        raise InvalidArgument("%s: %s" % (argument, of_no_numbers(values)), argument) from None
    return array


def points_of(points, argument="points"):
    """Points as the library reads them: the array that is to be kept alive, its shape, format and stride. float32 and
    float64 are read where they lie as long as the numbers of a row are neighbours; anything else is copied."""
    array = _array(points, argument)
    if array.ndim == 1 and len(array) > 1:
        raise InvalidArgument("%s: one axis; an array [n, D] is due: netmesh.delay(x, lag) makes points of a series, "
                              "rips(x[:, None]) takes numbers on a line" % argument, argument)
    if array.ndim != 2:
        raise InvalidArgument("%s: %d axes; an array [n, D] is due" % (argument, array.ndim), argument)
    count, dim = array.shape
    kind = _FORMATS.get(array.dtype)
    rows, columns = array.strides
    size = array.itemsize
    fits = (kind is not None and array.dtype.isnative and (columns == size or dim <= 1) and
            (count <= 1 or (rows >= dim * size and rows % size == 0)) and array.ctypes.data % size == 0)
    if not fits:
        array = doubles(array, argument, 2)
        kind, rows = c.NETMESH_POINTS_FLOAT64, array.strides[0]
    return array, count, dim, kind, rows if count > 1 else 0


def first_rows(array):
    """The row of each point that is left after equal rows were merged: the first of each group, ascending."""
    order = np.lexsort(array.T)
    ordered = array[order]
    is_first = np.append(True, (ordered[1:] != ordered[:-1]).any(axis=1))
    return np.sort(order[is_first]).astype(np.int32)


def put_points(request, points):
    """Makes a request read what points_of gave."""
    array, count, dim, kind, stride = points
    request.points = c.netmesh_points(array.ctypes.data or 8, count, dim, kind, stride)


def weights_of(radii, weights):
    """What is given of balls about points: the argument and its numbers; or None."""
    if radii is None and weights is None:
        return None
    if radii is not None and weights is not None:
        raise InvalidArgument("weights: give radii or weights", "weights")
    argument = "radii" if weights is None else "weights"
    return argument, doubles(radii if weights is None else weights, argument, 1)


def atoms_of(points, cell, pbc):
    """Points, cell and pbc of what is like ASE's ``Atoms``, whose cell counts where nothing else is given; of anything
    else what they are."""
    if not all(hasattr(points, name) for name in ("get_positions", "cell", "pbc")):
        return points, cell, pbc
    if cell is None:
        pbc = points.pbc if pbc is None else pbc
        cell = np.asarray(points.cell) if np.any(pbc) else None
    return points.get_positions(), cell, None if cell is None else pbc


def lattice_of(cell, pbc, dim):
    """The vectors by which points of ``dim`` coordinates repeat, float64 [m, dim]; None where they do not."""
    periods = _periods_of(pbc, dim)
    if cell is None:
        if pbc is not None and periods.any():
            raise InvalidArgument("pbc: goes with cell", "pbc")
        return None
    shape = np.shape(cell)
    if shape == (dim, dim):
        vectors = doubles(cell, "cell", 2)
    elif shape == (dim,):
        vectors = np.diag(_sides(doubles(cell, "cell", 1), periods))
    elif shape == (6,) and dim == 3:
        vectors = _of_angles(doubles(cell, "cell", 1))
    else:
        raise InvalidArgument("cell: shape %s, where there are points in %d dimensions: %d sides of a box, or as many "
                              "vectors%s" % (shape, dim, dim, "; or three sides and three angles" * (dim == 3)),
                              "cell")
    return np.ascontiguousarray(vectors[periods]) if periods.any() else None


def _periods_of(pbc, dim):
    flags = np.asarray(True if pbc is None else pbc)
    if flags.shape not in ((), (dim,)) or flags.dtype.kind not in "biu" or not np.isin(flags, (0, 1)).all():
        raise InvalidArgument("pbc: a bool, or one for each of %d vectors" % dim, "pbc")
    return np.broadcast_to(flags.astype(bool), dim)


def _sides(sides, periods):
    for i in np.flatnonzero(periods):
        if not 0 < sides[i] < np.inf:
            raise InvalidArgument("cell: side %d is %r; a number above 0, or pbc without it" % (i, float(sides[i])),
                                  "cell", int(i))
    return sides


def _of_angles(cell):
    """Rows of three sides and three angles in degrees: a along x, b in the plane of x and y."""
    angles = cell[3:]
    if not ((0 < cell) & (cell < np.inf)).all() or not 2 * angles.max() < angles.sum() < 360:
        raise InvalidArgument("cell: three sides above 0, and three angles in degrees, each less than the sum of the "
                              "others, all less than 360", "cell")
    exact = {60: 0.5, 90: 0.0, 120: -0.5}
    alpha, beta, gamma = [exact.get(x, math.cos(math.radians(x))) for x in angles]
    sine = 1.0 if angles[2] == 90 else math.sin(math.radians(angles[2]))
    y = (alpha - beta * gamma) / sine
    z = math.sqrt(max(1 - beta * beta - y * y, 0))
    a, b, c = cell[:3]
    return np.array([[a, 0, 0], [b * gamma, b * sine, 0], [c * beta, c * y, c * z]])


def number(value, argument):
    try:
        return float(value)
    except (TypeError, ValueError):
        raise InvalidArgument("%s: not a number" % argument, argument) from None


def whole(value, argument, least=0, most=2 ** 32 - 1):
    """A whole number within bounds."""
    try:
        same = int(value) == value
    except (TypeError, ValueError, OverflowError):
        same = False
    if not same or not least <= value <= most:
        raise InvalidArgument("%s: must be a whole number from %d to %d" % (argument, least, most), argument)
    return int(value)


def choice(value, argument, choices):
    """The number of a name."""
    if not isinstance(value, str) or value not in choices:
        raise InvalidArgument("%s: %r is none of %s%s" % (argument, value, ", ".join(choices),
                                                          did_you_mean(value, choices)), argument)
    return choices[value]
