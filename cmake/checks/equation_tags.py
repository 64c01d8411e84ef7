"""Every equation tag, such as two letters, a point and a number, that a file cites is the first
cell of exactly one row of the tables in docs/*.md: | (tag) | equation | source |
"""

import re

import tracked

DEFINITION = re.compile(r"\|\s*\(([A-Z]{2}\.\d+)\)\s*\|")
CITATION = re.compile(r"\b[A-Z]{2}\.\d+\b")
CITING = {".hpp", ".cpp", ".md", ".toml", ".txt", ".cmake"}


def check(root):
    defined = {}
    cited = []
    for path in tracked.files(root):
        if path.suffix not in CITING:
            continue
        is_docs_page = path.parts[0] == "docs" and len(path.parts) == 2 and path.suffix == ".md"
        for number, line in tracked.lines(root, path):
            place = f"{path}:{number}"
            if is_docs_page and (match := DEFINITION.match(line)):
                if match[1] in defined:
                    yield f"{place}: ({match[1]}) is already the equation at {defined[match[1]]}"
                defined[match[1]] = place
            cited += [(place, tag) for tag in CITATION.findall(line)]
    for place, tag in cited:
        if tag not in defined:
            yield f"{place}: ({tag}) is not in the equation tables of docs/*.md"


if __name__ == "__main__":
    tracked.main(check)
