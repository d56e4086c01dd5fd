#!/usr/bin/env python3
"""The README's ten lines in a project of their own: they compile, and our warnings are no concern of theirs.

    test_consumer.py CMAKE REPOSITORY
"""

import pathlib
import re
import subprocess
import sys
import tempfile

CMAKE, REPOSITORY = sys.argv[1], pathlib.Path(sys.argv[2])
PROJECT = f"""cmake_minimum_required(VERSION 3.25)
project(square LANGUAGES CXX)
add_subdirectory("{REPOSITORY}" forefront)
add_executable(square square.cpp)
target_link_libraries(square forefront_core)
"""
# Each flag that we compile by ourselves would warn of this.
WARNED = "static int unused(double given) { int given2; { int given2 = given; } return 3.5 * given; }\n"


def run(*command, folder):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}")
    return done.stdout


[ten_lines] = re.findall(r"^```cpp\n(.*?)^```$", (REPOSITORY / "README.md").read_text(), re.M | re.S)
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "CMakeLists.txt").write_text(PROJECT)
    (folder / "square.cpp").write_text(ten_lines + WARNED)
    run(CMAKE, "-G", "Ninja", "-B", "build", folder=folder)
    printed = run(CMAKE, "--build", "build", "--target", "CMakeFiles/square.dir/square.cpp.o", folder=folder)
    targets = run("ninja", "-C", "build", "-t", "targets", "all", folder=folder)
if "warning:" in printed:
    sys.exit(f"our warning flags reach the project:\n{printed}")
for part in ("forefront_ui", "forefront_unit_tests"):
    if part in targets:
        sys.exit(f"{part} is built within another project without being asked for")
