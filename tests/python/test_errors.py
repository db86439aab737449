"""Every exception, with argument and row."""
import re
import subprocess
import warnings

import numpy as np
import pytest

import netmesh
from netmesh import _declarations as c
from netmesh import errors
from netmesh._library import sized
from netmesh.errors import error_of

from conftest import uniform

POINTS = uniform(2, 50)


def bad(value, row=17, points=POINTS):
    points = points.copy()
    points[row, 1] = value
    return points


def raised(kind, call, *arguments, **options):
    with pytest.raises(kind) as info:
        call(*arguments, **options)
    return info.value


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("filter", ["alpha", "complete", "rips", "cech", "scales", "tight"])
def test_not_finite(filter, value):
    error = raised(errors.NotFinite, netmesh.persist, bad(value), filter)
    assert (error.argument, error.row) == ("points", 17) and "points, row 17" in str(error)
    assert isinstance(error, ValueError)


def test_what_few_jobs_read():
    """Refused by the others, which say who reads it."""
    for filter in ("rips", "cech", "barycentric-cech", "barycentric-rips"):
        error = raised(errors.InvalidArgument, netmesh.persist, POINTS[:9], filter, seed=3)
        assert error.argument == "seed" and "triangulations and meshes" in str(error)
    for filter in ("alpha", "auto", "complete", "knn", "scales", "tight"):
        assert netmesh.persist(POINTS[:9], filter, seed=3).filter
    for filter in ("alpha", "complete", "cech"):
        error = raised(errors.InvalidArgument, netmesh.persist, POINTS, filter, threshold=0.5)
        assert error.argument == "threshold" and "rips alone" in str(error)
    error = raised(errors.InvalidArgument, netmesh.mesh, POINTS, eps=0)
    assert error.argument == "eps" and str(error).endswith("above 0")


def test_not_finite_elsewhere():
    assert raised(errors.NotFinite, netmesh.delaunay, bad(np.nan, 3)).row == 3
    assert raised(errors.NotFinite, netmesh.mesh, bad(np.nan, 0)).row == 0
    assert raised(errors.NotFinite, netmesh.rips, bad(np.inf, 5), 0.5).row == 5
    error = raised(errors.NotFinite, netmesh.homology, [[0], [1]], [0, np.nan])
    assert (error.argument, error.row) == ("simplices", 1)


def test_out_of_range():
    error = raised(errors.OutOfRange, netmesh.mesh, bad(1e200, 7))
    assert (error.argument, error.row) == ("points", 7)


def test_too_close():
    points = POINTS.copy()
    points[41] = points[12] + [0, 1e-16]
    error = raised(errors.TooClose, netmesh.mesh, points)
    assert (error.argument, error.row, error.other_row) == ("points", 12, 41) and "row 41" in str(error)


def test_flat():
    error = raised(errors.Flat, netmesh.delaunay, np.arange(10.0)[:, None] * [1, 2])
    assert error.argument == "points"
    raised(errors.Flat, netmesh.persist, [[0, 0], [1, 1]], "alpha")
    assert netmesh.persist([[0, 0], [1, 1]]).filter == "complete"  # what auto does instead


@pytest.mark.parametrize("options, argument", [
    (dict(filter="nothing"), "filter"), (dict(filter=3), "filter"), (dict(max_degree=-1), "max_degree"),
    (dict(max_degree=1.5), "max_degree"), (dict(max_degree="one"), "max_degree"), (dict(k=2), "k"),
    (dict(filter="knn", k=0), "k"), (dict(filter="knn", k=51), "k"), (dict(filter="knn", ratio=2), "ratio"),
    (dict(filter="complete", ratio=1.2), "ratio"), (dict(filter="complete", ratio="two"), "ratio"),
    (dict(filter="complete", tau=1.5), "tau"), (dict(filter="complete", method="none"), "method"),
    (dict(filter="complete", method="svr", ratio=2), "ratio"), (dict(filter="complete", focus=2), "focus"),
    (dict(filter="complete", focus=(1.5, 2, 1)), "focus"), (dict(filter="complete", focus="auto"), "focus"),
    (dict(filter="alpha", focus="auto", memory="1M"), "focus"), (dict(filter="alpha", lipschitz=1), "lipschitz"),
    (dict(filter="complete", ratio=2, tau=3), "tau"), (dict(filter="complete", finish=True), "finish"),
    (dict(filter="complete", method="netmesh"), "finish"), (dict(filter="complete", tau=0), "tau"),
    (dict(filter="complete", domain_factor=9, method="svr"), "domain_factor"), (dict(threshold=-1), "threshold"),
    (dict(filter="complete", longer_than=2), "longer_than"), (dict(filter="complete", fit=True), "fit"),
    (dict(filter="complete", values="best"), "values"), (dict(filter="complete", seed=-1), "seed"),
    (dict(filter="tight", eps=0.7), "eps"), (dict(filter="tight", eps=0.5, ratio=2), "eps"),
    (dict(filter="scales", theta=0.5), "theta"), (dict(filter="alpha", tau=3), "tau"),
    (dict(filter="function"), "function"), (dict(filter="function", function=len), "lipschitz"),
    (dict(filter="function", function=len, lipschitz=1), "cut"),
    (dict(filter="function", function=3, lipschitz=1, cut=1), "function"),
    (dict(filter="function", function=len, lipschitz=-1, cut=1), "lipschitz"),
    (dict(filter="function", function=len, lipschitz=1, cut=np.inf), "cut"),
    (dict(filter="rips", max_degree=31), "max_degree"), (dict(filter="alpha", whole_cells=True), "whole_cells"),
    (dict(memory="much"), "memory"), (dict(memory=0), "memory"), (dict(progress=3), "progress"),
    (dict(filter="barycentric-cech", k=51), "k"), (dict(filter="alpha", representatives=True, eps=0.1), "eps")])
def test_persist_refuses(options, argument):
    error = raised(errors.InvalidArgument, netmesh.persist, POINTS, **options)
    assert error.argument == argument and str(error).startswith(argument)


def test_distances_in_place_of_points():
    distances = np.abs(np.subtract.outer(np.arange(9.0), np.arange(9.0)))
    error = raised(errors.InvalidArgument, netmesh.rips, distances)
    assert error.argument == "points" and "rips(distances=...)" in str(error)
    for given in (distances, distances.tolist(), distances[:4, :4]):
        with pytest.warns(UserWarning, match=r"looks like distances.*rips\(distances=D\) takes"):
            assert len(netmesh.persist(given, "rips").intervals(0)) == len(given)
    with pytest.warns(UserWarning, match="looks like distances"), pytest.raises(errors.InvalidArgument):
        netmesh.persist(distances)
    distances[2, 1] += 1e-15
    raised(errors.InvalidArgument, netmesh.rips, distances)
    distances[2, 1] += 1e-9
    with pytest.warns(UserWarning, match="nearly equal halves looks like distances.*take the noise off"):
        assert len(netmesh.rips(distances).intervals(0)) == 9
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        distances[2, 1] += 1
        assert len(netmesh.rips(distances).intervals(0)) == 9  # nothing that is a matrix of distances
        assert len(netmesh.rips([[0, 1], [1, 0]]).intervals(0)) == 2
        netmesh.persist(-np.eye(3), "rips")


def test_names_that_are_nearly_right():
    def said(call, **options):
        return str(raised((TypeError, errors.InvalidArgument), call, POINTS, **options))
    for call in (netmesh.persist, netmesh.rips):
        assert said(call, maxdim=1).endswith("argument 'maxdim'; did you mean max_degree?")
        assert said(call, treshold=1).endswith("did you mean threshold?")
        assert said(call, thresh=1).endswith("did you mean threshold? It is a radius, half of what ripser takes")
        assert said(call, quux=1).endswith("argument 'quux'")
    assert said(netmesh.vineyard, domain_facter=1).endswith("did you mean domain_factor?")
    assert said(netmesh.persist, filter="rip").endswith("did you mean rips?")
    assert said(netmesh.persist, box=[1, 1]).endswith("did you mean cell?")
    assert said(netmesh.read_table, usecols=(0, 1)).endswith("did you mean columns?")
    assert said(netmesh.read_table, sep=";").endswith("read_table() got an unexpected keyword argument 'sep'; did you "
                                                      "mean delimiter?")
    for call in (netmesh.persist, netmesh.persist_all):
        assert said(call, delay=8).endswith("argument 'delay'; netmesh.delay(x, lag) makes points of a series x")
    text = str(raised(TypeError, netmesh.persist_all, iter([]), maxdim=1))  # before a cloud is read
    assert text == "persist_all() got an unexpected keyword argument 'maxdim'; did you mean max_degree?"
    bars = [[0, 1]]
    assert str(raised(TypeError, netmesh.wasserstein, bars, bars, p=2)).endswith("did you mean order?")
    assert str(raised(TypeError, netmesh.bottleneck, bars, bars, degre=0)).endswith("did you mean degree?")
    assert said(netmesh.persist, filter="complete", method="Refine").endswith("did you mean refine?")


def test_dimensions_that_are_not_there():
    wide = uniform(9, 20)
    for call in (netmesh.persist, netmesh.delaunay, netmesh.mesh, netmesh.vineyard):
        assert str(raised(errors.InvalidArgument, call, wide)) == (
            "points: the dimension is not 2..6, but 9; rips(points) takes any number of coordinates")
    assert str(raised(errors.InvalidArgument, netmesh.persist, POINTS.T)).endswith("is points.T meant?")
    assert "rips(points) takes numbers on a line" in str(raised(errors.InvalidArgument, netmesh.persist, POINTS[:, :1]))


def test_a_k_that_is_given_or_not():
    error = raised(errors.InvalidArgument, netmesh.persist, POINTS, k=3)
    assert error.argument == "k" and 'filter="knn"' in str(error)
    with pytest.warns(UserWarning, match="outliers"):
        netmesh.persist(POINTS, "knn")


@pytest.mark.parametrize("options, argument", [
    (dict(tau=2), "tau"), (dict(tau=0), "tau"), (dict(tau="x"), "tau"), (dict(method="x"), "method"),
    (dict(purpose="x"), "purpose"), (dict(domain_factor=9), "domain_factor"), (dict(cages="x"), "cages"),
    (dict(net_spacing=100, method="refine"), "net_spacing"), (dict(focus=(1, 2, 3)), "focus"),
    (dict(ratio=1.2, purpose="persist"), "ratio"), (dict(size=3), "size"), (dict(size=lambda x: -1.0), "size"),
    (dict(size=lambda x: 1e-300), "size"), (dict(eps=-1), "eps"), (dict(size_at_inputs=-1), "size_at_inputs")])
def test_mesh_refuses(options, argument):
    assert raised(errors.InvalidArgument, netmesh.mesh, POINTS, **options).argument == argument


@pytest.mark.parametrize("arguments, options, argument, row", [
    ((), {}, "points", None), ((POINTS,), dict(distances=[[0]]), "points", None),
    ((POINTS, "far"), {}, "threshold", None), ((POINTS, -1), {}, "threshold", None),
    ((), dict(distances=[[0, 1]]), "distances", None), ((), dict(distances=[1, 2]), "distances", None),
    ((), dict(distances=[[0, 1], [2, 0]]), "distances", 1), ((), dict(distances=[[0, -1], [-1, 0]]), "distances", 0),
    ((), dict(distances=[[0, np.nan], [np.nan, 0]]), "distances", 0),
    ((), dict(distances=[[0, 1], [1, 3]]), "distances", 1), ((POINTS,), dict(max_degree=31), "max_degree", None),
    ((), dict(distances=np.eye(3) * 0, max_degree=31), "max_degree", None)])
def test_rips_refuses(arguments, options, argument, row):
    error = raised(errors.InvalidArgument, netmesh.rips, *arguments, **options)
    assert (error.argument, error.row) == (argument, row)


def test_sparse_refuses():
    sparse = pytest.importorskip("scipy.sparse")
    error = raised(errors.InvalidArgument, netmesh.rips, distances=sparse.coo_matrix([[0, 1.0], [2.0, 0]]))
    assert error.argument == "distances" and error.row is not None
    assert raised(errors.InvalidArgument, netmesh.rips, distances=sparse.csr_matrix((2, 3))).argument == "distances"


@pytest.mark.parametrize("a, argument, row", [
    ("x", "a", None), ([[1, 2, 3, 4]], "a", None), ([[0, 1, 2], [0.5, 1, 2]], "a", 1), ([[0, 1], [3, 2]], "a", 1),
    ([[np.nan, 1]], "a", 0), ([[np.inf, np.inf]], "a", 0)])
def test_distances_refuse(a, argument, row):
    for call in (netmesh.bottleneck, netmesh.wasserstein):
        error = raised(errors.InvalidArgument, call, a, [[0, 1]])
        assert (error.argument, error.row) == (argument, row)
        error = raised(errors.InvalidArgument, call, [[0, 1]], a)
        assert (error.argument, error.row) == ("b", row)


def test_distances_refuse_options():
    bars = [[0.5, 1.0]]
    assert raised(errors.InvalidArgument, netmesh.wasserstein, bars, bars, 17).argument == "order"
    assert raised(errors.InvalidArgument, netmesh.wasserstein, bars, bars, error=0).argument == "error"
    assert raised(errors.InvalidArgument, netmesh.bottleneck, bars, bars, -1).argument == "degree"
    assert raised(errors.InvalidArgument, netmesh.bottleneck, [[-1.0, 1]], bars, log=True).argument == "a"


def test_distances_refuse_degrees_that_are_not_there():
    diagram = netmesh.persist(POINTS)
    by_degree = [diagram.intervals(0), diagram.intervals(1)]
    for call in (netmesh.bottleneck, netmesh.wasserstein):
        for other in (diagram, by_degree):
            for a, b in ((diagram, other), (other, diagram)):
                error = raised(errors.InvalidArgument, call, a, b, degree=2)
                assert error.argument == "degree" and "2 is not from 0 to 1" in str(error)
        assert "bars [m, 2] are of degree 0" in str(raised(errors.InvalidArgument, call, *by_degree, degree=1))
        assert call(diagram.pairs, diagram.pairs, degree=2) == 0  # of which nothing says what was computed
        assert call([], [], degree=1) == 0


def test_distances_of_squares_and_radii(tmp_path):
    radii = np.linspace(0, 0.1, len(POINTS))
    plain, squared = netmesh.persist(POINTS, radii=radii), netmesh.persist(POINTS, radii=radii, squares=True)
    (tmp_path / "d.pers").write_text("# netmesh diagram 1: degree birth death\n# filter alpha\n# radii r\n# squares\n"
                                     "# max-degree 1\n0 -1 inf\n")
    for call in (netmesh.bottleneck, netmesh.wasserstein):
        for a, b in ((plain, squared), (squared, netmesh.persist(POINTS)), (netmesh.load(tmp_path / "d.pers"), plain)):
            error = raised(errors.InvalidArgument, call, a, b)
            assert error.argument == "b" and "squares of radii" in str(error) and "squares=True" in str(error)
        assert call(squared, squared) == 0 and call(squared, plain.pairs) > 0


def test_distances_name_what_they_take():
    diagram = netmesh.persist(POINTS)
    text = str(raised(errors.InvalidArgument, netmesh.bottleneck, diagram, diagram.to_gudhi()))
    assert "list of arrays [m, 2] by degree" in text and "numpy.array([(k, *bar) for k, bar in b])" in text
    assert netmesh.bottleneck(diagram, np.array([(k, *bar) for k, bar in diagram.to_gudhi()])) == 0
    assert "GUDHI" not in str(raised(errors.InvalidArgument, netmesh.bottleneck, diagram, "d.pers"))


def test_vineyard_refuses():
    for options, argument in ((dict(k=3), "k"), (dict(k=(2, 1)), "k"), (dict(k=(1, 51)), "k"),
                              (dict(filter="alpha"), "k"), (dict(values="x"), "values")):
        assert raised(errors.InvalidArgument, netmesh.vineyard, POINTS, **options).argument == argument
    assert raised(errors.InvalidArgument, netmesh.vineyard).argument == "points"
    assert raised(errors.InvalidArgument, netmesh.vineyard, simplices=[[0]], steps=[[1, 2]]).argument == "steps"
    error = raised(errors.NotFinite, netmesh.vineyard, simplices=[[0], [1]], steps=[[1, np.nan]])
    assert (error.argument, error.row) == ("simplices", 1)


@pytest.mark.parametrize("simplices, values, row, word", [
    ([[0], [0]], [0, 0], 1, "once more"), ([[0], [0, 0]], [0, 0], 1, "twice"), ([[0, 1], [0]], [0, 0], 0, "lacks"),
    ([[0], [1], [0, 1]], [0, 2, 1], 2, "before its face 1"), ([[0], []], [0, 0], 1, "no vertices")])
def test_not_a_complex(simplices, values, row, word):
    error = raised(errors.NotAComplex, netmesh.homology, simplices, values)
    assert (error.argument, error.row) == ("simplices", row) and word in str(error)


def test_homology_refuses():
    assert raised(errors.InvalidArgument, netmesh.homology, [[0]], [1, 2]).argument == "values"
    assert raised(errors.InvalidArgument, netmesh.homology, 3, [1]).argument == "simplices"
    assert raised(errors.InvalidArgument, netmesh.homology, [[-1]], [1]).argument == "simplices"
    assert raised(errors.InvalidArgument, netmesh.homology, [], []).argument == "simplices"


def test_out_of_memory():
    points = uniform(3, 2000)
    error = raised(errors.OutOfMemory, netmesh.persist, points, memory="64K")
    assert error.argument == "memory" and error.bytes_wanted > 65536 and "65536" in str(error)
    assert isinstance(error, MemoryError)
    raised(errors.OutOfMemory, netmesh.persist, points, memory=100)
    raised(errors.OutOfMemory, netmesh.persist, points, memory=1 << 61)
    assert netmesh.persist(points, memory="64M") == netmesh.persist(points)


@pytest.mark.parametrize("call, options", [
    (netmesh.persist, dict(memory=5000)), (netmesh.persist, dict(filter="complete", memory="12K")),
    (netmesh.rips, dict(memory="5K")), (netmesh.mesh, dict(memory="5K")), (netmesh.delaunay, dict(memory="5K"))])
def test_memory_to_plan_for(call, options):
    error = raised(errors.OutOfMemory, call, POINTS, **options)
    planned = re.search(r'; plan for (\d+): memory="(\d+)K"\Z', str(error))
    assert planned and int(planned.group(1)) == error.bytes_planned <= 1024 * int(planned.group(2))
    call(POINTS, **dict(options, memory=planned.group(2) + "K"))


@pytest.mark.parametrize("call, options", [
    (netmesh.persist, dict(filter="alpha")), (netmesh.persist, dict(filter="alpha", representatives=True)),
    (netmesh.persist, dict(filter="complete")), (netmesh.rips, {}), (netmesh.mesh, {}),
    (netmesh.vineyard, dict(k=(1, 3)))])
def test_memory_by_trying_again(call, options):
    """Of points that take more than is planned, as an alpha diagram of a hexagonal lattice does."""
    points = np.array([(x + y % 2 / 2, y * 0.8660254) for x in range(20) for y in range(15)])
    memory, tries = 1, []
    while True:
        try:
            call(points, **options, memory=memory)
            break
        except errors.OutOfMemory as error:
            assert error.bytes_planned > memory and error.bytes_planned >= error.bytes_wanted
            assert re.search(r'memory="\d+[KM]"\Z', str(error))
            memory = error.bytes_planned
            tries.append(str(error))
    assert 0 < len(tries) < 12
    assert len(tries) > 1 or options != dict(filter="alpha")
    if len(tries) > 1:
        assert re.search("more than is planned for such a number of points: try %d, memory" % memory, tries[-1])


@pytest.mark.parametrize("memory", ["65536", "64K", "64k", "2M", "1G", "14.2M", "2MB", "2MiB", "2 M", "0K", "K", "-1M",
                                    "\u0663K"])
def test_memory_as_the_tool_takes_it(tool, memory, tmp_path):
    (tmp_path / "p.csv").write_text("0,0\n1,0\n0,2\n")
    done = subprocess.run([tool, "persist", str(tmp_path / "p.csv"), "--memory", memory, "-q"],
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    assert done.returncode in (0, 2)
    if done.returncode:
        assert raised(errors.InvalidArgument, netmesh.persist, POINTS[:3], memory=memory).argument == "memory"
    else:
        netmesh.persist(POINTS[:3], memory=memory)


def test_check_failed():
    diagram = netmesh.persist(POINTS, "complete")
    netmesh.check(diagram, POINTS)
    error = raised(errors.CheckFailed, netmesh.check, diagram, bad(0.5))
    assert error.argument == "result"
    diagram._intervals[3, 1] = np.nextafter(diagram._intervals[3, 1], 9)
    assert raised(errors.CheckFailed, netmesh.check, diagram, POINTS).row == 3
    assert raised(errors.InvalidArgument, netmesh.check, diagram).argument == "points"
    assert raised(errors.InvalidArgument, netmesh.check, 3).argument == "result"


def test_no_result():
    with netmesh.mesh(POINTS) as made:
        assert made.values is None
        raised(errors.NoResult, made.persist, "alpha")
        raised(errors.InvalidArgument, made.persist, "rips")
        raised(errors.InvalidArgument, made.check, "everything")
        raised(errors.NoResult, made.persist, progress=lambda *_: made.persist())
    with netmesh.mesh(np.concatenate((POINTS, POINTS * 1e-6)), method="netmesh") as caged:
        assert len(caged.cages) > 0 and caged.cages["radius"].min() > 0
        raised(errors.NoResult, caged.persist)


def test_functions_that_fail():
    def fails(x):
        raise KeyError("mine")

    for call in (lambda: netmesh.persist(POINTS, "function", function=fails, lipschitz=1, cut=1),
                 lambda: netmesh.mesh(POINTS, size=fails)):
        assert raised(KeyError, call).args == ("mine",)
    error = raised(errors.NotFinite, netmesh.persist, POINTS, "function", function=lambda x: np.nan, lipschitz=1, cut=1)
    assert error.argument == "function"
    raised(TypeError, netmesh.persist, POINTS, "function", function=lambda x: None, lipschitz=1, cut=1)
    raised(ZeroDivisionError, netmesh.persist, uniform(3, 3000), progress=lambda *_: 1 / 0)


def test_cancelled():
    raised(errors.Cancelled, netmesh.persist, uniform(3, 3000), progress=lambda *_: True)


def test_every_status_has_a_class():
    """Those that Python cannot bring about, too."""
    detail = sized(c.netmesh_detail)
    for name in ("NOT_BUILT", "FLOATING_POINT", "INTERNAL", "CHECK_FAILED", "NO_RESULT", "OUT_OF_RANGE"):
        status = detail.status = getattr(c, "NETMESH_" + name)
        detail.message = b"what was said"
        error = error_of(status, detail)
        assert isinstance(error, errors.Error) and type(error) is not errors.Error
    names = ("INVALID_ARGUMENT", "OUT_OF_MEMORY", "CANCELLED", "NOT_FINITE", "FLAT", "TOO_CLOSE", "NOT_A_COMPLEX")
    statuses = [getattr(c, "NETMESH_" + name) for name in names]
    for status in statuses:
        assert type(error_of(status, sized(c.netmesh_detail))) is not errors.Error
