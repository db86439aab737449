"""Tables in text are read as the tool reads them: those of its own test, and random ones; and what only files have."""
import json
import os
import pathlib
import random
import re
import subprocess

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
    done = subprocess.run([TOOL, "delaunay", str(path), "-o", str(out), "-q"] + words, stderr=subprocess.PIPE)
    if done.returncode:
        return "flat" if done.returncode == 5 else None
    rows = [line.split() for line in out.read_text().splitlines() if not line.startswith("#")]
    count, dim = int(rows[0][0]), int(rows[0][1])
    return [[float(x) for x in row[1:1 + dim]] for row in rows[1:1 + count]]


def by_reader(content, options):
    try:
        points = parse_table(content, **options).points
    except errors.InvalidArgument as error:
        assert error.argument in ("path", "columns")
        return None
    return points.tolist() if 2 <= points.shape[1] <= 6 else None


def same(content, options, folder):
    due, found = by_tool(content, options, folder), by_reader(content, options)
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
    with pytest.raises(errors.InvalidArgument, match=r"columns=\[3, 4\]"):
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
