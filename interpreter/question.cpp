#include "interpreter/question.hpp"

#include <algorithm>

#include "geometry/clip.hpp"
#include "interpreter/component.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"
#include "interpreter/solid_set.hpp"
#include "interpreter/surroundings.hpp"

namespace mansard {
namespace {

/// A question of one shape, put to the frozen world face by face.
class Question {
 public:
  Question(const FunctionCall& call, std::string_view set, double distance)
      : machine_(call.machine),
        shape_(*call.shape),
        distance_(distance),
        set_(machine_, shape_, set) {}

  Cover cover();
  bool touches();
  /// What covers it, in the user's words.
  const std::string& why() const { return why_; }

 private:
  template <class F>
  void for_each_face(F f);
  Cover cover_of(const Shape& face);
  bool touches_at(const Shape& face);
  void neighbours_before(const Shape& face, const Polygon& outline, std::vector<Polygon>& pieces);
  void name(const std::string& occluder);

  Machine& machine_;
  const Shape& shape_;
  double distance_;
  SolidSet set_;
  std::vector<uint32_t> found_;
  std::string why_;
};

/// A rectangle or polygon is its own face; of a solid they are all faces.
template <class F>
void Question::for_each_face(F f) {
  auto& faces = machine_.scratch_shapes;
  const std::size_t first = faces.size();
  push_faces(machine_, shape_);
  const std::size_t end = faces.size();
  for (std::size_t i = first; i < end; ++i) {
    const Shape face = faces[i];
    f(face);
  }
  faces.resize(first);
}

Cover Question::cover() {
  bool some = false, all = true, any_face = false;
  for_each_face([&](const Shape& face) {
    const Cover answer = cover_of(face);
    any_face = true;
    some = some || answer != Cover::nothing;
    all = all && answer == Cover::full;
  });
  if (!any_face || !some) return Cover::nothing;
  return all ? Cover::full : Cover::part;
}

void Question::name(const std::string& occluder) {
  if (machine_.keeps_tree) why_ += (why_.empty() ? "" : ", ") + occluder;
}

Cover Question::cover_of(const Shape& face) {
  const double reach = std::max(contact, distance_);
  machine_.world.near(grown(bounds_of(face.scope), reach), found_);
  std::erase_if(found_, [&](uint32_t solid) { return !set_.has(solid); });
  const bool neighbours = set_.has_neighbours();
  if (found_.empty() && !(neighbours && machine_.footprint->around)) return Cover::nothing;
  const Polygon outline = plan_of(machine_, face);
  std::vector<Polygon> pieces;
  for (const uint32_t solid : found_) {
    std::vector<Polygon> before =
        distance_ > 0 ? machine_.world.shadow_of(machine_, solid, face.scope, contact,
                                                 contact + distance_, distance_)
                      : machine_.world.section_of(machine_, solid, face.scope, contact);
    if (covered(outline, before, thinnest_cover) == Cover::nothing) continue;
    const Shape& by = machine_.world[solid].shape;
    name(std::string(machine_.program.symbols[by.symbol]) + " (node " + std::to_string(by.node) +
         ")");
    std::move(before.begin(), before.end(), std::back_inserter(pieces));
  }
  const std::size_t own = pieces.size();
  if (neighbours) neighbours_before(face, outline, pieces);
  return covered(outline, pieces, pieces.size() > own ? thinnest_party : thinnest_cover);
}

/// Two sections: of neighbours that stand in this footprint by a little, and of those beside it.
void Question::neighbours_before(const Shape& face, const Polygon& outline,
                                 std::vector<Polygon>& pieces) {
  const Footprint& footprint = *machine_.footprint;
  if (!footprint.around) return;
  const double reach = party + contact + distance_;
  footprint.around->near(grown(bounds_of(face.scope), reach), found_);
  for (const uint32_t place : found_) {
    if (place == footprint.place) continue;
    const Prism& block = footprint.around->block(place);
    std::vector<Polygon> before;
    if (distance_ > 0) {
      before = shadow(to_mesh(block), face.scope, contact, reach, distance_);
    } else {
      before = section(block, face.scope, contact);
      for (Polygon& further : section(block, face.scope, contact + party))
        before.push_back(std::move(further));
    }
    if (covered(outline, before, thinnest_party) == Cover::nothing) continue;
    name("the neighbour '" + footprint.around->id(place) + "'");
    std::move(before.begin(), before.end(), std::back_inserter(pieces));
  }
}

bool Question::touches() {
  bool yes = false;
  for_each_face([&](const Shape& face) { yes = yes || touches_at(face); });
  return yes;
}

/// A solid ends in the face's plane where it is on one side of it and not on the other.
bool Question::touches_at(const Shape& face) {
  machine_.world.near(grown(bounds_of(face.scope), contact), found_);
  std::erase_if(found_, [&](uint32_t solid) { return !set_.has(solid); });
  const Polygon outline = plan_of(machine_, face);
  const auto ends = [&](const std::vector<Polygon>& on, const std::vector<Polygon>& off) {
    for (const Polygon& piece : on) {
      for (const Polygon& in : intersection(outline, piece)) {
        if (covered(in, off, thinnest_cover) != Cover::full && thickness(in) > thinnest_cover)
          return true;
      }
    }
    return false;
  };
  for (const uint32_t solid : found_) {
    const auto before = machine_.world.section_of(machine_, solid, face.scope, contact);
    const auto behind = machine_.world.section_of(machine_, solid, face.scope, -contact);
    if (!ends(before, behind) && !ends(behind, before)) continue;
    name(std::string(machine_.program.symbols[machine_.world[solid].shape.symbol]));
    return true;
  }
  if (!set_.has_neighbours()) return false;
  std::vector<Polygon> pieces;
  neighbours_before(face, outline, pieces);
  return !pieces.empty();
}

constexpr std::array<std::string_view, 3> words{"none", "part", "full"};

std::string_view word_of(Cover cover) { return words[static_cast<std::size_t>(cover)]; }

Cover answer(const FunctionCall& call, std::string_view set, std::optional<double> distance,
             std::string& why) {
  if (!call.shape) {
    call.machine.fail(call.machine.program.spans[call.node], "there is no shape to ask about here");
  }
  if (distance && !(*distance >= 0 && *distance <= 1000)) {
    call.machine.fail(call.machine.program.spans[call.node],
                      "a distance lies between 0 and 1000 m, not " + number_text(*distance));
  }
  LastCover& last = call.machine.last_cover;
  if (!last.holds(*call.shape, set, distance.value_or(0))) {
    Question question(call, set, distance.value_or(0));
    const Cover cover = question.cover();
    last = {*call.shape, std::string(set), distance.value_or(0), cover, question.why(), true};
  }
  why = last.why;
  return last.cover;
}

/// "distance", then metres, or neither.
void check_word(const FunctionCall& call, Word word, std::optional<double> distance) {
  const Program& program = call.machine.program;
  if (word && *word != "distance") {
    call.machine.fail(program.spans[program.children[program.nodes[call.node].children + 1]],
                      "a question goes on with \"distance\", not \"" + std::string(*word) + "\"",
                      "write \"distance\", then metres");
  }
  if (word && !distance) {
    call.machine.fail(program.spans[call.node], "the distance is missing",
                      "\"distance\", then metres");
  }
}

Value yes_or_no(const FunctionCall& call, bool yes, const std::string& why) {
  call.machine.note_answer(call.node, *call.shape, yes ? "true" : "false", why);
  return Value::of(yes);
}

}  // namespace

Value ask_cover(const FunctionCall& call, std::string_view set, Word word,
                std::optional<double> distance) {
  check_word(call, word, distance);
  std::string why;
  const std::string_view cover = word_of(answer(call, set, distance, why));
  call.machine.note_answer(call.node, *call.shape, cover, why);
  return Value::of(cover);
}

Value ask_inside(const FunctionCall& call, std::string_view set, Word word,
                 std::optional<double> distance) {
  check_word(call, word, distance);
  std::string why;
  const bool yes = answer(call, set, distance, why) == Cover::full;
  return yes_or_no(call, yes, why);
}

Value ask_overlaps(const FunctionCall& call, std::string_view set, Word word,
                   std::optional<double> distance) {
  check_word(call, word, distance);
  std::string why;
  const bool yes = answer(call, set, distance, why) != Cover::nothing;
  return yes_or_no(call, yes, why);
}

Value ask_touches(const FunctionCall& call, std::string_view set) {
  if (!call.shape) {
    call.machine.fail(call.machine.program.spans[call.node], "there is no shape to ask about here");
  }
  Question question(call, set, 0);
  const bool yes = question.touches();
  return yes_or_no(call, yes, question.why());
}

}  // namespace mansard
