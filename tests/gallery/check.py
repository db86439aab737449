#!/usr/bin/env python3
"""tests/gallery/check.py NETMESH WORK [--update]: runs every command of tools/docs/gallery.md in WORK, where scripts of
the page are, and compares the diagram and the picture that it leaves with those of tools/docs/gallery. --update writes
these. Commands that another test runs are left to it."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
GALLERY = ROOT / "tools" / "docs" / "gallery"
LARGEST = 200 * 1024


def build_has(program, dim):
    """Whether this build knows points of so many dimensions."""
    made = subprocess.run([program, "size", "--dim", str(dim), "--points", "10"], capture_output=True)
    return made.returncode == 0


def main():
    program, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    update = "--update" in sys.argv
    shutil.rmtree(work, ignore_errors=True)
    (work / "tests").mkdir(parents=True)
    (work / "tests" / "data").symlink_to(ROOT / "tests" / "data")
    (work / "bin").mkdir()
    (work / "bin" / "netmesh").symlink_to(program)
    text = (GALLERY.parent / "gallery.md").read_text()
    commands = re.findall(r"^((?:<!-- run by: [^\n]*-->\n)?)```sh\n(.*?)```", text, re.M | re.S)
    shown = re.findall(r"!\[[^]]+\]\(gallery/([^)]+)\.svg\)", text)
    for name, script in re.findall(r"^<!-- file: (\S+) -->\n```\w*\n(.*?)^```$", text, re.M | re.S):
        (work / name).write_text(script)
    faults, compared = [], set()
    for path in sorted((ROOT / "tests" / "data").iterdir()):
        if path.name != "README.md" and ("`%s`" % path.name) not in (ROOT / "tests/data/README.md").read_text():
            faults.append("%s has no row in README.md" % path.name)
        if path.stat().st_size > LARGEST:
            faults.append("%s has more than %d bytes" % (path.name, LARGEST))
    if len(commands) != len(shown):
        faults.append("%d commands for %d pictures" % (len(commands), len(shown)))
    for (elsewhere, command), name in zip(commands, shown):
        if elsewhere:
            print("%s: by another test" % name)
            compared.add(name + ".svg")
            continue
        if any(word in command for word in ("iris", "clifford")) and not build_has(program, 4):
            print("%s: not without D = 4" % name)
            compared.update((name + ".pers", name + ".svg"))
            continue
        ran = subprocess.run(command, shell=True, cwd=work, capture_output=True, text=True,
                             env=dict(os.environ, PATH="%s:%s" % ((work / "bin").resolve(), os.environ["PATH"])))
        if ran.returncode != 0:
            faults.append("%s: %s" % (command.strip(), ran.stderr))
            continue
        for made in (work / (name + ".pers"), work / (name + ".svg")):
            compared.add(made.name)
            if not made.exists():
                faults.append("%s is not made" % made.name)
            elif update:
                GALLERY.mkdir(exist_ok=True)
                shutil.copyfile(made, GALLERY / made.name)
            elif not (GALLERY / made.name).exists() or (GALLERY / made.name).read_bytes() != made.read_bytes():
                faults.append("%s is not the one of the gallery: see %s" % (made.name, made))
            elif made.stat().st_size > LARGEST:
                faults.append("%s has more than %d bytes" % (made.name, LARGEST))
    left = {path.name for path in GALLERY.iterdir()} - compared
    faults += ["%s belongs to no command" % name for name in sorted(left)]
    for fault in faults:
        print("FAULT", fault)
    print("%d commands, %d files compared, %d faults" % (len(commands), len(compared), len(faults)))
    return 1 if faults or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
