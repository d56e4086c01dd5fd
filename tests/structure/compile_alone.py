"""Checks the syntax of the sources named on standard input with the commands of a compilation database. Usage:
compile_alone.py COMPILE_COMMANDS"""
import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def check(entry):
    words = shlex.split(entry["command"])
    at = words.index("-o")
    del words[at:at + 2]
    run = subprocess.run([*words, "-fsyntax-only", "-O0"], cwd=entry["directory"], capture_output=True, text=True, check=False)
    return run.returncode, run.stderr


def main():
    wanted = {(Path.cwd() / line.strip()).resolve() for line in sys.stdin if line.strip()}
    entries = [entry for entry in json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
               if Path(entry["file"]).resolve() in wanted]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        failed = [text for code, text in pool.map(check, entries) if code != 0]
    print("\n".join(failed), end="")
    print(f"alone: {len(entries)} of {len(wanted)} sources are part of this build and were checked; {len(failed)} failed")
    return 1 if failed or not entries else 0


if __name__ == "__main__":
    sys.exit(main())
