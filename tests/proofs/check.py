#!/usr/bin/env python3
"""`netmesh check` with proofs beside diagrams, as a shell sees it: check.py NETMESH VERIFY WORK

An honest proof is verified and said to be; a forged one, a forged diagram, a proof of other points, one cut off or of
no kind at all is refused, with the place that the verifier names; without a proof or without netmesh-verify that is
said, and with --proof the latter is a failure. A verifier that ends otherwise than it should is never taken for a yes.
"""
import json
import os
import shutil
import stat
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from run import Case  # pylint: disable=wrong-import-position

NETMESH, VERIFY, WORK = (os.path.abspath(path) for path in sys.argv[1:4])
FAULTS = []


def run(*words, program=None, path=None, stdin=None):
    environment = dict(os.environ, LC_ALL="C", NO_COLOR="1")
    if path is not None:
        environment["PATH"] = path
    return subprocess.run([program or NETMESH, *words], cwd=WORK, env=environment, capture_output=True, text=True,
                          input=stdin, check=False)


def expect(what, done, code, *words, never=()):
    said = done.stdout + done.stderr
    wrong = [f"exit {done.returncode}, not {code}"] if done.returncode != code else []
    wrong += [f"does not say: {word}" for word in words if word not in said]
    wrong += [f"says: {word}" for word in never if word in said]
    if wrong:
        FAULTS.append(what)
        print(f"{what}: {'; '.join(wrong)}\n{said}")


def write(name, text):
    with open(os.path.join(WORK, name), "w", encoding="ascii") as file:
        file.write(text)


def read(name):
    with open(os.path.join(WORK, name), encoding="ascii") as file:
        return file.read()


def copy(a, b):
    shutil.copy(os.path.join(WORK, a), os.path.join(WORK, b))


def script(folder, text):
    """A netmesh-verify of one's own beside a copy of netmesh, whose path is the result."""
    os.makedirs(os.path.join(WORK, folder), exist_ok=True)
    own = os.path.join(WORK, folder, "netmesh")
    shutil.copy(NETMESH, own)
    if text is not None:
        write(folder + "/netmesh-verify", text)
        os.chmod(os.path.join(WORK, folder, "netmesh-verify"), stat.S_IRWXU)
    return own


def honest():
    expect("honest", run("check", "p.pers", "--points", "p.txt"), 0, "reproduced", "second opinion",
           "proof: by p.proof every bar is true and there is no other, for the points in p.txt; verified by " + VERIFY,
           never=["no proof"])
    expect("named", run("check", "p.pers", "--points", "p.txt", "--proof", "other.proof"), 0, "proof: by other.proof")
    said = json.loads(run("check", "p.pers", "--points", "p.txt", "--json").stdout)
    if not any(line.startswith("proof: by p.proof") for line in said["checked"]):
        FAULTS.append("json")
    expect("quiet", run("check", "p.pers", "--points", "p.txt", "-q"), 0, never=["p"])
    # Tables that netmesh-verify does not read: the points as netmesh reads them.
    lines = [line.replace(" ", ",") for line in read("p.txt").split("\n")[:-1]]
    write("table.csv", "name,x,y\n" + "".join(f'"n {i}",{line}\n' for i, line in enumerate(lines)))
    expect("table", run("check", "p.pers", "--points", "table.csv", "--columns", "x,y"), 0,
           "for the points that netmesh reads in table.csv; verified by")
    expect("stdin", run("check", "p.pers", "--points", "-", stdin=read("p.txt")), 0, "points that netmesh reads in")
    # What it reads as other points than netmesh does: a head in front of the points.
    rows = read("s.txt").split("\n")[:-1]
    write("s.off", f"OFF\n{len(rows)} 0 0\n" + read("s.txt"))
    expect("off", run("check", "s.pers", "--points", "s.off"), 0, "points that netmesh reads in s.off")
    # Balls: the weight in a column that has a number, or a name, which netmesh-verify takes for the last one.
    write("balls.csv", "r,x,y\n" + "".join(f"{1 + i % 3},{line}\n" for i, line in enumerate(lines)))
    for name, column in (("number", "1"), ("name", "r")):
        words = ["--radii", column, "-q", "-o", name + ".pers", "--proof", name + ".proof"]
        done = run("persist", "balls.csv", "--filter", "alpha", *words)
        expect("made balls", done, 0)
    expect("balls", run("check", "number.pers", "--points", "balls.csv"), 0, "for the points in balls.csv; verified by")
    expect("balls by name", run("check", "name.pers", "--points", "balls.csv"), 0,
           "for the points that netmesh reads in balls.csv; verified by")
    # Above what the second opinion takes: the proof is in its place, for all degrees.
    expect("large", run("check", "large.pers", "--points", "large.csv"), 0, "proof: by large.proof",
           never=["second opinion"])
    os.rename(os.path.join(WORK, "large.proof"), os.path.join(WORK, "away.proof"))
    expect("large without", run("check", "large.pers", "--points", "large.csv"), 0, "no proof beside it",
           "second opinion on degree 0 alone")


def forged():
    def refused(what, name, *words):
        expect(what, run("check", name + ".pers", "--points", name + ".txt"), 7, "check failed", *words)

    case = Case(os.path.join(WORK, "p"))
    del case.cells[3]
    case.write(os.path.join(WORK, "cell"))
    refused("a cell less", "cell", "cell.proof: check failed: not proven: step 3")
    case = Case(os.path.join(WORK, "p"))
    case.list[0], case.list[1] = case.list[1], case.list[0]
    case.write(os.path.join(WORK, "places"))
    refused("places exchanged", "places", "places.proof: check failed: not proven: step 3")
    # The engine sees a bar that is wrong before the proof is looked at, and the verifier would see it as well.
    case = Case(os.path.join(WORK, "p"))
    case.bars[-1][2] *= 1.5
    case.bars.sort()
    case.write(os.path.join(WORK, "bar"))
    refused("a bar moved", "bar", "bar.pers:")
    # A head that a proof is not for: the same bars, but those of length 0 are kept.
    expect("all", run("persist", "p.txt", "--filter", "alpha", "--all", "-o", "all.pers"), 0)
    copy("p.proof", "all.proof")
    refused_all = run("check", "all.pers", "--points", "p.txt")
    expect("another diagram's", refused_all, 7, "all.proof: check failed: not proven: step 1",
           "not of this diagram, by its fingerprint")
    copy("q.proof", "p-with-q.proof")
    copy("p.pers", "p-with-q.pers")
    copy("p.txt", "p-with-q.txt")
    refused("a proof of other points", "p-with-q", "p-with-q.proof: check failed: not proven: step 1",
            "not of these points")
    expect("a proof of other points, named", run("check", "p.pers", "--points", "p.txt", "--proof", "q.proof"), 7,
           "q.proof: check failed: not proven: step 1")
    said = json.loads(run("check", "p.pers", "--points", "p.txt", "--proof", "q.proof", "--json").stdout)
    if said["error"]["file"] != "q.proof" or said["error"]["code"] != 7:
        FAULTS.append("json of a refusal")
        print(said)
    for name, data in (("cut", 100), ("empty", 0)):
        for ending in (".pers", ".txt"):
            copy("p" + ending, name + ending)
        with open(os.path.join(WORK, "p.proof"), "rb") as file:
            whole = file.read()
        with open(os.path.join(WORK, name + ".proof"), "wb") as file:
            file.write(whole[:data])
        refused(name, name, name + ".proof: check failed: ")


def without():
    for ending in (".pers", ".txt"):
        copy("p" + ending, "bare" + ending)
    expect("no proof", run("check", "bare.pers", "--points", "bare.txt"), 0,
           "no proof beside it: there is no bare.proof; persist --proof writes one", "second opinion")
    expect("no such proof", run("check", "bare.pers", "--points", "bare.txt", "--proof", "none.proof"), 3,
           "none.proof: no such file, which --proof names")
    expect("rips", run("persist", "p.txt", "--filter", "rips", "--max-degree", "0", "-o", "rips.pers"), 0)
    copy("p.proof", "rips.proof")
    expect("rips beside", run("check", "rips.pers", "--points", "p.txt"), 0, never=["proof"])
    expect("rips named", run("check", "rips.pers", "--points", "p.txt", "--proof", "rips.proof"), 2,
           "--proof is of filter alpha alone, not of rips")
    for words, said in ((["p.pers"], "--proof goes with a diagram (.pers) and --points, without --mesh"),
                        (["p.pers", "--points", "p.txt", "--mesh", "p.node"], "and --points, without --mesh"),
                        (["p.node"], "--proof does nothing here: it says nothing about a mesh (.node)")):
        expect("proof with " + " ".join(words), run("check", *words, "--proof", "p.proof"), 2, said)


def verifiers():
    """Other programs of that name, and none."""
    words = ["check", "p.pers", "--points", "p.txt"]
    alone = script("alone", None)
    none = "there is no netmesh-verify beside netmesh, nor in a folder of PATH; it is built where there is GMP"
    done = run(*words, program=alone, path="/nowhere")
    expect("no program", done, 0, "no proof verified: p.proof is not verified", none, never=["every bar is true"])
    done = run(*words, "-q", program=alone, path="/nowhere")
    expect("no program, quiet", done, 0, none)
    if none not in done.stderr:
        FAULTS.append("no program, quiet: nothing on stderr")
    expect("no program, named", run(*words, "--proof", "p.proof", program=alone, path="/nowhere"), 3, none)
    expect("in PATH", run(*words, program=alone, path=os.path.dirname(VERIFY)), 0, "verified by " + VERIFY)
    for what, text, code, said in (
            ("no library", "echo 'error while loading shared libraries: libgmp.so.10' >&2; exit 127", 0,
             "not verified, as netmesh-verify cannot be run: error while loading"),
            ("killed", "kill -9 $$", 7, "netmesh-verify did not end as it should"),
            ("says nothing", "exit 0", 7, "netmesh-verify did not end as it should"),
            ("another code", "echo verified; exit 1", 7, "netmesh-verify did not end as it should"),
            ("a refusal", "echo 'netmesh-verify: not proven: step 9: here' >&2; exit 7", 7,
             "p.proof: check failed: not proven: step 9: here")):
        own = script("own", f"#!/bin/sh\n{text}\n")
        expect(what, run(*words, program=own), code, said, never=["every bar is true"])


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(WORK)
    circle = ["circle", "-n", "40", "--noise", ".1"]
    for name, words in (("p", circle), ("q", circle + ["--seed", "2"]), ("s", ["sphere", "-n", "30", "--noise", ".1"])):
        run("sample", *words, "-o", name + ".csv")
        write(name + ".txt", read(name + ".csv").replace(",", " "))
    run("sample", "ball", "--dim", "2", "-n", "90000", "-o", "large.csv")
    for name in ("p.txt", "q.txt", "s.txt", "large.csv"):
        stem = name.split(".")[0]
        expect("made " + name, run("persist", name, "--filter", "alpha", "-q", "-o", stem + ".pers", "--proof",
                                   stem + ".proof"), 0)
    run("persist", "p.txt", "--filter", "alpha", "-q", "-o", "other.pers", "--proof", "other.proof")
    honest()
    forged()
    without()
    verifiers()
    print(f"{len(FAULTS)} faults")
    return 1 if FAULTS else 0


sys.exit(main())
