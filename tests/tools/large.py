#!/usr/bin/env python3
"""Inputs that do not fit memory, and several inputs side by side: memory that does not grow with the input, the same
bytes by any number of processes, errors by name, processes that are killed, Ctrl-C.

  large.py TOOL
"""
import array
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

TOOL = os.path.abspath(sys.argv[1])
ENVIRONMENT = dict(os.environ, ASAN_OPTIONS="quarantine_size_mb=1:detect_leaks=0")
faults = 0


def run(*arguments, **options):
    return subprocess.run([TOOL, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                          timeout=600, **options)


def check(condition, what):
    global faults
    if not condition:
        faults += 1
        print("FAULT", what)


def content(path):
    with open(path, "rb") as file:
        return file.read()


def resident(*arguments):
    """The most memory of a run, in MiB."""
    process = subprocess.Popen([TOOL, *arguments], env=ENVIRONMENT, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = 0
    check(status == 0, "%s: status %d" % (arguments, status))
    return usage.ru_maxrss / 1024


def write_npy(path, count, numbers):
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d, 2), }" % count
    head += " " * (117 - len(head)) + "\n"
    with open(path, "wb") as file:
        file.write(b"\x93NUMPY\x01\x00" + bytes((len(head), 0)) + head.encode())
        numbers.tofile(file)


random.seed(1)
os.chdir(tempfile.mkdtemp(prefix="netmesh-test-"))

# Memory of split: read whole each of these takes more than 40 MiB. They are written by another process, since what
# this one holds counts as memory of all that it begins.
COUNT = 500000
writer = os.fork()
if writer == 0:
    numbers = array.array("d", [random.random() for _ in range(2 * COUNT)])
    write_npy("large.npy", COUNT, numbers)
    with open("large.csv", "w", encoding="ascii") as file:
        file.write("x,y\n")
        for i in range(0, 2 * COUNT, 2):
            file.write("%r,%r\n" % (numbers[i], numbers[i + 1]))
    with open("large.ply", "wb") as file:
        file.write(("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
                    "end_header\n" % COUNT).encode())
        numbers.tofile(file)
    with open("small.csv", "w", encoding="ascii") as file:
        file.writelines("%r %r\n" % (random.random(), random.random()) for _ in range(100))
    os._exit(0)
os.waitpid(writer, 0)
FILES = ("large.npy", "large.csv", "large.ply")
base = resident("pieces", "split", "small.csv", "small", "--pieces", "16", "--quiet")
for name in FILES:
    more = resident("pieces", "split", name, name + "-job", "--pieces", "16", "--memory", "4M", "--quiet") - base
    print("split %s in 4 MiB: %.1f MiB more than the %.1f of 100 points" % (name, more, base))
    check(more < 16, "split of %s takes %.1f MiB" % (name, more))
whole = resident("pieces", "split", "large.npy", "whole", "--pieces", "16", "--memory", "1G", "--quiet") - base
check(whole > 24, "split in 1 GiB takes %.1f MiB only: this does not measure memory" % whole)
shutil.rmtree("whole")
HEADER = 336  # bytes, with the input's name in it
for name in FILES:
    check(content(name + "-job/points")[HEADER:] == content("large.npy-job/points")[HEADER:], name + ": other points")
with open("large.csv", "rb") as file:
    ended = run("pieces", "split", "-", "whole", "--pieces", "16", "--quiet", stdin=file)
check(ended.returncode == 0, "stdin: " + ended.stderr)
check(content("whole/points")[HEADER:] == content("large.npy-job/points")[HEADER:], "other points than in memory")
check(sorted(os.listdir("large.csv-job")) == ["Makefile", "points"], "split leaves more behind than its files")
for name in ("large.csv", "large.npy"):  # a fault near the end
    data = content(name)
    with open("bad" + name[5:], "wb") as file:
        file.write(data[:-9] + b"x" + data[-8:] if name == "large.csv" else data[:-9])
    pieces = run("pieces", "split", "bad" + name[5:], "bad", "--pieces", "16")
    whole = run("persist", "bad" + name[5:], "--filter", "alpha")
    check(pieces.returncode == whole.returncode == 3 and pieces.stderr == whole.stderr and
          "bad" + name[5:] in pieces.stderr, "%s: %r, %r" % (name, pieces.stderr, whole.stderr))
    check(not os.listdir("bad"), "a fault leaves files behind")

# Several inputs by one process and by three, among them what fails.
names = []
for i in range(8):
    names.append("c%d.csv" % i)
    check(run("sample", "torus", "-n", str(300 - 30 * i), "--seed", str(i), "--noise", ".1", "-o", names[-1],
              "-q").returncode == 0, "sample")
with open("bad.csv", "w", encoding="ascii") as file:
    file.write("1,2\n3,x\n")
with open("flat.csv", "w", encoding="ascii") as file:
    file.writelines("%d,%d,%d\n" % (i, i, 2 * i) for i in range(9))
with open("header.csv", "w", encoding="ascii") as file:
    file.write("x,y\n0,0\n1,0\n0,1\n")
many = names[:3] + ["bad.csv", "header.csv", "flat.csv"] + names[3:] + ["missing.csv"]
for options in (["--filter", "alpha"], ["--filter", "alpha", "--top", "3", "--memory", "64M"],
                ["--ratio", "2.5", "--max-degree", "0", "--bounds"], ["--filter", "rips", "--threshold", ".1"]):
    said = []
    for jobs in ("1", "3", "20"):
        os.makedirs("out" + jobs, exist_ok=True)
        ended = run("persist", *many, *options, "--jobs", jobs, "-o", "out%s/{}.pers" % jobs, cwd=os.getcwd())
        lines = [line for line in ended.stderr.splitlines() if not line.startswith("time ")]
        said.append((ended.returncode, ended.stdout, lines,
                     [(name, content(os.path.join("out" + jobs, name))) for name in sorted(os.listdir("out" + jobs))]))
        shutil.rmtree("out" + jobs)
    check(said[0][0] == 3 and any(line.startswith("bad.csv:2: ") for line in said[0][2]), "%r" % (said[0][:3],))
    check(len(said[0][3]) >= 9, "%d files" % len(said[0][3]))
    for other in said[1:]:
        check(other == said[0], "%s: other files or words by several processes" % options)


def objects(text):
    """The objects on stdout, without their times."""
    found, decoder = [], json.JSONDecoder()
    while text.strip():
        one, end = decoder.raw_decode(text.lstrip())
        text = text.lstrip()[end:]
        one.pop("seconds", None)
        found.append(one)
    return found


made = [objects(run("persist", *many, "--filter", "alpha", "--json", "--jobs", jobs).stdout) for jobs in ("1", "3")]
check(made[0] == made[1] and len(made[0]) == len(many), "JSON of several inputs")
ended = run("persist", *many, "--filter", "alpha", "--memory", "20K", "--jobs", "3", "-o", "{}.pers")
check(ended.returncode == 4 and "c0.csv" not in os.listdir(".") or ended.stderr.count("of memory are too few") >= 8,
      "little memory: %d" % ended.returncode)
for arguments, text in ((["a.csv", "--jobs", "2"], "--jobs goes with --pieces, or with several POINTS"),
                        (names[:2] + ["--jobs", "0", "-o", "{}.pers"], "must be a number of processes"),
                        (names[:2] + ["--jobs", "2"], "several inputs need -o with {}")):
    ended = run("persist", *arguments)
    check(ended.returncode == 2 and text in ended.stderr, "%s: %r" % (arguments, ended.stderr))


def children(process):
    try:
        return [int(child) for child in content("/proc/%d/task/%d/children" % (process, process)).split()]
    except OSError:  # no /proc, or it has ended
        return []


# A process that is killed is told by its input, and the others go on; Ctrl-C ends all, and leaves nothing behind.
for kill in (True, False):
    folder = "killed" if kill else "stopped"
    os.makedirs(folder)
    os.makedirs("temporary", exist_ok=True)
    begun = subprocess.Popen([TOOL, "persist", "large.npy", *names, "--filter", "alpha", "--jobs", "2", "-q", "-o",
                              folder + "/{}.pers"], stderr=subprocess.PIPE, universal_newlines=True,
                             env=dict(os.environ, TMPDIR="temporary"))
    deadline = time.time() + 60
    while not os.path.exists(folder + "/c0.pers") and time.time() < deadline:
        time.sleep(0.01)
    first = children(begun.pid)
    if kill and not first:  # no way to tell processes
        begun.kill()
        begun.wait()
        continue
    if kill:
        os.kill(min(first), signal.SIGKILL)
    else:
        begun.send_signal(signal.SIGINT)
    said = begun.communicate(timeout=300)[1]
    if kill:
        check(begun.returncode == 1 and "large.npy: its process was killed" in said,
              "killed: %d %r" % (begun.returncode, said))
        check(sorted(os.listdir(folder)) == [name.replace("csv", "pers") for name in names], "killed: others stop")
    else:
        check(begun.returncode == 6 and "cancelled" in said, "Ctrl-C: %d %r" % (begun.returncode, said))
        whole = ["large.pers"] + [name.replace("csv", "pers") for name in names]  # what had ended before
        check(set(os.listdir(folder)) <= set(whole), "Ctrl-C leaves %s" % os.listdir(folder))
        check(not any(os.path.exists("/proc/%d" % child) for child in first), "Ctrl-C leaves processes")
    check(not os.listdir("temporary"), "files are left in the system's folder")
shutil.rmtree(os.getcwd(), ignore_errors=True)
print("%d faults" % faults)
sys.exit(1 if faults else 0)
