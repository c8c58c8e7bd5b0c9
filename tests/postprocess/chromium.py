"""Drives Chromium without a window over its DevTools pipe: JSON messages that end with a zero byte.

https://chromedevtools.github.io/devtools-protocol/; the pipe is file descriptors 3 (to Chromium) and 4 (from it).
"""

import base64
import json
import os
import select
import subprocess
import tempfile
import time


class Browser:
    """One page in a Chromium of its own; `problems` are errors and warnings of its console, `requests` the addresses that it asked
    for while the domain Network is enabled."""

    def __init__(self, program, options, seconds=60):
        self.seconds, self.buffer, self.count, self.problems, self.events = seconds, b"", 0, [], []
        self.requests = []
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        read_end, self.write_end = os.pipe()
        self.read_end, write_end = os.pipe()

        def wire():
            # Copied first, as either end may already be descriptor 3 or 4.
            incoming, outgoing = os.dup(read_end), os.dup(write_end)
            os.dup2(incoming, 3)
            os.dup2(outgoing, 4)

        self.process = subprocess.Popen(
            [program, *options(self.profile.name), "--remote-debugging-pipe", "about:blank"],
            preexec_fn=wire,
            close_fds=False,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(read_end)
        os.close(write_end)
        target = self._send("Target.createTarget", {"url": "about:blank"})["targetId"]
        self.session = self._send("Target.attachToTarget", {"targetId": target, "flatten": True})["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(self.seconds)
        os.close(self.write_end)
        os.close(self.read_end)
        self.profile.cleanup()

    def call(self, method, **parameters):
        return self._send(method, parameters, self.session)

    def _send(self, method, parameters, session=None):
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        os.write(self.write_end, json.dumps(message).encode() + b"\0")
        number = self.count
        while True:
            answer = self._receive()
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def _receive(self):
        until = time.monotonic() + self.seconds
        while b"\0" not in self.buffer:
            if not select.select([self.read_end], [], [], max(0.0, until - time.monotonic()))[0]:
                raise TimeoutError(f"Chromium said nothing for {self.seconds} s")
            piece = os.read(self.read_end, 1 << 20)
            if not piece:
                raise RuntimeError("Chromium has ended")
            self.buffer += piece
        text, self.buffer = self.buffer.split(b"\0", 1)
        message = json.loads(text)
        self._note(message)
        return message

    def _note(self, message):
        self.events.append(message.get("method"))
        found = message.get("params") or {}
        if message.get("method") == "Network.requestWillBeSent":
            self.requests.append(found["request"]["url"])
        elif message.get("method") == "Runtime.exceptionThrown":
            details = found["exceptionDetails"]
            self.problems.append(details.get("exception", {}).get("description") or details["text"])
        elif message.get("method") == "Runtime.consoleAPICalled" and found["type"] in ("error", "warning", "assert"):
            self.problems.append(str([item.get("value") for item in found["args"]]))
        elif message.get("method") == "Log.entryAdded" and found["entry"]["level"] in ("error", "warning"):
            self.problems.append(found["entry"]["text"])

    def open(self, path, width, height=900, dark=False, scripts=True):
        """Opens a file in a window of that size (CSS pixels) and waits until its scripts, if allowed, have run."""
        self.call(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600
        )
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.call("Emulation.setEmulatedMedia", features=[scheme])
        self.call("Emulation.setScriptExecutionDisabled", value=not scripts)
        self.events.clear()
        self.call("Page.navigate", url=path.resolve().as_uri())
        while "Page.loadEventFired" not in self.events:
            self._receive()
        if scripts:
            self.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")

    def value(self, script, session=None):
        """The value of an expression in the page or in the session of a frame; promises are awaited."""
        asked = {"expression": script, "returnByValue": True, "awaitPromise": True}
        answer = self._send("Runtime.evaluate", asked, session or self.session)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"]["exception"].get("description"))
        return answer["result"].get("value")

    def frame(self):
        """The session of the page's frame, which has a process of its own because it is sandboxed."""
        until = time.monotonic() + self.seconds
        while time.monotonic() < until:
            frames = [target for target in self._send("Target.getTargets", {})["targetInfos"] if target["type"] == "iframe"]
            if frames:
                return self._send("Target.attachToTarget", {"targetId": frames[0]["targetId"], "flatten": True})["sessionId"]
            time.sleep(0.05)
        raise TimeoutError(f"no frame of its own process after {self.seconds} s")

    def mouse(self, kind, x, y, **more):
        self.call(
            "Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left" if kind != "mouseWheel" else "none", **more
        )

    def picture(self, path):
        """The whole page as a PNG."""
        image = self.call(
            "Page.captureScreenshot",
            captureBeyondViewport=True,
            clip=self.value(
                "(({clientWidth, scrollHeight}) => ({x: 0, y: 0, scale: 1, width: clientWidth, height: scrollHeight}))"
                "(document.documentElement)"
            ),
        )
        path.write_bytes(base64.b64decode(image["data"]))
