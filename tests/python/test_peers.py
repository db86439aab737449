"""Diagrams and distances are those of GUDHI and scipy."""
import numpy as np
import pytest

import netmesh

from conftest import built_dimensions, circle, uniform

gudhi = pytest.importorskip("gudhi")


def sorted_rows(intervals):
    rows = np.asarray(intervals, dtype=float).reshape(-1, 2)
    return rows[np.lexsort((rows[:, 1], rows[:, 0]))]


def assert_same(ours, theirs, degree, convert):
    theirs = convert(np.asarray(theirs, dtype=float).reshape(-1, 2))
    theirs = sorted_rows(theirs[theirs[:, 1] - theirs[:, 0] > 1e-12])
    ours = sorted_rows(ours.intervals(degree))
    ours = ours[ours[:, 1] - ours[:, 0] > 1e-12]
    assert len(ours) == len(theirs) > 0
    np.testing.assert_allclose(ours, theirs, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("dim", [d for d in built_dimensions() if d < 5])
def test_alpha(dim):
    points = uniform(dim, {2: 400, 3: 200, 4: 60}[dim], seed=3)
    tree = gudhi.AlphaComplex(points=points, precision="exact").create_simplex_tree()
    tree.compute_persistence()
    ours = netmesh.persist(points, "alpha")
    for degree in range(dim):
        assert_same(ours, tree.persistence_intervals_in_dimension(degree), degree, np.sqrt)


@pytest.mark.parametrize("dim", [1, 2, 3, 10])
def test_rips(dim):
    points = np.random.default_rng(dim).random((40, dim))
    tree = gudhi.RipsComplex(points=points).create_simplex_tree(max_dimension=3 if dim > 1 else 2)
    tree.compute_persistence()
    ours = netmesh.rips(points, max_degree=2 if dim > 1 else 1)
    assert_same(ours, tree.persistence_intervals_in_dimension(0), 0, lambda x: x / 2)
    if dim > 1:
        assert_same(ours, tree.persistence_intervals_in_dimension(1), 1, lambda x: x / 2)


def test_rips_by_threshold():
    points = circle(60, 0.05)
    tree = gudhi.RipsComplex(points=points, max_edge_length=0.8).create_simplex_tree(max_dimension=2)
    tree.compute_persistence()
    for ours in (netmesh.rips(points, 0.4), netmesh.rips(points.astype(object), 0.4)):
        for degree in (0, 1):
            assert_same(ours, tree.persistence_intervals_in_dimension(degree), degree, lambda x: x / 2)


def test_rips_of_distances_with_rounding_noise():
    rng = np.random.default_rng(8)
    x = rng.normal(size=(12, 3))
    x /= np.linalg.norm(x, axis=1)[:, None]
    square = 1 - x @ x.T
    noisy = square + rng.normal(scale=1e-16, size=square.shape)
    with pytest.warns(UserWarning, match="took rounding noise off"):
        bars = netmesh.rips(distances=noisy, max_degree=1).intervals(0)
    even = (noisy + noisy.T) / 2
    np.fill_diagonal(even, 0)
    assert np.array_equal(bars, netmesh.rips(distances=np.maximum(even, 0), max_degree=1).intervals(0))
    noisy[3, 5] *= 1 + 1e-10
    with pytest.raises(netmesh.errors.InvalidArgument):
        netmesh.rips(distances=noisy)


def test_rips_of_distances():
    distance = pytest.importorskip("scipy.spatial.distance")
    sparse = pytest.importorskip("scipy.sparse")
    points = np.random.default_rng(4).random((50, 5))
    condensed = distance.pdist(points)
    square = distance.squareform(condensed)
    due = netmesh.rips(distances=square)
    assert netmesh.rips(distances=condensed) == due
    assert netmesh.rips(distances=square.astype(np.float64, order="F")) == due
    assert netmesh.rips(distances=sparse.csr_matrix(square)) == due
    tree = gudhi.RipsComplex(distance_matrix=square).create_simplex_tree(max_dimension=2)
    tree.compute_persistence()
    for degree in (0, 1):
        assert_same(due, tree.persistence_intervals_in_dimension(degree), degree, lambda x: x / 2)
    near = sparse.coo_matrix(np.where(square <= 0.8, square, 0))
    assert netmesh.rips(distances=near) == netmesh.rips(distances=square, threshold=0.4)


def test_to_gudhi():
    points = circle(40, 0.02)
    tree = gudhi.RipsComplex(points=points).create_simplex_tree(max_dimension=2)
    theirs = tree.persistence()
    ours = netmesh.rips(points).to_gudhi("diameter")
    key = lambda bar: (-bar[0], bar[1])
    for (degree, bar), (other, due) in zip(sorted(ours, key=key), sorted(theirs, key=key)):
        assert degree == other and bar == pytest.approx(due, rel=1e-9)
    assert len(ours) == len(theirs)
    assert [d for d, _ in ours] == sorted((d for d, _ in ours), reverse=True)
    squared = netmesh.persist(points).to_gudhi("squared")
    tree = gudhi.AlphaComplex(points=points).create_simplex_tree()
    longest = max(tree.persistence(), key=lambda bar: (bar[0], bar[1][1] - bar[1][0]))
    assert max(squared, key=lambda bar: (bar[0], bar[1][1] - bar[1][0]))[1] == pytest.approx(longest[1], rel=1e-9)


def test_bottleneck():
    a, b = (netmesh.persist(circle(60, 0.05, seed)) for seed in (1, 2))
    due = 0.0
    for degree in (0, 1):
        one = netmesh.bottleneck(a, b, degree)
        assert one == pytest.approx(gudhi.bottleneck_distance(a.intervals(degree), b.intervals(degree)), abs=1e-12)
        assert one == netmesh.bottleneck(a.intervals(degree), b.intervals(degree))
        due = max(due, one)
    assert netmesh.bottleneck(a, b) == due
    by_degree = [[d.intervals(k) for k in range(2)] for d in (a, b)]
    assert netmesh.bottleneck(*by_degree) == due == netmesh.bottleneck(a.pairs, b.pairs)
    assert netmesh.bottleneck(a, a) == 0 and netmesh.bottleneck(a, [[0, 1]]) == np.inf
    assert netmesh.bottleneck([[1, 8]], [[2, 8]], log=True) == pytest.approx(np.log(2))


def test_wasserstein():
    optimize = pytest.importorskip("scipy.optimize")
    rng = np.random.default_rng(5)
    a, b = (np.sort(rng.random((30, 2)), axis=1) for _ in range(2))
    for order in (1, 2):
        moves = np.abs(a[:, None] - b[None]).max(axis=2)
        costs = np.zeros((60, 60))
        costs[:30, :30] = moves
        costs[:30, 30:] = ((a[:, 1] - a[:, 0]) / 2)[:, None]
        costs[30:, :30] = ((b[:, 1] - b[:, 0]) / 2)[None]
        costs **= order
        rows, columns = optimize.linear_sum_assignment(costs)
        due = costs[rows, columns].sum() ** (1 / order)
        ours = netmesh.wasserstein(a, b, order, 0, error=1e-6)
        assert ours.lower <= due * (1 + 1e-12) and due <= ours * (1 + 1e-12) and ours <= 1.000001 * ours.lower
        mates = ours.mates
        reached = mates[mates >= 0]
        assert len(set(reached)) == len(reached) > 0
        stay = np.setdiff1d(np.arange(30), reached)
        cost = (moves[mates >= 0, reached] ** order).sum() + (((a[:, 1] - a[:, 0]) / 2)[mates < 0] ** order).sum()
        cost += (((b[:, 1] - b[:, 0]) / 2)[stay] ** order).sum()
        assert cost ** (1 / order) == pytest.approx(ours, rel=1e-12)


def test_delaunay():
    spatial = pytest.importorskip("scipy.spatial")
    points = np.random.default_rng(6).random((300, 3))
    ours = netmesh.delaunay(points)
    theirs = spatial.Delaunay(points)
    assert sorted(map(tuple, np.sort(ours.cells, axis=1))) == sorted(map(tuple, np.sort(theirs.simplices, axis=1)))
    cells, neighbours = ours.cells, ours.neighbours
    assert (ours.vertices == points).all() and ours.domain is None
    edges = points[cells[:, 1:]] - points[cells[:, :1]]
    assert (np.linalg.det(edges) > 0).all()
    for j in range(4):
        inside = np.flatnonzero(neighbours[:, j] >= 0)
        other = neighbours[inside, j]
        assert (neighbours[other] == inside[:, None]).any(axis=1).all()
        facets = np.delete(cells[inside], j, axis=1)
        assert all(set(facet) < set(cell) for facet, cell in zip(facets, cells[other]))
