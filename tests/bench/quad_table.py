"""Prints what meshes of quadrilaterals, of second order and with boundary layers are held to, as Markdown tables.

  /usr/bin/python3 tests/bench/quad_table.py [PROGRAM [FILE...]]

PROGRAM: build/release/app/forefront. FILE: domains that are meshed besides the samples.
Gmsh's rows are its front2d with Blossom for all quadrilaterals (Mesh.RecombinationAlgorithm 3), and are left out without
Debian's python3-gmsh. Seconds are CPU seconds of the calls that make, join and improve the elements, on one thread: the
fastest of ROUNDS runs that take turns; Gmsh runs once where it takes more than SLOW seconds. quad_measures.py, not
Forefront, measures every mesh. Needs python3-numpy. Takes some minutes."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from quad_measures import judge, least_uniformity, read_msh2

ROUNDS = 3
SLOW = 8.0
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PROGRAM = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/app/forefront").resolve()


def ring(radius, count):
    return [(radius * math.cos(2 * math.pi * i / count), radius * math.sin(2 * math.pi * i / count))
            for i in range(count)]


def poly(outline, hole=(), hole_tag=2):
    """Returns the text of a Triangle .poly file of an outline with tag 1 and a hole about the origin."""
    places = [*outline, *hole]
    lines = [f"{len(places)} 2 0 0", *(f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(places)), f"{len(places)} 1"]
    for first, count, tag in ((0, len(outline), 1), (len(outline), len(hole), hole_tag)):
        lines += [f"{first + i} {first + i} {first + (i + 1) % count} {tag}" for i in range(count)]
    return "\n".join([*lines, "1\n0 0 0" if hole else "0"]) + "\n"


class Case:
    def __init__(self, name, text, size, circle=None):
        """size: uniform spacing, or the least one near a circle; circle: (x, y, radius), with a slope of 0.232."""
        self.name, self.text, self.size, self.circle = name, text, size, circle

    def spacing(self, absolute="abs", root="sqrt"):
        if not self.circle:
            return repr(self.size)
        x, y, radius = self.circle
        return f"max({self.size!r}, 0.232*{absolute}({root}((x-{x})^2+(y-{y})^2)-{radius}))"

    def rho(self, x, y):
        if not self.circle:
            return np.full(len(x), self.size)
        return np.maximum(self.size, 0.232 * abs(np.hypot(x - self.circle[0], y - self.circle[1]) - self.circle[2]))


def even(count):
    return 2 * round(count / 2)


DISC, PLATE = math.sqrt(math.pi / 1e5), math.sqrt((16 - math.pi) / 1e4)
CASES = [Case("disc, 10⁵", poly(ring(1.0, even(2 * math.pi / DISC))), DISC),
         Case("graded .02", poly([(0, 0), (60, 0), (60, 40), (0, 40)]), 0.02, (30, 20, 12)),
         Case("L, 10⁴", poly([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]), math.sqrt(3 / 1e4)),
         Case("plate with a hole, 10⁴", poly([(-2, -2), (2, -2), (2, 2), (-2, 2)],
                                             ring(1.0, even(2 * math.pi / PLATE))), PLATE)]


def run(*words, cwd=None):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, cwd=cwd)
    if done.returncode != 0:
        sys.exit(f"quad_table.py: {' '.join(str(w) for w in words)}: {(done.stderr or done.stdout).strip()}")
    return done.stdout


def mesh(folder, *words):
    """Meshes with Forefront; returns its statistics and the mesh."""
    out = folder / "ours.msh"
    stats = json.loads(run(PROGRAM, "mesh", *words, "-o", out, "--format", "msh2", "--stats", "-"))
    return stats, *read_msh2(out)


def ours(case, folder, *options):
    stats, nodes, faces = mesh(folder, folder / "case.poly", "--spacing", case.spacing(), "--elements", "quads",
                               *options)
    return stats["seconds_mesh"] + stats["seconds_improve"], nodes, faces


def gmsh(case, folder):
    out = folder / "gmsh.msh"
    graded = case.spacing("Fabs", "Sqrt").replace("max", "Max") if case.circle else ""
    seconds = run(sys.executable, HERE / "quad_gmsh.py", folder / "case.poly", out, case.size, graded)
    return float(seconds.split()[-1]), *read_msh2(out)  # warnings may come first


def meshers():
    found = {"Forefront": lambda case, folder: ours(case, folder),
             "Forefront, best": lambda case, folder: ours(case, folder, "--improve", "best")}
    if subprocess.run([sys.executable, "-c", "import gmsh"], capture_output=True).returncode == 0:
        found["Gmsh, Blossom full-quad"] = gmsh
    return found


def quad_rows(folder):
    yield "| case | mesher | quads | triangles | inverted | CPU s | 1000/s | × Gmsh | SJ mean | least | irregular % | δ |"
    yield "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
    makers = meshers()
    for case in CASES:
        (folder / "case.poly").write_text(case.text)
        seconds, figures = {}, {}
        for _ in range(ROUNDS):
            for name, make in makers.items():
                if seconds.get(name, 0.0) < SLOW:
                    taken, nodes, faces = make(case, folder)
                    seconds[name] = min(taken, seconds.get(name, math.inf))
                    figures[name] = figures.get(name) or judge(nodes, faces, case.rho)
        speed = {name: figures[name]["quads"] / seconds[name] for name in makers}
        base = speed.get("Gmsh, Blossom full-quad")
        for name in makers:
            f = figures[name]
            yield (f"| {case.name} | {name} | {f['quads']} | {f['tris']} | {f['inverted']} | {seconds[name]:.3f} | "
                   f"{speed[name] / 1000:.0f} | {speed[name] / base if base else math.nan:.1f} | {f['mean']:.4f} | "
                   f"{f['least']:.3f} | {f['irregular']:.2f} | {f['delta']:.3f} |")


def sample_rows(folder):
    yield "| sample | quads | triangles | inverted | not conforming | least SJ | second order: least/greatest Jacobian |"
    yield "|---|---:|---:|---:|---:|---:|---:|"
    files = [pathlib.Path(word).resolve() for word in sys.argv[2:]]
    for file in [*sorted((ROOT / "assets/samples").glob("*.json")), *files]:
        _, nodes, faces = mesh(folder, file, "--elements", "quads", "--verify")
        f = judge(nodes, faces)
        _, *raised = mesh(folder, file, "--elements", "quads", "--order", "2", "--verify")
        yield (f"| {file.stem} | {f['quads']} | {f['tris']} | {f['inverted']} | {f['nonconforming']} | {f['least']:.3f} | "
               f"{least_uniformity(*raised):.3f} |")


def order_rows(folder):
    yield "| second order | elements | least/greatest Jacobian | straight edges along curves |"
    yield "|---|---:|---:|---:|"
    disc = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-1 -1 2 2"><circle r="1" fill="gray"/></svg>'
    (folder / "disc.svg").write_text(disc)
    for name, file in (("disc", folder / "disc.svg"), ("airfoil", ROOT / "assets/samples/airfoil.json"),
                       ("wing", ROOT / "assets/samples/wing.json")):
        for count in (500, 1500, 5000, 15000):
            for options in ((), ("--elements", "quads"), ("--elements", "quads", "--quad-nodes", "9")):
                stats, nodes, faces = mesh(folder, file, "--order", "2", "--target-elements", count, *options)
                kinds = {9: "triangles of 6 nodes", 16: "quadrilaterals of 8", 10: "quadrilaterals of 9"}
                number = sum(len(elements) for elements in faces.values())
                yield (f"| {name}, {' and '.join(kinds[k] for k in sorted(faces))} | {number} | "
                       f"{least_uniformity(nodes, faces):.3f} | {len(stats['second_order']['straight_edges'])} |")


def layer_rows(folder):
    """The layers alone: what the elements of the front lack is in the other tables."""
    yield "| boundary layers | quads | inverted | rays | shortened | growth, off by | 1000 quads/s |"
    yield "|---|---:|---:|---:|---:|---:|---:|"
    square = [(-30, -30), (30, -30), (30, 30), (-30, 30)]
    cross = [(1, -4), (1, -1), (4, -1), (4, 1), (1, 1), (1, 4), (-1, 4), (-1, 1), (-4, 1), (-4, -1), (-1, -1), (-1, -4)]
    layers = "boundary_2:first=1e-4,growth=1.2,count=20"
    for name, text, options in (
            ("cross", poly(square, cross), ("--size", "1", "--layers", layers)),
            ("wall of 10⁵ nodes", poly(square, ring(10.0, 100000)),
             ("--size", "2", "--keep-boundary", "--layers", "boundary_2:first=1e-4,growth=1.2,count=10")),
            ("airfoil with a flap", None, ())):
        file = folder / "case.poly"
        if text:
            file.write_text(text)
        else:
            file = ROOT / "assets/samples/flap.json"
        stats, nodes, faces = mesh(folder, file, *options)
        f = judge(nodes, faces)
        made = stats["boundary_layers"]
        off = "" if name != "wall of 10⁵ nodes" else f"{100 * growth_error(nodes, 10.0, 1e-4, 1.2, 10):.4f} %"
        yield (f"| {name} | {made['quadrilaterals']} | {f['inverted']} | {made['rays']} | {len(made['shortened'])} | {off} | "
               f"{made['quadrilaterals'] / stats['seconds_prepare'] / 1000:.0f} |")


def growth_error(nodes, radius, first, growth, count):
    """Returns how far the heights of layers on a circle are from those asked for, relative to each."""
    heights = np.hypot(nodes[:, 0], nodes[:, 1]) - radius
    worst = 0.0
    tops = np.cumsum(first * growth ** np.arange(count))
    for below, top in zip([0.0, *tops[:-1]], tops):
        near = heights[abs(heights - top) < 0.3 * (top - below)]
        worst = max(worst, float(abs((near - below) / (top - below) - 1.0).max()) if len(near) else 1.0)
    return worst


def main():
    with tempfile.TemporaryDirectory() as name:
        for rows in (quad_rows, order_rows, layer_rows, sample_rows):
            for row in rows(pathlib.Path(name)):
                print(row, flush=True)
            print()


main()
