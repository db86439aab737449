"""Many clouds over one executor: the diagrams of each, whoever makes them."""
import concurrent.futures
import os
import pickle
import signal

import numpy as np
import pytest

import netmesh
from conftest import processes
from netmesh import _clouds


def clouds(count=12):
    random = np.random.default_rng(3)
    return [random.normal(size=(30 + 7 * i, 2 + i % 2)) for i in range(count)]


def test_same_diagrams(tmp_path):
    due = [netmesh.persist(cloud) for cloud in clouds()]
    with processes(2) as executor, concurrent.futures.ThreadPoolExecutor(3) as threads:
        for made in (netmesh.persist_all(clouds()), netmesh.persist_all(clouds(), executor=executor),
                     netmesh.persist_all(iter(clouds()), executor=threads)):
            assert made == due and [d.fingerprint for d in made] == [d.fingerprint for d in due]
            for i, (one, other) in enumerate(zip(made, due)):
                one.save(tmp_path / "one.pers")
                other.save(tmp_path / "other.pers")
                assert (tmp_path / "one.pers").read_bytes() == (tmp_path / "other.pers").read_bytes(), i
        assert netmesh.persist_all([], executor=executor) == []


def test_options():
    given = dict(filter="complete", max_degree=1, ratio=2.5, bounds=True, representatives=True, memory="64M")
    due = [netmesh.persist(cloud, **given) for cloud in clouds(3)]
    with processes(2) as executor:
        made = netmesh.persist_all(clouds(3), executor=executor, **given)
    assert made == due
    for one, other in zip(made, due):
        assert one.report == other.report
        assert np.array_equal(one.bounds.birth, other.bounds.birth)
        assert len(one.representatives) == len(other.representatives)


def test_diagrams_are_pickled(tmp_path):
    for diagram in (netmesh.persist(clouds()[1]), netmesh.rips(clouds()[0]),
                    netmesh.homology([[0], [1], [0, 1]], [0, 0, 1.5])):
        copy = pickle.loads(pickle.dumps(diagram))
        assert copy == diagram and copy.fingerprint == diagram.fingerprint and copy.report == diagram.report
        diagram.save(tmp_path / "one.pers")
        pickle.loads(pickle.dumps(copy)).save(tmp_path / "other.pers")
        assert (tmp_path / "one.pers").read_bytes() == (tmp_path / "other.pers").read_bytes()


def test_a_failure_names_its_cloud():
    many = clouds()
    many[7] = many[7].copy()
    many[7][5, 1] = np.nan
    many[9] = np.zeros((40, 3)) + np.arange(40)[:, None]
    with processes(2) as executor:
        for arguments in (dict(), dict(executor=executor)):
            with pytest.raises(netmesh.errors.NotFinite, match=r"^clouds\[7\]: ") as error:
                netmesh.persist_all(many, "alpha", **arguments)
            assert (error.value.cloud, error.value.row, error.value.argument) == (7, 5, "points")
            with pytest.raises(netmesh.errors.Flat, match=r"^clouds\[2\]: ") as error:
                netmesh.persist_all(many[7:][::-1][:3] + [many[9]], "alpha", **arguments)
            assert error.value.cloud == 2


class Dies:
    """An executor whose process is killed with the third task."""

    def __init__(self, executor):
        self.executor, self.tasks = executor, 0

    def submit(self, function, *arguments):
        self.tasks += 1
        if self.tasks == 3:
            return self.executor.submit(os.kill, self.executor.submit(os.getpid).result(), signal.SIGKILL)
        return self.executor.submit(function, *arguments)


def test_a_killed_process_names_a_cloud():
    with processes(1) as executor:
        with pytest.raises(RuntimeError, match=r"^clouds\[2\]: its task has not ended well") as error:
            netmesh.persist_all(clouds(), executor=Dies(executor))
    assert error.value.cloud == 2


@pytest.mark.parametrize("options, argument", [
    (dict(pieces=2), "pieces"), (dict(scratch="x"), "scratch"), (dict(progress=print), "progress")])
def test_refused(options, argument):
    with pytest.raises(netmesh.errors.InvalidArgument) as error:
        netmesh.persist_all(clouds(), **options)
    assert error.value.argument == argument


@pytest.mark.parametrize("given", [np.zeros((5, 2)), 3])
def test_one_cloud_is_no_list_of_clouds(given):
    with pytest.raises(netmesh.errors.InvalidArgument) as error:
        netmesh.persist_all(given)
    assert error.value.argument == "clouds"


def test_an_array_of_three_axes_is_clouds():
    many = np.random.default_rng(1).normal(size=(4, 30, 2))
    assert netmesh.persist_all(many) == [netmesh.persist(cloud) for cloud in many]


class Sees:
    """An executor that keeps what it is given."""

    def __init__(self):
        self.given = []

    def submit(self, function, cloud, options):
        self.given.append(cloud)
        future = concurrent.futures.Future()
        future.set_result(function(pickle.loads(pickle.dumps(cloud)), options))
        return future


def test_memmaps_go_by_name(tmp_path):
    stored = np.random.default_rng(1).normal(size=(6, 400, 3))
    np.save(tmp_path / "many.npy", stored)
    np.asfortranarray(stored[0]).astype(np.float32).tofile(tmp_path / "raw")
    many = np.load(tmp_path / "many.npy", mmap_mode="r")
    parts = [many[0], many[3][10:], many[4][::2], many[5][:, :2],
             np.memmap(tmp_path / "raw", np.float32, "r", offset=12, shape=(300, 2), order="F")]
    seen = Sees()
    assert netmesh.persist_all(parts, executor=seen) == [netmesh.persist(np.array(part)) for part in parts]
    assert all(isinstance(cloud, _clouds._Mapped) and len(pickle.dumps(cloud)) < 1000 for cloud in seen.given)
    # What the file does not hold goes as it is.
    changed = np.load(tmp_path / "many.npy", mmap_mode="c")
    changed[1] += 1
    others = [changed[1], np.array(many[2]).view(np.memmap), many[2] + 0.0, many[1][::-1]]
    seen = Sees()
    assert netmesh.persist_all(others, executor=seen) == [netmesh.persist(np.array(part)) for part in others]
    assert not any(isinstance(cloud, _clouds._Mapped) for cloud in seen.given)


def test_clouds_are_read_little_ahead(monkeypatch):
    monkeypatch.setattr(_clouds, "_AHEAD", 3)
    read = []

    def endless():
        for i in range(100):
            read.append(i)
            yield np.full((5, 2), np.nan) if i == 2 else clouds()[0]

    with concurrent.futures.ThreadPoolExecutor(1) as executor:
        with pytest.raises(netmesh.errors.NotFinite):
            netmesh.persist_all(endless(), executor=executor)
    assert len(read) <= 8
