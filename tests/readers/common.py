"""What the checks of exported files share: the sample meshes, comparisons, and running a list of checks."""
import json
import math
import pathlib
import shutil
import subprocess
import tempfile


def near(a, b, tolerance=1e-9):
    assert abs(a - b) <= tolerance * max(1.0, abs(b)), f"{a} instead of {b}"


def same(a, b, what):
    assert a == b, f"{what}: {a} instead of {b}"


def triangle_area(a, b, c):
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def measure(corners):
    """Length of an edge or area of a triangle."""
    return math.dist(*corners) if len(corners) == 2 else triangle_area(*corners)


def measures(items, signed=True):
    """Count and total measure by key, of pairs (key, corners). Clockwise triangles count negative if `signed`."""
    found = {}
    for key, corners in items:
        count, total = found.get(key, (0, 0.0))
        size = measure(corners)
        found[key] = (count + 1, total + (size if signed else abs(size)))
    return found


def compare(found, parts, key, what):
    """Holds `found`, {key: (count, measure)}, against the true parts; `key` gives the key of a part by its name."""
    expected = {key(name): part for name, part in parts.items()}
    same(sorted(found, key=str), sorted(expected, key=str), f"{what}: keys")
    for k, part in expected.items():
        count, total = found[k]
        same(count, part["count"], f"{what}: count of {k}")
        near(total, part["length" if "length" in part else "area"])


class Sample:
    """A mesh in all formats, with its true figures."""

    def __init__(self, folder, name):
        truth = json.loads((folder / f"{name}.json").read_text())
        self.files = truth["files"]
        self.nodes, self.elements = truth["nodes"], truth["elements"]
        self.edges, self.regions, self.points = truth["edges"], truth["regions"], truth.get("points", {})

    def area(self):
        return sum(part["area"] for part in self.regions.values())

    def msh_label(self, kind, name):
        """The name of a physical group by the rule of the README, as far as these samples need it."""
        label = name.replace('"', "'")
        taken = kind != "edges" and name in self.edges
        return label + {"regions": "_region", "points": "_point"}[kind] if taken else label

    def msh_number(self, part):
        """The number of a physical group by the rule of the README: these samples use tags below 1000, and regions
        have tags of boundaries."""
        return part["tag"] + (1000 if "area" in part else 0 if "length" in part else 2000)


class Samples:
    """The exported files, in a temporary folder that stays where a check failed."""

    def __init__(self, program):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="forefront-readers-"))
        subprocess.run([program, str(self.folder)], check=True)

    def __getitem__(self, name):
        return Sample(self.folder, name)

    def run(self, checks):
        """Runs (name, function) pairs; returns the lines of the result and whether all passed."""
        lines, failures = [], 0
        for name, check in checks:
            try:
                check()
                lines.append(f"ok     {name}")
            except Exception as problem:  # one reader's complaint must not hide another's
                failures += 1
                lines.append(f"FAILED {name} - {type(problem).__name__} {problem}")
            print(lines[-1], flush=True)
        if failures == 0:
            shutil.rmtree(self.folder)
        else:
            print("the files stay in", self.folder)
        return lines, failures == 0
