#!/usr/bin/python3
"""No source file above 600 lines, a median below 150, no C++ function of more than 50: one idea per file, and per
function."""

import pathlib
import re
import statistics
import sys

LONGEST, MEDIAN, LONGEST_FUNCTION = 600, 150, 50
# clang-format puts the end of a function's head at the end of a line; the body ends with the first closing brace that
# is not indented further than the head
HEAD = re.compile(r"^( {0,4})[^ #/}].*(\)( const)?( noexcept)?( override)?( try)? \{$|^.*\) : .*\{$)")
OTHER = re.compile(r"^ *(if|for|while|switch|else|do|catch|namespace)\b|= \[")


def functions(path):
    """First line and number of lines of the body of each function of a C++ file."""
    lines = path.read_text().splitlines()
    for first, line in enumerate(lines):
        head = HEAD.match(line)
        if not head or OTHER.search(line):
            continue
        end = re.compile("^ {0,%d}}" % len(head.group(1)))
        for last in range(first + 1, len(lines)):
            if end.match(lines[last]):
                yield first + 1, last - first - 1
                break


def main():
    root = pathlib.Path(sys.argv[1])
    lengths = {
        path: len(path.read_text().splitlines())
        for folder in ("include", "src", "tests", "postprocess")
        for path in (root / folder).rglob("*")
        if path.suffix in (".h", ".cc", ".py")
    }
    long = [f"{path}: {n} lines, more than {LONGEST}" for path, n in lengths.items() if n > LONGEST]
    median = statistics.median(lengths.values())
    if median > MEDIAN:
        long.append(f"the median file has {median} lines, more than {MEDIAN}")
    sources = [path for path in lengths if path.suffix != ".py" and (root / "tests") not in path.parents]
    bodies = [(path, line, n) for path in sources for line, n in functions(path)]
    long += [f"{path}:{line}: a function of {n} lines, more than {LONGEST_FUNCTION}" for path, line, n in bodies
             if n > LONGEST_FUNCTION]
    print("\n".join(long) or f"lengths: {len(lengths)} files, median {median}, longest {max(lengths.values())}; "
          f"{len(bodies)} functions, longest {max(n for *_, n in bodies)}")
    return bool(long)


if __name__ == "__main__":
    sys.exit(main())
