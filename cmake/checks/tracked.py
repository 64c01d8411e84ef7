"""The files of the project, and how a check reports what it found in them."""

import subprocess
import sys
from pathlib import Path

NOT_OURS = {"build", "results", ".git"}


def files(root):
    """Paths relative to `root` of what git tracks; without git, of everything but build output."""
    listing = None
    if (root / ".git").exists():
        try:
            listing = subprocess.run(
                ["git", "-c", "safe.directory=*", "-C", root, "ls-files", "-z"],
                capture_output=True, check=True, text=True).stdout
        except (OSError, subprocess.CalledProcessError):
            pass
    if listing is not None:
        found = (Path(name) for name in listing.split("\0") if name)
    else:
        found = (path.relative_to(root) for path in root.rglob("*"))
        found = (path for path in found if path.parts[0] not in NOT_OURS)
    return sorted(path for path in found if (root / path).is_file())


def lines(root, path):
    """Numbered lines of a text file; none of a binary one."""
    try:
        return list(enumerate((root / path).read_text(encoding="utf-8").splitlines(), start=1))
    except UnicodeDecodeError:
        return []


def main(check):
    """Runs `check(root)`, which yields one message for each problem, on the folder given."""
    problems = list(check(Path(sys.argv[1]).resolve()))
    print("\n".join(problems) if problems else "nothing found")
    sys.exit(1 if problems else 0)
