#include "formats/packed.hpp"

#include "formats/bytes.hpp"

namespace mansard {
namespace {

enum Kind : char { number, boolean, text };

void put(std::string& to, const std::vector<Property>& properties) {
  for (const Property& property : properties) {
    put_values(to, property.name);
    const char kind = static_cast<char>(property.value.index());
    put_values(to, &kind, 1);
    if (const auto* n = std::get_if<double>(&property.value)) put_values(to, n, 1);
    if (const auto* b = std::get_if<bool>(&property.value)) put_values(to, b, 1);
    if (const auto* s = std::get_if<std::string>(&property.value)) put_values(to, *s);
  }
}

void take(Bytes& from, PropertyValue& value) {
  const char kind = from.one<char>();
  if (kind == number) {
    value = from.one<double>();
  } else if (kind == boolean) {
    value = from.one<bool>();
  } else {
    if (value.index() != text) value.emplace<std::string>();
    from.take(std::get<std::string>(value));
  }
}

/// All that is left.
void take(Bytes& from, std::vector<Property>& properties) {
  std::size_t count = 0;
  for (; from.any(); ++count) {
    if (count == properties.size()) properties.emplace_back();
    from.take(properties[count].name);
    take(from, properties[count].value);
  }
  properties.resize(count);
}

}  // namespace

void pack(const Footprint& footprint, std::string& bytes) {
  bytes.clear();
  put_values(bytes, footprint.id);
  put_values(bytes, footprint.polygon.points);
  put_values(bytes, footprint.polygon.tags);
  put_values(bytes, footprint.polygon.ring_ends);
  put(bytes, footprint.properties);
}

void unpack(std::string_view bytes, Footprint& footprint) {
  Bytes from(bytes);
  from.take(footprint.id);
  from.take(footprint.polygon.points);
  from.take(footprint.polygon.tags);
  from.take(footprint.polygon.ring_ends);
  take(from, footprint.properties);
}

void pack(const RawFeature& feature, std::string& bytes) {
  bytes.clear();
  put_values(bytes, feature.id);
  const uint64_t parts = feature.parts.size();
  put_values(bytes, &parts, 1);
  for (const RawPolygon& part : feature.parts) {
    const uint64_t rings = part.size();
    put_values(bytes, &rings, 1);
    for (const RawRing& ring : part) put_values(bytes, ring);
  }
  put(bytes, feature.properties);
}

void unpack(std::string_view bytes, RawFeature& feature) {
  Bytes from(bytes);
  from.take(feature.id);
  feature.parts.resize(from.one<uint64_t>());
  for (RawPolygon& part : feature.parts) {
    part.resize(from.one<uint64_t>());
    for (RawRing& ring : part) from.take(ring);
  }
  take(from, feature.properties);
}

}  // namespace mansard
