#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "styles/files.hpp"

namespace fs = std::filesystem;

namespace {

/// A folder that is gone after the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("mansard_files_" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

}  // namespace

TEST_CASE("the disk gives a file's bytes as they are") {
  const Folder folder;
  const std::string path = folder.path / "a.style";
  const std::string bytes("one\r\n\0two", 9);
  std::ofstream(path, std::ios::binary) << bytes;
  mansard::DiskFiles disk;
  CHECK(disk.exists(path));
  CHECK(disk.read(path) == bytes);
}

TEST_CASE("the disk refuses folders, devices and what is not there") {
  const Folder folder;
  mansard::DiskFiles disk;
  CHECK(!disk.read(folder.path));
  CHECK(!disk.read("/dev/zero"));
  CHECK(!disk.read(folder.path / "nothing.style"));
  CHECK(!disk.exists(folder.path / "nothing.style"));
  CHECK(!disk.read(""));
}

TEST_CASE("the disk reads a pipe to its end") {
  const Folder folder;
  const std::string path = folder.path / "pipe";
  REQUIRE(mkfifo(path.c_str(), 0600) == 0);
  const std::string bytes(300000, 'x');
  std::thread writer([&] { std::ofstream(path, std::ios::binary) << bytes; });
  mansard::DiskFiles disk;
  CHECK(disk.read(path) == bytes);
  writer.join();
}

TEST_CASE("all spellings of a file have one identity") {
  const Folder folder;
  const std::string path = folder.path / "a.style";
  std::ofstream(path) << "x";
  fs::create_symlink(path, folder.path / "link.style");
  mansard::DiskFiles disk;
  CHECK(disk.identity(folder.path / "." / "a.style") == disk.identity(path));
  CHECK(disk.identity(folder.path / "link.style") == disk.identity(path));
  CHECK(disk.identity(folder.path / "b.style") != disk.identity(path));
}
