"""A design model from flight logs: what is wrong in a model is found again, and what did not move is left alone."""

from __future__ import annotations

import dataclasses
import html
import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import in_this_process

import testbed
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import load_design_model
from testbed.common.signals import STATE
from testbed.inputs.yaml_source import dump
from testbed.logs.entry import _setup, identify, read_run
from testbed.logs.identification import Identified, identified
from testbed.logs.output_error import BIN_S, simulated
from testbed.logs.regression import Row, without_white_noise

from .conftest import SCENARIO, Run

WRONG = {"Cm_alpha": 1.4, "Cm_left_ruddervator": 1.3}


def _found(folder: Path, wrong: dict[str, float]) -> Identified:
    log, _ = read_run(folder)
    setup = _setup(load_aircraft("vtail"))
    return identified([log], dataclasses.replace(setup, model=setup.model.with_error(wrong)))


def test_coefficients_that_are_wrong_are_found(run: Run) -> None:
    """Factors 1.4 and 1.3 too much are taken back, and each coefficient of pitch that is right stays so, within two of its standard
    deviations, of 3 % at most."""
    factors = {each.name: each for each in _found(run(), WRONG).factors}
    for name, each in factors.items():
        if name.startswith("Cm_") and each.known:
            value, std = (WRONG.get(name, 1.0) * number for number in (each.value, each.std))
            assert std < 0.03 and abs(value - 1.0) < 2.0 * std, name
            assert each.contradicted == (name in WRONG), name
    assert {name for name in factors if name.startswith("Cm_") and factors[name].known} >= {"Cm_q", *WRONG}
    alone = dataclasses.replace(factors["Cm_alpha"], simulated=np.nan, simulated_std=np.nan)
    assert not alone.contradicted  # by equation error alone, which noise and gusts bias


def test_the_model_that_was_found_predicts_what_was_kept_back(run: Run) -> None:
    """On the last part of the log, which was not used, the fit of the wrong model becomes that of the right one."""
    found, right = _found(run(), WRONG), _found(run(), {})
    own_fit = {each.rate: each for each in right.validation}
    for each in found.validation:
        assert each.fit == pytest.approx(own_fit[each.rate].fit, abs=0.02)
    (pitch,) = (each for each in found.validation if each.rate == "q_dot")
    assert pitch.fit > pitch.fit_before + 0.1 and pitch.simulated > pitch.simulated_before + 0.1


def test_half_of_the_commands_biases_equation_error_alone(run: Run) -> None:
    """In gusts with MEMS sensors, of a log at half of the law's rate: the tails' moments by equation error are half too small; by
    output error they are right within 20 %, those that the model has wrong and those that it has right."""
    factors = {each.name: each for each in _found(run(None, True), WRONG).factors}
    for name in ("Cm_left_ruddervator", "Cm_right_ruddervator"):
        each, right = factors[name], 1.0 / WRONG.get(name, 1.0)
        assert each.simulated == pytest.approx(right, rel=0.2), name
        assert each.value < 0.7 * right and each.taken == each.simulated


@pytest.fixture(scope="module")
def every_command(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two minutes of turns and climbs in light gusts, with MEMS sensors and every command of the law."""
    folder = tmp_path_factory.mktemp("every")
    more: list[dict[str, float]] = [
        {"at_s": 45, "heading_deg": 110}, {"at_s": 55, "altitude_m": 306}, {"at_s": 65, "heading_deg": 70},
        {"at_s": 80, "altitude_m": 298}, {"at_s": 95, "heading_deg": 120}, {"at_s": 105, "altitude_m": 306},
    ]  # fmt: skip
    air = {
        "atmosphere": {"turbulence_w20_m_s": 3},
        "sensors": {"model": "mems"},
        "commands": SCENARIO["commands"] + more,
    }
    (folder / "scenario.yaml").write_text(
        dump({**SCENARIO, **air, "duration_s": 120, "log_hz": 200, "seed": 9})
    )
    return testbed.fly(folder / "scenario.yaml").save(folder / "run", figures=False)


@pytest.mark.nightly
def test_a_tail_that_is_wrong_is_told_with_mems_sensors(every_command: Path) -> None:
    """Both methods put its moment, 1.3 times too large, within 15 % of the truth; nothing that is right is contradicted. With every
    second command missing it is not told."""
    wrong = {"Cm_left_ruddervator": 1.3}
    factors = {each.name: each for each in _found(every_command, wrong).factors}
    each = factors["Cm_left_ruddervator"]
    assert each.contradicted
    assert each.value == pytest.approx(1.0 / 1.3, rel=0.15) == each.simulated
    assert {each.name for each in factors.values() if each.contradicted} == set(wrong)
    log, _ = read_run(every_command)
    held = log.commands.copy()
    held[1::2] = held[: len(held) - 1 : 2]
    setup = _setup(load_aircraft("vtail"))
    half = dataclasses.replace(setup, model=setup.model.with_error(wrong))
    found = identified([dataclasses.replace(log, commands=held)], half)
    (each,) = (each for each in found.factors if each.name in wrong)
    assert not each.contradicted and each.value < 0.5


def test_what_a_vane_measures_without_its_noise() -> None:
    """Motion below 1 Hz in as much white noise: nine tenths of the noise are gone, without delay; without noise all of it stays."""
    rng, time_s = np.random.default_rng(4), 0.005 * np.arange(24000)
    motion = sum(np.sin(2.0 * np.pi * hz * time_s + hz) for hz in (0.1, 0.37, 0.9))
    noisy = without_white_noise(motion + rng.normal(size=len(time_s)), 0.005)
    assert np.std(noisy - motion) < 0.25
    assert np.corrcoef(noisy[20:-20], motion[20:-20])[0, 1] > np.corrcoef(noisy[20:-20], motion[:-40])[0, 1]
    np.testing.assert_allclose(without_white_noise(motion, 0.005)[200:-200], motion[200:-200], atol=0.01)


def test_noise_and_gusts_contradict_nothing_that_is_right(run: Run) -> None:
    """Pitch by angle of attack comes out too small by both methods, which noise and gusts bias by different amounts."""
    factors = {each.name: each for each in _found(run(None, True), {}).factors}
    each = factors["Cm_alpha"]
    assert each.simulated + 3.0 * each.simulated_std < 1.0 and not each.contradicted
    assert not any(each.contradicted for each in factors.values())


def test_simulated_rates_and_their_derivatives() -> None:
    """A damped rate that is pushed by a known column: it follows the closed form, and its derivatives are those of differences."""
    count, damping = 200, -3.0
    time_s = BIN_S * np.arange(count)
    pushed = np.sin(2.0 * time_s)
    zero, columns = np.zeros(count), np.column_stack([0 * time_s, pushed, 0 * time_s])
    part = Row("p_dot", ("Cl_p", "Cl_u"), zero, columns, zero, np.array([damping, 0.0, 0.0]), (0, -1, -1))
    still = [
        Row(rate, (), zero, zero[:, None], zero, np.zeros(3), (-1, -1, -1)) for rate in ("q_dot", "r_dot")
    ]
    rows, change = np.arange(count)[None], np.array([0.0, 0.5, 0.0, 0.0, 0.0])
    error, by_change, _ = simulated([part, *still], np.ones(count), rows, change)
    exact = 0.5 * (3.0 * np.sin(2.0 * time_s) - 2.0 * np.cos(2.0 * time_s)) / 13.0
    moved = error[0, :, 0] - exact
    decay = np.exp(damping * time_s)
    assert np.abs(moved - decay * (decay @ moved) / (decay @ decay)).max() < 2e-4
    for i in (0, 1):
        step = 1e-4 * np.eye(5)[i]
        sides = [simulated([part, *still], np.ones(count), rows, change + side)[0] for side in (step, -step)]
        slope = (sides[0] - sides[1])[0, :, 0] / 2e-4
        rest = by_change[0, :, 0, i] - slope
        assert np.abs(rest - decay * (decay @ rest) / (decay @ decay)).max() < 0.05 * np.abs(slope).max()


def test_what_moves_alike_is_said(run: Run) -> None:
    """In turns by one law, yaw comes from sideslip, yaw rate and tails together: their variances are inflated."""
    factors = {each.name: each for each in _found(run(), {}).factors}
    assert factors["Cn_beta"].inflation > 30.0 > factors["Cm_alpha"].inflation
    assert not factors["Cn_left_propeller"].known and factors["Cn_left_propeller"].value == 1.0


@pytest.mark.nightly
def test_the_function_of_the_xml_that_a_log_contradicts_is_named(run: Run, tmp_path: Path) -> None:
    """An aircraft whose XML has a pitch damping 1.8 times too large, against a log of the right one."""
    folder = shutil.copytree(load_aircraft("vtail").folder, tmp_path / "vtail")
    xml = folder / "vtail.xml"
    xml.write_text(xml.read_text().replace("<value>-10.0586</value>", f"<value>{-10.0586 * 1.8}</value>"))
    ended = in_this_process(tmp_path, "identify", str(folder), "--log", str(run()), "--out", "out")
    lines = ended.stdout.splitlines()
    (at,) = (i for i, line in enumerate(lines) if line.startswith("  Cm_q "))
    assert "contradicts the model" in lines[at], ended.stdout + ended.stderr
    made = "made in the XML by aero/coefficient/Cm_q (PITCH) 8"
    assert lines[at + 1].startswith(f"    {made}")
    story, page = _written(tmp_path / "out")
    assert story["story"][0].startswith("Cm_q is 0.") and made in story["story"][0] and made in page
    assert story["made_by"].keys() == {"Cm_q"} and story["factors"]["Cm_q"]["contradicted"]
    right = in_this_process(tmp_path, "identify", "vtail", "--log", str(run()), "--out", "right")
    assert right.returncode == 0 and "contradict nothing" in _written(tmp_path / "right")[0]["story"][0]


def _written(folder: Path) -> tuple[dict[str, Any], str]:
    """(summary, page) of an identification."""
    summary = json.loads((folder / "summary.json").read_text())
    page = (folder / "report.html").read_text()
    assert all(html.escape(line) in page for line in summary["story"])
    return summary, page


def test_the_summary_and_the_page_say_what_was_found(run: Run, tmp_path: Path) -> None:
    """Covariances are those of the factors; predicted is measured less what is left; what moves alike is named."""
    found = identify("vtail", [run()], out=tmp_path / "out")
    summary, page = _written(tmp_path / "out")
    assert load_design_model(tmp_path / "out" / "design_model.json") == found.model
    for rate, each in summary["covariance"].items():
        std = "simulated_std" if rate == "output error" else "std"
        stds = [summary["factors"][name][std] for name in each["factors"]]
        np.testing.assert_allclose(np.sqrt(np.diagonal(each["matrix"])), stds, rtol=1e-9)
    for one in found.validation:
        spread = np.sqrt(np.mean(one.measured**2))
        left = np.sqrt(np.mean((one.measured - one.predicted) ** 2))
        assert one.fit == pytest.approx(1.0 - left / spread)
        assert one.coloured == np.mean(np.abs(one.correlations) > one.white)
    time_s, measured, error = found.output.kept
    log, _ = read_run(run())
    rows = np.round(time_s / log.step_s).astype(int)
    q = log.states[:, STATE.index("q")]
    np.testing.assert_allclose(measured[..., 1], 0.5 * (q[rows] + q[rows + 1]), atol=1e-9)
    assert time_s.min() > 0.7 * log.time_s[-1] - 1.0 and np.std(error[..., 1]) < 0.3 * np.std(
        measured[..., 1]
    )
    tails = summary["factors"]["Cm_left_propeller"]
    assert tails["alike"] == "Cm_right_propeller" and abs(tails["correlation"]) > 0.9
    assert page.count("<img") == 2 and tails["simulated"] is None


def test_the_command_writes_a_model(run: Run, tmp_path: Path) -> None:
    ended = in_this_process(tmp_path, "identify", "vtail", "--log", str(run()), "--out", "model.json")
    assert ended.returncode == 0, ended.stderr
    assert "Cm_alpha" in ended.stdout and "not identifiable" in ended.stdout
    assert "has 100 of 200 commands a second" in ended.stdout
    model = load_design_model(tmp_path / "model.json")
    assert model.actuators == load_design_model(load_aircraft("vtail").folder / "design_model.json").actuators
    again = in_this_process(tmp_path, "identify", "vtail", "--log", str(run()), "--out", "model.json")
    assert again.returncode == 2 and "exists" in again.stderr
    assert in_this_process(tmp_path, "identify", "vtail", "--out", "other.json").returncode == 2
    assert in_this_process(tmp_path, "identify", "vtail", "--check", "--log", str(run())).returncode == 2
