#!/usr/bin/env python3
"""Shows that a check can fail: builds one planted fault and demands that the check names it.

  planted.py CHECK FAULT --cxx g++ --engine engine --work DIR --flags "..." [--ld ld --objcopy objcopy --ld-flags "..."]
"""
import argparse
import os
import shlex
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))

# fault: (the check, words that its output must hold, extra compiler flags)
ARCHIVE = {
    "clean": (None, ""),
    "heap": ("undefined symbols beyond memcmp memcpy memmove memset: malloc", ""),
    "mutable_data": ("FAULT mutable data: .data", ""),
    "zeroed_data": ("FAULT mutable data: .bss", ""),
    "constructor": ("FAULT mutable data: .", ""),
    "fused": ("FAULT fused or x87 instructions: vfmadd", "-O2 -mfma -ffp-contract=fast"),
    "extended": ("FAULT fused or x87 instructions: f", ""),
    "special_section": ("FAULT sections of an unexpected kind: .at_my_place", ""),
    "thread_local": ("FAULT mutable data: .tbss", ""),
    "library": ("undefined symbols beyond memcmp memcpy memmove memset: sin", ""),
    "extra_global": ("FAULT global symbols that are not netmesh_*: _ZN7netmesh5innerEd", ""),
}
STACK = {
    "clean": (None, ""),
    "recursion": ("FAULT recursion: ", "-O1"),
    "dynamic_frame": ("FAULT frame of double netmesh_dynamic_frame", ""),
    "deep_stack": ("FAULT netmesh_deep_stack needs 40", ""),
    "indirect": ("FAULT indirect call in double netmesh_indirect", ""),
}
SIZE = {
    "clean": (None, ""),
    "large": ("FAULT 3", ""),
    "left_over": (None, ""),  # large, but no object of the build
}
# fault: (words of the compiler, flags)
COMPILE = {
    "clean": (None, ""),
    "fast_math": ("without -ffast-math", "-ffast-math"),
    "finite_math": ("without -ffast-math", "-ffinite-math-only"),
}
# fault: (file, its text, words)
INCLUDES = {
    "clean": ("mesh/good.hpp", '#include "delaunay/kernel.hpp"\n#include <cstdint>\n', None),
    "header": ("mesh/bad.hpp", "#include <vector>\n", "mesh/bad.hpp:1: <vector> is not on the allow-list"),
    "floor": ("delaunay/bad.cpp", '// up\n#include "mesh/mesh.hpp"\n',
              "delaunay/bad.cpp:2: delaunay does not see mesh/mesh.hpp"),
    "geometry": ("homology/bad.cpp", '#include "../delaunay/kernel.hpp"\n',
                 "homology does not see delaunay/kernel.hpp"),
    "outside": ("api/bad.cpp", '#include "../../platform/clock.hpp"\n', "api does not see ../platform/clock.hpp"),
    "source": ("mesh/bad.cpp", '#include "mesh/mesh.cpp"\n', "mesh/bad.cpp:1: mesh/mesh.cpp is a source, not a header"),
    "macro": ("api/bad.cpp", "#define KERNEL <cmath>\n#include KERNEL\n", "api/bad.cpp:2: include by macro"),
    "public": ("include/netmesh/bad.h", "#include <stdlib.h>\n",
               "include/netmesh/bad.h:1: <stdlib.h> is not on the allow-list"),
}


def check(*arguments):
    done = subprocess.run([sys.executable, os.path.join(HERE, "check.py")] + list(arguments),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    return done.returncode, done.stdout


def compiler(options, flags):
    return ([options.cxx] + shlex.split(options.flags) + ["-std=c++17", "-I", options.engine] + shlex.split(flags))


def compile_fault(options, fault, flags, out):
    source = os.path.join(HERE, "planted", fault + ".cpp")
    subprocess.check_call(compiler(options, flags) + ["-c", source, "-o", out])


def plant_archive(options, fault):
    words, flags = ARCHIVE[fault]
    out = os.path.join(options.work, fault + ".o")
    compile_fault(options, fault, flags or "-O2", out)
    if options.objcopy and fault != "extra_global":
        subprocess.check_call([options.ld] + shlex.split(options.ld_flags) + ["-o", out + ".tmp", out])
        subprocess.check_call([options.objcopy, "-w", "--keep-global-symbol=netmesh_*", out + ".tmp", out])
    archive = os.path.join(options.work, fault + ".a")
    if os.path.exists(archive):
        os.remove(archive)
    subprocess.check_call([options.ar, "qc", archive, out])
    plain = [] if options.objcopy or fault == "extra_global" else ["--plain"]
    return words, check("archive", "--archive", archive, *plain)


def plant_stack(options, fault):
    words, flags = STACK[fault]
    compile_fault(options, fault, (flags or "-O2") + " -fstack-usage -fcallgraph-info=su,da",
                  os.path.join(options.work, fault + ".cpp.o"))
    return words, check("stack", "--records", options.work)


def plant_size(options, fault):
    words, flags = SIZE[fault]
    records = ["--records", options.work]
    if fault == "left_over":
        for part in ("large", "clean"):
            compile_fault(options, part, flags or "-O2", os.path.join(options.work, part + ".cpp.o"))
        objects = os.path.join(options.work, "objects.txt")
        with open(objects, "w", encoding="utf-8") as f:
            f.write(os.path.join(options.work, "clean.cpp.o") + "\n")
        return words, check("size", *records, "--objects", objects)
    compile_fault(options, fault, flags or "-O2", os.path.join(options.work, fault + ".cpp.o"))
    return words, check("size", *records)


def plant_compile(options, fault):
    words, flags = COMPILE[fault]
    source = os.path.join(options.work, "arithmetic.cpp")
    with open(source, "w", encoding="utf-8") as f:
        f.write('#include "numerics/real.hpp"\n')
    done = subprocess.run(compiler(options, flags) + ["-fsyntax-only", source], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True)
    return words, (done.returncode, done.stdout)


def plant_includes(options, fault):
    path, text, words = INCLUDES[fault]
    for name in ("delaunay/kernel.hpp", "mesh/mesh.hpp", "mesh/mesh.cpp", path):
        full = os.path.join(options.work, "engine", name)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, "w", encoding="utf-8") as f:
            f.write(text if name == path else "")
    os.makedirs(os.path.join(options.work, "platform"))
    with open(os.path.join(options.work, "platform", "clock.hpp"), "w", encoding="utf-8"):
        pass
    return words, check("includes", "--engine", os.path.join(options.work, "engine"))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("check", choices=["archive", "stack", "includes", "size", "compile"])
    parser.add_argument("fault")
    parser.add_argument("--work", required=True)
    parser.add_argument("--engine")
    parser.add_argument("--cxx", default="g++")
    parser.add_argument("--flags", default="")
    parser.add_argument("--ar", default="ar")
    parser.add_argument("--ld", default="ld")
    parser.add_argument("--ld-flags", default="-r")
    parser.add_argument("--objcopy", default="")
    options = parser.parse_args()
    shutil.rmtree(options.work, ignore_errors=True)
    os.makedirs(options.work)
    plant = {"archive": plant_archive, "stack": plant_stack, "includes": plant_includes, "size": plant_size,
             "compile": plant_compile}[options.check]
    words, (code, output) = plant(options, options.fault)
    print(output, end="")
    if words is None:
        if code == 0 and "FAULT" not in output:
            return 0
        print("the check sees a fault where there is none")
        return 1
    if code != 0 and words in output:
        return 0
    print('the check did not fail with "%s"' % words)
    return 1


if __name__ == "__main__":
    sys.exit(main())
