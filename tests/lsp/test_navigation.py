"""From a name to where it is declared, overridden and used."""
import client
from client import Case, stretch
from scripts import ALL, HOUSE


class Navigation(Case):
    def setUp(self):
        super().setUp()
        self.write(**ALL)
        self.serve("narrow.style")

    def definition(self, *where, **more):
        return self.places(self.ask("definition", *where, **more))

    def test_definition(self):
        for needle, number, expected in (
                ("House", 0, {("house.style", 2, "House")}),
                ("WindowWidth", 0, {("narrow.style", 5, "WindowWidth")}),
                ("TILE", 0, {("narrow.style", 6, "TILE")}),
                ("Half", 0, {("house.style", 12, "Half")}),
                ("Facade", 0, {("house.style", 10, "Facade")}),
                ("super", 0, {("house.style", 19, "TILE")}),
                ("Narrow", 1, {("narrow.style", 3, "Narrow")})):
            self.assertEqual(self.definition("narrow.style", needle, number, 1), expected, needle)

    def test_exact_range(self):
        self.assertEqual(self.ask("definition", "narrow.style", "Half"),
                         [{"uri": self.uri("house.style"), "range": stretch(HOUSE, "Half")}])

    def test_the_end_of_a_word_counts(self):
        self.assertEqual(self.definition("narrow.style", "Half", 0, 4),
                         {("house.style", 12, "Half")})

    def test_definition_in_one_script(self):
        self.open("house.style")
        for needle, number, expected in (
                ("FOOTPRINT", 0, {("house.style", 8, "FOOTPRINT")}),
                ("Height)", 0, {("house.style", 5, "Height")}),
                ("FACADE", 0, {("house.style", 14, "FACADE"), ("house.style", 15, "FACADE")}),
                ("Axis)", 0, {("house.style", 11, "Axis")}),
                ("WALL", 0, {("house.style", 24, "WALL")}),
                ("n *", 0, {("house.style", 13, "n")}),
                ("n > 0", 0, {("house.style", 21, "n")}),
                ("Stack(n - 1)", 0, {("house.style", 21, "Stack"), ("house.style", 22, "Stack")})):
            self.assertEqual(self.definition("house.style", needle, number), expected, needle)
        for needle in ("extrude", "side", "W >", "0.3", "attr", "soffit"):
            self.assertFalse(self.definition("house.style", needle), needle)

    def test_definition_of_files(self):
        found, = self.ask("definition", "narrow.style", "house.style")
        self.assertEqual(found["uri"], self.uri("house.style"))
        self.write(mesh='style M { B { FOOTPRINT -> insert("a.obj") WALL } '
                        'Elements { WALL : "b.mesh" } }')
        for name in ("a.obj", "b.obj"):
            (self.folder / name).write_text("v 0 0 0\n")
        self.open("mesh.style")
        for needle, name in (("a.obj", "a.obj"), ("b.mesh", "b.obj")):
            found, = self.ask("definition", "mesh.style", needle)
            self.assertEqual(found["uri"], client.uri_of(self.folder / name))

    def test_declaration_is_what_is_overridden(self):
        for needle, expected in (
                ("WindowWidth", {("house.style", 18, "WindowWidth")}),
                ("TILE", {("house.style", 19, "TILE")}),
                ("Half", {("house.style", 12, "Half")})):  # overrides nothing
            self.assertEqual(self.places(self.ask("declaration", "narrow.style", needle)),
                             expected, needle)
        self.assertEqual(self.places(self.ask("declaration", "narrow.style", "TILE", 1)),
                         {("narrow.style", 6, "TILE"), ("house.style", 19, "TILE")})

    def test_implementation_is_where_heirs_override(self):
        self.open("house.style")
        heirs = self.places(self.ask("implementation", "house.style", "TILE ->"))
        self.assertEqual(heirs, {("narrow.style", 6, "TILE"), ("narrow.style", 9, "TILE")})
        heirs = self.places(self.ask("implementation", "house.style", "WindowWidth"))
        self.assertEqual(heirs, {("narrow.style", 5, "WindowWidth")})
        self.assertEqual(self.places(self.ask("implementation", "narrow.style", "TILE ->", 1)),
                         set())

    def references(self, name, needle, number=0, declarations=True):
        return self.places(self.ask("references", name, needle, number,
                                    context={"includeDeclaration": declarations}))

    def test_replace_drops_what_was_inherited(self):
        text = ("style A { B { var X = 1  TILE -> WALL } C { TILE -> extrude(B.X) } }\n"
                "style D : A { replace B { TILE -> super } }\n"
                "style E : D { B { var X = 2 } C { Y -> extrude(B.X) super } }\n")
        self.write(dropped=text)
        self.open("dropped.style")
        self.assertEqual(self.definition("dropped.style", "super"), {("dropped.style", 1, "TILE")})
        found, = self.ask("definition", "dropped.style", "super")
        self.assertEqual(found["range"], stretch(text, "TILE", 1))
        self.assertEqual(self.places(self.ask("declaration", "dropped.style", "X = 2")),
                         {("dropped.style", 3, "X")})  # overrides nothing that is left

    def test_references_across_files(self):
        self.assertEqual(self.references("narrow.style", "TILE"), {
            ("house.style", 14, "TILE"), ("house.style", 19, "TILE"), ("narrow.style", 6, "TILE"),
            ("narrow.style", 9, "TILE")})  # not those of apart.style
        self.assertEqual(self.references("narrow.style", "WindowWidth", declarations=False),
                         {("house.style", 19, "WindowWidth")})
        self.assertEqual(self.references("narrow.style", "House"), {
            ("house.style", 2, "House"), ("narrow.style", 3, "House"), ("proud.style", 4, "House")})

    def test_references_meet_in_an_heir(self):
        """FACADE of the mixin and of the house are one because Proud has both."""
        self.open("mixin.style")
        self.assertEqual(self.references("mixin.style", "FACADE"), {
            ("mixin.style", 2, "FACADE"), ("house.style", 8, "FACADE"),
            ("house.style", 14, "FACADE"), ("house.style", 15, "FACADE")})

    def test_highlights(self):
        self.open("house.style")
        found = self.ask("documentHighlight", "house.style", "Axis")
        self.assertEqual([(h["range"], h["kind"]) for h in found],
                         [(stretch(HOUSE, "Axis", n), 3 if n == 0 else 2) for n in range(5)])

    def test_styles_by_name(self):
        city = ('import "narrow.style"\nstyle City { Plot {\n  FOOTPRINT -> '
                'style("Narrow")::FOOTPRINT House::FACADE style(attr("s", "House"))::TILE } }\n')
        self.write(city=city)
        self.open("city.style")
        self.assertEqual(self.definition("city.style", 'Narrow")'), {("narrow.style", 3, "Narrow")})
        self.assertEqual(self.definition("city.style", "FACADE"),
                         {("house.style", 14, "FACADE"), ("house.style", 15, "FACADE")})
        self.assertEqual(self.definition("city.style", "TILE"), {
            ("house.style", 19, "TILE"), ("narrow.style", 6, "TILE"), ("narrow.style", 9, "TILE")})
        self.assertIn(("city.style", 3, "TILE"), self.references("narrow.style", "TILE"))


if __name__ == "__main__":
    client.main()
