#!/usr/bin/env python3
"""Prints every text that a user can see, as FILE:LINE: TEXT sorted by file: python3 tests/strings.py [FOREFRONT] [FOLDER...].

Takes the string literals of core, ui and app (or of the folders given) that read as text, and the gallery titles. If the
program FOREFRONT is given, its help texts follow. Adjacent literals are joined and escapes decoded. What is written to
files and names of widgets, codes and keys are left out."""
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ["app", "core", "ui"]
COMMANDS = [[], ["view"], ["mesh"], ["check"], ["adapt"], ["convert"], ["film"], ["trace"], ["tables"], ["run"], ["help"], ["completion"]]
TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/'                      # comments
    r'|R"(?P<tag>[^(\s]*)\((?P<raw>.*?)\)(?P=tag)"'
    r'|(?:u8)?"(?P<text>(?:[^"\\\n]|\\.)*)"'
    r"|'(?:[^'\\\n]|\\.)+'"
    r"|(?P<directive>^[ \t]*#[^\n]*)"
    r"|(?P<space>\s+)|(?P<other>[A-Za-z_0-9]+|.)", re.DOTALL | re.MULTILINE)
NOT_TEXT = re.compile(
    r"^(?:[\w.:+-]+/[\w./-]*|[a-z][a-z0-9]*(?:[-.][a-zA-Z0-9]+)+|[a-z]+[A-Z]\w*|\W*|<.*|[$#].*|[A-Z]+(?:_[A-Z]+)*)$",
    re.DOTALL)


def decode(text):
    data = re.sub(r"\\x([0-9a-fA-F]{1,2})", lambda m: "\\x" + m.group(1).rjust(2, "0"), text)
    raw = data.encode("latin-1", "backslashreplace").decode("unicode_escape", "replace")
    try:
        return raw.encode("latin-1").decode("utf-8", "replace")
    except UnicodeEncodeError:
        return raw


def literals(source):
    """Yields (line, text) of every literal, those side by side joined."""
    line, begun, parts = 1, 0, []
    for match in TOKEN.finditer(source):
        kind = match.lastgroup
        literal = match.group("raw") if match.group("raw") is not None else match.group("text")
        if literal is not None:
            begun = begun if parts else line
            parts.append(literal if match.group("raw") is not None else decode(literal))
        elif kind == "other" or kind == "directive" or match.group(0).startswith("'"):
            if parts:
                yield begun, "".join(parts)
            parts = []
        line += match.group(0).count("\n")
    if parts:
        yield begun, "".join(parts)


def reads_as_text(text):
    words = re.findall(r"[A-Za-z]{2,}", re.sub(r"%[-+ #0-9.*]*l*[a-zA-Z]", "", text))
    if not words or NOT_TEXT.match(text):
        return False
    return " " in text.strip() or text[0].isupper() or "…" in text


def main():
    arguments = sys.argv[1:]
    if arguments and arguments[0] in ("-h", "--help"):
        print(__doc__)
        return 0
    program = arguments.pop(0) if arguments and os.access(arguments[0], os.X_OK) and not Path(arguments[0]).is_dir() else None
    sources = sorted(path for folder in arguments or FOLDERS for path in (ROOT / folder).rglob("*")
                     if path.suffix in (".cpp", ".hpp") and not path.stem.endswith("_write"))
    for path in sources:
        for line, text in literals(path.read_text(encoding="utf-8")):
            if reads_as_text(text):
                print(f"{path.relative_to(ROOT)}:{line}: " + " ⏎ ".join(text.strip("\n").split("\n")))
    for number, line in enumerate((ROOT / "assets/samples/index.txt").read_text(encoding="utf-8").splitlines(), 1):
        print(f"assets/samples/index.txt:{number}: {line.partition(' ')[2]}")
    for command in COMMANDS if program else []:
        shown = subprocess.run([program, *command, "--help"], capture_output=True, text=True, check=False)
        for number, line in enumerate((shown.stdout + shown.stderr).splitlines(), 1):
            print(f"forefront {' '.join([*command, '--help'])}:{number}: {line}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except BrokenPipeError:  # the reader has seen enough
        os._exit(0)
