// Footprints of a city: in memory while they are few, beyond that on disk.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formats/record_file.hpp"
#include "interpreter/footprint.hpp"

namespace mansard {

/// Memory grows by some bytes a footprint, whatever its outline and properties. Throws Failure as
/// RecordFile does.
class FootprintStore final : public FootprintSource {
 public:
  /// Before keep() and set_around().
  void add(const Footprint& footprint);
  /// From now on only these, numbered in their order; numbers of before.
  void keep(const std::vector<uint32_t>& numbers);
  /// Of every footprint; its place is its number among all that were added.
  void set_around(std::shared_ptr<const Surroundings> around) { around_ = std::move(around); }

  std::size_t size() const override { return kept_ ? kept_->size() : records_->size(); }
  const Footprint& get(std::size_t number, Footprint& room) const override;
  /// f(number, footprint), in order; what f changes is not kept.
  template <class F>
  void for_each(F f) const {
    Footprint room;
    for (std::size_t i = 0; i < size(); ++i) {
      get(i, room);
      f(static_cast<uint32_t>(i), room);
    }
  }
  /// Keeps the footprints for which f(footprint) holds.
  template <class F>
  void keep_if(F f) {
    std::vector<uint32_t> numbers;
    for_each([&](uint32_t number, const Footprint& footprint) {
      if (f(footprint)) numbers.push_back(number);
    });
    keep(numbers);
  }

 private:
  std::shared_ptr<RecordFile> records_ = std::make_shared<RecordFile>();  ///< shared by copies
  std::optional<std::vector<uint32_t>> kept_;
  std::shared_ptr<const Surroundings> around_;
};

}  // namespace mansard
