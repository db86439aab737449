"""The gallery of tools/docs/gallery.md in Python: diagrams of real data, drawn by matplotlib.

    python3 gallery.py [DATA [OUT]]

DATA is the folder tests/data of a clone, OUT where the pictures go. To be read from top to bottom, and run cell by cell
in an editor that knows the marks "# %%".
"""
# %% What is needed, and where things are.
import gzip
import pathlib
import sys

import matplotlib
import numpy as np

import netmesh

matplotlib.use("Agg")  # pictures go to files; leave this out in a notebook
import matplotlib.pyplot as plt  # noqa: E402

here = pathlib.Path(__file__).resolve().parent
data = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parents[2] / "tests" / "data"
out = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(".")


def show(name, diagram, title):
    """Diagram and barcode side by side, OUT/name.png, and the bars as the tool writes them, OUT/name.csv."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 5))
    diagram.plot(left)
    diagram.plot(right, kind="barcode")
    figure.suptitle(title)
    figure.tight_layout()
    figure.savefig(out / (name + ".png"), dpi=80)
    plt.close(figure)
    diagram.save(str(out / (name + ".csv")))
    print("%-12s %s %s" % (name, diagram.fingerprint, title))


# %% Atoms of a protein: rings of six atoms die at the length of their bonds, rings of five before that.
with gzip.open(data / "1A8O.pdb.gz", "rt") as file:
    atoms = [line for line in file if line.startswith(("ATOM", "HETATM"))]
atoms = np.array([[float(line[at:at + 8]) for at in (30, 38, 46)] for line in atoms])
diagram = netmesh.persist(atoms, max_degree=1)
early = diagram.intervals(1)[diagram.intervals(1)[:, 0] < 0.8]
show("protein", diagram, "%d rings of six atoms, %d of five" % ((early[:, 1] > 1.3).sum(), (early[:, 1] < 1.3).sum()))

# %% Earthquakes of a week, in thousands of kilometres from the middle of the Earth, which is the one void.
quakes = np.genfromtxt(data / "earthquakes.csv", delimiter=",", names=True)
points = np.column_stack((quakes["x"], quakes["y"], quakes["z"]))
diagram = netmesh.persist(points)
void, second = diagram.longest(2, 2)
show("earthquakes", diagram, "a void from %.0f to %.0f km" % tuple(1000 * void))
assert 1000 * (second[1] - second[0]) < 3

# %% Iris flowers: two groups of the three species.
flowers = np.loadtxt(data / "iris.csv", delimiter=",", skiprows=1)[:, :4]
diagram = netmesh.persist(flowers)
last, before = np.sort(diagram.intervals(0)[:, 1])[[-2, -3]]
show("iris", diagram, "two groups to %.2f cm, three to %.2f" % (last, before))

# %% High ground: the long loops are lower ground that it closes in.
ground = np.loadtxt(data / "jacksboro.csv", delimiter=",", skiprows=1)[:, :2]
diagram = netmesh.persist(ground)
show("jacksboro", diagram, "low ground with room for a disc of %.2f km" % diagram.intervals(1)[:, 1].max())
