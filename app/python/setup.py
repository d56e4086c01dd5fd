"""Builds the package: CMake compiles the module forefront._core from the repository that this folder is in.

FOREFRONT_BUILD_DIR: a build folder of the repository whose module is taken, so that nothing is compiled twice.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
VERSION = re.search(r"project\(forefront VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
WORK = ROOT / "build" / "wheel"


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        given = os.environ.get("FOREFRONT_BUILD_DIR")
        folder = Path(given) if given else WORK / "cmake"
        if not given:
            self.configure(folder)
        subprocess.run(["cmake", "--build", folder, "--target", "forefront_python", "-j", str(self.jobs())], check=True)
        suffix = Path(self.get_ext_filename("_core")).name
        module = folder / "app" / "python" / "package" / "forefront" / suffix
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(module, target)

    @staticmethod
    def configure(folder):
        settings = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_UNITY_BUILD": "ON", "FOREFRONT_PCH": "ON",
                    "FOREFRONT_EDITOR": "OFF", "FOREFRONT_PROGRAM": "OFF", "FOREFRONT_TESTS": "OFF",
                    "FOREFRONT_INSTALL": "OFF", "FOREFRONT_PYTHON": "ON", "Python_EXECUTABLE": sys.executable}
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja",
                        *(f"-D{name}={value}" for name, value in settings.items())], check=True)

    @staticmethod
    def jobs():
        return int(os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or os.cpu_count() or 1)


WORK.mkdir(parents=True, exist_ok=True)
setup(
    version=VERSION,
    packages=["forefront", "forefront.compat"],
    package_data={"forefront": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("forefront._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    # Nothing is written beside the sources.
    options={"build": {"build_base": str(WORK / "build")}, "egg_info": {"egg_base": str(WORK)}},
    zip_safe=False,
)
