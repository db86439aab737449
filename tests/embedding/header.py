#!/usr/bin/env python3
"""Looks at headers, with those that they include, and at netmesh.hpp.

  header.py shorten HEADER...      prints an older version's header: structs with a size lack their last member
  header.py calls HEADER... NETMESH_HPP
                                   every function of the others occurs in the last; prints what is missing, exits 1
  header.py same PROGRAM PROGRAM   runs both; exits 1 when one fails or they print different lines
"""
import difflib
import os
import re
import subprocess
import sys

WHOLE = ("netmesh_distances", "netmesh_simplices")  # their last members have to be set


def code_of(path, seen):
    """A header without comments, its own headers in the place where they are first included."""
    if path in seen:
        return ""
    seen.add(path)
    text = re.sub(r"/\*.*?\*/", "", open(path).read(), flags=re.S)
    return re.sub(r'#include "(.*)"', lambda m: code_of(os.path.join(os.path.dirname(path), m.group(1)), seen), text)


def shortened(body):
    """The members of a struct without the last one."""
    members = [m.strip() for m in body.split(";") if m.strip()]
    if re.search(r"\breserved$", members[-1]):  # fills the struct up
        members.pop()
    declared = re.match(r"(.*,)\s*\w+(?:\[[^\]]*\])?$", members[-1], re.S)
    members[-1:] = [declared.group(1)[:-1]] if declared and "(" not in members[-1] else []
    return "".join("    %s;\n" % m for m in members)


def code_of_all(headers):
    seen = set()
    return "".join(code_of(header, seen) for header in headers)


def shorten(*headers):
    struct = re.compile(r"typedef struct (netmesh_\w+) \{\s*(uint32_t struct_bytes;.*?)\} \1;", re.S)
    def without_last(m):
        if m.group(1) in WHOLE:
            return m.group(0)
        return "typedef struct %s {\n%s} %s;" % (m.group(1), shortened(m.group(2)), m.group(1))
    text, count = struct.subn(without_last, code_of_all(headers))
    if count < 20:
        sys.exit("only %d structs with a size in %s" % (count, " ".join(headers)))
    print("#define NETMESH_SHORTER\n" + text)


def calls(*headers_and_wrapper):
    *headers, wrapper = headers_and_wrapper
    without_types = re.sub(r"typedef [^;{]*;", "", code_of_all(headers))
    functions = sorted(set(re.findall(r"\b(netmesh_\w+)\s*\(", without_types)))
    text = re.sub(r"//.*", "", open(wrapper).read())
    missing = [f for f in functions if not re.search(r"\b%s\b" % f, text)]
    print("%d functions, missing in the C++ layer: %s" % (len(functions), " ".join(missing) or "none"))
    sys.exit(1 if missing or len(functions) < 40 else 0)


def same(*programs):
    texts = []
    for program in programs:
        run = subprocess.run([program], stdout=subprocess.PIPE, universal_newlines=True)
        print("%s: status %d\n%s" % (program, run.returncode, run.stdout))
        if run.returncode != 0:
            sys.exit(1)
        texts.append(run.stdout.splitlines())
    different = list(difflib.unified_diff(*texts, lineterm=""))
    print("\n".join(different) or "the same")
    sys.exit(1 if different or len(texts[0]) < 40 else 0)


if __name__ == "__main__":
    {"shorten": shorten, "calls": calls, "same": same}[sys.argv[1]](*sys.argv[2:])
