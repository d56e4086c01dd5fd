#!/usr/bin/python3
"""Meshes a plate with a hole from Python, by forefront and by Gmsh's module, and prints a table.

    PYTHONPATH=build/release/app/python/package /usr/bin/python3 tests/bench/peer_python.py

The size grows from a minimum h at the hole by 3*h for each unit of distance. Each mesh is made in a process of its own: the
seconds are CPU seconds from the outline to NumPy arrays of nodes and triangles on one thread, the memory is what the
process held at most beyond the imported modules. The shape is the mean of 4*sqrt(3)*area over the squares of the sides.

Needs the Debian packages python3-gmsh and python3-numpy.
"""

import json
import resource
import subprocess
import sys
import time

import numpy as np

WIDTH, HEIGHT, CENTRE, RADIUS = 4.0, 2.0, (1.0, 1.0), 0.4
GROWTH = 3.0
MINIMA = (0.02, 0.006, 0.002)


def by_forefront(forefront, smallest):
    plate = forefront.Domain()
    plate.add_loop([(0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)])
    plate.add_circle(CENTRE, RADIUS)
    x, y = CENTRE
    size = f"{smallest}*(1 + {GROWTH}*max(0, sqrt((x-{x})^2 + (y-{y})^2) - {RADIUS}))"
    mesh = forefront.mesh(plate, size, threads=1)
    return mesh.nodes, mesh.elements


def by_gmsh(gmsh, smallest):
    gmsh.initialize()
    for name, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.Algorithm", 6),
                        ("Mesh.MeshSizeExtendFromBoundary", 0), ("Mesh.MeshSizeFromPoints", 0),
                        ("Mesh.MeshSizeFromCurvature", 0)):
        gmsh.option.setNumber(name, value)
    geometry, (x, y) = gmsh.model.geo, CENTRE
    corners = [geometry.addPoint(*at, 0) for at in ((0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT))]
    sides = [geometry.addLine(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
    middle = geometry.addPoint(x, y, 0)
    ends = [geometry.addPoint(x + RADIUS, y, 0), geometry.addPoint(x - RADIUS, y, 0)]
    halves = [geometry.addCircleArc(ends[0], middle, ends[1]), geometry.addCircleArc(ends[1], middle, ends[0])]
    geometry.addPlaneSurface([geometry.addCurveLoop(sides), geometry.addCurveLoop(halves)])
    geometry.synchronize()
    field = gmsh.model.mesh.field.add("MathEval")
    distance = f"Sqrt((x-{x})^2 + (y-{y})^2) - {RADIUS}"
    gmsh.model.mesh.field.setString(field, "F", f"{smallest}*(1 + {GROWTH}*0.5*({distance} + Fabs({distance})))")
    gmsh.model.mesh.field.setAsBackgroundMesh(field)
    gmsh.model.mesh.generate(2)
    tags, places, _ = gmsh.model.mesh.getNodes()
    number = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    number[tags] = np.arange(len(tags))
    _, triangles = gmsh.model.mesh.getElementsByType(2)
    return places.reshape(-1, 3)[:, :2], number[triangles].reshape(-1, 3)


def held():
    """Returns the most memory that this process has held, in MB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def measure(name, smallest):
    """Makes one mesh and returns its figures."""
    module = __import__(name)
    before, began = held(), time.process_time()
    nodes, triangles = (by_forefront if name == "forefront" else by_gmsh)(module, smallest)
    seconds, memory = time.process_time() - began, held() - before
    a, b, c = (nodes[triangles[:, k]] for k in range(3))
    area = 0.5 * np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    squares = sum(((p - q) ** 2).sum(axis=1) for p, q in ((a, b), (b, c), (c, a)))
    shape = 4 * np.sqrt(3) * area / squares
    version = getattr(module, "__version__", "")
    return {"name": f"{name} {version}", "triangles": len(triangles), "seconds": seconds, "memory": memory,
            "mean": float(shape.mean()), "least": float(shape.min())}


def main():
    if len(sys.argv) == 3:
        print(json.dumps(measure(sys.argv[1], float(sys.argv[2]))))
        return
    print("| minimum size | module | triangles | seconds | triangles per second | memory, MB | mean shape | minimum shape |\n"
          "|---|---|---|---|---|---|---|---|")
    for smallest in MINIMA:
        for name in ("forefront", "gmsh"):
            done = subprocess.run([sys.executable, __file__, name, str(smallest)], check=True, capture_output=True, text=True)
            row = json.loads(done.stdout.splitlines()[-1])
            print(f"| {smallest} | {row['name']} | {row['triangles']} | {row['seconds']:.3f} | "
                  f"{row['triangles'] / row['seconds']:.0f} | {row['memory']:.1f} | {row['mean']:.4f} | {row['least']:.3f} |",
                  flush=True)


if __name__ == "__main__":
    main()
