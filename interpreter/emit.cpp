// A symbol in a successor becomes a child shape; one without rules a terminal.
#include <algorithm>

#include "interpreter/machine.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

/// Of a parameter or variable that stands as a symbol.
Value Machine::emitted_symbol(const Step& s, const Env& env) {
  const Value value = evaluate(s.what, env);
  if (value.type != Type::symbol) {
    fail(s.at, "'" + std::string(s.at.text()) + "' stands as a symbol but is " +
                   std::string(described(value.type)));
  }
  return value;
}

uint16_t Machine::style_named(const Value& name, Span at) const {
  if (name.type == Type::string) {
    if (const auto it = program.style_numbers.find(name.string());
        it != program.style_numbers.end()) {
      return it->second;
    }
  }
  std::vector<std::string_view> known;
  for (const CompiledStyle& style : program.styles) known.push_back(style.name);
  const std::string_view word = name.type == Type::string ? name.string() : std::string_view{};
  const auto meant = nearest(word, known);
  const_cast<Machine*>(this)->fail(
      at, "no style '" + std::string(word) + "' is loaded",
      meant ? "did you mean '" + std::string(*meant) + "'?"
            : "write at the top: import \"FILE.style\", the file that has it");
}

/// Makes the child of a copy of its parent.
void Machine::make_child(const Step& s, uint32_t symbol, uint32_t style, const Env& env,
                         Shape& child) {
  child.symbol = symbol;
  child.style = static_cast<uint16_t>(style);
  if (s.style_of != none) {
    child.style = style_named(evaluate(s.style_of, env), program.spans[s.style_of]);
  }
  child.plain = s.kind == StepKind::super || child.plain;
  child.depth = static_cast<uint16_t>(child.depth + 1);
  if (s.index != none) child.index = number(s.index, env);
  if (!child.plain) {
    child.arguments = nullptr;
    if (s.argument_count > 0) {
      Value* const values = values_.take(s.argument_count);
      for (uint32_t i = 0; i < s.argument_count; ++i) {
        values[i] = evaluate(program.arguments[s.arguments + i], env);
      }
      child.arguments = values;
    }
  }
  child.seed = next_seed(symbol);
}

/// A function of the parent's stream, the symbol and how many earlier siblings bear the same one.
uint64_t Machine::next_seed(uint32_t symbol) {
  const uint64_t hash = program.symbol_hashes[symbol];
  if (!siblings_.apart) {
    Count& count = counts_[symbol];
    if (count.node != expanding) count = {expanding, 0};
    return mix(mix(nodes_[expanding].seed, hash), count.count++);
  }
  const auto begin = sibling_counts_.begin() + static_cast<std::ptrdiff_t>(siblings_.first);
  auto known = std::find_if(begin, sibling_counts_.end(),
                            [&](const auto& count) { return count.first == symbol; });
  if (known == sibling_counts_.end()) known = sibling_counts_.insert(known, {symbol, 0});
  return mix(mix(siblings_.seed, hash), known->second++);
}

Machine::Apart::Apart(Machine& machine, uint64_t seed)
    : machine_(machine), before_(machine.siblings_) {
  machine.siblings_ = {true, seed, machine.sibling_counts_.size(), 0};
}

Machine::Apart::~Apart() {
  machine_.sibling_counts_.resize(machine_.siblings_.first);
  machine_.siblings_ = before_;
}

uint64_t Machine::stream_of_split() const {
  const uint64_t seed = siblings_.apart ? siblings_.seed : nodes_[expanding].seed;
  return mix(mix(seed, hash_of("split")), siblings_.splits);
}

void Machine::emit(const Step& s, uint32_t symbol, uint32_t style, const Shape& shape,
                   const Env& env) {
  ++emitted;
  if (symbol == nil_symbol) return;
  Shape& child = stack_.emplace_back(shape);  // where it stays unless it is a terminal
  make_child(s, symbol, style, env, child);
  child.node = static_cast<uint32_t>(nodes_.size());
  nodes_.push_back({expanding, symbol, child.seed});
  if (++building->shapes > options.max_shapes) {
    fail(s.at, "more than " + std::to_string(options.max_shapes) + " shapes in one building",
         "does a rule call itself without end? --max-shapes allows more");
  }
  if (keeps_tree) building->tree.push_back({child, expanding, false});
  placer_.note_depth(child.depth);
  const uint32_t rules = rules_of(child);
  if (program.asks && (rules == none || !program.rule_sets[rules].waits)) show(child, false);
  if (rules == none) {
    finish(child);
    return stack_.pop_back();
  }
  if (child.depth > options.max_depth) {
    fail(s.at, "more than " + std::to_string(options.max_depth) + " shapes deep",
         rounds_ > 1 ? "after " + std::to_string(rounds_) +
                           " rounds: what a shape becomes asks again, in a round of its own; give "
                           "it a condition that ends it, or --max-depth"
                     : "does a rule call itself without end? give it a condition that ends it, or "
                       "--max-depth");
  }
  check_arguments(s, program.rule_sets[rules], child);
}

void Machine::check_arguments(const Step& s, const RuleSet& rules, const Shape& child) {
  if (s.kind == StepKind::super || rules.parameters == s.argument_count) return;
  fail(s.at, "'" + std::string(program.symbols[child.symbol]) + "' takes " +
                 count_text(rules.parameters, "argument") + ", not " +
                 std::to_string(s.argument_count));
}

void Machine::finish(Shape& shape) {
  ++building->terminals[shape.symbol];
  placer_.note_terminal(shape.symbol);
  if (keeps_tree) building->tree[shape.node].terminal = true;
  if (program.asks && is_solid(shape)) mark_active(shape);
  draw(shape, shape.symbol);
}

void Machine::finish_early(Shape& piece) {
  ++emitted;
  ++building->shapes;
  ++building->terminals[piece.symbol];
  placer_.note_terminal(piece.symbol);
  if (program.asks) show(piece, true);
  draw(piece, piece.symbol);
  piece.form = Form::nothing;
  piece.plain = true;
}

}  // namespace mansard
