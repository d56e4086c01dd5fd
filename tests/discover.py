#!/usr/bin/env python3
"""Writes a CTest file in which each case of a doctest program is a separate test.

    discover.py PROGRAM PREFIX LABELS OUTPUT
    discover.py --sources LABEL LABELS SOURCE...

Each test is named PREFIX/CASE. Its labels are PREFIX, those that the file LABELS gives to the case or its source file,
and the words of the case's suite. Cases that are not labelled slow are labelled fast. The second form prints the sources
that hold a case to which LABELS gives the label, and those without any case, separated by semicolons.
"""

import fnmatch
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

TIMEOUT = 600  # seconds; only a hang takes that long


def rules(path):
    for line in path.read_text().splitlines():
        words = line.split("#")[0].split()
        for pattern in words[1:]:
            yield words[0], pattern


def cases(program):
    listed = subprocess.run([program, "--list-test-cases", "--reporters=xml"], stdout=subprocess.PIPE, check=True, text=True)
    # The program may print another line before the XML.
    document = ElementTree.fromstring(listed.stdout[listed.stdout.index("<?xml"):].encode())
    return document.findall("TestCase")


def labels_of(case, source, given):
    """The labels that the file gives to a case of the source file."""
    return {label for label, pattern in given
            if fnmatch.fnmatchcase(source, pattern) or fnmatch.fnmatchcase(case, pattern)}


def sources_with(label, labels_file, *sources):
    given = list(rules(pathlib.Path(labels_file)))
    kept = []
    for source in map(pathlib.Path, sources):
        names = re.findall(r'^TEST_CASE\(\s*"((?:[^"\\]|\\.)*)"', source.read_text(), re.MULTILINE)
        if not names or any(label in labels_of(name, source.name, given) for name in names):
            kept.append(str(source))
    print(";".join(kept), end="")


def quoted(text):
    equals = "=" * (max((len(run) for run in re.findall("=+", text)), default=0) + 1)
    return f"[{equals}[{text}]{equals}]"


def main(program, prefix, labels_file, output):
    given = list(rules(pathlib.Path(labels_file)))
    lines = []
    names = set()
    for case in cases(program):
        name, source = case.get("name"), pathlib.Path(case.get("filename")).name
        if name in names:
            sys.exit(f"{source}: two cases are named '{name}'; each needs a different name")
        names.add(name)
        labels = {prefix} | labels_of(name, source, given) | set(case.get("testsuite", "").split())
        if "slow" not in labels:
            labels.add("fast")
        cost = 10 if labels & {"slow", "long"} else 0  # CTest starts the highest first
        test = quoted(f"{prefix}/{name}")
        # doctest separates names by commas.
        only = quoted("--test-case=" + name.replace(",", "\\,"))
        lines.append(f"add_test({test} {quoted(program)} {only})")
        lines.append(f"set_tests_properties({test} PROPERTIES TIMEOUT {TIMEOUT} LABELS {quoted(';'.join(sorted(labels)))}"
                     f' COST {cost}'
                     ' FAIL_REGULAR_EXPRESSION "test cases: +0 ")')
    pathlib.Path(output).write_text("\n".join(lines) + "\n")


if sys.argv[1] == "--sources":
    sources_with(*sys.argv[2:])
else:
    main(*sys.argv[1:])
