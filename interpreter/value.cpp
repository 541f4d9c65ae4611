#include "interpreter/value.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "interpreter/random.hpp"

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

uint64_t content_hash(const Value& value) {
  uint64_t hash = static_cast<uint64_t>(value.type);
  switch (value.type) {
    case Type::number:
      return mix(hash, std::isnan(value.number) ? 1 : std::bit_cast<uint64_t>(value.number + 0.0));
    case Type::boolean:
      return mix(hash, value.boolean);
    case Type::string:
      return mix(hash, hash_of(value.string()));
    case Type::symbol:
      return mix(mix(hash, value.symbol), value.size);
    case Type::list:
      for (const Value& item : value.list()) hash = mix(hash, content_hash(item));
      return hash;
  }
  return hash;
}

}  // namespace mansard
