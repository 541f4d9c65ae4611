#include "interpreter/roof_words.hpp"

#include <algorithm>
#include <cctype>
#include <span>

#include "grammar/diagnostic.hpp"
#include "interpreter/messages.hpp"

namespace mansard {
namespace {

std::string in_quotes(std::string_view word) { return "\"" + std::string(word) + "\""; }

/// "\"mansard\", \"gambrel\" or \"saltbox\"".
std::string listed(std::span<const std::string_view> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + in_quotes(words[i]);
  }
  return text;
}

/// What OpenStreetMap's roof:shape, CityEngine and builders call our kinds.
struct OtherWord {
  std::string_view word;
  RoofKind kind;
};
constexpr std::array other_words{
    OtherWord{"hipped", RoofKind::hip},
    OtherWord{"gabled", RoofKind::gable},
    OtherWord{"ridge", RoofKind::gable},
    OtherWord{"pitched", RoofKind::gable},
    OtherWord{"saddle", RoofKind::gable},
    OtherWord{"half_hipped", RoofKind::half_hip},
    OtherWord{"side_hipped", RoofKind::half_hip},
    OtherWord{"side_half_hipped", RoofKind::half_hip},
    OtherWord{"jerkinhead", RoofKind::half_hip},
    OtherWord{"clipped_gable", RoofKind::half_hip},
    OtherWord{"dutch", RoofKind::dutch_hip},
    OtherWord{"dutch_gable", RoofKind::dutch_hip},
    OtherWord{"gablet", RoofKind::dutch_hip},
    OtherWord{"hipped_and_gabled", RoofKind::dutch_hip},
    OtherWord{"hip_and_gable", RoofKind::dutch_hip},
    OtherWord{"pyramidal", RoofKind::pyramid},
    OtherWord{"tented", RoofKind::pyramid},
    OtherWord{"skillion", RoofKind::shed},
    OtherWord{"lean_to", RoofKind::shed},
    OtherWord{"mono_pitch", RoofKind::shed},
    OtherWord{"monopitch", RoofKind::shed},
    OtherWord{"pent", RoofKind::shed},
    OtherWord{"curb", RoofKind::gambrel},
    OtherWord{"barn", RoofKind::gambrel},
    OtherWord{"salt_box", RoofKind::saltbox},
    OtherWord{"crosspitched", RoofKind::cross_gable},
    OtherWord{"cross_gabled", RoofKind::cross_gable},
    OtherWord{"saw_tooth", RoofKind::sawtooth},
    OtherWord{"round", RoofKind::barrel},
    OtherWord{"vault", RoofKind::barrel},
    OtherWord{"arched", RoofKind::barrel},
    OtherWord{"terrace", RoofKind::flat},
    OtherWord{"none", RoofKind::flat},
};

/// "roofHip", "Half-Hipped roof" and "roof:half hipped" without what says nothing.
std::string plain(std::string_view word) {
  std::string text;
  for (const char c : word) {
    text += std::isalnum(static_cast<unsigned char>(c))
                ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                : '_';
  }
  if (text.starts_with("roof")) text.erase(0, 4);
  if (text.ends_with("roof")) text.erase(text.size() - 4);
  while (text.starts_with('_')) text.erase(0, 1);
  while (text.ends_with('_')) text.pop_back();
  return text;
}

std::string_view name_of(RoofKind kind) { return roof_kinds[static_cast<std::size_t>(kind)]; }

/// Open ranges have no ends: a pitch of 0 is none.
struct Range {
  std::string_view argument;
  double low, high;
  bool open;
  std::string_view unit, help;
};
constexpr std::array ranges{
    Range{"pitch", 0, 90, true, " degrees", "0 lies level, 90 stands upright"},
    Range{"upper_pitch", 0, 90, true, " degrees", "0 lies level, 90 stands upright"},
    Range{"height", 0, 1000, true, " metres", "a roof without height is roof(\"flat\")"},
    Range{"overhang", 0, 10, false, "", ""},
    Range{"verge", 0, 10, false, "", ""},
    Range{"thickness", 0.001, 10, false, "", ""},
    Range{"break_height", 0, 1000, true, " metres", "leave it out to break at 0.4 of the way up"},
    Range{"break_inset", 0, 1000, true, " metres", "leave it out to break at 0.4 of the way up"},
    Range{"clipped", 0, 1, true, "", "it is a share of the gable's height"},
    Range{"tooth", 0.5, 1000, false, "", ""},
    Range{"parapet", 0, 100, false, "", ""},
    Range{"parapet_width", 0.01, 10, false, "", ""},
};

constexpr uint32_t bit(RoofKind kind) { return 1u << static_cast<uint32_t>(kind); }
template <class... Kinds>
constexpr uint32_t bits(Kinds... kinds) {
  return (bit(kinds) | ...);
}
constexpr uint32_t all_kinds = (1u << roof_kinds.size()) - 1;

/// The kinds that look at an argument; those that stand in no row go for all.
struct Use {
  std::string_view argument;
  uint32_t kinds;
};
using enum RoofKind;
constexpr uint32_t over_skeletons =
    bits(hip, gable, half_hip, dutch_hip, mansard, gambrel, cross_gable);
constexpr std::array uses{
    Use{"pitch", all_kinds & ~bits(flat)},
    Use{"height", all_kinds & ~bits(flat)},
    Use{"verge", all_kinds & ~bits(flat, pyramid)},
    Use{"gables", over_skeletons},
    Use{"hips", over_skeletons},
    Use{"ridge", all_kinds & ~bits(flat, pyramid)},
    Use{"upper_pitch", bits(mansard, gambrel, saltbox)},
    Use{"break_height", bits(mansard, gambrel)},
    Use{"break_inset", bits(mansard, gambrel)},
    Use{"clipped", bits(half_hip, dutch_hip)},
    Use{"tooth", bits(sawtooth)},
    Use{"parapet", bits(flat)},
    Use{"parapet_width", bits(flat)},
};

}  // namespace

std::optional<RoofKind> find_roof_kind(std::string_view word) {
  const auto it = std::ranges::find(roof_kinds, word);
  if (it == roof_kinds.end()) return std::nullopt;
  return static_cast<RoofKind>(it - roof_kinds.begin());
}

std::optional<std::string_view> meant_roof_kind(std::string_view word) {
  const std::string text = plain(word);
  if (const auto kind = find_roof_kind(text)) return name_of(*kind);
  const auto it = std::ranges::find(other_words, text, &OtherWord::word);
  if (it != other_words.end()) return name_of(it->kind);
  return nearest(word, roof_kinds);
}

WrongWord unknown_roof_kind(std::string_view word) {
  const auto meant = meant_roof_kind(word);
  return {in_quotes(shortened(word)) + " is no kind of roof",
          meant ? "did you mean " + in_quotes(*meant) + "?" : listed(roof_kinds)};
}

WrongWord unknown_dormer_kind(std::string_view word) {
  const auto meant = nearest(plain(word), dormer_kinds);
  return {in_quotes(shortened(word)) + " is no kind of dormer",
          meant ? "did you mean " + in_quotes(*meant) + "?" : listed(dormer_kinds)};
}

std::optional<WrongWord> wrong_roof_number(std::string_view argument, double value) {
  const auto range = std::ranges::find(ranges, argument, &Range::argument);
  if (range == ranges.end()) return std::nullopt;
  const bool inside = range->open ? value > range->low && value < range->high
                                  : value >= range->low && value <= range->high;
  if (inside) return std::nullopt;
  const bool only_above = range->high == 1000 && value <= range->low;
  std::string text = "'" + std::string(argument) + "' must ";
  text += only_above ? (range->open ? "be more than " : "be at least ") + number_text(range->low)
                     : "lie between " + number_text(range->low) + " and " +
                           number_text(range->high) + std::string(range->unit);
  return WrongWord{text + ", it is " + number_text(value), std::string(range->help)};
}

std::optional<WrongWord> idle_roof_argument(std::string_view argument, RoofKind kind) {
  const auto use = std::ranges::find(uses, argument, &Use::argument);
  if (use == uses.end() || (use->kinds & bit(kind)) != 0) return std::nullopt;
  std::vector<std::string_view> kinds;
  for (std::size_t i = 0; i < roof_kinds.size(); ++i) {
    if (use->kinds & 1u << i) kinds.push_back(roof_kinds[i]);
  }
  return WrongWord{
      "'" + std::string(argument) + "' says nothing to a " + in_quotes(name_of(kind)) + " roof",
      "it is for " + listed(kinds)};
}

}  // namespace mansard
