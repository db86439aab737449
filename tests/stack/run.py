#!/usr/bin/env python3
"""Stack of the documented jobs on Cortex-M: no chain of calls, and none that runs, takes more than netmesh/job.h says.

    run.py [--build DIR] [--clouds N] [--seed S] [--dims 2,3,2+3] [--planted] [--jobs N] [CORE ...]

For each core of platform/cortexm/cores.txt and each library, of one dimension or, as 2+3, of several: the engine as two
files for its dimensions alone, -Os, without a warning. The object and its call graph go through
tests/archive/check.py, its jobs through board.cpp in qemu, on N clouds of nine kinds each, on stacks of the promised
size with a guard below. Clouds have the first dimension of a library, the promise is that of the last. Results have to
be those of this machine, to the bit. --planted: and once more with half of the stack, which has to be seen for each
job. The whole: run.py --clouds 500 --dims 2,3,4,2+3."""
import argparse
import concurrent.futures
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
BOARD = os.path.join(ROOT, "platform", "cortexm")
CHECK = os.path.join(ROOT, "tests", "archive", "check.py")
PROGRAM_FLAGS = ["-std=c++17", "-Os", "-ffreestanding", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
                 "-fno-tree-loop-distribute-patterns", "-ffp-contract=off", "-Wall", "-Wextra"]
JOBS = ["delaunay", "alpha", "certified", "rips"]
PLANTED_PERCENT, PLANTED_CLOUDS = 50, 9


def cores():
    """{core: (board, flags, flags of the linker)}, out of platform/cortexm/cores.txt."""
    found = {}
    with open(os.path.join(BOARD, "cores.txt"), encoding="utf-8") as f:
        for line in f:
            if line.strip() and not line.startswith("#"):
                core, board, *flags = line.split()
                found[core] = (board, ["-mthumb"] + [w for w in flags if not w.startswith("-Wl,")],
                               [w for w in flags if w.startswith("-Wl,")])
    return found


def run(command, cwd):
    done = subprocess.run(command, cwd=cwd, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode, done.stdout


def must(command, cwd):
    code, said = run(command, cwd)
    if code != 0:
        raise RuntimeError(" ".join(command) + "\n" + said)
    return said


def build_engine(work, core, dims):
    """The engine for one core and some dimensions with its call graph, in a folder of its own."""
    folder = os.path.join(work, "%s-%s" % (core, "+".join(map(str, dims))))
    os.makedirs(folder, exist_ok=True)
    must([sys.executable, os.path.join(ROOT, "tools", "amalgamate"), folder], folder)
    said = must(["arm-none-eabi-g++", "-std=c++17", "-Os", *cores()[core][1], "-ffunction-sections", "-fdata-sections",
                 "-DNETMESH_EACH_DIMENSION(DO)=" + " ".join("DO(%d)" % dim for dim in dims), "-fstack-usage",
                 "-fcallgraph-info=su,da", "-c", "netmesh.cpp", "-o", "netmesh.o"], folder)
    if said:
        raise RuntimeError("it does not compile without a warning:\n" + said)
    return folder


def check_object(folder):
    """What the object asks for and holds is what an archive may (tests/amalgamation does it for other processors)."""
    must(["arm-none-eabi-ar", "rcs", "libnetmesh.a", "netmesh.o"], folder)
    return run([sys.executable, CHECK, "archive", "--archive", "libnetmesh.a", "--tables", "--helpers",
                *("--%s=arm-none-eabi-%s" % (name, name) for name in ("nm", "objdump", "readelf", "ld"))], folder)


def check_options(folder, core, dims):
    """Options of check.py jobs for an engine that build_engine has built."""
    return ["--records", folder, "--source", os.path.join(folder, "netmesh.cpp"), "--helpers", "--readelf",
            "arm-none-eabi-readelf", "--nm", "arm-none-eabi-nm", "--include", folder, "--dims",
            ",".join(map(str, dims)), "--promise-of", str(dims[-1]), "--processor", "arm",
            "--cc", " ".join(["arm-none-eabi-gcc", *cores()[core][1]])]


def run_clouds(folder, core, dims, clouds, seed, percent):
    """Exit code and words of board.cpp, with so much of the promised stack."""
    board, flags, link = cores()[core]
    sources = [(HERE, "board"), (BOARD, "start"), (BOARD, "runtime")]
    values = ["-DDIM=%d" % dims[0], "-DPROMISE=%d" % dims[-1], "-DCLOUDS=%d" % clouds, "-DSEED=%d" % seed,
              "-DPERCENT=%d" % percent]
    for place, name in sources:
        must(["arm-none-eabi-g++", *PROGRAM_FLAGS, *flags, *values, "-I", ".", "-I", BOARD, "-I",
              os.path.join(ROOT, "tests"), "-c", os.path.join(place, name + ".cpp"), "-o", name + ".o"], folder)
    must(["arm-none-eabi-gcc", *flags, *(name + ".o" for _, name in sources), "netmesh.o", "-nostartfiles",
          "-nodefaultlibs", "-T", os.path.join(BOARD, "link.ld"), *link, "-Wl,--gc-sections", "-lgcc", "-o",
          "clouds.elf"], folder)
    return run(["qemu-system-arm", "-M", board, "-display", "none", "-monitor", "none", "-serial", "none",
                "-semihosting-config", "enable=on,target=native", "-kernel", "clouds.elf"], folder)


def results_of(text):
    """{(job, cloud, points): (status, fingerprint)}, and the other lines."""
    found, other = {}, []
    for line in text.splitlines():
        if line.startswith("= "):
            job, cloud, points, *rest = line[2:].split()
            found[job, cloud, points] = rest
        else:
            other.append(line)
    return found, other


def results_here(work, dim, clouds, seed):
    """What board.cpp prints on this machine, by g++ -O0, which compiles in a quarter of the time."""
    folder = os.path.join(work, "host-%d-%d-%d" % (dim, clouds, seed))
    os.makedirs(folder, exist_ok=True)
    must([sys.executable, os.path.join(ROOT, "tools", "amalgamate"), folder], folder)
    compiler = ["g++", "-std=c++17", "-O0"]
    values = ["-DDIM=%d" % dim, "-DPROMISE=%d" % dim, "-DCLOUDS=%d" % clouds, "-DSEED=%d" % seed, "-DPERCENT=100",
              "-DON_HOST"]
    must([*compiler, "-DNETMESH_EACH_DIMENSION(DO)=DO(%d)" % dim, "-c", "netmesh.cpp"], folder)
    must([*compiler, "-w", "-ffp-contract=off", *values, "-I", ".", "-I", BOARD, "-I", os.path.join(ROOT, "tests"),
          os.path.join(HERE, "board.cpp"), "netmesh.o", "-o", "clouds"], folder)
    return results_of(must(["./clouds"], folder))[0]


def compare(found, due, clouds):
    """Lines about results that differ. Where a mesh does not fit the board, its cloud has fewer points there."""
    both = found.keys() & due.keys()
    bad = sorted(k for k in both if found[k] != due[k])
    lines = ["FAULT result of %s, cloud %s: %s, here %s" % (*k[:2], found[k], due[k]) for k in bad]
    if len(both) < 0.9 * len(JOBS) * clouds:
        lines.append("FAULT only %d results could be compared" % len(both))
    return lines or ["%d results are those of this machine" % len(both)]


def one(core, dims, options, due):
    folder = build_engine(options.build, core, dims)
    unlike, text = check_object(folder)
    faults, lines = run([sys.executable, CHECK, "jobs", *check_options(folder, core, dims)], folder)
    text += lines
    failed, said = run_clouds(folder, core, dims, options.clouds, options.seed, 100)
    found, lines = results_of(said)
    lines += compare(found, due.result(), options.clouds)
    failed |= "FAULT" in lines[-1]
    text += "\n".join(lines) + "\n"
    if options.planted:
        _, said = run_clouds(folder, core, dims, PLANTED_CLOUDS, options.seed, PLANTED_PERCENT)
        blind = [job for job in JOBS if "FAULT " + job not in said]
        failed |= bool(blind)
        text += "FAULT not seen: half of the stack of %s\n" % ", ".join(blind) if blind else "half of it is seen\n"
    failed = unlike != 0 or faults != 0 or failed != 0
    return failed, "".join("cortex-%s  %s\n" % (core, line) for line in text.splitlines())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build-stack"))
    parser.add_argument("--clouds", type=int, default=27)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--dims", default="2,3")
    parser.add_argument("--planted", action="store_true")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("cores", nargs="*")
    options = parser.parse_args()
    options.build = os.path.abspath(options.build)
    chosen = options.cores or list(cores())
    if not set(chosen) <= set(cores()):
        sys.exit("cores are: " + " ".join(cores()))
    libraries = [[int(d) for d in dims.split("+")] for dims in options.dims.split(",")]
    print("seed %d" % options.seed)
    failed = False
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        due = {dim: pool.submit(results_here, options.build, dim, options.clouds, options.seed)
               for dim in {dims[0] for dims in libraries}}
        for task in [pool.submit(one, core, dims, options, due[dims[0]]) for core in chosen for dims in libraries]:
            fault, text = task.result()
            failed |= fault
            print(text, end="", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
