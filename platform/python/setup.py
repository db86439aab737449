"""Builds the package: Python files, and one shared library that serves every version of Python.

The engine is compiled as one source, which tools/amalgamate writes in a clone and which a source distribution carries;
that takes two minutes. NETMESH_LIBRARY names a library that is built already (cmake's target netmesh_python), which is
copied in its place. CC, CXX, CFLAGS and CXXFLAGS are heeded.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist
from setuptools.dist import Distribution

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
AMALGAMATE = os.path.join(ROOT, "tools", "amalgamate")
C_SOURCES = ["arrays.c", "functions.c", "watch.c"]
HEADERS = ["arrays.h", "functions.h", "watch.h"]


def version():
    with open(os.path.join(HERE, "netmesh", "_declarations.py"), encoding="utf-8") as file:
        return ".".join(re.findall(r"^NETMESH_VERSION_(?:MAJOR|MINOR|PATCH) = (\d+)", file.read(), re.M))


def gather(folder):
    """All sources of the library in one folder."""
    carried = os.path.join(HERE, "source")
    if os.path.isdir(carried):
        shutil.copytree(carried, folder, dirs_exist_ok=True)
        return
    subprocess.run([sys.executable, AMALGAMATE, folder], check=True)
    for name in C_SOURCES + HEADERS:
        here = os.path.join(HERE, name)
        shutil.copy(here if os.path.exists(here) else os.path.join(ROOT, "platform", "arrays", name), folder)


def flags(name):
    return shlex.split(os.environ.get(name, ""))


def compile_library(folder, output):
    cc, cxx = shlex.split(os.environ.get("CC", "cc")), shlex.split(os.environ.get("CXX", "c++"))
    common = ["-O2", "-fPIC", "-fvisibility=hidden", "-ffp-contract=off"]
    objects = []
    for name in ["netmesh.cpp"] + C_SOURCES:
        is_c = name.endswith(".c")
        command = cc + ["-std=c99"] if is_c else cxx + ["-std=c++17"]
        command += common + flags("CFLAGS" if is_c else "CXXFLAGS")
        print("netmesh: compiling", name, flush=True)
        subprocess.run(command + ["-c", name, "-o", name + ".o"], cwd=folder, check=True)
        objects.append(name + ".o")
    # The engine needs no library of C++.
    subprocess.run(cc + ["-shared", "-o", output, *objects, "-lm", *flags("LDFLAGS")], cwd=folder, check=True)


class BuildWithLibrary(build_py):
    def run(self):
        super().run()
        ending = {"darwin": "dylib", "win32": "dll"}.get(sys.platform, "so")
        target = os.path.abspath(os.path.join(self.build_lib, "netmesh", "libnetmesh." + ending))
        os.makedirs(os.path.dirname(target), exist_ok=True)
        named = os.environ.get("NETMESH_LIBRARY")
        if named:
            shutil.copy(named, target)
            return
        folder = os.path.abspath(os.path.join("build", "source"))
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        gather(folder)
        compile_library(folder, target)


class SourceWithEngine(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        folder = os.path.join(base_dir, "source")
        os.makedirs(folder, exist_ok=True)
        gather(folder)


class WheelForEveryPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return True


setup(version=version(), distclass=WithLibrary,
      cmdclass={"build_py": BuildWithLibrary, "sdist": SourceWithEngine, "bdist_wheel": WheelForEveryPython})
