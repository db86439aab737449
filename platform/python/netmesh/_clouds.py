"""Many clouds, one after the other or by an executor."""
import collections
import concurrent.futures
import inspect
import mmap
import os
from typing import Iterable, List, Optional

import numpy as np

from ._diagram import Diagram
from ._options import OTHERS, known
from ._persist import persist
from .errors import Error, InvalidArgument

_AHEAD = 1024  # clouds that an executor has been given and that nobody has asked for yet


def persist_all(clouds: Iterable, filter: str = "auto", max_degree: Optional[int] = None, *,
                executor: Optional[concurrent.futures.Executor] = None, **options) -> List[Diagram]:
    """The persistence diagrams of many clouds, in their order: ``[persist(cloud, filter, ...) for cloud in clouds]``.

    clouds: any iterable of arrays [n, D]. It is read about a thousand clouds ahead of what is done. A
        ``numpy.memmap`` is not copied: who makes its diagram opens its file.
    executor: a ``concurrent.futures.Executor`` that makes the diagrams; by default they are made here.
    filter, max_degree, options: as of :func:`netmesh.persist`, the same for all; ``memory`` is that of one cloud. With
        processes ``function`` has to be one that they can import.

    Raises what ``persist`` raises, of the first cloud in order that fails; the message begins with ``clouds[i]``, and
    ``cloud`` of the exception is i. Clouds behind it are then given up.
    """
    for name in ("pieces", "scratch", "progress"):
        if options.get(name) is not None:
            raise InvalidArgument("%s: is of one cloud, persist(); many clouds are many tasks already" % name, name)
    known(persist_all, options, OTHERS | set(inspect.signature(persist).parameters))
    options = dict(options, filter=filter, max_degree=max_degree)
    if executor is None:
        return [_result(i, persist, cloud, **options) for i, cloud in enumerate(_checked(clouds))]
    diagrams, waiting = [], collections.deque()
    try:
        for cloud in _checked(clouds):
            if len(waiting) == _AHEAD:
                diagrams.append(_result(len(diagrams), waiting.popleft().result))
            waiting.append(executor.submit(_made, _handed_over(cloud), options))
        while waiting:
            diagrams.append(_result(len(diagrams), waiting.popleft().result))
    finally:
        for future in waiting:
            future.cancel()
    return diagrams


def _checked(clouds):
    """One cloud is not taken for a list of its points."""
    if isinstance(clouds, np.ndarray) and clouds.ndim == 2:
        raise InvalidArgument("clouds: one array [n, D]; a list of them is due, or persist() of this one", "clouds")
    try:
        return iter(clouds)
    except TypeError:
        raise InvalidArgument("clouds: a list of arrays [n, D] is due", "clouds") from None


def _result(index, call, *arguments, **options):
    """What a call gives, or what it raises with the cloud that it is about."""
    try:
        return call(*arguments, **options)
    except Error as error:
        error.args = ("clouds[%d]: %s" % (index, error.args[0]),) + error.args[1:]
        error.cloud = index
        raise
    except Exception as error:
        named = RuntimeError("clouds[%d]: its task has not ended well: %s" %
                             (index, str(error) or type(error).__name__))
        named.cloud = index
        raise named from error


def _made(cloud, options):
    """One task."""
    return persist(cloud.array() if isinstance(cloud, _Mapped) else cloud, **options)


class _Mapped:
    """An array in a file, by its name."""

    def __init__(self, path, dtype, shape, offset, strides):
        self.path, self.dtype, self.shape, self.offset, self.strides = path, dtype, shape, offset, strides

    def array(self):
        last = sum((n - 1) * step for n, step in zip(self.shape, self.strides)) + self.dtype.itemsize
        content = np.memmap(self.path, np.uint8, "r", self.offset, (last,))
        return np.ndarray(self.shape, self.dtype, content, 0, self.strides)


def _handed_over(cloud):
    """The cloud as a process gets it: of what lies in a file where it lies."""
    kept = getattr(cloud, "_mmap", None)
    is_file = isinstance(cloud, np.memmap) and kept is not None and cloud.filename is not None and cloud.mode != "c"
    if not is_file or cloud.size == 0 or min(cloud.strides, default=-1) < 0 or cloud.dtype.hasobject:
        return cloud
    if cloud.mode != "r":
        cloud.flush()
    # `offset` is that of the map, of which this array may be a part.
    begin = cloud.offset - cloud.offset % mmap.ALLOCATIONGRANULARITY
    inside = cloud.ctypes.data - np.frombuffer(kept, dtype=np.uint8).ctypes.data
    if not 0 <= inside < len(kept):  # a copy that has kept the class
        return cloud
    return _Mapped(os.path.abspath(cloud.filename), cloud.dtype, cloud.shape, begin + inside, cloud.strides)
