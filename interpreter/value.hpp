// The values of expressions. A value remembers who wrote it, so that an error lands on the literal,
// the variable or the command line that gave it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace mansard {

enum class Type : uint8_t { number, boolean, string, list, symbol };

/// "a number", "a string", … for messages.
std::string_view described(Type type);

/// Trivially copyable; strings and lists point into the program, the footprint or the derivation's
/// arena, all of which outlive the building.
struct Value {
  static constexpr uint32_t unknown_origin = 0xffffffff;

  Type type = Type::number;
  uint32_t size =
      0;  ///< bytes of a string, items of a list, 1 + style of a symbol (0: the current)
  uint32_t origin = unknown_origin;  ///< expression node that wrote it, or see Program::origin
  union {
    double number = 0;
    bool boolean;
    const char* text;
    const Value* items;
    uint32_t symbol;
  };

  static Value of(double v) {
    Value r;
    r.number = v;
    return r;
  }
  static Value of(bool v) {
    Value r;
    r.type = Type::boolean;
    r.boolean = v;
    return r;
  }
  static Value of(std::string_view v) {
    Value r;
    r.type = Type::string;
    r.size = static_cast<uint32_t>(v.size());
    r.text = v.data();
    return r;
  }
  static Value of(std::span<const Value> v) {
    Value r;
    r.type = Type::list;
    r.size = static_cast<uint32_t>(v.size());
    r.items = v.data();
    return r;
  }
  static Value of_symbol(uint32_t symbol, uint32_t style_plus_one = 0) {
    Value r;
    r.type = Type::symbol;
    r.size = style_plus_one;
    r.symbol = symbol;
    return r;
  }

  std::string_view string() const { return {text, size}; }
  std::span<const Value> list() const { return {items, size}; }
  Value from(uint32_t node) const {
    Value r = *this;
    r.origin = node;
    return r;
  }
};

/// Same type and same content; lists item by item.
bool equal(const Value& a, const Value& b);
/// The same for equal values, and for all numbers that are none.
uint64_t content_hash(const Value& value);

}  // namespace mansard
