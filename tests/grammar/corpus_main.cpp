// Runs the fuzzer's function over every file of the given folders and over damaged copies of each:
// a short, repeatable run of the fuzzer where there is no libFuzzer.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<uint8_t>;

std::vector<Bytes> read_folders(int argc, char** argv) {
  std::vector<std::filesystem::path> paths;
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      if (entry.is_regular_file()) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> files;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>{});
  }
  return files;
}

/// Leaves something out, says it twice, takes it from another file, or changes a byte.
void damage(Bytes& bytes, const Bytes& other, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const auto at = static_cast<std::ptrdiff_t>(below(bytes.size()));
  const auto from = static_cast<std::ptrdiff_t>(below(other.size()));
  const auto rest = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(bytes.size()) - at);
  const auto most = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(other.size()) - from);
  switch (random() % 4) {
    case 0:
      bytes.erase(
          bytes.begin() + at,
          bytes.begin() + at + static_cast<std::ptrdiff_t>(below(std::min<std::size_t>(rest, 40))));
      break;
    case 1: {
      const Bytes again(
          bytes.begin() + at,
          bytes.begin() + at + static_cast<std::ptrdiff_t>(below(std::min<std::size_t>(rest, 40))));
      bytes.insert(bytes.begin() + at, again.begin(), again.end());
      break;
    }
    case 2:
      bytes.insert(bytes.begin() + at, other.begin() + from,
                   other.begin() + from +
                       static_cast<std::ptrdiff_t>(below(std::min<std::size_t>(most, 40))));
      break;
    default:
      if (!bytes.empty())
        bytes[static_cast<std::size_t>(at)] = static_cast<uint8_t>(32 + random() % 95);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Bytes> files = read_folders(argc, argv);
  std::mt19937 random(7);
  for (const Bytes& file : files) {
    LLVMFuzzerTestOneInput(file.data(), file.size());
    for (int copy = 0; copy < 20; ++copy) {
      Bytes damaged = file;
      for (int times = 1 + static_cast<int>(random() % 4); times > 0; --times) {
        damage(damaged, files[random() % files.size()], random);
      }
      LLVMFuzzerTestOneInput(damaged.data(), damaged.size());
    }
  }
  std::printf("%zu files, each in 21 states\n", files.size());
  return files.empty() ? 1 : 0;
}
