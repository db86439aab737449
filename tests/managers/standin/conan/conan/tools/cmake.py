import os

from conan import run


def cmake_layout(conanfile):
    conanfile.build_folder = os.path.join(conanfile.build_folder, conanfile.settings.build_type)
    conanfile.cpp.build.bindir = conanfile.build_folder


class CMakeToolchain:
    def __init__(self, conanfile):
        self.conanfile, self.cache_variables = conanfile, {}

    def generate(self):
        self.conanfile.cache_variables = self.cache_variables


def write_dependency(conanfile):
    """What the generator CMakeDeps writes, for one static library."""
    info, root = conanfile.requirement.cpp_info, conanfile.requirement.package_folder
    name, target = info.properties["cmake_file_name"], info.properties["cmake_target_name"]
    os.makedirs(conanfile.build_folder, exist_ok=True)
    with open(os.path.join(conanfile.build_folder, name + "-config.cmake"), "w", encoding="utf-8") as f:
        f.write("add_library(%s STATIC IMPORTED)\n" % target)
        f.write("set_target_properties(%s PROPERTIES IMPORTED_LOCATION %s/lib/lib%s.a\n"
                "  INTERFACE_INCLUDE_DIRECTORIES %s/include)\n" % (target, root, info.libs[0], root))


class CMake:
    def __init__(self, conanfile):
        self.conanfile = conanfile

    def configure(self):
        c = self.conanfile
        variables = {"CMAKE_BUILD_TYPE": c.settings.build_type, "CMAKE_INSTALL_PREFIX": c.package_folder,
                     **c.cache_variables}
        if "CMakeDeps" in c.generators:
            write_dependency(c)
            variables["CMAKE_PREFIX_PATH"] = c.build_folder
        text = {True: "ON", False: "OFF"}
        run(["cmake", "-S", c.source_folder, "-B", c.build_folder] +
            ["-D%s=%s" % (k, text.get(v, v)) for k, v in variables.items()])

    def build(self):
        run(["cmake", "--build", self.conanfile.build_folder, "--parallel", "2"])

    def install(self):
        run(["cmake", "--install", self.conanfile.build_folder])
