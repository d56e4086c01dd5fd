"""Checks that every field of the editor, and every tool in which numbers are typed, has a test with slow frames: a row in
tests/ui/entry_fields.txt whose case is in tests/ui/test_slow_*.cpp. Usage: test_entry_fields.py ROOT"""
import re
import sys
from collections import Counter
from pathlib import Path

# Functions that draw a field. Each is called with the context, then, maybe after others, the name of the field.
FUNCTIONS = ["ui::inputNumber", "ui::inputOptional", "ui::inputExpression", "ui::inputPoint", "ui::inputName", "ui::inputChecked",
             "ui::inputText", "ui::entry", "entry", "form::number", "form::optionalField", "form::pair", "form::text", "form::tag",
             "drawSizeOption", "drawOptionalSizeOption", "drawFormulaOption", "drawLengthOption", "drawPlaceField",
             "film_fields::whole", "film_fields::number", "optionalNumber", "drawSize"]
CALL = re.compile(r"(?<![\w:.>])(" + "|".join(FUNCTIONS) + r")\(\s*context,\s*")
TYPING = {"NumericEntry": re.compile(r"^    NumericEntry \w+;", re.M),
          "entryFields": re.compile(r"^    (?:virtual )?std::span<const EntryField> entryFields\(\) const\b", re.M)}
WRAPPED = "for others: "


def arguments(text):
    """The arguments of a call, from behind the first comma to its closing parenthesis."""
    depth, quoted, found, start = 1, False, [], 0
    for k, c in enumerate(text):
        if c == '"' and text[k - 1] != "\\":
            quoted = not quoted
        if quoted:
            continue
        depth += (c in "([{") - (c in ")]}")
        if depth == 0 or (c == "," and depth == 1):
            found.append(re.sub(r"\s+", " ", text[start:k]).strip().replace('"', ""))
            start = k + 1
        if depth == 0:
            return found
    raise ValueError("a call without an end")


def calls(path):
    """The names of the fields that a source draws, one for each call."""
    text = path.read_text(encoding="utf-8")
    for call in CALL.finditer(text):
        given = arguments(text[call.end():])
        yield given[1] if given[0] == "flow" else given[0]
    for word, pattern in TYPING.items():
        yield from [word] * len(pattern.findall(text))


def main():
    root = Path(sys.argv[1])
    drawn = Counter((path.relative_to(root / "ui").as_posix(), name) for path in sorted((root / "ui").rglob("*.[ch]pp"))
                    for name in calls(path))
    lines = (root / "tests/ui/entry_fields.txt").read_text(encoding="utf-8").splitlines()
    rows = [[column.strip() for column in line.split("|")] for line in lines if not line.startswith("#")]
    listed = Counter((source, call) for source, call, _, _ in rows if source)
    tests = "".join(path.read_text(encoding="utf-8") for path in sorted((root / "tests/ui").glob("test_slow_*.cpp")))
    cases = set(re.findall(r'expectSame\(\s*"([^"]*)"', tests))
    faults = [f"ui/{source}: the field {name} has no row in tests/ui/entry_fields.txt ({count} drawn, {listed[source, name]} listed)"
              for (source, name), count in drawn.items() if count > listed[source, name]]
    faults += [f"ui/{source} draws no field {name} ({count} listed)" for (source, name), count in listed.items()
               if count > drawn[source, name]]
    for source, call, field, case in rows:
        if case.startswith(WRAPPED):
            others = case[len(WRAPPED):].split(" and ")
            unknown = [other for other in others if other not in FUNCTIONS and "ui::" + other not in FUNCTIONS]
            faults += [f"ui/{source}: {call}: {other} draws no field" for other in unknown]
        elif case not in cases:
            faults.append(f"ui/{source}: {field or call}: there is no case '{case}' in tests/ui/test_slow_*.cpp")
    print("\n".join(faults) if faults else f"{sum(drawn.values())} places where one types have a case with slow frames")
    return 1 if faults or not drawn else 0


if __name__ == "__main__":
    sys.exit(main())
