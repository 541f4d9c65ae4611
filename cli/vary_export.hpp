// --export: each variation as a model and as a child style, in one folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/vary_child.hpp"
#include "formats/surface_writer.hpp"

namespace mansard {

class Library;

class Export {
 public:
  /// Makes the folder when there is none. Throws Failure when it can not, and when a file that the
  /// children would write is somebody else's or one that is read.
  Export(const std::string& folder, const std::vector<Child>& children, const Library& library);
  /// Takes the folder away again when it made it and nothing is in it.
  ~Export();
  Export(const Export&) = delete;
  Export& operator=(const Export&) = delete;

  std::string model_path(const Child& child) const;
  std::string script_path(const Child& child) const;
  /// Nothing is to be seen in the folder before finish().
  void add(const Child& child, std::unique_ptr<SurfaceWriter> model, std::vector<Look> looks);
  /// Returns how many files there are now.
  std::size_t finish();

 private:
  struct Pending {
    const Child* child;
    std::unique_ptr<SurfaceWriter> model;
    std::vector<Look> looks;
  };
  std::filesystem::path folder_;
  bool made_ = false;
  std::vector<Pending> pending_;
};

}  // namespace mansard
