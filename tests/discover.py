#!/usr/bin/env python3
"""Writes a CTest file with the cases of a doctest program.

    discover.py PROGRAM PREFIX LABELS OUTPUT
    discover.py --sources LABEL LABELS SOURCE...

Cases about the same subject, the part of their names before the colon, are one test, PREFIX/SUBJECT, since starting the
program takes longer than most cases. Its labels are PREFIX, those that the file LABELS gives to the cases or their source
files, and the words of their suites; cases with other labels are a test of their own, named by the subject and the labels.
A case that is labelled slow or long is always a test by itself, PREFIX/CASE. Tests that are not labelled slow are labelled
fast. The second form prints the sources that hold a case to which LABELS gives the label, and those without any case,
separated by semicolons.
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


def filter_for(names):
    """The option that selects these cases. doctest separates names by commas."""
    return "--test-case=" + ",".join(name.replace("\\", "\\\\").replace(",", "\\,") for name in names)


def check_filter(program, names):
    """Fails if the filter of a test would leave out a case."""
    for first in range(0, len(names), 200):  # an argument has at most 128 KiB
        part = names[first : first + 200]
        counted = subprocess.run([program, "--count", filter_for(part)], stdout=subprocess.PIPE, check=True, text=True)
        if int(re.search(r"filters: (\d+)", counted.stdout)[1]) != len(part):
            sys.exit(f"a case between '{part[0]}' and '{part[-1]}' has a name that no filter matches")


def tests_of(program, prefix, given):
    """The tests, as names of cases by name of the test and labels."""
    tests = {}
    names = set()
    for case in cases(program):
        name, source = case.get("name"), pathlib.Path(case.get("filename")).name
        if name in names:
            sys.exit(f"{source}: two cases are named '{name}'; each needs a different name")
        names.add(name)
        labels = labels_of(name, source, given) | set(case.get("testsuite", "").split())
        alone = labels & {"slow", "long"}
        test = name if alone else ", ".join([name.split(":")[0], *sorted(labels)])
        labels |= {prefix} if "slow" in labels else {prefix, "fast"}
        tests.setdefault((f"{prefix}/{test}", ";".join(sorted(labels)), bool(alone)), []).append(name)
    check_filter(program, sorted(names))
    return tests


def main(program, prefix, labels_file, output):
    lines = []
    for (test, labels, alone), names in tests_of(program, prefix, list(rules(pathlib.Path(labels_file)))).items():
        lines.append(f"add_test({quoted(test)} {quoted(program)} {quoted(filter_for(names))})")
        cost = 45 if alone else len(names)  # CTest starts the highest first
        lines.append(f"set_tests_properties({quoted(test)} PROPERTIES TIMEOUT {TIMEOUT} LABELS {quoted(labels)}"
                     f' COST {cost} FAIL_REGULAR_EXPRESSION "test cases: +0 ")')
    pathlib.Path(output).write_text("\n".join(lines) + "\n")


if sys.argv[1] == "--sources":
    sources_with(*sys.argv[2:])
else:
    main(*sys.argv[1:])
