#!/usr/bin/python3
"""Writes the manual pages and the bash completion, both from the output of the program's --help.

usage: help_pages.py PROGRAM FOLDER

FOLDER/man1/upbead.1, one page a command (upbead-run.1 ...), and FOLDER/upbead, which bash-completion reads.
"""

import pathlib
import re
import subprocess
import sys

OPTION = re.compile(r"^  (?:-\w,)?(--[\w-]+)", re.MULTILINE)
COMPLETION = """# completion of upbead's commands and options, made from its --help; files elsewhere
_upbead() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" words="{commands} {general}"
  if [ "$COMP_CWORD" -gt 1 ]; then
    case "${{COMP_WORDS[1]}}" in
{cases}
      *) words="" ;;
    esac
    [[ "$word" == -* ]] || words=""
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -o default -F _upbead upbead
"""


def help_of(program, *command):
    done = subprocess.run([program, *command, "--help"], capture_output=True, text=True, check=True)
    return done.stdout.replace(str(program), "upbead")


def commands_of(text):
    listed = text.split("Subcommands:\n")[1].split("\n\n")[0]
    return dict(line.split(None, 1) for line in listed.splitlines())


def man_page(name, what, text, version):
    """The help text unchanged, after the NAME section that `man` and `apropos` need and before SEE ALSO."""
    shown = re.sub(r"^(?=[.'])", r"\\&", text.replace("\\", "\\e").replace("-", "\\-"), flags=re.MULTILINE)
    title = name.replace(" ", "-")
    more = "upbead\\-run(1), and the pages in /usr/share/upbead/docs" if name == "upbead" else "upbead(1)"
    return (f'.TH {title.upper()} 1 "" "{version}" "User Commands"\n.SH NAME\n{title} \\- {what}\n'
            f".SH DESCRIPTION\n.nf\n{shown.rstrip()}\n.fi\n.SH SEE ALSO\n{more}\n")


def main():
    program, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0]
    general = help_of(program)
    commands = commands_of(general)
    pages = {"upbead": ("shear force and sliding of caissons under impulsive waves", general)}
    pages.update({f"upbead {command}": (what, help_of(program, command)) for command, what in commands.items()})
    (folder / "man1").mkdir(parents=True, exist_ok=True)
    for name, (what, text) in pages.items():
        (folder / "man1" / (name.replace(" ", "-") + ".1")).write_text(man_page(name, what, text, version))
    cases = "\n".join(f'      {command}) words="{" ".join(OPTION.findall(pages["upbead " + command][1]))}" ;;'
                      for command in commands)
    (folder / "upbead").write_text(
        COMPLETION.format(commands=" ".join(commands), general=" ".join(OPTION.findall(general)), cases=cases))


if __name__ == "__main__":
    main()
