"""Runs platform/python/examples/gallery.py: its diagrams are those of the tool, its pictures are pictures."""
import importlib.util
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
missing = [name for name in ("numpy", "matplotlib") if not importlib.util.find_spec(name)]
if missing:
    print("SKIPPED: no " + ", ".join("python3-" + name for name in missing))
    sys.exit(0)


def shown(name):
    """The bars of the gallery's own file."""
    lines = (ROOT / "tools/docs/gallery" / (name + ".pers")).read_text().splitlines()
    return [tuple(map(float, line.split())) for line in lines if line and not line.startswith("#")]


with tempfile.TemporaryDirectory() as folder:
    script = ROOT / "platform/python/examples/gallery.py"
    ran = subprocess.run([sys.executable, str(script), str(ROOT / "tests/data"), folder],
                         capture_output=True, text=True, env=dict(os.environ, MPLCONFIGDIR=folder))
    assert ran.returncode == 0, ran.stderr
    print(ran.stdout, end="")
    assert ran.stdout == (ROOT / "tests/gallery/languages.txt").read_text()
    names = [line.split()[0] for line in ran.stdout.splitlines()]
    assert names == ["protein", "earthquakes", "iris", "jacksboro"], names
    for name in names:
        rows = (pathlib.Path(folder) / (name + ".csv")).read_text().splitlines()
        rows = [tuple(map(float, row.split(",")[:3])) for row in rows if row[:1].isdigit()]
        assert rows == shown(name), "the bars of %s are not those of the tool" % name
        picture = (pathlib.Path(folder) / (name + ".png")).read_bytes()
        assert picture[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", picture[16:24]) == (880, 400)
        assert len(picture) > 10000, "%s.png is empty" % name
