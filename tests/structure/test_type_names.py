"""Checks that no two types of the project have the same name at namespace scope, in anonymous namespaces too: sources of a
folder are compiled as one, and equal names in headers break the one-definition rule without a word. Usage:
test_type_names.py ROOT"""
import re
import sys
from collections import defaultdict
from pathlib import Path

# A definition begins at the start of a line: the format indents members, not what is in a namespace.
DEFINITION = re.compile(r"^(?:template ?<[^{;]*> ?)?(?:struct|class|union|enum class|enum) (?:\[\[[^\]]*\]\] )?(\w+)(?: final)?"
                        r"(?: ?:[^:][^;]*)?(?: \{.*)?$")
NAMESPACE = re.compile(r"^namespace (?:FOREFRONT_API )?([\w:]+) \{$")
FOLDERS = ("core", "ui", "app", "tests/unit", "tests/ui", "tests/support", "tests/bench")


def definitions(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            namespace = ""
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if found := NAMESPACE.match(line):
                    namespace = found[1]
                elif found := DEFINITION.match(line):
                    yield f"{namespace}::{found[1]}", f"{path.relative_to(root).as_posix()}:{number}"


def main():
    root = Path(sys.argv[1])
    places = defaultdict(list)
    for name, place in definitions(root):
        places[name].append(place)
    faults = [f"{name} is defined in {' and in '.join(where)}" for name, where in sorted(places.items()) if len(where) > 1]
    print("\n".join(faults) if faults else f"{len(places)} types, each with a name of its own")
    return 1 if faults or len(places) < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
