"""Writes the program's descriptions of the keys of its summaries into pages and the package.

    /usr/bin/python3 postprocess/output_tables.py build/upbead

That is a page docs/reference/summary-COMMAND.md for each command, and upbead/outputs.json with unit and meaning of each key.
"""

import argparse
import json
import re
import subprocess
from pathlib import Path

import common  # noqa: F401: its hook shows errors without a traceback
from pages.reference import from_reference

HERE = Path(__file__).resolve().parent
REFERENCE = HERE.parent / "docs/reference"
HEAD = """# summary.json of `upbead {command}`

For those who read its numbers by a program: every key with its unit. A value that does not exist is null. Printed by
`upbead explain --outputs`; [what a run writes](../output.md) has the other files.

"""


def asked(program, option):
    return subprocess.run([program, "explain", option], check=True, capture_output=True, text=True).stdout


def files(program):
    """{path: text as it should be}"""
    found = re.split(r"^## summary.json of `upbead (\w+)`\n", asked(program, "--outputs"), flags=re.MULTILINE)[1:]
    made = {REFERENCE / f"summary-{command}.md": HEAD.format(command=command) + from_reference(tables).strip("\n") + "\n"
            for command, tables in zip(found[::2], found[1::2])}
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
