#!/usr/bin/env python3
"""Proofs of Rips and Cech diagrams and of listed complexes: rips.py NETMESH VERIFY WORK [--inputs N] [--forgeries N]

- Honest proofs of N inputs: points at random, on lattices, flat, equal, units in the last place apart, of all sizes;
  matrices, triangles and lists of distances with ties and infinite ones; complexes with ties and negative values; with
  thresholds and without. Both verifiers accept them, and the bars are those of a plain reduction of boundaries here.
- Forgeries, by hand and at random, in which every fingerprint is right: refused, where the forged thing is surely
  wrong. Else both verifiers say the same, and what they accept is true by the plain reduction.
"""
import argparse
import collections
import itertools
import math
import os
import random
import shutil
import struct
import subprocess
import sys
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/verify"))
import netmesh_verify_rips
import run
from run import ACCEPTED, REFUSED, UNREADABLE, bits_of, fingerprint, fingerprint_of_bytes, next_double, spelled

INF = math.inf
HEAD_BYTES = 64


# ---- inputs ----

def points(r, kind):
    dim = r.randrange(1, 5)
    count = r.randrange(2, 13)
    if kind == "lattice":
        rows = [[float(r.randrange(3)) for _ in range(dim)] for _ in range(count)]
    elif kind == "last digits":  # distances that are equal, or differ in their last digits
        rows = [[r.choice([0.1, 0.2, 0.3, 0.1 + 0.2, 0.7, 0.7999999999999999, 0.8]) for _ in range(dim)]
                for _ in range(count)]
    elif kind == "circle":
        rows = [[math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count)] for i in range(count)]
    elif kind == "flat":
        axes = [[r.choice([0.0, 1.0, 3.0]) for _ in range(dim + 1)] for _ in range(2)]
        rows = [[s * a + t * b for a, b in zip(*axes)]
                for s, t in ((r.randrange(-2, 3) / 4, r.random()) for _ in range(count))]
    elif kind == "sizes":
        far = r.choice([30, 300, 1020])
        rows = [[r.uniform(-1, 1) * 2.0 ** r.randrange(-far, far) for _ in range(dim)] for _ in range(count)]
    elif kind == "tiny":
        rows = [[r.randrange(-6, 7) * 5e-324 for _ in range(dim)] for _ in range(count)]
    else:
        rows = [[r.uniform(-1, 1) for _ in range(dim)] for _ in range(count)]
    if r.random() < 0.3:
        rows += [list(r.choice(rows)) for _ in range(2)]
    return rows


def distances(r, kind):
    n = r.randrange(2, 12)
    draw = {"random": r.random, "ties": lambda: float(r.randrange(1, 4)), "infinite": lambda: r.choice([1.0, 2.0, INF]),
            "tiny": lambda: r.randrange(1, 8) * 5e-324, "huge": lambda: r.choice([1.0, 1.7e308, 1e308])}[kind]
    d = [[0.0] * n for _ in range(n)]
    for i in range(n):
        for j in range(i):
            d[i][j] = d[j][i] = draw()
    form = r.choice(["full", "lower", "sparse"])
    if form == "full":
        return form, d
    if form == "lower":
        return form, [d[i][:i] for i in range(1, n)]
    entries = [[i, j, d[i][j]] for i in range(n) for j in range(n) if i != j and r.random() < 0.5]
    return form, entries or [[0, 1, 1.0]]


def complex_rows(r, kind):
    """Vertices and a value, every face before what it is a face of."""
    n = r.randrange(1, 10)
    labels = r.sample(range(100), n)
    tops = [r.sample(labels, r.randrange(1, min(n, 5) + 1)) for _ in range(r.randrange(1, 14))]
    faces = {tuple(sorted(f)) for top in tops for k in range(1, len(top) + 1) for f in itertools.combinations(top, k)}
    values = {}
    for face in sorted(faces, key=len):
        value = r.randrange(-2, 3) / 2 if kind == "ties" else r.uniform(-1, 1) if kind == "random" else 0.0
        below = [values[face[:i] + face[i + 1:]] for i in range(len(face)) if len(face) > 1]
        values[face] = max([value, *below])
    rows = [[*r.sample(face, len(face)), value] for face, value in values.items()]
    r.shuffle(rows)
    return rows


# ---- the truth ----

def square_of(a, b):
    return sum((Fraction(x) - Fraction(y)) ** 2 for x, y in zip(a, b))


def half_of(a, b):
    return root_of(square_of(a, b) / 4)


def root_of(number):
    """The nearest double to its root, by the squares of what is half way between two."""
    low, high = 0, bits_of(INF)

    def middle(bits):  # of that double and the next one; beyond the largest one of what would be next
        x, y = (struct.unpack("<d", struct.pack("<Q", b))[0] for b in (bits, bits + 1))
        return (Fraction(x) + (Fraction(y) if y < INF else Fraction(2) ** 1024)) / 2

    while low < high:
        at = (low + high) // 2
        square = middle(at) ** 2
        if square < number or (square == number and at % 2 == 1):
            low = at + 1
        else:
            high = at
    return struct.unpack("<d", struct.pack("<Q", low))[0]


def flag_complex(count, value, top):
    """All sets of up to top + 1 vertices that are joined, by value(i, j) or None."""
    simplices = {}
    for size in range(1, top + 2):
        for s in itertools.combinations(range(count), size):
            edges = [value(j, i) for i, j in itertools.combinations(s, 2)]
            if all(e is not None for e in edges):
                simplices[s] = max(edges, default=0.0)
    return simplices


def determinant(rows):
    rows, result = [list(row) for row in rows], Fraction(1)
    for i in range(len(rows)):
        at = next((r for r in range(i, len(rows)) if rows[r][i] != 0), None)
        if at is None:
            return Fraction(0)
        result *= rows[at][i] if at == i else -rows[at][i]
        rows[i], rows[at] = rows[at], rows[i]
        for r in range(i + 1, len(rows)):
            factor = rows[r][i] / rows[i][i]
            rows[r] = [x - factor * y for x, y in zip(rows[r], rows[i])]
    return result


def centred_square(s, squares):
    """Square of the radius of the smallest sphere through these points if its centre is strictly inside of them, else
    0: by the determinants of Cayley and Menger, whose cofactors are the centre's coordinates."""
    inner = [[squares[frozenset((a, b))] if a != b else Fraction(0) for b in s] for a in s]
    bordered = [[Fraction(0)] + [Fraction(1)] * len(s)] + [[Fraction(1)] + row for row in inner]
    whole = determinant(bordered)
    if whole == 0:
        return Fraction(0)
    for i in range(1, len(s) + 1):
        cofactor = determinant([row[:i] + row[i + 1:] for row in bordered[1:]]) * (-1) ** i
        if cofactor * whole <= 0:
            return Fraction(0)
    return -determinant(inner) / whole / 2


def cech_complex(rows, top):
    """All sets of up to top + 1 points: a smallest enclosing ball is the largest of its subsets' that are centred."""
    squares = {frozenset((i, j)): square_of(rows[i], rows[j]) for i, j in itertools.combinations(range(len(rows)), 2)}
    balls, simplices = {}, {}
    for size in range(1, top + 2):
        for s in itertools.combinations(range(len(rows)), size):
            own = centred_square(s, squares) if 2 <= size <= len(rows[0]) + 1 else Fraction(0)
            balls[s] = max([own, *(balls[s[:i] + s[i + 1:]] for i in range(size) if size > 1)])
            simplices[s] = root_of(balls[s])
    return simplices


def bars_of(simplices, top):
    """The standard algorithm on boundaries."""
    order = sorted(simplices, key=lambda s: (simplices[s], len(s), s))
    place = {s: i for i, s in enumerate(order)}
    lowest, bars, births = {}, [], set()
    for j, s in enumerate(order):
        column = {place[s[:i] + s[i + 1:]] for i in range(len(s))} if len(s) > 1 else set()
        while column and max(column) in lowest:
            column ^= lowest[max(column)]
        if column:
            i = max(column)
            lowest[i] = column
            births.discard(i)
            bars.append([len(s) - 2, simplices[order[i]], simplices[s]])
        else:
            births.add(j)
    bars += [[len(order[i]) - 1, simplices[order[i]], INF] for i in births]
    return sorted(bar for bar in bars if bar[0] <= top and bar[1] != bar[2])


def write_row(file, row, whole):
    """The first ones are whole numbers."""
    file.write(" ".join([str(int(x)) for x in row[:whole]] + [repr(x) for x in row[whole:]]) + "\n")


class Case:
    """An input, its diagram and proof, as lists that can be forged."""

    words = None  # of the input, where they are not to be those of the case

    def __init__(self, stem):
        with open(stem + ".txt", encoding="ascii") as file:
            self.rows = [[float(x) for x in line.split()] for line in file]
        with open(stem + ".pers", encoding="ascii") as file:
            lines = file.read().splitlines()
        self.head = [line for line in lines if line.startswith("#")]
        self.bars = [[int(d), float(b), float(e)] for d, b, e in (line.split() for line in lines[len(self.head):])]
        with open(stem + ".proof", "rb") as file:
            data = file.read()
        self.kind, self.space, self.n, self.degree, self.limit = struct.unpack_from("<IIQQd", data, 16)
        self.sort = self.kind          # of the input, whatever the proof says
        self.dim = self.degree + 1     # for forgeries of bars: degrees are below
        at, self.columns = HEAD_BYTES, []  # of each degree: columns before, and numbers of what is added to one

        def number():
            nonlocal at
            value, shift = 0, 0
            while True:
                byte = data[at]
                at += 1
                value |= (byte & 127) << shift
                shift += 7
                if byte < 128:
                    return value

        for _ in range(self.degree):
            entries, skipped = [], number()
            while skipped > 0:
                entries.append([skipped - 1, [number() for _ in range(number() + 1)]])
                skipped = number()
            self.columns.append(entries)

    def word(self, name):
        return next((line.split()[2] if len(line.split()) > 2 else "" for line in self.head
                     if line.split()[1] == name), None)

    def threshold(self):
        return float(self.word("threshold") or "inf")

    def different(self):
        return [list(row) for row in dict.fromkeys(tuple(x + 0.0 for x in row) for row in self.rows)]

    def pairs(self):
        """Distances of i > j, of a matrix or a list; None where the file is none."""
        if self.word("sparse") is not None:
            return {(int(max(a, b)), int(min(a, b))): d for a, b, d in self.rows if a != b}
        rows = self.rows if len(self.rows[0]) == len(self.rows) and len(self.rows) > 1 else [[], *self.rows]
        return {(i, j): rows[i][j] for i in range(len(rows)) for j in range(i)}

    def input_words(self):
        if self.kind in (3, 6):
            return [len(self.rows[0]), *(bits_of(x) for row in self.different() for x in row)]
        if self.kind == 5:
            return [w for row in self.rows for w in (len(row) - 1, *sorted(map(int, row[:-1])), bits_of(row[-1]))]
        pairs = sorted(self.pairs().items())
        if self.word("sparse") is not None:
            return [self.n, *(w for (i, j), d in pairs for w in (i, j, bits_of(d / 2)))]
        return [self.n, *(bits_of(d / 2) for _, d in pairs)]

    def truth(self):
        if self.kind == 5:
            return bars_of({tuple(sorted(map(int, row[:-1]))): row[-1] for row in self.rows}, self.degree)
        if self.kind == 6:
            return bars_of(cech_complex(self.different(), self.degree + 1), self.degree)
        threshold = self.threshold()
        if self.kind == 3:
            rows = self.different()
            halves = {(i, j): half_of(rows[i], rows[j]) for i in range(len(rows)) for j in range(i)}
            halves = {edge: half for edge, half in halves.items() if half <= threshold}
        else:
            halves = {edge: d / 2 for edge, d in self.pairs().items() if d < INF and Fraction(d) / 2 <= threshold}
        count = self.n if self.kind == 4 else len(rows)
        return bars_of(flag_complex(count, lambda i, j: halves.get((i, j)), self.degree + 1), self.degree)

    def body(self):
        body = bytearray(b"netmesh proof 3\n")
        words = [w for d, b, e in self.bars for w in (d, bits_of(b), bits_of(e))]
        body += struct.pack("<IIQQdQQ", self.kind, self.space, self.n, self.degree, self.limit,
                            fingerprint(self.words or self.input_words()), fingerprint(words))
        for entries in self.columns:
            for skipped, gaps in entries:
                body += spelled(skipped + 1) + spelled(len(gaps) - 1) + b"".join(map(spelled, gaps))
            body += b"\0"
        return bytes(body)

    def write(self, stem, body=None):
        with open(stem + ".txt", "w", encoding="ascii") as file:
            for row in self.rows:
                write_row(file, row, len(row) - 1 if self.sort == 5 else 2 if self.word("sparse") is not None else 0)
        with open(stem + ".pers", "w", encoding="ascii") as file:
            file.writelines(line + "\n" for line in self.head)
            file.writelines(f"{d} {b!r} {e!r}\n" for d, b, e in self.bars)
        body = self.body() if body is None else body
        with open(stem + ".proof", "wb") as file:
            file.write(body + struct.pack("<Q", fingerprint_of_bytes(body)))


# ---- forgeries: each changes a case and says whether that is surely wrong; None: it does not apply ----

def some_column(case, r):
    places = [(p, i) for p, entries in enumerate(case.columns) for i in range(len(entries))]
    return r.choice(places) if places else (None, None)


def move_bar(case, r):
    bar = r.choice(case.bars)
    end = r.randrange(1, 3)
    if math.isinf(bar[end]) or (end == 1 and bar[1] == 0 and case.kind != 5):
        return None
    bar[end] = next_double(bar[end], r.random() < 0.5)
    return run.sort_bars(case) if bar[1] < bar[2] < INF or math.isinf(bar[2]) else None


def other_degree(case, r):
    return run.other_degree(case, r) if case.degree > 0 else None


def add_bar(case, r):
    birth = r.choice(case.bars)[2]
    if birth > 1e308:
        return None
    case.bars.append([r.randrange(case.degree + 1), birth, next_double(birth, True)])
    return run.sort_bars(case)


def leave_out_addition(case, r):
    """Nothing, or less, is added to a column."""
    p, i = some_column(case, r)
    if p is None:
        return None
    if r.random() < 0.5:
        skipped, _ = case.columns[p].pop(i)
        if i < len(case.columns[p]):
            case.columns[p][i][0] += skipped + 1
    else:
        gaps = case.columns[p][i][1]
        if len(gaps) < 2:
            return None
        del gaps[r.randrange(len(gaps))]
    return False


def other_addition(case, r):
    """Another column is added."""
    p, i = some_column(case, r)
    if p is None:
        return None
    gaps = case.columns[p][i][1]
    at = r.randrange(len(gaps))
    gaps[at] = max(0, gaps[at] + r.choice([-1, 1]))
    return False


def more_addition(case, r):
    p = r.randrange(len(case.columns)) if case.columns else None
    if p is None:
        return None
    case.columns[p].insert(0, [r.randrange(1, 4), [0]])
    if len(case.columns[p]) > 1:
        left = case.columns[p][1][0] - case.columns[p][0][0] - 1
        if left < 0:
            return None
        case.columns[p][1][0] = left
    return False


def swap_columns(case, r):
    """Two columns exchange what is added to them."""
    p, i = some_column(case, r)
    if p is None or len(case.columns[p]) < 2:
        return None
    j = r.choice([j for j in range(len(case.columns[p])) if j != i])
    a, b = case.columns[p][i], case.columns[p][j]
    if a[1] == b[1]:
        return None
    a[1], b[1] = b[1], a[1]
    return False


def shift_columns(case, r):
    """A column is left out, or there is one more, as if a pair were a shortcut that is none."""
    p, i = some_column(case, r)
    if p is None:
        return None
    case.columns[p][i][0] = max(0, case.columns[p][i][0] + r.choice([-1, 1]))
    return False


def lower_limit(case, r):
    """Edges are left out."""
    if case.kind >= 5:
        return None
    ends = [e for _, _, e in case.bars if 0 < e < INF]
    if not ends:
        return None
    case.limit = next_double(r.choice(ends), False)
    return None if case.limit >= case.threshold() else False


def higher_limit(case, _):
    if case.kind >= 5 or case.limit >= 1e300:
        return None
    case.limit = 2 * case.limit + 1
    return False


def lower_degree(case, r):
    """Bars of the highest degree are left out, and said not to be claimed: true, if head and proof say so."""
    if case.degree == 0:
        return None
    bars = len(case.bars)
    case.bars = [bar for bar in case.bars if bar[0] < case.degree]
    if r.random() < 0.5 or case.kind == 5:  # a listed complex has no head: its proof says of what degrees it is
        case.degree -= 1
        case.columns.pop()
    if r.random() < 0.5 and case.kind != 5:
        case.head = [f"# max-degree {case.degree}" if "max-degree" in line else line for line in case.head]
    return False if len(case.bars) < bars or case.degree >= 0 else None


def change_input(case, r):
    """A number of the input is another one."""
    row = r.choice(case.rows)
    at = len(row) - 1 if case.kind == 5 or case.word("sparse") is not None else r.randrange(len(row) or 1)
    if not row or math.isinf(row[at]) or row[at] == 0 or abs(row[at]) > 1e307:
        return None
    row[at] = r.choice([next_double(row[at], True), next_double(row[at], False), 2 * row[at]])
    if case.kind == 4 and len(case.rows[0]) == len(case.rows) > 1 and case.word("sparse") is None:
        case.rows[at][case.rows.index(row)] = row[at]
    return False


def drop_row(case, r):
    """A point, an entry or a simplex less."""
    if len(case.rows) < 2 or (case.kind == 4 and case.word("sparse") is None):
        return None
    del case.rows[r.randrange(len(case.rows))]
    return False


def other_number(case, r):
    case.words = case.input_words()
    name = r.choice(["kind", "space", "n", "degree"])
    before = getattr(case, name)
    setattr(case, name, max(0, before + r.choice([-1, 1])))
    return True if getattr(case, name) != before else None


def other_head(case, r):
    """The head claims something else."""
    if case.kind == 5:
        case.head.append("# filter rips")
        return True
    choice = r.randrange(5)
    if choice == 0:
        case.head = [line for line in case.head if not line.startswith("# filter")] + [
            r.choice(["# filter alpha", "# filter cech" if case.kind != 6 else "# filter rips"])]
    elif choice == 1:
        case.head = [line for line in case.head if line != "# distances"] if case.kind == 4 else [*case.head,
                                                                                                  "# distances"]
    elif choice == 2:
        case.head.append("# a choice of 1 of 2")
    elif choice == 3:
        case.head.append("# box 0:10,0:10")
    else:
        case.head.append(f"# max-degree {case.degree}")  # twice
    return True


def other_threshold(case, r):
    if case.kind == 5:
        return None
    case.head = [line for line in case.head if "threshold" not in line]
    ends = [e for _, _, e in case.bars if 0 < e < INF]
    if ends and r.random() < 0.8:
        case.head.append(f"# threshold {r.choice([next_double(r.choice(ends), False), r.choice(ends)])!r}")
    return False


FORGERIES = [run.drop_bar, run.double_bar, run.swap_deaths, other_degree, run.end_essential, move_bar, add_bar,
             leave_out_addition, other_addition, more_addition, swap_columns, shift_columns, lower_limit, higher_limit,
             lower_degree, change_input, drop_row, other_number, other_head, other_threshold]


class Runner:
    def __init__(self, arguments):
        self.a = arguments
        self.counts = collections.Counter()
        self.faults = []

    def fault(self, stem, text):
        self.faults.append(f"{stem}: {text}")
        print(self.faults[-1])

    def verdict(self, stem):
        done = subprocess.run([self.a.verify, *(stem + e for e in (".txt", ".pers", ".proof"))], capture_output=True,
                              text=True, check=False)
        return done.returncode, (done.stderr or done.stdout).strip()

    @staticmethod
    def verdict_of_python(stem):
        try:
            return ACCEPTED, netmesh_verify_rips.verify(*(stem + e for e in (".txt", ".pers", ".proof")))
        except netmesh_verify_rips.NotProven as failure:
            return REFUSED, str(failure)
        except netmesh_verify_rips.Malformed as failure:
            return UNREADABLE, str(failure)

    def make(self, r, number):
        stem = os.path.join(self.a.work, f"input-{number}")
        sort = number % 4
        if sort in (0, 3):
            kind = r.choice(["random", "lattice", "last digits", "circle", "flat", "sizes", "tiny"])
            rows, words = points(r, kind), ["persist", "--filter", "rips" if sort == 0 else "cech"]
            rows = rows if sort == 0 else rows[:8]
        elif sort == 1:
            kind = r.choice(["random", "ties", "infinite", "tiny", "huge"])
            form, rows = distances(r, kind)
            words = ["persist", "--distances", *(["--sparse"] if form == "sparse" else [])]
        else:
            kind = r.choice(["random", "ties", "zero"])
            rows, words = complex_rows(r, kind), ["homology"]
        with open(stem + ".txt", "w", encoding="ascii") as file:
            for row in rows:
                write_row(file, row, len(row) - 1 if sort == 2 else 2 if "--sparse" in words else 0)
        if sort == 3:
            words += ["--max-degree", str(r.randrange(0, 4))]
        elif sort < 2:
            words += ["--max-degree", str(r.randrange(0, 4))]
            if (sort == 0 and len(rows[0]) == 1) or r.random() < 0.4:
                spread = max((abs(x) for row in rows for x in row if abs(x) < INF), default=1.0)
                most = r.choice([spread / 2, spread, 1.0, 0.5, 0.75, 1e300]) or 1.0
                if kind == "tiny":  # halves of distances round
                    most = r.randrange(1, 5) * 5e-324
                words += ["--threshold", repr(most)]
        elif r.random() < 0.3:
            words += ["--max-degree", str(r.randrange(0, 3))]
        done = subprocess.run([self.a.netmesh, words[0], stem + ".txt", *words[1:], "-q", "-o", stem + ".pers",
                               "--proof", stem + ".proof"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            self.counts["no diagram"] += 1
            if done.returncode not in (2, 3, 5):
                self.fault(stem, f"{words}: persist ends with {done.returncode}: {done.stderr}")
            return None
        return stem, f"{' '.join(words[:3]) if sort in (0, 3) else words[0]} {kind}"

    def cut(self, r, good):
        """The diagram up to a threshold and its proof, without the line that says so: edges are left out of both."""
        for _ in range(1000):
            stem = r.choice(good)
            case = Case(stem)
            ends = [e for _, _, e in case.bars if 0 < e < INF]
            if case.kind >= 5 or not ends:
                continue
            at = next_double(r.choice(ends), False)
            forms = ["--" + name for name in ("distances", "sparse") if case.word(name) is not None]
            whole = os.path.join(self.a.work, "cut")
            subprocess.run([self.a.netmesh, "persist", stem + ".txt", "--filter", "rips", *forms, "--threshold",
                            repr(at), "--max-degree", str(case.degree), "-q", "-o", whole + ".pers", "--proof",
                            whole + ".proof"], check=True)
            shutil.copy(stem + ".txt", whole + ".txt")
            forged = Case(whole)
            forged.head = case.head
            if forged.bars != case.bars:
                return forged
        sys.exit("no diagram can be cut")

    def honest(self):
        r = random.Random(self.a.seed)
        good = []
        for number in range(self.a.inputs):
            made = self.make(r, number)
            if made is None:
                continue
            stem, kind = made
            for code, said in (self.verdict(stem), self.verdict_of_python(stem)):
                if code != ACCEPTED:
                    self.fault(stem, f"{kind}: an honest proof is refused: {code} {said}")
            case = Case(stem)
            if case.bars != case.truth():
                self.fault(stem, f"{kind}: not the bars of the plain reduction")
            with open(stem + ".proof", "rb") as file:
                if file.read()[:-8] != case.body():
                    self.fault(stem, f"{kind}: this file spells the proof otherwise")
            self.counts[f"honest, {kind}"] += 1
            good.append(stem)
        return good

    def expect(self, stem, kind, surely_wrong):
        code, said = self.verdict(stem)
        other, heard = self.verdict_of_python(stem)
        self.counts[f"{kind}: {'accepted' if code == ACCEPTED else 'refused'}"] += 1
        if code not in (ACCEPTED, UNREADABLE, REFUSED):
            self.fault(stem, f"{kind}: exit {code} {said}")
        if (other == ACCEPTED) != (code == ACCEPTED):
            self.fault(stem, f"{kind}: {code} {said}, in Python {other} {heard}")
        if code == ACCEPTED and surely_wrong:
            self.fault(stem, f"{kind}: a forgery is accepted")
        if code == ACCEPTED:
            case = Case(stem)
            if case.bars != case.truth():
                self.fault(stem, f"{kind}: what is accepted is not true")
        return len(self.faults)

    def forge(self, good):
        r = random.Random(self.a.seed)
        for done in range(self.a.forgeries):
            stem = os.path.join(self.a.work, f"forged-{done}")
            faults = len(self.faults)
            turn = done % (len(FORGERIES) + 6)
            if turn < len(FORGERIES):
                for _ in range(20000):
                    case = Case(r.choice(good))
                    surely = FORGERIES[turn](case, r) if len(case.bars) > 1 else None
                    if surely is not None:
                        break
                else:
                    sys.exit(f"{FORGERIES[turn].__name__}: applies to no input")
                case.write(stem)
                self.expect(stem, FORGERIES[turn].__name__, surely)
            else:
                case, other = Case(r.choice(good)), Case(r.choice(good))
                body = case.body()
                if turn == len(FORGERIES):
                    case.write(stem, body[:r.randrange(len(body))] if r.random() < 0.7 else body + b"\0")
                    self.expect(stem, "other length", True)
                elif turn == len(FORGERIES) + 1:
                    case.write(stem, body[:HEAD_BYTES] + other.body()[HEAD_BYTES:])
                    self.expect(stem, "another's columns", False)
                elif turn == len(FORGERIES) + 2:
                    case.write(stem, other.body())
                    self.expect(stem, "another's proof", other.input_words() != case.input_words())
                elif turn == len(FORGERIES) + 3:
                    self.cut(r, good).write(stem)
                    self.expect(stem, "cut at a threshold", True)
                else:
                    flipped = bytearray(body)
                    at = r.randrange(len(body)) if r.random() < 0.3 or len(body) == HEAD_BYTES else r.randrange(
                        HEAD_BYTES, len(body))
                    flipped[at] ^= 1 << r.randrange(8)
                    case.write(stem, bytes(flipped))
                    self.expect(stem, "a bit", False)
            if len(self.faults) == faults:
                for ending in (".txt", ".pers", ".proof"):
                    os.remove(stem + ending)
        # As they stand: a fingerprint that is wrong is seen.
        stem = os.path.join(self.a.work, "damaged")
        case = Case(good[0])
        case.write(stem)
        with open(stem + ".proof", "rb") as file:
            data = bytearray(file.read())
        for at in range(len(data)):
            data[at] ^= 0x10
            with open(stem + ".proof", "wb") as file:
                file.write(data)
            self.expect(stem, "damaged", True)
            data[at] ^= 0x10


def main():
    p = argparse.ArgumentParser()
    for name in ("netmesh", "verify", "work"):
        p.add_argument(name)
    p.add_argument("--inputs", type=int, default=150)
    p.add_argument("--forgeries", type=int, default=400)
    p.add_argument("--seed", type=int, default=1)
    runner = Runner(p.parse_args())
    os.makedirs(runner.a.work, exist_ok=True)
    good = runner.honest()
    if len(good) < runner.a.inputs / 2:
        sys.exit("most inputs have no diagram")
    runner.forge(good)
    for kind, count in sorted(runner.counts.items()):
        print(f"{count:8,} {kind}")
    print(f"{len(runner.faults)} faults")
    return 1 if runner.faults else 0


if __name__ == "__main__":
    sys.exit(main())
