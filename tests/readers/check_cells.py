"""Checks of exported meshes with quadrilaterals and cells of second order: what other programs see must be the same cells,
node by node. check_readers.py runs them."""
import json
import math
import pathlib
import re
import subprocess

import getfem
import gmsh
import meshio
import numpy
import vtk

from common import near, same

# The kinds of cells by the names and numbers of other programs.
GMSH = {1: "edge2", 8: "edge3", 2: "triangle3", 9: "triangle6", 3: "quadrilateral4", 16: "quadrilateral8",
        10: "quadrilateral9"}
VTK = {vtk.VTK_LINE: "edge2", vtk.VTK_QUADRATIC_EDGE: "edge3", vtk.VTK_TRIANGLE: "triangle3",
       vtk.VTK_QUADRATIC_TRIANGLE: "triangle6", vtk.VTK_QUAD: "quadrilateral4",
       vtk.VTK_QUADRATIC_QUAD: "quadrilateral8", vtk.VTK_BIQUADRATIC_QUAD: "quadrilateral9"}
MESHIO = {"line": "edge2", "line3": "edge3", "triangle": "triangle3", "triangle6": "triangle6",
          "quad": "quadrilateral4", "quad8": "quadrilateral8", "quad9": "quadrilateral9"}
REGION_BASE = 1000  # of the physical groups of regions, whose tags are those of boundaries too


def rounded(point):
    return round(float(point[0]), 9) + 0.0, round(float(point[1]), 9) + 0.0


class Cells:
    """A mesh with all its cells, as pairs of kind and tag with the places of the nodes in order."""

    def __init__(self, folder, name):
        truth = json.loads((folder / f"{name}.json").read_text())
        self.files, self.nodes = truth["files"], truth["nodes"]
        self.boundaries = {int(tag): given for tag, given in truth["boundaries"]}
        self.regions = {int(tag): given for tag, given in truth["regions"]}
        self.cells = [(cell["kind"], cell["tag"], tuple(rounded(self.nodes[n]) for n in cell["nodes"]))
                      for cell in truth["cells"]]

    def elements(self):
        return [cell for cell in self.cells if not cell[0].startswith("edge")]

    def edges(self, tag=None):
        return [cell for cell in self.cells if cell[0].startswith("edge") and tag in (None, cell[1])]

    def area(self, region=None):
        return sum(area_of(kind, nodes) for kind, tag, nodes in self.elements() if region in (None, tag))


def area_of(kind, nodes):
    """The area inside an outline of straight or parabolic edges."""
    corners = 3 if kind.startswith("triangle") else 4
    total = 0.0
    for k in range(corners):
        a, b = nodes[k], nodes[(k + 1) % corners]
        total += 0.5 * (a[0] * b[1] - a[1] * b[0])
        if len(nodes) > corners:  # 2/3 of the chord times the height of the arc beside it
            m = nodes[corners + k]
            total += 2 / 3 * ((m[0] - a[0]) * (b[1] - a[1]) - (m[1] - a[1]) * (b[0] - a[0]))
    return total


def compare_cells(found, expected, tags=True):
    def listed(cells):
        return sorted((kind, tag if tags else 0, nodes) for kind, tag, nodes in cells)
    counts = [sorted({kind: sum(c[0] == kind for c in cells) for kind, *_ in cells}.items())
              for cells in (found, expected)]
    same(counts[0], counts[1], "cells by kind")
    same(listed(found), listed(expected), "cells")


def gmsh_cells(file, group):
    """The cells of a file as gmsh reads it; `group` returns the tag of an entity."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    try:
        gmsh.open(file)
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        places = dict(zip(tags, map(rounded, coordinates.reshape(-1, 3))))
        cells = []
        for dimension, entity in gmsh.model.getEntities():
            kinds, _, nodes = gmsh.model.mesh.getElements(dimension, entity)
            for kind, row in zip(kinds, nodes):
                if kind in GMSH:  # not points
                    for cell in row.reshape(-1, int(re.search(r"\d$", GMSH[kind])[0])):
                        cells.append((GMSH[kind], group(dimension, entity), tuple(places[n] for n in cell)))
        return len(places), cells
    finally:
        gmsh.finalize()


def physical(dimension, entity):
    [number] = gmsh.model.getPhysicalGroupsForEntity(dimension, entity)
    return number - (REGION_BASE if dimension == 2 else 0)


def check_gmsh(mesh, file, group=physical, tags=True):
    nodes, cells = gmsh_cells(file, group)
    same(nodes, len(mesh.nodes), "nodes")
    compare_cells(cells, mesh.cells, tags)


def check_meshio(mesh, file, form=None, edges=True, data=None):
    read = meshio.read(file, file_format=form)
    same(len(read.points), len(mesh.nodes), "nodes")
    cells = []
    for k, block in enumerate(read.cells):
        for c, row in enumerate(block.data if block.type in MESHIO else []):
            is_edge = block.type.startswith("line")
            name = data and data[0 if is_edge else 1]
            tag = int(read.cell_data[name][k][c]) if data else 0
            tag -= REGION_BASE if name == "gmsh:physical" and not is_edge else 0
            cells.append((MESHIO[block.type], tag, tuple(rounded(read.points[n]) for n in row)))
    compare_cells(cells, mesh.cells if edges else mesh.elements(), bool(data))


def check_vtk(mesh, file, reader):
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    same(grid.GetNumberOfPoints(), len(mesh.nodes), "nodes")
    regions, boundaries = (grid.GetCellData().GetArray(name) for name in ("region", "boundary"))
    cells = []
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        if cell.GetCellType() in VTK:
            values = boundaries if cell.GetCellDimension() == 1 else regions
            cells.append((VTK[cell.GetCellType()], int(values.GetTuple1(c)),
                          tuple(rounded(cell.GetPoints().GetPoint(k)) for k in range(cell.GetNumberOfPoints()))))
    compare_cells(cells, mesh.cells)


def check_getfem(mesh, file):
    """The area of the whole mesh, by integration on the cells as GetFEM maps them."""
    getfem.util_trace_level(0)
    read = getfem.Mesh("import", "gmsh", file)
    same(read.nbcvs(), len(mesh.elements()), "convexes")
    near(getfem.asm_generic(getfem.MeshIm(read, 6), 0, "1", -1), mesh.area())


LOADED = """*INCLUDE, INPUT=%s
*MATERIAL, NAME=M
*ELASTIC
1000., 0.3
*SOLID SECTION, ELSET=left_half, MATERIAL=M
1.
*SOLID SECTION, ELSET=right_half, MATERIAL=M
1.
*BOUNDARY
bottom, 1, 2, 0.
*STEP
*STATIC
*DSLOAD
S_%s, P, 2.
*NODE PRINT, NSET=bottom, TOTALS=ONLY
RF
*EL PRINT, ELSET=left_half, TOTALS=ONLY
EVOL
*EL PRINT, ELSET=right_half, TOTALS=ONLY
EVOL
*END STEP
"""


def load_at_end(nodes, k):
    """The share of the first node of an edge in the integral of coordinate k along it, by its shape functions."""
    a, b, *middle = (node[k] for node in nodes)
    return -a / 2 + 2 / 3 * middle[0] - b / 6 if middle else (b - a) / 2


def check_calculix(mesh, file, folder):
    """The areas of both regions, and the force of a pressure on each boundary: the chord from end to end turned by 90
    degrees, however the edges between are curved. A load on nodes that are held is no part of the reactions."""
    held = {node for *_, nodes in mesh.edges(1) for node in nodes}
    for tag in (2, 3, 4):
        (folder / "cells.inp").write_text(LOADED % (file, mesh.boundaries[tag]))
        run = subprocess.run(["ccx", "cells"], cwd=folder, capture_output=True, text=True)
        assert run.returncode == 0 and "ERROR" not in run.stdout, run.stdout[-2000:]
        rows = [[float(word) for word in line.split()] for line in (folder / "cells.dat").read_text().splitlines()
                if re.match(r"\s*[-+]?\d[-+.\dE ]*$", line)]
        [reaction] = [row for row in rows if len(row) == 3]
        volumes = [row[0] for row in rows if len(row) == 1]
        same(len(volumes), 2, "volumes")
        near(volumes[0], mesh.area(1), 1e-5)
        near(volumes[1], mesh.area(2), 1e-5)
        edges = [nodes for *_, nodes in mesh.edges(tag)]
        turned = [(b, a, *middle) for a, b, *middle in edges]
        along = [sum(nodes[1][k] - nodes[0][k] for nodes in edges) for k in (0, 1)]
        for k in (0, 1):
            along[k] -= sum(load_at_end(nodes, k) for nodes in edges if nodes[0] in held)
            along[k] += sum(load_at_end(nodes, k) for nodes in turned if nodes[0] in held)
        near(reaction[0], 2.0 * along[1], 1e-4)  # the pressure pushes to the left of the edges
        near(reaction[1], -2.0 * along[0], 1e-4)


# The stresses of this problem do not depend on Poisson's ratio; with 0, stresses through the thickness, which CalculiX's
# expanded elements have at single nodes, do not disturb them.
PULLED = """*INCLUDE, INPUT=%s
*MATERIAL, NAME=M
*ELASTIC
1000., 0.
*SOLID SECTION, ELSET=plate, MATERIAL=M
1.
*BOUNDARY
left, 1, 1, 0.
bottom, 2, 2, 0.
*STEP
*STATIC
*DSLOAD
S_right, P, -1.
*EL FILE, OUTPUT=2D
S
*END STEP
"""


def check_plate(mesh, file, folder, kind):
    """The largest stress at a hole of a fifth of the width of a plate: 3.14 times the tension at its ends (R. C. J.
    Howland, On the stresses in the neighbourhood of a circular hole in a strip under tension, 1930)."""
    hole = {rounded(node) for *_, nodes in mesh.edges(5) for node in nodes}
    if "edge3" in {cell[0] for cell in mesh.edges(5)}:
        for place in hole:
            near(math.hypot(*place), 1.0, 2e-9)
    same({cell[0] for cell in mesh.elements()}, {kind}, "kinds")
    (folder / "plate.inp").write_text(PULLED % file)
    run = subprocess.run(["ccx", "plate"], cwd=folder, capture_output=True, text=True)
    assert run.returncode == 0 and "ERROR" not in run.stdout, run.stdout[-2000:]
    top = 1 + next(k for k, node in enumerate(mesh.nodes) if rounded(node) == (0.0, 1.0))
    lines = (folder / "plate.frd").read_text().splitlines()
    first = next(k for k, line in enumerate(lines) if line.startswith(" -4  STRESS"))
    along = next(float(line[13:25]) for line in lines[first:] if line.startswith(" -1") and int(line[3:13]) == top)
    assert abs(along / 3.14 - 1) < 0.01, f"stress factor {along}"


def check_triangle(mesh, base):
    """Triangle's files: the fourth, fifth and sixth nodes are on the edges opposite to the first, second and third."""
    def rows(extension):
        lines = pathlib.Path(base).with_suffix(extension).read_text().splitlines()
        return [line.split() for line in lines if not line.startswith("#")]
    nodes, elements = rows(".node"), rows(".ele")
    same(elements[0], [str(len(mesh.elements())), "6", "1"], "header")
    places = {row[0]: rounded(row[1:3]) for row in nodes[1:]}
    cells = [("triangle6", int(row[7]), tuple(places[row[k]] for k in (1, 2, 3, 6, 4, 5))) for row in elements[1:]]
    compare_cells(cells, mesh.elements())


# What gmsh is to make: the order of its elements, whether it recombines triangles, and whether quadrilaterals of second
# order have no node in their centre.
MADE = {"triangle6": (2, 0, 0), "quadrilateral4": (1, 1, 0), "quadrilateral8": (2, 1, 1), "quadrilateral9": (2, 1, 0)}


def check_own_reader(program, folder, kind, extension, version=2.2, binary=0, digits=9):
    """A curved mesh as gmsh saves it, read and written as MSH by Forefront: gmsh finds the same cells in both."""
    saved, copied = str(folder / f"made{extension}"), str(folder / "copied.msh")
    order, recombine, incomplete = MADE[kind]
    gmsh.initialize()
    try:
        for option, value in (("General.Terminal", 0), ("Mesh.MeshSizeMax", 0.7), ("Mesh.RecombineAll", recombine),
                              ("Mesh.SecondOrderIncomplete", incomplete), ("Mesh.MshFileVersion", version),
                              ("Mesh.Binary", binary), ("Mesh.SaveAll", 0), ("Mesh.BdfFieldFormat", 2)):
            gmsh.option.setNumber(option, value)
        gmsh.model.occ.cut([(2, gmsh.model.occ.addRectangle(0, 0, 0, 4, 3))],
                           [(2, gmsh.model.occ.addDisk(2, 1.5, 0, 0.8, 0.8))])
        gmsh.model.occ.synchronize()
        curves, [(_, surface)] = [tag for _, tag in gmsh.model.getEntities(1)], gmsh.model.getEntities(2)
        gmsh.model.addPhysicalGroup(1, curves, 5)
        gmsh.model.addPhysicalGroup(2, [surface], 7)
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(order)
        gmsh.write(saved)
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        places = dict(zip(tags, map(rounded, coordinates.reshape(-1, 3))))
        expected = []
        for dimension in (1, 2):
            kinds, _, nodes = gmsh.model.mesh.getElements(dimension)
            for number, row in zip(kinds, nodes):
                for cell in row.reshape(-1, int(re.search(r"\d$", GMSH[number])[0])):
                    expected.append((GMSH[number], 0, tuple(places[n] for n in cell)))
    finally:
        gmsh.finalize()
    assert any(cell[0] == kind for cell in expected), f"gmsh made no {kind}"
    run = subprocess.run([program, "--copy", saved, copied], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    _, cells = gmsh_cells(copied, lambda *_: 0)

    def coarse(cell):  # gmsh writes 9 digits of a coordinate in Nastran files
        return cell[0], cell[1], tuple((round(x, digits) + 0.0, round(y, digits) + 0.0) for x, y in cell[2])

    def unordered(edge):  # sides of elements may run the other way
        return edge[0], edge[1], tuple(sorted(coarse(edge)[2]))
    for shape in ("edge", "triangle", "quad"):
        change = unordered if shape == "edge" else coarse
        same(sorted(map(change, (c for c in cells if c[0].startswith(shape)))),
             sorted(map(change, (c for c in expected if c[0].startswith(shape)))), shape)


def own_reader_checks(program, folder):
    """(name, function) pairs for files of gmsh. In MEDIT it writes cells of second order under keywords of first order."""
    for kind in MADE:
        formats = [("MSH 2.2", ".msh", 2.2, 0), ("MSH 4.1", ".msh", 4.1, 0), ("binary MSH 4.1", ".msh", 4.1, 1),
                   ("VTK legacy", ".vtk", 2.2, 0), ("Abaqus", ".inp", 2.2, 0)]
        formats += [("UNV", ".unv", 2.2, 0), ("Nastran", ".bdf", 2.2, 0, 3)] if kind != "quadrilateral9" else []
        formats += [("MEDIT", ".mesh", 2.2, 0), ("SU2", ".su2", 2.2, 0)] if kind == "quadrilateral4" else []
        for name, *options in formats:
            yield (f"{name} of gmsh with {kind} by Forefront",
                   lambda kind=kind, options=options: check_own_reader(program, folder, kind, *options))


def checks(samples):
    """(name, function) pairs for the meshes of export_sample."""
    folder, result = samples.folder, []

    def add(name, check, *arguments, **options):
        result.append((name, lambda: check(*arguments, **options)))
    for name in ("mixed", "curved6", "curved8", "curved9", "kinds"):
        mesh = Cells(folder, name)
        f = mesh.files
        for kind in ("msh2", "msh41", "msh41-binary"):
            if name != "kinds":  # gmsh shows elements of one order in an entity
                add(f"{kind} of {name} by gmsh", check_gmsh, mesh, f[kind])
            add(f"{kind} of {name} by meshio", check_meshio, mesh, f[kind], data=("gmsh:physical", "gmsh:physical"))
        if name != "kinds":
            add(f"VTK legacy of {name} by gmsh", check_gmsh, mesh, f["vtk"], lambda *_: 0, tags=False)
        add(f"VTU of {name} by VTK", check_vtk, mesh, f["vtu"], vtk.vtkXMLUnstructuredGridReader())
        add(f"VTK legacy of {name} by VTK", check_vtk, mesh, f["vtk"], vtk.vtkUnstructuredGridReader())
        for kind in ("vtu", "vtk"):
            add(f"{kind} of {name} by meshio", check_meshio, mesh, f[kind], data=("boundary", "region"))
        add(f"MSH 2.2 of {name} by GetFEM", check_getfem, mesh, f["msh2"])
        if name in ("mixed", "curved6"):  # gmsh skips QuadrilateralsQ2
            add(f"MEDIT of {name} by gmsh", check_gmsh, mesh, f["medit"], lambda _, entity: entity)
        if "inp" in f:
            add(f"Abaqus of {name} by CalculiX", check_calculix, mesh, f["inp"], folder)
    mixed, curved = Cells(folder, "mixed"), Cells(folder, "curved6")
    add("MEDIT of mixed by meshio", check_meshio, mixed, mixed.files["medit"], data=("medit:ref", "medit:ref"))
    add("Abaqus of mixed by meshio", check_meshio, mixed, mixed.files["inp"], "abaqus", edges=False)  # knows no CPS6
    add("SU2 of mixed by meshio", check_meshio, mixed, mixed.files["su2"], "su2")
    for name, kind in (("plate6", "triangle6"), ("plate8", "quadrilateral8"), ("plate4", "quadrilateral4")):
        plate = Cells(folder, name)
        add(f"Abaqus of {name} by CalculiX: stress at a hole", check_plate, plate, plate.files["inp"], folder, kind)
    add("Triangle files of curved6", check_triangle, curved, curved.files["triangle"])
    return result
