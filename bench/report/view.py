#!/usr/bin/env python3
"""How fast a report opens and turns in headless Chromium, with software rendering.

    ./pliant run cases/organ --set discretisation.spacing=0.00259 --set output.every=0.00272 --set output.surface=true
    ./pliant report results/organ
    bench/report/view.py results/organ/report.html [--turns 120] [--size 1280 900]

Prints when the first picture was there, and the pictures in a second and the processor time of each picture while the body
turns, for each kind of process of the browser. Needs the packages of the section `browser` of
cmake/debian-packages.txt. Processor times hold on a busy machine too; the others need two idle cores.
"""
import argparse
import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))

from picture import open_browser, wait_for

# Drags the body in circles, one step before each frame, and returns the seconds it took.
TURN = """
const [pictures, answer] = arguments;
const canvas = document.getElementById("canvas");
canvas.setPointerCapture = canvas.releasePointerCapture = () => {};
const send = (kind, i) => canvas.dispatchEvent(new PointerEvent(kind, {
  pointerId: 1, pointerType: "mouse", isPrimary: true, button: 0, buttons: kind === "pointerup" ? 0 : 1, bubbles: true,
  clientX: 300 + 80 * Math.cos(i / 12), clientY: 300 + 40 * Math.sin(i / 12),
}));
let i = 0, start = 0;
send("pointerdown", 0);
const step = () => {
  if (i === 0) start = performance.now();
  if (++i <= pictures) {
    send("pointermove", i);
    requestAnimationFrame(step);
  } else {
    const seconds = (performance.now() - start) / 1000;
    const pixels = [canvas.width, canvas.height];
    send("pointerup", i);
    answer([seconds, pixels]);
  }
};
requestAnimationFrame(step);
"""


def processes_below(parent):
    """All descendants of a process."""
    found = []
    for path in pathlib.Path("/proc").iterdir():
        try:
            if path.name.isdigit() and int((path / "stat").read_text().rsplit(")", 1)[1].split()[1]) == parent:
                found += [int(path.name), *processes_below(int(path.name))]
        except OSError:
            pass  # has ended already
    return found


def processor_seconds(parent):
    """Of the processes below one, by what they do for the browser."""
    seconds = {}
    for process in processes_below(parent):
        try:
            words = pathlib.Path(f"/proc/{process}/cmdline").read_bytes().decode().replace("\0", " ").split()
            times = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[11:13]
        except OSError:
            continue
        kind = next((word.removeprefix("--type=") for word in words if word.startswith("--type=")), "browser")
        seconds[kind] = seconds.get(kind, 0) + sum(map(int, times)) / os.sysconf("SC_CLK_TCK")
    return seconds


def turn(browser, pictures):
    before = processor_seconds(browser.service.process.pid)
    seconds, pixels = browser.execute_async_script(TURN, pictures)
    after = processor_seconds(browser.service.process.pid)
    each = {kind: 1e3 * (after[kind] - before.get(kind, 0)) / pictures for kind in after}
    busy = ", ".join(f"{kind} {time:.1f}" for kind, time in sorted(each.items(), key=lambda item: -item[1]) if time > 0.05)
    print(f"turning, {pixels[0]} x {pixels[1]} pixels: {pictures / seconds:.0f} pictures/s, "
          f"{sum(each.values()):.1f} ms of processor time each ({busy})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--turns", type=int, default=120, help="pictures of a measurement")
    parser.add_argument("--size", type=int, nargs=2, default=[1280, 900], help="of the window")
    arguments = parser.parse_args()
    browser = open_browser(*arguments.size)
    try:
        browser.set_script_timeout(300)
        browser.get(arguments.page.resolve().as_uri())
        wait_for(lambda: browser.execute_script("return document.getElementById('stage').dataset.loaded === 'yes'"))
        marks = browser.execute_script("return performance.getEntriesByType('mark').map((m) => [m.name, m.startTime])")
        print(", ".join(f"{name.replace('-', ' ')} after {time / 1e3:.2f} s" for name, time in marks))
        for _ in range(3):
            turn(browser, arguments.turns)
    finally:
        browser.quit()


if __name__ == "__main__":
    main()
