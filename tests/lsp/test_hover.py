"""What the editor shows under the pointer."""
import client
from client import Case, stretch
from scripts import ALL, HOUSE


class Hover(Case):
    def setUp(self):
        super().setUp()
        self.write(**ALL)
        self.serve("house.style", "narrow.style")

    def hover(self, *where):
        found = self.ask("hover", *where)
        if found is None:
            return None
        self.assertEqual(found["contents"]["kind"], "markdown")
        return found["contents"]["value"]

    def test_a_variable_with_its_origin(self):
        self.assertEqual(self.hover("narrow.style", "WindowWidth"),
                         "```style\nvar WindowWidth = 0.6\n```\n\n"
                         "Given by `Narrow.Tile` (narrow.style:5)\n\n"
                         "Overrides `House.Tile` (house.style:18)")

    def test_documentation_annotations_and_range(self):
        found = self.ask("hover", "house.style", "Height)")
        self.assertEqual(found["range"], stretch(HOUSE, "Height", 1))
        self.assertEqual(found["contents"]["value"],
                         '```style\n@range(3, 30)\nvar Height = attr("height", 6)\n```\n\n'
                         "How high the walls are.\n\nGiven by `House` (house.style:5)")

    def test_a_value_is_worked_out_late_bound(self):
        self.assertIn("\n\n= 1.2\n\nGiven by `House.Facade` (house.style:12), inherited by "
                      "`Narrow`", self.hover("narrow.style", "Half"))
        self.write(wide='import "house.style"\nstyle Wide : House { Facade { var Axis = 5\n'
                        'X -> extrude(Half) } }')
        self.open("wide.style")
        self.assertIn("\n\n= 2.5\n\n", self.hover("wide.style", "Half"))

    def test_a_symbol_with_its_rules(self):
        text = self.hover("house.style", "FACADE")
        self.assertIn('```style\nFACADE : W > Axis -> repeat("X", Axis) { TILE }\n'
                      'FACADE : else -> WALL\n```', text)
        self.assertIn("Given by `House.Facade` (house.style:14)", text)
        self.assertIn("A terminal: no rule rewrites it", self.hover("house.style", "WINDOW"))
        self.assertIn('WALL : color("tan")', self.hover("house.style", "WALL"))

    def test_heirs(self):
        self.write(heirs="style A { B { TILE -> WALL } }\nstyle C : A { B { TILE -> WALL } }\n"
                         "style D : C { B { TILE -> WALL } }\n")
        self.open("heirs.style")
        self.assertIn("\n\nOverridden by `C.B` (heirs.style:2), `D.B` (heirs.style:3)",
                      self.hover("heirs.style", "TILE"))
        self.assertIn("Given by `D.B` (heirs.style:3)\n\nOverrides `C.B` (heirs.style:2), "
                      "`A.B` (heirs.style:1)", self.hover("heirs.style", "TILE", 2))

    def test_super(self):
        text = self.hover("narrow.style", "super")
        self.assertIn("TILE -> subdiv", text)
        self.assertIn("Given by `House.Tile`", text)

    def test_a_style(self):
        self.assertEqual(self.hover("narrow.style", "Narrow"),
                         "```style\nstyle Narrow : House\n```\n\n"
                         "Resolution order: `Narrow`, `House`")
        self.assertIn("A house.", self.hover("narrow.style", "House"))

    def test_words_of_the_language(self):
        for needle, number, expected in (
                ("extrude", 0, "```style\nextrude(height, corners) { PART }\n```\n\nDraws a flat"),
                ("roof", 0, "FOOTPRINT -> roof("),
                ("side", 0, "Faces steeper than 45°."),
                ("slope", 0, "`slope` is a part that `roof` makes"),
                ("overhang", 0, "`overhang`: a number; may be left out"),
                ("range", 0, "@range(min, max, step)"),
                ("attr", 0, "reads a property of the footprint"),
                ("W >", 0, "The width of the shape's scope"),
                ("else", 0, "tried where no rule before it"),
                ("start", 0, "Names the symbol with which derivation begins"),
                ("FOOTPRINT ->", 0, "The symbol with which derivation begins"),
                ("Materials", 0, "The block of looks"),
                ("n - 1", 0, "A parameter of `Stack`")):
            self.assertIn(expected, self.hover("house.style", needle, number), needle)
        self.assertIn("the next style's", self.hover("narrow.style", "super"))

    def test_nothing_to_say(self):
        for needle in ("/// A house", "3, 30", "{"):
            self.assertIsNone(self.hover("house.style", needle, 0, 5 if "///" in needle else 0))

    def test_in_a_line_that_can_not_be_read(self):
        self.change("house.style", "style A { B { FOOTPRINT -> extrude( } }")
        self.assertIn("Draws a flat shape", self.hover("house.style", "extrude"))

    def test_files(self):
        self.assertEqual(self.hover("narrow.style", "house.style"),
                         f"`{self.folder / 'house.style'}`")


if __name__ == "__main__":
    client.main()
