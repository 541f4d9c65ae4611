#include "interpreter/value.hpp"

#include <algorithm>

namespace mansard {

std::string_view described(Type type) {
  switch (type) {
    case Type::number:
      return "a number";
    case Type::boolean:
      return "true or false";
    case Type::string:
      return "a string";
    case Type::list:
      return "a list";
    case Type::symbol:
      return "a symbol";
  }
  return "a value";
}

bool equal(const Value& a, const Value& b) {
  if (a.type != b.type) return false;
  switch (a.type) {
    case Type::number:
      return a.number == b.number;
    case Type::boolean:
      return a.boolean == b.boolean;
    case Type::string:
      return a.string() == b.string();
    case Type::symbol:
      return a.symbol == b.symbol && a.size == b.size;
    case Type::list:
      return std::ranges::equal(a.list(), b.list(), equal);
  }
  return false;
}

}  // namespace mansard
