"""Relative links and pictures of every Markdown page lead to a file."""

import re

import tracked

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)\s]*)?\)")
ELSEWHERE = re.compile(r"[a-z]+:")


def check(root):
    for path in tracked.files(root):
        if path.suffix != ".md":
            continue
        for number, line in tracked.lines(root, path):
            for target in LINK.findall(re.sub(r"`[^`]*`", "", line)):
                if not ELSEWHERE.match(target) and not (root / path.parent / target).exists():
                    yield f"{path}:{number}: {target}: the link leads nowhere"


if __name__ == "__main__":
    tracked.main(check)
