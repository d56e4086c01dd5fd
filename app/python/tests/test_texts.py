"""The code of the README, the docstrings and the examples does what it shows."""
import doctest
import inspect
import os
import subprocess
import sys
from pathlib import Path

import pytest

import forefront as ff

FOLDER = Path(__file__).resolve().parents[1]
EXAMPLES = sorted((FOLDER / "examples").glob("*.py"))


def test_readme_and_docstring():
    results = doctest.testfile(str(FOLDER / "README.md"), module_relative=False)
    assert results.attempted > 20 and results.failed == 0
    results = doctest.testmod(ff)
    assert results.attempted > 2 and results.failed == 0


def test_there_are_examples():
    assert len(EXAMPLES) >= 3


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example_prints_what_it_says(example, tmp_path):
    result = subprocess.run([sys.executable, example], capture_output=True, text=True, cwd=tmp_path,
                            env={**os.environ, "MPLBACKEND": "Agg"})
    assert result.returncode == 0, result.stderr
    expected = [line[4:] for line in example.read_text().splitlines() if line.startswith("#-> ")]
    assert expected and result.stdout.splitlines() == expected


def test_everything_public_is_documented():
    for name in ff.__all__:
        value = getattr(ff, name)
        if inspect.isclass(value) or inspect.isfunction(value):
            assert inspect.getdoc(value), name
        if inspect.isclass(value) and value.__module__.startswith("forefront._") and value is not ff.Fault:
            for member, found in vars(value).items():
                if not member.startswith("_") and (inspect.isfunction(found) or isinstance(found, property)):
                    assert inspect.getdoc(found), f"{name}.{member}"


def test_properties_of_compiled_classes_are_documented():
    for cls in (ff.Domain, ff.Mesh, ff.Fault):
        properties = [name for name in dir(cls) if not name.startswith("_") and isinstance(getattr(cls, name), property)]
        assert len(properties) > 5
        for name in properties:
            assert inspect.getdoc(getattr(cls, name)), f"{cls.__name__}.{name}"


def test_stubs_name_what_the_module_has():
    from forefront import _core

    text = (Path(ff.__file__).parent / "_core.pyi").read_text()
    for name in vars(_core):
        if not name.startswith("__"):
            assert f"class {name}" in text or f"def {name}(" in text, name
            value = getattr(_core, name)
            for member in vars(value) if inspect.isclass(value) else ():
                if not member.startswith("__"):
                    assert f"def {member}(" in text or f"    {member}: " in text, f"{name}.{member}"
