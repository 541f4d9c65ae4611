#include "cli/models.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace mansard {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> endings{".obj", ".glb", ".gltf", ".ply", ".stl"};

std::string ending_of(const std::string& path) {
  const auto ending = std::ranges::find_if(endings, [&](auto e) { return path.ends_with(e); });
  if (ending == endings.end())
    throw UsageError("'" + path +
                     "' has no ending that is written: .obj, .glb, .gltf, .ply or .stl");
  return std::string(*ending);
}

/// town.obj: town_lod1.obj.
std::string with_lod(const std::string& path, int lod) {
  const std::string ending = ending_of(path);
  return path.substr(0, path.size() - ending.size()) + "_lod" + std::to_string(lod) + ending;
}

std::vector<ModelTarget> targets_of(const Arguments& arguments) {
  const auto out = arguments.value("--output");
  if (!out) throw UsageError("say where the model goes: -o OUT.obj or OUT.glb");
  ending_of(*out);
  const std::string lod = arguments.text("--lod", "3");
  if (lod == "all") return {{3, with_lod(*out, 3)}, {2, with_lod(*out, 2)}, {1, with_lod(*out, 1)}};
  if (lod != "1" && lod != "2" && lod != "3")
    throw UsageError("--lod takes 1, 2, 3 or all, not '" + lod + "'");
  return {{lod[0] - '0', *out}};
}

/// One of the words that a flag takes; the first of them without the flag.
std::size_t word_of(const Arguments& arguments, std::string_view flag,
                    std::span<const std::string_view> words) {
  const std::string word = arguments.text(flag, std::string(words.front()));
  const auto at = std::ranges::find(words, word);
  if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i)
    all += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + std::string(words[i]);
  throw UsageError(std::string(flag) + " takes " + all + ", not '" + word + "'");
}

void refuse_misplaced_flags(const Arguments& arguments, const ModelOptions& options) {
  const std::string ending = ending_of(options.targets.front().path);
  const bool is_gltf = ending == ".glb" || ending == ".gltf";
  if (is_gltf && options.up == Up::z)
    throw UsageError("--up z is for .obj, .ply and .stl: glTF is always y up");
  for (const char* const flag : {"--instancing", "--compress"}) {
    if (!is_gltf && arguments.has(flag))
      throw UsageError(std::string(flag) + " is for .glb and .gltf: " + ending +
                       " has no word for it");
  }
}

/// Nothing that is read is written over, and the report not over the model.
void refuse_own_input(const Arguments& arguments, const ModelOptions& options) {
  std::vector<std::pair<std::string, std::string>> outputs;
  for (const ModelTarget& target : options.targets) outputs.emplace_back("-o", target.path);
  const auto report = arguments.value("--report");
  if (report) outputs.emplace_back("--report", *report);
  for (const auto& [flag, path] : outputs) {
    for (const std::string& input : arguments.positional()) {
      std::error_code missing;
      if (fs::equivalent(input, path, missing))
        throw UsageError(flag + " " + path + " would write over what is read from '" + input +
                         "': give it another name");
    }
    if (report && flag == "-o" && path == *report)
      throw UsageError("--report and -o name the same file: '" + path + "'");
  }
}

}  // namespace

ModelOptions model_options(const Arguments& arguments) {
  constexpr std::array<std::string_view, 2> ups{"y", "z"};
  constexpr std::array<std::string_view, 3> instancings{"nodes", "gpu", "none"};
  constexpr std::array<std::string_view, 2> compressions{"none", "draco"};
  ModelOptions options;
  options.targets = targets_of(arguments);
  options.up = word_of(arguments, "--up", ups) == 0 ? Up::y : Up::z;
  options.gltf.instancing =
      std::array{Instancing::nodes, Instancing::gpu,
                 Instancing::copies}[word_of(arguments, "--instancing", instancings)];
  options.gltf.draco = word_of(arguments, "--compress", compressions) == 1;
  refuse_misplaced_flags(arguments, options);
  refuse_own_input(arguments, options);
  return options;
}

std::unique_ptr<SurfaceWriter> open_model(const std::string& path, const ModelOptions& options,
                                          const std::string& comment) {
  const std::string ending = ending_of(path);
  if (ending == ".obj") return write_obj(path, options.up, comment);
  if (ending == ".ply" || ending == ".stl") return write_triangles(path, options.up);
  return write_gltf(path, comment, options.gltf);
}

}  // namespace mansard
