"""What the editor shows under the pointer."""
import client
from client import Case, stretch
from scripts import ALL, HOUSE

VALUES = '''style Base {
    var Storeys = attr("levels", 3)
    var Brick = "#a04030"
    Tile {
        /// How wide the glass is.
        @range(0.4, 2) @unit("m") var Width = 1.2
        var Glass = Width * 2
        var Pitch = rand(30, 45)
        var Twice = Pitch * 2
        @per("shape") var Depth = rand(0.1, 0.2)
        var Share = W / 3
        var Tall = rand(2, 3) * Storeys
        abstract var Colour
        var Hue = Colour
        var Bad = [1, 2][Storeys * 9]
        var Both = [Brick, "tan"]
        var Gap = 0.1
        FOOTPRINT -> extrude(Tall) { ROW }
    }
}
style Heir : Base {
    Tile {
        var Width = 0.6
        var Colour = "tan"   var Depth = rand(0, 1)
        ROW -> set(Tile.Width, 0.3) extrude(Glass + Gap)
    }
    Facade { EDGE -> extrude(Tile.Glass) }
}
'''


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
                         "How high the walls are.\n\n"
                         "= `6` where the footprint has no properties that say otherwise\n\n"
                         "Given by `House` (house.style:5)")

    def test_a_value_is_worked_out_late_bound(self):
        self.assertIn("\n\n= `1.2`\n\nGiven by `House.Facade` (house.style:12), inherited by "
                      "`Narrow`", self.hover("narrow.style", "Half"))
        self.write(wide='import "house.style"\nstyle Wide : House { Facade { var Axis = 5\n'
                        'X -> extrude(Half) } }')
        self.open("wide.style")
        self.assertIn("\n\n= `2.5`\n\n", self.hover("wide.style", "Half"))

    def valued(self):
        self.write(values=VALUES)
        self.open("values.style")
        return lambda needle, number=0: self.hover("values.style", needle, number)

    def test_where_a_value_comes_from(self):
        """Wherever it is spoken of, a variable is worth what the style at hand makes of it."""
        hover = self.valued()
        head = "```style\nvar Glass = Width * 2\n```\n\n"
        self.assertEqual(hover("Glass = "),
                         head + "= `2.4`\n\nGiven by `Base.Tile` (values.style:7)")
        inherited = (head + "= `1.2` where no set() says otherwise\n\n"
                     "Given by `Base.Tile` (values.style:7), inherited by `Heir`")
        self.assertEqual(hover("Glass + "), inherited)
        self.assertEqual(hover("Glass)"), inherited)  # Tile.Glass, from another block
        self.assertEqual(hover("Width = 0.6"),
                         "```style\nvar Width = 0.6\n```\n\nHow wide the glass is.\n\n"
                         "Set for some shapes by `ROW` (values.style:25) to `0.3`\n\n"
                         "Given by `Heir.Tile` (values.style:23)\n\n"
                         'Keeps `@range(0.4, 2)` `@unit("m")` of `Base.Tile` (values.style:6)\n\n'
                         "Overrides `Base.Tile` (values.style:6)")

    def test_values_that_no_script_decides(self):
        hover = self.valued()
        for needle, worth in (
                ("Pitch", "drawn once a building, by its seed"),
                ("Twice", "drawn once a building, by its seed"),
                ("Depth", "drawn, another value for each shape"),
                ("Share", "another value for each shape"),
                ("Storeys", "`3` where the footprint has no properties that say otherwise"),
                ("Tall", "drawn once a building, by its seed, and depends on the footprint"),
                ("Hue = ", "no value yet: it waits for what a child has to give"),
                ("Bad", "no value where the footprint has no properties: "
                        "no item 27 in a list of 2"),
                ("Both", '`["#a04030", "tan"]`'),
                ("Brick", None), ("Gap", None)):
            text = hover(needle)
            found = [line[2:] for line in text.split("\n") if line.startswith("= ")]
            self.assertEqual(found, [worth] if worth else [], f"{needle}: {text}")

    def test_how_often_to_draw_is_not_kept(self):
        """A child that gives the variable anew draws it as it says itself."""
        text = self.valued()("Depth = ", 1)
        self.assertIn("= drawn once a building", text)
        self.assertNotIn("Keeps", text)

    def test_no_value_while_the_style_has_errors(self):
        self.write(broken="style A { B { var W = 1 var V = W * 2\n"
                          "FOOTPRINT -> extrude(V + Nix) } }\n"
                          "style C { B { var U = 1 + 1\nFOOTPRINT -> extrude(U) } }")
        self.open("broken.style")
        self.assertEqual(self.hover("broken.style", "V ="),
                         "```style\nvar V = W * 2\n```\n\nGiven by `A.B` (broken.style:1)")
        self.assertIn("= `2`", self.hover("broken.style", "U)"))

    def test_where_super_leads(self):
        text = self.hover("narrow.style", "TILE ->")
        self.assertIn("\n\n`super` goes on with `House.Tile` (house.style:19)\n\n"
                      "Given by `Narrow.Tile` (narrow.style:6)", text)

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
