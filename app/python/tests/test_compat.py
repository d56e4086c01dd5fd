"""forefront.compat.triangle."""
import numpy as np
import pytest

import forefront as ff
import forefront.compat.triangle as tr


def box(x0, y0, x1, y1):
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def loops(count):
    return [[4 * k + i, 4 * k + (i + 1) % 4] for k in range(count) for i in range(4)]


def angles_and_areas(result):
    corner = result["vertices"][result["triangles"]]
    least = np.full(len(corner), 180.0)
    for k in range(3):
        u, v = (corner[:, (k + j) % 3] - corner[:, k] for j in (1, 2))
        area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        least = np.minimum(least, np.degrees(np.arctan2(area, (u * v).sum(axis=1))))
    return least, 0.5 * area


def test_keys_and_order():
    square = {"vertices": box(0, 0, 1, 1), "segments": loops(1), "vertex_markers": [[5], [0], [0], [0]]}
    result = tr.triangulate(square, "pq30a0.01zne")
    assert set(result) == {"vertices", "vertex_markers", "triangles", "segments", "segment_markers", "neighbors",
                           "edges", "edge_markers"}
    assert result["vertices"][:4].tolist() == square["vertices"]
    least, areas = angles_and_areas(result)
    assert least.min() >= 30.0 and areas.max() <= 0.01 and areas.min() > 0.0
    assert areas.sum() == pytest.approx(1.0)
    assert result["vertex_markers"][0, 0] == 5
    n, t, e = len(result["vertices"]), len(result["triangles"]), len(result["edges"])
    assert n - e + t == 1
    assert np.count_nonzero(result["edge_markers"]) == len(result["segments"])
    for element, row in enumerate(result["neighbors"]):
        for k, other in enumerate(row):
            if other >= 0:
                opposite = set(result["triangles"][element]) - {result["triangles"][element][k]}
                assert opposite <= set(result["triangles"][other])


def test_holes_markers_and_loose_vertices():
    inner = [[2, 2], [0.5, 0.5]]  # one in the hole, one inside the domain
    graph = {"vertices": box(0, 0, 4, 4) + box(1, 1, 3, 3) + inner, "segments": loops(2), "holes": [[2, 2.1]],
             "segment_markers": [-1] * 4 + [7] * 4}
    result = tr.triangulate(graph, "pq")
    assert angles_and_areas(result)[1].sum() == pytest.approx(12.0)
    assert set(result["segment_markers"].ravel()) == {-1, 7}
    assert 8 not in result["triangles"] and 9 in result["triangles"]
    assert result["vertices"][:10].tolist() == graph["vertices"]


def test_the_convex_hull_without_p():
    points = np.random.default_rng(2).random((40, 2))
    result = tr.triangulate({"vertices": points}, "")
    assert np.array_equal(result["vertices"][:40], points)
    assert set(range(40)) <= set(result["triangles"].ravel())


def test_areas_of_regions_are_held():
    """The case that ANUGA asks for: nested regions with the areas 1000, 100, 36 and 8, and angles above 30 degrees."""
    graph = {"vertices": box(0, 0, 1000, 800) + box(150, 150, 850, 650) + box(300, 250, 700, 550)
             + box(420, 330, 580, 470), "segments": loops(4),
             "regions": [[10, 10, 1, 1000], [160, 160, 2, 100], [310, 260, 3, 36], [430, 340, 4, 8]]}
    result = tr.triangulate(graph, "pzq30aA")
    least, areas = angles_and_areas(result)
    attribute = result["triangle_attributes"].ravel()
    assert least.min() >= 30.0
    needed = 0.0
    for _, _, number, limit in graph["regions"]:
        assert areas[attribute == number].max() <= limit
        needed += areas[attribute == number].sum() / limit
    assert len(areas) < 2.2 * needed
    assert len(areas) < 1.3 * 14006  # elements of Triangle 1.6


def test_a_least_angle_takes_no_more_elements_than_in_triangle():
    """A coast whose segments differ in length by a factor of ten: Triangle 1.6 makes 2246 elements with -pq30."""
    turn = 2 * np.pi * np.arange(600) / 600
    reach = 10 + 2 * np.sin(3 * turn) + 0.3 * np.sin(40 * turn) * (turn > 3) + 0.1 * (np.arange(600) ** 2 % 7)
    coast = {"vertices": np.column_stack([reach * np.cos(turn), reach * np.sin(turn)]),
             "segments": np.column_stack([np.arange(600), (np.arange(600) + 1) % 600])}
    result = tr.triangulate(coast, "pq30")
    assert angles_and_areas(result)[0].min() >= 30.0
    assert len(result["triangles"]) <= 2246


def test_faults_have_places():
    with pytest.raises(ff.MeshError) as caught:
        tr.triangulate({"vertices": box(0, 0, 1, 1) + [[1, 0]], "segments": loops(1)}, "p")
    assert caught.value.faults[0].at == (1.0, 0.0)
    crossed = {"vertices": box(0, 0, 1, 1), "segments": [[0, 2], [2, 1], [1, 3], [3, 0]]}
    with pytest.raises(ff.MeshError) as caught:
        tr.triangulate(crossed, "pq")
    assert caught.value.faults[0].at == (0.5, 0.5)
    square = {"vertices": box(0, 0, 1, 1), "segments": loops(1)}
    for switches, message in (("pr", "unknown switches r"), ("pq40", "from 0 to 33 degrees"), ("pa0", "positive area")):
        with pytest.raises(ValueError, match=message):
            tr.triangulate(square, switches)


def test_elements_at_a_sharp_corner_of_the_input_may_be_sharp():
    wedge = {"vertices": [[0, 0], [4, 0], [4, 1.9]], "segments": [[0, 1], [1, 2], [2, 0]]}
    result = tr.triangulate(wedge, "pq30")
    least, _ = angles_and_areas(result)
    at_corner = np.any(result["triangles"] == 0, axis=1)
    assert np.all(least[~at_corner] >= 30.0) and least[at_corner].min() == pytest.approx(25.4, abs=0.1)


def test_an_angle_is_kept_but_at_sharp_corners():
    result = tr.triangulate({"vertices": [[0, 0], [4, 0], [4, 0.4]], "segments": [[0, 1], [1, 2], [2, 0]]}, "pq30")
    least, _ = angles_and_areas(result)
    sharp = result["triangles"][least < 30.0]
    assert len(sharp) == 1 and 0 in sharp[0]


def test_segments_without_markers_have_0_inside_and_1_on_the_boundary():
    graph = {"vertices": box(0, 0, 4, 4) + box(1, 1, 2, 2), "segments": loops(2)}
    for markers in ({}, {"segment_markers": [0] * 8}):
        result = tr.triangulate({**graph, **markers}, "pq30e")
        places = result["vertices"]
        outside = np.any((places == 0) | (places == 4), axis=1)
        assert np.array_equal(result["vertex_markers"].ravel() == 1, outside)
        ends = outside[result["segments"]].all(axis=1)
        assert np.array_equal(result["segment_markers"].ravel(), ends.astype(int)) and not ends.all()
    kept = tr.triangulate({**graph, "segment_markers": [0] * 4 + [5] * 4}, "p")
    assert sorted(set(kept["segment_markers"].ravel())) == [1, 5]
    with pytest.raises(ValueError, match="vertex_attributes"):
        tr.triangulate({**graph, "vertex_attributes": np.zeros((8, 1))}, "p")


@pytest.mark.parametrize("given, switches, message", [
    ({}, "p", "^vertices: they are missing"),
    ({"vertices": [(0, 0), (1, 0), (0, 1)]}, "p", "^segments: the switch p needs them"),
    ({"vertices": [(0, 0), (1, 0), (np.nan, 1)]}, "", r"^vertices\[2\]: expected finite coordinates, got \(nan, 1\)"),
    ({"vertices": [(0, 0), (1, 0)]}, "", "at least three that are not on one line"),
    ({"vertices": [(0, 0), (1, 1), (2, 2)]}, "", "at least three that are not on one line")])
def test_vertices_that_span_nothing_are_told(given, switches, message):
    with pytest.raises(ValueError, match=message):
        tr.triangulate(given, switches)
