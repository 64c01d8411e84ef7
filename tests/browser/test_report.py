"""A report in headless Chromium: what its canvas shows, and what happens on clicks and keys."""

import json
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SKIPPED = 77
PROGRAM, SOURCE = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()

try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError:
    webdriver = None

# Draws a picture of the canvas, and returns the number of its colours and a sum over its pixels.
READ_PICTURE = """
const [png, answer] = arguments;
const image = new Image();
image.onload = () => {
  const canvas = new OffscreenCanvas(image.width, image.height);
  const context = canvas.getContext("2d");
  context.drawImage(image, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
  let sum = 0;
  pixels.forEach((pixel, i) => { sum = (sum + pixel * (i % 1009 + 1)) % 9007199254740991; });
  answer([new Set(pixels).size, sum]);
};
image.src = "data:image/png;base64," + png;
"""

# Records the width of the canvas and the number of triangles of all pictures from then on.
RECORD_PICTURES = """
window.drawn = [];
const { prototype } = WebGL2RenderingContext, draw = prototype.drawElements;
prototype.drawElements = function (mode, count, ...rest) {
  drawn.push([this.canvas.width, count / 3]);
  return draw.call(this, mode, count, ...rest);
};
"""

# Counts the connected spots of one colour in a canvas that are large enough.
COUNT_SPOTS = """
const [canvas, colour, least] = arguments;
const { width, height } = canvas;
const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
const is_spot = (i) => colour.every((part, c) => Math.abs(data[4 * i + c] - part) < 40) && data[4 * i + 3] > 200;
const seen = new Uint8Array(width * height);
let spots = 0;
for (let first = 0; first < width * height; ++first) {
  if (seen[first] || !is_spot(first)) continue;
  let size = 0;
  for (const todo = [first]; todo.length > 0;) {
    const i = todo.pop();
    if (seen[i] || !is_spot(i)) continue;
    seen[i] = 1;
    ++size;
    todo.push(i - 1, i + 1, i - width, i + width);
  }
  if (size > least) ++spots;
}
return spots;
"""


def open_browser():
    options = Options()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage",
                     "--window-size=900,800", "--hide-scrollbars"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
    browser.set_script_timeout(120)
    return browser


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        cls.solid = cls.page_of("docs/boundaries/free.toml", "discretisation.spacing=0.01", "output.measure_every=0.005",
                                'measurement=[{ name = "tip", kind = "extent", body = "ball", axis = "y" }]')
        cls.plane = cls.page_of("cases/rotating_cylinder", "discretisation.spacing=0.1", "time.step=0.001",
                                "time.end=0.04")
        cls.browser = BROWSER
        cls.addClassCleanup(cls.browser.quit)

    @classmethod
    def page_of(cls, case, *settings):
        out = cls.folder / Path(case).stem
        sets = [part for setting in settings for part in ("--set", setting)]
        subprocess.run([PROGRAM, "run", SOURCE / case, "--quiet", "--threads", "1", "--out", out, *sets],
                       cwd=SOURCE, check=True)
        subprocess.run([PROGRAM, "report", out], cwd=SOURCE, check=True, stdout=subprocess.DEVNULL)
        return (out / "report.html").as_uri()

    def open(self, address):
        self.browser.get(address)
        self.wait(lambda: self.element("stage").get_attribute("data-loaded") == "yes")
        self.wait(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#tables table"))

    def wait(self, condition):
        end = time.monotonic() + 120
        while not condition():
            self.assertLess(time.monotonic(), end, "nothing came")
            time.sleep(0.05)

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def picture(self):
        """Number of colours of the canvas, and a sum over its pixels."""
        self.browser.execute_script("scrollTo(0, 0)")
        png = self.element("canvas").screenshot_as_base64
        return tuple(self.browser.execute_async_script(READ_PICTURE, png))

    def expect_change(self, before):
        self.wait(lambda: self.picture() != before)
        return self.picture()

    def move(self, slider, keys):
        self.element(slider).send_keys(keys)

    def test_a_page_asks_for_nothing_and_reports_no_error(self):
        for address in (self.solid, self.plane):
            self.open(address)
            asked = self.browser.execute_script("return performance.getEntriesByType('resource').map(e => e.name)")
            self.assertEqual([], [name for name in asked if not name.startswith(("data:", "blob:"))])
            self.assertEqual([], [line for line in self.browser.get_log("browser") if line["level"] == "SEVERE"])

    def test_the_body_is_drawn_and_its_colours_change_with_time(self):
        for address in (self.solid, self.plane):
            self.open(address)
            first = self.picture()
            self.move("frame", Keys.END)
            last = self.expect_change(first)
            self.assertGreater(last[0], 30, "a body in colours has many of them")
            self.move("frame", Keys.HOME)
            self.wait(lambda: self.picture() == first)

    def test_another_field_has_other_colours_and_a_range_of_its_own(self):
        self.open(self.solid)
        self.move("frame", Keys.END)
        before, highest = self.picture(), self.element("highest").get_attribute("value")
        Select(self.element("field")).select_by_index(1)
        self.expect_change(before)
        self.assertNotEqual(highest, self.element("highest").get_attribute("value"))

    def test_a_cut_opens_the_body_and_moves(self):
        self.open(self.solid)
        whole = self.picture()
        self.assertFalse(self.element("place").is_displayed())
        Select(self.element("cut")).select_by_visible_text("x")
        opened = self.expect_change(whole)
        self.move("place", Keys.ARROW_LEFT * 10)
        moved = self.expect_change(opened)
        self.element("flip").click()
        other = self.expect_change(moved)
        Select(self.element("cut")).select_by_visible_text("none")
        self.expect_change(other)

    def test_keys_turn_the_body_and_reset_turns_it_back(self):
        self.open(self.solid)
        before = self.picture()
        self.element("canvas").send_keys(Keys.ARROW_RIGHT * 3, Keys.ARROW_UP, "+")
        self.expect_change(before)
        self.element("reset").click()
        self.wait(lambda: self.picture() == before)

    def test_a_body_that_turns_slowly_has_fewer_pixels_and_triangles_until_it_rests(self):
        self.open(self.solid)
        self.browser.execute_script(RECORD_PICTURES)
        full = self.picture()

        def drawn():
            """Width and triangles of the last picture."""
            return self.browser.execute_script("return drawn.at(-1)")

        self.element("canvas").send_keys(Keys.ARROW_RIGHT)
        self.wait(drawn)
        sharp = drawn()
        self.browser.execute_script("let now = 0; performance.now = () => (now += 100);")  # every picture takes long
        ActionChains(self.browser).click_and_hold(self.element("canvas")).perform()

        def is_rough():
            ActionChains(self.browser, duration=20).move_by_offset(3, 1).perform()
            least = self.browser.execute_script("return [0, 1].map((i) => Math.min(...drawn.map((one) => one[i])))")
            return least[0] < 0.5 * sharp[0] and least[1] < sharp[1]

        self.wait(is_rough)
        self.wait(lambda: drawn() == sharp)  # the body rests, though still held
        ActionChains(self.browser).release().perform()
        self.element("reset").click()
        self.wait(lambda: self.picture() == full)

    def test_a_click_on_a_plot_goes_to_its_time(self):
        self.open(self.solid)
        self.assertIn("tip", self.browser.find_element(By.CSS_SELECTOR, ".plot h2").text)
        before = self.element("time").text
        self.browser.find_element(By.CSS_SELECTOR, ".plot .u-over").click()
        self.wait(lambda: self.element("time").text != before)
        self.assertEqual("3", self.element("frame").get_attribute("value"), "a click in the middle")

    def test_play_moves_through_the_frames(self):
        self.open(self.solid)
        before = self.element("time").text
        self.element("play").click()
        self.wait(lambda: self.element("time").text != before)
        self.element("play").click()
        self.assertEqual("Play", self.element("play").text)

    def test_tables_and_plots_are_those_of_the_summary(self):
        self.open(self.plane)
        summary = json.loads((self.folder / "rotating_cylinder/summary.json").read_text())
        text = self.element("tables").text
        for name in [*summary["phases"], *(name.replace("_", " ") for name in summary["measurements"])]:
            self.assertIn(name, text)
        plots = self.browser.find_elements(By.CSS_SELECTOR, ".plot")
        self.assertEqual(len(summary["measurements"]), len(plots))

    def test_a_batch_has_a_point_for_each_run(self):
        sweep = self.folder / "sweep.toml"
        sweep.write_text(f'''case = "{SOURCE}/cases/rotating_cylinder"
set = ["discretisation.spacing=0.1", "time.step=0.001", "time.end=0.02", "output.every=0.01"]
[[design]]
parameters."body.cylinder.material.poissons_ratio" = [0.2, 0.4]
parameters."body.cylinder.material.youngs_modulus" = [50, 100]
''')
        out = self.folder / "sweep"
        subprocess.run([PROGRAM, "batch", sweep, "--quiet", "--out", out], check=True)
        subprocess.run([PROGRAM, "report", out], check=True, stdout=subprocess.DEVNULL)
        self.browser.get((out / "report.html").as_uri())
        self.wait(lambda: len(self.browser.find_elements(By.CSS_SELECTOR, "tbody tr")) == 4)
        # The second plot is that of the energy; the angular momentum is the same in all runs.
        canvas = self.browser.find_elements(By.CSS_SELECTOR, ".plot canvas")[1]
        self.wait(lambda: self.browser.execute_script(COUNT_SPOTS, canvas, [31, 111, 159], 10) == 4)

    def sheet_of(self, page, wishes):
        """The element with the picture."""
        self.browser.get("about:blank")
        self.browser.get(f"{page}#picture&{wishes}")
        self.wait(lambda: self.browser.find_element(By.TAG_NAME, "body").get_attribute("data-ready") == "yes")
        return self.element("picture")

    def test_a_picture_says_when_it_is_ready(self):
        sheet = self.sheet_of(self.solid, "size=600,400&times=0,0.03&field=velocity&cut=y")
        colours, _ = self.browser.execute_async_script(READ_PICTURE, sheet.screenshot_as_base64)
        self.assertGreater(colours, 30)

    def test_the_face_of_a_cut_has_no_holes_beside_walls(self):
        page = self.page_of("docs/boundaries/moving_wall.toml")
        for view in ("-60,25", "-80,25"):
            sheet = self.sheet_of(page, f"size=600,500&times=2&field=displacement&cut=y&walls=1&view={view}")
            floor = self.browser.execute_script(COUNT_SPOTS, sheet, [174, 181, 191], 30)
            self.assertEqual(2, floor, "it shows on both sides of the body, and not through it")


def main():
    if not (webdriver and shutil.which("chromium") and shutil.which("chromedriver")):
        print("Chromium, its driver or Selenium are missing")
        return SKIPPED
    global BROWSER
    try:
        BROWSER = open_browser()
    except WebDriverException as error:
        print("Chromium does not start here:", error)
        return SKIPPED
    del sys.argv[1:3]
    unittest.main()


if __name__ == "__main__":
    sys.exit(main())
