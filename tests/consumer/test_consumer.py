#!/usr/bin/env python3
"""The library as its users meet it: installed as a static and as a shared library, and used by the README's example
through find_package, pkg-config and add_subdirectory. All six programs must write the same file. The examples of
usual tasks are built against the installed library and run, too. The library that is added as a folder is compiled by
another compiler; the meshes of all pinned scenes must be the same with it.

    test_consumer.py CMAKE REPOSITORY BUILD_FOLDER
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

CMAKE, REPOSITORY, BUILD = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
KINDS = {"static": "forefront_core", "shared": "forefront_shared"}
VERSION = re.search(r"project\(forefront VERSION ([0-9.]+)", (REPOSITORY / "CMakeLists.txt").read_text())[1]
MINOR = VERSION.rsplit(".", 1)[0]
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES {languages})
{find}
add_executable(consumer consumer.cpp)
target_link_libraries(consumer Forefront::core)
"""
# The public headers must be clean under the warnings that their users may have chosen.
STRICT = "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror"
# Our own warnings must not reach users: each of them would report this line.
CARELESS = "static int unused(double given) { int given2; { int given2 = given; } return 3.5 * given; }\n"
EXAMPLES = REPOSITORY / "tests" / "consumer" / "examples"
[EXAMPLE] = re.findall(r"^```cpp\n(.*?)^```$", (REPOSITORY / "README.md").read_text(), re.M | re.S)


def project(find, languages="CXX"):
    return PROJECT.format(find=find, languages=languages)


def run(*command, folder, env=None):
    done = subprocess.run([str(word) for word in command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, env=dict(os.environ, **(env or {})))
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in command)} failed:\n{done.stdout}")
    return done.stdout


def check(condition, message):
    if not condition:
        sys.exit(message)


def installed(kind, folder):
    """Installs one kind, then moves the tree: nothing in it may depend on where it was installed."""
    first, prefix = folder / f"first-{kind}", folder / f"prefix-{kind}"
    for component in (KINDS[kind], KINDS[kind] + "_runtime"):
        run(CMAKE, "--install", BUILD, "--prefix", first, "--component", component, folder=folder)
    first.rename(prefix)
    headers = {str(path.relative_to(prefix / "include")) for path in prefix.rglob("*.hpp")}
    check("forefront/forefront.hpp" in headers, f"forefront.hpp is missing among {sorted(headers)}")
    check(all(name.startswith("forefront/") for name in headers), f"headers outside of forefront/: {sorted(headers)}")
    for name in headers:
        text = (prefix / "include" / name).read_text()
        check('#include "core/' not in text, f'{name} includes "core/..."')
    for path in prefix.rglob("*"):
        if path.suffix in (".cmake", ".pc"):
            check(str(REPOSITORY) not in path.read_text(), f"{path.name} names the source folder")
    return prefix


def library_folder(prefix):
    [pc] = prefix.rglob("forefront.pc")
    return pc.parent.parent


def check_shared_object(prefix):
    [library] = [path for path in library_folder(prefix).glob("libforefront.so.*") if not path.is_symlink()]
    dynamic = run("readelf", "-d", library, folder=prefix)
    check(f"Library soname: [libforefront.so.{MINOR}]" in dynamic, f"unexpected soname:\n{dynamic}")
    names = run("nm", "-DC", "--defined-only", library, folder=prefix).splitlines()
    # Strong symbols only: templates of the standard library that users instantiate too are weak.
    strong = [line.split(" ", 2)[2] for line in names if line.split(" ", 2)[1] in "TDB"]
    # The names of the C interface have no namespace; every one is declared in its header.
    declared = set(re.findall(r"\b(forefront_\w+)\(", (prefix / "include" / "forefront" / "forefront.h").read_text()))
    foreign = [name for name in strong if "forefront::" not in name and name not in declared]
    check(strong and not foreign, f"exported symbols that are not ours: {foreign[:10]}")
    check(declared <= set(strong), f"C functions that are not exported: {sorted(declared - set(strong))[:10]}")
    check(any("forefront::meshDomain(" in name for name in strong), "meshDomain is not exported")
    hidden = [name for name in strong if "GenerationFront" in name or "PlaneSweep" in name or "pugi::" in name]
    check(not hidden, f"internal symbols are exported: {hidden[:10]}")


def result(program, folder, prefix=None):
    env = {} if prefix is None else {"LD_LIBRARY_PATH": str(library_folder(prefix))}
    run(program, folder=folder, env=env)
    [mesh] = folder.glob("*.msh")
    return mesh.read_bytes()


def source_folder(folder, name, text):
    made = folder / name
    made.mkdir()
    (made / "consumer.cpp").write_text(text)
    return made


def by_find_package(kind, prefix, folder):
    made = source_folder(folder, f"find-package-{kind}", EXAMPLE)
    (made / "CMakeLists.txt").write_text(project(f"find_package(Forefront {MINOR} REQUIRED)"))
    run(CMAKE, "-G", "Ninja", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_FLAGS={STRICT}", folder=made)
    run(CMAKE, "--build", "build", folder=made)
    return result(made / "build" / "consumer", made)


def check_other_versions_are_refused(prefix, folder):
    for version in ("0.1", "0.2", "0.9", "1.0"):
        made = source_folder(folder, f"version-{version}", EXAMPLE)
        # The version is checked before anything else, so that no compiler is needed.
        (made / "CMakeLists.txt").write_text(project(f"find_package(Forefront {version} REQUIRED)", languages="NONE"))
        done = subprocess.run([CMAKE, "-G", "Ninja", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}"], cwd=made,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        check(done.returncode != 0 and "compatible" in done.stdout, f"version {version} is accepted:\n{done.stdout}")


def by_pkg_config(kind, prefix, folder):
    made = source_folder(folder, f"pkg-config-{kind}", EXAMPLE)
    [pc] = prefix.rglob("forefront.pc")
    env = {"PKG_CONFIG_PATH": str(pc.parent)}
    check(run("pkg-config", "--modversion", "forefront", folder=made, env=env).strip() == VERSION, "another version")
    flags = run("pkg-config", "--cflags", "--libs", "forefront", folder=made, env=env).split()
    run(os.environ.get("CXX", "c++"), "-std=c++20", *STRICT.split(), "consumer.cpp", "-o", "consumer", *flags, folder=made,
        env=env)
    return result(made / "consumer", made, prefix)


def by_add_subdirectory(folder):
    """One build tree, first static and then shared, so that the library is compiled once. It is compiled with clang where
    that is installed, and not optimised: the mesh must be the same with another compiler and other options."""
    made = source_folder(folder, "add-subdirectory", EXAMPLE + CARELESS)
    (made / "CMakeLists.txt").write_text(project(f'add_subdirectory("{REPOSITORY}" forefront)'))
    compiler = os.environ.get("CXX") or shutil.which("clang++") or "c++"
    for kind, shared in (("static", "OFF"), ("shared", "ON")):
        run(CMAKE, "-G", "Ninja", "-B", "build", f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=Debug",
            "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DFOREFRONT_PCH=ON", "-DCMAKE_UNITY_BUILD=ON", "-DFOREFRONT_WERROR=ON",
            f"-DBUILD_SHARED_LIBS={shared}", folder=made)
        targets = run("ninja", "-C", "build", "-t", "targets", "all", folder=made)
        for part in ("forefront_ui", "forefront_unit_tests", "app/forefront"):
            check(part not in targets, f"{part} is built in another project without being asked for")
        printed = run(CMAKE, "--build", "build", "--target", "consumer", folder=made)
        check("warning:" not in printed, f"our warnings reach the project:\n{printed}")
        check("forefront_drawing" not in printed, f"drawings are compiled for a program that only meshes:\n{printed}")
        yield kind, result(made / "build" / "consumer", made)
    check_pinned_meshes(made)


def check_pinned_meshes(made):
    run(CMAKE, "-B", "build", "-DFOREFRONT_TESTS=ON", "-DFOREFRONT_UNIT_TESTS=OFF", "-DBUILD_SHARED_LIBS=OFF", folder=made)
    run(CMAKE, "--build", "build", "--target", "forefront_pinned", folder=made)
    [program] = made.glob("build/**/forefront_pinned")
    run(program, REPOSITORY / "assets", REPOSITORY / "tests" / "pinned" / "meshes.txt", folder=made)


def user_lines(text):
    """Returns the lines of an example that its user writes: all but blank lines, comments, includes and main() itself."""
    frame = r"\s*$|\s*//|#include|int main\(\) \{|\}"
    return [line for line in text.splitlines() if not re.match(frame, line)]


# The examples share the precompiled header of the library, which takes most of the time of compiling each.
SHARED_HEADER = """cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL share_header)
function(share_header)
  get_property(programs DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  list(POP_FRONT programs first)
  target_precompile_headers(${first} PRIVATE <forefront/forefront.hpp>)
  foreach(program ${programs})
    target_precompile_headers(${program} REUSE_FROM ${first})
  endforeach()
endfunction()
"""


def check_examples(prefix, folder):
    """Builds the examples as one project and runs each: they must succeed, and stay short."""
    made = folder / "examples"
    shutil.copytree(EXAMPLES, made)
    (made / "shared_header.cmake").write_text(SHARED_HEADER)
    sources = sorted(made.glob("*.cpp"))
    check(len(sources) == 11, f"{len(sources)} examples instead of 11")
    run(CMAKE, "-G", "Ninja", "-B", "build", f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_FLAGS={STRICT}",
        f"-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES={made / 'shared_header.cmake'}", folder=made)
    run(CMAKE, "--build", "build", folder=made)
    for source in sources:
        check("#include <forefront/forefront.hpp>" in source.read_text(), f"{source.name} does not include forefront.hpp")
        lines = len(user_lines(source.read_text()))
        check(0 < lines <= 15, f"{source.name} has {lines} lines; expected at most 15")
        run(made / "build" / source.stem, folder=made)


def check_warnings_stay_warnings(folder):
    made = source_folder(folder, "werror", EXAMPLE)
    (made / "CMakeLists.txt").write_text(project(f'add_subdirectory("{REPOSITORY}" forefront)'))
    run(CMAKE, "-G", "Ninja", "-B", "build", folder=made)
    commands = run("ninja", "-C", "build", "-t", "commands", "consumer", folder=made)
    check("-Wall" in commands and "-Werror" not in commands, "-Werror is on in another project")


with tempfile.TemporaryDirectory() as name:
    top = pathlib.Path(name)
    results = {}
    for kind in KINDS:
        prefix = installed(kind, top)
        results[f"find_package, {kind}"] = by_find_package(kind, prefix, top)
        results[f"pkg-config, {kind}"] = by_pkg_config(kind, prefix, top)
        if kind == "static":
            check_examples(prefix, top)
        if kind == "shared":
            check_shared_object(prefix)
            check_other_versions_are_refused(prefix, top)
    check_warnings_stay_warnings(top)
    for kind, mesh in by_add_subdirectory(top):
        results[f"add_subdirectory, {kind}"] = mesh
    check(len(results) == 6 and len(set(results.values())) == 1, f"different meshes: {sorted(results)}")
