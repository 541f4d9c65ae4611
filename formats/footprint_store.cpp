#include "formats/footprint_store.hpp"

#include "formats/packed.hpp"

namespace mansard {

void FootprintStore::add(const Footprint& footprint) {
  std::string bytes;
  pack(footprint, bytes);
  records_->add(bytes);
}

void FootprintStore::keep(const std::vector<uint32_t>& numbers) {
  if (numbers.size() == size()) return;
  std::vector<uint32_t> kept;
  kept.reserve(numbers.size());
  for (const uint32_t number : numbers) kept.push_back(kept_ ? (*kept_)[number] : number);
  kept_ = std::move(kept);
}

const Footprint& FootprintStore::get(std::size_t number, Footprint& room) const {
  thread_local std::string bytes;
  const std::size_t record = kept_ ? (*kept_)[number] : number;
  records_->read(record, bytes);
  unpack(bytes, room);
  room.around = around_;
  room.place = static_cast<uint32_t>(record);
  return room;
}

}  // namespace mansard
