"""States in the address: which demo they are of, what Back brings, what moves on the way."""

import json
from typing import Any

from playwright.sync_api import Page, expect

from chr_notes.demos import GimbalLockDemo, MagnetometerDemo, TiltDemo

from .parts import PageOf, Visit, hold, let_pass, slider, state_of


def states(page: Page) -> list[dict[str, Any]]:
    """The states of all demos of a page, once they are there."""
    expect(page.locator("[data-demo]:not(:has(> .chr-demo))")).to_have_count(0)
    written = page.locator(".chr-demo").evaluate_all("(all) => all.map((one) => one.dataset.state)")
    return [json.loads(each) for each in written]


def test_two_demos_of_a_kind_and_another_keep_each_its_own_state(
    visit: Visit, page_of: PageOf
) -> None:
    page = visit(page_of(GimbalLockDemo(), GimbalLockDemo(yaw=30), TiltDemo(roll=2)))
    # One right after the other, sooner than the address follows.
    slider(page, "pitch").nth(1).press("ArrowRight")
    slider(page, "roll").nth(2).press("ArrowRight")
    page.wait_for_function("location.hash !== ''")
    first, second, third = states(page)
    assert first == GimbalLockDemo().state()
    assert second == GimbalLockDemo(yaw=30, pitch=1).state()
    assert third == TiltDemo(roll=3).state()
    said = page.url.partition("#")[2]
    assert said == (
        "tilt?roll=3&pitch=0&forward_acceleration=0&lateral_acceleration=0&vibration=0"
        ";gimbal-lock-2?view=0&yaw=30&pitch=1&roll=0&flown=0"
    )
    page.reload()
    assert states(page) == [first, second, third]
    # The same address elsewhere, where no history knows more.
    page.goto("about:blank")
    page.goto(page_of(GimbalLockDemo(yaw=5), GimbalLockDemo(), TiltDemo()) + "#" + said)
    assert states(page) == [GimbalLockDemo(yaw=5).state(), second, third]


SAYS = """([name, value]) =>
  JSON.parse(document.querySelectorAll(".chr-demo")[1].dataset.state)[name] === value"""


def test_a_link_on_an_open_page_and_back_and_forward_move_the_demo(
    visit: Visit, page_of: PageOf
) -> None:
    page = visit(page_of(GimbalLockDemo(), TiltDemo(roll=2)))
    slider(page, "yaw").press("ArrowRight")
    page.wait_for_function("location.hash !== ''")
    moved = GimbalLockDemo(yaw=1).state()
    page.evaluate("location.hash = 'tilt?roll=20&pitch=5'")
    page.wait_for_function(SAYS, arg=["pitch", 5])
    assert states(page) == [moved, TiltDemo(roll=20, pitch=5).state()]
    page.evaluate("location.hash = 'a-section'")  # has nothing to do with them
    slider(page, "roll").nth(1).press("ArrowRight")
    page.evaluate("history.go(-2)")
    page.wait_for_function("location.hash.startsWith('#gimbal-lock?')")
    page.wait_for_function(SAYS, arg=["roll", 2])
    assert states(page) == [moved, TiltDemo(roll=2).state()]
    page.go_forward()
    page.wait_for_function(SAYS, arg=["roll", 20])
    assert states(page) == [moved, TiltDemo(roll=20, pitch=5).state()]
    page.reload()
    assert states(page) == [moved, TiltDemo(roll=20, pitch=5).state()]


def test_a_hand_that_ends_a_glide_leaves_nothing_half_way(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(TiltDemo(roll=7)) + "#tilt?roll=-50&pitch=33&vibration=2", own=True)
    hold(page)
    page.get_by_role("button", name="Reset").click()
    let_pass(page, 240, frame=80)
    assert 7 > state_of(page)["roll"] > -50
    slider(page, "roll").press("End")
    there = state_of(page)
    assert there == TiltDemo(roll=180).state()
    let_pass(page, 2_000)
    assert state_of(page) == there
    # In a story, they go to the nearest of their steps.
    page.get_by_role("button", name="Play").click()
    let_pass(page, 7_000)
    assert state_of(page)["roll"] % 1
    page.get_by_role("button", name="Pause").click()
    there = state_of(page)
    assert all(value % 1 == 0 for name, value in there.items() if name in {"roll", "pitch"})
    let_pass(page, 1_000)
    assert f"roll={there['roll']}&pitch={there['pitch']}&" in page.url


def test_the_address_waits_until_nothing_moves(visit: Visit, page_of: PageOf) -> None:
    page = visit(page_of(MagnetometerDemo()), own=True)
    hold(page)
    page.get_by_role("button", name="Play").click()
    let_pass(page, 1_600, frame=400)  # longer between two frames than the address waits
    assert "#" not in page.url
