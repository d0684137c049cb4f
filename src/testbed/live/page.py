"""The page of a flight by hand: the places that `web/src/live.js` fills, with what it has to know."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from testbed.reporting import html
from testbed.reporting.html import Html, tag
from testbed.reporting.page import group_of
from testbed.reporting.panels import TRACKED, error_panel

_SPEEDS = (0.25, 0.5, 1, 2, 4, 8, 16)
_ORDERS = {
    "heading_deg": ("heading [deg]", 5),
    "altitude_m": ("altitude [m]", 1),
    "airspeed_m_s": ("airspeed [m/s]", 0.5),
}
_WIND = {"north": 0, "east": 0, "down": 0}
_TURBULENCE = {"W20": 5}
_GUST = {"forward": 0, "right": 3, "down": 0, "rise [s]": 0.5, "hold [s]": 1}


def page(facts: Mapping[str, Any], address: str) -> str:
    """The page of a flight with these facts (see `messages.facts`), which connects to an address."""
    panels = group_of("errors", "Errors against what was ordered", False, map(error_panel, TRACKED))
    for panel, tracked in zip(panels["panels"], TRACKED.values(), strict=True):
        limit = facts["limits"].get(tracked.reference)
        panel["limits"] = [] if limit is None else [-limit, limit]
    chips = [tag("li", tag("b", what), facts[what]) for what in ("aircraft", "controller")]
    parts = [
        tag("h1", f"{facts['name']}, live"),
        tag("ul", chips, class_="chips"),
        _choice(facts["choices"], facts["chosen"]),
        tag("p", "connecting", id="status", role="status"),
        tag("div", [_flight(), _beside(not facts["sensors"])], class_="live"),
        html.panels(panels),
        _told(),
    ]
    data = {"live": {**facts, "panels": [panels]}}
    return html.page_text(f"{facts['name']}, live", parts, "live.js", data, "live.css", address)


def _choice(names: Mapping[str, list[str]], chosen: Mapping[str, str]) -> Html:
    """What can be flown in place of what is chosen, and what can fly beside it."""
    groups = [
        tag("optgroup", _options(names[kind], chosen["flight"]), label=label)
        for kind, label in (("scenarios", "scenario"), ("aircraft", "level flight of"))
    ]
    choose = tag(
        "form", tag("label", "flight", tag("select", groups, name="flight")),
        tag("label", "controller", _chosen("controller", names["controllers"], chosen)),
        tag("label", "sensors", _chosen("sensors", names["sensors"], chosen)),
        _button("Fly this", kind="submit"), id="choose",
    )  # fmt: skip
    boxes = [
        tag("label", tag("input", type="checkbox", value=name), name, tag("span"))
        for name in names["controllers"][1:]
    ]
    beside = tag(
        "fieldset",
        tag("legend", "Fly the same beside it, by other controllers (at most 3)"),
        boxes,
        id="ghosts",
    )
    return tag("details", tag("summary", "Choose what flies"), choose, beside, class_="choose")


def _chosen(what: str, names: Iterable[str], chosen: Mapping[str, str]) -> Html:
    return tag("select", _options(names, chosen[what]), name=what)


def _options(names: Iterable[str], chosen: str) -> list[Html]:
    return [tag("option", name, value=name, selected="selected" if name == chosen else "") for name in names]


def _flight() -> Html:
    """The picture and the time."""
    speeds = [tag("option", f"{s:g} x", value=s, selected="selected" if s == 1 else "") for s in _SPEEDS]
    views = [_button(view, view=view) for view in ("chase", "side", "top", "whole")]
    times = [
        _button("Pause", do="pause", title="space"), tag("label", "speed ", tag("select", speeds, id="speed")), *views,
        _button("Save", do="save"), _button("Start again", do="restart"),
    ]  # fmt: skip
    back = [
        tag("label", "go back to ", tag("output", id="back-to"), for_="back"),
        tag("input", type="range", id="back", min=0, max=0, step=0.1, value=0),
    ]
    said = (
        "Click on a surface or a propeller, or on its name, to break it. "
        "Keys: space pauses, left and right turn, up and down climb; so does a gamepad's stick. "
        "Drag to turn the camera; wheel, two fingers, + and - zoom."
    )
    canvas = tag("canvas", role="img", tabindex=0, aria_label="the flight")
    return tag(
        "section", tag("div", canvas, tag("output"), class_="picture"), tag("div", times, class_="buttons"),
        tag("div", back, class_="buttons"), html.note(said), tag("div", id="saved"), aria_label="flight",
    )  # fmt: skip


def _sensors(ideal: bool) -> Html:
    """The sensors, each of which can fail; those that are ideal cannot."""
    heads = [*(tag("th", text) for text in ("sensor", "truth")), tag("td")]
    table = tag("table", tag("thead", tag("tr", heads)), tag("tbody", id="sensors"))
    none = tag("p", "They are ideal, and cannot fail: choose others above.")
    return tag("details", tag("summary", "Sensors"), none if ideal else tag("div", table, class_="table"))


def _beside(ideal: bool) -> Html:
    """Actuators, modes, and what can be done."""
    heads = [*(tag("th", text) for text in ("actuator", "truth", "belief")), tag("td")]
    table = tag("table", tag("thead", tag("tr", heads)), tag("tbody", id="actuators"))
    orders = [
        tag("label", words, tag("input", type="number", step=step, name=name))
        for name, (words, step) in _ORDERS.items()
    ]
    return tag(
        "section", tag("div", table, class_="table"), tag("p", id="modes"),
        _sensors(ideal), tag("form", id="break", hidden="hidden"),
        tag("form", orders, _button("Order", kind="submit"), id="order"),
        _numbers("wind", "wind [m/s] towards", _WIND, "Change wind"),
        _numbers("gust", "gust [m/s]", _GUST, "Blow"),
        _numbers("turbulence", "turbulence [m/s], 0 for none", _TURBULENCE, "Change turbulence"),
        aria_label="actuators and orders",
    )  # fmt: skip


def _numbers(name: str, title: str, fields: Mapping[str, float], does: str) -> Html:
    inputs = [
        tag("label", field, tag("input", type="number", step="any", value=v)) for field, v in fields.items()
    ]
    return tag("form", tag("span", title), inputs, _button(does, kind="submit"), id=name)


def _told() -> Html:
    return tag(
        "section", tag("h2", "Story so far"), tag("ul", id="story", class_="story"),
        tag("h2", "Events"), tag("ul", id="events"), aria_label="story",
    )  # fmt: skip


def _button(words: str, kind: str = "button", do: str = "", view: str = "", title: str = "") -> Html:
    return tag("button", words, type=kind, data_do=do, data_view=view, title=title)
