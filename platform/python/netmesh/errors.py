"""What goes wrong: an exception for each status of the library, all of them an :class:`Error`.

Each has ``argument``, the name of the argument that it is about, and ``row``, the row of it, from 0 on; ``None`` where
there is none. ``cloud`` is the number of the cloud of :func:`netmesh.persist_all`.
"""
from typing import Optional

from . import _declarations as c
from ._library import OPTION_NAMES, lib

__all__ = ["Error", "InvalidArgument", "OutOfMemory", "Cancelled", "NotFinite", "OutOfRange", "Flat", "TooClose",
           "NoResult", "CheckFailed", "FloatingPointMode", "InternalError", "NotAComplex", "NotBuilt"]


class Error(Exception):
    """Anything that this package refuses or cannot do."""

    def __init__(self, message: str, argument: Optional[str] = None, row: Optional[int] = None):
        super().__init__(message)
        self.argument = argument
        self.row = row
        self.cloud: Optional[int] = None


class InvalidArgument(Error, ValueError):
    """An argument that is not admitted."""


class OutOfMemory(Error, MemoryError):
    """The block is too small. ``bytes_wanted``: at least so many are needed; 0 where nothing is known.
    ``bytes_planned``: how many to try next, more than ``memory``: enough for points like uniform ones, or twice
    ``memory`` where that was not enough. So the same call again with ``memory=error.bytes_planned``, some few times,
    ends in a result. 0 where ``memory`` was not given, or where the system does not have it."""

    bytes_wanted = 0
    bytes_planned = 0


class Cancelled(Error):
    """The progress function asked to stop."""


class NotFinite(Error, ValueError):
    """A coordinate or value is NaN or infinite."""


class OutOfRange(Error, ValueError):
    """A coordinate has a magnitude that is not admitted."""


class Flat(Error, ValueError):
    """Fewer than D + 1 affinely independent points: there is no triangulation."""


class TooClose(Error, ValueError):
    """Two points are distinct, but closer than coordinates resolve; ``other_row`` is the second one."""

    other_row: Optional[int] = None


class NoResult(Error, RuntimeError):
    """An earlier step is missing."""


class CheckFailed(Error):
    """A check has found a violation."""


class FloatingPointMode(Error, RuntimeError):
    """The processor does not round to nearest, or flushes small numbers to zero."""


class InternalError(Error, RuntimeError):
    """An invariant of the library does not hold: a defect, please report it."""


class NotAComplex(Error, ValueError):
    """A simplex has no place in a filtered complex."""


class NotBuilt(Error, NotImplementedError):
    """This build of the library leaves that out."""


_CLASSES = {
    c.NETMESH_INVALID_ARGUMENT: InvalidArgument, c.NETMESH_OUT_OF_MEMORY: OutOfMemory,
    c.NETMESH_CANCELLED: Cancelled, c.NETMESH_NOT_FINITE: NotFinite, c.NETMESH_OUT_OF_RANGE: OutOfRange,
    c.NETMESH_FLAT: Flat, c.NETMESH_TOO_CLOSE: TooClose, c.NETMESH_NO_RESULT: NoResult,
    c.NETMESH_CHECK_FAILED: CheckFailed, c.NETMESH_FLOATING_POINT: FloatingPointMode,
    c.NETMESH_INTERNAL: InternalError, c.NETMESH_NOT_A_COMPLEX: NotAComplex, c.NETMESH_NOT_BUILT: NotBuilt,
}

# Fields of requests that are called something else here, by the table of options or by their own name.
ARGUMENTS = {
    "cycles": "representatives", "focus_ratio": "focus", "focus_from": "focus", "focus_to": "focus", "k_last": "k",
    "sizes": "size", "relative_error": "error", "pairs_a": "a", "pairs_b": "b", "entries": "values",
    "evaluate": "function",
}
# Those of a source: the argument whose rows are read.
_OF_SOURCES = ("dim", "count", "format", "stride_bytes", "numbers", "entry_count", "vertices", "starts",
               "simplex_count")
_FAULTS = {
    c.NETMESH_FAULT_SIZE: "has no vertices or more than 32", c.NETMESH_FAULT_TOO_MANY: "is one of too many",
    c.NETMESH_FAULT_VERTEX_TWICE: "has a vertex twice",
    c.NETMESH_FAULT_LISTED_TWICE: "is simplex {b} once more",
    c.NETMESH_FAULT_FACE_MISSING: "lacks the face without its vertex number {b}",
    c.NETMESH_FAULT_FACE_LATER: "enters before its face {b}",
}
# Of these index_a is a row.
_OF_ROWS = (c.NETMESH_NOT_FINITE, c.NETMESH_OUT_OF_RANGE, c.NETMESH_TOO_CLOSE, c.NETMESH_NOT_A_COMPLEX)


def error_of(status, detail, rows="points", renamed=None):
    """The exception for a status. ``rows``: the argument whose rows jobs read; ``renamed``: names of arguments."""
    text = lib.netmesh_status_text(status).decode()
    said = (detail.message or b"").decode() if detail.status == status else ""
    argument = row = None
    if status in _OF_ROWS:
        argument, row = rows, detail.index_a
        if said.startswith("the function"):
            argument, row = "function", None
        if said.startswith("a weight"):
            argument = (renamed or {}).get("weights", "weights")
        text = said or text
        if status == c.NETMESH_TOO_CLOSE:
            text = "%s: %s" % (_place(rows, row), "too close to row %d, but not equal to it: coordinates do not "
                               "resolve the distance for this mesh" % detail.index_b)
        elif status == c.NETMESH_NOT_A_COMPLEX:
            fault = _FAULTS.get(detail.fault, "has no place in a complex")
            text = "%s %s" % (_place(rows, row), fault.format(b=detail.index_b))
        else:
            text = "%s: %s" % (_place(argument, row), text)
    elif status in (c.NETMESH_INVALID_ARGUMENT, c.NETMESH_NOT_BUILT):
        field = OPTION_NAMES.get(detail.field) or lib.netmesh_field_text(detail.field).decode()
        argument = {**ARGUMENTS, **(renamed or {})}.get(field, field) if detail.field else None
        of_distances = field == "entries" and rows == "distances"
        if field in _OF_SOURCES or of_distances:
            argument = rows
        is_of_row = field in ("sizes", "size_at_inputs", "numbers") or said == "a radius is negative"
        if is_of_row or of_distances:
            row = detail.index_a
        text = "%s: %s" % (_place(argument, row), said or text) if argument else said or text
    elif status == c.NETMESH_OUT_OF_MEMORY:
        argument = "memory"
        if detail.bytes_wanted:
            text += "; it takes more than %d bytes" % (detail.bytes_wanted - 1)
    elif status in (c.NETMESH_CHECK_FAILED, c.NETMESH_NO_RESULT, c.NETMESH_INTERNAL, c.NETMESH_FLAT):
        text = said or text
        argument = rows if status == c.NETMESH_FLAT else None
        text = "%s: %s" % (argument, text) if argument else text
    error = _CLASSES[status](text, argument, row)
    if status == c.NETMESH_OUT_OF_MEMORY:
        error.bytes_wanted = detail.bytes_wanted
    if status == c.NETMESH_TOO_CLOSE:
        error.other_row = detail.index_b
    return error


def _place(argument, row):
    return argument if row is None else "%s, row %d" % (argument, row)
