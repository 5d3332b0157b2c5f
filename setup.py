# SPDX-License-Identifier: Apache-2.0
"""Builds the wheel of the Python package: CMake builds the extension and the import helper, tools/package/repair_wheel.py puts the libraries that
they need beside them. Metadata: pyproject.toml. CMAKE_ARGS in the environment adds arguments to the configuration."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from wheel.bdist_wheel import bdist_wheel

ROOT = pathlib.Path(__file__).resolve().parent
BUILD = ROOT / "build" / "wheel"

sys.path.insert(0, str(ROOT / "tools/package"))
from repair_wheel import platform_tag, repair  # noqa: E402


def version():
    return re.search(r"project\(rakelight VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildByCMake(build_ext):
    """The package's build folder has all that the wheel holds."""

    def build_extension(self, ext):
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        configure = ["cmake", "--preset", "package", "-B", str(BUILD), "-DRAKELIGHT_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}",
                     "-DRAKELIGHT_VIEWER=OFF", "-DRAKELIGHT_OPENGL=OFF",
                     "-DRAKELIGHT_BOTH_LIBRARIES=OFF", *launcher, *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
        subprocess.run(configure, cwd=ROOT, check=True)
        jobs = str(self.parallel or len(os.sched_getaffinity(0)))
        subprocess.run(["cmake", "--build", str(BUILD), "-j", jobs, "--target", "rakelight_python_package"], cwd=ROOT, check=True)
        package = pathlib.Path(self.get_ext_fullpath(ext.name)).parent
        package.mkdir(parents=True, exist_ok=True)
        built = BUILD / "python" / "rakelight"
        for file in (*built.glob("_core.*.so"), built / "rakelight-import"):
            shutil.copy2(file, package)
        if not self.inplace:
            repair(package, package.parent / "rakelight.libs")


class LinuxWheel(bdist_wheel):
    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        python, abi, _ = super().get_tag()
        return python, abi, platform_tag(self.get_finalized_command("build").build_lib)


setup(
    version=version(),
    packages=["rakelight"],
    package_dir={"": "python"},
    package_data={"rakelight": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("rakelight._core", sources=[])],
    cmdclass={"build_ext": BuildByCMake, "bdist_wheel": LinuxWheel},
)
