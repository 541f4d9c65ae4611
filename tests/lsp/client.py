"""A client of `mansard lsp`: a real process, real frames over its standard input and output."""
import json
import os
import select
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = os.environ.get("MANSARD", "mansard")
PATIENCE = 30  # seconds; only a hang takes so long


class Refused(Exception):
    def __init__(self, error):
        super().__init__(f"{error['code']}: {error['message']}")
        self.code = error["code"]
        self.message = error["message"]


class Client:
    def __init__(self, *arguments, start=True, folder=None, encodings=None, snippets=True):
        self.process = subprocess.Popen([PROGRAM, "lsp", *arguments], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.buffer = b""
        self.next_id = 0
        self.notices = []  # that came while something else was waited for
        self.diagnostics = {}  # by URI, the last said
        if start:
            self.start(folder, encodings, snippets)

    def start(self, folder=None, encodings=None, snippets=True):
        capabilities = {"textDocument": {"completion": {"completionItem": {
            "snippetSupport": snippets}}}}
        if encodings:
            capabilities["general"] = {"positionEncodings": encodings}
        self.capabilities = self.request("initialize", {
            "processId": os.getpid(), "rootUri": uri_of(folder) if folder else None,
            "capabilities": capabilities})["capabilities"]
        self.notify("initialized", {})

    # ---- frames

    def raw(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        text = json.dumps(message).encode()
        self.raw(b"Content-Length: %d\r\n\r\n%s" % (len(text), text))

    def receive(self, seconds=PATIENCE):
        """The next message; None when none comes in time or the server ended."""
        end = time.monotonic() + seconds
        while True:
            header, found, rest = self.buffer.partition(b"\r\n\r\n")
            if found:
                if not header.startswith(b"Content-Length: "):
                    raise AssertionError(f"no header on standard output: {self.buffer[:200]}")
                length = int(header[16:])
                if len(rest) >= length:
                    self.buffer = rest[length:]
                    return json.loads(rest[:length])
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.process.stdout], [], [], left)[0]:
                return None
            data = os.read(self.process.stdout.fileno(), 1 << 16)
            if not data:
                return None
            self.buffer += data

    # ---- messages

    def notify(self, method, params=None):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def request(self, method, params=None):
        self.next_id += 1
        self.send({"jsonrpc": "2.0", "id": self.next_id, "method": method, "params": params})
        return self.answer(self.next_id)

    def answer(self, number):
        while True:
            message = self.receive()
            if message is None:
                raise AssertionError("no answer; the server said: " + self.last_words())
            assert message["jsonrpc"] == "2.0", message
            if message.get("id") == number and "method" not in message:
                if "error" in message:
                    raise Refused(message["error"])
                return message["result"]
            self.keep(message)

    def keep(self, message):
        if message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"]
        self.notices.append(message)

    def settle(self):
        """All diagnostics that are to come, by URI."""
        while message := self.receive(0.4):
            self.keep(message)
        return self.diagnostics

    def published(self, uri):
        """The next diagnostics of this file."""
        while True:
            message = self.receive()
            assert message is not None, "no diagnostics; the server said: " + self.last_words()
            self.keep(message)
            if message.get("method") == "textDocument/publishDiagnostics" and \
                    message["params"]["uri"] == uri:
                return message["params"]["diagnostics"]

    # ---- life

    def last_words(self):
        self.process.kill()
        return self.process.communicate()[1].decode(errors="replace")

    def stop(self):
        """The exit status after an orderly end."""
        self.request("shutdown")
        self.notify("exit")
        return self.end()

    def end(self):
        """Closes the server's input; its exit status."""
        try:
            self.process.stdin.close()
        except BrokenPipeError:
            pass
        status = self.process.wait(PATIENCE)
        self.errors = self.process.stderr.read().decode(errors="replace")
        for stream in (self.process.stdout, self.process.stderr):
            stream.close()
        return status


def uri_of(path):
    return Path(path).resolve().as_uri()


def position(text, needle, number=0, behind=0, unit="utf-16"):
    """Where the needle stands for the number-th time (and `behind` characters into it)."""
    at = -1
    for _ in range(number + 1):
        at = text.index(needle, at + 1)
    before = text[:at + behind]
    line = before.rsplit("\n", 1)[-1]
    width = len(line.encode("utf-16-le")) // 2 if unit == "utf-16" else len(line.encode())
    return {"line": before.count("\n"), "character": width}


def stretch(text, needle, number=0, unit="utf-16"):
    return {"start": position(text, needle, number, 0, unit),
            "end": position(text, needle, number, len(needle), unit)}


def edited(text, edits):
    """The text after the edits of a client, from the last to the first."""
    lines = text.split("\n")
    for edit in sorted(edits, key=lambda e: (e["range"]["start"]["line"],
                                             e["range"]["start"]["character"]), reverse=True):
        start, end = edit["range"]["start"], edit["range"]["end"]
        head = lines[start["line"]][:start["character"]]
        tail = lines[end["line"]][end["character"]:]
        lines[start["line"]:end["line"] + 1] = (head + edit["newText"] + tail).split("\n")
    return "\n".join(lines)


class Case(unittest.TestCase):
    """A server over a folder of scripts, those named in `open` open in the editor."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name).resolve()
        self.texts = {}
        self.client = None

    def tearDown(self):
        if self.client and self.client.process.poll() is None:
            self.assertEqual(self.client.stop(), 0)
            self.assertEqual(self.client.errors, "")

    def write(self, **files):
        for name, text in files.items():
            name = name.replace("__", "/") + ".style"
            self.texts[name] = text
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text, encoding="utf-8")

    def serve(self, *names, **options):
        self.client = Client(folder=self.folder, **options)
        for name in names:
            self.open(name)

    def uri(self, name):
        return uri_of(self.folder / name)

    def open(self, name, text=None):
        self.texts[name] = self.texts[name] if text is None else text
        self.client.notify("textDocument/didOpen", {"textDocument": {
            "uri": self.uri(name), "languageId": "mansard", "version": 1,
            "text": self.texts[name]}})

    def change(self, name, text, version=2):
        self.texts[name] = text
        self.client.notify("textDocument/didChange", {
            "textDocument": {"uri": self.uri(name), "version": version},
            "contentChanges": [{"text": text}]})

    def there(self, name, needle, number=0, behind=0):
        return {"textDocument": {"uri": self.uri(name)},
                "position": position(self.texts[name], needle, number, behind)}

    def ask(self, method, name, needle, number=0, behind=0, **more):
        return self.client.request("textDocument/" + method,
                                   {**self.there(name, needle, number, behind), **more})

    def spot(self, name, needle, number=0):
        return {"uri": self.uri(name), "range": stretch(self.texts[name], needle, number)}

    def places(self, locations):
        """{(file, line, word)} of locations, lines from 1."""
        found = set()
        for at in locations or []:
            name = str(Path(at["uri"].removeprefix("file://")).relative_to(self.folder))
            text = self.texts[name].split("\n")
            start, end = at["range"]["start"], at["range"]["end"]
            self.assertEqual(start["line"], end["line"])
            line = text[start["line"]].encode("utf-16-le")
            word = line[2 * start["character"]:2 * end["character"]].decode("utf-16-le")
            found.add((name, start["line"] + 1, word))
        return found


def main():
    global PROGRAM
    import sys
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and "/" in sys.argv[1]:
        PROGRAM = sys.argv.pop(1)
    unittest.main(module="__main__")
