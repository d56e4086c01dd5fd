"""Prints the table of peers.sh: peer_table.py FOREFRONT FOLDER PEER...; FOLDER/peer_cgal is the compiled CGAL mesher.

Seconds are the CPU time of the call that makes the triangles and improves them. Reading, writing, start-up and, if it is
a separate step, the discretisation of the boundary are not included. The fastest of ROUNDS runs counts; the meshers take
turns, so that a busy moment of the machine affects all of them. A mesher that takes more than SLOW seconds runs once.
`forefront check` measures every mesh against the requested spacing."""

import json
import pathlib
import re
import subprocess
import sys

from peer_cases import CASES

ROUNDS = 3
SLOW = 8.0
LIMIT = 300  # seconds for one run
HERE = pathlib.Path(__file__).parent
PROGRAM, FOLDER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
REFERENCE = "Gmsh front2d"


def run(words):
    """Returns what the program prints; raises RuntimeError with one line if it fails."""
    try:
        done = subprocess.run([str(w) for w in words], capture_output=True, text=True, timeout=LIMIT, cwd=FOLDER)
    except (subprocess.TimeoutExpired, OSError) as error:
        raise RuntimeError(f"not finished after {LIMIT} s" if isinstance(error, subprocess.TimeoutExpired) else error)
    if done.returncode != 0:
        lines = (done.stderr.strip() or done.stdout.strip() or f"exit code {done.returncode}").splitlines()
        raise RuntimeError(lines[-1][:100])
    return done.stdout


def find(pattern, printed):
    """Returns the groups of the pattern in the output; raises RuntimeError if nothing matches."""
    match = re.search(pattern, printed, re.M)
    if not match:
        raise RuntimeError(f"no line of its output matches {pattern}")
    return match.groups()


def ours(*options):
    def mesh(name, case, out):
        run([PROGRAM, "mesh", f"{name}.poly", "--spacing", case.spacing, "-o", out, "--stats", "stats.json", *options])
        stats = json.loads((FOLDER / "stats.json").read_text())
        return stats["seconds_mesh"] + stats["seconds_improve"]
    return mesh


def peer(*command):
    """Returns a mesher that takes CASE OUT (CGAL: CASE NODES OUT ROUNDS) and prints mesh_cpu=SECONDS."""
    def mesh(name, case, out):
        printed = run([w.format(case=name, out=out) for w in command])
        return float(find(r"^mesh_cpu=(.*)$", printed)[0])
    return mesh


def script(name):
    return peer(sys.executable, str(HERE / name), "{case}", "{out}")


MESHERS = {
    "Forefront, front only": ours("--improve", "none"),
    "Forefront": ours(),
    "Forefront, best": ours("--improve", "best"),
    "Forefront, classic front only": ours("--method", "classic", "--improve", "none"),
    REFERENCE: script("peer_gmsh.py"),
    "Netgen": script("peer_netgen.py"),
    "CGAL refinement": peer("./peer_cgal", "{case}", "{case}.txt", "{out}"),
    "CGAL with Lloyd, 10 rounds": peer("./peer_cgal", "{case}", "{case}.txt", "{out}", "10"),
}
MESHERS = {name: mesh for name, mesh in MESHERS.items() if name.split()[0].rstrip(",") in ("Forefront", *sys.argv[3:])}
# Tens of times slower than refinement alone, so it runs on one case only.
ONLY = {"CGAL with Lloyd, 10 rounds": "graded-0.05"}


def judge(case, out):
    """Returns the number of elements and the columns α mean, α min, min angle, δ, all measured by `forefront check`."""
    printed = run([PROGRAM, "check", out, "--spacing", case.spacing])
    return int(find(r"(\d+) elements", printed)[0]), (
        *find(r"^shape factor: mean ([\d.]+),.*minimum ([\d.]+); angles ([\d.]+)", printed),
        *find(r"conformity: mean ([\d.]+)", printed))


def measure(name, case):
    """Returns {mesher: (seconds, elements, columns) or RuntimeError}."""
    found = {}
    for _ in range(ROUNDS):
        for mesher, mesh in MESHERS.items():
            before = found.get(mesher)
            if ONLY.get(mesher, name) != name or isinstance(before, RuntimeError) or (before and before[0] > SLOW):
                continue
            out = FOLDER / "mesh.msh"
            out.unlink(missing_ok=True)
            try:
                seconds = mesh(name, case, out)
                found[mesher] = (min(seconds, before[0]), *before[1:]) if before else (seconds, *judge(case, out))
            except RuntimeError as error:
                found[mesher] = error
    return found


def rows(name, found):
    reference = found.get(REFERENCE)
    base = reference[1] / reference[0] if isinstance(reference, tuple) else None
    for mesher, what in found.items():
        if isinstance(what, RuntimeError):
            print(f"peers.sh: {name}: {mesher} is left out: {what}", file=sys.stderr)
            continue
        seconds, elements, columns = what
        speed = elements / seconds
        times = f"{speed / base:.2g}" if base and speed < 10 * base else f"{speed / base:.0f}" if base else ""
        yield (f"| {name} | {mesher} | {elements} | {seconds:.3f} | {speed / 1000:.0f} | {times} | "
               + " | ".join(columns) + " |")


for case_name, CASE in CASES.items():
    (FOLDER / f"{case_name}.poly").write_text(CASE.poly())
    (FOLDER / f"{case_name}.txt").write_text("".join(f"{x!r} {y!r}\n" for x, y in CASE.polygon))
print("| case | mesher | triangles | CPU s | 1000/s | × Gmsh | α mean | α min | min angle ° | δ |")
print("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|")
for case_name, CASE in CASES.items():
    for row in rows(case_name, measure(case_name, CASE)):
        print(row, flush=True)
