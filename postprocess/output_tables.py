"""Writes the program's descriptions of the keys of its summaries into pages and the package.

    /usr/bin/python3 postprocess/output_tables.py build/upbead

The tables between `<!-- upbead explain --outputs: COMMAND -->` and `<!-- end -->` of docs/*.md, and upbead/outputs.json with
unit and meaning of each key.
"""

import argparse
import json
import re
import subprocess
from pathlib import Path

import common  # noqa: F401: its hook shows errors without a traceback

HERE = Path(__file__).resolve().parent
TABLES = re.compile(r"(<!-- upbead explain --outputs: (\w+) -->\n).*?(?=<!-- end -->\n)", re.DOTALL)


def asked(program, option):
    return subprocess.run([program, "explain", option], check=True, capture_output=True, text=True).stdout


def files(program):
    """{path: text as it should be}"""
    found = re.split(r"^## summary.json of `upbead (\w+)`\n", asked(program, "--outputs"), flags=re.MULTILINE)[1:]
    tables = dict(zip(found[::2], found[1::2]))
    made = {}
    for path in sorted((HERE.parent / "docs").glob("*.md")):
        text = path.read_text(encoding="utf-8")
        if TABLES.search(text):
            made[path] = TABLES.sub(lambda match: match[1] + tables[match[2]].rstrip("\n") + "\n\n", text)
    commands = json.loads(asked(program, "--outputs-json"))
    blocks = (f'"{command}": {{\n' + ",\n".join(f"{json.dumps(key)}: {json.dumps(row)}" for key, row in keys.items()) + "\n}"
              for command, keys in commands.items())
    made[HERE / "upbead" / "outputs.json"] = "{" + ",\n".join(blocks) + "}\n"
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("program", help="the program, such as build/upbead")
    for path, text in files(parser.parse_args().program).items():
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
