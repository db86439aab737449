"""Delaunay triangulations, quality meshes and certified persistent homology of points in R^2 to R^6.

    >>> import numpy as np, netmesh
    >>> points = np.random.default_rng(1).normal(size=(100, 2))
    >>> points /= np.linalg.norm(points, axis=1, keepdims=True)
    >>> diagram = netmesh.persist(points)
    >>> birth, death = diagram.longest(1)[0]
    >>> bool(birth < 0.3 and death > 0.9)
    True

Every result is the same to the last bit on every machine. Births and deaths are radii, in units of the coordinates.
"""
from . import errors
from ._check import check
from ._clouds import persist_all
from ._diagram import Bounds, Diagram, Representatives
from ._distance import Transport, bottleneck, wasserstein
from ._files import load
from ._library import VERSION as __version__
from ._mesh import Mesh, delaunay, mesh
from ._persist import homology, persist, rips
from ._series import delay
from ._table import Table, read_table
from ._vineyard import Vineyard, vineyard

__all__ = ["Bounds", "Diagram", "Mesh", "Representatives", "Table", "Transport", "Vineyard", "bottleneck", "check",
           "delay", "delaunay", "errors", "homology", "load", "mesh", "persist", "persist_all", "read_table", "rips",
           "vineyard", "wasserstein", "__version__"]
