#!/usr/bin/env python3
"""What the README and the pages of tools/docs promise.

  check.py commands BUILD   every command block is run in a fresh folder, and its output is what the page shows; every
                            picture of a page is what its commands make
  check.py write BUILD      writes into the pages what their commands print and draw now
  check.py links            links lead to files and headings of the project; those to elsewhere have the form of one
  check.py names BUILD      every option of `netmesh help` and every call of netmesh.h is in the pages, and no other is
  check.py schema BUILD     what --json prints for every command, and what fails, is as tools/docs/schema.json has it
  check.py site BUILD       tools/docs/build makes the site; links of all its pages work; a manual page for each command
  check.py planted BUILD    each of these finds what is wrong

Blocks: ```sh is run and has to succeed; ```console has lines `$ command` and what they print, `time     differs` for a
line that begins with time; ```python is run where numpy is there. A line in front of a block says otherwise:
<!-- run by: TEST -->, the name of a test that does it; <!-- not run: REASON -->; <!-- needs: PROGRAM --> of one that is
run where there is such a program; <!-- file: NAME --> of a block that is a file in the folder of the commands that
follow. <!-- rows: COMMANDS --> in front of a table: behind these commands those in its cells are run,
row by row. In that folder are the files of the project, its build as `build`, and for pages that have it beside them
the project as `netmesh`."""
import argparse
import glob
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
BLOCK = re.compile(r"(?:^<!-- ([a-z ]+): ([^\n]*?) -->\n)?^```(\w*)\n(.*?)^```$", re.M | re.S)
# A table of commands, and a cell that has some.
ROWS = re.compile(r"^<!-- rows: (.*?) -->\n((?:\|.*\n)+)", re.M)
COMMAND_CELL = re.compile(r"\| `((?:netmesh|awk) [^`]*)`")
OPTION = re.compile(r"(?<![\w-])(--?[A-Za-z][\w-]*)")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as f:
        return f.read()


def own_pages():
    names = sorted(os.path.basename(p) for p in glob.glob(os.path.join(ROOT, "tools/docs/*.md")))
    return {path: read(path) for path in ["README.md"] + ["tools/docs/" + name for name in names]}


def other_pages():
    paths = ["CHANGELOG.md", "CONTRIBUTING.md", "engine/ARCHITECTURE.md", "engine/thesis.md", "tests/CHECKS.md",
             "tests/figures/FIGURES.md", "tests/coverage/COVERAGE.md", "platform/python/README.md",
             "platform/wasm/npm/README.md"]
    paths += sorted(os.path.relpath(p, ROOT) for p in glob.glob(os.path.join(ROOT, "engine/decisions/*.md")))
    return {path: read(path) for path in paths}


# ---- commands ------------------------------------------------------------------------------------------------------


def registered_tests():
    """Names of tests, as far as CMake files have them in full, or the macros' last part."""
    text = "".join(read(os.path.relpath(p, ROOT)) for p in glob.glob(os.path.join(ROOT, "tests/*/CMakeLists.txt")))
    names = set(re.findall(r"add_test\(NAME\s+([\w.+-]+)", text))
    return names | {"amalgamation." + name for name in re.findall(r"^add_check\((\w+)", text, re.M)}


class Folder:
    """A fresh folder with the project in it."""

    def __init__(self, path, build):
        self.path = path
        for name in os.listdir(ROOT):
            if not name.startswith((".", "build")):
                os.symlink(os.path.join(ROOT, name), os.path.join(path, name))
        os.symlink(build, os.path.join(path, "build"))
        os.symlink(ROOT, os.path.join(path, "netmesh"))
        self.environment = dict(os.environ, PATH=build + os.pathsep + os.environ["PATH"], LC_ALL="C", NO_COLOR="1")
        self.environment.pop("CI", None)

    def run(self, command):
        done = subprocess.run(command, cwd=self.path, env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done.returncode, done.stdout.decode(errors="replace")


def sessions(text):
    """Commands of a console block, each with the lines that it prints."""
    found = []
    for line in text.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found:
            found[-1][1].append(line)
        else:
            return None
    return found


def same(shown, printed):
    shown, printed = [[line.rstrip() for line in lines] for lines in (shown, printed)]
    return len(shown) == len(printed) and all(
        a == b or a == "time     differs" and b.startswith("time ") for a, b in zip(shown, printed))


def faults_of_commands(pages, build, write=False):
    faults, tests = [], registered_tests()
    for page, text in list(pages.items()):
        counts, elsewhere = {"run": 0, "elsewhere": 0}, ""
        with tempfile.TemporaryDirectory() as path:
            folder = Folder(path, build)
            found = sorted([*BLOCK.finditer(text), *ROWS.finditer(text)], key=lambda match: match.start())
            for block in found:
                if block.re is ROWS:
                    for command in [block.group(1)] + COMMAND_CELL.findall(block.group(2)):
                        counts["run"] += 1
                        status, said = folder.run(["sh", "-ec", command])
                        if status != 0:
                            faults.append("%s: ends with %d:\n%s\n%s" % (page, status, command, said))
                    continue
                says, what, language, body = block.groups()
                place = "%s:%d" % (page, text.count("\n", 0, block.start(3)) + 1)
                if says == "run by":
                    counts["elsewhere"] += 1
                    elsewhere += body
                    if what not in tests:
                        faults.append("%s: there is no test %s" % (place, what))
                elif says == "not run":
                    counts["elsewhere"] += 1
                elif says == "file":
                    with open(os.path.join(path, what), "w", encoding="utf-8") as f:
                        f.write(body)
                elif says == "needs" and not shutil.which(what, path=folder.environment["PATH"]):
                    print("%s: not run, there is no %s" % (place, what))
                elif says not in (None, "needs"):
                    faults.append("%s: what is `%s`?" % (place, says))
                elif language == "sh":
                    counts["run"] += 1
                    status, said = folder.run(["sh", "-ec", body])
                    if status != 0:
                        faults.append("%s: ends with %d:\n%s%s" % (place, status, body, said))
                elif language == "console":
                    lines, now = sessions(body), ""
                    if not lines:
                        faults.append("%s: a console block begins with `$ `" % place)
                    for command, shown in lines or []:
                        counts["run"] += 1
                        status, said = folder.run(["sh", "-c", command])
                        now += "$ %s\n%s" % (command, re.sub(r"^time .*", "time     differs", said, flags=re.M))
                        if status != 0 or not write and not same(shown, said.splitlines()):
                            faults.append("%s: $ %s\nends with %d and prints\n%swhere the page has\n%s" % (
                                place, command, status, said, "\n".join(shown)))
                    if write and now != body:
                        pages[page] = pages[page].replace(body, now)
                elif language == "python":
                    if importlib.util.find_spec("numpy") and os.environ.get("NETMESH_LIBRARY"):
                        counts["run"] += 1
                        status, said = folder.run([sys.executable, "-c", body])
                        if status != 0:
                            faults.append("%s: ends with %d:\n%s" % (place, status, said))
                    else:
                        print("%s: not run, there is no numpy or no library" % place)
                elif language:
                    faults.append("%s: who runs a block of %s?" % (place, language))
                elif re.search(r"^(\$|netmesh) ", body, re.M):
                    faults.append("%s: commands in a block that is not run" % place)
            for target in re.findall(r"!\[[^\]]*\]\(([^)]*)\)", text) + re.findall(r'<img src="([^"]*)"', text):
                made = os.path.join(path, os.path.basename(target))
                shown = os.path.join(ROOT, os.path.dirname(page), target)
                if write and os.path.isfile(made):
                    shutil.copyfile(made, shown)
                if os.path.basename(target) in elsewhere:
                    continue
                if not os.path.isfile(made):
                    faults.append("%s: no command makes the picture %s" % (page, target))
                elif open(made, "rb").read() != open(shown, "rb").read():
                    faults.append("%s: %s is not what the commands make" % (page, target))
        print("%s: %d commands run, %d blocks by other tests or not at all" % (page, counts["run"],
                                                                              counts["elsewhere"]))
    return faults


# ---- links ---------------------------------------------------------------------------------------------------------


def slug(heading):
    return re.sub(r"[^\w\- ]", "", re.sub(r"`|\*", "", heading).lower()).strip().replace(" ", "-")


def anchors_of(text):
    plain = BLOCK.sub("", text)
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", plain)
    return {slug(h) for h in re.findall(r"^#+ (.*)", plain, re.M)}


def faults_of_links(pages):
    faults, count = [], 0
    for page, text in pages.items():
        plain = re.sub(r"`[^`\n]*`", "", BLOCK.sub("", text))
        for target in re.findall(r"\]\(([^)\s]*)\)", plain) + re.findall(r'<img src="([^"]*)"', plain):
            count += 1
            if re.match(r"https?:", target):
                if not re.fullmatch(r"https?://[\w-]+(\.[\w-]+)+(/[\w./~%#?=&+-]*)?", target):
                    faults.append("%s: %s is no address" % (page, target))
                continue
            path, _, anchor = target.partition("#")
            full = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
            if not os.path.isfile(os.path.join(ROOT, full)):
                faults.append("%s: there is no file %s" % (page, target))
            elif anchor and anchor not in anchors_of(pages.get(full) or read(full)):
                faults.append("%s: %s has no heading for #%s" % (page, full, anchor))
    print("%d links of %d pages" % (count, len(pages)))
    return faults


# ---- names ---------------------------------------------------------------------------------------------------------


def said_by(program, *words):
    return subprocess.run([program, *words], check=True, stdout=subprocess.PIPE).stdout.decode()


def commands_of(program):
    listed = said_by(program, "help").split("\nexamples:")[0]
    return [name for name in re.findall(r"^  netmesh ([a-z]+) ", listed, re.M) if name != "help"]


def options_of(program):
    found = {"--version", "-V", "--completion", "--manual"}
    for command in commands_of(program):
        listed = said_by(program, "help", command).split("\noptions:\n")[1]
        for line in re.findall(r"^  (-.*?)(?:  |$)", listed, re.M):
            found |= set(OPTION.findall(line.split(" {")[0]))
    return found


def headers():
    text = {}
    for path in sorted(glob.glob(os.path.join(ROOT, "engine/include/**/*.h"), recursive=True)):
        with open(path, encoding="utf-8") as f:
            text[os.path.basename(path)] = f.read()
    return text


def calls_of(text):
    bare = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return set(re.findall(r"^[\w].*?\b(netmesh_\w+)\(", bare, re.M)) - set(re.findall(r"\(\*(netmesh_\w+)\)", bare))


def spoken_options(text):
    """Options of netmesh in a page: in spans that begin with one or with `netmesh`, and in lines that call it."""
    found = set()
    for block in BLOCK.finditer(text):
        if block.group(3) not in ("sh", "console"):
            continue
        for line in block.group(4).splitlines():
            line = line[2:] if line.startswith("$ ") else line
            for part in re.split(r"\||&&|;|#", line):
                if part.split()[:1] == ["netmesh"]:
                    found |= set(OPTION.findall(re.sub(r"'[^']*'", "", part)))
    plain = BLOCK.sub("", text)
    for span in re.findall(r"`([^`]+)`", plain):
        if span.startswith(("-", "netmesh ")) and not span.startswith(("-D", "-W", "-f", "-O", "-std", "-m")):
            found |= set(OPTION.findall(span))
    return found


def faults_of_names(pages, program):
    faults = []
    options = options_of(program)
    spoken = {page: spoken_options(text) for page, text in pages.items()}
    for page, names in spoken.items():
        faults += ["%s: netmesh has no option %s" % (page, name) for name in sorted(names - options)]
    faults += ["no page has option %s" % name for name in sorted(options - set().union(*spoken.values()))]
    commands = set(commands_of(program)) | {"help"}
    for page, text in pages.items():
        for name in re.findall(r"`netmesh ([a-z]+)", text):
            if name not in commands:
                faults.append("%s: netmesh has no command %s" % (page, name))
    known_text = "\n".join(headers().values())
    calls = set().union(*(calls_of(text) for text in headers().values()))
    listed = set(re.findall(r"`(netmesh_\w+)`", "\n".join(l for l in pages["tools/docs/calls.md"].splitlines()
                                                         if l.startswith("|"))))
    faults += ["tools/docs/calls.md does not have %s" % name for name in sorted(calls - listed)]
    faults += ["tools/docs/calls.md has %s, which is no call" % name for name in sorted(listed - calls)]
    # Names that end in _ stand for all that begin so; X for any.
    for page, text in pages.items():
        for name in set(re.findall(r"\bnetmesh_\w+", text)):
            begin = name[:name.index("X")] if "X" in name else name
            whole = r"\b%s%s" % (re.escape(begin), "" if begin.endswith("_") else r"\b")
            if not re.search(whole, known_text) and "add_executable(%s " % name not in read("tools/CMakeLists.txt"):
                faults.append("%s: there is no %s" % (page, name))
    # A call stands under the header that has it.
    header = None
    for line in pages["tools/docs/calls.md"].splitlines():
        named = re.findall(r"\[(\w+\.h)\]\(", line)
        header = named or header
        if line.startswith("|") and header:
            there = set().union(*(calls_of(headers()[name]) for name in header))
            faults += ["tools/docs/calls.md: %s is not in %s" % (name, ", ".join(header))
                       for name in re.findall(r"`(netmesh_\w+)`", line) if name in calls - there]
    print("%d options, %d calls" % (len(options), len(calls)))
    return faults + faults_of_stacks(pages["tools/docs/small-parts.md"])


def faults_of_stacks(page):
    """What the table of small parts says of stacks is what the header promises, of boards and of 64 bits."""
    wide, narrow = read("engine/include/netmesh/job.h").split("/* figures: stack */")[1].split("#else")
    macro = re.compile(r"BYTES_(\w+)\(dim\) \\\n([^#]*?)NETMESH_STACK_BYTES\(dim\)")
    promised = [{(job, dim): int(size) for job, text in macro.findall(part)
                 for dim, size in re.findall(r"\(dim\) == (\d) \? (\d+)", text)} for part in (narrow, wide)]
    table = page.split("<!-- figures: light -->")[1].split("<!-- end -->")[0]
    rows = re.findall(r"^\| (Delaunay|alpha|certified|Rips)[^|]*\| (\d) \|(.*)\|$", table, re.M)
    macros = {"Rips": "RIPS_SMALL"}  # the table's job is by that filter
    faults = [] if len(rows) >= 15 else ["tools/docs/small-parts.md: the table has %d rows" % len(rows)]
    for job, dim, rest in rows:
        cells = [cell.strip().replace(",", "") for cell in rest.split("|")]
        for bits, said, sizes in ((32, cells[3], promised[0]), (64, cells[7], promised[1])):
            due = sizes.get((macros.get(job, job.upper()), dim))
            if said != str(due):
                faults.append("tools/docs/small-parts.md: %s, D = %s, %d bits: a stack of %s, the header promises %s"
                              % (job, dim, bits, said, due))
    return faults


# ---- schema --------------------------------------------------------------------------------------------------------

# Lines of netmesh, and the exit code; files of a line are there for the next.
RUNS = """0 sample circle -n 40 --noise 0.05 -o circle.csv
0 sample torus -n 60 -o torus.csv
0 sample clifford -n 30 -o clifford.csv
0 sample grid -n 27 -o grid.csv
0 mesh circle.csv -o mesh.node --check --analyse
0 mesh circle.csv --cell-size 0.2,0.1 --domain 2 --audit quality -o sized.node
0 mesh circle.csv --eps 0.5 --audit quality -o fine.node
0 mesh circle.csv --method netmesh --analyse -o cages.node
0 mesh circle.csv --method netmesh --cages thesis --audit quality -o thesis.node
0 mesh circle.csv --method refine --net 0.5 -o refined.node
0 mesh torus.csv --audit location -o torus.node
0 delaunay torus.csv -o torus.off --check --analyse
0 persist circle.csv -o circle.pers
0 persist circle.csv --box -2:2,-2:2 -o periods.pers
0 persist circle.csv
0 persist clifford.csv --top 2
0 persist clifford.csv --weights 4 --squares
0 persist circle.csv --filter complete --bounds
0 persist circle.csv --filter complete --bounds -o bounded.pers --mesh complete.node
0 persist circle.csv --filter complete --method svr --tau 3 --values thesis
0 persist circle.csv --filter complete --ratio 2 --focus 1.5 --from 0.5 --to 1
0 persist circle.csv --focus auto --longer-than 2 --memory 1M
0 persist circle.csv --fit --memory 300K
0 persist circle.csv --fit --memory 300K --from 0.3 --to 1
0 persist circle.csv --filter knn --k 3 --all
0 persist circle.csv --filter tight --eps 0.5
0 persist circle.csv --filter scales --bounds
0 persist circle.csv --filter function --function sqrt(x*x+y*y) --lipschitz 1 --cut 1 --error 0.2 --bounds
0 persist circle.csv --filter function --function sqrt(x*x+y*y) --lipschitz 1 --cut 1 --fit --memory 1M
0 persist circle.csv --filter rips --threshold 0.5
0 persist circle.csv --filter cech --max-degree 0
0 persist circle.csv torus.csv -o {}.json
0 persist distances.txt --distances
0 homology complex.txt
0 homology complex.txt --check
0 distance circle.pers bounded.pers
0 distance circle.pers bounded.pers --log
0 distance circle.pers bounded.pers --wasserstein 2
0 vineyard circle.csv --k 1..3 -o circle.vines
0 vineyard circle.csv --filter barycentric-cech --k 1..2 -o nested.vines
0 vineyard complex.txt --values values.txt
0 check mesh.node --points circle.csv
0 check bounded.pers --points circle.csv
0 check circle.vines --points circle.csv
7 check circle.pers
0 size --dim 3 --points 1000
0 help
0 help persist
0 --version
0 --completion bash
0 --manual mesh
2 persist
2 nonsense
2 persist circle.csv --tau 1
3 persist none.csv
3 persist bad.csv
4 persist circle.csv --filter complete --memory 12K
7 check circle.pers --points torus.csv"""
FILES = {"distances.txt": "0\n1 0\n1.4 1 0\n", "complex.txt": "0 0\n1 0\n2 .5\n0 1 1\n1 2 1\n0 2 2\n0 1 2 3\n",
         "values.txt": "0 0 0 1 1 1 2\n0 0 1 1 2 2 3\n", "bad.csv": "1,2\n3,x\n"}


def faults_of_schema(schema, program):
    import jsonschema
    kind = getattr(jsonschema, "Draft202012Validator", None)
    if kind is None:
        print("SKIPPED: Python's jsonschema does not know JSON Schema 2020-12")
        return []
    kind.check_schema(schema)
    faults, seen, objects = [], set(), 0
    part = lambda name: kind({**schema["$defs"][name], "$defs": schema["$defs"]})

    def look(value, validator, name):
        for error in list(validator.iter_errors(value))[:3]:
            faults.append("%s: %s at %s" % (name, error.message[:300], "/".join(map(str, error.absolute_path))))

    def members(value, at=""):
        if isinstance(value, dict):
            for key, inner in value.items():
                seen.add(at + key)
                members(inner, at + key + ".")

    with tempfile.TemporaryDirectory() as folder:
        for name, text in FILES.items():
            with open(os.path.join(folder, name), "w", encoding="utf-8") as f:
                f.write(text)
        for line in RUNS.splitlines():
            code, line = int(line.split()[0]), line.split(" ", 1)[1]
            words = line.split() + ([] if line.startswith("sample") else ["--json", "-q"] if
                                    line.split()[0] in commands_of(program) else ["--json"])
            done = subprocess.run([program, *words], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            if done.returncode != code:
                faults.append("netmesh %s ends with %d, not %d: %s" % (line, done.returncode, code,
                                                                       done.stderr.decode()))
            text, at = done.stdout.decode(), 0
            if line.startswith("sample"):
                continue
            if not text.strip():
                faults.append("netmesh %s: no JSON" % line)
            while text[at:].strip():
                value, length = json.JSONDecoder().raw_decode(text[at:].lstrip())
                at += len(text[at:]) - len(text[at:].lstrip()) + length
                objects += 1
                which = "failure" if code else "report" if "options" in value else "text"
                look(value, part(which), "netmesh " + line)
                look(value, kind(schema), "netmesh " + line)
                members(value)
        for name in ("circle.json", "torus.json"):
            with open(os.path.join(folder, name), encoding="utf-8") as f:
                look(json.load(f), part("diagram_file"), name)

    # What the schema names and no run has would be a member that does not exist.
    def named(piece, at=""):
        for key, inner in piece.get("properties", {}).items():
            yield at + key
            yield from named(inner, at + key + ".")

    for which in ("report", "failure", "text"):
        faults += ["no run prints %s" % name for name in named(schema["$defs"][which]) if name not in seen]
    print("%d objects, %d members" % (objects, len(seen)))
    return faults


# ---- site ----------------------------------------------------------------------------------------------------------


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.names = [], set()

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and tag in ("a", "img", "link", "script"):
                self.links.append(value)
            if name in ("id", "name"):
                self.names.add(value)


def pages_below(folder):
    pages = {}
    for path in glob.glob(os.path.join(folder, "**/*.html"), recursive=True):
        pages[path] = Page()
        with open(path, encoding="utf-8", errors="replace") as f:
            pages[path].feed(f.read())
    return pages


def faults_of_site(out, program):
    faults, count = [], 0
    pages = pages_below(out)
    reference = os.path.join(out, "c") + os.sep
    for path, page in pages.items():
        if path.startswith(reference):
            continue  # Doxygen's own
        for link in page.links:
            if re.match(r"[a-z]+:", link):
                continue
            count += 1
            to, _, anchor = link.partition("#")
            full = os.path.normpath(os.path.join(os.path.dirname(path), to)) if to else path
            here = os.path.relpath(path, out)
            if not os.path.exists(full):
                faults.append("%s: %s leads nowhere" % (here, link))
            elif anchor and full in pages and anchor not in pages[full].names:
                faults.append("%s: %s has no such heading" % (here, link))
    for name in [""] + commands_of(program):
        manual = os.path.join(out, "man", "man1", "netmesh%s.1" % ("-" + name if name else ""))
        if not os.path.isfile(manual):
            faults.append("there is no manual page of %s" % (name or "netmesh"))
            continue
        with open(manual, encoding="utf-8") as f:
            text = f.read().replace("\\-", "-")
        told = said_by(program, "help", name).split("\noptions:\n")[1] if name else ""
        for line in re.findall(r"^  (-.*?)(?:  |$)", told, re.M):
            if not all("\n\\fB" + o in text or ", " + o in text for o in OPTION.findall(line)):
                faults.append("the manual page of %s has no %s" % (name, line))
        if shutil.which("groff"):
            done = subprocess.run(["groff", "-man", "-ww", "-Tascii", manual], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE)
            if done.returncode or done.stderr:
                faults.append("%s: %s" % (os.path.basename(manual), done.stderr.decode()[:300]))
    if os.path.isdir(reference):
        text = ""
        for path in glob.glob(reference + "*_8h.html"):
            with open(path, encoding="utf-8", errors="replace") as f:
                text += f.read()
        for call in sorted(set().union(*(calls_of(h) for h in headers().values()))):
            if not re.search(r"\b%s\b" % call, text):
                faults.append("the reference has no %s" % call)
    else:
        print("the reference of the C interface is left out: there is no doxygen")
    print("%d pages, %d links" % (len(pages), count))
    return faults


def build_site(out, program):
    done = subprocess.run([sys.executable, os.path.join(ROOT, "tools/docs/build"), out, "--netmesh", program],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(done.stdout.decode()[-2000:])
    return [] if done.returncode == 0 else ["tools/docs/build ends with %d" % done.returncode]


# ---- planted -------------------------------------------------------------------------------------------------------


def planted(build):
    """What has to be found, with a word of what is said then."""
    program = os.path.join(build, "netmesh")
    page, faults = "tools/docs/guide.md", []

    def expect(name, found, words):
        good = any(words in fault for fault in found)
        print("%-5s %s" % ("ok" if good else "FAULT", name))
        if not good:
            faults.append("%s is not found" % name)

    def commands(name, text, words):
        expect(name, faults_of_commands({page: text}, build), words)

    commands("a command that fails", "```sh\nnetmesh persist none.csv\n```\n", "ends with 3")
    commands("another output", "```console\n$ netmesh --version\nnetmesh 0.0.0\n```\n", "where the page has")
    commands("an output that is longer", "```console\n$ echo 1; echo 2\n1\n```\n", "where the page has")
    commands("an exit code that is not shown", "```console\n$ false\n```\n", "ends with 1")
    commands("a test that is not there", "<!-- run by: no.test -->\n```sh\nfalse\n```\n", "there is no test")
    commands("a block that nobody runs", "```js\nf();\n```\n", "who runs")
    commands("commands without a language", "```\nnetmesh mesh a.csv\n```\n", "not run")
    commands("a picture that nothing makes", "![a](plate.svg)\n", "no command makes")
    commands("another picture", "```sh\necho 1 >plate.svg\n```\n![a](plate.svg)\n", "is not what the commands make")

    expect("a file that is gone", faults_of_links({page: "[a](none.md)"}), "there is no file")
    expect("a heading that is gone", faults_of_links({page: "[a](formats.md#none)"}), "has no heading")
    expect("an address that is none", faults_of_links({page: "[a](https://)"}), "is no address")

    pages = own_pages()
    change = lambda path, old, new: {**pages, path: pages[path].replace(old, new)}
    expect("an option that does not exist", faults_of_names(change(page, "`--axis`", "`--axes`"), program),
           "no option --axes")
    expect("an option that is not told", faults_of_names({p: t.replace("--longer-than", "") for p, t in pages.items()},
                                                         program), "no page has option --longer-than")
    expect("a command that does not exist", faults_of_names({**pages, page: pages[page] + "`netmesh frob`"}, program),
           "no command frob")
    calls = "tools/docs/calls.md"
    expect("a call that is not told", faults_of_names(change(calls, "`netmesh_adopt`", ""), program),
           "does not have netmesh_adopt")
    expect("a call that does not exist", faults_of_names(change(calls, "netmesh_adopt", "netmesh_adapt"), program),
           "no call")
    expect("a call under another header", faults_of_names(
        change(calls, "| `netmesh_get_report` |", "| `netmesh_get_report`, `netmesh_mesh` |"), program), "is not in")
    parts = "tools/docs/small-parts.md"
    expect("a stack that was promised once", faults_of_stacks(re.sub(r"3,584", "2,848", pages[parts])), "promises 3584")
    expect("a name that does not exist", faults_of_names({**pages, page: pages[page] + " netmesh_none "}, program),
           "there is no netmesh_none")

    if importlib.util.find_spec("jsonschema"):
        schema = json.loads(read("tools/docs/schema.json"))
        without = json.loads(json.dumps(schema))
        del without["$defs"]["report"]["properties"]["mesh"]["properties"]["vertices"]
        expect("a member that the schema lacks", faults_of_schema(without, program), "vertices")
        more = json.loads(json.dumps(schema))
        more["$defs"]["report"]["properties"]["none"] = {"type": "null"}
        expect("a member that nothing prints", faults_of_schema(more, program), "no run prints none")
        other = json.loads(json.dumps(schema))
        other["$defs"]["report"]["properties"]["fingerprint"] = {"type": "integer"}
        expect("a member of another kind", faults_of_schema(other, program), "fingerprint")

    with tempfile.TemporaryDirectory() as out:
        with open(os.path.join(out, "index.html"), "w", encoding="utf-8") as f:
            f.write('<a href="none.html">a</a><a href="#none">b</a>')
        found = faults_of_site(out, program)
        expect("a page that is gone", found, "none.html leads nowhere")
        expect("a heading of the site that is gone", found, "#none has no such heading")
        expect("a manual page that is gone", found, "no manual page of persist")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["commands", "write", "links", "names", "schema", "site", "planted"])
    parser.add_argument("build", nargs="?", default=os.path.join(ROOT, "build"))
    options = parser.parse_args()
    build = os.path.abspath(options.build)
    program = os.path.join(build, "netmesh")
    for what, module in (("schema", "jsonschema"), ("site", "markdown")):
        if options.what == what and not importlib.util.find_spec(module):
            print("SKIPPED: Python has no " + module)
            return 0
    if options.what == "commands":
        faults = faults_of_commands(own_pages(), build)
    elif options.what == "write":
        pages = own_pages()
        faults = faults_of_commands(pages, build, True)
        for page, text in pages.items():
            if text != read(page):
                with open(os.path.join(ROOT, page), "w", encoding="utf-8") as f:
                    f.write(text)
    elif options.what == "links":
        faults = faults_of_links({**own_pages(), **other_pages()})
    elif options.what == "names":
        faults = faults_of_names(own_pages(), program)
    elif options.what == "schema":
        faults = faults_of_schema(json.loads(read("tools/docs/schema.json")), program)
    elif options.what == "site":
        with tempfile.TemporaryDirectory() as out:
            faults = build_site(out, program) or faults_of_site(out, program)
    else:
        faults = planted(build)
    for fault in faults:
        print("FAULT " + fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
