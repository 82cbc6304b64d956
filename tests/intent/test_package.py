"""The npm package: what it exports is there and typed, it is installed as a tarball, imported anywhere."""

from __future__ import annotations

import json
import shutil
import tomllib
from pathlib import Path

import pytest

from pointpred.registry import REGISTRY
from tests.hosts import file_host
from tests.intent import npm
from tests.intent.npm import LIB, ROOT
from tests.server import browser
from tests.server.page_browser import Visitor

PACKAGE = json.loads((LIB / "package.json").read_text())
TYPED = [name for name, entry in PACKAGE["exports"].items() if isinstance(entry, dict)]
NODE = shutil.which("node")
installed = pytest.mark.slow
"""Packages of npm take longest: `make npm` runs it."""
needs_node = pytest.mark.skipif(NODE is None, reason="no node on this machine")
POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'self'"
SCRIPTS = ("pointpred.min.js", "minimum-jerk.min.js")


@pytest.fixture(scope="module")
def tarball(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return npm.pack(tmp_path_factory.mktemp("packed"))


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project that has installed the tarball, Vite and TypeScript."""
    folder = tmp_path_factory.mktemp("project")
    npm.install(folder, "vite@7.3.8", "typescript@5.9.3")
    return folder


def test_the_licence_is_that_of_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert PACKAGE["license"] == project["license"]
    assert "dependencies" not in PACKAGE
    for name in ("LICENSE", "NOTICE"):
        assert (LIB / name).read_text() == (ROOT / name).read_text()


def test_it_says_where_it_comes_from() -> None:
    assert PACKAGE["repository"]["url"].startswith("git+https://github.com/")
    assert (ROOT / PACKAGE["repository"]["directory"]) == LIB


def test_each_predictor_has_an_entry_and_each_entry_types() -> None:
    assert {f"./{name}" for name in REGISTRY} <= set(TYPED)
    for name in TYPED:
        types, module = PACKAGE["exports"][name]["types"], PACKAGE["exports"][name]["default"]
        assert list(PACKAGE["exports"][name]) == ["types", "default"], "TypeScript takes the first that fits"
        assert (LIB / types).is_file(), types
        assert (LIB / module).is_file(), module


@installed
def test_what_belongs_goes_with_it(tarball: Path) -> None:
    listed = npm.run(["tar", "tzf", tarball.name], tarball.parent).stdout.split()
    found = {path.removeprefix("package/") for path in listed}
    assert {"index.js", "index.d.ts", "laws/kinematic.js", "laws/parameters.d.ts", *SCRIPTS} <= found
    assert {path.removeprefix("./") for name in TYPED for path in PACKAGE["exports"][name].values()} <= found
    rooms = {path.partition("/")[0] for path in found}
    assert rooms == {*PACKAGE["files"], "package.json", "LICENSE", "README.md"}


@installed
def test_an_installed_tarball_is_installed_again_by_npm_ci_and_built(project: Path) -> None:
    (project / "index.html").write_text('<script type="module" src="./main.js"></script>')
    (project / "main.js").write_text(
        'import { prefetchLink } from "pointpred/intent"; prefetchLink("nav a");'
    )
    npm.run(["npm", "ci", *npm.QUIET], project)
    assert not (project / "node_modules" / "pointpred").is_symlink()
    npm.run(["npx", "vite", "build", "--logLevel", "warn"], project)
    assert "Float64Array" in "".join(path.read_text() for path in (project / "dist").rglob("*.js"))


USED = """
import * as all from "pointpred";
import { onIntent, prefetchLink, register, showOverlay, onPlace, ledger } from "pointpred/intent";
import * as small from "pointpred/minimum-jerk";
import * as learned from "pointpred/kinematic-adaptive";
import { build } from "pointpred/switched";
import type { IntentOptions, PredictorName } from "pointpred";

declare const link: HTMLAnchorElement;
const name: PredictorName = "kinematic";
const options: IntentOptions = { predictor: name, policy: "highlight", hitSlop: { top: 8 } };
const stop: () => void = onIntent(link, ({ p }) => console.log(p.toFixed(2)), options);
small.onIntent(link, () => {}, { threshold: 0.4 });
learned.onPlace(({ place }) => console.log(place.size));
small.prefetchLink("nav a", { action: "prerender", threshold: 0.7 });
all.connect("ws://here", { predictor: "my-own", page: true });
const pipelines = [all.build("switched", { threshold: 0.1 }), build({ bound: 2, gain_xi: 2, person: "" })];
pipelines.map(async (one) => (await one).update({ t: 0, x: 1, y: 2 })?.remaining_s);
console.log(stop, register(link).share, showOverlay, onPlace, ledger().hit, small.ledger().hit);

// @ts-expect-error a misspelled predictor
onIntent(link, () => {}, { predictor: "minimum-jerc" });
// @ts-expect-error a misspelled option
onIntent(link, () => {}, { treshold: 0.4 });
// @ts-expect-error a misspelled policy
prefetchLink(link, { policy: "hihglight" });
// @ts-expect-error a text for a number
register(link, { hitSlop: "8" });
// @ts-expect-error there is one predictor
small.onIntent(link, () => {}, { predictor: "minimum-jerk" });
// @ts-expect-error it learns no places
small.onPlace(() => {});
// @ts-expect-error a misspelled option
small.register(link, { prioritty: 2 });
// @ts-expect-error there is no such predictor
all.build("switchd");
// @ts-expect-error a parameter of another predictor
all.build("linear", { bound: 2 });
// @ts-expect-error a misspelled parameter
build({ gain_lamda: 60 });
// @ts-expect-error a misspelled option
all.connect("ws://here", { predicter: "hold" });
"""


@installed
@pytest.mark.parametrize("resolution", ["bundler", "nodenext"])
def test_types_catch_what_is_wrong(project: Path, resolution: str) -> None:
    """``@ts-expect-error`` is itself an error where the next line is right."""
    every = "".join(
        f'export * as e{i} from "pointpred{name[1:]}";\n'
        for i, name in enumerate(TYPED)
        if not name.startswith(("./react", "./vue", "./svelte", "./astro", "./human"))
    )
    (project / "used.ts").write_text(USED)
    (project / "every.ts").write_text(every)
    module = "nodenext" if resolution == "nodenext" else "esnext"
    flags = (
        "--noEmit",
        "--strict",
        "--lib",
        "esnext,dom",
        "--module",
        module,
        "--moduleResolution",
        resolution,
    )
    npm.run(["npx", "tsc", *flags, "used.ts", "every.ts"], project)


def node(project: Path, script: str) -> str:
    return npm.run(["node", "--input-type=module", "-e", script], project).stdout.strip()


@installed
@needs_node
def test_every_entry_is_imported_without_a_page(project: Path) -> None:
    """A server that renders pages imports the same modules; React and Vue are not installed here."""
    names = [name[1:] for name in TYPED if not name.startswith(("./react", "./svelte", "./astro"))]
    imports = f"for (const name of {json.dumps(names)}) await import('pointpred' + name);"
    assert node(project, f"{imports} console.log('imported')") == "imported"
    built = """import { build } from "pointpred/kinematic-adaptive"; import { ledger } from "pointpred";
    const pipeline = await build();
    for (let i = 0; i < 30; i += 1) pipeline.update({ t: i / 100, x: i * i, y: 0 });
    console.log(pipeline.update({ t: 0.3, x: 900, y: 0 }).x > 900, ledger().fired);"""
    assert node(project, built) == "true 0"


@installed
@needs_node
@pytest.mark.parametrize(
    "call",
    ["onIntent(null, () => {})", "register()", "prefetchLink('a')", "onPlace(() => {})", "connect()"],
)
def test_a_call_without_a_document_says_so(project: Path, call: str) -> None:
    name = call.partition("(")[0]
    told = node(
        project,
        f"import * as all from 'pointpred'; try {{ all.{call} }} catch (e) {{ console.log(e.message) }}",
    )
    assert told.startswith(f"{name} needs a document: call it in the browser")
    overlay = (
        "import('pointpred').then(({ showOverlay }) => showOverlay()).catch((e) => console.log(e.message))"
    )
    assert node(project, overlay).startswith("showOverlay needs a document")


@installed
@needs_node
def test_importing_listens_to_nothing_and_changes_nothing(project: Path) -> None:
    """``sideEffects`` is false: a bundler may leave out any module that is not used."""
    names = [name[1:] for name in TYPED if not name.startswith(("./react", "./svelte", "./astro"))]
    watched = """const heard = [];
    const watch = (name) => new Proxy(function () {}, {
      get: (_, key) => (key === "supports" ? () => true : watch(`${name}.${String(key)}`)),
      set: (_, key) => heard.push(`${name}.${String(key)} is set`),
      apply: () => heard.push(`${name}() is called`) });
    const OF_PAGES = ["document", "window", "addEventListener", "localStorage", "HTMLScriptElement"];
    for (const name of OF_PAGES) globalThis[name] = watch(name);
    const before = Object.keys(globalThis).length;
    """
    script = f"{watched} for (const name of {json.dumps(names)}) await import('pointpred' + name);"
    assert (
        node(project, f"{script} console.log(heard.join(), Object.keys(globalThis).length - before)") == "0"
    )


@installed
@browser.needed
@pytest.mark.parametrize("script", SCRIPTS)
def test_a_script_tag_is_enough(project: Path, visitor: Visitor, tmp_path: Path, script: str) -> None:
    shutil.copy(project / "node_modules" / "pointpred" / script, tmp_path)
    (tmp_path / "page.html").write_text(
        f"""<!doctype html><meta http-equiv="Content-Security-Policy" content="{POLICY}">
        <button id="goal" style="position: absolute; left: 600px; top: 500px">goal</button>
        <script src="{script}"></script><script src="own.js"></script>"""
    )
    (tmp_path / "own.js").write_text(
        "window.fired = []; window.refused = [];"
        "addEventListener('securitypolicyviolation', (event) => refused.push(event.blockedURI));"
        "pointpred.onIntent(document.querySelector('#goal'), ({ reason }) => { fired.push(reason); });"
        "window.ready = pointpred.register(document.querySelector('#goal')).ready;"
    )
    with file_host(tmp_path) as origin:
        visitor.open(f"{origin}/page.html")
        visitor.value("ready.then(() => new Promise((done) => setTimeout(done, 200)))")
        visitor.reach((40, 40), (620, 510), 0.5, paced=True)
        visitor.wait("fired.length > 0")
        assert visitor.value("fired") == ["predicted"]
        assert visitor.value("refused") == []


@browser.needed
def test_a_policy_that_lets_scripts_alone_load_lets_the_learned_predictor_load(
    visitor: Visitor, tmp_path: Path
) -> None:
    """Its coefficients are a module, so that `connect-src` does not matter."""
    (tmp_path / "pointpred").symlink_to(LIB)
    (tmp_path / "own.js").write_text(
        'import { register } from "./pointpred/intent/index.js";'
        "window.refused = [];"
        "addEventListener('securitypolicyviolation', (event) => refused.push(event.blockedURI));"
        "window.ready = register(document.body).ready.then(() => 'loaded', String);"
    )
    (tmp_path / "page.html").write_text(
        f"""<!doctype html><meta http-equiv="Content-Security-Policy" content="{POLICY}">
        <body><script type="module" src="own.js"></script>"""
    )
    with file_host(tmp_path) as origin:
        visitor.open(f"{origin}/page.html")
        visitor.wait("'ready' in window")
        assert visitor.value("ready") == "loaded"
        assert visitor.value("refused") == []
