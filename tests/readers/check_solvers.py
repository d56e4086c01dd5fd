"""Checks of exported files for solvers: universal files, Nastran, 2DM, grids of water, MFEM and surfaces, by gmsh,
meshio and VTK where they read them, and by small parsers of their own. check_readers.py runs them."""
import math
import pathlib
import re
import subprocess

import meshio
import vtk

from check_cells import MESHIO, REGION_BASE, Cells, check_gmsh, compare_cells, gmsh_cells, rounded
from common import compare, measures, near, same


def straight(cells):
    """The cells with their edges as chords."""
    return [("edge2", tag, nodes[:2]) if kind.startswith("edge") else (kind, tag, nodes) for kind, tag, nodes in cells]


# Universal files

UNV = {11: "edge2", 24: "edge3", 91: "triangle3", 92: "triangle6", 94: "quadrilateral4", 95: "quadrilateral8"}


class UniversalFile:
    """Nodes, elements (kind, property, nodes in the order of the file) and groups (name, type, entities)."""

    def __init__(self, file):
        lines = pathlib.Path(file).read_bytes().decode("ascii").splitlines()
        marks = [k for k, line in enumerate(lines) if line == "    -1"]
        same(len(marks) % 2, 0, "delimiters")
        content = {int(lines[a + 1]): lines[a + 2:b] for a, b in zip(marks[::2], marks[1::2])}
        same(sorted(content), [2411, 2412, 2467], "datasets")
        self.nodes, self.elements, self.groups = {}, {}, {}
        rows = iter(content[2411])
        for head in rows:
            x, y, z = (float(word.replace("D", "e")) for word in next(rows).split())
            same(z, 0.0, "z")
            self.nodes[int(head.split()[0])] = (x, y)
        rows = iter(content[2412])
        for head in rows:
            number, kind, group, _, _, count = map(int, head.split())
            if kind in (11, 24):
                same(len(next(rows).split()), 3, "section of a beam")
            nodes = next(rows).split()
            same(len(nodes), count, "nodes of an element")
            self.elements[number] = (UNV[kind], group, [int(n) for n in nodes])
        rows = iter(content[2467])
        for head in rows:
            number, *_, count = map(int, head.split())
            name, words = next(rows), []
            while len(words) < 4 * count:
                words += map(int, next(rows).split())
            same(len(words), 4 * count, "entities")
            self.groups[number] = (name, words[0], words[1::4])


def check_unv(sample, file, labels):
    """Regions and boundary parts as groups of elements under their names, points as groups of nodes."""
    read = UniversalFile(file)
    same(len(read.nodes), sample.nodes, "nodes")
    for kind, parts in (("edge2", sample.edges), ("triangle3", sample.regions)):
        found = measures((name, [read.nodes[n] for n in read.elements[e][2]])
                         for name, entity, members in read.groups.values() for e in members
                         if entity == 8 and read.elements[e][0] == kind)
        compare(found, parts, lambda name: labels(kind, name), "groups")
    for number, (name, entity, members) in read.groups.items():
        if entity == 8:
            same({read.elements[e][1] for e in members}, {number}, f"properties of {name}")
    points = {name: len(members) for name, entity, members in read.groups.values() if entity == 7}
    same(points, {labels("point", name): part["count"] for name, part in sample.points.items()}, "points")


def check_unv_cells(mesh, file):
    """Nodes of elements of second order run around them."""
    read, cells = UniversalFile(file), []
    for kind, number, nodes in read.elements.values():
        places = [rounded(read.nodes[n]) for n in nodes]
        around = places[::2] + places[1::2] if int(kind[-1]) in (6, 8) or kind == "edge3" else places
        cells.append((kind, number - (0 if kind.startswith("edge") else REGION_BASE), tuple(around)))
    compare_cells(cells, mesh.cells)


def unv_label(sample):
    def label(kind, name):
        text = re.sub("[^A-Za-z0-9_]", "_", name)
        text = text if text[0].isalpha() else "n_" + text
        taken = {re.sub("[^A-Za-z0-9_]", "_", edge) for edge in sample.edges}
        if kind == "edge2":
            return text + ("_2" if name == "sea_bed" and "sea bed" in sample.edges else "")
        return text + {"triangle3": "_region", "point": "_point"}[kind] if text in taken or kind == "point" else text
    return label


# Nastran

def check_nastran_meshio(mesh, file):
    read, cells = meshio.read(file, file_format="nastran"), []
    same(len(read.points), len(mesh.nodes), "nodes")
    for block, tags in zip(read.cells, read.cell_data["nastran:ref"]):
        for row, tag in zip(block.data, tags):
            kind = MESHIO[block.type]
            cells.append((kind, int(tag) - (0 if kind == "edge2" else REGION_BASE),
                          tuple(rounded(read.points[n]) for n in row)))
    compare_cells(cells, straight(mesh.cells))


def check_nastran_gmsh(mesh, file):
    """gmsh takes the properties as numbers of entities."""
    nodes, cells = gmsh_cells(file, lambda dimension, entity: entity - (REGION_BASE if dimension == 2 else 0))
    same(nodes, len(mesh.nodes), "nodes")
    compare_cells(cells, straight(mesh.cells))


def check_nastran_columns(file):
    """Fields of 8 and 16 characters, real numbers with a point, and no property that elements and rods share."""
    properties = {"C": set(), "R": set()}
    for line in pathlib.Path(file).read_bytes().decode("ascii").splitlines():
        if line.startswith("GRID*"):
            same(len(line), 73, "characters of a line of GRID*")
            assert "." in line[40:56] and "." in line[56:72], line
        elif line.startswith("C"):
            assert len(line) <= 73 and (len(line) - 8) % 8 in (0, 1), line
            properties["R" if line.startswith("CROD") else "C"].add(int(line[16:24]))
    same(properties["C"] & properties["R"], set(), "shared properties")


# 2DM

TWO_DM = {"E3T": "triangle3", "E6T": "triangle6", "E4Q": "quadrilateral4", "E8Q": "quadrilateral8",
          "E9Q": "quadrilateral9"}


def check_two_dm(mesh, file):
    """Elements with their materials, nodes of second order around them, and node strings along the boundary parts."""
    places, rows, strings, string = {}, [], [], []
    lines = pathlib.Path(file).read_text().splitlines()
    same(lines[0], "MESH2D", "first line")
    for line in lines[1:]:
        card, *words = line.split()
        if card == "ND":
            places[int(words[0])] = rounded(words[1:3])
        elif card in TWO_DM:
            rows.append((TWO_DM[card], [int(word) for word in words[1:]]))
        elif card == "NS":
            for k, word in enumerate(words):
                string.append(abs(int(word)))
                if int(word) < 0:
                    same(len(words), k + 2, "words of the end of a node string")
                    strings.append((int(words[-1]), string))
                    string = []
                    break
    same((len(places), string), (len(mesh.nodes), []), "nodes")
    cells, middles = [], set()
    for kind, (*nodes, material) in rows:
        corners = 3 if kind.startswith("triangle") else 4
        around, centre = (nodes[:2 * corners], nodes[2 * corners:]) if len(nodes) > corners else (nodes, [])
        ordered = around[::2] + around[1::2] if len(nodes) > corners else nodes
        middles |= set(ordered[corners:])
        cells.append((kind, material, tuple(places[n] for n in ordered + centre)))
    for tag, nodes in strings:
        while len(nodes) > 1:
            middle = [nodes[1]] if nodes[1] in middles else []
            a, b = nodes[0], nodes[1 + len(middle)]
            cells.append(("edge3" if middle else "edge2", tag, tuple(places[n] for n in (a, b, *middle))))
            nodes = nodes[1 + len(middle):]

    def unordered(listed):  # chains run in one direction
        return [(k, t, tuple(sorted(n[:2])) + n[2:]) if k.startswith("edge") else (k, t, n) for k, t, n in listed]
    compare_cells(unordered(cells), unordered(mesh.cells))


# ADCIRC and SCHISM

class Grid:
    """Nodes, elements, and stretches of the boundary as (type, nodes); the type of open ones is None."""

    def __init__(self, file):
        title, *lines = pathlib.Path(file).read_text().splitlines()
        assert title in ("Plane triangle mesh", "Plane mesh"), title
        words = iter([line.split() for line in lines])
        elements, nodes = map(int, next(words))
        rows = [next(words) for _ in range(nodes)]
        same([row[0] for row in rows], [str(k + 1) for k in range(nodes)], "numbers of nodes")
        same({row[3] for row in rows}, {"0"}, "depths")
        self.places = {int(row[0]): (float(row[1]), float(row[2])) for row in rows}
        rows = [list(map(int, next(words))) for _ in range(elements)]
        same([row[1] for row in rows], [len(row) - 2 for row in rows], "nodes of elements")
        self.elements = [row[2:] for row in rows]
        self.stretches = []
        for isOpen in (True, False):
            [count], [total] = next(words), next(words)
            for _ in range(int(count)):
                size, *kind = map(int, next(words))
                same(len(kind), 0 if isOpen else 1, "words of a stretch")
                self.stretches.append((kind[0] if kind else None, [int(next(words)[0]) for _ in range(size)]))
                total = int(total) - size
            same(int(total), 0, "nodes of all stretches")
        same(next(words, None), None, "rest of the file")

    def outline(self):
        """The sides of elements without a neighbour, in their direction."""
        sides = {(row[k - 1], row[k]) for row in self.elements for k in range(len(row))}
        return {(a, b) for a, b in sides if (b, a) not in sides}


def check_grid(file, land, island, elements, nodes, area, open_length=None):
    """Closed chains with the water on the left that cover the outline once."""
    grid = Grid(file)
    same((len(grid.elements), len(grid.places)), (elements, nodes), "elements and nodes")
    found = []
    for kind, chain in grid.stretches:
        closed = chain + chain[:1] if kind == island else chain
        found += zip(closed, closed[1:])
    same(sorted(found), sorted(grid.outline()), "sides")
    same({kind for kind, _ in grid.stretches} <= {None, land, island}, True, "types")
    places = grid.places

    def shoelace(pairs):
        return sum(0.5 * (places[a][0] * places[b][1] - places[b][0] * places[a][1]) for a, b in pairs)
    near(shoelace(found), area)
    for kind, chain in grid.stretches:
        if kind == island:
            assert shoelace(zip(chain, chain[1:] + chain[:1])) < 0, "an island runs counter-clockwise"
    opened = sum(math.dist(places[a], places[b]) for kind, chain in grid.stretches if kind is None
                 for a, b in zip(chain, chain[1:]))
    near(opened, open_length or 0.0)


def check_open(program, folder, sample):
    """The right side and the top of the sample are open: one chain each, and the rest one of land."""
    file = folder / "open.14"
    run = subprocess.run([program, "--open", sample.files["msh2"], str(file), "right", "top"], capture_output=True,
                         text=True)
    assert run.returncode == 0, run.stderr
    grid = Grid(file)
    same([kind for kind, _ in grid.stretches], [None, None, 20, 21], "types")
    right, top, land, _ = (chain for _, chain in grid.stretches)
    same([grid.places[chain[k]] for chain in (right, top, land) for k in (0, -1)],
         [(4, 0), (4, 2), (4, 2), (0, 2), (0, 2), (4, 0)], "ends")
    check_grid(file, 20, 21, sample.elements, sample.nodes, sample.area(), 6.0)


# MFEM and surfaces

class MfemEdges(dict):
    """Numbers edges in the order in which elements name them first, as MFEM does."""

    def number(self, a, b):
        return self.setdefault((min(a, b), max(a, b)), len(self))


def check_mfem(mesh, file):
    """Attributes are regions and boundary parts; vertices are numbered from 0. A grid function has a place for each
    vertex, then for each edge, then for each quadrilateral."""
    words = [line for line in pathlib.Path(file).read_text().splitlines() if line and not line.startswith("#")]
    same(words[:4], ["MFEM mesh v1.0", "dimension", "2", "elements"], "header")
    rows, at = {}, 3
    for name in ("elements", "boundary"):
        same(words[at], name, "section")
        count = int(words[at + 1])
        rows[name] = [[int(word) for word in line.split()] for line in words[at + 2:at + 2 + count]]
        at += 2 + count
    same(words[at], "vertices", "section")
    vertices, curved = int(words[at + 1]), words[at + 2] == "nodes"
    if curved:
        same(words[at + 3:at + 7],
             ["FiniteElementSpace", "FiniteElementCollection: H1_2D_P2", "VDim: 2", "Ordering: 1"], "grid function")
    else:
        same(words[at + 2], "2", "dimension")
    places = [rounded(line.split()) for line in words[at + (7 if curved else 3):]]
    edges, cells = MfemEdges(), []
    shapes = {1: ("edge", 2), 2: ("triangle", 3), 3: ("quadrilateral", 4)}
    for row in rows["elements"] if curved else []:
        for a, b in zip(row[2:], row[3:] + row[2:3]):
            edges.number(a, b)
    centre = vertices + len(edges)
    for attribute, kind, *corners in rows["elements"] + rows["boundary"]:
        same(len(corners), shapes[kind][1], "vertices of an element")
        nodes = list(corners)
        if curved:
            sides = list(zip(corners, corners[1:] + corners[:1]))[:1 if kind == 1 else None]
            nodes += [vertices + edges.number(a, b) for a, b in sides]
        if curved and kind == 3:
            nodes += [centre] if "quadrilateral8" not in {cell[0] for cell in mesh.cells} else []
            centre += 1
        cells.append((f"{shapes[kind][0]}{len(nodes)}", attribute, tuple(places[n] for n in nodes)))
    same(len(places), centre if curved else vertices, "places")
    compare_cells(cells, mesh.cells)


def check_faces(mesh, file, form):
    """The faces of a surface file as VTK reads it; OFF by a parser of its own."""
    if form == "off":
        lines = pathlib.Path(file).read_text().splitlines()
        same(lines[:2], ["OFF", f"{len(mesh.nodes)} {len(mesh.elements())} 0"], "header")
        places = [rounded(line.split()) for line in lines[2:2 + len(mesh.nodes)]]
        faces = [[places[int(n)] for n in line.split()[1:]] for line in lines[2 + len(mesh.nodes):]]
    else:
        reader = vtk.vtkPLYReader() if form == "ply" else vtk.vtkSTLReader()
        reader.SetFileName(file)
        reader.Update()
        grid = reader.GetOutput()
        faces = [[rounded(grid.GetCell(c).GetPoints().GetPoint(k)) for k in range(grid.GetCell(c).GetNumberOfPoints())]
                 for c in range(grid.GetNumberOfCells())]

    def coarse(cells):  # VTK keeps single precision
        turned = [[(round(x, 4) + 0.0, round(y, 4) + 0.0) for x, y in cell] for cell in cells]
        return sorted(tuple(cell[cell.index(min(cell)):] + cell[:cell.index(min(cell))]) for cell in turned)
    same(coarse(faces), coarse(nodes for *_, nodes in mesh.elements()), "faces")


def check_off_meshio(mesh, file):
    """meshio reads OFF of triangles alone."""
    read = meshio.read(file, file_format="off")
    same(len(read.points), len(mesh.nodes), "nodes")
    same(set(read.points[:, 2]), {0.0}, "z")
    cells = [("triangle3", 0, tuple(rounded(read.points[n]) for n in row)) for block in read.cells for row in block.data]
    compare_cells(cells, mesh.elements(), tags=False)


def checks(samples, program):
    """(name, function) pairs for the meshes of export_sample."""
    folder, result = samples.folder, []

    def add(name, check, *arguments):
        result.append((name, lambda: check(*arguments)))
    for name in ("sample", "twins"):
        sample = samples[name]
        add(f"UNV groups of {name}", check_unv, sample, sample.files["unv"], unv_label(sample))
        add(f"Nastran fields of {name}", check_nastran_columns, sample.files["nastran"])
        for kind, land, island in (("adcirc", 20, 21), ("gr3", 0, 1)):
            add(f"{kind} of {name}", check_grid, sample.files[kind], land, island, sample.elements, sample.nodes,
                sample.area())
    add("ADCIRC with open parts", check_open, program, folder, samples["sample"])
    mixed = Cells(folder, "mixed")
    add("gr3 of mixed", check_grid, mixed.files["gr3"], 0, 1, len(mixed.elements()), len(mixed.nodes), mixed.area())
    for name in ("mixed", "curved6", "curved8", "curved9"):
        add(f"MFEM of {name}", check_mfem, Cells(folder, name), Cells(folder, name).files["mfem"])
    for form in ("ply", "off"):
        add(f"{form} of mixed", check_faces, mixed, mixed.files[form], form)
    for form in ("ply", "stl", "off"):
        add(f"{form} of flat3", check_faces, Cells(folder, "flat3"), Cells(folder, "flat3").files[form], form)
    add("OFF of flat3 by meshio", check_off_meshio, Cells(folder, "flat3"), Cells(folder, "flat3").files["off"])
    for name in ("mixed", "curved6", "curved8", "curved9", "kinds"):
        mesh = Cells(folder, name)
        if "unv" in mesh.files:
            add(f"UNV of {name} by gmsh", check_gmsh, mesh, mesh.files["unv"])
            add(f"UNV of {name}", check_unv_cells, mesh, mesh.files["unv"])
        if "nastran" in mesh.files:
            add(f"Nastran of {name} by meshio", check_nastran_meshio, mesh, mesh.files["nastran"])
            add(f"Nastran of {name} by gmsh", check_nastran_gmsh, mesh, mesh.files["nastran"])
        add(f"2DM of {name}", check_two_dm, mesh, mesh.files["2dm"])
    return result
