"""The outline of a script, names of the workspace, and what can be folded."""
import client
from client import Case, stretch
from scripts import ALL, HOUSE


class Symbols(Case):
    def setUp(self):
        super().setUp()
        self.write(**ALL)
        self.serve("house.style")

    def whole(self, method, name="house.style"):
        return self.client.request("textDocument/" + method,
                                   {"textDocument": {"uri": self.uri(name)}})

    def test_outline(self):
        style, = self.whole("documentSymbol")
        self.assertEqual(style["name"], "House")
        self.assertEqual(style["selectionRange"], stretch(HOUSE, "House"))
        self.assertEqual(style["range"]["start"], {"line": 1, "character": 0})
        self.assertEqual(style["range"]["end"], {"line": 24, "character": 1})
        self.assertEqual([c["name"] for c in style["children"]],
                         ["Height", "Mass", "Facade", "Tile", "Materials"])
        facade = style["children"][2]
        self.assertEqual([(c["name"], c.get("detail")) for c in facade["children"]],
                         [("Axis", "2.4"), ("Half", "Axis / 2"), ("share", "n * Axis"),
                          ("FACADE", ": W > Axis"), ("FACADE", ": else")])
        self.assertEqual(facade["children"][3]["selectionRange"], stretch(HOUSE, "FACADE", 1))
        for outer in (style, *style["children"]):
            for inner in outer.get("children", []):
                self.assertLessEqual(self.key(outer["range"]["start"]),
                                     self.key(inner["range"]["start"]))
                self.assertLessEqual(self.key(inner["range"]["end"]),
                                     self.key(outer["range"]["end"]))

    @staticmethod
    def key(position):
        return position["line"], position["character"]

    def test_parents_are_shown(self):
        self.open("narrow.style")
        self.assertEqual([(s["name"], s["detail"]) for s in self.whole("documentSymbol",
                                                                       "narrow.style")],
                         [("Narrow", ": House"), ("Other", ": Narrow")])

    def found(self, query):
        return {(s["name"], s["containerName"], s["location"]["uri"].rsplit("/", 1)[-1])
                for s in self.client.request("workspace/symbol", {"query": query})}

    def test_workspace(self):
        self.assertEqual(self.found("wwidth"), {("WindowWidth", "House.Tile", "house.style"),
                                                ("WindowWidth", "Narrow.Tile", "narrow.style")})
        self.assertEqual(self.found("Proud"), {("Proud", "", "proud.style")})
        self.assertIn(("FACADE", "Cornice.Facade", "mixin.style"), self.found("facade"))
        self.assertEqual(self.found("nothing of the kind"), set())
        self.assertTrue(len(self.found("")) > 20)

    def test_new_files_are_found(self):
        self.assertEqual(self.found("Brandnew"), set())
        self.write(new="style Brandnew { }")
        self.client.notify("workspace/didChangeWatchedFiles", {"changes": [
            {"uri": self.uri("new.style"), "type": 1}]})
        self.assertEqual(self.found("Brandnew"), {("Brandnew", "", "new.style")})

    def test_folders_come_and_go(self):
        self.write(sub__a="style Inner { }")
        self.client.notify("workspace/didChangeWorkspaceFolders", {"event": {
            "added": [{"uri": self.uri("sub"), "name": "sub"}],
            "removed": [{"uri": self.uri(""), "name": "all"}]}})
        self.assertEqual(self.found("Inner"), {("Inner", "", "a.style")})
        self.assertEqual(self.found("Proud"), set())
        self.assertEqual(self.found("House"), {("House", "", "house.style")})  # it is open

    def test_folding(self):
        text = "// one\n// two\n\n/* a\n b */\n" + HOUSE
        self.change("house.style", text)
        folds = {(f["startLine"], f["endLine"], f.get("kind")) for f in self.whole("foldingRange")}
        self.assertLessEqual({(0, 1, "comment"), (3, 4, "comment"), (6, 29, None),
                              (14, 20, None)}, folds)
        self.assertNotIn((12, 12, None), folds)


if __name__ == "__main__":
    client.main()
