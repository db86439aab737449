"""How calls behave: interrupts, progress, threads, memory and what a call costs beside the engine's own."""
import gc
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import netmesh
from netmesh import errors

from conftest import ROOT, needs_proc, uniform

LARGE = 60000  # points in space that take seconds


def resident_bytes():
    needs_proc()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def slow_calls():
    points = uniform(3, 200)
    many = np.random.default_rng(1).random((LARGE, 3))
    more = np.random.default_rng(3).random((8 * LARGE, 3))
    cloud = np.random.default_rng(2).random((900, 3))
    return {
        "alpha": lambda **options: netmesh.persist(many, "alpha", **options),
        "complete": lambda **options: netmesh.persist(many, "complete", **options),
        "delaunay": lambda **options: netmesh.delaunay(more, **options),
        "mesh": lambda **options: netmesh.mesh(many, **options),
        "rips": lambda **options: netmesh.rips(cloud, max_degree=2, **options),
        "rips by threshold": lambda **options: netmesh.rips(cloud, 0.3, max_degree=2, **options),
        "cech": lambda **options: netmesh.persist(points, "cech", 2, **options),
        "function": lambda **options: netmesh.persist(
            many, "function", function=lambda x: abs(x[0]), lipschitz=1, cut=1, **options),
        "bottleneck": lambda **_: netmesh.bottleneck(np.sort(many[:, :2]), np.sort(many[::-1, 1:])),
    }


def interrupted(call, after=0.25):
    """Seconds from the signal to the exception: of the processor in this process, and by the clock. What else runs on
    the machine makes only the second longer."""
    sent = []

    def send():
        sent.extend((time.process_time(), time.monotonic()))
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(after, send)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            call()
        return time.process_time() - sent[0], time.monotonic() - sent[1]
    finally:
        timer.cancel()


def least_wait(call):
    """Of up to five the least seconds of the processor; says what the clock has said."""
    best = float("inf"), float("inf")
    for _ in range(5):
        best = min(best, interrupted(call))
        if best[0] < 0.3:
            break
    print("%.3f s, by the clock %.3f s" % best)
    return best[0]


@pytest.mark.parametrize("name", list(slow_calls()))
def test_interrupt(name):
    assert least_wait(slow_calls()[name]) < 0.3
    # Nothing is left over.
    assert len(netmesh.persist(uniform(2, 30))) > 0


@pytest.mark.parametrize("name", ["complete", "rips"])
def test_interrupt_with_progress(name):
    seen = []
    assert least_wait(lambda: slow_calls()[name](progress=lambda *now: seen.append(now))) < 0.3
    assert len(seen) >= 2
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_handler_that_raises_something_else():
    """Timeouts work by other signals."""
    class Late(Exception):
        pass

    def handle(*_):
        raise Late

    previous = signal.signal(signal.SIGALRM, handle)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        call = slow_calls()["complete"]
        begin = time.process_time()
        with pytest.raises(Late):
            call()
        assert time.process_time() - begin < 0.5
    finally:
        signal.signal(signal.SIGALRM, previous)


def test_a_handler_that_does_not_raise():
    seen = []
    previous = signal.signal(signal.SIGINT, lambda *_: seen.append(1))
    try:
        threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
        points = np.random.default_rng(1).random((8000, 3))
        due = netmesh.persist(points).fingerprint
        assert netmesh.persist(points, progress=lambda *_: None).fingerprint == due
        while not seen:
            time.sleep(0.01)
    finally:
        signal.signal(signal.SIGINT, previous)


def test_progress():
    seen = []
    diagram = netmesh.persist(np.random.default_rng(1).random((20000, 3)), progress=lambda *now: seen.append(now))
    assert len(diagram) > 20000
    stages = [stage for stage, *_ in seen]
    assert "delaunay" in stages or "sort" in stages
    assert all(done <= total or total == 0 for _, done, total, _, _ in seen)


def test_progress_by_tqdm(capsys):
    pytest.importorskip("tqdm")
    points = np.random.default_rng(1).random((8000, 3))
    assert netmesh.persist(points, progress=True).fingerprint == netmesh.persist(points).fingerprint
    shown = capsys.readouterr().err
    assert "it/s" in shown and ("delaunay" in shown or "sort" in shown)


def test_progress_without_tqdm(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    with pytest.raises(errors.InvalidArgument) as caught:
        netmesh.persist(uniform(2, 30), progress=True)
    assert caught.value.argument == "progress" and "tqdm" in str(caught.value)


def test_other_threads_run():
    """The interpreter's lock is free while a job runs, so two jobs and Python itself go on side by side."""
    points = np.random.default_rng(1).random((20000, 3))
    due = netmesh.persist(points).fingerprint
    found, turns, end = [], [0], []

    def count():
        while not end:
            turns[0] += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    workers = [threading.Thread(target=lambda: found.append(netmesh.persist(points).fingerprint)) for _ in range(2)]
    counter.start()
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    end.append(True)
    counter.join()
    assert found == [due, due] and turns[0] > 20


def test_one_thread_at_a_time_in_a_mesh():
    with netmesh.mesh(np.random.default_rng(1).random((20000, 3)), purpose="persist") as made:
        entered = threading.Event()
        worker = threading.Thread(target=lambda: made.persist(progress=lambda *_: entered.set()))
        worker.start()
        assert entered.wait(10)
        for call in (made.persist, lambda: made.cells, made.check, made.close):
            with pytest.raises(errors.NoResult):
                call()
        worker.join()
        assert len(made.values) == len(made.vertices)


def test_nothing_leaks():
    """Resident memory stays where it is over 1,000 calls of each kind, failures among them."""
    small, space = uniform(2, 30), uniform(3, 40)
    bad = small.copy()
    bad[3, 1] = np.nan

    def failing():
        with pytest.raises(errors.NotFinite):
            netmesh.persist(bad)

    def failing_function():
        with pytest.raises(ZeroDivisionError):
            netmesh.persist(small, "function", function=lambda x: 1 / 0, lipschitz=1, cut=1)

    calls = [lambda: netmesh.persist(space, representatives=True, bounds=True),
             lambda: netmesh.persist(small, "complete", progress=lambda *_: None), lambda: netmesh.mesh(space).cells,
             lambda: netmesh.persist(small, "function", function=lambda x: abs(x[0]), lipschitz=1, cut=1),
             lambda: netmesh.rips(small, 0.4).report, lambda: netmesh.bottleneck([[0, 1]], [[0.5, 1]]), failing,
             failing_function, lambda: netmesh.persist(small, memory="1M")]
    for call in calls:
        for _ in range(50):
            call()
    gc.collect()
    for call in calls:
        call()
        before = resident_bytes()
        for _ in range(1000):
            call()
        gc.collect()
        assert resident_bytes() - before < 1 << 20


def test_large_blocks_are_given_back():
    before = resident_bytes()
    for _ in range(3):
        netmesh.persist(np.random.default_rng(1).random((20000, 3)))
    gc.collect()
    assert resident_bytes() - before < 8 << 20


def test_limited_address_space():
    """A limit on address space: what is reserved is less, the result the same; where it does not fit, MemoryError."""
    needs_proc()
    program = (
        "import resource, sys; sys.path[:0] = [%r, %r]\n"
        "import numpy as np, netmesh\n"
        "points = np.random.default_rng(1).random((3000, 3))\n"
        "due = netmesh.persist(points).fingerprint\n"
        "now = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()\n"
        "resource.setrlimit(resource.RLIMIT_AS, (now + (400 << 20), now + (400 << 20)))\n"
        "assert netmesh.persist(points).fingerprint == due\n"
        "resource.setrlimit(resource.RLIMIT_AS, (now + (64 << 20), now + (400 << 20)))\n"
        "try: netmesh.persist(np.random.default_rng(1).random((200000, 3)))\n"
        "except MemoryError as error: print(error)\n" % (os.path.join(ROOT, "platform", "python"), ROOT))
    said = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, check=True).stdout.decode()
    assert "bytes" in said or "memory" in said.lower()


@pytest.mark.parametrize("n", [10, 20000])
def test_results_are_those_of_a_program_in_c(n, tmp_path):
    """tests/python/plain.c: the same jobs in C. `bench.py --overhead` compares their times."""
    program = os.environ.get("NETMESH_PLAIN")
    if not program:
        pytest.skip("NETMESH_PLAIN, the program in C, is not given")
    points = np.random.default_rng(1).random((n, 3))
    path = os.path.join(str(tmp_path), "points")
    points.tofile(path)
    words = subprocess.run([program, path, "3", "1"], stdout=subprocess.PIPE, check=True).stdout.decode().split()
    theirs = dict(zip(words[::3], words[1::3]))
    assert netmesh.persist(points, "alpha").fingerprint == theirs["alpha"]
    with netmesh.delaunay(points) as made:
        assert made.fingerprint == theirs["delaunay"]
