#!/usr/bin/env python3
"""once.py KEPT COMPILER ARGUMENT...: compiles, or takes what the same compiler made of the same text before.

The text is the source behind the preprocessor, so it holds whatever files and definitions went into it. Arguments are
compared but for paths, definitions and warnings, which leave no trace in an object."""
import fcntl
import hashlib
import os
import re
import shutil
import subprocess
import sys

PASSED = re.compile(r"-[IDUW].*|-w|-isystem.*|-M.*|-g.*")


def main():
    kept, command = sys.argv[1], sys.argv[2:]
    if "-c" not in command or "-o" not in command:
        return subprocess.call(command)
    out = command[command.index("-o") + 1]
    rest, flags = iter(command), []
    expand = [a for a in command if not a.startswith("-M") and not a.endswith((".d", ".o", ".obj"))
              and a not in ("-c", "-o")]
    for argument in rest:
        if argument in ("-o", "-MF", "-MT", "-MQ", "-I", "-D", "-isystem"):
            next(rest)
        elif argument.startswith("-") and not PASSED.fullmatch(argument):
            flags.append(argument)
    text = subprocess.run(expand + ["-E", "-P"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if text.returncode != 0:
        return subprocess.call(command)
    key = hashlib.sha256(repr((os.path.basename(command[0]), sorted(set(flags)))).encode() + text.stdout).hexdigest()
    os.makedirs(kept, exist_ok=True)
    place = os.path.join(kept, key + ".o")
    with open(place + ".lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # or two that need it would both make it
        if os.path.exists(place):
            shutil.copy(place, out)
            return 0
        status = subprocess.call(command)
        if status == 0:
            shutil.copy(out, place + ".new")
            os.replace(place + ".new", place)
        return status


if __name__ == "__main__":
    sys.exit(main())
