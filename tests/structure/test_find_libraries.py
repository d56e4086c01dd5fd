"""Checks that ui/find_libraries.cmake finds GLFW, GLM, Dear ImGui and glad by the names of several systems, each made up of
empty packages, and that it says what is missing. Usage: test_find_libraries.py ROOT"""
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

TARGET = """add_library({0} INTERFACE IMPORTED)
set_target_properties({0} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${{CMAKE_CURRENT_LIST_DIR}}/../../include")
"""
BACKENDS = ["imgui_impl_opengl3.h", "imgui_freetype.h", "imgui_stdlib.h"]


def package(root, name, target, version="3.4"):
    folder = root / "lib" / name
    folder.mkdir(parents=True)
    (folder / f"{name}Config.cmake").write_text(TARGET.format(target))
    (folder / f"{name}ConfigVersion.cmake").write_text(
        f'set(PACKAGE_VERSION "{version}")\nif(NOT PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION)\n'
        "  set(PACKAGE_VERSION_COMPATIBLE TRUE)\nendif()\n")


def module(root, name, version):
    folder = root / "pkgconfig"
    folder.mkdir(exist_ok=True)
    (folder / f"{name}.pc").write_text(
        f"prefix={root}\nName: {name}\nDescription: {name}\nVersion: {version}\nCflags: -I{root}/include/{name}\n")
    (root / "include" / name).mkdir(parents=True, exist_ok=True)


def headers(root, *names):
    for name in names:
        path = root / "include" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()


def vcpkg(root):
    """CMake packages with the headers of the backends beside imgui.h, and glad 2 as a library."""
    package(root, "glfw3", "glfw")
    package(root, "glm", "glm::glm")
    package(root, "imgui", "imgui::imgui", "1.92")
    package(root, "glad", "glad::glad", "2.0")
    headers(root, *BACKENDS, "glad/gl.h")


def conan(root):
    """Other names of the targets, and the headers of the backends in folders."""
    package(root, "glfw3", "glfw::glfw")
    package(root, "glm", "glm")
    package(root, "imgui", "imgui::imgui", "1.91")
    package(root, "glad", "glad::glad", "2.0")
    headers(root, "backends/imgui_impl_opengl3.h", "misc/freetype/imgui_freetype.h", "misc/cpp/imgui_stdlib.h", "glad/gl.h")


def by_pkg_config(root):
    """Only modules of pkg-config, as in Fedora and Arch, and the program glad."""
    module(root, "glfw3", "3.3.8")
    module(root, "glm", "0.9.9")
    module(root, "imgui", "1.86")
    headers(root, *(f"imgui/{name}" for name in BACKENDS))
    program = root / "bin" / "glad"
    program.parent.mkdir()
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)


def old_glad(root):
    vcpkg(root)
    (root / "include/glad/gl.h").rename(root / "include/glad/glad.h")


def old_glfw(root):
    vcpkg(root)
    (root / "lib/glfw3/glfw3ConfigVersion.cmake").write_text('set(PACKAGE_VERSION "3.2")\n')


def without_freetype(root):
    vcpkg(root)
    (root / "include/imgui_freetype.h").unlink()


# system, expected in the output
CASES = [
    (vcpkg, ["GLFW: target glfw of", "GLM: target glm::glm of", "Dear ImGui: target imgui::imgui", "glad: target glad::glad"]),
    (conan, ["GLFW: target glfw::glfw of", "GLM: target glm of", "Dear ImGui: target imgui::imgui", "glad: target glad::glad"]),
    (by_pkg_config, ["GLFW: pkg-config glfw3", "GLM: pkg-config glm", "Dear ImGui: pkg-config imgui"]),
    (old_glad, ["CMake Error", "glad 2 not found"]),
    (old_glfw, ["CMake Error", "GLFW not found", "libglfw3-dev"]),
    (without_freetype, ["CMake Error", "Dear ImGui has no imgui_freetype.h"]),
]


def configure(finder, system, scratch):
    """Returns what CMake prints for a project that includes the finder, where only the packages of the system exist."""
    root, project = scratch / "system", scratch / "project"
    root.mkdir()
    project.mkdir()
    system(root)
    (project / "CMakeLists.txt").write_text(textwrap.dedent(f"""
        cmake_minimum_required(VERSION 3.25)
        project(found LANGUAGES NONE)
        set(CMAKE_FIND_USE_CMAKE_SYSTEM_PATH OFF)
        set(CMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH OFF)
        set(CMAKE_FIND_USE_PACKAGE_REGISTRY OFF)
        set(CMAKE_PREFIX_PATH {root})
        set(PKG_CONFIG_EXECUTABLE pkg-config)
        set(ENV{{PKG_CONFIG_LIBDIR}} {root}/pkgconfig)
        include({finder})
        foreach(name IN ITEMS glfw glm imgui)
          if(NOT TARGET forefront_${{name}})
            message(FATAL_ERROR "no target forefront_${{name}}")
          endif()
        endforeach()
        """))
    done = subprocess.run(["cmake", "-S", project, "-B", scratch / "build"], capture_output=True, text=True, check=False)
    # CMake breaks its messages into lines.
    return done.returncode == 0, " ".join((done.stdout + done.stderr).split())


def main():
    finder = Path(sys.argv[1]).resolve() / "ui" / "find_libraries.cmake"
    faults = []
    for system, expected in CASES:
        with tempfile.TemporaryDirectory() as scratch:
            done, output = configure(finder, system, Path(scratch))
        name = system.__name__.replace("_", " ")
        faults += [f"{name}: {text!r} is not said in:\n{output}" for text in expected if text not in output]
        if done == ("CMake Error" in expected):
            faults.append(f"{name}: configuring {'succeeds' if done else 'fails'}:\n{output}")
    print("\n".join(faults) if faults else "the libraries of the editor are found by their other names")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
