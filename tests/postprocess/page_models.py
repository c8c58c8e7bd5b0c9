"""Models, pages and results that the tests of the page use."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np

SCRIPTS, PROGRAM, CASES = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(SCRIPTS))

# Sets a page's controls to {key: text}, waits until the error is shown, and returns the numbers, wave and histories
# shown.
ASK = """async (settings) => {
  const saved = [], click = HTMLAnchorElement.prototype.click, address = URL.createObjectURL;
  HTMLAnchorElement.prototype.click = () => {};
  URL.createObjectURL = (blob) => { saved.push(blob.text()); return "data:,"; };
  for (const key in settings) {
    const control = document.querySelector(`[data-key="${key}"]`);
    control.value = settings[key];
  }
  for (const key in settings) document.querySelector(`[data-key="${key}"]`).dispatchEvent(new Event("input"));
  const wrong = document.querySelector(".wrong").textContent, numbers = {};
  if (wrong) return {wrong};
  while (!document.querySelector('data[data-key="error_estimate"]')) await new Promise((done) => setTimeout(done, 10));
  for (const item of document.querySelectorAll(".whatif data")) numbers[item.dataset.key] = JSON.parse(item.value);
  for (const button of [...document.querySelectorAll(".saves button")].slice(0, 2)) button.click();
  const [histories, wave] = await Promise.all(saved);
  HTMLAnchorElement.prototype.click = click;
  URL.createObjectURL = address;
  return {numbers, histories, wave, wrong};
}"""


def call(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return done.stdout


def reduced(case, folder, *settings):
    """Makes a reduced model; returns its file."""
    call("reduce", CASES / case, "--out", folder, *(word for setting in settings for word in ("--set", setting)))
    return folder / "reduced.h5"


def voided(model, copy, name="implausible"):
    """A copy of a model of a scene of which no verdict may be drawn."""
    changed(model, copy)
    with h5py.File(copy, "r+") as file:
        if "warnings" in file:
            del file["warnings"]
        for key in ("name", "what", "cure"):
            file[f"warnings/{key}"] = [np.bytes_(name if key == "name" else f"{key} of it")]
        file["warnings/number"] = [[1.0, 2.0, 1.0]]
    return copy


def changed(model, copy, **sliding):
    """A copy of a model with another table [sliding]; without its checksum, as older versions wrote them."""
    copy.write_bytes(model.read_bytes())
    with h5py.File(copy, "r+") as file:
        file.attrs.pop("checksum", None)
        for key, value in sliding.items():
            file["sliding"].attrs[key] = np.bytes_(value) if isinstance(value, str) else value
    return copy


def respond(model, waves, out, *options):
    """(numbers of each wave, file of histories) by the program."""
    summary = json.loads(call("respond", model, *waves, "--json", "--out", out, *options))
    return {wave["name"]: wave for wave in summary["waves"]}, out / "responses.h5"


def ask(browser, settings):
    return browser.value(f"({ASK})({json.dumps(settings)})")


def axe(folder):
    """The file of axe-core, or None if npm cannot fetch it."""
    npm = shutil.which("npm")
    if npm is None:
        return None
    try:
        subprocess.run([npm, "install", "--prefix", folder, "axe-core@4"], capture_output=True, check=True, timeout=120)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None
    return folder / "node_modules/axe-core/axe.min.js"


def violations(browser, source):
    """Findings of axe-core in the open page: rules, each with its first element."""
    browser.value(source.read_text() + "; 0")
    value = "violations.map(({id, nodes}) => id + ': ' + nodes[0].html)"
    found, held = browser.value(f"axe.run().then(({{violations, passes}}) => [{value}, passes.length])")
    if held <= 20:
        raise AssertionError(f"only {held} rules were looked at")
    return found
