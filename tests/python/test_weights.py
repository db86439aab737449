"""Points with radii or weights: diagrams are those of GUDHI, and arguments that do not fit are refused by name."""
import numpy as np
import pytest

import netmesh
from netmesh import errors

from conftest import uniform

POINTS = uniform(3, 60)
RADII = np.linspace(0, 0.3, 60)


def bars_of_gudhi(points, weights):
    gudhi = pytest.importorskip("gudhi")
    tree = gudhi.AlphaComplex(points=points, weights=list(weights), precision="exact").create_simplex_tree()
    tree.compute_persistence(homology_coeff_field=2)
    return [tree.persistence_intervals_in_dimension(degree) for degree in range(points.shape[1])]


@pytest.mark.parametrize("dim, count", [(2, 300), (3, 120)])
def test_weights_as_gudhi_has_them(dim, count):
    rng = np.random.default_rng(dim)
    points, weights = rng.random((count, dim)), rng.normal(scale=0.01, size=count)
    ours = netmesh.persist(points, "alpha", weights=weights, squares=True)
    for degree, theirs in enumerate(bars_of_gudhi(points, weights)):
        theirs = theirs[np.lexsort((theirs[:, 1], theirs[:, 0]))]
        theirs = theirs[theirs[:, 1] > theirs[:, 0] + 1e-14]  # theirs are rounded apart
        mine = ours.intervals(degree)
        mine = mine[mine[:, 1] > mine[:, 0] + 1e-14]
        assert mine.shape == theirs.shape
        np.testing.assert_allclose(mine[np.lexsort((mine[:, 1], mine[:, 0]))], theirs, rtol=1e-9, atol=1e-12)
    hidden = ours.report["input"]["hidden"]
    assert hidden > 0 and ours.reference == "unions of balls about the points in R^%d" % dim


def test_radii_are_roots_of_weights():
    radii = netmesh.persist(POINTS, radii=RADII)
    assert radii.filter == "alpha" and radii.intervals(0)[:, 0].min() == -RADII.max()
    squares = netmesh.persist(POINTS, radii=RADII, squares=True)
    for degree in range(3):
        expected = squares.intervals(degree)
        np.testing.assert_allclose(radii.intervals(degree), np.sign(expected) * np.sqrt(np.abs(expected)), rtol=1e-12)
    other = netmesh.persist(POINTS.astype(np.float32), radii=RADII)
    assert other != radii and netmesh.persist(POINTS.astype(np.float32).astype(float), radii=RADII) == other


def test_equal_radii_move_the_diagram():
    plain = netmesh.persist(POINTS, "alpha")
    assert netmesh.persist(POINTS, "alpha", weights=np.zeros(60)).fingerprint != ""
    for degree in range(3):
        assert np.array_equal(netmesh.persist(POINTS, radii=np.zeros(60)).intervals(degree), plain.intervals(degree))
        moved = netmesh.persist(POINTS, radii=np.full(60, 0.5), squares=True).intervals(degree)
        np.testing.assert_allclose(moved, plain.intervals(degree) ** 2 - 0.25, rtol=1e-9, atol=1e-12)


def test_regular_triangulation():
    with netmesh.delaunay(POINTS, weights=RADII) as mesh:
        report = mesh.report
    assert report["input"]["hidden"] > 0
    assert report["mesh"]["vertices"] == 60 - report["input"]["hidden"]


@pytest.mark.parametrize("arguments, argument", [
    (dict(radii=RADII, weights=RADII), "weights"), (dict(radii=RADII[1:]), "radii"),
    (dict(radii=np.full((60, 1), 1.0)), "radii"), (dict(weights=["a"] * 60), "weights"),
    (dict(radii=-RADII), "radii"), (dict(radii=RADII, filter="rips"), "radii"),
    (dict(radii=RADII, filter="alpha", bounds=True), "bounds"), (dict(squares=True), "squares"),
    (dict(weights=RADII, filter="alpha", representatives=True), "representatives"),
    (dict(radii=RADII, pieces=2), "radii")])
def test_refusals(arguments, argument):
    with pytest.raises(errors.InvalidArgument) as raised:
        netmesh.persist(POINTS, **arguments)
    assert raised.value.argument == argument
    assert argument in str(raised.value)


def test_numbers_that_are_none():
    weights = RADII.copy()
    weights[7] = np.nan
    with pytest.raises(errors.NotFinite) as raised:
        netmesh.persist(POINTS, weights=weights)
    assert raised.value.row == 7
    radii = RADII.copy()
    radii[9] = -1
    with pytest.raises(errors.InvalidArgument) as raised:
        netmesh.persist(POINTS, radii=radii)
    assert raised.value.row == 9 and "negative" in str(raised.value)
