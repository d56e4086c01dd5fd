#!/usr/bin/env python3
"""The installed program: installs it, moves the tree, and checks that it meshes and that the editor finds its samples.

    test_program.py CMAKE BUILD_FOLDER VERSION
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

CMAKE, BUILD, VERSION = sys.argv[1:]


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in command)} failed:\n{done.stdout}")
    return done.stdout


def check(condition, message):
    if not condition:
        sys.exit(message)


with tempfile.TemporaryDirectory() as name:
    top = pathlib.Path(name)
    run(CMAKE, "--install", BUILD, "--prefix", top / "first")
    prefix = top / "moved"
    (top / "first").rename(prefix)
    program = prefix / "bin" / "forefront"
    check(run(program, "--version").strip() == f"forefront {VERSION}", "the program prints another version")
    samples = prefix / "share" / "forefront" / "assets" / "samples"
    run(program, "mesh", samples / "plate.json", "-o", top / "plate.msh")
    check((top / "plate.msh").stat().st_size > 0, "no mesh was written")

    [desktop] = prefix.rglob("*.desktop")
    check("Exec=forefront" in desktop.read_text(), f"{desktop.name} starts another program")
    if shutil.which("desktop-file-validate"):
        run("desktop-file-validate", desktop)
    icons = list((prefix / "share" / "icons").rglob("forefront.svg"))
    check(len(icons) == 1, "the icon is missing")

    if shutil.which("xvfb-run"):
        env = {key: value for key, value in os.environ.items() if key != "FOREFRONT_ASSETS"}
        env.update(HOME=name, XDG_CONFIG_HOME=f"{name}/config", XDG_STATE_HOME=f"{name}/state", LIBGL_ALWAYS_SOFTWARE="1")
        run("xvfb-run", "-a", program, "--frames", "5", "--state-file", top / "state.json", cwd=name, env=env)
        widgets = json.loads((top / "state.json").read_text())["widgets"]
        check("start/sample/plate" in widgets, "the editor does not find its samples")
