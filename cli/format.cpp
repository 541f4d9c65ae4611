// mansard format
#include "grammar/format.hpp"

#include <unistd.h>

#include <cstdio>

#include "cli/arguments.hpp"
#include "cli/difference.hpp"
#include "formats/output_file.hpp"
#include "styles/files.hpp"

namespace mansard {
namespace {

constexpr std::string_view standard_input = "<standard input>";

enum class Way : uint8_t { print, write, compare };

void print(const std::string& text, std::FILE* to) { std::fwrite(text.data(), 1, text.size(), to); }

std::string read_standard_input() {
  std::string text;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stdin)) {
    text.append(buffer, count);
    if (text.size() > Source::max_bytes) break;  // parse() says so
  }
  return text;
}

std::string contents(const std::string& path) {
  DiskFiles files;
  if (auto text = files.read(path)) return *std::move(text);
  Diagnostic d;
  d.text = files.exists(path) ? "'" + path + "' can not be read as a file"
                              : "there is no file '" + path + "'";
  throw Failure(std::move(d));
}

class Formatting {
 public:
  explicit Formatting(const Arguments& arguments)
      : json_(arguments.has("--json")),
        color_(!arguments.has("--no-color") && isatty(STDERR_FILENO) == 1),
        quiet_(arguments.has("--quiet")),
        diff_(arguments.has("--diff")),
        check_(arguments.has("--check")),
        way_(arguments.has("--write") ? Way::write
             : diff_ || check_        ? Way::compare
                                      : Way::print) {
    if (way_ == Way::write && (diff_ || check_))
      throw UsageError("--write changes the files; --diff and --check leave them alone: give one");
  }

  void all(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      try {
        one(path);
      } catch (const Failure& failure) {
        complain(failure.diagnostic);
        good_ = false;
      }
    }
    if (quiet_ || changed_ == 0) return;
    const std::string files = std::to_string(changed_) + (changed_ == 1 ? " file" : " files");
    if (way_ == Way::write) print(files + " changed\n", stderr);
    if (check_) print(files + " would change\n", stderr);
  }
  int status() const { return good_ && !(check_ && changed_ > 0) ? exit_done : exit_input; }

 private:
  void one(const std::string& path) {
    const bool is_input = path == "-";
    if (is_input && way_ == Way::write)
      throw UsageError("--write takes files: standard input can not be written to");
    const std::string name(is_input ? standard_input : path);
    const Source source(name, is_input ? read_standard_input() : contents(path));
    Diagnostics diagnostics;
    const std::optional<std::string> text = format(source, diagnostics);
    diagnostics.sort();
    for (const Diagnostic& d : diagnostics.all()) complain(d);
    if (!text) {
      good_ = false;
    } else if (way_ == Way::print) {
      print(*text, stdout);
    } else if (*text != source.text()) {
      ++changed_;
      changed(path, name, source, *text);
    }
  }

  void changed(const std::string& path, const std::string& name, const Source& source,
               const std::string& text) const {
    if (way_ == Way::write) {
      OutputFile file(path);
      file.put(text);
      file.commit();
    } else if (diff_) {
      print(difference(name, source.text(), text), stdout);
    } else {
      print(name + "\n", stdout);
    }
  }

  void complain(const Diagnostic& d) const {
    print(json_ ? to_json(d) + "\n" : to_text(d, color_), stderr);
  }

  bool json_, color_, quiet_, diff_, check_;
  Way way_;
  bool good_ = true;
  std::size_t changed_ = 0;
};

}  // namespace

int run_format(const Arguments& arguments) {
  Formatting formatting(arguments);
  const std::vector<std::string>& given = arguments.positional();
  formatting.all(given.empty() ? std::vector<std::string>{"-"} : given);
  return formatting.status();
}

}  // namespace mansard
