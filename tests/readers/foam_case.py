"""Reads the mesh of a case of OpenFOAM (polyMesh, ASCII), and writes the rest of a case for laplacianFoam."""
import pathlib
import re

HEADER = "FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"
FILES = {
    "system/controlDict": ("dictionary", "application laplacianFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; "
                           "deltaT 1; writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 15; "
                           "runTimeModifiable no;"),
    "system/fvSchemes": ("dictionary", "ddtSchemes { default steadyState; } gradSchemes { default leastSquares; } "
                         "divSchemes { default none; } laplacianSchemes { default Gauss linear corrected; } "
                         "interpolationSchemes { default linear; } snGradSchemes { default corrected; }"),
    "system/fvSolution": ("dictionary", "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-15; relTol 0; } } "
                          "SIMPLE { nNonOrthogonalCorrectors 60; }"),
    "constant/transportProperties": ("dictionary", "DT DT [0 2 -1 0 0 0 0] 1;"),
}


class FoamMesh:
    """points, faces (node lists), owner, neighbour, patches {name: (type, faces)}, cell_zones {name: cells}."""

    def __init__(self, case):
        folder = pathlib.Path(case) / "constant/polyMesh"

        def body(name):
            return (folder / name).read_text().split("}", 1)[1]
        self.points = [tuple(map(float, row.split())) for row in re.findall(r"\(([^()\n]+)\)", body("points"))]
        self.faces = [list(map(int, row.split())) for row in re.findall(r"\d\(([\d ]+)\)", body("faces"))]
        self.owner, self.neighbour = (list(map(int, re.findall(r"\d+", body(name))))[1:] for name in ("owner", "neighbour"))
        self.patches = {}
        for name, kind, count, first in re.findall(
                r"(\w+)\s*\{\s*type\s+(\w+);\s*nFaces\s+(\d+);\s*startFace\s+(\d+);", body("boundary")):
            self.patches[name] = (kind, range(int(first), int(first) + int(count)))
        self.cell_zones = {}
        for name, cells in re.findall(r"(\w+)\s*\{[^}]*cellLabels List<label>\s*\d+\s*\(([\d\s]*)\)", body("cellZones")):
            self.cell_zones[name] = list(map(int, cells.split()))
        self.cells = 1 + max(self.owner)

    def face_area(self, face):
        """Vector of the area of a face and its centre."""
        corners = [self.points[n] for n in self.faces[face]]
        middle = [sum(p[k] for p in corners) / len(corners) for k in range(3)]
        total = [0.0, 0.0, 0.0]
        for p, q in zip(corners, corners[1:] + corners[:1]):
            a, b = ([p[k] - middle[k] for k in range(3)], [q[k] - middle[k] for k in range(3)])
            for k in range(3):
                total[k] += 0.5 * (a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2])
        return total, middle

    def volumes(self):
        """Volume of each cell by the divergence theorem; negative parts show where a normal points the wrong way."""
        volumes = [0.0] * self.cells
        for face in range(len(self.faces)):
            area, middle = self.face_area(face)
            part = sum(a * m for a, m in zip(area, middle)) / 3.0
            volumes[self.owner[face]] += part
            if face < len(self.neighbour):
                volumes[self.neighbour[face]] -= part
        return volumes

    def centres(self):
        """Mean of the corners of each cell, which is the centroid of a prism."""
        nodes = [set() for _ in range(self.cells)]
        for face, corners in enumerate(self.faces):
            nodes[self.owner[face]].update(corners)
            if face < len(self.neighbour):
                nodes[self.neighbour[face]].update(corners)
        return [tuple(sum(self.points[n][k] for n in each) / len(each) for k in range(3)) for each in nodes]


def write_heat_case(case, mesh, fixed):
    """Writes a case of steady heat with the given temperatures on some patches and no flux through the others."""
    case = pathlib.Path(case)
    fields = "".join(
        f"{name} {{ type {'empty' if kind == 'empty' else 'fixedValue' if name in fixed else 'zeroGradient'}; "
        + (f"value uniform {fixed[name]}; " if name in fixed else "") + "}\n" for name, (kind, _) in mesh.patches.items())
    files = dict(FILES)
    files["0/T"] = ("volScalarField", "dimensions [0 0 0 1 0 0 0];\ninternalField uniform 0;\nboundaryField\n{\n" + fields + "}")
    for name, (kind, text) in files.items():
        (case / name).parent.mkdir(parents=True, exist_ok=True)
        (case / name).write_text(HEADER.format(kind=kind, name=pathlib.Path(name).name) + text + "\n")


def read_temperatures(case):
    text = (pathlib.Path(case) / "1/T").read_text()
    return list(map(float, re.search(r"nonuniform List<scalar>\s*\d+\s*\(([^)]*)\)", text)[1].split()))
