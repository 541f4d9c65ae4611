// What every command that compiles a style needs: the disk, the library, the program.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "cli/arguments.hpp"
#include "formats/footprints.hpp"
#include "interpreter/derivation.hpp"
#include "interpreter/program.hpp"
#include "styles/library.hpp"

namespace mansard {

/// Meshes from disk, each read once.
class DiskMeshes final : public MeshSource {
 public:
  /// From now on only what lies below the folders of the library's scripts and of its style path is
  /// read. Before, nothing is held back.
  void keep_within(const Library& library);
  const Mesh* mesh(const std::string& path, std::string& problem) override;
  bool has_picture(const std::string& path) override;
  std::string picture_problem(const std::string& path) override;

 private:
  struct Entry {
    std::optional<Mesh> mesh;
    std::string problem;
  };
  std::mutex mutex_;
  std::vector<std::string> folders_;
  /// By the folders that the reading was bound to, then by path.
  std::map<std::vector<std::string>, std::unordered_map<std::string, Entry>> known_;
  std::unordered_map<std::string, bool> pictures_;
  std::unordered_map<std::string, std::string> picture_problems_;  ///< within folders_
};

class Session {
 public:
  explicit Session(const Arguments& arguments);
  ~Session();

  /// Loads and compiles; false after errors, which are printed.
  bool compile(const std::string& script, const CompileOptions& options);
  bool compiled() const { return program_ != nullptr; }
  const Program& program() const { return *program_; }
  MeshSource& meshes() { return meshes_; }
  Library& library() { return library_; }

  /// To standard error: text, or a JSON object a line with --json.
  void print(const Diagnostic& diagnostic) const;
  /// f's exit status; a Failure is printed while the sources it points into are still there.
  template <class F>
  int guard(F f) const {
    try {
      return f();
    } catch (const Failure& failure) {
      print(failure.diagnostic);
      return exit_input;
    }
  }
  void say(const std::string& line) const;  ///< unless --quiet
  /// Which style was taken where none was asked for and the script has several:
  /// " (style Mine, the last of 6)"; else nothing.
  std::string style_taken(const Arguments& arguments) const;
  bool quiet() const { return quiet_; }

 private:
  DiskFiles files_;
  Library library_;
  DiskMeshes meshes_;
  std::unique_ptr<Program> program_;
  bool json_, color_, quiet_;
};

/// Where imports and meshes are looked for: --style-path, then the shipped library, which stands
/// beside the program when it is installed, else in the sources it was built from.
std::vector<std::string> style_path(const Arguments& arguments);
CompileOptions compile_options(const Arguments& arguments);
/// Without --seed it is the one that the style to be derived carries, else 0. `lod` stands for
/// --lod, for who reads that otherwise.
DeriveOptions derive_options(const Arguments& arguments, const Program& program,
                             std::optional<int> lod = {});
/// --threads; 0: all.
int thread_option(const Arguments& arguments);
FootprintOptions footprint_options(const Arguments& arguments);
/// Reads, marks neighbours, says what was repaired. With `keep_going` broken footprints are
/// reported and left out (`failed` counts them), else they are a Failure.
StoredSet stored_footprints(const Session& session, const std::string& what,
                            const Arguments& arguments, std::size_t& failed);
/// The same, all in memory.
FootprintSet footprints(const Session& session, const std::string& what, const Arguments& arguments,
                        std::size_t& failed);

}  // namespace mansard
