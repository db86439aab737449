"""What each package manager documents of its manifest, as far as a program can check it without the manager.

faults(kind, folder, expected) gives lines of text; listed(kind, folder) the files that the manager takes along."""
import fnmatch
import glob
import json
import os
import re
import sys
import xml.etree.ElementTree

VERSION = re.compile(r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)")
URL = re.compile(r"https?://[^\s/]+\S*")


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as f:
        return f.read()


def files_of(folder):
    return sorted(os.path.relpath(os.path.join(base, name), folder).replace(os.sep, "/")
                  for base, _, names in os.walk(folder) for name in names if "__pycache__" not in base)


def matching(folder, patterns):
    """Files by glob, ** for any folders."""
    found = set()
    for pattern in patterns:
        found |= {os.path.relpath(p, folder).replace(os.sep, "/")
                  for p in glob.glob(os.path.join(glob.escape(folder), pattern), recursive=True) if os.path.isfile(p)}
    return sorted(found)


def unknown(found, known):
    return ["there is no field %s" % name for name in sorted(set(found) - set(known))]


def absent(folder, paths):
    return ["%s is listed and not there" % path for path in paths if not os.path.isfile(os.path.join(folder, path))]


# Arduino: the library specification, and the rules of arduino-lint. No list of files: the layout is one.

CATEGORIES = ("Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing", "Data Storage",
              "Data Processing", "Other")
PROPERTIES = {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures",
              "includes", "license"}


def properties(folder):
    lines = [line for line in read(folder, "library.properties").splitlines() if line and not line.startswith("#")]
    return dict(line.split("=", 1) for line in lines)


def arduino(folder, expected):
    said = properties(folder)
    faults = unknown(said, PROPERTIES) + ["no field %s" % name for name in sorted(PROPERTIES - set(said))]
    faults += ["%s is empty" % name for name, value in said.items() if not value and name != "url"]
    name = said.get("name", "")
    if not re.fullmatch(r"[A-Za-z0-9][\w .-]{0,62}", name) or re.match("arduino", name, re.I):
        faults.append("name: %s" % name)
    if said.get("category") not in CATEGORIES:
        faults.append("category: %s" % said.get("category"))
    if said.get("url") and not URL.fullmatch(said["url"]):
        faults.append("url: %s" % said["url"])
    if not re.fullmatch(r"\*|[a-z0-9_]+(,[a-z0-9_]+)*", said.get("architectures", "")):
        faults.append("architectures: %s" % said.get("architectures"))
    if said.get("sentence", "") in said.get("paragraph", ""):
        faults.append("paragraph repeats sentence")
    faults += absent(folder, ["src/" + header for header in said.get("includes", "").split(",")])
    for sketch in matching(folder, ["**/*.ino"]):
        parts = sketch.split("/")
        if parts[0] != "examples" or parts[-1] != parts[-2] + ".ino":
            faults.append("%s is no sketch of a folder of its name in examples" % sketch)
    return faults + same(expected, said.get("version"), said.get("license"), name)


def listed_arduino(folder):
    return matching(folder, ["library.properties", "LICENSE", "README.md", "src/**/*.h", "src/**/*.cpp", "src/**/*.c",
                             "examples/**/*"])


def same(expected, version, license_, name, license_matters=True):
    faults = [] if version == expected["version"] else ["version %s, not %s" % (version, expected["version"])]
    if license_matters and license_ != expected["license"]:
        faults.append("license %s, not %s" % (license_, expected["license"]))
    return faults if name == expected["name"] else faults + ["name %s" % name]


# PlatformIO: the schema of library.json

def platformio(folder, expected):
    said = json.loads(read(folder, "library.json"))
    known = {"name", "version", "description", "keywords", "homepage", "repository", "authors", "license", "frameworks",
             "platforms", "headers", "examples", "dependencies", "build", "export", "scripts"}
    faults = unknown(said, known)
    faults += ["keyword: %s" % word for word in said.get("keywords", [])
               if not re.fullmatch(r"[a-z\d_+. -]{1,50}", word)]
    for author in said.get("authors", []):
        faults += unknown(author, {"name", "email", "maintainer", "url"})
        address = re.fullmatch(r"\S+@\S+\.\S+", author.get("email", ""))
        if not 1 <= len(author.get("name", "")) <= 100 or not address:
            faults.append("author: %s" % author)
    if not 1 <= len(said.get("description", "")) <= 1000:
        faults.append("description")
    if "homepage" in said and not URL.fullmatch(said["homepage"]):
        faults.append("homepage: %s" % said["homepage"])
    for name in ("frameworks", "platforms"):
        words = said.get(name, "*")
        words = words if isinstance(words, list) else [words]
        faults += ["%s: %s" % (name, word) for word in words if not re.fullmatch(r"[a-z\d_-]+|\*", word)]
    build = said.get("build", {})
    faults += unknown(build, {"flags", "unflags", "includeDir", "srcDir", "srcFilter", "extraScript", "libArchive",
                              "libLDFMode", "libCompatMode", "builder"})
    faults += ["build.%s is no folder" % name for name in ("srcDir", "includeDir")
               if not os.path.isdir(os.path.join(folder, build.get(name, "src")))]
    faults += absent(folder, [os.path.join(build.get("includeDir", "include"), said.get("headers", ""))])
    faults += unknown(said.get("export", {}), {"include", "exclude"})
    faults += absent(folder, said.get("export", {}).get("include", []))
    return faults + same(expected, said.get("version"), said.get("license"), said.get("name"))


def listed_platformio(folder):
    """What pio pkg pack takes: export.include, and always the manifest, README and LICENSE."""
    include = json.loads(read(folder, "library.json"))["export"]["include"]
    return matching(folder, include + ["library.json", "README.md", "LICENSE"])


# ESP-IDF: the manifest of its component manager

def espidf(folder, expected):
    import yaml
    said = yaml.safe_load(read(folder, "idf_component.yml"))
    known = {"version", "targets", "maintainers", "description", "license", "tags", "dependencies", "files", "examples",
             "url", "repository", "documentation", "issues", "discussion", "repository_info"}
    faults = unknown(said, known)
    tags = said.get("tags", [])
    faults += ["tag: %s" % tag for tag in tags if not re.fullmatch(r"[A-Za-z0-9_-]{3,32}", tag)]
    if len(set(map(str.lower, tags))) != len(tags):
        faults.append("a tag twice")
    faults += ["%s: %s" % (name, said[name]) for name in ("url", "repository", "documentation")
               if name in said and not URL.fullmatch(said[name])]
    for name, wanted in said.get("dependencies", {}).items():
        if not re.fullmatch(r"([a-z\d_-]+/)?[a-z\d_+-]+", name) or "__" in name:
            faults.append("dependency: %s" % name)
        if isinstance(wanted, str) and not re.fullmatch(r"(\*|[~^<>=!]*\d+(\.\d+)*)(,[<>=!]+\d+(\.\d+)*)*", wanted):
            faults.append("dependency: %s %s" % (name, wanted))
    faults += unknown(said.get("files", {}), {"use_gitignore", "include", "exclude"})
    faults += absent(folder, said.get("files", {}).get("include", []))
    for name in ("CMakeLists.txt", "idf_component.yml"):
        if name not in listed_espidf(folder):
            faults.append("%s is not among the files" % name)
    return faults + same(expected, said.get("version"), said.get("license"), expected["name"])


def listed_espidf(folder):
    """All files, less what is excluded, and what is included."""
    import yaml
    rules = yaml.safe_load(read(folder, "idf_component.yml")).get("files", {})
    left = set(files_of(folder)) - set(matching(folder, rules.get("exclude", [])))
    return sorted(left | set(matching(folder, rules.get("include", []))))


# Zephyr: the schema of module.yml in scripts/zephyr_module.py. It has no version and no licence.

def module(folder):
    import yaml
    return yaml.safe_load(read(folder, "zephyr/module.yml"))


def zephyr(folder, expected):
    said = module(folder)
    build = said.get("build", {})
    faults = unknown(said, {"name", "build", "tests", "samples", "boards", "blobs"})
    faults += unknown(build, {"cmake", "kconfig", "cmake-ext", "kconfig-ext", "depends", "settings"})
    faults += absent(folder, [build.get("cmake", "zephyr") + "/CMakeLists.txt", build.get("kconfig", "zephyr/Kconfig")])
    faults += ["samples: no folder %s" % path for path in said.get("samples", [])
               if not os.path.isdir(os.path.join(folder, path))]
    for sample in matching(folder, [path + "/**/sample.yaml" for path in said.get("samples", [])]):
        import yaml
        found = yaml.safe_load(read(folder, sample))
        faults += unknown(found, {"sample", "common", "tests"})
        faults += absent(os.path.join(folder, os.path.dirname(sample)), ["CMakeLists.txt", "prj.conf"])
    return faults + same(expected, expected["version"], None, said.get("name"), False)


def listed_zephyr(folder):
    """What module.yml and the files that it names name: west takes the folder whole."""
    said = module(folder)
    cmake, kconfig = said["build"]["cmake"] + "/CMakeLists.txt", said["build"]["kconfig"]
    text = read(folder, cmake)
    found = {"zephyr/module.yml", cmake, kconfig}
    for path in re.findall(r"zephyr_library_sources\((.*?)\)", text, re.S):
        found |= {os.path.normpath(os.path.join(os.path.dirname(cmake), p)) for p in path.split()}
    for path in re.findall(r"zephyr_include_directories\((.*?)\)", text, re.S):
        for where in path.split():
            found |= set(matching(folder, [os.path.normpath(os.path.join(os.path.dirname(cmake), where)) + "/*.h"]))
    for path in said.get("samples", []):
        found |= set(matching(folder, [path + "/**/*"]))
    return sorted(found)


# CMSIS: PACK.xsd. Its own file is VENDOR.NAME.pdsc.

PDSC_FILE = {"category", "name", "attr", "language", "select", "version", "condition", "scope", "path", "public"}
PDSC_CATEGORIES = {"doc", "header", "include", "library", "object", "source", "linkerScript", "utility", "image",
                   "other", "preIncludeGlobal", "preIncludeLocal"}
PDSC_ELEMENTS = ["name", "vendor", "description", "url", "license", "releases", "keywords", "taxonomy", "components"]


def description(folder):
    """The name of the file, and what it holds."""
    (path,) = matching(folder, ["*.pdsc"])
    return path, xml.etree.ElementTree.parse(os.path.join(folder, path)).getroot()


def cmsis(folder, expected):
    path, root = description(folder)
    faults = unknown([child.tag for child in root], PDSC_ELEMENTS)
    faults += ["%d elements %s" % (len(root.findall(tag)), tag) for tag in PDSC_ELEMENTS if len(root.findall(tag)) != 1]
    if root.tag != "package" or not re.fullmatch(r"\d+\.\d+(\.\d+)?", root.get("schemaVersion", "")):
        faults.append("package of schema %s" % root.get("schemaVersion"))
    vendor, name = root.findtext("vendor", ""), root.findtext("name", "")
    if path != "%s.%s.pdsc" % (vendor, name) or not re.fullmatch(r"[\w-]+", vendor + name):
        faults.append("%s is of %s, %s" % (path, vendor, name))
    if root.findtext("url") and not URL.fullmatch(root.findtext("url")):
        faults.append("url: %s" % root.findtext("url"))
    versions = [release.get("version") for release in root.iter("release")]
    classes = {entry.get("Cclass") for entry in root.iter("description") if entry.get("Cclass")}
    for component in root.iter("component"):
        versions.append(component.get("Cversion"))
        if not component.get("Cgroup") or component.get("Cclass") not in classes:
            faults.append("component: %s" % component.attrib)
        if [child.tag for child in component] != ["description", "RTE_Components_h", "files"]:
            faults.append("a component is a description, RTE_Components_h and files, in this order")
        for file in component.iter("file"):
            faults += unknown(file.attrib, PDSC_FILE)
            if file.get("category") not in PDSC_CATEGORIES or file.get("attr") not in (None, "config", "template"):
                faults.append("file: %s" % file.attrib)
            if file.get("attr") == "config" and not VERSION.fullmatch(file.get("version", "")):
                faults.append("a file for configuration has a version: %s" % file.attrib)
        paths = [(file.get("attr"), os.path.dirname(file.get("name"))) for file in component.iter("file")]
        open_folders = {place for attr, place in paths if attr is None}
        faults += ["%s is on the include path, and holds a file for configuration" % place for attr, place in paths
                   if attr == "config" and place in open_folders]
    license_ = root.findtext("license", "")
    faults += absent(folder, listed_cmsis(folder))
    wrong = [version for version in versions if version != expected["version"]]
    return faults + same(expected, wrong[0] if wrong else expected["version"], license_, name, False)


def listed_cmsis(folder):
    path, root = description(folder)
    found = {path, root.findtext("license"), root.find("description").get("overview")}
    return sorted(found | {file.get("name") for file in root.iter("file")} - {None})


# vcpkg: the schema of vcpkg.json. A port is a folder, taken whole.

IDENTIFIER = re.compile(r"(?!(prn|aux|nul|con|lpt[1-9]|com[1-9]|core|default)$)[a-z0-9]+(-[a-z0-9]+)*")


def vcpkg(folder, expected):
    said = json.loads(read(folder, "vcpkg.json"))
    faults = unknown(said, {"name", "version-semver", "maintainers", "description", "homepage", "license", "supports",
                            "dependencies", "default-features", "features"})
    faults += ["feature: %s" % name for name, feature in said.get("features", {}).items()
               if not IDENTIFIER.fullmatch(name) or "description" not in feature
               or set(feature) - {"description", "dependencies", "supports", "license"}]
    faults += ["default feature %s is none" % name for name in said.get("default-features", [])
               if name not in said.get("features", {})]
    for needed in said.get("dependencies", []):
        faults += unknown(needed, {"name", "host", "features", "default-features", "platform", "version>="})
        if not IDENTIFIER.fullmatch(needed.get("name", "")):
            faults.append("dependency: %s" % needed)
    if "homepage" in said and not URL.fullmatch(said["homepage"]):
        faults.append("homepage: %s" % said["homepage"])
    faults += absent(folder, ["portfile.cmake", "usage"])
    return faults + same(expected, said.get("version-semver"), said.get("license"), said.get("name"))


def listed_vcpkg(folder):
    return files_of(folder)


# conan: attributes of a recipe of version 2

def recipe(path):
    """The class of a recipe."""
    import importlib.util
    stand_in = os.path.join(os.path.dirname(os.path.abspath(__file__)), "standin", "conan")
    sys.path.insert(0, stand_in)
    sys.dont_write_bytecode = True
    spec = importlib.util.spec_from_file_location("recipe", path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    sys.path.remove(stand_in)
    from conan import ConanFile
    classes = [c for c in vars(loaded).values() if isinstance(c, type) and issubclass(c, ConanFile)]
    (found,) = [c for c in classes if c is not ConanFile]
    return found


def conan(folder, expected):
    made = recipe(os.path.join(folder, "conanfile.py"))
    own = {name for name in vars(made) if not name.startswith("_")}
    faults = unknown(own, {"name", "version", "license", "author", "homepage", "url", "description", "topics",
                           "package_type", "settings", "options", "default_options", "exports_sources", "validate",
                           "layout", "generate", "build", "package", "package_info"})
    if not re.fullmatch(r"[a-z0-9_][a-z0-9_+.-]{1,100}", made.name):
        faults.append("name: %s" % made.name)
    if made.package_type not in ("application", "library", "shared-library", "static-library", "header-library",
                                 "build-scripts", "python-require", "unknown"):
        faults.append("package_type: %s" % made.package_type)
    faults += ["default of %s: %s" % option for option in made.default_options.items()
               if option[1] not in made.options.get(option[0], ())]
    faults += ["exports_sources: nothing is %s" % pattern for pattern in made.exports_sources
               if not fnmatch.filter(files_of(folder), pattern)]
    faults += absent(folder, ["test_package/conanfile.py"])
    return faults + same(expected, made.version, made.license, made.name)


def listed_conan(folder):
    """What conan create exports. Its patterns let * stand for folders, too; test_package stays where it is."""
    patterns = ("conanfile.py", "test_package/*") + recipe(os.path.join(folder, "conanfile.py")).exports_sources
    return sorted({path for pattern in patterns for path in fnmatch.filter(files_of(folder), pattern)})


def faults(kind, folder, expected):
    return globals()[kind](folder, expected)


def listed(kind, folder):
    return globals()["listed_" + kind](folder)
