"""Diagrams in pieces: the same bars, whoever runs the tasks."""
import concurrent.futures
import os
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import netmesh
from conftest import needs_proc, processes
from netmesh import _pieces


def cloud(n=2000, dim=3, seed=4):
    return np.random.default_rng(seed).normal(size=(n, dim))


@pytest.mark.parametrize("dim, n", [(2, 3000), (3, 2000), (4, 300), (5, 60)])
@pytest.mark.parametrize("pieces", [1, 4, 16])
def test_same_diagram(dim, n, pieces, tmp_path):
    points = cloud(n, dim)
    whole, parts = netmesh.persist(points, "alpha"), netmesh.persist(points, pieces=pieces)
    assert parts == whole and parts.fingerprint == whole.fingerprint
    whole.save(tmp_path / "whole.pers")
    parts.save(tmp_path / "parts.pers")
    assert (tmp_path / "whole.pers").read_bytes() == (tmp_path / "parts.pers").read_bytes()


def test_options():
    points = np.round(cloud(), 1)
    for options in (dict(max_degree=1), dict(keep_zero_pairs=True), dict(memory="64M")):
        kept = {name: value for name, value in options.items() if name != "memory"}
        assert netmesh.persist(points, "alpha", **kept) == netmesh.persist(points, "alpha", pieces=8, **options)


def test_processes_and_threads():
    points = cloud()
    whole = netmesh.persist(points, "alpha")
    with processes(2) as executor:
        assert netmesh.persist(points, pieces=8, executor=executor).fingerprint == whole.fingerprint
    with concurrent.futures.ThreadPoolExecutor(3) as executor:
        assert netmesh.persist(points, pieces="auto", executor=executor).fingerprint == whole.fingerprint


def test_memmap_and_float32(tmp_path):
    points = cloud().astype(np.float32)
    np.save(tmp_path / "points.npy", points)
    mapped = np.load(tmp_path / "points.npy", mmap_mode="r")
    assert netmesh.persist(mapped, pieces=4).fingerprint == netmesh.persist(points, "alpha").fingerprint


def test_goes_on_with_what_is_there(tmp_path):
    points = cloud()
    folder = str(tmp_path / "scratch")
    facts = _pieces.split(points, folder, 8)
    for node in (8, 9, 4, 13):
        _pieces.make(folder, node)
    before = os.stat(os.path.join(folder, "piece-4")).st_mtime_ns
    assert netmesh.persist(points, pieces=8, scratch=folder) == netmesh.persist(points, "alpha")
    assert os.stat(os.path.join(folder, "piece-4")).st_mtime_ns == before
    assert facts["pieces"] == 8
    with pytest.raises(netmesh.errors.InvalidArgument, match="another job") as error:
        netmesh.persist(cloud(seed=5), pieces=8, scratch=folder)
    assert error.value.argument == "scratch"


def test_damaged_pieces(tmp_path):
    points = cloud()
    folder = str(tmp_path / "scratch")
    whole = netmesh.persist(points, pieces=4, scratch=folder)
    path = os.path.join(folder, "piece-5")
    content = bytearray(open(path, "rb").read())
    content[len(content) // 2] ^= 4
    open(path, "wb").write(content)
    os.unlink(os.path.join(folder, "piece-2"))
    with pytest.raises(netmesh.errors.InvalidArgument, match="piece-5.*damaged"):
        _pieces.make(folder, 2)
    # The same call makes it again.
    assert netmesh.persist(points, pieces=4, scratch=folder) == whole


def _die(folder, node, memory=None):
    if node == 9 and not os.path.exists(os.path.join(folder, "killed")):
        open(os.path.join(folder, "killed"), "w").close()
        os.kill(os.getpid(), signal.SIGKILL)
    return _pieces.make(folder, node, memory)


class Killed:
    """An executor one of whose processes is killed."""

    def __init__(self, executor):
        self.executor = executor

    def submit(self, function, *arguments):
        return self.executor.submit(_die, *arguments)


def test_killed_worker(tmp_path):
    points = cloud()
    folder = str(tmp_path / "scratch")
    with processes(2) as executor:
        with pytest.raises(RuntimeError, match="the same call goes on"):
            netmesh.persist(points, pieces=8, executor=Killed(executor), scratch=folder)
    with processes(2) as executor:
        parts = netmesh.persist(points, pieces=8, executor=executor, scratch=folder)
    assert parts == netmesh.persist(points, "alpha")


@pytest.mark.parametrize("options, argument", [
    (dict(pieces=3), "pieces"), (dict(pieces=0), "pieces"), (dict(pieces="many"), "pieces"),
    (dict(pieces=2, filter="rips"), "pieces"), (dict(pieces=2, bounds=True), "bounds"),
    (dict(pieces=2, representatives=True), "representatives"), (dict(pieces=4096), "pieces"),
    (dict(pieces=2, progress=print), "progress"), (dict(pieces=2, ratio=2), "ratio")])
def test_refused(options, argument):
    with pytest.raises(netmesh.errors.InvalidArgument) as error:
        netmesh.persist(cloud(), **options)
    assert error.value.argument == argument


@pytest.mark.parametrize("options, argument, text", [
    (dict(executor=1), "executor", "goes with pieces"), (dict(scratch="x"), "scratch", "goes with pieces"),
    (dict(pieces=2, executor=1), "executor", "concurrent.futures.Executor"),
    (dict(pieces=2, scratch=""), "scratch", "path"), (dict(pieces=2, scratch=7), "scratch", "path")])
def test_refused_words(options, argument, text):
    with pytest.raises(netmesh.errors.InvalidArgument, match=text) as error:
        netmesh.persist(cloud(), **options)
    assert error.value.argument == argument


def test_damaged_scratch(tmp_path):
    """Whatever bit of whatever file is changed: the same diagram or an error that names the file."""
    points = cloud()
    folder = str(tmp_path / "scratch")
    whole = netmesh.persist(points, pieces=4, scratch=folder)
    random = np.random.default_rng(3)
    for name in ("points.npy", "rows.npy", "boxes.npy", "job.json"):
        path = os.path.join(folder, name)
        kept = open(path, "rb").read()
        for _ in range(10):
            content = bytearray(kept)
            content[random.integers(len(content))] ^= 1 << random.integers(8)
            open(path, "wb").write(content)
            for node in range(1, 8):
                os.unlink(os.path.join(folder, "piece-%d" % node))
            try:
                assert netmesh.persist(points, pieces=4, scratch=folder) == whole
            except netmesh.errors.InvalidArgument as error:
                assert error.argument == "scratch" and folder in str(error)
            open(path, "wb").write(kept)
            assert netmesh.persist(points, pieces=4, scratch=folder) == whole
    # Those of another job, and a piece of one.
    other = str(tmp_path / "other")
    netmesh.persist(cloud(seed=8), pieces=4, scratch=other)
    os.replace(os.path.join(other, "piece-1"), os.path.join(folder, "piece-1"))
    with pytest.raises(netmesh.errors.InvalidArgument, match="piece-1.*another job"):
        _pieces.collect(folder)
    os.replace(os.path.join(other, "points.npy"), os.path.join(folder, "points.npy"))
    os.unlink(os.path.join(folder, "piece-5"))
    with pytest.raises(netmesh.errors.InvalidArgument, match="points.npy.*another job"):
        netmesh.persist(points, pieces=4, scratch=folder)


def test_bad_points():
    with pytest.raises(netmesh.errors.Flat):
        netmesh.persist(np.zeros((40, 3)) + np.arange(40)[:, None], pieces=2)
    points = cloud()
    points[77, 1] = np.nan
    with pytest.raises(netmesh.errors.NotFinite) as error:
        netmesh.persist(points, pieces=2)
    assert error.value.row == 77


def test_dask():
    needs_proc()  # the package reads it
    distributed = pytest.importorskip("distributed")
    points = cloud()
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            parts = netmesh.persist(points, pieces=8, executor=client.get_executor())
    assert parts == netmesh.persist(points, "alpha")


def test_dask_loses_a_worker(tmp_path):
    needs_proc()  # the package reads it
    distributed = pytest.importorskip("distributed")
    points, folder = cloud(20000), str(tmp_path / "scratch")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client, concurrent.futures.ThreadPoolExecutor(1) as thread:
            running = thread.submit(netmesh.persist, points, pieces=32, scratch=folder,
                                    executor=client.get_executor())
            while not os.path.exists(os.path.join(folder, "piece-40")):
                time.sleep(0.01)
                assert not running.done()
            os.kill(next(iter(client.run(os.getpid).values())), signal.SIGKILL)
            try:
                parts = running.result(120)
            except RuntimeError as error:
                assert "the same call goes on" in str(error)
                parts = netmesh.persist(points, pieces=32, scratch=folder, executor=client.get_executor())
    assert parts == netmesh.persist(points, "alpha")


MPI = """
import numpy as np, netmesh
from mpi4py.futures import MPIPoolExecutor
if __name__ == "__main__":
    points = np.random.default_rng(4).normal(size=(2000, 3))
    with MPIPoolExecutor() as executor:
        parts = netmesh.persist(points, pieces=8, executor=executor)
    assert parts == netmesh.persist(points, "alpha") and parts.fingerprint
    print("same")
"""


def test_mpi(tmp_path):
    pytest.importorskip("mpi4py")
    if shutil.which("mpiexec") is None:
        pytest.skip("no mpiexec")
    (tmp_path / "program.py").write_text(MPI)
    start = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "3"]
    probe = subprocess.run(start + ["true"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                           timeout=100)
    if probe.returncode != 0:
        pytest.skip("mpiexec does not start programs here: " + probe.stdout[-200:])
    ended = subprocess.run(start + [sys.executable, "-m", "mpi4py.futures", str(tmp_path / "program.py")],
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, timeout=300)
    assert ended.returncode == 0 and "same" in ended.stdout, ended.stdout
