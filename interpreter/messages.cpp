#include "interpreter/messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "grammar/codes.hpp"
#include "grammar/utf8.hpp"
#include "interpreter/machine.hpp"

namespace mansard {

std::string count_text(std::size_t n, std::string_view noun) {
  return std::to_string(n) + " " + std::string(noun) + (n == 1 ? "" : "s");
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string script_text(const Program& program, const Value& value) {
  switch (value.type) {
    case Type::number:
      return number_text(value.number);
    case Type::boolean:
      return value.boolean ? "true" : "false";
    case Type::string:
      return "\"" + std::string(value.string()) + "\"";
    case Type::symbol: {
      auto symbol = std::string(program.symbols[value.symbol]);
      if (value.size == 0) return symbol;
      return std::string(program.styles[value.size - 1].name) + "::" + symbol;
    }
    case Type::list: {
      std::string text;
      for (const Value& item : value.list()) {
        text += (text.empty() ? "" : ", ") + script_text(program, item);
      }
      return "[" + text + "]";
    }
  }
  return {};
}

std::string shortened(std::string_view text) {
  constexpr std::size_t most = 60;  // bytes
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decode(text, at);
    if (line.size() + c.bytes > most) return line + "...";
    const bool plain = c.valid && c.value >= ' ' && c.value != 127;
    line += plain ? text.substr(at, c.bytes) : std::string_view(" ");
    at += c.bytes;
  }
  return line;
}

std::string size_text(Vec3 size) {
  return number_text(size.x) + " x " + number_text(size.y) + " x " + number_text(size.z) + " m";
}

namespace {

std::string_view rule_of(ExprKind kind) {
  switch (kind) {
    case ExprKind::add:
      return "'+' adds two numbers or joins two strings";
    case ExprKind::subtract:
      return "'-' takes two numbers";
    case ExprKind::multiply:
      return "'*' takes two numbers";
    case ExprKind::divide:
      return "'/' takes two numbers";
    case ExprKind::equal:
    case ExprKind::unequal:
      return "only values of one type can be equal";
    default:
      return "'<' and its like order two numbers or two strings";
  }
}

}  // namespace

std::optional<Diagnostic> operand_error(const Program& program, const ExprNode& node, Type left,
                                        Type right, ExprId a, ExprId b) {
  const bool numbers = left == Type::number && right == Type::number;
  const bool strings = left == Type::string && right == Type::string;
  const bool equality = node.kind == ExprKind::equal || node.kind == ExprKind::unequal;
  const bool arithmetic = node.kind < ExprKind::less;
  if (numbers || (equality && left == right)) return std::nullopt;
  if (strings && (!arithmetic || node.kind == ExprKind::add)) return std::nullopt;
  Diagnostic d;
  d.at = program.spans[a];
  d.also.push_back(program.spans[b]);
  d.text = std::string(rule_of(node.kind)) + ", not " + std::string(described(left)) + " and " +
           std::string(described(right));
  if ((left == Type::string) != (right == Type::string)) {
    d.help = "num(text) makes a number of a string, str(value) a string of a number";
  }
  return d;
}

bool is_angle(double degrees) { return std::abs(degrees) <= 360; }

std::string wrong_angle(double degrees) {
  return "an axis at " + number_text(degrees) + " degrees: an angle lies between -360 and 360";
}

bool is_component_number(double number) {
  return number >= 0 && number == std::floor(number) && number < 1e9;
}

std::string wrong_component(double number) {
  return "no component has the number " + number_text(number);
}

bool is_tolerance(double metres) { return metres >= 0 && metres <= 100; }

std::string wrong_tolerance(double metres) {
  return "a tolerance lies between 0 and 100 m, not " + number_text(metres);
}

Diagnostic size_count_error(const Call& call, std::size_t sizes) {
  const std::size_t parts = call.parts.size();
  Diagnostic d;
  d.at = call.args_at;
  // A list over several lines shows where each of its parts begins.
  const Source* const source = call.parts_at.source;
  if (source && source->line_of(call.parts_at.begin) != source->line_of(call.parts_at.end)) {
    for (const CallPart& part : call.parts) d.also.push_back(part.at);
  } else {
    d.also.push_back(call.parts_at);
  }
  d.text = "'" + std::string(call.operation->name) + "' got " + count_text(sizes, "size") +
           " for " + count_text(parts, "part");
  d.help = sizes < parts ? "add a size, or drop a part" : "add a part, or drop a size";
  return d;
}

void Machine::fail(Span at, std::string text, std::string help) {
  Diagnostic d;
  d.at = at;
  d.text = std::move(text);
  d.help = std::move(help);
  throw Failure(std::move(d));
}

/// Once for each place and building.
void Machine::warn(std::string_view code, Span at, std::string text, std::string help) {
  warn({Severity::warning, code, at, std::move(text), {}, {}, std::move(help)});
}

void Machine::warn(Diagnostic warning) {
  reads |= read_bits::aloud;
  for (const Diagnostic& known : building->warnings) {
    if (known.code != warning.code || known.at != warning.at) continue;
    if (!each_text_is_news(warning.code) || known.text == warning.text) return;
  }
  building->warnings.push_back(std::move(warning));
}

/// Says what was being derived: the rule, the chain of symbols above it, the footprint. Once: where
/// the failure was.
void Machine::explain(Diagnostic& diagnostic) {
  if (std::exchange(explained_, true)) return;
  if (production && expanding < nodes_.size()) {
    const auto symbol = std::string(program.symbols[nodes_[expanding].symbol]);
    diagnostic.notes.push_back({"while deriving '" + symbol + "' by this rule of style '" +
                                    std::string(production->from.style->name.text) + "'",
                                production->syntax->head});
  }
  std::string chain;
  std::size_t shown = 0;
  uint32_t above = expanding < nodes_.size() ? nodes_[expanding].parent : Shape::none;
  for (; above != Shape::none && shown < 8; above = nodes_[above].parent, ++shown) {
    chain += (chain.empty() ? "" : " < ") + std::string(program.symbols[nodes_[above].symbol]);
  }
  if (above != Shape::none) chain += " < ...";
  if (!chain.empty()) diagnostic.notes.push_back({"which came from " + chain, {}});
  if (footprint) diagnostic.notes.push_back({"for footprint '" + footprint->id + "'", {}});
}

Program::Program() = default;
Program::~Program() = default;

Span Program::origin(const Value& value) const {
  return value.origin < spans.size() ? spans[value.origin] : Span{};
}

void note_writer(Diagnostic& diagnostic, std::string_view what, Span written) {
  if (!written || written == diagnostic.at) return;
  if (std::ranges::find(diagnostic.also, written) != diagnostic.also.end()) return;
  const bool set = written.source->name().starts_with("--set ");
  diagnostic.notes.push_back(
      {std::string(what) + (set ? " was set on the command line" : " was written here"), written});
}

}  // namespace mansard
