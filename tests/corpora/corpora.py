#!/usr/bin/python3
"""Meshes public corpora of drawings and maps, and prints a table for each.

    python3 tests/corpora/corpora.py fetch --corpus DIR [--repositories DIR] [NAME]...
    python3 tests/corpora/corpora.py run   --corpus DIR --program build/release/app/forefront [NAME]... [--jobs N]

`fetch` writes the files below DIR; the sources are in sources.py: whole corpora, and samples of others. `run` meshes
each file with the default options on one thread, checks the mesh against the file, and compares its area with what
librsvg paints (SVG) or GEOS unites (maps). Details of every file go to DIR/NAME.csv, so that two runs can be compared.
True areas are kept in DIR/NAME-areas.json; remove it when areas.py has changed.

Needs the Debian packages git, python3-shapely, python3-pil, librsvg2-bin and 7zip.
"""

import argparse
import collections
import concurrent.futures
import csv
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

import areas
import sources

MAX_AREA_ERROR = 0.005
SLOW_SECONDS, SLOW_ELEMENTS = 2.0, 500_000
MIN_ALPHA, MIN_ANGLE = 0.95, 20.0
CPU_LIMIT = 300  # seconds a file
REFUSALS = ("empty-domain", "no-outline", "bad-format")  # no area, or no file of the kind


def bounded_run(command, cwd=None):
    """Runs a program for at most CPU_LIMIT seconds. Returns exit code, errors and CPU seconds."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT, CPU_LIMIT + 5))

    with tempfile.TemporaryFile() as errors:
        with subprocess.Popen(command, cwd=cwd, stdout=subprocess.DEVNULL, stderr=errors, preexec_fn=limit) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        return process.returncode, errors.read().decode(errors="replace"), usage.ru_utime + usage.ru_stime


def judge(program, path):
    """Meshes and checks one file. Returns a row of the details."""
    row = {"file": path.name, "state": "meshed"}
    with tempfile.TemporaryDirectory() as scratch:
        mesh, statistics = pathlib.Path(scratch, "mesh.msh"), pathlib.Path(scratch, "mesh.json")
        code, errors, seconds = bounded_run([program, "mesh", path, "-o", mesh, "--format", "msh41-binary",
                                             "--threads", "1", "--stats", statistics])
        row["seconds"] = round(seconds, 3)
        if code != 0:
            faults = [line for line in errors.splitlines() if "error" in line] or errors.splitlines()[-1:] or [""]
            found = re.search(r"\[([a-z-]+)\]", faults[0])
            row.update(state="refused" if code == 1 else f"exit {code}",
                       reason=found[1] if found else faults[0][:80])
            return row
        numbers = json.loads(statistics.read_text())
        corners = numbers.get("sharp_corners", [])
        row.update(elements=numbers["elements"], alpha=numbers["alpha_geometric_mean"], alpha_min=numbers["alpha_min"],
                   angle=numbers["min_angle_deg"], angle_elsewhere=numbers["min_angle_elsewhere_deg"],
                   sharp_corners=len(corners), prepare=numbers["seconds_prepare"], front=numbers["seconds_mesh"],
                   improve=numbers["seconds_improve"], area=numbers.get("area"), hash=numbers["hash"],
                   narrow=len(numbers.get("narrow_places", [])))
        code, errors, _ = bounded_run([program, "check", mesh, "--domain", path])
        row["valid"] = int(code == 0)
        if code != 0:
            row["reason"] = errors.strip().splitlines()[-1][:160] if errors.strip() else f"exit {code}"
    return row


def area_or_none(path):
    """Returns the true area of a file, or None if it is malformed or beyond the reference program."""
    try:
        return areas.area_of(path)
    except Exception as fault:  # pylint: disable=broad-exception-caught
        print(f"no area of {path}: {fault}", file=sys.stderr)
        return None


def true_areas(folder, files):
    """Returns the true area of each file, from a cache beside the files where there is one."""
    cache = folder.parent / f"{folder.name}-areas.json"
    known = json.loads(cache.read_text()) if cache.exists() else {}
    missing = [path for path in files if path.name not in known]
    with concurrent.futures.ProcessPoolExecutor() as pool:
        for path, area in zip(missing, pool.map(area_or_none, missing, chunksize=8)):
            known[path.name] = area
    cache.write_text(json.dumps(known))
    return known


def run_corpus(name, arguments):
    folder = arguments.corpus / name
    files = sorted(path for path in folder.iterdir() if fnmatch_any(path.name, arguments.only))
    known = true_areas(folder, files)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for row in pool.map(lambda path: judge(arguments.program, path), files):
            row["true_area"] = known[row["file"]]
            rows.append(row)
            if sys.stderr.isatty():
                print(f"\r{name} {len(rows)}/{len(files)}", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print("\r", end="", file=sys.stderr)
    columns = ["file", "state", "reason", "valid", "elements", "area", "true_area", "seconds", "prepare", "front",
               "improve", "alpha", "alpha_min", "angle", "angle_elsewhere", "sharp_corners", "narrow", "hash"]
    with open(arguments.corpus / f"{name}{arguments.suffix}.csv", "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, columns)
        writer.writeheader()
        writer.writerows(rows)
    return rows


def fnmatch_any(name, pattern):
    return pathlib.PurePath(name).match(pattern)


def area_is_off(row):
    true = row["true_area"]
    return true is not None and row["area"] is not None and abs(row["area"] - true) > MAX_AREA_ERROR * abs(true)


def is_slow(row):
    return row["seconds"] > SLOW_SECONDS and row["elements"] < SLOW_ELEMENTS


def is_poor(row):
    return row["alpha"] < MIN_ALPHA


def is_sharp(row):
    """Returns true if an angle is small away from corners and narrow places that force it."""
    return row["angle_elsewhere"] < MIN_ANGLE


def refusals(rows):
    """Returns the reasons of refusals with their counts."""
    reasons = collections.Counter(row.get("reason", "") for row in rows if row["state"] != "meshed")
    return ", ".join(f"{count} {reason}" for reason, count in reasons.most_common()) or 0


def share(rows, condition):
    """Returns how many rows fulfil a condition, with the first names."""
    found = [row for row in rows if condition(row)]
    names = ", ".join(row["file"].rsplit(".", 1)[0] for row in found[:4])
    return f"{len(found)}" + (f" ({names}{', …' if len(found) > 4 else ''})" if found else "")


def table(name, rows):
    meshed = [row for row in rows if row["state"] == "meshed"]
    lines = [("files", len(rows)), ("meshed", len(meshed)), ("of them valid", sum(row["valid"] for row in meshed)),
             ("refused", refusals(rows))]
    if meshed:
        elements = sorted(row["elements"] for row in meshed)
        slowest = max(meshed, key=lambda row: row["seconds"])
        lines += [
            ("area off by more than 0.5 %", share(meshed, area_is_off)),
            ("triangles: median, 99 %, maximum",
             f"{elements[len(elements) // 2]}, {elements[len(elements) * 99 // 100]}, {elements[-1]}"),
            ("slowest", f"{slowest['file']}: {slowest['seconds']:.1f} s, {slowest['elements']} triangles"),
            ("more than 2 s for fewer than 500,000 triangles", share(meshed, is_slow)),
            ("α geometric mean below .95", share(meshed, is_poor)),
            ("minimum angle below 20°", share(meshed, lambda row: row["angle"] < MIN_ANGLE)),
            ("the same away from corners and narrow places that force it", share(meshed, is_sharp)),
            ("minimum angle", f"{min(row['angle'] for row in meshed):.2g}°"),
        ]
    source, licence = sources.SOURCES[name]
    return "\n".join([f"### {name}: {source} ({licence})", "", "| | |", "|---|---|"] +
                     [f"| {label} | {value} |" for label, value in lines]) + "\n"


def sample_table(corpora):
    """Returns one table of all samples, a line each."""
    lines = ["### Samples", "", "| corpus | files | meshed | valid | refused | area off | slow | α below .95 | minimum angle "
             "below 20° elsewhere | triangles: median, maximum | source |", "|---|" + "---|" * 10]
    for name, rows in corpora.items():
        meshed = [row for row in rows if row["state"] == "meshed"]
        elements = sorted(row["elements"] for row in meshed) or [0]
        source, licence, _ = sources.SAMPLES[name]
        cells = [name, len(rows), len(meshed), sum(row["valid"] for row in meshed), refusals(rows),
                 share(meshed, area_is_off), share(meshed, is_slow), share(meshed, is_poor), share(meshed, is_sharp),
                 f"{elements[len(elements) // 2]}, {elements[-1]}", f"{source} ({licence})"]
        lines.append("| " + " | ".join(str(cell) for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def summary(corpora):
    """Returns a sentence about all files."""
    rows = [row for some in corpora.values() for row in some]
    meshed = [row for row in rows if row["state"] == "meshed"]
    poor = sum(1 for row in meshed if is_poor(row))
    return (f"All corpora of this run: {len(rows)} files, {len(meshed)} meshed, {sum(row['valid'] for row in meshed)} "
            f"of them valid; {poor} ({100 * poor / max(1, len(meshed)):.2f} %) with α below .95.\n")


def main():
    known = [*sources.SOURCES, *sources.SAMPLES]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["fetch", "run"])
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(known)}; default: all")
    parser.add_argument("--corpus", type=pathlib.Path, required=True, help="folder of the files")
    parser.add_argument("--repositories", type=pathlib.Path, help="folder of clones named OWNER+NAME")
    parser.add_argument("--program", default="forefront")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="*", help="pattern of file names")
    parser.add_argument("--suffix", default="", help="appended to the names of the CSV files")
    arguments = parser.parse_intermixed_args()
    names = arguments.names or known
    unknown = set(names) - set(known)
    if unknown:
        parser.error(f"unknown corpus {', '.join(sorted(unknown))}; expected {', '.join(known)}")
    if arguments.command == "fetch":
        sources.fetch(names, arguments.corpus, arguments.repositories)
        return
    corpora = {}
    for name in names:
        corpora[name] = run_corpus(name, arguments)
        if name in sources.SOURCES:
            print(table(name, corpora[name]), flush=True)
    samples = {name: rows for name, rows in corpora.items() if name in sources.SAMPLES}
    if samples:
        print(sample_table(samples), flush=True)
    print(summary(corpora))


if __name__ == "__main__":
    main()
