#!/usr/bin/env python3
"""page.py TEMPLATE MODULE OUT: puts the module into the page, so that one file is all there is."""
import base64
import sys

with open(sys.argv[1], encoding="utf-8") as f:
    page = f.read()
with open(sys.argv[2], "rb") as f:
    module = base64.b64encode(f.read()).decode("ascii")
if page.count("@MODULE@") != 1:
    sys.exit("the template has no single @MODULE@")
with open(sys.argv[3], "w", encoding="utf-8") as f:
    f.write(page.replace("@MODULE@", module))
