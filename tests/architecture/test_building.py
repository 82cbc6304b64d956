"""Building the distributions: which compiler, what is asked for, what is said where nothing compiles."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.architecture.tree import ROOT

HEADER = Path(sysconfig.get_path("include"), "Python.h")
ABI3 = ROOT / "pointpred" / "laws" / "abi3.h"
COMPILER = next((name for name in ("cc", "gcc", "clang") if shutil.which(name)), None)
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="needs a C compiler")


@pytest.fixture
def source(tmp_path: Path) -> Path:
    """Two small distributions, one in a folder of the other as the observers are."""
    tree = tmp_path / "tree"
    for folder, name in ((tree, "pointpred"), (tree / "observers", "pointpred_observers")):
        (folder / name).mkdir(parents=True)
        (folder / name / "__init__.py").touch()
        shutil.copytree(ROOT / "pointpred" / "laws", folder / name / "laws")
        about = f'[project]\nname = "{name}"\nversion = "1"\n[tool.setuptools]\npackages = ["{name}"]\n'
        (folder / "pyproject.toml").write_text(f"{about}include-package-data = false\n")
    shutil.copy(ROOT / "setup.py", tree)
    shutil.copy(ROOT / "observers" / "setup.py", tree / "observers")
    return tree


def run(folder: Path, *arguments: str, code: int = 0, **environment: str) -> str:
    """What this Python prints with its packages and with the given variables alone."""
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        env={"PYTHONPATH": ":".join(path for path in sys.path if path), **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert done.returncode == code, done.stdout
    return done.stdout


def asked(folder: Path, kind: str, **environment: str) -> list[str]:
    """What building a wheel or an editable installation asks for."""
    code = f"from setuptools import build_meta; print('asked', *build_meta.get_requires_for_build_{kind}())"
    return re.findall(r"^asked *(.*)$", run(folder, "-c", code, **environment), re.MULTILINE)[0].split()


without_zig = pytest.mark.skipif(find_spec("ziglang") is not None, reason="zig is installed")


@without_zig
@pytest.mark.parametrize("folder", [".", "observers"])
@pytest.mark.parametrize("kind", ["wheel", "editable"])
def test_zig_is_asked_for_only_where_there_is_no_compiler(source: Path, folder: str, kind: str) -> None:
    empty = source / "bin"
    empty.mkdir()
    assert [one.partition("=")[0] for one in asked(source / folder, kind, PATH=str(empty))] == ["ziglang"]
    assert asked(source / folder, kind, PATH=str(empty), CC="my-compiler") == []
    for code in (1, 0):
        # Apple's cc without developer tools is there, and fails.
        (empty / "cc").write_text(f"#!/bin/sh\nexit {code}\n")
        (empty / "cc").chmod(0o755)
        assert bool(asked(source / folder, kind, PATH=str(empty))) is bool(code)


def test_nothing_is_asked_for_where_nothing_is_compiled(source: Path) -> None:
    assert asked(source, "wheel", PATH="", POINTPRED_COMPILED="0") == []
    shutil.rmtree(source / "pointpred" / "laws")
    assert asked(source, "wheel", PATH="") == []


@without_zig
def test_building_goes_on_without_a_compiler_and_says_what_follows(source: Path) -> None:
    said = run(source, "setup.py", "build", PATH="")
    assert "The laws of pointpred are not compiled: no C compiler was found. They run as plain Python" in said
    assert "pip install ziglang" in said
    assert [path.name for path in source.glob("build/lib*/pointpred/*")] == ["__init__.py"]


@pytest.mark.parametrize("folder", [".", "observers"])
def test_a_compiler_that_fails_is_named_and_leaves_nothing_old(source: Path, folder: str) -> None:
    package = "pointpred" if folder == "." else "pointpred_observers"
    old = source / folder / package / "_laws.abi3.so"
    said = f"The laws of {package.replace('_', '-')} are not compiled: false failed."
    old.touch()
    assert said in run(source / folder, "setup.py", "build_ext", "--inplace", CC="false", code=1)
    assert said in run(source / folder, "setup.py", "build", CC="false")
    assert old.exists()
    build = "from setuptools import build_meta; build_meta.build_editable('.')"
    assert said in run(source / folder, "-c", build, CC="false")
    assert not old.exists()


@needs_compiler
def test_only_what_changed_is_compiled(source: Path) -> None:
    def compile_laws() -> dict[str, int]:
        run(source, "setup.py", "build_ext", "--inplace", PATH=os.environ["PATH"], CFLAGS="-O0")
        return {path.name: path.stat().st_mtime_ns for path in source.glob("build/temp*/*/*/*.o")}

    laws = source / "pointpred" / "laws"
    first = compile_laws()
    assert set(first) == {f"{path.stem}.o" for path in laws.glob("*.c")}
    changed = next(path for path in laws.glob("*.c") if path.stem != "module")
    os.utime(changed)
    second = compile_laws()
    assert {name for name in first if first[name] != second[name]} == {f"{changed.stem}.o"}
    os.utime(laws / "abi3.h")
    third = compile_laws()
    assert all(second[name] != third[name] for name in first)
    print_place = "import pointpred._laws; print(pointpred._laws.__file__)"
    assert run(source, "-c", print_place).strip() == str(source / "pointpred" / "_laws.abi3.so")


@needs_compiler
def test_a_source_distribution_of_the_observers_builds_alone(source: Path, tmp_path: Path) -> None:
    build = "import sys; from setuptools import build_meta; getattr(build_meta, sys.argv[1])('.')"
    run(source / "observers", "-c", build, "build_sdist", PATH=os.environ["PATH"], CFLAGS="-O0")
    with tarfile.open(next((source / "observers").glob("*.tar.gz"))) as archive:
        archive.extractall(tmp_path / "alone", filter="data")
    (alone,) = (tmp_path / "alone").iterdir()
    run(alone, "-c", build, "build_wheel", PATH=os.environ["PATH"], CFLAGS="-O0")
    (wheel,) = alone.glob("*.whl")
    assert "-cp311-abi3-" in wheel.name


@needs_compiler
@pytest.mark.skipif(not HEADER.exists(), reason="needs the headers of Python")
def test_abi3_declares_what_python_declares(tmp_path: Path) -> None:
    """Sizes, places, constants and types of functions of ``abi3.h`` are those of ``Python.h``."""
    text = ABI3.read_text(encoding="utf-8")
    structs = re.findall(r"^typedef struct(?: \w+)? \{\n(.*?)^\} (\w+);", text, re.MULTILINE | re.DOTALL)
    fields = [
        (kind, field)
        for body, kind in structs
        for field in re.findall(r"^  (?:\w.*?[ *]|\w.*?\(\*)(\w+)(?:;|\)\()", body, re.MULTILINE)
    ]
    assert len(fields) > 25
    constants = re.findall(r"^#define ((?:METH|Py_mod|PyBUF)_\w+)", text, re.MULTILINE)
    shown = [f"offsetof({kind}, {field})" for kind, field in fields]
    shown += [f"sizeof({kind})" for _, kind in structs] + constants
    lines = "".join(f'  printf("%s %ld\\n", "{one}", (long)({one}));\n' for one in shown)
    answers = []
    for name, include in (("ours", f'#include "{ABI3}"'), ("pythons", "#include <Python.h>")):
        program = tmp_path / name
        head = f"#define Py_LIMITED_API 0x030B0000\n{include}\n#include <stdio.h>\n#include <stddef.h>\n"
        program.with_suffix(".c").write_text(f"{head}int main(void) {{\n{lines}  return 0;\n}}\n")
        compile_it = [str(COMPILER), f"-I{HEADER.parent}", program.with_suffix(".c"), "-o", program]
        subprocess.run(compile_it, check=True)
        answers.append(subprocess.run([program], capture_output=True, text=True, check=True).stdout)
    assert answers[0] == answers[1]

    # Declared twice in one file, a function must have one type.
    functions = re.findall(r"^API (.*;)$", text, re.MULTILINE)
    assert len(functions) > 20
    both = tmp_path / "both.c"
    both.write_text(
        "#define Py_LIMITED_API 0x030B0000\n#include <Python.h>\n"
        + "".join(f"extern {one}\n" for one in functions if "_Py_NoneStruct" not in one)
    )
    subprocess.run([str(COMPILER), f"-I{HEADER.parent}", "-fsyntax-only", both], check=True)
