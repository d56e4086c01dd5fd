"""Files, checks and figures."""
import io
import json
import pickle
import sys
import types
import warnings
from pathlib import Path

import numpy as np
import pytest

import forefront as ff

PLATE = Path(__file__).resolve().parents[3] / "assets" / "samples" / "plate.json"
CIRCLE = b"0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nA\n10\n5\n20\n1\n40\n0.7\n0\nENDSEC\n0\nEOF\n"


@pytest.mark.parametrize("name", ["a.msh", "a.vtu", "a.vtk", "a.mesh", "a.inp", "a.su2", "a.node"])
def test_a_mesh_survives_its_file(plate, tmp_path, name):
    mesh = ff.mesh(plate, 0.3)
    mesh.write(tmp_path / name, inner_edges=True)
    again = ff.read_mesh(tmp_path / name)
    assert again.element_count == mesh.element_count
    assert np.allclose(again.nodes, mesh.nodes, rtol=0, atol=1e-15)
    assert np.array_equal(np.sort(again.elements, axis=None), np.sort(mesh.elements, axis=None))


def test_memory_and_open_files(plate, tmp_path):
    mesh = ff.mesh(plate, 0.3)
    assert ff.read_mesh(mesh.to_bytes("msh2")).hash == mesh.hash
    assert ff.read_mesh(io.BytesIO(mesh.to_bytes("msh41")), "msh41").boundary_names == mesh.boundary_names
    for buffer in (io.BytesIO(), open(tmp_path / "text.msh", "w+")):
        with buffer:
            mesh.write(buffer, "msh2")
            buffer.seek(0)
            assert ff.read_mesh(buffer).hash == mesh.hash
    with pytest.raises(ValueError, match="an open file needs one"):
        mesh.write(io.BytesIO())
    assert mesh._repr_svg_().count("<svg") == 1


def test_faults_of_files_are_mesh_errors(plate, tmp_path):
    with pytest.raises(ff.MeshError) as caught:
        ff.read_mesh(tmp_path / "none.msh")
    assert caught.value.faults[0].file.endswith("none.msh")
    with pytest.raises(ff.MeshError) as caught:
        ff.read_mesh(b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nmany\n$EndNodes\n")
    assert caught.value.faults[0].line == 5
    with pytest.raises(ff.MeshError, match="unknown-format"):
        ff.mesh(plate, 0.5).write(tmp_path / "a.docx")
    with pytest.raises(ValueError, match="unknown format 'docx'"):
        ff.read_mesh(b"", "docx")


def test_the_rule_of_overlaps_is_that_of_the_program(tmp_path):
    def square(name, x, side):
        ring = [(x, 0), (x + side, 0), (x + side, side), (x, side), (x, 0)]
        return {"type": "Feature", "properties": {"name": name}, "geometry": {"type": "Polygon", "coordinates": [ring]}}

    features = {"type": "FeatureCollection", "features": [square("small", 0, 1), square("large", 0.5, 2)]}

    def area_of(name, **options):
        mesh = ff.mesh(ff.Domain.from_geojson(features, degrees="keep", **options), 0.2)
        return float(mesh.quality("area")[mesh.elements_of(name)].sum())

    assert area_of("small") == pytest.approx(0.5) and area_of("small", overlap="later") == pytest.approx(0.5)
    assert area_of("small", overlap="smaller") == pytest.approx(1)
    with pytest.raises(ValueError, match="overlap: expected later or smaller, got 'first'"):
        area_of("small", overlap="first")


def test_bounds_follow_curves(tmp_path):
    domain = ff.Domain.read(CIRCLE, "dxf")
    assert domain.bounds == pytest.approx((4.3, 0.3, 5.7, 1.7), abs=1e-12)


def test_domains_are_read_with_their_sizes(tmp_path):
    text = "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n1\n1 1 0.5 7 0.01\n"
    file = tmp_path / "tank.poly"
    file.write_text(text)
    mesh = ff.mesh(file)
    assert mesh.quality("area").max() <= 0.01 * 1.125 and set(mesh.regions) == {7}
    domain = ff.Domain.read(text.encode(), "poly")
    assert len(domain.nodes) == 4 and domain.bounds == (0, 0, 2, 1)
    assert ff.mesh(domain).hash == mesh.hash
    with pytest.raises(TypeError, match=r"^Domain.read\(\) has no argument 'colour'; expected one of curve_tolerance, "):
        ff.Domain.read(file, colour=1)
    drawing = ff.Domain.read(b'<svg xmlns="http://www.w3.org/2000/svg"><rect width="3" height="2"/><text>a</text></svg>')
    assert drawing.notes and drawing.notes[0].severity == "note"


OPEN = b"MULTILINESTRING((0 0,10 0,10 5,0 5,0 0.01),(3 2,6 2,6 3,3 3,3 2))"


def test_an_outline_that_does_not_close_is_warned_of(tmp_path):
    text = "the outline does not close at .* by 0.01, so the area within it is not meshed; weld=0.0105 closes it"
    with pytest.warns(UserWarning, match=text) as seen:
        domain = ff.Domain.read(OPEN, "wkt")
    assert seen[0].filename == __file__
    assert any(note.severity == "warning" and "weld=0.0105" in note.message for note in domain.notes)
    (tmp_path / "open.wkt").write_bytes(OPEN)
    with pytest.warns(UserWarning, match=text) as seen:
        assert ff.mesh(tmp_path / "open.wkt", 1).quality("area").sum() == pytest.approx(3)
    assert seen[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        whole = ff.mesh(ff.Domain.read(OPEN, "wkt", weld=0.0105), 1)
    assert whole.quality("area").sum() == pytest.approx(47, abs=0.1)


def test_layers_may_be_a_list_and_wrong_types_are_told():
    assert ff.Domain.read(CIRCLE, "dxf", layer=["A"]).bounds == ff.Domain.read(CIRCLE, "dxf", layer="A").bounds
    for option, value, text in (("layer", 3, "a name, or a list of names, got 3"), ("weld", "much", "a length, got 'much'"),
                                ("parts", {"A": (0, 50)}, "a dict such as .* got {'A': .0, 50.}"),
                                ("strict", "yes", "True or False, got 'yes'")):
        with pytest.raises(TypeError, match=f"^{option}: expected {text}"):
            ff.Domain.read(CIRCLE, "dxf", **{option: value})


def test_unknown_arguments_are_named_with_what_was_meant(plate):
    wrong = [(lambda: ff.mesh("part.dxf", 3, weld=1), r"mesh\(\) has no argument 'weld', .* Domain.read\(file, weld=...\)"),
             (lambda: ff.mesh(plate, 3, ordre=2), r"mesh\(\) has no argument 'ordre'; did you mean 'order'\?"),
             (lambda: ff.mesh(plate, 3, wled=2), r"mesh\(\) has no argument 'wled'; did you mean 'weld' of Domain.read\(\)"),
             (lambda: ff.estimate(plate, 3, colour=2), r"estimate\(\) has no argument 'colour'; expected one of sources, "),
             (lambda: ff.run(plate, 3, methd="classic"), r"run\(\) has no argument 'methd'; did you mean 'method'\?"),
             (lambda: ff.Domain.read(CIRCLE, "dxf", wled=1), r"Domain.read\(\) has no argument 'wled'; did you mean 'weld'\?"),
             (lambda: ff.mesh(plate, 1).to_bytes("msh2", unti="mm"), r"to_bytes\(\) .* 'unti'; did you mean 'unit'\?"),
             (lambda: ff.mesh(plate, 1).write("a.msh", unti="mm"), r"write\(\) .* 'unti'; did you mean 'unit'\?")]
    for call, text in wrong:
        with pytest.raises(TypeError, match=f"^{text}"):
            call()


def test_fields_come_with_their_mesh():
    vtk = ("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\n"
           "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nPOINT_DATA 3\nSCALARS heat double 1\nLOOKUP_TABLE default\n1 2 3\n")
    mesh, nodes, elements = ff.read_fields(vtk.encode(), "vtk")
    assert nodes["heat"].tolist() == [1, 2, 3] and elements == {} and mesh.element_count == 1


def test_checks_and_limits(plate):
    mesh = ff.mesh(plate, 0.3)
    assert mesh.check() == mesh.check(plate) == mesh.check(plate, min_angle=20, max_angle=130) == []
    faults = mesh.check(min_angle=59)
    assert faults and all(fault.code == "min-angle" and fault.at for fault in faults)
    broken = np.array(mesh.elements)
    broken[3] = broken[3][::-1]
    assert "inverted-element" in {f.code for f in ff.Mesh(mesh.nodes, broken, None, mesh.edges).check()}
    other = ff.Domain()
    other.add_loop([(0, 0), (5, 0), (5, 2), (0, 2)])
    assert mesh.check(other) != []
    with pytest.raises(ValueError, match="expected a number from 0 to 90"):
        mesh.check(min_angle=100)
    with pytest.raises(ValueError, match="got 'min-beauty'"):
        mesh.check(min_beauty=1)


def test_measures(plate):
    mesh = ff.mesh(plate, 0.2)
    assert mesh.quality("area").sum() == pytest.approx(8 - np.pi * 0.16, rel=1e-3)
    assert mesh.quality().min() > 0.5 and mesh.quality("min-angle").min() > 30
    assert mesh.quality("delta").mean() > 0.9
    with pytest.raises(ValueError, match="measure: expected alpha"):
        mesh.quality("beauty")
    with pytest.raises(ValueError, match="known only for a mesh that was made here"):
        ff.read_mesh(mesh.to_bytes("vtu")).quality("delta")


def test_formats_and_meshio(plate):
    assert {"msh2", "vtu", "inp"} <= {row["id"] for row in ff.formats() if row["writes_mesh"]}
    meshio = pytest.importorskip("meshio")
    mesh = ff.mesh(plate, 0.3)
    there = mesh.to_meshio()
    assert isinstance(there, meshio.Mesh) and len(there.cells_dict["triangle"]) == mesh.element_count
    assert there.field_data["hole"].tolist() == [6, 1]


def test_a_triangulation_for_matplotlib(plate, monkeypatch):
    """Matplotlib is not needed for the tests: a class in its place keeps what it is given."""
    tri = types.ModuleType("matplotlib.tri")
    tri.Triangulation = lambda x, y, triangles: (x, y, triangles)
    monkeypatch.setitem(sys.modules, "matplotlib", types.ModuleType("matplotlib"))
    monkeypatch.setitem(sys.modules, "matplotlib.tri", tri)
    mesh = ff.mesh(plate, 0.3, elements="quads")
    x, y, triangles = mesh.to_matplotlib()
    assert np.array_equal(np.column_stack([x, y]), mesh.nodes) and triangles.shape == (2 * mesh.element_count, 3)


def map_in_degrees(size):
    """A field of 0.02 x 0.01 degrees at 60 degrees of latitude, some 1110 x 1110 m, with an element size."""
    return ('{"type": "Feature", "properties": {"name": "field", "h": %s}, "geometry": {"type": "Polygon", "coordinates": '
            '[[[25, 60], [25.02, 60], [25.02, 60.01], [25, 60.01], [25, 60]]]}}' % size).encode()


POLY = b"3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"
PLAIN = [("poly", POLY), ("wkt", b"POLYGON ((0 0, 1 0, 0 1, 0 0))"), ("geojson", map_in_degrees(1))]


@pytest.mark.parametrize("option, value, formats", [
    ("layer", "a", "poly wkt geojson"), ("names", "name", "poly wkt"), ("sizes", "h", "poly wkt"),
    ("projection", "EPSG:3067", "poly wkt"), ("overlap", "smaller", "poly wkt"), ("degrees", "keep", "poly wkt"),
    ("weld", 1e-6, "poly"), ("curve_tolerance", 0.1, "poly wkt geojson"), ("drop_lines", True, "poly"),
    ("beyond_page", True, "poly wkt geojson"), ("stroke_areas", True, "poly wkt geojson"),
    ("shape_regions", True, "poly wkt geojson"), ("white_holes", False, "poly wkt geojson"),
    ("parameters", {"r": "1"}, "poly wkt geojson")])
def test_options_that_a_format_lacks_are_refused(option, value, formats):
    names = {"poly": "Triangle domain", "wkt": "well-known text", "geojson": "GeoJSON"}
    for known, content in PLAIN:
        if known in formats.split():
            with pytest.raises(ValueError, match=f"^{option}: .*{names[known]}"):
                ff.Domain.read(content, known, **{option: value})
        elif (known, option) != ("geojson", "projection"):  # which needs a component
            ff.Domain.read(content, known, **{option: value})


def test_options_of_projects_drawings_and_pictures_are_refused_elsewhere():
    with pytest.raises(ValueError, match="^parts: .* Forefront project keep names of their own"):
        ff.Domain.read(PLATE, parts={"a": ((0, 0), (1, 0))})
    for option in ("drop_lines", "shape_regions"):
        with pytest.raises(ValueError, match=f"^{option}: only .*; the file is in the format DXF drawing"):
            ff.Domain.read(CIRCLE, "dxf", **{option: True})
    assert ff.Domain.read(CIRCLE, "dxf", curve_tolerance=0.1, layer="A", weld=0.01).bounds == pytest.approx((4.3, 0.3, 5.7, 1.7))
    grid = b"ncols 2\nnrows 2\nxllcorner -1\nyllcorner -1\ncellsize 2\n0.1 0.2\n0.1 0.2\n"
    with pytest.raises(ValueError, match="black, white, box: only pictures have colours; .* ESRI ASCII grid"):
        ff.read_sizes(grid, "esri", black=1, white=2, box=(0, 0, 1, 1))


def test_maps_are_read_with_sizes_and_projected(tmp_path):
    fine, coarse = (ff.mesh(ff.Domain.read(map_in_degrees(h), "geojson", degrees="local", sizes="h")) for h in (50, 200))
    assert fine.element_count == pytest.approx(1113 * 1112 / (0.433 * 50**2), rel=0.1)
    assert fine.element_count > 4 * coarse.element_count
    assert fine.quality("area").sum() == pytest.approx(1113 * 1112, rel=0.01)
    plain = ff.Domain.read(map_in_degrees(50), "geojson", degrees="keep")
    assert plain.bounds == (25, 60, 25.02, 60.01)
    with pytest.raises(ff.MeshError, match="no feature has a property 'size'"):
        ff.Domain.read(map_in_degrees(50), "geojson", degrees="keep", sizes="size")
    with pytest.raises(ff.MeshError, match="expected a size above 0"):
        ff.Domain.read(map_in_degrees(-1), "geojson", degrees="keep", sizes="h")
    file = tmp_path / "map.geojson"
    file.write_bytes(map_in_degrees(50))
    try:
        domain = ff.Domain.read(file, projection="EPSG:3067", sizes="h")
    except ff.MeshError as error:
        assert error.faults[0].code == "missing-component"
    else:
        x, y, right, top = domain.bounds
        assert 388000 < x < right < 390000 and 6651000 < y < top < 6654000
        assert ff.mesh(domain).element_count == pytest.approx(fine.element_count, rel=0.1)


def test_rasters_are_sizes():
    grid = b"ncols 3\nnrows 2\nxllcorner -1\nyllcorner -1\ncellsize 2\nNODATA_value -9\n0.1 0.2 0.4\n0.1 0.2 0.4\n"
    square = [(0, 0), (3, 0), (3, 2), (0, 2)]
    mesh = ff.mesh(square, ff.read_sizes(grid, "esri"))
    x, areas = mesh.nodes[mesh.elements].mean(axis=1)[:, 0], mesh.quality("area")
    assert areas[x > 2.5].mean() > 3 * areas[x < 0.5].mean()
    with pytest.raises(ff.MeshError):
        ff.read_sizes(grid.replace(b"0.4", b"-9").replace(b"0.1", b"-1"), "esri")


def test_parts_of_the_boundary_get_names_by_places():
    ring = [(24.0, 60.0), (24.1, 60.0), (24.1, 60.1), (24.0, 60.1), (24.0, 60.0)]
    domain = ff.Domain.from_geojson({"type": "Polygon", "coordinates": [ring]}, degrees="local",
                                    parts={"sea": ((24.0, 60.0), (24.1, 60.0))})
    mesh = ff.mesh(domain, 1000.0)
    places = mesh.nodes[mesh.nodes_of("sea")]
    assert np.ptp(places[:, 1]) < 20 and np.ptp(places[:, 0]) > 5000  # the southern side, in metres
    plate = ff.Domain()
    plate.add_loop([(0, 0), (4, 0), (4, 2), (0, 2)])
    plate.add_circle((2, 1), 0.5)
    plate.name_part("top", (4, 2), (0, 2))
    plate.name_part("hole", (2, 1.4))
    assert [note.message.split("'")[1] for note in plate.notes] == ["top", "hole"]
    mesh = ff.mesh(plate, 0.3)
    assert set(mesh.nodes[mesh.nodes_of("top")][:, 1]) == {2.0}
    assert np.allclose(np.hypot(*(mesh.nodes[mesh.nodes_of("hole")] - (2, 1)).T), 0.5, atol=1e-9)
    with pytest.raises(ff.MeshError) as caught:
        plate.name_part("far", (90, 90), (91, 90))
    assert caught.value.faults[0].code == "part-place"
    with pytest.raises(ValueError, match="name"):
        plate.name_part("", (0, 0))


def test_values_are_told_where_they_are_left_out_and_survive_pickling(tmp_path):
    mesh = ff.mesh([(0, 0), (1, 0), (0, 1)], 0.3)
    mesh.node_values["u"] = mesh.nodes[:, 0].copy()
    notes = mesh.write(tmp_path / "a.vtu")
    assert [note.code for note in notes] == ["dropped-fields"] and notes[0].severity == "note" and "u" in notes[0].message
    assert np.array_equal(pickle.loads(pickle.dumps(mesh)).node_values["u"], mesh.nodes[:, 0])


def test_names_are_a_property_of_features_of_a_file_too(tmp_path):
    feature = {"type": "Feature", "properties": {"soil": "clay"},
               "geometry": {"type": "Polygon", "coordinates": [[(0, 0), (4, 0), (4, 2), (0, 2), (0, 0)]]}}
    file = tmp_path / "soil.geojson"
    file.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))
    assert "clay" in ff.mesh(file, 0.5, names="soil").region_names.values()
    with pytest.raises(ValueError, match="names: only features"):
        ff.mesh([(0, 0), (4, 0), (4, 2)], 0.5, names="soil")
