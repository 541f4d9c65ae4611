// The words of roof(kind, ...): its kinds, those that others use for them, and what each of its
// arguments may be. Read while compiling, where arguments are written out, and while deriving.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/roof.hpp"

namespace mansard {

/// In the order of RoofKind.
inline constexpr std::array<std::string_view, 13> roof_kinds{
    "flat",    "hip",     "gable",   "half_hip",    "dutch_hip", "pyramid", "shed",
    "mansard", "gambrel", "saltbox", "cross_gable", "sawtooth",  "barrel"};
/// In the order of DormerKind.
inline constexpr std::array<std::string_view, 5> dormer_kinds{"flat", "shed", "gable", "hip",
                                                              "eyebrow"};
/// In the order of RoofPart.
inline constexpr std::array<std::string_view, 8> roof_parts{"slope",  "gable",   "top",   "soffit",
                                                            "fascia", "parapet", "lower", "upper"};

/// What is wrong and what to do about it.
struct WrongWord {
  std::string text, help;
};

std::optional<RoofKind> find_roof_kind(std::string_view word);
/// The kind that another word means: "hipped", "roof:skillion", "roofHip", "gabel".
std::optional<std::string_view> meant_roof_kind(std::string_view word);
/// Of a word that is no kind.
WrongWord unknown_roof_kind(std::string_view word);
WrongWord unknown_dormer_kind(std::string_view word);

/// A number outside what the named argument of roof() or upright() may be.
std::optional<WrongWord> wrong_roof_number(std::string_view argument, double value);

/// An argument that a kind of roof has no use for.
std::optional<WrongWord> idle_roof_argument(std::string_view argument, RoofKind kind);

}  // namespace mansard
