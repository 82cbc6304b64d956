"""The types of the frameworks and of `pointpred/human`, by the real compilers: a wrong prop is an error."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.intent import npm

pytestmark = pytest.mark.slow  # packages of npm take longest; `make npm` runs it

CONFIG = """{
  "compilerOptions": {
    "strict": true, "noEmit": true, "skipLibCheck": true, "target": "es2022", "module": "esnext",
    "moduleResolution": "bundler", "jsx": "react-jsx", "lib": ["es2022", "dom"], "types": []
  },
  "include": ["typed"]
}"""
REACT = """import { createRef } from "react";
import { Intent, useIntent, useIntentState } from "pointpred/react";

const link = createRef<HTMLAnchorElement>();
const Card = ({ title }: { title: string }) => <b>{title}</b>;
const load = async () => { await fetch("/cart.json"); };

export function Page() {
  const ref = useIntent(({ element, p }) => { element.classList.add("next"); p.toFixed(); });
  const { ref: state, predicted, fired, p, error } = useIntentState(load, { policy: "highlight" });
  const bare = useIntentState();
  const text: string = `${predicted && fired} ${p.toFixed()} ${error} ${bare.fired}`;
  return <>
    <button ref={ref} />
    <a ref={state}>{text}</a>
    <Intent ref={link} href="/cart" onIntent={load} options={{ threshold: 0.4 }}>Cart</Intent>
    <Intent as="button" disabled onIntent={load} />
    <Intent as={Card} title="one" onIntent={load} />
    {/* @ts-expect-error a link is not disabled */}
    <Intent disabled onIntent={load} />
    {/* @ts-expect-error a button has no address */}
    <Intent as="button" href="/cart" onIntent={load} />
    {/* @ts-expect-error the card needs a title */}
    <Intent as={Card} onIntent={load} />
    {/* @ts-expect-error the ref is that of a link */}
    <Intent as="button" ref={link} onIntent={load} />
    {/* @ts-expect-error nothing is called */}
    <Intent href="/cart" />
    {/* @ts-expect-error no such option */}
    <Intent href="/cart" onIntent={load} options={{ treshold: 0.4 }} />
  </>;
}

// @ts-expect-error no such policy
useIntent(load, { policy: "prefech" });
// @ts-expect-error a probability is a number
const wrong: string = useIntentState(load).p;
export { wrong };
"""
OTHERS = """import { human } from "pointpred/human";
import { intent } from "pointpred/svelte";
import { vIntent } from "pointpred/vue";
import type { Page as PlaywrightPage } from "playwright-core";
import type { Page as PuppeteerPage } from "puppeteer-core";
import { createApp } from "vue";

const load = () => {};
createApp({}).directive("intent", vIntent);
intent(document.body, load);
intent(document.body, { callback: load, hitSlop: 8 });
// @ts-expect-error no such option
intent(document.body, { callback: load, hitSlope: 8 });
// @ts-expect-error nothing is called
intent(document.body, { hitSlop: 8 });

export async function drive(playwright: PlaywrightPage, puppeteer: PuppeteerPage) {
  const hand = human(playwright, { seed: 1 });
  await hand.moveTo("#cart");
  await hand.click(playwright.locator("#cart"));
  await human(puppeteer).click((await puppeteer.$("#cart"))!);
  await human("http://127.0.0.1:9515/session/1").moveTo({ x: 1, y: 2, width: 30, height: 20 });
  const x: number = hand.at.x;
  // @ts-expect-error no page
  human({ seed: 1 });
  // @ts-expect-error the seed is a number
  human(playwright, { seed: "1" });
  // @ts-expect-error half a place
  await hand.moveTo({ x });
}
"""
VUE = """<script setup lang="ts">
import { vIntent } from "pointpred/vue";

const load = () => {};
</script>

<template>
  <a v-intent="load">Cart</a>
  <a v-intent="{ callback: load, policy: 'highlight' }">Cart</a>
  <!-- @vue-expect-error no such policy -->
  <a v-intent="{ callback: load, policy: 'prefech' }">Cart</a>
  <!-- @vue-expect-error nothing is called -->
  <a v-intent="{ policy: 'highlight' }">Cart</a>
</template>
"""


def test_a_wrong_prop_option_or_target_is_an_error(packages: Path) -> None:
    files = {"react.tsx": REACT, "others.ts": OTHERS, "vue.vue": VUE}
    npm.write(packages, {f"typed/{name}": text for name, text in files.items()})
    npm.write(packages, {"tsconfig.json": CONFIG})
    npm.run(["node_modules/.bin/vue-tsc", "-p", "."], packages)


@pytest.mark.slow
def test_the_types_fit_react_18(older_packages: Path) -> None:
    npm.write(older_packages, {"typed/react.tsx": REACT, "tsconfig.json": CONFIG})
    npm.run(["node_modules/.bin/tsc", "-p", "."], older_packages)
