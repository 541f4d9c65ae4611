#include "styles/mentions.hpp"

#include <algorithm>
#include <span>
#include <variant>

namespace mansard {

namespace {

using namespace syntax;

class Finder {
 public:
  explicit Finder(std::span<const Name> parameters) : parameters_(parameters) {}

  std::vector<Mention> found;
  /// `FLOOR[i]` binds i as a parameter.
  std::string_view index;

  void expression(const ExprPtr& expr) {
    if (expr) std::visit([&](const auto& is) { in(is, expr->at); }, expr->is);
  }

  void body(const Body& body) {
    for (const Element& element : body) std::visit([&](const auto& is) { in(is); }, element.is);
  }

 private:
  void in(const Number&, Span) {}
  void in(const Text&, Span) {}
  void in(const Boolean&, Span) {}
  void in(const List& list, Span) {
    for (const ExprPtr& item : list.items) expression(item);
  }
  void in(const Reference& reference, Span) { add(MentionKind::value, reference); }
  void in(const Call& call, Span) {
    add(MentionKind::call, call.callee);
    arguments(call.args);
  }
  void in(const Subscript& subscript, Span) {
    expression(subscript.list);
    expression(subscript.index);
  }
  void in(const Unary& unary, Span) { expression(unary.operand); }
  void in(const Chain& chain, Span) {
    for (const ExprPtr& operand : chain.operands) expression(operand);
  }
  void in(const Conditional& conditional, Span) {
    expression(conditional.condition);
    expression(conditional.then);
    expression(conditional.otherwise);
  }

  void in(const Push& push) { body(push.body); }
  void in(const Super&) {}
  void in(const If& branch) {
    for (const IfArm& arm : branch.arms) {
      expression(arm.condition);
      body(arm.body);
    }
  }
  void in(const Emit& emit) {
    expression(emit.style_of);
    const bool elsewhere = emit.style || emit.style_of;
    const MentionKind kind = emit.args || emit.parts ? MentionKind::apply : MentionKind::emit;
    if (!elsewhere) add(kind, {}, emit.name);
    if (emit.args) {
      const std::span<const Arg> all(*emit.args);
      const bool sets = !elsewhere && emit.name.text == "set" && sets_variable(all);
      arguments(sets ? all.subspan(1) : all);
    }
    expression(emit.index);
    if (emit.parts) parts(emit.parts->parts, emit.name.text == "split");
  }

  void arguments(std::span<const Arg> args) {
    for (const Arg& arg : args) expression(arg.value.value);
  }

  bool sets_variable(std::span<const Arg> args) {
    const ExprPtr* first = args.empty() ? nullptr : &args[0].value.value;
    const auto* reference = first && *first ? std::get_if<Reference>(&(*first)->is) : nullptr;
    if (!reference) return false;
    const std::size_t before = found.size();
    add(MentionKind::set, *reference);
    const bool gives = found.size() > before && args.size() > 1 && args[1].value.value;
    if (gives) found.back().value = args[1].value.value->at;
    return true;
  }

  /// A label is a size in a split; elsewhere its words are those of the operation.
  void parts(const std::vector<Part>& parts, bool sizes) {
    for (const Part& part : parts) {
      if (sizes && part.label) expression(part.label->value);
      body(part.body);
      this->parts(part.group, sizes);
    }
  }

  void add(MentionKind kind, const Reference& reference) {
    if (reference.style || reference.names.size() > 2) return;
    const Name& last = reference.names.back();
    if (reference.names.size() == 1) return add(kind, {}, last);
    const Name& block = reference.names.front();
    found.push_back({kind, block.text, last.text, join(block.at, last.at), {}});
  }

  void add(MentionKind kind, std::string_view block, const Name& name) {
    const bool bare = kind == MentionKind::value || kind == MentionKind::emit;
    if (bare && (name.text == index || is_parameter(name.text))) return;
    found.push_back({kind, block, name.text, name.at, {}});
  }

  bool is_parameter(std::string_view name) const {
    return std::ranges::find(parameters_, name, &Name::text) != parameters_.end();
  }

  std::span<const Name> parameters_;
};

}  // namespace

std::vector<Mention> mentions_of(const Rule& rule) {
  Finder finder(rule.params);
  const auto* index = rule.index ? std::get_if<Reference>(&rule.index->is) : nullptr;
  if (index && !index->style && index->names.size() == 1) finder.index = index->names[0].text;
  finder.expression(rule.index);
  finder.expression(rule.guard);
  finder.body(rule.successor);
  finder.expression(rule.probability);
  return std::move(finder.found);
}

std::vector<Mention> mentions_of(const Variable& variable) {
  Finder finder({});
  finder.expression(variable.value);
  return std::move(finder.found);
}

std::vector<Mention> mentions_of(const Function& function) {
  Finder finder(function.params);
  finder.expression(function.value);
  return std::move(finder.found);
}

}  // namespace mansard
