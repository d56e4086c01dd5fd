"""The least angle is a promise: reached everywhere, or the places that force less are named, or the run fails."""
from pathlib import Path

import numpy as np
import pytest

import forefront as ff

SAMPLES = sorted((Path(__file__).resolve().parents[3] / "assets" / "samples").glob("*.json"))
OUTER = [(0, 0), (4, 0), (4, 2), (0, 2)]


def _check_promise(mesh, angle):
    """Checks that each element with a smaller angle lies in a place that the run names."""
    forced = mesh.summary()["least_angle"]["forced"]
    notes = [note for note in mesh.notes if note.code == "forced-angle"]
    assert sorted(note.at for note in notes) == sorted((place["x"], place["y"]) for place in forced)
    sharp = np.flatnonzero(mesh.quality("min-angle") < angle * (1 - 1e-9))
    assert len(sharp) == sum(place["elements"] for place in forced)
    for element in sharp:
        centre = mesh.nodes[mesh.elements[element]].mean(axis=0)
        assert any(np.hypot(place["x"] - centre[0], place["y"] - centre[1]) <= place["reach"] + 1e-9 * (1 + np.abs(centre).max())
                   for place in forced)
    return forced


def _has_layers(sample):
    return '"layers"' in sample.read_text()


def test_samples_reach_30_degrees_or_name_the_places():
    assert len(SAMPLES) >= 20 and 0 < sum(map(_has_layers, SAMPLES)) < 5
    reached = 0
    for sample in SAMPLES:
        try:
            mesh = ff.mesh(sample, elements="triangles", min_angle=30)
        except ff.MeshError as error:
            assert _has_layers(sample) and "beside boundary layers" in str(error), sample.name
            continue
        reached += not _check_promise(mesh, 30)
    assert reached >= len(SAMPLES) - 6  # the corners of the dam are sharper


def _gap(width):
    """A plate whose hole leaves a gap of a width over the lower side, from x = 1 to 3."""
    return [OUTER, [(1, width), (3, width), (3, 1), (1, 1)]]


def test_gaps_are_refined_unless_their_sides_must_stay():
    assert _check_promise(ff.mesh(_gap(0.01), 0.3, min_angle=30), 30) == []
    kept = _check_promise(ff.mesh(_gap(0.01), 0.3, min_angle=30, keep_boundary=True), 30)
    assert {place["by"] for place in kept} == {"kept-edge"}
    assert any(place["y"] < 0.01 and place["angle"] < 1 for place in kept)


def test_a_run_that_would_take_too_many_elements_says_where():
    with pytest.raises(ff.MeshError, match="a least angle of 30° needs more than [0-9]+ elements") as caught:
        ff.mesh(_gap(1e-4), 0.3, min_angle=30, max_elements=2000)
    fault, = caught.value.faults
    assert fault.code == "least-angle" and 0.9 < fault.at[0] < 3.1 and -0.1 < fault.at[1] < 0.2
    assert "less narrow" in fault.advice
