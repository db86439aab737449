"""Files of diagrams are those of the tool, line by line, and each reads the other's."""
import subprocess

import numpy as np
import pytest

import netmesh
from netmesh import errors
from netmesh._files import number_text

from conftest import circle, uniform

CASES = [
    ("complete", {}, ""), ("complete", dict(ratio=1.8, bounds=True), "--ratio 1.8 --bounds"),
    ("complete", dict(method="svr", tau=3), "--method svr --tau 3"),
    ("complete", dict(method="netmesh", finish=True), "--method netmesh --finish"),
    ("complete", dict(values="thesis"), "--values thesis"),
    ("complete", dict(whole_cells=True, keep_zero_pairs=True), "--whole-cells --all"),
    ("complete", dict(focus=(1.5, 0.05, 0.2)), "--focus 1.5 --from 0.05 --to 0.2"),
    ("complete", dict(fit=True, memory="512K"), "--fit --memory 512K"),
    ("complete", dict(fit=True, memory="512K", focus=(0.05, 0.2)), "--fit --memory 512K --from 0.05 --to 0.2"),
    ("complete", dict(focus="auto", memory="1M"), "--focus auto --memory 1M"),
    ("basic", dict(seed=7), "--seed 7"), ("alpha", {}, ""), ("alpha", dict(max_degree=0), "--max-degree 0"),
    ("knn", dict(k=3, bounds=True), "--k 3 --bounds"),
    ("knn", dict(k=2, fit=True, memory="1M"), "--k 2 --fit --memory 1M"),
    ("kdistance", dict(k=3), "--k 3"), ("tight", dict(eps=0.4), "--eps 0.4"), ("tight", dict(ratio=1.9), "--ratio 1.9"),
    ("scales", {}, ""), ("scales", dict(ratio=2.5, theta=0.1), "--ratio 2.5 --theta 0.1"), ("rips", {}, ""),
    ("cech", dict(max_degree=0), "--max-degree 0"), ("barycentric-cech", dict(k=2), "--k 2"),
    ("barycentric-rips", dict(k=2, max_degree=0), "--k 2 --max-degree 0")]


@pytest.mark.parametrize("filter, arguments, options", CASES, ids=[" ".join((c[0], c[2])) for c in CASES])
def test_same_file(tool, tmp_path, filter, arguments, options):
    points = uniform(2, 12 if filter in ("tight", "barycentric-cech", "barycentric-rips") else 40)
    np.save(tmp_path / "p.npy", points)
    theirs, ours = tmp_path / "theirs.pers", tmp_path / "ours.pers"
    subprocess.run([tool, "persist", str(tmp_path / "p.npy"), "--filter", filter, *options.split(), "--quiet", "-o",
                    str(theirs)], check=True)
    diagram = netmesh.persist(points, filter, **arguments)
    diagram.save(ours)
    assert ours.read_text() == theirs.read_text()
    netmesh.check(diagram, points)
    loaded = netmesh.load(theirs)
    assert loaded == diagram and loaded.certified_ratio == diagram.certified_ratio
    netmesh.check(loaded, points)
    subprocess.run([tool, "check", str(ours), "--points", str(tmp_path / "p.npy"), "--quiet"], check=True)


def test_four_dimensions(tool, tmp_path):
    points = uniform(4, 8)
    np.save(tmp_path / "p.npy", points)
    for filter, options in (("complete", []), ("tight", ["--ratio", "2.4"]), ("scales", [])):
        try:
            diagram = netmesh.persist(points, filter, ratio=2.4 if options else None)
        except errors.NotBuilt:
            pytest.skip("built without four dimensions")
        diagram.save(tmp_path / "ours.pers")
        subprocess.run([tool, "persist", str(tmp_path / "p.npy"), "--filter", filter, *options, "--quiet", "-o",
                        str(tmp_path / "theirs.pers")], check=True)
        assert (tmp_path / "ours.pers").read_text() == (tmp_path / "theirs.pers").read_text()


def test_check_finds_a_changed_file(tmp_path):
    points = uniform(2, 40)
    netmesh.persist(points).save(tmp_path / "d.pers")
    text = (tmp_path / "d.pers").read_text()
    for old, new in (("# input ", "# input 0"), ("# duplicates 0", "# duplicates 1"), ("0 0 inf", "0 0 2")):
        assert old in text
        (tmp_path / "d.pers").write_text(text.replace(old, new))
        with pytest.raises(errors.CheckFailed):
            netmesh.check(netmesh.load(tmp_path / "d.pers"), points)


@pytest.mark.parametrize("name, content", [("d.pers", ""), ("d.pers", "\n# of today\n"), ("d.csv", ""), ("d", "")])
def test_empty_files_are_no_diagrams(tmp_path, name, content):
    (tmp_path / name).write_text(content)
    with pytest.raises(errors.InvalidArgument, match="no diagram|no rows") as raised:
        netmesh.load(tmp_path / name)
    assert raised.value.argument == "path"


@pytest.mark.parametrize("name, content", [
    ("d.pers", "# netmesh diagram 1: degree birth death\n"), ("d.pers", "# a choice of 0 bars of degree 1\n"),
    ("d.csv", "degree,birth,death\n"), ("d.json", '{"bars": []}')])
def test_files_that_say_that_they_have_no_bars(tmp_path, name, content):
    (tmp_path / name).write_text(content)
    assert len(netmesh.load(tmp_path / name)) == 0


def test_functions_have_no_head(tmp_path):
    diagram = netmesh.persist(circle(20), "function", function=lambda x: np.hypot(*x), lipschitz=1, cut=1)
    diagram.save(tmp_path / "d.pers")
    assert netmesh.load(tmp_path / "d.pers") == diagram
    with pytest.raises(errors.InvalidArgument) as raised:
        netmesh.check(diagram, circle(20))
    assert raised.value.argument == "result"


def test_other_formats(tmp_path):
    diagram = netmesh.persist(circle(30))
    diagram.save(str(tmp_path / "d.npy"))
    assert (np.load(tmp_path / "d.npy") == diagram.pairs).all()
    diagram.save(tmp_path / "d.csv")
    rows = (tmp_path / "d.csv").read_text().splitlines()
    assert rows[0] == "degree,birth,death" and len(rows) == len(diagram) + 1
    assert [tuple(map(float, row.split(","))) for row in rows[1:]] == list(diagram)
    with pytest.raises(errors.InvalidArgument) as raised:
        diagram.save(tmp_path / "d.png")
    assert raised.value.argument == "path" and "diagram.plot().figure.savefig(path)" in str(raised.value)


@pytest.mark.parametrize("line", ["0 1", "0 1 0.5", "x 0 1", "0 inf inf", "-1 0 1", "0 nan 1", "0 0 1 2"])
def test_load_refuses(tmp_path, line):
    (tmp_path / "d.pers").write_text("0 0 1\n" + line + "\n")
    with pytest.raises(errors.InvalidArgument) as raised:
        netmesh.load(tmp_path / "d.pers")
    assert raised.value.row == 1


@pytest.mark.parametrize("value, text", [
    (0.0, "0"), (-0.0, "0"), (1.0, "1"), (0.1, "0.1"), (100000.0, "1e+05"), (120000.0, "120000"), (1e22, "1e+22"),
    (1e-5, "1e-05"), (0.001, "0.001"), (0.0001, "1e-04"), (-2.5e-300, "-2.5e-300"), (float("inf"), "inf"),
    (123456789012345680000.0, "123456789012345683968"), (5e-324, "5e-324"),
    (0.07313247725035307, "0.07313247725035307")])
def test_numbers(value, text):
    assert number_text(value) == text


@pytest.mark.parametrize("ending", [".pers", ".csv", ".npy"])
def test_what_is_saved_is_loaded(tmp_path, ending):
    diagram = netmesh.persist(np.random.default_rng(1).random((40, 2)))
    path = tmp_path / ("d" + ending)
    diagram.save(path)
    assert netmesh.load(path) == diagram


def test_bars_of_the_tool_and_of_others_are_loaded(tmp_path):
    def loaded(name, content):
        (tmp_path / name).write_text(content)
        return [(k, b, d) for k, b, d in netmesh.load(tmp_path / name)]
    due = [(0, 0.0, 0.5), (0, 0.0, np.inf), (1, 0.75, 1.5)]
    assert loaded("a.json", '{"schema": 1, "bars": [[0, 0, 0.5], [0, 0, null], [1, 0.75, 1.5]]}') == due
    assert loaded("a.csv", "birth,death,degree\r\n0,0.5,0\r\n0,,0\r\n0.75,1.5,1\r\n") == due
    assert loaded("b.csv", "\ufeffdegree,birth,death\n1,0.75,1.5\n0,0,inf\n0,0,0.5\n") == due
    for name, content in (("c.csv", "a,b,c\n1,2,3\n"), ("d.csv", "degree,birth,death\n0,1,0.5\n"), ("e.json", "[]"),
                          ("f.json", '{"bars": [[0, 1]]}'), ("g.csv", "")):
        with pytest.raises(errors.InvalidArgument) as raised:
            loaded(name, content)
        assert raised.value.argument == "path"
