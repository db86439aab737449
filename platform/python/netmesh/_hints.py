"""What somebody may have meant: names that are nearly those there are, and things that are no arrays of numbers."""
import difflib
import os

import numpy as np

# What other packages call it.
_ELSEWHERE = {
    "maxdim": "max_degree", "max_dim": "max_degree", "max_dimension": "max_degree", "homology_dimensions": "max_degree",
    "degree": "max_degree", "thresh": "threshold", "max_edge_length": "threshold", "max_radius": "threshold",
    "distance_matrix": "distances", "metric": "distances", "do_cocycles": "representatives",
    "cycles": "representatives", "box": "cell", "lattice": "cell", "periodic": "pbc", "p": "order", "q": "order",
    "usecols": "columns", "sep": "delimiter", "skiprows": "skip", "skip_header": "skip", "dropna": "drop_missing",
}
_DIAMETERS = {"thresh": "ripser", "max_edge_length": "GUDHI"}


def did_you_mean(given, names):
    """"; did you mean knn?", or nothing."""
    found = difflib.get_close_matches(str(given).lower(), [str(name) for name in names], 1)
    return "; did you mean %s?" % found[0] if found else ""


def unknown_argument(call, name, names):
    """The exception for a keyword argument that a call does not have."""
    meant = _ELSEWHERE.get(name)
    hint = "; did you mean %s?" % meant if meant in names else did_you_mean(name, names)
    if name == "delay":
        hint = "; netmesh.delay(x, lag) makes points of a series x"
    if meant in names and name in _DIAMETERS:
        hint += " It is a radius, half of what %s takes" % _DIAMETERS[name]
    return TypeError("%s() got an unexpected keyword argument %r%s" % (call, name, hint))


def is_diagram(values):
    return hasattr(values, "intervals") and hasattr(values, "certified_ratio")


def of_no_numbers(values):
    """Why values are no array of real numbers, as far as that can be told, and what helps."""
    return _of_another_kind(values) or "not numbers in rows of equal length" + _of_no_rows(values)


def _of_another_kind(values):
    """What values are that have rows of equal length, but of nothing that is taken for coordinates."""
    if is_diagram(values):
        return "a netmesh.Diagram; its bars are .pairs, [m, 3]"
    if hasattr(values, "tocoo"):
        return "a sparse matrix of scipy; .toarray() has all of its numbers, rips(distances=) takes one of distances"
    try:
        kind = np.asarray(values).dtype.kind
    except (TypeError, ValueError):
        return ""
    if kind == "c":
        return "complex numbers; numpy.column_stack((z.real, z.imag)) makes two columns of z"
    if kind == "b":
        return ("an array of bool; numpy.argwhere(mask) has the places that are true as rows, mask.astype(float) 0 and "
                "1 as numbers")
    return ""


def _of_no_rows(values):
    """Why values are no rows of numbers; begins with ": "."""
    if isinstance(values, (str, os.PathLike)):
        return ": a path or text; netmesh.read_table(path).points are those of a table, netmesh.load(path) is a diagram"
    if hasattr(values, "points") and hasattr(values, "notes"):
        return ": a netmesh.Table; its numbers are .points"
    if hasattr(values, "columns") and hasattr(values, "dtypes"):
        words = [name for name, kind in zip(values.columns, values.dtypes) if getattr(kind, "kind", "O") not in "fiub"]
        numbers = [name for name in values.columns if name not in words]
        if words and len(numbers) > 1:
            return ": no numbers in column %s; df[%r] leaves such columns out" % (
                ", ".join("%r" % (name,) for name in words), numbers)
    names = getattr(getattr(values, "dtype", None), "names", None)
    if names:
        return ": an array of records; numpy.column_stack([points[name] for name in %r]) makes rows of them" % (
            list(names),)
    return _first_of_no_number(values)


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def _first_of_no_number(values):
    """The first value that is no number, or row that is longer or shorter than the first one."""
    try:
        rows = [list(row) for row in values]
    except TypeError:
        return ""
    for i, row in enumerate(rows):
        if len(row) != len(rows[0]):
            return ": row %d has %d, row 0 has %d" % (i, len(row), len(rows[0]))
        for value in row:
            if isinstance(value, (str, bytes)) and not _is_number(value):
                return ": %r in row %d" % (value, i)
    return ""
