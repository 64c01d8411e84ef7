"""make_data.py RESULT: writes tip.csv beside this file, the displacement of the tip in RESULT (a result.h5 of
cases/liver_aspiration) with normal noise of 1 % of each value, seeded.

    pliant run cases/liver_aspiration --set discretisation.spacing=0.0025 --set time.step=6e-3 \\
           --set output.measure_every=0.25 --out results/liver
    python3 docs/calibration/make_data.py results/liver/result.h5
"""

import random
import subprocess
import sys
from pathlib import Path


def column(file, name):
    text = subprocess.run(["h5dump", "-y", "-m", "%.17g", "-d", f"/measurements/tip/{name}", file], check=True,
                          capture_output=True, text=True).stdout
    return [float(value) for value in text.split("DATA {")[1].split("}")[0].replace(",", " ").split()]


def main():
    random.seed(1)
    lines = ["time,displacement"]
    for time, value in zip(column(sys.argv[1], "time"), column(sys.argv[1], "value")):
        if time > 1:
            lines.append(f"{time:.6g},{value * (1 + random.gauss(0, 0.01)):.6e}")
    (Path(__file__).parent / "tip.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
