"""Check propeller.py on a published table: APC 18x8E, from the file inside the jsbsim wheel.

    python validate_propeller.py

The blade here is the one of geometry.yaml (same chord law, section and number of blades) at 18 in and 8 in of
pitch: the true chord law of the 18x8E was not at hand, so this checks method and assumed blade together.
APC's table is itself computed (at 10 000 rpm).
"""

import re
from dataclasses import replace
from pathlib import Path

import jsbsim
import numpy as np
import yaml
from derive import blade_of
from propeller import coefficients


def published(text, name):
    data = re.search(f'name="{name}".*?<tableData>(.*?)</tableData>', text, re.S).group(1)
    return np.array(data.split(), float).reshape(-1, 2).T


def main():
    text = (Path(jsbsim.__file__).parent / "engine" / "APC_18x8E.xml").read_text()
    thrust, power = published(text, "C_THRUST"), published(text, "C_POWER")
    g = yaml.safe_load((Path(__file__).parent / "geometry.yaml").read_text())
    blade = replace(blade_of(g), diameter_m=18 * 0.0254, pitch_m=8 * 0.0254)
    print("   J      CT    APC      %       CP    APC      %")
    for j in (0.0, 0.1, 0.2, 0.3, 0.4, 0.5):
        ct, cp = coefficients(blade, j, 10000 / 60)
        a, b = np.interp(j, *thrust), np.interp(j, *power)
        off_t, off_p = 100 * (ct / a - 1), 100 * (cp / b - 1)
        print(f"{j:5.2f}  {ct:.4f} {a:.4f} {off_t:6.1f}   {cp:.4f} {b:.4f} {off_p:6.1f}")


if __name__ == "__main__":
    main()
