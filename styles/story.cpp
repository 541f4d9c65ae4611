#include "styles/story.hpp"

#include <algorithm>
#include <functional>

namespace mansard {

// ---- a writing

Span Writing::at() const {
  Span at = std::visit([](const auto* is) { return is->at; }, syntax);
  for (const Span& doc : preamble().docs) at.begin = std::max(at.begin, doc.end);
  for (const auto& annotation : preamble().annotations)
    at.begin = std::max(at.begin, annotation.at.end);
  const std::string_view text = at.text();
  at.begin += static_cast<uint32_t>(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return at;
}

Span Writing::name() const {
  const auto name = [](const auto* is) {
    if constexpr (requires { is->symbol; }) {
      return is->symbol.at;
    } else {
      return is->name.at;
    }
  };
  return std::visit(name, syntax);
}

const syntax::Preamble& Writing::preamble() const {
  return std::visit([](const auto* is) -> const syntax::Preamble& { return is->pre; }, syntax);
}

std::vector<const Writing*> from_the_base(const std::vector<Writing>& writings) {
  std::vector<const Writing*> told;
  told.reserve(writings.size());
  for (const Writing& writing : writings) told.push_back(&writing);
  std::ranges::stable_sort(told, std::greater(), &Writing::rank);
  return told;
}

// ---- a story

std::string Story::full_name() const {
  if (kind == MemberKind::symbol || block.empty()) return std::string(name);
  return std::string(block).append(".").append(name);
}

const Writing* Story::in_force() const {
  const auto found = std::ranges::find(writings, Fate::in_force, &Writing::fate);
  return found == writings.end() ? nullptr : &*found;
}

// ---- all stories

std::size_t Stories::Hash::operator()(const Key& key) const {
  const std::hash<std::string_view> hash;
  return hash(key.name) * 31 + hash(key.block) * 7 + static_cast<std::size_t>(key.kind);
}

const Story* Stories::find(MemberKind kind, std::string_view block, std::string_view name) const {
  const auto found =
      numbers_.find({kind, kind == MemberKind::symbol ? std::string_view() : block, name});
  return found == numbers_.end() ? nullptr : &stories_[found->second];
}

std::vector<const Story*> Stories::named(std::string_view name) const {
  std::vector<const Story*> found;
  const auto dot = name.find('.');
  const std::string_view block = dot == std::string_view::npos ? "" : name.substr(0, dot);
  const auto [begin, end] = by_name_.equal_range(name.substr(dot + 1));
  for (auto at = begin; at != end; ++at) {
    const Story& story = stories_[at->second];
    if (dot == std::string_view::npos || story.block == block) found.push_back(&story);
  }
  std::ranges::sort(found);  // all of one vector: the order of all()
  return found;
}

bool Stories::earlier(const Span& a, const Span& b) {
  return a.source != b.source ? std::less<>()(a.source, b.source) : a.begin < b.begin;
}

const Story* Stories::at(const Source& source, uint32_t offset) const {
  const auto after =
      std::ranges::upper_bound(places_, Span{&source, offset, offset}, earlier, &Place::at);
  if (after == places_.begin()) return nullptr;
  const Place& place = *std::prev(after);
  return place.at.source == &source && offset <= place.at.end ? &stories_[place.story] : nullptr;
}

}  // namespace mansard
