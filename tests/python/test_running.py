# SPDX-License-Identifier: GPL-3.0-or-later
"""How computations run: threads, Ctrl-C, progress, memory, and what a call costs."""

import ctypes
import gc
import multiprocessing
import os
import signal
import statistics
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import SOURCE

import hdconj

UNDER_SANITIZER = "HDCONJ_SANITIZED" in os.environ
INTERRUPT_SECONDS = (2.0 if UNDER_SANITIZER else 0.2) * (os.cpu_count() or 1)
"""Processor time of all threads from Ctrl-C to its exception; other programs do not add to it."""


class Heap(ctypes.Structure):
    """What mallinfo2 of glibc tells of the heap [bytes]."""

    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost"
    )]  # fmt: skip


def in_use():
    """Bytes of the heap that are in use, and blocks of Python's own allocator."""
    gc.collect()
    mallinfo = ctypes.CDLL(None).mallinfo2
    mallinfo.restype = Heap
    heap = mallinfo()
    return heap.uordblks + heap.hblkhd, sys.getallocatedblocks()


def resident_mb():
    with open("/proc/self/statm") as status:
        return int(status.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20


def test_no_leak():
    """Neither heap nor objects of Python grow; HDCONJ_FULL looks at the memory of ten times as many calls too."""
    scene = hdconj.Scene().with_({"solver.threads": 1, "solver.tolerance": 1e-3})
    rounds = 10_000 if "HDCONJ_FULL" in os.environ else 1000
    rounds = 300 if UNDER_SANITIZER else rounds

    def work(count):
        for _ in range(count):
            assert hdconj.solve(scene).circular_spline.outline.size > 0

    work(rounds // 10)
    resident, heap, blocks = resident_mb(), *in_use()
    work(rounds)
    after = in_use()
    assert UNDER_SANITIZER or after[0] - heap < 20_000
    assert UNDER_SANITIZER or after[1] - blocks < 100
    assert rounds < 10_000 or resident_mb() - resident < 1


def test_arrays_outlive_their_result():
    array = hdconj.solve().envelope.branch_000.point
    copy = array.tobytes()
    for _ in range(50):
        hdconj.solve()
    assert array.tobytes() == copy
    with pytest.raises(ValueError):
        array[0] = 0


@pytest.mark.skipif(UNDER_SANITIZER, reason="the sanitizer takes its own time")
def test_a_call_costs_a_fortieth_of_a_solve_at_most():
    """50 us where the built-in drive takes 2 ms on one thread. Other programs and cold memory only add to a round."""
    scene = hdconj.Scene().with_({"solver.threads": 1})

    def overhead():
        begin = time.perf_counter()
        solution = hdconj.solve(scene)
        return (time.perf_counter() - begin) / solution.wall_seconds - 1

    assert any(statistics.median(overhead() for _ in range(200)) < 1 / 40 for _ in range(5))


def test_eight_threads_at_once_give_the_same_bits():
    scenes = [hdconj.Scene().with_({"wave_generator.radial_deformation": 0.25 + 0.001 * i}) for i in range(4)]
    expected = [hdconj.solve(scene).circular_spline.outline.tobytes() for scene in scenes]

    def work(number):
        return [hdconj.solve(scenes[(number + i) % 4]).circular_spline.outline.tobytes() for i in range(8)]

    with ThreadPoolExecutor(8) as pool:
        for number, found in enumerate(pool.map(work, range(8))):
            assert found == [expected[(number + i) % 4] for i in range(8)]


def areas_of_contact(scene):
    return hdconj.contact(scene, errors=False).contact.contact_area.tolist()


@pytest.mark.skipif(UNDER_SANITIZER, reason="a sanitizer has threads of its own, which a fork loses")
def test_a_fork_computes_on_one_thread_what_its_parent_computed_on_several(coned):
    """A copy of a process has none of its threads, and would wait for them for ever."""
    scene = coned.with_({"solver.threads": 2})
    expected = areas_of_contact(scene)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(areas_of_contact, [scene, scene]).get(timeout=60) == [expected, expected]


def test_the_lock_is_released():
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    hdconj.load(hdconj.Scene().with_({"slices.count": 3}), curve=False)
    done.set()
    other.join()
    assert counted > 20


CONED = SOURCE / "data/scenes/type-50-coned.toml"
WANTED = SOURCE / "data/scenes/type-50-wanted.toml"
FINE_CUT = {"solver.tolerance": 1e-10, "wedm.tolerance": 1e-5, "wedm.decimals": 6}
LONG_WORK = {
    "load": lambda: hdconj.load(points=300),
    "contact": lambda: hdconj.contact(CONED, tilts_deg=[0.01 * i for i in range(99)]),
    "accuracy": lambda: hdconj.accuracy(),
    "wedm": lambda: [hdconj.wedm(hdconj.Scene().with_(FINE_CUT)) for _ in range(20)],
    "neutral curve": lambda: [hdconj.find_neutral_curve(WANTED) for _ in range(20)],
    "design": lambda: [hdconj.design(100, diameter=50, torque=28) for _ in range(20)],
}


@pytest.mark.parametrize("work", LONG_WORK)
@pytest.mark.parametrize("delay", [0.05, 0.4, 1.0])
def test_ctrl_c(work, delay):
    asked = []

    def interrupt():
        asked.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(delay, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        LONG_WORK[work]()
    taken = time.process_time() - asked[0]
    timer.join()
    assert taken < INTERRUPT_SECONDS
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert hdconj.solve().circular_spline.outline.size > 0  # nothing is left of it


def test_ctrl_c_in_other_threads():
    asked = []

    def interrupt():
        asked.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.5, interrupt)
    with ThreadPoolExecutor(2) as pool:
        timer.start()
        long = [pool.submit(LONG_WORK[name]) for name in ("contact", "load")]
        with pytest.raises(KeyboardInterrupt):
            long[0].result()
    taken = time.process_time() - asked[0]
    timer.join()
    assert all(isinstance(each.exception(), hdconj.StoppedError) for each in long)
    assert taken < INTERRUPT_SECONDS
    with ThreadPoolExecutor(2) as pool:  # nothing is left of it
        assert all(result.circular_spline.outline.size for result in pool.map(hdconj.solve, [None, None]))


def test_progress_by_function():
    told = []
    hdconj.contact(
        hdconj.Scene().with_({"slices.count": 3, "contact.flank_points": 40}),
        progress=lambda what, share: told.append((what, share)),
    )
    assert "envelope" in [what for what, _ in told]
    shares = [share for _, share in told if share is not None]
    assert shares == sorted(shares) and all(0 <= share <= 1 for share in shares)


def test_a_failing_observer_ends_the_computation():
    def refuse(what, share):
        raise LookupError(what)

    with pytest.raises(LookupError):
        hdconj.load(progress=refuse)


def test_progress_by_tqdm(capsys):
    pytest.importorskip("tqdm")
    hdconj.solve(progress=True)
    assert "outline" in capsys.readouterr().err
