"""Diagrams in files."""
import csv
import json
import math
import os
import warnings
from typing import Union

import numpy as np

from . import _declarations as c
from . import _svg
from ._diagram import Diagram
from ._library import FILTERS, OPTIONS, VERSION, lib
from ._options import settled
from .errors import InvalidArgument

MARKER = "# netmesh diagram 1: degree birth death"
# Said of files with a line `# value-error`.
BEFORE_ROUNDING = ("made by netmesh 0.2.0 or before, whose births and deaths were not rounded to nearest; make the "
                   "diagram again")


# Lines of a head in their order; what they are called in the table; what has no line.
_LINES = ("filter", "threshold", "k", "values", "method", "finish", "tau", "fit", "memory", "ratio", "whole-cells",
          "focus", "from", "to", "eps", "theta", "max-degree", "all", "bounds", "seed")
_NAMES = {"focus": "focus_ratio", "from": "focus_from", "to": "focus_to", "all": "keep_zero_pairs"}
_UNSAID = ("domain_factor", "net_spacing", "size_eps", "size_at_inputs", "size_growth")


def _row_of(line):
    return OPTIONS.get(_NAMES.get(line, line.replace("-", "_")))


def _options_head(request, memory):
    """A settled request as the tool writes it, (name, value) each; nothing where lines do not say it all, as of weights
    and cells."""
    if request.function or request.weighting or request.periods or any(OPTIONS[name].get(request) for name in _UNSAID):
        return []
    filter = next(row for row in FILTERS.values() if row.filter == request.filter)
    is_meshed, is_fitted = filter.is_on_mesh or filter.is_by_scales, bool(request.fit)
    by_goal = filter.has_goal or filter.has_eps
    certificate = OPTIONS["method"].words["certificate"]
    by_ratio = by_goal and request.mesh.method == certificate
    if is_meshed and not is_fitted and not by_goal and request.mesh.method == certificate:
        return []  # a word that the tool does not offer
    # Of others: whether they are given.
    due = {"threshold": request.threshold < math.inf, "values": filter.has_values, "memory": is_fitted,
           "method": request.mesh.method and not by_ratio and not is_fitted, "tau": is_meshed and not is_fitted,
           "whole-cells": filter.clips_cells and request.mesh.whole_cells, "max-degree": True, "seed": is_meshed}
    return [(line, _text_of(line, request, memory)) for line in _LINES if due.get(line) or
            (line not in due and _row_of(line).get(request))]


def _text_of(line, request, memory):
    if line == "memory":
        return str(memory)
    row = _row_of(line)
    value = row.get(request)
    if line == "tau" and not value:  # beside a ratio that does not follow from it: the dimension's
        plain = lib.netmesh_default_request()
        plain.points, plain.filter = request.points, FILTERS["basic"].filter
        value = settled(None, plain).mesh.tau
    if row.type == c.NETMESH_OPTION_NAME:
        return next(word for word, stands_for in row.words.items() if stands_for == value)
    if row.type == c.NETMESH_OPTION_DOUBLE:
        return number_text(value)
    return "" if row.type == c.NETMESH_OPTION_FLAG else str(value)


def arguments_of(head):
    """Options, by their names in the table, that the lines of a head stand for."""
    kinds = {c.NETMESH_OPTION_FLAG: lambda _: True, c.NETMESH_OPTION_NAME: str, c.NETMESH_OPTION_DOUBLE: float}
    rows = [(_row_of(line), text) for line, text in head]
    given = {row.name: kinds.get(row.type, int)(text) for row, text in rows if row}
    if "ratio" in given:  # which says what the mesh is made for
        given.pop("tau", None)
    return given


def number_text(value):
    """The shortest text that is read as the same number, as the tool writes it (C++'s to_chars)."""
    value = float(value) + 0.0
    if not math.isfinite(value):
        return repr(value)
    is_whole = value == math.floor(value)
    plain = str(int(value)) if is_whole else np.format_float_positional(value, unique=True, trim="-")
    scientific = np.format_float_scientific(value, unique=True, trim="-", exp_digits=2)
    return plain if len(plain) <= len(scientific) else scientific


def options_of(diagram):
    """How a diagram is made, in the words of a head; none where a file cannot say that."""
    asked = diagram._asked
    if isinstance(asked, list):  # of a diagram that came from another process
        return asked
    return _options_head(*asked) if asked is not None and 2 <= asked[0].points.dim <= 6 else []


def head_of(diagram):
    """The lines of a .pers file's head, (name, value) each; none where a file cannot say how the diagram is made."""
    options, report = options_of(diagram), diagram._report
    if not options:
        return []
    part = report.diagram
    lines = [("version", VERSION)] + options
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
            line += " exists" if bounds.certain[i] else ""
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
    elif ending == ".svg":
        text = _svg.barcode(diagram)
    else:
        raise InvalidArgument("path: ends in none of .pers, .csv, .npy, .svg, the last of which is a picture; for "
                              "others diagram.plot().figure.savefig(path), by matplotlib", "path")
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(text)


def _rows_of_others(path):
    """Bars of .csv, .npy and .json; None of what is read by lines."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending not in (".csv", ".npy", ".json"):
        return None
    try:
        if ending == ".npy":
            bars = np.load(path).tolist()
        elif ending == ".json":
            with open(path, encoding="utf-8") as file:
                bars = [(k, b, np.inf if d is None else d) for k, b, d in json.load(file)["bars"]]
        else:
            with open(path, encoding="utf-8-sig", newline="") as file:
                lines = [line for line in csv.reader(file) if line]
            names = [name.strip().lower() for name in lines[0]] if lines else []
            places = [names.index(name) for name in ("degree", "birth", "death")]
            bars = [[line[k] or "inf" for k in places] for line in lines[1:]]
        rows = [(int(k), float(b), float(d)) for k, b, d in bars]
    except (ValueError, KeyError, TypeError, IndexError) as error:
        raise InvalidArgument("path: %s: no rows of degree, birth and death: %s" % (path, error), "path") from None
    for i, (k, b, d) in enumerate(rows):
        if k < 0 or not np.isfinite(b) or not d >= b:
            raise InvalidArgument("path: %s: bar %d: not degree, birth and death" % (path, i + 1), "path", i)
    return rows


def load(path: Union[str, os.PathLike]) -> Diagram:
    """Reads a .pers file, of this package or of the tool, or the bars in .csv, .npy and .json that these write. Bounds
    are not read: ``netmesh.check`` makes them anew. A file without bars, head and header is refused.

    Warns of files of version 0.2.0 and before whose births and deaths were not rounded to nearest.
    """
    head, rows = [], _rows_of_others(path)
    is_said = rows is not None  # that this is a diagram, which may have no bar that was chosen
    with open(os.devnull if rows is not None else path, encoding="utf-8") as file:
        rows = rows or []
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
            elif line.startswith(("# netmesh diagram ", "# a choice of ")):
                is_said = True
            elif line.startswith("#") and not rows and not line.startswith("# scale "):
                name, _, value = line[1:].strip().partition(" ")
                head.append((name, value.strip()))
    if not rows and not is_said:
        raise InvalidArgument("path: %s: no diagram: it has no bars, no head and no header" % path, "path")
    lines = dict(head)
    if "value-error" in lines:
        warnings.warn("%s: this file was %s" % (path, BEFORE_ROUNDING), stacklevel=2)
    if lines.get("filter") not in FILTERS:
        head, lines = [], {}
    rows.sort()
    degrees = np.array([row[0] for row in rows], dtype=np.int64)
    top = int(lines.get("max-degree", max(degrees, default=0)))
    starts = np.searchsorted(degrees, np.arange(top + 2)).tolist()
    facts = {"filter": lines.get("filter", ""), "fingerprint": "", "reference": lines.get("reference", ""),
             "squares": "squares" in lines if lines else None}
    for name, default in (("certified-ratio", np.inf), ("certified-from", 0), ("certified-error", 0)):
        facts[name.replace("-", "_")] = float(lines.get(name, default))
    intervals = np.array([row[1:] for row in rows]).reshape(len(rows), 2)
    diagram = Diagram(intervals, starts, facts)
    diagram._head = head
    return diagram
