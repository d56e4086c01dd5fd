#!/usr/bin/python3
"""Meshes public problems of FEMM, checks the meshes and prints tables.

    python3 tests/corpora/femm.py fetch --corpus DIR [--repositories DIR]
    python3 tests/corpora/femm.py run   --corpus DIR --build build/release >tests/corpora/femm.md

For each file, `run` meshes it, checks the mesh against it, and compares the area of the mesh with that of the faces that
GEOS finds between the lines and arcs, without those that hold a hole or a label without a mesh. Files with the same
content count once.

Needs the Debian packages git and python3-shapely.
"""

import argparse
import collections
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # keeps the source tree clean
import shapely.geometry as geometry
import shapely.ops as operations
import sources

# repository, licence
REPOSITORIES = [
    ("crobarcro/xfemm", "AFPL and others"),
    ("tamasorosz/py2femm", "AGPL-3.0"),
    ("aimthiazz/OpenSourceMotorDesignWorkflow", "MIT"),
]
PATTERNS = [f"*.{letters}" for extension in ("fem", "fee", "feh", "fec") for letters in (extension, extension.upper())]
SECONDS = 60  # for meshing one file
MAX_AREA_ERROR = 0.005
DEGREES_PER_CHORD = 0.5


def fetch(corpus, clones):
    with tempfile.TemporaryDirectory() as scratch:
        for name, _ in REPOSITORIES:
            folder = corpus / name.replace("/", "+")
            folder.mkdir(parents=True, exist_ok=True)
            repository = sources.open_repository(name, clones, scratch)
            seen = set()
            for path, content in repository.read(sorted(set(repository.paths(*PATTERNS)))):
                if content not in seen:
                    seen.add(content)
                    (folder / re.sub(r"[/ ]", "_", path)).write_bytes(content)


def table_of(text, key):
    """Returns the rows of numbers that follow a line such as [NumPoints] = 4."""
    lines = text.splitlines()
    for at, line in enumerate(lines):
        if line.strip().lower().startswith(f"[{key}]"):
            count = int(line.split("=")[1])
            return [[float(word) for word in re.findall(r"[-+.\deE]+", row)[:9]] for row in lines[at + 1:at + 1 + count]]
    return []


def arc(a, b, degrees):
    """Returns points on the arc from a to b, counter-clockwise."""
    height = 0.5 / math.tan(math.radians(degrees) / 2)  # of the centre over the chord, in chords
    along = (b[0] - a[0], b[1] - a[1])
    centre = (0.5 * (a[0] + b[0]) - height * along[1], 0.5 * (a[1] + b[1]) + height * along[0])
    radius, start = math.dist(a, centre), math.atan2(a[1] - centre[1], a[0] - centre[0])
    count = max(2, math.ceil(degrees / DEGREES_PER_CHORD))
    inner = [start + math.radians(degrees) * k / count for k in range(1, count)]
    return [a, *((centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in inner), b]


def area_of(path):
    """Returns the area to be meshed."""
    text = path.read_text(errors="replace")
    nodes = [tuple(row[:2]) for row in table_of(text, "numpoints")]
    lines = [(nodes[int(row[0])], nodes[int(row[1])]) for row in table_of(text, "numsegments")]
    lines += [arc(nodes[int(row[0])], nodes[int(row[1])], row[2]) for row in table_of(text, "numarcsegments")]
    holes = [row[:2] for row in table_of(text, "numholes")]
    holes += [row[:2] for row in table_of(text, "numblocklabels") if row[2] < 0]
    points = [geometry.Point(hole) for hole in holes]
    faces = operations.polygonize(operations.unary_union([geometry.LineString(line) for line in lines]))
    return sum(face.area for face in faces if not any(face.contains(point) for point in points))


def judge(build, path):
    """Returns what happened with one file: the result of meshing, and if meshed, triangles, seconds, whether the mesh is
    valid, and the relative error of its area."""
    with tempfile.TemporaryDirectory() as scratch:
        mesh, statistics = pathlib.Path(scratch, "mesh.msh"), pathlib.Path(scratch, "mesh.json")
        began = time.monotonic()
        try:
            done = subprocess.run([build / "app/forefront", "mesh", path, "-o", mesh, "--format", "msh41-binary", "--stats",
                                   statistics, "--threads", "1"], capture_output=True, text=True, errors="replace",
                                  timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return {"result": "slow"}
        seconds = time.monotonic() - began
        if done.returncode != 0:
            faults = [line for line in done.stderr.splitlines() if "error" in line] or ["no message"]
            code = re.search(r"\[([a-z-]+)\]", faults[0])
            return {"result": code[1] if code else f"exit {done.returncode}"}
        valid = subprocess.run([build / "app/forefront", "check", mesh, "--domain", path], capture_output=True,
                               check=False).returncode == 0
        numbers = json.loads(statistics.read_text())
        area = area_of(path)
        return {"result": "meshed", "seconds": seconds, "valid": valid, "triangles": numbers["elements"],
                "error": abs(numbers["area"] - area) / area}


def run(corpus, build):
    print("# FEMM problems: the last table\n\nMade with `femm.py run`. The files are not part of the repository.\n")
    print("| source | licence | files | meshed | valid | area right | triangles | seconds at most | not meshed |\n"
          "|---|---|---|---|---|---|---|---|---|")
    remarks = []
    for name, licence in REPOSITORIES:
        rows = [(path, judge(build, path)) for path in sorted((corpus / name.replace("/", "+")).iterdir())]
        meshed = [row for _, row in rows if row["result"] == "meshed"]
        others = collections.Counter(row["result"] for _, row in rows if row["result"] != "meshed")
        triangles = [row["triangles"] for row in meshed] or [0]
        print(f"| {name} | {licence} | {len(rows)} | {len(meshed)} | {sum(row['valid'] for row in meshed)} | "
              f"{sum(row['error'] <= MAX_AREA_ERROR for row in meshed)} | {min(triangles)} to {max(triangles)} | "
              f"{max((row['seconds'] for row in meshed), default=0):.1f} | "
              f"{', '.join(f'{count} {reason}' for reason, count in others.most_common()) or 0} |", flush=True)
        for path, row in rows:
            if row["result"] != "meshed" or not row["valid"] or row["error"] > MAX_AREA_ERROR:
                remarks.append(f"| {name}/{path.name} | {row['result']} | {row.get('valid', '')} | "
                               f"{row.get("error", math.nan):.4f} |")
    print("\n| remarkable file | result | valid | error of the area |\n|---|---|---|---|")
    print("\n".join(remarks))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["fetch", "run"])
    parser.add_argument("--corpus", type=pathlib.Path, required=True, help="folder of the files")
    parser.add_argument("--repositories", type=pathlib.Path, help="folder of clones named OWNER+NAME")
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    arguments = parser.parse_args()
    if arguments.command == "fetch":
        fetch(arguments.corpus, arguments.repositories)
    else:
        run(arguments.corpus, arguments.build)


if __name__ == "__main__":
    main()
