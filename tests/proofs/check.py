#!/usr/bin/env python3
"""`netmesh check` with proofs beside diagrams, as a shell sees it: check.py NETMESH VERIFY VERIFY_RIPS WORK

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

NETMESH, VERIFY, VERIFY_RIPS, WORK = (os.path.abspath(path) for path in sys.argv[1:5])
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
    expect("complete", run("persist", "p.txt", "--filter", "complete", "-o", "complete.pers"), 0)
    copy("p.proof", "complete.proof")
    expect("complete beside", run("check", "complete.pers", "--points", "p.txt"), 0, never=["proof"])
    expect("complete named", run("check", "complete.pers", "--points", "p.txt", "--proof", "complete.proof"), 2,
           "--proof is of filters alpha, rips and cech, not of complete")
    for words, said in ((["p.pers"], "--proof goes with a diagram (.pers) and --points, without --mesh"),
                        (["p.pers", "--points", "p.txt", "--mesh", "p.node"], "and --points, without --mesh"),
                        (["p.node"], "--proof does nothing here: it says nothing about a mesh (.node)")):
        expect("proof with " + " ".join(words), run("check", *words, "--proof", "p.proof"), 2, said)


def rips():
    """Rips diagrams of points, with a threshold and without, and of distances of each form; a Cech diagram."""
    proven = "verified by " + VERIFY_RIPS
    table = "name,x,y\n" + "".join(f"\"n {i}\",{line.replace(' ', ',')}\n"
                                  for i, line in enumerate(read("p.txt").split("\n")[:-1] + ["1 2", "1 2"]))
    write("named.csv", table)
    write("few.csv", "".join(line + "\n" for line in table.split("\n")[:16]))
    write("full.txt", "0 1 2\n1 0 1.5\n2 1.5 0\n")
    write("noise.txt", "0 1 2\n1.00000000000001 0 1.5\n2 1.5 0\n")
    write("lower.txt", "1\n2 1.5\n2 2 inf\n")
    write("condensed.txt", "1 0 3 1 1 1\n")
    write("entries.txt", "0 1 1\n1 2 1\n0 2 2.5\n1 0 1\n")
    plain = [("p.txt", []), ("p.txt", ["--threshold", "0.7", "--max-degree", "2"]), ("full.txt", ["--distances"]),
             ("lower.txt", ["--distances"]), ("entries.txt", ["--distances", "--sparse", "--threshold", "1"])]
    handed = [("named.csv", []), ("named.csv", ["--threshold", "0.7"]), ("noise.txt", ["--distances"]),
              ("condensed.txt", ["--distances"])]
    for name, words in plain + handed:
        columns = ["--columns", "x,y"] if name == "named.csv" else []
        words = ["--filter", "rips", *words]
        done = run("persist", name, *columns, *words, "-q", "-o", "r.pers", "--proof", "r.proof")
        expect(f"made rips {name} {words}", done, 0)
        kind = "distances" if "--distances" in words else "points"
        how = f"for the {kind} that netmesh reads in {name}" if (name, words[2:]) in handed else f"{kind} in {name}"
        expect(f"rips {name} {words}", run("check", "r.pers", "--points", name, *columns), 0, "reproduced",
               "proof: by r.proof every bar is true", how, proven)
    expect("rips, stdin", run("check", "r.pers", "--points", "-", stdin=read("condensed.txt")), 0,
           "for the distances that netmesh reads in", proven)
    few = ["few.csv", "--columns", "x,y"]
    expect("made cech", run("persist", *few, "--filter", "cech", "-q", "-o", "c.pers", "--proof", "c.proof"), 0)
    expect("cech", run("check", "c.pers", "--points", *few), 0, "reproduced", "proof: by c.proof every bar is true",
           "for the points that netmesh reads in few.csv", proven)
    write("c.pers", read("c.pers").replace("# filter cech", "# filter rips"))
    expect("cech for rips", run("check", "c.pers", "--points", *few, "--proof", "c.proof"), 7)
    # Refused: another's proof, one of the other kind, one that is cut.
    expect("a proof of alpha", run("check", "r.pers", "--points", "condensed.txt", "--proof", "p.proof"), 7,
           "p.proof: check failed: p.proof: not a proof of version 3")
    expect("a proof of rips for alpha", run("check", "p.pers", "--points", "p.txt", "--proof", "r.proof"), 7,
           "r.proof: check failed: r.proof: not a proof of version 1")
    for words in (["--max-degree", "2", "-o", "two.pers", "--proof", "two.proof"], ["-o", "one.pers"]):
        expect("made rips", run("persist", "q.txt", "--filter", "rips", "-q", *words), 0)
    expect("another's", run("check", "one.pers", "--points", "q.txt", "--proof", "two.proof"), 7,
           "two.proof: check failed: not proven: step 1", "not of this diagram" if read("one.pers").split("\n")[-2]
           != read("two.pers").split("\n")[-2] else "max-degree")
    with open(os.path.join(WORK, "two.proof"), "rb") as file:
        whole = file.read()
    with open(os.path.join(WORK, "two.proof"), "wb") as file:
        file.write(whole[:-1])
    expect("cut", run("check", "two.pers", "--points", "q.txt"), 7, "two.proof: check failed: not proven: step 1")
    expect("none", run("check", "one.pers", "--points", "q.txt"), 0, "no proof beside it: there is no one.proof")
    done = run("check", "r.pers", "--points", "condensed.txt", program=script("alone", None), path="/nowhere")
    expect("no program", done, 0, "no proof verified: r.proof is not verified",
           "there is no netmesh-verify-rips beside netmesh, nor in a folder of PATH", never=["every bar is true"])


def verifiers():
    """Other programs of that name, and none."""
    words = ["check", "p.pers", "--points", "p.txt"]
    alone = script("alone", None)
    none = ("there is no netmesh-verify beside netmesh, nor in a folder of PATH; it is built with GMP: "
            "cmake --build build")
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
    rips()
    verifiers()
    print(f"{len(FAULTS)} faults")
    return 1 if FAULTS else 0


sys.exit(main())
