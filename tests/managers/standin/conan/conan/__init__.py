"""What a recipe sees of conan: enough to make a package, and a package that tests it, on this machine."""
import os
import subprocess


def run(command):
    """Quietly, unless it fails."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    if done.returncode != 0:
        raise RuntimeError("%s\n%s" % (" ".join(command), done.stdout))


class Settings:
    os, arch, compiler, build_type = "Linux", "x86_64", "gcc", "MinSizeRel"


class Options(dict):
    def get_safe(self, name):
        return self.get(name)


class Named:
    """self.folders, self.cpp.build and self.cpp_info."""

    def __init__(self):
        self.properties = {}

    def set_property(self, name, value):
        self.properties[name] = value


class ConanFile:
    settings, options, default_options, generators, exports_sources = (), {}, {}, (), ()

    def __init__(self, work, source, options=(), requirement=None):
        unknown = set(dict(options)) - set(type(self).options)
        if unknown:
            raise ValueError("no option " + " ".join(sorted(unknown)))
        self.options = Options(self.default_options, **dict(options))
        self.settings = Settings()
        self.source_folder, self.package_folder = source, os.path.join(work, "package")
        self.build_folder = os.path.join(work, "build")
        self.cpp, self.cpp_info, self.requirement = Named(), Named(), requirement
        self.cpp.build = Named()
        self.tested_reference_str = requirement and "%s/%s" % (requirement.name, requirement.version)
        self.cache_variables = {}

    def requires(self, reference):
        assert reference == self.tested_reference_str, reference

    def run(self, command, env=None):
        run(["sh", "-c", command])
