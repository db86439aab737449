"""All tests of the Python package under pytest, or a word why not. Arguments go to pytest."""
import importlib.util
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    missing = [name for name in ("numpy", "pytest") if not importlib.util.find_spec(name)]
    if missing:
        print("SKIPPED: no " + ", ".join("python3-" + name for name in missing))
        return 0
    import pytest
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.dont_write_bytecode = True
    return pytest.main(["-q", "-p", "no:cacheprovider", "-rs", HERE, *sys.argv[1:]])


if __name__ == "__main__":  # tests begin processes that read this file again
    sys.exit(main())
