"""Builds the release of the commit that is checked out into ``dist``, and says what is left to do.

``python release.py build``, or ``make release``: wheels, source distributions, the npm tarball, a bill of
materials, the changes of the version, and checksums. ``again`` builds everything a second time, elsewhere,
with nothing that the first build left, and compares the bytes. ``check`` compares the release with the tag,
the changelog and the tree. Nothing is published.

Files that are not committed are not part of it: it is built from an archive of the commit, whose time is
that of every file (``SOURCE_DATE_EPOCH``), with the versions of tools that ``constraints.txt``,
``package-lock.json``, ``setup.ZIGLANG`` and the ``Makefile`` name.
"""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import tomllib
from collections.abc import Iterator
from pathlib import Path

from setup import TARGETS  # type: ignore[attr-defined]  # mypy takes the one in observers

ROOT = Path(__file__).parent
DIST = ROOT / "dist"
FOLDERS = {"pointpred": ".", "pointpred-server": "server", "pointpred-observers": "observers"}
"""The distributions, each after those that it needs."""
PACKAGE = "server/pointpred_server/web/lib/package.json"
SUMS = "SHA256SUMS"
NO_ADDRESS = "github.com/OWNER/"
"""In the address of a repository that nobody has filled in yet."""
PIP = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
VENDORED = re.compile(r"\b(uPlot) (\d[\d.]*\d)")
"""The code of others in ``pointpred-server``, as ``NOTICE`` names it: under the MIT License."""

STEPS = """\
Steps that only a person can do, each once:
  1. Accounts on PyPI and npm, with a second factor, for whoever publishes; the names were free on 2026-11-27.
  2. PyPI, https://pypi.org/manage/account/publishing/: a pending trusted publisher for each of
     {names}: the repository, the workflow release.yml, the environment pypi.
  3. npm: publish the first version by hand, `npm publish {tarball}`; then, in the settings of the package,
     a trusted publisher: the repository, the workflow release.yml, the environment npm.
  4. GitHub: the repository, private reports of weaknesses, the environments pypi and npm, each with somebody
     who must approve; a rule that only maintainers push tags v*.
  5. Zenodo: switch the repository on before its first release; put the DOI into CITATION.cff and README.md.
  6. A host for the site, and its address in the repository's settings.
And for this version:
  7. Try the wheels for macOS and Windows there: `python tests/strangers.py dist`.
  8. `git tag -s v{version}`, `git push origin v{version}`: release.yml builds these files again and publishes
     them once both environments are approved. Compare its SHA256SUMS with this one."""


def git(*arguments: str) -> str:
    """What git prints."""
    return subprocess.run(
        ["git", *arguments], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.strip()


def run(command: list[str | Path], folder: Path, **variables: str) -> None:
    """Run a command in a folder, with variables beside those of this process; it prints errors alone."""
    environment = {**os.environ, **variables}
    subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL, check=True)


def declared(tree: Path = ROOT) -> dict[str, str]:
    """The version, by each place that states it."""
    found = {PACKAGE: str(json.loads((tree / PACKAGE).read_text("utf-8"))["version"])}
    patterns = {
        "pointpred/__init__.py": r'^__version__ = "(.+)"',
        "CITATION.cff": r"^version: (.+)",
        "CHANGELOG.md": r"^## \[(\d.*)\] - \d{4}-\d\d-\d\d$",
    }
    for place, pattern in patterns.items():
        match = re.search(pattern, (tree / place).read_text("utf-8"), re.MULTILINE)
        found[place] = match[1] if match else "none"
    for name in ("server", "observers"):
        place = f"{name}/pyproject.toml"
        project = tomllib.loads((tree / place).read_text("utf-8"))["project"]
        found[place] = project["version"]
        (needed,) = (one for one in project["dependencies"] if re.match(r"pointpred\b", one))
        found[f"{place}, what it needs"] = needed.partition("==")[2]
    return found


def version() -> str:
    """The version of the library, which is that of everything else."""
    return declared()["pointpred/__init__.py"]


def address(tree: Path = ROOT) -> str:
    """Where the repository lies: the npm package states it, the rest of a release repeats it."""
    url = str(json.loads((tree / PACKAGE).read_text("utf-8"))["repository"]["url"])
    return url.removeprefix("git+").removesuffix(".git")


def changes(text: str, of: str) -> str:
    """The part of a changelog that is about one version."""
    return text.partition(f"\n## [{of}]")[2].partition("\n")[2].partition("\n## ")[0].strip() + "\n"


def compiled(tree: Path, name: str) -> bool:
    """Whether a distribution has laws in C, and so a wheel for each platform."""
    return any((tree / FOLDERS[name]).glob("*/laws/*.c"))


def expected() -> set[str]:
    """The names of the files of a release."""
    number, names = version(), {SUMS}
    for name in FOLDERS:
        stem = f"{name.replace('-', '_')}-{version()}"
        tags = [f"cp311-abi3-{one}" for one in TARGETS] if compiled(ROOT, name) else ["py3-none-any"]
        names |= {f"{stem}.tar.gz", *(f"{stem}-{tag}.whl" for tag in tags)}
    return names | {f"pointpred-{number}.tgz", f"pointpred-{number}.cdx.json", f"CHANGELOG-{number}.md"}


def export(commit: str, tree: Path) -> None:
    """Lay the files of a commit into a folder, with the address of the repository in what is published."""
    archive = subprocess.run(
        ["git", "-c", "tar.umask=0022", "archive", commit], cwd=ROOT, check=True, capture_output=True
    ).stdout
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        files.extractall(tree, filter="data")
    repository = address(tree)
    for folder in FOLDERS.values():
        about = tree / folder / "pyproject.toml"
        text = about.read_text("utf-8")
        about.write_text(f'{text}\n[project.urls]\nRepository = "{repository}"\n', "utf-8")
        # An index shows this page far from the files that it links to.
        page = tree / folder / tomllib.loads(text)["project"]["readme"]
        there = [repository, "blob", f"v{version()}", *page.parent.relative_to(tree).parts]
        page.write_text(absolute(page.read_text("utf-8"), "/".join(there)), "utf-8")


def absolute(page: str, there: str) -> str:
    """A page of Markdown with its relative links below an address, those of its pictures to the bytes."""

    def link(match: re.Match[str]) -> str:
        return f"{match[1]}{there.replace('/blob/', '/raw/') if match[1][0] == '!' else there}/"

    return re.sub(r"(!?\[[^\]]*\]\()(?![a-z]+:|#)", link, page)


def build(out: Path, **variables: str) -> None:
    """Build every file of the release into an empty folder."""
    os.umask(0o022)
    commit = git("rev-parse", "HEAD")
    variables["SOURCE_DATE_EPOCH"] = git("log", "-1", "--format=%ct", commit)
    with tempfile.TemporaryDirectory() as temporary:
        tree = Path(temporary, "tree")
        export(commit, tree)
        for name, folder in FOLDERS.items():
            build_wheels(tree / folder, out, list(TARGETS) if compiled(tree, name) else [], variables)
            backend = "import sys; from setuptools import build_meta; build_meta.build_sdist(sys.argv[1])"
            run([sys.executable, "-W", "ignore", "-c", backend, out], tree / folder, **variables)
        for path in out.glob("*.tar.gz"):
            settle(path, int(variables["SOURCE_DATE_EPOCH"]))
        run(["make", "--silent", "package"], tree, **variables)
        shutil.copy(tree / "dist" / f"pointpred-{version()}.tgz", out)
        (out / f"CHANGELOG-{version()}.md").write_text(
            changes((tree / "CHANGELOG.md").read_text("utf-8"), version()), "utf-8"
        )
        write_bill(out, tree, Path(temporary, "installed"), variables)
    sums = "".join(f"{digest}  {name}\n" for name, digest in digests(out).items())
    (out / SUMS).write_text(f"# pointpred {version()}, built from commit {commit}\n{sums}")


def build_wheels(folder: Path, out: Path, platforms: list[str], variables: dict[str, str]) -> None:
    """Build the wheel of each platform, or where none is named the one for all."""
    for option in [["--config-settings", f"--build-option=--plat-name={one}"] for one in platforms] or [[]]:
        shutil.rmtree(folder / "build", ignore_errors=True)
        run(
            [*PIP, "wheel", "--no-deps", "--no-build-isolation", "-w", out, *option, "."], folder, **variables
        )


def settle(path: Path, epoch: int) -> None:
    """Write a ``.tar.gz`` again with nothing in it of when, where and by whom it was made."""
    with tarfile.open(path) as archive:
        members = sorted(archive.getmembers(), key=lambda one: one.name)
        files = [(one, archive.extractfile(one) if one.isfile() else None) for one in members]
        written = io.BytesIO()
        with tarfile.open(fileobj=written, mode="w", format=tarfile.PAX_FORMAT) as again:
            for member, file in files:
                member.uid = member.gid = 0
                member.uname = member.gname = ""
                member.mtime, member.pax_headers = epoch, {}
                again.addfile(member, file)
    with path.open("wb") as raw, gzip.GzipFile("", "wb", mtime=epoch, fileobj=raw) as packed:
        packed.write(written.getvalue())


def write_bill(out: Path, tree: Path, place: Path, variables: dict[str, str]) -> None:
    """Write what the distributions bring along, as CycloneDX, with every extra but that of developers."""
    run([sys.executable, "-m", "venv", "--without-pip", place], tree)
    python = place / "bin" / "python"
    wanted: list[str | Path] = []
    for name, folder in FOLDERS.items():
        project = tomllib.loads((tree / folder / "pyproject.toml").read_text("utf-8"))["project"]
        extras = sorted(set(project.get("optional-dependencies", {})) - {"dev"})
        wanted.append(f"{name}[{','.join(extras)}]=={version()}")
    taken: list[str | Path] = ["install", "--no-compile", "-c", "constraints.txt", "--find-links", out]
    run([*PIP, "--python", python, *taken, *wanted], tree)
    file = out / f"pointpred-{version()}.cdx.json"
    tool: list[str | Path] = [sys.executable, "-m", "cyclonedx_py", "environment", python]
    run([*tool, "--output-reproducible", "--of", "JSON", "--sv", "1.6", "-o", file], tree, **variables)
    bill = json.loads(file.read_text("utf-8"))
    known = {one["name"]: one["bom-ref"] for one in bill["components"]}
    bill["metadata"]["component"] = {"type": "application", "name": "pointpred", "version": version()}
    for name, number in VENDORED.findall((tree / "NOTICE").read_text("utf-8")):
        ref = f"pkg:npm/{name.lower()}@{number}"
        component = {"type": "library", "bom-ref": ref, "name": name, "version": number, "purl": ref}
        bill["components"].append(component | {"licenses": [{"license": {"id": "MIT"}}]})
        bill["dependencies"].append({"ref": ref})
        (needs,) = (one for one in bill["dependencies"] if one["ref"] == known["pointpred-server"])
        needs["dependsOn"].append(ref)
    file.write_text(json.dumps(bill, indent=2) + "\n", "utf-8")


def digests(folder: Path) -> dict[str, str]:
    """The SHA-256 of every file in a folder but the list of these."""
    files = sorted(path for path in folder.iterdir() if path.name != SUMS)
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def compare_with_another_build() -> None:
    """Build again, with an empty cache of the compiler, and leave where a byte differs from ``dist``."""
    with tempfile.TemporaryDirectory() as temporary:
        out = Path(temporary, "another", "dist")
        out.mkdir(parents=True)
        build(out, ZIG_GLOBAL_CACHE_DIR=f"{temporary}/zig")
        first, second = digests(DIST), digests(out)
    differ = sorted(name for name in first.keys() | second.keys() if first.get(name) != second.get(name))
    if differ:
        sys.exit(f"these differ between two builds: {', '.join(differ)}")
    print(f"two builds of commit {git('rev-parse', '--short', 'HEAD')}: {len(first)} files, equal bytes")


def problems() -> Iterator[str]:
    """What speaks against publishing what lies in ``dist``."""
    number = version()
    for place, stated in declared().items():
        if stated != number:
            yield f"{place} says {stated}, pointpred/__init__.py {number}"
    if git("status", "--porcelain"):
        yield "the tree has files that are not committed, or other than committed"
    head = git("rev-parse", "HEAD")
    tag = git("tag", "--list", f"v{number}")
    if not tag:
        yield f"there is no tag v{number}"
    elif git("rev-parse", f"{tag}^{{commit}}") != head:
        yield f"the tag {tag} is of another commit"
    if NO_ADDRESS in address():
        yield f"nobody has filled in the address of the repository: `repository` in {PACKAGE}"
    there = {path.name for path in DIST.glob("*")}
    for name in sorted(expected() ^ there):
        yield f"dist/{name} is missing" if name in expected() else f"dist/{name} is no part of {number}"
    if SUMS in there:
        first, *lines = (DIST / SUMS).read_text("utf-8").splitlines()
        if not first.endswith(head):
            yield "dist was built from another commit"
        if {line[66:]: line[:64] for line in lines} != digests(DIST):
            yield f"files in dist are not those of dist/{SUMS}"


def check() -> int:
    """Print what is wrong and what a person still has to do; 1 where something is wrong."""
    found = list(problems())
    for one in found:
        print(f"not yet: {one}")
    if not found:
        print(f"dist holds {version()}: version, tag, changelog, tree, files and checksums agree")
    print(STEPS.format(version=version(), names=", ".join(FOLDERS), tarball=f"pointpred-{version()}.tgz"))
    return bool(found)


def main(asked: str) -> int:
    """Do one of ``build``, ``again`` and ``check``."""
    if asked == "again":
        compare_with_another_build()
    elif asked == "build":
        shutil.rmtree(DIST, ignore_errors=True)
        DIST.mkdir()
        build(DIST)
        for path in sorted(DIST.iterdir()):
            print(f"{path.stat().st_size / 1e6:6.2f} MB  {path.name}")
        check()
    return check() if asked == "check" else 0


if __name__ == "__main__":
    if sys.argv[1:] not in (["build"], ["again"], ["check"]):
        sys.exit("usage: python release.py build | again | check")
    sys.exit(main(sys.argv[1]))
