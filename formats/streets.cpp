#include "formats/streets.hpp"

#include <cmath>
#include <optional>

#include "formats/footprint_sources.hpp"

namespace mansard {
namespace {

RawSet read_raw(const std::string& what, const StreetOptions& options,
                const FootprintFacts& beside) {
  if (what.starts_with("WKT:") || what.starts_with("wkt:")) {
    RawSet set;
    for (RawRing& line : read_wkt_lines(std::string_view(what).substr(4)))
      set.features->add({"", {{std::move(line)}}, {}});
    return set;
  }
  check_is_file(what, "streets", "WKT:LINESTRING(-5 -4, 15 -4)");
  return read_gis_lines(what, options, beside);
}

/// Points that could not be converted part a line in two.
void add_pieces(const RawRing& line, std::vector<StreetLine>& to) {
  StreetLine piece;
  const auto end = [&] {
    if (piece.size() > 1) to.push_back(piece);
    piece.clear();
  };
  for (const Vec2 p : line) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      end();
    } else if (piece.empty() || !(piece.back() == p)) {
      piece.push_back(p);
    }
  }
  end();
}

}  // namespace

StreetSet read_streets(const std::string& what, const StreetOptions& options,
                       const FootprintFacts& beside) {
  const RawSet raw = read_raw(what, options, beside);
  StreetSet set;
  for (const FootprintNote& note : raw.notes) set.notes.push_back(note.text);
  raw.for_each([&](const RawFeature& feature) {
    for (const RawPolygon& part : feature.parts) add_pieces(part[0], set.lines);
  });
  if (set.lines.empty()) {
    Diagnostic d;
    d.text = "'" + what + "' has no street of any length";
    throw Failure(std::move(d));
  }
  return set;
}

}  // namespace mansard
