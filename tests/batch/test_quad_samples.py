#!/usr/bin/env python3
"""Quadrilaterals of every sample: each mesh follows its domain, and no element is flat, not convex or clockwise.

    test_quad_samples.py PROGRAM [FOLDER OR FILE...]

Without files it meshes the samples of the repository. Prints one line for each mesh with a fault; fails if there is one.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "assets" / "samples"
KINDS = [".json", ".poly", ".geojson", ".svg", ".dxf"]
WAYS = [["--elements", "quads"], ["--elements", "mixed"], ["--elements", "quads", "--keep-boundary"],
        ["--elements", "mixed", "--keep-boundary"]]


def domains(words):
    for word in map(pathlib.Path, words):
        files = sorted(word.iterdir()) if word.is_dir() else [word]
        yield from (file for file in files if file.suffix in KINDS)


def faults(program, domain, way, folder):
    """Returns what is wrong with the mesh of a domain: a list of texts."""
    stats_file = folder / "stats.json"
    done = subprocess.run([program, "mesh", domain, "-o", folder / "mesh.msh", "--verify", "--stats", stats_file, *way],
                          capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        return [done.stderr.strip() or f"exit code {done.returncode}"]
    stats = json.loads(stats_file.read_text())
    quads = stats["quadrilaterals"]
    found = []
    if quads["not_convex"] > 0:
        found.append(f"quadrilaterals that are not convex at {quads['not_convex_at']}")
    if stats["flat_elements"] > 0:
        found.append(f"{stats['flat_elements']} flat elements")
    if quads["triangles_for_quads_at"] and "triangles-for-quads" not in done.stderr:
        found.append("triangles for quadrilaterals that no note names")
    asked_for = "mixed" in way or quads["odd_edges"] > 0 or quads["triangles_for_quads_at"]
    if quads["triangles_left"] > 0 and not asked_for:
        found.append(f"{quads['triangles_left']} triangles for no reason")
    return found


def main():
    program = os.path.abspath(sys.argv[1])
    meshes = bad = 0
    with tempfile.TemporaryDirectory() as folder:
        for domain in domains(sys.argv[2:] or [SAMPLES]):
            for way in WAYS:
                meshes += 1
                found = faults(program, domain, way, pathlib.Path(folder))
                bad += bool(found)
                for text in found:
                    print(f"{domain.name} {' '.join(way)}: {text}")
    print(f"{meshes} meshes, {bad} with faults")
    return bool(bad or not meshes)


if __name__ == "__main__":
    sys.exit(main())
