// The parameters of the call that is being written.
#include "cli/lsp/features.hpp"
#include "cli/lsp/pages.hpp"
#include "cli/lsp/place.hpp"
#include "cli/vocabulary.hpp"

namespace mansard::lsp {

namespace {

struct Signature {
  std::string label, documentation;
  std::vector<std::string> parameters;
  bool variadic = false;
  std::size_t places = 0;  ///< of the parameters, those that are given by place
};

Signature signature_of(const Operation& row) {
  Signature made{usage(row), page(row), {}, row.variadic, row.places()};
  for (std::size_t i = 0; i < row.places(); ++i)
    made.parameters.emplace_back(row.parameter_name(row.parameter_at(i)));
  for (std::size_t i = 0; i < row.count; ++i) {
    if (row.parameters[i].named) made.parameters.emplace_back(row.parameter_name(i));
  }
  return made;
}

Signature signature_of(const Function& row) {
  Signature made{std::string(row.name) + "(" + std::string(row.args) + ")",
                 page(row),
                 {},
                 row.variadic,
                 row.count};
  for (std::size_t i = 0; i < row.count; ++i) made.parameters.emplace_back(row.parameter_name(i));
  return made;
}

Signature signature_of(std::string_view name, const std::vector<syntax::Name>& params) {
  Signature made{std::string(name) + "(", {}, {}, false};
  for (const syntax::Name& param : params) {
    made.label.append(made.parameters.empty() ? "" : ", ").append(param.text);
    made.parameters.emplace_back(param.text);
  }
  made.label += ")";
  return made;
}

/// A function or symbol of the styles; without parameters when there is none.
Signature declared_signature(View& view, const Place& place, const OpenCall& call) {
  const syntax::Style* const style = view.library().find(place.style);
  if (!style) return {};
  const Meanings& meanings = view.meanings();
  for (const std::string_view block : {call.block.empty() ? place.block : call.block, {}}) {
    for (const Word* word : meanings.definition({Kind::function, block, call.name, style, nullptr}))
      return signature_of(call.name, std::get<const syntax::Function*>(word->declares)->params);
  }
  for (const Word* word : meanings.definition({Kind::symbol, {}, call.name, style, nullptr})) {
    if (const auto* rule = std::get_if<const syntax::Rule*>(&word->declares))
      return signature_of(call.name, (*rule)->params);
  }
  return {};
}

Signature find_signature(View& view, const Place& place, const OpenCall& call) {
  if (call.is_step) {
    if (const Operation* row = find_operation(call.name)) return signature_of(*row);
  } else if (const Function* row = find_function(call.name)) {
    return signature_of(*row);
  }
  if (call.name == "attr") return {"attr(name, default)", word_page("attr"), {"name", "default"}};
  return declared_signature(view, place, call);
}

}  // namespace

Json signature_help(Project& project, const Params& params) {
  const Cursor at = project.cursor(params);
  const std::string_view text = at.file->source->text();
  const Place place = place_at(text, tokens_of(text), at.offset);
  View& view = project.sound_view(at.file->source->name());
  for (auto call = place.calls.rbegin(); call != place.calls.rend(); ++call) {
    if (call->name.empty()) continue;  // parentheses of arithmetic
    const Signature found = find_signature(view, place, *call);
    if (found.parameters.empty()) return nullptr;
    std::vector<Json> parameters;
    for (const std::string& name : found.parameters)
      parameters.push_back(Json::object({{"label", name}}));
    Json signature =
        Json::object({{"label", found.label}, {"parameters", Json::array(parameters)}});
    if (!found.documentation.empty())
      signature.put("documentation",
                    Json::object({{"kind", "markdown"}, {"value", found.documentation}}));
    std::size_t active = call->argument;
    if (found.variadic) active = std::min(active, found.places - 1);
    return Json::object({{"signatures", Json::array({signature})},
                         {"activeSignature", 0},
                         {"activeParameter", active}});
  }
  return nullptr;
}

}  // namespace mansard::lsp
