#include "styles/members.hpp"

#include <map>
#include <set>
#include <utility>

namespace mansard {

namespace {

using Key = std::pair<std::string_view, std::string_view>;

/// The slots of one kind of member, found by name while they are filled.
template <class T>
class Table {
 public:
  explicit Table(std::vector<Slot<T>>& slots) : slots_(slots) {}

  Slot<T>& at(std::string_view block, std::string_view name) {
    const auto [found, is_new] = places_.emplace(Key(block, name), slots_.size());
    if (is_new) slots_.push_back({block, name, {}});
    return slots_[found->second];
  }

 private:
  std::vector<Slot<T>>& slots_;
  std::map<Key, std::size_t> places_;
};

class Gatherer {
 public:
  explicit Gatherer(const Order& order)
      : order_(order), members_{{}, {}, {}, {}, {}, {}, {}, Replacements(order)} {}

  // Twice: from the base for the order of the slots, then from the derived style to fill them.
  Members gather() {
    filling_ = false;
    for (std::size_t rank = order_.size(); rank-- > 0;) add_style(rank);
    filling_ = true;
    for (std::size_t rank = 0; rank < order_.size(); ++rank) add_style(rank);
    return std::move(members_);
  }

 private:
  void add_style(std::size_t rank) {
    for (const syntax::StyleMember& member : order_[rank]->members) {
      std::visit([&](const auto& m) { add(m, {order_[rank], nullptr}, rank); }, member);
    }
  }

  void add(const syntax::Block& block, const Origin& from, std::size_t rank) {
    for (const auto& entry : block.elements) put(elements_, {}, entry, {from.style, &block}, rank);
    for (const auto& entry : block.materials)
      put(materials_, {}, entry, {from.style, &block}, rank);
    if (block.kind != syntax::BlockKind::rules) return;
    if (!filling_ && known_blocks_.insert(block.name.text).second) {
      members_.blocks.push_back(block.name.text);
    }
    for (const syntax::BlockItem& item : block.items) {
      std::visit([&](const auto& m) { add(m, {from.style, &block}, rank); }, item);
    }
  }
  void add(const syntax::Start&, const Origin&, std::size_t) {}
  void add(const syntax::Rule& rule, const Origin& from, std::size_t rank) {
    put(symbols_, {}, rule, from, rank);
  }
  void add(const syntax::AbstractSymbol& symbol, const Origin& from, std::size_t rank) {
    put(abstract_symbols_, {}, symbol, from, rank);
  }
  void add(const syntax::Variable& variable, const Origin& from, std::size_t rank) {
    put(variables_, block_name(from), variable, from, rank);
  }
  void add(const syntax::Function& function, const Origin& from, std::size_t rank) {
    put(functions_, block_name(from), function, from, rank);
  }

  static std::string_view block_name(const Origin& from) {
    return from.block ? from.block->name.text : std::string_view();
  }

  template <class T>
  static std::string_view name_of(const T& member) {
    if constexpr (requires { member.symbol; }) {
      return member.symbol.text;
    } else {
      return member.name.text;
    }
  }

  template <class T>
  void put(Table<T>& table, std::string_view block, const T& member, const Origin& from,
           std::size_t rank) {
    Slot<T>& slot = table.at(block, name_of(member));
    if (!filling_) return;
    slot.given.push_back(
        {&member, from, rank, from.block && members_.replaced.drops(*from.block, rank)});
  }

  const Order& order_;
  Members members_;
  Table<syntax::Rule> symbols_{members_.symbols};
  Table<syntax::AbstractSymbol> abstract_symbols_{members_.abstract_symbols};
  Table<syntax::Variable> variables_{members_.variables};
  Table<syntax::Function> functions_{members_.functions};
  Table<syntax::ElementEntry> elements_{members_.elements};
  Table<syntax::MaterialEntry> materials_{members_.materials};
  std::set<std::string_view> known_blocks_;
  bool filling_ = false;
};

}  // namespace

Replacements::Replacements(const Order& order) {
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    for_each_block(*order[rank], [&](const syntax::Block& block) {
      if (!block.replace) return;
      most_derived_.try_emplace(block.name.text, Replacement{{order[rank], &block}, rank});
    });
  }
}

Members gather(const Order& order) { return Gatherer(order).gather(); }

}  // namespace mansard
