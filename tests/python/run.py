"""All tests of the Python package under pytest, or a word why not. Arguments go to pytest."""
import importlib.util
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
missing = [name for name in ("numpy", "pytest") if not importlib.util.find_spec(name)]
if missing:
    print("SKIPPED: no " + ", ".join("python3-" + name for name in missing))
    sys.exit(0)
import pytest  # noqa: E402

os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
sys.dont_write_bytecode = True
sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", "-rs", HERE, *sys.argv[1:]]))
