#!/usr/bin/python3
"""No source file above 600 lines, and a median below 150: one idea per file."""

import pathlib
import statistics
import sys

LONGEST, MEDIAN = 600, 150


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
    print("\n".join(long) or f"lengths: {len(lengths)} files, median {median}, longest {max(lengths.values())}")
    return bool(long)


if __name__ == "__main__":
    sys.exit(main())
