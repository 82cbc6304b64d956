"""The guide's recipes, built by their frameworks and tried with a mouse in a browser: `make frameworks`."""

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
"""Stands in what a router loads for the other page, and nowhere else."""
AWAY = (900.0, 600.0)


class Recipe(NamedTuple):
    """A heading of the guide, with what the example needs around it."""

    packages: tuple[str, ...]
    files: dict[str, str]
    build: tuple[str, ...]
    made: str
    """The folder of the finished site."""


RECIPES = {
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
    """Whether what lies at an address is of the other page."""
    with urllib.request.urlopen(address, timeout=20) as answer:
        return MARKER in answer.read().decode(errors="replace")


def asked(visitor: Visitor) -> set[str]:
    """What the page has asked for by now."""
    visitor.value("0")
    return visitor.asked()


@pytest.mark.parametrize("framework", RECIPES)
def test_a_router_loads_the_page_that_the_mouse_heads_for(
    framework: str, tmp_path: Path, visitor: Visitor, monkeypatch: pytest.MonkeyPatch
) -> None:
    recipe = RECIPES[framework]
    for name in ("ASTRO_TELEMETRY_DISABLED", "NEXT_TELEMETRY_DISABLED", "NUXT_TELEMETRY_DISABLED", "CI"):
        monkeypatch.setenv(name, "1")
    npm.install(tmp_path, *recipe.packages)
    npm.write(tmp_path, recipe.files | examples(framework))
    npm.run([*recipe.build], tmp_path)
    npm.write(tmp_path / recipe.made, {"favicon.ico": ""})
    with file_host(tmp_path / recipe.made) as origin:
        visitor.open(f"{origin}/")
        link = visitor.corner("a[href^='/cart']")
        visitor.value("new Promise((done) => setTimeout(done, 1000))")
        before = set(visitor.asked())
        assert not any(map(holds_cart, before)), "the page is not loaded ahead before the mouse moves"
        visitor.reach(AWAY, (link[0] + link[2] / 2, link[1] + link[3] / 2), 0.5)
        until(lambda: any(map(holds_cart, asked(visitor) - before)), "the page behind the link", 10.0)
        assert visitor.value("location.pathname") == "/"
        assert visitor.complaints() == []
