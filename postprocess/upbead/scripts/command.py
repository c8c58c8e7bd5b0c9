"""The command `upbead` of a wheel: it becomes the program that the wheel has inside."""

import os
import sys
from typing import NoReturn

from ..errors import UserError
from ..program import environment, find


def main() -> NoReturn:
    try:
        program = find()
    except UserError as error:
        print(f"upbead: {error}", file=sys.stderr)
        sys.exit(1)
    os.execve(program, [program, *sys.argv[1:]], environment(program))
