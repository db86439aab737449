"""Diagrams in files."""
import os
import warnings
from typing import Union

import numpy as np

from . import _declarations as c
from ._diagram import Diagram
from ._library import FILTERS, VERSION
from ._options import number_text
from .errors import InvalidArgument

MARKER = "# netmesh diagram 1: degree birth death"
# Said of files with a line `# value-error`.
BEFORE_ROUNDING = ("made by netmesh 0.2.0 or before, whose births and deaths were not rounded to nearest; make the "
                   "diagram again")


def head_of(diagram):
    """The lines of a .pers file's head, (name, value) each; none where a file cannot say how the diagram is made."""
    options, report = diagram._options, diagram._report
    if options is None or report is None or options.function is not None or options.dim > 6 or options.dim < 2:
        return []
    part = report.diagram
    lines = [("version", VERSION)] + options.head()
    lines += [("dim", str(report.input.dim)), ("points", str(report.input.points)),
              ("duplicates", str(report.input.duplicates)), ("input", "%016x" % report.input.fingerprint)]
    if report.mesh.is_mesh:
        lines.append(("domain", " ".join(map(number_text, report.mesh.domain[:report.input.dim + 1]))))
    lines.append(("certified-ratio", number_text(part.certified_ratio)))
    if part.certified_from > 0:
        lines.append(("certified-from", number_text(part.certified_from)))
    lines.append(("reference", diagram.reference))
    return lines


def _pers(diagram):
    lines = head_of(diagram)
    text = [MARKER] + ["# %s %s" % line if line[1] else "# " + line[0] for line in lines] if lines else []
    bounds = diagram.bounds
    by_error = diagram.filter == "function"
    if bounds is not None:
        for row in bounds.steps:
            numbers = list(map(number_text, row))
            text.append("# scale %s low %s high %s reach %s %s %s" % (
                *numbers[:4], "error" if by_error else "ratio", numbers[5 if by_error else 4]))
    for i, (degree, birth, death) in enumerate(diagram):
        line = "%d %s %s" % (degree, number_text(birth), number_text(death))
        if bounds is not None:
            line += " # birth %s %s death %s %s" % (*map(number_text, bounds.birth[i]),
                                                    *map(number_text, bounds.death[i]))
            line += " real" if bounds.certain[i] else ""
        text.append(line)
    return "\n".join(text + [""])


def save(diagram, path):
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending == ".npy":
        np.save(path, diagram.pairs)
        return
    if ending == ".pers":
        text = _pers(diagram)
    elif ending == ".csv":
        rows = ["%d,%s,%s" % (k, number_text(b), number_text(d)) for k, b, d in diagram]
        text = "\n".join(["degree,birth,death"] + rows + [""])
    else:
        raise InvalidArgument("path: ends in none of .pers, .csv, .npy", "path")
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(text)


def load(path: Union[str, os.PathLike]) -> Diagram:
    """Reads a .pers file, of this package or of the tool. Bounds are not read: ``netmesh.check`` makes them anew.

    Warns of files of version 0.2.0 and before whose births and deaths were not rounded to nearest.
    """
    head, rows = [], []
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file):
            words = line.split("#")[0].split()
            if words:
                try:
                    rows.append((int(words[0]), float(words[1]), float(words[2])))
                    birth, death = rows[-1][1:]
                    if len(words) != 3 or rows[-1][0] < 0 or not (np.isfinite(birth) and death >= birth):
                        raise ValueError
                except (ValueError, IndexError):
                    raise InvalidArgument("path: %s:%d: not degree, birth and death" % (path, number + 1), "path",
                                          number) from None
            elif line.startswith("#") and not rows and not line.startswith(("# scale ", "# netmesh diagram ")):
                name, _, value = line[1:].strip().partition(" ")
                head.append((name, value.strip()))
    lines = dict(head)
    if "value-error" in lines:
        warnings.warn("%s: this file was %s" % (path, BEFORE_ROUNDING), stacklevel=2)
    if lines.get("filter") not in FILTERS:
        head, lines = [], {}
    rows.sort()
    degrees = np.array([row[0] for row in rows], dtype=np.int64)
    top = int(lines.get("max-degree", max(degrees, default=0)))
    starts = np.searchsorted(degrees, np.arange(top + 2)).tolist()
    facts = {"filter": lines.get("filter", ""), "fingerprint": "", "reference": lines.get("reference", "")}
    for name, default in (("certified-ratio", np.inf), ("certified-from", 0), ("certified-error", 0)):
        facts[name.replace("-", "_")] = float(lines.get(name, default))
    intervals = np.array([row[1:] for row in rows]).reshape(len(rows), 2)
    diagram = Diagram(intervals, starts, facts)
    diagram._head = head
    return diagram
