#!/usr/bin/env python3
"""Proofs of alpha diagrams against two verifiers that share no code with the engine, the tool, this file or each other.

    run.py NETMESH VERIFY CLOUDS WORK [--clouds N] [--forgeries N] [--seed S] [--twice N]

- Honest proofs of N clouds that are nearly degenerate (proofs_clouds): accepted, of the first --twice by both.
- Forgeries of diagrams, proofs and points, in which every fingerprint is right: refused, where the forged thing is
  surely wrong. Of what can be another valid proof (a bit that is flipped) both verifiers say the same.
"""
import argparse
import collections
import math
import os
import random
import struct
import subprocess
import sys

MASK = (1 << 64) - 1
HEAD_BYTES = 56
ACCEPTED, UNREADABLE, REFUSED = 0, 3, 7
HERE = os.path.dirname(os.path.abspath(__file__))
PYTHON_VERIFIER = os.path.join(HERE, "../../tools/verify/netmesh_verify.py")


def mix(z):
    z = (z + 0x9E3779B97F4A7C15) & MASK
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def fingerprint(words):
    state = 0x6E65746D65736800
    for w in words:
        state = (mix(state ^ w) + 0x632BE59BD9B4E019 * w) & MASK
    return mix(state)


def bits_of(x):
    return struct.unpack("<Q", struct.pack("<d", x + 0.0))[0] if x != 0 else 0


def spelled(n):
    out = bytearray()
    while n >= 0x80:
        out.append(n & 0x7F | 0x80)
        n >>= 7
    out.append(n)
    return bytes(out)


class Case:
    """Points, diagram and proof, each as a list that can be forged. With weights these are the last numbers of rows."""

    def __init__(self, stem):
        with open(stem + ".txt", encoding="ascii") as file:
            self.rows = [[float(x) for x in line.split()] for line in file]
        with open(stem + ".pers", encoding="ascii") as file:
            lines = file.read().splitlines()
        self.head = [line for line in lines if line.startswith("#")]
        self.bars = []
        for line in lines[len(self.head):]:
            degree, birth, death = line.split()
            self.bars.append([int(degree), float(birth), float(death)])
        self.kinds = [line.split()[1] for line in self.head if line.split()[1] in ("radii", "weights")]
        with open(stem + ".proof", "rb") as file:
            self.read(file.read())

    def read(self, data):
        self.kind, self.dim, n, c = struct.unpack_from("<IIQQ", data, 16)
        width = self.row_bytes()
        at = HEAD_BYTES
        hidden = 0
        if self.kinds:
            hidden = struct.unpack_from("<Q", data, at)[0]
            at += 8
        rows = [int.from_bytes(data[at + i * width:at + (i + 1) * width], "little") for i in range(n + hidden)]
        at += (n + hidden) * width

        def number():
            nonlocal at
            value, shift = 0, 0
            while True:
                byte = data[at]
                at += 1
                value |= (byte & 0x7F) << shift
                shift += 7
                if byte < 0x80:
                    return value

        self.cells, first = [], 0
        for _ in range(c):
            cell = []
            for j in range(self.dim + 1):
                value = number()
                cell.append(first + value if j == 0 else cell[-1] + 1 + value)
            first = cell[0]
            self.cells.append(tuple(cell))
        self.list = rows[:n]
        self.hidden = [(row, self.cells[number()]) for row in rows[n:]]
        assert at + 8 == len(data)

    def row_bytes(self):
        return max(1, ((len(self.rows) - 1).bit_length() + 7) // 8)

    def distinct(self):
        seen, points = set(), []
        for row in self.rows:
            key = tuple(x + 0.0 if x != 0 else 0.0 for x in row[:self.dim])
            if key not in seen:
                seen.add(key)
                points.append(row)
        return points

    def points_fingerprint(self):
        of_points = fingerprint([self.dim] + [bits_of(x) for row in self.rows for x in row[:self.dim]])
        if not self.kinds:
            return of_points
        return fingerprint([of_points, int(self.kinds == ["radii"])] + [bits_of(row[-1]) for row in self.rows])

    def bars_fingerprint(self):
        return fingerprint([w for d, b, e in self.bars for w in (d, bits_of(b), bits_of(e))])

    def body(self):
        out = bytearray(b"netmesh proof 2\n" if self.kinds else b"netmesh proof 1\n")
        out += struct.pack("<IIQQQQ", self.kind, self.dim, len(self.list), len(self.cells), self.points_fingerprint(),
                           self.bars_fingerprint())
        if self.kinds:
            out += struct.pack("<Q", len(self.hidden))
        for row in self.list + [row for row, _ in self.hidden]:
            out += row.to_bytes(self.row_bytes(), "little")
        first = 0
        for cell in self.cells:
            out += spelled(cell[0] - first)
            first = cell[0]
            for a, b in zip(cell, cell[1:]):
                out += spelled(b - a - 1)
        for _, cell in self.hidden:
            out += spelled(self.cells.index(cell) if cell in self.cells else len(self.cells) - 1)
        return bytes(out)

    def write(self, stem, body=None):
        with open(stem + ".txt", "w", encoding="ascii") as file:
            file.writelines(" ".join(repr(x) for x in row) + "\n" for row in self.rows)
        head = []
        for line in self.head:
            if line.startswith("# input "):
                line = f"# input {self.points_fingerprint():016x}"
            if line.startswith("# points "):
                line = f"# points {len(self.rows)}"
            if line.startswith("# duplicates "):
                line = f"# duplicates {len(self.rows) - len(self.distinct())}"
            head.append(line)
        with open(stem + ".pers", "w", encoding="ascii") as file:
            file.writelines(line + "\n" for line in head)
            file.writelines(f"{d} {b!r} {e!r}\n" for d, b, e in self.bars)
        if body is None:
            body = self.body()
        with open(stem + ".proof", "wb") as file:
            file.write(body + struct.pack("<Q", fingerprint_of_bytes(body)))


def fingerprint_of_bytes(body):
    padded = body + bytes(-len(body) % 8)
    return fingerprint([len(body), *struct.unpack(f"<{len(padded) // 8}Q", padded)])


def next_double(x, up):
    return math.nextafter(x, math.inf if up else -math.inf) if hasattr(math, "nextafter") else nudged(x, up)


def nudged(x, up):
    if x == 0:
        return 5e-324 if up else -5e-324
    bits = struct.unpack("<q", struct.pack("<d", x))[0]
    bits += 1 if (x > 0) == up else -1
    return struct.unpack("<d", struct.pack("<q", bits))[0]


# ---- forgeries: each changes a case and says whether that is surely wrong; None: it does not apply ----

def sort_bars(case):
    case.bars.sort()
    return True


def drop_bar(case, r):
    if not case.bars:
        return None
    del case.bars[r.randrange(len(case.bars))]
    return True


def double_bar(case, r):
    case.bars.append(list(r.choice(case.bars)))
    return sort_bars(case)


def move_bar(case, r):
    bar = r.choice(case.bars)
    end = r.randrange(1, 3)
    if math.isinf(bar[end]) or (end == 1 and bar[0] == 0):
        return None
    bar[end] = next_double(bar[end], r.random() < 0.5)
    return sort_bars(case) if bar[1] < bar[2] else None


def swap_deaths(case, r):
    a, b = r.choice(case.bars), r.choice(case.bars)
    if a[0] != b[0] or a[1] == b[1] or a[2] == b[2] or a[1] >= b[2] or b[1] >= a[2]:
        return None
    a[2], b[2] = b[2], a[2]
    return sort_bars(case)


def other_degree(case, r):
    bar = r.choice(case.bars)
    degrees = [d for d in range(case.dim) if d != bar[0]]
    bar[0] = r.choice(degrees)
    return sort_bars(case)


def end_essential(case, _):
    for bar in case.bars:
        if math.isinf(bar[2]):
            bar[2] = 2 * bar[1] + 1
            return sort_bars(case)
    return None


def add_bar(case, r):
    birth = r.choice(case.bars)[1]
    case.bars.append([r.randrange(1, case.dim), birth, next_double(birth, True)])
    return sort_bars(case) if birth > 0 else None


def drop_cell(case, r):
    del case.cells[r.randrange(len(case.cells))]
    return True


def add_cell(case, r):
    if len(case.list) < case.dim + 1:
        return None
    cell = tuple(sorted(r.sample(range(len(case.list)), case.dim + 1)))
    if cell in case.cells:
        return None
    case.cells = sorted(case.cells + [cell])
    return True


def other_corner(case, r):
    i = r.randrange(len(case.cells))
    cell = list(case.cells[i])
    others = [p for p in range(len(case.list)) if p not in cell]
    if not others:
        return None
    cell[r.randrange(len(cell))] = r.choice(others)
    case.cells[i] = tuple(sorted(cell))
    if len(set(case.cells)) < len(case.cells):
        return None
    case.cells.sort()
    return True


def flip(case, r):
    """Two triangles as the other two of their corners: also where that is no triangulation, or as good a one."""
    if case.dim != 2:
        return None
    a, b = r.choice(case.cells), r.choice(case.cells)
    shared = sorted(set(a) & set(b))
    if len(shared) != 2:
        return None
    p, q = (set(a) ^ set(b))
    new = {tuple(sorted((p, q, corner))) for corner in shared}
    case.cells = sorted((set(case.cells) - {a, b}) | new)
    return False


def swap_places(case, r):
    """Two points exchange their places and cells do not follow: where points are symmetric that changes nothing."""
    i, j = r.randrange(len(case.list)), r.randrange(len(case.list))
    if i == j:
        return None
    case.list[i], case.list[j] = case.list[j], case.list[i]
    return False


def move_point(case, r):
    """By one unit in the last place: few values may hang on it."""
    row = r.choice(case.rows)
    c = r.randrange(case.dim)
    if row[c] == 0:
        return None
    row[c] = next_double(row[c], r.random() < 0.5)
    return False


def far_point(case, _):
    case.rows.append([2 * max(abs(row[c]) for row in case.rows) + 1 for c in range(case.dim)])
    return True


def lower_degree(case, _):
    """The head claims a degree less than its bars have."""
    highest = max(bar[0] for bar in case.bars)
    if highest == 0:
        return None
    case.head = [f"# max-degree {highest - 1}" if line.startswith("# max-degree") else line for line in case.head]
    return True


def other_claim(case, r):
    """True bars under the head of another diagram."""
    lines = ["# box 0:10,0:10", "# radii 3", "# weights w", "# cell 9,0,0,9", "# a choice of 1 of 2"]
    case.head.append(r.choice(lines))
    return True


FORGERIES = [drop_bar, double_bar, move_bar, swap_deaths, other_degree, end_essential, add_bar, drop_cell, add_cell,
             other_corner, flip, swap_places, move_point, far_point, lower_degree, other_claim]


def other_list(case, r):
    """Another order of the list, cells renamed: as good a proof."""
    order = list(range(len(case.list)))
    r.shuffle(order)
    place = {old: new for new, old in enumerate(order)}
    case.list = [case.list[old] for old in order]
    renamed = {cell: tuple(sorted(place[p] for p in cell)) for cell in case.cells}
    case.cells = sorted(renamed.values())
    case.hidden = [(row, renamed[cell]) for row, cell in case.hidden]


class Runner:
    forgeries = FORGERIES

    def __init__(self, arguments):
        self.a = arguments
        self.counts = collections.Counter()
        self.faults = []

    def verdict(self, stem, python=False):
        program = [sys.executable, PYTHON_VERIFIER] if python else [self.a.verify]
        files = [stem + ending for ending in (".txt", ".pers", ".proof")]
        done = subprocess.run([*program, *files], capture_output=True, text=True)
        return done.returncode, (done.stderr or done.stdout).strip().splitlines()[-1:]

    def fault(self, stem, text):
        self.faults.append(f"{stem}: {text}")
        print(self.faults[-1])

    def honest(self):
        clouds = os.path.join(self.a.work, "clouds")
        os.makedirs(clouds, exist_ok=True)
        subprocess.run([self.a.clouds_program, str(self.a.seed), str(self.a.clouds), clouds], check=True)
        good = []
        for i in range(self.a.clouds):
            stem = os.path.join(clouds, str(i))
            made = subprocess.run([self.a.netmesh, "persist", stem + ".txt", "--filter", "alpha", "-q", "-o",
                                   stem + ".pers", "--proof", stem + ".proof"], capture_output=True, text=True)
            if made.returncode != 0:  # flat, or out of the range of doubles
                self.counts["no diagram"] += 1
                continue
            code, said = self.verdict(stem)
            if code != ACCEPTED:
                self.fault(stem, f"an honest proof is refused: {code} {said}")
                continue
            self.counts["honest"] += 1
            good.append(stem)
            if self.counts["honest by both"] < self.a.twice:
                code, said = self.verdict(stem, python=True)
                if code != ACCEPTED:
                    self.fault(stem, f"an honest proof is refused in Python: {code} {said}")
                self.counts["honest by both"] += 1
        return good

    def expect(self, stem, kind, surely_wrong):
        code, said = self.verdict(stem)
        self.counts[f"{kind}: {'accepted' if code == ACCEPTED else 'refused'}"] += 1
        if code not in (ACCEPTED, UNREADABLE, REFUSED):
            self.fault(stem, f"{kind}: exit {code} {said}")
        elif surely_wrong and code == ACCEPTED:
            self.fault(stem, f"{kind}: a forgery is accepted")
        elif not surely_wrong:
            other, heard = self.verdict(stem, python=True)
            if (other == ACCEPTED) != (code == ACCEPTED):
                self.fault(stem, f"{kind}: {code} {said}, in Python {other} {heard}")
        return code

    def forge(self, good):
        r = random.Random(self.a.seed)
        done = 0
        while done < self.a.forgeries:
            case = Case(r.choice(good))
            stem = os.path.join(self.a.work, f"forged-{done}")
            forgeries = self.forgeries
            turn = done % (len(forgeries) + 4)
            if turn < len(forgeries):
                forgery = forgeries[turn]
                surely = None
                for _ in range(20000):
                    case = Case(r.choice(good))
                    surely = forgery(case, r) if len(case.bars) > 1 else None
                    if surely is not None:
                        break
                if surely is None:
                    sys.exit(f"{forgery.__name__}: applies to no cloud")
                case.write(stem)
                self.expect(stem, forgery.__name__, surely)
            elif turn == len(forgeries):
                other_list(case, r)
                case.write(stem)
                if self.expect(stem, "another order", False) != ACCEPTED:
                    self.fault(stem, "another order of the list is refused")
            elif turn == len(forgeries) + 1:
                body = case.body()
                case.write(stem, body[:r.randrange(len(body))] if r.random() < 0.7 else body + b"\0")
                self.expect(stem, "other length", True)
            elif turn == len(forgeries) + 2:
                other = Case(r.choice(good))
                body = case.body()
                if other.body()[HEAD_BYTES:] == body[HEAD_BYTES:]:
                    continue
                case.write(stem, body[:HEAD_BYTES] + other.body()[HEAD_BYTES:])
                self.expect(stem, "another's cells", False)
            else:
                body = bytearray(case.body())
                body[r.randrange(len(body))] ^= 1 << r.randrange(8)
                case.write(stem, bytes(body))
                self.expect(stem, "a bit", False)
            done += 1
            if not self.faults or not self.faults[-1].startswith(stem):
                for ending in (".txt", ".pers", ".proof"):
                    os.remove(stem + ending)
        # As they stand: a fingerprint that is wrong is seen.
        stem = os.path.join(self.a.work, "damaged")
        case = Case(good[0])
        case.write(stem)
        with open(stem + ".proof", "rb") as file:
            data = bytearray(file.read())
        for at in {r.randrange(len(data)) for _ in range(min(200, self.a.forgeries))}:
            data[at] ^= 0x10
            with open(stem + ".proof", "wb") as file:
                file.write(data)
            self.expect(stem, "damaged", True)
            data[at] ^= 0x10


def main():
    p = argparse.ArgumentParser()
    for name in ("netmesh", "verify", "clouds_program", "work"):
        p.add_argument(name)
    p.add_argument("--clouds", type=int, default=150)
    p.add_argument("--twice", type=int, default=40)
    p.add_argument("--forgeries", type=int, default=300)
    p.add_argument("--seed", type=int, default=1)
    runner = Runner(p.parse_args())
    os.makedirs(runner.a.work, exist_ok=True)
    good = runner.honest()
    if len(good) < runner.a.clouds / 2:
        sys.exit("most clouds have no diagram")
    runner.forge(good)
    for kind, count in sorted(runner.counts.items()):
        print(f"{count:8,} {kind}")
    print(f"{len(runner.faults)} faults")
    return 1 if runner.faults else 0


if __name__ == "__main__":
    sys.exit(main())
