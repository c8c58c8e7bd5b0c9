"""`upbead respond MODEL WAVES --soil -` as a child process that answers one soil after the other."""

import json
import os
import shutil
import subprocess
import tempfile
import threading

from .errors import CaseError, NumericsError, UpbeadError
from .program import environment


class SoilServer:
    """One child. Where anything disturbs it between a question and its answer, it is ended, as its next line would be the
    answer to another soil."""

    def __init__(self, command, folder=None):
        self.pid, self.folder, self.told = os.getpid(), folder, tempfile.TemporaryFile()
        # a group of its own: Ctrl-C is for Python, and its child ends with its input
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.told, text=True,
                                        encoding="utf-8", start_new_session=True, env=environment(command[0]))

    def ask(self, soil):
        """The answer to {key: value}, a dict."""
        try:
            line = self.exchange(json.dumps(soil, allow_nan=False))
        except BaseException:
            self.close()
            raise
        self.forget_folder()
        return json.loads(line)

    def exchange(self, question):
        try:
            self.process.stdin.write(question + "\n")
            self.process.stdin.flush()
            line = self.process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line.endswith("\n"):
            raise self.failure()
        return line

    def failure(self):
        """The error of a child that ended by itself, with its own text."""
        code = self.process.wait()
        self.told.seek(0)
        text = self.told.read().decode(errors="replace").strip()
        kind = {1: CaseError, 2: NumericsError}.get(code, UpbeadError)
        return kind(text if kind is not UpbeadError and text else f"upbead respond ended with exit code {code}\n{text}")

    def forget_folder(self):
        """The folder of a wave that was given as arrays is read once the first soil is answered."""
        if self.folder:
            shutil.rmtree(self.folder, ignore_errors=True)
            self.folder = None

    def close(self):
        """Ends the child; in a fork of the process that started it, leaves it alone."""
        own = self.pid == os.getpid()
        if own and self.process.poll() is None:
            self.process.kill()
        for stream in (self.process.stdin, self.process.stdout, self.told):
            try:
                stream.close()
            except BrokenPipeError:
                pass
        if own:
            self.process.wait()
            self.forget_folder()
        else:
            self.process.returncode = 0  # it is no child of this process, which has none to wait for


class SoilServers:
    """Up to `jobs` servers of the same waves, begun when they are needed; for several threads."""

    def __init__(self, begin, jobs):
        self.begin, self.slots, self.lock, self.idle = begin, threading.Semaphore(jobs), threading.Lock(), []

    def ask(self, soil):
        with self.slots:
            with self.lock:
                server = self.idle.pop() if self.idle else None
            server = server or self.begin()
            answer = server.ask(soil)  # a server that fails has ended, and another one begins with the next question
            with self.lock:
                self.idle.append(server)
            return answer

    def close(self):
        with self.lock:
            for server in self.idle:
                server.close()
            self.idle = []
