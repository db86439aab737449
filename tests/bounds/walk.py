"""Operations of the stages as trace.cpp prints them, and the walk over them that follows roundings."""
import itertools
import os
import subprocess
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
U = Fraction(1, 2**53)          # of a rounding, relative
TINY = Fraction(1, 2**1075)     # of a product below the least normal double, absolute
LARGEST = Fraction(2)**1023     # nothing below it overflows when it is rounded


class Refused(Exception):
    """A bound that is not proven, or operations that are not those of the proof."""


def require(condition, *what):
    if not condition:
        raise Refused(" ".join(str(word) for word in what))


# Numbers for Gappa, and rounding of bounds, which would grow without end.

def more(x):
    """x >= 0 rounded up to 64 bits."""
    if x == 0:
        return Fraction(0)
    unit = Fraction(2)**(x.numerator.bit_length() - x.denominator.bit_length() - 64)
    return -(-x // unit) * unit


def written(x):
    """A binary fraction, exactly."""
    power = x.denominator.bit_length() - 1
    require(x.denominator == 1 << power, x, "is no binary fraction")
    return "%db%d" % (x.numerator, -power)


def within(low, high):
    return "[%s, %s]" % (written(low), written(high))


def about(bound):
    return within(-bound, bound)


# What trace.cpp prints.

class Trace:
    def __init__(self, stage, dim, lifted):
        self.stage, self.dim, self.lifted = stage, int(dim), lifted == "1"
        self.rows = self.dim + self.lifted
        self.node = [None]      # (operation, operand, operand)
        self.guard = []         # (comparison, operand, operand, outcome)
        self.out, self.exponent, self.sign = {}, {}, None

    def __str__(self):
        if self.stage == "arms":
            return "plane.hpp, %s" % ("no weights", "weights", "radii")[self.dim - 2]
        return "%s %s, D = %d" % (self.stage, "in_ball" if self.lifted else "orient", self.dim)

    def operand(self, word):
        return self.same(int(word[1:])) if word.startswith("#") else Fraction(float.fromhex(word))

    def same(self, n):
        """The operand that n is without a rounding: 0 + x, 1 * x."""
        operation, *operands = self.node[n]
        if operation in "+*" and (0 if operation == "+" else 1) in [x for x in operands if isinstance(x, Fraction)]:
            others = [x for x in operands if not isinstance(x, Fraction)]
            return others[0]
        return n

    def read(self, word, *rest):
        if word == "out":
            self.out[rest[0]] = self.operand(rest[1])
        elif word == "sign":
            self.sign = int(rest[0])
        elif word == "exponent":
            self.exponent[int(rest[0])] = int(rest[1])
        elif word == "input":
            self.node.append((word, int(rest[0]), int(rest[1])))
        elif word in ("<", "<=", ">", ">=", "=="):
            self.guard.append((word, self.operand(rest[0]), self.operand(rest[1]), rest[2] == "1"))
        else:
            self.node.append((word, *[self.operand(x) for x in rest]))

    def parts(self, x, operation):
        """Operands of x, which is what that operation made."""
        require(not isinstance(x, Fraction) and self.node[x][0] == operation, self, "no", operation, "where one was")
        return self.node[x][1:]

    def is_above(self, a, b):
        """Whether comparisons of this run say a > b."""
        return (">", a, b, True) in self.guard or ("<", b, a, True) in self.guard

    def at_least(self):
        """Pairs (a, b) with a >= b, by comparisons of this run."""
        pairs = set()
        for comparison, a, b, outcome in self.guard:
            if comparison in ("<", "<="):
                comparison, a, b = (">", b, a) if comparison == "<" else (">=", b, a)
            if comparison == "==":
                continue
            pairs.add((a, b) if outcome else (b, a))
        found = True
        while found:
            found = {(a, d) for a, b in pairs for c, d in pairs if b == c} - pairs
            pairs |= found
        return pairs


def traces(cxx, engine, scratch, dims, flags):
    program = os.path.join(scratch, "trace")
    done = subprocess.run([cxx, "-std=c++17", *flags, "-I", engine, "-I", os.path.join(engine, "include"),
                           "-DNETMESH_EACH_DIMENSION(DO)=" + " ".join("DO(%d)" % d for d in dims),
                           os.path.join(HERE, "trace.cpp"), "-o", program],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    require(done.returncode == 0, "the stages cannot be traced:\n" + done.stdout)
    text = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout
    found = []
    for line in text.splitlines():
        word, *rest = line.split()
        if word == "trace":
            found.append(Trace(*rest))
        else:
            found[-1].read(word, *rest)
    return found


# The walk. Every number of a stage is a polynomial in the differences of coordinates, times rounding factors 1 + delta,
# plus what products below the least normal double lose. Polynomials are {monomial: (coefficient, roundings)}: the
# monomial's product of factors has at most so many. Three bits of a monomial for each difference: its power.

COLUMNS = 8         # of coordinates up to six, and two for a difference of weights, which of radii is a product

def difference(row, column):
    return 1 << 3 * (COLUMNS * row + column)


ABSOLUTE = 3 * 7 * COLUMNS  # where the powers of differences begin of which the absolute value is taken
ODD = sum(difference(row, c) for row in range(7) for c in range(COLUMNS))
WEIGHTS = {"weights": (6, ), "radii": (6, 7)}


def absolute_monomials(polynomial):
    """Of a polynomial that is no sum of other terms than constants, squares and absolute values: by the monomials."""
    found = {}
    for m, (c, k) in polynomial.items():
        low, high = m & (1 << ABSOLUTE) - 1, m >> ABSOLUTE
        require(c > 0 and low & ODD == 0 and low + high not in found, "an error has terms that may be negative")
        found[low + high] = (c, k)
    return found


class Polynomials:
    """Numbers of all traces: the same operations on the same differences are the same number."""

    def __init__(self):
        self.known, self.made, self.value = {}, [], {}

    def key(self, *what):
        if what not in self.known:
            self.known[what] = len(self.made)
            self.made.append(what)
        return self.known[what]

    def of(self, key):
        if key not in self.value:
            self.value[key] = self.compute(*self.made[key])
        return self.value[key]

    def compute(self, operation, *operands):
        if operation == "difference":
            return {difference(*operands): (1, 1)}
        if operation == "constant":
            return {0: (operands[0], 0)}
        a = self.of(operands[0])
        if operation == "abs":
            require(len(a) == 1, "the absolute value of a sum")
            return {(m if m >> ABSOLUTE else m << ABSOLUTE): (abs(c), k) for m, (c, k) in a.items()}
        b = self.of(operands[1])
        product = {}
        if operation == "*":
            for (m, (c, k)), (m2, (c2, k2)) in itertools.product(a.items(), b.items()):
                require(m + m2 not in product, "a monomial comes twice in a product")
                product[m + m2] = (c * c2, k + k2 + 1)
            return product
        require(operation in "+-", "an operation that is not followed:", operation)
        require(not a.keys() & b.keys(), "a monomial comes twice in a sum")
        product = {m: (c, k + 1) for m, (c, k) in a.items()}
        product.update({m: (c if operation == "+" else -c, k + 1) for m, (c, k) in b.items()})
        return product


POLYNOMIALS = Polynomials()


class Number:
    """A number of a trace. rows, lifts: it is a form in rows of the matrix, of degree one in each, and `lifts` lengths
    more; it is measured in the product of these lengths, the longest one in place of the lifts'. size: the most that
    it is, as computed, off: what underflow takes from it, or adds."""

    def __init__(self, key, rows, lifts, size, off, factor=Fraction(1)):
        self.key, self.rows, self.lifts, self.size, self.off, self.factor = key, rows, lifts, size, off, factor

    def degree(self):
        return bin(self.rows).count("1") + self.lifts


class Walk:
    """lengths: the least of a row and the largest; sizes: of what is a difference, relative to its row's length."""

    def __init__(self, trace, lengths, size):
        self.trace, self.lengths, self.size, self.number = trace, lengths, size, {}
        self.base = 3 if trace.stage == "arms" else trace.rows
        # Where the number of a point stands that is no coordinate.
        self.column = 2 if trace.stage == "arms" else trace.dim if trace.stage in WEIGHTS else None

    def of(self, x):
        if x not in self.number:
            self.number[x] = self.make(x)
            size, degree = self.number[x].size, self.number[x].degree()
            if size is not None and self.lengths[1] is not None:
                require(size * self.lengths[1]**degree < LARGEST, self.trace, "may overflow")
        return self.number[x]

    def are_inputs(self, numbers):
        return all(not isinstance(y, Fraction) and self.trace.node[y][0] == "input" for y in numbers)

    def is_of_weights(self, numbers):
        return self.column is not None and self.are_inputs(numbers) and self.trace.node[numbers[0]][2] == self.column

    def lost(self, degree):
        return more(TINY / self.lengths[0]**degree)

    def make(self, x):
        if isinstance(x, Fraction):
            return Number(POLYNOMIALS.key("constant", x), 0, 0, abs(x), 0)
        operation, *operands = self.trace.node[x]
        if operation == "-" and self.are_inputs(operands) and not self.is_of_weights(operands):
            (_, i, c), (_, base, c2) = (self.trace.node[y] for y in operands)
            require(c == c2 and base == self.base and i < base, self.trace, "a difference of other coordinates")
            return Number(POLYNOMIALS.key("difference", i, c), 1 << i, 0, self.size, Fraction(0))
        if operation in "+-" and self.is_of_weights(operands):
            (_, base, _), (_, i, c) = (self.trace.node[y] for y in operands)
            require(base == self.base and i < base and c == self.column, self.trace, "a difference of other weights")
            # Of radii the product of both is a difference of weights: the two sizes hold for it alone.
            columns = WEIGHTS["radii"]
            column, size = (columns[0], self.size**2) if operation == "-" else (columns[1], Fraction(1))
            of_lift = operation == "-" and self.trace.stage != "arms"
            return Number(POLYNOMIALS.key("difference", i, column), of_lift << i, int(of_lift), size, Fraction(0))
        a = self.of(operands[0])
        if operation == "abs":
            return Number(POLYNOMIALS.key("abs", a.key), a.rows, a.lifts, a.size, a.off)
        require(operation in "+-*", self.trace, "an operation that is not followed:", operation)
        b = self.of(operands[1])
        if operation == "*" and self.trace.stage == "scaled" and not isinstance(operands[0], Fraction) and isinstance(
                operands[1], Fraction):
            return self.scaled(a, operands[1])
        if operation == "*":
            self.check_scale(a)
            self.check_scale(b)
            key = POLYNOMIALS.key("*", *sorted((a.key, b.key)))
            rows, lifts = a.rows | b.rows, a.lifts + b.lifts + bin(a.rows & b.rows).count("1")
            lost = self.lost(a.degree() + b.degree())
            size = None if None in (a.size, b.size) else more(a.size * b.size * (1 + U) + lost)
            off = (a.size * b.off if b.off else 0) + (b.size * a.off if a.off else 0)
            return Number(key, rows, lifts, size, more(off * (1 + U) + lost))
        require(a.factor == 1 == b.factor, self.trace, "a sum of scaled numbers")
        if self.trace.stage not in ("plane", "arms"):
            require((a.rows, a.lifts) == (b.rows, b.lifts), self.trace, "a sum of forms in different rows")
        size = None if None in (a.size, b.size) else more((a.size + b.size) * (1 + U))
        return Number(POLYNOMIALS.key(operation, a.key, b.key), a.rows, a.lifts, size, more((a.off + b.off) * (1 + U)))

    # float_stage_scaled: what stands in the matrix is multiplied by powers of two, in two steps.
    def scaled(self, a, power):
        require(power.numerator & power.numerator - 1 == 0 and power.denominator & power.denominator - 1 == 0,
                self.trace, "scaled by what is no power of two")
        lost = self.lost(a.degree())
        return Number(a.key, a.rows, a.lifts, more(a.size + lost), more(a.off + lost), a.factor * power)

    def check_scale(self, a):
        if self.trace.stage != "scaled" or a.rows & a.rows - 1 or a.rows == 0:
            return
        row, exponent = a.rows.bit_length() - 1, self.trace.exponent
        power = -exponent[row] if a.lifts == 0 else max(exponent[row] - max(exponent.values()), -2000)
        require(a.factor == Fraction(2)**power, self.trace, "row", row, "is scaled by another power of two")


def determinant(dim, lifted, weight):
    """{monomial: coefficient} of the determinant that frame.hpp says; weight: what a lift has beside squares."""
    rows = dim + lifted
    found = {}
    for order in itertools.permutations(range(rows)):
        sign = 1
        for i, j in itertools.combinations(range(rows), 2):
            sign = -sign if order[i] > order[j] else sign
        monomial = sum(difference(order[c], c) for c in range(dim))
        for c in range(dim) if lifted else [None]:
            found[monomial + (2 * difference(order[dim], c) if lifted else 0)] = sign
        if weight:
            found[monomial + sum(difference(order[dim], c) for c in weight)] = sign
    return found


DETERMINANTS = {}


def check_determinant(trace, number):
    """That it is the determinant, and the most roundings of a product in it."""
    weight = WEIGHTS.get(trace.stage)
    which = (trace.dim, trace.lifted, weight, number.key)
    if which not in DETERMINANTS:
        wanted, found = determinant(trace.dim, trace.lifted, weight), POLYNOMIALS.of(number.key)
        require({m: c for m, (c, _) in found.items()} == wanted, trace, "is another polynomial than the determinant")
        DETERMINANTS[which] = max(k for _, k in found.values())
    if trace.stage != "plane":
        require(number.rows == (1 << trace.rows) - 1 and number.lifts == trace.lifted, trace, "another form")
    return DETERMINANTS[which]
