"""The library's table of options: every row goes into a request and comes back out of it."""
import ctypes

import numpy as np
import pytest

import netmesh
from netmesh import _declarations as c
from netmesh import errors
from netmesh._library import FILTERS, OPTIONS, lib
from netmesh._options import fill, request_of
from netmesh._session import Session

from conftest import circle, uniform

POINTS = uniform(2, 40)


@pytest.mark.parametrize("name", list(OPTIONS))
def test_a_row(name):
    row = OPTIONS[name]
    session = Session()
    request = request_of(session)
    assert row.get(request) == row.default
    of_words = bool(row.words)
    value = list(row.words)[-1] if of_words else 3
    fill(session, {name: value})
    assert row.get(request) == (row.words[value] if of_words else row.object or (
        1 if row.type == c.NETMESH_OPTION_FLAG else 3))
    other = request_of(Session())
    differing = [i for i in range(ctypes.sizeof(request)) if bytes(request)[i] != bytes(other)[i]]
    session.request.monitor = other.monitor
    assert differing and sum(r.get(request) != r.default for r in OPTIONS.values()) == 1


def test_the_table_names_what_there_is():
    words = OPTIONS["filter"].words
    assert set(words) - set(FILTERS) == {"auto", "simplices"}
    assert all(words[name] == row.filter for name, row in FILTERS.items())
    assert len(set(words.values())) == len(words) and len(OPTIONS["method"].words) == 6
    assert lib.netmesh_default_request().struct_bytes == ctypes.sizeof(c.netmesh_request)


@pytest.mark.parametrize("name", [name for name, row in OPTIONS.items() if not row.default and not row.words and
                                  row.type != c.NETMESH_OPTION_FLAG and not row.range.startswith("0")])
def test_nought_is_not_taken_for_an_open_option(name):
    session = Session()
    request_of(session)
    with pytest.raises(errors.InvalidArgument) as raised:
        fill(session, {name: 0})
    assert str(raised.value).endswith(OPTIONS[name].range)


def test_by_the_names_of_the_table():
    assert netmesh.persist(POINTS, "rips", threshold=0.1) == netmesh.rips(POINTS, 0.1)
    plain = netmesh.persist(POINTS, "complete", method="svr").report["mesh"]
    assert netmesh.persist(POINTS, "complete", method="svr", domain_factor=2).report["mesh"]["domain"][-1] == (
        pytest.approx(2 * plain["domain"][-1]))
    finer = netmesh.persist(POINTS, "complete", method="svr", size_eps=0.2)
    assert finer.report["mesh"]["vertices"] > plain["vertices"]
    assert netmesh.persist(POINTS, "complete", method="svr", audit=["quality"]).report["mesh"]["audit"]
    with pytest.raises(errors.InvalidArgument) as raised:
        netmesh.persist(POINTS, "complete", method="refine", net_spacing=9)
    assert raised.value.argument == "net_spacing"
    vines = netmesh.vineyard(POINTS, (1, 2), domain_factor=2)
    assert vines.report["mesh"]["domain"][-1] == pytest.approx(2 * plain["domain"][-1])
    for name in ("vines", "k_last", "focus_ratio", "cycles", "nothing"):
        with pytest.raises(TypeError):
            netmesh.persist(POINTS, **{name: 2})


def test_auto():
    """An argument that asks for a mesh takes complete."""
    assert netmesh.persist(POINTS).filter == "alpha"
    for options in (dict(ratio=2), dict(values="certified"), dict(tau=3), dict(method="svr"), dict(whole_cells=True)):
        assert netmesh.persist(POINTS, **options).filter == "complete"
    assert netmesh.persist(POINTS, bounds=True, representatives=True, seed=3, keep_zero_pairs=True).filter == "alpha"


def test_what_cannot_be_said_in_a_file(tmp_path):
    """Options without a line in it: the file has no head."""
    for options in (dict(filter="complete", method="svr", domain_factor=2),
                    dict(filter="basic", method="certificate", ratio=2)):
        diagram = netmesh.persist(POINTS, **options)
        with pytest.raises(errors.InvalidArgument):
            netmesh.check(diagram, POINTS)
    rips = netmesh.rips(POINTS, 0.1)
    netmesh.check(rips, POINTS)
    rips.save(tmp_path / "d.pers")
    assert "# threshold 0.1" in (tmp_path / "d.pers").read_text()


def test_a_mesh_keeps_its_sizes():
    made = netmesh.mesh(POINTS, size=lambda x: 0.1 + 0.1 * abs(x[0]))
    made.check()
    made.check("quality", progress=lambda *_: None)
    made = netmesh.mesh(circle(30), purpose="persist", ratio=1.9, focus=(1.5, 0.05, 0.5))
    made.check()
    assert made.persist(bounds=True).bounds is not None and made.persist(representatives=True).bounds is None


@pytest.mark.parametrize("method", ["svr", "netmesh", "thesis", "refine", "certificate", "delaunay"])
def test_methods(method):
    made = netmesh.mesh(POINTS[:12], method=method)
    assert made.report["mesh"].get("method", "delaunay") == method  # of a mesh
    made.check()
    assert (made.domain is None) == (method == "delaunay")
    if method == "thesis":
        assert netmesh.mesh(POINTS[:12], method="netmesh", cages="thesis").fingerprint == made.fingerprint
        with pytest.raises(errors.InvalidArgument) as raised:
            netmesh.mesh(POINTS[:12], cages="thesis")
        assert raised.value.argument == "cages"
    if method == "delaunay":
        due = np.sort(netmesh.delaunay(POINTS[:12]).cells)
        assert (np.sort(made.cells) == due).all()
