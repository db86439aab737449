#!/usr/bin/env python3
"""Proofs of alpha diagrams of balls against both verifiers: balls.py NETMESH VERIFY WORK [--clouds N] [--forgeries N]

- Honest proofs of N clouds, D = 2 to 4: at random, on lattices, with hidden points, points that lie where others do,
  points that the hull of lifts passes through, equal radii, weights of any sign, squares: accepted by both.
- Forgeries, by hand and at random, in which every fingerprint is right: refused, where the forged thing is surely
  wrong; else both verifiers say the same.
"""
import argparse
import os
import random
from fractions import Fraction
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/verify"))
import netmesh_verify
import run
from run import ACCEPTED, Case, Runner, next_double


def cloud(r, dim, kind):
    """Rows, and whether the last numbers are radii."""
    count = r.randrange(dim + 2, (34, 22, 14)[dim - 2])
    radii = r.random() < 0.5
    if kind == "random":
        rows = [[r.uniform(-1, 1) for _ in range(dim)] + [r.uniform(0, 0.6)] for _ in range(count)]
    elif kind == "lattice":  # ties of all kinds: cospherical, on the hull of the lifts, in one place
        rows = [[float(r.randrange(3)) for _ in range(dim)] + [float(r.randrange(3))] for _ in range(count)]
    elif kind == "equal":
        rows = [[r.uniform(-1, 1) for _ in range(dim)] + [0.37] for _ in range(count)]
    elif kind == "hidden":
        rows = [[r.uniform(-1, 1) for _ in range(dim)] + [r.choice([0.01, 0.02, 1.1])] for _ in range(count)]
    elif kind == "one lift":  # |p|^2 - w is an affine function: all points are on one facet of the hull
        rows = [[float(r.randrange(4)) for _ in range(dim)] for _ in range(count)]
        rows, radii = [row + [sum(x * x - x for x in row) + r.choice([0, 0, -1])] for row in rows], False
    elif kind == "wide":  # numbers of all sizes, beyond what doubles decide
        bits = r.choice([20, 120, 260])
        rows = [[r.uniform(-1, 1) * 2.0 ** r.randrange(-bits, bits) for _ in range(dim + 1)] for _ in range(count)]
        rows = [row[:-1] + [abs(row[-1]) if radii else row[-1] * r.choice([1, abs(row[-1])])] for row in rows]
    else:  # nearly so
        rows = [[r.randrange(4) / 4 for _ in range(dim)] for _ in range(count)]
        rows, radii = [row + [sum(x * x for x in row)] for row in rows], False
        for row in rows:
            row[-1] = next_double(row[-1], r.random() < 0.5) if row[-1] and r.random() < 0.3 else row[-1]
    if not radii and kind not in ("one lift", "wide"):
        rows = [row[:-1] + [row[-1] - r.choice([0, 0.5])] for row in rows]
    if r.random() < 0.3:
        rows += [list(r.choice(rows)) for _ in range(3)]
        rows[-1][-1] = abs(rows[-1][-1]) / 2
    if r.random() < 0.15:
        scale = 2.0 ** r.randrange(-400, 400)
        rows = [[x * scale for x in row[:-1]] + [row[-1] * (scale if radii else scale * scale)] for row in rows]
    return rows, radii


KINDS = ["random", "lattice", "equal", "hidden", "one lift", "near", "wide"]


def drop_hidden(case, r):
    """A hidden point is on no list."""
    if not case.hidden:
        return None
    del case.hidden[r.randrange(len(case.hidden))]
    return True


def unhide(case, r):
    """A hidden point is a vertex, of no cell."""
    if not case.hidden:
        return None
    row, _ = case.hidden.pop(r.randrange(len(case.hidden)))
    case.list.append(row)
    return True


def unhide_in_cell(case, r):
    """A hidden point is a vertex, and the cell that hides it D + 1 cells: a triangulation that is not regular, unless
    the point is on the hull of the lifts."""
    if not case.hidden:
        return None
    row, cell = case.hidden.pop(r.randrange(len(case.hidden)))
    if any(other == cell for _, other in case.hidden):
        return None
    new = len(case.list)
    case.list.append(row)
    case.cells.remove(cell)
    case.cells = sorted(case.cells + [cell[:i] + cell[i + 1:] + (new,) for i in range(len(cell))])
    return False


def hide_vertex(case, r):
    """A vertex is said to be hidden, and its cells are left out."""
    place = r.randrange(len(case.list))
    cells = [cell for cell in case.cells if place not in cell]
    if not cells or any(place in cell for _, cell in case.hidden):
        return None
    renamed = {cell: tuple(p - (p > place) for p in cell) for cell in cells}
    case.cells = sorted(renamed.values())
    case.hidden = [(row, renamed[cell]) for row, cell in case.hidden] + [(case.list.pop(place), case.cells[0])]
    return True


def other_cell(case, r):
    """A hidden point in another cell, which may contain it, too."""
    if not case.hidden or len(case.cells) < 2:
        return None
    i = r.randrange(len(case.hidden))
    case.hidden[i] = (case.hidden[i][0], r.choice([cell for cell in case.cells if cell != case.hidden[i][1]]))
    return False


def other_row(case, r):
    """The row of a hidden point is that of another point."""
    if not case.hidden:
        return None
    i = r.randrange(len(case.hidden))
    case.hidden[i] = (r.choice(case.list), case.hidden[i][1])
    return True


def lighter_equal(case, r):
    """Of equal points a lighter one is listed."""
    for i in r.sample(range(len(case.list)), len(case.list)):
        heavy = case.rows[case.list[i]]
        for number, row in enumerate(case.rows):
            if row[:-1] == heavy[:-1] and row[-1] < heavy[-1]:
                case.list[i] = number
                return True
    return None


def change_weight(case, r):
    """A weight changes by much: of a hidden point downwards, which changes nothing, or of any."""
    row = r.choice(case.rows)
    if row[-1] == 0:
        return None
    row[-1] *= r.choice([0.5, 2])
    return False


def nudge_weight(case, r):
    row = r.choice(case.rows)
    if row[-1] == 0:
        return None
    row[-1] = next_double(row[-1], r.random() < 0.5)
    return False


def raise_hidden(case, r):
    """A hidden point becomes so heavy that it is hidden no more."""
    if not case.hidden:
        return None
    row = case.rows[r.choice(case.hidden)[0]]
    largest = max(abs(x) for other in case.rows for x in other)
    row[-1] = 2 * largest + 4 * largest * largest
    return row[-1] < 1e100 or None


def negative_radius(case, r):
    if case.kinds != ["radii"]:
        return None
    row = r.choice(case.rows)
    row[-1] = -row[-1] or -1.0
    return True


def other_kind(case, _):
    """Radii are weights, weights radii: the same where all are 0 or 1."""
    case.head = [line.replace("# radii", "# WEIGHTS").replace("# weights", "# radii").replace("WEIGHTS", "weights")
                 for line in case.head]
    case.kinds = ["weights"] if case.kinds == ["radii"] else ["radii"]
    return False


def other_squares(case, _):
    """Values are said to be squares, or not to be: the same where all are 0 or 1."""
    lines = [line for line in case.head if line != "# squares"]
    case.head = lines + ["# squares"] if len(lines) == len(case.head) else lines
    return False


def no_weights(case, _):
    """The head says nothing of weights: three columns are points of space, or the file is none."""
    case.head = [line for line in case.head if line.split()[1] not in ("radii", "weights", "squares")]
    return True


def both_kinds(case, _):
    case.head.append("# weights 1" if case.kinds == ["radii"] else "# radii 1")
    return True


def kind_twice(case, r):
    """The weights are in one column and in another one."""
    line = next(line for line in case.head if line.split()[1] in case.kinds)
    case.head.append(r.choice([line, "# %s %d" % (case.kinds[0], 1)]))
    return True


SHARED = [run.drop_bar, run.double_bar, run.swap_deaths, run.other_degree, run.end_essential, run.drop_cell,
          run.add_cell, run.other_corner, run.flip, run.swap_places, run.lower_degree]


def move_bar(case, r):
    bar = r.choice(case.bars)
    end = r.randrange(1, 3)
    if bar[end] in (0, float("inf")) or abs(bar[end]) < 1e-300:
        return None
    bar[end] = next_double(bar[end], r.random() < 0.5)
    return run.sort_bars(case) if bar[1] < bar[2] else None


def other_sign(case, r):
    bar = r.choice(case.bars)
    end = r.randrange(1, 3)
    if bar[end] in (0, float("inf")):
        return None
    bar[end] = -bar[end]
    return run.sort_bars(case) if bar[1] < bar[2] else None


def exact(case, rows):
    """Points and weights of these rows in integers, over a unit, and that."""
    power = 2 if case.kinds == ["radii"] else 1
    numbers = [[Fraction(x) for x in case.rows[row]] for row in rows]
    unit = max(x.denominator for number in numbers for x in number)
    return ([tuple(int(x * unit) for x in number[:-1]) for number in numbers],
            [int(number[-1] ** power * unit**2) for number in numbers], unit)


def take_its_bars(case):
    """The bars become those that follow from the triangulation, be it regular or not. False where a cell is flat."""
    points, weights, unit = exact(case, case.list)
    if any(netmesh_verify.side([points[p] for p in cell[1:]], points[cell[0]]) == 0 for cell in case.cells):
        return False
    levels = netmesh_verify.rounded_values(points, weights, unit, "# squares" in case.head, case.cells, case.dim)
    if any(value == float("inf") for level in levels for value in level.values()):
        return False
    case.bars = [list(bar) for bar in netmesh_verify.persistence(levels, case.dim - 1)]
    return True


def flip_with_its_bars(case, r):
    """Where that is a triangulation all fits together, but it is not regular."""
    if run.flip(case, r) is None or not take_its_bars(case):
        return None
    return False


def unhide_with_its_bars(case, r):
    """The same of a hidden point that is made a vertex of the cells that it parts another one into."""
    return False if unhide_in_cell(case, r) is not None and take_its_bars(case) else None


class BallRunner(Runner):
    forgeries = SHARED + [move_bar, other_sign, drop_hidden, unhide, unhide_in_cell, hide_vertex, other_cell, other_row,
                          lighter_equal, change_weight, nudge_weight, raise_hidden, negative_radius, other_kind,
                          other_squares, no_weights, both_kinds, kind_twice, flip_with_its_bars, unhide_with_its_bars,
                          "hide with bars"]

    def __init__(self, arguments):
        super().__init__(arguments)
        self.forgeries = [self.hide_with_its_bars if f == "hide with bars" else f for f in self.forgeries]

    def expect(self, stem, kind, surely_wrong):
        """What is accepted has to be true: the engine makes the same bars of these points."""
        code = super().expect(stem, kind, surely_wrong)
        if code == ACCEPTED:
            case = Case(stem)
            words = ["--" + case.kinds[0], str(case.dim + 1)] + ["--squares"] * ("# squares" in case.head)
            done = subprocess.run([self.a.netmesh, "persist", stem + ".txt", "--filter", "alpha", *words, "-q"],
                                  capture_output=True, text=True, check=False)
            bars = [line.split() for line in done.stdout.splitlines() if not line.startswith("#")]
            if [[int(d), float(b), float(e)] for d, b, e in bars] != case.bars:
                self.fault(stem, f"{kind}: what is accepted is not true")
            self.counts["accepted, and true"] += 1
        return code

    def hide_with_its_bars(self, case, r):
        """The proof of all points but one, a vertex, which is said to be hidden by the cell that contains it."""
        left_out = r.choice(case.list)
        stem, bars = os.path.join(self.a.work, "fewer"), case.bars
        row = case.rows[left_out]
        rest = [other for other in case.rows if other[:-1] != row[:-1]]
        with open(stem + ".txt", "w", encoding="ascii") as file:
            file.writelines(" ".join(repr(x) for x in other) + "\n" for other in rest)
        words = ["--" + case.kinds[0], str(case.dim + 1)] + ["--squares"] * ("# squares" in case.head)
        done = subprocess.run([self.a.netmesh, "persist", stem + ".txt", "--filter", "alpha", *words, "-q", "-o",
                               stem + ".pers", "--proof", stem + ".proof"], capture_output=True, check=False)
        if done.returncode != 0:
            return None
        case.__dict__ = Case(stem).__dict__
        case.rows.append(row)
        points, _, _ = exact(case, case.list + [len(case.rows) - 1])
        for cell in case.cells:
            if all(netmesh_verify.side([points[p] for p in f], points[-1]) !=
                   -netmesh_verify.side([points[p] for p in f], points[apex])
                   for f, apex in netmesh_verify.facets(cell)):
                case.hidden.append((len(case.rows) - 1, cell))
                return case.bars != bars or False
        return None

    def honest(self):
        r = random.Random(self.a.seed)
        good, made = [], 0
        while len(good) < self.a.clouds and made < 3 * self.a.clouds:
            kind, dim = KINDS[made % len(KINDS)], 2 + made // len(KINDS) % 3
            rows, radii = cloud(r, dim, kind)
            stem = os.path.join(self.a.work, f"cloud-{made}")
            made += 1
            with open(stem + ".txt", "w", encoding="ascii") as file:
                file.writelines(" ".join(repr(x) for x in row) + "\n" for row in rows)
            words = ["--radii" if radii else "--weights", str(dim + 1)] + (["--squares"] if r.random() < 0.3 else [])
            done = subprocess.run([self.a.netmesh, "persist", stem + ".txt", "--filter", "alpha", *words, "-q", "-o",
                                   stem + ".pers", "--proof", stem + ".proof"], capture_output=True, text=True,
                                  check=False)
            if done.returncode != 0:  # flat
                self.counts["no diagram"] += 1
                if done.returncode not in (3, 5):
                    self.fault(stem, f"persist ends with {done.returncode}: {done.stderr}")
                continue
            for python in (False, True):
                code, said = self.verdict(stem, python)
                if code != ACCEPTED:
                    self.fault(stem, f"{kind}: an honest proof is refused, python {python}: {code} {said}")
            case = Case(stem)
            self.counts[f"honest, {kind}, R^{dim}"] += 1
            self.counts["hidden points"] += len(case.hidden)
            good.append(stem)
        if len(good) < self.a.clouds or self.counts["hidden points"] < self.a.clouds:
            self.fault("clouds", "too few of them, or too few hidden points")
        return good


def main():
    p = argparse.ArgumentParser()
    for name in ("netmesh", "verify", "work"):
        p.add_argument(name)
    p.add_argument("--clouds", type=int, default=60)
    p.add_argument("--forgeries", type=int, default=250)
    p.add_argument("--seed", type=int, default=1)
    runner = BallRunner(p.parse_args())
    os.makedirs(runner.a.work, exist_ok=True)
    good = runner.honest()
    runner.forge(good)
    for kind, count in sorted(runner.counts.items()):
        print(f"{count:8,} {kind}")
    print(f"{len(runner.faults)} faults")
    return 1 if runner.faults else 0


if __name__ == "__main__":
    sys.exit(main())
