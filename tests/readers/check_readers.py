"""Reads every exported format back with the program it is meant for and holds what that program sees against the truth.

    check_readers.py EXPORT_SAMPLE        (the helper that writes the files)

Exit status 77: a reader is missing and FOREFRONT_REQUIRE_READERS is not set.
"""
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

missing = [program for program in ("gmsh", "FreeFem++", "ccx", "rsvg-convert") if not shutil.which(program)]
try:
    import gmsh
    import meshio
    import numpy
    import vtk
except ImportError as problem:
    missing.append(str(problem))
if missing:
    print("readers missing:", ", ".join(missing))
    sys.exit(1 if os.environ.get("FOREFRONT_REQUIRE_READERS") else 77)


def near(a, b, tolerance=1e-9):
    assert abs(a - b) <= tolerance * max(1.0, abs(b)), f"{a} is not {b}"


def same(a, b, what):
    assert a == b, f"{what}: {a} instead of {b}"


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return 0.5 * ((b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])).sum()


def whole_area(truth):
    return sum(region["area"] for region in truth["regions"].values())


def check_gmsh(truth, file, named=True):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(file)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    place = dict(zip(tags, coordinates.reshape(-1, 3)))
    for dimension, parts, measure in ((1, truth["edges"], "length"), (2, truth["regions"], "area")):
        groups = {gmsh.model.getPhysicalName(dimension, tag): tag for _, tag in gmsh.model.getPhysicalGroups(dimension)}
        if named:
            same(set(groups), set(parts), f"gmsh names of dimension {dimension}")
        else:
            groups = {name: part["tag"] for name, part in parts.items()}
        for name, part in parts.items():
            same(groups[name], part["tag"], f"gmsh tag of {name}")
            count = 0
            total = 0.0
            entities = (gmsh.model.getEntitiesForPhysicalGroup(dimension, groups[name]) if named else [groups[name]])
            for entity in entities:
                _, ids, nodes = gmsh.model.mesh.getElements(dimension, entity)
                count += sum(len(i) for i in ids)
                for row in numpy.concatenate(nodes).reshape(-1, dimension + 1):
                    corners = [place[n] for n in row]
                    total += (math.dist(*corners) if dimension == 1 else
                              area(numpy.array(corners), numpy.array([[0, 1, 2]])))
            same(count, part["count"], f"gmsh elements of {name}")
            near(total, part[measure])
    same(len(place), truth["nodes"], "gmsh nodes")
    gmsh.finalize()


def check_own_reader(truth, file, folder):
    """The mesh as gmsh saves it in binary, with nodal values, read by our own reader."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(file)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    values = [[1.0 + x + 2.0 * y] for x, y, _ in coordinates.reshape(-1, 3)]
    view = gmsh.view.add("heat")
    gmsh.view.addModelData(view, 0, gmsh.model.getCurrent(), "NodeData", tags, values)
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    saved = str(folder / "gmsh-binary.msh")
    gmsh.write(saved)
    gmsh.view.write(view, saved, True)
    gmsh.finalize()
    assert b"4.1 1 8" in pathlib.Path(saved).read_bytes()[:40], "gmsh wrote no binary file"
    run = subprocess.run([sys.argv[1], "--read", saved, "heat"], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    found = json.loads(run.stdout)
    for kind, measure in (("edges", "length"), ("regions", "area")):
        same(set(found[kind]), set(truth[kind]), f"names of {kind}")
        for name, part in truth[kind].items():
            same((found[kind][name]["tag"], found[kind][name]["count"]), (part["tag"], part["count"]), name)
            near(found[kind][name][measure], part[measure])
    same((found["nodes"], found["elements"]), (truth["nodes"], truth["elements"]), "nodes and elements")
    near(found["worst_value"], 0.0, 1e-12)


def check_meshio(truth, file, names=False, regions=None, kind=None):
    mesh = meshio.read(file, file_format=kind)
    triangles = numpy.concatenate([block.data for block in mesh.cells if block.type == "triangle"])
    same(len(triangles), truth["elements"], "meshio triangles")
    same(len(mesh.points), truth["nodes"], "meshio nodes")
    near(area(mesh.points, triangles), whole_area(truth))
    if names:
        found = {name: (int(tag), int(dimension)) for name, (tag, dimension) in mesh.field_data.items()}
        wanted = {name: (part["tag"], 1) for name, part in truth["edges"].items()}
        wanted.update({name: (part["tag"], 2) for name, part in truth["regions"].items()})
        same(found, wanted, "meshio names")
    if regions:
        values = numpy.concatenate([data for block, data in zip(mesh.cells, mesh.cell_data[regions]) if block.type == "triangle"])
        for part in truth["regions"].values():
            same(int((values == part["tag"]).sum()), part["count"], "meshio elements of a region")
    return mesh


def check_meshio_sets(truth, file):
    """Abaqus: element sets by region, node sets by boundary."""
    mesh = check_meshio(truth, file, kind="abaqus")
    sets = {name.lower(): sum(len(cells) for cells in blocks) for name, blocks in mesh.cell_sets.items()}
    for name, part in truth["regions"].items():
        same(sets[name], part["count"], f"abaqus element set {name}")
    for name, part in truth["edges"].items():
        nodes = {key.lower(): value for key, value in mesh.point_sets.items()}[name]
        same(len(nodes), part["count"] + (0 if name == "hole" else 1), f"abaqus node set {name}")


def check_su2(truth, file):
    check_meshio(truth, file, kind="su2")
    text = pathlib.Path(file).read_text()
    markers = dict(re.findall(r"MARKER_TAG=\s*(\S+)\s+MARKER_ELEMS=\s*(\d+)", text))
    boundary = {name: str(part["count"]) for name, part in truth["edges"].items() if name != "seam"}
    same({name: markers.get(name) for name in boundary}, boundary, "SU2 markers")


def check_vtk(truth, file, reader):
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    same(grid.GetNumberOfPoints(), truth["nodes"], "VTK points")
    total, counts = 0.0, {}
    region = grid.GetCellData().GetArray("region")
    assert region is not None, "no cell data 'region'"
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        if cell.GetCellType() == vtk.VTK_TRIANGLE:
            corners = [cell.GetPoints().GetPoint(k) for k in range(3)]
            total += area(numpy.array(corners), numpy.array([[0, 1, 2]]))
            tag = int(region.GetTuple1(c))
            counts[tag] = counts.get(tag, 0) + 1
    same(counts, {part["tag"]: part["count"] for part in truth["regions"].values()}, "VTK elements by region")
    near(total, whole_area(truth))


def check_vtk_obj(truth, file):
    reader = vtk.vtkOBJReader()
    reader.SetFileName(file)
    reader.Update()
    same(reader.GetOutput().GetNumberOfPoints(), truth["nodes"], "OBJ points")
    same(reader.GetOutput().GetNumberOfPolys(), truth["elements"], "OBJ faces")


def check_svg(file, folder):
    picture = str(folder / "mesh.png")
    subprocess.run(["rsvg-convert", "-w", "400", file, "-o", picture], check=True)
    assert os.path.getsize(picture) > 1000, "empty picture"


def check_triangle(truth, base):
    def rows(extension):
        lines = [line.split("#")[0].split() for line in pathlib.Path(base).with_suffix(extension).read_text().splitlines()]
        return [line for line in lines if line]
    nodes, elements, edges = rows(".node"), rows(".ele"), rows(".edge")
    same((int(nodes[0][0]), int(nodes[0][1])), (truth["nodes"], 2), "Triangle .node header")
    same((int(elements[0][0]), int(elements[0][1])), (truth["elements"], 3), "Triangle .ele header")
    first = int(nodes[1][0])
    points = numpy.array([[float(row[1]), float(row[2])] for row in nodes[1:]])
    triangles = numpy.array([[int(n) - first for n in row[1:4]] for row in elements[1:]])
    near(area(points, triangles), whole_area(truth))
    for part in truth["regions"].values():
        same(sum(int(row[4]) == part["tag"] for row in elements[1:]), part["count"], "Triangle region attribute")
    for part in truth["edges"].values():
        same(sum(int(row[3]) == part["tag"] for row in edges[1:]), part["count"], "Triangle edge marker")


POISSON = """
%s
mesh Th = %s;
int[int] tags = [%s];
real[int] lengths = [%s];
for (int k = 0; k < tags.n; ++k)
  if (abs(int1d(Th, tags[k])(1.) - lengths[k]) > 1e-9 * lengths[k]) { cout << "LENGTH " << tags[k] << endl; exit(3); }
int[int] regions = [%s];
real[int] areas = [%s];
for (int k = 0; k < regions.n; ++k)
  if (abs(int2d(Th, regions[k])(1.) - areas[k]) > 1e-9 * areas[k]) { cout << "AREA " << regions[k] << endl; exit(4); }
// div(k grad u) = 0 with k = 1 in the steel and 3 in the copper: u = 3x left of the seam and x + 4 right of it has a continuous flux, and
// elements that keep to the seam represent it exactly.
fespace Vh(Th, P1);
Vh u, v, exact = x < 2 ? 3 * x : x + 4;
func k = region == %d ? 1. : 3.;
solve heat(u, v) = int2d(Th)(k * (dx(u) * dx(v) + dy(u) * dy(v))) + on(%s, u = exact);
real error = 0;
for (int i = 0; i < Vh.ndof; ++i) error = max(error, abs(u[][i] - exact[][i]));
cout << "ERROR " << error << endl;
if (error > 1e-9) exit(5);
cout << "SOLVED" << endl;
"""


def check_freefem(truth, file, command, folder):
    edges = [part for part in truth["edges"].values()]
    outer = [truth["edges"][name]["tag"] for name in ("bottom", "right", "top", "left", "hole")]
    regions = list(truth["regions"].values())
    script = folder / "poisson.edp"
    script.write_text(POISSON % (
        'load "gmsh"' if "gmshload" in command else "", command % file, ",".join(str(p["tag"]) for p in edges), ",".join(repr(p["length"]) for p in edges),
        ",".join(str(p["tag"]) for p in regions), ",".join(repr(p["area"]) for p in regions),
        truth["regions"]["steel"]["tag"], ",".join(map(str, outer))))
    # Debian's packages keep the plugins elsewhere than the program looks for them.
    plugins = {**os.environ, "FF_LOADPATH": "/usr/lib/freefem++/"}
    run = subprocess.run(["FreeFem++", "-nw", "-v", "0", str(script)], capture_output=True, text=True, env=plugins)
    assert run.returncode == 0 and "SOLVED" in run.stdout, run.stdout[-2000:] + run.stderr[-500:]


TENSION = """*INCLUDE, INPUT=%s
*MATERIAL, NAME=M
*ELASTIC
1000., 0.3
*SOLID SECTION, ELSET=%s, MATERIAL=M
1.
*STEP
*STATIC
*BOUNDARY
%s, 1, 1, 0.
%s, 1, 1, 0.1
%d, 2, 2, 0.
*NODE PRINT, NSET=%s
U
*EL PRINT, ELSET=%s
S
*END STEP
"""


def check_calculix(truth, file, folder):
    """Uniaxial tension of a plate in plane stress: constant stress E·ε, u_y = -ν·ε·y, exactly."""
    text = pathlib.Path(file).read_text()
    element_set = re.search(r"\*ELEMENT.*", text, re.I)
    assert element_set and "CPS3" in element_set.group(0).upper(), "no CPS3 elements"
    assert "T3D2" not in text.upper(), "line elements among the exported"
    names = {name.lower(): name for name in re.findall(r"[EN]?SET=\s*\"?([\w-]+)", text, re.I)}
    corner = next(int(m.group(1)) for m in re.finditer(r"^\s*(\d+)\s*,\s*([-+.\deE]+)\s*,\s*([-+.\deE]+)", text, re.M)
                  if float(m.group(2)) == 0.0 and float(m.group(3)) == 0.0)
    deck = folder / "tension.inp"
    deck.write_text(TENSION % (file, names["plate"], names["left"], names["right"], corner, names["top"], names["plate"]))
    run = subprocess.run(["ccx", "-i", "tension"], cwd=folder, capture_output=True, text=True)
    data = (folder / "tension.dat").read_text() if (folder / "tension.dat").exists() else ""
    assert data, run.stdout[-1500:]
    displacements, stresses = data.split("stresses", 1)
    rows = [line.split() for line in displacements.splitlines() if re.match(r"\s*\d+\s+[-+.\d]", line)]
    assert rows, "no displacements"
    for row in rows:  # on top, y = 2: u_y = -0.3·0.01·2
        near(float(row[2]), -0.006, 1e-6)
    rows = [line.split() for line in stresses.splitlines() if re.match(r"\s*\d+\s+\d+\s+[-+.\d]", line)]
    same(len({row[0] for row in rows}), truth["elements"], "elements with stresses")
    for row in rows:
        near(float(row[2]), 10.0, 1e-5)
        assert abs(float(row[3])) < 1e-4 and abs(float(row[5])) < 1e-4, row


def main():
    folder = pathlib.Path(tempfile.mkdtemp(prefix="forefront-readers-"))
    subprocess.run([sys.argv[1], str(folder)], check=True)
    truth = json.loads((folder / "sample.json").read_text())
    strip = json.loads((folder / "strip.json").read_text())
    files = truth["files"]
    checks = [
        ("MEDIT by gmsh", lambda: check_gmsh(truth, files["medit"], named=False)),
        ("MSH 2.2 by gmsh", lambda: check_gmsh(truth, files["msh2"])),
        ("MSH 4.1 by gmsh", lambda: check_gmsh(truth, files["msh41"])),
        ("binary MSH 4.1 by gmsh", lambda: check_gmsh(truth, files["msh41-binary"])),
        ("binary MSH 4.1 of gmsh by Forefront", lambda: check_own_reader(truth, files["msh41"], folder)),
        ("MSH 2.2 by meshio", lambda: check_meshio(truth, files["msh2"], names=True, regions="gmsh:physical")),
        ("MSH 4.1 by meshio", lambda: check_meshio(truth, files["msh41"], names=True, regions="gmsh:physical")),
        ("binary MSH 4.1 by meshio",
         lambda: check_meshio(truth, files["msh41-binary"], names=True, regions="gmsh:physical")),
        ("VTU by meshio", lambda: check_meshio(truth, files["vtu"], regions="region")),
        ("VTK by meshio", lambda: check_meshio(truth, files["vtk"], regions="region")),
        ("MEDIT by meshio", lambda: check_meshio(truth, files["medit"], regions="medit:ref")),
        ("Abaqus by meshio", lambda: check_meshio_sets(truth, files["inp"])),
        ("SU2 by meshio", lambda: check_su2(truth, files["su2"])),
        ("OBJ by VTK", lambda: check_vtk_obj(truth, files["obj"])),
        ("VTU by VTK", lambda: check_vtk(truth, files["vtu"], vtk.vtkXMLUnstructuredGridReader())),
        ("VTK legacy by VTK", lambda: check_vtk(truth, files["vtk"], vtk.vtkUnstructuredGridReader())),
        ("Triangle files", lambda: check_triangle(truth, files["triangle"])),
        ("SVG by librsvg", lambda: check_svg(files["svg"], folder)),
        ("MSH 2.2 solved by FreeFem++", lambda: check_freefem(truth, files["msh2"], 'gmshload("%s")', folder)),
        ("MEDIT solved by FreeFem++", lambda: check_freefem(truth, files["medit"], 'readmesh("%s")', folder)),
        ("Abaqus solved by CalculiX", lambda: check_calculix(strip, strip["files"]["inp"], folder)),
    ]
    failures = 0
    for name, check in checks:
        try:
            check()
            print("ok    ", name)
        except Exception as problem:  # one reader's complaint must not hide another's
            failures += 1
            print("FAILED", name, "-", type(problem).__name__, problem)
    if failures == 0:
        shutil.rmtree(folder)
    else:
        print("the files stay in", folder)
    sys.exit(1 if failures else 0)


main()
