// Plain values as bytes and back, for what stays on this machine: pipes and nameless files.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace mansard {

/// Their number, then the values.
template <class T>
void put_values(std::string& to, const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  const uint64_t size = count;
  to.append(reinterpret_cast<const char*>(&size), sizeof size);
  to.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}
template <class Values>
void put_values(std::string& to, const Values& values) {
  put_values(to, values.data(), values.size());
}

/// Takes in the order in which they were put.
class Bytes {
 public:
  explicit Bytes(std::string_view left) : left_(left) {}
  /// Replaces a vector or a string, whose memory is used again; empty, and whole() no longer holds,
  /// where there is too little.
  template <class Values>
  void take(Values& values) {
    using T = typename Values::value_type;
    values.clear();
    uint64_t count = 0;
    whole_ = whole_ && left_.size() >= sizeof count;
    if (!whole_) return;
    std::memcpy(&count, left_.data(), sizeof count);
    left_.remove_prefix(sizeof count);
    whole_ = count <= left_.size() / sizeof(T);
    if (!whole_) return;
    values.resize(count);
    if (count > 0) std::memcpy(values.data(), left_.data(), count * sizeof(T));
    left_.remove_prefix(count * sizeof(T));
  }
  template <class Values>
  Values take() {
    Values values;
    take(values);
    return values;
  }
  /// Of values that were put alone.
  template <class T>
  T one() {
    static_assert(std::is_trivially_copyable_v<T>);
    constexpr std::size_t count = sizeof(uint64_t);
    T value{};
    whole_ = whole_ && left_.size() >= count + sizeof value;
    if (!whole_) return value;
    std::memcpy(&value, left_.data() + count, sizeof value);
    left_.remove_prefix(count + sizeof value);
    return value;
  }
  bool whole() const { return whole_; }
  bool any() const { return !left_.empty(); }

 private:
  std::string_view left_;
  bool whole_ = true;
};

}  // namespace mansard
