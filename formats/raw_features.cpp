#include "formats/footprint_sources.hpp"
#include "formats/packed.hpp"
#include "formats/record_file.hpp"

namespace mansard {
namespace {

class StoredFeatures final : public RawFeatures {
 public:
  void add(const RawFeature& feature) override {
    pack(feature, bytes_);
    records_.add(bytes_);
  }
  std::size_t size() const override { return records_.size(); }
  void for_each(const Use& use) const override {
    RawFeature feature;
    std::string bytes;
    for (std::size_t i = 0; i < records_.size(); ++i) {
      records_.read(i, bytes);
      unpack(bytes, feature);
      use(i, feature);
    }
  }

 private:
  RecordFile records_;
  std::string bytes_;
};

}  // namespace

std::unique_ptr<RawFeatures> no_features() { return std::make_unique<StoredFeatures>(); }

}  // namespace mansard
