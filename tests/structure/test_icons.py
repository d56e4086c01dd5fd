"""Checks that ui/style/icons.hpp lists every icon in kAll and that no other file has its own. Usage: test_icons.py ROOT"""
import re
import sys
from pathlib import Path

HEADER = "ui/style/icons.hpp"
# UTF-8 of Font Awesome's code points, escaped or not.
ICON = re.compile(r"\\xef\\x8[0-9a-f]|\\uf[0-2][0-9a-f]{2}|[\uf000-\uf2ff]", re.I)


def faults(root):
    text = (root / HEADER).read_text(encoding="utf-8")
    defined = re.findall(r"const char \*(k\w+) = ", text)
    listed = re.findall(r"k\w+", re.search(r"kAll\[\] = \{(.*?)\}", text, re.S)[1])
    yield from (f"{HEADER}: {name} is not in kAll" for name in defined if name not in listed)
    for top in ("core", "ui", "app"):
        for path in (root / top).rglob("*.[ch]pp"):
            if ICON.search(path.read_text(encoding="utf-8")) and path != root / HEADER:
                yield f"{path.relative_to(root)}: an icon that is not in {HEADER}"


if __name__ == "__main__":
    found = sorted(faults(Path(sys.argv[1])))
    print(*found, sep="\n")
    sys.exit(bool(found))
