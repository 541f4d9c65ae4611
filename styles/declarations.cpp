// What a single style may not say: reserved names, and one thing twice.

#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "styles/annotations.hpp"
#include "styles/complaint.hpp"
#include "styles/members.hpp"
#include "styles/reserved.hpp"

namespace mansard {

namespace {

using syntax::Name;
using syntax::Style;

void check_free(Linking& linking, const Style& style, const Name& name) {
  if (!is_reserved(name.text)) return;
  linking.diagnostics.add(error(name.at,
                                in_quotes(name.text) + " is reserved and can not be declared",
                                {while_linking(style)}, "choose another name"));
}

void check_parameters(Linking& linking, const Style& style, const std::vector<Name>& parameters) {
  std::set<std::string_view> seen;
  for (const Name& name : parameters) {
    check_free(linking, style, name);
    if (seen.insert(name.text).second) continue;
    linking.diagnostics.add(
        error(name.at, "there are two parameters " + in_quotes(name.text), {while_linking(style)}));
  }
}

/// Reserved words among all that a style declares, and the annotations before it.
struct MemberCheck {
  Linking& linking;
  const Style& style;

  void annotations(const syntax::Preamble& pre, Annotated what) {
    for (Diagnostic& wrong : check_annotations(pre, what)) {
      wrong.notes.push_back(while_linking(style));
      linking.diagnostics.add(std::move(wrong));
    }
  }
  void operator()(const syntax::Variable& variable) {
    annotations(variable.pre, Annotated::variable);
    check_free(linking, style, variable.name);
  }
  void operator()(const syntax::Function& function) {
    annotations(function.pre, Annotated::other);
    check_free(linking, style, function.name);
    check_parameters(linking, style, function.params);
  }
  void operator()(const syntax::Rule& rule) {
    annotations(rule.pre, Annotated::rule);
    check_parameters(linking, style, rule.params);
  }
  void operator()(const syntax::AbstractSymbol& symbol) {
    annotations(symbol.pre, Annotated::other);
  }
  void operator()(const syntax::Start&) {}
  void operator()(const syntax::Block& block) {
    annotations(block.pre, Annotated::other);
    check_free(linking, style, block.name);
    for (const auto& entry : block.elements) annotations(entry.pre, Annotated::other);
    for (const auto& entry : block.materials) annotations(entry.pre, Annotated::other);
    for (const syntax::BlockItem& item : block.items) std::visit(*this, item);
  }
};

/// A second writing of a variable or function in one block of one style.
template <class T>
void check_once(Linking& linking, const Slot<T>& slot, const char* kind) {
  for (std::size_t i = 1; i < slot.given.size(); ++i) {
    const Given<T>&first = slot.given[i - 1], &second = slot.given[i];
    if (first.rank != second.rank) continue;
    const std::string where =
        slot.block.empty() ? " in the style" : " in block " + in_quotes(slot.block);
    linking.diagnostics.add(error(
        second.syntax->name.at,
        std::string("there are two ") + kind + " " + in_quotes(slot.name) + where,
        {{"the other one is here", first.syntax->name.at}, while_linking(*second.from.style)}));
  }
}

void check_one_start(Linking& linking, const Style& style) {
  const syntax::Start* first = nullptr;
  for (const syntax::StyleMember& member : style.members) {
    const auto* start = std::get_if<syntax::Start>(&member);
    if (!start) continue;
    if (first) {
      linking.diagnostics.add(
          error(start->symbol.at, "style " + in_quotes(style.name.text) + " starts twice",
                {{"the other start is here", first->symbol.at}, while_linking(style)}));
    } else {
      first = start;
    }
  }
}

}  // namespace

void check_declarations(Linking& linking) {
  for (const Style* style : linking.ancestry.order()) {
    MemberCheck check{linking, *style};
    check.annotations(style->pre, Annotated::other);
    for (const syntax::StyleMember& member : style->members) std::visit(check, member);
    check_one_start(linking, *style);
  }
  for (const auto& slot : linking.members.variables) check_once(linking, slot, "variables");
  for (const auto& slot : linking.members.functions) check_once(linking, slot, "functions");
}

}  // namespace mansard
