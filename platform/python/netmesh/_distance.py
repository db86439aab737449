"""Distances of diagrams."""
import ctypes
import math
from typing import Optional

import numpy as np

from . import _declarations as c
from ._arrays import number, whole
from ._diagram import bars_of
from ._library import lib, sized
from ._session import SMALL_BYTES, Session, _reserve


def bottleneck(a, b, degree: Optional[int] = None, log: bool = False) -> float:
    """The bottleneck distance of two diagrams, exact and rounded once.

    a, b: each a Diagram, bars [m, 2] (birth, death), bars [m, 3] (degree, birth, death), or a list of arrays [m, 2] by
        degree.
    degree: of this degree alone; by default the largest distance of all degrees.
    log: of the logarithms of births and deaths, the natural ones: what certified ratios are about. Births are not
        negative then. The ratio that it is the logarithm of is exact and rounded once.

    Infinite where the numbers of essential bars differ. In units of the coordinates.
    """
    distance = sized(c.netmesh_distance)
    request = lib.netmesh_default_bottleneck()
    request.scale = c.NETMESH_SCALE_LOG if log else c.NETMESH_SCALE_PLAIN
    _compare(request, a, b, degree, lib.netmesh_bottleneck_bytes, lib.netmesh_bottleneck, distance)
    if not log or math.isinf(distance.value):
        return distance.value
    return math.log(distance.value) + distance.exponent * math.log(2)


class Transport(float):
    """A Wasserstein distance, a number with bounds: ``lower`` is proven, and the distance is between the two."""

    lower: float
    #: int32 [m]: the bar of b that each bar of a goes to, -1 for the diagonal; where one degree was asked for.
    mates: Optional[np.ndarray]


def wasserstein(a, b, order: int = 1, degree: Optional[int] = None, error: float = 0.001) -> Transport:
    """The Wasserstein distance of two diagrams, within a relative error that is proven.

    a, b: as of :func:`netmesh.bottleneck`.
    order: p, 1 to 16: the p-th root of the least sum of p-th powers; costs are the larger of the moves of birth and
        death, half of the length for a way to the diagonal.
    degree: of this degree alone; by default the p-norm of the distances of all degrees.
    error: the distance is between the result's ``lower`` and the result, at most ``1 + error`` times that.

    Infinite where the numbers of essential bars differ, ``lower`` too; a distance beyond the largest float has that for
    ``lower``. Bounds that stay farther apart than ``error`` are not returned: InternalError, as that is a defect.
    """
    distance = sized(c.netmesh_wasserstein_distance)
    request = lib.netmesh_default_wasserstein()
    request.order = whole(order, "order", 1, c.NETMESH_ORDER_MAX)
    request.relative_error = number(error, "error")
    pairs = bars_of(a, "a")
    mates = None
    if degree is not None:
        mates = np.full(len(pairs), -1, dtype=np.int32)
        request.mates_a = mates.ctypes.data if len(mates) else None
    _compare(request, pairs, b, degree, lib.netmesh_wasserstein_bytes, lib.netmesh_wasserstein, distance)
    result = Transport(distance.value)
    result.lower = distance.lower
    result.mates = mates
    return result


def _compare(request, a, b, degree, plan, call, distance):
    pairs_a = a if isinstance(a, np.ndarray) and a.dtype.names else bars_of(a, "a")
    pairs_b = bars_of(b, "b")
    session = Session()
    request.monitor = session.monitor
    request.pairs_a, request.count_a = pairs_a.ctypes.data, len(pairs_a)
    request.pairs_b, request.count_b = pairs_b.ctypes.data, len(pairs_b)
    if degree is not None:
        request.degree = whole(degree, "degree", 0, 1000)
    size = plan(ctypes.addressof(request))
    detail = sized(c.netmesh_detail)
    block = None
    if 0 < size < 1 << 62:
        block = _reserve(max(size, SMALL_BYTES), False)
        request.scratch, request.scratch_bytes = block.address, block.bytes
    status = call(ctypes.addressof(request), ctypes.addressof(distance), ctypes.addressof(detail))
    if status != c.NETMESH_OK:
        session.fail(status, detail)
