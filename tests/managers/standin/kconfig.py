"""kconfig.py KCONFIG MODULE_KCONFIG OUT CONF...: reads a configuration as Zephyr and ESP-IDF do, where a warning is an
error, and writes it for CMake."""
import os
import sys

import kconfiglib

root, module, out, *fragments = sys.argv[1:]
os.environ["MODULE_KCONFIG"] = module
if not os.path.isfile(module):
    sys.exit("no file " + module)
config = kconfiglib.Kconfig(root, warn_to_stderr=False)
wanted = {}
for fragment in fragments:
    config.load_config(fragment, replace=False)
    with open(fragment, encoding="utf-8") as f:
        wanted.update(line.strip().split("=", 1) for line in f if "=" in line)
for name, value in wanted.items():
    symbol = config.syms.get(name[len("CONFIG_"):])
    if symbol is not None and symbol.str_value != value:
        config.warnings.append("%s is %s, not %s" % (name, symbol.str_value, value))
if config.warnings:
    sys.exit("\n".join(config.warnings))
with open(out, "w", encoding="utf-8") as f:
    for symbol in config.unique_defined_syms:
        if symbol.str_value not in ("n", ""):
            f.write("set(CONFIG_%s %s)\n" % (symbol.name, symbol.str_value))
