"""Checks that every #include below core/, ui/ and app/ points to a lower room. Usage: test_includes.py ROOT"""
import re
import sys
from collections import defaultdict
from pathlib import Path

# Rooms from the lowest up; "." is the folder itself. A file may include the rooms before its own; rooms in one string
# are equals and must not include each other.
ORDERS = {
    "core": ["base", "geometry", "domain", "arrangement", "spacing", "boundary", "front", "grid", "mesh", "improve", "mesher",
             "adapt edit session", "io", "."],
    "core/spacing": ["spec", "sites", "parts", "."],
    "core/io": ["source", "text", "common", "json", "abaqus geojson gmsh medit obj project su2 svg triangle vtk", "."],
    "ui": ["platform input style", "widgets", "canvas gl", "layers tools panels dialogs", "shell", "editor", "."],
}
FORBIDDEN = {"core/": r"(ui|app)/|GL/|GLES|EGL|GLFW|imgui|implot|glad", "ui/": r"app/"}
# What is not in order yet. Delete entries as they become unnecessary (the test lists those); never add one.
EXCEPTIONS = {tuple(pair.split()) for pair in """
ui/canvas ui/editor, ui/canvas ui/gl, ui/dialogs ui/editor, ui/dialogs ui/tools, ui/gl ui/canvas, ui/layers ui/editor,
ui/panels ui/editor, ui/panels ui/layers, ui/panels ui/tools, ui/platform ui/input, ui/shell ui/editor,
ui/tools ui/editor, ui/widgets ui/canvas, ui/widgets ui/editor, ui/widgets ui/tools""".split(",")}


def includes(root):
    for path in sorted(path for top in ("core", "ui", "app") for path in (root / top).rglob("*.[ch]pp")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if found := re.match(r'\s*#\s*include\s*["<]([^">]+)[">]', line):
                yield path.relative_to(root).as_posix(), number, found[1]


def room(path, top):
    folder = path.rpartition("/")[0] + "/"
    return (folder.removeprefix(top + "/").partition("/")[0] or ".") if folder.startswith(top + "/") else None


def faults(root, used):
    arrows = defaultdict(list)
    for file, number, included in includes(root):
        arrow = f"{file}:{number}: #include of {included}"
        yield from (f"{arrow}: {top} must not include it" for top, pattern in FORBIDDEN.items()
                    if file.startswith(top) and re.match(pattern, included))
        arrows[file.rpartition("/")[0], included.rpartition("/")[0]].append(arrow)
        for top, order in ORDERS.items():
            rank = {name: place for place, names in enumerate(order) for name in names.split()}
            a, b = room(file, top), room(included, top)
            if a is not None and a not in rank:
                yield f"{file}: {top}/{a} has no place in the order; add it to ORDERS"
            elif a != b and b in rank and a in rank and rank[a] <= rank[b]:
                used.add((f"{top}/{a}", f"{top}/{b}"))
                if (f"{top}/{a}", f"{top}/{b}") not in EXCEPTIONS:
                    yield f"{arrow}: {top}/{b} does not come before {top}/{a}"
    for a, b in sorted(arrows):
        if a < b and (b, a) in arrows:
            used |= {(a, b), (b, a)}
            if not {(a, b), (b, a)} & EXCEPTIONS:
                yield f"{a} and {b} include each other: {arrows[a, b][0]}; {arrows[b, a][0]}"


if __name__ == "__main__":
    used = set()
    found = sorted(set(faults(Path(sys.argv[1]), used)))
    print(*found, *(f"note: exception no longer needed: {a} {b}" for a, b in sorted(EXCEPTIONS - used)), sep="\n")
    sys.exit(bool(found))
