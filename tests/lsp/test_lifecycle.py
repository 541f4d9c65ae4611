"""How a conversation begins and ends, and what is refused."""
import json
import unittest

import client
from client import Case, Client, Refused


class Lifecycle(unittest.TestCase):
    def refusal(self, server, method, params=None):
        with self.assertRaises(Refused) as caught:
            server.request(method, params)
        return caught.exception.code

    def test_capabilities(self):
        server = Client()
        for name in ("hover", "definition", "declaration", "implementation", "references", "rename",
                     "completion", "signatureHelp", "documentSymbol", "workspaceSymbol",
                     "foldingRange", "documentHighlight", "codeAction", "documentFormatting"):
            self.assertTrue(server.capabilities[name + "Provider"], name)
        self.assertEqual(server.capabilities["positionEncoding"], "utf-16")
        self.assertEqual(server.capabilities["textDocumentSync"]["change"], 2)
        self.assertEqual(server.stop(), 0)
        self.assertEqual(server.errors, "")

    def test_encoding_is_the_editors_favourite(self):
        for offered, taken in ((["utf-8", "utf-16"], "utf-8"), (["utf-16", "utf-8"], "utf-16"),
                               (["utf-32", "utf-8"], "utf-8"), (["utf-32"], "utf-16")):
            server = Client(encodings=offered)
            self.assertEqual(server.capabilities["positionEncoding"], taken, offered)
            self.assertEqual(server.stop(), 0)

    def test_nothing_before_initialize(self):
        server = Client(start=False)
        self.assertEqual(self.refusal(server, "textDocument/hover", {}), -32002)
        self.assertEqual(self.refusal(server, "shutdown"), -32002)
        server.notify("textDocument/didOpen", {"textDocument": {"uri": "file:///a", "text": "x"}})
        server.start()
        self.assertEqual(self.refusal(server, "initialize", {}), -32600)
        self.assertEqual(server.settle(), {})
        self.assertEqual(server.stop(), 0)

    def test_unknown_methods(self):
        server = Client()
        self.assertEqual(self.refusal(server, "textDocument/nonsense", {}), -32601)
        self.assertEqual(self.refusal(server, "$/nonsense", {}), -32601)
        server.notify("$/nonsense", {})
        server.notify("nonsense")
        server.notify("textDocument/nonsense", {"textDocument": {"uri": "file:///a"}})
        self.assertEqual(server.stop(), 0)

    def test_after_shutdown_only_exit(self):
        server = Client()
        self.assertIsNone(server.request("shutdown"))
        self.assertEqual(self.refusal(server, "textDocument/hover", {}), -32600)
        self.assertEqual(self.refusal(server, "shutdown"), -32600)
        server.notify("exit")
        self.assertEqual(server.end(), 0)

    def test_exit_without_shutdown_fails(self):
        server = Client()
        server.notify("exit")
        self.assertEqual(server.end(), 1)

    def test_exit_before_initialize_fails(self):
        server = Client(start=False)
        server.notify("exit")
        self.assertEqual(server.end(), 1)

    def test_end_of_input_fails(self):
        server = Client()
        self.assertEqual(server.end(), 1)
        self.assertEqual(server.errors, "")

    def test_cancelled_while_it_waits(self):
        server = Client()
        frames = b""
        for message in ({"id": 7, "method": "workspace/symbol", "params": {"query": ""}},
                        {"id": 8, "method": "workspace/symbol", "params": {"query": ""}},
                        {"method": "$/cancelRequest", "params": {"id": 8}},
                        {"method": "$/cancelRequest", "params": {"id": 99}}):
            text = json.dumps({"jsonrpc": "2.0", **message}).encode()
            frames += b"Content-Length: %d\r\n\r\n%s" % (len(text), text)
        server.raw(frames)
        self.assertEqual(server.answer(7), [])
        with self.assertRaises(Refused) as caught:
            server.answer(8)
        self.assertEqual(caught.exception.code, -32800)
        self.assertEqual(server.stop(), 0)

    def test_ids_come_back_as_they_were(self):
        server = Client()
        for number in ("a \"name\"", 12, 0):
            server.send({"jsonrpc": "2.0", "id": number, "method": "workspace/symbol",
                         "params": {}})
            self.assertEqual(server.answer(number), [])
        self.assertEqual(server.stop(), 0)

    def test_usage(self):
        import subprocess
        wrong = subprocess.run([client.PROGRAM, "lsp", "a.style"], capture_output=True, text=True,
                               stdin=subprocess.DEVNULL)
        self.assertEqual(wrong.returncode, 2)
        self.assertEqual(wrong.stdout, "")


if __name__ == "__main__":
    client.main()
