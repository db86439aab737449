#!/usr/bin/env python3
"""Checks of tools/amalgamate and of the two files that it writes.

  check.py script  --work DIR               same bytes from everywhere; errors said, nothing left half-written
  check.py planted --work DIR --cxx C       what cannot stand in one file is refused, wrong arithmetic does not compile
  check.py compile --work DIR --cxx C [--flags F] [--wasm]
                                            the plane alone compiles without a warning; its symbols and instructions
  check.py readme  --work DIR --cxx C --cc C [--flags F]
                                            the commands of tools/docs/embedding.md, with two files
                                            of a user's in C++ and in C99; then symbols, instructions and
                                            all golden fingerprints of what they made, F behind their own flags
  check.py golden  --work DIR --cxx C --flags F
                                            the same of the plane and space together, and their golden fingerprints
"""
import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "../.."))
AMALGAMATE = os.path.join(ROOT, "tools/amalgamate")
PLANE, BOTH = "-DNETMESH_EACH_DIMENSION(DO)=DO(2)", "-DNETMESH_EACH_DIMENSION(DO)=DO(2) DO(3)"
FILES = ["netmesh.cpp", "netmesh.h"]
faults = 0


def check(holds, what):
    global faults
    print("%-5s %s" % ("ok" if holds else "FAULT", what))
    faults += not holds


def run(command, **kind):
    """Status and all that the command said."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, **kind)
    return done.returncode, done.stdout


def must(command, **kind):
    status, said = run(command, **kind)
    if status != 0:
        print("%s\n%s\nFAULT the command ends with %d" % (" ".join(command), said, status))
        sys.exit(1)
    return said


def amalgamate(*arguments, **kind):
    return run([sys.executable, AMALGAMATE, *arguments], **kind)


def copy_of_engine(work, backwards=False):
    """A copy whose files were made in another order."""
    root = os.path.join(work, "copy")
    shutil.rmtree(root, ignore_errors=True)
    paths = sorted(os.path.relpath(os.path.join(base, name), ROOT)
                   for base, _, names in os.walk(os.path.join(ROOT, "engine")) for name in names)
    for path in (reversed(paths) if backwards else paths):
        os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
        shutil.copyfile(os.path.join(ROOT, path), os.path.join(root, path))
    shutil.copyfile(os.path.join(ROOT, "LICENSE"), os.path.join(root, "LICENSE"))
    return os.path.join(root, "engine")


def check_script(options):
    work = options.work
    status, said = amalgamate("--help")
    check(status == 0 and "netmesh.cpp" in said, "--help says what it writes")
    first = os.path.join(work, "first")
    must([sys.executable, AMALGAMATE, first])
    check(sorted(os.listdir(first)) == FILES, "two files are written and nothing else")
    ways = {
        "again, over old files": ([first], {}),
        "from another folder": (["second"], {"cwd": work}),
        "in another locale": (["third"], {"cwd": work, "env": {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0",
                                                               "PYTHONHASHSEED": "11"}}),
        "with a script language of its own": (["fourth"], {"cwd": work, "env": {**os.environ, "LC_ALL": "tr_TR.UTF-8",
                                                                                "TZ": "Asia/Tokyo"}}),
        "from files made in another order": (["--engine", copy_of_engine(work, True), "fifth"], {"cwd": work}),
    }
    kept = {name: open(os.path.join(first, name), "rb").read() for name in FILES}
    for how, (arguments, kind) in ways.items():
        status, said = amalgamate(*arguments, **kind)
        out = os.path.join(work, arguments[-1])
        same = status == 0 and all(open(os.path.join(out, n), "rb").read() == kept[n] for n in FILES)
        check(same, "the same bytes " + how + ("" if same else ": " + said))
    text = kept["netmesh.cpp"].decode() + kept["netmesh.h"].decode()
    inside = sorted(os.path.relpath(os.path.join(base, name), ROOT)
                    for base, _, names in os.walk(os.path.join(ROOT, "engine")) for name in names
                    if name.endswith((".h", ".hpp", ".cpp")))
    marks = sorted(re.findall(r"^/\* ---- (\S+) ---- \*/$", text, re.M))
    check(marks == inside, "each of the engine's %d files is in them once, with its name" % len(inside))
    others = re.search(r"^#\s*include\s*<(?!std(def|int)\.h>)", text, re.M)
    check(not others, "they include stddef.h and stdint.h alone")
    wrong = os.path.join(work, "a_file")
    open(wrong, "w").close()
    blocked = os.path.join(work, "blocked")
    os.makedirs(os.path.join(blocked, "netmesh.h"))
    for arguments, words in [([], "give OUT"), ([wrong], "cannot write to"), ([blocked], "cannot write to"),
                             (["--engine", work, "out"], "is not the engine")]:
        status, said = amalgamate(*arguments, cwd=work)
        check(status != 0 and words in said and "Traceback" not in said, "%s: %s" % (" ".join(arguments), words))
    check(os.listdir(blocked) == ["netmesh.h"], "nothing is left behind by a failure")


FRAME = "mesh/loop/frame.cpp"

# name: (file of the engine, what is put at its end, what is said)
PLANTS = {
    "a function twice": ("api/bounds.cpp", "namespace netmesh {\nnamespace {\nint link_facets(int x) { return x; }\n"
                         "}  // namespace\n}  // namespace netmesh\n", "link_facets is declared in api/bounds.cpp and"),
    "a type twice": (FRAME, "namespace netmesh {\nnamespace {\nstruct Items {\n    int a;\n};\n"
                     "}  // namespace\n}  // namespace netmesh\n",
                     "Items is declared in " + FRAME + " and numerics/value_order.cpp"),
    "a constant twice": (FRAME, "namespace netmesh {\nnamespace {\nconstexpr double other = 1, chunk = 2;\n"
                         "}  // namespace\n}  // namespace netmesh\n", "chunk is declared in"),
    "a macro that stays": (FRAME, "#define NETMESH_LEFT 1\n", "macro NETMESH_LEFT is not undefined"),
    "a using directive": (FRAME, "namespace netmesh {\nusing namespace filter_trait;\n"
                          "}  // namespace netmesh\n", "using namespace filter_trait"),
    "a header of C++": (FRAME, "#include <array>\n", FRAME + " includes <array>"),
    "a name of C++": (FRAME, "namespace netmesh {\ninline int least() { return std::min(1, 2); }\n"
                      "}  // namespace netmesh\n", FRAME + " uses std::min"),
    "a header that is not there": (FRAME, '#include "mesh/none.hpp"\n', 'includes "mesh/none.hpp"'),
    "headers in a circle": ("vocabulary/ids.hpp", '#include "mesh/loop/frame.hpp"\n', "files include one another"),
    "a namespace in one line": (FRAME, "namespace netmesh { int here(); }\n", FRAME + ": namespace"),
}


def check_planted(options):
    for name, (path, text, words) in PLANTS.items():
        engine = copy_of_engine(options.work)
        with open(os.path.join(engine, path), "a", encoding="utf-8") as f:
            f.write("\n" + text)
        out = os.path.join(options.work, "out")
        status, said = amalgamate("--engine", engine, out)
        check(status == 1 and words in said and not os.path.exists(out), "%s: %s" % (name, said.strip()[-100:]))
    good = os.path.join(options.work, "good")
    must([sys.executable, AMALGAMATE, good])
    source = os.path.join(good, "netmesh.cpp")
    base = [options.cxx, "-std=c++17", PLANE, "-fsyntax-only"]
    status, said = run(base + [source])
    check(status == 0 and said == "", "without a fault it compiles " + said[:300])
    flags = [["-ffast-math"], ["-ffinite-math-only"], ["-std=gnu++14"],
             ["-U__SIZEOF_DOUBLE__", "-D__SIZEOF_DOUBLE__=4"]]
    if "clang" not in must([options.cxx, "--version"]):
        flags += [["-freciprocal-math"], ["-fno-signed-zeros"], ["-funsafe-math-optimizations"]]
        if re.search("x86[-_]64", must([options.cxx, "-dumpmachine"])):
            flags.append(["-mfpmath=387"])
    for flag in flags:
        status, said = run(base + flag + ["-Wfatal-errors", source])
        check(status != 0 and "#error" in said and "netmesh: " in said, "%s is an #error" % " ".join(flag))
    # The compiler by itself sees what two sources would declare, should the script ever miss it.
    with open(source, "a", encoding="utf-8") as f:
        f.write("namespace {\nnamespace netmesh {\nnamespace {\nstruct Items {};\n}\n}\n}\n")
    status, said = run(base + [source])
    check(status != 0 and "Items" in said, "a type twice does not compile")


def symbols(nm, objects, *options):
    return {line.split()[0] for line in must([nm, "-P", *options, objects]).splitlines() if line and line[-1] != ":"}


def check_object(options):
    """netmesh.o in the work folder."""
    objects = os.path.join(options.work, "netmesh.o")
    if options.wasm:
        # The linker's own names are no library's.
        wanted = symbols("llvm-nm", objects, "-u") - {"__stack_pointer", "__linear_memory", "__indirect_function_table"}
        shown = symbols("llvm-nm", objects, "-g", "--defined-only")
        check(wanted <= {"memcpy", "memmove", "memset", "memcmp"}, "undefined: " + " ".join(sorted(wanted)))
        check(all(s.startswith("netmesh_") for s in shown) and len(shown) > 40, "%d symbols are visible" % len(shown))
        return
    archive = os.path.join(options.work, "libnetmesh.a")
    must(["ar", "rcs", archive, objects])
    status, said = run([sys.executable, os.path.join(ROOT, "tests/archive/check.py"), "archive", "--archive", archive,
                        "--tables", *("--%s=%s" % (name, name) for name in ("nm", "objdump", "readelf", "ld"))])
    print(said)
    check(status == 0, "the object keeps what the archive promises")


def check_compile(options, dimensions=PLANE):
    must([sys.executable, AMALGAMATE, options.work])
    command = [options.cxx, "-std=c++17", *shlex.split(options.flags), dimensions, "-c", "netmesh.cpp"]
    said = must(command, cwd=options.work)
    check(said == "", "compiles without a warning %s" % said[:500])
    check_object(options)


def readme_commands():
    """Lines of the shell blocks of the section in tools/docs."""
    with open(os.path.join(ROOT, "tools/docs/embedding.md"), encoding="utf-8") as f:
        section = re.search(r"^## Vendoring: two files\n(.*?)^## ", f.read(), re.M | re.S)
    lines = [line for block in re.findall(r"```sh\n(.*?)```", section.group(1), re.S) for line in block.splitlines()]
    if len(lines) != 4:
        sys.exit("FAULT the section has %d commands, not 4" % len(lines))
    return lines


def user_files(work, ending):
    for name in ("main", "points"):
        shutil.copyfile(os.path.join(HERE, "example", name + ".c"), os.path.join(work, name + ending))


def compare(program, dimensions=()):
    said = must(["sh", os.path.join(ROOT, "tests/determinism/compare"), program,
                 os.path.join(ROOT, "tests/golden/fingerprints.txt"), *dimensions])
    check("fingerprints equal" in said, said.strip())


def fingerprints(options, flags):
    """The program of tests/determinism, linked with netmesh.o in the work folder."""
    with open(os.path.join(options.work, "netmesh.hpp"), "w", encoding="utf-8") as f:
        f.write('#include "netmesh.h"\n')
    program = os.path.join(options.work, "fingerprints")
    tests = os.path.join(ROOT, "tests")
    must([options.cxx, "-std=c++17", *flags, "-ffp-contract=off", "-I", options.work, "-I", tests,
          os.path.join(tests, "determinism/fingerprints.cpp"), os.path.join(options.work, "netmesh.o"), "-o", program])
    return program


def check_readme(options):
    """The compilers of the build go by the names that the page has."""
    work = options.work
    os.symlink(ROOT, os.path.join(work, "netmesh"))
    tools = os.path.join(work, "bin")
    os.makedirs(tools)
    # The line that makes all at once is tried for the plane alone and at -O0, for time; the two steps as they are.
    more = shlex.split(options.flags)
    for name, command, more in [("g++", options.cxx, more), ("gcc", options.cc, more),
                                ("plane/g++", options.cxx, [PLANE, "-O0"])]:
        path = os.path.join(tools, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as f:
            f.write("#!/bin/sh\nexec %s \"$@\" %s\n" % (shlex.quote(command), " ".join(map(shlex.quote, more))))
        os.chmod(path, 0o755)
    write, at_once, engine, application = readme_commands()
    paths = {kind: {**os.environ, "PATH": os.pathsep.join([os.path.join(tools, kind), tools, os.environ["PATH"]])}
             for kind in ("", "plane")}
    must(["sh", "-ec", write], cwd=work)
    user_files(work, ".cpp")
    said = must(["sh", "-ec", at_once], cwd=work, env=paths["plane"])
    check(said == "", at_once + said)
    program = os.path.join(work, "program")
    check("1 loop" in must([program]), "runs")
    os.remove(program)
    user_files(work, ".c")
    for command in (engine, application):
        said = must(["sh", "-ec", command], cwd=work, env=paths[""])
        check(said == "", command + said)
    check("1 loop" in must([program]), "runs, in C99")
    if shutil.which("readelf"):
        needed = re.findall(r"\(NEEDED\).*\[(.*)\]", must(["readelf", "-d", program]))
        check(needed and not any("stdc++" in n or "gcc_s" in n for n in needed), "needs " + " ".join(needed))
    check_object(options)
    compare(fingerprints(options, ["-O2"]))


def check_golden(options):
    check_compile(options, BOTH)
    compare(fingerprints(options, shlex.split(options.flags)), ("2", "3"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["script", "planted", "compile", "readme", "golden"])
    parser.add_argument("--work", required=True)
    parser.add_argument("--cxx", default="g++")
    parser.add_argument("--cc", default="gcc")
    parser.add_argument("--flags", default="")
    parser.add_argument("--wasm", action="store_true")
    options = parser.parse_args()
    options.work = os.path.abspath(options.work)
    if shutil.which(options.cxx) is None or options.wasm and shutil.which("llvm-nm") is None:
        print("SKIPPED: %s is not installed" % options.cxx)
        return 0
    shutil.rmtree(options.work, ignore_errors=True)
    os.makedirs(options.work)
    {"script": check_script, "planted": check_planted, "compile": check_compile, "readme": check_readme,
     "golden": check_golden}[options.what](options)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
