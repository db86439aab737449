"""The declarations for ctypes are what the headers say and what the compiler makes of them."""
import ctypes
import os
import runpy
import shutil
import subprocess
import sys

import pytest

from conftest import ROOT
from netmesh import _declarations as c

DECLARE = os.path.join(ROOT, "platform", "python", "declare")


def test_written_anew():
    subprocess.run([sys.executable, DECLARE, "--check"], check=True)


def test_layouts(tmp_path):
    compiler = os.environ.get("CC") or shutil.which("cc")
    if not compiler:
        pytest.skip("no C compiler")
    lines = ['#include <stddef.h>', '#include <stdio.h>', '#include "arrays.h"', '#include "netmesh/laboratory.h"',
             '#include "watch.h"', "int main(void) {"]
    due = []
    for struct in c.STRUCTS:
        name = struct.__name__
        lines.append('printf("%%zu\\n", sizeof(%s));' % name)
        due.append(ctypes.sizeof(struct))
        for field in struct._fields_:
            lines.append('printf("%%zu\\n", offsetof(%s, %s));' % (name, field[0]))
            due.append(getattr(struct, field[0]).offset)
            lines.append('printf("%%zu\\n", sizeof(((%s*)0)->%s));' % (name, field[0]))
            due.append(getattr(struct, field[0]).size)
    constants = sorted(name for name in dir(c) if name.startswith("NETMESH_"))
    for name in constants:
        lines.append('printf("%%lld\\n", (long long)%s);' % name)
        due.append(getattr(c, name))
    source = tmp_path / "layouts.c"
    source.write_text("\n".join(lines + ["return 0; }", ""]))
    folders = ["engine/include", "platform/arrays", "platform/python"]
    subprocess.run([compiler, "-std=c99", *("-I" + os.path.join(ROOT, f) for f in folders), str(source), "-o",
                    str(tmp_path / "layouts")], check=True)
    said = subprocess.run([str(tmp_path / "layouts")], check=True, stdout=subprocess.PIPE).stdout.split()
    assert [int(word) for word in said] == due
    assert len(c.STRUCTS) > 50 and len(constants) > 150


def test_what_is_not_understood_is_an_error():
    declare = runpy.run_path(DECLARE)
    for text in ("typedef struct a { uint32_t x : 3; } a;", "union u { int a; };", "#define NETMESH_A f(3)\n"):
        with pytest.raises((SystemExit, KeyError, AttributeError)):
            declare["Reader"]().read(text)
