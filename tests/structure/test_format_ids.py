"""Checks that no code outside the lists of formats asks for a format by its id: what differs between formats belongs into
FileFormat, where a new format cannot miss it. Usage: test_format_ids.py ROOT"""
import re
import sys
from pathlib import Path

LISTS = ("core/files/engine_formats.cpp", "core/drawing_files/drawing_formats.cpp")
ID = re.compile(r'\.id = "([\w-]+)"|\b(?:gmsh|gdalMap)\("([\w-]+)"')
# Words that mean something else where a file of one format is read.
READERS = re.compile(r"core/(files|drawing_files)/\w+/")


def main():
    root = Path(sys.argv[1])
    ids = {a or b for path in LISTS for a, b in ID.findall((root / path).read_text(encoding="utf-8"))}
    word = '"(?:' + "|".join(map(re.escape, sorted(ids))) + r')"(?:sv)?\)?'
    comparison = re.compile(rf"[=!]=\s*(?:std::string(?:_view)?\()?{word}|{word}\s*[=!]=|\b(?:withId|ofId)\({word}")
    faults = []
    for path in sorted(path for top in ("core", "ui", "app") for path in (root / top).rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        if name in LISTS or READERS.match(name):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if found := comparison.search(line):
                faults.append(f"{name}:{number}: {found[0]} is about one format; add what it needs to FileFormat")
    print("\n".join(faults) if faults else f"{len(ids)} ids, compared nowhere")
    return 1 if faults or len(ids) < 15 else 0


if __name__ == "__main__":
    sys.exit(main())
