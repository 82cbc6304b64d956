"""The hook, the component and the directive with the real frameworks, where npm can fetch them."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.hosts import file_host
from tests.intent.conftest import LIB, StaticHost
from tests.intent.packed import pack
from tests.intent.page import IntentPage
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = browser.needed

PACKAGES = ("react@19.2.0", "react-dom@19.2.0", "vue@3.5.22", "esbuild@0.25.12")
BUNDLE = """export * as react from "react"; export { createRoot } from "react-dom/client";
export { flushSync } from "react-dom";
export { Intent, useIntent } from "pointpred/react";
export { createApp, h, ref, withDirectives } from "vue/dist/vue.esm-bundler.js";
export { vIntent } from "pointpred/vue";
export { ledger, register } from "pointpred";
"""
"""What a bundler makes of the package as its users name it."""


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> Path:
    if shutil.which("npm") is None:
        pytest.skip("no npm on this machine")
    folder = tmp_path_factory.mktemp("frameworks")
    (folder / "package.json").write_text("{}")
    fetched = subprocess.run(
        ["npm", "install", "--silent", "--no-audit", "--no-fund", *PACKAGES],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
    )
    if fetched.returncode:
        pytest.skip(f"npm cannot fetch the frameworks: {fetched.stderr.strip()[-200:]}")
    tarball = pack(tmp_path_factory.mktemp("packed"))
    install = ["npm", "install", "--silent", "--no-audit", "--no-fund", str(tarball)]
    subprocess.run(install, cwd=folder, capture_output=True, check=True, timeout=300)
    (folder / "entry.js").write_text(BUNDLE)
    command = [
        *("node_modules/.bin/esbuild", "entry.js", "--bundle", "--splitting", "--format=esm", "--outdir=out"),
        *("--define:process.env.NODE_ENV='production'", "--log-level=error"),
    ]
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    for room in ("client", "intent", "laws", "prediction"):  # for what the tests themselves load
        (folder / "out" / room).symlink_to(LIB / room)
    return folder / "out"


READY = """(async () => {
  const probe = app.register(document.createElement("i"), { predictor: "minimum-jerk" });
  await probe.ready;
  probe.stop();
  await frames(3);
})()"""
"""Waits for the predictor that the package in the bundle loads."""


@pytest.fixture
def app(bundle: Path, visitor: Visitor) -> Iterator[IntentPage]:
    """A page with the bundle's exports as ``app``."""
    with file_host(bundle, StaticHost) as origin:
        page = IntentPage(visitor, origin)
        page.value("import('/pointpred/entry.js').then((app) => { window.app = app; })")
        page.make("const root = document.createElement('div'); root.id = 'root'; document.body.append(root)")
        yield page


PLACE = "{ position: 'absolute', left: '600px', top: '500px', width: '100px', height: '60px' }"
REACT = f"""const {{ react: {{ createElement, useState }}, createRoot, Intent, useIntent }} = app;
function Card({{ word, policy }}) {{
  const ref = useIntent(({{ element }}) => {{
    heard.push({{ id: element.id, reason: word, began: true }});
    return () => heard.push({{ id: element.id, began: false }});
  }}, {{ predictor: 'minimum-jerk', policy }});
  return createElement('a', {{ id: 'card', ref, style: {PLACE} }}, word);
}}
function App() {{
  const [state, set] = useState({{ word: 'first', shown: true, policy: 'highlight' }});
  window.set = (change) => app.flushSync(() => set((now) => ({{ ...now, ...change }})));
  return createElement('main', null, state.shown && createElement(Card, state),
    createElement(Intent, {{ id: 'link', href: '#there', options: {{ predictor: 'minimum-jerk' }},
      style: {{ ...{PLACE}, left: '100px' }},
      onIntent: () =>
        heard.push({{ id: 'link', reason: state.word, began: true }}) }}, 'there'));
}}
window.root = createRoot(document.getElementById('root'));
app.flushSync(() => window.root.render(createElement(App)));"""


def test_react_calls_the_newest_function_and_cleans_up(app: IntentPage) -> None:
    app.make(REACT)
    app.make("set({ word: 'second' })")
    app.value(READY)
    app.move((40, 40), (650, 530), 0.5)
    assert app.said()[0] == "card second"
    app.make("set({ shown: false })")
    assert app.said()[-1] == "card ended"
    app.away()
    app.move((650, 530), (150, 530), 0.5)
    assert "link second" in app.said()
    app.make("root.unmount()")
    count = len(app.said())
    app.away()
    app.move((150, 530), (650, 530), 0.4)
    assert len(app.said()) == count


VUE = f"""const {{ createApp, ref, vIntent }} = app;
window.word = ref('first'); window.shown = ref(true); window.policy = ref('highlight');
window.vue = createApp({{
  directives: {{ intent: vIntent }},
  setup: () => ({{ word, shown, policy, style: {PLACE}, call: (said) => ({{ element }}) => {{
    heard.push({{ id: element.id, reason: said, began: true }});
    return () => heard.push({{ id: element.id, began: false }});
  }} }}),
  template: `<a v-if="shown" id="card" :style="style"
    v-intent="{{ callback: call(word), predictor: 'minimum-jerk', policy }}">{{{{ word }}}}</a>`,
}});
window.vue.mount('#root');"""


def test_vue_calls_the_newest_function_and_cleans_up(app: IntentPage) -> None:
    app.make(VUE)
    app.make("word.value = 'second'")
    app.value(READY)
    app.move((40, 40), (650, 530), 0.5)
    assert app.said()[0] == "card second"
    app.make("shown.value = false")
    assert app.said()[-1] == "card ended"
    app.make("vue.unmount()")


def test_other_options_begin_anew(app: IntentPage) -> None:
    app.make(VUE)
    app.make("policy.value = 'prefetch'")
    app.value(READY)
    app.move((40, 40), (650, 530), 0.4)
    app.away()
    app.move((650, 530), (40, 40), 0.4)
    assert app.said() == ["card first"], "nothing is withdrawn"
