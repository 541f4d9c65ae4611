// What can be folded away: braces over several lines, long comments, runs of comment lines.
#include "cli/lsp/features.hpp"
#include "cli/lsp/tokens.hpp"

namespace mansard::lsp {

namespace {

class Folds {
 public:
  explicit Folds(const Lines& lines) : lines_(lines) {}

  void take(const Token& token) {
    if (token.kind == TokenKind::comment) return take_comment(token);
    if (token.is("{")) open_.push_back(line(token.begin));
    if (!token.is("}") || open_.empty()) return;
    add(open_.back(), line(token.begin), nullptr);
    open_.pop_back();
  }

  std::vector<Json> all() {
    end_run();
    return std::move(folds_);
  }

 private:
  uint32_t line(uint32_t offset) const { return lines_.position(offset).line; }

  void take_comment(const Token& token) {
    const uint32_t first = line(token.begin), last = line(token.end);
    if (token.text.starts_with("/*")) return add(first, last, "comment");
    if (!in_run_ || first != run_last_ + 1) {
      end_run();
      run_first_ = first;
    }
    in_run_ = true;
    run_last_ = first;
  }

  void end_run() {
    if (in_run_) add(run_first_, run_last_, "comment");
    in_run_ = false;
  }

  void add(uint32_t first, uint32_t last, const char* kind) {
    if (first >= last) return;
    Json fold = Json::object({{"startLine", first}, {"endLine", last}});
    if (kind) fold.put("kind", kind);
    folds_.push_back(std::move(fold));
  }

  const Lines& lines_;
  std::vector<uint32_t> open_;
  bool in_run_ = false;
  uint32_t run_first_ = 0, run_last_ = 0;
  std::vector<Json> folds_;
};

}  // namespace

Json folding_ranges(Project& project, const Params& params) {
  const Cursor at = project.whole(params);
  const Source& source = *at.file->source;
  Folds folds(at.view->lines(source));
  for (const Token& token : tokens_of(source.text())) folds.take(token);
  return Json::array(folds.all());
}

}  // namespace mansard::lsp
