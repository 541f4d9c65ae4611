// Textures beside a model.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace mansard {

/// Copies each picture once into the model's folder, under a name that no other has and that begins
/// with the model's: quarter_brick.jpg.
class CopiedPictures {
 public:
  explicit CopiedPictures(const std::string& model);
  /// The name of the copy. Throws Failure when the picture can not be read.
  const std::string& name_of(const std::string& path);
  /// Likewise, of a picture that was made for the model.
  std::string put(const std::string& file, const std::string& bytes);

 private:
  std::string free_name(const std::string& file);

  std::filesystem::path folder_;
  std::string prefix_;
  std::map<std::string, std::string> names_;
  std::set<std::string> taken_;
};

/// The bytes of a picture's file. Throws Failure when it can not be read or is no file.
std::string picture_bytes(const std::string& path);

}  // namespace mansard
