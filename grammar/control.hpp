// The control of the grammar: runs every rule that has a row in messages.hpp or actions.hpp, keeps
// the trail of what was wanted where, bounds the depth, and keeps the tape in step with matching.
#pragma once

#include "grammar/actions.hpp"

namespace mansard::peg {

template <class Rule>
inline constexpr bool has_parts = !std::is_same_v<typename Rule::subs_t, type_list<>>;
template <class Rule>
inline constexpr bool is_watched = tag<Rule> != Tag::none || has_wording<Rule> ||
                                   opener<Rule> != '\0' || is_quiet<Rule> || hushes<Rule>;

/// One try of one watched rule at one place.
template <class Rule>
class Attempt {
 public:
  Attempt(Reading& reading, const char* at)
      : trail_(reading.trail), at_(at), wants_(trail_.wants_at(at)) {
    if constexpr (is_quiet<Rule>) trail_.hush();
    if constexpr (opener<Rule> != '\0') {
      opened_ = *at == opener<Rule>;
      if (opened_) trail_.open(at);
    }
  }
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  bool too_deep() {
    if constexpr (opener<Rule> != '\0') {
      if (trail_.depth() <= Trail::max_depth) return false;
      trail_.complain(at_, {at_,
                            at_ + 1,
                            "brackets and ifs stand more than " + std::to_string(Trail::max_depth) +
                                " deep in each other",
                            {},
                            nullptr});
      return true;
    }
    return false;
  }
  void finish(bool matched) {
    if constexpr (opener<Rule> != '\0') {
      if (opened_) trail_.close();
    }
    if constexpr (is_quiet<Rule>) trail_.speak();
    if (matched) return;
    if constexpr (hushes<Rule>) trail_.forget(at_, wants_);
    if constexpr (has_wording<Rule>) {
      if (trail_.furthest().at <= at_) trail_.refuse(at_, wording<Rule>, wants_);
    }
  }

 private:
  Trail& trail_;
  const char* at_;
  std::size_t wants_;
  bool opened_ = false;
};

template <class Rule>
struct control : normal<Rule> {
  template <apply_mode A, rewind_mode M, template <class...> class Action,
            template <class...> class Control, class In>
  static bool match(In& in, Reading& reading) {
    constexpr bool acting = A == apply_mode::action;
    if constexpr (is_watched<Rule>) {
      return watched_match<A, Action, Control>(in, reading);
    } else if constexpr (acting && has_parts<Rule>) {
      const uint32_t mark = reading.tape.size();
      const bool matched = normal<Rule>::template match<A, M, Action, Control>(in, reading);
      if (!matched) reading.tape.cut(mark);
      return matched;
    } else {
      return normal<Rule>::template match<A, M, Action, Control>(in, reading);
    }
  }

 private:
  template <apply_mode A, template <class...> class Action, template <class...> class Control,
            class In>
  static bool watched_match(In& in, Reading& reading) {
    constexpr bool acting = A == apply_mode::action;
    const uint32_t mark = reading.tape.size();
    auto rewind = in.template mark<rewind_mode::required>();
    const char* begin = in.current();
    if constexpr (!is_tight<Rule>) begin = reading.after_space(begin);
    if constexpr (tag<Rule> != Tag::none) in.bump(static_cast<std::size_t>(begin - in.current()));

    Attempt<Rule> attempt(reading, begin);
    const bool matched =
        !attempt.too_deep() &&
        normal<Rule>::template match<A, rewind_mode::active, Action, Control>(in, reading);
    attempt.finish(matched);
    if constexpr (acting) {
      if (!matched) {
        reading.tape.cut(mark);
      } else if constexpr (tag<Rule> != Tag::none) {
        if (!folds<Rule> || !reading.tape.single(mark)) {
          reading.tape.add(tag<Rule>, reading.offset(begin), reading.offset(in.current()), mark);
        }
      }
    }
    return rewind(matched);
  }
};

}  // namespace mansard::peg
