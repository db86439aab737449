"""The shared library, its functions and its tables."""
import ctypes
import os
import sys

from . import _declarations as c


def _path():
    """The library named by NETMESH_LIBRARY, or the one that is installed beside this file."""
    named = os.environ.get("NETMESH_LIBRARY")
    if named:
        return named
    ending = {"darwin": "dylib", "win32": "dll"}.get(sys.platform, "so")
    return os.path.join(os.path.dirname(os.path.abspath(__file__)), "libnetmesh." + ending)


class _Entry(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("function", ctypes.c_void_p)]


class Functions:
    """The library's functions as attributes. A call gives the interpreter's lock away while it runs."""

    def __init__(self, path):
        try:
            self._library = ctypes.CDLL(path)
        except OSError as error:
            raise ImportError("netmesh: the shared library cannot be loaded: %s. Build it with `pip install .`, or set "
                              "NETMESH_LIBRARY to the one that cmake has built" % error) from None
        first = ctypes.addressof(_Entry.in_dll(self._library, "netmesh_python_functions"))
        addresses = {}
        while True:
            entry = _Entry.from_address(first + len(addresses) * ctypes.sizeof(_Entry))
            if entry.name is None:
                break
            addresses[entry.name.decode()] = entry.function
        if set(addresses) != set(c.FUNCTIONS):
            raise ImportError("netmesh: %s is of another version than this package" % path)
        for name, (result, arguments) in c.FUNCTIONS.items():
            setattr(self, name, ctypes.CFUNCTYPE(result, *arguments)(addresses[name]))
        self.addresses = addresses


lib = Functions(_path())
VERSION = lib.netmesh_version_text().decode()
if lib.netmesh_version() != (c.NETMESH_VERSION_MAJOR << 16 | c.NETMESH_VERSION_MINOR << 8 | c.NETMESH_VERSION_PATCH):
    raise ImportError("netmesh: the shared library is version %s, another one than this package" % VERSION)


def sized(struct):
    """An empty struct for a result, with its size set."""
    made = struct()
    made.struct_bytes = ctypes.sizeof(struct)
    return made


def requested(struct, *arguments):
    """A request with the defaults that its init call writes."""
    made = struct()
    getattr(lib, struct.__name__ + "_init")(ctypes.addressof(made), ctypes.sizeof(struct), *arguments)
    return made


class Filter:
    """A row of the library's table of filters."""

    def __init__(self, info):
        for name, _ in c.netmesh_filter_info._fields_:
            setattr(self, name, getattr(info, name))
        self.name = info.name.decode()
        self.reference = info.reference.decode()


def _filters():
    rows = {}
    info = sized(c.netmesh_filter_info)
    while lib.netmesh_get_filter_info(len(rows), ctypes.addressof(info)) == c.NETMESH_OK:
        row = Filter(info)
        rows[row.name] = row
    return rows


FILTERS = _filters()
FILTER_NAMES = {row.filter: row.name for row in FILTERS.values()}
