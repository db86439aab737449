"""Arrays in: what is read where it lies, what is copied, what is refused."""
import warnings

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
    with pytest.warns(UserWarning, match=r"left out: the diagram is that of points\[:, \[0, 1\]\]"):
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


def test_matrices_that_are_no_distances_are_told_the_worst_fault_and_what_helps():
    clean = np.abs(np.subtract.outer(np.arange(6.0), np.arange(6.0)))
    noise = 1e-4 * np.random.default_rng(1).normal(size=(6, 6))

    def said(matrix, row):
        with pytest.raises(errors.InvalidArgument) as raised:
            netmesh.rips(distances=matrix)
        assert raised.value.argument == "distances" and raised.value.row == row
        return str(raised.value)
    assert said(clean + noise, 0) == ("distances, row 0: the distance to itself is %r, not 0; D = (D + D.T) / 2 and "
                                      "numpy.fill_diagonal(D, 0) take noise off" % float(noise[0, 0]))
    assert said(clean + 1e-4 * np.diag([0, 0, 1, 1, 0, 0]), 2).endswith(
        "to itself is 0.0001, not 0; numpy.fill_diagonal(D, 0) takes noise off")
    broken = clean + noise
    broken[3, 4] = np.nan
    assert said(broken, 3) == ("distances, row 3: the distance to 4 is nan, not a number; numpy.inf stands for pairs "
                               "that are never joined")
    broken = clean.copy()
    broken[1, 5] = broken[5, 1] = -2
    assert said(broken, 1).endswith("the distance to 5 is -2.0, and below 0")
    mended = (clean + noise + (clean + noise).T) / 2
    np.fill_diagonal(mended, 0)
    assert len(netmesh.rips(distances=mended).intervals(0)) == 6


def test_what_is_no_array_is_told_what_helps(tmp_path):
    def said(points):
        with pytest.raises(errors.InvalidArgument) as raised:
            netmesh.persist(points)
        return str(raised.value)
    (tmp_path / "p.csv").write_text("x,y\n1,2\n3,5\n4,4\n")
    assert said(netmesh.read_table(tmp_path / "p.csv")).endswith("a netmesh.Table; its numbers are .points")
    for path in ("p.csv", tmp_path / "p.csv"):
        assert "netmesh.read_table(path).points" in said(path) and "netmesh.load(path)" in said(path)
    assert said(np.array([[1, 2], ["a", 3]], dtype=object)).endswith("'a' in row 1")
    assert said([[1, 2], [3, "b"]]).endswith("'b' in row 1")
    assert said([[1, 2], [3]]).endswith("row 1 has 1, row 0 has 2")
    assert "for name in ['x', 'y']" in said(np.zeros(3, dtype=[("x", "f8"), ("y", "f8")]))
    assert "netmesh.delay(x, lag)" in said(POINTS[:, 0]) and "rips(x[:, None])" in said(POINTS[:, 0])


def test_bool_complex_and_sparse_are_told_what_they_are():
    def said(call, *arguments, argument="points", **options):
        with pytest.raises(errors.InvalidArgument) as raised:
            call(*arguments, **options)
        assert raised.value.argument == argument
        return str(raised.value)
    mask = POINTS > 0.5
    for given in (mask, mask.tolist()):
        for call in (netmesh.persist, netmesh.rips, netmesh.delaunay, netmesh.mesh):
            assert said(call, given).startswith("points: an array of bool; numpy.argwhere(mask)")
    assert "an array of bool" in said(netmesh.persist, POINTS, argument="radii", radii=mask[:, 0])
    assert "an array of bool" in said(netmesh.rips, argument="distances", distances=mask[:3])
    assert len(netmesh.persist(np.argwhere(mask)[::2])) > 1 and len(netmesh.persist(mask.astype(float), "rips")) > 1
    z = POINTS[:, 0] + 1j * POINTS[:, 1]
    for given in (z, z.tolist(), z[:, None]):
        assert said(netmesh.persist, given).startswith("points: complex numbers; numpy.column_stack((z.real, z.imag))")
    assert "a netmesh.Diagram" in said(netmesh.persist, netmesh.persist(POINTS))
    sparse = pytest.importorskip("scipy.sparse")
    for kind in (sparse.csr_matrix, sparse.coo_matrix):
        for call in (netmesh.persist, netmesh.rips):
            text = said(call, kind(POINTS))
            assert text.startswith("points: a sparse matrix of scipy; .toarray()") and "rips(distances=)" in text


class Frame:
    """As far as pandas's is looked at."""
    columns = ["name", "x", "y"]
    dtypes = [np.dtype(object), np.dtype(float), np.dtype(int)]

    def __array__(self, dtype=None):
        return np.array([["a", 1.5, 2], ["b", 3.5, 4]], dtype=object)


def test_frames_with_words_are_told_the_columns():
    with pytest.raises(errors.InvalidArgument, match=r"no numbers in column 'name'; df\[\['x', 'y'\]\] leaves such"):
        netmesh.persist(Frame())
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"name": list("abc"), "x": [1.0, 2, 5], "y": [1, 3, 1]})
    with pytest.raises(errors.InvalidArgument, match=r"df\[\['x', 'y'\]\]"):
        netmesh.persist(frame)
    assert len(netmesh.persist(frame[["x", "y"]]).intervals(0)) == 3


def test_delays():
    series = np.array([3, 1, 4, 1, 5, 9])
    assert netmesh.delay(series, 2).tolist() == [[3, 4], [1, 1], [4, 5], [1, 9]]
    assert netmesh.delay(series.tolist(), 1, 3).tolist() == [[3, 1, 4], [1, 4, 1], [4, 1, 5], [1, 5, 9]]
    assert netmesh.delay(series, 5).tolist() == [[3, 9]] and netmesh.delay(series, 1, 1).shape == (6, 1)
    sine = np.sin(2 * np.pi * np.arange(100) / 20)
    (birth, death), = netmesh.persist(netmesh.delay(sine, 5)).longest(1)  # a quarter of the period: a circle
    assert birth < 0.2 and death == pytest.approx(1, abs=0.02)
    for arguments, argument in (((series, 0), "lag"), ((series, 1.5), "lag"), ((series, 1, 0), "dimension"),
                                ((series, 6), "x"), ((POINTS, 1), "x"), (("abc", 1), "x")):
        with pytest.raises(errors.InvalidArgument) as raised:
            netmesh.delay(*arguments)
        assert raised.value.argument == argument
    with pytest.raises(errors.InvalidArgument, match="6 numbers; 3 coordinates with a lag of 3 take 7 at least"):
        netmesh.delay(series, 3, 3)


def test_constant_coordinates_are_left_out():
    square = np.array([[0.0, 0, 5], [1, 0, 5], [1, 1, 5], [0, 1, 5]])
    for filter in ("auto", "alpha"):
        with pytest.warns(UserWarning, match=r"coordinate 2 is the same in all.*points\[:, \[0, 1\]\]"):
            assert netmesh.persist(square, filter=filter).longest(1).tolist() == [[0.5, np.sqrt(0.5)]]
    with pytest.warns(UserWarning, match="coordinates 0, 2 are the same"):
        assert len(netmesh.persist(np.insert(square, 0, 7, axis=1)[:, [0, 1, 3, 2]]).intervals(1)) == 1
    with pytest.warns(UserWarning, match="lie in a hyperplane"):  # one coordinate would be left
        netmesh.persist([[0.0, 5, 5], [1, 5, 5], [2, 5, 5]])
    with pytest.warns(UserWarning, match="coordinate 2 is the same"):
        assert len(netmesh.persist(square, radii=[1, 1, 1, 1]).intervals(1)) == 1
    with pytest.raises(errors.Flat):
        netmesh.persist([[0.0, 0, 0], [1, 0, 1], [1, 1, 2], [0, 1, 1]], filter="alpha")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert netmesh.persist(square, filter="rips").intervals(1).shape == (1, 2)
