"""What is offered while a line is written, and the parameters of calls."""
import client
from client import Case, edited
from scripts import ALL, HOUSE

HEIR = '''import "house.style"
style Heir : House {
    Tile {
        $
    }
    Facade {
        FACADE -> $
    }
}
'''


class Completion(Case):
    def setUp(self):
        super().setUp()
        self.write(**ALL)
        self.serve("house.style")

    def complete(self, text, name="work.style"):
        """Items by label where the $ stands."""
        at = text.index("$")
        before = text[:at]
        text = before + text[at + 1:]
        known = name in self.texts
        (self.change if known else self.open)(name, text)
        self.position = {"line": before.count("\n"),
                         "character": len(before.rsplit("\n", 1)[-1])}
        items = self.client.request("textDocument/completion", {
            "textDocument": {"uri": self.uri(name)}, "position": self.position})
        self.text = text
        return {item["label"]: item for item in items}

    def accept(self, item):
        return edited(self.text, [item["textEdit"]])

    def in_tile(self, line):
        return self.complete(HEIR.replace("-> $", "-> WALL").replace("$", line, 1))

    def test_operations_with_snippets(self):
        items = self.in_tile("TILE -> ext$")
        extrude = items["extrude"]
        self.assertEqual(extrude["insertTextFormat"], 2)
        self.assertIn("        TILE -> extrude(${1:height})$0\n", self.accept(extrude))
        self.assertEqual(extrude["detail"], "extrude(height, corners) { PART }")
        self.assertIn("Draws a flat shape upwards", extrude["documentation"]["value"])
        self.assertEqual(items["subdiv"]["textEdit"]["newText"],
                         'subdiv("${1:axis}", ${2:size}) { $0 }')
        self.assertEqual(items["comp"]["textEdit"]["newText"], "comp { $0 }")
        self.assertIn("super", items)
        self.assertEqual(items["Heir"]["textEdit"]["newText"], "Heir::")
        self.assertTrue({"TILE", "WALL", "WINDOW", "FACADE", "NIL"} <= set(items))

    def test_without_snippets(self):
        self.client.stop()
        self.serve("house.style", snippets=False)
        items = self.in_tile("TILE -> ext$")
        self.assertEqual(items["extrude"]["textEdit"]["newText"], "extrude")
        self.assertEqual({i["insertTextFormat"] for i in items.values()}, {1})

    def test_members_to_override(self):
        items = self.in_tile("$")
        tile = items["TILE"]
        self.assertEqual(tile["detail"], "override, from House")
        self.assertIn('        TILE -> subdiv("X", 1r, WindowWidth, 1r) { WALL | WINDOW | WALL }\n',
                      self.accept(tile))
        self.assertEqual(items["Stack"]["textEdit"]["newText"],
                         "Stack(n) : n > 0 -> extrude(1) { Stack(n - 1) }\n"
                         "Stack(n) : else -> WALL")
        self.assertEqual(items["WindowWidth"]["textEdit"]["newText"], "var WindowWidth = 1.2")
        self.assertTrue(tile["sortText"] < items["var"]["sortText"])
        self.assertNotIn("Axis", items)
        self.assertNotIn("extrude", items)
        items = self.in_tile("var WindowWidth = 2\n        $")
        self.assertNotIn("var WindowWidth = 1.2",
                         [i["textEdit"]["newText"] for i in items.values()])

    def test_after_a_rule_both_may_follow(self):
        items = self.in_tile("X -> WALL\n        $")
        self.assertEqual(items["Stack"]["detail"], "override, from House")
        self.assertIn("extrude", items)
        self.assertIn("var", items)

    def test_selectors_and_parts(self):
        items = self.in_tile("TILE -> comp { si$ }")
        self.assertEqual(items["side"]["textEdit"]["newText"], "side : ")
        self.assertIn("Faces steeper", items["side"]["documentation"]["value"])
        items = self.in_tile('TILE -> roof("hip", 30) { slope : TILES | $ }')
        self.assertEqual(items["soffit"]["textEdit"]["newText"], "soffit : ")
        self.assertNotIn("side", items)
        items = self.in_tile('TILE -> comp { side : $ }')
        self.assertNotIn("side", items)
        self.assertIn("WALL", items)
        items = self.in_tile('TILE -> setback(2, "str$")')
        self.assertEqual(set(items) & {"street", "party", "extrude"}, {"street", "party"})
        self.assertIn('setback(2, "street")', self.accept(items["street"]))

    def test_expressions(self):
        items = self.in_tile("TILE -> extrude($)")
        self.assertEqual(items["corners"]["textEdit"]["newText"], "corners = ")
        self.assertTrue({"WindowWidth", "Height", "Facade", "W", "split.index", "min",
                         "BUILDING_HEIGHT", "attr"} <= set(items))
        self.assertEqual(items["WindowWidth"]["detail"], "Tile.1.2")
        self.assertEqual(items["Height"]["documentation"]["value"], "How high the walls are.")
        self.assertEqual(items["min"]["textEdit"]["newText"], "min($0)")
        self.assertNotIn("extrude", items)
        self.assertNotIn("Axis", items)  # another block's
        for line in ("var X = $", "TILE : $ -> WALL", "TILE -> WALL : $", "TILE -> if $",
                     "TILE -> WALL[$]", "def f(a) = a + $", "var X = (1 + 2) * $"):
            items = self.in_tile(line)
            self.assertIn("min", items, line)
            self.assertNotIn("extrude", items, line)
        self.assertIn("fits", self.in_tile("TILE : $ -> WALL"))

    def test_parameters(self):
        for line in ("Stack(n) -> WALL : $n\n        TILE -> WALL", "Stack(n) : $ -> WALL", "Stack(n) -> extrude(n - $)", "Stack(n) -> $",
                     "Stack(a)[n] -> extrude($)"):
            self.assertIn("n", self.in_tile(line), line)
        self.assertNotIn("n", self.in_tile("Stack(n) -> WALL  TILE -> extrude($)"))

    def test_after_a_dot(self):
        items = self.in_tile("TILE -> extrude(Facade.$)")
        self.assertEqual(set(items), {"Axis", "Half", "share"})
        items = self.in_tile("TILE -> extrude(Facade.Ha$)")
        self.assertIn("extrude(Facade.Half)", self.accept(items["Half"]))
        self.assertEqual(set(self.in_tile("TILE -> extrude(split.$)")),
                         {"index", "count", "round"})

    def test_after_two_colons(self):
        items = self.in_tile("TILE -> House::$")
        self.assertTrue({"FACADE", "TILE", "ROOF"} <= set(items))
        self.assertNotIn("extrude", items)

    def test_parents(self):
        items = self.complete('import "house.style"\nstyle A : $')
        self.assertEqual(set(items), {"House"})
        items = self.complete('import "house.style"\nstyle A : House, $ { }\nstyle B { }')
        self.assertEqual(set(items), {"House", "B"})

    def test_members_of_a_style(self):
        items = self.complete('import "house.style"\nstyle A : House {\n    $\n}\n')
        self.assertTrue({"var", "def", "start", "replace", "Elements", "Materials", "Tile",
                         "Facade", "Height"} <= set(items))
        self.assertEqual(items["Tile"]["textEdit"]["newText"], "Tile {\n\t$0\n}")
        self.assertEqual(items["Height"]["textEdit"]["newText"],
                         '@range(3, 30)\nvar Height = attr("height", 6)')
        self.assertNotIn("extrude", items)

    def test_between_styles(self):
        self.assertEqual(set(self.complete("$")), {"style", "import", "final", "class"})

    def test_imports_and_annotations(self):
        items = self.complete('import "$"\n')
        self.assertTrue({"house.style", "narrow.style", "listings.style"} <= set(items))
        self.assertEqual(self.accept(items["house.style"]), 'import "house.style"\n')
        items = self.in_tile("@$")
        self.assertTrue({"range", "per", "choice"} <= set(items))
        self.assertIn("TILE", self.in_tile('@per("$") var X = 1'))

    def test_entries(self):
        items = self.complete('import "house.style"\nstyle A : House { Materials { $ } }')
        self.assertTrue({"WALL", "TILES", "color", "remove"} <= set(items))
        self.assertNotIn("extrude", items)
        items = self.complete('import "house.style"\nstyle A : House { Elements { $ } }')
        self.assertIn("WINDOW", items)
        self.assertNotIn("color", items)

    def test_nothing_in_comments_and_new_names(self):
        for line in ("// ext$", "/* ext$ */", "var Ne$", "def f$"):
            self.assertEqual(self.in_tile(line), {}, line)

    def test_names_stay_known_while_a_line_is_broken(self):
        sound = HOUSE.replace("ROOF -> roof", "ROOF -> $roof")
        self.complete(sound, "house.style")
        broken = HOUSE.replace('TILE -> subdiv("X", 1r, WindowWidth, 1r) { WALL | WINDOW | WALL }',
                               "TILE -> extrude(Win$ { { (")
        self.assertIn("WindowWidth", self.complete(broken, "house.style"))

    def signature(self, line):
        self.in_tile(line)
        found = self.client.request("textDocument/signatureHelp", {
            "textDocument": {"uri": self.uri("work.style")}, "position": self.position})
        if found is None:
            return None
        signature, = found["signatures"]
        return (signature["label"], [p["label"] for p in signature["parameters"]],
                found["activeParameter"])

    def test_signatures(self):
        self.assertEqual(self.signature("TILE -> detrude($"),
                         ("detrude(depth) { inner | reveal }", ["depth"], 0))
        self.assertEqual(self.signature('TILE -> subdiv("Y", 1r, (2 + 3) * max(1, 2), $) { A }'),
                         ("subdiv(axis, size, to =, tolerance =) { PART | ... }",
                          ["axis", "size", "to", "tolerance"], 1))
        self.assertEqual(self.signature("TILE -> extrude(min(W, $"),
                         ("min(values)", ["values"], 0))
        self.assertEqual(self.signature("TILE -> extrude(2 * ($"),
                         ("extrude(height, corners) { PART }", ["height", "corners"], 0))
        self.assertEqual(self.signature("TILE -> Stack($)"), ("Stack(n)", ["n"], 0))
        self.assertEqual(self.signature("TILE -> extrude(Facade.share($))"),
                         ("share(n)", ["n"], 0))
        self.assertEqual(self.signature('var X = attr("height", $)'),
                         ("attr(name, default)", ["name", "default"], 1))
        self.assertIsNone(self.signature("TILE -> WALL $"))
        self.assertIsNone(self.signature("TILE -> unknown($)"))


if __name__ == "__main__":
    client.main()
