#!/usr/bin/env python3
"""What the tool writes, read back by other programs: numpy, meshio, VTK and GUDHI, as far as they are there.

  other_readers.py NETMESH    the binary

Prints the names of readers that are missing, and SKIPPED where neither numpy nor meshio is there.
"""
import csv
import gzip
import json
import math
import os
import subprocess
import sys
import tempfile


def find(name):
    try:
        return __import__(name)
    except ImportError:
        print(f"without {name}: not there")
        return None


numpy = find("numpy")
meshio = find("meshio")
vtk = find("vtk")
gudhi = find("gudhi")


def run(*arguments):
    done = subprocess.run([BINARY, *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"netmesh {' '.join(arguments)}: exit {done.returncode}: {done.stderr}")
    return done.stdout


def same(name, have, due):
    if have != due:
        sys.exit(f"{name}: {have} where {due} is due")


def node_file(path):
    """Coordinates, attributes and markers of a .node file, cells of its .ele."""
    rows = [line.split() for line in open(path) if not line.startswith("#")]
    count, dim, attributes, _ = map(int, rows[0])
    vertices = [[float(x) for x in row[1 : 1 + dim]] for row in rows[1:]]
    values = [float(row[1 + dim]) for row in rows[1:]] if attributes else []
    markers = [int(row[-1]) for row in rows[1:]]
    same(path, len(vertices), count)
    cells = [list(map(int, line.split()))[1:] for line in open(path[:-4] + "ele")][1:]
    return vertices, values, markers, cells


def padded(vertices):
    return [vertex + [0.0] * (3 - len(vertex)) for vertex in vertices]


def triangles_of(cells):
    """Each triangle of triangles or tetrahedra once."""
    faces = set()
    for cell in cells:
        if len(cell) == 3:
            faces.add(tuple(sorted(cell)))
        else:
            faces |= {tuple(sorted(cell[:k] + cell[k + 1 :])) for k in range(4)}
    return sorted(faces)


def sorted_cells(cells):
    return sorted(tuple(sorted(map(int, cell))) for cell in cells)


def check_mesh(stem, ending, vertices, values, markers, cells):
    name = stem + ending
    mesh = meshio.read(name)
    places = [list(map(float, place)) for place in mesh.points]
    same(name + " points", padded(places), padded(vertices))
    kind = "triangle" if ending in (".ply", ".obj") or len(cells[0]) == 3 else "tetra"
    same(name + " kinds", [block.type for block in mesh.cells], [kind])
    due = triangles_of(cells) if ending in (".ply", ".obj") else sorted_cells(cells)
    same(name + " cells", sorted_cells(mesh.cells[0].data), due)
    if ending != ".obj":
        marker = mesh.point_data["medit:ref" if ending == ".mesh" else "marker"]
        same(name + " markers", [int(x) for x in marker.ravel()], markers)
    if values and ending not in (".obj", ".mesh"):
        same(name + " values", [float(x) for x in mesh.point_data["value"].ravel()], values)


def check_meshes():
    for dim, shape in ((2, "circle"), (3, "torus")):
        run("sample", shape, "-n", "40", "-o", "p.txt")
        for command, stem in (("delaunay", "t"), ("mesh", "m")):
            for ending in (".node", ".vtu", ".ply", ".obj", ".msh", ".mesh"):
                run(command, "p.txt", "-o", stem + ending, "--quiet")
                if ending != ".node" and meshio:
                    check_mesh(stem, ending, *node_file(stem + ".node"))
        for ending in (".node", ".vtu", ".ply", ".obj", ".msh", ".mesh"):  # with values
            run("persist", "p.txt", "-o", "d.pers", "--mesh", "v" + ending, "--quiet")
            if ending != ".node" and meshio:
                check_mesh("v", ending, *node_file("v.node"))
        vertices, values, _, cells = node_file("v.node")
        lines = open("v.sol").read().split()
        same("v.sol", [float(x) for x in lines[lines.index("1", 5) + 2 : -1]][-len(values) :], values)
        if vtk:
            reader = vtk.vtkXMLUnstructuredGridReader()
            reader.SetFileName("v.vtu")
            reader.Update()
            grid = reader.GetOutput()
            same("vtk", (grid.GetNumberOfPoints(), grid.GetNumberOfCells()), (len(vertices), len(cells)))


def bars_in(text):
    rows = [line.split() for line in text.splitlines() if line and not line.startswith("#")]
    return [[float(degree), float(birth), float(death)] for degree, birth, death in rows]


def check_diagrams():
    run("sample", "torus", "-n", "60", "-o", "p.txt")
    for options in ([], ["--top", "3"], ["--min-persistence", "0.2"]):
        for ending in (".pers", ".csv", ".json", ".npy"):
            run("persist", "p.txt", "--filter", "alpha", "-o", "d" + ending, "--quiet", *options)
        bars = bars_in(open("d.pers").read())
        with open("d.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        same("d.csv", [[float(row[k]) for k in ("degree", "birth", "death")] for row in rows], bars)
        document = json.load(open("d.json"))
        same("d.json", [[k, b, math.inf if d is None else d] for k, b, d in document["bars"]], bars)
        if numpy:
            same("d.npy", numpy.load("d.npy").tolist(), bars)
        if gudhi:
            read = gudhi.read_persistence_intervals_grouped_by_dimension("d.pers")
            grouped = {k: sorted([b, d] for q, b, d in bars if q == k) for k in {int(bar[0]) for bar in bars}}
            same("gudhi", {k: sorted(map(list, v)) for k, v in read.items()}, grouped)


def cycles_in(path):
    cycles, lines = [], open(path).read().splitlines()
    while lines:
        words = lines.pop(0).split()
        count = int(words[4])
        cycles.append((words[1:4], [tuple(map(int, line.split())) for line in lines[:count]]))
        del lines[:count]
    return cycles


def check_cycles():
    for shape, options in (("circle", ["--filter", "rips"]), ("torus", ["--filter", "alpha"]), ("sphere", [])):
        run("sample", shape, "-n", "24", "-o", "p.txt")
        for ending in (".txt", ".vtu", ".obj"):
            run("persist", "p.txt", *options, "--representatives", "r" + ending, "-o", "d.pers", "--quiet")
        cycles = cycles_in("r.txt")
        simplices = [simplex for _, cycle in cycles for simplex in cycle]
        groups, places = [], []
        for line in open("r.obj"):
            words = line.split()
            if words[0] == "g":
                groups.append([])
            elif words[0] == "v":
                places.append(words[1:])
            elif words[0] in "plf":
                groups[-1].append(tuple(int(word) - 1 for word in words[1:]))
        same("r.obj", groups, [cycle for _, cycle in cycles])
        if not meshio:
            continue
        grid = meshio.read("r.vtu")
        same("r.vtu points", [list(map(float, p)) for p in places], [list(map(float, p)) for p in grid.points])
        read = [tuple(map(int, cell)) for block in grid.cells for cell in block.data]
        same("r.vtu cells", sorted(read), sorted(simplices))
        bars = [int(x) for block in grid.cell_data["bar"] for x in block.ravel()]
        same("r.vtu bars", sorted(bars), sorted(i for i, (_, cycle) in enumerate(cycles) for _ in cycle))
        births = {float(x) for block in grid.cell_data["birth"] for x in block.ravel()}
        same("r.vtu births", births, {float(bar[1]) for bar, cycle in cycles if cycle})


def points_read(name):
    """The points that the tool takes out of a file, as the vertices of their triangulation."""
    run("delaunay", name, "-o", "read.node", "--quiet")
    return node_file("read.node")[0]


def check_diagrams_in_arrays():
    with open("ref.pers", "w") as file:
        file.write("0 0 0.5\n0 0 inf\n1 0.75 1.5\n")
    loops, rows = numpy.array([[0.75, 1.5]]), numpy.array([[0, 0, 0.5], [0, 0, numpy.inf], [1, 0.75, 1.5]])
    pieces = numpy.array([[0, 0.5], [0, numpy.inf]])
    numpy.savez("dgms.npz", pieces, loops, numpy.empty((0, 2)))
    numpy.savez_compressed("named.npz", dgm1=loops, dgm0=pieces)
    numpy.savez("one.npz", rows)
    numpy.save("rows.npy", rows.astype(numpy.float32))
    numpy.save("empty.npy", numpy.empty((0, 3)))
    for name in ("dgms.npz", "named.npz", "one.npz", "rows.npy"):
        same(name, run("distance", name, "ref.pers", "-q").split(), ["0", "0", "1", "0"])
    same("empty.npy", run("distance", "empty.npy", "empty.npy", "-q"), "")
    numpy.savez("x.npz", a=pieces, b=loops)
    numpy.save("pairs.npy", pieces)
    for name, due in (("x.npz", "does not end in its degree"), ("pairs.npy", "numpy.savez(FILE, *diagrams)")):
        same(name, due in subprocess.run([BINARY, "distance", name, "ref.pers"], capture_output=True, text=True).stderr,
             True)


def check_hints_for_types(array):
    """What the tool says of elements that it does not read is a call that makes floats of them."""
    import numpy.lib.recfunctions
    records = numpy.array([tuple(row) for row in array], dtype=[("x", "f8"), ("y", "f8")])
    for a in (records, array[:, 0] + 1j * array[:, 1], array.astype(object), array.astype(str), array.astype("S30"),
              array.astype(numpy.longdouble)):
        numpy.save("typed.npy", a, allow_pickle=True)
        done = subprocess.run([BINARY, "delaunay", "typed.npy"], capture_output=True, text=True)
        same(str(a.dtype), done.returncode, 3)
        call = done.stderr.strip().split("numpy.save(FILE, ...) of ")[1].split(", where ")[0]
        numpy.save("mended.npy", eval(call, {"numpy": numpy, "a": a}))
        same(call, points_read("mended.npy"), array.tolist())


def check_inputs():
    """The other way: what numpy, csv and meshio write is read by the tool."""
    points = [[1.5, -2.25], [3.125, 4.0], [-0.5, 6.75], [0.0, 0.1]]
    with open("excel.csv", "w", newline="") as file:
        csv.writer(file, dialect="excel").writerows([["x", "y"]] + points)
    same("excel.csv", points_read("excel.csv"), points)
    with open("quoted.csv", "w", newline="") as file:
        csv.writer(file, quoting=csv.QUOTE_ALL, delimiter=";").writerows(points)
    same("quoted.csv", points_read("quoted.csv"), points)
    with gzip.open("p.csv.gz", "wt") as file:
        file.write("".join(f"{x},{y}\n" for x, y in points))
    if subprocess.run([BINARY, "delaunay", "p.csv.gz"], capture_output=True).stderr.find(b"without zlib") >= 0:
        print("without zlib: the tool was built so")
        return
    same("p.csv.gz", points_read("p.csv.gz"), points)
    if numpy:
        array = numpy.array(points)
        for name, form in (("c", array), ("f", numpy.asfortranarray(array)), ("big", array.astype(">f8"))):
            numpy.save(name + ".npy", form)
            same(name + ".npy", points_read(name + ".npy"), points)
        halves = array.astype(numpy.float16)
        numpy.save("half.npy", halves)
        same("half.npy", points_read("half.npy"), halves.astype(float).tolist())
        numpy.savez("z.npz", array)
        same("z.npz", points_read("z.npz"), points)
        numpy.savez_compressed("zz.npz", a=array, b=numpy.zeros(3))
        same("zz.npz", points_read("zz.npz:a"), points)
        numpy.savetxt("t.txt", array, header="x y")
        same("t.txt", points_read("t.txt"), points)
        check_diagrams_in_arrays()
        check_hints_for_types(array)
    if meshio:
        corners = [[0.5, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        mesh = meshio.Mesh(corners, [("triangle", [[0, 1, 2], [0, 1, 3], [0, 2, 3]])])
        for name in ("w.obj", "w.stl", "w.off", "w.ply"):
            mesh.write(name)
            same(name, sorted(points_read(name)), sorted(corners))


def main():
    if numpy is None and meshio is None:
        print("SKIPPED: neither numpy nor meshio is there to read what the tool writes")
        return
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        check_meshes()
        check_diagrams()
        check_cycles()
        check_inputs()
        os.chdir("/")
    print("read back by", ", ".join(m.__name__ for m in (numpy, meshio, vtk, gudhi) if m))


if __name__ == "__main__":
    BINARY = os.path.abspath(sys.argv[1])
    main()
