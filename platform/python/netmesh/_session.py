"""Calls of the library: a context in a block of memory, the watch over a job, and what comes of a status."""
import ctypes
import functools
import mmap
import os
import re
import signal
import threading

from . import _declarations as c
from ._library import lib, sized
from .errors import InvalidArgument, NoResult, OutOfMemory, error_of

SMALL_BYTES = 1 << 20   # blocks of small jobs are kept for the next one
LEAST_BYTES = 1 << 30   # of address space for larger ones
HUGE_BYTES = 4 << 20    # from plans of so many bytes on, large pages pay
MOST_BYTES = 1 << 62    # of memory=


class Block:
    """Address space: pages become memory when they are first written, and go when nothing refers to the block."""

    def __init__(self, size, huge=False):
        flags = mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS | getattr(mmap, "MAP_NORESERVE", 0x4000)
        self.bytes = size
        self._memory = mmap.mmap(-1, size, flags=flags, prot=mmap.PROT_READ | mmap.PROT_WRITE)
        if huge and hasattr(mmap, "MADV_HUGEPAGE"):
            try:
                self._memory.madvise(mmap.MADV_HUGEPAGE)
            except OSError:
                pass
        self._hold = ctypes.c_char.from_buffer(self._memory)
        self.address = ctypes.addressof(self._hold)


@functools.lru_cache(maxsize=None)
def physical_bytes():
    """The machine's memory, or the control group's limit where that is lower."""
    size = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    try:
        with open("/sys/fs/cgroup/memory.max", encoding="ascii") as file:
            size = min(size, int(file.read()))
    except (OSError, ValueError):
        pass
    return size


def bytes_of(memory):
    """Bytes of ``memory=``: None, a number, or a text such as "64M", as the tool takes them."""
    if memory is None:
        return None
    size = memory
    if isinstance(memory, str):
        found = re.fullmatch(r"(\d+)([KMGT]?)", memory, re.I | re.A)
        if not found:
            raise InvalidArgument('memory: "%s" is neither a whole number of bytes nor such as "64K", "512M", "2G"' %
                                  memory, "memory")
        size = int(found.group(1)) << 10 * " KMGT".index(found.group(2).upper() or " ")
    try:
        size = int(size)
    except (TypeError, ValueError, OverflowError):
        raise InvalidArgument("memory: not a number of bytes", "memory") from None
    if not 0 < size < MOST_BYTES:
        raise InvalidArgument("memory: not a number of bytes above 0", "memory")
    return size


def _memory_text(size):
    """At least so many bytes, as ``memory=`` takes them."""
    shift = 20 if size >= 10 << 20 else 10
    return '"%d%s"' % (-(-size >> shift), " KM"[shift // 10])


_pythonapi = ctypes.pythonapi
_restore = _pythonapi.PyErr_Restore
_restore.argtypes, _restore.restype = [ctypes.c_void_p] * 3, None


def _address(function):
    return ctypes.cast(function, ctypes.c_void_p).value


_WATCH = c.netmesh_python_watch(
    ensure=_address(_pythonapi.PyGILState_Ensure), release=_address(_pythonapi.PyGILState_Release),
    check_signals=_address(_pythonapi.PyErr_CheckSignals), fetch=_address(_pythonapi.PyErr_Fetch),
    signals_every=20_000_000, progress_every=100_000_000)
_POLL = lib.addresses["netmesh_python_poll"]
_PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(c.netmesh_progress))
_EVALUATE = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_void_p, ctypes.POINTER(ctypes.c_double))
STAGES = ("none", "sort", "delaunay", "refine", "certify", "filter", "gradient", "reduce", "check", "analyse")

_spare = []        # small blocks of jobs that have ended
_spare_space = []  # large ones of which hardly a page was written to
_no_detail = sized(c.netmesh_detail)


class Session:
    """A context and its block. ``rows``: the argument whose rows the jobs read."""

    def __init__(self, memory=None, progress=None, rows="points", renamed=None):
        self.bytes = bytes_of(memory)
        self.block = None
        self.context = None
        self.rows = rows
        self.renamed = renamed or {}
        self.lock = threading.Lock()
        self.error = None      # what a function of the caller's raised
        self.callbacks = []    # kept alive as long as the library may call them
        self.request = None    # of the call that is on its way or was the last one
        self.kept = []         # what it points to
        self.watch = c.netmesh_python_watch.from_buffer_copy(_WATCH)
        self.monitor = c.netmesh_monitor(_POLL, ctypes.addressof(self.watch))
        if progress is not None:
            self.show(progress)

    def enter(self):
        """Takes the lock of a context that others can get at: one thread at a time, and none from within a job."""
        if not self.lock.acquire(blocking=False):
            raise NoResult("another call is at work on this mesh")

    def show(self, progress):
        """Calls ``progress(stage, done, total, vertices, cells)`` now and then; it stops the job by a True."""
        progress = _bar() if progress is True else progress
        if not callable(progress):
            raise InvalidArgument("progress: not a function", "progress")

        def call(now):
            self.watch.answer = 2
            try:
                p = now.contents
                stops = progress(STAGES[p.stage], p.done, p.total, p.vertices, p.cells)
                self.watch.answer = 2 if stops else 1
            except BaseException as error:
                self.error = error
            return 0

        self.callbacks.append(_PROGRESS(call))
        self.watch.call = _address(self.callbacks[-1])

    def unwatch(self):
        """Forgets the caller's functions of the call before."""
        self.callbacks.clear()
        self.kept.clear()
        self.watch.call = None
        self.watch.signals_next = self.watch.progress_next = 0

    def evaluation(self, function, dim, argument):
        """The address of a C function of x[dim] that calls ``function(x)``."""
        import numpy as np

        def call(_, x):
            if self.error is not None:
                return float("nan")
            try:
                return float(function(np.array(x[:dim])))
            except BaseException as error:
                self.error = error
                self.watch.stop = 1
                return float("nan")

        if not callable(function):
            raise InvalidArgument("%s: not a function" % argument, argument)
        self.callbacks.append(_EVALUATE(call))
        return _address(self.callbacks[-1])

    def call(self, function, *arguments):
        """One call of the library; an exception where its status is not OK."""
        if not self.callbacks:
            status = function(*arguments)
        else:
            with _DeferredInterrupt(self):
                status = function(*arguments)
        if status != c.NETMESH_OK or self.error is not None or self.watch.error_type:
            self.fail(status)

    def fail(self, status, detail=None):
        """Raises what a call has come to."""
        watch = self.watch
        watch.stop = 0
        if watch.error_type:
            raised = watch.error_type, watch.error_value, watch.error_traceback
            watch.error_type = watch.error_value = watch.error_traceback = None
            _restore(*raised)
        if self.error is not None:
            error, self.error = self.error, None
            raise error
        if detail is None:
            detail = _no_detail
            if self.context:
                detail = sized(c.netmesh_detail)
                lib.netmesh_get_detail(self.context, ctypes.addressof(detail))
        error = error_of(status, detail, self.rows, self.renamed)
        if status == c.NETMESH_OUT_OF_MEMORY and self.bytes is not None:
            error.args = ("memory: %d bytes are too few; %s" % (self.bytes, error.args[0]),)
        if detail.field == c.NETMESH_FIELD_DIM and self.rows == "points" and self.request is not None:
            error.args = (error.args[0] + self._remedy_of_dimension(),)
        raise error

    def _remedy_of_dimension(self):
        count, dim = self.request.points.count, self.request.points.dim
        if dim <= 6:
            return "; rips(points) takes numbers on a line" if dim == 1 else ""
        turned = "; points are rows: is points.T meant?" if 2 <= count <= 6 else ""
        return ", but %d; rips(points) takes any number of coordinates%s" % (dim, turned)

    def _begin(self, block):
        context = ctypes.c_void_p()
        self.context = None
        self.block = block
        self.call(lib.netmesh_init, block.address, block.bytes, ctypes.addressof(context))
        self.context = context.value

    def run(self, plan, work, keep=False):
        """Calls ``work()`` with a context, in a larger block when the block was too small. ``keep``: the context is
        wanted afterwards; else :meth:`end` gives it back."""
        if self.bytes is not None:
            block = _reserve(self.bytes, self.bytes >= HUGE_BYTES)
            try:
                self._begin(block)
                return work()
            except OutOfMemory as error:
                self._advise(error, plan)
                raise
        if plan < SMALL_BYTES // 2 and not keep:
            self._begin(_spare.pop() if _spare else Block(SMALL_BYTES))
            try:
                return work()
            except OutOfMemory:
                self.end()
        physical = physical_bytes()
        size = min(max(LEAST_BYTES, 64 * plan), physical)
        while True:
            if size == LEAST_BYTES and plan < SMALL_BYTES // 2 and _spare_space:
                block = _spare_space.pop()
            else:
                block = _reserve(size, plan >= HUGE_BYTES, least=LEAST_BYTES // 64)
            try:
                self._begin(block)
                return work()
            except OutOfMemory:
                if block.bytes < size or size >= physical:
                    raise
                self.block = self.context = None
                size = min(4 * size, physical)

    def _advise(self, error, plan):
        """What to try after ``memory=`` was too little: the plan, or twice as much where that is not enough."""
        planned = plan
        words = "plan for %d: memory=%s"
        if not max(self.bytes, error.bytes_wanted) < plan < MOST_BYTES:
            planned = max(2 * self.bytes, error.bytes_wanted)
            words = "more than is planned for such a number of points: try %d, memory=%s"
        if planned < MOST_BYTES:
            error.bytes_planned = planned
            error.args = ("%s; %s" % (error.args[0], words % (planned, _memory_text(planned))),)

    def end(self, written=LEAST_BYTES):
        """Gives the block back, of which so many bytes were written to. What was read from it stays."""
        block, self.block, self.context = self.block, None, None
        if block is None or self.bytes is not None:
            return
        if block.bytes == SMALL_BYTES and len(_spare) < 4:
            _spare.append(block)
        elif block.bytes == LEAST_BYTES and written < SMALL_BYTES // 2 and len(_spare_space) < 2:
            _spare_space.append(block)

    def report(self):
        report = sized(c.netmesh_report)
        status = lib.netmesh_get_report(self.context, ctypes.addressof(report))
        if status != c.NETMESH_OK:
            self.fail(status)
        return report


def _reserve(size, huge, least=None):
    """A block of ``size`` bytes; with ``least`` a smaller one where the system refuses that."""
    while True:
        try:
            return Block(size, huge)
        except (OSError, ValueError, OverflowError, MemoryError):
            if least is None or size // 2 < least:
                error = OutOfMemory("memory: the system refuses to reserve %d bytes" % size, "memory")
                raise error from None
            size //= 2


class _DeferredInterrupt:
    """While Python functions are called by a job: Ctrl-C must not end up in one of them, where nobody would see it.
    The handler runs as ever, and what it raises stops the job and is raised behind it."""

    def __init__(self, session):
        self.session = session
        self.previous = None

    def __enter__(self):
        if threading.current_thread() is not threading.main_thread():
            return
        previous = signal.getsignal(signal.SIGINT)
        if not callable(previous):
            return

        def handle(number, frame):
            try:
                previous(number, frame)
            except BaseException as error:
                self.session.error = error
                self.session.watch.stop = 1

        self.previous = previous
        signal.signal(signal.SIGINT, handle)

    def __exit__(self, *_):
        if self.previous is not None:
            signal.signal(signal.SIGINT, self.previous)


def _bar():
    """Progress by tqdm, where it is there."""
    try:
        from tqdm import tqdm
    except ImportError:
        raise InvalidArgument("progress: True needs tqdm, which is not installed", "progress") from None
    bar = tqdm()

    def show(stage, done, total, vertices, cells):
        bar.set_description_str(stage, refresh=False)
        bar.total = total or None
        bar.n = done
        bar.refresh()

    return show


def figures(report, get=None):
    """All figures of a report as nested dictionaries, by the names of the tool's JSON; those that say nothing are
    left out."""
    get = get or lib.netmesh_get_report_figure
    types = {c.NETMESH_FIGURE_UINT32: ctypes.c_uint32, c.NETMESH_FIGURE_UINT64: ctypes.c_uint64,
             c.NETMESH_FIGURE_FLAG: ctypes.c_uint32, c.NETMESH_FIGURE_DOUBLE: ctypes.c_double,
             c.NETMESH_FIGURE_FINGERPRINT: ctypes.c_uint64}
    found = {}
    figure = sized(c.netmesh_figure)
    index = 0
    while get(ctypes.addressof(report), index, ctypes.addressof(figure)) == c.NETMESH_OK:
        index += 1
        if not figure.applies:
            continue
        if figure.type == c.NETMESH_FIGURE_NAME:
            value = figure.text.decode()
        else:
            values = list((types[figure.type] * figure.count).from_address(figure.values)) if figure.count else []
            if figure.type == c.NETMESH_FIGURE_FINGERPRINT:
                values = ["%016x" % v for v in values]
            elif figure.type == c.NETMESH_FIGURE_FLAG:
                values = [bool(v) for v in values]
            value = values if figure.is_array else values[0]
        at = found
        *parts, name = figure.path.decode().split(".")
        for part in parts:
            at = at.setdefault(part, {})
        at[name] = value
    return found

