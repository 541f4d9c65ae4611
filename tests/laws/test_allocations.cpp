// After the first few buildings neither deriving nor writing asks the heap for anything.
#include <doctest/doctest.h>

#include <cstdlib>
#include <new>

#include "formats/surface_writer.hpp"
#include "tests/formats/support.hpp"
#include "tests/laws/derive.hpp"

namespace {
thread_local bool counting = false;
thread_local std::size_t allocations = 0;

void* counted(std::size_t bytes) {
  if (counting) ++allocations;
  if (void* const p = std::malloc(bytes == 0 ? 1 : bytes)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes); }
void* operator new[](std::size_t bytes) { return counted(bytes); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace {

using namespace mansard;
using namespace mansard::test;

/// Heap calls while buildings `from` to 100 are derived, one after the other.
std::size_t heap_calls(const Script& script, std::size_t from) {
  const Footprint on = footprint("rect:10x8");
  Derivation derivation(script.program(), script.meshes(), {});
  Building building;
  for (std::size_t i = 0; i < 100; ++i) {
    if (i == from) {
      allocations = 0;
      counting = true;
    }
    derivation.derive(on, building);
  }
  counting = false;
  return allocations;
}

}  // namespace

TEST_CASE("heap calls are counted") {
  counting = true;
  allocations = 0;
  { const std::vector<int> some(100); }
  counting = false;
  CHECK(allocations == 1);
}

TEST_CASE("the facade box needs no heap after the first few") {
  CHECK(heap_calls(Script::file("bench/facade_box.style"), 20) == 0);
}

TEST_CASE("the thesis's building needs no heap after the first few") {
  for (const char* const name : {"ThesisBy61", "ThesisBy610"})
    CHECK(heap_calls(Script::file("bench/thesis.style", {{}, name}), 20) == 0);
}

TEST_CASE("guards, indices, drawn sizes and reports need no heap") {
  CHECK(heap_calls(Script::text(R"(style A {
    var Floor = 3   def half(x) = x / 2
    Mass  { FOOTPRINT -> extrude(12) { BOX }   BOX -> comp { front : FACADE | side : FACADE | top : roof("flat") { top : DECK } } }
    Facade {
        FACADE : H > Floor + 1 -> subdiv("Y", Floor, 1r) { FLOOR[0] | FLOORS } : 2
        FACADE : else -> WALL
        FLOORS -> repeat("Y", Floor) { set(Tile.Width, half(W) / 3) FLOOR[split.index] }
        FLOOR[0] -> repeat("X", 2.5) { Cell(split.index) }
        FLOOR : fits -> subdiv("X", 0.5, 1r, 0.5) { WALL | repeat("X", 2) { TILE } | WALL }
    }
    Tile {
        var Width = 1
        Cell(n) : n > 1 -> WALL   Cell(n) : else -> TILE
        TILE -> if Width > 0.2 { color("red") subdiv("X", 1r, 0.5 + rand(0, 0.1), 1r) { WALL | [ t(0, 0, 0.1) TRIM ] WINDOW | WALL } } else { WALL }
    }
    Materials { WALL : color("#a08070") : 0.5  color("#b09080") : 0.5 }
})"),
                   20) == 0);
}

TEST_CASE("splits that snap need no heap") {
  CHECK(heap_calls(Script::text(R"(style A {
    Mass  { FOOTPRINT -> [ s(6, 0, 8) extrude(12) MASS ] t(6, 0, 0) s(4, 0, 8) extrude(7) MASS   MASS -> comp { side : FACADE } }
    Facade {
        FACADE -> subdiv("YS", 3, 1r) { repeat("X", 2.5) { snap("YZ", "shop") SHOP } | UPPER }
        UPPER  -> repeat("YS", 3) { snap("XZ") FLOOR }
        FLOOR  -> repeat("XS", 1.2, to = "shop") { TILE }
        TILE   -> subdiv("XS", 0.2, 1r, 0.2) { WALL | PANE | WALL }
    }
})"),
                   20) == 0);
}

namespace {

/// Heap calls while boxes `from` to 100 are written, in the steps that are many to a building; a
/// building's name may take some.
std::size_t heap_calls_of_writing(std::unique_ptr<SurfaceWriter> writer, std::size_t from) {
  const Script script = Script::file("bench/facade_box.style");
  const Building building = script.derive("rect:10x8");
  std::vector<std::string_view> symbols;
  for (uint32_t i = 0; i < script.program().symbols.size(); ++i)
    symbols.push_back(script.program().symbols[i]);
  const std::vector<Look> looks(script.program().materials.size(), {"plain", {}, 1, {}});
  const auto piece = writer->new_piece();
  allocations = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    counting = i >= from;
    piece->prepare({building.id, &building.surface});
    counting = false;
    piece->number(symbols, looks);
    counting = i >= from;
    piece->format();
    piece->append();
  }
  counting = false;
  writer->finish(looks);
  return allocations;
}

}  // namespace

TEST_CASE("writing an OBJ needs no heap after the first few but for names") {
  const Folder folder;
  CHECK(heap_calls_of_writing(write_obj(folder / "boxes.obj", Up::y, ""), 20) == 0);
}
