"""Derive `vtail_aft`: the v-tail with its battery moved aft until it is unstable in pitch, by the v-tail's own derivation.

    python ballast.py            solve, write the model, the description and solution.yaml, and print what was found
    python ballast.py --check    write nothing; exit 1 if a file is not that of the stored solution, or the solution is none

Needs AeroSandbox (the extra `derive`) and the testbed. Two numbers of the v-tail's geometry are changed, and both are solved for:
where the battery stands, so that the motion in JSBSim has the root `DOUBLING_TIME_S`, and the tail's incidence, so that the
ruddervators' trim is that of the v-tail. Everything else is `../vtail/geometry.yaml`, through `../vtail/derive.py`.
"""

import argparse
import copy
import math
import sys
import tempfile
from pathlib import Path

import numpy as np
import yaml

HERE = Path(__file__).resolve().parent
VTAIL = HERE.parent / "vtail"
sys.path.insert(0, str(VTAIL))

import derive  # noqa: E402 - the v-tail's derivation is a script beside its geometry
import shape  # noqa: E402 - likewise

from testbed.aircraft.description import load_aircraft  # noqa: E402
from testbed.plant.jsbsim import Plant  # noqa: E402
from testbed.plant.trim import accelerations, trim  # noqa: E402

DOUBLING_TIME_S = 0.5
DESCRIPTION = "the v-tail with its battery further aft, unstable in pitch (doubles in 0.5 s)"
FIRST_GUESS, STEPS = np.array([0.40, -1.0]), np.array([0.01, 0.5])  # battery's x [m], tail's incidence [deg]
DECIMALS = (4, 2)  # to which the two are stated
CLOSE = np.array([0.02, 0.02])  # of the root [rad/s] and of the trim [deg]
TRIES = 8
SOLUTION = "solution.yaml"
LONGITUDINAL = [0, 2, 4]  # u, w, q among the accelerations
STEP = (0.05, 0.05, 0.005, 0.005)  # u, w [m/s], q [rad/s], pitch [rad]


def geometry(unknowns):
    """The v-tail's geometry with the battery at x and the tail at the incidence of `unknowns`."""
    g = copy.deepcopy(derive.stated_geometry())
    g["name"] = "vtail_aft"
    battery = next(part for part in g["masses"] if part["name"] == "battery")
    battery["at_m"][0], g["tail"]["incidence_deg"] = map(float, unknowns)
    return g


def description():
    """The v-tail's YAML under another name."""
    lines = (VTAIL / "vtail.yaml").read_text().splitlines()
    new = {"name": "vtail_aft", "description": DESCRIPTION, "model": "vtail_aft"}
    text = "\n".join(_renamed(line, new) for line in lines)
    return (
        text.replace(
            "; vtail.xml is what JSBSim reads.",
            ".\n# Written by ballast.py from ../vtail/vtail.yaml: change those, not this.",
        ).replace("vtail.xml", "vtail_aft.xml")
        + "\n"
    )


def _renamed(line, new):
    key = line.partition(":")[0]
    return f"{key}: {new[key]}" if key in new else line


def files(unknowns):
    """Text of each file, by its path in the folder."""
    g = geometry(unknowns)
    texts = derive.build(g)[-1]
    where = f"battery at x {unknowns[0]:.4f} m, tail at {unknowns[1]:.2f} deg"
    model = texts["vtail_aft.xml"].replace(
        "Written by derive.py from geometry.yaml: change those, not this.",
        f"Written by ballast.py through ../vtail/derive.py, with the {where}: change those, not this.",
    )
    looks = shape.text_of(g).replace(
        "Written by shape.py from geometry.yaml", "Written by ballast.py through ../vtail/shape.py"
    )
    return {**texts, "vtail_aft.xml": model, "vtail_aft.yaml": description(), "shape.yaml": looks}


def write(texts, folder):
    for name, text in texts.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def measured(texts):
    """Fastest growing root [rad/s] of the longitudinal motion in JSBSim, and the ruddervators' trim [deg]."""
    with tempfile.TemporaryDirectory() as root:
        folder = Path(root) / "aircraft" / "vtail_aft"
        write(texts, folder)
        plant = Plant(load_aircraft(str(folder)), 200)
        level = trim(plant, 18.0, 300.0)
        return np.array([_growth(plant, level), level.positions[0]])


def _growth(plant, level):
    speed, alpha, pitch = (level.state[name] for name in ("airspeed", "alpha", "pitch"))
    x0 = np.array([speed * math.cos(alpha), speed * math.sin(alpha), 0.0, pitch])

    def rates(x):
        u, w, q, theta = map(float, x)
        state = {
            **level.state,
            "airspeed": math.hypot(u, w),
            "alpha": math.atan2(w, u),
            "q": q,
            "pitch": theta,
        }
        return np.append(accelerations(plant, state, level.commands)[LONGITUDINAL], q)

    columns = [(rates(x0 + h) - rates(x0 - h)) / (2 * h.max()) for h in np.diag(STEP)]
    return max(np.linalg.eigvals(np.column_stack(columns)).real)


def solved():
    """The two unknowns, rounded: Newton's method with a difference Jacobian, which Broyden's rule updates."""
    x, wanted = FIRST_GUESS, goal()
    error = measured(files(x)) - wanted
    slopes = np.column_stack([(measured(files(x + h)) - wanted - error) / h.max() for h in np.diag(STEPS)])
    for _ in range(TRIES):
        step = -np.linalg.solve(slopes, error)
        x = np.array([round(v, n) for v, n in zip(x + step, DECIMALS, strict=True)])
        error = measured(files(x)) - wanted
        if np.all(np.abs(error) < CLOSE):
            return x
        slopes = slopes + np.outer(error, step) / (step @ step)
    raise RuntimeError(f"no solution: {x} leaves {error}")


def goal():
    """What `measured` shall be."""
    plant = Plant(load_aircraft(str(VTAIL)), 200)
    return np.array([math.log(2.0) / DOUBLING_TIME_S, trim(plant, 18.0, 300.0).positions[0]])


def stored():
    found = yaml.safe_load((HERE / SOLUTION).read_text())
    return np.array([found["battery_x_m"], found["tail_incidence_deg"]])


def checked():
    """What is wrong with the files as they are."""
    unknowns = stored()
    texts = files(unknowns)
    for name, text in texts.items():
        if not (HERE / name).exists() or (HERE / name).read_text() != text:
            yield f"differs: {name}"
    error = measured(texts) - goal()
    if np.any(np.abs(error) >= CLOSE):
        yield f"no solution: off by {error[0]:.3f} rad/s and {error[1]:.3f} deg"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="check the files only; exit 1 if one is wrong")
    if parser.parse_args().check:
        wrong = list(checked())
        print("\n".join(wrong) or "identical")
        return 1 if wrong else 0
    unknowns = solved()
    texts = files(unknowns)
    x, incidence = map(float, unknowns)
    (HERE / SOLUTION).write_text(
        f"# Found by ballast.py.\nbattery_x_m: {x}\ntail_incidence_deg: {incidence}\n"
    )
    write(texts, HERE)
    growth, tail = measured(texts)
    print(f"battery at x {x} m, tail's incidence {incidence} deg")
    print(f"time to double {math.log(2.0) / growth:.3f} s, ruddervators at {tail:+.2f} deg")
    print("centre of gravity", derive.masses(geometry(unknowns))["cg_m"])
    return 0


if __name__ == "__main__":
    sys.exit(main())
