"""Runs the examples of a README, block after block, in one program and an empty folder. `--first`: the first alone."""
import importlib.util
import os
import re
import sys
import tempfile

if not importlib.util.find_spec("numpy") or "--first" not in sys.argv and not importlib.util.find_spec("sklearn"):
    print("SKIPPED: no numpy or scikit-learn")
    sys.exit(0)
path = os.path.abspath(sys.argv[1])
with open(path, encoding="utf-8") as file:
    blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.M | re.S)
assert len(blocks) > 8
names = {}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for number, block in enumerate(blocks[:1] if "--first" in sys.argv else blocks):
        exec(compile(block, "%s, block %d" % (path, number + 1), "exec"), names)
    os.chdir("/")
print("%d blocks of %s" % (1 if "--first" in sys.argv else len(blocks), os.path.basename(path)))
