#include "interpreter/group.hpp"

#include <algorithm>
#include <functional>
#include <span>

#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

double Meeting::gather(Machine& machine, Gather how, uint32_t expr, uint32_t within) {
  const uint32_t rules = machine.rules_of(shapes[current]);
  for (std::size_t i = 0; i < used_; ++i) {
    const Tally& t = tallies_[i];
    if (t.known && t.how == how && t.expr == expr && t.within == within && t.rules == rules)
      return t.of[current];
  }
  std::vector<Member> members;
  for (uint32_t i = 0; i < shapes.size(); ++i) {
    if (machine.rules_of(shapes[i]) != rules) continue;
    const uint32_t root = within == none ? none : machine.ancestor(shapes[i], within);
    members.push_back({root, i, machine.value_for(shapes[i], expr, how)});
  }
  if (used_ == tallies_.size()) tallies_.emplace_back();
  Tally& tally = tallies_[used_++];  // those that the expression itself asked for came before
  tally.how = how;
  tally.expr = expr;
  tally.within = within;
  tally.rules = rules;
  tally.of.assign(shapes.size(), 0);
  reduce(how, members, tally.of);
  tally.known = true;
  return tally.of[current];
}

namespace {

double reduced(Gather how, const auto& members) {
  double sum = 0, least = members[0].value, most = members[0].value;
  for (const auto& m : members) {
    sum += m.value;
    least = std::min(least, m.value);
    most = std::max(most, m.value);
  }
  switch (how) {
    case Gather::any:
    case Gather::most:
      return most;
    case Gather::count:
    case Gather::sum:
      return sum;
    default:  // of conditions, ones and zeros, whether all hold
      return least;
  }
}

}  // namespace

/// `members` come in the order of derivation, which settles ties.
void Meeting::reduce(Gather how, std::vector<Member>& members, std::vector<double>& of) {
  std::ranges::stable_sort(members, {}, &Member::root);
  for (auto first = members.begin(); first != members.end();) {
    const auto last =
        std::find_if(first, members.end(), [&](const Member& m) { return m.root != first->root; });
    const std::span<Member> group(first, last);
    if (how == Gather::rank || how == Gather::best) {
      std::ranges::stable_sort(group, std::greater(), &Member::value);
      for (std::size_t i = 0; i < group.size(); ++i) {
        const auto rank = static_cast<double>(i);
        of[group[i].shape] = how == Gather::rank ? rank : i == 0;
      }
    } else {
      const double result = reduced(how, group);
      for (const Member& m : group) of[m.shape] = result;
    }
    first = last;
  }
}

uint32_t Machine::ancestor(const Shape& shape, uint32_t symbol) const {
  uint32_t n = nodes_[shape.node].parent;
  while (n < nodes_.size() && nodes_[n].symbol != symbol) n = nodes_[n].parent;
  return n < nodes_.size() ? n : none;
}

/// Draws of the expression are the shape's own, whoever asks.
double Machine::value_for(const Shape& shape, ExprId expr, Gather how) {
  Env env{&shape, shape.arguments, mix(shape.seed, hash_of("group")), &shape.scope};
  if (production) bind_index(*production, program.rule_sets[rules_of(shape)], shape, env);
  const Value value = evaluate(expr, env);
  const Type wanted = how <= Gather::count ? Type::boolean : Type::number;
  if (value.type != wanted) {
    fail(program.spans[expr], "a group is asked here for " + std::string(described(wanted)) +
                                  " of each shape, not for " + std::string(described(value.type)));
  }
  if (value.type == Type::boolean) return value.boolean ? 1 : 0;
  return value.number;
}

namespace {

double gather(const FunctionCall& call, Gather how, ExprId each, Type wanted, Within within) {
  Machine& machine = call.machine;
  if (!machine.meeting) {
    machine.fail(machine.program.spans[call.node],
                 "only a rule can ask a group, while its shape waits");
  }
  const auto symbol = within ? machine.program.symbols.find(*within).value_or(none) : none;
  const double result = machine.meeting->gather(machine, how, each, symbol);
  const Meeting& meeting = *machine.meeting;
  const std::string answer =
      wanted == Type::boolean ? (result != 0 ? "true" : "false") : number_text(result);
  std::string why;
  if (machine.keeps_tree && how >= Gather::rank)
    why = "score " + number_text(machine.value_for(meeting.shapes[meeting.current], each, how));
  machine.note_answer(call.node, meeting.shapes[meeting.current], answer, why);
  return result;
}

Value truth(const FunctionCall& call, Gather how, ExprId each, Within within) {
  return Value::of(gather(call, how, each, Type::boolean, within) != 0);
}
Value count(const FunctionCall& call, Gather how, ExprId each, Within within) {
  return Value::of(gather(call, how, each, Type::number, within));
}

}  // namespace

Value group_any(const FunctionCall& call, Each<bool> each, Within within) {
  return truth(call, Gather::any, each.expr, within);
}
Value group_all(const FunctionCall& call, Each<bool> each, Within within) {
  return truth(call, Gather::all, each.expr, within);
}
Value group_count(const FunctionCall& call, Each<bool> each, Within within) {
  return count(call, Gather::count, each.expr, within);
}
Value group_sum(const FunctionCall& call, Each<double> each, Within within) {
  return count(call, Gather::sum, each.expr, within);
}
Value group_max(const FunctionCall& call, Each<double> each, Within within) {
  return count(call, Gather::most, each.expr, within);
}
Value group_min(const FunctionCall& call, Each<double> each, Within within) {
  return count(call, Gather::least, each.expr, within);
}
Value group_rank(const FunctionCall& call, Each<double> each, Within within) {
  return count(call, Gather::rank, each.expr, within);
}
Value group_best(const FunctionCall& call, Each<double> each, Within within) {
  return truth(call, Gather::best, each.expr, within);
}

}  // namespace mansard
