// The models that derive writes: which formats, which files, with which options.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {

/// A model at a level of detail.
struct ModelTarget {
  int lod = 3;
  std::string path;
};

struct ModelOptions {
  std::vector<ModelTarget> targets;  ///< the finest first; --lod all has three
  Up up = Up::y;
  GltfOptions gltf;
};

/// -o, --lod, --up, --instancing and --compress. Throws UsageError for what does not go together,
/// among it a model or a report that would be written over what is read.
ModelOptions model_options(const Arguments& arguments);

std::unique_ptr<SurfaceWriter> open_model(const std::string& path, const ModelOptions& options,
                                          const std::string& comment);

}  // namespace mansard
