#!/usr/bin/env python3
"""Branch coverage of engine/ for each instantiation, out of `llvm-cov export -format=text` (JSON).

  table.py EXPORT ROOT [--list FILE] [--least PERCENT] [--conditions FOLDER...]

Prints covered and all branch outcomes by folder and dimension D. An instantiation is a branch of the source
at one D; copies for other template arguments (types, comparisons, orders of minors) and in several programs are the
same branch, also the copy of the arithmetic that is compiled without 128-bit integers. "any" is what has no D: plain
functions, and memory/, whose templates know types only. Conditions that the compiler folds are not counted. --list
writes what is not covered, a line a branch: place, outcome, dimensions. --conditions prints MC/DC of the folders named:
conditions shown to decide alone. Ends with 1 when a column is below --least."""
import argparse
import collections
import json
import os
import re
import sys

COLUMNS = [2, 3, 4, 5, 6, None]


def dimension_of(name, path):
    m = re.search(r"ILi([2-6])E", name)
    return int(m.group(1)) if m and not path.startswith("memory" + os.sep) else None


def functions(export, root):
    """(path, dimension, record) of every function that is written in engine/; paths from there."""
    engine = os.path.join(os.path.realpath(root), "engine") + os.sep
    for f in export["data"][0]["functions"]:
        path = os.path.realpath(f["filenames"][0])
        if path.startswith(engine):
            path = path[len(engine):]
            yield path, dimension_of(f["name"], path), f


def branch_outcomes(export, root):
    """{(path, line, column, outcome, dimension): largest count}"""
    counts = collections.Counter()
    for path, d, f in functions(export, root):
        for line, column, _, _, taken, not_taken in (b[:6] for b in f["branches"]):
            for outcome, count in ((True, taken), (False, not_taken)):
                key = (path, line, column, outcome, d)
                counts[key] = max(counts[key], count)
    return counts


def conditions(export, root):
    """{(path, line, column, dimension): [covered or not, a value for each condition]}"""
    decisions = {}
    for path, d, f in functions(export, root):
        for record in f.get("mcdc_records", []):
            key = (path, record[0], record[1], d)
            old = decisions.get(key, [False] * len(record[-1]))
            decisions[key] = [a or b for a, b in zip(old, record[-1])]
    return decisions


def print_table(title, covered, total, folders):
    print("%-12s" % title + "".join("%20s" % ("any" if d is None else "D = %d" % d) for d in COLUMNS) + "%20s" % "all")
    for folder in sorted(folders) + ["all"]:
        row = "%-12s" % folder
        for d in COLUMNS + ["all"]:
            n, m = covered[folder, d], total[folder, d]
            row += "%20s" % ("%d/%d %5.1f%%" % (n, m, 100.0 * n / m) if m else "")
        print(row)
    print()


def tally(items):
    """covered and total by (folder, dimension) with sums, from (path, dimension, is covered)."""
    covered, total, folders = collections.Counter(), collections.Counter(), set()
    for path, d, good in items:
        folder = path.split(os.sep)[0]
        folders.add(folder)
        for key in ((folder, d), (folder, "all"), ("all", d), ("all", "all")):
            total[key] += 1
            covered[key] += bool(good)
    return covered, total, folders


def in_words(dims):
    return ", ".join("any" if d is None else str(d) for d in COLUMNS if d in dims)


def print_conditions(export, root, folders):
    decided = {k: v for k, v in conditions(export, root).items() if k[0].split(os.sep)[0] in folders}
    print_table("MC/DC", *tally((k[0], k[3], c) for k, all_of in decided.items() for c in all_of))
    missing = collections.defaultdict(set)
    for (path, line, column, d), all_of in decided.items():
        for i, c in enumerate(all_of):
            if not c:
                missing[path, line, column, i + 1].add(d)
    for (path, line, column, i), dims in sorted(missing.items()):
        print("engine/%s:%d:%d condition %d not shown to decide alone, D = %s" %
              (path, line, column, i, in_words(dims)))
    print()


def write_list(counts, name):
    missing = collections.defaultdict(set)
    for (path, line, column, outcome, d), n in counts.items():
        if n == 0:
            missing[path, line, column, outcome].add(d)
    with open(name, "w") as file:
        for (path, line, column, outcome), dims in sorted(missing.items()):
            file.write("engine/%s:%d:%d never %s, D = %s\n" %
                       (path, line, column, str(outcome).lower(), in_words(dims)))
    print("%d branch outcomes are not covered: %s" % (sum(len(d) for d in missing.values()), name))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("export")
    parser.add_argument("root")
    parser.add_argument("--list")
    parser.add_argument("--least", type=float, default=0)
    parser.add_argument("--conditions", nargs="*", default=[])
    args = parser.parse_args()
    with open(args.export) as file:
        export = json.load(file)
    counts = branch_outcomes(export, args.root)
    covered, total, folders = tally((key[0], key[4], n) for key, n in counts.items())
    if not total:
        sys.exit("no function of engine/ in " + args.export)
    print_table("branches", covered, total, folders)
    if args.conditions:
        print_conditions(export, args.root, args.conditions)
    if args.list:
        write_list(counts, args.list)
    low = [d for d in COLUMNS if total["all", d] and 100.0 * covered["all", d] / total["all", d] < args.least]
    if low:
        print("below %.1f%%: %s" % (args.least, low))
    return 1 if low else 0


if __name__ == "__main__":
    sys.exit(main())
