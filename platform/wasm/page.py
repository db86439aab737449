#!/usr/bin/env python3
"""page.py FOLDER MODULE OUT: puts style, scripts and module into FOLDER/page/page.html, so that one file is all."""
import base64
import pathlib
import re
import sys

folder = pathlib.Path(sys.argv[1]) / "page"
module = base64.b64encode(pathlib.Path(sys.argv[2]).read_bytes()).decode("ascii")


def part(found):
    name = found.group(1)
    text = module if name == "MODULE" else (folder / name).read_text(encoding="utf-8")
    text = re.sub(r"^export (?=function|class|const)", "", text, flags=re.M)  # a module of the package, as a script
    text = re.sub(r"^import .*\n", "", text, flags=re.M)
    if name != "MODULE" and ("</script" in text or "</style" in text):
        sys.exit(f"{name} would end its own element")
    return text


page, count = re.subn(r"@([A-Za-z./]+)@", part, (folder / "page.html").read_text(encoding="utf-8"))
if count != 12:
    sys.exit(f"the page has {count} parts and not 12")
pathlib.Path(sys.argv[3]).write_text(page, encoding="utf-8")
