"""What the pointer is over is what the page's own hit test says, not what lies in a rectangle."""

from __future__ import annotations

import pytest

from tests.intent.page import IntentPage
from tests.server import browser

pytestmark = browser.needed


def test_the_gap_of_a_wrapped_link_is_not_entered(page: IntentPage) -> None:
    page.make(
        "document.body.insertAdjacentHTML('beforeend', '<p style=\"position:absolute;left:100px;top:300px;"
        'width:400px;font:20px/40px monospace;margin:0">xxxxxxxxxxxxxxxxxxxxxxxxxxx '
        '<a id=wrapped href="/w.html">one two three</a> yyyyyyyyyyyyyyyyyy</p>\');'
        "watch(wrapped, { threshold: 1 })"
    )
    page.move((286, 100), (286, 600), 0.5)
    assert page.said() == []
    page.move((286, 600), (120, 360), 0.4)
    assert page.said() == ["wrapped entered"]


def test_a_wrapped_link_is_predicted_though_another_lies_between_its_lines(page: IntentPage) -> None:
    page.make(
        "document.body.insertAdjacentHTML('beforeend', '<p style=\"position:absolute;left:100px;top:300px;"
        'width:400px;font:20px/40px monospace;margin:0">xxxxxxxxxxxxxxxxxxxxxxxxxxx '
        '<a id=wrapped href="/w.html">one two three</a>'
        '<a href="/n.html" style="position:absolute;left:150px;top:0;width:150px;height:80px">next</a>'
        "</p>');"
        "watch(wrapped)"
    )
    box = page.value("wrapped.getBoundingClientRect().toJSON()")
    middle = (box["left"] + box["width"] / 2, box["top"] + box["height"] / 2)
    assert page.value(f"document.elementFromPoint({middle[0]}, {middle[1]}).textContent") == "next"
    assert page.value("measured('wrapped').isCovered") is False
    page.make("box('over', 0, 300, 500, 100, 'div')")
    page.away()
    assert page.value("measured('wrapped').isCovered") is True


def test_an_area_is_not_covered_by_its_neighbour_in_the_map(page: IntentPage) -> None:
    page.make(
        "document.body.insertAdjacentHTML('beforeend', `<map name=sea>"
        "<area id=ring href='/ring.html' shape=poly"
        " coords='0,0,200,0,200,200,0,200,0,180,180,180,180,20,0,20'>"
        "<area shape=rect coords='20,30,170,170' href='/inner.html'></map>"
        "<img usemap=#sea width=200 height=200 style='position:absolute;left:600px;top:400px'"
        " src=\"data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' width='200' height='200'/>\">`);"
        "watch(ring)"
    )
    page.value("frames(10)")
    assert page.value("document.elementFromPoint(700, 500) !== ring") is True
    assert page.value("measured('ring').isCovered") is False
    page.make("box('over', 600, 400, 200, 200, 'div')")
    page.away()
    assert page.value("measured('ring').isCovered") is True


def test_the_corner_of_a_circle_is_not_entered_but_the_circle_is(page: IntentPage) -> None:
    page.make("box('circle', 400, 300, 200, 200).style.borderRadius = '50%'; watch(circle, { threshold: 1 })")
    page.move((700, 100), (595, 305), 0.4)
    assert page.said() == []
    page.move((595, 305), (560, 340), 0.2)
    assert page.said() == ["circle entered"]


def test_a_rotated_bar_is_entered_where_it_is(page: IntentPage) -> None:
    page.make("box('bar', 300, 340, 400, 20).style.transform = 'rotate(45deg)'; watch(bar, { threshold: 1 })")
    page.move((680, 100), (600, 250), 0.4)  # in its rectangle, to the right of it
    assert page.said() == []
    page.move((600, 250), (560, 410), 0.3)
    assert page.said() == ["bar entered"]


@pytest.mark.parametrize(
    "made",
    [
        "goal.disabled = true",
        "goal.style.pointerEvents = 'none'",
        "goal.inert = true",
        "const set = document.createElement('fieldset'); set.disabled = true; goal.replaceWith(set);"
        "set.append(goal)",
    ],
)
@pytest.mark.parametrize("policy", ["prefetch", "highlight"])
def test_what_takes_no_pointer_is_left_alone(page: IntentPage, made: str, policy: str) -> None:
    page.make(
        f"window.goal = box('goal', 600, 500); watch(goal, {{ policy: '{policy}' }}); {made};"
        "watch(box('other', 300, 500), { threshold: 1 })"
    )
    page.move((40, 40), (650, 530), 0.4)
    assert page.said() == []


def test_elements_in_a_shadow_tree_are_entered(page: IntentPage) -> None:
    page.make(
        "const root = box('host', 600, 500, 100, 60, 'div').attachShadow({ mode: 'closed' });"
        "root.innerHTML = '<button id=inner style=\"width:100%;height:100%\"></button>';"
        "watch(root.firstChild, { threshold: 1 })"
    )
    page.move((40, 40), (650, 530), 0.4)
    assert page.said() == ["inner entered"]
