"""Domains, sizes and options."""
import json
import os
import subprocess
import time

import numpy as np
import pytest

import forefront as ff


def test_a_loop_becomes_a_mesh_that_covers_it(rectangle, areas):
    mesh = ff.mesh(rectangle, size=0.25)
    assert areas(mesh).sum() == pytest.approx(8.0, rel=1e-12)
    assert areas(mesh).min() > 0.0
    assert mesh.quality("length").mean() == pytest.approx(0.25, rel=0.1)
    assert mesh.check(_domain(rectangle)) == []


def _domain(loop):
    domain = ff.Domain()
    domain.add_loop(loop)
    return domain


def test_an_inner_loop_is_a_hole(rectangle, areas):
    mesh = ff.mesh([rectangle, [(1, 0.5), (2, 0.5), (2, 1.5), (1, 1.5)]], 0.2)
    assert areas(mesh).sum() == pytest.approx(7.0, rel=1e-12)


def test_hash_equals_that_of_the_batch_program(plate, tmp_path):
    program = os.environ.get("FOREFRONT_PROGRAM")
    if not program:
        pytest.skip("FOREFRONT_PROGRAM is not set")
    file = tmp_path / "plate.geojson"
    file.write_text(json.dumps({"type": "Polygon", "coordinates": [[[0, 0], [7, 0], [7, 5], [2, 4], [0, 0]],
                                                                   [[3, 1], [4, 1], [4, 2], [3, 2], [3, 1]]]}))
    statistics = tmp_path / "statistics.json"
    for options, arguments in (({}, []), ({"size": 0.2}, ["--size", "0.2"]),
                               ({"size": "0.1+0.05*x", "method": "classic"},
                                ["--spacing", "0.1+0.05*x", "--method", "classic"]),
                               ({"size": 0.3, "elements": "quads"}, ["--size", "0.3", "--elements", "quads"])):
        subprocess.run([program, "mesh", file, "-o", tmp_path / "plate.msh", "-q", "--stats", statistics, *arguments],
                       check=True)
        expected = json.loads(statistics.read_text())
        mesh = ff.mesh(file, **options)
        assert f"{mesh.hash:016x}" == expected["hash"].removeprefix("0x")
        mine = mesh.summary()
        for figure in ("nodes", "elements", "area", "alpha_min", "delta_mean", "hash", "regions", "boundaries"):
            assert mine[figure] == expected[figure]


def test_names_follow_the_boundary(plate):
    mesh = ff.mesh(plate, 0.2, sizes={"hole": 0.05})
    hole = mesh.nodes[mesh.nodes_of("hole")]
    assert len(hole) == len(mesh.edges_of("hole")) == pytest.approx(2 * np.pi * 0.4 / 0.05, rel=0.1)
    assert np.abs(np.hypot(*(hole - 1).T) - 0.4).max() < 1e-12
    assert np.all(mesh.nodes[mesh.nodes_of("bottom"), 1] == 0.0)
    assert set(mesh.boundary_names.values()) == {"bottom", "right", "top", "left", "hole"}
    with pytest.raises(KeyError, match="expected bottom, hole"):
        mesh.nodes_of("door")


def test_regions_have_names_sizes_and_areas(rectangle, areas):
    domain = _domain(rectangle)
    domain.add_line([(2, 0), (2, 2)], names="wall")
    domain.region((1, 1), "clay")
    domain.region((3, 1), "sand")
    with pytest.raises(ff.MeshError, match="touching-segments"):
        ff.mesh(domain, 0.5)
    assert ff.mesh(domain, 0.5, repair=True).element_count > 0
    domain, _ = domain.repair()
    mesh = ff.mesh(domain, 0.5, regions={"sand": 0.1})
    sand = mesh.elements_of("sand")
    assert areas(mesh)[sand].sum() == pytest.approx(4.0)
    assert np.all(mesh.nodes[mesh.nodes_of("wall"), 0] == 2.0)
    assert areas(mesh)[sand].mean() < 0.3 * areas(mesh)[mesh.elements_of("clay")].mean()
    limited = ff.mesh(domain, max_area={"clay": 0.01})
    assert areas(limited)[limited.elements_of("clay")].max() <= 0.01 * 1.125
    assert areas(ff.mesh(domain, max_area=0.02)).max() <= 0.02 * 1.125
    with pytest.raises(ValueError, match="unknown region 'silt'; expected clay, sand"):
        ff.mesh(domain, regions={"silt": 1})


def test_hole_markers_and_points(rectangle, areas):
    domain = _domain(rectangle)
    domain.add_loop([(1, 0.5), (2, 0.5), (2, 1.5), (1, 1.5)])
    domain.add_loop([(3, 0.5), (3.5, 0.5), (3.5, 1.5), (3, 1.5)])
    domain.hole((1.5, 1))
    domain.add_point((0.5, 1.3), name="gauge", size=0.02)
    mesh = ff.mesh(domain, 0.3)
    assert areas(mesh).sum() == pytest.approx(7.0)
    gauge, = mesh.nodes_of("gauge")
    assert tuple(mesh.nodes[gauge]) == (0.5, 1.3)
    near = np.any(mesh.elements == gauge, axis=1)
    assert areas(mesh)[near].max() < 0.002


def test_sources_limits_and_grids(rectangle, areas):
    def at(mesh, x, y):
        corner = mesh.nodes[mesh.elements].mean(axis=1)
        return np.sqrt(areas(mesh)[np.argmin(np.hypot(*(corner - (x, y)).T))] * 4 / np.sqrt(3))

    for source in (ff.Source.point((1, 1), 0.02), ff.Source.disc((1, 1), 0.1, 0.02),
                   ff.Source.line((1, 0), (1, 2), 0.02), ff.Source.box((0.9, 0.9), (1.1, 1.1), 0.02)):
        mesh = ff.mesh(rectangle, sources=[source])
        assert at(mesh, 1, 1) == pytest.approx(0.02, rel=0.3)
        assert at(mesh, 3.5, 1) > 0.1
    gradient = ff.mesh(rectangle, sources=[ff.Source.gradient((0, 0), (4, 0), 0.05, 0.3)])
    assert at(gradient, 0.05, 1) < 0.08 < 0.2 < at(gradient, 3.8, 1)
    assert ff.mesh(rectangle, 1.0, maximum=0.2).element_count == ff.mesh(rectangle, 0.2).element_count
    grid = ff.Grid(np.full((3, 5), 0.2), pitch=1.0)
    assert ff.mesh(rectangle, grid).element_count == pytest.approx(ff.mesh(rectangle, 0.2).element_count, rel=0.05)
    coarse = ff.mesh(rectangle, 0.5)
    background = ff.Background(coarse.nodes, coarse.elements, np.full(len(coarse.nodes), 0.2))
    assert ff.mesh(rectangle, background).element_count == pytest.approx(ff.mesh(rectangle, 0.2).element_count, rel=0.05)


def test_options_reach_the_mesher(rectangle):
    assert ff.mesh(rectangle, 0.2, threads=2).hash == ff.mesh(rectangle, 0.2).hash
    assert ff.mesh(rectangle, 0.2, improve="none").quality().mean() < ff.mesh(rectangle, 0.2, improve="best").quality().mean()
    quads = ff.mesh(rectangle, 0.2, elements="quads")
    assert quads.elements.shape[1] == 4 and list(quads.blocks) == ["quadrilateral4"]
    split = quads.triangulated()
    assert split.elements.shape == (2 * len(quads.elements), 3) and np.array_equal(split.nodes, quads.nodes)
    assert quads.neighbours.shape == quads.elements.shape
    kept = ff.mesh(rectangle, 0.2, keep_boundary=True)
    assert len(kept.edges) == 4
    wedge = [(0, 0), (10, 0), (10, 0.9)]
    sharp = ff.mesh(wedge, 0.5, min_angle=30)
    assert np.count_nonzero(sharp.quality("min-angle") < 30) == 1 and "sharp corner" in str(sharp.notes[0])
    with pytest.raises(ff.MeshError, match="at most 33"):
        ff.mesh(wedge, 0.5, min_angle=40)
    for option, value in (("method", "slow"), ("improve", "much"), ("elements", "hexagons"), ("grid", "round")):
        with pytest.raises(ValueError, match=f"{option}: expected .*, got '{value}'"):
            ff.mesh(rectangle, 0.2, **{option: value})
    with pytest.raises(TypeError):
        ff.mesh(rectangle, 0.2, colour="red")
    with pytest.raises(ff.MeshError, match="too-many-elements"):
        ff.mesh(rectangle, 0.01, max_elements=1000)


def test_features_with_a_size_in_a_column():
    def square(x, **properties):
        ring = [[x, 0], [x + 1, 0], [x + 1, 1], [x, 1], [x, 0]]
        return {"type": "Feature", "properties": properties, "geometry": {"type": "Polygon", "coordinates": [ring]}}

    class Frame:
        __geo_interface__ = {"type": "FeatureCollection", "features": [square(0, soil="clay", cellsize=0.3),
                                                                       square(1, soil="sand", cellsize=0.1)]}

    mesh = ff.mesh(Frame(), size="cellsize", names="soil")
    assert set(mesh.region_names.values()) >= {"clay", "sand"}
    assert len(mesh.elements_of("sand")) > 2 * len(mesh.elements_of("clay"))
    assert ff.mesh(Frame(), size=0.2, names="soil").region_names == mesh.region_names
    assert ff.Domain.from_shapely(Frame(), names="soil").validate() == []


def test_a_thousand_triangles_take_less_than_5_ms(rectangle):
    loop = np.array(rectangle)
    ff.mesh(loop, 0.13)
    times = []
    for _ in range(10):
        start = time.process_time()
        mesh = ff.mesh(loop, 0.13)
        arrays = mesh.nodes, mesh.elements, mesh.regions, mesh.edges, mesh.edge_tags
        times.append(time.process_time() - start)
    assert len(arrays[1]) > 1000
    assert min(times) < 0.005


def test_repair_reports_what_it_changed(bow_tie, areas):
    domain = _domain(bow_tie)
    assert [fault.code for fault in domain.validate()] == ["crossing-segments"]
    repaired, changes = domain.repair()
    assert changes and repaired.validate() == []
    assert areas(ff.mesh(repaired, 0.1)).sum() == pytest.approx(0.5)


def test_adapting_lowers_the_error(plate):
    coarse = ff.mesh(plate, 0.3)
    by_expression = ff.adapt(coarse, "atan(20*(x-y))", 0.15)
    assert by_expression.met and by_expression.rounds[-1][2] <= 0.15 < by_expression.rounds[0][2]
    assert by_expression.mesh.check(plate) == []
    field = lambda mesh: np.arctan(20 * (mesh.nodes[:, 0] - mesh.nodes[:, 1]))
    by_function = ff.adapt(coarse, field, 0.15)
    assert by_function.rounds[-1][2] <= 0.15
    once = ff.adapt(coarse, field(coarse), 0.15)
    assert len(once.rounds) == 1 and once.mesh.element_count > coarse.element_count
    with pytest.raises(ZeroDivisionError):
        ff.adapt(coarse, lambda mesh: 1 / 0, 0.1)
    with pytest.raises(ValueError, match="one for each of the"):
        ff.adapt(coarse, [1.0, 2.0], 0.1)


def _square(width=2.0, height=1.0):
    domain = ff.Domain()
    domain.add_loop([(0, 0), (width, 0), (width, height), (0, height)], names=["bottom", "right", "top", "left"])
    return domain


def _counts(mesh, region):
    blocks = mesh.blocks
    first, counts = 0, {}
    tag = next(tag for tag, name in mesh.region_names.items() if name == region)
    for kind, elements in blocks.items():
        inside = int((mesh.regions[first:first + len(elements)] == tag).sum())
        first += len(elements)
        if inside:
            counts[kind] = inside
    return counts


def test_a_strip_is_a_region_of_rows():
    domain = _square()
    domain.add_line([(0.5, 0.5), (1.5, 0.5)], "wall")
    domain.add_strip("wall", width=0.1, rows=2)
    mesh = ff.mesh(domain, 0.2, verify=True)
    assert list(_counts(mesh, "wall")) == ["quadrilateral4"]
    assert mesh.check(domain) == []
    domain.add_strip("wall", 0.1, 2, elements="triangles")
    assert list(_counts(ff.mesh(domain, 0.2, verify=True), "wall")) == ["triangle3"]
    domain.add_strip("wall", 1.5, 2)
    with pytest.raises(ff.MeshError) as caught:
        ff.mesh(domain, 0.2)
    assert caught.value.faults[0].code == "strip-room"
    with pytest.raises(ValueError, match="elements: expected"):
        domain.add_strip("wall", 0.1, 2, elements="hexes")


def test_cracks_periodic_parts_layers_mapped_regions_and_elements():
    domain = _square()
    domain.add_line([(0.5, 0.5), (1.5, 0.5)], "joint")
    plain = ff.mesh(domain, 0.2)
    domain.add_crack("joint")
    opened = ff.mesh(domain, 0.2, verify=True)
    assert len(opened.nodes) > len(plain.nodes)
    assert [fault.code for fault in opened.check(domain)] == ["open-line"]  # a note
    domain = _square()
    domain.add_periodic("left", "right")
    domain.add_layers("bottom", first=0.02, count=3)
    mesh = ff.mesh(domain, "0.05 + 0.1*x", verify=True)
    left, right = (np.sort(mesh.nodes[mesh.nodes_of(name)][:, 1]) for name in ("left", "right"))
    assert np.array_equal(left, right)
    domain = _square()
    domain.region((1, 0.5), "plate")
    domain.add_mapped("plate")
    domain.set_elements("plate", "quads")
    mesh = ff.mesh(domain, 0.25, verify=True)
    assert _counts(mesh, "plate") == {"quadrilateral4": 32}
    with pytest.raises(ValueError, match="elements: expected"):
        domain.set_elements("plate", "hexes")


def test_limits_warn_and_fix_changes_settings_until_they_are_met():
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    plain = ff.mesh(square, "0.05 + 0.6*x", gradation=1, limits={"max_growth": 1.6})
    warned = [note for note in plain.notes if note.code == "limit"]
    assert len(warned) == 1 and warned[0].severity == "warning" and "growth" in warned[0].message
    fixed = ff.mesh(square, "0.05 + 0.6*x", gradation=1, limits={"max_growth": 1.6}, fix=True)
    changes = [note.message for note in fixed.notes if note.code == "fixed"]
    assert changes and "gradation 1" in changes[0]
    assert len(fixed.check(max_growth=1.6)) < len(plain.check(max_growth=1.6))
    assert not any("--" in note.message + note.advice for note in plain.notes + fixed.notes)


def test_limits_of_projects_hold_and_limits_need_names_and_values(tmp_path):
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    with pytest.raises(ValueError, match="limits: expected min-angle.*got 'beauty'"):
        ff.mesh(square, limits={"beauty": 1})
    with pytest.raises(ValueError, match="min-angle: expected a number from 0 to"):
        ff.mesh(square, limits={"min_angle": 100})
    with pytest.raises(ValueError, match="fix: there are no limits"):
        ff.mesh(square, fix=True)


def test_flat_elements_are_warned_of():
    thin = [(0.1, 0.1), (0.9, 0.9), (0.7, np.nextafter(0.7, 1.0))]
    mesh = ff.mesh(thin, 1.0)
    assert any(note.code == "flat-element" for note in mesh.notes)
