"""Alpha diagrams in pieces: tasks that are pure functions of files in a folder, and whoever runs them."""
import concurrent.futures
import ctypes
import json
import os
import shutil
import tempfile
import zlib

import numpy as np

from . import _declarations as c
from . import _diagram
from ._arrays import points_of, put_points, whole
from ._library import lib, sized
from ._options import as_asked, fill, request_of, settled
from ._session import Session
from .errors import Error, InvalidArgument

ADVISED = {2: 65536, 3: 65536, 4: 8192, 5: 1024, 6: 256}  # points of a piece
_ARRAYS = ("points.npy", "rows.npy", "boxes.npy")
_FACTS = ("dim", "levels", "pieces", "count", "rows", "fingerprint", "max_degree", "keep_zero_pairs")


def advised(dim, count):
    """How many pieces are best: a power of 2."""
    pieces = 1
    while count / pieces > ADVISED.get(dim, 65536):
        pieces *= 2
    return pieces


def _damaged(path, what):
    return InvalidArgument("scratch: %s: %s" % (path, what), "scratch")


def split(points, folder, pieces="auto", max_degree=None, keep_zero_pairs=False):
    """Writes the points in the order of the tree, and what is known of the job, into a folder. The job's facts; a
    folder that holds another job is refused."""
    read = points_of(points)
    count, dim = read[1], read[2]
    if isinstance(pieces, str) and pieces == "auto":
        pieces = advised(dim, count)
    pieces = whole(pieces, "pieces", 1, 2 ** 20)
    if pieces & (pieces - 1):
        raise InvalidArgument('pieces: must be a power of 2, or "auto"', "pieces")
    session = Session()
    request = sized(c.netmesh_split_request)
    request.pieces, request.monitor = pieces, session.monitor
    put_points(request, read)
    result = sized(c.netmesh_split_result)

    def work():
        session.call(lib.netmesh_split, session.context, ctypes.addressof(request))
        session.call(lib.netmesh_get_split, session.context, ctypes.addressof(result))

    try:
        session.run(count * (8 * dim + 64), work)
        order = _view(result.order, np.uint32, result.count).copy()
        boxes = _view(result.boxes, np.float64, result.box_count * 2 * dim).copy()
    finally:
        session.end()
    max_degree = dim - 1 if max_degree is None else min(whole(max_degree, "max_degree"), dim - 1)
    facts = dict(zip(_FACTS, (dim, result.levels, pieces, result.count, result.rows, "%016x" % result.fingerprint,
                              max_degree, bool(keep_zero_pairs))))
    os.makedirs(folder, exist_ok=True)
    there = os.path.join(folder, "job.json")
    if not os.path.exists(there):
        _save(folder, "rows.npy", lambda file: np.save(file, order))
        _save(folder, "boxes.npy", lambda file: np.save(file, boxes))
        _save(folder, "points.npy", lambda file: _save_points(file, read[0], order, dim))
        sums = {name: _checksum(os.path.join(folder, name)) for name in _ARRAYS}
        _save(folder, "job.json", lambda file: file.write(json.dumps(dict(facts, checksums=sums)).encode()))
    kept = job_of(folder)  # of another call perhaps, in the meantime or before
    for name, meaning in (("dim", "points"), ("rows", "points"), ("fingerprint", "points"), ("pieces", "pieces"),
                          ("max_degree", "max_degree"), ("keep_zero_pairs", "keep_zero_pairs")):
        if kept[name] != facts[name]:
            raise InvalidArgument("scratch: %s holds the pieces of another job, of other %s; name another folder" %
                                  (folder, meaning), "scratch")
    if {name: kept[name] for name in _FACTS} != facts:
        raise _damaged(there, "damaged; remove the folder")
    return kept


def _checksum(path):
    value = 0
    with open(path, "rb") as file:
        for some in iter(lambda: file.read(1 << 20), b""):
            value = zlib.crc32(some, value)
    return "%08x" % value


_checked = {}  # what a process has found good: path -> time, size and checksum


def _open_array(folder, name, facts):
    """An array of the job, mapped; its file is read once by each process to see that it is as it was written."""
    path = os.path.join(folder, name)
    try:
        about = os.stat(path)
        mark = about.st_mtime_ns, about.st_size, facts["checksums"][name]
        if _checked.get(path) != mark:
            if _checksum(path) != facts["checksums"][name]:
                raise _damaged(path, "damaged, or of another job")
            _checked[path] = mark
        return np.load(path, mmap_mode="r")
    except OSError as error:
        raise _damaged(path, error.strerror or error) from error


def _save_points(file, points, order, dim):
    """Rows in order, as float64, some at a time."""
    head = {"descr": "<f8" if np.little_endian else ">f8", "fortran_order": False, "shape": (len(order), dim)}
    np.lib.format.write_array_header_1_0(file, head)
    for begin in range(0, len(order), 1 << 16):
        some = np.ascontiguousarray(points[order[begin:begin + (1 << 16)]], dtype=np.float64) + 0.0
        file.write(some.tobytes())


def _view(address, dtype, count):
    size = int(count) * np.dtype(dtype).itemsize
    return np.frombuffer((ctypes.c_char * size).from_address(address), dtype=dtype)


def _save(folder, name, write):
    """A file that is there whole or not at all."""
    handle, temporary = tempfile.mkstemp(dir=folder, prefix=".")
    try:
        with os.fdopen(handle, "wb") as file:
            write(file)
        os.replace(temporary, os.path.join(folder, name))
    except BaseException:
        os.unlink(temporary)
        raise


def job_of(folder):
    path = os.path.join(folder, "job.json")
    try:
        with open(path, encoding="utf-8") as file:
            facts = json.load(file)
        if set(_FACTS) - set(facts) or set(_ARRAYS) - set(facts["checksums"]):
            raise ValueError
    except OSError as error:
        raise _damaged(path, error.strerror or error) from error
    except (ValueError, TypeError, KeyError) as error:
        raise _damaged(path, "damaged; remove the folder") from error
    return facts


def _piece_path(folder, node):
    return os.path.join(folder, "piece-%d" % node)


def _read_piece(path):
    """The bytes of a piece, mapped, and where they are."""
    try:
        array = np.memmap(path, dtype=np.uint8, mode="r")
    except ValueError:
        raise _damaged(path, "empty; remove it, and its task makes it again") from None
    except OSError as error:
        raise _damaged(path, "%s; its task has not been done" % (error.strerror or error)) from error
    return array, c.netmesh_piece(array.ctypes.data, array.size)


def has_piece(folder, node, facts):
    """Whether a piece is there, whole and of this job."""
    try:
        return _is_of(_read_piece(_piece_path(folder, node)), node, facts, True)
    except InvalidArgument:
        return False


def _is_of(read, node, facts, all_bytes):
    """Whether what _read_piece has read is the piece of this node of the job, by all bytes or by its head."""
    piece = read[1]
    info = sized(c.netmesh_piece_info)
    info.look_at_all = all_bytes
    status = lib.netmesh_read_piece(ctypes.addressof(piece), ctypes.addressof(info))
    return (status == c.NETMESH_OK and info.node == node and info.pieces == facts["pieces"] and
            info.dim == facts["dim"] and "%016x" % info.fingerprint == facts["fingerprint"] and
            info.max_degree == facts["max_degree"] and bool(info.keep_zero_pairs) == facts["keep_zero_pairs"] and
            info.points == facts["count"])


def _need_piece(folder, node, facts):
    """The same as _read_piece, of a piece that has to be this one's."""
    kept = _read_piece(_piece_path(folder, node))
    if not _is_of(kept, node, facts, False):
        raise _damaged(_piece_path(folder, node),
                       "damaged, or a piece of another job or node; remove it, and its task makes it again")
    return kept


def make(folder, node, memory=None):
    """One task: the piece of a node, from the points or from the pieces below. Runs anywhere that sees the folder, as
    often as one likes; what is there already stays."""
    facts = job_of(folder)
    if has_piece(folder, node, facts):
        return node
    session = Session(memory)
    try:
        _leaf(session, folder, node, facts) if node >= facts["pieces"] else _join(session, folder, node, facts)
        piece = c.netmesh_piece()
        session.call(lib.netmesh_get_piece, session.context, ctypes.addressof(piece))
        made = _view(piece.bytes, np.uint8, piece.count)
        _save(folder, "piece-%d" % node, lambda file: file.write(made.data))
    finally:
        session.end()
    return node


def _leaf(session, folder, node, facts):
    points, rows, boxes = (_open_array(folder, name, facts) for name in _ARRAYS)
    arrays = c.netmesh_point_arrays(points.ctypes.data, rows.ctypes.data, boxes.ctypes.data, facts["dim"])
    source = sized(c.netmesh_source)
    lib.netmesh_array_source(ctypes.addressof(arrays), ctypes.addressof(source))
    source.levels, source.count, source.rows = facts["levels"], facts["count"], facts["rows"]
    source.fingerprint = int(facts["fingerprint"], 16)
    request = sized(c.netmesh_leaf_request)
    request.pieces, request.node, request.source = facts["pieces"], node, ctypes.addressof(source)
    request.max_degree, request.keep_zero_pairs = facts["max_degree"], facts["keep_zero_pairs"]
    request.monitor = session.monitor
    at = ctypes.addressof(request)
    session.run(lib.netmesh_plan_leaf(facts["dim"], facts["count"], facts["pieces"]),
                lambda: session.call(lib.netmesh_leaf, session.context, at))


def _join(session, folder, node, facts):
    request = sized(c.netmesh_join_request)
    kept = [_need_piece(folder, 2 * node + i, facts) for i in range(2)]
    request.one, request.other, request.monitor = kept[0][1], kept[1][1], session.monitor
    at = ctypes.addressof(request)
    try:
        session.run(3 * (kept[0][1].count + kept[1][1].count),
                    lambda: session.call(lib.netmesh_join, session.context, at))
    except InvalidArgument as error:
        error.args = ("%s: %s; remove it, and its task makes it again" %
                      (_piece_path(folder, 2 * node + (error.argument == "other")), error.args[0]),)
        raise


def collect(folder):
    """The diagram of all pieces."""
    facts = job_of(folder)
    kept = [_need_piece(folder, node, facts) for node in range(1, 2 * facts["pieces"])]
    pieces = (c.netmesh_piece * len(kept))(*(piece for _, piece in kept))
    session = Session()
    request = sized(c.netmesh_collect_request)
    request.pieces, request.count, request.monitor = ctypes.addressof(pieces), len(kept), session.monitor
    asked = request_of(session)
    fill(session, dict(filter="alpha", max_degree=facts["max_degree"], keep_zero_pairs=facts["keep_zero_pairs"]))
    asked.points = c.netmesh_points(8, facts["rows"], facts["dim"], c.NETMESH_POINTS_FLOAT64, 0)
    at = ctypes.addressof(request)
    try:
        session.run(sum(piece.count for _, piece in kept),
                    lambda: session.call(lib.netmesh_collect, session.context, at))
        diagram = _diagram.read(session)
    finally:
        session.end()
    diagram._asked = as_asked(session, settled(session, asked), diagram._report), None
    return diagram


def schedule(folder, executor, memory=None, stays=True):
    """All tasks that are not done, by an executor: joins as soon as what is below them is there. stays: the folder is
    there afterwards."""
    facts = job_of(folder)
    pieces = facts["pieces"]
    done = {node for node in range(1, 2 * pieces) if has_piece(folder, node, facts)}
    waiting = {}

    def begin(node):
        waiting[executor.submit(make, folder, node, memory)] = node

    for node in range(1, 2 * pieces):
        if node not in done and (node >= pieces or {2 * node, 2 * node + 1} <= done):
            begin(node)
    try:
        while waiting:
            for future in concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)[0]:
                node = waiting.pop(future)
                try:
                    future.result()
                except Error:
                    raise
                except Exception as error:
                    raise RuntimeError(
                        "the task of piece %d has not ended well: %s. %s" %
                        (node, str(error) or type(error).__name__,
                         "What is done is in %s; the same call goes on with it" % folder if stays else
                         "With scratch= a folder, what is done stays there, and the same call goes on with it")
                    ) from error
                done.add(node)
                if node > 1 and node ^ 1 in done and node // 2 not in done:
                    begin(node // 2)
    finally:
        for future in waiting:
            future.cancel()


def persist_in_pieces(points, pieces, executor, scratch, memory, max_degree, keep_zero_pairs):
    if scratch is not None and not (isinstance(scratch, (str, os.PathLike)) and os.fspath(scratch)):
        raise InvalidArgument("scratch: must be the path of a folder", "scratch")
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InvalidArgument("executor: must be a concurrent.futures.Executor", "executor")
    folder = os.fspath(scratch) if scratch is not None else tempfile.mkdtemp(prefix="netmesh-")
    try:
        facts = split(points, folder, pieces, max_degree, keep_zero_pairs)
        if executor is not None:
            schedule(folder, executor, memory, scratch is not None)
        else:
            for node in range(2 * facts["pieces"] - 1, 0, -1):
                make(folder, node, memory)
        return collect(folder)
    finally:
        if scratch is None:
            shutil.rmtree(folder, ignore_errors=True)
