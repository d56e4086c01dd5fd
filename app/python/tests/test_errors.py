"""Faults with places, and exceptions of callbacks."""
import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import forefront as ff


def test_crossing_segments_have_a_place(bow_tie):
    with pytest.raises(ff.MeshError) as caught:
        ff.mesh(bow_tie, 0.1)
    fault = caught.value.faults[0]
    assert fault.code == "crossing-segments" and fault.at == (0.5, 0.5) and fault.severity == "error"
    assert [kind for kind, _ in fault.parts] == ["segment", "segment"] and fault.advice
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.faults[0].at == (0.5, 0.5)


def test_repeated_vertices_are_refused_with_places():
    with pytest.raises(ff.MeshError) as caught:
        ff.mesh([(0, 0), (1, 0), (1, 0), (1, 1)], 0.1)
    assert caught.value.faults[0].at == (1.0, 0.0)
    for empty in ([], [(0, 0)], [(0, 0), (1, 1)], [(0, 0), (np.nan, 1), (1, 1)]):
        with pytest.raises(ff.MeshError):
            ff.mesh(empty, 0.1)


def test_sizes_that_are_not_positive_are_refused(rectangle):
    for size in (-1.0, 0.0, float("nan"), "x-1", "x+", lambda x, y: x - 1):
        with pytest.raises(ff.MeshError):
            ff.mesh(rectangle, size)
    with pytest.raises(TypeError, match="size: expected a number"):
        ff.mesh(rectangle, [0.1])


def test_an_exception_of_the_size_function_arrives_unchanged(rectangle):
    error = ZeroDivisionError("mine")

    def size(x, y):
        raise error

    for exact in (False, True):
        with pytest.raises(ZeroDivisionError) as caught:
            ff.mesh(rectangle, size, exact=exact)
        assert caught.value is error
    with pytest.raises(ValueError, match="one value for each of the"):
        ff.mesh(rectangle, lambda x, y: x[1:])
    assert ff.mesh(rectangle, 0.5).element_count > 0


def test_progress_is_reported_and_cancels(rectangle):
    stages, threads = [], set()

    def note(stage, fraction):
        assert 0.0 <= fraction <= 1.0
        stages.append(stage)
        threads.add(threading.get_ident())

    ff.mesh(rectangle, 0.01, progress=note)
    assert len(set(stages)) >= 3 and threads == {threading.get_ident()}

    class Stop(Exception):
        pass

    def stop(stage, fraction):
        if stage == stages[-1]:
            raise Stop

    with pytest.raises(Stop):
        ff.mesh(rectangle, 0.01, progress=stop)
    with pytest.raises(TypeError, match="progress: expected a function"):
        ff.mesh(rectangle, 0.5, progress=3)


def test_ctrl_c_ends_a_long_run_quickly(rectangle):
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.2, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        ff.mesh(rectangle, 0.0007)
    assert time.monotonic() - sent[0] < 1.0  # 0.03 s on an idle machine
    timer.join()


def test_threads_mesh_at_the_same_time_with_the_lock_free(rectangle):
    hashes = []
    workers = [threading.Thread(target=lambda: hashes.append(ff.mesh(rectangle, 0.008).hash)) for _ in range(4)]
    for worker in workers:
        worker.start()
    ticks = 0
    while any(worker.is_alive() for worker in workers):
        time.sleep(0.001)
        ticks += 1
    assert len(hashes) == 4 and len(set(hashes)) == 1
    assert ticks > 20


def test_callbacks_from_several_threads(rectangle):
    results = []

    def work():
        results.append(ff.mesh(rectangle, lambda x, y: 0.05 + 0.02 * x, progress=lambda stage, part: None).hash)

    workers = [threading.Thread(target=work) for _ in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(results) == 4 and len(set(results)) == 1


def test_size_functions_are_called_with_many_points(rectangle):
    calls = []

    def smooth(x, y):
        calls.append(len(x))
        return 0.02 + 0.1 * np.hypot(x - 1, y - 1)

    sampled = ff.mesh(rectangle, smooth)
    assert len(calls) <= 5
    exact = ff.mesh(rectangle, smooth, exact=True)
    assert len(calls) > 100
    assert sampled.element_count == pytest.approx(exact.element_count, rel=0.02)
    assert ff.mesh(rectangle, lambda x, y: 0.2).element_count == pytest.approx(
        ff.mesh(rectangle, 0.2).element_count, rel=0.05)


def test_a_detail_between_the_places_of_the_grid_is_not_lost(rectangle):
    def pit(x, y):
        return np.where(np.hypot(x - 1.0031, y - 1.0077) < 0.03, 0.01, 0.5)

    mesh = ff.mesh(rectangle, pit)
    centre = mesh.nodes[mesh.elements].mean(axis=1)
    inside = np.hypot(*(centre - (1.0031, 1.0077)).T) < 0.02
    assert inside.sum() > 5 and mesh.quality("area")[inside].max() < 0.001


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_field_that_is_not_finite_is_refused_with_its_place(bad):
    mesh = ff.mesh([(0, 0), (1, 0), (1, 1), (0, 1)], 0.2)
    values = np.sin(mesh.nodes[:, 0])
    values[7] = bad
    with pytest.raises(ff.MeshError, match="not finite") as caught:
        ff.adapt(mesh, values, 0.1)
    assert caught.value.faults[0].at == tuple(mesh.nodes[7])
