"""Renaming: every use, nothing else, and never into a clash."""
from pathlib import Path

import client
from client import Case, Refused, edited, stretch
from scripts import ALL, HOUSE, NARROW


class Rename(Case):
    def setUp(self):
        super().setUp()
        self.write(**ALL)
        self.serve()

    def rename(self, name, needle, new, number=0, behind=0):
        if name not in self.client.diagnostics:
            self.open(name)
        return self.ask("rename", name, needle, number, behind, newName=new)["changes"]

    def renamed(self, *arguments, **more):
        """The texts after the rename, of the files that it changes."""
        changed = {}
        for uri, edits in self.rename(*arguments, **more).items():
            name = str(Path(uri.removeprefix("file://")).relative_to(self.folder))
            changed[name] = edited(self.texts[name], edits)
        return changed

    def refusal(self, name, needle, new, number=0):
        with self.assertRaises(Refused) as caught:
            self.rename(name, needle, new, number)
        self.assertEqual(caught.exception.code, -32803)
        return caught.exception.message

    def check(self, changed):
        """The scripts after the rename have no more problems than before."""
        for name, text in {**self.texts, **changed}.items():
            self.open(name, text)
        self.assertEqual(self.client.settle(), {})

    def test_a_symbol_across_files(self):
        changed = self.renamed("narrow.style", "TILE", "BAY")
        self.assertEqual(changed, {
            "house.style": HOUSE.replace("TILE ", "BAY ").replace("TILE}", "BAY}"),
            "narrow.style": NARROW.replace("TILE ", "BAY ")})
        self.check(changed)

    def test_a_variable_of_a_block(self):
        changed = self.renamed("house.style", "WindowWidth", "PaneWidth", 1)
        self.assertEqual(changed, {name: ALL[name[:-6]].replace("WindowWidth", "PaneWidth")
                                   for name in ("house.style", "narrow.style")})
        self.check(changed)

    def test_a_qualified_variable(self):
        changed = self.renamed("narrow.style", "Half", "Middle")
        self.assertEqual(changed, {"house.style": HOUSE.replace("Half", "Middle"),
                                   "narrow.style": NARROW.replace("Half", "Middle")})
        self.check(changed)

    def test_of_the_block_that_was_meant(self):
        text = ('style A { A1 { var X = 1  FOOTPRINT -> extrude(X) B }\n'
                'A2 { var X = 2  B -> extrude(X + A1.X) C } }\n')
        self.write(two=text)
        changed = self.renamed("two.style", "X = 2", "Y")
        self.assertEqual(changed["two.style"], text.replace("X = 2", "Y = 2").replace(
            "extrude(X + ", "extrude(Y + "))
        changed = self.renamed("two.style", "X = 1", "Y")
        self.assertEqual(changed["two.style"], text.replace("X = 1", "Y = 1").replace(
            "extrude(X)", "extrude(Y)").replace("A1.X", "A1.Y"))

    def test_a_block(self):
        changed = self.renamed("house.style", "Facade", "Front")
        self.assertEqual(changed, {name: ALL[name[:-6]].replace("Facade", "Front")
                                   for name in ("house.style", "narrow.style", "mixin.style")})
        self.check(changed)

    def test_a_style(self):
        changed = self.renamed("narrow.style", "House", "Home")
        self.assertEqual(changed, {name: ALL[name[:-6]].replace("House", "Home")
                                   for name in ("house.style", "narrow.style", "proud.style")})
        self.check(changed)

    def test_parameters_stay_in_their_rule(self):
        changed = self.renamed("house.style", "n > 0", "count")
        self.assertEqual(changed["house.style"], HOUSE.replace(
            "Stack(n) : n > 0 -> extrude(1) { Stack(n - 1) }",
            "Stack(count) : count > 0 -> extrude(1) { Stack(count - 1) }"))
        changed = self.renamed("house.style", "n * Axis", "part")
        self.assertEqual(changed["house.style"],
                         HOUSE.replace("def share(n) = n *", "def share(part) = part *"))

    def test_through_a_mixin(self):
        changed = self.renamed("mixin.style", "FACADE", "FRONT")
        self.assertEqual(set(changed), {"mixin.style", "house.style"})
        self.check(changed)

    def test_symbols_in_quotes(self):
        text = ('style A { B { @per("FLOOR") var X = rand(1, 2)  FOOTPRINT -> extrude(X) FLOOR }\n'
                'Materials { FLOOR : color("tan") per "FLOOR" } }\n')
        self.write(quoted=text)
        self.assertEqual(self.renamed("quoted.style", "FLOOR }", "STOREY")["quoted.style"],
                         text.replace("FLOOR", "STOREY"))

    def test_unsaved_text_is_renamed(self):
        self.open("narrow.style", "// new\n" + NARROW)
        changed = self.rename("house.style", "WindowWidth", "PaneWidth")
        self.assertEqual([e["range"] for e in changed[self.uri("narrow.style")]],
                         [stretch("// new\n" + NARROW, "WindowWidth")])

    def test_prepare(self):
        self.open("house.style")
        self.assertEqual(self.ask("prepareRename", "house.style", "WindowWidth", 1, 3),
                         {"range": stretch(HOUSE, "WindowWidth", 1), "placeholder": "WindowWidth"})
        self.assertIsNone(self.ask("prepareRename", "house.style", "/// A house", 0, 6))
        for needle in ("extrude", "attr", "side", "FOOTPRINT", "W >", "range", "overhang"):
            with self.assertRaises(Refused, msg=needle):
                self.ask("prepareRename", "house.style", needle)

    def test_names_that_can_not_be(self):
        for new in ("", "a b", "1x", "é", "a.b", "x-y", '"x"', "x\n"):
            self.assertIn("is no name", self.refusal("house.style", "WindowWidth", new))
        for new in ("style", "super", "W", "split", "BUILDING_HEIGHT"):
            self.assertIn("is reserved", self.refusal("house.style", "WindowWidth", new))
        self.assertIn("is an operation", self.refusal("house.style", "TILE", "extrude"))
        self.assertIn("'NIL' deletes", self.refusal("house.style", "TILE", "NIL"))
        self.assertIn("syntax of its own", self.refusal("house.style", "Facade", "Elements"))
        self.assertIn("function of the language", self.refusal("house.style", "share", "min"))

    def test_what_belongs_to_the_language(self):
        for needle in ("extrude", "attr", "side", "overhang", "slope :", "range"):
            self.assertIn("belongs to the language", self.refusal("house.style", needle, "Fresh"))
        self.assertIn("start NAME", self.refusal("house.style", "FOOTPRINT", "PLOT"))
        self.assertIn("name of a file", self.refusal("narrow.style", "house.style", "Fresh"))

    def test_clashes(self):
        for name, needle, new, with_what in (
                ("house.style", "TILE ", "WALL", "symbol 'WALL' already: house.style:15"),
                ("house.style", "TILE ", "TRIM", "symbol 'TRIM' already: narrow.style:6"),
                ("house.style", "Axis", "Half", "variable 'Half' already: house.style:12"),
                ("house.style", "Axis", "Height", "variable 'Height' already: house.style:5"),
                ("house.style", "Height", "Axis", "variable 'Axis' already: house.style:11"),
                ("house.style", "Axis", "n", "parameter 'n' already: house.style:13"),
                ("house.style", "Facade", "Tile", "block 'Tile' already: house.style:17"),
                ("narrow.style", "House", "Narrow", "style 'Narrow' already: narrow.style:3"),
                ("house.style", "n * Axis", "Axis", "variable 'Axis' already: house.style:13")):
            self.assertIn("there is a " + with_what, self.refusal(name, needle, new), (needle, new))

    def test_no_clash_with_strangers(self):
        """What another block or an unrelated style calls so is not in the way."""
        self.assertTrue(self.rename("house.style", "Axis", "WindowWidth"))
        self.assertTrue(self.rename("apart.style", "TILE", "TRIM"))

    def test_outside_of_the_workspace(self):
        other = self.folder / "elsewhere"
        self.write(elsewhere__base=HOUSE, workspace__heir=NARROW.replace("house", "../elsewhere/base"))
        self.client.stop()
        self.client = client.Client(folder=self.folder / "workspace")
        self.assertIn("not in the workspace",
                      self.refusal("workspace/heir.style", "WindowWidth", "Pane"))
        self.assertTrue(self.rename("workspace/heir.style", "Narrow", "Slim"))
        self.assertTrue(other.exists())

    def test_the_shipped_library_stays_as_it_is(self):
        self.client.stop()
        self.client = client.Client()  # no folder is open
        self.write(mine='import "listings.style"\nstyle Mine : Building1 { var Fresh = 1 }\n')
        self.assertIn("not in the workspace", self.refusal("mine.style", "Building1", "Mansion"))
        self.assertTrue(self.rename("mine.style", "Fresh", "Other"))

    def test_build_folders_are_passed_over(self):
        self.write(build__copy=HOUSE, node_modules__copy=HOUSE, sub__heir=NARROW.replace(
            "house.style", "../house.style"))
        self.assertEqual(set(self.renamed("house.style", "WindowWidth", "Pane")),
                         {"house.style", "narrow.style", "sub/heir.style"})

    def test_the_same_name_changes_nothing(self):
        self.assertEqual(self.rename("house.style", "TILE", "TILE"), {})


if __name__ == "__main__":
    client.main()
