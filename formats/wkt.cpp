// A reader of well-known text, small because footprints are polygons and streets lines; OGR's would
// not say where the text goes wrong.
#include <cctype>
#include <charconv>
#include <cmath>

#include "formats/footprint_sources.hpp"

namespace mansard {
namespace {

class Wkt {
 public:
  Wkt(std::string_view text, std::string_view form) : text_(text), form_(form) {}

  std::vector<RawRing> read_lines() {
    const std::string kind = word();
    skip_dimensions();
    if (kind != "LINESTRING" && kind != "MULTILINESTRING") {
      fail("is '" + kind + "', not a LINESTRING or MULTILINESTRING");
    }
    std::vector<RawRing> lines;
    const auto line = [&] {
      RawRing& points = lines.emplace_back();
      in_brackets([&] { points.push_back(point()); });
    };
    if (kind == "LINESTRING") {
      line();
    } else {
      in_brackets(line);
    }
    check_end();
    return lines;
  }

  std::vector<RawPolygon> read() {
    const std::string kind = word();
    skip_dimensions();
    if (kind != "POLYGON" && kind != "MULTIPOLYGON") {
      fail("is '" + kind + "', not a POLYGON or MULTIPOLYGON");
    }
    std::vector<RawPolygon> polygons;
    if (kind == "POLYGON") {
      polygons.push_back(polygon());
    } else {
      in_brackets([&] { polygons.push_back(polygon()); });
    }
    check_end();
    return polygons;
  }

 private:
  void skip_dimensions() {
    std::string dimensions = word();
    if (dimensions == "Z" || dimensions == "M" || dimensions == "ZM") dimensions = word();
    if (dimensions == "EMPTY") fail("is empty");
    if (!dimensions.empty()) expect('(');
  }
  void check_end() {
    skip_space();
    if (at_ < text_.size()) fail("goes on after its end: " + here());
  }
  /// "(" item {"," item} ")"
  template <class Item>
  void in_brackets(Item item) {
    expect('(');
    do {
      item();
    } while (accept(','));
    expect(')');
  }
  RawPolygon polygon() {
    RawPolygon rings;
    in_brackets([&] {
      RawRing& ring = rings.emplace_back();
      in_brackets([&] { ring.push_back(point()); });
    });
    return rings;
  }
  Vec2 point() {
    const double u = number(), v = number();
    skip_space();
    for (int more = 0; more < 2 && at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')';
         ++more) {
      number();  // Z, M
      skip_space();
    }
    return {u, v};
  }
  double number() {
    skip_space();
    if (at_ < text_.size() && text_[at_] == '+') ++at_;
    double value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail("has a number that is too large: " + here());
    if (error != std::errc()) fail("needs a number at " + here());
    at_ = end - text_.data();
    return value;
  }
  /// In capitals; empty when no letter comes.
  std::string word() {
    skip_space();
    std::string letters;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) {
      letters += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
    }
    return letters;
  }
  bool accept(char c) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!accept(c)) fail(std::string("needs '") + c + "' at " + here());
  }
  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  std::string here() const {
    if (at_ == text_.size()) return "its end";
    return std::string("'").append(shortened(text_.substr(at_))).append("'");
  }
  static std::string shortened(std::string_view text) {
    constexpr std::size_t most = 40;
    return std::string(text.substr(0, most)) + (text.size() > most ? "..." : "");
  }
  [[noreturn]] void fail(const std::string& problem) const {
    Diagnostic d;
    d.text = "'WKT:" + shortened(text_) + "' " + problem;
    d.help = form_;
    throw Failure(std::move(d));
  }

  std::string_view text_, form_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<RawPolygon> read_wkt(std::string_view text) {
  return Wkt(text,
             "write WKT:POLYGON((0 0, 10 0, 10 8, 0 8, 0 0)), in metres; a court is a second ring, "
             "several buildings are a MULTIPOLYGON(((...)), ((...)))")
      .read();
}

std::vector<RawRing> read_wkt_lines(std::string_view text) {
  return Wkt(text,
             "write WKT:LINESTRING(-5 -4, 15 -4), in metres; several streets are a "
             "MULTILINESTRING((...), (...))")
      .read_lines();
}

}  // namespace mansard
