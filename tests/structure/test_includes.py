"""Checks that every #include below core/, ui/ and app/ points to a lower room. Usage: test_includes.py ROOT"""
import re
import sys
from collections import defaultdict
from pathlib import Path

# Rooms from the lowest up; "." is the folder itself. A file may include the rooms before its own; rooms in one string
# are equals and must not include each other. "*" stands for all rooms that are not named.
ORDERS = {
    "core": ["engine", "files", "components", "c", "drawing", "drawing_files", "teaching", "."],
    "core/engine": ["platform", "base", "geometry", "domain", "spacing", "boundary", "front", "grid", "mesh", "improve", "layers", "strips", "mapped",
                    "mesher", "quads", "refine", "pipeline", "adapt session"],
    "core/engine/spacing": ["spec", "sites", "parts", "."],
    "core/files": ["source", "text", "common", "json", "components", "*", "."],
    "core/drawing": ["arrangement", "sketch", "document", "shapes", "colour_outline", "names", "joints", "constraints", "formulas", "domain", "picking", "commands recovery"],
    "core/drawing/arrangement": [".", "snapping", "curves", "repeated_lines", "cover", "assembly repair"],
    "core/drawing_files": ["common", "*", "clipboard script", "."],
    "core/drawing_files/svg": ["xml", "values", "style", "drawing", "areas", "."],
    "core/teaching": ["moment markup", "lesson page trace", "film lesson_page", "tables"],
    "ui/tools": ["common", "draw select size look", "."],
    "ui/workspace": ["document", "messages", "view", "mesh", "run", "."],
    "ui": ["input", "style background", "platform", "widgets", "canvas", "gl", "workspace", "parts", "layers tools panels dialogs", "lessons", "shell",
           "editor", "."],
}
FORBIDDEN = {"core/": r"(ui|app)/|GL/|GLES|EGL|GLFW|imgui|implot|glad", "ui/": r"app/"}
# Headers of one operating system, and the rooms that may include them.
SYSTEM = r"(sys/.*|unistd|fcntl|dlfcn|spawn|poll|pthread|termios|csignal|signal|windows|io|direct)(\.h)?$"
SYSTEM_ROOMS = ("core/engine/platform/", "ui/platform/", "app/memory/")


def includes(root):
    for path in sorted(path for top in ("core", "ui", "app") for path in (root / top).rglob("*.[ch]pp")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if found := re.match(r'\s*#\s*include\s*["<]([^">]+)[">]', line):
                yield path.relative_to(root).as_posix(), number, found[1]


def room(path, top):
    folder = path.rpartition("/")[0] + "/"
    return (folder.removeprefix(top + "/").partition("/")[0] or ".") if folder.startswith(top + "/") else None


def faults(root):
    arrows = defaultdict(list)
    for file, number, included in includes(root):
        arrow = f"{file}:{number}: #include of {included}"
        yield from (f"{arrow}: {top} must not include it" for top, pattern in FORBIDDEN.items()
                    if file.startswith(top) and re.match(pattern, included))
        if re.match(SYSTEM, included) and not file.startswith(SYSTEM_ROOMS):
            yield f"{arrow}: only {', '.join(SYSTEM_ROOMS)} may include headers of an operating system"
        arrows[file.rpartition("/")[0], included.rpartition("/")[0]].append(arrow)
        for top, order in ORDERS.items():
            rank = {name: place for place, names in enumerate(order) for name in names.split()}
            a, b = room(file, top), room(included, top)
            if "*" in rank:
                rank |= {name: rank["*"] for name in (a, b) if name is not None and name not in rank}
            if a is not None and a not in rank:
                yield f"{file}: {top}/{a} has no place in the order; add it to ORDERS"
            elif a != b and b in rank and a in rank and rank[a] <= rank[b]:
                yield f"{arrow}: {top}/{b} does not come before {top}/{a}"
    for a, b in sorted(arrows):
        if a < b and (b, a) in arrows:
            yield f"{a} and {b} include each other: {arrows[a, b][0]}; {arrows[b, a][0]}"


if __name__ == "__main__":
    found = sorted(set(faults(Path(sys.argv[1]))))
    print(*found, sep="\n")
    sys.exit(bool(found))
