"""Input that no editor should send: the server says so where it can, and goes on."""
import json
import random

import client
from client import Case, Client, Refused
from scripts import HOUSE

LIVE = {"jsonrpc": "2.0", "id": "alive", "method": "workspace/symbol", "params": {"query": "zzzz"}}


def frame(text):
    return b"Content-Length: %d\r\n\r\n%s" % (len(text), text)


class Garbage(Case):
    def still_alive(self, expected=()):
        """Sends a request; the codes of the errors that came before its answer."""
        codes = []
        self.client.send(LIVE)
        while True:
            message = self.client.receive()
            self.assertIsNotNone(message, self.client.process.poll())
            if message.get("id") == "alive":
                self.assertEqual(message["result"], [])
                break
            if "error" in message:
                self.assertIsNone(message["id"])
                codes.append(message["error"]["code"])
        self.assertEqual(codes, list(expected))

    def setUp(self):
        super().setUp()
        self.serve()

    def test_no_json(self):
        for text in (b"", b"{", b"nonsense", b"\xff\xfe", b'{"id": 1,', b'"\xc3\x28"', b"NaN"):
            self.client.raw(frame(text))
            self.still_alive([-32700])

    def test_json_that_is_no_message(self):
        for text in (b"1", b"null", b"[]", b'"text"', b"{}", b'{"id": 1}', b'{"method": 3}',
                     b'[{"jsonrpc": "2.0", "id": 1, "method": "shutdown"}]'):
            self.client.raw(frame(text))
            self.still_alive([-32600])

    def test_answers_to_nothing_are_dropped(self):
        self.client.send({"jsonrpc": "2.0", "id": 5, "result": {"a": 1}})
        self.client.send({"jsonrpc": "2.0", "id": 6, "error": {"code": 1, "message": ""}})
        self.still_alive()

    def test_text_between_messages(self):
        self.client.raw(b"hello\r\n\r\n{}{}{}")
        self.still_alive([-32700])
        self.client.raw(b"\r\n\r\n   \r\n")
        self.still_alive()

    def test_wrong_lengths(self):
        text = json.dumps(LIVE).encode()
        self.client.raw(b"Content-Length: 5\r\n\r\n" + text)  # too short
        self.still_alive([-32700, -32700])
        self.client.raw(b"Content-Length: %d\r\n\r\n" % (len(text) + 30) + text)
        self.client.send(LIVE)  # its head was taken for the end of the one before
        self.assertEqual(self.client.receive()["error"]["code"], -32700)
        self.assertEqual(self.client.receive()["id"], "alive")
        for length in (b"-5", b"abc", b"1e3", b"", b"99999999999999999999999999", b"0x10"):
            self.client.raw(b"Content-Length: " + length + b"\r\n\r\n")
            self.still_alive([-32700])

    def test_headers(self):
        text = json.dumps(LIVE).encode()
        for head in (b"content-length: %d\r\n\r\n", b"Content-Length:%d\r\n\r\n",
                     b"Content-Length: %d\r\nContent-Type: application/vscode-jsonrpc\r\n\r\n",
                     b"Content-Type: application/vscode-jsonrpc\r\nContent-Length: %d\r\n\r\n",
                     b"Content-Length: %d\n\n"):
            self.client.raw(head % len(text) + text)
            self.assertEqual(self.client.receive()["id"], "alive", head)

    def test_in_small_pieces(self):
        for byte in frame(json.dumps(LIVE).encode()):
            self.client.raw(bytes([byte]))
        self.assertEqual(self.client.receive()["id"], "alive")

    def test_huge(self):
        self.client.raw(b"Content-Length: 100000000\r\n\r\n")
        for _ in range(100):
            self.client.raw(b"x" * 1_000_000)
        self.still_alive([-32700])
        self.client.raw(frame(b"[" * 3_000_000))
        self.still_alive([-32700])
        self.client.raw(frame(b"[" * 500_000 + b"]" * 500_000))
        self.still_alive([-32600])
        self.client.raw(b"y" * 1_000_000)
        self.still_alive([-32700])

    def test_a_huge_script(self):
        text = HOUSE * 2
        self.texts["house.style"] = ""
        self.open("house.style", text + "/" * 5_000_000)
        found = self.client.published(self.uri("house.style"))
        self.assertIn("larger than", found[0]["message"])
        self.open("deep.style", "style A { B { C -> " + "[ " * 100_000)
        self.assertTrue(self.client.published(self.uri("deep.style")))

    def test_cut_off_in_the_middle(self):
        self.client.raw(b"Content-Length: 400\r\n\r\n{\"jsonrpc\"")
        self.assertEqual(self.client.end(), 1)
        self.assertEqual(self.client.errors, "")

    def test_parameters_of_other_types(self):
        self.write(house=HOUSE)
        self.open("house.style")
        here = {"textDocument": {"uri": self.uri("house.style")},
                "position": {"line": 1, "character": 7}}
        methods = [m for m in ("hover", "definition", "declaration", "implementation", "references",
                               "documentHighlight", "prepareRename", "rename", "completion",
                               "signatureHelp", "documentSymbol", "foldingRange", "codeAction",
                               "formatting")]
        for method in methods:
            for params in (None, [], {}, 3, {"textDocument": 1}, {"textDocument": {"uri": 7}},
                           {**here, "position": []} if method not in
                           ("documentSymbol", "foldingRange", "formatting") else {}):
                with self.assertRaises(Refused, msg=(method, params)) as caught:
                    self.client.request("textDocument/" + method, params)
                self.assertEqual(caught.exception.code, -32602, (method, params))
        self.still_alive()

    def test_notifications_that_fit_nothing(self):
        uri = self.uri("house.style")
        self.client.notify("textDocument/didChange", {
            "textDocument": {"uri": uri, "version": 3}, "contentChanges": [{"text": "x"}]})
        self.client.notify("textDocument/didClose", {"textDocument": {"uri": uri}})
        self.client.notify("textDocument/didSave", {"textDocument": {"uri": uri}})
        self.client.notify("textDocument/didOpen", {"textDocument": {"uri": uri}})
        self.client.notify("textDocument/didOpen", None)
        self.client.notify("workspace/didChangeWorkspaceFolders", {"event": {"added": [3]}})
        self.client.notify("initialized", {})
        self.still_alive()
        self.assertEqual(self.client.diagnostics, {})

    def test_unknown_files(self):
        for uri in (self.uri("missing.style"), "untitled:Untitled-1", "", "%%%", "file://",
                    "file:///", self.folder.as_uri(), "http://example.org/a.style"):
            with self.assertRaises(Refused) as caught:
                self.client.request("textDocument/hover", {
                    "textDocument": {"uri": uri}, "position": {"line": 0, "character": 0}})
            self.assertEqual(caught.exception.code, -32803, uri)

    def test_positions_outside_of_the_text(self):
        self.write(house=HOUSE)
        self.open("house.style")
        for line, character in ((10_000, 0), (2_147_483_647, 2_147_483_647), (3, 5_000),
                                (26, 0), (26, 9)):
            for method in ("hover", "definition", "references", "completion", "signatureHelp",
                           "documentHighlight"):
                self.client.request("textDocument/" + method, {
                    "textDocument": {"uri": self.uri("house.style")},
                    "position": {"line": line, "character": character}})
        for line, character in ((-1, 0), (0, -1), (0.5, 1e99), (2 ** 40, 0)):
            with self.assertRaises(Refused, msg=(line, character)):
                self.client.request("textDocument/hover", {
                    "textDocument": {"uri": self.uri("house.style")},
                    "position": {"line": line, "character": character}})

    def test_random_bytes(self):
        """Damaged messages of every kind; what follows is understood again."""
        dice = random.Random(5)
        whole = frame(json.dumps(LIVE).encode())
        for _ in range(300):
            damaged = bytearray(whole)
            for _ in range(dice.randint(1, 4)):
                at = dice.randrange(len(damaged))
                if dice.random() < 0.5:
                    damaged[at] = dice.randrange(256)
                else:
                    del damaged[at:at + dice.randint(1, 20)]
            self.client.raw(bytes(damaged) + b"\r\n\r\n")
        for _ in range(3):  # a length that was too long may swallow the first
            self.client.send({**LIVE, "id": "end"})
        while self.client.receive()["id"] != "end":
            pass

    def test_every_request_everywhere(self):
        """In whole, cut-off and damaged scripts, at every few characters."""
        self.write(house=HOUSE)
        dice = random.Random(7)
        texts = [HOUSE, HOUSE[:400], HOUSE.replace("}", ""), HOUSE.replace('"', ""), ""]
        texts += ["".join(dice.sample(HOUSE, len(HOUSE)))]
        self.open("house.style")
        for text in texts:
            self.change("house.style", text)
            for line in range(0, text.count("\n") + 2):
                for character in (0, dice.randint(0, 60), 500):
                    here = {"textDocument": {"uri": self.uri("house.style")},
                            "position": {"line": line, "character": character}}
                    for method in ("hover", "definition", "declaration", "implementation",
                                   "references", "documentHighlight", "completion",
                                   "signatureHelp"):
                        self.client.request("textDocument/" + method, here)
                    try:
                        self.client.request("textDocument/rename", {**here, "newName": "Fresh"})
                    except Refused as refused:
                        self.assertEqual(refused.code, -32803)
            for method in ("documentSymbol", "foldingRange", "formatting"):
                self.client.request("textDocument/" + method, {
                    "textDocument": {"uri": self.uri("house.style")}})


if __name__ == "__main__":
    client.main()
