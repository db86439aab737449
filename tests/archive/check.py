#!/usr/bin/env python3
"""Checks on what the build made and on who includes whom. Each prints what it found and exits 1 on a fault.

  check.py archive  --archive libnetmesh.a [--plain]     symbols, data, instructions of the archive
  check.py includes --engine engine                      headers by allow-list, folders by layer
  check.py stack    --records DIR [--objects FILE] [--bytes N] [--bytes-low-dim N] [--recursion-only]
                                                         worst call chain of every public function
  check.py jobs     --records DIR [--objects FILE] --include DIR [--dims 2,3] [--cc COMMAND] [--nm NAME]
                                                         worst call chain of every documented job, and the bytes that
                                                         netmesh/job.h promises for it
  check.py size     --records DIR [--objects FILE] [--bytes N]
                                                         code and constants by folder and dimension

--objects: a list of the objects that count, one a line; without, all below DIR, those of sources that have left a
           build folder, too.
--plain: inner symbols may be global (an archive that could not be finished).
--tables: it was compiled without the engine's flags; tables for unwinding may be there.
--helpers: the target has no unit for doubles or 64-bit division; the compiler's own routines may be called.
--source:  netmesh.cpp of tools/amalgamate, when that was compiled: its comments say what stands in which file.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile

PUBLIC = "netmesh_"
UNDEFINED_ALLOWED = {"memcpy", "memmove", "memset", "memcmp"}
HELPERS = re.compile(r"__aeabi_\w+$|__c[lt]z[sd]i2$|__gnu_thumb1_case_\w+$"
                     r"|__(add|sub|mul|div|neg|fix|fixuns|float|floatun|floatuns|extend|trunc|eq|ne|lt|le|gt"
                     r"|ge|cmp|unord)[dst][ifd]\w*$")


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout


def records_below(folder, endings, objects):
    """Paths of the files with these endings, in order; with a list of objects theirs alone."""
    counted = None
    if objects:
        with open(objects, encoding="utf-8") as f:
            counted = {os.path.splitext(os.path.realpath(line.strip()))[0] for line in f if line.strip()}
    for base, _, names in sorted(os.walk(folder)):
        for name in sorted(names):
            stem, ending = os.path.splitext(os.path.join(base, name))
            if ending in endings and (counted is None or os.path.realpath(stem) in counted):
                yield stem + ending


# ---------------------------------------------------------------------------------------------------- the archive


def undefined_symbols(archive, tools):
    """Names that the archive wants from outside and does not define itself."""
    wanted, defined = set(), set()
    for line in run(tools.nm, "-P", archive).splitlines():
        field = line.split()
        if len(field) < 2 or line.endswith(":"):
            continue
        (wanted if field[1] in "Uwv" else defined).add(field[0])
    # The compiler's mark for position-independent code, made by the linker itself.
    names = wanted - defined - UNDEFINED_ALLOWED - {"_GLOBAL_OFFSET_TABLE_"}
    return sorted(n for n in names if not (tools.helpers and HELPERS.match(n)))


def global_symbols(archive, tools):
    names = set()
    for line in run(tools.nm, "-P", "-g", "--defined-only", archive).splitlines():
        field = line.split()
        if len(field) >= 2 and not field[0].startswith(PUBLIC):
            names.add(field[0])
    return sorted(names)


SECTION = re.compile(r"\[ *\d+\] (\S+) +(\S+) +[0-9a-f]+ [0-9a-f]+ ([0-9a-f]+) [0-9a-f]+ +([A-Za-z]*) ")
SECTIONS_ALLOWED = re.compile(r"\.(text|rodata|data\.rel\.ro|rela?|debug|comment|note|symtab|strtab|shstrtab|group"
                              r"|llvm_addrsig|ARM\.(attributes|exidx|extab)|riscv\.attributes)(\.|_|$)")


def sections(archive, tools):
    """Name, bytes and flags of each section that is not empty."""
    for line in run(tools.readelf, "-SW", archive).splitlines():
        m = SECTION.search(line)
        if m and int(m.group(3), 16) > 0:
            yield m.group(1), int(m.group(3), 16), m.group(4)


def mutable_sections(archive, tools):
    """Sections that are writable at run time and not empty. Constants with relocations (.data.rel.ro) are not: the
    loader protects them once they are filled in."""
    return ["%s (%d bytes)" % (name, size) for name, size, flags in sections(archive, tools)
            if "W" in flags and "A" in flags and not name.startswith(".data.rel.ro")]


def unknown_sections(archive, tools):
    """Sections of a kind that a linker script need not know: code that runs by itself, tables for unwinding, placement
    by attribute; and the mark that asks for an executable stack."""
    tables = {".eh_frame", ".rela.eh_frame", ".rel.eh_frame"} if tools.tables else set()
    found = [name for name, _, flags in sections(archive, tools)
             if not SECTIONS_ALLOWED.match(name) and name not in tables and not ("W" in flags and "A" in flags)]
    for line in run(tools.readelf, "-SW", archive).splitlines():
        m = SECTION.search(line)
        if m and m.group(1) == ".note.GNU-stack" and "X" in m.group(4):
            found.append("executable stack")
    return sorted(set(found))


# Fused multiply-add of x86 and of Arm; x87 on x86-64, where nothing but long double brings it in.
FUSED = re.compile(r"\t(vf[n]?m(?:add|sub|addsub|subadd)\w*|f[n]?m(?:add|sub)|fml[as]|vfm[as]|vfnm[as])\b")
X87 = re.compile(r"\t(f(?:ld|ild|st|ist|add|iadd|mul|imul|sub|isub|div|idiv|sqrt|xch|chs|abs|com|ucom)\w*)\b")


def forbidden_instructions(archive, tools):
    # Linked first, with no entry: in an object every function may begin at 0, and objdump then looks through all of
    # them for each operand that it prints, which takes minutes.
    with tempfile.TemporaryDirectory() as folder:
        linked = os.path.join(folder, "linked")
        run(tools.ld, "-e", "0", "--unresolved-symbols=ignore-all", "-o", linked, "--whole-archive", archive)
        text = run(tools.objdump, "-d", "--no-show-raw-insn", linked)
    patterns = [FUSED, X87] if "x86-64" in text else [FUSED]
    function, found, lines = "?", {}, 0
    for line in text.splitlines():
        if line.endswith(">:"):
            function = line[line.index("<") + 1:-2]
            continue
        lines += 1
        for pattern in patterns:
            m = pattern.search(line)
            if m:
                found.setdefault(function, set()).add(m.group(1))
    if lines == 0:
        return ["nothing was disassembled"]
    return ["%s in %s" % (" ".join(sorted(v)), k) for k, v in sorted(found.items())]


def check_archive(tools):
    parts = [("undefined symbols beyond " + " ".join(sorted(UNDEFINED_ALLOWED)), undefined_symbols),
             ("mutable data", mutable_sections), ("sections of an unexpected kind", unknown_sections),
             ("fused or x87 instructions", forbidden_instructions)]
    if not tools.plain:
        parts.append(("global symbols that are not " + PUBLIC + "*", global_symbols))
    public = [s for s in run(tools.nm, "-P", "-g", "--defined-only", tools.archive).split("\n") if s.startswith(PUBLIC)]
    print("%s: %d public symbols" % (tools.archive, len(public)))
    if not public:
        print("FAULT no public symbol at all")
    faults = 0 if public else 1
    for title, part in parts:
        found = part(tools.archive, tools)
        print("%-5s %s: %s" % ("FAULT" if found else "ok", title, ", ".join(found) if found else "none"))
        faults += len(found)
    return faults


# ------------------------------------------------------------------------------------------------------- includes

SYSTEM_ALLOWED = {"cstddef", "cstdint", "type_traits", "utility"}
SYSTEM_PUBLIC = {"stddef.h", "stdint.h"}
# A folder sees its own files, the files of these folders and single files named here. A folder inside another has an
# entry of its own; what is not in one of them stands above them all.
BASE = {"vocabulary", "memory", "numerics"}
DELAUNAY = BASE | {"include", "predicates", "complex/triangulation.hpp"}
MESH = DELAUNAY | {"delaunay", "certificate", "complex"}
DOMAIN = {"mesh/domain.hpp", "mesh/any_domain.hpp", "mesh/input_tree.hpp"}
HOMOLOGY = BASE | {"include", "complex"}
SEES = {
    "include": set(),
    "vocabulary": {"include"},
    "memory": {"vocabulary"},
    "numerics": {"vocabulary", "memory"},
    "predicates": BASE,
    "geometry": BASE | {"predicates"},
    "delaunay": DELAUNAY,
    "certificate": DELAUNAY | {"delaunay"},
    "mesh": MESH | {"mesh/clip", "mesh/cages", "mesh/check", "mesh/audit", "mesh/loop"},
    "mesh/clip": MESH | DOMAIN,
    "mesh/cages": MESH | DOMAIN | {"mesh/clip"},
    "mesh/check": MESH | DOMAIN | {"mesh/clip", "mesh/cages"},
    "mesh/audit": MESH | DOMAIN | {"mesh/clip", "mesh/cages", "mesh/mesh_request.hpp"},
    "mesh/loop": MESH | {"mesh"},
    "laboratory": MESH | {"mesh"},
    "complex": BASE,
    "homology": HOMOLOGY | {"diagram/pair.hpp"},
    "diagram": HOMOLOGY | {"homology"},
    "filtration": MESH | {"geometry", "mesh", "homology/rips/rips.hpp", "homology/rank.hpp"},
    "pieces": DELAUNAY | HOMOLOGY | {"delaunay", "complex", "filtration", "homology", "diagram"},
    "periods": DELAUNAY | {"delaunay", "complex"},
    "jobs": MESH | HOMOLOGY | {"mesh", "filtration", "homology", "diagram", "periods"},
    "api": MESH | HOMOLOGY | {"mesh", "filtration", "homology", "diagram", "laboratory", "jobs", "pieces"},
}
INCLUDE = re.compile(r"^[ \t]*#[ \t]*(?:include|include_next|import)\b[ \t]*(.*)", re.M)


def room_of(path):
    parts = path.split(os.sep)
    inner = "/".join(parts[:2])
    return inner if len(parts) > 2 and inner in SEES else parts[0]


def check_includes(engine):
    faults, files = [], 0
    for folder, _, names in sorted(os.walk(engine)):
        for name in sorted(names):
            if not name.endswith((".hpp", ".cpp", ".h", ".c", ".inc")):
                continue
            path = os.path.relpath(os.path.join(folder, name), engine)
            room = room_of(path)
            files += 1
            if room not in SEES:
                faults.append("%s: no such folder" % path)
                continue
            system = SYSTEM_PUBLIC if path.startswith("include") and name.endswith(".h") else SYSTEM_ALLOWED
            with open(os.path.join(folder, name), encoding="utf-8") as f:
                text = f.read()
            for m in INCLUDE.finditer(text):
                what = m.group(1).strip()
                where = "%s:%d" % (path, text.count("\n", 0, m.start()) + 1)
                if what.startswith("<"):
                    if what[1:what.find(">")] not in system:
                        faults.append("%s: %s is not on the allow-list" % (where, what))
                    continue
                if not what.startswith('"'):
                    faults.append("%s: include by macro" % where)
                    continue
                target = what[1:what.find('"', 1)]
                for base in (folder, engine, os.path.join(engine, "include")):
                    full = os.path.normpath(os.path.join(base, target))
                    if os.path.isfile(full):
                        break
                else:
                    faults.append('%s: "%s" is not a file of the engine' % (where, target))
                    continue
                seen = os.path.relpath(full, engine)
                if seen.endswith((".cpp", ".c")):
                    faults.append("%s: %s is a source, not a header" % (where, seen))
                    continue
                names_of = {room_of(seen), seen.split(os.sep)[0], seen.replace(os.sep, "/")}
                if room_of(seen) != room and not names_of & SEES[room]:
                    faults.append("%s: %s does not see %s" % (where, room, seen))
    print("%d files" % files)
    for fault in faults:
        print("FAULT " + fault)
    if files == 0:
        print("FAULT no files under %s" % engine)
        return 1
    if not faults:
        print("ok    headers on the allow-list, folders include only their own or lower layers")
    return len(faults)


# ---------------------------------------------------------------------------------------------------------- stack

NODE = re.compile(r'^node: \{ title: "([^"]*)" label: "([^"]*)"(.*)\}')
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"(?: label: "([^"]*)")?')
OUTSIDE_BYTES = 128   # what memcpy and its like may take, with their return address
RED_ZONE_BYTES = 128  # used below the frame by functions that call nothing; the compiler's figure leaves it out
ASSEMBLY = {"netmesh_switch_stack", "netmesh_enter_stack"}  # memory/stack_switch.cpp; they stay below OUTSIDE_BYTES
INDIRECT = "__indirect_call"
# The poll and the caller's functions: their stack is the caller's affair.
INDIRECT_ALLOWED = ("vocabulary/monitor.cpp", "vocabulary/callback.hpp", "mesh/sizing.hpp")
# Calls through the constant objects of api/objects.hpp and of filtration/filters.hpp, by what stands in the line: the
# objects that it may be, and which of their functions.
DISPATCH = [(re.compile(r"\bfilter\.run\("), re.compile(r"netmesh_filter_\w+$"), 0),
            (re.compile(r"\bfilter\.settle\("), re.compile(r"netmesh_filter_\w+$"), 1),
            (re.compile(r"\bmethod\.mesh\("), re.compile(r"netmesh_method_\w+$"), 0),
            (re.compile(r"\bmethod\.settle\("), re.compile(r"netmesh_method_\w+$"), 1),
            (re.compile(r"\bweighting\.run\("), re.compile(r"netmesh_(radii|weights)$"), 1),
            (re.compile(r"\bweighting\.mesh\("), re.compile(r"netmesh_(radii|weights)$"), 2),
            (re.compile(r"\bweighting\.settle\("), re.compile(r"netmesh_(radii|weights)$"), 0),
            (re.compile(r"\bperiods\.settle\("), re.compile(r"netmesh_periodic$"), 0),
            (re.compile(r"\bperiods\.run\("), re.compile(r"netmesh_periodic$"), 1),
            (re.compile(r"\bwant\.settle\("), re.compile(r"netmesh_(vines|fit)$"), 1),
            (re.compile(r"\bwant\.run\("), re.compile(r"netmesh_(bounds|cycles|vines|fit)$"), 0),
            (re.compile(r"\bbounds\.run\("), re.compile(r"netmesh_bounds$"), 0),
            (re.compile(r"\bon_mesh->evaluate\("), re.compile(r"_ZN7netmesh\d+\w+_on_meshE$"), 0)]
OBJECT_SECTION = re.compile(
    r"'\.rela?\.(?:data\.rel\.ro|rodata)(?:\.local)?\.(netmesh_\w+|_ZN7netmesh\d+\w+_on_meshE)'")
POLL, PAUSE = "vocabulary/monitor.cpp", "netmesh_poll_pause"


class Parts:
    """Which source stands where in netmesh.cpp."""

    def __init__(self, source):
        self.begins = []
        with open(source, encoding="utf-8") as f:
            for number, line in enumerate(f, 1):
                m = re.match(r"/\* ---- engine/(\S+) ---- \*/", line)
                if m:
                    self.begins.append((number, m.group(1)))

    def of(self, place):
        """The source of netmesh.cpp:line:column; a place in another file stays what it is."""
        m = re.match(r"(?:.*/)?netmesh\.cpp:(\d+):", place)
        names = [name for begin, name in self.begins if begin <= int(m.group(1))] if m else []
        return names[-1] if names else place


class Graph:
    def __init__(self, parts=None, base="."):
        self.base = base  # of relative paths in the records: where the compiler ran
        self.frame, self.label, self.calls, self.faults, self.files = {}, {}, {}, [], 0
        self.dispatch, self.objects, self.lines = {}, {}, {}  # caller: rows of DISPATCH; object: its functions
        self.parts, self.polls, self.aliases = parts, set(), {}  # polls: the functions that call the poll

    def read(self, records, objects):
        """All .ci files below a folder. A template instantiated in several files counts with its largest frame."""
        for path in records_below(records, {".ci"}, objects):
            self.files += 1
            with open(path, encoding="utf-8") as f:
                for line in f:
                    self.read_line(line)

    def read_line(self, line):
        m = NODE.match(line)
        if m:
            title, label, rest = m.groups()
            if "shape" in rest:  # declared here, defined elsewhere
                return
            size = re.search(r"(\d+) bytes \(([a-z,]+)\)", label)
            if not size:
                self.faults.append("no frame size for %s" % title)
                return
            self.frame[title] = max(self.frame.get(title, 0), int(size.group(1)))
            self.label[title] = label.split("\\n")[0]
            self.calls.setdefault(title, set())
            # "dynamic,bounded": arguments pushed around a call; the figure is the most that it gets.
            if size.group(2) not in ("static", "dynamic,bounded"):
                self.faults.append("frame of %s is %s" % (self.label[title], size.group(2)))
            return
        m = EDGE.match(line)
        if m:
            caller, callee, where = m.groups()
            if callee == INDIRECT:
                file = self.parts.of(where or "") if self.parts else where or ""
                if POLL in file:
                    self.polls.add(caller)
                if any(allowed in file for allowed in INDIRECT_ALLOWED):
                    return
                rows = [row for row in DISPATCH if row[0].search(self.text_at(where or ""))]
                if rows:
                    self.dispatch.setdefault(caller, []).extend(rows)
                else:
                    self.faults.append("indirect call in %s at %s" % (self.label.get(caller, caller), where))
                return
            self.calls.setdefault(caller, set()).add(callee)

    def text_at(self, place):
        """The line of file:line:column; empty where there is no such file."""
        m = re.match(r"(.*):(\d+):\d+$", place)
        if not m:
            return ""
        path = m.group(1) if os.path.isabs(m.group(1)) else os.path.join(self.base, m.group(1))
        if path not in self.lines:
            self.lines[path] = []
            if os.path.exists(path):
                with open(path, encoding="utf-8") as f:
                    self.lines[path] = f.read().split("\n")
        number = int(m.group(2))
        return self.lines[path][number - 1] if number <= len(self.lines[path]) else ""

    def know_objects(self, paths, readelf):
        """The functions that constant objects name, in their order."""
        for path in paths:
            name = None
            for line in run(readelf, "-rW", path).splitlines():
                if line.startswith("Relocation section"):
                    m = OBJECT_SECTION.search(line)
                    name = m.group(1) if m else None
                    continue
                m = re.match(r"[0-9a-f]+ +[0-9a-f]+ +R_\S+ +[0-9a-f]+ +(\S+)", line.strip())
                if name is None or not m:
                    continue
                symbol = m.group(1)
                symbol = symbol[len(".text."):] if symbol.startswith(".text.") else symbol
                symbol = re.sub(r"^(unlikely|hot|startup)\.", "", symbol)
                if not re.match(r"netmesh_(filter|method)_|_ZN7netmesh\d+\w+_on_meshE", symbol):
                    self.objects.setdefault(name, []).append(symbol)

    def with_objects(self, chosen):
        """The same graph where calls through objects lead to those of them whose name is chosen."""
        graph = Graph()
        graph.frame, graph.label, graph.polls = self.frame, self.label, self.polls
        graph.calls = {t: set(s) for t, s in self.calls.items()}
        for caller, rows in self.dispatch.items():
            for _, which, place in rows:
                for name, functions in self.objects.items():
                    if which.match(name) and (chosen is None or chosen.search(name)) and place < len(functions):
                        graph.calls.setdefault(caller, set()).add(functions[place])
        graph.aliases = self.aliases
        graph.link()
        return graph

    def know_aliases(self, paths, readelf):
        """The compiler folds functions of equal code: one has a record, the others are names of the same place."""
        of_symbol = {title.rsplit(":", 1)[-1]: title for title in self.frame}
        for path in paths:
            places = {}
            for line in run(readelf, "-sW", path).splitlines():
                field = line.split()
                if len(field) == 8 and field[3] == "FUNC" and field[6] != "UND":
                    places.setdefault((field[6], field[1]), []).append(field[7])
            for names in places.values():
                recorded = [of_symbol[n] for n in names if n in of_symbol]
                for name in names:
                    if recorded and name not in of_symbol:
                        self.aliases[name] = recorded[0]

    def link(self):
        """Calls across files name the bare symbol; an instantiation's own record has its file in front."""
        definitions = dict(self.aliases)
        for title in self.frame:
            symbol = title.rsplit(":", 1)[-1]
            if symbol not in definitions or self.frame[title] > self.frame[definitions[symbol]]:
                definitions[symbol] = title
        def home(symbol):
            # Constructors and destructors of whole objects (C1, D1) are mostly other names of those of base objects.
            if symbol in self.frame:
                return symbol
            symbol = symbol if symbol in definitions else self.aliases.get(symbol.rsplit(":", 1)[-1], symbol)
            if symbol in self.frame:
                return symbol
            of_base = symbol.replace("C1E", "C2E").replace("C1I", "C2I").replace("D1E", "D2E")  # I: a template
            return of_base if of_base in self.frame else definitions.get(symbol, definitions.get(of_base, symbol))

        for caller, callees in self.calls.items():
            self.calls[caller] = {home(c) for c in callees}

    def cycles(self):
        """Strongly connected sets of more than one function, or functions that call themselves (Tarjan, iterative)."""
        index, low, on, stack, found, count = {}, {}, set(), [], [], 0
        for root in sorted(self.frame):
            if root in index:
                continue
            work = [(root, iter(sorted(self.calls[root])))]
            index[root] = low[root] = count = count + 1
            stack.append(root)
            on.add(root)
            while work:
                node, rest = work[-1]
                for callee in rest:
                    if callee not in self.frame:
                        continue
                    if callee not in index:
                        index[callee] = low[callee] = count = count + 1
                        stack.append(callee)
                        on.add(callee)
                        work.append((callee, iter(sorted(self.calls[callee]))))
                        break
                    if callee in on:
                        low[node] = min(low[node], index[callee])
                else:
                    work.pop()
                    if work:
                        low[work[-1][0]] = min(low[work[-1][0]], low[node])
                    if low[node] == index[node]:
                        part = []
                        while True:
                            top = stack.pop()
                            on.discard(top)
                            part.append(top)
                            if top == node:
                                break
                        if len(part) > 1 or node in self.calls[node]:
                            found.append(part)
        return found

    def pausing(self):
        """The same graph where each poll pauses its job."""
        graph = Graph()
        graph.frame, graph.label = self.frame, self.label
        graph.calls = {t: s | {PAUSE} if t in self.polls else s for t, s in self.calls.items()}
        return graph

    def worst(self, root, dim=None):
        """Bytes of the deepest chain from root, and the chain. With dim, instantiations for other dimensions are left
        out. Only for graphs without cycles."""
        memo, work = {}, [root]
        while work:
            node = work[-1]
            if node in memo:
                work.pop()
                continue
            callees = [c for c in sorted(self.calls.get(node, ())) if dim is None or dimension_of(c) in (None, dim)]
            todo = [c for c in callees if c not in memo and c in self.frame]
            if todo:
                work.extend(todo)
                continue
            best, through = (0, None) if callees else (RED_ZONE_BYTES, None)
            for c in callees:
                bytes_c = memo[c][0] if c in self.frame else OUTSIDE_BYTES
                if bytes_c > best:
                    best, through = bytes_c, c
            memo[node] = (self.frame[node] + best, through)
            work.pop()
        chain, node = [], root
        while node is not None and node in self.frame:
            chain.append(node)
            node = memo[node][1]
        return memo[root][0], chain


def dimension_of(title):
    """D of an instantiation on a dimension: the first template argument, an int of 2..6."""
    m = re.search(r"ILi([2-6])E", title)
    return int(m.group(1)) if m else None


def graph_of(options):
    # CMake's records stand two folders below where the compiler ran, those of one source in its own.
    base = os.path.dirname(options.source) if options.source else os.path.join(options.records, "..", "..")
    graph = Graph(Parts(options.source) if options.source else None, base)
    graph.read(options.records, options.objects)
    if options.source:
        graph.know_aliases(records_below(options.records, {".o"}, options.objects), options.readelf)
    if not graph.frame:
        sys.exit("FAULT no call graphs (.ci) under %s" % options.records)
    graph.know_objects(records_below(options.records, {".o", ".obj"}, options.objects), options.readelf)
    if graph.dispatch and not graph.objects:
        sys.exit("FAULT calls through objects, and no objects under %s" % options.records)
    return graph


def unseen(graph, helpers):
    """What is called and not in the graph, though its stack counts."""
    outside = set(c for s in graph.calls.values() for c in s if c not in graph.frame)
    return outside, sorted(c for c in outside - UNDEFINED_ALLOWED - ASSEMBLY if not (helpers and HELPERS.match(c)))


def check_stack(options):
    limit, limit_low, recursion_only = options.bytes, options.bytes_low_dim, options.recursion_only
    read = graph_of(options)
    faults = sorted(set(read.faults))
    graph = read.with_objects(None)
    graph.files = read.files
    cycles = graph.cycles()
    for part in cycles:
        faults.append("recursion: " + ", ".join(graph.label[t] for t in sorted(part)))
    roots = sorted(t for t in graph.frame if t.startswith(PUBLIC))
    print("%d functions in %d files, %d of them public" % (len(graph.frame), graph.files, len(roots)))
    if not roots:
        faults.append("no public function")
    if not cycles and not recursion_only:
        deepest, deepest_chain = 0, []
        print("%-28s %8s   %s" % ("worst chain, bytes", "any D", "  ".join("D = %d " % d for d in range(2, 7))))
        for root in roots:
            total, chain = graph.worst(root)
            by_dim = {d: graph.worst(root, d)[0] for d in range(2, 7)}
            print("%-28s %8d   %s" % (root, total, "  ".join("%6d" % by_dim[d] for d in range(2, 7))))
            if total > limit:
                faults.append("%s needs %d bytes of stack, %d are the limit" % (root, total, limit))
            for d in (2, 3, 4):
                if by_dim[d] > limit_low:
                    faults.append("%s needs %d bytes of stack at D = %d, %d are the limit" %
                                  (root, by_dim[d], d, limit_low))
            if total > deepest:
                deepest, deepest_chain = total, chain
        print("the deepest:")
        for node in deepest_chain:
            print("  %6d  %s" % (graph.frame[node], graph.label[node]))
        outside, unknown = unseen(graph, options.helpers)
        print("called but not seen: " + " ".join(sorted(outside)))
        faults += ["%s is called but not seen" % c for c in unknown]
    for fault in faults:
        print("FAULT " + fault)
    if not faults:
        print("ok    no recursion, no dynamic frame, no indirect call but the caller's functions" +
              ("" if recursion_only else "; at most %d bytes, %d for D <= 4" % (limit, limit_low)))
    return len(faults)


# ----------------------------------------------------------------------------------------------------------- jobs

# The calls of a job for which netmesh/job.h has a figure, NETMESH_STACK_BYTES_<JOB>(dim), and the objects that its
# requests name.
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../engine/api/on_meshes.cpp"),
          encoding="utf-8") as listed:
    ON_MESH = r"_on_meshE$|netmesh_filter_(%s)$|netmesh_method_" % "|".join(
        re.findall(r"^    FILTER\((\w+), ", listed.read(), re.M))
JOBS = {
    "DELAUNAY": (["netmesh_mesh"], r"netmesh_method_delaunay(_small)?$"),
    "ALPHA": (["netmesh_persist"], r"netmesh_filter_alpha(_small)?$"),
    "CERTIFIED": (["netmesh_mesh", "netmesh_persist"], ON_MESH),
    "RIPS": (["netmesh_persist"], r"netmesh_filter_(rips|cech)$"),
    "RIPS_SMALL": (["netmesh_persist"], r"netmesh_filter_rips_small$"),
}
# What comes with each of them.
EVERY_JOB = re.compile(r"netmesh_(init|plan|plan_\w+|settle|get_\w+|status_text)$")
JOB_ENTRY = re.compile(r"void .*\brun_job\(void\*\)$")
JOB_RECORD_BYTES = 192  # of netmesh_job, its guard and its alignment (api/job.cpp)


def stack_of_jobs(graph, dims):
    """{(job, dim): (bytes, bytes in slices beside the job's record, the deepest chain of calls)}."""
    entry = [t for t in graph.frame if JOB_ENTRY.match(graph.label[t])]
    slices = bool(entry)  # a processor on which stacks are not switched has none
    if slices and (len(entry) != 1 or PAUSE not in graph.frame or not graph.polls):
        sys.exit("FAULT jobs in slices: %d entries, %d polls" % (len(entry), len(graph.polls)))
    found = {}
    for job, (calls, objects) in JOBS.items():
        limited = graph.with_objects(re.compile(objects))
        pausing = limited.pausing()
        roots = [t for t in graph.frame if t in calls or EVERY_JOB.match(t)]
        if not set(calls) <= set(roots):
            sys.exit("FAULT not in the archive: %s" % " ".join(sorted(set(calls) - set(roots))))
        for dim in dims:
            plain, chain = max((limited.worst(t, dim) for t in roots), key=lambda found: found[0])
            sliced = max(pausing.worst(t, dim)[0] for t in roots) + graph.frame[entry[0]] if slices else 0
            found[job, dim] = plain, sliced, chain
    return found


def promised(options, dims):
    """{(job, dim): bytes} of the header, and NETMESH_STACK_BYTES_JOB, as its compiler has them."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = os.path.join(folder, "promised.c"), os.path.join(folder, "promised.o")
        with open(source, "w", encoding="utf-8") as f:
            f.write('#include "netmesh.h"\nchar JOB_0[NETMESH_STACK_BYTES_JOB] = {1};\n')
            f.writelines("char %s_%d[NETMESH_STACK_BYTES_%s(%d)] = {1};\n" % (job, dim, job, dim)
                         for job in JOBS for dim in dims)
        run(*options.cc.split(), "-I", options.include, "-c", source, "-o", out)
        fields = [line.split() for line in run(options.nm, "-P", "-S", out).splitlines()]
    sizes = {tuple(f[0].rsplit("_", 1)): int(f[3], 16) for f in fields if len(f) == 4}
    return {(job, int(dim)): size for (job, dim), size in sizes.items()}


def check_jobs(options):
    graph = graph_of(options)
    dims = [int(d) for d in options.dims.split(",")]
    cycles = graph.with_objects(None).cycles()
    faults = sorted(set(graph.faults)) + ["recursion: " + ", ".join(graph.label.get(f, f) for f in c) for c in cycles]
    if faults:
        print("FAULT " + "\nFAULT ".join(faults))
        return len(faults)
    faults = ["%s is called but not seen" % c for c in unseen(graph.with_objects(None), options.helpers)[1]]
    if not re.search(r"x86_64|AMD64|i.86", options.processor):
        global RED_ZONE_BYTES
        RED_ZONE_BYTES = 0
    promise = {key: size * options.percent // 100 for key, size in promised(options, dims).items()}
    for job, dim in list(promise):
        if options.promise_of and dim in dims:
            promise[job, dim] = promise[job, options.promise_of]
    print("%-10s %s %10s %10s %10s" % ("job", "D", "bytes", "in slices", "promised"))
    for (job, dim), (plain, sliced, chain) in stack_of_jobs(graph, dims).items():
        print("%-10s %d %10d %10d %10d" % (job, dim, plain, sliced, promise[job, dim]))
        if max(plain, sliced + JOB_RECORD_BYTES - promise["JOB", 0]) > promise[job, dim]:
            print("".join("    %6d  %s\n" % (graph.frame[node], graph.label[node]) for node in chain), end="")
        if plain > promise[job, dim]:
            faults.append("%s in dimension %d takes %d bytes of stack, netmesh/job.h promises %d" %
                          (job, dim, plain, promise[job, dim]))
        if sliced + JOB_RECORD_BYTES > promise[job, dim] + promise["JOB", 0]:
            faults.append("%s in dimension %d takes %d bytes of a job's stack beside its record, %d promised" %
                          (job, dim, sliced, promise[job, dim] + promise["JOB", 0]))
    for fault in faults:
        print("FAULT " + fault)
    if not faults:
        print("ok    no job takes more stack than netmesh/job.h says")
    return len(faults)


# ----------------------------------------------------------------------------------------------------------- size


def check_size(records, objects, nm, limit):
    """Bytes of code and constants, a line for each folder and a column for each dimension, from their objects."""
    table = {}
    for path in records_below(records, {".o", ".obj"}, objects):
        parts = os.path.relpath(os.path.dirname(path), records).split(os.sep)
        room = parts[1] if parts[0] == "engine" and len(parts) > 1 else parts[0]
        row = table.setdefault(room, {})
        seen = {}
        for line in run(nm, "-P", "-S", "--defined-only", path).splitlines():
            field = line.split()
            if len(field) >= 4 and field[1].lower() in "trvwdbnu":
                seen[(field[0], field[2])] = int(field[3], 16)
        for (symbol, _), size in seen.items():
            dim = dimension_of(symbol)
            row[dim] = row.get(dim, 0) + size
    columns = [2, 3, 4, 5, 6, None]
    heads = ["any D" if d is None else "D = %d" % d for d in columns] + ["sum"]
    print("%-12s" % "bytes" + "".join("%10s" % head for head in heads))
    total = 0
    for room, row in sorted(table.items()):
        print("%-12s" % room + "".join("%10d" % row.get(d, 0) for d in columns) + "%10d" % sum(row.values()))
        total += sum(row.values())
    sums = [sum(row.get(d, 0) for row in table.values()) for d in columns]
    print("%-12s" % "all folders" + "".join("%10d" % n for n in sums + [total]))
    if total == 0:
        print("FAULT no code under %s" % records)
    elif total > limit:
        print("FAULT %d bytes, %d are the limit" % (total, limit))
    else:
        print("ok    at most %d bytes" % limit)
    return 0 if 0 < total <= limit else 1


def main():
    parser = argparse.ArgumentParser()
    sub = parser.add_subparsers(dest="check", required=True)
    archive = sub.add_parser("archive")
    archive.add_argument("--archive", required=True)
    archive.add_argument("--plain", action="store_true")
    archive.add_argument("--helpers", action="store_true")
    archive.add_argument("--tables", action="store_true")
    for tool in ("nm", "objdump", "readelf", "ld"):
        archive.add_argument("--" + tool, default=tool)
    includes = sub.add_parser("includes")
    includes.add_argument("--engine", required=True)
    stack = sub.add_parser("stack")
    stack.add_argument("--records", required=True)
    stack.add_argument("--objects")
    stack.add_argument("--bytes", type=int, default=32768)
    stack.add_argument("--bytes-low-dim", type=int, default=16384)
    stack.add_argument("--recursion-only", action="store_true")
    jobs = sub.add_parser("jobs")
    jobs.add_argument("--include", required=True)
    jobs.add_argument("--dims", default="2,3,4,5,6")
    jobs.add_argument("--promise-of", type=int, help="of --dims: the dimension whose promise holds for all")
    jobs.add_argument("--cc", default="cc")
    jobs.add_argument("--nm", default="nm")
    jobs.add_argument("--processor", default="x86_64")
    jobs.add_argument("--percent", type=int, default=100, help="of what the header promises: less plants a fault")
    for graph in (stack, jobs):
        graph.add_argument("--source")
        graph.add_argument("--helpers", action="store_true")
        graph.add_argument("--readelf", default="readelf")
    jobs.add_argument("--records", required=True)
    jobs.add_argument("--objects")
    size = sub.add_parser("size")
    size.add_argument("--records", required=True)
    size.add_argument("--objects")
    size.add_argument("--bytes", type=int, default=1_800_000)
    size.add_argument("--nm", default="nm")
    options = parser.parse_args()
    if options.check == "size":
        faults = check_size(options.records, options.objects, options.nm, options.bytes)
    elif options.check == "archive":
        faults = check_archive(options)
    elif options.check == "includes":
        faults = check_includes(options.engine)
    elif options.check == "jobs":
        faults = check_jobs(options)
    else:
        faults = check_stack(options)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
