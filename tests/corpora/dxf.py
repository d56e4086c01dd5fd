#!/usr/bin/python3
"""Reads public DXF drawings, compares their curves with those that ezdxf finds, meshes them and prints tables.

    python3 tests/corpora/dxf.py fetch --corpus DIR [--repositories DIR] [--only REPOSITORY]...
    python3 tests/corpora/dxf.py run   --corpus DIR --build build/release [--only REPOSITORY]... >tests/corpora/dxf.md

For each file, `run` compares by layer the length and the bounds of all curves with those of ezdxf, flattened finely. Then
it meshes the file and checks the mesh against it. If all curves of a file are closed, the area of the mesh is compared
with that of the faces inside an odd number of them, by GEOS.

The files come from public repositories and from Debian packages of programs, which must be in the sources of apt. Needs
the Debian packages git, python3-ezdxf and python3-shapely.
"""

import argparse
import collections
import json
import logging
import math
import pathlib
import signal
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # keeps the source tree clean
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "readers"))
import dxf_reference as reference
import shapely.geometry as geometry
import shapely.ops as operations
import sources

# repository, licence, maximum number of files, patterns
REPOSITORIES = [
    ("mozman/ezdxf", "MIT", 150, ["*.dxf"]),
    ("skymakerolof/dxf", "MIT", 150, ["*.dxf"]),
    ("openscad/openscad", "GPL-2.0", 150, ["*.dxf"]),
    ("LibreCAD/LibreCAD", "GPL-2.0", 60, ["*.dxf"]),
    ("jscad/sample-files", "not stated", 150, ["*.dxf"]),
    ("joco-nz/dxf2gcode-plasma", "not stated", 150, ["*.dxf", "*.DXF"]),
    ("bert/libdxf", "GPL-2.0", 150, ["*.dxf"]),
    ("gdsestimating/dxf-parser", "MIT", 150, ["*.dxf"]),
    ("arbaev/dxf-kit", "MIT", 150, ["*.dxf"]),
    ("dotoritos-kim/dxf-json", "GPL-3.0", 150, ["*.dxf"]),
]
# Debian package, licence, maximum number of files
PACKAGES = [("librecad-data", "GPL-2.0", 60), ("freecad-common", "LGPL-2.1", 60)]
MAX_BYTES = 400_000  # of a file: ezdxf is slow
SECONDS = 20  # for ezdxf and for meshing one file
MAX_AREA_ERROR = 0.005


def some(paths, limit):
    return paths[:: max(1, math.ceil(len(paths) / limit))]


def fetch(corpus, clones, only):
    def keep(name, path, content):
        if len(content) <= MAX_BYTES:
            folder = corpus / name.replace("/", "+")
            folder.mkdir(parents=True, exist_ok=True)
            (folder / path.replace("/", "_").replace(" ", "_")).write_bytes(content)

    with tempfile.TemporaryDirectory() as scratch:
        for name, _, limit, patterns in REPOSITORIES:
            if not only or name in only:
                repository = sources.open_repository(name, clones, scratch)
                for path, content in repository.read(some(repository.paths(*patterns), limit)):
                    keep(name, path, content)
        for name, _, limit in PACKAGES:
            if not only or name in only:
                unpacked = pathlib.Path(scratch, name)
                subprocess.run(["apt-get", "download", name], cwd=scratch, check=True, capture_output=True)
                package = next(pathlib.Path(scratch).glob(f"{name}_*.deb"))
                subprocess.run(["dpkg-deb", "--extract", package, unpacked], check=True)
                for path in some(sorted(unpacked.rglob("*.[dD][xX][fF]")), limit):
                    keep(name, str(path.relative_to(unpacked)), path.read_bytes())


def even_odd_area(lines, size):
    """Returns the area inside an odd number of closed lines; None if one of them is open."""
    if not lines or any(len(line) < 4 or math.dist(line[0], line[-1]) > 1e-9 * size for line in lines):
        return None
    rings = []
    for line in lines:  # one drawn twice counts once
        polygon = geometry.Polygon(line)
        if not any(abs(polygon.area - other.area) < 1e-6 * size * size and polygon.bounds == other.bounds
                   for other in rings):
            rings.append(polygon)
    area = 0.0
    faces = operations.polygonize(operations.unary_union([ring.exterior for ring in rings]))
    for face in faces:
        point = face.representative_point()
        inside = sum(1 for ring in rings for part in operations.polygonize(operations.unary_union(ring.exterior))
                     if part.contains(point))
        area += face.area if inside % 2 else 0.0
    return area


def reference_of(path):
    """Returns the measures of ezdxf and the area; the error in words if it cannot read the file."""
    def stop(*_):
        raise TimeoutError("too slow")

    signal.signal(signal.SIGALRM, stop)
    signal.alarm(SECONDS)
    try:
        measured = reference.measure(path)
        boxes = [layer["box"] for layer in measured["layers"].values()]
        size = max((math.dist(box[:2], box[2:]) for box in boxes), default=1.0)
        lines = [line for _, line in reference.lines_of(reference.document_in(path))]
        hidden = any(layer.is_off() or layer.is_frozen() for layer in reference.document_in(path).layers)
        return measured, None if hidden or len(lines) > 300 else even_odd_area(lines, size)
    except Exception as fault:  # pylint: disable=broad-exception-caught
        return f"{type(fault).__name__}: {fault}"[:80], None
    finally:
        signal.alarm(0)


def last_error(text):
    faults = [line for line in text.splitlines() if "error" in line] or [text.strip() or "no message"]
    return faults[0].split("[")[-1].split("]")[0] if "[" in faults[0] else faults[0][:60]


def run_bounded(command):
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=SECONDS)
        return done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        return "slow", "", ""


def judge(build, path):
    """Returns a row of what happened with one file."""
    row = {"file": path.name}
    code, out, _ = run_bounded([build / "tests/forefront_dxf_paths", path])
    theirs, area = reference_of(path)
    if code not in (0, 1):
        row["curves"] = f"exit {code}"
    elif code == 1:
        row["curves"] = "refused: " + last_error(out)
    elif isinstance(theirs, str):
        row["curves"] = "no reference"
    else:
        found = reference.differences(json.loads(out), theirs)
        row["curves"] = "differ: " + "; ".join(found) if found else "same"
    with tempfile.TemporaryDirectory() as scratch:
        mesh, statistics = pathlib.Path(scratch, "mesh.msh"), pathlib.Path(scratch, "mesh.json")
        code, _, errors = run_bounded([build / "app/forefront", "mesh", path, "-o", mesh, "--format", "msh41-binary",
                                       "--stats", statistics, "--threads", "1"])
        row["mesh"] = "meshed" if code == 0 else last_error(errors) if code == 1 else f"exit {code}"
        if code == 0:
            row["valid"] = run_bounded([build / "app/forefront", "check", mesh, "--domain", path])[0] == 0
            if area:
                row["area"] = abs(json.loads(statistics.read_text())["area"] - area) <= MAX_AREA_ERROR * area
    return row


def run(corpus, build, only):
    print("# DXF drawings: the last table\n\nMade with `dxf.py run`.\n")
    print("| source | licence | files | curves as by ezdxf | differ | no reference | refused | meshed | valid | area right | not "
          "meshed |\n|---|---|---|---|---|---|---|---|---|---|---|")
    remarks = []
    for name, licence in [each[:2] for each in REPOSITORIES + PACKAGES]:
        if only and name not in only:
            continue
        rows = [judge(build, path) for path in sorted((corpus / name.replace("/", "+")).iterdir())]
        curves = collections.Counter(row["curves"].split(":")[0] for row in rows)
        others = collections.Counter(row["mesh"] for row in rows if row["mesh"] != "meshed")
        areas = [row["area"] for row in rows if "area" in row]
        print(f"| {name} | {licence} | {len(rows)} | {curves['same']} | {curves['differ']} | {curves['no reference']} | "
              f"{curves['refused']} | {sum(row['mesh'] == 'meshed' for row in rows)} | "
              f"{sum(row.get('valid', False) for row in rows)} | {sum(areas)} of {len(areas)} | "
              f"{', '.join(f'{count} {reason}' for reason, count in others.most_common()) or 0} |", flush=True)
        for row in rows:
            usual = row["curves"] in ("same", "no reference") and row.get("valid", True) and row.get("area", True)
            if not usual or row["mesh"].startswith("exit"):
                remarks.append(f"| {name}/{row['file']} | {row['curves']} | {row['mesh']} | "
                               f"{row.get('valid', '')} | {row.get('area', '')} |")
    print("\n| remarkable file | curves | mesh | valid | area right |\n|---|---|---|---|---|")
    print("\n".join(remarks))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["fetch", "run"])
    parser.add_argument("--corpus", type=pathlib.Path, required=True, help="folder of the files")
    parser.add_argument("--repositories", type=pathlib.Path, help="folder of clones named OWNER+NAME")
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--only", action="append", help="repository or package, such as mozman/ezdxf; default: all")
    arguments = parser.parse_args()
    logging.disable(logging.CRITICAL)
    if arguments.command == "fetch":
        fetch(arguments.corpus, arguments.repositories, arguments.only)
    else:
        run(arguments.corpus, arguments.build, arguments.only)


if __name__ == "__main__":
    main()
