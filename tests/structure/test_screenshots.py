#!/usr/bin/env python3
"""Fails if a panel or dialog of the program has no scene of its name in tests/ui/screenshots.cpp."""
import re
import sys
from pathlib import Path

root = Path(sys.argv[1])
CLASS = re.compile(r"class \w+ final : public (?:Dialog|PreviewDialog|Panel)\b.*?\n};", re.S)
ID = re.compile(r'const char \*id\(\) const override \{ return "([^"]+)"; \}')
REQUEST = re.compile(r'\b(?:request|operation)\.id = "([^"]+)"|QuestionDialog>\(\s*"([^"]+)"|lengthOperation\(\s*context, "([^"]+)"')
EXEMPT = {"layers", "inspector", "spacing", "meshing",  # in every picture
          "writing"}  # shown only while a file is written

found = {}
for file in sorted((root / "ui").rglob("*.[ch]pp")):
    text = file.read_text(encoding="utf-8")
    ids = [match for body in CLASS.findall(text + "\n};") for match in ID.findall(body)]
    ids += [name for names in REQUEST.findall(text) for name in names if name]
    found.update((name, file.relative_to(root)) for name in ids)
scenes = set(re.findall(r'\{"([^"]+)",', (root / "tests/ui/screenshots.cpp").read_text(encoding="utf-8")))

assert {"history", "preferences", "transform", "unsaved", "export", "fillet"} <= found.keys(), sorted(found)
missing = [f"{file}: no scene '{name}'" for name, file in found.items() if name not in scenes | EXEMPT]
print("\n".join(missing) or f"{len(found)} panels and dialogs have a screenshot")
sys.exit(1 if missing else 0)
