#!/usr/bin/env python3
"""What each job takes on a board and on a PC: flash, block, stack and instructions, measured.

    footprint.py WORK [--jobs N] [D ...]      prints the table of tools/docs/small-parts.md; D: 2, 3, 4
    footprint.py WORK --kinds                 the one by kinds of points

Engine in two files, one dimension, -Os for a Cortex-M3 in qemu and -O2 for x86-64 under callgrind. Flash: text,
constants and initialised data of a program with the job above those of one without. Block: report.memory.peak_bytes.
Stack: what netmesh/job.h promises for the job, whatever the points are, which tests/stack and archive.jobs hold it to;
more than that, measured here on uniform points, is an error. Instructions: all that are executed from the points on
until the result is read, those of the compiler's routines for doubles too; on the board in steps of 40."""
import argparse
import concurrent.futures
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "tests", "archive"))
import check  # noqa: E402

BOARD = os.path.join(ROOT, "platform/cortexm")
SWITCHES = "CERTIFICATE SIZES AUDITS"
# Name, JOB of footprint.c, points by D, switches that the job leaves on, name of its stack in netmesh/job.h.
JOBS = [
    ("Delaunay", 1, {2: 500, 3: 500, 4: 50}, "", "DELAUNAY"),
    ("alpha diagram (`alpha_small`)", 2, {2: 500, 3: 500, 4: 50}, "", "ALPHA"),
    ("certified diagram, ratio 2.25", 4, {2: 500, 3: 200, 4: 50}, "CERTIFICATE", "CERTIFIED"),
    ("certified diagram of a quality mesh", 3, {2: 500, 3: 200, 4: 50}, "", "CERTIFIED"),
    ("Rips diagram (`rips_small`), degrees 0 and 1", 5, {2: 100, 3: 100, 4: 100}, "", "RIPS_SMALL"),
]
KINDS = ["uniform", "rounded to .01", "grid of tenths", "worst case"]
KIND_POINTS = {2: 500, 3: 100}
NOTHING = 0
CALLER = 1024  # bytes of the stack that footprint.c itself and the start of a program take at most
SECTIONS = ["-ffunction-sections", "-fdata-sections"]
CORE = ["-mthumb", "-mcpu=cortex-m3"]
TARGETS = {
    "board": (["arm-none-eabi-gcc"], ["arm-none-eabi-g++"], ["-Os", *CORE, *SECTIONS], "arm-none-eabi-size"),
    "host": (["gcc"], ["g++"], ["-O2", *SECTIONS], "size"),
}
NM = {"board": "arm-none-eabi-nm", "host": "nm"}


def run(*command, cwd):
    done = subprocess.run(command, cwd=cwd, text=True, capture_output=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def off(left_on):
    return [s for s in SWITCHES.split() if s not in left_on.split()]


def build_engine(work, target, dim, left_on):
    """The object of the engine for one dimension without the switches that a job leaves off."""
    out = os.path.join(work, f"{target}-{dim}-{left_on or 'least'}.o")
    flags = [f"-DNETMESH_WITH_{switch}=0" for switch in off(left_on)]
    run(*TARGETS[target][1], "-std=c++17", *TARGETS[target][2], f"-DNETMESH_EACH_DIMENSION(DO)=DO({dim})", *flags, "-c",
        "netmesh.cpp", "-o", out, cwd=work)
    return out


def build_board(work):
    """What every program for the board is linked with."""
    flags = [*TARGETS["board"][2], "-std=c++17", "-ffreestanding", "-fno-exceptions", "-fno-rtti",
             "-fno-threadsafe-statics", "-fno-tree-loop-distribute-patterns", "-I", BOARD, "-I",
             os.path.join(ROOT, "tests")]
    for source in (f"{BOARD}/start.cpp", f"{BOARD}/runtime.cpp", f"{HERE}/footprint_board.cpp"):
        run("arm-none-eabi-g++", *flags, "-c", source, cwd=work)


def link(work, target, dim, engine, job, points, report, kind=0):
    """A program with one job; 0: with none."""
    cc, _, flags, _ = TARGETS[target]
    name = f"{target}-{dim}-{job}-{report}-{kind}"
    run(*cc, "-std=c11", *flags, f"-DDIM={dim}", f"-DJOB={job}", f"-DPOINTS={points}", f"-DREPORT={report}",
        f"-DKIND={kind}", "-I", ".", "-c", f"{HERE}/footprint.c", "-o", f"{name}-job.o", cwd=work)
    objects = [f"{name}-job.o", *([engine] if job != NOTHING else [])]
    if target == "board":
        run(*cc, *CORE, *objects, "footprint_board.o", "start.o", "runtime.o", "-nostartfiles", "-nodefaultlibs", "-T",
            f"{BOARD}/link.ld", "-Wl,--gc-sections", "-lgcc", "-o", name, cwd=work)
    else:
        run(*cc, *flags, "-static", "-pthread", "-DBLOCK=(16<<20)", f"{HERE}/footprint_host.c", *objects,
            "-Wl,--gc-sections", "-o", name, cwd=work)
    return name


def flash_of(work, target, program):
    text, data = run(TARGETS[target][3], program, cwd=work).splitlines()[1].split()[:2]
    return int(text) + int(data)


def measure(work, target, program):
    """Block, stack, instructions."""
    if target == "board":
        said = run("qemu-system-arm", "-M", "mps2-an385", "-icount", "shift=0", "-display", "none", "-monitor", "none",
                   "-serial", "none", "-semihosting-config", "enable=on,target=native", "-kernel", program, cwd=work)
        return [int(n) for n in said.split()]
    block, stack = run(f"./{program}", cwd=work).split()
    said = run("valgrind", "--tool=callgrind", f"--callgrind-out-file={program}.callgrind",
               "--toggle-collect=footprint_job", f"./{program}", cwd=work)
    return [int(block), int(stack), int(re.search(r"Collected : (\d+)", said)[1])]


def rows_of(work, target, dim, left_on, nothing):
    """By job: flash, block, stack, instructions, with the engine that these jobs need."""
    engine = build_engine(work, target, dim, left_on)
    found = {}
    promised = check.promised(argparse.Namespace(cc=" ".join(TARGETS[target][0] + TARGETS[target][2]), nm=NM[target],
                                                 include=work), [dim])
    for name, job, points, on, stack_of in JOBS:
        if on != left_on:
            continue
        flash = flash_of(work, target, link(work, target, dim, engine, job, points[dim], 0))
        block, stack, count = measure(work, target, link(work, target, dim, engine, job, points[dim], 1))
        if stack > promised[stack_of, dim] + CALLER:
            raise RuntimeError(f"{name} in dimension {dim} takes {stack} bytes of stack")
        found[name] = [flash - nothing, block, promised[stack_of, dim], count]
    return found


def millions(count):
    return f"{count / 1e6:,.0f} M" if count >= 9.95e6 else f"{count / 1e6:.1f} M"


def measured(work, dims, jobs):
    """Lines of the table."""
    os.makedirs(work, exist_ok=True)
    run(sys.executable, os.path.join(ROOT, "tools/amalgamate"), work, cwd=work)
    build_board(work)
    tasks = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for dim in dims:
            for target in TARGETS:
                nothing = flash_of(work, target, link(work, target, dim, None, NOTHING, 1, 0))
                for left_on in sorted({job[3] for job in JOBS}):
                    tasks[dim, target, left_on] = pool.submit(rows_of, work, target, dim, left_on, nothing)
    columns = "flash | block | stack | instructions |"
    lines = [f"| job | D | points | {columns} x86-64: {columns}", "|---|" + "---:|" * 10]
    for name, _, points, left_on, _ in JOBS:
        for dim in dims:
            cells = []
            for target in TARGETS:
                flash, block, stack, instructions = tasks[dim, target, left_on].result()[name]
                cells += [f"{flash:,}", f"{block:,}", f"{stack:,}", millions(instructions)]
            shown = name + " (`delaunay_small`)" * ((name, dim) == ("Delaunay", 2))
            lines.append(f"| {shown} | {dim} | {points[dim]:,} | " + " | ".join(cells) + " |")
    return lines


def by_kinds(work):
    """Lines of the table by kinds of points, on the board."""
    os.makedirs(work, exist_ok=True)
    run(sys.executable, os.path.join(ROOT, "tools/amalgamate"), work, cwd=work)
    build_board(work)
    lines = ["| job | D | points | " + " | ".join(KINDS) + " |", "|---|" + "---:|" * (2 + len(KINDS))]
    engines = {dim: build_engine(work, "board", dim, "") for dim in KIND_POINTS}
    for name, job, *_ in JOBS[:2]:
        for dim, points in KIND_POINTS.items():
            counts = [measure(work, "board", link(work, "board", dim, engines[dim], job, points, 1, kind))[2]
                      for kind in range(len(KINDS))]
            lines.append(f"| {name} | {dim} | {points} | " + " | ".join(millions(count) for count in counts) + " |")
    return lines


def main():
    arguments = sys.argv[1:]
    if len(arguments) == 2 and arguments[1] == "--kinds":
        print("\n".join(by_kinds(os.path.abspath(arguments[0]))))
        return
    jobs = os.cpu_count() or 1
    if "--jobs" in arguments:
        at = arguments.index("--jobs")
        jobs = int(arguments[at + 1])
        del arguments[at:at + 2]
    if not arguments:
        sys.exit(__doc__)
    print("\n".join(measured(os.path.abspath(arguments[0]), [int(d) for d in arguments[1:]] or [2, 3, 4], jobs)))


if __name__ == "__main__":
    main()
