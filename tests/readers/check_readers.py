"""Reads every exported format with the programs it is meant for and holds what they see against the truth.

    check_readers.py EXPORT_SAMPLE        (the helper that writes the files)

Exit status 77: a reader is missing and FOREFRONT_REQUIRE_READERS is not set.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # keeps the source tree clean
from common import Samples, compare, measures, near, same, triangle_area

missing = [program for program in ("gmsh", "FreeFem++", "ccx", "rsvg-convert") if not shutil.which(program)]
try:
    import getfem
    import gmsh
    import meshio
    import numpy
    import vtk
except ImportError as problem:
    missing.append(str(problem))
if missing:
    print("readers missing:", ", ".join(missing))
    sys.exit(1 if os.environ.get("FOREFRONT_REQUIRE_READERS") else 77)
import check_cells
import check_solids
import check_solvers
import check_water


class Gmsh:
    """A file opened by gmsh."""

    def __init__(self, file):
        self.file = file

    def __enter__(self):
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(self.file)
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        self.places = dict(zip(tags, coordinates.reshape(-1, 3)))
        return self

    def __exit__(self, *_):
        gmsh.finalize()

    def corners(self, dimension, entity=-1):
        _, _, nodes = gmsh.model.mesh.getElements(dimension, entity)
        for row in (numpy.concatenate(nodes) if nodes else numpy.array([])).reshape(-1, dimension + 1):
            yield [self.places[n] for n in row]


def check_gmsh(sample, file):
    with Gmsh(file) as mesh:
        same(len(mesh.places), sample.nodes, "nodes")
        for dimension, kind, parts in ((1, "edges", sample.edges), (2, "regions", sample.regions)):
            groups = {tag: gmsh.model.getPhysicalName(dimension, tag)
                      for _, tag in gmsh.model.getPhysicalGroups(dimension)}
            found = measures((groups[tag], corners) for tag in groups
                             for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
                             for corners in mesh.corners(dimension, entity))
            compare(found, parts, lambda name: sample.msh_label(kind, name), "gmsh")
            same(groups, {sample.msh_number(part): sample.msh_label(kind, name) for name, part in parts.items()},
                 "physical groups")


def check_gmsh_entities(sample, file):
    """MEDIT: gmsh takes the references as numbers of entities."""
    with Gmsh(file) as mesh:
        for dimension, parts in ((1, sample.edges), (2, sample.regions)):
            found = measures((tag, corners) for _, tag in gmsh.model.getEntities(dimension)
                             for corners in mesh.corners(dimension, tag))
            compare(found, parts, lambda name: parts[name]["tag"], "gmsh")


def check_gmsh_vtk(sample, file):
    """VTK legacy: gmsh reads the cells, not their data."""
    with Gmsh(file) as mesh:
        for dimension, parts in ((1, sample.edges), (2, sample.regions)):
            found = measures((0, corners) for corners in mesh.corners(dimension))
            same(found[0][0], sum(part["count"] for part in parts.values()), "cells")
            near(found[0][1], sum(part.get("length", part.get("area")) for part in parts.values()))


def check_own_reader(sample, file, folder, program):
    """The mesh as gmsh saves it in binary, with nodal values, read by our own reader."""
    saved = str(folder / "gmsh-binary.msh")
    with Gmsh(file) as mesh:
        values = [[1.0 + x + 2.0 * y] for x, y, _ in mesh.places.values()]
        view = gmsh.view.add("heat")
        gmsh.view.addModelData(view, 0, gmsh.model.getCurrent(), "NodeData", list(mesh.places), values)
        gmsh.option.setNumber("Mesh.Binary", 1)
        gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
        gmsh.write(saved)
        gmsh.view.write(view, saved, True)
    assert b"4.1 1 8" in pathlib.Path(saved).read_bytes()[:40], "gmsh wrote no binary file"
    run = subprocess.run([program, "--read", saved, "heat"], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    found = json.loads(run.stdout)
    for kind, size, parts in (("edges", "length", sample.edges), ("regions", "area", sample.regions)):
        same(set(found[kind]), set(parts), f"names of {kind}")
        for name, part in parts.items():  # gmsh keeps the physical numbers, not the tags in the comments
            same((found[kind][name]["tag"], found[kind][name]["count"]), (sample.msh_number(part), part["count"]), name)
            near(found[kind][name][size], part[size])
    same((found["nodes"], found["elements"]), (sample.nodes, sample.elements), "nodes and elements")
    near(found["worst_value"], 0.0, 1e-12)


def cells_of(mesh, shape, data=None):
    """(value of the cell data, corners) of the cells of a shape in a meshio mesh."""
    for k, block in enumerate(mesh.cells):
        if block.type == shape:
            for c, row in enumerate(block.data):
                yield (int(mesh.cell_data[data][k][c]) if data else 0), mesh.points[row][:, :2]


def check_meshio(sample, file, regions=None, edges=None, kind=None, numbers=lambda part: part["tag"]):
    """Areas by the cell data `regions` and lengths by `edges`; without them, the whole area."""
    mesh = meshio.read(file, file_format=kind)
    same(len(mesh.points), sample.nodes, "nodes")
    if regions:
        found = measures(cells_of(mesh, "triangle", regions))
        compare(found, sample.regions, lambda name: numbers(sample.regions[name]), "meshio")
    if edges:
        found = measures(cells_of(mesh, "line", edges))
        compare(found, sample.edges, lambda name: numbers(sample.edges[name]), "meshio")
    found = measures(cells_of(mesh, "triangle"))
    same(found[0][0], sample.elements, "triangles")
    near(found[0][1], sample.area())
    return mesh


def check_meshio_msh(sample, file):
    """meshio keeps one table of names for all dimensions."""
    mesh = check_meshio(sample, file, "gmsh:physical", "gmsh:physical", numbers=sample.msh_number)
    found = {name: (int(tag), int(dimension)) for name, (tag, dimension) in mesh.field_data.items()}
    expected = {}
    for dimension, kind, parts in ((0, "points", sample.points), (1, "edges", sample.edges),
                                   (2, "regions", sample.regions)):
        for name, part in parts.items():
            expected[sample.msh_label(kind, name)] = (sample.msh_number(part), dimension)
    same(found, expected, "table of names")


def check_meshio_sets(sample, file):
    """Abaqus: element sets by region, node sets by boundary."""
    mesh = check_meshio(sample, file, kind="abaqus")
    sets = {name.lower(): sum(len(cells) for cells in blocks) for name, blocks in mesh.cell_sets.items()}
    for name, part in sample.regions.items():
        same(sets[name], part["count"], f"element set {name}")
    nodes = {key.lower(): value for key, value in mesh.point_sets.items()}
    for name, part in sample.edges.items():
        same(len(nodes[name]), part["count"] + (0 if name == "hole" else 1), f"node set {name}")


def check_su2(sample, file, markers):
    """SU2 itself is not packaged: its words are read here, and the file must be ASCII."""
    mesh = check_meshio(sample, file, kind="su2")
    text = pathlib.Path(file).read_bytes().decode("ascii")
    found = {}
    for name, count, rows in re.findall(r"MARKER_TAG=\s*(\S+)\s+MARKER_ELEMS=\s*(\d+)\n((?:3 \d+ \d+\n)*)", text):
        edges = [[mesh.points[int(n)] for n in row.split()[1:]] for row in rows.splitlines()]
        same(len(edges), int(count), f"edges of {name}")
        found.update(measures((name, corners) for corners in edges))
    compare(found, sample.edges, lambda name: markers.get(name, name), "SU2")


def vtk_cells(grid, shape, data):
    values = grid.GetCellData().GetArray(data)
    assert values is not None, f"no cell data '{data}'"
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        if cell.GetCellType() == shape:
            yield int(values.GetTuple1(c)), [cell.GetPoints().GetPoint(k) for k in range(cell.GetNumberOfPoints())]


def check_vtk(sample, file, reader, names=False):
    complaints = []
    reader.AddObserver("ErrorEvent", lambda *_: complaints.append("error"))
    reader.AddObserver("WarningEvent", lambda *_: complaints.append("warning"))
    reader.SetFileName(file)
    reader.Update()
    same(complaints, [], "complaints of VTK")
    grid = reader.GetOutput()
    same(grid.GetNumberOfPoints(), sample.nodes, "points")
    for shape, data, parts in ((vtk.VTK_TRIANGLE, "region", sample.regions), (vtk.VTK_LINE, "boundary", sample.edges)):
        found = measures((tag, [p[:2] for p in corners]) for tag, corners in vtk_cells(grid, shape, data))
        compare(found, parts, lambda name: parts[name]["tag"], "VTK")
    if names:
        fields = grid.GetFieldData()
        for kind, parts in (("boundary", sample.edges), ("region", sample.regions)):
            for name, part in parts.items():
                values = fields.GetArray(f"{kind}:{name}")
                assert values is not None, f"no field '{kind}:{name}'"
                same(int(values.GetTuple1(0)), part["tag"], name)


def check_vtk_obj(sample, file):
    reader = vtk.vtkOBJReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    same(grid.GetNumberOfPoints(), sample.nodes, "points")
    same(grid.GetNumberOfPolys(), sample.elements, "faces")
    same(grid.GetNumberOfLines(), sum(part["count"] for part in sample.edges.values()), "lines")
    near(sum(triangle_area(*(grid.GetCell(c).GetPoints().GetPoint(k) for k in range(3)))
             for c in range(grid.GetNumberOfCells()) if grid.GetCellType(c) == vtk.VTK_TRIANGLE), sample.area())


def check_svg(file, folder):
    picture = str(folder / "mesh.png")
    subprocess.run(["rsvg-convert", "-w", "400", file, "-o", picture], check=True)
    assert os.path.getsize(picture) > 1000, "empty picture"


def check_triangle(sample, base):
    def rows(extension):
        text = pathlib.Path(base).with_suffix(extension).read_bytes().decode("ascii")
        lines = [line.split("#")[0].split() for line in text.splitlines()]
        return [line for line in lines if line]
    nodes, elements, edges = rows(".node"), rows(".ele"), rows(".edge")
    same((int(nodes[0][0]), int(nodes[0][1])), (sample.nodes, 2), "Triangle .node header")
    same((int(elements[0][0]), int(elements[0][1])), (sample.elements, 3), "Triangle .ele header")
    places = {row[0]: (float(row[1]), float(row[2])) for row in nodes[1:]}
    found = measures((int(row[4]), [places[n] for n in row[1:4]]) for row in elements[1:])
    compare(found, sample.regions, lambda name: sample.regions[name]["tag"], "Triangle")
    found = measures((int(row[3]), [places[n] for n in row[1:3]]) for row in edges[1:])
    compare(found, sample.edges, lambda name: sample.edges[name]["tag"], "Triangle")


FREEFEM = """
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
"""

# div(k grad u) = 0 with k = 1 in the steel and 3 in the copper: u = 3x left of the seam and x + 4 right of it has a
# continuous flux, and elements that keep to the seam represent it exactly.
FREEFEM_POISSON = """
fespace Vh(Th, P1);
Vh u, v, exact = x < 2 ? 3 * x : x + 4;
func k = region == %d ? 1. : 3.;
solve heat(u, v) = int2d(Th)(k * (dx(u) * dx(v) + dy(u) * dy(v))) + on(%s, u = exact);
real error = 0;
for (int i = 0; i < Vh.ndof; ++i) error = max(error, abs(u[][i] - exact[][i]));
if (error > 1e-9) { cout << "ERROR " << error << endl; exit(5); }
"""


def run_freefem(text, folder):
    script = folder / "check.edp"
    script.write_text(text + 'cout << "DONE" << endl;\n')
    # Debian's packages keep the plugins elsewhere than the program looks for them.
    plugins = {**os.environ, "FF_LOADPATH": "/usr/lib/freefem++/"}
    run = subprocess.run(["FreeFem++", "-nw", "-v", "0", str(script)], capture_output=True, text=True, env=plugins)
    assert run.returncode == 0 and "DONE" in run.stdout, run.stdout[-2000:] + run.stderr[-500:]


def check_freefem(sample, file, command, numbers, folder):
    def listed(values):
        return ",".join(map(repr, values))
    edges, regions = sample.edges.values(), sample.regions.values()
    outer = [numbers(part) for part in edges if part["tag"] <= 5]
    run_freefem(FREEFEM % ('load "gmsh"' if "gmshload" in command else "", command % file,
                           listed(numbers(p) for p in edges), listed(p["length"] for p in edges),
                           listed(numbers(p) for p in regions), listed(p["area"] for p in regions))
                + FREEFEM_POISSON % (numbers(sample.regions["steel"]), listed(outer)), folder)


def check_freefem_vtk(sample, file, folder):
    """VTK legacy: FreeFem++ reads the cells and gives all the same label."""
    length = sum(part["length"] for part in sample.edges.values())
    run_freefem(FREEFEM % ('load "iovtk"', f'vtkload("{file}")', "1", repr(length), "1", repr(sample.area())), folder)


def check_getfem(sample, file):
    """GetFEM keeps one table of physical numbers for all dimensions."""
    getfem.util_trace_level(0)
    mesh = getfem.Mesh("import", "gmsh", file)
    places = mesh.pts().T
    whole = 65535  # the number of a face that stands for the convex itself
    items = set()  # a face inside belongs to two convexes
    for number in map(int, mesh.regions()):
        for convex, face in mesh.region(number).T:
            nodes = (mesh.pid_from_cvid(int(convex))[0] if face in (-1, whole)
                     else mesh.pid_in_faces([[int(convex)], [int(face)]]))
            items.add((number, tuple(sorted(map(int, nodes)))))
    found = measures(((number, [places[n] for n in nodes]) for number, nodes in items), signed=False)
    compare(found, {**{f"edge {name}": part for name, part in sample.edges.items()},
                    **{f"region {name}": part for name, part in sample.regions.items()}},
            lambda name: sample.msh_number((sample.edges if name.startswith("edge") else sample.regions)
                                           [name.split(" ", 1)[1]]), "GetFEM")
    solve_getfem(sample, mesh)


def solve_getfem(sample, mesh):
    """The problem that FREEFEM_POISSON solves."""
    elements = getfem.MeshFem(mesh, 1)
    elements.set_classical_fem(1)
    integration = getfem.MeshIm(mesh, 2)
    model = getfem.Model("real")
    model.add_fem_variable("u", elements)
    for name, conductivity in (("steel", 1), ("copper", 3)):
        model.add_linear_term(integration, f"{conductivity}*Grad_u.Grad_Test_u",
                              sample.msh_number(sample.regions[name]))
    x = elements.basic_dof_nodes()[0]
    exact = numpy.where(x < 2, 3 * x, x + 4)
    model.add_initialized_fem_data("exact", elements, exact)
    for part in sample.edges.values():
        if part["tag"] <= 5:
            model.add_Dirichlet_condition_with_simplification("u", part["tag"], "exact")
    model.solve()
    assert numpy.abs(model.variable("u") - exact).max() < 1e-9, "the solution is wrong"


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


def run_calculix(name, deck, folder):
    (folder / f"{name}.inp").write_text(deck)
    run = subprocess.run(["ccx", "-i", name], cwd=folder, capture_output=True, text=True)
    assert "*WARNING" not in run.stdout and "*ERROR" not in run.stdout, run.stdout[-1500:]
    data = folder / f"{name}.dat"
    assert data.exists(), run.stdout[-1500:]
    return data.read_text()


def check_calculix(sample, file, folder):
    """Uniaxial tension of a plate in plane stress: constant stress E·ε, u_y = -ν·ε·y, exactly."""
    text = pathlib.Path(file).read_text()
    element_set = re.search(r"\*ELEMENT.*", text, re.I)
    assert element_set and "CPS3" in element_set.group(0).upper(), "no CPS3 elements"
    assert "T3D2" not in text.upper(), "line elements among the exported"
    names = {name.lower(): name for name in re.findall(r"[EN]?SET=\s*\"?([\w-]+)", text, re.I)}
    corner = next(int(m.group(1)) for m in re.finditer(r"^\s*(\d+)\s*,\s*([-+.\deE]+)\s*,\s*([-+.\deE]+)", text, re.M)
                  if float(m.group(2)) == 0.0 and float(m.group(3)) == 0.0)
    data = run_calculix("tension", TENSION % (file, names["plate"], names["left"], names["right"], corner, names["top"],
                                              names["plate"]), folder)
    displacements, stresses = data.split("stresses", 1)
    rows = [line.split() for line in displacements.splitlines() if re.match(r"\s*\d+\s+[-+.\d]", line)]
    assert rows, "no displacements"
    for row in rows:  # on top, y = 2: u_y = -0.3·0.01·2
        near(float(row[2]), -0.006, 1e-6)
    rows = [line.split() for line in stresses.splitlines() if re.match(r"\s*\d+\s+\d+\s+[-+.\d]", line)]
    same(len({row[0] for row in rows}), sample.elements, "elements with stresses")
    for row in rows:
        near(float(row[2]), 10.0, 1e-5)
        assert abs(float(row[3])) < 1e-4 and abs(float(row[5])) < 1e-4, row


# Names of the boundaries of the sample "twins" as identifiers; those of regions then end in "_region".
TWIN_SETS = {"steel": "steel", 'Öffnung "süd"': "n__ffnung__s_d_", "sea bed": "sea_bed", "sea_bed": "sea_bed_2",
             "4th hole": "n_4th_hole", "copper": "copper"}
TWIN_MARKERS = TWIN_SETS

LOADED = """*INCLUDE, INPUT=%s
*MATERIAL, NAME=M
*ELASTIC
1000., 0.3
*SOLID SECTION, ELSET=steel_region, MATERIAL=M
1.
*SOLID SECTION, ELSET=copper_region, MATERIAL=M
1.
*BOUNDARY
n_4th_hole, 1, 2, 0.
*STEP
*STATIC
*DSLOAD
%s, P, 2.
*NODE PRINT, NSET=n_4th_hole, TOTALS=ONLY
RF
*NODE PRINT, NSET=%s
U
*EL PRINT, ELSET=steel_region, TOTALS=ONLY
EVOL
*EL PRINT, ELSET=copper_region, TOTALS=ONLY
EVOL
*END STEP
"""


def check_calculix_names(sample, file, folder):
    """Every set and surface under its name: volumes of the regions, nodes of the boundaries, pressure on the outer
    boundaries as a reaction where the hole is held."""
    outwards = {1: (0, -1), 2: (1, 0), 3: (0, 1), 4: (-1, 0)}
    for name, part in sample.edges.items():
        node_set = TWIN_SETS[name]
        data = run_calculix("loaded", LOADED % (file, "S_" + node_set, node_set), folder)
        numbers = [[float(word) for word in line.split()] for line in data.splitlines()
                   if re.match(r"\s*[-+]?\d[-+.\dE ]*$", line)]
        closed = name == "4th hole"
        same(len([row for row in numbers if len(row) == 4]), part["count"] + (0 if closed else 1), f"nodes of {name}")
        volumes = [row[0] for row in numbers if len(row) == 1]
        same(len(volumes), 2, "volumes")
        near(volumes[0], sample.regions["steel"]["area"], 1e-5)
        near(volumes[1], sample.regions["copper"]["area"], 1e-5)
        if part["tag"] in outwards:
            [reaction] = [row for row in numbers if len(row) == 3]
            for k in range(2):  # the pressure pushes inwards, the reaction outwards
                near(reaction[k], 2.0 * part["length"] * outwards[part["tag"]][k], 1e-5)


def main():
    samples = Samples(sys.argv[1])
    sample, twins, strip, folder = samples["sample"], samples["twins"], samples["strip"], samples.folder

    def by_tag(part):
        return part["tag"]
    checks = [("binary MSH 4.1 of gmsh by Forefront",
               lambda: check_own_reader(sample, sample.files["msh41"], folder, sys.argv[1])),
              ("Abaqus by meshio", lambda: check_meshio_sets(sample, sample.files["inp"])),
              ("Abaqus solved by CalculiX", lambda: check_calculix(strip, strip.files["inp"], folder)),
              ("Abaqus names by CalculiX", lambda: check_calculix_names(twins, twins.files["inp"], folder))]
    for s, name, markers in ((sample, "", {}), (twins, " with twin names", TWIN_MARKERS)):
        f = s.files
        for kind in ("msh2", "msh41", "msh41-binary"):
            checks += [(f"{kind} by gmsh{name}", lambda s=s, f=f, kind=kind: check_gmsh(s, f[kind])),
                       (f"{kind} by meshio{name}", lambda s=s, f=f, kind=kind: check_meshio_msh(s, f[kind]))]
        for kind in ("msh2", "msh41"):  # GetFEM reads no binary files
            checks.append((f"{kind} solved by GetFEM{name}", lambda s=s, f=f, kind=kind: check_getfem(s, f[kind])))
        checks += [
            (f"MEDIT by gmsh{name}", lambda s=s, f=f: check_gmsh_entities(s, f["medit"])),
            (f"VTK legacy by gmsh{name}", lambda s=s, f=f: check_gmsh_vtk(s, f["vtk"])),
            (f"VTU by meshio{name}", lambda s=s, f=f: check_meshio(s, f["vtu"], "region", "boundary")),
            (f"VTK legacy by meshio{name}", lambda s=s, f=f: check_meshio(s, f["vtk"], "region", "boundary")),
            (f"MEDIT by meshio{name}", lambda s=s, f=f: check_meshio(s, f["medit"], "medit:ref", "medit:ref")),
            (f"SU2 by meshio{name}", lambda s=s, f=f, markers=markers: check_su2(s, f["su2"], markers)),
            (f"OBJ by VTK{name}", lambda s=s, f=f: check_vtk_obj(s, f["obj"])),
            (f"VTU by VTK{name}", lambda s=s, f=f: check_vtk(s, f["vtu"], vtk.vtkXMLUnstructuredGridReader(), True)),
            (f"VTK legacy by VTK{name}", lambda s=s, f=f: check_vtk(s, f["vtk"], vtk.vtkUnstructuredGridReader())),
            (f"Triangle files{name}", lambda s=s, f=f: check_triangle(s, f["triangle"])),
            (f"SVG by librsvg{name}", lambda f=f: check_svg(f["svg"], folder)),
            (f"MSH 2.2 solved by FreeFem++{name}",
             lambda s=s, f=f: check_freefem(s, f["msh2"], 'gmshload("%s")', s.msh_number, folder)),
            (f"MEDIT solved by FreeFem++{name}",
             lambda s=s, f=f: check_freefem(s, f["medit"], 'readmesh("%s")', by_tag, folder)),
            (f"VTK legacy by FreeFem++{name}", lambda s=s, f=f: check_freefem_vtk(s, f["vtk"], folder))]
    checks += check_solvers.checks(samples, sys.argv[1]) + check_cells.checks(samples)
    mixed = check_cells.Cells(folder, "mixed")
    checks += check_water.checks(samples, mixed)
    checks += check_solids.checks(mixed, mixed.files["msh2"], folder, sys.argv[1])
    checks += list(check_cells.own_reader_checks(sys.argv[1], folder))
    sys.exit(0 if samples.run(checks)[1] else 1)


main()
