"""The guide's recipes, built by their frameworks and tried with a mouse in a browser: `make npm`."""

from __future__ import annotations

import re
import urllib.request
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.hosts import file_host
from tests.intent import npm
from tests.server import browser
from tests.server.page_browser import Visitor, until

pytestmark = [browser.needed, pytest.mark.slow]

GUIDE = (Path(__file__).parents[2] / "docs" / "guide" / "frameworks.md").read_text("utf-8")
MARKER = "what-the-cart-holds"
"""Stands in what is loaded ahead, and nowhere else."""
AWAY = (900.0, 600.0)


class Recipe(NamedTuple):
    """A heading of the guide, with what the example needs around it."""

    packages: tuple[str, ...]
    files: dict[str, str]
    build: tuple[str, ...]
    made: str
    """The folder of the finished site."""
    aim: str = "a[href^='/cart']"
    """What the mouse heads for."""


def vite(plugin: str, start: str) -> dict[str, str]:
    """A site of one page, built by Vite with a plugin."""
    return {
        "index.html": '<!doctype html><div id="app"></div><script type="module" src="/main.js"></script>',
        "main.js": start,
        "vite.config.js": f"{plugin}\nexport default {{ plugins: [plugin()] }};",
        "src/cart.js": f'export default "{MARKER}";',
    }


RECIPES = {
    "React": Recipe(
        ("react@19.2.0", "react-dom@19.2.0", "vite@7", "@vitejs/plugin-react@5"),
        vite(
            'import plugin from "@vitejs/plugin-react";',
            'import { createElement } from "react";\nimport { createRoot } from "react-dom/client";\n'
            'import { Links } from "./app/cart.jsx";\n'
            'createRoot(document.querySelector("#app")).render(createElement(Links));',
        )
        | {"app/chart.jsx": f'export default "{MARKER}";'},
        ("node_modules/.bin/vite", "build"),
        "dist",
        "button",
    ),
    "Vue": Recipe(
        ("vue@3.5.22", "vite@7", "@vitejs/plugin-vue@6"),
        vite(
            'import plugin from "@vitejs/plugin-vue";',
            'import { createApp } from "vue";\nimport App from "./src/App.vue";\n'
            'createApp(App).mount("#app");',
        ),
        ("node_modules/.bin/vite", "build"),
        "dist",
    ),
    "Svelte": Recipe(
        ("svelte@5", "vite@7", "@sveltejs/vite-plugin-svelte@6"),
        vite(
            'import { svelte as plugin } from "@sveltejs/vite-plugin-svelte";',
            'import { mount } from "svelte";\nimport App from "./src/App.svelte";\n'
            'mount(App, { target: document.querySelector("#app") });',
        ),
        ("node_modules/.bin/vite", "build"),
        "dist",
    ),
    "Astro": Recipe(
        ("astro@5",),
        {"src/pages/cart.astro": f"<p>{MARKER}</p>"},
        ("node_modules/.bin/astro", "build"),
        "dist",
    ),
    "Next": Recipe(
        ("next@16", "react@19.2.0", "react-dom@19.2.0"),
        {
            "next.config.mjs": "const turbopack = { root: import.meta.dirname };\n"
            'export default { output: "export", turbopack };',
            "app/layout.jsx": "export default ({ children }) => <html><body>{children}</body></html>;",
            "app/page.jsx": 'import { CartLink } from "./cart-link.jsx";\nexport default () => <CartLink />;',
            "app/cart/page.jsx": f"export default () => <p>{MARKER}</p>;",
        },
        ("node_modules/.bin/next", "build"),
        "out",
    ),
    "React Router": Recipe(
        (
            *("react-router@7.18.4", "@react-router/dev@7.18.4", "@react-router/node@7.18.4"),
            *("vite@7", "react@19.2.0", "react-dom@19.2.0", "isbot@5"),
        ),
        {
            "vite.config.js": 'import { reactRouter } from "@react-router/dev/vite";\n'
            "export default { plugins: [reactRouter()] };",
            "react-router.config.js": 'export default { ssr: false, prerender: ["/"] };',
            "app/routes.js": 'import { index, route } from "@react-router/dev/routes";\n'
            'export default [index("home.jsx"), route("cart", "cart.jsx")];',
            "app/root.jsx": 'import { Links, Outlet, Scripts } from "react-router";\n'
            "export default () => <html><head><Links /></head><body><Outlet /><Scripts /></body></html>;",
            "app/home.jsx": 'import { CartLink } from "./cart-link.jsx";\nexport default () => <CartLink />;',
            "app/cart.jsx": f"export default () => <p>{MARKER}</p>;",
        },
        ("node_modules/.bin/react-router", "build"),
        "build/client",
    ),
    "Nuxt": Recipe(
        ("nuxt@4.4.5",),
        {
            # Its payloads need an older unstorage than npm gives it.
            "nuxt.config.js": "export default { telemetry: false, compatibilityDate: '2026-01-01',"
            " experimental: { payloadExtraction: false } };",
            "app/pages/cart.vue": f"<template><p>{MARKER}</p></template>",
        },
        ("node_modules/.bin/nuxt", "generate"),
        ".output/public",
    ),
    "SvelteKit": Recipe(
        (
            *("@sveltejs/kit@2", "@sveltejs/adapter-static@3", "@sveltejs/vite-plugin-svelte@6"),
            *("svelte@5", "vite@7"),
        ),
        {
            "vite.config.js": 'import { sveltekit } from "@sveltejs/kit/vite";\n'
            "export default { plugins: [sveltekit()] };",
            "svelte.config.js": 'import adapter from "@sveltejs/adapter-static";\n'
            "export default { kit: { adapter: adapter() } };",
            "src/app.html": "<!doctype html><head>%sveltekit.head%</head><body>%sveltekit.body%</body>",
            "src/routes/+layout.js": "export const prerender = true;",
            "src/routes/cart/+page.svelte": f"<p>{MARKER}</p>",
        },
        ("node_modules/.bin/vite", "build"),
        "build",
    ),
}


def examples(heading: str) -> dict[str, str]:
    """The files in a section of the guide, by the names in their first lines."""
    section = GUIDE.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    named = r"^```\w+\n(?:// |<!-- )(\S+)(?: -->)?\n(.*?)^```$"
    return dict(re.findall(named, section, re.MULTILINE | re.DOTALL))


def holds_cart(address: str) -> bool:
    """Whether what lies at an address is what shall be loaded ahead."""
    with urllib.request.urlopen(address, timeout=20) as answer:
        return MARKER in answer.read().decode(errors="replace")


def asked(visitor: Visitor) -> set[str]:
    """What the page has asked for by now."""
    visitor.value("0")
    return visitor.asked()


@pytest.fixture(autouse=True)
def quiet(monkeypatch: pytest.MonkeyPatch) -> None:
    """Frameworks tell nobody of these builds."""
    for name in ("ASTRO_TELEMETRY_DISABLED", "NEXT_TELEMETRY_DISABLED", "NUXT_TELEMETRY_DISABLED", "CI"):
        monkeypatch.setenv(name, "1")


@pytest.mark.parametrize("framework", RECIPES)
def test_what_the_mouse_heads_for_is_loaded(framework: str, tmp_path: Path, visitor: Visitor) -> None:
    recipe = RECIPES[framework]
    npm.install(tmp_path, *recipe.packages)
    npm.write(tmp_path, recipe.files | examples(framework))
    npm.run([*recipe.build], tmp_path)
    npm.write(tmp_path / recipe.made, {"favicon.ico": ""})
    with file_host(tmp_path / recipe.made) as origin:
        visitor.open(f"{origin}/")
        link = visitor.corner(recipe.aim)
        visitor.value("new Promise((done) => setTimeout(done, 1000))")
        before = set(visitor.asked())
        assert not any(map(holds_cart, before)), "nothing is loaded ahead before the mouse moves"
        visitor.reach(AWAY, (link[0] + link[2] / 2, link[1] + link[3] / 2), 0.5)
        until(lambda: any(map(holds_cart, asked(visitor) - before)), "what the mouse heads for", 10.0)
        assert visitor.value("location.pathname") == "/"
        assert visitor.complaints() == []


ASTRO = {
    "astro.config.mjs": """import { defineConfig } from "astro/config";
import pointpred from "pointpred/astro";
const integrations = [pointpred({ hitSlop: 4, again_s: Infinity })];
export default defineConfig({ prefetch: { prefetchAll: true }, integrations });
""",
    "src/pages/index.astro": """---
import { ClientRouter } from "astro:transitions";
---
<head><ClientRouter /></head><body><a href="/other/" data-astro-prefetch="false">other</a></body>
""",
    "src/pages/other.astro": """---
import { ClientRouter } from "astro:transitions";
---
<head><ClientRouter /></head><body>
<a href="/cart/" style="position: absolute; left: 300px; top: 200px">cart</a>
<a href="/never/" data-astro-prefetch="false" style="position: absolute; left: 300px; top: 400px">never</a>
<a href="/logout/" style="position: absolute; left: 600px; top: 200px">log out</a>
<p data-no-prefetch><a href="/quiet/" style="position: absolute; left: 600px; top: 400px">quiet</a></p>
</body>
""",
    "src/pages/cart.astro": f"<p>{MARKER}</p>",
    **{f"src/pages/{name}.astro": f"<p>{name}</p>" for name in ("never", "logout", "quiet")},
    "typed.ts": """import pointpred from "pointpred/astro";
import { defineConfig } from "astro/config";

export default defineConfig({ integrations: [pointpred(), pointpred({ threshold: 0.4 })] });
// @ts-expect-error functions cannot be written into pages
pointpred({ onError: () => {} });
// @ts-expect-error no such option
pointpred({ treshold: 0.4 });
""",
}
TYPES = ("--noEmit", "--strict", "--skipLibCheck", "--module", "esnext", "--moduleResolution", "bundler")


def test_astro_prefetches_every_link_also_of_pages_that_its_router_swaps_in(
    tmp_path: Path, visitor: Visitor
) -> None:
    npm.install(tmp_path, "astro@5", "typescript@5.9")
    npm.write(tmp_path, ASTRO)
    npm.run(["node_modules/.bin/astro", "build"], tmp_path)
    npm.run(["node_modules/.bin/tsc", *TYPES, "--target", "es2022", "typed.ts"], tmp_path)
    npm.write(tmp_path / "dist", {"favicon.ico": ""})
    with file_host(tmp_path / "dist") as origin:
        visitor.open(f"{origin}/")
        visitor.value("window.same = true")
        visitor.page.click("a")
        visitor.wait("location.pathname === '/other/' && document.querySelector('a').textContent === 'cart'")
        visitor.value("new Promise((done) => setTimeout(done, 1000))")
        for target in ("a[href='/never/']", "a[href='/logout/']", "a[href='/quiet/']", "a[href='/cart/']"):
            left, top, width, height = visitor.corner(target)
            visitor.reach(AWAY, (left + width / 2, top + height / 2), 0.5)
            visitor.value("new Promise((done) => setTimeout(done, 400))")
        until(lambda: any(map(holds_cart, asked(visitor))), "the page behind the link", 10.0)
        assert visitor.value("same"), "the router has swapped the page in"
        assert not any(one.endswith(("/never/", "/logout/", "/quiet/")) for one in asked(visitor))
        assert visitor.complaints() == []
