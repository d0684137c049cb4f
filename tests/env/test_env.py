"""Environments: what Gymnasium's and stable-baselines3's checkers say, what is drawn, how an episode ends, and what is saved."""

from __future__ import annotations

import shutil
import warnings
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.error import ResetNeeded
from gymnasium.utils.env_checker import check_env

import testbed
import testbed.env
from testbed import BadInput
from testbed.aircraft.shipped import aircraft_names, find_aircraft
from testbed.controllers.user.loader import load_controller
from testbed.env.flight import REWARDS, FlightEnv

SWEEP = "scenarios/sweeps/left_tail_monte_carlo.yaml"
LOST = [{"type": "effectiveness", "actuator": "left_ruddervator", "at_s": 0.5, "value": 0.0}]
STILL = np.zeros(4)


def made(**given: Any) -> FlightEnv:
    """The v-tail's environment, for two seconds."""
    short = {"set": {"duration_s": 2.0}} if not given.get("sweep") else {}
    env = gymnasium.make("testbed/vtail-v0", **{**short, **given}).unwrapped
    assert isinstance(env, FlightEnv)
    return env


def flown(env: FlightEnv, action: np.ndarray = STILL) -> tuple[float, bool, bool, dict[str, Any]]:
    """An episode to its end, with the same action all the time: the last reward and what comes with it."""
    while True:
        _, reward, lost, truncated, info = env.step(action)
        if lost or truncated:
            return reward, lost, truncated, info


@pytest.mark.parametrize("task", REWARDS)
@pytest.mark.parametrize("aircraft", aircraft_names())
def test_gymnasiums_checker_is_silent(aircraft: str, task: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gymnasium.make(f"testbed/{aircraft}-v0", task=task).unwrapped)


@pytest.mark.nightly
@pytest.mark.parametrize("aircraft", aircraft_names())
def test_stable_baselines3s_checker_is_silent(aircraft: str) -> None:
    checker = pytest.importorskip(
        "stable_baselines3.common.env_checker", reason="stable-baselines3 is not installed"
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        checker.check_env(gymnasium.make(f"testbed/{aircraft}-v0"))


def test_a_folder_is_flown(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    own = shutil.copytree(find_aircraft("vtail").parent, tmp_path / "aircraft" / "mine")
    (own / "mine.yaml").write_text((own / "vtail.yaml").read_text().replace("name: vtail", "name: mine"))
    monkeypatch.chdir(tmp_path)
    testbed.env.register()
    seen, _ = gymnasium.make("testbed/mine-v0").reset(seed=1)
    del gymnasium.registry["testbed/mine-v0"]
    again, _ = gymnasium.make(testbed.env.ANY, aircraft="aircraft/mine").reset(seed=1)
    assert np.array_equal(seen, again)


def test_the_same_seed_draws_the_same_episode_and_another_one_another() -> None:
    env = made(sweep=SWEEP)
    first, second, again = (env.reset(seed=seed)[1]["run"] for seed in (1, 2, 1))
    assert first == again != second
    env.reset(options={"run": 5})
    plan_draw = env._episodes._plan.draw(5)
    failure = env._session.parts.scenario.failures[0]  # type: ignore[union-attr]
    assert (failure.actuator, failure.value) == (
        plan_draw["failures.0.actuator"],
        plan_draw["failures.0.value"],
    )


def test_an_option_breaks_one_episode_and_not_the_next() -> None:
    env = made()
    _, info = env.reset(seed=3, options={"failures": LOST})
    assert set(info) == {"seed"}
    broken = flown(env)[0]
    env.reset(seed=3)
    assert broken < 0.8 and flown(env)[0] > 0.999


def test_the_end_truncates_and_a_loss_terminates() -> None:
    env = made(task="survive")
    env.reset(seed=1)
    assert flown(env) == (1.0, False, True, {"outcome": "completed"})
    with pytest.raises(ResetNeeded):
        env.step(STILL)
    env.reset(seed=1, options={"set": {"initial.altitude_m": 3.0, "duration_s": 10}})
    assert flown(env, np.array([1.0, 1.0, -1.0, -1.0])) == (0.0, True, False, {"outcome": "ground_contact"})


def test_zero_holds_trimmed_flight() -> None:
    env = made(action_hz=5)
    seen, _ = env.reset(seed=1)
    assert np.abs(seen[:3]).max() < 1e-3
    reward, *_ = flown(env)
    assert reward > 0.999


def test_commands_are_drawn_only_to_follow() -> None:
    follow, hold = made(task="follow", set={"duration_s": 30}), made()
    follow.reset(seed=1)
    hold.reset(seed=1)
    assert len(follow._session.parts.scenario.commands) > 3  # type: ignore[union-attr]
    assert len(hold._session.parts.scenario.commands) == 1  # type: ignore[union-attr]


def test_an_episode_is_saved_as_a_run_folder(tmp_path: Path) -> None:
    env = made()
    env.reset(seed=1, options={"failures": LOST})
    flown(env)
    folder = env.save(tmp_path / "episode", figures=False)
    flight = testbed.load(folder)
    assert flight.end_time_s == 2.0
    assert flight.summary["events"][0]["verified"]
    assert "left ruddervator" in (folder / "report.html").read_text().replace("_", " ")


def test_the_learnt_policy_holds_with_a_lost_tail() -> None:
    learnt = load_controller(f"{Path(__file__).parents[2] / 'examples' / 'learn.py'}:Learnt")
    flight = testbed.fly("scenarios/left_tail_fail.yaml", learnt)
    assert flight.metrics["altitude_error_max_m"] < 1 and flight.metrics["heading_error_max_deg"] < 2


def test_environments_fly_in_processes() -> None:
    env = gymnasium.make_vec("testbed/vtail-v0", 2, vectorization_mode="async", set={"duration_s": 1.0})
    try:
        seen, _ = env.reset(seed=1)
        for _ in range(25):  # beyond the end, where a new episode begins
            seen, *_ = env.step(np.zeros((2, 4)))
        assert seen.shape == (2, 18)
    finally:
        env.close()


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"runs": 3}, "did you mean run"),
        ({"run": 3}, "without a sweep"),
        ({"sweep": SWEEP, "run": 1000}, "from 0 to 999"),
        ({"scenario": {"aircraft": "aerosonde"}}, "is aerosonde, and the environment's is vtail"),
        ({"set": 3}, "expected a mapping"),
        ({"failures": [{"type": "stuk"}]}, "stuck"),
    ],
)
def test_options_are_refused_in_words(options: dict[str, Any], said: str) -> None:
    with pytest.raises(BadInput, match=said):
        made().reset(options=options)


def test_arguments_and_actions_are_refused_in_words() -> None:
    with pytest.raises(BadInput, match="did you mean hold"):
        made(task="hod")
    with pytest.raises(BadInput, match="divided by a whole number"):
        made(action_hz=7).reset()
    env = made()
    env.reset()
    for action in (np.zeros(3), np.full(4, np.nan)):
        with pytest.raises(BadInput, match="4 finite numbers"):
            env.step(action)
