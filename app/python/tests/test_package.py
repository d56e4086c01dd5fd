"""The wheel: built without a network, installed, and imported away from the sources."""
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

import forefront as ff

FOLDER = Path(__file__).resolve().parents[1]


def test_a_wheel_is_built_and_installed_offline(tmp_path):
    build = os.environ.get("FOREFRONT_BUILD_DIR")
    if not build:
        pytest.skip("FOREFRONT_BUILD_DIR is not set")
    missing = [name for name in ("build", "pip", "wheel", "setuptools") if importlib.util.find_spec(name) is None]
    if missing:
        pytest.skip("not installed: " + ", ".join(missing))
    environment = {**os.environ, "PIP_NO_INDEX": "1"}
    environment.pop("PYTHONPATH", None)
    subprocess.run([sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", tmp_path, FOLDER],
                   check=True, env=environment, stdout=subprocess.DEVNULL)
    wheel, = tmp_path.glob("forefront-*.whl")
    assert ff.__version__ in wheel.name
    there = tmp_path / "installed"
    subprocess.run([sys.executable, "-m", "pip", "install", "--no-index", "--no-deps", "--target", there, wheel],
                   check=True, env=environment, stdout=subprocess.DEVNULL)
    assert (there / "forefront" / "py.typed").exists() and (there / "forefront" / "_core.pyi").exists()
    program = "import forefront as ff; m = ff.mesh([(0, 0), (1, 0), (0, 1)], 0.2); print(ff.__file__, m.hash)"
    result = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True,
                            env={**environment, "PYTHONPATH": str(there)}, cwd=tmp_path)
    place, number = result.stdout.split()
    assert place.startswith(str(there)) and int(number) == ff.mesh([(0, 0), (1, 0), (0, 1)], 0.2).hash
