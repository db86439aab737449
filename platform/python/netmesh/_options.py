"""Python's arguments as a request, by the library's table of options."""
import ctypes
import inspect

from . import _declarations as c
from ._arrays import choice, number, put_points, whole
from ._hints import unknown_argument
from ._library import FILTER_NAMES, FILTERS, OPTIONS, lib, sized
from .errors import ARGUMENTS, InvalidArgument


# Those that go by the table's names, where a call does not list them itself.
OTHERS = set(OPTIONS) - set(ARGUMENTS) - {"vines", "weighting", "periods"}


def known(call, others, taken=OTHERS):
    """Other keyword arguments of a call, which all have to be options of the table."""
    for name in others:
        if name not in taken:
            named = {name for name, row in inspect.signature(call).parameters.items() if row.kind != row.VAR_KEYWORD}
            raise unknown_argument(call.__name__, name, named | taken)
    return others


def request_of(session, points=None):
    """The session's request, with defaults; of points as ``points_of`` gives them, which the caller keeps."""
    request = session.request = lib.netmesh_default_request()
    request.monitor = session.monitor
    if points is not None:
        put_points(request, points)
    return request


def put_weights(session, balls):
    """What ``weights_of`` gives, behind the points, which are float64."""
    if balls is None:
        return
    argument, numbers = balls
    request = session.request
    if len(numbers) != request.points.count:
        raise InvalidArgument("%s: %d numbers, where there are %d points" % (argument, len(numbers),
                                                                            request.points.count), argument)
    request.points.weights = numbers.ctypes.data or 8
    request.weighting = OPTIONS["weighting"].words[argument]
    session.kept.append(numbers)
    session.renamed.update(weights=argument, weighting=argument)


def put_lattice(session, vectors):
    """What ``lattice_of`` gives, behind the points."""
    if vectors is None:
        return
    request = session.request
    request.points.lattice = vectors.ctypes.data
    request.points.lattice_count = len(vectors)
    request.periods = OPTIONS["periods"].object
    session.kept.append(vectors)
    session.renamed.update(lattice="cell", lattice_count="cell", periods="cell")


def fill(session, given):
    """Puts options by their names in the table into the session's request; None and False: not given."""
    for name, value in given.items():
        if value is not None and value is not False:
            row = OPTIONS[name]
            row.put(session.request, _taken(row, session.renamed.get(name) or ARGUMENTS.get(name, name), value))


def _taken(row, argument, value):
    if row.type == c.NETMESH_OPTION_FLAG:
        return (row.object or 1) if value else 0
    if row.type == c.NETMESH_OPTION_NAME:
        return choice(value, argument, row.words)
    if row.type == c.NETMESH_OPTION_NAMES:
        return sum({choice(word, argument, row.words) for word in ([value] if isinstance(value, str) else value)})
    is_whole = row.type != c.NETMESH_OPTION_DOUBLE
    taken = whole(value, argument, 0, 2 ** row.bits - 1) if is_whole else number(value, argument)
    if taken == row.default == 0 and not row.range.startswith("0"):  # which would be the library's "not given"
        raise InvalidArgument("%s: must be %s" % (argument, row.range), argument)
    return taken


def put_function(session, dim, function=None, lipschitz=None, cut=None, distance_factor=None):
    """A caller's function of x[dim], where there is one."""
    numbers = {"lipschitz": lipschitz, "cut": cut, "distance_factor": distance_factor}
    made = sized(c.netmesh_function)
    if function is not None:
        made.evaluate = session.evaluation(function, dim, "function")
        session.request.function = ctypes.addressof(made)
        session.kept.append(made)
    for name, value in numbers.items():
        if value is not None and function is None:
            raise InvalidArgument("%s: goes with function" % name, name)
        if value is not None:
            setattr(made, name, number(value, name))
        elif function is not None and name != "distance_factor":
            raise InvalidArgument("%s: a function needs it" % name, name)


def focus_of(focus, fit=False):
    """``focus=`` by the names of its numbers; with a fit the ratio is what is found."""
    names = ("focus_ratio", "focus_from", "focus_to")[bool(fit):]
    try:
        numbers = [None if focus is None else float(x) for x in (names if focus is None else focus)]
    except (TypeError, ValueError):
        numbers = []
    if len(numbers) != len(names):
        raise InvalidArgument('focus: (ratio, from, to), with fit (from, to), or "auto" for a diagram', "focus")
    return dict(zip(names, numbers))


def settled(session, request):
    """The request with nothing left open."""
    result, detail = sized(c.netmesh_request), sized(c.netmesh_detail)
    status = lib.netmesh_settle(*map(ctypes.addressof, (request, result, detail)))
    if status != c.NETMESH_OK:
        session.fail(status, detail)
    return result


def as_asked(session, request, report):
    """A settled request after its job: what was left to that, as if it had been asked for."""
    if request.goal.longer_than:
        request.fit, request.mesh.method, request.mesh.tau = None, None, 0
        request.goal = report.mesh.goal
        if not request.goal.focus_ratio:
            request.goal.focus_from = request.goal.focus_to = 0
    elif request.filter != OPTIONS["filter"].words["auto"]:
        return request
    request.filter = FILTERS[FILTER_NAMES[report.diagram.filter]].filter
    return settled(session, request)
