#!/usr/bin/env python3
"""Diagrams in pieces by the tool, and what goes wrong on the way: workers that are killed, files that are damaged,
tasks that run twice, folders of other jobs. Each ends with the right bytes or a clear error.

  pieces.py TOOL [KILLS]      KILLS: how many runs are killed at a random time (12)
"""
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

TOOL = os.path.abspath(sys.argv[1])
KILLS = int(sys.argv[2]) if len(sys.argv) > 2 else 12
faults = 0


def run(*arguments, **options):
    return subprocess.run([TOOL, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                          timeout=300, **options)


def check(condition, what):
    global faults
    if not condition:
        faults += 1
        print("FAULT", what)


def content(path):
    with open(path, "rb") as file:
        return file.read()


def refused(code, text, *arguments):
    ended = run(*arguments)
    check(ended.returncode == code and text in ended.stderr,
          "%s: exit %d, %r; wanted %d, %r" % (" ".join(arguments), ended.returncode, ended.stderr, code, text))


def same(path, what):
    check(os.path.exists(path) and content(path) == WHOLE, what + ": another diagram")


def flip(path):
    data = bytearray(content(path))
    data[random.randrange(len(data))] ^= 1 << random.randrange(8)
    with open(path, "wb") as file:
        file.write(data)


random.seed(1)
os.chdir(tempfile.mkdtemp(prefix="netmesh-test-"))
check(run("sample", "torus", "-n", "4000", "--noise", ".02", "-o", "a.csv", "--quiet").returncode == 0, "sample")
check(run("persist", "a.csv", "--filter", "alpha", "-o", "whole.pers", "--quiet").returncode == 0, "persist")
WHOLE = content("whole.pers")

# Any number of pieces and processes, several inputs, both commands.
for pieces, jobs in (("1", "1"), ("2", "2"), ("16", "3"), ("auto", "1")):
    run("persist", "a.csv", "--pieces", pieces, "--jobs", jobs, "-o", "b.pers", "--quiet")
    same("b.pers", "%s pieces, %s jobs" % (pieces, jobs))
os.makedirs("temporary")
run("persist", "a.csv", "--pieces", "4", "-o", "b.pers", "--quiet", env=dict(os.environ, TMPDIR="temporary"))
same("b.pers", "a temporary folder")
check(not os.listdir("temporary"), "a folder is left behind")
shutil.copy("a.csv", "c.csv")
run("persist", "a.csv", "c.csv", "--pieces", "4", "-o", "{}.pers", "--quiet")
same("a.pers", "the first of two")
same("c.pers", "the second of two")
check(run("pieces", "split", "a.csv", "made", "--pieces", "8", "--quiet").returncode == 0, "split")
made = subprocess.run(["make", "-s", "-j3", "-C", "made", "NETMESH=" + TOOL], stderr=subprocess.DEVNULL)
check(made.returncode == 0, "make")
same("made/diagram.pers", "make")
check(run("pieces", "collect", "made", "-o", "d.pers", "--quiet").returncode == 0, "collect")
same("d.pers", "collect")

# Processes that are killed: the same command goes on.
for kill in range(KILLS):
    shutil.rmtree("killed", ignore_errors=True)
    begun = subprocess.Popen([TOOL, "persist", "a.csv", "--pieces", "16", "--jobs", "2", "--scratch", "killed", "-o",
                              "k.pers", "--quiet"], stderr=subprocess.DEVNULL, start_new_session=True)
    time.sleep(random.uniform(0, 0.25))
    if kill % 2 == 0:  # all of them
        try:
            os.killpg(begun.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    else:  # a worker
        try:
            found = content("/proc/%d/task/%d/children" % (begun.pid, begun.pid)).split()
        except OSError:  # no /proc, or it has ended
            found = []
        if found:
            try:
                os.kill(int(random.choice(found)), signal.SIGKILL)
            except ProcessLookupError:
                pass
    code = begun.wait(timeout=300)
    check(code in (0, 1, -9), "killed: exit %d" % code)
    again = run("persist", "a.csv", "--pieces", "16", "--scratch", "killed", "-o", "k.pers", "--quiet")
    check(again.returncode == 0, "after a kill: " + again.stderr)
    same("k.pers", "after a kill")

# Ctrl-C, and a task that runs twice at once.
shutil.rmtree("killed", ignore_errors=True)
begun = subprocess.Popen([TOOL, "persist", "a.csv", "--pieces", "16", "--jobs", "1", "--scratch", "killed", "-o",
                          "k.pers", "--quiet"], stderr=subprocess.PIPE, universal_newlines=True)
time.sleep(0.15)
begun.send_signal(signal.SIGINT)
said = begun.communicate(timeout=300)[1]
check(begun.returncode == 6 and "cancelled" in said or begun.returncode == 0,
      "Ctrl-C: %d %r" % (begun.returncode, said))
os.unlink("made/piece-9")
twice = [subprocess.Popen([TOOL, "pieces", "leaf", "made", "9"]) for _ in range(3)]
check(not any(task.wait(timeout=300) for task in twice), "a task that runs twice at once")
run("pieces", "collect", "made", "-o", "d.pers", "--quiet")
same("d.pers", "after a task that ran twice at once")

# Damaged files.
for trial in range(20):
    for name in ("points", "piece-1", "piece-4"):
        kept = content("made/" + name)
        flip("made/" + name)
        if name == "points":
            for node in range(8, 16):
                if os.path.exists("made/piece-%d" % node):
                    os.rename("made/piece-%d" % node, "made/kept-%d" % node)
            results = [run("pieces", "leaf", "made", str(node)) for node in range(8, 16)]
            for node in range(8, 16):
                made, kept_one = "made/piece-%d" % node, "made/kept-%d" % node
                if results[node - 8].returncode == 0:
                    check(content(made) == content(kept_one), "a piece of damaged points")
                else:
                    check(results[node - 8].returncode == 3 and "made/points" in results[node - 8].stderr,
                          "damaged points: " + results[node - 8].stderr)
                os.rename(kept_one, made)
        elif name == "piece-1":
            ended = run("pieces", "collect", "made", "-o", "d.pers", "--quiet")
            if ended.returncode == 0:  # behind its head, which nobody reads
                same("d.pers", "a damaged piece")
            else:
                check(ended.returncode == 3 and "made/piece-1" in ended.stderr, "a damaged piece: " + ended.stderr)
        else:
            os.rename("made/piece-2", "made/kept-2")
            refused(3, "made/piece-4", "pieces", "join", "made", "2")
            os.rename("made/kept-2", "made/piece-2")
        with open("made/" + name, "wb") as file:
            file.write(kept)
with open("made/piece-1", "rb+") as file:
    file.truncate(100)
refused(3, "the piece ends in its header", "pieces", "collect", "made", "-o", "d.pers")
check(run("pieces", "join", "made", "1").returncode == 0, "a piece that was cut off is made again")
run("pieces", "collect", "made", "-o", "d.pers", "--quiet")
same("d.pers", "after a piece was cut off")

# What is refused.
refused(3, "made/points: of another job: --pieces 8 in place of 4", "persist", "a.csv", "--pieces", "4", "--scratch",
        "made")
run("sample", "torus", "-n", "4000", "--noise", ".02", "--seed", "2", "-o", "other.csv", "--quiet")
refused(3, "of another job: other points, of a.csv;", "persist", "other.csv", "--pieces", "8", "--scratch", "made")
refused(3, "of another job: --max-degree 2 in place of 1", "persist", "a.csv", "--pieces", "8", "--max-degree", "1",
        "--scratch", "made")
refused(3, "of another job: without --all", "persist", "a.csv", "--pieces", "8", "--all", "--scratch", "made")
refused(2, "--scratch is for one input", "persist", "a.csv", "other.csv", "--pieces", "8", "--scratch", "several", "-o",
        "{}.pers")
# Points that are replaced: joins and collecting know the pieces of others.
run("pieces", "split", "a.csv", "stale", "--pieces", "2", "--quiet")
for task in (("leaf", "2"), ("leaf", "3"), ("join", "1")):
    run("pieces", task[0], "stale", task[1])
shutil.copytree("stale", "mixed")
os.unlink("stale/points")
run("pieces", "split", "other.csv", "stale", "--pieces", "2", "--quiet")
refused(3, "stale/piece-1: a piece of another job than the points", "pieces", "collect", "stale", "-o", "d.pers")
os.unlink("stale/piece-1")
refused(3, "stale/piece-2: a piece of another job than the points", "pieces", "join", "stale", "1")
for name in ("points", "piece-2", "piece-3"):
    shutil.copy("mixed/" + name, "stale/" + name)
run("pieces", "join", "stale", "1")
shutil.copy("stale/piece-2", "stale/piece-3")
refused(3, "stale/piece-3: the piece of node 2; remove the file", "pieces", "collect", "stale", "-o", "d.pers")
open("stale/piece-3", "w").close()
refused(3, "stale/piece-3: the piece ends in its header; remove the file", "pieces", "collect", "stale", "-o", "d.pers")
# A file of the user's.
os.mkdir("own")
with open("own/Makefile", "w", encoding="ascii") as file:
    file.write("all:\n")
refused(3, "own/Makefile: a file of that name is there", "pieces", "split", "a.csv", "own", "--pieces", "2")
check(content("own/Makefile") == b"all:\n", "a Makefile is overwritten")
# Two jobs that begin in one folder at once: each ends with its own diagram, or says why not.
run("persist", "other.csv", "--filter", "alpha", "-o", "other.pers", "--quiet")
for trial in range(12):
    shutil.rmtree("race", ignore_errors=True)
    both = [subprocess.Popen([TOOL, "persist", name, "--pieces", "8", "--jobs", "2", "--scratch", "race", "-o",
                              "race-" + name + ".pers", "--quiet"], stderr=subprocess.PIPE, universal_newlines=True)
            for name in ("a.csv", "other.csv")]
    for process, whole in zip(both, ("whole.pers", "other.pers")):
        said = process.communicate()[1]
        name = process.args[2]
        if process.returncode == 0:
            check(content("race-" + name + ".pers") == content(whole), "two jobs at once: another diagram")
        else:
            check(process.returncode == 3 and "another job" in said, "two jobs at once: " + said)
refused(3, "no such file", "pieces", "leaf", "nothing", "8")
refused(2, "nodes of this job are 8 to 15", "pieces", "leaf", "made", "7")
refused(2, "nodes of this job are 1 to 7", "pieces", "join", "made", "8")
refused(2, "there are split, leaf, join and collect", "pieces", "leave", "made", "8")
refused(2, "takes DIR NODE", "pieces", "leaf", "made")
refused(2, "does nothing here", "pieces", "leaf", "made", "8", "--pieces", "4")
refused(2, "a power of 2", "persist", "a.csv", "--pieces", "3")
refused(2, "goes with --pieces", "persist", "a.csv", "--jobs", "3")
refused(2, "of filter alpha alone", "persist", "a.csv", "--pieces", "2", "--filter", "complete")
refused(2, "--representatives does not go with --pieces", "persist", "a.csv", "--pieces", "2", "--representatives",
        "r.txt")
refused(2, "more pieces than there are different points", "persist", "a.csv", "--pieces", "8192")
refused(4, "a leaf takes less with more --pieces", "persist", "a.csv", "--pieces", "2", "--memory", "64K")
with open("few.csv", "w", encoding="ascii") as file:
    file.write("".join("%d,%d\n" % (i % 3, i * i % 3) for i in range(200000)))
check(run("persist", "few.csv", "--filter", "alpha", "-o", "few.pers", "--quiet").returncode == 0, "few points")
check(run("persist", "few.csv", "--pieces", "auto", "-o", "few-pieces.pers", "--quiet").returncode == 0, "few again")
check(content("few.pers") == content("few-pieces.pers"), "few points in pieces")
with open("flat.csv", "w", encoding="ascii") as file:
    file.write("".join("%d,%d,%d\n" % (i, 2 * i % 7, i) for i in range(100)))
refused(5, "flat.csv: flat", "persist", "flat.csv", "--pieces", "4")
# No room for files: nothing half-written is left, and with room the same command goes on.
def little_room():
    resource.setrlimit(resource.RLIMIT_FSIZE, (ROOM, ROOM))


kept = ["persist", "a.csv", "--pieces", "4", "--scratch", "full", "-o", "k.pers", "--quiet"]
for ROOM in (1000, 150000, 200000):
    ended = run(*kept, preexec_fn=little_room)
    check(ended.returncode == 3 and ("full" in ended.stderr or "k.pers" in ended.stderr),
          "no room: %d %r" % (ended.returncode, ended.stderr))
    left = os.listdir("full")
    check(all(name == "points" or name.startswith("piece-") for name in left), "no room: %s are left" % left)
check(run(*kept).returncode == 0, "room again")
same("k.pers", "room again")
shutil.rmtree(os.getcwd(), ignore_errors=True)
print("%d runs killed, %d faults" % (KILLS, faults))
sys.exit(1 if faults else 0)
