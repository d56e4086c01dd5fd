#!/usr/bin/python3
"""Compares the numbers of elements that a least angle of 30 degrees takes in Forefront and in Triangle, as a table.

    PYTHONPATH=build/release/app/python/package /usr/bin/python3 tests/bench/triangle_table.py TRIANGLE [DOMAIN...]

TRIANGLE is the program of the Debian package triangle-bin, which is not in main. DOMAIN: files of domains; default: all
samples without boundary layers. Both meshers get the same segments, those of the domain with its curves as chords, and no
sizes, as ``triangle -pq30`` and ``forefront.compat.triangle.triangulate(graph, "pq30")``. With areas, both get the same
greatest area, the square of a twentieth of the shorter side of the domain.

Needs the Debian packages triangle-bin (non-free) and python3-numpy.
"""

import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

import forefront as ff
import forefront.compat.triangle as compat

ANGLE = 30


def graph_of(path):
    """Returns the segments of a domain, its curves as chords, and a place in each hole."""
    domain = ff.Domain.read(path)
    x0, y0, x1, y1 = domain.bounds
    mesh = ff.mesh(domain, float(np.hypot(x1 - x0, y1 - y0)), elements="triangles", elements_across=0, improve="none")
    edges = mesh.edges.astype(np.int64)
    used = np.unique(edges)
    number = np.zeros(len(mesh.nodes), np.int64)
    number[used] = np.arange(len(used))
    return {"vertices": mesh.nodes[used], "segments": number[edges], "holes": holes_of(mesh)}


def holes_of(mesh):
    """Returns a place in each hole, beside the longest edge of each loop that the mesh lies around."""
    corners = mesh.elements.astype(np.int64)
    half_edges = np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)])
    known = {(int(a), int(b)) for a, b in half_edges}
    ends = {}
    for a, b in known:
        if (b, a) not in known:
            ends.setdefault(a, []).append(b)
    places = []
    while ends:
        loop = [next(iter(ends))]
        while loop[-1] in ends:
            followers = ends[loop[-1]]
            node = followers.pop()
            if not followers:
                del ends[loop[-1]]
            loop.append(node)
        start, end = mesh.nodes[loop[:-1]], mesh.nodes[loop[1:]]
        if np.sum(start[:, 0] * end[:, 1] - start[:, 1] * end[:, 0]) < 0.0:
            along = end - start
            longest = int(np.argmax(np.hypot(*along.T)))
            x, y = along[longest]
            places.append(0.5 * (start[longest] + end[longest]) + 1e-7 * np.array([y, -x]))
    return np.reshape(places, (-1, 2))


def by_triangle(program, graph, switches):
    """Returns the number of triangles of Triangle and its seconds."""
    with tempfile.TemporaryDirectory() as name:
        poly = pathlib.Path(name) / "graph.poly"
        with poly.open("w") as out:
            out.write(f"{len(graph['vertices'])} 2 0 0\n")
            for k, (x, y) in enumerate(graph["vertices"], 1):
                out.write(f"{k} {float(x)!r} {float(y)!r}\n")
            out.write(f"{len(graph['segments'])} 0\n")
            for k, (a, b) in enumerate(graph["segments"], 1):
                out.write(f"{k} {a + 1} {b + 1}\n")
            out.write(f"{len(graph['holes'])}\n")
            for k, (x, y) in enumerate(graph["holes"], 1):
                out.write(f"{k} {float(x)!r} {float(y)!r}\n")
        began = time.perf_counter()
        subprocess.run([program, "-Q" + switches, str(poly)], check=True, capture_output=True, timeout=300)
        seconds = time.perf_counter() - began
        return int((pathlib.Path(name) / "graph.1.ele").read_text().split(maxsplit=1)[0]), seconds


def by_forefront(graph, switches):
    """Returns the number of triangles of Forefront and its seconds."""
    began = time.perf_counter()
    made = compat.triangulate(graph, switches)
    return len(made["triangles"]), time.perf_counter() - began


def rows(program, paths):
    for path in paths:
        if '"layers"' in path.read_text(errors="replace"):
            continue
        graph = graph_of(path)
        width, height = np.ptp(graph["vertices"], axis=0)
        area = (min(width, height) / 20) ** 2
        for name, switches in (("no size", f"pq{ANGLE}"), ("area", f"pq{ANGLE}a{area:.9f}")):
            theirs, their_seconds = by_triangle(program, graph, switches)
            ours, seconds = by_forefront(graph, switches)
            yield path.name, name, len(graph["segments"]), theirs, ours, their_seconds, seconds


def main():
    program, *given = sys.argv[1:]
    samples = pathlib.Path(__file__).resolve().parents[2] / "assets" / "samples"
    paths = [pathlib.Path(word) for word in given] or sorted(samples.glob("*.json"))
    print("| domain | limits | segments | Triangle | Forefront | ratio | s | s |\n|---|---|---:|---:|---:|---:|---:|---:|")
    ratios = {}
    for name, limits, segments, theirs, ours, their_seconds, seconds in rows(program, paths):
        ratios.setdefault(limits, []).append(ours / theirs)
        print(f"| {name} | {limits} | {segments} | {theirs} | {ours} | {ours / theirs:.2f} | {their_seconds:.3f} | "
              f"{seconds:.3f} |", flush=True)
    for limits, values in ratios.items():
        print(f"{limits}: geometric mean of the ratios {np.exp(np.mean(np.log(values))):.3f}, greatest {max(values):.2f}, "
              f"{sum(value <= 1.3 for value in values)} of {len(values)} at most 1.3")


if __name__ == "__main__":
    main()
