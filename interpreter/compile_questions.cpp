// Which rules ask about other shapes, and so wait: known before anything is derived.
#include "interpreter/question.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/axes.hpp"
#include "interpreter/compiler.hpp"
#include "interpreter/lint/walk.hpp"
#include "interpreter/sight.hpp"
#include "interpreter/solid_set.hpp"

namespace mansard {

Asks asked_by(const ExprNode& node) {
  return node.kind == ExprKind::call ? functions()[node.aux].asks : Asks::nothing;
}

bool is_question(const ExprNode& node) { return asked_by(node) != Asks::nothing; }

namespace {

bool is_corner(const ExprNode& node) {
  const auto attribute = static_cast<Attribute>(node.aux);
  return node.kind == ExprKind::attribute &&
         (attribute == Attribute::corner_left || attribute == Attribute::corner_right);
}

/// What expressions ask, through the variables and functions that they read: the greatest of Asks.
class Askers {
 public:
  explicit Askers(const Program& program)
      : program_(program), functions_(program.functions.size(), Asks::nothing) {
    // Functions may call each other in rings: what one gains by another takes one more pass.
    for (bool changed = true; changed;) {
      changed = false;
      variables_.assign(program.variables.size(), std::nullopt);
      for (std::size_t i = 0; i < functions_.size(); ++i) {
        const Asks now = asked(program.functions[i].value);
        changed = changed || now != functions_[i];
        functions_[i] = now;
      }
    }
  }

  Asks asked(ExprId id) {
    if (id == none) return Asks::nothing;
    const ExprNode& node = program_.nodes[id];
    Asks most = asked_by(node);
    if (node.kind == ExprKind::definition) most = std::max(most, functions_[node.first]);
    if (node.kind == ExprKind::variable) most = std::max(most, variable(node.first));
    for (uint32_t i = 0; i < node.count; ++i) {
      most = std::max(most, asked(program_.children[node.children + i]));
    }
    return most;
  }

 private:
  Asks variable(uint32_t slot) {
    if (!variables_[slot]) variables_[slot] = asked(program_.variables[slot].value);
    return *variables_[slot];
  }

  const Program& program_;
  std::vector<Asks> functions_;
  std::vector<std::optional<Asks>> variables_;
};

/// extrude(depth, corners = "mitre") or with a word that is computed.
bool has_corners(const Call& call) {
  const std::size_t at = call.operation->find_parameter("corners");
  return at < call.operation->count && call.args[at].value != none;
}

/// Looks through a production.
struct Look {
  const Program& program;
  Askers& askers;
  const std::vector<bool>& snapping_calls;
  bool waits = false, of_group = false;

  void step(const Step& step) {
    if (step.kind != StepKind::operation) return;
    waits = waits || program.calls[step.what].operation->waits || snapping_calls[step.what];
  }
  void expression(ExprId id) {
    const Asks asked = askers.asked(id);
    waits = waits || asked != Asks::nothing;
    of_group = of_group || asked == Asks::group;
  }
};

}  // namespace

/// A rule set waits when one of its productions asks or snaps, or one that `super` leads to: a
/// shape waits before it is known which is drawn.
void Compiler::find_waiting() {
  const std::vector<bool> snapping = snapping_calls();
  program_.snaps = std::ranges::find(snapping, true) != snapping.end();
  program_.asks = program_.snaps ||
                  std::ranges::find(program_.nodes, Asks::others, asked_by) != program_.nodes.end();
  program_.reads_corners = std::ranges::any_of(program_.nodes, is_corner) ||
                           std::ranges::any_of(program_.calls, has_corners);
  Askers askers(program_);
  // A rule set's super was declared before it.
  for (RuleSet& set : program_.rule_sets) {
    std::optional<uint16_t> stage;
    bool says_super = false;
    Look look{program_, askers, snapping};
    for (uint32_t i = set.first; i < set.first + set.count; ++i) {
      const Production& production = program_.productions[i];
      if (walk_production(program_, production, look)) says_super = true;
      if (!production.stage) continue;
      if (stage && *stage != *production.stage)
        attempt_anywhere([&] { refuse_two_stages(set, *stage, production); });
      stage = production.stage;
    }
    const RuleSet* const inherited =
        says_super && set.super != none ? &program_.rule_sets[set.super] : nullptr;
    set.waits = look.waits || stage.has_value() || (inherited && inherited->waits);
    const uint16_t usual = look.of_group ? group_stage : usual_stage;
    set.stage =
        stage.value_or(inherited && inherited->waits ? std::max(usual, inherited->stage) : usual);
  }
}

void Compiler::refuse_two_stages(const RuleSet& set, uint16_t stage,
                                 const Production& production) const {
  const auto* first = &program_.productions[set.first];
  while (first->stage != stage) ++first;
  const std::string name(production.syntax->name.text);
  refuse(production.syntax->head,
         "'" + name + "' is of stage " + std::to_string(*production.stage) + " here and of stage " +
             std::to_string(stage) + " before",
         "a shape waits before one of its rules is drawn: all rules of '" + name +
             "' are of one stage",
         {{"stage " + std::to_string(stage) + " is said here", first->syntax->head}});
}

std::optional<uint16_t> Compiler::stage_of(const syntax::Rule& rule) {
  for (const syntax::Annotation& a : rule.pre.annotations) {
    if (a.name.text != "stage" || a.args.empty()) continue;
    const auto* number =
        a.args[0].value.value ? std::get_if<syntax::Number>(&a.args[0].value.value->is) : nullptr;
    const bool whole = number && number->value >= 0 && number->value <= last_stage &&
                       number->value == std::floor(number->value);
    if (!whole) {
      refuse(a.at, "a stage is a whole number from 0 to " + std::to_string(last_stage),
             "rules that ask and say no stage are of stage " + std::to_string(usual_stage) +
                 ", those that ask their group of stage " + std::to_string(group_stage));
    }
    return static_cast<uint16_t>(number->value);
  }
  return std::nullopt;
}

void refuse_later(Span at) {
  refuse(at, "'" + std::string(at.text()) + "' comes with a later version of Mansard");
}

/// `Shape.occ(...)`; also `Shape.inside(...)`.
ExprId Compiler::question(const syntax::Call& call, Span at, NameScope& scope) {
  const syntax::Name& name = call.callee.names[1];
  std::vector<std::string_view> known;
  for (const Function& function : functions()) {
    if (function.asks != Asks::others) continue;
    std::string_view word = function.name;
    if (word.starts_with("Shape.")) word.remove_prefix(6);
    if (word == name.text) return function_call(function, call, at, scope);
    known.push_back(word);
  }
  refuse(name.at, "a shape can not be asked for '" + std::string(name.text) + "'",
         meant(name.text, known));
}

/// `group.best(...)`.
ExprId Compiler::group_question(const syntax::Call& call, Span at, NameScope& scope) {
  const syntax::Name& name = call.callee.names[1];
  const std::string whole = "group." + std::string(name.text);
  const Function* const function = find_function(whole);
  if (!function) {
    std::vector<std::string_view> known;
    for (const Function& f : functions()) {
      if (f.asks == Asks::group) known.push_back(f.name);
    }
    const std::string help = meant(whole, known);
    refuse(at, "a group can not be asked for '" + std::string(name.text) + "'",
           help.empty() ? "any, all, count, sum, max, min, rank, best" : help);
  }
  if (scope.in_function) {
    refuse(at, "a group is asked in rules and variables, not in functions with parameters",
           "each shape of the group has the rule's own parameters: write it there");
  }
  return function_call(*function, call, at, scope);
}

/// Labels may come from any text of the script.
void Compiler::intern_texts() {
  const auto snaps = [](const Value& value) {
    return value.type == Type::string && is_snapping_axis(value.string());
  };
  if (std::ranges::none_of(program_.nodes, is_question) &&
      std::ranges::none_of(program_.constants, snaps))
    return;
  for (const Value& value : program_.constants) {
    if (value.type == Type::string) program_.symbols.intern(value.string());
  }
}

namespace {

bool takes_streets(const Function& question) {
  return question.name == "Shape.visible" || question.name == "nearest";
}

}  // namespace

/// Sets and answers that there are not: a comparison with a misspelt word would never hold.
void Compiler::check_questions() {
  std::vector<std::string_view> labels(occluder_sets.begin(), occluder_sets.end());
  bool computed = false;
  for (const Call& call : program_.calls) {
    if (call.operation->name != "label") continue;
    const ExprNode& name = program_.nodes[call.args[0].value];
    if (name.kind != ExprKind::constant) {
      computed = true;
    } else if (program_.constants[name.first].type == Type::string) {
      labels.push_back(program_.constants[name.first].string());
    }
  }
  for (ExprId id = 0; id < program_.nodes.size(); ++id) {
    const ExprNode& node = program_.nodes[id];
    if (node.kind == ExprKind::equal || node.kind == ExprKind::unequal)
      attempt_anywhere([&] { check_cover_word(node); });
    const Asks asked = asked_by(node);
    if (asked == Asks::others && !computed) {
      std::vector<std::string_view> known = labels;
      if (takes_streets(functions()[node.aux])) known.push_back(street_word);
      attempt_anywhere([&] { check_question(id, known); });
    }
    if (asked == Asks::group) attempt_anywhere([&] { check_group(id); });
    if (asked == Asks::outcome) attempt_anywhere([&] { check_outcome(id); });
  }
}

void Compiler::check_question(ExprId id, std::span<const std::string_view> labels) {
  const ExprId set = program_.children[program_.nodes[id].children];
  const ExprNode& node = program_.nodes[set];
  if (node.kind != ExprKind::constant) return;
  const Value& value = program_.constants[node.first];
  if (value.type != Type::string || std::ranges::find(labels, value.string()) != labels.end())
    return;
  const std::string help = meant(value.string(), labels);
  const std::string sets = "\"all\", \"noparent\", \"active\", \"neighbours\", ";
  const bool streets = labels.back() == street_word;
  refuse(program_.spans[set],
         "\"" + std::string(value.string()) + "\" is no set of shapes, and no label() gives it",
         help.empty() ? sets + (streets ? "\"street\", " : "") + "or what label() names" : help);
}

void Compiler::check_cover_word(const ExprNode& comparison) {
  constexpr std::array<std::string_view, 3> answers{"none", "part", "full"};
  for (const uint32_t side : {0u, 1u}) {
    const ExprNode& asked = program_.nodes[program_.children[comparison.children + side]];
    const ExprId other = program_.children[comparison.children + 1 - side];
    const ExprNode& word = program_.nodes[other];
    if (asked.kind != ExprKind::call || functions()[asked.aux].name != "Shape.occ") continue;
    if (word.kind != ExprKind::constant) continue;
    const Value& value = program_.constants[word.first];
    if (value.type == Type::string && std::ranges::find(answers, value.string()) != answers.end())
      continue;
    const std::string help = value.type == Type::string ? meant(value.string(), answers) : "";
    refuse(program_.spans[other],
           "Shape.occ never answers " + std::string(program_.spans[other].text()),
           help.empty() ? "it answers \"none\", \"part\" or \"full\"" : help);
  }
}

}  // namespace mansard
