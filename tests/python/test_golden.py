"""The golden fingerprints of tests/golden, made from Python."""
import numpy as np
import pytest

import netmesh
from conftest import Random, built_dimensions, golden, grid, uniform

FLAT = 6
POINTS_MAX = 48
RANDOM_POINTS = {2: 30, 3: 14, 4: 9, 5: 8, 6: 9}


def rows(random, count, dim):
    return [[random.uniform() - 0.25 for _ in range(dim)] for _ in range(count)]


def lattice(dim, side, count, scale, jitter):
    random = Random(77)
    if side ** dim <= count:
        digits = [[i // side ** k % side for k in range(dim)] for i in range(side ** dim)]
        return [[(d + jitter * random.uniform()) * scale for d in digit] for digit in digits]
    made = []
    for i in range(count):
        digit = [float(k + 1 == i) if i <= dim else random.below(side) for k in range(dim)]
        made.append([(d + jitter * random.uniform()) * scale for d in digit])
    return made


def cross(dim, radius):
    return [[sign * radius if j == k else 0.0 for j in range(dim)] for k in range(dim) for sign in (-1, 1)]


def roots(dim, count):
    made = []
    for i in range(dim):
        for j in range(i + 1, dim):
            for s in range(4):
                p = [0.0] * dim
                p[i], p[j] = (1.0 if s & 1 else -1.0), (1.0 if s & 2 else -1.0)
                made.append(p)
    del made[POINTS_MAX:]
    random = Random(5)
    for i in range(len(made), 1, -1):
        j = random.below(i)
        made[i - 1], made[j] = made[j], made[i - 1]
    return made[:count]


def zoom(dim, count, step, seed):
    random = Random(seed)
    return [[(2 * random.uniform() - 1) * 0.5 ** (i * step) for _ in range(dim)] for i in range(count)]


def repeated(points, copies):
    n = len(points)
    return (points + [points[(i * 7 + c) % n] for c in range(1, copies) for i in range(n)])[:POINTS_MAX]


def slice_input(dim, which):
    """Points, and how many of them are meshed."""
    low, n, few = dim < 4, RANDOM_POINTS[dim], dim + 2
    all_meshed = POINTS_MAX if dim < 5 else 7 if dim < 6 else 6
    counts = [n, n, dim + 1, few, 1]
    if which < 5:
        return rows(Random(which + 1), counts[which], dim), all_meshed
    made = {
        5: lambda: lattice(dim, 3, 27 if low else n, 1, 0),
        6: lambda: lattice(dim, 2, 8 if low else n, 0.1, 0),
        7: lambda: lattice(dim, 2, 8, 1, 2.0 ** -44 if low else 2.0 ** -5),
        8: lambda: lattice(dim, 2, dim, 3, 0),
        9: lambda: cross(dim, 1),
        10: lambda: [[0.0] * dim] + cross(dim, 0.3),
        11: lambda: roots(dim, 12 if low else n),
        12: lambda: lattice(dim, 2, 8 if low else few + 1, 2.0 ** -30, 0),
        13: lambda: zoom(dim, few, {2: 8, 3: 2}.get(dim, 1), 6),
        14: lambda: zoom(dim, few, 24 if dim == 2 else 40, 7),
        15: lambda: zoom(dim, dim + 3, 200, 8),
        16: lambda: repeated(rows(Random(9), few, dim), 3),
        17: lambda: repeated(cross(dim, 1), 2),
        18: lambda: repeated(rows(Random(10), 1, dim), 4),
        19: lambda: [[i * i * 0.25 * (k + 1) for k in range(dim)] for i in range(few if low else 2)],
    }[which]()
    meshed = {7: 8 if low else 5, 13: few if low else 4, 14: few if dim == 2 else 2}.get(which, all_meshed)
    return made, meshed


def said(make):
    try:
        return make()
    except netmesh.errors.Flat:
        return "status 6"
    except netmesh.errors.TooClose:
        return "status 7"


@pytest.mark.parametrize("dim", built_dimensions())
@pytest.mark.parametrize("which", range(20))
def test_slice(dim, which):
    due = next(line for line in golden("slice.txt") if line.startswith("D%d %d " % (dim, which)))
    points, meshed = slice_input(dim, which)
    parts = {}

    def triangulated():
        with netmesh.delaunay(points) as made:
            parts["alpha"] = made.persist("alpha", keep_zero_pairs=True).fingerprint
            return parts["delaunay"]

    def delaunay():
        with netmesh.delaunay(points) as made:
            return made.fingerprint

    def meshing():
        with netmesh.mesh(points[:meshed], purpose="persist") as made:
            parts["persist"] = made.persist("complete", keep_zero_pairs=True).fingerprint
            return None

    def fresh_mesh():
        with netmesh.mesh(points[:meshed], purpose="persist") as made:
            return made.fingerprint

    parts["delaunay"] = said(delaunay)
    said(triangulated)
    parts["mesh"] = said(fresh_mesh)
    said(meshing)
    alpha = parts.get("alpha", parts["delaunay"])
    persist = parts.get("persist", parts["mesh"])
    name = due.split()[2]
    assert due == "D%d %d %s delaunay %s alpha %s mesh %s persist %s" % (
        dim, which, name, parts["delaunay"], alpha, parts["mesh"], persist)


@pytest.mark.parametrize("dim", built_dimensions())
def test_calls(dim):
    """The other calls on few points."""
    due = {}
    for line in golden("slice.txt"):
        if line.startswith("D%d calls " % dim):
            words = line.split()[2:]
            due.update(zip(words[::2], words[1::2]))
    points = rows(Random(11), dim + 2 if dim < 5 else 3, dim)
    with netmesh.mesh(points, purpose="persist") as made:
        assert made.persist("tight").fingerprint == due["tight"]
        assert made.persist("kdistance", k=2).fingerprint == due["kdistance"]
        assert made.persist("knn", k=2).fingerprint == due["knn"]
        slope = made.persist("function", function=lambda x: abs(x[0]) * 0.5 + abs(x[1]) * 0.25, lipschitz=0.75, cut=2)
        assert slope.fingerprint == due["function"]
        assert made.vineyard((1, 2)).fingerprint == due["vineyard"]
    few = zoom(dim, 5 if dim < 5 else 3, 6, 13)
    with netmesh.mesh(few, method="netmesh") as made:
        assert made.fingerprint == due["cages"]
    if dim < 4:
        with netmesh.mesh(few, method="netmesh", finish=True) as made:
            assert made.fingerprint == due["finished"]
    points = np.array(rows(Random(12), 8, dim))
    for name in ("rips", "cech"):
        assert netmesh.persist(points, name, max_degree=1, representatives=True).fingerprint == due[name]
    for name in ("barycentric-cech", "barycentric-rips"):
        assert netmesh.persist(points, name, k=2).fingerprint == due[name]
    for name in ("cech", "rips"):
        made = netmesh.vineyard(points[:6], (1, 3), "barycentric-" + name)
        assert made.fingerprint == due["nested-" + name]


def test_calls_without_points():
    due = next(line for line in golden("slice.txt") if line.startswith("D2 calls scales")).split()
    assert netmesh.persist(zoom(2, 2, 30, 14), "scales").fingerprint == due[3]
    simplices = [[0], [1], [2], [3], [0, 1], [1, 2], [2, 0], [3, 1], [2, 3], [0, 1, 2]]
    values = [0, 0.5, 0.25, 0, 1, 2, 1.5, 2, 3, 2.5]
    assert netmesh.homology(simplices, values, 2, representatives=True).fingerprint == due[5]


@pytest.mark.parametrize("dim", built_dimensions())
def test_fingerprints(dim):
    """Lines of the long file: a triangulation, a mesh, each kind of diagram."""
    due = {}
    for line in golden("fingerprints.txt"):
        words = line.split()
        if words[2] == "D%d" % dim and "result" in words:
            due.setdefault(tuple(words[:2]), words[words.index("result") + 1])
    points, meshed, complexed, side = {2: (2000, 400, 40, 20), 3: (1000, 150, 36, 6), 4: (300, 40, 32, 4),
                                       5: (120, 12, 24, 3), 6: (50, 6, 20, 2)}[dim]
    with netmesh.delaunay(uniform(dim, points)) as made:
        assert made.fingerprint == due["delaunay", "uniform"]
    with netmesh.delaunay(grid(dim, side)) as made:
        assert made.fingerprint == due["delaunay", "grid"]
    made = netmesh.persist(uniform(dim, points // 2), "alpha")
    assert made.fingerprint == due["alpha-of-points", "uniform"]
    made = netmesh.persist(uniform(dim, complexed), "rips", 2 if dim < 4 else 1)
    assert made.fingerprint == due["rips", "uniform"]
    if dim < 5:
        with netmesh.mesh(uniform(dim, meshed)) as made:
            assert made.fingerprint == due["mesh", "uniform"]
        made = netmesh.persist(uniform(dim, meshed), "complete", method="svr")
        assert made.fingerprint == due["persist", "uniform"]
        with netmesh.mesh(uniform(dim, meshed), ratio=2.25, purpose="persist") as made:
            assert made.persist().fingerprint == due["persist-ratio", "uniform"]


def test_distances():
    a = [[0, 0.25, 1], [0, 0.5, 2.25], [1, 0.125, 0.75]]
    b = [[0, 0.3, 1.1], [1, 0.1, 0.7], [1, 0.6, 0.65]]

    def mixed(*numbers):
        value = 1
        for number in numbers:
            value = ((value ^ int(np.float64(number).view(np.uint64))) * 0x100000001B3 + 1) % 2 ** 64
        return "%016x" % value

    due = next(line for line in golden("slice.txt") if line.startswith("D2 calls scales")).split()
    transport = netmesh.wasserstein(a, b, 2)
    assert mixed(transport.lower, float(transport)) == due[due.index("transport") + 1]
    log = netmesh.bottleneck(a, b, log=True)
    assert log == pytest.approx(np.log(2.25 / 1.1), rel=1e-15)  # of the long bars; the other one is ln 2 from nothing
