#!/usr/bin/env python3
"""Builds of the engine without some of its parts: each switch of netmesh_config.h off by itself, all of them
off, and single dimensions. Each runs features.c: what is in gives the fingerprints of the full build, what is out
answers NETMESH_NOT_BUILT and names its switch.

    features.py SOURCE WORK CC CXX

Sources are compiled many at once, those that read the switches by themselves: only they are compiled again, and the
objects of the others are those of the full build.
"""
import concurrent.futures
import os
import re
import subprocess
import sys

FLAGS = ("-O0 -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno -ffp-contract=off "
         "-ffunction-sections -fdata-sections").split()
SWITCHES = "vocabulary/features.hpp"


def run(command, **more):
    return subprocess.run(command, check=True, text=True, capture_output=True, **more).stdout


class Builder:
    def __init__(self, source, work, cc, cxx):
        self.source, self.work, self.cc, self.cxx = source, work, cc, cxx
        self.engine = os.path.join(source, "engine")
        files = sorted(os.path.relpath(os.path.join(folder, name), self.engine)
                       for folder, _, names in os.walk(self.engine) for name in names if name.endswith(".cpp"))
        self.below = {}
        others = [f for f in files if SWITCHES not in self.included(f)]
        self.parts = {"readers": [f for f in files if f not in others], "even": others[::2], "odd": others[1::2]}
        self.pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())

    def included(self, file):
        """All of the engine's files that a file includes, itself among them."""
        if file not in self.below:
            self.below[file] = {file}
            with open(os.path.join(self.engine, file), encoding="utf-8") as text:
                for name in re.findall(r'^#include "(.+)"$', text.read(), re.M):
                    if os.path.isfile(os.path.join(self.engine, name)):
                        self.below[file] |= self.included(name)
        return self.below[file]

    def compile(self, part, folder, defines):
        """The sources of a part at once, which takes a quarter of the time."""
        unit = os.path.join(folder, part + ".cpp")
        with open(unit, "w", encoding="utf-8") as text:
            text.writelines(f'#include "{os.path.join(self.engine, file)}"\n' for file in self.parts[part])
        run([self.cxx, "-std=c++17", *FLAGS, *defines, "-I", self.engine, "-I", self.engine + "/include", "-c", unit,
             "-o", unit[:-4] + ".o"])
        return unit[:-4] + ".o"

    def objects(self, name, defines, base=None):
        """Object files by part. With `base`, the sources that do not read the switches are taken from it."""
        folder = os.path.join(self.work, name)
        os.makedirs(folder, exist_ok=True)
        again = list(self.parts) if base is None else ["readers"]
        made = dict(base or {})
        made.update(zip(again, self.pool.map(lambda part: self.compile(part, folder, defines), again)))
        return made

    def lines(self, name, defines, objects):
        program = os.path.join(self.work, name, "features")
        run([self.cc, "-std=c99", "-Wall", "-Werror", *defines, "-I", self.engine, "-I", self.engine + "/include",
             os.path.join(self.source, "tests/embedding/features.c"), *objects.values(), "-o", program, "-lm"])
        done = subprocess.run([program], text=True, capture_output=True)
        if done.returncode != 0:
            print(f"{name}: exit {done.returncode}\n{done.stderr}")
            return None
        return set(done.stdout.splitlines())


def main():
    source, work, cc, cxx = sys.argv[1:]
    with open(os.path.join(source, "engine/vocabulary/netmesh_config.h"), encoding="utf-8") as header:
        switches = re.findall(r"#ifndef (NETMESH_WITH_\w+)", header.read())
    if len(switches) < 3:
        sys.exit("netmesh_config.h has hardly any switch")
    builder = Builder(source, work, cc, cxx)
    plane = ["-DNETMESH_EACH_DIMENSION(DO)=DO(2)"]
    base = builder.objects("plane", plane)
    full = {}
    builds = [("plane", plane, base), ("space", ["-DNETMESH_EACH_DIMENSION(DO)=DO(3)"], None),
              ("both", ["-DNETMESH_EACH_DIMENSION(DO)=DO(2) DO(3)"], None)]
    for name, defines, objects in builds:
        full[name] = builder.lines(name, defines, objects or builder.objects(name, defines))
    if None in full.values():
        return 1
    failed = full["plane"] | full["space"] != full["both"]
    if failed:
        print("two dimensions together give other results than each by itself")
    for off in [[s] for s in switches] + [switches]:
        name = off[0] if len(off) == 1 else "all"
        defines = plane + [f"-D{switch}=0" for switch in off]
        lines = builder.lines(name, defines, builder.objects(name, defines, base))
        if lines is None:
            failed = True
        elif not lines < full["plane"]:
            failed = True
            print(f"without {name}:", *sorted(lines - full["plane"]) or ["no job is left out"], sep="\n    ")
        else:
            print(f"without {name}: {len(lines)} of {len(full['plane'])} jobs, with the same results")
    return failed


sys.exit(main())
