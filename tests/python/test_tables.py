"""Tables in text are read as the tool reads them: those of its own test, and random ones; and what only files have."""
import gzip
import json
import os
import pathlib
import random
import re
import subprocess
import warnings

import numpy as np
import pytest

import netmesh
from netmesh import errors
from netmesh._table import parse_table

TOOL = os.environ.get("NETMESH_TOOL")
needs_tool = pytest.mark.skipif(not TOOL, reason="NETMESH_TOOL, the program, is not given")
SOURCE = pathlib.Path(__file__).parent.parent / "tools/parts/odd_files.cpp"
LITERAL = r'"((?:[^"\\]|\\[nrt"\\])*)"'
CASES = re.compile(r'(with\()?(?:good|bad)\("([^"]+)",\s*%s(?=[,)])[^\n]*?(?:\), %s(?:, %s)?(?:, (\d+))?\))?,\n'
                   % (LITERAL, LITERAL, LITERAL))
# Of notes about columns that may be no coordinates, what all readers say in the same words.
SLIPS = re.compile(r'took [^;\n]*, too|took [^;\n]*looks like[^;\n]*, for|[^;:\n]* look like degrees'
                   r'|[^;:\n]*, far from its|what stands behind # in every row|took [^;\n]*counts rows')


def by_tool(content, options, folder):
    """The points, None where it refuses, "flat" where it only says that it has read them."""
    path, out = folder / "p.txt", folder / "p.node"
    path.write_bytes(content.encode())
    words = []
    if "columns" in options:
        words += ["--columns", ",".join(options["columns"])]
    if "delimiter" in options:
        words += ["--delimiter", {" ": "blank", "\t": "tab"}.get(options["delimiter"], options["delimiter"])]
    if options.get("skip"):
        words += ["--skip", str(options["skip"])]
    words += ["--drop-missing"] * options.get("drop_missing", False)
    done = subprocess.run([TOOL, "delaunay", str(path), "-o", str(out)] + words, stderr=subprocess.PIPE)
    if done.returncode:
        return "flat" if done.returncode == 5 else None, set()
    rows = [line.split() for line in out.read_text().splitlines() if not line.startswith("#")]
    count, dim = int(rows[0][0]), int(rows[0][1])
    points = [[float(x) for x in row[1:1 + dim]] for row in rows[1:1 + count]]
    return points, {slip.strip() for slip in SLIPS.findall(done.stderr.decode(errors="replace"))}


def by_reader(content, options):
    try:
        table = parse_table(content, **options)
    except errors.InvalidArgument as error:
        assert error.argument in ("path", "columns")
        return None, set()
    slips = {slip.strip() for slip in SLIPS.findall("; ".join(table.notes))}
    return (table.points.tolist(), slips) if 2 <= table.points.shape[1] <= 6 else (None, set())


def same(content, options, folder):
    (due, said), (found, noted) = by_tool(content, options, folder), by_reader(content, options)
    assert noted == said or due in (None, "flat"), (content, options, said, noted)
    assert (found is None) == (due is None), (content, options, due, found)
    assert due in (None, "flat") or found == due, (content, options)
    return due is not None


@needs_tool
def test_the_tables_of_the_tool(tmp_path):
    text = SOURCE.read_text(encoding="utf-8")
    text = text[text.index("std::vector<OddFile> tables()"):text.index("std::vector<OddFile> formats()")]
    good = bad = 0
    for is_with, name, content, columns, delimiter, skip in CASES.findall(text):
        if name.endswith((".xyz", ".off", ".ply", ".pdb")) or (is_with and not columns + delimiter + skip):
            continue
        if '\\"' in columns:  # quotes of the command line
            continue
        options = {}
        if columns:
            options["columns"] = columns.split(",")
        if delimiter:
            options["delimiter"] = " " if delimiter == "blank" else json.loads('"%s"' % delimiter)
        if skip:
            options["skip"] = int(skip)
        if same(json.loads('"%s"' % content), options, tmp_path):
            good += 1
        else:
            bad += 1
    assert good > 40 and bad > 40


@needs_tool
def test_random_tables(tmp_path):
    rng = random.Random(3)
    taken = 0
    for _ in range(80):
        decimal, dim, count = rng.random() < 0.3, rng.randint(2, 4), rng.randint(5, 10)
        delimiter = rng.choice([";", "\t", "|", "; "] if decimal else [",", ";", "\t", " ", "|", ", ", " ; ", "   "])
        word = rng.random() < 0.3 and delimiter.strip() != ""

        def written(x):
            return repr(x).replace(".", ",") if decimal else repr(x)
        rows = [([rng.choice(["a", "Lab A", '"b"', ""])] if word else []) +
                [written(rng.randint(-10 ** 6, 10 ** 6) / 10 ** rng.choice((1, 4))) for _ in range(dim)]
                for _ in range(count)]
        if rng.random() < 0.4:
            rows[rng.randrange(1, count)][-1 - rng.randrange(dim)] = rng.choice(["NA", "", "-", "x", "1.2.3", "nan"])
        names = (["name"] if word else []) + ["x%d" % k for k in range(dim)]
        options = {"columns": names[1:]} if word else {}
        if rng.random() < 0.5:
            options["drop_missing"] = True
        end = rng.choice(("\n", "\r\n"))
        header = [names] if word or rng.random() < 0.5 else []
        taken += same(end.join(delimiter.join(row) for row in header + rows) + end, options, tmp_path)
    assert taken > 30


def test_a_file(tmp_path):
    path = tmp_path / "lab.csv"
    path.write_text('time,site,x [mm],y\n2024-03-01 10:00:00,"Lab A, bench",0,0\n2024-03-01 10:01:00,"Lab\nB",1,\n'
                    "2024-03-01 10:02:00,C,1,2\n")
    with pytest.raises(errors.InvalidArgument, match="drop_missing=True leaves such rows out, 1 of 3") as raised:
        netmesh.read_table(path, ["x [mm]", "y"])
    assert raised.value.row == 2
    with pytest.raises(errors.InvalidArgument, match=r"columns=\['x \[mm\]', 'y'\]"):
        netmesh.read_table(path)
    table = netmesh.read_table(path, ["x [mm]", 4], drop_missing=True)
    assert table.points.tolist() == [[0, 0], [1, 2]] and table.lines == [2, 5]
    assert table.names == ["time", "site", "x [mm]", "y"] and "left out 1 of 3 rows" in table.notes[-1]
    path.write_bytes("x;y\r\n0,5;1\r\n2;3,5\r\n".encode("utf-16"))
    assert netmesh.read_table(path).points.tolist() == [[0.5, 1], [2, 3.5]]
    path.write_bytes(b"Stra\xdfe,y\n1,2\n")
    assert netmesh.read_table(path).points.tolist() == [[1, 2]]
    path.write_text("x,y\n1.5,-0.0\n2.5,1e-400\n")
    assert not np.signbit(netmesh.read_table(path).points).any()


def test_what_helps_is_said_with_the_place_in_the_file(tmp_path):
    path = tmp_path / "messy.csv"

    def said(content, *arguments, **options):
        path.write_text(content)
        with pytest.raises(errors.InvalidArgument) as raised:
            netmesh.read_table(path, *arguments, **options)
        assert str(raised.value).startswith(str(path) + ":")
        return str(raised.value)[len(str(path)):]
    text = "id,city,x,y,note\n1,NA,1.5,2,ok\n2,Bonn,3,na,\n3,,4,7,bad\n"
    assert said(text) == (":2: \"NA\" is not a number; columns=['x', 'y'] leaves columns of words out, and "
                          "drop_missing=True rows that lack a value, 1 of 3")
    assert said(text.replace("na", "5")).endswith("; columns=['x', 'y'] leaves columns of words out")
    assert said("a,1,2\nb,3,4\n") == ':1: "a" is not a number; columns=[2, 3] leaves columns of words out'
    assert said("a,1\nb,3\n") == ':1: "a" is not a number'  # no columns that leave a single one
    assert said("x,y\n1,2\n3,z\n4,5\n") == ':3: "z" is not a number'
    assert said(text, "x,y") == (':3: "na" is not a number; a row with a missing value has to be left out or filled '
                                 "in: drop_missing=True leaves such rows out, 1 of 3")
    header = 'the header names "id", "city", "x", "y", "note"'
    assert said(text, ["x", "z"]) == ': columns: there is no column "z"; ' + header
    assert said(text, ["x", "notes"]) == ': columns: there is no column "notes"; %s; did you mean note?' % header
    assert said("1,2\n3,4\n", ["x"]) == ': columns: there is no column "x"; there is no header'
    assert said(text, [0, 1]) == ": columns: 0, where there are columns 1 to 5"
    assert said("", "x") == ": the table ends without a row"
    assert said(text, "") == said(text, []) == ": columns: none is named"
    path.write_text(text)
    for columns in ("x,y", "x, y", '"x",y', "3-4", ["x", 4], "3,y"):
        assert netmesh.read_table(path, columns, drop_missing=True).points.tolist() == [[1.5, 2], [4, 7]]
    path.write_text('"x,y",z\n1,2\n3,4\n')
    assert netmesh.read_table(path, "x,y").points.tolist() == [[1], [3]]
    assert netmesh.read_table(path, '"x,y",z').points.tolist() == [[1, 2], [3, 4]]
    assert repr(netmesh.read_table(path)) == "<netmesh.Table: 2 points in R^2; notes: 1>"


def test_what_may_be_no_coordinate_is_warned_of(tmp_path):
    path = tmp_path / "p.csv"
    for content, words in (("lat,lon\n48.1,11.5\n48.2,11.6\n48.15,11.4\n", "look like degrees"),
                           ("x,y\n1,2\n3,5\n-999,4\n", '"x" holds -999, far'),
                           ("x,y,label\n1,2,0\n3,5,1\n", "'x', 'y'"),
                           ("1 2 #7\n3 5 #8\n", "behind # in every row"),
                           ("1700000000,1,2\n1700000060,3,4\n", "[2, 3]")):
        path.write_text(content)
        with pytest.warns(UserWarning, match=re.escape(words)) as caught:
            netmesh.read_table(path)
        assert caught[0].filename == __file__
    path.write_text("x,y,label\n1,2,0\n3,5,1\n")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        netmesh.read_table(path, ["x", "y"])


def test_files_that_are_no_tables_are_named(tmp_path):
    def fault(content, skip=0):
        path = tmp_path / "p.csv"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        with pytest.raises(errors.InvalidArgument) as raised:
            netmesh.read_table(path, skip=skip)
        assert raised.value.argument == "path"
        return str(raised.value)
    packed = gzip.compress(b"x,y\n0,0\n1,2.5\n")
    (tmp_path / "p.csv.gz").write_bytes(packed)
    assert netmesh.read_table(tmp_path / "p.csv.gz").points.tolist() == [[0, 0], [1, 2.5]]
    assert "cut off or damaged" in fault(packed[:-6])
    np.save(tmp_path / "p.npy", np.zeros((3, 2)))
    assert "numpy.load reads it" in fault((tmp_path / "p.npy").read_bytes())
    read = "give the file to the program netmesh"
    for content, what in (("OFF\n3 0 0\n1 2 3\n4 5 6\n7 8 8\n", "an OFF file"),
                          ("ply\nformat ascii 1.0\n", "a PLY file"), ("solid a\nfacet normal 0 0 1\n", "an STL file"),
                          ("v 1 2 3\nv 1 2 4\n", "an OBJ file"), ("# Blender\no a\nv 1 2 3\n", "an OBJ file"),
                          ("ATOM      1  N   ALA A   1       1.500  -2.250   7.000\n", "a PDB file"),
                          ("3\nwater\nO 0 0 1\nH 0 1 0\nH 1 0 0\n", "atoms in .xyz")):
        assert what in fault(content) and read in fault(content)
    assert "JSON" in fault('{"points": []}') and "without brackets" in fault("[[1, 2], [3, 4]]")
    assert "HTML" in fault("<!DOCTYPE html>\n<html>\n") and "LAMMPS" in fault("ITEM: TIMESTEP\n0\n")
    assert "save the table as CSV" in fault(b"PAR1\x15\x04") and "byte 1 is 0" in fault("1\t2\n".encode("utf-16-le"))
    assert "a VTK or XML file" not in fault("# vtk DataFile\n1,a\n2,b\n", skip=1)
