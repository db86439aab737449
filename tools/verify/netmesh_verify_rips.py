#!/usr/bin/env python3
"""Verifies an exact Rips or Cech diagram, or that of a listed complex:
netmesh_verify_rips.py INPUT DIAGRAM PROOF [--quiet]
The reading of tools/docs/proofs.md, "Rips, Cech and listed complexes", in plain Python, the standard library alone,
no code shared with netmesh. Every simplex is listed with its facets and cofaces, columns are sets, and distances of
points are roots of integers. Meant for small inputs: up to some ten thousand simplices.
Exit: 0 verified; 7 not proven (step and place on stderr); 2 usage; 3 a file cannot be read or is malformed.
"""
import math
import re
import struct
import sys
from collections import Counter
from fractions import Fraction
from itertools import combinations
from pathlib import Path

INF = math.inf
NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)


class Malformed(Exception):
    """A file that is not of its format."""


class NotProven(Exception):
    """Step and place."""


def need(holds, step, what):
    if not holds:
        raise NotProven(f"not proven: step {step}: {what}")


# ---- Step 1: files ----

def fingerprint(words):
    mask = 2**64 - 1

    def mix(z):
        z = (z + 0x9E3779B97F4A7C15) & mask
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return z ^ (z >> 31)

    state = 0x6E65746D65736800
    for word in words:
        state = (mix(state ^ word) + 0x632BE59BD9B4E019 * word) & mask
    return mix(state)


def bits(x):
    return struct.unpack("<Q", struct.pack("<d", x + 0.0))[0]


def double(word, where):
    if not NUMBER.fullmatch(word):
        raise Malformed(f"{where}: not a number: {word}")
    x = float(word) + 0.0
    if math.isinf(x):
        raise Malformed(f"{where}: beyond the largest double")
    return x


def lines_of(name):
    try:
        return Path(name).read_text(encoding="ascii").split("\n")
    except (OSError, UnicodeError) as error:
        raise Malformed(f"{name}: {error}") from error


def read_rows(name, header=False, never=False):
    rows = []
    for number, line in enumerate(lines_of(name), 1):
        line = line.strip(" \t\r")
        if not line or line.startswith("#"):
            continue
        words = re.split(r"[ \t]*[,;][ \t]*|[ \t]+", line)
        if header and not any(NUMBER.fullmatch(word) for word in words):
            header = False
            continue
        header = False
        rows.append([INF if never and w == "inf" else double(w, f"{name}, line {number}") for w in words])
    if not rows:
        raise Malformed(f"{name}: nothing in it")
    return rows


def read_diagram(name):
    head, bars, lines = {}, [], lines_of(name)
    for number, line in enumerate(lines[:-1] if lines[-1] == "" else lines, 1):
        words = line.split()
        if words and words[0].startswith("#"):
            if words[0] == "#" and len(words) > 1:
                head[words[1]] = words[2] if len(words) == 3 and words[1] not in head else "?"
            continue
        where = f"{name}, line {number}"
        if len(words) != 3 or not re.fullmatch(r"\d+", words[0]):
            raise Malformed(f"{where}: not degree, birth and death")
        death = INF if words[2] == "inf" else double(words[2], where)
        bars.append((int(words[0]), double(words[1], where), death))
    if bars != sorted(bars):
        raise Malformed(f"{name}: bars are not sorted")
    for claim in ("box", "cell", "radii", "weights", "a"):
        if claim in head:
            raise Malformed(f"{name}: by its head it claims something else: # {claim}")
    return head, bars


class Proof:
    def __init__(self, name, bars):
        data = Path(name).read_bytes() if Path(name).is_file() else b""
        if data[:16] != b"netmesh proof 3\n":
            raise Malformed(f"{name}: not a proof of version 3")
        need(len(data) >= 72, 1, "the proof is too short")
        body = data[:-8] + bytes(-len(data) % 8)
        words = struct.unpack(f"<{len(body) // 8}Q", body)
        need(struct.unpack("<Q", data[-8:])[0] == fingerprint([len(data) - 8, *words]), 1, "the proof is damaged")
        self.kind, self.dim, self.n, self.degree, self.limit, self.input, diagram = struct.unpack("<IIQQdQQ",
                                                                                                  data[16:64])
        need(3 <= self.kind <= 6 and self.limit >= 0 and 0 < self.n < 2**32 - 1 and self.degree <= 31 and
             (self.kind in (3, 6) or self.dim == 0) and (self.kind < 5 or self.limit == 0), 1,
             "a number that cannot be")
        need(diagram == fingerprint(w for d, b, e in bars for w in (d, bits(b), bits(e))), 1, "not of this diagram")
        self.data, self.at = data[:-8], 64

    def number(self):
        value = 0
        for shift in range(0, 35, 7):
            need(self.at < len(self.data), 1, "the proof is too short")
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 127) << shift
            if byte < 128:
                need(byte > 0 or shift == 0, 1, "a number of more bytes than it takes")
                return value
        raise NotProven("not proven: step 1: a number of more bytes than it takes")


# ---- Step 2: the complex. Of each dimension a list of (vertices, value) in order ----

def nearest_root(square):
    digits = 1100  # all doubles and what lies in the middle of two are whole numbers in these units
    whole = square.numerator * square.denominator << 2 * digits
    root = math.isqrt(whole)
    try:
        return float(Fraction(2 * root + (root * root < whole), square.denominator << (digits + 1)))
    except OverflowError:
        return INF


def half_distance(a, b):
    return nearest_root(sum((Fraction(x) - Fraction(y)) ** 2 for x, y in zip(a, b)) / 4)


def read_points(name, head, proof):
    rows = read_rows(name, header=True)
    points = list(dict.fromkeys(map(tuple, rows)))
    if any(len(row) != len(rows[0]) for row in rows):
        raise Malformed(f"{name}: rows of different lengths")
    for key, due in (("dim", len(rows[0])), ("points", len(rows)), ("duplicates", len(rows) - len(points))):
        need(head.get(key, "0" if key == "duplicates" else "") == str(due), 1, f"the head must say {key} {due}")
    need(proof.dim == len(rows[0]) and proof.n == len(points), 1, "not of so many points, or dimensions")
    need(proof.input == fingerprint([proof.dim, *(bits(x) for point in points for x in point)]), 1, "other points")
    return points


def points_edges(name, head, proof):
    points = read_points(name, head, proof)
    return {(i, j): (Fraction(0), half_distance(points[i], points[j])) for i in range(proof.n) for j in range(i)}


def distances_edges(name, head, proof):
    rows = read_rows(name, never=True)
    words, d = [], {}
    if "sparse" in head:
        for row in rows:
            if len(row) != 3 or not all(0 <= x < 2**26 and x == int(x) for x in row[:2]) or not row[2] >= 0:
                raise Malformed(f"{name}: not two points and a distance")
            i, j = int(max(row[:2])), int(min(row[:2]))
            if (i == j and row[2] != 0) or d.setdefault((i, j), row[2]) != row[2]:
                raise Malformed(f"{name}: two distances of one pair")
        n = 1 + max(i for i, _ in d)
        d = {edge: d[edge] for edge in sorted(d) if edge[0] != edge[1]}
        words = [word for (i, j), x in d.items() for word in (i, j, bits(x / 2))]
    else:
        if len(rows[0]) == 1 and (len(rows) > 1 or rows[0][0] != 0):  # a lower triangle, with its diagonal or not
            if any(len(row) != i + 1 for i, row in enumerate(rows)):
                raise Malformed(f"{name}: neither a square nor a lower triangle")
            rows = [row[:-1] for row in rows] if len(rows) > 1 and all(r[-1] == 0 for r in rows) else [[], *rows]
        elif any(len(row) != len(rows) or row[i] != 0 or any(rows[i][j] != rows[j][i] for j in range(i))
                 for i, row in enumerate(rows)):
            raise Malformed(f"{name}: neither a symmetric square nor a lower triangle")
        n = len(rows)
        d = {(i, j): rows[i][j] for i in range(n) for j in range(i)}
        words = [bits(x / 2) for x in d.values()]
    if any(x < 0 for x in d.values()):
        raise Malformed(f"{name}: a negative distance")
    need(proof.n == n and proof.input == fingerprint([n, *words]), 1, "other distances")
    return {edge: (Fraction(x) / 2, x / 2) for edge, x in d.items() if x < INF}


def rips(edges, head, proof):
    threshold = double(head["threshold"], "# threshold") if "threshold" in head else INF
    need(head.get("max-degree") == str(proof.degree), 1, f"the head must say max-degree {proof.degree}")
    edges = {edge: value for edge, (exact, value) in edges.items()
             if exact <= threshold and value <= min(threshold, proof.limit) and value < INF}
    joined = Counter(v for edge in edges for v in edge)
    need(proof.limit >= threshold or proof.n - 1 in [joined[v] for v in range(proof.n)], 2,
         "no point is joined to all others up to the limit")
    order = sorted(edges, key=lambda edge: (edges[edge], edge))
    rank = {frozenset(edge): at for at, edge in enumerate(order)}
    levels, cliques = [[((v,), 0.0) for v in range(proof.n)]], [(v,) for v in range(proof.n)]
    for _ in range(proof.degree + 1):
        cliques = [c + (v,) for c in cliques for v in range(c[-1] + 1, proof.n)
                   if all(frozenset((u, v)) in rank for u in c)]
        level = []
        for c in cliques:
            last = max(rank[frozenset((u, v))] for u in c for v in c if u < v)
            level.append((last, [v for v in reversed(c) if v not in order[last]], c))
        levels.append([(c, edges[order[last]]) for last, _, c in sorted(level)])
    return levels


def centred_radius(points):
    """Of the smallest sphere through the points if its centre is strictly inside of them, else None."""
    origin, *others = ([Fraction(x) for x in point] for point in points)
    edges = [[x - y for x, y in zip(point, origin)] for point in others]
    squares = [sum(x * x for x in edge) for edge in edges]
    rows = [[2 * sum(x * y for x, y in zip(a, b)) for b in edges] + [square] for a, square in zip(edges, squares)]
    for i, row in enumerate(rows):  # 2 v_i v_j x_j = v_i v_i; the matrix has no negative pivots
        if row[i] == 0:
            return None
        row[:] = [x / row[i] for x in row]
        for other in rows:
            if other is not row:
                other[:] = [x - other[i] * y for x, y in zip(other, row)]
    centre = [row[-1] for row in rows]
    if min(centre) <= 0 or sum(centre) >= 1:
        return None
    return nearest_root(sum(x * square for x, square in zip(centre, squares)) / 2)


def cech(name, head, proof):
    need(head.get("max-degree") == str(proof.degree), 1, f"the head must say max-degree {proof.degree}")
    need("threshold" not in head, 1, "up to a threshold, not the whole complex")
    points = read_points(name, head, proof)
    levels = [[((v,), 0.0) for v in range(proof.n)]]
    for size in range(2, proof.degree + 3):
        below = dict(levels[-1])
        level = []
        for s in combinations(range(proof.n), size):
            own = centred_radius([points[v] for v in s]) if size <= proof.dim + 1 else None
            level.append((s, own if own is not None else max(below[s[:i] + s[i + 1:]] for i in range(size))))
        levels.append(sorted(level, key=lambda row: row[1]))
    return levels


def listed(name, head, proof):
    need("filter" not in head, 1, "of a filter, not of a complex that is listed")
    rows = [(tuple(sorted(row[:-1])), row[-1]) for row in read_rows(name)]
    if not all(0 < len(set(s)) == len(s) <= 32 and all(0 <= v < 2**32 and v == int(v) for v in s) for s, _ in rows):
        raise Malformed(f"{name}: not vertices and a value")
    values = dict(rows)
    for s, value in rows:
        if any(values.get(s[:i] + s[i + 1:], INF) > value for i in range(len(s)) if len(s) > 1):
            raise Malformed(f"{name}: a face of {s} is missing, or enters later")
    if len(values) < len(rows):
        raise Malformed(f"{name}: a simplex twice")
    need(proof.input == fingerprint(w for s, x in rows for w in (len(s), *map(int, s), bits(x))), 1, "another complex")
    levels = [sorted((row for row in rows if len(row[0]) == p + 1), key=lambda row: row[1]) for p in range(33)]
    need(proof.n == len(levels[0]) and levels[proof.degree], 1, "not of so many vertices, or of such a degree")
    return levels


# ---- Step 3: columns ----

def columns(levels, proof):
    bars, below = [], set()
    for p in range(proof.degree + 1):
        low, high = levels[p], levels[p + 1]
        place = {s: i for i, (s, _) in enumerate(low)}
        facets = [[place[s[:i] + s[i + 1:]] for i in range(p + 2)] for s, _ in high]
        cofaces = [set() for _ in low]
        for i, row in enumerate(facets):
            for facet in row:
                cofaces[facet].add(i)
        shortcut = {}  # of p-simplices and their cofaces, the latter in front
        for i, row in enumerate(facets):
            if min(cofaces[max(row)]) == i:
                shortcut[i] = max(row)
        births = {facet: i for i, facet in shortcut.items()}
        pivots, order, by_pivot = dict(shortcut.items()), [], {}
        plain = proof.number() if p > 0 else 0
        for key in reversed(range(len(low))):
            if key in below:
                continue
            if key in births:
                bars.append((p, low[key][1], high[births[key]][1]))
                continue
            total = set(cofaces[key])
            if plain > 0:
                plain -= 1
                if plain == 0:
                    last = len(order)
                    for _ in range(proof.number() + 1):
                        last -= proof.number() + 1
                        need(last >= 0, 1, f"degree {p}: a column that is not before the one it is added to")
                        total ^= cofaces[order[last]]
                    plain = proof.number()
            order.append(key)
            while total:
                pivot = min(total)
                if pivot in shortcut:
                    total ^= cofaces[shortcut[pivot]]
                elif p == 0 and pivot in by_pivot:  # vertices have no columns in the file
                    total ^= by_pivot[pivot]
                else:
                    break
            if total:
                need(min(total) not in pivots, 3, f"degree {p}, column {len(order) - 1}: another one has its pivot")
                pivots[min(total)] = key
                by_pivot[min(total)] = total
            bars.append((p, low[key][1], high[min(total)][1] if total else INF))
        need(plain == 0, 3, f"degree {p}: more columns than there are")
        below = set(pivots)
    need(proof.at == len(proof.data), 1, "bytes behind the end")
    return Counter(bar for bar in bars if bar[1] != bar[2])


# ---- Step 4 ----

def verify(name, diagram, proof_name):
    head, bars = read_diagram(diagram)
    proof = Proof(proof_name, bars)
    if proof.kind == 5:
        levels = listed(name, head, proof)
    else:
        which = "cech" if proof.kind == 6 else "rips"
        need(head.get("filter") == which, 1, f"not one line # filter {which}")
        need(("distances" in head) == (proof.kind == 4), 1, "# distances, or points?")
        if proof.kind == 6:
            levels = cech(name, head, proof)
        else:
            levels = rips((points_edges if proof.kind == 3 else distances_edges)(name, head, proof), head, proof)
    found, claimed = columns(levels, proof), Counter(bars)
    for bar in sorted((found - claimed) + (claimed - found)):
        need(False, 4, f"the bar {bar} is {'missing' if found[bar] > claimed[bar] else 'not there, or not so often'}")
    return f"verified   {diagram}: degrees 0 to {proof.degree}"


def main(words):
    quiet = words[3:] == ["--quiet"]
    if len(words) != 3 and not quiet:
        print("usage: netmesh_verify_rips.py INPUT DIAGRAM PROOF [--quiet]", file=sys.stderr)
        return 2
    try:
        report = verify(*words[:3])
        if not quiet:
            print(report)
        return 0
    except (Malformed, NotProven, MemoryError) as failure:
        print(f"netmesh_verify_rips: {failure or 'memory'}", file=sys.stderr)
        return 7 if isinstance(failure, NotProven) else 3


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
