// Operations: arguments by place or name, parts by label or place.
#include <algorithm>
#include <array>

#include "interpreter/compiler.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/random.hpp"
#include "interpreter/selectors.hpp"

namespace mansard {
namespace {

constexpr std::array<std::string_view, 2> later_options{"even", "index"};

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// `roof(hip, 30)`, `comp(f)`, `extrude(world.up, 3)`: what is unknown was meant as a text, or is
/// one of another language.
void explain_bare_word(Diagnostic& d, const Operation& operation, ArgType type,
                       const syntax::Arg& arg) {
  const auto* word = std::get_if<syntax::Reference>(&arg.value.value->is);
  if (!word || word->style || !d.text.starts_with("unknown variable")) return;
  const std::string_view text = arg.at.text();
  if (text == "world.up" || text == "y.up" || text == "face.normal") {
    d.help = "extrude(height) goes up where the shape lies flat, else out of its plane";
  } else if (operation.name == "comp" && text.size() == 1) {
    d.help = "the parts say which faces: comp { side : A | top : B }";
  } else if (d.help.empty() && operation.name == "color") {
    d.help = "a colour is a string: color(\"" + std::string(text) + "\") or color(\"#445566\")";
  } else if (d.help.empty() && word->names.size() == 1 && type != ArgType::number &&
             type != ArgType::length && type != ArgType::sizes) {
    d.help = "text stands in quotes: \"" + std::string(text) + "\"";
  }
}

/// `{ side FACADE | top : ROOF }`
void refuse_lost_colon(const syntax::Part& part, std::span<const std::string_view> labels) {
  if (part.label || part.body.size() < 2) return;
  const auto* first = std::get_if<syntax::Emit>(&part.body[0].is);
  if (!first || first->args || first->parts || first->style) return;
  if (std::ranges::find(labels, first->name.text) == labels.end()) return;
  refuse(first->name.at, quoted(first->name.text) + " stands in this part as a symbol",
         "is a ':' missing behind it?");
}

}  // namespace

uint32_t Compiler::operation_call(const Operation& operation, const syntax::Emit& e, Span at,
                                  NameScope& scope) {
  if (e.index) refuse(at, "an operation has no index", "put a space before '[' to save the shape");
  Call call;
  call.operation = &operation;
  call.at = e.name.at;
  call.args_at = e.args ? e.args_at : e.name.at;
  call.parts_at = e.parts ? e.parts->at : e.name.at;
  call.salt = hash_of(operation.name) + (scope.salt ? (*scope.salt)++ : 0u);
  call_arguments(call, e, scope);
  call_parts(call, e, scope);
  call.measures = name_streams(call.parts);
  for (const SizeExpr& size : call.args) {
    call.measures = call.measures || size.kind == syntax::SizeKind::dont_care;
  }
  const auto is_group = [](const CallPart& part) { return !part.group.empty(); };
  call.parts_repeat =
      call.parts.size() == 1 || call.starred || std::ranges::any_of(call.parts, is_group);
  program_.calls.push_back(std::move(call));
  return static_cast<uint32_t>(program_.calls.size() - 1);
}

/// `height == 3`
void Compiler::refuse_compared_name(const Operation& operation, const syntax::Arg& arg,
                                    const NameScope& scope) {
  const auto* chain = arg.value.value ? std::get_if<syntax::Chain>(&arg.value.value->is) : nullptr;
  if (!chain || chain->operators[0] != syntax::Infix::equal) return;
  const auto* name = std::get_if<syntax::Reference>(&chain->operands[0]->is);
  if (!name || name->names.size() != 1 || name->style) return;
  const std::string_view word = name->names[0].text;
  if (std::ranges::find(scope.parameters, word) != scope.parameters.end()) return;
  if (variable_slot(scope.style, scope.block, word) != none) return;
  if (variable_slot(scope.style, {}, word) != none) return;
  for (std::size_t i = 0; i < operation.count; ++i) {
    if (operation.parameter_name(i) != word) continue;
    refuse(chain->operator_spans[0],
           "argument " + quoted(word) + " of " + quoted(operation.name) + " is compared with '=='",
           "an argument with a name is written with one '='");
  }
}

void Compiler::call_arguments(Call& call, const syntax::Emit& e, NameScope& scope) {
  const Operation& operation = *call.operation;
  call.args.resize(operation.count);
  std::size_t position = 0;
  if (e.args) {
    for (const syntax::Arg& arg : *e.args) {
      refuse_compared_name(operation, arg, scope);
      const std::size_t place = argument_place(operation, arg, position);
      if (!arg.name) ++position;
      if (place >= call.args.size()) call.args.resize(place + 1);
      if (call.args[place].value != none) {
        refuse(arg.at,
               quoted(operation.parameter_name(operation.parameter_of(place))) + " is given twice");
      }
      if (place < operation.count && operation.parameters[place].type == ArgType::setting) {
        setting_argument(call, arg, scope);
      } else {
        call.args[place] = size_argument(operation, place, arg, scope);
      }
    }
  }
  for (std::size_t i = 0; i < operation.required; ++i) {
    if (operation.parameters[i].optional) continue;
    const bool setting = operation.parameters[i].type == ArgType::setting && call.setting != none;
    const bool rest = operation.variadic && i == operation.rest;
    if (setting || (rest ? call.args.size() > operation.count : call.args[i].value != none))
      continue;
    refuse(call.args_at, quoted(operation.name) + " needs " + quoted(operation.parameter_name(i)),
           "write " + std::string(operation.name) + "(" + operation.names_by_place() + ")");
  }
}

std::size_t Compiler::argument_place(const Operation& operation, const syntax::Arg& arg,
                                     std::size_t position) {
  const auto slot = [&](std::size_t i) -> std::size_t {
    const bool rest = operation.variadic && i == operation.rest;
    return rest ? operation.count + std::max<std::size_t>(position, i) - i : i;
  };
  if (!arg.name) {
    if (position >= operation.places() && !operation.variadic) {
      std::string help =
          "write " + std::string(operation.name) + "(" + operation.names_by_place() + ")";
      if (operation.name == "color")
        help = "red, green and blue stand in one text: color(\"#445566\")";
      if (operation.name == "split")
        help =
            "sizes stand before the parts: split(\"X\") { 1 : A | 1r : B }, or "
            "subdiv(\"X\", 1, 1r) { A | B }";
      refuse(arg.at,
             quoted(operation.name) + " takes " + count_text(operation.places(), "argument") +
                 " at most",
             help);
    }
    return slot(operation.parameter_at(position));
  }
  const std::size_t named = operation.find_parameter(arg.name.text);
  if (named < operation.count) return slot(named);
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < operation.count; ++i) names.push_back(operation.parameter_name(i));
  if (std::ranges::find(later_options, arg.name.text) != later_options.end()) {
    refuse(arg.name.at, quoted(arg.name.text) + " of " + quoted(operation.name) +
                            " comes with a later version of Mansard");
  }
  refuse(arg.name.at, quoted(operation.name) + " has no argument " + quoted(arg.name.text),
         meant(arg.name.text, names));
}

/// A size ':', 0 metres until it is measured.
SizeExpr Compiler::unmeasured(Span at) {
  return {syntax::SizeKind::dont_care, constant(Value::of(0.0), at)};
}

/// Whether a size among the parts is ':'; of all of them, groups too, the streams of what they
/// emit: a part is known by the first symbol in it and how many before it have the same.
bool Compiler::name_streams(std::vector<CallPart>& parts) {
  bool measures = false;
  std::vector<uint64_t> before;
  for (CallPart& part : parts) {
    measures = name_streams(part.group) || measures;
    measures = measures || part.size.kind == syntax::SizeKind::dont_care;
    const uint64_t first = part.group.empty() ? first_symbol(part.body) : part.group[0].stream;
    part.stream = mix(first, static_cast<uint64_t>(std::ranges::count(before, first)));
    before.push_back(first);
  }
  return measures;
}

SizeExpr Compiler::size_argument(const Operation& operation, std::size_t place,
                                 const syntax::Arg& arg, NameScope& scope) {
  using enum syntax::SizeKind;
  const std::size_t known = operation.parameter_of(place);
  const ArgType type = operation.parameters[known].type;
  const syntax::SizeKind kind = arg.value.kind;
  const bool of_repeat = operation.name == "repeat" && place == 1;
  const bool allowed = kind == absolute || type == ArgType::sizes ||
                       (type == ArgType::length && kind == percent) ||
                       (of_repeat && (kind == floating || kind == dont_care));
  if (!allowed) {
    refuse(arg.at, quoted(arg.at.text()) + " is a size of a split, but " +
                       quoted(operation.parameter_name(known)) + " of " + quoted(operation.name) +
                       " is a plain value");
  }
  if (kind == dont_care) return unmeasured(arg.at);
  SizeExpr size;
  size.kind = kind;
  try {
    size.value = expression(*arg.value.value, scope);
  } catch (Failure& failure) {
    explain_bare_word(failure.diagnostic, operation, type, arg);
    throw;
  }
  return size;
}

/// set(Block.Name, value): the variable is named, not read.
void Compiler::setting_argument(Call& call, const syntax::Arg& arg, NameScope& scope) {
  const auto* reference =
      arg.value.value ? std::get_if<syntax::Reference>(&arg.value.value->is) : nullptr;
  if (!reference || reference->style || reference->names.size() > 2)
    refuse(arg.at, "set() takes the name of a variable first", "set(Tile.WindowHeight, 2.1)");
  uint32_t slot = none;
  if (reference->names.size() == 2) {
    slot = variable_slot(scope.style, reference->names[0].text, reference->names[1].text);
  } else {
    slot = variable_slot(scope.style, scope.block, reference->names[0].text);
    if (slot == none) slot = variable_slot(scope.style, {}, reference->names[0].text);
  }
  if (slot == none) {
    std::vector<std::string_view> known;
    for (const VariableSlot& v : program_.variables) known.push_back(v.name);
    refuse(arg.at, "unknown variable " + quoted(arg.at.text()), meant(arg.at.text(), known));
  }
  call.setting = program_.variables[slot].setting;
  set_somewhere_.insert(call.setting);
}

void Compiler::call_parts(Call& call, const syntax::Emit& e, NameScope& scope) {
  const Operation& operation = *call.operation;
  call.has_parts = e.parts.has_value();
  if (!e.parts) {
    const bool goes_on = operation.rule == PartRule::body && operation.name != "repeat";
    if (operation.rule == PartRule::without || goes_on || operation.name == "roof") return;
    refuse(call.args_at,
           quoted(operation.name) + " makes parts, and no { ... } says what becomes of them",
           operation.parts.empty() ? "write " + std::string(operation.name) + "(...) { PART }"
                                   : "write { " + std::string(operation.parts) + " }");
  }
  if (operation.rule == PartRule::without)
    refuse(e.parts->at, quoted(operation.name) + " makes no parts",
           "drop the { ... }; the shape goes on");
  call.starred = e.parts->starred;
  if (call.starred && operation.rule != PartRule::pattern)
    refuse(e.parts->at, "only split(axis) { ... }* repeats its pattern");
  for (const syntax::Part& part : e.parts->parts)
    call.parts.push_back(call_part(operation, part, scope));
  check_part_count(call, e);
  if (operation.rule == PartRule::named) name_parts(call, e);
}

CallPart Compiler::call_part(const Operation& operation, const syntax::Part& part,
                             NameScope& scope) {
  CallPart out;
  out.at = part.at;
  if (!part.group.empty()) {
    if (operation.rule != PartRule::pattern)
      refuse(part.at, "groups { ... }* stand only in split(axis) { ... }");
    for (const syntax::Part& inner : part.group)
      out.group.push_back(call_part(operation, inner, scope));
    return out;
  }
  if (part.label) part_label(operation, part, out, scope);
  if (!part.label && operation.rule == PartRule::pattern) {
    refuse(part.at, "a part of 'split' begins with its size",
           "1r : " + std::string(part.at.text()));
  }
  out.body = body(part.body, scope);
  return out;
}

void Compiler::part_label(const Operation& operation, const syntax::Part& part, CallPart& out,
                          NameScope& scope) {
  const syntax::Size& label = *part.label;
  out.labelled = true;
  const auto* word = label.value ? std::get_if<syntax::Reference>(&label.value->is) : nullptr;
  const bool plain =
      label.kind == syntax::SizeKind::absolute && word && word->names.size() == 1 && !word->style;
  switch (operation.rule) {
    case PartRule::named:
      if (!plain)
        refuse(label.at, quoted(label.at.text()) + " names no part of " + quoted(operation.name),
               "its parts: " + std::string(operation.parts));
      out.name = program_.symbols.intern(word->names[0].text);
      return;
    case PartRule::selectors:
      if (plain) {
        const std::string_view name = word->names[0].text;
        if (find_selector(name)) {
          out.name = program_.symbols.intern(name);
          return;
        }
        if (variable_slot(scope.style, scope.block, name) == none &&
            variable_slot(scope.style, {}, name) == none) {
          refuse(label.at, quoted(name) + " selects no components", meant(name, selector_words));
        }
      }
      if (label.kind != syntax::SizeKind::absolute)
        refuse(label.at, "a component is chosen by a word or a number");
      out.size = {label.kind, expression(*label.value, scope)};
      return;
    case PartRule::pattern:
      out.size = label.kind == syntax::SizeKind::dont_care
                     ? unmeasured(label.at)
                     : SizeExpr{label.kind, expression(*label.value, scope)};
      return;
    default:
      refuse(label.at, "parts of " + quoted(operation.name) + " have no labels",
             operation.name == "subdiv"
                 ? "the sizes stand in the parentheses; split(axis) takes them here"
                 : "");
  }
}

void Compiler::name_parts(Call& call, const syntax::Emit& e) {
  const Operation& operation = *call.operation;
  const std::size_t names = parts_in(operation.parts);
  call.part_of.assign(names, none);
  const std::size_t labelled =
      static_cast<std::size_t>(std::ranges::count(call.parts, true, &CallPart::labelled));
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < names; ++i) known.push_back(part_name(operation.parts, i));
  if (labelled != 0 && labelled != call.parts.size()) {
    for (const syntax::Part& part : e.parts->parts) refuse_lost_colon(part, known);
    refuse(e.parts->at, "named parts and parts by place do not mix",
           "its parts: " + std::string(operation.parts));
  }
  for (uint32_t p = 0; p < call.parts.size(); ++p) {
    std::size_t i = p;
    if (labelled) {
      const std::string_view word = program_.symbols[call.parts[p].name];
      i = static_cast<std::size_t>(std::ranges::find(known, word) - known.begin());
      const Span at = e.parts->parts[p].label->at;
      if (i == names)
        refuse(at, quoted(word) + " is no part of " + quoted(operation.name), meant(word, known));
      if (call.part_of[i] != none) refuse(at, quoted(word) + " stands twice");
    }
    call.part_of[i] = p;
  }
}

void Compiler::check_part_count(const Call& call, const syntax::Emit& e) {
  const Operation& operation = *call.operation;
  std::size_t most = 1000000;
  if (operation.rule == PartRule::body) most = 1;
  if (operation.rule == PartRule::named) most = parts_in(operation.parts);
  const bool worded =
      operation.rule == PartRule::selectors && call.args.size() > 0 && call.args[0].value != none;
  if (worded) most = 1;
  if (call.parts.size() > most) {
    refuse(e.parts->at, quoted(operation.name) + " makes " + count_text(most, "part") + ", not " +
                            std::to_string(call.parts.size()));
  }
  if (operation.rule != PartRule::selectors) return;
  for (const CallPart& part : call.parts) {
    if (!worded && !part.labelled) {
      refuse_lost_colon(e.parts->parts[static_cast<std::size_t>(&part - call.parts.data())],
                        selector_words);
      refuse(part.at, "say which components this part gets",
             "side : " + std::string(part.at.text()));
    }
    if (worded && part.labelled) refuse(part.at, "the selector stands in the parentheses already");
  }
}

}  // namespace mansard
