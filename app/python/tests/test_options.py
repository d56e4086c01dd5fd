"""The options of jobs that the batch program has, too."""
import json
from pathlib import Path

import numpy as np
import pytest

import forefront as ff

SAMPLES = Path(__file__).resolve().parents[3] / "assets" / "samples"
RASTER = "ncols 8\nnrows 6\nxllcorner -2\nyllcorner -2\ncellsize 1\nNODATA_value -99\n" + \
    6 * "0.1 0.1 0.1 0.2 0.3 0.4 0.4 0.4\n"


def test_elements_of_second_order(plate):
    second = ff.mesh(plate, 0.3, order=2)
    assert list(second.blocks) == ["triangle6"]
    assert ff.mesh(plate, 0.3, order=2, elements="quads").elements.shape[1] == 8
    assert ff.mesh(plate, 0.3, order=2, elements="quads", quad_nodes=9).elements.shape[1] == 9
    with pytest.raises(ValueError, match="order: expected 1 or 2, got '3'"):
        ff.mesh(plate, 0.3, order=3)


def test_rules_of_the_classic_method(rectangle, tmp_path):
    usual = ff.mesh(rectangle, 0.3, method="classic")
    other = ff.mesh(rectangle, 0.3, method="classic", rules={"base": "oldest", "radius": 2})
    file = tmp_path / "rules.json"
    file.write_text('{"base": "oldest", "radius": 2}')
    assert other.hash == ff.mesh(rectangle, 0.3, method="classic", rules=file).hash != usual.hash
    with pytest.raises(ValueError, match="rules: the fast method has no such rules"):
        ff.mesh(rectangle, 0.3, rules={})
    with pytest.raises(ValueError, match="rules: quadrilaterals have a front of their own"):
        ff.mesh(rectangle, 0.3, elements="quads", rules={})
    with pytest.raises(ff.MeshError, match="raduis"):
        ff.mesh(rectangle, 0.3, method="classic", rules={"raduis": 2})


def test_a_target_number_of_elements(plate):
    for size in (None, "0.1+0.05*x", lambda x, y: 0.1 + 0.05 * x):
        mesh = ff.mesh(plate, size, target_elements=1000)
        assert mesh.element_count == pytest.approx(1000, rel=0.05)
    assert ff.estimate(plate, target_elements=1000).elements == pytest.approx(1000, rel=0.2)
    held = ff.mesh([(0, 0), (4, 0), (4, 2), (0, 2)], minimum=0.5, target_elements=5000)
    assert held.element_count < 500 and "target" in " ".join(note.code for note in held.notes)
    with pytest.raises(ValueError, match="target_elements: expected a number from 1 on, got 0"):
        ff.mesh(plate, target_elements=0)


def test_rasters_are_called_by_the_expression(rectangle, tmp_path):
    file = tmp_path / "h.asc"
    file.write_text(RASTER)
    rows = [line.split() for line in RASTER.splitlines()[6:]]
    grid = ff.Grid(np.array(rows, float)[::-1], origin=(-1.5, -1.5))
    mesh = ff.mesh(rectangle, "h(x,y)", rasters={"h": file})
    x, areas = mesh.nodes[mesh.elements].mean(axis=1)[:, 0], mesh.quality("area")
    assert areas[x > 3].mean() > 3 * areas[x < 1].mean()
    assert ff.mesh(rectangle, "h(x,y)", rasters={"h": grid}).hash == mesh.hash
    with pytest.raises(ValueError, match="rasters: "):
        ff.mesh(rectangle, "h(x,y)", rasters={"sin": grid})
    with pytest.raises(TypeError, match="rasters: expected a file or a Grid for 'h', got int"):
        ff.mesh(rectangle, "h(x,y)", rasters={"h": 3})
    with pytest.raises(ValueError, match="a pitch above 0"):
        ff.mesh(rectangle, "h(x,y)", rasters={"h": ff.Grid(np.ones((2, 2)), pitch=0.0)})


def test_size_presets_are_the_size(rectangle):
    depth = ff.Grid(np.full((9, 9), 10.0), origin=(-2, -2))
    preset = ff.mesh(rectangle, size_presets="wavelength:depth=d,period=1,elements=30", rasters={"d": depth})
    assert preset.quality("length").mean() == pytest.approx(np.sqrt(9.81 * 10) / 30, rel=0.1)
    with pytest.raises(ValueError, match="size_presets: they are the size; leave out size"):
        ff.mesh(rectangle, 0.1, size_presets="shore:size=0.1,growth=0.1")
    with pytest.raises(ff.MeshError, match="bad-preset"):
        ff.mesh(rectangle, size_presets="tide:depth=d")


def test_parameters_and_rasters_of_projects_hold_for_expressions():
    square = [(0, 0), (4, 0), (4, 2), (0, 2)]
    assert ff.mesh(square, "h", parameters={"h": 0.2}).hash == ff.mesh(square, "0.2").hash
    with pytest.raises(ff.MeshError, match="expression"):
        ff.mesh(square, "h")
    gear, bay = SAMPLES / "gear.json", SAMPLES / "bay.json"
    usual = ff.mesh(gear, "3").hash
    assert ff.mesh(gear, "bore*3/22").hash == ff.mesh(gear, "bore/10", parameters={"bore": 30}).hash == usual
    assert ff.mesh(bay, "500 + 20*depth(x,y)").element_count > 500


def test_uniform_grids_of_a_size(rectangle):
    plain = ff.mesh(rectangle, 0.2)
    assert ff.mesh(rectangle, 0.2, grid="uniform:20x10").hash == ff.mesh(rectangle, 0.2, grid="uniform").hash
    assert plain.element_count > 0
    for wrong in ("uniform:0x10", "uniform:20x1000000", "uniform:20x99999999999"):
        with pytest.raises(ValueError, match="grid: expected 1 to 100000 columns and rows"):
            ff.mesh(rectangle, 0.2, grid=wrong)
    with pytest.raises(ValueError, match="grid: expected none"):
        ff.mesh(rectangle, 0.2, grid="uniform:20")


def test_an_estimate_is_near_the_mesh(plate):
    found = ff.estimate(plate, 0.1)
    mesh = ff.mesh(plate, 0.1)
    assert found.elements == pytest.approx(mesh.element_count, rel=0.15)
    assert found.nodes == pytest.approx(len(mesh.nodes), rel=0.15) and found.notes == []
    assert found.boundary_edges == len(mesh.edges) and found.bytes > 1e4 and 0 < found.seconds < 1
    with pytest.raises(ff.MeshError, match="bad-size"):
        ff.estimate(plate, -1)


def test_notes_of_readers_and_repairs_reach_the_mesh(bow_tie, tmp_path):
    file = tmp_path / "lonlat.geojson"
    file.write_text(json.dumps({"type": "Polygon", "coordinates": [[[25, 60], [26, 60], [26, 61], [25, 61], [25, 60]]]}))
    domain = ff.Domain.read(file)
    assert "warning" in {note.severity for note in domain.notes}
    codes = lambda noted: [note.code for note in noted.notes]
    mesh = ff.mesh(file, 0.2)
    assert codes(mesh)[:len(domain.notes)] == codes(domain) == codes(ff.run(file, 0.2).finish())
    assert codes(ff.estimate(file, 0.2)) == codes(domain) == codes(domain.copy())
    assert codes(mesh.recombine())[:len(domain.notes)] == codes(domain)
    repaired, changes = ff.Domain(_loop(bow_tie)).repair()
    assert codes(repaired) == [change.code for change in changes] != []
    assert codes(ff.mesh(bow_tie, 0.2, repair=True))[:len(changes)] == codes(repaired)


def _loop(points):
    domain = ff.Domain()
    domain.add_loop(points)
    return domain
