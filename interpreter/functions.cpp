// The table of functions. As for operations, types and arity come from the C++ signature.
#include <algorithm>
#include <cmath>

#include "interpreter/function.hpp"
#include "interpreter/group.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/question.hpp"
#include "interpreter/sight.hpp"
#include "interpreter/trial.hpp"
#include "interpreter/units.hpp"

namespace mansard {
namespace {

constexpr double pi = 3.14159265358979323846;
double radians(double degrees) { return degrees * pi / 180; }
double degrees(double radians) { return radians * 180 / pi; }

[[noreturn]] void refuse(const FunctionCall& c, std::size_t i, std::string_view expected);

template <class T>
struct argument;
template <>
struct argument<double> {
  static double take(const FunctionCall& c, std::size_t i) {
    if (c.args[i].type != Type::number) refuse(c, i, "a number");
    return c.args[i].number;
  }
};
template <>
struct argument<std::string_view> {
  static std::string_view take(const FunctionCall& c, std::size_t i) {
    if (c.args[i].type != Type::string) refuse(c, i, "a string");
    return c.args[i].string();
  }
};
template <>
struct argument<Value> {
  static Value take(const FunctionCall& c, std::size_t i) { return c.args[i]; }
};
template <class T>
struct argument<Each<T>> {
  static Each<T> take(const FunctionCall& c, std::size_t i) {
    return {c.machine.program.children[c.machine.program.nodes[c.node].children + i]};
  }
};
template <>
struct argument<Values> {
  static Values take(const FunctionCall&, std::size_t i) { return {static_cast<uint32_t>(i)}; }
};
template <class T>
struct argument<std::optional<T>> {
  static std::optional<T> take(const FunctionCall& c, std::size_t i) {
    if (i >= c.args.size()) return std::nullopt;
    return argument<T>::take(c, i);
  }
};

Value to_value(double v) { return Value::of(v); }
Value to_value(Value v) { return v; }

template <auto F, class R, class... P>
consteval Function signature_of(R (*)(const FunctionCall&, P...)) {
  Function row;
  ((row.parameters[row.count++] = parameter_of<P>::is), ...);
  for (std::size_t i = 0; i < row.count; ++i) {
    if (!row.parameters[i].optional) row.required = static_cast<uint8_t>(i + 1);
    if (row.parameters[i].type == ArgType::values) row.variadic = true;
  }
  row.invoke = [](const FunctionCall& c) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return to_value(F(c, argument<P>::take(c, I)...));
    }
    (std::index_sequence_for<P...>{});
  };
  return row;
}

template <auto F>
constexpr Function row(std::string_view name, std::string_view args, std::string_view summary,
                       std::string_view example, bool random = false) {
  Function r = signature_of<F>(F);
  if (names_in(args) != r.count) throw "every parameter needs a name";
  r.name = name;
  r.args = args;
  r.summary = summary;
  r.example = example;
  r.random = random;
  return r;
}

/// A question about other shapes.
template <auto F>
constexpr Function asking(std::string_view name, std::string_view args, std::string_view summary,
                          std::string_view example) {
  Function r = row<F>(name, args, summary, example);
  r.asks = Asks::others;
  return r;
}

/// About the shapes that are answered together.
template <auto F>
constexpr Function of_group(std::string_view name, std::string_view args, std::string_view summary,
                            std::string_view example) {
  Function r = row<F>(name, args, summary, example);
  r.asks = Asks::group;
  r.each = true;
  return r;
}

/// About what came of an alternative.
template <auto F>
constexpr Function of_outcome(std::string_view name, std::string_view args,
                              std::string_view summary, std::string_view example) {
  Function r = row<F>(name, args, summary, example);
  r.asks = Asks::outcome;
  return r;
}

using Call = const FunctionCall&;
using Opt = std::optional<double>;

// ---- chance

double draw_between(Call c, Opt low, Opt high) {
  const double a = high ? *low : 0, b = high ? *high : low.value_or(1);
  if (a > b) {
    c.machine.fail(c.machine.program.spans[c.node],
                   high ? "rand(low, high) got " + number_text(a) + " for low and " +
                              number_text(b) + " for high"
                        : "rand(high) draws between 0 and high, which is " + number_text(b),
                   high ? "write the lower bound first" : "write rand(low, high)");
  }
  return a + (b - a) * unit_interval(c.draw);
}

/// Box and Muller 1958.
double draw_normal(Call c, double mean, double deviation) {
  if (deviation < 0) {
    c.machine.fail(c.machine.program.spans[c.node],
                   "a deviation can not be negative: " + number_text(deviation));
  }
  const double u = 1 - unit_interval(mix(c.draw, 1)), v = unit_interval(mix(c.draw, 2));
  return mean + deviation * std::sqrt(-2 * std::log(u)) * std::cos(2 * pi * v);
}

Value choose_weighted(Call c, std::span<const Value> items, std::span<const Value> weights) {
  if (items.size() != weights.size() || items.empty()) {
    c.machine.fail(c.machine.program.spans[c.node],
                   "'choose' got " + count_text(items.size(), "value") + " for " +
                       count_text(weights.size(), "weight"));
  }
  double total = 0;
  for (const Value& w : weights) {
    if (w.type != Type::number || !(w.number >= 0)) {
      c.machine.fail(c.machine.program.spans[c.node], "a weight is a number that is not negative");
    }
    total += w.number;
  }
  if (!(total > 0)) {
    c.machine.fail(c.machine.program.spans[c.node],
                   "all weights are 0: 'choose' can draw none of its values");
  }
  double draw = unit_interval(c.draw) * total;
  std::size_t i = 0;
  while (i + 1 < items.size() && draw >= weights[i].number) draw -= weights[i++].number;
  return items[i];
}

Value choose(Call c, Values) {
  const auto all = c.args;
  if (all.size() == 2 && all[0].type == Type::list && all[1].type == Type::list) {
    return choose_weighted(c, all[0].list(), all[1].list());
  }
  const auto items = all.size() == 1 && all[0].type == Type::list ? all[0].list() : all;
  if (items.empty())
    c.machine.fail(c.machine.program.spans[c.node], "'choose' has nothing to choose from");
  const auto i =
      static_cast<std::size_t>(unit_interval(c.draw) * static_cast<double>(items.size()));
  return items[std::min(i, items.size() - 1)];
}

// ---- numbers

template <class Better>
double extreme(Call c, Better better) {
  const auto items = c.args.size() == 1 && c.args[0].type == Type::list ? c.args[0].list() : c.args;
  if (items.empty()) c.machine.fail(c.machine.program.spans[c.node], "there is no number to take");
  double best = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].type != Type::number) refuse(c, std::min(i, c.args.size() - 1), "numbers");
    if (i == 0 || better(items[i].number, best)) best = items[i].number;
  }
  return best;
}
double least(Call c, Values) { return extreme(c, std::less<>()); }
double most(Call c, Values) { return extreme(c, std::greater<>()); }
double clamp_between(Call, double x, double low, double high) {
  return std::max(low, std::min(high, x));
}
double absolute(Call, double x) { return std::abs(x); }
/// The remainder has the sign of the divisor, as in mathematics.
double modulo(Call, double x, double y) { return x - y * std::floor(x / y); }
double round_down(Call, double x) { return std::floor(x); }
double round_up(Call, double x) { return std::ceil(x); }
double round_near(Call, double x) { return std::round(x); }
double root(Call, double x) { return std::sqrt(x); }
double power(Call, double x, double y) { return std::pow(x, y); }
double exponential(Call, double x) { return std::exp(x); }
double logarithm(Call, double x) { return std::log(x); }
double sine(Call, double a) { return std::sin(radians(a)); }
double cosine(Call, double a) { return std::cos(radians(a)); }
double tangent(Call, double a) { return std::tan(radians(a)); }
double arc_sine(Call, double x) { return degrees(std::asin(x)); }
double arc_cosine(Call, double x) { return degrees(std::acos(x)); }
double arc_tangent(Call, double x) { return degrees(std::atan(x)); }
double arc_tangent2(Call, double y, double x) { return degrees(std::atan2(y, x)); }

// ---- lists and texts

double length_of(Call c, Value list) {
  if (list.type == Type::list || list.type == Type::string) return list.size;
  refuse(c, 0, "a list or a string");
}

double find_in(Call c, Value list, Value item) {
  if (list.type != Type::list) refuse(c, 0, "a list");
  const auto items = list.list();
  const auto it = std::ranges::find_if(items, [&](const Value& v) { return equal(v, item); });
  return it == items.end() ? -1 : static_cast<double>(it - items.begin());
}

Value to_string(Call c, Value v) {
  switch (v.type) {
    case Type::number:
      return Value::of(c.machine.keep(number_text(v.number)));
    case Type::boolean:
      return Value::of(std::string_view(v.boolean ? "true" : "false"));
    case Type::symbol:
      return Value::of(c.machine.program.symbols[v.symbol]);
    case Type::string:
      return v;
    case Type::list:
      break;
  }
  refuse(c, 0, "a number, a symbol, true or false");
}

double to_number(Call c, std::string_view text) {
  const auto number = read_number(text);
  if (!number) {
    c.machine.fail(c.machine.program.spans[c.node],
                   "\"" + std::string(text) + "\" does not read as a number");
  }
  return *number;
}

constexpr std::array rows{
    row<draw_between>("rand", "low, high",
                      "A random number between low and high; rand() lies between 0 and 1.",
                      "rand(30, 45)", true),
    row<draw_normal>("normal", "mean, deviation", "A random number of the normal distribution.",
                     "normal(2.8, 0.1)", true),
    row<choose>("choose", "values", "One of the values at random; with a second list, by weights.",
                "choose(\"hip\", \"gable\")", true),
    row<least>("min", "values", "The least of numbers or of a list of them.", "min(W, 3)"),
    row<most>("max", "values", "The greatest of numbers or of a list of them.", "max(H - 1, 0)"),
    row<clamp_between>("clamp", "x, low, high", "x, but not below low nor above high.",
                       "clamp(W, 1, 2)"),
    row<absolute>("abs", "x", "x without its sign.", "abs(-2)"),
    row<modulo>("mod", "x, y", "What is left of x after whole ys.", "mod(7, 3)"),
    row<round_down>("floor", "x", "The next whole number below.", "floor(H / 3)"),
    row<round_up>("ceil", "x", "The next whole number above.", "ceil(H / 3)"),
    row<round_near>("round", "x", "The nearest whole number.", "round(H / 3)"),
    row<root>("sqrt", "x", "The square root.", "sqrt(area)"),
    row<power>("pow", "x, y", "x to the power of y.", "pow(W, 2)"),
    row<exponential>("exp", "x", "e to the power of x.", "exp(1)"),
    row<logarithm>("log", "x", "The natural logarithm.", "log(area)"),
    row<sine>("sin", "degrees", "The sine of an angle in degrees.", "sin(30)"),
    row<cosine>("cos", "degrees", "The cosine of an angle in degrees.", "cos(60)"),
    row<tangent>("tan", "degrees", "The tangent of an angle in degrees.", "tan(45)"),
    row<arc_sine>("asin", "x", "The angle in degrees whose sine is x.", "asin(0.5)"),
    row<arc_cosine>("acos", "x", "The angle in degrees whose cosine is x.", "acos(0.5)"),
    row<arc_tangent>("atan", "x", "The angle in degrees whose tangent is x.", "atan(1)"),
    row<arc_tangent2>("atan2", "y, x", "The direction in degrees of (x, y).", "atan2(1, 1)"),
    row<length_of>("len", "list", "How many items a list, or bytes a string, has.",
                   "len([1, 2, 3])"),
    row<find_in>("find", "list, item",
                 "The number of the first item that is equal, from 0; -1 when none is.",
                 "find([\"shop\", \"office\"], BUILDING_USE)"),
    row<to_string>("str", "value", "The value as a string.", "str(12.5)"),
    row<to_number>("num", "text", "The number that a text reads as, with an optional unit.",
                   "num(\"12.5 m\")"),
    asking<ask_cover>("Shape.occ", "set, word, distance",
                      "How far the shape is covered by the solids of a set: \"none\", \"part\" or "
                      "\"full\"; with \"distance\", d by what stands within d metres before it.",
                      "Shape.occ(\"noparent\", \"distance\", 0.5)"),
    asking<ask_inside>("inside", "set, word, distance",
                       "Whether the shape is covered as a whole, as Shape.occ says.",
                       "inside(\"all\")"),
    asking<ask_overlaps>("overlaps", "set, word, distance",
                         "Whether the shape is covered as a whole or in part.",
                         "overlaps(\"neighbours\")"),
    asking<ask_touches>("touches", "set",
                        "Whether a solid of the set ends in the plane of the shape, on it.",
                        "touches(\"noparent\")"),
    asking<ask_visible>(
        "Shape.visible", "set",
        "Whether the shortest line from the middle of the shape to the nearest solid of "
        "the set, or to the nearest \"street\", is free of solids.",
        "Shape.visible(\"street\")"),
    asking<ask_nearest>(
        "nearest", "set",
        "Metres from the shape to the nearest solid of the set that it did not come "
        "from, or in the plan to the nearest \"street\"; infinity without any.",
        "nearest(\"street\")"),
    of_group<group_any>("group.any", "condition, within",
                        "Whether the condition holds for some shape of the group.",
                        "group.any(W < 1)"),
    of_group<group_all>("group.all", "condition, within",
                        "Whether the condition holds for every shape of the group.",
                        "group.all(W > 1)"),
    of_group<group_count>("group.count", "condition, within",
                          "For how many shapes of the group the condition holds.",
                          "group.count(true)"),
    of_group<group_sum>("group.sum", "number, within", "The sum over the shapes of the group.",
                        "group.sum(area)"),
    of_group<group_max>("group.max", "number, within",
                        "The greatest number among the shapes of the group.",
                        "group.max(H, \"FOOTPRINT\")"),
    of_group<group_min>("group.min", "number, within",
                        "The least number among the shapes of the group.", "group.min(W)"),
    of_group<group_rank>("group.rank", "score, within",
                         "How many shapes of the group have a greater score, or the same and come "
                         "first: 0 for the best.",
                         "group.rank(area) < 3"),
    of_group<group_best>("group.best", "score, within",
                         "Whether no shape of the group has a greater score, nor the same and "
                         "comes first: holds for exactly one.",
                         "group.best(area)"),
    of_outcome<made>("made", "symbol",
                     "In the score of best(): how many terminals of the symbol the alternative "
                     "has.",
                     "made(\"MASS\")"),
    of_outcome<reported>("reported", "key",
                         "In the score of best(): the sum of the numbers that the alternative "
                         "gave to report(key, ...).",
                         "reported(\"floor area\")"),
};

void refuse(const FunctionCall& c, std::size_t i, std::string_view expected) {
  const ExprNode& node = c.machine.program.nodes[c.node];
  const Function& function = rows[node.aux];
  Diagnostic d;
  d.at = c.machine.program.spans[c.machine.program.children[node.children + i]];
  const std::size_t named = std::min<std::size_t>(i, function.count - 1u);
  d.text = "'" + std::string(function.name) + "' expects " + std::string(expected) + " for '" +
           std::string(function.parameter_name(named)) + "', not " +
           std::string(described(c.args[i].type));
  note_writer(d, described(c.args[i].type), c.machine.program.origin(c.args[i]));
  throw Failure(std::move(d));
}

}  // namespace

std::span<const Function> functions() { return rows; }

const Function* find_function(std::string_view name) {
  const auto it = std::ranges::find(rows, name, &Function::name);
  return it == rows.end() ? nullptr : &*it;
}

}  // namespace mansard
