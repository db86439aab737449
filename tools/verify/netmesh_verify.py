#!/usr/bin/env python3
"""Verifies an exact alpha diagram, of points or balls: netmesh_verify.py POINTS DIAGRAM PROOF [--quiet]
The reading of tools/docs/proofs.md in plain Python, the standard library alone, no code shared with netmesh. The steps
1 to 6 of that page are the sections below, 3a to 3e its letters. Doubles are integers over a power of two, so all signs
are signs of integers and no decision is rounded. Meant for small inputs: seconds for 1,000 points of the plane.
Exit: 0 verified; 7 not proven (step and place on stderr); 2 usage; 3 a file cannot be read or is malformed.
"""
import ast
import math
import re
import struct
import sys
from collections import Counter
from fractions import Fraction
from itertools import accumulate, chain
from pathlib import Path

class Malformed(Exception):
    """A file that is not what it should be: exit 3."""
class NotProven(Exception):
    """A step that fails: exit 7."""
# ---- Step 1: reads --------------------------------------------------------------------------------------------------
DECIMAL = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?")
BETWEEN = re.compile(r"[ \t]*[,;][ \t]*|[ \t]+")
HEAD = ("dim", "max-degree", "points", "duplicates", "filter", "input")
OTHER = ("box", "cell", "a")  # "a choice of": claims of other diagrams
MASK = (1 << 64) - 1
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
def bits(x):
    return struct.unpack("<Q", struct.pack("<d", x))[0]
def text_lines(path, data):  # each line with what messages call it; after the last newline there is no line
    lines = data.decode("latin-1").removesuffix("\n").split("\n")
    return [(f"{path}, line {number}", line.rstrip("\r")) for number, line in enumerate(lines, 1)]
def finite(word, where):
    value = float(word) if DECIMAL.fullmatch(word) else math.nan  # the nearest double, ties to even
    if not math.isfinite(value):
        raise Malformed(f"{where}: '{word[:40]}' is not a number, or none of a double")
    return value
def natural(word, where):
    if not re.fullmatch("[0-9]{1,18}", word):
        raise Malformed(f"{where}: '{word[:40]}' is not a count")
    return int(word)
def read_points(path, diagram):
    """The rows of the file, tuples of doubles, -0 made 0, and their radii or weights, None without."""
    rows = read_rows(path, diagram.dim + diagram.weighted)
    if not diagram.weighted:
        return rows, None
    name = diagram.radii or diagram.weights
    at = int(name) - 1 if re.fullmatch("[0-9]{1,9}", name) and 1 <= int(name) <= diagram.dim else diagram.dim
    if diagram.radii and any(row[at] < 0 for row in rows):
        raise Malformed(f"{path}: a radius is negative")
    return [row[:at] + row[at + 1 :] for row in rows], [row[at] for row in rows]
def read_rows(path, dim):
    data = Path(path).read_bytes()
    if data.startswith(b"\x93NUMPY"):
        return read_npy(path, data, dim)
    rows, is_first = [], True
    for where, line in text_lines(path, data):
        words = BETWEEN.split(line.strip(" \t\r"))
        if words == [""] or words[0].startswith("#"):
            continue
        is_header, is_first = is_first and not any(map(DECIMAL.fullmatch, words)), False
        if not is_header:
            rows.append(tuple(finite(word, where) + 0.0 for word in words))
            if len(rows[-1]) != dim:
                raise Malformed(f"{where}: {len(rows[-1])} numbers, not {dim}")
    return rows
def read_npy(path, data, dim):
    start = 10 if data[6:7] == b"\x01" else 12
    end = min(10000, start + int.from_bytes(data[8:start], "little"))  # longer heads no parser has to bear
    try:
        head = ast.literal_eval(data[start:end].decode("latin-1").strip())
        (count, width), by_columns = head["shape"], head["fortran_order"]
        numbers = [x + 0.0 for x in struct.unpack(f"<{dim * count}d", data[end:])]
        if (head["descr"], type(count), width) != ("<f8", int, dim) or not all(map(math.isfinite, numbers)):
            raise ValueError
    except (ValueError, SyntaxError, TypeError, KeyError, MemoryError, RecursionError, struct.error):
        raise Malformed(f"{path}: not an .npy of shape (rows, {dim}), little endian doubles, finite") from None
    return [tuple(numbers[i::count] if by_columns else numbers[i * dim : (i + 1) * dim]) for i in range(count)]
class Diagram:
    def __init__(self, path):
        self.bars, self.lines, head = [], [], {}  # (degree, birth, death), and the place of each in the file
        minus_at = ""
        for where, line in text_lines(path, Path(path).read_bytes()):
            words = re.findall("[^ \t]+", line)
            if line.startswith("#"):
                name = words[1] if words[0] == "#" and len(words) > 1 else ""
                if name in OTHER:
                    raise Malformed(f"{where}: by its head it claims something else")
                if name in head or (name in HEAD and len(words) > 3):
                    raise Malformed(f"{where}: '# {name}' has more than one value, or is there twice")
                if name in ("radii", "weights", "squares") or (name in HEAD and len(words) > 2):
                    head[name] = (words[2] if len(words) == 3 else "?", where)
                continue
            if len(words) != 3:
                raise Malformed(f"{where}: not a degree, a birth and a death")
            death = math.inf if words[2] == "inf" else finite(words[2], where)
            bar = (natural(words[0], where), finite(words[1], where) + 0.0, death + 0.0)
            if self.bars and bar < self.bars[-1]:
                raise Malformed(f"{where}: bars not in order")
            minus_at = where if "-" in (words[1][0], words[2][0]) else minus_at
            self.bars.append(bar)
            self.lines.append(where)
        # What the head says behind them, or "?".
        self.radii, self.weights, self.squares = (head.get(name, ("",))[0] for name in ("radii", "weights", "squares"))
        self.weighted = bool(self.radii or self.weights)
        if (self.radii and self.weights) or (self.squares and not self.weighted) or (minus_at and not self.weighted):
            raise Malformed(f"{minus_at or path}: a birth or death with a minus, or not one of # radii and # weights")
        head.setdefault("duplicates", ("0", path))
        counts = (natural(*head.get(name, ("", f"{path}, # {name}"))) for name in HEAD[:4])
        self.dim, self.max_degree, self.rows, self.duplicates = counts
        self.input = head.get("input", ("",))[0]
        if head.get("filter", ("",))[0] != "alpha" or not 2 <= self.dim <= 6:
            raise Malformed(f"{path}: # filter is not alpha, or # dim not 2 to 6")
class Proof:
    def __init__(self, path, row_count, weighted):
        data = Path(path).read_bytes()
        self.end, begin, version = len(data) - 8, 64 if weighted else 56, 2 if weighted else 1
        if self.end < begin or not data.startswith(b"netmesh proof %d\n" % version):
            raise Malformed(f"{path}, byte 0: not a proof of version {version}, or cut off")
        kind, self.dim, n, c, self.of_points, self.of_diagram = struct.unpack_from("<IIQQQQ", data, 16)
        filled = data[:-8] + bytes(-self.end % 8)
        words = chain([self.end], struct.unpack(f"<{len(filled) // 8}Q", filled))
        if fingerprint(words) != int.from_bytes(data[-8:], "little"):
            raise Malformed(f"{path}, byte {self.end}: not the fingerprint of all bytes before")
        if kind != version or not 2 <= self.dim <= 6:
            raise Malformed(f"{path}, byte 16: kind {kind} is not {version}, or dimension {self.dim} not 2 to 6")
        hidden = int.from_bytes(data[56:begin], "little")
        at = begin + (n + hidden) * (width := max(1, (max(row_count - 1, 0).bit_length() + 7) // 8))
        if at > self.end:
            raise Malformed(f"{path}, byte {self.end}: the list of {n + hidden} points is cut off")
        self.rows = [int.from_bytes(data[i : i + width], "little") for i in range(begin, at, width)]
        numbers, ends, value, shift = [], [at], 0, 0  # 7 bits a byte, the least first
        for at in range(at, self.end):
            value |= (data[at] & 127) << shift
            shift += 7
            if shift > 70 or shift > 7 and data[at] == 0:
                raise Malformed(f"{path}, byte {at}: a number is too long, or ends in a byte 0")
            if data[at] < 128:
                numbers.append(value)
                ends.append(at + 1)
                value = shift = 0
        if shift or len(numbers) != c * (self.dim + 1) + hidden:
            raise Malformed(f"{path}, byte {ends[-1]}: {len(numbers)} numbers, not those of {c} cells, {hidden} hidden")
        self.vertices, self.hidden = n, numbers[len(numbers) - hidden :]  # for each hidden point the number of a cell
        del numbers[len(numbers) - hidden :]
        if any(number >= c for number in self.hidden):
            raise Malformed(f"{path}: a hidden point in a cell that is none")
        self.cells, self.offsets = [], ends[:: self.dim + 1]  # tuples of places, and the byte where each begins
        for i in range(0, len(numbers), self.dim + 1):
            before = self.cells[-1] if self.cells else (0,)
            gaps = [before[0] + numbers[i]] + [gap + 1 for gap in numbers[i + 1 : i + self.dim + 1]]
            cell = tuple(accumulate(gaps))
            if cell[-1] >= n or cell <= before:  # the first cell is greater than (0,)
                raise Malformed(f"{path}, byte {ends[i]}: places beyond the list, or cells not ascending")
            self.cells.append(cell)
def check_heads(diagram, rows, weights, proof):
    different = list(dict.fromkeys(rows))
    of_points = fingerprint(chain([diagram.dim], map(bits, chain.from_iterable(rows))))
    if diagram.weighted:
        of_points = fingerprint(chain([of_points, int(bool(diagram.radii))], map(bits, weights)))
    of_bars = fingerprint(w for degree, birth, death in diagram.bars for w in (degree, bits(birth), bits(death)))
    for what, found, said in (
        ("# points of the diagram", len(rows), diagram.rows),
        ("# duplicates of the diagram", len(rows) - len(different), diagram.duplicates),
        ("# input of the diagram, fingerprint of points", f"{of_points:016x}", diagram.input or f"{of_points:016x}"),
        ("byte 20 of the proof, dimension", diagram.dim, proof.dim),
        ("byte 24 of the proof, different points, hidden ones too", len(different), len(proof.rows)),
        ("byte 40 of the proof, fingerprint of points", of_points, proof.of_points),
        ("byte 48 of the proof, fingerprint of the diagram", of_bars, proof.of_diagram),
    ):
        if found != said:
            raise NotProven(f"1: {what}: {said}, but it is {found}")
# ---- Step 2: points -------------------------------------------------------------------------------------------------
def listed_points(rows, weights, proof):
    place_of = {}
    for place, row in enumerate(proof.rows):
        if row >= len(rows) or rows[row] in place_of:
            raise NotProven(f"2: place {place}: there is no row {row}, or its point is on the list before")
        place_of[rows[row]] = place
    for number, row in enumerate(rows):
        if row not in place_of:
            raise NotProven(f"2: row {number} is equal to no point on the list")
        if weights and weights[number] > weights[proof.rows[place_of[row]]]:
            raise NotProven(f"2: row {number} is heavier than the equal point on the list")
    return list(place_of)
# ---- Exact geometry, of points of integers --------------------------------------------------------------------------
def det(m):  # by Bareiss's elimination, in which all divisions come out even
    m, sign_of_swaps, before = [list(row) for row in m], 1, 1
    for k in range(len(m)):
        pivot = next((i for i in range(k, len(m)) if m[i][k]), k)
        if m[pivot][k] == 0:
            return 0
        m[k], m[pivot], sign_of_swaps = m[pivot], m[k], sign_of_swaps if pivot == k else -sign_of_swaps
        for i in range(k + 1, len(m)):
            for j in range(k + 1, len(m)):
                m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) // before
        before = m[k][k]
    return sign_of_swaps * before
def det_sign(m):
    d = det(m)
    return (d > 0) - (d < 0)
def minus(p, q):
    return [a - b for a, b in zip(p, q)]
def dot(u, v):
    return sum(a * b for a, b in zip(u, v))
def side(facet, x):  # on which side of the hyperplane through D points x lies: -1 or 1, or 0 on it
    return det_sign([minus(p, x) for p in facet])
def smallest_sphere(corners):
    """(a, C, E) of the smallest sphere of a simplex, whose corners are points, each with its weight: the powers of the
    corners at its centre a + C / 2E are equal, E > 0. The centre is a + sum of l_j v_j, v_j the edges from a: for each
    i sum over j of (v_i.v_j) 2 l_j is v_i.v_i + weight of a - that of v_i's end. By Cramer's rule 2 l_j = N_j / E, E
    being the Gram determinant."""
    a, weight = corners[0]
    edges = [minus(p, a) for p, _ in corners[1:]]
    gram = [[dot(u, v) for v in edges] for u in edges]
    d = [dot(v, v) + weight - w for v, (_, w) in zip(edges, corners[1:])]
    n = [det([row[:j] + [d[i]] + row[j + 1 :] for i, row in enumerate(gram)]) for j in range(len(edges))]
    return corners[0], [sum(n_j * v[x] for n_j, v in zip(n, edges)) for x in range(len(a))], det(gram)
def strictly_inside(sphere, q):  # q's power at the centre is below a's: E (v.v + weight of a - that of q) < C.v
    (a, weight), centre, scale = sphere
    v = minus(q[0], a)
    return scale * (dot(v, v) + weight - q[1]) < dot(centre, v)
def nearest(num, den, is_root):
    """The double nearest to the root of num / den, or to that itself, ties to even, inf from halfway between the
    largest and 2^1024 on; of num < 0 minus that of -num. All doubles, and all halfway between two, are multiples of
    2^-1075. So the root is counted in these, and one more bit says that it is more than that."""
    size = abs(num) << 2 * 1075
    whole = math.isqrt(size // den)
    try:
        value = (2 * whole + (whole * whole * den < size)) / 2**1076 if is_root else abs(num) / den
    except OverflowError:
        value = math.inf
    return -value if num < 0 else value
def facets(s):  # of a simplex, each with the vertex that it has not
    return [(s[:i] + s[i + 1 :], s[i]) for i in range(len(s))]
def by_facets(simplices):  # of each facet of simplices those that have it, each with the other vertex
    having = {}
    for s in simplices:
        for facet, apex in facets(s):
            having.setdefault(facet, []).append((s, apex))
    return having
# ---- Step 3: triangulation ---------------------------------------------------------------------------------------
def check_triangulation(points, weights, proof):  # steps 3a to 3e; the result is the number of hull facets
    cells = proof.cells
    def balls(s):
        return [(points[place], weights[place]) for place in s]
    def at(s):
        return [points[place] for place in s]
    def name(s):
        return "of rows " + " ".join(str(proof.rows[place]) for place in s)
    def cell_name(cell):
        return f"cell {cells.index(cell)} (byte {proof.offsets[cells.index(cell)]}), {name(cell)}"
    # a. No point is left out, no cell is flat.
    if not cells:
        raise NotProven("3a: there is no cell")
    for place in sorted(set(range(proof.vertices)).difference(*cells)):
        raise NotProven(f"3a: row {proof.rows[place]}, place {place}, is a vertex of no cell")
    for cell in cells:
        if side(at(cell[1:]), points[cell[0]]) == 0:
            raise NotProven(f"3a: {cell_name(cell)}, is flat")
    for place, number in enumerate(proof.hidden, proof.vertices):
        cell = cells[number]
        beyond = any(side(at(f), points[place]) == -side(at(f), points[apex]) for f, apex in facets(cell))
        if beyond or strictly_inside(smallest_sphere(balls(cell)), (points[place], weights[place])):
            raise NotProven(f"3a: row {proof.rows[place]} is not hidden by {cell_name(cell)}")
    # b. Two cells at a facet are on different sides, and Delaunay there. The others are hull facets.
    hull = {}  # with the other vertex of the cell
    for facet, those in by_facets(cells).items():
        if len(those) == 1:
            hull[facet] = those[0][1]
            continue
        if len(those) > 2:
            raise NotProven(f"3b: facet {name(facet)} belongs to {len(those)} cells")
        (s, p), (t, q) = those
        if side(at(facet), points[p]) != -side(at(facet), points[q]):
            raise NotProven(f"3b: {cell_name(s)}, and {cell_name(t)}, are on one side of their facet")
        if strictly_inside(smallest_sphere(balls(s)), (points[q], weights[q])):
            raise NotProven(f"3b: row {proof.rows[q]} of {cell_name(t)}, is in the sphere of {cell_name(s)}")
    # From here on all is D + 1 times as large, and the centroid o of the first cell is the origin.
    total = [sum(x) for x in zip(*at(cells[0]))]
    points = [tuple((proof.dim + 1) * x - t for x, t in zip(p, total)) for p in points]
    o = (0,) * proof.dim
    # c. Hull facets are seen from inside.
    inner = {facet: side(at(facet), points[apex]) for facet, apex in hull.items()}  # the side of cell and o
    for facet in hull:
        if side(at(facet), o) != inner[facet]:
            raise NotProven(f"3c: hull facet {name(facet)}: o is not on the side of its cell")
    # d. At a ridge two hull facets part, seen from o, and there is no dent.
    for ridge, those in by_facets(hull).items():
        if len(those) != 2:
            raise NotProven(f"3d: ridge {name(ridge)} belongs to {len(those)} hull facets")
        (f, p), (g, q) = those
        if det_sign(at(ridge) + [points[p]]) * det_sign(at(ridge) + [points[q]]) != -1:
            raise NotProven(f"3d: hull facets {name(f)} and {name(g)} do not part at their ridge, seen from o")
        if side(at(f), points[q]) == -inner[f] or side(at(g), points[p]) == -inner[g]:
            raise NotProven(f"3d: hull facets {name(f)} and {name(g)} make a dent")
    # e. One layer of cells at o; one of hull facets in a direction.
    for cell in cells[1:]:
        if all(side(at(facet), o) != -side(at(facet), points[apex]) for facet, apex in facets(cell)):
            raise NotProven(f"3e: {cell_name(cell)}, has the centroid of the first cell")
    first = next(iter(hull), ())
    ray = tuple(sum(x) for x in zip(*at(first)))
    for facet in hull:
        rows = at(facet)  # independent, by c; the ray is the sum of m_i rows_i, and meets the facet if no m_i is < 0
        signs = [det_sign(rows[:i] + [ray] + rows[i + 1 :]) for i in range(len(rows))]
        if facet != first and -det_sign(rows) not in signs:
            raise NotProven(f"3e: hull facet {name(facet)} is in the direction of the one {name(first)}")
    return len(hull)
# ---- Step 4: values -------------------------------------------------------------------------------------------------
def rounded_values(points, weights, unit, squares, cells, dim):
    """By dimension, a dictionary from each simplex to its value, of points that are integers over unit. The least of
    rounded values is the least value rounded, as rounding is monotone: exact ones need not be compared."""
    levels = [{} for _ in range(dim + 1)]
    above = {cell: [] for cell in cells}  # simplex: those of one dimension more, each with its other vertex
    for k in range(dim, -1, -1):
        for s, those in above.items():
            sphere = smallest_sphere([(points[p], weights[p]) for p in s])
            if any(strictly_inside(sphere, (points[q], weights[q])) for _, q in those):
                levels[k][s] = min(levels[k + 1][t] for t, _ in those)
            else:
                power = dot(sphere[1], sphere[1]) - sphere[0][1] * (2 * sphere[2]) ** 2
                levels[k][s] = nearest(power, (2 * sphere[2] * unit) ** 2, not squares)
        above = by_facets(above)
    return levels
# ---- Step 5: pairs --------------------------------------------------------------------------------------------------
def persistence(levels, max_degree):
    """The bars. A column has rows of one dimension, and only columns of one dimension are added. So it is enough to
    order each dimension for itself, by value. Bit i of an integer is the row of the i-th simplex."""
    bars = []
    order = [sorted(level, key=level.get) for level in levels]
    zero = [set(order[0])] + [set() for _ in levels]  # of each dimension, simplices whose column is 0, in no pair yet
    for k in range(1, min(len(levels), max_degree + 2)):
        number = {s: i for i, s in enumerate(order[k - 1])}
        reduced = {}  # by number of the lowest row
        for s in order[k]:
            column = sum(1 << number[facet] for facet, _ in facets(s))
            while column.bit_length() - 1 in reduced:
                column ^= reduced[column.bit_length() - 1]
            if column:
                reduced[column.bit_length() - 1] = column
                low = order[k - 1][column.bit_length() - 1]
                zero[k - 1].remove(low)
                bars.append((k - 1, levels[k - 1][low], levels[k][s]))
            else:
                zero[k].add(s)
    bars += [(k, levels[k][s], math.inf) for k in range(min(len(levels), max_degree + 1)) for s in zero[k]]
    return sorted(bar for bar in bars if bar[1] != bar[2])
# ---- Step 6: compares, and the whole --------------------------------------------------------------------------------
def verify(points_path, diagram_path, proof_path):
    diagram = Diagram(diagram_path)
    rows, weights = read_points(points_path, diagram)
    proof = Proof(proof_path, len(rows), diagram.weighted)
    check_heads(diagram, rows, weights, proof)
    points = [[Fraction(x) for x in p] for p in listed_points(rows, weights, proof)]
    weights = [Fraction(weights[row] if weights else 0) ** (2 if diagram.radii else 1) for row in proof.rows]
    unit = max((x.denominator for x in chain(weights, *points)), default=1)  # all denominators are powers of two
    points = [tuple(int(x * unit) for x in p) for p in points]
    weights = [int(w * unit**2) for w in weights]
    hull = check_triangulation(points, weights, proof)
    levels = rounded_values(points, weights, unit, diagram.squares, proof.cells, proof.dim)
    found, listed = Counter(persistence(levels, diagram.max_degree)), Counter(diagram.bars)
    for bar, where in zip(diagram.bars, diagram.lines):
        if found[bar] < listed[bar]:
            raise NotProven(f"6: {where}: this bar is there {listed[bar]} times, found {found[bar]} times")
    for bar in found - listed:
        raise NotProven(f"6: {diagram_path}: bar %d %r %r is not there, or not as often as found" % bar)
    return [
        f"verified   the bars of degree 0 to {diagram.max_degree} are true, and there is no other",
        f"points     {len(points)} in R^{proof.dim}, {len(proof.hidden)} hidden, and {diagram.duplicates} duplicates",
        f"cells      {len(proof.cells)}, Delaunay, with {hull} hull facets",
        "simplices  " + ", ".join(f"{len(level)} of dimension {k}" for k, level in enumerate(levels)),
    ]
def main(arguments):
    paths = [argument for argument in arguments if argument != "--quiet"]
    if len(paths) != 3 or any(path.startswith("-") for path in paths):
        print("usage: netmesh_verify.py POINTS DIAGRAM PROOF [--quiet]", file=sys.stderr)
        return 2
    try:
        report = verify(*paths)
    except NotProven as failure:
        print(f"not proven: step {failure}", file=sys.stderr)
        return 7
    except (Malformed, OSError, MemoryError) as failure:
        print(f"netmesh_verify: {failure or 'memory'}", file=sys.stderr)
        return 3
    if "--quiet" not in arguments:
        print("\n".join(report))
    return 0
if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
