"""The build backend of `pip install .` (PEP 517): the Python module as a wheel, the tracked files as an sdist.

It needs CMake, Ninja, a compiler and the libraries of cmake/packages.txt, and no package of Python. It builds in
build/wheel; pip's --config-settings build-dir=DIR names another folder.
"""

import base64
import hashlib
import io
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
VERSION = re.search(r"project\(steadyslide VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text("utf-8"))[1]
NAME = f"{PROJECT['name']}-{VERSION}"
INFO = f"{NAME}.dist-info"


def metadata():
    """Returns the core metadata of the package."""
    lines = ["Metadata-Version: 2.1", f"Name: {PROJECT['name']}", f"Version: {VERSION}", f"Summary: {PROJECT['description']}",
             f"License: {PROJECT['license']['text']}", f"Requires-Python: {PROJECT['requires-python']}"]
    lines += [f"Requires-Dist: {name}" for name in PROJECT["dependencies"]]
    for extra, names in PROJECT["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {name}; extra == "{extra}"' for name in names)]
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", (ROOT / PROJECT["readme"]).read_text("utf-8")])


def tag():
    """Returns the tag of the wheel: the interpreter, its binary interface and the system."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True, stdout=sys.stderr)


def module_files(build):
    """Builds the module, and returns the files of its folder: {name: contents}."""
    cmake("-G", "Ninja", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DSTEADYSLIDE_BUILD_TESTS=OFF",
          "-DSTEADYSLIDE_BUILD_PYTHON=ON", "-DSTEADYSLIDE_PYTHON_DIR=.",
          f"-DPython_EXECUTABLE={os.path.realpath(sys.executable)}")
    cmake("--build", build, "--target", "steadyslide_python")
    with tempfile.TemporaryDirectory() as staging:
        cmake("--install", build, "--strip", "--component", "python", "--prefix", staging)
        return {f"steadyslide/{file.name}": file.read_bytes() for file in Path(staging, "steadyslide").iterdir()}


def info_files():
    """Returns the files that describe the wheel: {name: contents}."""
    wheel = f"Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    return {f"{INFO}/LICENSE": (ROOT / "LICENSE").read_bytes(), f"{INFO}/METADATA": metadata().encode(),
            f"{INFO}/WHEEL": wheel.encode()}


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes the metadata without a build, and returns the name of its folder."""
    for name, data in info_files().items():
        file = Path(metadata_directory, name)
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(data)
    return INFO


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel, and returns the name of its file."""
    files = module_files(Path((config_settings or {}).get("build-dir", ROOT / "build" / "wheel"))) | info_files()
    digests = {name: base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=") for name, data in files.items()}
    record = [f"{name},sha256={digests[name]},{len(data)}\n" for name, data in files.items()] + [f"{INFO}/RECORD,,\n"]
    files[f"{INFO}/RECORD"] = "".join(record).encode()
    wheel = f"{NAME}-{tag()}.whl"
    with zipfile.ZipFile(Path(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name)
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """Writes the tracked files of a checkout as an archive, and returns the name of its file."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    info = tarfile.TarInfo(f"{NAME}/PKG-INFO")
    info.size = len(metadata().encode())
    with tarfile.open(Path(sdist_directory, f"{NAME}.tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for file in listed.split("\0")[:-1]:
            archive.add(ROOT / file, f"{NAME}/{file}", recursive=False)
        archive.addfile(info, io.BytesIO(metadata().encode()))
    return f"{NAME}.tar.gz"
