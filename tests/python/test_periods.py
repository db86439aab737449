"""Points that repeat: lattices have the diagrams that formulas say, and arguments that do not fit are refused."""
import math

import numpy as np
import pytest

import netmesh
from netmesh import errors

from conftest import uniform

HALF, ROOT2, ROOT3 = 0.5, math.sqrt(2) / 2, math.sqrt(3) / 2
POINTS = uniform(3, 40)


def essential(diagram, degree):
    bars = diagram.intervals(degree)
    return bars[np.isinf(bars[:, 1]), 0].tolist()


def same(one, other):
    return np.array_equal(one.pairs, other.pairs) and one.max_degree == other.max_degree


class Atoms:
    """As much of ASE's as is read."""

    def __init__(self, positions, cell, pbc):
        self.positions, self.cell, self.pbc = np.array(positions), np.array(cell, dtype=float), np.array(pbc)

    def get_positions(self):
        return self.positions.copy()


def test_square_lattice():
    diagram = netmesh.persist([[0.25, 0.75]], cell=[1, 1])
    assert diagram.filter == "alpha" and diagram.max_degree == 2
    assert [essential(diagram, degree) for degree in range(3)] == [[0], [HALF, HALF], [ROOT2]]
    assert len(diagram) == 4
    assert diagram.reference == "closed offsets of the points in R^2 modulo the lattice"


def test_cubic_lattice():
    diagram = netmesh.persist([[0.0, 0, 0]], cell=[1, 1, 1])
    due = [[0], [HALF] * 3, [ROOT2] * 3, [ROOT3]]
    assert [essential(diagram, degree) for degree in range(4)] == due
    given = diagram.report["input"]
    assert given["periods"] == 3 and given["copies"] > 0 and given["moved"] == 0 and given["points"] == 1


def test_cycles_say_which_copies():
    """Two atoms of a chain along x: one loop around, over both, which none of them closes alone."""
    diagram = netmesh.persist([[0.0, 0], [3.5, 0], [0, 40]], cell=[[1.0, 0], [0, 9]], pbc=[True, False],
                              representatives=True)
    bars = [i for i, bar in enumerate(diagram.pairs) if bar[0] == 1]
    assert len(bars) == 2 and len(diagram.representatives.translations) == len(diagram)
    edges, times = diagram.representatives[bars[0]], diagram.representatives.translations[bars[0]]
    assert edges.dtype == times.dtype == np.int32 and times.shape == edges.shape + (1,)
    points = np.array([[0.0, 0], [3.5, 0], [0, 40]])
    places = points[edges] + times * np.array([1.0, 0])
    assert np.all(np.linalg.norm(places[:, 1] - places[:, 0], axis=1) == 0.5)
    assert np.count_nonzero(times[:, 0]) == 0
    # Around once: the parts of the edges along x, from a point to the next copy, add up to a period.
    square = netmesh.persist([[0.25, 0.75]], cell=[1, 1], representatives=True)
    loops = [square.representatives.translations[i][0, 1].tolist() for i in np.nonzero(square.pairs[:, 0] == 1)[0]]
    assert sorted(np.abs(loops).tolist()) == [[0, 1], [1, 0]]
    assert netmesh.persist(POINTS[:4], "alpha", representatives=True).representatives.translations is None


def test_lattices_that_are_the_same():
    box = netmesh.persist(POINTS, cell=[1, 1, 2])
    for cell in (np.diag([1, 1, 2]), [[0, 0, 2], [1, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0], [-1, 0, 2]],
                 [1, 1, 2, 90, 90, 90], np.array([1, 1, 2], dtype=np.float32)):
        assert same(netmesh.persist(POINTS, cell=cell), box)
    assert same(netmesh.persist(POINTS, cell=[1, 1, 2], pbc=True), box)
    assert same(netmesh.persist(POINTS, cell=[1, 1, 2], pbc=[True] * 3), box)
    assert not same(netmesh.persist(POINTS, "alpha"), box)


def test_two_points_of_a_cubic_lattice_of_half_the_side():
    points = [[x, y, z] for x in (0, 0.5) for y in (0, 0.5) for z in (0, 0.5)]
    whole = netmesh.persist(points, cell=[1, 1, 1])
    assert [essential(whole, degree) for degree in range(4)] == [[0], [0.25] * 3, [ROOT2 / 2] * 3, [ROOT3 / 2]]


def test_angles():
    """Sides and angles of a hexagonal cell are those of its vectors."""
    hexagonal = netmesh.persist([[0.0, 0, 0]], cell=[1, 1, 3, 90, 90, 120])
    assert essential(hexagonal, 1) == pytest.approx([HALF, HALF, 1.5], rel=1e-12)  # sqrt(3) / 2 is moved
    assert 0 < hexagonal.report["input"]["moved"] < 1e-13


def test_some_directions():
    slab = netmesh.persist(POINTS, cell=[1, 1, 0], pbc=[True, True, False])
    assert slab.report["input"]["periods"] == 2
    assert [len(essential(slab, degree)) for degree in range(4)] == [1, 2, 1, 0]
    rows = netmesh.persist(POINTS, cell=np.diag([1, 1, 5]), pbc=[1, 1, 0])
    assert same(rows, slab)
    for without in (dict(cell=[1, 1, 1], pbc=False), dict(cell=[1, 1, 1], pbc=np.zeros(3, dtype=bool)),
                    dict(pbc=False)):
        assert same(netmesh.persist(POINTS, "alpha", **without), netmesh.persist(POINTS, "alpha"))


def test_which_copy_is_given_does_not_matter():
    moved = POINTS + np.random.default_rng(1).integers(-2, 3, size=POINTS.shape)
    base = np.round(POINTS * 2 ** 20) / 2 ** 20
    moved = base + np.round(moved - POINTS)
    assert same(netmesh.persist(base, cell=[1, 1, 1]), netmesh.persist(moved, cell=[1, 1, 1]))


def test_equal_copies_are_duplicates():
    diagram = netmesh.persist([[0.0, 0], [0.5, 0.5], [1, 1]], cell=[1, 1])
    assert diagram.report["input"]["duplicates"] == 1


def test_radii():
    radii = np.full(40, 0.125)
    plain = netmesh.persist(POINTS, cell=[1, 1, 1])
    for degree in range(4):
        moved = netmesh.persist(POINTS, cell=[1, 1, 1], radii=radii, squares=True).intervals(degree)
        np.testing.assert_allclose(moved, plain.intervals(degree) ** 2 - 0.125 ** 2, rtol=1e-9, atol=1e-12)
    given = netmesh.persist(POINTS, cell=[1, 1, 1], weights=np.linspace(0, 0.5, 40)).report["input"]
    assert given["periods"] == 3


def test_atoms():
    cell = np.diag([1.0, 1, 2])
    assert same(netmesh.persist(Atoms(POINTS, cell, [True] * 3)), netmesh.persist(POINTS, cell=cell))
    slab = netmesh.persist(POINTS, cell=cell, pbc=[True, True, False])
    assert same(netmesh.persist(Atoms(POINTS, cell, [True, True, False])), slab)
    assert same(netmesh.persist(Atoms(POINTS, cell, [True] * 3), pbc=[True, True, False]), slab)
    alone = netmesh.persist(POINTS, "alpha")
    assert same(netmesh.persist(Atoms(POINTS, np.zeros((3, 3)), [False] * 3), "alpha"), alone)
    assert same(netmesh.persist(Atoms(POINTS, cell, [True] * 3), "alpha", pbc=False), alone)
    assert same(netmesh.persist(Atoms(POINTS, cell, [False] * 3), cell=[1, 1, 2]), netmesh.persist(POINTS, cell=cell))
    both = netmesh.persist_all([Atoms(POINTS, cell, [True] * 3), POINTS])
    assert same(both[0], netmesh.persist(POINTS, cell=cell))


def test_numbers_that_are_moved():
    """Thirds have no copies that are doubles; what is moved is said, and next to nothing."""
    diagram = netmesh.persist([[1 / 3, 1 / 3], [0.1, 0.7]], cell=[1 / 3, 0.7])
    assert 0 < diagram.report["input"]["moved"] < 1e-12


@pytest.mark.parametrize("arguments, argument", [
    (dict(cell=[1, 1]), "cell"), (dict(cell=1), "cell"), (dict(cell=np.ones((2, 3))), "cell"),
    (dict(cell=[1, 1, 1, 90, 90]), "cell"), (dict(cell=["a", 1, 1]), "cell"), (dict(cell=[1, 0, 1]), "cell"),
    (dict(cell=[1, -1, 1]), "cell"), (dict(cell=[1, math.nan, 1]), "cell"),
    (dict(cell=[1, 1, 1, 30, 30, 90]), "cell"), (dict(cell=[1, 1, 0, 90, 90, 90]), "cell"),
    (dict(cell=[[1, 0, 0], [0, 1, 0], [1, 1, 0]]), "cell"), (dict(cell=np.full((3, 3), math.nan)), "cell"),
    (dict(pbc=True), "pbc"), (dict(cell=[1, 1, 1], pbc=[True, True]), "pbc"),
    (dict(cell=[1, 1, 1], pbc="TTF"), "pbc"), (dict(cell=[1, 1, 1], pbc=2), "pbc"),
    (dict(cell=[1, 1, 1], filter="rips"), "cell"), (dict(cell=[1, 1, 1], pieces=2), "cell"),
    (dict(cell=[1, 1, 1], filter="alpha", bounds=True), "bounds")])
def test_refusals(arguments, argument):
    with pytest.raises(errors.InvalidArgument) as raised:
        netmesh.persist(POINTS, **arguments)
    assert raised.value.argument == argument
    assert argument in str(raised.value)


def test_side_at_fault():
    with pytest.raises(errors.InvalidArgument, match="side 1 is 0.0") as raised:
        netmesh.persist(POINTS, cell=[1, 0, 1])
    assert raised.value.row == 1


def test_files_claim_nothing(tmp_path):
    """Lines of a head do not say the cell here, so there are none, and nothing is taken for a diagram without one."""
    diagram = netmesh.persist(POINTS, cell=[1, 1, 1])
    diagram.save(tmp_path / "d.pers")
    assert not (tmp_path / "d.pers").read_text().startswith("#")
    again = netmesh.load(tmp_path / "d.pers")
    assert np.array_equal(again.pairs, diagram.pairs)
    for result in (diagram, again):
        with pytest.raises(errors.InvalidArgument, match="result"):
            netmesh.check(result, POINTS)
    head = "# netmesh diagram 1: degree birth death\n# filter alpha\n# box 0:1,0:1,0:1\n"
    (tmp_path / "e.pers").write_text(head + "0 0 inf\n")
    with pytest.raises(errors.InvalidArgument, match="a cell are not made again"):
        netmesh.check(netmesh.load(tmp_path / "e.pers"), POINTS)
