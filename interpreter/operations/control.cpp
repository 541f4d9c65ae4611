// Labels, settings, and what a script says while it runs.
#include <algorithm>
#include <cmath>

#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"

namespace mansard {
namespace {

std::string text_of(const Program& program, const Value& value) {
  return value.type == Type::string ? std::string(value.string()) : script_text(program, value);
}

}  // namespace

namespace operation {

void label(Context& c, std::string_view name) {
  const auto known = c.machine.program.symbols.find(name);
  c.shape.label = known.value_or(Shape::none);
}

/// yes and no as scripts that were written for others have them.
void occluder(Context& c, Value hides) {
  const bool word =
      hides.type == Type::string && (hides.string() == "yes" || hides.string() == "no");
  if (hides.type != Type::boolean && !word) c.wrong_type(0, hides, "true or false");
  c.shape.hides = word ? hides.string() == "yes" : hides.boolean;
}

/// The value holds for this shape and its descendants.
void set(Context& c, Setting, Value value) {
  const Value kept =
      value.type == Type::list
          ? Value::of(std::span<const Value>(c.machine.keep(value.list()), value.size))
                .from(value.origin)
          : value;
  c.machine.settings.push_back({c.call.setting, c.shape.settings, kept});
  c.shape.settings = static_cast<uint32_t>(c.machine.settings.size() - 1);
}

void report(Context& c, std::string_view key, Value value) {
  ReportEntry& entry = c.machine.building->report[std::string(key)];
  ++entry.count;
  if (value.type != Type::number) {
    ++entry.strings[text_of(c.machine.program, value)];
    return;
  }
  if (!std::isfinite(value.number)) c.fail(1, "this is not a finite number");
  entry.sum += value.number;
  entry.least = entry.count == 1 ? value.number : std::min(entry.least, value.number);
  entry.most = entry.count == 1 ? value.number : std::max(entry.most, value.number);
}

void print(Context& c, Values values) {
  std::string line;
  for (std::size_t i = values.first; i < c.call.args.size(); ++i) {
    line += (line.empty() ? "" : " ") + text_of(c.machine.program, c.value(i));
  }
  c.machine.building->printed.push_back(std::move(line));
}

void fail(Context& c, std::string_view message) {
  if (message.empty()) {
    c.machine.fail(c.call.at, "the style fails here, and does not say why",
                   "give fail() a message");
  }
  c.machine.fail(c.call.at, "the style says: " + std::string(message));
}

}  // namespace operation
}  // namespace mansard
