#!/bin/sh
# Types and runs the commands of the recording in README. To make it anew, with Debian's termtosvg:
#   sleep 60 | termtosvg docs/figures/terminal.svg -c 'sh docs/figures/terminal.sh build' -g 132x44 -t window_frame -m 40 -M 2500 -D 4000
# Its argument is the folder of the program.
set -eu
program=$(cd "$1" && pwd)
PATH="$program:$PATH"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

run() { # types a command, letter by letter, and runs it
  printf '\033[32m$\033[0m '
  left=$1
  while [ -n "$left" ]; do
    rest=${left#?}
    printf '%s' "${left%"$rest"}"
    left=$rest
    sleep 0.03
  done
  sleep 0.4
  printf '\n'
  sh -c "$1" 2>&1
  sleep "$2"
}

run "upbead new mine.toml --width 20 --height 17     # a commented case of a caisson of one's own" 2
run "upbead run mine.toml" 8
