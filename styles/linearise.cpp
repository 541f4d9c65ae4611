#include "styles/linearise.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "styles/complaint.hpp"

namespace mansard {

using syntax::Style;

namespace {

// Far above any library of styles; keeps the recursion and the sum of all orders small.
constexpr std::size_t most_ancestors = 250;

/// An order that the merge must keep: that of a parent, or the one in which the parents are named.
struct Wish {
  const Style* whose;
  bool parents_as_named;
  Order order;
  std::size_t next = 0;

  bool empty() const { return next == order.size(); }
  const Style* head() const { return order[next]; }
  bool holds_in_tail(const Style* style) const {
    return std::find(order.begin() + static_cast<std::ptrdiff_t>(next) + 1, order.end(), style) !=
           order.end();
  }
};

/// C3: again and again the first head that stands in no other wish's tail. Nothing when all heads
/// do; then `wishes` is left with the orders that contradict each other.
std::optional<Order> merge(std::vector<Wish>& wishes) {
  std::unordered_map<const Style*, int> in_tails;
  for (const Wish& wish : wishes) {
    for (std::size_t i = 1; i < wish.order.size(); ++i) ++in_tails[wish.order[i]];
  }
  Order merged;
  for (;;) {
    std::erase_if(wishes, [](const Wish& wish) { return wish.empty(); });
    if (wishes.empty()) return merged;
    const auto free =
        std::ranges::find_if(wishes, [&](const Wish& wish) { return in_tails[wish.head()] == 0; });
    if (free == wishes.end()) return std::nullopt;
    const Style* taken = free->head();
    merged.push_back(taken);
    for (Wish& wish : wishes) {
      if (wish.head() != taken) continue;
      ++wish.next;
      if (!wish.empty()) --in_tails[wish.head()];
    }
  }
}

/// Of wishes that are stuck, a ring of which each forbids the head of the one before it.
std::vector<const Wish*> ring_of(const std::vector<Wish>& wishes) {
  std::vector<const Wish*> path{&wishes.front()};
  for (;;) {
    const Wish& forbidding = *std::ranges::find_if(
        wishes, [&](const Wish& wish) { return wish.holds_in_tail(path.back()->head()); });
    const auto seen = std::ranges::find(path, &forbidding);
    if (seen != path.end()) return {seen, path.end()};
    path.push_back(&forbidding);
  }
}

Diagnostic contradiction(const Style& style, const std::vector<Wish>& wishes) {
  std::vector<Note> notes;
  std::string heads;
  for (const Wish* wish : ring_of(wishes)) {
    heads += (heads.empty() ? "" : " and ") + in_quotes(wish->head()->name.text);
    notes.push_back(
        {in_quotes(wish->whose->name.text) +
             (wish->parents_as_named ? " names its parents in the order " : " has the order ") +
             listed(wish->order),
         wish->whose->name.at});
  }
  notes.push_back(while_linking(style));
  return error(
      style.name.at,
      "the parents of " + in_quotes(style.name.text) + " disagree on the order of " + heads,
      std::move(notes), "name the parents in an order that all of them agree with");
}

}  // namespace

/// Depth first over the parents; each style's order is made from its parents' orders.
class Lineariser {
 public:
  Lineariser(const Library& library, Ancestry& ancestry, Diagnostics& diagnostics)
      : library_(library), ancestry_(ancestry), diagnostics_(diagnostics) {}

  bool visit(const Style& style) {
    if (ancestry_.lines_.contains(&style)) return true;
    if (failed_.contains(&style)) return false;
    if (std::ranges::find(path_, &style) != path_.end()) return refuse(ring_to(style));
    if (path_.size() + ancestry_.lines_.size() >= most_ancestors) {
      const Style& heir = *path_.front();
      return refuse(error(heir.name.at,
                          "style " + in_quotes(heir.name.text) + " inherits from more than " +
                              std::to_string(most_ancestors) + " styles",
                          {while_linking(heir)}));
    }
    path_.push_back(&style);
    const std::optional<Order> parents = parents_of(style);
    bool sound = parents.has_value();
    if (parents) {
      for (const Style* parent : *parents) sound = visit(*parent) && sound;
    }
    path_.pop_back();
    if (sound && linearise(style, *parents)) return true;
    failed_.insert(&style);
    return false;
  }

 private:
  bool refuse(Diagnostic diagnostic) {
    diagnostics_.add(std::move(diagnostic));
    return false;
  }

  /// Nothing when one is missing or named twice.
  std::optional<Order> parents_of(const Style& style) {
    Order parents;
    bool sound = true;
    for (const syntax::Name& name : style.parents) {
      const Style* parent = library_.find(name.text);
      if (!parent) {
        sound = refuse(unknown_parent(style, name));
      } else if (std::ranges::find(parents, parent) != parents.end()) {
        sound = refuse(error(name.at, in_quotes(name.text) + " is named twice as a parent",
                             {while_linking(style)}));
      } else {
        parents.push_back(parent);
        if (parent->pre.final) diagnostics_.add(heir_of_final(style, name, *parent));
      }
    }
    return sound ? std::optional(std::move(parents)) : std::nullopt;
  }

  Diagnostic unknown_parent(const Style& style, const syntax::Name& name) const {
    std::vector<std::string_view> known;
    for (const Style* other : library_.styles()) {
      if (other != &style) known.push_back(other->name.text);
    }
    std::string help = did_you_mean(name.text, std::move(known));
    if (help.empty()) help = library_.how_to_import(name.text, name.at);
    return error(name.at, "no style is called " + in_quotes(name.text), {while_linking(style)},
                 std::move(help));
  }

  static Diagnostic heir_of_final(const Style& style, const syntax::Name& name,
                                  const Style& parent) {
    return error(name.at, "style " + in_quotes(name.text) + " is final and can have no heirs",
                 {{"declared final here", parent.pre.final}, while_linking(style)});
  }

  /// Written from the same style on whichever style of the ring was asked for, so that it is one
  /// error and not as many as the ring has styles.
  Diagnostic ring_to(const Style& style) const {
    Order ring(std::ranges::find(path_, &style), path_.end());
    const auto position = [](const Style* s) {
      return std::pair(s->name.at.source ? s->name.at.source->name() : "", s->name.at.begin);
    };
    std::rotate(ring.begin(), std::ranges::min_element(ring, {}, position), ring.end());
    std::string text = "style " + in_quotes(ring.front()->name.text) + " inherits from itself: ";
    std::vector<Note> notes;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      text += std::string(ring[i]->name.text) + " : ";
      if (i == 0) continue;
      const Style& parent = *ring[(i + 1) % ring.size()];
      notes.push_back(
          {in_quotes(ring[i]->name.text) + " inherits from " + in_quotes(parent.name.text),
           mention(*ring[i], parent)});
    }
    text += ring.front()->name.text;
    notes.push_back(while_linking(*ring.front()));
    return error(mention(*ring[0], *ring[1 % ring.size()]), std::move(text), std::move(notes));
  }

  /// Where a style names its parent.
  static Span mention(const Style& style, const Style& parent) {
    return std::ranges::find(style.parents, parent.name.text, &syntax::Name::text)->at;
  }

  bool linearise(const Style& style, const Order& parents) {
    std::vector<Wish> wishes;
    for (const Style* parent : parents) {
      wishes.push_back({parent, false, ancestry_.order_of(*parent)});
    }
    wishes.push_back({&style, true, parents});
    std::optional<Order> merged = merge(wishes);
    if (!merged) return refuse(contradiction(style, wishes));
    merged->insert(merged->begin(), &style);
    Ancestry::Line& line = ancestry_.lines_[&style];
    line.members.insert(merged->begin(), merged->end());
    line.order = std::move(*merged);
    return true;
  }

  const Library& library_;
  Ancestry& ancestry_;
  Diagnostics& diagnostics_;
  Order path_;  ///< from the style asked for down to the one at hand
  std::unordered_set<const Style*> failed_;
};

std::optional<Ancestry> Ancestry::of(const Library& library, const Style& style,
                                     Diagnostics& diagnostics) {
  Ancestry ancestry(style);
  if (!Lineariser(library, ancestry, diagnostics).visit(style)) return std::nullopt;
  return ancestry;
}

const Style& Ancestry::meeting(const Style& a, const Style& b) const {
  const auto both = [&](const Style* style) { return inherits(*style, a) && inherits(*style, b); };
  return **std::find_if(order().rbegin(), order().rend(), both);
}

}  // namespace mansard
