"""The live page as HTML: which modules it loads first, and whether a service answers it."""

from __future__ import annotations

import json
import posixpath
import re
from functools import cache
from pathlib import Path

from pointpred.registry import RECOMMENDED, REGISTRY
from pointpred_server.http_responses import SECURITY_HEADERS

WEB = Path(__file__).with_name("web")
FIRST = ("page/live/start.js", "lib/prediction/session.js")
"""The live view and what it predicts with; what they import follows."""
REST = ("page/page.js", "lib/intent/page-source.js")
"""Every view, and what `onIntent` begins with."""
REGISTRY_MODULE = "lib/laws/registry.js"
IMPORT = re.compile(r'^(?:import|export) (?:[^;"]*? from )?"(\.[^"]+)"', re.MULTILINE)
LATER = re.compile(r'import\("(\.[^"]+)"\)')
PACKAGE = json.loads((WEB / "lib" / "package.json").read_text(encoding="utf-8"))
REPOSITORY = PACKAGE["repository"]["url"].removeprefix("git+").removesuffix(".git")
"""Where the page's links to documents and source lead, as the npm package states it."""
CHARSET = '<meta charset="utf-8">'
POLICY = SECURITY_HEADERS["Content-Security-Policy"].replace("; frame-ancestors 'none'", "")
"""As the service sends it, but for what only a header can say: the page loads nothing from elsewhere."""
MODULES_PLACE = "<!-- modules that are loaded at once -->"
FILES_PLACE = "<!-- files to try -->"
FILES = (
    '<p class="note">Files to try: <a href="samples/sample_samples.csv" download>sample_samples.csv</a> and '
    '<a href="samples/sample_trials.csv" download>its targets</a>. Save both, then open both.</p>'
)
"""They lie beside a page without a service."""


def page(service: bool = True) -> str:
    """The page; without a service it neither asks one nor offers what needs one."""
    text = (WEB / "page" / "index.html").read_text(encoding="utf-8")
    if not service:
        text = text.replace('data-service="same"', 'data-service="none"')
        text = text.replace(
            CHARSET, f'{CHARSET}\n<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        )
    text = text.replace("{repository}", REPOSITORY)
    return text.replace(MODULES_PLACE, "\n".join(_links())).replace(FILES_PLACE, "" if service else FILES)


def study_page() -> str:
    """The page of a study."""
    return (WEB / "page" / "study.html").read_text(encoding="utf-8")


@cache
def _links() -> tuple[str, ...]:
    """A link for each module, so that none waits for the one that imports it."""
    return tuple(f'<link rel="modulepreload" href="web/{path}">' for path in _modules())


def _modules() -> list[str]:
    """The modules that the page needs, those of its first prediction first, by their paths in the folder."""
    stages = (f'  "{RECOMMENDED}": ', f'  "{REGISTRY[RECOMMENDED].differentiator}": ')
    lines = (WEB / REGISTRY_MODULE).read_text(encoding="utf-8").splitlines()
    loaded = [path for line in lines if line.startswith(stages) for path in LATER.findall(line)]
    roots = [*FIRST, *(_beside(REGISTRY_MODULE, path) for path in loaded), *REST]
    found: dict[str, None] = {}
    for root in roots:
        waiting = [root]
        while waiting:
            path = waiting.pop(0)
            if path not in found:
                found[path] = None
                addresses = IMPORT.findall((WEB / path).read_text(encoding="utf-8"))
                waiting += [_beside(path, address) for address in addresses]
    return list(found)


def _beside(path: str, address: str) -> str:
    """What a relative address in a module names."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(path), address))
