// Turns a C++ function's own signature into the row of a table: how many arguments, of which types,
// which may be left out. So the check, the call and the documentation can not disagree.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "interpreter/value.hpp"

namespace mansard {

enum class ArgType : uint8_t {
  number,
  length,
  boolean,
  string,
  value,
  edges,
  sizes,
  values,
  setting
};

struct Parameter {
  ArgType type = ArgType::value;
  bool optional = false;
  bool named = false;  ///< given by its name only
};

/// An argument that may be left out and that only its name gives: `tolerance = 0.2`.
template <class T>
struct Option : std::optional<T> {
  using std::optional<T>::optional;
};

/// A number of metres, or a share of the scope along the axis it stands for.
struct Length {
  double value = 0;
  bool share = false;
  double metres(double whole) const { return share ? value * whole : value; }
};
/// The sizes of a split: the rest of the arguments, evaluated when asked for.
struct Sizes {
  uint32_t first = 0;
};
/// The rest of the arguments as values.
struct Values {
  uint32_t first = 0;
};
/// Which edges or faces: words and numbers, one or a list.
struct Edges {
  Value value;
};
/// An expression that gives a T, evaluated by the function itself: for each shape of a group.
template <class T>
struct Each {
  uint32_t expr = 0;
};
/// An argument that the operation itself evaluates, when its parts are derived.
struct Score {
  std::size_t place = 0;
};
/// The variable that set() names; its number is in the call.
struct Setting {};

template <class T>
struct parameter_of;
template <>
struct parameter_of<double> {
  static constexpr Parameter is{ArgType::number, false};
};
template <>
struct parameter_of<Length> {
  static constexpr Parameter is{ArgType::length, false};
};
template <>
struct parameter_of<bool> {
  static constexpr Parameter is{ArgType::boolean, false};
};
template <>
struct parameter_of<std::string_view> {
  static constexpr Parameter is{ArgType::string, false};
};
template <>
struct parameter_of<Value> {
  static constexpr Parameter is{ArgType::value, false};
};
template <>
struct parameter_of<Edges> {
  static constexpr Parameter is{ArgType::edges, false};
};
template <>
struct parameter_of<Sizes> {
  static constexpr Parameter is{ArgType::sizes, false};
};
template <>
struct parameter_of<Values> {
  static constexpr Parameter is{ArgType::values, true};
};
template <class T>
struct parameter_of<Each<T>> {
  static constexpr Parameter is{parameter_of<T>::is.type, false};
};
template <>
struct parameter_of<Score> {
  static constexpr Parameter is{ArgType::number, false};
};
template <>
struct parameter_of<Setting> {
  static constexpr Parameter is{ArgType::setting, false};
};
template <class T>
struct parameter_of<std::optional<T>> {
  static constexpr Parameter is{parameter_of<T>::is.type, true};
};

template <class T>
struct parameter_of<Option<T>> {
  static constexpr Parameter is{parameter_of<T>::is.type, true, true};
};

inline constexpr std::size_t max_parameters = 16;

/// How many comma-separated names a row gives its parameters.
constexpr std::size_t names_in(std::string_view names) {
  if (names.empty()) return 0;
  std::size_t n = 1;
  for (const char c : names) n += c == ',';
  return n;
}

/// The name of parameter i in "height, corners": without space.
constexpr std::string_view name_of(std::string_view names, std::size_t i) {
  for (; i > 0; --i) names.remove_prefix(names.find(',') + 1);
  names = names.substr(0, names.find(','));
  while (!names.empty() && names.front() == ' ') names.remove_prefix(1);
  return names;
}

}  // namespace mansard
