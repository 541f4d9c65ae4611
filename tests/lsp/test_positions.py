"""Lines and characters as editors count them."""
import client
from client import Case, position, stretch

TEXT = '''style A {
    /* é𝄞中 */ var Wide = 3   // 𝄞 after
    B { FOOTPRINT -> report("𝄞é", Wide) extrude(Wide) }
}
'''


class Positions(Case):
    def references(self, unit):
        at = position(TEXT, "Wide", 0, 1, unit)
        found = self.client.request("textDocument/references", {
            "textDocument": {"uri": self.uri("a.style")}, "position": at,
            "context": {"includeDeclaration": True}})
        return [place["range"] for place in found]

    def test_utf16(self):
        self.write(a=TEXT)
        self.serve("a.style")
        self.assertEqual(self.references("utf-16"),
                         [stretch(TEXT, "Wide", n, "utf-16") for n in range(3)])
        self.assertEqual(stretch(TEXT, "Wide", 0, "utf-16")["start"]["character"], 19)

    def test_utf8(self):
        self.write(a=TEXT)
        self.serve("a.style", encodings=["utf-8"])
        self.assertEqual(self.references("utf-8"),
                         [stretch(TEXT, "Wide", n, "utf-8") for n in range(3)])
        self.assertEqual(stretch(TEXT, "Wide", 0, "utf-8")["start"]["character"], 24)

    def test_line_ends(self):
        self.write(a="")
        self.texts["a.style"] = TEXT.replace("\n", "\r\n")
        self.serve("a.style")
        self.assertEqual(self.references("utf-16"),
                         [stretch(TEXT, "Wide", n, "utf-16") for n in range(3)])

    def test_carriage_returns_alone_are_a_problem(self):
        self.write(a="")
        self.texts["a.style"] = TEXT.replace("\n", "\r")
        self.serve("a.style")
        told = [d["message"] for problems in self.client.settle().values() for d in problems]
        self.assertEqual(len(told), 1)
        self.assertIn("a carriage return without a line feed", told[0])

    def test_changes_inside_wide_characters(self):
        self.write(a=TEXT)
        self.serve("a.style")
        at = position(TEXT, "𝄞", 1)
        self.client.notify("textDocument/didChange", {
            "textDocument": {"uri": self.uri("a.style"), "version": 2}, "contentChanges": [
                {"range": {"start": at, "end": {**at, "character": at["character"] + 2}},
                 "text": "x"},
                {"range": {"start": {"line": 0, "character": 6},
                           "end": {"line": 0, "character": 7}}, "text": "Renamed"}]})
        symbols = self.client.request("textDocument/documentSymbol",
                                      {"textDocument": {"uri": self.uri("a.style")}})
        self.assertEqual(symbols[0]["name"], "Renamed")
        self.assertEqual(self.client.settle(), {})

    def test_paths_with_spaces_and_accents(self):
        folder = self.folder / "zwei Häuser %41"
        folder.mkdir()
        (folder / "a b.style").write_text(TEXT)
        self.texts["zwei Häuser %41/c.style"] = 'import "a b.style"\nstyle C : A { }\n'
        self.serve()
        self.open("zwei Häuser %41/c.style")
        found = self.ask("definition", "zwei Häuser %41/c.style", "A {")
        self.assertEqual(found, [{"uri": client.uri_of(folder / "a b.style"),
                                  "range": stretch(TEXT, "A")}])
        self.assertIn("%2541", found[0]["uri"])
        self.assertEqual(self.client.settle(), {})


if __name__ == "__main__":
    client.main()
