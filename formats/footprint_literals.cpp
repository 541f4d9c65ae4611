// Footprints that are typed on the command line.
#include <array>
#include <charconv>
#include <cmath>

#include "formats/footprint_sources.hpp"

namespace mansard {
namespace {

constexpr double longest = 100'000;  ///< metres; more is a slip of the keyboard

struct Form {
  std::string_view name, example, meaning;
  std::size_t numbers;
  /// The last two numbers are a piece of the first two.
  bool has_piece;
  RawPolygon (*draw)(std::span<const double> n);
};

RawPolygon draw_rectangle(std::span<const double> n) {
  return {{{0, 0}, {n[0], 0}, {n[0], n[1]}, {0, n[1]}}};
}

RawPolygon draw_l(std::span<const double> n) {
  const double x = n[0] - n[2], y = n[1] - n[3];
  return {{{0, 0}, {n[0], 0}, {n[0], y}, {x, y}, {x, n[1]}, {0, n[1]}}};
}

RawPolygon draw_t(std::span<const double> n) {
  const double left = (n[0] - n[2]) / 2, right = left + n[2], y = n[1] - n[3];
  return {
      {{0, 0}, {n[0], 0}, {n[0], y}, {right, y}, {right, n[1]}, {left, n[1]}, {left, y}, {0, y}}};
}

RawPolygon draw_u(std::span<const double> n) {
  const double left = (n[0] - n[2]) / 2, right = left + n[2], y = n[1] - n[3];
  return {{{0, 0},
           {n[0], 0},
           {n[0], n[1]},
           {right, n[1]},
           {right, y},
           {left, y},
           {left, n[1]},
           {0, n[1]}}};
}

RawPolygon draw_ring(std::span<const double> n) {
  const double u = (n[0] - n[2]) / 2, v = (n[1] - n[3]) / 2;
  return {{{0, 0}, {n[0], 0}, {n[0], n[1]}, {0, n[1]}},
          {{u, v}, {u, v + n[3]}, {u + n[2], v + n[3]}, {u + n[2], v}}};
}

constexpr std::array forms{
    Form{"rect", "rect:10x8", "width and depth", 2, false, draw_rectangle},
    Form{"L", "L:12x9x5x4", "width, depth, width and depth of the missing corner (back right)", 4,
         true, draw_l},
    Form{"T", "T:14x10x4x6", "width, depth, width and depth of the stem towards the back", 4, true,
         draw_t},
    Form{"U", "U:14x10x6x5", "width, depth, width and depth of the court that is open to the back",
         4, true, draw_u},
    Form{"ring", "ring:20x16x8x6", "width, depth, width and depth of the court in the middle", 4,
         true, draw_ring},
};
constexpr std::string_view wkt_example = "WKT:POLYGON((0 0, 10 0, 10 8, 0 8, 0 0))";

[[noreturn]] void fail(std::string_view what, const std::string& problem, const Form& form) {
  Diagnostic d;
  d.text = "'" + std::string(what) + "' " + problem;
  d.help = "write " + std::string(form.example) + ": " + std::string(form.meaning) + ", in metres";
  throw Failure(std::move(d));
}

/// Numbers with an x between them.
std::vector<double> read_numbers(std::string_view what, std::string_view text, const Form& form) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at < end && *at == ' ') ++at;
    double number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number)) {
      const std::string here(at, end);
      fail(what,
           here.empty() ? "ends where a number is expected"
                        : "has '" + here + "' where a number is expected",
           form);
    }
    numbers.push_back(number);
    at = next;
    while (at < end && *at == ' ') ++at;
    if (at == end) return numbers;
    if (*at != 'x' && *at != 'X') {
      fail(what, "has '" + std::string(at, end) + "' where 'x' is expected", form);
    }
    ++at;
  }
}

RawPolygon read_form(std::string_view what, std::string_view text, const Form& form) {
  const std::vector<double> n = read_numbers(what, text, form);
  if (n.size() != form.numbers) {
    fail(what,
         "has " + std::to_string(n.size()) + " of " + std::to_string(form.numbers) + " numbers",
         form);
  }
  for (double number : n) {
    if (number <= 0) fail(what, "has a length that is not positive", form);
    if (number > longest) fail(what, "is longer than 100 km", form);
  }
  if (form.has_piece && (n[2] >= n[0] || n[3] >= n[1])) {
    fail(what, "has a piece (the last two numbers) that is not smaller than the whole", form);
  }
  return form.draw(n);
}

RawSet alone(std::vector<RawPolygon> parts, bool rings_close) {
  RawSet set;
  set.rings_close = rings_close;
  set.features->add({"0", std::move(parts), {}});
  return set;
}

}  // namespace

std::optional<RawSet> read_literal(std::string_view what) {
  const std::size_t colon = what.find(':');
  if (colon == what.npos) return {};
  const std::string_view name = what.substr(0, colon), text = what.substr(colon + 1);
  if (name == "WKT" || name == "wkt") return alone(read_wkt(text), true);
  for (const Form& form : forms) {
    if (name == form.name) return alone({read_form(what, text, form)}, false);
  }
  return {};
}

std::string literal_forms() {
  std::string text;
  for (const Form& form : forms) text += std::string(form.example) + ", ";
  return text + std::string(wkt_example);
}

}  // namespace mansard
