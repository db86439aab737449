"""package.py wheel | source: builds the package without a network, installs it in a clean environment, and runs the
first example of its README there, and a script of the clone, which has to find the package that is installed.

  wheel    with the library that NETMESH_LIBRARY names, by `pip wheel`
  source   by `pip install` of the source distribution, which compiles the engine; of D = 2 alone and not optimised, as
           this is about the way, unless CXXFLAGS says something else
"""
import glob
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
PACKAGE = os.path.join(ROOT, "platform", "python")
OFFLINE = ["--no-index", "--no-deps", "--no-build-isolation", "--disable-pip-version-check", "--quiet"]


def run(*command, **options):
    subprocess.run(command, check=True, **options)


def build(kind, folder):
    """A file that pip installs."""
    # Of a copy, so that nothing is left behind in the sources.
    ignored = shutil.ignore_patterns("build", "dist", "*.egg-info", "__pycache__", "libnetmesh.*")
    tree = os.path.join(folder, "clone")
    shutil.copytree(PACKAGE, os.path.join(tree, "platform", "python"), ignore=ignored)
    for part in ("engine", "tools", os.path.join("platform", "arrays")):
        shutil.copytree(os.path.join(ROOT, part), os.path.join(tree, part))
    shutil.copy(os.path.join(ROOT, "LICENSE"), tree)
    copy = os.path.join(tree, "platform", "python")
    environment = dict(os.environ)
    if kind == "wheel":
        run(sys.executable, "-m", "pip", "wheel", *OFFLINE, "-w", folder, copy, env=environment)
        return glob.glob(os.path.join(folder, "*.whl"))[0], environment
    environment.pop("NETMESH_LIBRARY", None)
    environment.setdefault("CXXFLAGS", "-O0 '-DNETMESH_EACH_DIMENSION(DO)=DO(2)'")
    run(sys.executable, "setup.py", "-q", "sdist", "-d", folder, cwd=copy, env=environment,
        stdout=subprocess.DEVNULL)
    shutil.rmtree(tree)
    return glob.glob(os.path.join(folder, "*.tar.gz"))[0], environment


def main():
    kind = sys.argv[1]
    missing = [name for name in ("numpy", "pip", "setuptools", "wheel", "venv") if not importlib.util.find_spec(name)]
    if missing:
        print("SKIPPED: no " + ", ".join(missing))
        return
    if kind == "wheel" and not os.environ.get("NETMESH_LIBRARY"):
        print("SKIPPED: NETMESH_LIBRARY, the library that cmake builds, is not given")
        return
    with tempfile.TemporaryDirectory() as folder:
        file, environment = build(kind, folder)
        name = os.path.basename(file)
        assert kind != "wheel" or name.startswith("netmesh-") and "-py3-none-" in name, name
        clean = os.path.join(folder, "clean")
        run(sys.executable, "-m", "venv", "--system-site-packages", clean)
        python = os.path.join(clean, "bin", "python")
        run(python, "-m", "pip", "install", *OFFLINE, file, env=environment)
        for variable in ("NETMESH_LIBRARY", "PYTHONPATH"):
            environment.pop(variable, None)
        run(python, os.path.join(HERE, "readme.py"), os.path.join(PACKAGE, "README.md"), "--first", env=environment,
            cwd=folder)
        said = subprocess.run([python, "-c", "import netmesh; print(netmesh.__file__)"], check=True, cwd=folder,
                              env=environment, stdout=subprocess.PIPE).stdout.decode().strip()
        assert said.startswith(clean), said
        run(python, os.path.join(PACKAGE, "examples", "windows.py"), "2", cwd=ROOT, env=environment,
            stdout=subprocess.DEVNULL)
        print("%s, %d KB, installed and run" % (name, os.path.getsize(file) // 1024))


if __name__ == "__main__":
    main()
