#include "cli/lsp/resolved.hpp"

#include <utility>

namespace mansard::lsp {

namespace {

bool is_said(const VariableValue& value, const Story& story) {
  const Writing* const writing = story.in_force();
  if (!writing) return false;
  const auto& variable = *std::get<const syntax::Variable*>(writing->syntax);
  return variable.value && variable.value->at.text() == *value.value;
}

std::string text_of(const VariableValue& value) {
  const Dependence& on = value.dependence;
  if (on.abstract) return "no value yet: it waits for what a child has to give";
  if (!value.problem.empty())
    return (on.footprint ? "no value where the footprint has no properties: " : "no value: ") +
           value.problem;
  const std::string footprint = on.footprint ? ", and depends on the footprint" : "";
  if (on.random && on.shape) return "drawn, another value for each shape" + footprint;
  if (on.random) return "drawn once a building, by its seed" + footprint;
  if (on.shape) return "another value for each shape" + footprint;
  if (!value.value) return {};
  return "`" + *value.value + "`" +
         (on.footprint ? " where the footprint has no properties that say otherwise" : "") +
         (on.footprint && on.set ? "," : "") + (on.set ? " where no set() says otherwise" : "");
}

}  // namespace

std::unique_ptr<Resolved> Resolved::of(Library& library, const syntax::Style& style) {
  if (library.find(style.name.text) != &style) return nullptr;  // one of two of this name
  CompileOptions options;
  options.style = style.name.text;
  options.abstract_too = true;
  NoMeshes meshes;
  Diagnostics unheard;
  auto program = compile(library, meshes, options, unheard);
  return program ? std::unique_ptr<Resolved>(new Resolved(std::move(program))) : nullptr;
}

Resolved::Resolved(std::unique_ptr<Program> program)
    : program_(std::move(program)),
      values_(*program_, bare_, 0),
      stories_(*program_->styles[program_->main_style].linked) {}

std::string Resolved::worth(const Meaning& variable) {
  const auto value = values_.variable(variable.block, variable.name);
  const Story* const story = this->story(variable);
  if (!value || !story) return {};
  const bool settled = value->value && !value->dependence.random && !value->dependence.shape &&
                       !value->dependence.footprint;
  return settled && is_said(*value, *story) ? std::string() : text_of(*value);
}

const Story* Resolved::story(const Meaning& member) const {
  switch (member.kind) {
    case Kind::variable:
      return stories_.find(MemberKind::variable, member.block, member.name);
    case Kind::function:
      return stories_.find(MemberKind::function, member.block, member.name);
    case Kind::symbol:
    case Kind::super:
      return stories_.find(MemberKind::symbol, {}, member.name);
    default:
      return nullptr;
  }
}

}  // namespace mansard::lsp
