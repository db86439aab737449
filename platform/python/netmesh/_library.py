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


class Filter:
    """A row of the library's table of filters."""

    def __init__(self, info):
        for name, _ in c.netmesh_filter_info._fields_:
            setattr(self, name, getattr(info, name))
        self.name = info.name.decode()
        self.reference = info.reference.decode()


_KINDS = {c.NETMESH_OPTION_UINT64: ctypes.c_uint64, c.NETMESH_OPTION_DOUBLE: ctypes.c_double}


class Option:
    """A row of the library's table of options: a member of netmesh_request."""

    def __init__(self, index, row):
        self.type, self.field, self.object = row.type, row.field, row.object
        self.name, self.range = row.name.decode(), row.range.decode()
        #: What each word stands for, an object's address or a number.
        self.words = {}
        word = sized(c.netmesh_option_word)
        while lib.netmesh_get_option_word(index, len(self.words), ctypes.addressof(word)) == c.NETMESH_OK:
            self.words[word.name.decode()] = word.object or word.value
        is_address = self.object or word.object
        self._kind = ctypes.c_void_p if is_address else _KINDS.get(self.type, ctypes.c_uint32)
        self._offset = row.offset
        self.bits = 8 * ctypes.sizeof(self._kind)
        self.default = self.get(lib.netmesh_default_request())

    def get(self, request):
        return self._kind.from_buffer(request, self._offset).value

    def put(self, request, value):
        self._kind.from_buffer(request, self._offset).value = value


def _rows(get, struct, row):
    rows = []
    found = sized(struct)
    while get(len(rows), ctypes.addressof(found)) == c.NETMESH_OK:
        rows.append(row(len(rows), found))
    return {row.name: row for row in rows}


FILTERS = _rows(lib.netmesh_get_filter_info, c.netmesh_filter_info, lambda _, info: Filter(info))
FILTER_NAMES = {row.id: row.name for row in FILTERS.values()}
OPTIONS = _rows(lib.netmesh_get_option, c.netmesh_option, Option)
OPTION_NAMES = {row.field: row.name for row in OPTIONS.values()}
