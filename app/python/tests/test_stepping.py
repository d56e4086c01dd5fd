"""Runs, moments and pages."""
import os
import signal
import threading
import time

import numpy as np
import pytest

import forefront as ff


def test_moments_show_the_front(rectangle):
    run = ff.run(rectangle, 0.5, method="classic")
    moments = list(run)
    assert [moment.position for moment in moments] == list(range(1, len(moments) + 1))
    assert run.at_end and len(moments[-1].front) == 0
    first = moments[0]
    assert first.front.shape[1:] == (2, 2) and first.base.shape == (2, 2)
    assert any(candidate["verdict"] == "accepted" for candidate in first.candidates)
    assert len(first.made) == 1 and first.made[0].shape == (3, 2) and "accepted" in first.caption
    # Each segment of a front starts where another ends.
    starts = {tuple(segment[0]) for segment in first.front}
    assert starts == {tuple(segment[1]) for segment in first.front}
    assert run.finish().hash == ff.mesh(rectangle, 0.5, method="classic").hash


def test_back_and_forth_gives_the_same_state(rectangle):
    run = ff.run(rectangle, 0.5, method="classic")
    assert run.explanation() is None
    with pytest.raises(ValueError, match="has not advanced"):
        run.moment()
    assert run.advance(10) == 10
    front = run.front
    assert run.advance(5) == 5 and run.retreat(5) == 5 and run.position == 10
    assert np.array_equal(run.front, front)
    run.seek(3)
    assert run.position == 3 and run.mesh.element_count == 3
    assert run.retreat(10) == 3


def test_ctrl_c_stops_a_move_and_the_run_goes_on(rectangle):
    run = ff.run(rectangle, 0.02)
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.1, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        while True:
            run.advance(10**12)
            run.retreat(10**12)
    assert time.monotonic() - sent[0] < 1.0
    timer.join()
    run.seek(0)
    assert run.advance(10) == 10 and run.mesh.element_count >= 10
    assert run.finish().hash == ff.mesh(rectangle, 0.02).hash


def test_a_run_of_quadrilaterals_steps_forward_and_back(rectangle):
    run = ff.run(rectangle, 0.5, elements="quads")
    assert run.advance(12) == 12
    front, elements = run.front, run.mesh.element_count
    assert run.advance(8) == 8 and run.retreat(8) == 8 and run.position == 12
    assert np.array_equal(run.front, front) and run.mesh.element_count == elements
    run.advance(1)
    assert "square" in run.explanation()["caption"]
    advances = run.trace()["advances"]
    assert {advance["square"] for advance in advances} == {"row", "closing", "half"}
    assert tuple(advances[12]["base"]["nodes"]) == run.explanation()["base_nodes"]


def test_a_page_plays_the_run(rectangle):
    page = ff.run(rectangle, 0.7, method="classic").page(title="Tank")
    assert page.lstrip().lower().startswith("<!doctype html") and "Tank" in page and "http://" not in page.replace(
        "http://www.w3.org", "")
    assert "<svg" in ff.run(rectangle, 0.7)._repr_svg_()


def test_films_traces_and_notebooks(rectangle, tmp_path):
    run = ff.run(rectangle, 0.7, method="classic")
    assert run.film(tmp_path / "run.gif", frames=5, width=120) == 5
    assert (tmp_path / "run.gif").read_bytes()[:6] == b"GIF89a"
    assert run.film(tmp_path / "run-%d.svg", frames=3, layers=["mesh", "front"]) == 3
    assert sorted(path.name for path in tmp_path.glob("run-*.svg")) == ["run-1.svg", "run-2.svg", "run-3.svg"]
    with pytest.raises(ValueError, match="layers: expected mesh"):
        run.film(tmp_path / "run.gif", layers=["sky"])
    trace = run.trace()
    assert len(trace["advances"]) == len(list(run))
    assert len(run.trace(steps=4)["advances"]) == 4
    assert run._repr_html_().startswith("<iframe srcdoc=")
