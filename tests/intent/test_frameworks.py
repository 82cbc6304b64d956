"""Hooks, component, directive and action with the real frameworks, where npm can fetch them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.hosts import file_host
from tests.intent import npm
from tests.intent.conftest import StaticHost
from tests.intent.npm import LIB
from tests.intent.page import IntentPage
from tests.server import browser
from tests.server.page_browser import Visitor

pytestmark = [browser.needed, pytest.mark.slow]  # packages of npm take longest: `make npm` runs it

REACT_ENTRY = """export * as react from "react";
export { createRoot, hydrateRoot } from "react-dom/client";
export { flushSync } from "react-dom";
export { renderToString } from "react-dom/server";
export { Intent, useIntent, useIntentState } from "pointpred/react";
export { ledger, register } from "pointpred";
"""
VUE_ENTRY = """export { createApp, createSSRApp, h, ref } from "vue/dist/vue.esm-bundler.js";
export { vIntent } from "pointpred/vue";
export { ledger, register } from "pointpred";
"""
SVELTE_ENTRY = """import Card from "./card.js";
export const make = (options) => new Card(options);
export { ledger, register } from "pointpred";
"""
SVELTE_5_ENTRY = SVELTE_ENTRY.replace(
    "new Card(options)", "createClassComponent({ component: Card, ...options })"
)
SVELTE_5_ENTRY += 'import { createClassComponent } from "svelte/legacy";'
CARD = """<script>
  import { intent } from "pointpred/svelte";
  export let call, word = "first", policy = "highlight", shown = true;
</script>
{#if shown}
  <a id="card" href="#there" style="position: absolute; left: 600px; top: 500px; width: 100px; height: 60px"
    use:intent={{ callback: call(word), predictor: "minimum-jerk", policy }}>{word}</a>
{/if}
"""
COMPILE = """import { readFileSync, writeFileSync } from "node:fs";
import { compile } from "svelte/compiler";
writeFileSync("card.js", compile(readFileSync("Card.svelte", "utf8"), {}).js.code);
"""
MODES = ("process.env.NODE_ENV='development'", "__VUE_OPTIONS_API__=true", "__VUE_PROD_DEVTOOLS__=false")
MODES += ("__VUE_PROD_HYDRATION_MISMATCH_DETAILS__=false",)


ENTRIES = {
    "react19": REACT_ENTRY,
    "react18": REACT_ENTRY,
    "vue": VUE_ENTRY,
    "svelte5": SVELTE_5_ENTRY,
    "svelte4": SVELTE_ENTRY,
}
OLDER = ("react18", "svelte4")


@pytest.fixture(scope="session")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where bundles lie, beside the modules that the tests themselves load."""
    folder = tmp_path_factory.mktemp("out")
    for room in ("client", "intent", "laws", "prediction"):
        (folder / room).symlink_to(LIB / room)
    return folder


@pytest.fixture(scope="session")
def hosted(out: Path) -> Iterator[str]:
    """The address of the bundles."""
    with file_host(out, StaticHost) as origin:
        yield origin


def bundle(folder: Path, out: Path, name: str) -> None:
    """Bundle an entry in a folder of packages, as users do."""
    npm.write(folder, {"Card.svelte": CARD, "compile.mjs": COMPILE, f"{name}.js": ENTRIES[name]})
    npm.run(["node", "compile.mjs"], folder)
    command = [
        *("node_modules/.bin/esbuild", f"{name}.js", "--bundle", "--splitting", "--format=esm"),
        *(f"--outdir={out / name}", "--loader:.f32=file", "--log-level=error"),
        *(f"--define:{one}" for one in MODES),
    ]
    npm.run(command, folder)


READY = """(async () => {
  const probe = app.register(document.createElement("i"), { predictor: "minimum-jerk" });
  await probe.ready;
  probe.stop();
  await frames(3);
})()"""
"""Waits for the predictor that the package in the bundle loads."""


@pytest.fixture
def app(request: pytest.FixtureRequest, visitor: Visitor, hosted: str, out: Path) -> IntentPage:
    """A page with the exports of the bundle that the test names as ``app``."""
    name: str = request.param
    if not (out / name).exists():
        bundle(request.getfixturevalue("older_packages" if name in OLDER else "packages"), out, name)
    page = IntentPage(visitor, hosted)
    page.value(f"import('/pointpred/{name}/{name}.js').then((app) => {{ window.app = app; }})")
    page.make("const root = document.createElement('div'); root.id = 'root'; document.body.append(root)")
    return page


def of(*names: str) -> pytest.MarkDecorator:
    """A test of these bundles."""
    return pytest.mark.parametrize("app", names, indirect=True)


react, vue, svelte = of("react19", "react18"), of("vue"), of("svelte5", "svelte4")


PLACE = "{ position: 'absolute', left: '600px', top: '500px', width: '100px', height: '60px' }"
REACT = f"""const {{ react: {{ createElement, StrictMode, useState }}, createRoot, Intent, useIntent }} = app;
function Card({{ word, policy }}) {{
  const ref = useIntent(({{ element }}) => {{
    heard.push({{ id: element.id, reason: word, began: true }});
    return () => heard.push({{ id: element.id, began: false }});
  }}, {{ predictor: 'minimum-jerk', policy }});
  return createElement('a', {{ id: 'card', ref, style: {PLACE} }}, word);
}}
window.given = [];
window.linkRef = {{ current: null }};
function App() {{
  const [state, set] = useState({{ word: 'first', shown: true, linked: true, policy: 'highlight' }});
  window.set = (change) => app.flushSync(() => set((now) => ({{ ...now, ...change }})));
  return createElement('main', null, state.shown && createElement(Card, state),
    state.linked && createElement(Intent, {{ id: 'link', href: '#there', ref: window.linkRef,
      options: {{ predictor: 'minimum-jerk' }}, style: {{ ...{PLACE}, left: '100px' }},
      onIntent: () =>
        heard.push({{ id: 'link', reason: state.word, began: true }}) }}, 'there'),
    createElement(Intent, {{ as: 'button', id: 'help', onIntent: () => {{}},
      ref: (element) => {{ window.given.push(element?.tagName ?? null); }} }}, 'help'));
}}
"""
RENDERED = """window.root = createRoot(document.getElementById('root'));
app.flushSync(() => window.root.render(createElement(StrictMode, null, createElement(App))));"""
HYDRATED = """document.getElementById('root').innerHTML = app.renderToString(createElement(App));
window.root = app.hydrateRoot(document.getElementById('root'), createElement(App),
  { onRecoverableError: (error) => heard.push(String(error)) });"""


@react
@pytest.mark.parametrize("start", [RENDERED, HYDRATED], ids=["strict", "hydrated"])
def test_react_calls_the_newest_function_and_cleans_up(app: IntentPage, start: str) -> None:
    app.make(REACT + start)
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


@react
def test_react_registers_an_element_once_however_often_it_renders(app: IntentPage) -> None:
    app.make(REACT + RENDERED)
    app.value(READY)
    for word in ("second", "third"):
        app.make(f"set({{ word: '{word}' }})")
        app.move((150, 40), (150, 530), 0.4)
        app.away()
        app.move((150, 530), (150, 40), 0.4)
        app.away()
    assert [one for one in app.said() if one.startswith("link")] == ["link second"]
    assert app.value("app.ledger().names.link.fired") == 1


@react
def test_react_forwards_the_ref_of_a_component(app: IntentPage) -> None:
    app.make(REACT + RENDERED)
    assert app.value("linkRef.current.id") == "link"
    assert app.value("given.at(-1)") == "BUTTON"
    app.make("set({ linked: false })")
    assert app.value("linkRef.current") is None
    app.make("root.unmount()")
    assert app.value("given.at(-1)") is None


SWAP = """const { react: { createElement, forwardRef, useState }, createRoot, Intent } = app;
const Swapped = forwardRef(function Swapped(properties, ref) {
  const [type, set] = useState('a');
  window.swap = (type) => app.flushSync(() => set(type));
  return createElement(type, { ...properties, ref });
});
window.held = { current: null };
window.given = [];
const link = (ref) => createElement(Intent, { as: Swapped, onIntent: () => {}, ref });
window.root = createRoot(document.getElementById('root'));
app.flushSync(() => root.render(
  createElement('p', null, link(held), link((element) => { given.push(element?.tagName ?? null); }))));"""


@react
def test_react_forwards_another_node_of_the_same_component(app: IntentPage) -> None:
    app.make(SWAP.replace("createElement('p', null, link(held), link", "createElement('p', null, link"))
    assert app.value("given") == ["A"]
    app.make("swap('button')")
    assert app.value("given") == ["A", None, "BUTTON"]
    app.make("root.unmount()")
    assert app.value("given") == ["A", None, "BUTTON", None]
    app.make(
        "const root = document.createElement('div'); root.id = 'root';"
        "document.getElementById('root').replaceWith(root)"
    )
    app.make(SWAP.replace(", link((element) => { given.push(element?.tagName ?? null); })", ""))
    assert app.value("held.current.tagName") == "A"
    app.make("swap('button')")
    assert app.value("held.current.tagName") == "BUTTON"
    app.make("root.unmount()")
    assert app.value("held.current") is None


STATE = f"""const {{ react: {{ createElement, StrictMode, useState }}, createRoot, useIntentState }} = app;
window.answer = () => undefined;
function Card({{ policy }}) {{
  const {{ ref, predicted, fired, p, error }} =
    useIntentState(() => window.answer(), {{ predictor: 'minimum-jerk', policy }});
  window.state = {{ predicted, fired, likely: p > 0, error: error?.message ?? null }};
  return createElement('a', {{ id: 'card', ref, style: {PLACE} }}, 'card');
}}
function Bare() {{
  const {{ ref, fired }} = useIntentState(null, {{ predictor: 'minimum-jerk' }});
  return createElement('a', {{ id: 'bare', ref, style: {{ ...{PLACE}, left: '100px' }} }}, String(fired));
}}
function App() {{
  const [policy, set] = useState('highlight');
  window.follow = (policy) => app.flushSync(() => set(policy));
  return createElement(StrictMode, null, createElement(Card, {{ policy }}), createElement(Bare));
}}
app.flushSync(() => createRoot(document.getElementById('root')).render(createElement(App)));"""


def state(predicted: bool, fired: bool, error: str | None = None) -> dict[str, object]:
    return {"predicted": predicted, "fired": fired, "likely": fired, "error": error}


@react
def test_react_says_what_has_become_of_it(app: IntentPage) -> None:
    app.make(STATE)
    app.value(READY)
    assert app.value("state") == state(False, False)
    assert app.value("bare.textContent") == "false"
    app.move((650, 40), (650, 530), 0.5)
    assert app.value("state") == state(True, True)
    app.away()
    app.move((650, 530), (150, 530), 0.5)
    assert app.value("state") == state(False, True)
    assert app.value("bare.textContent") == "true"
    app.make("window.answer = () => Promise.reject(new Error('no cart'))")
    app.away()
    app.move((150, 530), (650, 530), 0.5)
    assert app.value("state") == state(True, True, "no cart")
    app.make("window.answer = () => { throw new Error('broken') }; follow('prefetch')")
    app.away()
    app.move((650, 530), (150, 530), 0.5)
    app.away()
    app.move((150, 530), (650, 530), 0.5)
    assert app.value("state.error") == "broken"
    app.make("window.answer = () => undefined; follow('highlight')")
    app.away()
    app.move((650, 530), (150, 530), 0.5)
    app.away()
    app.move((150, 530), (650, 530), 0.5)
    assert app.value("state") == state(True, True)


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


@vue
def test_vue_calls_the_newest_function_and_cleans_up(app: IntentPage) -> None:
    app.make(VUE)
    app.make("word.value = 'second'")
    app.value(READY)
    app.move((40, 40), (650, 530), 0.5)
    assert app.said()[0] == "card second"
    app.make("shown.value = false")
    assert app.said()[-1] == "card ended"
    app.make("vue.unmount()")


@vue
def test_other_options_begin_anew(app: IntentPage) -> None:
    app.make(VUE)
    app.make("policy.value = 'prefetch'")
    app.value(READY)
    app.move((40, 40), (650, 530), 0.4)
    app.away()
    app.move((650, 530), (40, 40), 0.4)
    assert app.said() == ["card first"], "nothing is withdrawn"


SVELTE = """const call = (said) => ({ element }) => {
  heard.push({ id: element.id, reason: said, began: true });
  return () => heard.push({ id: element.id, began: false });
};
window.card = app.make({ target: document.getElementById('root'), props: { call } });"""


@svelte
def test_svelte_calls_the_newest_function_and_cleans_up(app: IntentPage) -> None:
    app.make(SVELTE)
    app.make("card.$set({ word: 'second' })")
    app.value(READY)
    app.move((40, 40), (650, 530), 0.5)
    assert app.said()[0] == "card second"
    app.make("card.$set({ shown: false })")
    assert app.said()[-1] == "card ended"
    count = len(app.said())
    app.make("card.$set({ shown: true, policy: 'prefetch' })")
    app.away()
    app.move((650, 530), (40, 40), 0.4)
    app.away()
    app.move((40, 40), (650, 530), 0.4)
    assert app.said()[count:] == ["card second"], "it fires once, and nothing is withdrawn"
    app.make("card.$destroy()")
    assert app.value("document.querySelector('#card')") is None


def test_a_server_renders_the_same_elements_and_registers_none(packages: Path) -> None:
    script = """import { createElement as h, createRef } from "react";
import { renderToString } from "react-dom/server";
import { createSSRApp, h as vh, withDirectives } from "vue";
import { renderToString as vueToString } from "vue/server-renderer";
import { Intent, useIntentState } from "pointpred/react";
import { vIntent } from "pointpred/vue";
const Card = () => { const { ref, fired } = useIntentState(); return h("b", { ref }, String(fired)); };
const link = h(Intent, { href: "/cart", ref: createRef(), onIntent: () => {} }, h(Card));
const render = () => withDirectives(vh("a", { href: "/cart" }, "cart"), [[vIntent, () => {}]]);
const app = createSSRApp({ render });
console.log(renderToString(link) + (await vueToString(app)));
"""
    npm.write(packages, {"serve.mjs": script})
    told = npm.run(["node", "serve.mjs"], packages).stdout.strip()
    assert told == '<a href="/cart"><b>false</b></a><a href="/cart">cart</a>'
