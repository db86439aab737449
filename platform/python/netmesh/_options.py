"""How a diagram is made: what was asked for, with nothing left open, as requests and as the head of a .pers file."""
import ctypes
import math

import numpy as np

from . import _declarations as c
from ._arrays import choice, number, positive, whole
from ._library import FILTERS, lib, requested
from ._session import bytes_of
from .errors import InvalidArgument

VALUES = {"certified": c.NETMESH_VALUES_CERTIFIED, "thesis": c.NETMESH_VALUES_THESIS}
METHODS = {"svr": c.NETMESH_METHOD_SVR, "netmesh": c.NETMESH_METHOD_HIERARCHY, "refine": c.NETMESH_METHOD_REFINE}
FIT_RATIO, EPS, THETA, LONGER_THAN = 4.0, 0.5, 1.0 / 9, 1.5  # the tool's


# What goes with either filter of "auto"; everything else asks for a mesh.
OF_EITHER = {"max_degree", "keep_zero_pairs", "bounds", "representatives", "seed", "memory"}


def filter_row(name):
    if not isinstance(name, str) or name not in FILTERS:
        raise InvalidArgument("filter: %r is none of auto, %s" % (name, ", ".join(FILTERS)), "filter")
    return FILTERS[name]


class Options:
    """The arguments of ``persist`` for points of one dimension. Everything that a filter does not read is refused."""

    def __init__(self, dim, filter, given):
        self.dim = dim
        self.filter = row = filter_row(filter)
        self.name = row.name
        given = {name: value for name, value in given.items() if value is not None and value is not False}
        self._refuse(given)
        take = given.get
        self.fit = bool(take("fit", False))
        self.memory = bytes_of(take("memory"))
        self.finish = bool(take("finish", False))
        self.method = None if take("method") is None else choice(take("method"), "method", METHODS)
        self.is_error = take("error") is not None or (self.fit and row.needs_function)
        self.values = choice(take("values", "thesis" if self.is_error else "certified"), "values", VALUES)
        self.k = whole(take("k", 1), "k", 1) if row.needs_k else 0
        self.seed = whole(take("seed", 1), "seed", 0, 2 ** 64 - 1)
        self.tau_given = 0.0 if take("tau") is None else positive(take("tau"), "tau")
        self.ratio = None if take("ratio") is None else positive(take("ratio"), "ratio")
        self.eps = 0.0 if take("eps") is None else positive(take("eps"), "eps")
        self.theta = positive(take("theta", THETA), "theta") if row.has_theta else 0.0
        self.error = 0.0 if take("error") is None else positive(take("error"), "error")
        self.distance_factor = 0.0 if take("distance_factor") is None else positive(take("distance_factor"),
                                                                                    "distance_factor")
        self.whole_cells = bool(take("whole_cells", False))
        self.keep_zero_pairs = bool(take("keep_zero_pairs", False))
        self.bounds = bool(take("bounds", False))
        self.representatives = bool(take("representatives", False))
        self._take_degree(take("max_degree"))
        self._take_function(take)
        self._take_focus(take("focus"), take("longer_than"))
        if self.fit and self.memory is None:
            raise InvalidArgument("fit: needs memory=, the size to fit in", "fit")
        self._settle()

    def _refuse(self, given):
        row = self.filter
        on_mesh = row.source == c.NETMESH_SOURCE_MESH
        by_scales = row.source == c.NETMESH_SOURCE_SCALES
        reads = {"k": row.needs_k, "function": row.needs_function, "lipschitz": row.needs_function,
                 "cut": row.needs_function, "error": row.needs_function, "distance_factor": row.needs_function,
                 "eps": row.has_eps, "theta": row.has_theta, "values": row.has_values,
                 "ratio": on_mesh or by_scales, "tau": on_mesh or by_scales, "seed": True, "method": on_mesh,
                 "finish": on_mesh, "focus": on_mesh, "longer_than": on_mesh, "whole_cells": on_mesh, "fit": on_mesh,
                 "representatives": row.has_representatives}
        for name in given:
            if not reads.get(name, True):
                raise InvalidArgument("%s: not for the filter %s" % (name, row.name), name)

    def _take_degree(self, max_degree):
        on_points = self.filter.source == c.NETMESH_SOURCE_POINTS
        if max_degree is None:
            self.max_degree = 1 if on_points else self.dim - 1
        else:
            self.max_degree = whole(max_degree, "max_degree", 0, 30)
            if not on_points:
                self.max_degree = min(self.max_degree, self.dim - 1)

    def _take_function(self, take):
        self.function = take("function")
        if not self.filter.needs_function:
            return
        for name in ("function", "lipschitz", "cut"):
            if take(name) is None:
                raise InvalidArgument("%s: the filter function needs it" % name, name)
        self.lipschitz = number(take("lipschitz"), "lipschitz")
        self.cut = number(take("cut"), "cut")
        if self.fit and self.error:
            raise InvalidArgument("error: fit finds the least one", "error")

    def _take_focus(self, focus, longer_than):
        self.focus = None
        self.longer_than = 0.0
        if focus is None:
            if longer_than is not None:
                raise InvalidArgument('longer_than: goes with focus="auto"', "longer_than")
            return
        if isinstance(focus, str) and focus == "auto":
            if self.memory is None:
                raise InvalidArgument('focus: "auto" needs memory=, the size to fit in', "focus")
            if self.fit:
                raise InvalidArgument('fit: finds the best ratio, focus="auto" which bars are real', "fit")
            self.longer_than = LONGER_THAN if longer_than is None else positive(longer_than, "longer_than")
            self.bounds = True
            return
        try:
            numbers = [float(x) for x in focus]
        except (TypeError, ValueError):
            numbers = []
        if len(numbers) != (2 if self.fit else 3):
            raise InvalidArgument('focus: "auto", (ratio, from, to), or with fit (from, to)', "focus")
        self.focus = (0.0, *numbers) if self.fit else tuple(numbers)

    def _settle(self):
        row = self.filter
        if row.has_eps and self.eps and self.ratio:
            raise InvalidArgument("eps: ratio says what is asked for, too", "eps")
        open_accuracy = row.has_eps and not (self.eps or self.ratio or self.fit or self.method is not None)
        if self.dim >= 4 and open_accuracy and self.values == c.NETMESH_VALUES_CERTIFIED:
            self.ratio = self._default_ratio() * (1 + 3 * self.theta)
        if row.has_eps and not self.eps and not self.ratio:
            self.eps = EPS
        if self.longer_than and (not row.has_goal or not self.refines):
            raise InvalidArgument('focus: "auto" is for the complete filter with certified values', "focus")
        by_scales = row.source == c.NETMESH_SOURCE_SCALES
        if (self.ratio or self.focus) and not (self.refines or (by_scales and not self.focus)):
            raise InvalidArgument("%s: for filters refined by the certificate: complete, or tight and scales by "
                                  "ratio; certified values, no method" % ("ratio" if self.ratio else "focus"),
                                  "ratio" if self.ratio else "focus")
        if self.whole_cells and not self.clips:
            raise InvalidArgument("whole_cells: for meshes refined by the certificate for clipped cells",
                                  "whole_cells")
        if self.fit and not (self.refines or self.fits_error):
            raise InvalidArgument("fit: for filters on a mesh but tight, without method", "fit")
        if self.refines and self.ratio is None:
            self.ratio = FIT_RATIO if self.fit else self._default_ratio()

    def _default_ratio(self):
        return math.sqrt(2 + self.tau)

    @property
    def on_mesh(self):
        return self.filter.source == c.NETMESH_SOURCE_MESH

    @property
    def fits_error(self):
        return self.fit and self.method is None and not self.finish and bool(self.filter.needs_function)

    @property
    def refines(self):
        """Whether the mesh is refined by the certificate."""
        row = self.filter
        if not self.on_mesh or self.method is not None or self.finish:
            return False
        if self.fit:
            return not row.has_eps and not row.needs_function
        by_goal = row.has_goal or (row.has_eps and self.ratio is not None)
        return bool(by_goal) and self.values == c.NETMESH_VALUES_CERTIFIED

    @property
    def clips(self):
        return self.refines and bool(self.filter.clips_cells)

    @property
    def tau(self):
        request = requested(c.netmesh_mesh_request, self.dim)
        request.tau = self.tau_given
        return lib.netmesh_tau(ctypes.addressof(request))

    def goal(self):
        ratio = self.ratio if self.ratio is not None else self._default_ratio()
        return c.netmesh_certificate_goal(ratio, *(self.focus or (0.0, 0.0, 0.0)))

    def mesh_request(self):
        request = requested(c.netmesh_mesh_request, self.dim)
        request.dim = self.dim
        request.seed = self.seed
        request.purpose = c.NETMESH_PURPOSE_PERSIST if self.refines else self.filter.purpose
        request.method = c.NETMESH_METHOD_SVR if self.method is None else self.method
        request.tau = self.tau_given
        request.tight_eps = self.eps if self.filter.has_eps else 0.0
        request.finish = self.finish
        if self.refines:
            request.certificate = self.goal()
        request.whole_cells = self.whole_cells or not self.clips
        return request

    def put_diagram(self, request):
        request.values = self.values
        request.max_degree = self.max_degree
        request.keep_zero_pairs = self.keep_zero_pairs

    def fit_request(self):
        request = requested(c.netmesh_fit_request, self.dim)
        request.dim = self.dim
        request.seed = self.seed
        request.by_error = self.fits_error
        request.ratio = 0.0 if self.fits_error else self.ratio
        request.longer_than = self.longer_than
        if self.focus:
            request.focus_from, request.focus_to = self.focus[1:]
        self.put_diagram(request)
        request.bounds = self.bounds
        request.filter = self.filter.filter
        request.k = self.k
        request.whole_cells = self.whole_cells
        return request

    def take_goal(self, goal):
        """What focus="auto" has chosen, as if it had been asked for."""
        self.longer_than = 0.0
        self.ratio = goal.ratio
        self.focus = (goal.focus_ratio, goal.focus_from, goal.focus_to) if goal.focus_ratio > 0 else None

    def head(self):
        """The options as the tool writes them, (name, value) each."""
        row = self.filter
        lines = [("filter", row.name)]
        if row.needs_k:
            lines.append(("k", str(self.k)))
        if row.has_values:
            lines.append(("values", "thesis" if self.values else "certified"))
        by_scales = row.source == c.NETMESH_SOURCE_SCALES
        if self.on_mesh:
            if not self.refines and not self.fits_error:
                names = {number: name for name, number in METHODS.items()}
                lines.append(("method", names[self.method or c.NETMESH_METHOD_SVR]))
                if self.finish:
                    lines.append(("finish", ""))
        if (self.on_mesh and not self.fit) or by_scales:
            lines.append(("tau", number_text(self.tau)))
        if self.fit:
            lines += [("fit", ""), ("memory", str(self.memory))]
        if self.refines:
            lines.append(("ratio", number_text(self.ratio)))
        elif by_scales and self.ratio:
            lines.append(("ratio", number_text(self.ratio)))
        if self.clips and self.whole_cells:
            lines.append(("whole-cells", ""))
        if self.focus:
            names = ("focus", "from", "to")
            lines += [pair for pair in zip(names, map(number_text, self.focus)) if pair[0] != "focus" or not self.fit]
        if row.has_eps and self.ratio is None:
            lines.append(("eps", number_text(self.eps)))
        if row.has_theta:
            lines.append(("theta", number_text(self.theta)))
        lines.append(("max-degree", str(self.max_degree)))
        if self.keep_zero_pairs:
            lines.append(("all", ""))
        if self.bounds:
            lines.append(("bounds", ""))
        if self.on_mesh or by_scales:
            lines.append(("seed", str(self.seed)))
        return lines


def arguments_of(head):
    """The arguments of ``persist`` that the lines of a head stand for."""
    lines = dict(head)
    names = {"k": int, "values": str, "method": str, "tau": float, "ratio": float, "eps": float, "theta": float,
             "max-degree": int, "seed": int, "memory": int}
    arguments = {name.replace("-", "_"): kind(lines[name]) for name, kind in names.items() if name in lines}
    for name, argument in (("finish", "finish"), ("fit", "fit"), ("whole-cells", "whole_cells"),
                           ("all", "keep_zero_pairs"), ("bounds", "bounds")):
        if name in lines:
            arguments[argument] = True
    if "from" in lines:
        focus = [float(lines[name]) for name in ("focus", "from", "to") if name in lines]
        arguments["focus"] = tuple(focus)
    if arguments.get("fit") and "ratio" not in arguments:
        arguments.pop("tau", None)
    return lines["filter"], arguments


def number_text(value):
    """The shortest text that is read as the same number, as the tool writes it (C++'s to_chars)."""
    value = float(value) + 0.0
    if not math.isfinite(value):
        return repr(value)
    is_whole = value == math.floor(value)
    plain = str(int(value)) if is_whole else np.format_float_positional(value, unique=True, trim="-")
    scientific = np.format_float_scientific(value, unique=True, trim="-", exp_digits=2)
    return plain if len(plain) <= len(scientific) else scientific
