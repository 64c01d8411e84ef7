"""engine/report/bundle/page.html is what page/bundle.js makes of the sources and the locked libraries."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
REPORT = Path(sys.argv[1]).resolve() / "engine/report"


def main():
    if not shutil.which("npm"):
        print("npm is missing")
        return SKIPPED
    with tempfile.TemporaryDirectory() as scratch:
        page = Path(scratch) / "page"
        shutil.copytree(REPORT / "page", page, ignore=shutil.ignore_patterns("node_modules"))
        installed = subprocess.run(["npm", "ci", "--no-audit", "--no-fund"], cwd=page, capture_output=True, text=True)
        if installed.returncode != 0:
            print("the libraries cannot be installed, perhaps for want of a network:", installed.stderr)
            return SKIPPED
        made = Path(scratch) / "page.html"
        subprocess.run(["node", "bundle.js", made], cwd=page, check=True)
        if made.read_bytes() == (REPORT / "bundle/page.html").read_bytes():
            return 0
    print("bundle/page.html is not what page/ makes; run `npm ci && npm run bundle` in engine/report/page")
    return 1


if __name__ == "__main__":
    sys.exit(main())
