"""Diagrams, meshes, vineyards: what their attributes say."""
import doctest
import typing
import warnings
from xml.etree import ElementTree

import numpy as np
import pytest

import netmesh
from netmesh import errors

from conftest import circle, uniform


def test_a_circle():
    diagram = netmesh.persist(circle(60))
    assert diagram.intervals(0).shape == (60, 2) and diagram.intervals(1).shape == (1, 2)
    birth, death = diagram.intervals(1)[0]
    assert birth == pytest.approx(np.sin(np.pi / 60)) and death == pytest.approx(1)
    assert diagram.betti(0.5) == (1, 1) and diagram.betti(0.01) == (60, 0) and diagram.betti(2) == (1, 0)
    assert diagram.certified_ratio == 1 and diagram.filter == "alpha" and diagram.max_degree == 1
    assert len(diagram) == 61 and len(list(diagram)) == 61 and diagram.pairs.shape == (61, 3)
    assert diagram.bounds is None and diagram.representatives is None
    assert "61" not in repr(diagram) and "60 of degree 0" in repr(diagram)
    assert len(diagram.fingerprint) == 16 and diagram.report["fingerprint"] == diagram.fingerprint
    assert diagram.report["input"]["points"] == 60 and diagram.reference
    for degree in (-1, 2):
        with pytest.raises(errors.InvalidArgument):
            diagram.intervals(degree)
    with pytest.raises(errors.InvalidArgument):
        diagram.to_gudhi("feet")


def test_a_diagram_as_an_array(tmp_path):
    diagram = netmesh.persist(circle(20))
    diagram.save(tmp_path / "d.npy")
    for array in (np.array(diagram), np.asarray(diagram), np.load(tmp_path / "d.npy")):
        assert array.dtype == np.float64 and (array == diagram.pairs).all() and array.shape == (len(diagram), 3)
    assert np.array(diagram, dtype=np.float32).dtype == np.float32
    with pytest.raises(ValueError):
        diagram.__array__(copy=False)


def test_the_longest_bars():
    diagram = netmesh.persist(np.concatenate((circle(40), 3 + 0.5 * circle(30))))
    bars = diagram.intervals(1)
    lengths = bars[:, 1] - bars[:, 0]
    assert (diagram.longest() == bars[[np.argmax(lengths)]]).all() and diagram.longest(1).shape == (1, 2)
    two = diagram.longest(1, 2)
    assert two[0, 1] == pytest.approx(1) and two[1, 1] == pytest.approx(0.5)
    assert len(diagram.longest(1, 1000)) == len(bars) and len(netmesh.persist([[0, 0], [1, 1], [1, 0]]).longest(1)) < 2
    assert diagram.longest(0)[0, 1] == np.inf
    finite = diagram.longest(0, 1000)[1:]
    assert (np.diff(finite[:, 1] - finite[:, 0]) <= 0).all()
    for degree, count in ((2, 1), (1, 0), (1, 1.5)):
        with pytest.raises(errors.InvalidArgument):
            diagram.longest(degree, count)


def test_betti_numbers_at_many_radii():
    diagram = netmesh.persist(circle(60))
    radii = np.array([[0.01, 0.5], [2, 0]])
    counts = diagram.betti(radii)
    assert counts.shape == (2, 2, 2)
    for at in np.ndindex(2, 2):
        assert tuple(counts[at]) == diagram.betti(radii[at])
    assert diagram.betti([0.5, 0.9]).tolist() == [[1, 1], [1, 1]]


def test_pictures_without_another_package(tmp_path):
    diagram = netmesh.persist(np.concatenate((circle(40), 3 + 0.5 * circle(30))))
    picture = diagram._repr_svg_()
    assert ElementTree.fromstring(picture).tag.endswith("svg")
    assert "2 stand apart" in picture and "exact" in picture and "&#8734;" in picture
    diagram.save(tmp_path / "d.svg")
    assert (tmp_path / "d.svg").read_text() == picture
    for few in (netmesh.persist([[0, 0], [1, 1], [1, 0]]), netmesh.homology([[0]], [0.0]),
                netmesh.persist(circle(20), "complete", ratio=2)):
        ElementTree.fromstring(few._repr_svg_())


def test_intervals_are_not_copied():
    diagram = netmesh.persist(circle(60))
    assert np.shares_memory(diagram.intervals(0), diagram.intervals(0))


def test_max_degree_nought():
    assert netmesh.persist(circle(20), max_degree=0).max_degree == 0


def test_bounds():
    points = circle(30, 0.02)
    diagram = netmesh.persist(points, "complete", ratio=1.7, bounds=True)
    true = netmesh.persist(points, "alpha").intervals(1)
    longest = true[np.argmax(true[:, 1] - true[:, 0])]
    rows = diagram.rows(1)
    bounds = diagram.bounds
    certain = np.flatnonzero(bounds.certain[rows])
    assert len(certain) == 1
    at = rows.start + certain[0]
    assert bounds.birth[at, 0] <= longest[0] <= bounds.birth[at, 1]
    assert bounds.death[at, 0] <= longest[1] <= bounds.death[at, 1]
    assert bounds.birth.shape == (len(diagram), 2) and bounds.certain.dtype == bool and bounds.steps.shape[1] == 6
    assert (bounds.certain_after >= bounds.birth[:, 1]).all()
    assert repr(bounds) == "<netmesh.Bounds of %d bars, %d certified to exist>" % (len(diagram), bounds.certain.sum())
    assert 1 <= diagram.certified_ratio <= 1.7


@pytest.mark.parametrize("filter", ["alpha", "complete", "rips", "cech"])
def test_representatives(filter):
    diagram = netmesh.persist(circle(24, 0.01), filter, representatives=True)
    cycles = diagram.representatives
    assert len(cycles) == len(diagram) and len(list(cycles)) == len(diagram)
    for index in range(*diagram.rows(1).indices(len(diagram))):
        edges = cycles[index]
        assert edges.dtype == np.int32 and edges.shape[1] == 2 and len(edges) >= 3
        ends, counts = np.unique(edges, return_counts=True)
        assert (counts % 2 == 0).all()
    for index in range(*diagram.rows(0).indices(len(diagram))):
        assert cycles[index].shape == ((1 if np.isinf(list(diagram)[index][2]) else 2), 1)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_representatives_are_rows_of_the_points(dtype):
    """Also where rows are equal; of equal ones the first."""
    ring = circle(12)
    points = np.concatenate(([[5, 5], [5, 5], [0.0, 9], [-0.0, 9], [6, 7]], ring, ring[::-1])).astype(dtype)
    firsts = [0, 2, 4] + list(range(5, 17))
    for filter in ("alpha", "rips", "cech", "scales"):
        diagram = netmesh.persist(points, filter, representatives=True)
        bars, cycles = diagram.intervals(1), diagram.representatives
        edges = cycles[diagram.rows(1).start + int(np.argmax(bars[:, 1] - bars[:, 0]))]
        assert edges.dtype == np.int32 and (np.linalg.norm(points[edges], axis=2) < 1.01).all()
        assert set(np.concatenate([cycle.ravel() for cycle in cycles])) == set(firsts)
    line = netmesh.rips(np.array([[0], [0], [3]], dtype=dtype), representatives=True)
    assert [cycle.ravel().tolist() for cycle in line.representatives] == [[2, 0], [0]]

    def cycles_of(points, filter):
        return [cycle.tolist() for cycle in netmesh.persist(points, filter, representatives=True).representatives]
    assert cycles_of(points, "complete") == cycles_of(points[firsts], "complete")  # vertices of the mesh
    with pytest.warns(UserWarning, match="left out"):
        assert cycles_of(np.insert(points, 2, 3, axis=1), "alpha") == cycles_of(points, "alpha")


def test_mesh():
    points = uniform(2, 100)
    made = netmesh.mesh(points, 2.5)
    assert (made.vertices[:100] == points).all() and set(np.unique(made.markers)) >= {0, 1}
    assert made.aspect_ratio_max <= 2.5 and (made.markers[:100] == 0).all()
    centre, radius = made.domain
    assert (np.linalg.norm(points - centre, axis=1) <= radius * 1.001).all()
    made.check()
    assert "R^2" in repr(made) and made.report["mesh"]["tau"] == 2.5
    assert made.values is None and len(made.cages) == 0
    diagram = made.persist("knn", k=2)
    values = made.values
    assert values.shape == (len(made.vertices),) and (values > 0).all() and diagram.filter == "knn"
    assert (made.persist(), made.values is not values)[1]
    finer = netmesh.mesh(points, size=lambda x: 0.05 + 0.1 * abs(x[0]))
    assert len(finer.vertices) > len(made.vertices)
    assert len(netmesh.mesh(points, size_at_inputs=0.05).vertices) > len(made.vertices)
    assert netmesh.mesh(points, method="refine").aspect_ratio_max <= 2.5


def test_a_function():
    points = circle(30)

    def height(x):
        assert isinstance(x, np.ndarray) and x.shape == (2,)
        return float(np.hypot(x[0], x[1])) - 1

    diagram = netmesh.persist(points, "function", function=height, lipschitz=1, cut=0, error=0.1)
    assert 0 < diagram.certified_error <= 0.1
    assert diagram.intervals(0)[0, 0] == pytest.approx(-1, abs=0.1)
    bounded = netmesh.persist(points, "function", function=height, lipschitz=1, cut=0, error=0.1, bounds=True)
    assert (bounded.bounds.birth[:, 0] <= -1).any()
    fitted = netmesh.persist(points, "function", function=height, lipschitz=1, cut=0, fit=True, memory="1M")
    assert fitted.certified_error < 0.1


def test_a_function_that_contradicts_its_bounds():
    def first(x):
        return float(x[0])
    for options in (dict(lipschitz=0.1, cut=9), dict(lipschitz=1, cut=9, error=0.1)):
        with pytest.warns(UserWarning, match="contradicts lipschitz and cut.*take a lower cut") as warned:
            diagram = netmesh.persist(circle(30), "function", function=first, **options)
        assert diagram.certified_error == np.inf and warned[0].filename == __file__
    with netmesh.mesh(circle(30), purpose="persist") as made:
        with pytest.warns(UserWarning, match="contradicts") as warned:
            made.persist("function", function=first, lipschitz=1, cut=9)
        assert warned[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isfinite(netmesh.persist(circle(30), "function", function=first, lipschitz=1, cut=-9).certified_error)


def test_vineyard():
    points = uniform(2, 25)
    vines = netmesh.vineyard(points, (1, 4))
    for k in range(1, 5):
        due = netmesh.persist(points, "knn", k=k, method="svr")
        assert vines.diagram(k) == due
        assert vines.ratios[k - 1] == due.certified_ratio == vines.diagram(k).certified_ratio
    ks, path = vines.vine(0)
    assert len(ks) == len(path) and (np.diff(ks) > 0).all() and vines.count == vines.vines.max() + 1
    assert vines.degrees.max() == 1 and "vines" in repr(vines) and vines.report["vineyard"]["k_last"] == 4
    nested = netmesh.vineyard(points[:8], (1, 2), "barycentric-cech")
    assert nested.diagram(2) == netmesh.persist(points[:8], "barycentric-cech", k=2)
    with pytest.raises(errors.InvalidArgument):
        vines.diagram(5)


def test_a_vineyard_of_values():
    simplices = [[0], [1], [0, 1]]
    vines = netmesh.vineyard(simplices=simplices, steps=[[0, 1, 2], [1, 0, 3]])
    assert vines.diagram(1) == netmesh.homology(simplices, [0, 1, 2])
    assert vines.diagram(2) == netmesh.homology(simplices, [1, 0, 3])
    by_vertex = netmesh.vineyard(simplices=simplices, steps=[[0, 1], [1, 0]], by_vertex=True)
    assert by_vertex.diagram(1) == netmesh.homology(simplices, [0, 1, 1])


def test_homology():
    diagram = netmesh.homology([[0], [1], [2], [0, 1], [1, 2], [0, 2]], [0, 0, 0, 1, 2, 3], representatives=True)
    assert list(diagram) == [(0, 0, 1), (0, 0, 2), (0, 0, np.inf), (1, 3, np.inf)]
    assert sorted(map(tuple, diagram.representatives[3])) == [(0, 1), (0, 2), (1, 2)]


@pytest.mark.parametrize("kind", ["diagram", "barcode"])
def test_plot(kind, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots()
    diagram = netmesh.persist(circle(20, 0.05))
    assert diagram.plot(axes, kind) is axes
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["H0", "H1"]
    shown = sum(len(c.get_offsets() if kind == "diagram" else c.get_segments()) for c in axes.collections)
    assert shown == len(diagram)
    figure.savefig(tmp_path / "d.png")
    plt.close(figure)
    assert (tmp_path / "d.png").stat().st_size > 5000
    with pytest.raises(errors.InvalidArgument):
        diagram.plot(axes, "cake")
    plt.close("all")


def test_examples_in_docstrings():
    failed, tried = doctest.testmod(netmesh)
    assert tried > 3 and not failed


def test_the_rule_of_the_guide_for_bars_to_report():
    """Of clouds without a hole: what tools/docs/guide.md says of halves, and of subsamples of four fifths."""
    rng = np.random.default_rng(7)
    reported = {}
    for share in (0.5, 0.8):
        reported[share] = 0
        for seed in range(100):
            points = np.random.default_rng(seed).uniform(0, 10, size=(284, 2))
            diagram = netmesh.persist(points)
            parts = [points[rng.choice(284, int(284 * share), replace=False)] for _ in range(20)]
            apart = max(netmesh.bottleneck(diagram, netmesh.persist(part), degree=1) for part in parts)
            birth, death = diagram.longest(1)[0]
            reported[share] += death - birth > 2 * apart
    assert reported == {0.5: 1, 0.8: 55}


@pytest.mark.parametrize("name", netmesh.__all__)
def test_documented(name):
    """Everything public has a docstring, and every argument and result a type."""
    thing = getattr(netmesh, name)
    if name in ("errors", "__version__"):
        return
    assert thing.__doc__
    functions = [thing] if not isinstance(thing, type) else [
        f for n, f in vars(thing).items() if callable(f) and not n.startswith("_")]
    for function in functions:
        assert function.__doc__, function
        hints = typing.get_type_hints(function)
        names = function.__code__.co_varnames[:function.__code__.co_argcount + function.__code__.co_kwonlyargcount]
        untyped = set(names) - set(hints) - {"self", "points", "axes", "a", "b", "distances", "simplices", "values",
                                            "result", "steps"}
        assert not untyped, (function, untyped)


def test_to_gudhi_of_squares():
    points = np.random.default_rng(3).random((30, 2))
    radii = np.full(30, 0.05)
    plain, squares = (netmesh.persist(points, "alpha", radii=radii, squares=squares) for squares in (False, True))
    for units in ("radius", "diameter", "squared"):
        pairs = list(zip(plain.to_gudhi(units), squares.to_gudhi(units)))
        assert len(pairs) == len(plain) == len(squares)
        for (degree, bar), (other, same) in pairs:
            assert degree == other and np.allclose(bar, same, rtol=1e-12, atol=1e-15)
