#!/usr/bin/env python3
"""Makes a picture of a run with the view of its report, in headless Chromium.

    docs/picture.py results/organ picture.png --times 0 0.08 0.16 --field velocity
    docs/picture.py results/block_cut picture.png --view -70 45 --cut y

Runs in 3D should have `output.surface = true`. Needs the packages of the section `browser` of
cmake/debian-packages.txt.
"""
import argparse
import pathlib
import shutil
import subprocess
import tempfile
import time
import urllib.parse

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

root = pathlib.Path(__file__).resolve().parent.parent
PATIENCE = 300  # [s]


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", default=root / "pliant")
    parser.add_argument("--field", help="as `pliant report` takes it (default: the first that a report shows)")
    parser.add_argument("--label", help="what the bar of colours says (default: the field)")
    parser.add_argument("--scale", type=float, default=1, help="factor of the numbers at that bar")
    parser.add_argument("--range", type=float, nargs=2, help="ends of the colours")
    parser.add_argument("--times", type=float, nargs="+", help="frames nearest to them (default: the last)")
    parser.add_argument("--stack", action="store_true", help="times below each other, not side by side")
    parser.add_argument("--cut", choices="xyz", help="open the bodies across this axis, on the side of the camera")
    parser.add_argument("--place", type=float, default=0.5, help="of the cut, from 0 to 1 (default: 0.5, the middle)")
    parser.add_argument("--particles", action="store_true", help="show particles instead of bodies")
    parser.add_argument("--walls", action="store_true", help="show the walls of the case")
    parser.add_argument("--up", choices="xyz", help="(default: against gravity, else z)")
    parser.add_argument("--view", type=float, nargs=2, default=[-60, 25], metavar=("AZIMUTH", "ELEVATION"),
                        help="of the camera, degrees")
    parser.add_argument("--zoom", type=float, default=1)
    parser.add_argument("--size", type=int, nargs=2, default=[1100, 700])
    return parser.parse_args()


def wishes_of(arguments):
    """What the page reads behind the # of its address (engine/report/page/picture.js)."""
    wishes = {"picture": "", "view": arguments.view, "zoom": arguments.zoom, "scale": arguments.scale,
              "size": arguments.size, "times": arguments.times, "range": arguments.range, "field": arguments.field,
              "label": arguments.label, "cut": arguments.cut, "place": arguments.place, "up": arguments.up,
              "walls": arguments.walls or None, "stack": arguments.stack or None, "particles": arguments.particles or None}
    texts = {key: ",".join(map(str, value)) if isinstance(value, list) else str(value)
             for key, value in wishes.items() if value is not None}
    return urllib.parse.urlencode(texts)


def open_browser(width, height):
    options = Options()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                     f"--window-size={width + 50},{height + 250}"):
        options.add_argument(argument)
    return webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))


def wait_for(is_ready):
    end = time.monotonic() + PATIENCE
    while not is_ready():
        if time.monotonic() > end:
            raise SystemExit("the page does not become ready")
        time.sleep(0.1)


def take(page, arguments):
    browser = open_browser(*arguments.size)
    try:
        browser.get(f"{page.as_uri()}#{wishes_of(arguments)}")
        wait_for(lambda: browser.find_element(By.TAG_NAME, "body").get_attribute("data-ready") == "yes")
        browser.find_element(By.ID, "picture").screenshot(str(arguments.picture))
    finally:
        browser.quit()


def main():
    arguments = arguments_of()
    fields = ["--field", arguments.field] if arguments.field else []
    with tempfile.TemporaryDirectory() as scratch:
        page = pathlib.Path(scratch) / "report.html"
        subprocess.run([arguments.program, "report", arguments.folder, "--out", page, *fields], check=True)
        take(page, arguments)


if __name__ == "__main__":
    main()
