"""platform/python/examples/windows.py prints what windows.c prints on every machine, and draws what the gallery has."""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
if not importlib.util.find_spec("numpy"):
    print("SKIPPED: no python3-numpy")
    sys.exit(0)

with tempfile.TemporaryDirectory() as folder:
    for dim in 2, 3:
        made = pathlib.Path(folder) / ("windows-%d.svg" % dim)
        ran = subprocess.run([sys.executable, str(ROOT / "platform/python/examples/windows.py"), str(dim), str(made)],
                             capture_output=True, text=True)
        assert ran.returncode == 0, ran.stderr
        assert ran.stdout == (ROOT / ("platform/cortexm/windows-%d.txt" % dim)).read_text(), ran.stdout
        print(ran.stdout, end="")
        picture = ROOT / "tools/docs/gallery" / made.name
        assert made.read_bytes() == picture.read_bytes(), "%s is not what windows.py draws" % picture
