// Where reading failed furthest, and what would have been right there.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace mansard {

/// How messages speak of a rule of the grammar; a row of the table in messages.hpp.
struct Wording {
  const char* want = nullptr;  ///< "a value": goes into "expected …, not 'x'"
  const char* say = nullptr;   ///< the whole sentence, where that would not read well
  const char* help = nullptr;
  bool given = true;  ///< false for phrases that have no row
};

/// Something more particular than "expected … here", found by a rule that looks closely.
struct Complaint {
  const char *begin = nullptr, *end = nullptr;
  std::string text, help;
  const char* resume = nullptr;  ///< where the rest of the text makes sense again
};

class Trail {
 public:
  static constexpr std::size_t max_depth = 250;  ///< open brackets and unfinished ifs at once

  struct Place {
    const char* at = nullptr;  ///< the furthest refusal
    std::vector<const Wording*> wants;
    Complaint complaint;         ///< begin is null when there is none
    const char* open = nullptr;  ///< innermost bracket open there
    std::size_t braces = 0;      ///< how many '{' are open there
  };
  const Place& furthest() const { return place_; }

  /// How many wordings stand at `at`, to be given back to forget().
  std::size_t wants_at(const char* at) const { return place_.at == at ? place_.wants.size() : 0; }
  /// Drops what was wanted at `at` since wants_at() was asked.
  void forget(const char* at, std::size_t keep) {
    if (quiet_ == 0 && place_.at == at) place_.wants.resize(std::min(keep, place_.wants.size()));
  }
  /// A rule with a name of its own was refused at `at`: its name replaces those of its first
  /// tokens.
  void refuse(const char* at, const Wording& wording, std::size_t keep) {
    if (quiet_ > 0 || at < place_.at) return;
    if (at > place_.at) move_to(at);
    place_.wants.resize(std::min(keep, place_.wants.size()));
    place_.wants.push_back(&wording);
  }
  void complain(const char* at, Complaint complaint) {
    if (quiet_ > 0 || at < place_.at) return;
    if (at > place_.at) move_to(at);
    if (!place_.complaint.begin) place_.complaint = std::move(complaint);
  }
  /// After a report: what lies behind is told.
  void restart() { place_ = {}; }

  void open(const char* bracket) { open_.push_back(bracket); }
  void close() { open_.pop_back(); }
  std::size_t depth() const { return open_.size(); }
  std::size_t braces() const {
    return static_cast<std::size_t>(
        std::count_if(open_.begin(), open_.end(), [](const char* at) { return *at == '{'; }));
  }
  const char* innermost() const {
    for (auto it = open_.rbegin(); it != open_.rend(); ++it) {
      if (**it != 'i') return *it;  // an `if` is no bracket
    }
    return nullptr;
  }

  void hush() { ++quiet_; }
  void speak() { --quiet_; }
  bool quiet() const { return quiet_ > 0; }

 private:
  void move_to(const char* at) {
    place_.at = at;
    place_.wants.clear();
    place_.complaint = {};
    place_.open = innermost();
    place_.braces = braces();
  }

  Place place_;
  std::vector<const char*> open_;
  int quiet_ = 0;
};

}  // namespace mansard
