"""Checks exported XDMF files with dolfinx (FEniCSx), whose packages are some 500 MB on the disc, so that the ordinary tests
leave it out, and with meshio, which reads one grid of a file.

    check_xdmf.py EXPORT_SAMPLE RESULT      (needs the Debian packages python3-dolfinx-real, python3-meshio, python3-h5py)

EXPORT_SAMPLE is the helper that writes the files. The outcome is printed and written to RESULT. Exit status 77: a package
is missing.
"""
import datetime
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True  # keeps the source tree clean
from common import Samples, compare, measures, near, same

try:
    import dolfinx
    import meshio
    import numpy
    import ufl
    from dolfinx.io import XDMFFile
    from mpi4py import MPI
    from petsc4py import PETSc
    import h5py  # noqa: F401  used by meshio
    from check_cells import Cells
except ImportError as problem:
    print("readers missing:", problem)
    sys.exit(77)


def names_in(file, kind):
    """The tags by name, from the <Information> elements."""
    found = {}
    for item in ElementTree.parse(file).getroot().iter("Information"):
        word, tag = item.get("Name").split()
        if word == kind:
            found[item.get("Value")] = int(tag)
    return found


def one_grid(file, name):
    """Writes a copy of the file that has only the grid `name`, as meshio expects."""
    tree = ElementTree.parse(file)
    domain = tree.getroot().find("Domain")
    for child in list(domain):
        if child.tag != "Grid" or child.get("Name") != name:
            domain.remove(child)
    copy = pathlib.Path(file).with_name(f"{pathlib.Path(file).stem}-{name}.xdmf")
    tree.write(copy)
    return copy


def check_meshio(sample, file):
    for grid, shape, values, parts in (("mesh", "triangle", "region", sample.regions),
                                       ("boundary", "line", "boundary", sample.edges)):
        mesh = meshio.read(one_grid(file, grid))
        same(len(mesh.points), sample.nodes, "nodes")
        [block], [tags] = mesh.cells, mesh.cell_data[values]
        same(block.type, shape, "cells")
        found = measures((int(tag), mesh.points[row]) for row, tag in zip(block.data, tags.ravel()))
        compare(found, parts, lambda name, parts=parts: parts[name]["tag"], f"meshio {grid}")
    same({**names_in(file, "region")}, {name: part["tag"] for name, part in sample.regions.items()}, "names")


def read_dolfinx(file):
    with XDMFFile(MPI.COMM_SELF, file, "r") as data:
        mesh = data.read_mesh(name="mesh")
        mesh.topology.create_connectivity(1, 2)
        return mesh, data.read_meshtags(mesh, name="mesh"), data.read_meshtags(mesh, name="boundary")


def check_dolfinx(sample, file):
    mesh, cells, facets = read_dolfinx(file)
    one = dolfinx.fem.Constant(mesh, PETSc.ScalarType(1))
    for kind, tags, parts in (("dx", cells, sample.regions), ("ds", facets, sample.edges)):
        same(len(tags.indices), sum(part["count"] for part in parts.values()), "tagged cells")
        inner = kind == "ds"
        measure = ufl.Measure(kind, domain=mesh, subdomain_data=tags)
        within = ufl.Measure("dS", domain=mesh, subdomain_data=tags)
        for name, part in parts.items():
            size = dolfinx.fem.assemble_scalar(dolfinx.fem.form(one * measure(part["tag"])))
            if inner:  # a facet inside the domain
                size += dolfinx.fem.assemble_scalar(dolfinx.fem.form(one * within(part["tag"])))
            near(size, part["length" if inner else "area"])


def check_heat(sample, file):
    """div(k grad u) = 0 with k = 1 in the steel and 3 in the copper: u = 3x left of the seam and x + 4 right of it."""
    mesh, cells, facets = read_dolfinx(file)
    regions = names_in(file, "region")
    space = dolfinx.fem.FunctionSpace(mesh, ("CG", 1))
    trial, test = ufl.TrialFunction(space), ufl.TestFunction(space)
    k = dolfinx.fem.Function(dolfinx.fem.FunctionSpace(mesh, ("DG", 0)))
    k.x.array[cells.find(regions["steel"])] = 1
    k.x.array[cells.find(regions["copper"])] = 3
    exact = dolfinx.fem.Function(space)
    exact.interpolate(lambda x: numpy.where(x[0] < 2, 3 * x[0], x[0] + 4))
    outer = numpy.concatenate([facets.find(part["tag"]) for part in sample.edges.values() if part["tag"] <= 5])
    held = dolfinx.fem.dirichletbc(exact, dolfinx.fem.locate_dofs_topological(space, 1, outer))
    from dolfinx.fem.petsc import LinearProblem
    zero = dolfinx.fem.Constant(mesh, PETSc.ScalarType(0))
    solved = LinearProblem(k * ufl.dot(ufl.grad(trial), ufl.grad(test)) * ufl.dx, zero * test * ufl.dx, bcs=[held],
                           petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()
    worst = numpy.abs(solved.x.array - exact.x.array).max()
    assert worst < 1e-9, f"the solution is wrong by {worst}"


def check_area(cells):
    """Curved edges are parabolas, which elements of second order represent exactly."""
    with XDMFFile(MPI.COMM_SELF, cells.files["xdmf"], "r") as data:
        mesh = data.read_mesh(name="mesh")
    same(len(mesh.geometry.x), len(cells.nodes), "nodes")
    one = dolfinx.fem.Constant(mesh, PETSc.ScalarType(1))
    near(dolfinx.fem.assemble_scalar(dolfinx.fem.form(one * ufl.Measure("dx", domain=mesh))), cells.area(), 1e-9)


def main():
    program, result = sys.argv[1:]
    samples = Samples(program)
    checks = []
    for name in ("sample", "twins"):
        sample = samples[name]
        file = sample.files["xdmf"]
        checks += [(f"meshio: regions and boundary parts of {name}", lambda s=sample, f=file: check_meshio(s, f)),
                   (f"dolfinx: regions and boundary parts of {name}", lambda s=sample, f=file: check_dolfinx(s, f))]
    sample = samples["sample"]
    checks.append(("dolfinx: two materials solved", lambda: check_heat(sample, sample.files["xdmf"])))
    for name in ("flat3", "curved6"):
        cells = Cells(samples.folder, name)
        checks.append((f"dolfinx: area of {name}", lambda c=cells: check_area(c)))
    lines, passed = samples.run(checks)
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}\\n", "python3-dolfinx-real", "python3-meshio",
                              "python3-h5py"], capture_output=True, text=True)
    pathlib.Path(result).write_text("\n".join([f"Last run: {datetime.date.today()}", version.stdout, *lines]) + "\n")
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main()
