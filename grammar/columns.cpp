#include "grammar/columns.hpp"

#include <algorithm>

namespace mansard::layout {

namespace {

constexpr std::size_t most_together = 20;  // rows, where not all of them can be aligned

class Columns {
 public:
  Columns(std::span<const Row> rows, int column, Page& page, const Tokens& tokens,
          const std::function<void(const Row&)>& write)
      : rows_(rows), column_(column), page_(page), tokens_(tokens), write_(write) {
    for (const Row& row : rows) plain_.push_back(one_line(row) ? Page::Cost{} : cost(row));
    at_.resize(rows.size());
  }

  /// Rows that follow each other with one key.
  void align(std::size_t begin, std::size_t end, bool weights) {
    weights_ = weights;
    if (end - begin < 2 || aligned(begin, end)) return;
    if (rows_[begin].all_or_none && !weights) return;
    while (begin < end) {
      const std::size_t last = std::min(end, begin + most_together);
      std::size_t behind = begin + 1;
      while (behind < last && aligned(begin, behind + 1)) ++behind;
      aligned(begin, behind);
      begin = behind;
    }
  }

 private:
  struct At {  // how far a row is laid out
    uint32_t token = 0;
    int column = 0;
  };

  std::span<const uint32_t> stops(std::size_t i) const {
    const Row& row = rows_[i];
    if (!weights_) return row.stops;
    return {&row.weight, row.weight == 0 ? std::size_t{0} : std::size_t{1}};
  }
  bool one_line(const Row& row) const {
    return page_.flat(row.line) && column_ + page_.width(row.line) <= page_width;
  }
  Page::Cost cost(const Row& row) {
    return page_.cost([&] { write_(row); });
  }

  // False when it would not do; then nothing is padded.
  bool aligned(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) at_[i] = {rows_[i].line.first, column_};
    bool good = true, more = true;
    for (std::size_t stop = 0; good && more; ++stop) {
      more = false;
      for (std::size_t from = begin; from < end;) {
        std::size_t to = from;
        while (to < end && stops(to).size() > stop) ++to;
        good = good && pad(from, to, stop);
        more = more || to > from;
        from = std::max(to, from + 1);
      }
    }
    for (std::size_t i = begin; good && i < end; ++i) good = fits(i);
    for (std::size_t i = begin; !good && i < end; ++i) {
      for (const uint32_t stop : stops(i)) page_.pad(stop, 0);
    }
    return good;
  }

  int reached(std::size_t i, uint32_t token) const {
    const Range range{at_[i].token, token};
    const int padding = token > range.first + 1 ? page_.padding({range.first + 1, token - 1}) : 0;
    return at_[i].column + page_.width(range) - tokens_[token].width + padding;
  }

  bool pad(std::size_t from, std::size_t to, std::size_t stop) {
    int target = 0;
    for (std::size_t i = from; i < to; ++i) target = std::max(target, reached(i, stops(i)[stop]));
    bool good = true;
    for (std::size_t i = from; i < to; ++i) {
      const uint32_t token = stops(i)[stop];
      const int padding = target - reached(i, token);
      good = good && padding <= rows_[i].most_padding;
      page_.pad(token, padding);
      at_[i] = {token, target};
    }
    return good;
  }

  bool padded(std::size_t i) const {
    return std::ranges::any_of(stops(i), [&](uint32_t s) { return page_.padding({s, s}) > 0; });
  }

  bool fits(std::size_t i) {
    const Row& row = rows_[i];
    if (!one_line(row)) return !padded(i) || cost(row) <= plain_[i];
    return reached(i, row.line.last) + tokens_[row.line.last].width <= page_width;
  }

  std::span<const Row> rows_;
  int column_;
  Page& page_;
  const Tokens& tokens_;
  const std::function<void(const Row&)>& write_;
  std::vector<At> at_;
  std::vector<Page::Cost> plain_;  // before anything is aligned
  bool weights_ = false;
};

}  // namespace

void align(std::span<const Row> rows, int column, Page& page, const Tokens& tokens,
           const std::function<void(const Row&)>& write) {
  Columns columns(rows, column, page, tokens, write);
  const auto each_run = [&](std::string_view Row::*key, bool weights) {
    for (std::size_t begin = 0; begin < rows.size();) {
      std::size_t end = begin + 1;
      while (end < rows.size() && !(rows[begin].*key).empty() &&
             rows[end].*key == rows[begin].*key && !rows[end].apart) {
        ++end;
      }
      columns.align(begin, end, weights);
      begin = end;
    }
  };
  each_run(&Row::key, false);
  each_run(&Row::symbol, true);
}

}  // namespace mansard::layout
