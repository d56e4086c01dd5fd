"""Checks that icons are drawn by this program and stand for one thing. Usage: test_icons.py ROOT

Every icon of ui/style/icons.hpp has a shape in ui/style/icon_shapes.cpp; no other file has characters of its own for
icons; the icon of a tool stands for nothing but that tool.
"""
import re
import sys
from pathlib import Path

HEADER, SHAPES = "ui/style/icons.hpp", "ui/style/icon_shapes.cpp"
# UTF-8 of the private area of Unicode, escaped or not.
ICON = re.compile(r"\\xe[ef]\\x8[0-9a-f]|\\u[ef][0-9a-f]{3}|[\ue000-\uf2ff]", re.I)
# Used outside their tools, for the same thing: what is selected.
SAME = {"kSelect"}


def faults(root):
    defined = re.findall(r"const char \*(k\w+) = ", (root / HEADER).read_text(encoding="utf-8"))
    drawn = re.findall(r"icon::(k\w+)", (root / SHAPES).read_text(encoding="utf-8"))
    yield from (f"{HEADER}: {name} has no shape, or more than one" for name in defined if drawn.count(name) != 1)
    tools, elsewhere = set(), {}
    for top in ("core", "ui", "app"):
        for path in (root / top).rglob("*.[ch]pp"):
            name, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
            if name in (HEADER, SHAPES):
                continue
            if ICON.search(text):
                yield f"{name}: an icon that is not in {HEADER}"
            for icon in re.findall(r"icon::(k\w+)", text):
                if name.startswith("ui/tools/"):
                    tools.add(icon)
                else:
                    elsewhere[icon] = name
    yield from (f"{elsewhere[icon]}: {icon} is the icon of a tool" for icon in tools - SAME if icon in elsewhere)


if __name__ == "__main__":
    found = sorted(faults(Path(sys.argv[1])))
    print(*found, sep="\n")
    sys.exit(bool(found))
