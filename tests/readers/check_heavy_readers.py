"""Reads exported meshes with deal.II and dolfinx, whose packages are too large for every run of the tests.

    check_heavy_readers.py EXPORT_SAMPLE DEALII_READER RESULT

EXPORT_SAMPLE is the helper that writes the files, DEALII_READER the program built from dealii_reader.cpp. The outcome is
printed and written to RESULT.
"""
import datetime
import json
import pathlib
import subprocess
import sys

import gmsh
from dolfinx.io import gmshio
from mpi4py import MPI

sys.dont_write_bytecode = True  # keeps the source tree clean
from common import Samples, compare, measures, near, same


def check_dealii(sample, file, kind, numbers, program):
    run = subprocess.run([program, kind, file], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr[-1500:]
    found = json.loads(run.stdout)
    same(found["nodes"], sample.nodes, "nodes")
    for key, parts in (("regions", sample.regions), ("edges", sample.edges)):
        compare({int(number): part for number, part in found[key].items()}, parts,
                lambda name: numbers(parts[name]), "deal.II")


def check_dealii_refuses(file, program):
    """If deal.II accepts boundary ids on inner edges one day, the advice in the README can go."""
    run = subprocess.run([program, "msh", file], capture_output=True, text=True)
    assert run.returncode == 1 and "internal face" in run.stderr, run.stderr[-1500:]


def check_dolfinx(sample, file):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(file)
    mesh, cells, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_SELF, 0, gdim=2)
    gmsh.finalize()
    places = mesh.geometry.x
    same(len(places), sample.nodes, "nodes")
    corners_of_cell = mesh.geometry.dofmap
    near(len(cells.indices), sample.elements)
    found = measures(((int(value), [places[n][:2] for n in corners_of_cell.links(cell)])
                      for cell, value in zip(cells.indices, cells.values)), signed=False)
    compare(found, sample.regions, lambda name: sample.msh_number(sample.regions[name]), "dolfinx regions")
    mesh.topology.create_connectivity(1, 0)
    mesh.topology.create_connectivity(2, 0)
    vertices = mesh.topology.connectivity(1, 0)
    node_of_vertex = {}
    for cell in range(len(cells.indices)):
        node_of_vertex.update(zip(mesh.topology.connectivity(2, 0).links(cell), corners_of_cell.links(cell)))
    found = measures((int(value), [places[node_of_vertex[v]][:2] for v in vertices.links(facet)])
                     for facet, value in zip(facets.indices, facets.values))
    compare(found, sample.edges, lambda name: sample.edges[name]["tag"], "dolfinx boundaries")


def versions():
    packages = ["libdeal.ii-dev", "python3-dolfinx-real", "gmsh"]
    run = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}\n", *packages], capture_output=True, text=True)
    return run.stdout.splitlines()


def main():
    program, dealii, result = sys.argv[1:]
    samples = Samples(program)
    sample, outline, twins = samples["sample"], samples["sample-outline"], samples["twins-outline"]

    def by_tag(part):
        return part["tag"]
    checks = []
    for s, name in ((outline, ""), (twins, " with twin names")):
        for kind in ("msh2", "msh41"):
            checks.append((f"{kind} without inner edges by deal.II{name}",
                           lambda s=s, kind=kind: check_dealii(s, s.files[kind], "msh", s.msh_number, dealii)))
            checks.append((f"{kind} by dolfinx{name}", lambda s=s, kind=kind: check_dolfinx(s, s.files[kind])))
    checks += [("msh41-binary by dolfinx", lambda: check_dolfinx(sample, sample.files["msh41-binary"])),
               ("msh2 with inner edges by dolfinx", lambda: check_dolfinx(sample, sample.files["msh2"])),
               ("VTK legacy without inner edges by deal.II",
                lambda: check_dealii(outline, outline.files["vtk"], "vtk", by_tag, dealii)),
               ("inner edges are refused by deal.II", lambda: check_dealii_refuses(sample.files["msh2"], dealii))]
    lines, passed = samples.run(checks)
    pathlib.Path(result).write_text("\n".join([f"Last run: {datetime.date.today()}", *versions(), "", *lines]) + "\n")
    sys.exit(0 if passed else 1)


main()
