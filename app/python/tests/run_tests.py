"""Runs the tests of the Python package. Usage: run_tests.py PACKAGE_FOLDER PROGRAM BUILD_FOLDER

Returns 77, which ctest shows as skipped, if pytest or NumPy is not installed.
"""
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

if __name__ == "__main__":
    missing = [name for name in ("pytest", "numpy") if importlib.util.find_spec(name) is None]
    if missing:
        print("not installed:", *missing)
        sys.exit(77)
    package, program, build = sys.argv[1:]
    environment = {**os.environ, "PYTHONPATH": package, "FOREFRONT_PROGRAM": program, "FOREFRONT_BUILD_DIR": build,
                   "PYTHONDONTWRITEBYTECODE": "1"}
    folder = Path(__file__).resolve().parent
    sys.exit(subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", folder],
                            env=environment).returncode)
