"""Files beyond the mesh itself, and meshes made of other meshes."""
import json
import os
import pickle
import subprocess

import numpy as np
import pytest

import forefront as ff

RASTER = b"ncols 6\nnrows 4\nxllcorner -1\nyllcorner -1\ncellsize 1\nNODATA_value -99\n" + 4 * b"-3 -3 -3 -3 -3 -3\n"


def _points_of(content):
    """Returns the nodes of a 2DM file as rows x, y, z."""
    return np.array([line.split()[2:5] for line in content.decode().splitlines() if line.startswith("ND ")], float)


def test_elevations_are_arrays_functions_expressions_and_rasters(plate, tmp_path):
    mesh = ff.mesh(plate, 0.3)
    x, y = mesh.nodes.T
    raster = tmp_path / "sea.asc"
    raster.write_bytes(RASTER)
    expected = -5 - 0.5 * x
    for given in (expected, lambda x, y: -5 - 0.5 * x, "-5-0.5*x"):
        found = _points_of(mesh.to_bytes("2dm", elevation=given))
        assert np.allclose(found, np.column_stack([x, y, expected]), rtol=0, atol=1e-9)
    assert np.all(_points_of(mesh.to_bytes("2dm", elevation=raster))[:, 2] == -3)
    assert np.all(_points_of(mesh.to_bytes("2dm", elevation=str(raster)))[:, 2] == -3)
    with pytest.raises(ValueError, match=f"elevation: expected one for each of the {len(x)} nodes, got 2"):
        mesh.to_bytes("2dm", elevation=[1.0, 2.0])
    with pytest.raises(ValueError, match="elevation: expected finite numbers, got nan at node 0"):
        mesh.to_bytes("2dm", elevation=np.full(len(x), np.nan))
    with pytest.raises(ff.MeshError, match="expression-syntax"):
        mesh.to_bytes("2dm", elevation="2*")
    with pytest.raises(ff.MeshError, match="no-elevation") as caught:
        ff.mesh([(0, 0), (40, 0), (40, 2)], 0.5).to_bytes("2dm", elevation=raster)
    assert caught.value.faults[0].file == str(raster)


def test_numbering_keeps_elevations_at_their_nodes(plate):
    mesh = ff.mesh(plate, 0.3)
    content = mesh.to_bytes("2dm", numbering="rcm", elevation=lambda x, y: x + 10 * y)
    found = _points_of(content)
    assert np.allclose(found[:, 2], found[:, 0] + 10 * found[:, 1], rtol=0, atol=1e-6)
    assert np.allclose(found[:, :2], mesh.numbered("rcm").nodes, rtol=0, atol=1e-9)
    assert not np.allclose(found[:, :2], mesh.nodes)
    with pytest.raises(ValueError, match="numbering: expected creation or rcm, got 'best'"):
        mesh.to_bytes("2dm", numbering="best")


def test_files_have_prisms_open_boundaries_tags_and_units(plate, tmp_path):
    mesh = ff.mesh(plate, 0.4)
    assert f'NumberOfPoints="{4 * len(mesh.nodes)}"'.encode() in mesh.to_bytes("vtu", extrude=(2, 3))
    assert f'NumberOfPoints="{2 * len(mesh.nodes)}"'.encode() in mesh.to_bytes("vtu", extrude=2)
    mesh.write(tmp_path / "a.foam", extrude=0.5)
    assert (tmp_path / "a.foam").exists()
    water = tmp_path / "a.14"
    assert "no-open-boundary" in {note.code for note in mesh.write(water)}
    assert "no-open-boundary" not in {note.code for note in mesh.write(water, open="left")}
    grid = ff.read_mesh(water)
    assert any("open" in name for name in grid.boundary_names.values())
    assert b"unit" not in mesh.to_bytes("msh2") and b"mm" in mesh.to_bytes("msh2", unit="mm")
    plate.region((3, 1), 2)  # the tag of the bottom, too
    mesh = ff.mesh(plate, 0.4)
    assert b'\n2 1002 "' in mesh.to_bytes("msh2") and b'\n2 2 "' in mesh.to_bytes("msh2", tags="keep")


def test_arguments_without_a_place_in_the_format_are_refused(plate):
    mesh = ff.mesh(plate, 0.5)
    for argument, value in (("elevation", "1"), ("extrude", 1), ("open", "left"), ("tags", "keep"), ("unit", "mm")):
        able = {row["id"]: row[argument] for row in ff.formats() if row["writes_mesh"]}
        refusing = next(name for name, holds in able.items() if not holds)
        others = ", ".join(name for name, holds in able.items() if holds)
        with pytest.raises(ValueError, match=f"^{argument}: .*; write one of the formats {others}$"):
            mesh.to_bytes(refusing, **{argument: value})
    with pytest.raises(KeyError, match="unknown boundary part 'sea'; expected bottom, hole"):
        mesh.to_bytes("adcirc", open="sea")
    with pytest.raises(ValueError, match="open: no part of the boundary has the tag 77"):
        mesh.to_bytes("adcirc", open=[77])
    for extrude in (0, -1, (1, 0), (1, 20000)):
        with pytest.raises(ValueError, match="extrude: expected a height above 0"):
            mesh.to_bytes("vtu", extrude=extrude)
    with pytest.raises(ValueError, match="unit: expected none, mm.* got 'mile'"):
        mesh.to_bytes("msh2", unit="mile")
    with pytest.raises(ValueError, match="tags: expected apart or keep, got 'loose'"):
        mesh.to_bytes("msh2", tags="loose")
    with pytest.raises(TypeError):
        mesh.to_bytes("msh2", colour="red")
    assert {"elevation", "extrude", "open", "tags", "unit"} <= set(ff.formats()[0])


def test_inner_edges_that_a_format_lacks_are_noted(rectangle, tmp_path):
    domain = ff.Domain()
    domain.add_loop(rectangle)
    domain.add_line([(1, 1), (3, 1)])
    mesh = ff.mesh(domain, 0.5)
    assert [note.code for note in mesh.write(tmp_path / "a.su2")] == ["inner-edges"]
    assert mesh.write(tmp_path / "a.su2", inner_edges=True) == mesh.write(tmp_path / "a.vtu") == []


def test_recombining_makes_quadrilaterals(plate):
    mesh = ff.mesh(plate, 0.2)
    quads = mesh.recombine()
    assert quads.elements.shape[1] == 4 and quads.quality("area").sum() == pytest.approx(mesh.quality("area").sum())
    assert quads.check() == [] and len(quads.edges) == len(mesh.edges)
    assert quads.quality("delta").mean() > 0.8
    odd = ff.mesh([(0, 0), (1, 0), (0, 1)], 10.0, keep_boundary=True).recombine()
    assert list(odd.blocks) == ["triangle3"] and [note.code for note in odd.notes] == ["triangles-left"]
    with pytest.raises(ValueError, match="improve: expected none, default or best, got 'much'"):
        mesh.recombine(improve="much")
    with pytest.raises(ff.MeshError, match="not-first-order"):
        mesh.raise_order().recombine()


def test_raising_the_order_follows_the_curves(plate):
    mesh = ff.mesh(plate, 0.3)
    second = mesh.raise_order()
    assert list(second.blocks) == ["triangle6"] and np.array_equal(second.nodes[:len(mesh.nodes)], mesh.nodes)
    assert second.hash == ff.mesh(plate, 0.3, order=2).hash
    middles = second.nodes[second.nodes_of("hole")]
    assert np.abs(np.hypot(*(middles - 1).T) - 0.4).max() < 1e-12
    straight = ff.read_mesh(mesh.to_bytes("msh2")).raise_order()
    assert straight.element_count == mesh.element_count and straight.hash != second.hash
    assert "quadrilateral9" in mesh.recombine().raise_order(9).blocks
    with pytest.raises(ValueError, match="quad_nodes: expected 8 or 9, got 7"):
        mesh.raise_order(7)
    with pytest.raises(ValueError, match="of second order; triangulated"):
        second.raise_order()


def test_a_mesh_that_was_read_gets_a_spacing(rectangle):
    made = ff.mesh(rectangle, "0.1+0.05*x")
    read = ff.read_mesh(made.to_bytes("vtu"))
    assert [fault.code for fault in read.check(min_delta=0.5)] == ["no-spacing"]
    sized = read.with_size("0.1+0.05*x")
    assert np.allclose(np.sort(sized.quality("delta")), np.sort(made.quality("delta")), rtol=0, atol=1e-6)
    assert sized.check(min_delta=0.3) == [] and sized.hash == read.hash
    coarse = read.with_size(lambda x, y: 0.4 + 0 * x).check(min_delta=0.5)
    assert coarse and {fault.code for fault in coarse} == {"min-delta"}
    with pytest.raises(ff.MeshError, match="bad-size"):
        read.with_size(-1)


def test_points_survive_numbering_and_pickling(rectangle):
    domain = ff.Domain()
    domain.add_loop(rectangle)
    domain.add_point((1.3, 0.7), name="gauge")
    mesh = ff.mesh(domain, 0.2)
    for other in (mesh.numbered("rcm"), pickle.loads(pickle.dumps(mesh))):
        gauge, = other.nodes_of("gauge")
        assert tuple(other.nodes[gauge]) == (1.3, 0.7) and other.hash == mesh.hash
    with pytest.raises(ValueError, match="points: node 9 does not exist"):
        ff.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)], points=[9])
    with pytest.raises(ValueError, match="point_tags: expected one for each of the 1 points, got 2"):
        ff.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)], points=[1], point_tags=[1, 2])


def test_numbering_carries_values():
    vtk = ("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n"
           "CELLS 2 8\n3 0 1 2\n3 0 2 3\nCELL_TYPES 2\n5\n5\nCELL_DATA 2\nSCALARS load double 1\nLOOKUP_TABLE default\n"
           "5 7\nPOINT_DATA 4\nSCALARS heat double 1\nLOOKUP_TABLE default\n1 2 3 4\n").encode()
    mesh = ff.read_mesh(vtk, "vtk")
    moved = mesh.numbered([3, 2, 1, 0])
    assert moved.node_values["heat"].tolist() == [4, 3, 2, 1]
    by_place = lambda m: {tuple(c): v for c, v in zip(m.nodes[m.elements].mean(axis=1).round(9).tolist(),
                                                      m.element_values["load"].tolist())}
    assert by_place(moved) == by_place(mesh)


def test_files_equal_those_of_the_batch_program(plate, tmp_path):
    program = os.environ.get("FOREFRONT_PROGRAM")
    if not program:
        pytest.skip("FOREFRONT_PROGRAM is not set")
    file = tmp_path / "bay.geojson"
    file.write_text(json.dumps({"type": "Polygon", "coordinates": [[[0, 0], [7, 0], [7, 5], [2, 4], [0, 0]]]}))
    mesh = ff.mesh(file, 0.4)
    for name, form, arguments in (("a.2dm", {"elevation": "-1-x"}, ["--elevation", "-1-x"]),
                                  ("a.msh", {"unit": "m"}, ["--unit", "m"]),
                                  ("b.vtu", {"extrude": (2, 3)}, ["--extrude", "2:3"])):
        subprocess.run([program, "mesh", file, "--size", "0.4", "-q", "-o", tmp_path / name, "--numbering", "rcm",
                        *arguments], check=True)
        mine = tmp_path / ("mine" + name[1:])
        mesh.write(mine, numbering="rcm", **form)
        assert mine.read_bytes() == (tmp_path / name).read_bytes(), name
