#include "cli/vary_export.hpp"

#include <fstream>
#include <set>

#include "formats/output_file.hpp"
#include "grammar/in_quotes.hpp"
#include "styles/library.hpp"

namespace mansard {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(std::string text, std::string help) {
  Diagnostic d;
  d.text = std::move(text);
  d.help = std::move(help);
  throw Failure(std::move(d));
}

bool is_ours(const fs::path& script) {
  std::ifstream in(script, std::ios::binary);
  std::string line;
  return std::getline(in, line) && line == child_mark;
}

/// A script of ours may be written over, and the model beside it; nothing else.
void refuse_foreign(const fs::path& folder, const Child& child, const std::set<std::string>& read) {
  const fs::path script = folder / (child.stem + ".style");
  std::error_code error;
  if (read.contains(fs::weakly_canonical(script, error).string()))
    refuse("--export would write over " + in_quotes(script.string()) + ", which is read",
           "give another folder");
  const bool ours = is_ours(script);
  for (const char* const ending : {".style", ".obj", ".mtl"}) {
    const fs::path file = folder / (child.stem + ending);
    if (ours || !fs::exists(fs::symlink_status(file, error))) continue;
    refuse("--export would write over " + in_quotes(file.string()) +
               ", which is not from 'mansard vary'",
           "move it away, or give another folder");
  }
}

}  // namespace

Export::Export(const std::string& folder, const std::vector<Child>& children,
               const Library& library)
    : folder_(folder) {
  std::set<std::string> read;
  std::error_code error;
  for (const syntax::Style* style : library.styles())
    read.insert(fs::weakly_canonical(style->name.at.source->name(), error).string());
  for (const Child& child : children) refuse_foreign(folder_, child, read);
  made_ = fs::create_directory(folder_, error);
  if (fs::is_directory(folder_)) return;
  refuse("can not make the folder " + in_quotes(folder) + ": " +
             (error ? error.message() : "there is a file of that name"),
         "make it first, or give another one");
}

Export::~Export() {
  pending_.clear();
  std::error_code ignored;
  if (made_) fs::remove(folder_, ignored);
}

std::string Export::model_path(const Child& child) const {
  return (folder_ / (child.stem + ".obj")).string();
}

std::string Export::script_path(const Child& child) const {
  return (folder_ / (child.stem + ".style")).string();
}

void Export::add(const Child& child, std::unique_ptr<SurfaceWriter> model,
                 std::vector<Look> looks) {
  pending_.push_back({&child, std::move(model), std::move(looks)});
}

std::size_t Export::finish() {
  for (const Pending& one : pending_) {
    OutputFile script(script_path(*one.child));  // first: it marks the model as ours
    script.put(one.child->text);
    script.commit();
    one.model->finish(one.looks);
  }
  return pending_.size();
}

}  // namespace mansard
