#!/usr/bin/env python3
"""The error bounds of the floating-point stages of the predicates, proven from what their sources do. See README.md.

    check.py [--engine DIR] [--cxx PROGRAM] [--dims 2,3,4,5,6] [--scripts DIR]
    check.py --planted          changed operations and constants have to be refused

trace.cpp prints the operations of each stage, the walk follows roundings through them, Gappa proves what is left.
--scripts keeps what was given to Gappa. Exit code 77: Gappa or the compiler is missing."""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

sys.dont_write_bytecode = True
from walk import (HERE, LARGEST, POLYNOMIALS, TINY, U, WEIGHTS, Refused, Walk, about,  # noqa: E402
                  absolute_monomials, check_determinant, difference, more, require, traces, within, written)

ROOT = os.path.dirname(os.path.dirname(HERE))
SKIP = 77


# Gappa.

class Gappa:
    def __init__(self, folder):
        self.folder, self.proven, self.seconds = folder, set(), 0.0

    def prove(self, name, script):
        """A script is definitions, the claim in braces, hints. The rounding is that of doubles, denormals as they are;
        a claim for numbers that would overflow holds of doubles with larger exponents."""
        script = "@rnd = float<ieee_64,ne>;\n" + script
        if script in self.proven:
            return
        if self.folder is not None:
            file = "%03d_%s.g" % (len(self.proven), re.sub(r"\W+", "_", name))
            with open(os.path.join(self.folder, file), "w", encoding="utf-8") as f:
                f.write(script)
        begin = time.monotonic()
        try:
            done = subprocess.run(["gappa", "-Eprecision=200"], input=script, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, check=False, timeout=20)
            said = None if done.returncode == 0 else done.stdout
        except subprocess.TimeoutExpired:
            said = "it takes too long\n"
        self.seconds += time.monotonic() - begin
        require(said is None, "Gappa does not prove", name + ":\n%s" % said + script)
        self.proven.add(script)


def prove_model(gappa):
    """What the walk takes a rounding for."""
    double = "x = rnd(x_); y = rnd(y_);\n"
    normal = "|z| in [0x1p-1021, 0x1p1023]"
    claims = {
        "products: relative": "{ %s -> rnd(z) -/ z in %s }" % (normal, about(U)),
        "products: absolute": "{ |z| in [0, 0x1p-1021] -> |rnd(z) - z| in %s }" % within(0 * U, TINY),
        "sums": double + "{ rnd(x + y) -/ (x + y) in %s }" % about(U),
        "differences": double + "{ rnd(x - y) -/ (x - y) in %s }" % about(U),
        "roots": double + "{ x in [0x1p-1074, 0x1p1023] -> rnd(sqrt(x)) -/ sqrt(x) in %s }" % about(U),
    }
    for name, script in claims.items():
        gappa.prove("model " + name, script)




# What is claimed of a stage: the computed determinant differs from the exact one by no more than the computed error,
# from which it is above or below. In the plane, where the error is smaller: where the sign is taken it is right. There
# the last operation x + y of the determinant does not change its sign; with at most e roundings in a product x + y is
# off by (1 + u)^(e - 1) - 1 times its products, and above error / (1 + u) where the determinant is above the error.

def power(base, count):
    return "*".join([base] * count) if count else "1"


def least_of(count):
    """The least product of so many roundings' factors."""
    return power("(1 - 1b-53)", count)


def most_of(count):
    return power("(1 + 1b-53)", count)


def prove_margin(gappa, name, margin):
    gappa.prove(name, "{ %s >= 0 }" % margin)


def cone(trace, x):
    """All numbers that x is made from, itself among them."""
    found, left = set(), [x]
    while left:
        n = left.pop()
        if not isinstance(n, Fraction) and n not in found:
            found.add(n)
            left += trace.node[n][1:] if trace.node[n][0] != "input" else []
    return found


def plane_size(gappa, trace):
    """What differences of coordinates are below, by limits of their sums of squares; None without."""
    limits = {a: b for comparison, a, b, outcome in trace.guard
              if comparison == "<" and outcome and isinstance(b, Fraction)}
    if not limits:
        return None
    found = set()
    for lift in limits:
        squares = [trace.parts(x, "*") for x in trace.parts(lift, "+")]
        require(all(a == b for a, b in squares), trace, "has a limit for what is no sum of two squares")
        found |= {a for a, _ in squares}
    require(len(found) == 2 * trace.rows, trace, "has no limit for some difference")
    limit = max(limits.values())
    half = Fraction(2)**(limit.numerator.bit_length() // 2 + 1)
    for large, other in ("xy", "yx"):
        gappa.prove("%s size %s" % (trace, large), "x = rnd(x_); y = rnd(y_); s = rnd(rnd(x*x) + rnd(y*y));\n"
                    "{ |%s| in %s /\\ |%s| in %s -> s >= %s }" % (large, within(half, LARGEST), other,
                                                                  within(0 * U, LARGEST), written(limit)))
    return half


def plane_margins(gappa, trace):
    """Each product of the determinant by itself against the same product in the error."""
    comparisons = [g for g in trace.guard if not any(isinstance(x, Fraction) for x in g[1:3])]
    require([g[0] for g in comparisons] == [">", "<"], trace, "is decided by other comparisons")
    (_, value, error, positive), (_, again, negated, negative) = comparisons
    require(value == again and trace.parts(negated, "neg")[0] == error, trace, "is decided by other comparisons")
    require(trace.sign == positive - negative != 0, trace, "gives another sign")
    size = plane_size(gappa, trace)
    # Without limits what overflows makes the error infinite or no number, which decides nothing; the last difference
    # is rounded to no more than the sum in the error.
    require(size is not None or cone(trace, value) - {value} <= cone(trace, error), trace, "may overflow unseen")
    walk = Walk(trace, (Fraction(1), None if size is None else Fraction(1)), size)
    computed, bound = walk.of(value), walk.of(error)
    e = check_determinant(trace, computed)
    products = absolute_monomials(POLYNOMIALS.of(bound.key))
    require(products.keys() == POLYNOMIALS.of(computed.key).keys() | {0}, trace, "has other products in its error")
    for monomial, (coefficient, count) in products.items():
        wanted = "(%s - 1)" % most_of(e - 1) if monomial else written(computed.off + bound.off)
        prove_margin(gappa, "%s, %s" % (trace, "a product" if monomial else "underflow"),
                     "%s*%s/(1 + 1b-53) - %s" % (written(coefficient), least_of(count), wanted))
    Relative(gappa, trace).check(value, error)
    return e


# The plane once more, by other means, for runs without underflow: each step of the error's way by Gappa. A number
# x is known as (w, e, g): it is off by e w at most and |x| <= g w, w being made of computed numbers: ("abs", number),
# ("+", w, w) or ("*", w, w), or a number that is its own.

NEAR = 1 + Fraction(1, 2**20)


class Relative:
    def __init__(self, gappa, trace):
        self.gappa, self.trace, self.known = gappa, trace, {}

    def prove(self, what, script):
        self.gappa.prove("%s, %s" % (self.trace, what), script)

    def bounded(self, what, text, bound, hypotheses, by_share=False):
        """|text| <= bound for |name| <= most of hypotheses and a share w, which is looked at in pieces if by_share."""
        claims = ["w in [0, 1]"] + ["|%s| in %s" % (name, within(0 * U, most)) for name, most in hypotheses.items()]
        self.prove(what, "{ %s -> |%s| in %s }\n" % (" /\\ ".join(claims), text, within(0 * U, bound)) +
                   ("|%s| $ w;" % text if by_share else ""))
        return bound

    def of(self, x):
        if x not in self.known:
            self.known[x] = self.make(x)
        return self.known[x]

    def make(self, x):
        operation, a, b = self.trace.node[x]
        if operation == "*" and self.trace.node[a][0] == self.trace.node[b][0] == "-" and self.is_difference(a, b):
            return ("abs", x), self.product(a == b), Fraction(1)
        if operation == "+" and all(self.trace.node[y][0] == "*" and len(set(self.trace.node[y][1:])) == 1
                                    for y in (a, b)):
            square = self.product(True)
            off = self.total(square, square, 1 + square, 1 + square, U)
            return x, self.of_computed(off), Fraction(1)
        (v, e, g), (w, f, h) = self.of(a), self.of(b)
        names = {"e": e, "f": f, "g": g, "h": h, "d": U}
        if operation == "*":
            off = self.bounded("a product of sums", "g*h*d + g*f + h*e - e*f",
                               more((g * h * U + g * f + h * e) * NEAR), names)
            return ("*", v, w), off, more(g * h * (1 + U))
        return ("+", v, w), self.total(e, f, g, h, U), more(max(g, h) * (1 + U))

    def total(self, e, f, g, h, last):
        """A sum or difference, rounded by `last`."""
        bound = more((max(e, f) + last * max(g, h)) * (1 + Fraction(1, 64)))
        return self.bounded("a sum", "w*(e + d*g) + (1 - w)*(f + d*h)", bound,
                            {"e": e, "f": f, "g": g, "h": h, "d": last}, by_share=True)

    def is_difference(self, *numbers):
        return all(self.trace.node[y][0] == "input" for x in numbers for y in self.trace.node[x][1:])

    def product(self, is_square):
        """A product of two differences of doubles, relative to itself, where it is a normal number."""
        bound = 3 * U * NEAR
        script = "".join("%s = rnd(%s_);\n" % (name, name) for name in "abcd")
        second = "(a - b)" if is_square else "(c - d)"
        script += "p = rnd(rnd(a - b)*rnd%s);\n" % second
        self.prove("a square" if is_square else "a product of differences", script +
                   "{ |rnd(a - b)*rnd%s| in [0x1p-1021, 0x1p1023] -> p -/ ((a - b)*%s) in %s }" % (second, second,
                                                                                                   about(bound)))
        return self.of_computed(bound)

    def of_computed(self, bound):
        """x off by bound times the exact number: relative to the computed one."""
        return self.bounded("relative to what is computed", "e / (1 + e)", more(bound * NEAR), {"e": bound})

    def covered(self, x, w):
        """The most roundings of a product in x, which is w."""
        if x == w or isinstance(w, tuple) and w[0] == "abs" and self.trace.node[x] == w:
            return 0
        require(isinstance(w, tuple) and self.trace.node[x][0] == w[0], self.trace, "has an error of another form")
        counts = [self.covered(y, v) for y, v in zip(self.trace.node[x][1:], w[1:])]
        return 1 + (sum(counts) if w[0] == "*" else max(counts))

    def check(self, value, error):
        (v, e, g), (w, f, h) = [self.of(y) for y in self.trace.node[value][1:]]
        off = self.total(e, f, g, h, 0 * U)
        scaled = self.trace.parts(error, "+")[0]
        constant, permanent = self.trace.parts(scaled, "*")
        count = 2 + self.covered(permanent, ("+", v, w))
        self.prove("the whole", "{ %s*%s/(1 + 1b-53) - %s >= 0 }" % (written(constant), least_of(count), written(off)))


def is_power_of_two(x):
    return isinstance(x, Fraction) and all(n > 0 and n & (n - 1) == 0 for n in (x.numerator, x.denominator))


def is_sum(trace, x):
    """A sum, or one that is scaled."""
    operation, *operands = ("", ) if isinstance(x, Fraction) else trace.node[x]
    return operation == "+" or operation == "*" and is_power_of_two(operands[1]) and is_sum(trace, operands[0])


def factors_of(trace, x, half_powers=2):
    """x as a product of powers of constants and of sums: {number: twice its power}."""
    operation, *operands = ("", ) if isinstance(x, Fraction) else trace.node[x]
    if operation not in ("*", "sqrt") or is_sum(trace, x):
        return {x: half_powers}
    found = {}
    for y in operands:
        for z, halves in factors_of(trace, y, half_powers // 2 if operation == "sqrt" else half_powers).items():
            require(halves > 0, trace, "has the root of a root")
            found[z] = found.get(z, 0) + halves
    return found


def expression(trace, x, names, rounds):
    """x as Gappa reads it, with every operation rounded or without; names: of numbers."""
    if isinstance(x, Fraction):
        return written(x)
    if x in names:
        return names[x]
    operation, *operands = trace.node[x]
    parts = [expression(trace, y, names, rounds) for y in operands]
    require(operation in ("+", "-", "*", "sqrt"), trace, "has an operation that is not followed:", operation)
    text = "sqrt(%s)" % parts[0] if operation == "sqrt" else "(%s %s %s)" % (parts[0], operation, parts[1])
    return "rnd(%s)" % text if rounds else text


ERROR_ROUNDED = Fraction(1, 2**48)


def prove_error_rounded(gappa, trace, error, ranges):
    """The computed error is the exact product of its factors but for ERROR_ROUNDED. ranges: {number: (least, most)}."""
    names = {x: "s%d" % i for i, x in enumerate(sorted(ranges))}
    script = "".join("%s = rnd(%s_);\n" % (name, name) for name in names.values())
    for name, rounds in (("e", True), ("x", False)):
        script += "%s = %s;\n" % (name, expression(trace, error, names, rounds))
    claims = ["%s in %s" % (names[x], within(*ranges[x])) for x in names]
    gappa.prove("%s, error" % trace, script + "{ %s -> e -/ x in %s }" % (" /\\ ".join(claims), about(ERROR_ROUNDED)))


def squares_of(trace, walk, numbers):
    """{row: (number, the most roundings of a product, what underflows)} of those that are sums of a row's squares."""
    found = {}
    for x in numbers:
        number = walk.of(x)
        row = number.rows.bit_length() - 1
        polynomial = POLYNOMIALS.of(number.key)
        require(number.rows == 1 << row and number.lifts == 1 and row not in found and
                {m: c for m, (c, _) in polynomial.items()} ==
                {2 * difference(row, c): 1 for c in range(trace.dim)}, trace, "has another factor in its error")
        found[row] = (x, max(k for _, k in polynomial.values()), number.off)
    require(len(found) == trace.rows, trace, "lacks a row in its error")
    return found


def form_margin(gappa, trace, computed, factors, squares, lost=Fraction(0), of_lifts=None):
    """The permanent inequality: error over the product of lengths, squares being those lengths but for `low`, against
    what the determinant is off, both without the product. lost: what a scale takes from lifts. of_lifts: `low` of what
    stands for lifts, where that is no length."""
    e = check_determinant(trace, computed)
    constant = Fraction(1)
    for x, half_powers in factors.items():
        if isinstance(x, Fraction):
            require(half_powers % 2 == 0, trace, "has the root of a constant")
            constant *= x**(half_powers // 2)
    off = max(off for _, _, off in squares.values()) + lost
    count = max(k for _, k, _ in squares.values())
    permanent = 1
    for k in range(2, trace.dim + 1):
        permanent *= k
    permanent = "%d/sqrt(%d)%s" % (permanent, trace.dim**trace.dim, "*%d" % trace.rows if trace.lifted else "")
    low = power("(%s - %s)" % (least_of(count), written(more(off))), trace.rows + (trace.lifted and of_lifts is None))
    low += "" if of_lifts is None else "*" + of_lifts
    prove_margin(gappa, "%s, margin" % trace, "%s*(1 - %s)*%s - (%s*(%s - 1) + %s)" % (
        written(constant), written(ERROR_ROUNDED), low, permanent, most_of(e), written(computed.off)))
    return e


def admitted(trace, rows):
    """The least and the largest of the squares of lengths that are admitted, and a walk for such lengths."""
    least = [{b for c, a, b, outcome in trace.guard if (c, a, outcome) == (">=", x, True)} for x in rows]
    most = [{b for c, a, b, outcome in trace.guard if (c, a, outcome) == ("<=", x, True)} for x in rows]
    require(all(least) and all(most), trace, "admits any length")
    least, most = min(max(x) for x in least), max(min(x) for x in most)
    # Exact lengths: of a sum below the least admitted one as computed, and above the largest.
    low, high = (Fraction(2)**(power_of(trace, x) // 2) for x in (least, most))
    require((low / NEAR)**2 * (1 + U)**(2 * trace.dim) + 2 * trace.dim * TINY < least and
            (high * NEAR)**2 * (1 - U)**(2 * trace.dim) - 2 * trace.dim * TINY > most, trace, "admits other lengths")
    return least, most, Walk(trace, (low / NEAR, high * NEAR), 1 + U)


def stage_margins(gappa, trace):
    """float_stage and is_sure."""
    sure = [g for g in trace.guard if g[0] == ">" and not isinstance(g[1], Fraction) and trace.node[g[1]][0] == "abs"]
    require(len(sure) == 1 and sure[0][3], trace, "is decided by other comparisons")
    determinant_, error = trace.parts(sure[0][1], "abs")[0], sure[0][2]
    if trace.stage == "decide":
        signs = [outcome for outcome in (True, False) if (">", determinant_, 0, outcome) in trace.guard]
        require(len(signs) == 1 and trace.sign == (1 if signs[0] else -1) * (-1)**trace.dim, trace,
                "gives another sign")
    else:
        require(trace.sign == 1 and trace.out["determinant"] == determinant_, trace, "has another determinant")
    factors = factors_of(trace, error)
    rows = [x for x in factors if not isinstance(x, Fraction)]
    least, most, walk = admitted(trace, rows)
    squares = squares_of(trace, walk, rows)
    expected = {x: 1 for x in rows}
    if trace.lifted:
        longest = [x for x in rows if factors[x] == 2]
        require(len(longest) == 1, trace, "has not the largest length once more")
        pairs = trace.at_least()
        require(all(x == longest[0] or (longest[0], x) in pairs for x in rows), trace, "has not the largest length")
        expected[longest[0]] = 2
    require({x: factors[x] for x in rows} == expected, trace, "has other lengths in its error")
    prove_error_rounded(gappa, trace, error, {x: (least, most) for x in rows})
    return form_margin(gappa, trace, walk.of(determinant_), factors, squares)


def weighted_margins(gappa, trace):
    """power_stage. A lift is |d|^2 + w; in its place in the error is the largest ratio (|d|^2 + |w|) / |d|, in which
    lifts are measured. It is not below any length, and what is known of |d|^2 as of a lift is known of a square, too:
    what underflows is as small, and lengths are not below the least admitted one."""
    comparisons = [g for g in trace.guard if not any(isinstance(x, Fraction) for x in g[1:3])][-2:]
    require([g[0] for g in comparisons] == [">", "<"], trace, "is decided by other comparisons")
    (_, value, error, positive), (_, again, negated, negative) = comparisons
    require(value == again and trace.parts(negated, "neg")[0] == error, trace, "is decided by other comparisons")
    require(trace.sign == positive - negative != 0, trace, "gives another sign")
    factors = factors_of(trace, error)
    ratios = [x for x in range(1, len(trace.node)) if trace.node[x][0] == "/"]
    rows = [x for x in factors if not isinstance(x, Fraction) and x not in ratios]
    widest = [x for x in factors if x in ratios]
    require(len(widest) == 1 and len(ratios) == trace.rows, trace, "has not the widest ratio")
    require({x: factors[x] for x in rows + widest} == {x: 1 for x in rows + widest}, trace, "has other lengths")
    pairs = trace.at_least()
    require(all(x == widest[0] or (widest[0], x) in pairs for x in ratios), trace, "has not the widest ratio")
    least, most, walk = admitted(trace, rows)
    require(all(("<=", x, most, True) in trace.guard for x in ratios), trace, "admits any weight")
    # Of squares of what is admitted nothing underflows.
    require(least**2 > Fraction(2)**-1000, trace, "admits lengths of any size")
    squares = squares_of(trace, walk, rows)
    counts, lost = [], []
    for row, (square, roundings, off) in squares.items():
        ratio = [x for x in ratios if trace.node[x][2] == square]
        require(len(ratio) == 1, trace, "lacks a ratio")
        total, again = trace.parts(trace.node[ratio[0]][1], "*")
        require(total == again, trace, "has another ratio")
        wanted = {2 * difference(row, c) for c in range(trace.dim)}
        wanted.add(sum(difference(row, c) for c in WEIGHTS[trace.stage]))
        number = walk.of(total)
        terms = absolute_monomials(POLYNOMIALS.of(number.key))
        require({m: c for m, (c, _) in terms.items()} == {m: 1 for m in wanted} and number.lifts == 1, trace,
                "has another ratio")
        counts.append((max(k for _, k in terms.values()), roundings))
        lost.append((number.off, off))
    # The root of the computed ratio over the exact one: two roundings of the ratio are one of its root.
    of_total, of_square = (max(x) for x in zip(*counts))
    off_total, off_square = (more(max(x)) for x in zip(*lost))
    of_lifts = "((%s - %s)*%s/(%s + %s))" % (least_of(of_total), written(off_total), least_of(1), most_of(of_square),
                                             written(off_square))
    low = ((1 - U)**of_total - off_total) * (1 - U) / ((1 + U)**of_square + off_square)
    require(low * NEAR > 1, trace, "admits other ratios")
    ranges = {x: (least, most) for x in rows}
    ranges[widest[0]] = (least * (1 - Fraction(1, 2**50)), most)
    prove_error_rounded(gappa, trace, error, ranges)
    return form_margin(gappa, trace, walk.of(value), factors, squares, of_lifts=of_lifts)


def power_of(trace, x):
    require(is_power_of_two(x) and (x.numerator * x.denominator).bit_length() % 2 == 1, trace, "has an odd limit")
    return x.numerator.bit_length() - x.denominator.bit_length()


def scaled_margins(gappa, trace):
    """float_stage_scaled. Each row is divided by its exponent's power of two: its largest coordinate, as computed, is
    at least 1 and below 2. Lifts are multiplied by the row's power of two over the widest row's."""
    determinant_, error = trace.out["determinant"], trace.out["error"]
    least = 1 - Fraction(1, 2**50)
    walk = Walk(trace, (least, Fraction(5)), 1 + U)
    computed = walk.of(determinant_)
    factors = factors_of(trace, error)
    numbers = [x for x in factors if not isinstance(x, Fraction)]
    rows = [x for x in numbers if walk.of(x).factor == 1]
    squares = squares_of(trace, walk, rows)
    most = Fraction(4 * trace.dim)
    for c in range(trace.dim):
        names = ["x%d" % i for i in range(trace.dim)]
        total = "rnd(x0*x0)"
        for name in names[1:]:
            total = "rnd(%s + rnd(%s*%s))" % (total, name, name)
        claims = ["|%s| in [%d, 2]" % (name, i == c) for i, name in enumerate(names)]
        gappa.prove("%s, squares with %d largest" % (trace, c), "".join("%s = rnd(%s_);\n" % (n, n) for n in names) +
                    "{ %s -> %s in %s }" % (" /\\ ".join(claims), total, within(Fraction(1), most)))
    ranges = {x: (Fraction(1), most) for x in numbers}
    expected = {x: 1 for x in rows}
    if trace.lifted:
        lifts = {}
        for x in range(1, len(trace.node)):
            if x in walk.number and walk.number[x].lifts == 1 and walk.number[x].rows & (walk.number[x].rows - 1) == 0:
                row = walk.number[x].rows.bit_length() - 1
                power = max(trace.exponent[row] - max(trace.exponent.values()), -2000)
                if walk.number[x].factor == Fraction(2)**power and (power or x == squares[row][0]):
                    lifts[row] = x
        require(len(lifts) == trace.rows, trace, "lacks a lift")
        pairs = trace.at_least()
        highest = [x for x in lifts.values() if factors.get(x, 0) > (x in rows)]
        require(len(highest) == 1, trace, "has not the largest lift")
        require(all(x == highest[0] or (highest[0], x) in pairs for x in lifts.values()), trace,
                "has not the largest lift")
        expected[highest[0]] = expected.get(highest[0], 0) + 2
    require({x: factors[x] for x in numbers} == expected, trace, "has other lengths in its error")
    prove_error_rounded(gappa, trace, error, ranges)
    # A lift is at least its power of two times its row's length, which is `least` or more.
    return form_margin(gappa, trace, computed, factors, squares, Fraction(1, 2**49))


def refused(trace):
    """Lengths out of range give a magnitude of 0, or no sign."""
    require(trace.sign == 0 or trace.out == {"determinant": 0, "magnitude": 0}, trace,
            "admits lengths that are out of range")


def arms_margins(gappa, trace):
    """In-circle tests of delaunay/plane.hpp. A lift is the square of a length, |a|^2, and a difference w of weights. In
    the bound |x y'| + |y x'| <= (|a|^2 + |a'|^2) / 2 takes the place of cross products, |a|^2 + |w| that of lifts."""
    walk = Walk(trace, (Fraction(1), Fraction(1)), Fraction(2)**121)
    computed, error = (walk.of(trace.out[name]) for name in ("value", "error"))
    weight = {2: None, 3: WEIGHTS["weights"], 4: WEIGHTS["radii"]}[trace.dim]
    lift = [{2 * difference(i, c): 1 for c in (0, 1)} for i in range(3)]
    for i in range(3) if weight else ():
        lift[i][sum(difference(i, c) for c in weight)] = 1
    wanted, bound = {}, {}
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        for m in lift[i]:
            wanted[m + difference(j, 0) + difference(k, 1)] = 1
            wanted[m + difference(j, 1) + difference(k, 0)] = -1
            bound.update({m + m2: 1 for m2 in lift[j]})
    products = POLYNOMIALS.of(computed.key)
    require({m: c for m, (c, _) in products.items()} == wanted, trace, "is another polynomial than the determinant")
    e = max(k for _, k in products.values())
    errors = absolute_monomials(POLYNOMIALS.of(error.key))
    absolute, count = errors.pop(0, (Fraction(0), 0))
    require(errors.keys() == bound.keys(), trace, "has other products in its error")
    prove_margin(gappa, "%s, underflow" % trace, "%s*%s/(1 + 1b-53) - %s" % (
        written(absolute), least_of(count), written(computed.off + error.off)))
    for coefficient, count in errors.values():
        prove_margin(gappa, "%s, a product" % trace, "%s*%s/(1 + 1b-53) - (%s - 1)" % (
            written(coefficient), least_of(count), most_of(e - 1)))
    # The side of an edge, whatever the extent: what overflows in a product does so in a square.
    walk = Walk(trace, (Fraction(1), None), None)
    computed, error = (walk.of(trace.out[name]) for name in ("side", "side_error"))
    products = POLYNOMIALS.of(computed.key)
    require({m: c for m, (c, _) in products.items()} == {difference(0, 0) + difference(1, 1): 1,
                                                         difference(0, 1) + difference(1, 0): -1}, trace, "has no side")
    sides = max(k for _, k in products.values())
    errors = absolute_monomials(POLYNOMIALS.of(error.key))
    absolute, count = errors.pop(0, (Fraction(0), 0))
    require(errors.keys() == {2 * difference(i, c) for i in (0, 1) for c in (0, 1)}, trace,
            "has another error of sides")
    prove_margin(gappa, "%s, underflow of sides" % trace, "%s*%s/(1 + 1b-53) - %s" % (
        written(absolute), least_of(count), written(computed.off + error.off)))
    for coefficient, count in errors.values():
        prove_margin(gappa, "%s, sides" % trace, "%s*%s/(1 + 1b-53) - (%s - 1)/2" % (
            written(coefficient), least_of(count), most_of(sides - 1)))
    return e


# What trace.cpp repeats of functions that are not traced.
REPEATED = {
    os.path.join("predicates", "undecided.cpp"): (
        "if (frame.exponent[i] == exponent_of_zero) return decide(0, false, stage_float);",
        "if (frame.widest(rows) <= 1023 && (first.magnitude == 0 || frame.gain > 2)) { "
        "const FloatResult second = float_stage_scaled(frame, dim, lifted); "
        "const double error = second.magnitude * error_factor(dim, lifted); "
        "if (__builtin_fabs(second.determinant) > error) "
        "return decide(sign_of(second.determinant), frame.negate, stage_float); }"),
    os.path.join("delaunay", "plane.hpp"): (
        "const double side[3] = {cross(arm[1], arm[2]), cross(arm[2], arm[0]), cross(arm[0], arm[1])}; "
        "const double value = arm[0].lift * side[0] + arm[1].lift * side[1] + arm[2].lift * side[2]; "
        "const double error = question.error_of(arm[0].size(), arm[1].size(), arm[2].size()); "
        "if (value > error) return c;",
        "const bool is_outside = W::has && value < -error;",
        "side[i] > 4 * unit_roundoff * (arm[next[i]].square() + arm[next[next[i]]].square()) + 0x1p-960;",
        "side[i] < -4 * unit_roundoff * (arm[next[i]].square() + arm[next[next[i]]].square()) - 0x1p-960",
        "const double up = cross(from, apex), down = cross(apex, to); "
        "const double value = from.lift * down + to.lift * up - apex.lift * edge; "
        "const double error = question.error_of(from.size(), to.size(), apex.size()); bool inside = value > 0;",
        "} else if (__builtin_expect(!(__builtin_fabs(value) > error), 0)) { inside = undecided_conflict(n);",
        "question_.extent2 = width * width + height * height; "
        "if constexpr (W::has) question_.extent2 += question_.weights.difference(most[2], least[2]);",
        "question_.underflow = question_.extent2 < 0x1p240 ? 0x1p-790 : infinity;")}
ARMS = ("struct PlaneArm {", "}  // namespace netmesh")


def write_arms(engine, scratch):
    """The part of delaunay/plane_question.hpp that trace.cpp includes."""
    with open(os.path.join(engine, "delaunay", "plane_question.hpp"), encoding="utf-8") as f:
        text = f.read()
    require(all(text.count(mark) == 1 for mark in ARMS), "delaunay/plane_question.hpp has no arms")
    with open(os.path.join(scratch, "arms.hpp"), "w", encoding="utf-8") as f:
        f.write(text[text.index(ARMS[0]):text.index(ARMS[1])])


def check_repeated(engine):
    for file, lines in REPEATED.items():
        with open(os.path.join(engine, file), encoding="utf-8") as f:
            text = " ".join(f.read().split())
        for line in lines:
            require(line in text, file, "has no longer:", line)


CHECKS = {"plane": plane_margins, "arms": arms_margins, "stage": stage_margins, "decide": stage_margins,
          "scaled": scaled_margins, "weights": weighted_margins, "radii": weighted_margins}


def check(gappa, cxx, engine, dims, flags):
    """{stage: (how many runs, most roundings)}"""
    found = {}
    check_repeated(engine)
    prove_model(gappa)
    with tempfile.TemporaryDirectory() as scratch:
        write_arms(engine, scratch)
        runs = traces(cxx, engine, scratch, dims, ["-I", scratch, *flags])
    for trace in runs:
        if trace.stage == "refused":
            refused(trace)
        elif trace.stage == "decide" and trace.dim == 2:
            require(trace.sign == plane_sign(trace), trace, "gives another sign")
        else:
            e = CHECKS[trace.stage](gappa, trace)
            count, most = found.get(str(trace), (0, 0))
            found[str(trace)] = (count + 1, max(most, e))
    return found


def plane_sign(trace):
    """What the last comparison with the error says, in the plane."""
    outcomes = [g[3] for g in trace.guard if not any(isinstance(x, Fraction) for x in g[1:3])]
    return outcomes[0] - outcomes[1]


# (dimension to look at, file of the engine, what stands there, what is put in its place)
PLANTS = [
    (2, "planar_stage.hpp", "4 * unit_roundoff", "3 * unit_roundoff"),
    (2, "planar_stage.hpp", " + 0x1p-960", ""),
    (2, "planar_stage.hpp", "11 * unit_roundoff", "10 * unit_roundoff"),
    (2, "planar_stage.hpp", "0x1p-790", "0x1p-850"),
    (2, "planar_stage.hpp", "a < 0x1p240", "a < 0x1p540"),
    (2, "planar_stage.hpp", "a * (bc - cb) + b * (ca - ac) + c * (ab - ba)",
     "a * bc - a * cb + b * ca - b * ac + c * ab - c * ba"),
    (2, "planar_stage.hpp", "__builtin_fabs(ca) + __builtin_fabs(ac)", "__builtin_fabs(ca - ac)"),
    (2, "planar_stage.hpp", "__builtin_fabs(left)", "left"),
    (2, "planar_stage.hpp", "__builtin_fabs(bc)", "bc"),
    (2, "planar_stage.hpp", "value < -error", "value < error"),
    (3, "float_stage.hpp", "roundings += k + 1", "roundings += k"),
    (2, "float_stage.hpp", "2 * dim + 3", "2 * dim + 2"),
    (2, "float_stage.hpp", "1.1102230246251565e-16", "1.1e-16"),
    (3, "float_stage.hpp", "1.15471", "1.152"),
    (2, "float_stage.hpp", "* (dim + 1)", "* dim"),
    (2, "float_stage.hpp", "960 / (", "1020 / ("),
    (2, "float_stage.hpp", "longest = s > longest ? s : longest", "longest = s"),
    (2, "float_stage.hpp", "admitted &= s >= Bounds::length_squared_min;", ""),
    (2, "float_stage.hpp", "if (!admitted) return {0, 0};", ""),
    (2, "float_stage.hpp", "half[i & 1] *= s", "half[0] *= s"),
    (2, "float_stage.hpp", "points[i][c] - points[n][c]", "points[i][c] - points[0][c]"),
    (2, "float_stage.hpp", "lift > highest ? lift : highest", "lift"),
    (2, "float_stage.hpp", "? -fall : -2000", "? -fall : -1000"),
    (2, "float_stage.hpp", "power_of_two(k - k / 2)", "power_of_two(k / 2)"),
    (2, "power_stage.hpp", "error_factor(D, true, 1)", "error_factor(D, true)"),
    (2, "power_stage.hpp", "s + __builtin_fabs(less)", "s + less"),
    (2, "power_stage.hpp", "sum * sum / s", "sum"),
    (2, "power_stage.hpp", "ratio2 > widest ? ratio2 : widest", "ratio2"),
    (2, "power_stage.hpp", "admitted &= ratio2 <= Bounds::length_squared_max;", ""),
    (2, "power_stage.hpp", "a[i][D] = s + less", "a[i][D] = s - less"),
    (2, "power_stage.hpp", "half[n & 1] *= widest;", ""),
    (2, "cascade.hpp", "result.magnitude * factor", "result.magnitude * (factor / 2)"),
    (3, "cascade.hpp", "(D & 1) != 0", "false"),
    (2, "undecided.cpp", "second.magnitude * error_factor", "0.5 * second.magnitude * error_factor"),
    (3, "../numerics/minors.hpp", "(J & 1) == 0", "(J & 1) != 0"),
    (2, "../numerics/minors.hpp", "(j & 1) != 0 ? sum - product", "(j & 1) == 0 ? sum - product"),
    (2, "../delaunay/plane_question.hpp", "11 * unit_roundoff", "10 * unit_roundoff"),
    (2, "../delaunay/plane_question.hpp", "13 * unit_roundoff", "11 * unit_roundoff"),
    (2, "../delaunay/plane_question.hpp", "square + __builtin_fabs(less)", "square + less"),
    (2, "../delaunay/plane_question.hpp", "a.x * b.y - a.y * b.x", "a.x * b.y + a.y * b.x"),
    (2, "../delaunay/plane.hpp", "0x1p-790", "0x1p-850"),
    (2, "../numerics/real.hpp", "unit_roundoff = 0x1p-53", "unit_roundoff = 0x1p-54"),
]


def planted(options):
    missed = 0
    for dim, name, old, new in PLANTS:
        with tempfile.TemporaryDirectory() as scratch:
            engine = os.path.join(scratch, "engine")
            for folder in ("delaunay", "include", "numerics", "predicates", "vocabulary"):
                shutil.copytree(os.path.join(options.engine, folder), os.path.join(engine, folder))
            path = os.path.join(engine, "predicates", name)
            with open(path, encoding="utf-8") as f:
                text = f.read()
            said = None
            if old in text:
                with open(path, "w", encoding="utf-8") as f:
                    f.write(text.replace(old, new))
                try:
                    check(Gappa(None), options.cxx, engine, sorted({2, dim}), ["-O0"])
                except Refused as refusal:
                    said = str(refusal).split("\n")[0]
            seen = said is not None and not said.startswith("the stages cannot be traced")
            missed += not seen
            print("%-16s %s -> %s: %s" % (os.path.basename(name), old, new or "nothing", said if seen else "NOT SEEN" if
                                          old in text else "NOT THERE"), flush=True)
    return 1 if missed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", default=os.path.join(ROOT, "engine"))
    parser.add_argument("--cxx", default=os.environ.get("CXX", "c++"))
    parser.add_argument("--dims", default="2,3,4,5,6")
    parser.add_argument("--scripts")
    parser.add_argument("--planted", action="store_true")
    options = parser.parse_args()
    for program in ("gappa", options.cxx):
        if shutil.which(program) is None:
            print("skipped: %s is not installed" % program)
            return SKIP
    if options.planted:
        return planted(options)
    if options.scripts is not None:
        os.makedirs(options.scripts, exist_ok=True)
    gappa = Gappa(options.scripts)
    try:
        for flags in (["-O0"], ["-Os"]):
            found = check(gappa, options.cxx, options.engine, [int(d) for d in options.dims.split(",")], flags)
            for stage, (runs, most) in found.items():
                print("%s  %-24s at most %2d roundings in a product, %2d runs" % (flags[0], stage, most, runs))
    except Refused as refusal:
        print("NOT PROVEN: %s" % refusal)
        return 1
    print("%d claims proven by Gappa in %.1f s" % (len(gappa.proven), gappa.seconds))
    return 0


if __name__ == "__main__":
    sys.exit(main())
