"""Distances of diagrams."""
import ctypes
import math
from typing import Optional

import numpy as np

from . import _declarations as c
from ._arrays import number, whole
from ._diagram import Diagram, bars_of, top_degree_of
from ._library import lib, sized
from ._options import known
from ._session import SMALL_BYTES, Session, _reserve
from .errors import InvalidArgument


def bottleneck(a, b, degree: Optional[int] = None, log: bool = False, **unknown) -> float:
    """The bottleneck distance of two diagrams, exact and rounded once.

    a, b: each a Diagram, bars [m, 2] (birth, death), bars [m, 3] (degree, birth, death), or a list of arrays [m, 2] by
        degree.
    degree: of this degree alone, which both have; by default the largest distance of all degrees.
    log: of the logarithms of births and deaths, the natural ones: what certified ratios are about. Births are not
        negative then. The ratio that it is the logarithm of is exact and rounded once.

    Infinite where the numbers of essential bars differ. In units of the coordinates.
    """
    known(bottleneck, unknown, set())
    distance = sized(c.netmesh_distance)
    request = lib.netmesh_default_bottleneck()
    request.scale = c.NETMESH_SCALE_LOG if log else c.NETMESH_SCALE_PLAIN
    _compare(request, _pairs_of(a, b, degree), degree, lib.netmesh_bottleneck_bytes, lib.netmesh_bottleneck, distance)
    if not log or math.isinf(distance.value):
        return distance.value
    return math.log(distance.value) + distance.exponent * math.log(2)


class Transport(float):
    """A Wasserstein distance, a number with bounds: ``lower`` is proven, and the distance is between the two."""

    lower: float
    #: int32 [m]: the bar of b that each bar of a goes to, -1 for the diagonal; where one degree was asked for.
    mates: Optional[np.ndarray]


def wasserstein(a, b, order: int = 1, degree: Optional[int] = None, error: float = 0.001, **unknown) -> Transport:
    """The Wasserstein distance of two diagrams, within a relative error that is proven.

    a, b: as of :func:`netmesh.bottleneck`.
    order: p, 1 to 16: the p-th root of the least sum of p-th powers; costs are the larger of the moves of birth and
        death, half of the length for a way to the diagonal.
    degree: of this degree alone, which both have; by default the p-norm of the distances of all degrees.
    error: the distance is between the result's ``lower`` and the result, at most ``1 + error`` times that.

    Infinite where the numbers of essential bars differ, ``lower`` too; a distance beyond the largest float has that for
    ``lower``. Bounds that stay farther apart than ``error`` are not returned: InternalError, as that is a defect.
    """
    known(wasserstein, unknown, set())
    distance = sized(c.netmesh_wasserstein_distance)
    request = lib.netmesh_default_wasserstein()
    request.order = whole(order, "order", 1, c.NETMESH_ORDER_MAX)
    request.relative_error = number(error, "error")
    pairs = _pairs_of(a, b, degree)
    mates = None
    if degree is not None:
        mates = np.full(len(pairs[0]), -1, dtype=np.int32)
        request.mates_a = mates.ctypes.data if len(mates) else None
    _compare(request, pairs, degree, lib.netmesh_wasserstein_bytes, lib.netmesh_wasserstein, distance)
    result = Transport(distance.value)
    result.lower = distance.lower
    result.mates = mates
    return result


def _pairs_of(a, b, degree):
    """Both as the library's pairs; what has not got the degree, and radii beside their squares, are refused."""
    pairs = bars_of(a, "a"), bars_of(b, "b")
    if degree is not None:
        whole(degree, "degree", 0, 1000)
        for argument, diagram in (("a", a), ("b", b)):
            top = top_degree_of(diagram)
            if top is not None and degree > top:
                raise InvalidArgument("degree: %d is not from 0 to %d, the degrees of %s%s" % (
                    degree, top, argument, "" if isinstance(diagram, Diagram) or top else
                    "; bars [m, 2] are of degree 0, and compared as they are without degree="), "degree")
    squares = [diagram._facts.get("squares") if isinstance(diagram, Diagram) else None for diagram in (a, b)]
    if None not in squares and squares[0] != squares[1]:
        units = ["squares of radii" if is_squared else "radii" for is_squared in squares]
        raise InvalidArgument("b: births and deaths are %s, those of a are %s; make both with squares=True, or both "
                              "without" % (units[1], units[0]), "b")
    return pairs


def _compare(request, pairs, degree, plan, call, distance):
    pairs_a, pairs_b = pairs
    session = Session()
    request.monitor = session.monitor
    request.pairs_a, request.count_a = pairs_a.ctypes.data, len(pairs_a)
    request.pairs_b, request.count_b = pairs_b.ctypes.data, len(pairs_b)
    if degree is not None:
        request.degree = int(degree)
    size = plan(ctypes.addressof(request))
    detail = sized(c.netmesh_detail)
    block = None
    if 0 < size < 1 << 62:
        block = _reserve(max(size, SMALL_BYTES), False)
        request.scratch, request.scratch_bytes = block.address, block.bytes
    status = call(ctypes.addressof(request), ctypes.addressof(distance), ctypes.addressof(detail))
    if status != c.NETMESH_OK:
        session.fail(status, detail)
