"""Compiles the laws, the C of ``PACKAGE/laws``, into one extension of Python's stable ABI, ``PACKAGE._laws``.

The rest of a distribution is in its ``pyproject.toml``. Building it asks for ``ziglang``, a C compiler from
PyPI, only where no other is found. Where nothing compiles, the distribution is installed without the
extension, and its laws run as plain Python, as with ``POINTPRED_COMPILED=0``, which asks for no compiler.

``python setup.py build_ext --inplace`` compiles the files that changed, all of them with ``--force``
or after another ``CC`` or ``CFLAGS``. ``bdist_wheel --plat-name NAME`` compiles with zig for one of
``TARGETS``.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist
from setuptools.errors import CompileError

TARGETS = {
    "manylinux_2_17_x86_64": "x86_64-linux-gnu.2.17",
    "manylinux_2_17_aarch64": "aarch64-linux-gnu.2.17",
    "macosx_11_0_x86_64": "x86_64-macos.11.0",
    "macosx_11_0_arm64": "aarch64-macos.11.0",
    "win_amd64": "x86_64-windows-gnu",
}
"""Platforms that wheels are built for, and what zig calls them."""

ZIGLANG = "ziglang==0.17.1"
ZIG = [sys.executable, "-m", "ziglang"]
FLAGS = ["-std=c11", "-O3", "-ffp-contract=off", "-fPIC", "-fvisibility=hidden"]
FLAGS += ["-Werror=implicit-function-declaration"]

NOT_COMPILED = (
    "The laws of {package} are not compiled: {reason}. They run as plain Python, about 100 times slower. "
    "Install a C compiler (gcc or clang), or run "
    "'python -m pip install ziglang', and install {package} again."
)


def compiler() -> list[str] | None:
    """The command of a C compiler: what ``CC`` says, one on the path, else zig where this Python has it."""
    if named := os.environ.get("CC"):
        return shlex.split(named)
    for name in ("cc", "gcc", "clang"):
        # Run, because Apple puts a cc on the path that only says how to install one.
        if shutil.which(name) and subprocess.run([name, "--version"], capture_output=True).returncode == 0:
            return [name]
    return [*ZIG, "cc", "-mcpu=baseline"] if find_spec("ziglang") else None


def import_library(header: Path, folder: Path) -> Path:
    """What a Windows extension is linked with: the names that ``abi3.h`` declares, from ``python3.dll``."""
    text = header.read_text(encoding="utf-8")
    names = re.findall(r"^API [^(;]*?(\w+)\(", text, re.MULTILINE)
    names += [f"{name} DATA" for name in re.findall(r"^API [^(;]*?(\w+);", text, re.MULTILINE)]
    library, definition = folder / "python3.lib", folder / "python3.def"
    definition.write_text("\n".join(["LIBRARY python3.dll", "EXPORTS", *names, ""]), encoding="utf-8")
    tool = [*ZIG, "dlltool", "-m", "i386:x86-64", "-D", "python3.dll", "-d", definition, "-l", library]
    subprocess.run(tool, check=True)
    return library


class Compile(build_ext):
    """Compiles changed files, several at once, with gcc, clang or zig."""

    def target(self) -> str | None:
        """What zig calls the platform that the wheel is for, where that was said."""
        wheel = self.distribution.get_command_obj("bdist_wheel", create=False)
        return TARGETS.get(getattr(wheel, "plat_name", None))

    def finalize_options(self) -> None:
        """Whoever compiles a checkout by hand wants to see an error; an installation goes on without."""
        super().finalize_options()
        for ext in self.extensions:
            ext.optional = self.editable_mode or not self.inplace

    def get_ext_filename(self, fullname: str) -> str:
        """The file of the extension, named as the wheel's platform names it."""
        if target := self.target():
            return str(Path(*fullname.split("."))) + (".pyd" if "windows" in target else ".abi3.so")
        return super().get_ext_filename(fullname)

    def build_extension(self, ext: Extension) -> None:
        """Compile for this machine or the wheel's; nothing old is left where that fails."""
        Path(self.get_ext_fullpath(ext.name)).unlink(missing_ok=True)
        if self.editable_mode:
            Path(self.get_ext_filename(ext.name)).unlink(missing_ok=True)
        target = self.target()
        command = [*ZIG, "cc", "-mcpu=baseline", "-target", target] if target else compiler()
        package = ext.name.partition(".")[0].replace("_", "-")
        if command is None:
            raise CompileError(NOT_COMPILED.format(package=package, reason="no C compiler was found"))
        try:
            self.compile_and_link(ext, command, target or sys.platform)
        except (OSError, subprocess.CalledProcessError) as error:
            if target:
                raise
            raise CompileError(NOT_COMPILED.format(package=package, reason=f"{command[0]} failed")) from error

    def compile_and_link(self, ext: Extension, command: list[str], platform: str) -> None:
        """Compile the files that are older than their object, then link."""
        headers = max((Path(header).stat().st_mtime for header in ext.depends), default=0.0)
        flags = [*FLAGS, *shlex.split(os.environ.get("CFLAGS", ""))]
        # Of each compiler and its flags apart: objects of two that are linked together differ in last bits.
        made_by = sha256(shlex.join([*command, *flags]).encode()).hexdigest()[:12]
        folder = Path(self.build_temp, ext.name, made_by)
        folder.mkdir(parents=True, exist_ok=True)

        def compiled(source: str) -> Path:
            file, made = Path(source), folder / f"{Path(source).stem}.o"
            if self.force or not made.exists() or made.stat().st_mtime < max(headers, file.stat().st_mtime):
                subprocess.run([*command, *flags, "-c", file, "-o", made], check=True)
            return made

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            objects = list(pool.map(compiled, ext.sources))
        libraries: list[str | Path] = ["-lm"]
        if "macos" in platform or platform == "darwin":
            libraries = ["-Wl,-undefined,dynamic_lookup"]
        elif platform.startswith(("x86_64-windows", "win")):
            libraries = [import_library(Path(ext.sources[0]).parent / "abi3.h", folder)]
        if self.target():
            libraries.append("-s")  # a wheel for others carries no names for a debugger
        libraries += shlex.split(os.environ.get("LDFLAGS", ""))
        library = Path(self.get_ext_fullpath(ext.name))
        library.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([*command, *flags, "-shared", *objects, *libraries, "-o", library], check=True)


class Sources(sdist):
    """Takes this file along, also where ``setup.py`` of the distribution only runs it."""

    def make_release_tree(self, base_dir: str, files: list[str]) -> None:
        """Lay the files of the distribution, with this one as its ``setup.py``."""
        super().make_release_tree(base_dir, files)
        Path(base_dir, "setup.py").unlink(missing_ok=True)  # it may be a link to the source
        shutil.copy(__file__, Path(base_dir, "setup.py"))


def extensions() -> list[Extension]:
    """``PACKAGE._laws`` where it is wanted, there is C in ``PACKAGE/laws`` and Python has the stable ABI."""
    if os.environ.get("POINTPRED_COMPILED") == "0":
        return []
    if sys.implementation.name != "cpython" or sysconfig.get_config_var("Py_GIL_DISABLED"):
        return []
    return [
        Extension(
            f"{folder.parent.name}._laws",
            sorted(file.as_posix() for file in folder.glob("*.c")),
            depends=sorted(file.as_posix() for file in folder.glob("*.h")),
            py_limited_api=True,
        )
        for folder in Path().glob("*/laws")
        if list(folder.glob("*.c"))
    ]


if __name__ in {"__main__", "<run_path>"}:
    found = extensions()
    # setuptools.build_meta, the backend, runs egg_info to ask what building needs.
    asked = "egg_info" in sys.argv and found and not compiler()
    setup(
        ext_modules=found,
        cmdclass={"build_ext": Compile, "sdist": Sources},
        options={"bdist_wheel": {"py_limited_api": "cp311"}} if found else {},
        setup_requires=[ZIGLANG] if asked else [],
    )
