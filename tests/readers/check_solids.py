"""Checks extruded meshes: volumes and parts as gmsh, meshio and VTK see them, and OpenFOAM's files by a parser of its
own."""
import subprocess

import gmsh
import meshio
import numpy
import vtk

from common import near, same
from foam_case import FoamMesh

HEIGHT, LAYERS = 0.75, 3
# The sides of a prism and a hexahedron with outward normals, in the order of gmsh and meshio.
SIDES = {6: [(2, 1, 0), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
         8: [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]}


def volume(corners):
    total = 0.0
    for side in SIDES[len(corners)]:
        a = corners[side[0]]
        for k in range(2, len(side)):
            total += numpy.dot(a, numpy.cross(corners[side[k - 1]], corners[side[k]])) / 6.0
    return total


def check_meshio(mesh, file, kind):
    found = meshio.read(file, file_format=kind)
    cells = [found.points[row] for block in found.cells if block.type in ("wedge", "hexahedron") for row in block.data]
    same(len(cells), LAYERS * len(mesh.elements()), "cells")
    volumes = list(map(volume, cells))
    assert min(volumes) > 0.0, "a cell is inside out"
    near(sum(volumes), HEIGHT * mesh.area())


def check_gmsh(mesh, file, named):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(file)
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    places = dict(zip(tags, coordinates.reshape(-1, 3)))
    counts, total = {2: 0, 3: 0}, 0.0
    for dimension in (2, 3):
        for kind, _, nodes in zip(*gmsh.model.mesh.getElements(dimension)):
            width = gmsh.model.mesh.getElementProperties(kind)[3]
            counts[dimension] += len(nodes) // width
            if dimension == 3:
                total += sum(volume([places[n] for n in row]) for row in nodes.reshape(-1, width))
    names = {gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups()}
    gmsh.finalize()
    same(counts[3], LAYERS * len(mesh.elements()), "cells")
    edges = sum(1 for kind, *_ in mesh.cells if kind == "edge2")
    same(counts[2], LAYERS * edges + 2 * len(mesh.elements()), "faces")
    near(total, HEIGHT * mesh.area())
    assert not named or {"back", "front"} <= names, names


def check_vtk(mesh, file):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    cells = sizes.GetOutput().GetCellData()
    near(sum(cells.GetArray("Volume").GetValue(k) for k in range(sizes.GetOutput().GetNumberOfCells())),
         HEIGHT * mesh.area())
    for k in range(reader.GetOutput().GetNumberOfCells()):  # the corners of a wedge run as VTK's documents say
        cell = reader.GetOutput().GetCell(k)
        if cell.GetCellType() == vtk.VTK_WEDGE:
            a, b, c, d = (numpy.array(cell.GetPoints().GetPoint(n)) for n in range(4))
            assert numpy.dot(numpy.cross(b - a, c - a), d - a) < 0.0, "the first triangle of a wedge faces inwards"


def check_foam(mesh, case):
    found = FoamMesh(case)
    volumes = found.volumes()
    same(len(volumes), LAYERS * len(mesh.elements()), "cells")
    assert min(volumes) > 0.0, "a cell is inside out"
    near(sum(volumes), HEIGHT * mesh.area())
    pairs = list(zip(found.owner, found.neighbour))
    same(pairs, sorted(pairs), "order of inner faces")


def checks(mesh, source, folder, program):
    """(name, function) pairs for a mesh of triangles and quadrilaterals, with its file in MSH 2.2."""
    def extruded(extension):
        file = str(folder / f"extruded{extension}")
        subprocess.run([program, "--extrude", source, file, str(HEIGHT), str(LAYERS)], check=True)
        return file
    result = []
    for extension, kind in ((".msh", "gmsh"), (".vtu", "vtu"), (".inp", "abaqus"), (".mesh", "medit"), (".bdf", "nastran")):
        if extension != ".vtu":  # meshio keeps VTK's order of corners
            result.append((f"extruded {extension} by meshio",
                           lambda e=extension, k=kind: check_meshio(mesh, extruded(e), k)))
    for extension in (".msh", ".unv", ".bdf"):  # gmsh 4.8 skips the prisms of MEDIT files
        result.append((f"extruded {extension} by gmsh", lambda e=extension: check_gmsh(mesh, extruded(e), e == ".msh")))
    result += [("extruded .vtu by VTK", lambda: check_vtk(mesh, extruded(".vtu"))),
               ("extruded .foam", lambda: check_foam(mesh, extruded(".foam")))]
    return result
