"""bench.py [--small] [--readme | --overhead]: the ten jobs that users of topological data analysis do most, in netmesh
and in what they would use else: GUDHI, ripser (the program) and scipy. Each runs in a process of its own; seconds are
the best of some runs, memory the growth of the process's peak. A peer that is not installed is left out. Prints a
table; --readme also puts it into platform/python/README.md, at the mark that names this program.
--overhead compares with the same jobs in C instead, the program tests/python/plain.c that NETMESH_PLAIN names (the
library is that of NETMESH_LIBRARY): 1 at the end when calls take more than 50 us more on 10 points, reading of results
and making of the block included, or more than 3 % more on 1e5 points in space.
"""
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SMALL = "--small" in sys.argv

# What each process runs: a setting, then a statement that is measured.
COMMON = """
import os, resource, sys, time
import numpy as np
rng = np.random.default_rng(1)
def noisy_sphere(n, dim, noise=0.05):
    x = rng.normal(size=(n, dim))
    return x / np.linalg.norm(x, axis=1, keepdims=True) + noise * rng.normal(size=(n, dim))
def diagram(n, seed):
    rows = np.sort(np.random.default_rng(seed).random((n, 2)), axis=1)
    return rows
"""
END = """
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
job_small()
before = peak()
times = []
while len(times) < 3 and sum(times) < 20:
    begin = time.perf_counter()
    job()
    times.append(time.perf_counter() - begin)
import json
print(json.dumps({"seconds": min(times), "bytes": peak() - before}))
"""
RIPSER = """
import subprocess, tempfile
def by_ripser(points, degree, threshold=None):
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        np.savetxt(file, points)
        file.flush()
        options = [] if threshold is None else ["--threshold", str(threshold)]
        # A child of Python has had Python's memory; one of `time` has its own.
        said = subprocess.run(["/usr/bin/time", "-f", "%M", "ripser", "--format", "point-cloud", "--dim", str(degree),
                               *options, file.name], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        peaks.append(int(said.stderr.split()[-1]) * 1024)
peaks = [0]
def peak():
    return max(peaks)
"""


def gudhi_alpha(n):
    return ("import gudhi\np = noisy_sphere(%d, {dim})\n"
            "def job(p=p):\n"
            "    tree = gudhi.AlphaComplex(points=p).create_simplex_tree()\n"
            "    tree.compute_persistence()\n"
            "    return [tree.persistence_intervals_in_dimension(k) for k in range({dim})]\n"
            "job_small = lambda: job(p[:20])\n") % n


def ours(setting, call):
    return "import netmesh\n%s\ndef job(p=p):\n    return %s\njob_small = lambda: job(p[:20])\n" % (setting, call)


def scale(n):
    return n // 10 if SMALL else n


def jobs():
    """Name, our program, peers' programs by name, needed modules."""
    sphere = "p = noisy_sphere(%d, %d)"
    diagrams = "a, b = diagram(%d, 1), diagram(%d, 2)\np = a"
    found = []
    for dim, n in ((2, scale(20000)), (3, scale(20000))):
        found.append(("alpha diagram, %dD, %d points" % (dim, n),
                      ours(sphere % (n, dim), 'netmesh.persist(p, "alpha")'),
                      {"gudhi": gudhi_alpha(n).replace("{dim}", str(dim))}))
    for n, degree in ((scale(1000), 1), (scale(300), 2)):
        found.append((
            "Rips diagram to degree %d, 3D, %d points" % (degree, n),
            ours(sphere % (n, 3), "netmesh.rips(p, max_degree=%d)" % degree),
            {"ripser": RIPSER + sphere % (n, 3) + "\njob = lambda: by_ripser(p, %d)\n" % degree +
             "job_small = lambda: 0\n"}))
    n = scale(500)
    found.append((
        "Rips diagram of a distance matrix, %d points" % n,
        ours("from scipy.spatial.distance import cdist\n" + sphere % (n, 10) + "\nm = cdist(p, p)",
             "netmesh.rips(distances=m[:len(p), :len(p)])"),
        {"gudhi": "import gudhi\nfrom scipy.spatial.distance import cdist\n" + sphere % (n, 10) + "\nm = cdist(p, p)\n"
         "def job(m=m):\n    tree = gudhi.RipsComplex(distance_matrix=m).create_simplex_tree(max_dimension=1)\n"
         "    tree.collapse_edges()\n    tree.expansion(2)\n    tree.compute_persistence()\n"
         "    return tree.persistence_intervals_in_dimension(1)\njob_small = lambda: job(m[:20, :20])\n"}))
    n = scale(2000)
    found.append((
        "Rips diagram within radius 0.15, %d points" % n,
        ours(sphere % (n, 3), "netmesh.rips(p, 0.15)"),
        {"ripser": RIPSER + sphere % (n, 3) + "\njob = lambda: by_ripser(p, 1, 0.3)\njob_small = lambda: 0\n"}))
    n = scale(100000)
    found.append(("Delaunay triangulation, 3D, %d points" % n,
                  ours("p = rng.random((%d, 3))" % n, "netmesh.delaunay(p).cells"),
                  {"scipy": "from scipy.spatial import Delaunay\np = rng.random((%d, 3))\n"
                   "job = lambda: Delaunay(p).simplices\njob_small = lambda: Delaunay(p[:20])\n" % n}))
    n = scale(2000)
    found.append(("bottleneck distance, %d bars each" % n,
                  ours(diagrams % (n, n), "netmesh.bottleneck(p, b[:len(p)])"),
                  {"gudhi": "import gudhi\n" + diagrams % (n, n) + "\njob = lambda: gudhi.bottleneck_distance(a, b)\n"
                   "job_small = lambda: gudhi.bottleneck_distance(a[:20], b[:20])\n"}))
    n = scale(1000)
    found.append(("Wasserstein distance of order 2, %d bars each" % n,
                  ours(diagrams % (n, n), "netmesh.wasserstein(p, b[:len(p)], 2)"),
                  {"scipy": "from scipy.optimize import linear_sum_assignment\n" + diagrams % (n, n) +
                   "\ndef job(a=a, b=b):\n    n = len(a)\n    cost = np.zeros((2 * n, 2 * n))\n"
                   "    cost[:n, :n] = np.abs(a[:, None] - b[None]).max(axis=2)\n"
                   "    cost[:n, n:] = ((a[:, 1] - a[:, 0]) / 2)[:, None]\n"
                   "    cost[n:, :n] = ((b[:, 1] - b[:, 0]) / 2)[None]\n    cost **= 2\n"
                   "    return cost[linear_sum_assignment(cost)].sum() ** 0.5\n"
                   "job_small = lambda: job(a[:20], b[:20])\n"}))
    n = scale(2000)
    found.append(("alpha diagrams of 200 clouds of %d points, 2D" % (n // 20),
                  ours("p = [noisy_sphere(%d, 2) for _ in range(200)]" % (n // 20),
                       "[netmesh.persist(x).intervals(1) for x in p]"),
                  {"gudhi": "import gudhi\np = [noisy_sphere(%d, 2) for _ in range(200)]\n"
                   "def one(x):\n    tree = gudhi.AlphaComplex(points=x).create_simplex_tree()\n"
                   "    tree.compute_persistence()\n    return tree.persistence_intervals_in_dimension(1)\n"
                   "job = lambda: [one(x) for x in p]\njob_small = lambda: one(p[0])\n" % (n // 20)}))
    return found


def measure(program):
    environment = dict(os.environ, PYTHONPATH=os.path.join(ROOT, "platform", "python"), OMP_NUM_THREADS="1")
    with tempfile.NamedTemporaryFile("w", suffix=".py") as file:
        # A program of its own says what its peak is.
        end = END.replace("def peak():\n    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024\n", "") \
            if "def peak" in program else END
        file.write(COMMON + program + end)
        file.flush()
        said = subprocess.run([sys.executable, file.name], stdout=subprocess.PIPE, env=environment, check=True)
    return json.loads(said.stdout.decode().splitlines()[-1])


def is_there(peer):
    if peer == "ripser":
        return bool(shutil.which(peer)) and os.path.exists("/usr/bin/time")
    return bool(importlib.util.find_spec(peer))


def put_into_readme(lines):
    path = os.path.join(ROOT, "platform", "python", "README.md")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    begin, end = "<!-- tests/python/bench.py --readme -->\n", "<!-- end -->"
    head, rest = text.split(begin)
    with open(path, "w", encoding="utf-8") as file:
        file.write(head + begin + "\n" + "\n".join(lines) + "\n\n" + end + rest.split(end, 1)[1])


def compare_with_c():
    """The best of runs that take turns, as the machine is shared."""
    sys.path.insert(0, os.path.join(ROOT, "platform", "python"))
    import netmesh
    import numpy as np

    def cells(points):
        with netmesh.delaunay(points) as made:
            made.vertices, made.cells
            return made.fingerprint

    calls = {"alpha": lambda points: netmesh.persist(points, "alpha").fingerprint, "delaunay": cells}
    good = True
    for n, times, rounds in ((10, 2000, 5), (100000, 1, 10)):
        points = np.random.default_rng(1).random((n, 3))
        ours, theirs = {}, {}
        with tempfile.NamedTemporaryFile() as file:
            points.tofile(file.name)
            for _ in range(rounds):
                said = subprocess.run([os.environ["NETMESH_PLAIN"], file.name, "3", str(times)],
                                      stdout=subprocess.PIPE, check=True).stdout.decode().split()
                for name, fingerprint, seconds in zip(said[::3], said[1::3], said[2::3]):
                    assert calls[name](points) == fingerprint
                    theirs[name] = min(theirs.get(name, float("inf")), float(seconds))
                    for _ in range(times):
                        begin = time.perf_counter()
                        calls[name](points)
                        ours[name] = min(ours.get(name, float("inf")), time.perf_counter() - begin)
        for name in ours:
            more = ours[name] - theirs[name]
            good = good and (more <= 50e-6 if n == 10 else more <= 0.03 * theirs[name])
            print("%s of %d points: in C %.6f s, here %.1f us (%.2f %%) more" % (
                name, n, theirs[name], 1e6 * more, 100 * more / theirs[name]))
    return good


def main():
    if "--overhead" in sys.argv:
        return 0 if compare_with_c() else 1
    lines = []

    def say(line):
        lines.append(line)
        print(line, flush=True)

    say("| job | netmesh | peer | peer's time over ours | memory over ours |")
    say("|---|---|---|---|---|")
    for name, program, peers in jobs():
        ours_found = measure(program)
        row = "%.4g s, %.1f MiB" % (ours_found["seconds"], ours_found["bytes"] / 2 ** 20)
        for peer, theirs in peers.items():
            if not is_there(peer):
                say("| %s | %s | %s is not installed | | |" % (name, row, peer))
                continue
            found = measure(theirs)
            # Below a page or so nothing is said of memory.
            least = 2 ** 18
            memory = "%.1f" % (found["bytes"] / ours_found["bytes"]) if min(
                found["bytes"], ours_found["bytes"]) >= least else "-"
            say("| %s | %s | %s: %.4g s, %.1f MiB | %.1f | %s |" % (
                name, row, peer, found["seconds"], found["bytes"] / 2 ** 20, found["seconds"] / ours_found["seconds"],
                memory))
    if "--readme" in sys.argv:
        put_into_readme(lines)


if __name__ == "__main__":
    sys.exit(main())
