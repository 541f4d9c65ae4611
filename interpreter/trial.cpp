#include "interpreter/trial.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/context.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/operations/functions.hpp"

namespace mansard {

/// The machine as it was, again: what an alternative made goes when this does. Its random draws,
/// and so its shapes, come out the same when it is derived in earnest.
class Trial {
 public:
  explicit Trial(Machine& machine)
      : machine_(machine),
        counts_(machine.counts_),
        siblings_(machine.siblings_),
        sibling_counts_(machine.sibling_counts_),
        building_(machine.building),
        meeting_(machine.meeting),
        production_(machine.production),
        emitted_(machine.emitted),
        nodes_(machine.nodes_.size()),
        solids_(machine.world.size()),
        frozen_(machine.world.frozen()),
        expanding_(machine.expanding),
        rules_(machine.current_rules_),
        lod_(machine.lod),
        keeps_tree_(machine.keeps_tree) {
    if (machine.program.snaps) planes_ = machine.planes;
    std::swap(stack_, machine.stack_);
    std::swap(waiting_, machine.waiting_);
    Building& side = machine.trials_[machine.trials_.take()];
    side.clear();
    side.id = building_->id;
    side.materials = building_->materials;  // shapes name them by number
    side.terminals.resize(building_->terminals.size());
    side.taken.resize(building_->taken.size());
    machine.building = &side;
    machine.lod = 3;  // the choice is the same at every level of detail
    machine.keeps_tree = false;
  }
  ~Trial() {
    std::swap(stack_, machine_.stack_);
    std::swap(waiting_, machine_.waiting_);
    machine_.tried_ += machine_.building->shapes;
    machine_.trials_.give_back();
    machine_.counts_.swap(counts_);
    machine_.siblings_ = siblings_;
    machine_.sibling_counts_.swap(sibling_counts_);
    machine_.building = building_;
    machine_.meeting = meeting_;
    machine_.production = production_;
    machine_.emitted = emitted_;
    machine_.nodes_.resize(nodes_);
    machine_.world.go_back(solids_, frozen_);
    if (machine_.program.snaps) machine_.planes = std::move(planes_);
    machine_.expanding = expanding_;
    machine_.current_rules_ = rules_;
    machine_.lod = lod_;
    machine_.keeps_tree = keeps_tree_;
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

 private:
  Machine& machine_;
  std::vector<Machine::Count> counts_;
  Machine::Siblings siblings_;
  std::vector<std::pair<uint32_t, uint32_t>> sibling_counts_;
  std::vector<Shape> stack_, waiting_;
  SnapPlanes planes_;
  Building* building_;
  Meeting* meeting_;
  const Production* production_;
  std::size_t emitted_, nodes_;
  uint32_t solids_, frozen_, expanding_, rules_;
  int lod_;
  bool keeps_tree_;
};

double Machine::try_part(Context& c, std::size_t i, ExprId score) {
  if (tried_ + building->shapes > options.max_shapes) {
    fail(c.call.at,
         "more than " + std::to_string(options.max_shapes) + " shapes to try in one building",
         "do alternatives stand in alternatives? --max-shapes allows more");
  }
  constexpr uint32_t most_nested = 20;
  if (trials_.size() >= most_nested) {
    fail(c.call.at, "alternatives more than " + std::to_string(most_nested) + " deep",
         "an alternative that comes to best(...) again is tried again each time");
  }
  Meeting* const round = meeting;
  const Trial trial(*this);
  try {
    Shape piece = c.shape;
    c.part(i, piece);
    std::ranges::reverse(stack_);
    derive_all();
    meeting = round;  // the score may ask the group of the shape itself
    scoring_ = true;
    const double result = number(score, c.env);
    scoring_ = false;
    return result;
  } catch (Failure& failure) {
    explain(failure.diagnostic);  // while it is known what was being derived
    throw;
  }
}

void Machine::note_choice(const Call& call, std::size_t part, const std::string& why) {
  if (!keeps_tree || building->rounds.empty()) return;
  building->rounds.back().answers.push_back({expanding, "best" + std::string(call.args_at.text()),
                                             "part " + std::to_string(part + 1), why});
}

namespace {

const Building& outcome(const FunctionCall& call) {
  Machine& machine = call.machine;
  if (!machine.scores()) {
    machine.fail(machine.program.spans[call.node],
                 "this is known only while best(...) tries its alternatives",
                 "it stands in the score of best(score) { A | B }");
  }
  return *machine.building;
}

}  // namespace

double made(const FunctionCall& call, std::string_view symbol) {
  const Building& building = outcome(call);
  const auto number = call.machine.program.symbols.find(symbol);
  return number ? static_cast<double>(building.terminals[*number]) : 0;
}

double reported(const FunctionCall& call, std::string_view key) {
  const auto& report = outcome(call).report;
  const auto entry = report.find(std::string(key));
  return entry == report.end() ? 0 : entry->second.sum;
}

namespace operation {

/// The first of those with the highest score.
void best(Context& c, Score score) {
  std::size_t chosen = 0;
  double most = 0;
  std::string scores;
  const std::size_t n = c.call.parts.size();
  for (std::size_t i = 0; i < n && n > 1; ++i) {
    const double value = c.machine.try_part(c, i, c.call.args[score.place].value);
    if (i == 0 || value > most) chosen = i, most = value;
    scores += (i == 0 ? "" : ", ") + number_text(value);
  }
  c.machine.note_choice(c.call, chosen, "scores " + scores);
  c.part(chosen, c.shape);
}

}  // namespace operation

}  // namespace mansard
