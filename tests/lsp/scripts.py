"""Scripts that the tests of the language server look at."""

HOUSE = '''/// A house.
style House {
    /// How high the walls are.
    @range(3, 30)
    var Height = attr("height", 6)
    start FOOTPRINT
    Mass {
        FOOTPRINT -> extrude(Height) { comp { side : FACADE | top : ROOF } }
    }
    Facade {
        var Axis = 2.4
        var Half = Axis / 2          // allow W006
        def share(n) = n * Axis      // allow W006
        FACADE : W > Axis -> repeat("X", Axis) { TILE }
        FACADE : else -> WALL
    }
    Tile {
        var WindowWidth = 1.2
        TILE -> subdiv("X", 1r, WindowWidth, 1r) { WALL | WINDOW | WALL }
        ROOF -> roof("hip", 30, overhang = 0.3) { slope : TILES | soffit : WALL | fascia : WALL }
        Stack(n) : n > 0 -> extrude(1) { Stack(n - 1) }  // allow W009
        Stack(n) : else -> WALL
    }
    Materials { WALL : color("tan")  TILES : color("#804030") }
}
'''

NARROW = '''import "house.style"

style Narrow : House {
    Tile {
        var WindowWidth = 0.6
        override TILE -> [ t(0, 0, Facade.Half) TRIM ] super
    }
}
style Other : Narrow { Tile { TILE -> WALL } }
'''

MIXIN = '''style Cornice {
    Facade { FACADE -> [ CORNICE ] super }
}
'''

PROUD = '''import "mixin.style"
import "house.style"

style Proud : Cornice, House { }
'''

APART = '''style Apart { Mass { FOOTPRINT -> extrude(2) { TILE } TILE -> WALL } }
'''

ALL = {"house": HOUSE, "narrow": NARROW, "mixin": MIXIN, "proud": PROUD, "apart": APART}
