"""Checks exported cases with OpenFOAM, whose package is some 150 MB on the disc, so that the ordinary tests leave it out.

    check_openfoam.py EXPORT_SAMPLE RESULT      (needs the Debian package openfoam)

EXPORT_SAMPLE is the helper that writes the files. The outcome is printed and written to RESULT. Exit status 77: OpenFOAM is
missing.
"""
import datetime
import os
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True  # keeps the source tree clean
from check_cells import Cells
from common import Samples, near, same
from foam_case import FoamMesh, read_temperatures, write_heat_case


def run_foam(program, case):
    run = subprocess.run([program, "-case", str(case)], capture_output=True, text=True,
                         env={"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ})
    assert run.returncode == 0, run.stdout[-1500:] + run.stderr[-500:]
    return run.stdout


def check_mesh(case, fixed):
    mesh = FoamMesh(case)
    write_heat_case(case, mesh, fixed)
    assert "\nMesh OK.\n" in run_foam("checkMesh", case), "checkMesh complains"
    return mesh


def check_parts(sample):
    mesh = check_mesh(sample.files["openfoam"], {})
    same(sorted(mesh.patches), sorted([name for name in sample.edges if name != "seam"] + ["frontAndBack"]), "patches")
    same(mesh.patches["frontAndBack"][0], "empty", "type of frontAndBack")
    same(sorted(mesh.cell_zones), sorted(sample.regions), "cell zones")
    for name, part in sample.regions.items():
        same(len(mesh.cell_zones[name]), part["count"], f"cells of {name}")


def check_kinds(cells):
    """Prisms beside hexahedra: the patches and cell zones of the parts, and the volume by the area and the height."""
    mesh = check_mesh(cells.files["openfoam"], {})
    corners = [len(nodes) for *_, nodes in cells.elements()]
    assert {3, 4} == set(corners), "the sample must have both kinds"
    same(mesh.cells, len(corners), "cells")
    caps = [len(mesh.faces[face]) for face in mesh.patches["frontAndBack"][1]]
    same(sorted(caps), sorted(2 * corners), "corners of the faces in front and at the back")
    near(sum(mesh.volumes()), cells.area() * max(p[2] for p in mesh.points))


def check_heat(sample, layers, program):
    """T = 0 on the left and 10 on the right of a strip of length 10: T = x."""
    case = sample.files["openfoam"]
    if layers > 1:
        case = str(pathlib.Path(case).with_name("layers.foam"))
        subprocess.run([program, "--extrude", sample.files["msh2"], case, "0.6", str(layers)], check=True)
    mesh = check_mesh(case, {"left": 0, "right": 10})
    run_foam("laplacianFoam", case)
    values = read_temperatures(case)
    same(len(values), sample.elements * layers, "values")
    worst = max(abs(value - centre[0]) for value, centre in zip(values, mesh.centres()))
    assert worst < 1e-6, f"T differs from x by {worst}"
    near(sum(mesh.volumes()), sample.area() * max(p[2] for p in mesh.points))


def main():
    if not shutil.which("checkMesh"):
        print("OpenFOAM is missing")
        sys.exit(77)
    program, result = sys.argv[1:]
    samples = Samples(program)
    checks = [("checkMesh: Mesh OK, patches and cell zones", lambda: check_parts(samples["sample"])),
              ("checkMesh: twin names", lambda: check_mesh(samples["twins"].files["openfoam"], {})),
              ("checkMesh: prisms and hexahedra", lambda: check_kinds(Cells(samples.folder, "mixed"))),
              ("laplacianFoam: T = x to 1e-6, one layer", lambda: check_heat(samples["strip"], 1, program)),
              ("laplacianFoam: T = x to 1e-6, three layers", lambda: check_heat(samples["strip"], 3, program))]
    lines, passed = samples.run(checks)
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}", "openfoam"], capture_output=True, text=True)
    pathlib.Path(result).write_text("\n".join([f"Last run: {datetime.date.today()}", version.stdout, "", *lines]) + "\n")
    sys.exit(0 if passed else 1)


main()
