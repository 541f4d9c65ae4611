"""Formatting gives the text of `mansard format`."""
import subprocess

import client
from client import Case, edited
from scripts import ALL, HOUSE

MESSY = """// head
style   A{ B{FOOTPRINT->extrude( 3 ){WALL}
 /* 𝄞 */   var X=1 } }

style C : A { }
"""


class Formatting(Case):
    def format(self, name):
        return self.client.request("textDocument/formatting", {
            "textDocument": {"uri": self.uri(name)},
            "options": {"tabSize": 4, "insertSpaces": True}})

    def by_command(self, name):
        return subprocess.run([client.PROGRAM, "format", self.folder / name], check=True,
                              capture_output=True, text=True, encoding="utf-8").stdout

    def test_as_the_command_does(self):
        self.write(messy=MESSY, windows=MESSY.replace("\n", "\r\n"), bare=MESSY.rstrip(), **ALL)
        self.serve()
        for name in self.texts:
            self.open(name)
            edits = self.format(name)
            self.assertEqual(edited(self.texts[name], edits), self.by_command(name), name)
            self.change(name, edited(self.texts[name], edits))
            self.assertEqual(self.format(name), [], name)

    def test_only_what_differs(self):
        self.write(messy=MESSY)
        self.serve("messy.style")
        edit, = self.format("messy.style")
        self.assertEqual(edit["range"]["start"]["line"], 1)
        self.assertNotIn("// head", edit["newText"])

    def test_unsaved_text(self):
        self.write(house=HOUSE)
        self.serve("house.style")
        self.change("house.style", "style   A{}")
        edit, = self.format("house.style")
        self.assertTrue(edit["newText"].startswith("style A {"))

    def test_not_with_syntax_errors(self):
        self.write(broken="style A { B { FOOTPRINT -> } }")
        self.serve("broken.style")
        self.assertIsNone(self.format("broken.style"))


if __name__ == "__main__":
    client.main()
