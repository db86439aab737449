#!/usr/bin/env python3
"""Writes measured figures into the documents, between `<!-- figures: NAME -->` and `<!-- end -->`.

  write.py stack BUILD      stack of every public call, by the compiler's call graph   -> FIGURES.md
  write.py jobs BUILD       stack of the documented jobs: of the Release build in BUILD for 64-bit machines, and of
                            engines for every core of platform/cortexm/cores.txt, which are built in BUILD/stack
                                                                                       -> engine/include/netmesh/job.h
  write.py size BUILD       code and constants by folder and dimension                 -> FIGURES.md
  write.py bare LOG         what `platform/cortexm/run` printed                        -> FIGURES.md
  write.py gaps LOG         what `tests/gaps/run short 3` printed                      -> FIGURES.md
  write.py coverage LOG     what `tests/coverage/run` printed                          -> tests/coverage/COVERAGE.md
  write.py light WORK       what jobs take on a board, measured by tests/embedding/footprint.py in WORK
                                                                                       -> tools/docs/small-parts.md
  write.py kinds WORK       instructions by kinds of points, by footprint.py --kinds   -> tools/docs/small-parts.md
  write.py windows LOG      what `platform/cortexm/run --windows D` printed for D = 2 and 3
                                                                                       -> tools/docs/small-parts.md
  write.py lemmas LOG       what `test_mesh -tc="every lemma*"` printed                -> FIGURES.md

Nothing between the marks is written by hand. Exit code 1: the marks or the figures are missing."""
import argparse
import os
import re
import subprocess
import sys

TESTS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(TESTS, "archive"), os.path.join(TESTS, "stack")]
import check as graph_check  # noqa: E402
import run as stack_run  # noqa: E402

FIGURES = os.path.join(TESTS, "figures", "FIGURES.md")
JOB_HEADER = os.path.join(os.path.dirname(TESTS), "engine", "include", "netmesh", "job.h")
SMALL_PARTS = os.path.join(os.path.dirname(TESTS), "tools", "docs", "small-parts.md")
COVERAGE = os.path.join(TESTS, "coverage", "COVERAGE.md")
STACK_LEAST = 1024  # calls with less are not listed
PROMISE_STEP = 64   # what netmesh/job.h promises is a multiple of it
SMALL_DIMS = [2, 3, 4]
SMALL_LIBRARIES = [[2], [3], [4], [2, 3]]


def put(document, name, lines, mark="<!-- %s -->", space="\n"):
    """Replaces what stands between the marks of this name."""
    with open(document, encoding="utf-8") as f:
        text = f.read()
    begin, end = (re.escape(mark % words) for words in ("figures: " + name, "end"))
    marks = re.compile(r"(%s\n).*?(%s)" % (begin, end), re.S)
    if not lines:
        sys.exit("no figures for %s" % name)
    text, found = marks.subn(lambda m: m.group(1) + space + "\n".join(lines) + "\n" + space + m.group(2), text)
    if found != 1:
        sys.exit("%s has no place for %s" % (document, name))
    with open(document, "w", encoding="utf-8") as f:
        f.write(text)
    print("%s: %s" % (os.path.relpath(document), name))


def check(what, build, *options):
    """The output of tests/archive/check.py on the objects of a build."""
    records = os.path.join(build, "CMakeFiles", "netmesh_engine.dir")
    objects = os.path.join(build, "tests", "archive", "objects.txt")
    command = [sys.executable, os.path.join(TESTS, "archive", "check.py"), what, "--records", records,
               "--objects", objects, *options]
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()


def table(header, rows):
    return ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)] + ["| " + " | ".join(r) + " |" for r in rows]


def stack(build):
    lines = [line.split() for line in check("stack", build)]
    title = next(line for line in lines if line[:2] == ["worst", "chain,"])
    dimensions = [title[i + 2] for i, word in enumerate(title) if word == "D" and title[i + 1] == "="]
    calls = [line for line in lines if line and line[0].startswith("netmesh_") and len(line) == 2 + len(dimensions)]
    small = [int(c[1]) for c in calls if int(c[1]) < STACK_LEAST]
    rows = [["`%s`" % c[0]] + c[2:] for c in sorted(calls, key=lambda c: -int(c[1])) if int(c[1]) >= STACK_LEAST]
    text = table(["bytes"] + ["D = " + d for d in dimensions], rows)
    put(FIGURES, "stack", text + ["", "%d other calls take at most %d bytes." % (len(small), max(small))])


def promises(graphs):
    """{(job, dim): bytes}: the most of (graph, {dimension: whose promise it is}), rounded up, in slices without what a
    job takes beside."""
    most = {}
    for graph, dims in graphs:
        for (job, dim), (plain, sliced, _) in graph_check.stack_of_jobs(graph, dims).items():
            key = job, dims[dim]
            room = (1024 if graph_check.RED_ZONE_BYTES else 512) - graph_check.JOB_RECORD_BYTES
            most[key] = max(most.get(key, 0), plain, sliced - room)
    return {key: -(-n // PROMISE_STEP) * PROMISE_STEP for key, n in most.items()}


def macros(promise, dims):
    text = []
    for job in graph_check.JOBS:
        choice = ["(dim) == %d ? %d :" % (d, promise[job, d]) for d in dims]
        text.append("#define NETMESH_STACK_BYTES_%s(dim) \\" % job)
        text.append("    ((size_t)(%s \\" % " ".join(choice[:3]))
        text.append("              %s))" % " ".join(choice[3:] + ["NETMESH_STACK_BYTES(dim)"]))
    return text


def graph_in(folder, objects=None, source=None):
    return graph_check.graph_of(argparse.Namespace(records=folder, objects=objects, source=source,
                                                   readelf="arm-none-eabi-readelf"))


def jobs(build):
    """A minute for each core."""
    large = graph_in(os.path.join(build, "CMakeFiles", "netmesh_engine.dir"),
                     os.path.join(build, "tests", "archive", "objects.txt"))
    text = ["/* clang-format off */", "#if UINTPTR_MAX > 0xFFFFFFFFu"]
    text += [*macros(promises([(large, {d: d for d in range(2, 7)})]), range(2, 7)), "#else"]
    graph_check.RED_ZONE_BYTES = 0  # of x86-64 alone
    small = []
    for core in stack_run.cores():
        for dims in SMALL_LIBRARIES:
            folder = stack_run.build_engine(os.path.abspath(os.path.join(build, "stack")), core, dims)
            small.append((graph_in(folder, source=os.path.join(folder, "netmesh.cpp")), {d: dims[-1] for d in dims}))
    text += [*macros(promises(small), SMALL_DIMS), "#endif", "/* clang-format on */"]
    put(JOB_HEADER, "stack", text, "/* %s */", "")


def size(build):
    lines = [line for line in check("size", build) if not line.startswith("ok")]
    columns = [c.strip() for c in re.findall(r"(D = \d|any D|sum)", lines[0])]
    rows = []
    for line in lines[1:]:
        name, numbers = re.match(r"(.*?)((?:\s+\d+)+)$", line).groups()
        rows.append([name] + ["{:,}".format(int(n)) if int(n) > 0 else "" for n in numbers.split()])
    put(FIGURES, "size", table(["bytes"] + columns, rows))


def bare(log):
    with open(log, encoding="utf-8") as f:
        lines = [line.rstrip() for line in f if line.startswith("cortex-")]
    put(FIGURES, "bare", ["```"] + lines + ["```"])


def gaps(log):
    """Lines of calls alone."""
    line_of_call = re.compile(r"(.*\S)\s+D3 +(\d+) +(\d+) +([\d.]+) +([\d.]+) ")
    with open(log, encoding="utf-8") as f:
        calls = [found.groups() for found in map(line_of_call.match, f) if found]
    rows = [[name, "{:,}".format(int(points)), "{:,.1f}".format(float(millions)), "{:,}".format(int(polls)),
             "%.1f" % float(longest)] for name, points, polls, millions, longest in calls]
    put(FIGURES, "gaps", rows and table(["call", "points", "millions", "polls", "longest"], rows))


def coverage(log):
    """Tables are blocks of lines, a title and a number or an empty field for each column of 20 characters."""
    with open(log, encoding="utf-8") as f:
        blocks = [b.splitlines() for b in f.read().strip().split("\n\n") if b.strip()]
    blocks = [b for b in blocks if re.search(r"D = \d", b[0])]
    for name, block in zip(("branches", "conditions"), blocks):
        fields = [[line[:12].strip()] + [" ".join(line[i:i + 20].split()) for i in range(12, len(line), 20)]
                  for line in block]
        put(COVERAGE, name, table(fields[0], fields[1:]))
    if len(blocks) < 2:
        sys.exit("%s has no two tables" % log)


def light(work):
    """Some minutes of building and running."""
    command = [sys.executable, os.path.join(TESTS, "embedding", "footprint.py"), work]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    put(SMALL_PARTS, "light", done.stdout.splitlines())


def kinds(work):
    command = [sys.executable, os.path.join(TESTS, "embedding", "footprint.py"), work, "--kinds"]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    put(SMALL_PARTS, "kinds", done.stdout.splitlines())


def lemmas(log):
    """The last table of each dimension."""
    rows, titles, largest = {}, {}, {}
    with open(log, encoding="utf-8") as f:
        for line in f:
            title = re.match(r"D(\d) after (\d+) inputs", line)
            row = re.match(r"D(\d)  (.*\S)\s+(\d+)  ([\d.]+)  (\d+)$", line)
            most = re.match(r"D(\d)  (.*\S)\s+(\S+)$", line)
            if title:
                titles[title[1]] = int(title[2])
                rows[title[1]], largest[title[1]] = {}, {}
            elif row:
                rows[row[1]][row[2]] = row.groups()[2:]
            elif most:
                largest[most[1]][most[2]] = most[3]
    dims = sorted(titles)
    text = []
    for name in sorted({n for d in dims for n in rows[d]}):
        cells = [rows[d].get(name, ("", "", "0")) for d in dims]
        text.append([name] + ["{:,}".format(int(c[0])) if c[0] else "" for c in cells] + [c[1] for c in cells] +
                    [str(sum(int(c[2]) for c in cells))])
    head = ["lemma"] + ["checks, D = " + d for d in dims] + ["worst, D = " + d for d in dims] + ["violations"]
    more = [[name] + [largest[d].get(name, "") for d in dims] for name in sorted({n for d in dims for n in largest[d]})]
    put(FIGURES, "lemmas", ["Inputs: " + ", ".join("{:,} in {}D".format(titles[d], d) for d in dims) + ".", ""] +
        table(head, text) + ["", "Largest values of what has no bound with a number:", ""] +
        table(["largest"] + ["D = " + d for d in dims], more))


def windows(log):
    cores, dim = {}, None
    with open(log, encoding="utf-8") as f:
        for line in f:
            begin = re.match(r"windows\.c, D = (\d)", line)
            said = re.match(r"cortex-(\w+)  (\w+): (.*)", line)
            if begin:
                dim = begin[1]
            elif said:
                cores.setdefault((dim, said[1]), {})[said[2]] = [int(n) for n in re.findall(r"\d+", said[3])]
    rows = []
    for (dim, core), said in cores.items():
        window, window_most, slice_most = said["instructions"]
        rows.append([dim, core.upper()] + ["{:,}".format(n) for n in (said["flash"][0], said["flash"][2])] +
                    ["{:,} of {:,}".format(*said[name][at:at + 2]) for name, at in (("block", 0), ("stack", 2))] +
                    ["%.1f M" % (n / 1e6) for n in (window, window_most)] +
                    [str(said["slices"][1]), "{:,}".format(slice_most)])
    put(SMALL_PARTS, "windows",
        table(["D", "core", "flash", "RAM", "block", "stack of the job", "instructions a window", "at most",
               "slices, at most", "instructions a slice, at most"], rows))


def main():
    writers = {"stack": stack, "jobs": jobs, "size": size, "bare": bare, "gaps": gaps, "coverage": coverage,
               "light": light, "kinds": kinds, "windows": windows, "lemmas": lemmas}
    if len(sys.argv) != 3 or sys.argv[1] not in writers:
        sys.exit(__doc__)
    writers[sys.argv[1]](sys.argv[2])


if __name__ == "__main__":
    main()
