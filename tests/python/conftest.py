"""What the tests of the Python package share: where things are, point sets, and the golden files."""
import concurrent.futures
import multiprocessing
import os
import sys

import numpy as np
import pytest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "platform", "python"))

MASK = 2 ** 64 - 1


def processes(count):
    """An executor; the test is skipped where the system has no locks between processes, as without /dev/shm."""
    context = multiprocessing.get_context("spawn")
    try:
        context.Lock()
    except OSError as why:
        pytest.skip("no locks between processes: %s" % why)
    return concurrent.futures.ProcessPoolExecutor(count, mp_context=context)


def needs_proc():
    if not os.path.exists("/proc/self/statm"):
        pytest.skip("no /proc")


class Random:
    """The generator of tests/determinism/slice.cpp."""

    def __init__(self, seed):
        self.state = seed * 0x9E3779B97F4A7C15 & MASK

    def bits(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) & MASK
        high = self.state >> 32
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) & MASK
        return high << 32 | self.state >> 32

    def uniform(self):
        return (self.bits() >> 11) * 2.0 ** -53

    def below(self, n):
        return (self.bits() >> 32) % n


class Mixed:
    """The generator of tests/common/inputs.hpp, splitmix64."""

    def __init__(self, seed):
        self.state = seed

    def bits(self):
        self.state = (self.state + 0x9E3779B97F4A7C15) & MASK
        z = self.state
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & MASK
        z = (z ^ z >> 27) * 0x94D049BB133111EB & MASK
        return z ^ z >> 31

    def uniform(self):
        return (self.bits() >> 11) * 2.0 ** -53


def uniform(dim, count, seed=1):
    random = Mixed(seed)
    return np.array([random.uniform() for _ in range(count * dim)]).reshape(count, dim)


def grid(dim, side):
    axes = [np.arange(side, dtype=float)] * dim
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, dim)[:, ::-1].copy()


def circle(count, noise=0.0, seed=1):
    angle = 2 * np.pi * np.arange(count) / count
    points = np.stack((np.cos(angle), np.sin(angle)), axis=1)
    return points + noise * np.random.default_rng(seed).normal(size=points.shape)


def golden(name):
    with open(os.path.join(ROOT, "tests", "golden", name), encoding="ascii") as file:
        return file.read().splitlines()


def built_dimensions():
    import netmesh
    found = []
    for dim in range(2, 7):
        try:
            netmesh.delaunay(np.eye(dim + 1, dim))
            found.append(dim)
        except netmesh.errors.NotBuilt:
            pass
    return found


@pytest.fixture
def tool():
    path = os.environ.get("NETMESH_TOOL")
    if not path:
        pytest.skip("NETMESH_TOOL, the command-line tool, is not given")
    return path
