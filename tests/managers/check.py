#!/usr/bin/env python3
"""Checks of tools/package and of what it writes for each package manager.

  check.py script  --work DIR    same bytes from everywhere, fields that are given, errors said
  check.py KIND    --work DIR    the manifest is what the manager documents (rules.py); a copy that holds only what it
                                 lists is built as the manager would (standin/), and its example run; dimensions are
                                 chosen in the manager's own way
  check.py planted --work DIR    faults in descriptions, manifests and lists are found

Packages for firmware are built for a Cortex-M and run in qemu, those for desktops on this machine. netmesh.cpp, behind
the preprocessor, is the same text for all kinds of firmware: once.py compiles it once.
"""
import argparse
import filecmp
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import zipfile

import rules

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "../.."))
STANDIN = os.path.join(HERE, "standin")
PACKAGE = os.path.join(ROOT, "tools", "package")
KINDS = ("arduino", "cmsis", "conan", "espidf", "platformio", "vcpkg", "zephyr")
FIRMWARE = ("arduino", "cmsis", "espidf", "platformio", "zephyr")
CXX, CC = "arm-none-eabi-g++", "arm-none-eabi-gcc"
# Of every core for Arduino and every board of the others. They have -Os, which takes twice the time of -O0 here: the
# sources are those of -Os.
BOARD = ["-mthumb", "-mcpu=cortex-m4", "-O0", "-D__OPTIMIZE_SIZE__", "-ffunction-sections", "-fdata-sections"]
CORE = ["-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics"]
LINK = ["--specs=rdimon.specs", "-Wl,--gc-sections", "-Wl,--section-start=.vectors=0", "-Wl,-u,vectors"]
SAYS = "loop from 259 to 1000\n"  # sin(pi/12) and 1
REFERENCE = {2: "-DNETMESH_EACH_DIMENSION(DO)=DO(2)", 3: "-DNETMESH_EACH_DIMENSION(DO)=DO(2) DO(3)"}
wrong = 0


def check(holds, what):
    global wrong
    print("%-5s %s" % ("ok" if holds else "FAULT", what))
    wrong += not holds


def run(command, **kind):
    """Status and all that the command said."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, **kind)
    return done.returncode, done.stdout


class Failed(Exception):
    """A build that does not go through."""


def must(command, **kind):
    status, said = run(command, **kind)
    if status != 0:
        raise Failed("%s\n%s\nends with %d" % (" ".join(command), said[-3000:], status))
    return said


def expected():
    numbers = re.findall(r"^#define NETMESH_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$",
                         rules.read(ROOT, "engine/include/netmesh/context.h"), re.M)
    return {"version": ".".join(numbers), "license": "MIT", "name": "netmesh"}


def package(kind, folder, *more):
    shutil.rmtree(folder, ignore_errors=True)
    must([sys.executable, PACKAGE, kind, folder, *more])
    return folder


def copy_listed(kind, folder, copy):
    """Only what the manifest lists, in a folder of its own."""
    shutil.rmtree(copy, ignore_errors=True)
    for path in rules.listed(kind, folder):
        os.makedirs(os.path.dirname(os.path.join(copy, path)), exist_ok=True)
        shutil.copy(os.path.join(folder, path), os.path.join(copy, path))
    return copy


# ------------------------------------------------------------------------------------------------------------- firmware


class Board:
    """A compiler whose work is kept, and qemu."""

    def __init__(self, work):
        self.work, self.kept, self.objects = work, os.path.join(work, "../../kept"), []

    def once(self, command):
        return must([sys.executable, os.path.join(HERE, "once.py"), self.kept, *command])

    def compile(self, source, flags):
        made = os.path.join(self.work, "%d.o" % len(self.objects))
        c = source.endswith(".c")
        language = ["-std=gnu11"] if c else [] if any(f.startswith("-std=") for f in flags) else ["-std=gnu++17"]
        said = self.once([CC if c else CXX, *BOARD, *([] if c else CORE), *language, *flags, "-c", source, "-o", made])
        check(said == "", "%s compiles without a warning %s" % (os.path.basename(source), said[:400]))
        self.objects.append(made)

    def link(self):
        self.compile(os.path.join(STANDIN, "start.c"), [])
        program = os.path.join(self.work, "program")
        must([CXX, *BOARD, *self.objects, "-o", program, *LINK])
        self.example(program)

    def example(self, program):
        if shutil.which("qemu-system-arm") is None:
            print("qemu-system-arm is not installed; the example is not run")
            return
        said = must(["timeout", "100", "qemu-system-arm", "-M", "mps2-an386", "-display", "none", "-monitor", "none",
                     "-serial", "none", "-semihosting-config", "enable=on,target=native", "-kernel", program])
        check(said == SAYS, "the example says: %s" % said.strip())


def expanded(command):
    """Words of a source behind the preprocessor, by the command that compiles it."""
    keep = [a for a in command if a not in ("-c", "-o") and not a.endswith((".o", ".obj"))]
    return must(keep + ["-E", "-P"]).split()


def compare_dimensions(kind, highest, command):
    """What a command compiles against the same with the macro itself."""
    reference = [a for a in command if not a.startswith("-DNETMESH_")] + [REFERENCE[highest]]
    check(expanded(command) == expanded(reference), "%s: the dimensions are 2 to %d" % (kind, highest))


def build_arduino(copy, work):
    """Flags of a core with C++17; sources below src, the library's and the sketch's folder on the path."""
    board = Board(work)
    paths = ["-I", os.path.join(STANDIN, "arduino"), "-I", os.path.join(copy, "src")]
    for source in rules.matching(copy, ["src/**/*.cpp", "src/**/*.c"]):
        board.compile(os.path.join(copy, source), paths)
    (sketch,) = rules.matching(copy, ["examples/*/*.ino"])
    made = os.path.join(work, "sketch.cpp")
    with open(made, "w", encoding="utf-8") as f:
        f.write('#include <Arduino.h>\n#line 1 "%s"\n%s' % (sketch, rules.read(copy, sketch)))
    board.compile(made, paths + ["-Wall", "-Wextra", "-I", os.path.dirname(os.path.join(copy, sketch))])
    board.compile(os.path.join(STANDIN, "arduino", "main.cpp"), paths)
    board.link()
    source = [CXX, *BOARD, "-std=gnu++17", os.path.join(copy, "src/netmesh.cpp")]
    compare_dimensions("as it is", 3, source)
    config = os.path.join(copy, "src/netmesh_config.h")
    text = rules.read(config)
    with open(config, "w", encoding="utf-8") as f:
        f.write(text.replace("#define NETMESH_DIMENSION_3 1", "#define NETMESH_DIMENSION_3 0"))
    compare_dimensions("netmesh_config.h", 2, source)
    status, said = run([CXX, *BOARD, "-std=gnu++11", "-fsyntax-only", os.path.join(copy, "src/netmesh.cpp")])
    first = re.search("error: .*", said)
    check(status != 0 and first and "C++17 is needed" in first.group(), "a core with C++11: %s" % first.group())


def build_platformio(copy, work):
    """Flags of a framework, without what build.unflags has, with build.flags; sources below srcDir."""
    board, build = Board(work), json.loads(rules.read(copy, "library.json"))["build"]
    framework = [flag for flag in CORE + ["-std=gnu++11", "-Wall", "-Werror"] if flag not in build["unflags"]]
    paths = ["-I", os.path.join(STANDIN, "arduino"), "-I", os.path.join(copy, build["includeDir"])]
    for source in rules.matching(copy, [build["srcDir"] + "/**/*.cpp", build["srcDir"] + "/**/*.c"]):
        board.compile(os.path.join(copy, source), framework + build["flags"] + paths)
    (sketch,) = rules.matching(copy, ["examples/*/*.ino"])
    made = os.path.join(work, "sketch.cpp")
    shutil.copy(os.path.join(copy, sketch), made)
    # The project's own files have the framework's flags alone.
    board.compile(made, CORE + ["-std=gnu++11", "-Wall"] + paths + ["-I", os.path.dirname(os.path.join(copy, sketch))])
    board.compile(os.path.join(STANDIN, "arduino", "main.cpp"), paths)
    board.link()
    source = [CXX, *BOARD, *framework, *build["flags"], os.path.join(copy, build["srcDir"], "netmesh.cpp")]
    compare_dimensions("as it is", 3, source)
    # README: build_flags of platformio.ini, which all libraries get.
    flags = re.search(r"build_flags = (.*)", rules.read(copy, "README.md")).group(1)
    check(expanded(source + shlex.split(flags.replace("-D ", "-D"))) ==
          expanded(source + ["-DNETMESH_EACH_DIMENSION(DO)=DO(2) DO(4)"]), "build_flags = %s" % flags)


def build_cmake(project, work, variables, target, highest=3, build=True):
    """The command that compiles netmesh.cpp; with `build` the program is made and run."""
    board = Board(work)
    folder = os.path.join(work, "build-%d" % highest)
    must(["cmake", "-S", project, "-B", folder, "-DCMAKE_TOOLCHAIN_FILE=" + os.path.join(STANDIN, "arm.cmake"),
          "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DPYTHON=" + sys.executable, "-DCMAKE_C_FLAGS=" + " ".join(BOARD),
          "-DCMAKE_CXX_FLAGS=" + " ".join(BOARD + CORE), "-DCMAKE_EXE_LINKER_FLAGS=" + " ".join(LINK),
          "-DCMAKE_CXX_COMPILER_LAUNCHER=%s;%s;%s" % (sys.executable, os.path.join(HERE, "once.py"), board.kept),
          *("-D%s=%s" % variable for variable in variables.items())])
    if build:
        must(["cmake", "--build", folder])
        board.example(os.path.join(folder, target))
    commands = json.loads(rules.read(folder, "compile_commands.json"))
    (command,) = [c["command"] for c in commands if c["file"].endswith("/netmesh.cpp")]
    words = shlex.split(command)
    return words[next(i for i, word in enumerate(words) if word.endswith(CXX)):]  # without the launcher


def without_third(work):
    path = os.path.join(work, "extra.conf")
    with open(path, "w", encoding="utf-8") as f:
        f.write("CONFIG_NETMESH_DIMENSION_3=n\n")
    return path


def build_espidf(copy, work):
    """The example, whose manifest names the component by its folder."""
    import yaml
    example = os.path.join(copy, "examples/loop")
    (needed,) = yaml.safe_load(rules.read(example, "main/idf_component.yml"))["dependencies"].items()
    component = os.path.normpath(os.path.join(example, "main", needed[1]["override_path"]))
    check(needed[0] == os.path.basename(component) and component == copy, "the example names %s" % component)
    os.environ["IDF_PATH"] = os.path.join(STANDIN, "espidf")
    variables = {"NETMESH_COMPONENT": component}
    command = build_cmake(example, work, variables, "program")
    compare_dimensions("as it is", 3, command)
    must([a for a in command if not a.startswith("-std=")] + ["-std=gnu++2b", "-fsyntax-only"])
    command = build_cmake(example, work, {**variables, "EXTRA_CONF_FILE": without_third(work)}, "", 2, False)
    compare_dimensions("menuconfig", 2, command)


def build_zephyr(copy, work):
    """The sample, with the module as scripts/zephyr_module.py finds it."""
    build = rules.module(copy)["build"]
    os.environ["ZEPHYR_BASE"] = os.path.join(STANDIN, "zephyr")
    variables = {"MODULE_CMAKE": os.path.join(copy, build["cmake"]),
                 "MODULE_KCONFIG": os.path.join(copy, build["kconfig"])}
    sample = os.path.join(copy, "samples/loop")
    command = build_cmake(sample, work, variables, "program")
    compare_dimensions("as it is", 3, command)
    command = build_cmake(sample, work, {**variables, "EXTRA_CONF_FILE": without_third(work)}, "", 2, False)
    compare_dimensions("Kconfig", 2, command)
    old = os.path.join(work, "old.conf")
    with open(old, "w", encoding="utf-8") as f:
        f.write("CONFIG_STD_CPP11=y\n")
    try:
        build_cmake(sample, work, {**variables, "EXTRA_CONF_FILE": old}, "", 2, False)
        check(False, "C++11 is refused by Kconfig")
    except Failed as failed:
        check("CONFIG_NETMESH is n, not y" in str(failed), "C++11 is refused by Kconfig")


def build_cmsis(copy, work):
    """Components of the description: files for configuration and templates go into the project, the others stay."""
    board, (_, root) = Board(work), rules.description(copy)
    project = os.path.join(work, "project")
    os.makedirs(os.path.join(project, "RTE"))
    paths, sources = [], []
    for file in root.iter("file"):
        path, attr = file.get("name"), file.get("attr")
        if attr is not None:
            place = os.path.join(project, "RTE" if attr == "config" else "", os.path.basename(path))
            shutil.copy(os.path.join(copy, path), place)
        else:
            place = os.path.join(copy, path)
        if file.get("category") == "source":
            sources.append(place)
        elif os.path.dirname(place) not in paths:
            paths.append(os.path.dirname(place))
    paths = [word for path in paths for word in ("-I", path)]
    for source in sources:
        board.compile(source, paths + ["-D_RTE_"])
    board.link()
    (source,) = [s for s in sources if s.endswith("netmesh.cpp")]
    command = [CXX, *BOARD, "-std=gnu++17", *paths, source]
    compare_dimensions("as it is", 3, command)
    config = os.path.join(project, "RTE/netmesh_config.h")
    text = rules.read(config)
    check(text.index("<<< Use Configuration Wizard in Context Menu >>>") < text.index("<q>"), "it is for the wizard")
    with open(config, "w", encoding="utf-8") as f:
        f.write(text.replace("#define NETMESH_DIMENSION_3 1", "#define NETMESH_DIMENSION_3 0"))
    compare_dimensions("the project's netmesh_config.h", 2, command)


# ------------------------------------------------------------------------------------------------------------- desktops


def build_vcpkg(copy, work):
    """The port's script, for the plane; what vcpkg looks at after a build; a program that follows `usage`."""
    port = lambda where, features, *more: must(
        ["cmake", "-DPORT_DIR=" + copy, "-DWORK=" + os.path.join(work, where), "-DFEATURES=" + features, *more,
         "-P", os.path.join(STANDIN, "vcpkg.cmake")])
    port("plane", "core")
    cache = lambda where: rules.read(work, where, "buildtrees/rel/CMakeCache.txt")
    check(re.search("^NETMESH_DIMENSIONS:.*=2$", cache("plane"), re.M), "netmesh[core] has the plane")
    said = json.loads(rules.read(copy, "vcpkg.json"))
    port("all", ",".join(["core"] + said["default-features"]), "-DCONFIGURE_ONLY=ON")
    check(re.search("^NETMESH_DIMENSIONS:.*=2,3,4,5,6$", cache("all"), re.M), "by default all dimensions")
    made = os.path.join(work, "plane/packages")
    have = rules.files_of(made)
    for path in ("share/netmesh/copyright", "share/netmesh/usage", "share/netmesh/netmesh-config.cmake",
                 "include/netmesh.h", "lib/libnetmesh.a"):
        check(path in have, "it leaves " + path)
    stray = [path for path in have if not path.startswith(("share/netmesh/", "include/netmesh", "lib/libnetmesh.a",
                                                           "lib/pkgconfig/"))]
    empty = [base for base, folders, names in os.walk(made) if not folders and not names]
    check(not stray and not empty, "and nothing elsewhere, no empty folder %s" % (stray + empty))
    check(filecmp.cmp(os.path.join(made, "share/netmesh/copyright"), os.path.join(ROOT, "LICENSE")), "its licence")
    client = os.path.join(work, "client")
    os.makedirs(client)
    for name in ("main.c", "loop.h"):
        shutil.copy(os.path.join(ROOT, "platform/packages", name), client)
    lines = [line.strip() for line in rules.read(made, "share/netmesh/usage").splitlines() if line.startswith("  ")]
    with open(os.path.join(client, "CMakeLists.txt"), "w", encoding="utf-8") as f:
        f.write("\n".join(["cmake_minimum_required(VERSION 3.16)", "project(main C)", lines[0],
                           "add_executable(main main.c)", *lines[1:], ""]))
    must(["cmake", "-S", client, "-B", client + "/build", "-DCMAKE_PREFIX_PATH=" + made])
    must(["cmake", "--build", client + "/build"])
    said = must([client + "/build/main"])
    check(said == SAYS, "a program that follows usage says: %s" % said.strip())


def build_conan(copy, work):
    """The recipe's methods in conan's order, for the plane and MinSizeRel; then those of test_package."""
    made = rules.recipe(os.path.join(copy, "conanfile.py"))
    sources = os.path.join(work, "sources")  # test_package is not exported
    shutil.copytree(copy, sources, ignore=shutil.ignore_patterns("test_package", "conanfile.py"))
    options = {name: False for name in made.options}
    recipe = made(os.path.join(work, "netmesh"), sources, options)
    for step in ("validate", "layout", "generate", "build", "package", "package_info"):
        getattr(recipe, step)()
    check(recipe.cache_variables["NETMESH_DIMENSIONS"] == "2", "without options it has the plane")
    whole = made(os.path.join(work, "whole"), sources)
    whole.layout()
    whole.generate()
    check(whole.cache_variables["NETMESH_DIMENSIONS"] == "2,3,4,5,6", "by default all dimensions")
    have = rules.files_of(recipe.package_folder)
    check("licenses/LICENSE" in have and "lib/libnetmesh.a" in have and "include/netmesh.h" in have, "it is packaged")
    test = rules.recipe(os.path.join(copy, "test_package/conanfile.py"))(
        os.path.join(work, "test"), os.path.join(copy, "test_package"), requirement=recipe)
    for step in ("requirements", "layout", "build"):
        getattr(test, step)()
    program = os.path.join(test.cpp.build.bindir, "loop")
    test.test()
    check(must([program]) == SAYS, "test_package says so, too")
    recipe.settings.compiler = "msvc"
    try:
        recipe.validate()
        check(False, "msvc is refused")
    except Exception as error:
        check(type(error).__name__ == "ConanInvalidConfiguration", "msvc is refused: %s" % error)


# --------------------------------------------------------------------------------------------------------------- checks


def check_kind(kind, work):
    folder = package(kind, os.path.join(work, "made", "netmesh"))
    found = rules.faults(kind, folder, expected())
    check(not found, "the manifest is one of %s %s" % (kind, "; ".join(found)))
    found = rules.faults(kind, package(kind, os.path.join(work, "published"), "--url", "https://example.org/netmesh"),
                         expected())
    check(not found, "with an address, too %s" % "; ".join(found))
    listed, there = set(rules.listed(kind, folder)), set(rules.files_of(folder))
    left = sorted(there - listed - ({"LICENSE", "README.md"} if kind == "zephyr" else set()))
    check(all(name.endswith(".pack") for name in left), "each file is listed %s" % " ".join(left))
    if kind == "cmsis":
        with zipfile.ZipFile(os.path.join(folder, left[0])) as archive:
            check(sorted(archive.namelist()) == sorted(listed), "%s holds what is listed" % left[0])
            check(left[0] == "netmesh.netmesh.%s.pack" % expected()["version"], "and has its name")
    copy = copy_listed(kind, folder, os.path.join(work, "copy", "netmesh"))
    os.makedirs(os.path.join(work, "build"))
    globals()["build_" + kind](copy, os.path.join(work, "build"))


def check_script(work):
    status, said = run([sys.executable, PACKAGE, "--help"])
    check(status == 0 and all(kind in said for kind in KINDS), "--help names all kinds")
    environment = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONHASHSEED": "11", "TZ": "Asia/Tokyo"}
    for kind in KINDS:
        first, second = package(kind, os.path.join(work, kind)), os.path.join(work, kind + "-again")
        must([sys.executable, PACKAGE, kind, os.path.basename(second)], cwd=work, env=environment)
        names = rules.files_of(first)
        same = names == rules.files_of(second) and filecmp.cmpfiles(first, second, names, shallow=False)[0] == names
        check(same, "%s: the same bytes from elsewhere" % kind)
        open_values = [n for n in names if not n.startswith(("engine/", "source/")) and not n.endswith(".pack")
                       and re.search("@[A-Z_]+@", rules.read(first, n))]
        check(not open_values, "%s: every value is filled in %s" % (kind, open_values))
    description = json.loads(rules.read(ROOT, "platform/packages/description.json"))
    for path in ("platform/python/pyproject.toml", "platform/wasm/npm/package.json"):
        check('"%s"' % description["summary"] in rules.read(ROOT, path), "%s has the same summary" % path)
    full, file = os.path.join(work, "arduino"), os.path.join(work, "file")
    open(file, "w", encoding="utf-8").close()
    for arguments, words in [(["arduino", full], "holds something"), (["arduino", file], "holds something"),
                             (["maven", "out"], "invalid choice"), (["arduino"], "required"),
                             (["arduino", "out", "--maintainer", "somebody"], "a maintainer is")]:
        status, said = run([sys.executable, PACKAGE, *arguments], cwd=work)
        check(status != 0 and words in said and "Traceback" not in said, "%s: %s" % (" ".join(arguments), words))
    check(not os.path.exists(os.path.join(work, "out")), "nothing is left behind by a failure")


# kind: (file, what stands there, what is put there, what is said); of manifests
PLANTS = {
    "arduino": [("library.properties", "version=", "version=9.", "version 9."),
                ("library.properties", "Data Processing", "Mathematics", "category: Mathematics"),
                ("library.properties", "includes=netmesh.h", "includes=mesh.h", "src/mesh.h is listed"),
                ("library.properties", "paragraph=", "paragraf=", "no field paragraf"),
                ("library.properties", "license=MIT", "license=BSD", "license BSD")],
    "platformio": [("library.json", '"version": "', '"version": "9.', "version 9."),
                   ("library.json", '"delaunay"', '"Delaunay"', "keyword: Delaunay"),
                   ("library.json", '"srcDir": "src"', '"srcDir": "sources"', "build.srcDir is no folder"),
                   ("library.json", "src/netmesh.h", "src/mesh.h", "src/mesh.h is listed"),
                   ("library.json", '"flags"', '"flag"', "no field flag")],
    "espidf": [("idf_component.yml", 'version: "', 'version: "9.', "version 9."),
               ("idf_component.yml", '"persistent-homology"', '"persistent homology"', "tag: persistent homology"),
               ("idf_component.yml", ">=5.0", "five", "dependency: idf five"),
               ("idf_component.yml", "src/netmesh.h", "src/mesh.h", "src/mesh.h is listed"),
               ("idf_component.yml", "license:", "licence:", "no field licence")],
    "zephyr": [("zephyr/module.yml", "kconfig: zephyr/Kconfig", "kconfig: Kconfig", "Kconfig is listed"),
               ("zephyr/module.yml", "samples:", "sample:", "no field sample"),
               ("zephyr/module.yml", "name: netmesh", "name: mesh", "name mesh")],
    "cmsis": [("netmesh.netmesh.pdsc", 'Cversion="', 'Cversion="9.', "version 9."),
              ("netmesh.netmesh.pdsc", 'category="source" language="cpp"', 'category="code"', "'category': 'code'"),
              ("netmesh.netmesh.pdsc", "src/netmesh.cpp", "src/mesh.cpp", "src/mesh.cpp is listed"),
              ("netmesh.netmesh.pdsc", "config/netmesh_config.h", "src/netmesh_config.h", "is on the include path"),
              ("netmesh.netmesh.pdsc", "<vendor>netmesh", "<vendor>mesh", "is of mesh, netmesh")],
    "vcpkg": [("vcpkg.json", '"version-semver": "', '"version-semver": "9.', "version 9."),
              ("vcpkg.json", '"dimension-3": {', '"Dimension_3": {', "feature: Dimension_3"),
              ("vcpkg.json", '"supports"', '"support"', "no field support")],
    "conan": [("conanfile.py", 'version = "', 'version = "9.', "version 9."),
              ("conanfile.py", '"static-library"', '"archive"', "package_type: archive"),
              ("conanfile.py", "'engine/*'", "'engines/*'", "nothing is engines/*"),
              ("conanfile.py", "exports_sources", "export_sources", "no field export_sources")],
}
# kind: (file, what is taken out of it, a part of what the build then says): files that a list leaves out
OMITTED = {
    "platformio": ("library.json", '"src/netmesh.h", ', "netmesh.h: No such file"),
    "espidf": ("idf_component.yml", '"src/netmesh.cpp", ', "netmesh.cpp"),
    "cmsis": ("netmesh.netmesh.pdsc", '<file category="header" name="src/netmesh.h"/>', "netmesh.h: No such file"),
    "zephyr": ("zephyr/CMakeLists.txt", "zephyr_include_directories(../src)", "netmesh.h: No such file"),
    "conan": ("conanfile.py", "'engine/*', ", "engine"),
}


def exchange(path, old, new):
    text = rules.read(path)
    if old not in text:
        raise Failed("%s does not have %s" % (path, old))
    with open(path, "w", encoding="utf-8") as f:
        f.write(text.replace(old, new, 1))


def check_planted(work):
    for kind, plants in PLANTS.items():
        folder = package(kind, os.path.join(work, kind, "netmesh"))
        for name, old, new, words in plants:
            path = os.path.join(folder, name)
            before = rules.read(path)
            exchange(path, old, new)
            found = "; ".join(rules.faults(kind, folder, expected()))
            check(words in found, "%s: %s: %s" % (kind, new, found[:120]))
            with open(path, "w", encoding="utf-8") as f:
                f.write(before)
        if kind in OMITTED:
            name, old, words = OMITTED[kind]
            exchange(os.path.join(folder, name), old, "")
            copy = copy_listed(kind, folder, os.path.join(work, kind, "copy", "netmesh"))
            os.makedirs(os.path.join(work, kind, "build"))
            try:
                globals()["build_" + kind](copy, os.path.join(work, kind, "build"))
                check(False, "%s: a build without what %s listed ends well" % (kind, name))
            except (Failed, RuntimeError, ValueError) as failed:
                check(words in str(failed), "%s: without %s the build ends: %s" %
                      (kind, old, str(failed).strip()[-100:].replace("\n", " ")))
    # The description itself, in a copy of the project.
    project = os.path.join(work, "project")
    for part in ("engine", "platform/packages", "tools/amalgamate", "tools/package", "LICENSE", "CMakeLists.txt",
                 "CHANGELOG.md"):
        source, target = os.path.join(ROOT, part), os.path.join(project, part)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        (shutil.copytree if os.path.isdir(source) else shutil.copy)(source, target)
    script, home = os.path.join(project, "tools/package"), os.path.join(project, "platform/packages")
    for path, old, new, words in [
            (home + "/description.json", '"loop.ino"', '"lost.ino"', "names lost.ino, which is not there"),
            (home + "/arduino/library.properties.in", "@VERSION@", "@EDITION@", "@EDITION@, which is no value")]:
        before = rules.read(path)
        exchange(path, old, new)
        status, said = run([sys.executable, script, "arduino", os.path.join(work, "none")])
        check(status == 1 and words in said and not os.path.exists(os.path.join(work, "none")), said.strip())
        with open(path, "w", encoding="utf-8") as f:
            f.write(before)


def missing(what):
    """What a check needs and this machine does not have."""
    kinds = KINDS if what == "planted" else (what,)
    if set(kinds) & set(FIRMWARE):
        for program in (CXX, CC):
            if shutil.which(program) is None:
                return program
        if subprocess.run([CC, "-E", "-x", "c", "-", "-o", os.devnull], input=b"#include <stdio.h>\n",
                          stderr=subprocess.DEVNULL).returncode != 0:
            return "newlib for " + CC
    for module, users in (("yaml", ("espidf", "zephyr")), ("kconfiglib", ("espidf", "zephyr"))):
        if set(kinds) & set(users):
            try:
                __import__(module)
            except ImportError:
                return "python3-" + module
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("script", "planted") + KINDS)
    parser.add_argument("--work", required=True)
    options = parser.parse_args()
    work = os.path.abspath(options.work)
    lack = missing(options.what)
    if lack:
        print("SKIPPED: %s is not installed" % lack)
        return 0
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    try:
        if options.what in KINDS:
            check_kind(options.what, work)
        else:
            {"script": check_script, "planted": check_planted}[options.what](work)
    except Failed as failed:
        check(False, str(failed))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
