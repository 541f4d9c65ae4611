"""Problems as one types, in the open script and in what it imports."""
import client
from client import Case, stretch
from scripts import ALL, HOUSE, NARROW


class Diagnostics(Case):
    def test_a_sound_script_has_none(self):
        self.write(**ALL)
        self.serve("house.style", "narrow.style", "proud.style")
        self.assertEqual(self.client.settle(), {})

    def test_range_code_help_and_notes(self):
        text = 'style A {\n  B { FOOTPRINT : H > 1 -> extruda(3) { WALL } }\n}\n'
        self.write(a=text)
        self.serve("a.style")
        found = self.client.published(self.uri("a.style"))
        self.assertEqual([d["range"] for d in found], [stretch(text, "FOOTPRINT : H > 1"),
                                                       stretch(text, "extruda")])
        warning, error = found
        self.assertEqual((warning["severity"], warning["code"]), (2, "W002"))
        self.assertIn("\nhelp: add a production with ': else'", warning["message"])
        self.assertEqual((error["severity"], error["source"]), (1, "mansard"))
        self.assertNotIn("code", error)
        self.assertEqual(error["message"],
                         "unknown operation 'extruda'\n"
                         "note: while checking block 'B' of style 'A'\n"
                         "help: did you mean 'extrude'?")

    def test_notes_with_a_place_are_related_information(self):
        text = "style A { var X = 1  var X = 2  B { FOOTPRINT -> extrude(X) } }\n"
        self.write(a=text)
        self.serve("a.style")
        error, = self.client.published(self.uri("a.style"))
        self.assertEqual(error["range"], stretch(text, "X", 1))
        self.assertEqual(error["relatedInformation"], [
            {"location": {"uri": self.uri("a.style"), "range": stretch(text, "X", 0)},
             "message": "the other one is here"}])

    def test_mended_and_broken_again(self):
        self.write(a="style A { B { FOOTPRINT -> extrude(3 } }")
        self.serve("a.style")
        self.assertEqual(len(self.client.published(self.uri("a.style"))), 1)
        self.change("a.style", "style A { B { FOOTPRINT -> extrude(3) } }")
        self.assertEqual(self.client.published(self.uri("a.style")), [])
        self.change("a.style", "style A { B { FOOTPRINT -> extrude(} }", 3)
        self.assertEqual(len(self.client.published(self.uri("a.style"))), 1)
        self.assertEqual(self.client.notices[-1]["params"]["version"], 3)
        self.client.notify("textDocument/didClose", {"textDocument": {"uri": self.uri("a.style")}})
        self.assertEqual(self.client.published(self.uri("a.style")), [])

    def test_every_keystroke(self):
        """A script written letter by letter with incremental changes ends without a problem."""
        self.write(a="")
        self.serve("a.style")
        line = character = 0
        for version, letter in enumerate(HOUSE, 2):
            here = {"line": line, "character": character}
            self.client.notify("textDocument/didChange", {
                "textDocument": {"uri": self.uri("a.style"), "version": version},
                "contentChanges": [{"range": {"start": here, "end": here}, "text": letter}]})
            line, character = (line + 1, 0) if letter == "\n" else (line, character + 1)
            if version == 200:
                self.assertTrue(self.client.published(self.uri("a.style")))
        self.assertEqual(self.client.settle(), {self.uri("a.style"): []})

    def test_incremental_changes_in_one_message(self):
        self.write(a="style A { B { FOOTPRINT -> extrude(3) } }\n")
        self.serve("a.style")
        self.client.notify("textDocument/didChange", {
            "textDocument": {"uri": self.uri("a.style"), "version": 2}, "contentChanges": [
                {"range": {"start": {"line": 0, "character": 6},
                           "end": {"line": 0, "character": 7}}, "text": "Bé𝄞\n"},
                {"range": {"start": {"line": 0, "character": 7},
                           "end": {"line": 1, "character": 0}}, "text": ""}]})
        self.assertEqual(self.client.settle(), {})
        self.assertEqual([s["name"] for s in self.symbols("a.style")], ["B"])

    def symbols(self, name):
        return self.client.request("textDocument/documentSymbol",
                                   {"textDocument": {"uri": self.uri(name)}})

    def test_problems_of_an_imported_file(self):
        self.write(house=HOUSE.replace("extrude(Height)", "extrude(Heigt)"), narrow=NARROW)
        self.serve("narrow.style")
        error, = self.client.published(self.uri("house.style"))
        self.assertEqual(error["range"], stretch(self.texts["house.style"], "Heigt"))
        self.assertEqual(self.client.settle()[self.uri("house.style")], [error])
        self.assertEqual(self.client.diagnostics.get(self.uri("narrow.style"), []), [])

    def test_unsaved_imports_win_over_the_disk(self):
        self.write(house=HOUSE, narrow=NARROW)
        self.serve("house.style", "narrow.style")
        self.assertEqual(self.client.settle(), {})
        self.change("house.style", HOUSE.replace("var Half = Axis / 2", ""))
        error, = self.client.published(self.uri("narrow.style"))
        self.assertEqual(error["range"], stretch(NARROW, "Facade.Half"))
        self.change("house.style", HOUSE, 3)
        self.assertEqual(self.client.published(self.uri("narrow.style")), [])
        self.change("house.style", "", 4)
        self.assertIn("no style is called 'House'",
                      self.client.published(self.uri("narrow.style"))[0]["message"])
        # Closed without being saved: the disk counts again.
        self.client.notify("textDocument/didClose",
                           {"textDocument": {"uri": self.uri("house.style")}})
        self.assertEqual(self.client.published(self.uri("narrow.style")), [])

    def test_an_import_that_is_only_open(self):
        self.write(narrow=NARROW)
        self.serve("narrow.style")
        self.assertIn("there is no file 'house.style'",
                      self.client.published(self.uri("narrow.style"))[0]["message"])
        self.open("house.style", HOUSE)
        self.assertEqual(self.client.published(self.uri("narrow.style")), [])

    def test_changes_on_disk(self):
        self.write(house=HOUSE, narrow=NARROW)
        self.serve("narrow.style")
        self.assertEqual(self.client.settle(), {})
        (self.folder / "house.style").write_text("style Hovel { }")
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": [
            {"uri": self.uri("house.style"), "type": 2}]})
        self.assertEqual(len(self.client.published(self.uri("narrow.style"))), 1)

    def test_a_mesh_that_comes_later(self):
        self.write(a='style A { B { FOOTPRINT -> WALL } Elements { WALL : "w.obj" } }')
        self.serve("a.style")
        warning, = self.client.published(self.uri("a.style"))
        self.assertEqual(warning["code"], "W008")
        (self.folder / "w.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": [
            {"uri": self.uri("w.obj"), "type": 1}]})
        self.assertEqual(self.client.published(self.uri("a.style")), [])

    def test_two_open_scripts_say_a_thing_once(self):
        self.write(house=HOUSE.replace("extrude(Height)", "extrude(Heigt)"), narrow=NARROW)
        self.serve("house.style", "narrow.style")
        error, = self.client.settle()[self.uri("house.style")]
        self.assertIn("of style 'House'", error["message"])  # its own words, not an heir's

    def test_style_path(self):
        self.write(parts__house=HOUSE, narrow=NARROW)
        self.client = client.Client("--style-path", str(self.folder / "parts"), folder=self.folder)
        self.open("narrow.style")
        self.assertEqual(self.client.settle(), {})

    def test_quick_fixes(self):
        text = "style A {\n  B { FOOTPRINT : H > 1 -> extruda(3) { WALL } } // a\n}\n"
        self.write(a=text)
        self.serve("a.style")
        self.assertEqual(len(self.client.published(self.uri("a.style"))), 2)
        whole = {"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}}
        allow, write = self.client.request("textDocument/codeAction", {
            "textDocument": {"uri": self.uri("a.style")}, "range": whole,
            "context": {"diagnostics": []}})
        self.assertEqual(allow["title"], "Allow W002 on this line")
        self.assertEqual(write["title"], "Write 'extrude'")
        for action in (allow, write):
            edits = action["edit"]["changes"][self.uri("a.style")]
            text = client.edited(text, edits)
        self.change("a.style", text)
        self.assertEqual(self.client.published(self.uri("a.style")), [])
        self.assertIn("extrude(3) { WALL } } // a  // allow W002", text)
        self.assertEqual(self.client.request("textDocument/codeAction", {
            "textDocument": {"uri": self.uri("a.style")}, "range": whole,
            "context": {"diagnostics": []}}), [])

    def test_what_was_meant_keeps_its_quotes(self):
        text = ('style House { A { FOOTPRINT -> WALL } }\n'
                'style City { A { FOOTPRINT -> style(attr("kind", "Hose"))::FOOTPRINT } }\n')
        self.write(a=text)
        self.serve("a.style")
        self.assertEqual(self.client.published(self.uri("a.style"))[0]["code"], "W022")
        write = self.client.request("textDocument/codeAction", {
            "textDocument": {"uri": self.uri("a.style")}, "context": {"diagnostics": []},
            "range": {"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}}})[0]
        mended = client.edited(text, write["edit"]["changes"][self.uri("a.style")])
        self.assertEqual(mended, text.replace("Hose", "House"))


if __name__ == "__main__":
    client.main()
