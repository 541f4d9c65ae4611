// Shapes that ask about others wait; when nothing else is left, those of the lowest stage see what
// there is by then, all of them the same, and go on. So no answer depends on the order of work.
#include <algorithm>

#include "interpreter/machine.hpp"

namespace mansard {

void Machine::show(Shape& shape, bool active) {
  if (!is_solid(shape) || !shape.hides) return;
  shape.solid = world.add(shape, active);
}

/// Of a terminal: nothing takes its place.
void Machine::mark_active(const Shape& shape) {
  if (shape.solid == Shape::none) return;
  Occluder& occluder = world[shape.solid];
  occluder.active = occluder.active || occluder.shape.node == shape.node;
}

void Machine::show_apart(Shape& shape) {
  if (shape.solid != Shape::none) {
    const Shape& known = world[shape.solid].shape;
    const Scope &a = known.scope, &b = shape.scope;
    const bool same = known.form == shape.form && known.geometry == shape.geometry &&
                      a.origin == b.origin && a.size == b.size && a.x == b.x && a.y == b.y;
    if (same) return;
  }
  show(shape, false);
}

/// Those that wait are of one stage or of several; what they emit is derived before the next round.
void Machine::answer_round() {
  uint16_t stage = 0xffff;
  for (const Shape& shape : waiting_)
    stage = std::min(stage, program.rule_sets[rules_of(shape)].stage);
  Meeting& round = meetings_[meetings_.take()];
  round.open();
  auto kept = waiting_.begin();
  for (const Shape& shape : waiting_) {
    if (program.rule_sets[rules_of(shape)].stage == stage) {
      round.shapes.push_back(shape);
    } else {
      *kept++ = shape;
    }
  }
  waiting_.erase(kept, waiting_.end());
  world.freeze();
  ++rounds_;
  if (program.snaps) planes.freeze(*this);
  if (keeps_tree) building->rounds.push_back({stage, round.shapes.size(), {}, {}});
  last_cover.known = false;
  for (Shape& shape : round.shapes) show(shape, false);
  for (uint32_t i = 0; i < round.shapes.size(); ++i) {
    meeting = &round;  // an alternative's own rounds may have come between
    round.current = i;
    Shape shape = round.shapes[i];
    const std::size_t first = stack_.size();
    replace(shape);
    std::reverse(stack_.begin() + static_cast<std::ptrdiff_t>(first), stack_.end());
  }
  meeting = nullptr;
  meetings_.give_back();
  std::reverse(stack_.begin(), stack_.end());  // the first one's first child is on top
}

void Machine::note_answer(uint32_t node, const Shape& shape, std::string_view answer,
                          const std::string& why) {
  if (!keeps_tree || building->rounds.empty()) return;
  Answer now{shape.node, std::string(program.spans[node].text()), std::string(answer), why};
  auto& answers = building->rounds.back().answers;
  const bool again = !answers.empty() && answers.back().node == now.node &&
                     answers.back().asked == now.asked && answers.back().answer == now.answer;
  if (!again) answers.push_back(std::move(now));
}

}  // namespace mansard
