// What the functions of the table of operations see of a derivation. Private to the interpreter.
#pragma once

#include <array>
#include <optional>

#include "interpreter/machine.hpp"

namespace mansard {

/// An operation carried out on a shape: what the functions of the table see.
class Context {
 public:
  Context(Machine& m, const Call& c, Shape& s, const Env& e)
      : machine(m), call(c), shape(s), env(e) {}

  Machine& machine;
  const Call& call;
  Shape& shape;  ///< the current shape; operations without parts change it
  const Env& env;

  bool has_parts() const { return call.has_parts; }
  /// Goes on with part i of the rule's list.
  void part(std::size_t i, Shape& piece);
  /// Goes on with the named part `i` of the operation's row, if the rule gives it.
  void named_part(std::size_t i, Shape& piece);
  bool wants(std::size_t i) const { return i < call.part_of.size() && call.part_of[i] != none; }
  /// The single part, or the rest of the rule.
  void become(Shape& piece);

  bool given(std::size_t i) const { return i < call.args.size() && call.args[i].value != none; }
  Value value(std::size_t i);
  double number(std::size_t i);
  Span at(std::size_t i) const;
  [[noreturn]] void wrong_type(std::size_t i, const Value& value, std::string_view expected);
  [[noreturn]] void fail(std::size_t i, std::string text, std::string help = {});

  template <class T>
  T take(std::size_t i);

  void go_on(const CallPart& part, std::size_t i, Shape& piece);

  /// Numbers what the parts of a split with sizes ':' emit part by part; look_apart() for one that
  /// is not carried out.
  void count_apart();
  void look_apart();
  /// The stream of a part, of which split_index and its like are set on the piece.
  uint64_t stream_of(const CallPart& part, const Shape& piece) const;

 private:
  bool apart_ = false;
  uint64_t stream_ = 0;
  std::array<uint32_t, most_part_names> pieces_{};  ///< given to each named part so far
};

template <>
double Context::take<double>(std::size_t i);
template <>
Length Context::take<Length>(std::size_t i);
template <>
bool Context::take<bool>(std::size_t i);
template <>
std::string_view Context::take<std::string_view>(std::size_t i);
template <>
Value Context::take<Value>(std::size_t i);
template <>
Edges Context::take<Edges>(std::size_t i);
template <>
Sizes Context::take<Sizes>(std::size_t i);
template <>
Values Context::take<Values>(std::size_t i);
template <>
Score Context::take<Score>(std::size_t i);
template <>
Setting Context::take<Setting>(std::size_t i);

template <class T>
struct taker {
  static T take(Context& c, std::size_t i) { return c.take<T>(i); }
};
template <class T>
struct taker<Option<T>> {
  static Option<T> take(Context& c, std::size_t i) {
    if (!c.given(i)) return {};
    return c.take<T>(i);
  }
};
template <class T>
struct taker<std::optional<T>> {
  static std::optional<T> take(Context& c, std::size_t i) {
    if (!c.given(i)) return std::nullopt;
    return c.take<T>(i);
  }
};

}  // namespace mansard
