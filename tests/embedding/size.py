#!/usr/bin/env python3
"""What the smallest programs take: text and constants above those of an empty program, at -Os on this machine. And
what the whole archive takes, all dimensions, all calls.

    size.py SOURCE WORK CC CXX           build, run, and compare with the limits below
    size.py SOURCE WORK CC CXX --table   the same as a table

Where size counts some ways of computing are shorter: the build of D = 2 and 3 has to print the golden fingerprints.
"""
import os
import subprocess
import sys

# Source, flags, what it prints.
PROGRAMS = {"delaunay": ("delaunay", [], "5"), "alpha_small": ("alpha", ["-DFILTER=netmesh_filter_alpha_small"], "10"),
            "planned": ("alpha", ["-DFILTER=netmesh_filter_alpha_small", "-DPLANS"], "10"),
            "alpha": ("alpha", [], "10"), "persist": ("persist", [], "6")}
# What a program that persists a quality mesh by the complete filter has no use for and names no object of.
WITHOUT = "certificate;sizes;audits"
FINGERPRINTS = "D = 2 and 3"
# Bytes at most, of g++ 12 on x86-64: what was measured, and no more than a fiftieth above. In the plane alpha has two
# widths of words, and lists of simplices for what asks for more than a diagram; alpha_small has one of the three.
# Planned: that and netmesh_plan, which leads to none of the filters that it plans for.
BUILDS = {
    "D = 2": (["-DNETMESH_DIMENSIONS=2"],
              {"delaunay": 22950, "alpha_small": 35700, "planned": 44900, "alpha": 53400, "persist": 121000}),
    "D = 2, least": (["-DNETMESH_DIMENSIONS=2", f"-DNETMESH_WITHOUT={WITHOUT}"],
                     {"delaunay": 22950, "alpha_small": 35700, "planned": 44900, "alpha": 53400, "persist": 67600}),
    FINGERPRINTS: (["-DNETMESH_DIMENSIONS=2;3"],
                   {"delaunay": 35400, "alpha_small": 60300, "planned": 72000, "alpha": 71000, "persist": 140700}),
    "D = 2 and 3, least": (["-DNETMESH_DIMENSIONS=2;3", f"-DNETMESH_WITHOUT={WITHOUT}"],
                           {"delaunay": 35400, "alpha_small": 60300, "planned": 72000, "alpha": 71000,
                            "persist": 96000}),
}
WHOLE = 776_000


def run(*command):
    done = subprocess.run(command, text=True, capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def text_of(program):
    """Text and constants, as `size` adds them up."""
    return int(run("size", program).splitlines()[1].split()[0])


def build_archive(source, build, cc, cxx, settings):
    run("cmake", "-S", source, "-B", build, "-DCMAKE_BUILD_TYPE=MinSizeRel", "-DNETMESH_BUILD_TOOLS=OFF",
        "-DNETMESH_BUILD_TESTS=OFF", "-DNETMESH_INSTALL=OFF", "-DNETMESH_BUILD_FUZZ=OFF",
        f"-DCMAKE_CXX_COMPILER={cxx}", f"-DCMAKE_C_COMPILER={cc}", *settings)
    run("cmake", "--build", build, "-j", str(os.cpu_count()))


def prints_fingerprints(source, build, cxx):
    """Those of D = 2 and 3."""
    here, program = os.path.join(source, "tests/determinism"), os.path.join(build, "fingerprints")
    run(cxx, "-std=c++17", "-O1", "-ffp-contract=off", "-I", os.path.join(source, "tests"), "-I",
        os.path.join(source, "engine/include"), os.path.join(here, "fingerprints.cpp"),
        os.path.join(build, "libnetmesh.a"), "-o", program)
    done = subprocess.run(["sh", os.path.join(here, "compare"), program,
                           os.path.join(source, "tests/golden/fingerprints.txt"), "2", "3"],
                          text=True, capture_output=True, check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
    return done.returncode == 0


def main():
    source, work, cc, cxx = sys.argv[1:5]
    os.makedirs(work, exist_ok=True)
    here = os.path.join(source, "tests/embedding")
    link = ["-std=c11", "-Os", "-static", "-ffunction-sections", "-Wl,--gc-sections"]

    def text_of_source(file, *more):
        program = os.path.join(work, os.path.basename(file)[:-2])
        run(cc, *link, "-I", os.path.join(source, "engine/include"), file, *more, "-o", program)
        return text_of(program), run(program).strip()

    empty = os.path.join(work, "empty.c")
    with open(empty, "w", encoding="utf-8") as file:
        file.write('#include <stdio.h>\nint main(void) {\n    printf("%u\\n", 0u);\n    return 0;\n}\n')
    nothing = text_of_source(empty)[0]
    failed, rows = False, []
    for name, (settings, limits) in BUILDS.items():
        build = os.path.join(work, name.replace(" ", "").replace(",", "-").replace("=", ""))
        build_archive(source, build, cc, cxx, settings)
        row = []
        for program, (file, flags, printed) in PROGRAMS.items():
            text, said = text_of_source(f"{here}/size_{file}.c", os.path.join(build, "libnetmesh.a"), *flags)
            row.append(f"{text - nothing:,}")
            if said != printed:
                failed = True
                print(f"{name}: {program} prints {said} for {printed}")
            if text - nothing > limits[program]:
                failed = True
                print(f"{name}: {program} takes {text - nothing:,} bytes, above {limits[program]:,}")
        rows.append((name, *row))
        if name == FINGERPRINTS:
            failed = not prints_fingerprints(source, build, cxx) or failed
    if "--table" in sys.argv:
        print("| build | " + " | ".join(PROGRAMS) + " |")
        print("|---|" + "---:|" * len(PROGRAMS))
    else:
        whole = os.path.join(work, "whole")
        build_archive(source, whole, cc, cxx, [])
        text = text_of(os.path.join(whole, "libnetmesh.a"))
        print(f"the whole archive: {text:,} bytes")
        if text > WHOLE:
            failed = True
            print(f"above {WHOLE:,}")
    for row in rows:
        print("| " + " | ".join(row) + " |" if "--table" in sys.argv else "   ".join(row))
    return failed


sys.exit(main())
