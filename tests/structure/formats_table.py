"""Keeps core/files/FORMATS.md, the table of all file formats, equal to what the program says of itself.

    formats_table.py PROGRAM ROOT [--update]

PROGRAM is forefront. Prints what differs, or writes the table anew with --update. The programs that read each format are
listed here, each with the script that lets them read our files; a format without an entry is a fault.
"""
import json
import pathlib
import re
import subprocess
import sys

CHECK = "check_readers.py"
HEAVY = "heavy_readers.sh"
# By format: the programs that read exported files, and the script or test that lets them.
READ_BY = {
    "svg": ("librsvg", CHECK),
    "dxf": ("own reader", "../unit/test_io_dxf_write.cpp"),
    "dxf-outline": ("own reader", "../unit/test_io_dxf_write.cpp"),
    "msh2": ("Gmsh, meshio, GetFEM, FreeFem++; deal.II, dolfinx", f"{CHECK}; {HEAVY}"),
    "msh41": ("Gmsh, meshio, GetFEM; deal.II, dolfinx", f"{CHECK}; {HEAVY}"),
    "msh41-binary": ("Gmsh, meshio; dolfinx", f"{CHECK}; {HEAVY}"),
    "vtu": ("meshio, VTK", CHECK),
    "vtk": ("Gmsh, meshio, VTK, FreeFem++; deal.II", f"{CHECK}; {HEAVY}"),
    "xdmf": ("dolfinx; meshio, one grid at a time; QGIS (MDAL) reads no meshes from XDMF", "check_xdmf.py; check_qgis.py"),
    "medit": ("Gmsh, meshio, FreeFem++", CHECK),
    "mfem": ("MFEM, by hand; own parser", f"{CHECK}; check_mfem.cpp"),
    "inp": ("CalculiX, meshio", CHECK),
    "su2": ("meshio; markers by own parser: SU2 is not in Debian", CHECK),
    "unv": ("Gmsh; groups by own parser", CHECK),
    "nastran": ("Gmsh, meshio", CHECK),
    "openfoam": ("checkMesh and laplacianFoam of OpenFOAM", "check_openfoam.py"),
    "2dm": ("QGIS (MDAL), whose release 3.22 refuses quadrilaterals of 8 and 9 nodes; own parser", f"{CHECK}; check_qgis.py"),
    "adcirc": ("own parser: ADCIRC is not in Debian", CHECK),
    "gr3": ("own parser: SCHISM is not in Debian", CHECK),
    "selafin": ("QGIS (MDAL); own parser", f"{CHECK}; check_qgis.py"),
    "ugrid": ("QGIS (MDAL), SciPy", f"{CHECK}; check_qgis.py"),
    "mike": ("own parser: MIKE is not in Debian", CHECK),
    "anuga": ("own parser: ANUGA is not in Debian", CHECK),
    "triangle": ("own parser: Triangle is not in Debian's main part", CHECK),
    "obj": ("VTK", CHECK),
    "ply": ("VTK", CHECK),
    "stl": ("VTK", CHECK),
    "off": ("meshio, triangles alone; own parser", CHECK),
}
KINDS = {"triangle3": "triangles", "triangle6": "triangles of 6 nodes", "quadrilateral4": "quadrilaterals",
         "quadrilateral8": "quadrilaterals of 8 nodes", "quadrilateral9": "quadrilaterals of 9 nodes"}

INTRODUCTION = """# File formats

Made by `tests/structure/formats_table.py` from what `forefront formats --json` prints, which a test compares; change the lists of
formats and that script, not this file.

## Written

All formats keep the coordinates of nodes, in double precision unless the table says otherwise, and the elements. Values of nodes
and elements other than elevations are not written. "Lost" lists what a format has no place for: kinds of elements (a mesh with
such elements is refused, with the formats that hold them) and elevations (left out, with a note). The scripts lie in
[`tests/readers`](../../tests/readers). A build with tests runs them by

```sh
python3 tests/readers/check_readers.py build/release/tests/forefront_export_sample                # in every run of the tests
python3 tests/readers/check_xdmf.py build/release/tests/forefront_export_sample RESULT.txt        # and check_openfoam, check_qgis
sh tests/readers/heavy_readers.sh build/release/tests/forefront_export_sample
```

QGIS 3.22 reads XDMF only as values of a mesh that another file holds, a time series of values of elements; `check_qgis.py` shows that
our files are refused as a mesh and as values. For QGIS, write 2DM, UGRID or SELAFIN. Of 2DM it reads triangles of 3 and,
as polygons, of 6 nodes, and quadrilaterals of 4; it does not recognise a file with quadrilaterals of 8 or 9 nodes, which the same script shows.
[The sample Bay with its depths](../../tests/readers/bay_by_qgis.png), a UGRID file, as QGIS draws it.

MFEM holds second order as a grid function `nodes`, whose values follow the numbers that MFEM itself gives the edges: in the
order in which the elements name them first. MFEM is not in Debian, so that `check_mfem.cpp`, which reads our files with it, is
compiled and run by hand: [`mfem.txt`](../../tests/readers/mfem.txt).

The last results of those that need large packages lie beside them: [`xdmf.txt`](../../tests/readers/xdmf.txt),
[`openfoam.txt`](../../tests/readers/openfoam.txt), [`qgis.txt`](../../tests/readers/qgis.txt) and
[`heavy_readers.txt`](../../tests/readers/heavy_readers.txt).
"""


def lost(entry):
    parts = [name for kind, name in KINDS.items() if kind not in entry["elements"]]
    parts += [] if entry["elevations"] else ["elevations"]
    return ", ".join(parts) or "nothing of these"


def table(formats):
    lines = [INTRODUCTION, "| format | files | kept | lost | read by | script |", "|---|---|---|---|---|---|"]
    for entry in formats:
        if entry["writes_mesh"]:
            programs, script = READ_BY[entry["id"]]
            needs = f" Needs `forefront-{entry['component']}`." if entry["component"] else ""
            lines.append(f"| `{entry['id']}` {entry['name']} | `{entry['extensions']}` | {entry['keeps']}{needs} | {lost(entry)} | "
                         f"{programs} | `{script.replace('; ', '`, `')}` |")
    lines += ["", "## Read", "", "| format | files | reads | needs |", "|---|---|---|---|"]
    for entry in formats:
        if entry["reads"]:
            component = f"`forefront-{entry['component']}`" if entry["component"] else ""
            lines.append(f"| `{entry['id']}` {entry['name']} | `{entry['extensions']}` | {', '.join(entry['reads'])} | "
                         f"{component} |")
    return "\n".join(lines) + "\n"


def faults(formats, root):
    written = {entry["id"] for entry in formats if entry["writes_mesh"]}
    yield from (f"formats_table.py: no program is listed for the format {name}" for name in sorted(written - set(READ_BY)))
    yield from (f"formats_table.py: the format {name} is not written" for name in sorted(set(READ_BY) - written))
    for _, scripts in READ_BY.values():
        for script in scripts.split("; "):
            if not (root / "tests/readers" / script).exists():
                yield f"formats_table.py: tests/readers/{script} does not exist"


def main():
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    printed = subprocess.run([program, "formats", "--json"], capture_output=True, text=True, check=True).stdout
    formats = json.loads(printed)["formats"]
    found = list(faults(formats, root))
    if not found:
        file, text = root / "core/files/FORMATS.md", table(formats)
        if "--update" in sys.argv:
            file.write_text(text, encoding="utf-8")
        elif not file.exists() or file.read_text(encoding="utf-8") != text:
            found = ["core/files/FORMATS.md differs from what the program says; make it anew with "
                     "tests/structure/formats_table.py PROGRAM ROOT --update"]
    print("\n".join(found) if found else f"{len(formats)} formats")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
