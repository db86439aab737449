"""Arrays in: what is read where it lies, what is copied, what is refused."""
import numpy as np
import pytest

import netmesh
from netmesh import errors
from netmesh._arrays import points_of

from conftest import uniform

POINTS = uniform(3, 60)


def strided(dtype=np.float64, gap=2):
    wide = np.full((60, 3 + gap), 99, dtype=dtype)
    wide[:, 1:4] = POINTS
    return wide[:, 1:4]


@pytest.mark.parametrize("points", [
    POINTS, POINTS.astype(np.float32), strided(), strided(np.float32), np.repeat(POINTS, 2, axis=0)[::2]],
    ids=["packed", "float32", "gaps", "float32 with gaps", "every other row"])
def test_no_copy(points):
    array, count, dim, _, stride = points_of(points)
    assert array is points and (count, dim) == (60, 3) and stride == points.strides[0]
    same = np.array(points, dtype=np.float64)
    assert netmesh.persist(points).fingerprint == netmesh.persist(same).fingerprint
    assert netmesh.delaunay(points).fingerprint == netmesh.delaunay(same).fingerprint


@pytest.mark.parametrize("points", [
    np.asfortranarray(POINTS), POINTS[::-1], POINTS[:, ::-1], POINTS.astype(">f8"), POINTS.astype(np.longdouble),
    POINTS.tolist(), [tuple(row) for row in POINTS], POINTS.astype(object), np.broadcast_to(POINTS, (60, 3))],
    ids=["fortran", "backwards", "columns backwards", "big-endian", "long double", "lists", "tuples", "objects",
         "broadcast"])
def test_copied(points):
    same = np.array(points, dtype=np.float64)
    assert netmesh.persist(points).fingerprint == netmesh.persist(same).fingerprint


def test_small_types():
    whole = np.arange(60).reshape(20, 3) ** 2 % 17
    for dtype in (np.int8, np.uint16, np.int64, np.float16):
        assert netmesh.persist(whole.astype(dtype)) == netmesh.persist(whole.astype(float))
    assert netmesh.persist(whole % 2 == 1, "rips") == netmesh.persist(whole % 2, "rips")


def test_input_is_left_alone():
    points = POINTS.copy()
    points.flags.writeable = False
    netmesh.persist(points)
    assert (points == POINTS).all()


@pytest.mark.parametrize("points", [
    None, 3, "points", [1, 2, 3], [[1, 2], [3]], POINTS.astype(complex), np.zeros((2, 2, 2)), [["a", "b"]],
    np.array([[2 ** 60, 1], [3, 4]]), np.ma.masked_array(POINTS, POINTS > 0.5), np.empty((0, 2)), np.zeros((5, 1)),
    np.zeros((5, 7)), np.empty((0, 0))])
@pytest.mark.parametrize("call", [netmesh.persist, netmesh.delaunay, netmesh.mesh])
def test_refused(call, points):
    with pytest.raises(errors.InvalidArgument) as raised:
        call(points)
    assert raised.value.argument == "points" and str(raised.value).startswith("points")
    assert isinstance(raised.value, ValueError)


def test_results_own_their_memory():
    made = netmesh.mesh(POINTS)
    vertices, cells, neighbours = made.vertices, made.cells, made.neighbours
    assert made.vertices is vertices and made.cells is cells
    made.close()
    assert (vertices[:60] == POINTS).all() and vertices.dtype == np.float64
    assert cells.dtype == np.int32 and cells.shape[1] == 4 and cells.max() == len(vertices) - 1
    assert neighbours.min() == -1 and neighbours.shape == cells.shape
    with pytest.raises(errors.InvalidArgument):
        made.persist()


def test_flat_points_are_told_what_is_exact():
    flat = np.c_[np.random.default_rng(1).random((20, 2)), np.full(20, 5.0)]
    with pytest.warns(UserWarning, match=r"points\[:, \[0, 1\]\] have an exact diagram"):
        netmesh.persist(flat)
    assert netmesh.persist(flat[:, [0, 1]]).certified_ratio == 1
    with pytest.warns(UserWarning, match='filter="cech" is exact'):
        netmesh.persist(np.c_[flat[:, :2], flat[:, 0]][:6])
    with pytest.warns(UserWarning, match='filter="rips" is exact'):
        netmesh.persist([[0, 0], [1, 1], [3, 3]])


def test_matrices_that_are_no_distances_are_told_both_values():
    square = np.abs(np.subtract.outer(np.arange(4.0), np.arange(4.0)))
    square[0, 2] = 2.5
    with pytest.raises(errors.InvalidArgument, match=r"row 2: the distance to 0 is 2.0, and 2.5 the other way"):
        netmesh.rips(distances=square)
    with pytest.raises(errors.InvalidArgument, match="of similarities S give 1 - S"):
        netmesh.rips(distances=np.eye(3))
