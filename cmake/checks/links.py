"""Relative links and pictures of every Markdown page lead to a file, and so do names of sources."""

import re

import tracked

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)\s]*)?\)")
ELSEWHERE = re.compile(r"[a-z]+:")
SOURCE = re.compile(r"`([\w/.-]+\.[ch]pp)`")
PLACEHOLDER = "NAME"


def check(root):
    files = tracked.files(root)
    sources = [f"/{path.as_posix()}".removesuffix(".in") for path in files]
    for path in files:
        if path.suffix != ".md":
            continue
        for number, line in tracked.lines(root, path):
            for name in SOURCE.findall(line):
                if PLACEHOLDER not in name and not any(s.endswith(f"/{name}") for s in sources):
                    yield f"{path}:{number}: {name}: there is no such source"
            for target in LINK.findall(re.sub(r"`[^`]*`", "", line)):
                if not ELSEWHERE.match(target) and not (root / path.parent / target).exists():
                    yield f"{path}:{number}: {target}: the link leads nowhere"


if __name__ == "__main__":
    tracked.main(check)
