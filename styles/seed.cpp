// The seed that a style carries: `@seed(7)` before it.
#include <cmath>

#include "styles/complaint.hpp"
#include "styles/members.hpp"

namespace mansard {

namespace {

constexpr double largest_seed = 1e15;  // as --seed takes

std::optional<uint64_t> number_of(const syntax::Annotation& annotation) {
  if (annotation.args.size() != 1) return {};
  const syntax::Arg& arg = annotation.args[0];
  if (arg.name || arg.value.kind != syntax::SizeKind::absolute || !arg.value.value) return {};
  const auto* number = std::get_if<syntax::Number>(&arg.value.value->is);
  if (!number || number->value < 0 || number->value > largest_seed ||
      number->value != std::floor(number->value)) {
    return {};
  }
  return static_cast<uint64_t>(number->value);
}

/// The style's own; complains of what is none.
std::optional<uint64_t> seed_of(Linking& linking, const syntax::Style& style) {
  std::optional<uint64_t> seed;
  for (const syntax::Annotation& annotation : style.pre.annotations) {
    if (annotation.name.text != "seed") continue;
    const std::optional<uint64_t> number = number_of(annotation);
    if (!number) {
      linking.diagnostics.add(error(annotation.at, "@seed takes a whole number from 0 to 1e15",
                                    {while_linking(style)}, "write @seed(7)"));
    } else if (seed) {
      linking.diagnostics.add(error(annotation.at,
                                    "style " + in_quotes(style.name.text) + " has two seeds",
                                    {while_linking(style)}, "keep one of them"));
    }
    if (!seed) seed = number;
  }
  return seed;
}

/// A seed is a building's, so it can not stand before a part of a style.
struct MisplacedSeed {
  Linking& linking;
  const syntax::Style& style;

  void operator()(const syntax::Start&) {}
  void operator()(const syntax::Block& block) {
    check(block.pre);
    for (const syntax::BlockItem& item : block.items) std::visit(*this, item);
  }
  template <class Member>
  void operator()(const Member& member) {
    check(member.pre);
  }
  void check(const syntax::Preamble& pre) {
    for (const syntax::Annotation& annotation : pre.annotations) {
      if (annotation.name.text != "seed") continue;
      linking.diagnostics.add(error(annotation.at, "@seed stands before a style",
                                    {while_linking(style)},
                                    "move it before 'style " + std::string(style.name.text) + "'"));
    }
  }
};

}  // namespace

void link_seed(Linking& linking) {
  for (const syntax::Style* style : linking.ancestry.order()) {
    const std::optional<uint64_t> seed = seed_of(linking, *style);
    if (!linking.result.seed) linking.result.seed = seed;
    MisplacedSeed misplaced{linking, *style};
    for (const syntax::StyleMember& member : style->members) std::visit(misplaced, member);
  }
}

}  // namespace mansard
