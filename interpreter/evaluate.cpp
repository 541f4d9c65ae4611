// Expressions.
#include <cmath>

#include "interpreter/function.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/measure.hpp"
#include "interpreter/messages.hpp"

namespace mansard {
Value Machine::evaluate(ExprId id, const Env& env) {
  const ExprNode& node = program.nodes[id];
  const uint32_t* const child = program.children.data() + node.children;
  switch (node.kind) {
    case ExprKind::constant:
      return program.constants[node.first];
    case ExprKind::attribute:
      return attribute(static_cast<Attribute>(node.aux), env.shape, id);
    case ExprKind::parameter: {
      const Value& value = env.parameters[node.aux];
      if (value.type == Type::number && std::isnan(value.number)) {
        fail(program.spans[id], "the index of this shape is not set",
             "a symbol sets it where it is emitted: FLOOR[split.index]");
      }
      return value;
    }
    case ExprKind::variable:
      return variable(node.first, env, id);
    case ExprKind::property: {
      const Value fallback = evaluate(child[0], env);
      return property(node.first, fallback, id);
    }
    case ExprKind::input:
      return input(static_cast<Input>(node.aux)).from(id);
    case ExprKind::fits:
      return Value::of(fits(node.first, env)).from(id);
    case ExprKind::list: {
      Value* const items = values_.take(node.count);
      for (uint32_t i = 0; i < node.count; ++i) items[i] = evaluate(child[i], env);
      return Value::of(std::span<const Value>(items, node.count)).from(id);
    }
    case ExprKind::subscript:
      return subscript(node, env);
    case ExprKind::negate:
      return Value::of(-number(child[0], env)).from(id);
    case ExprKind::invert:
      return Value::of(!condition(child[0], env)).from(id);
    case ExprKind::and_:
      return Value::of(condition(child[0], env) && condition(child[1], env)).from(id);
    case ExprKind::or_:
      return Value::of(condition(child[0], env) || condition(child[1], env)).from(id);
    case ExprKind::conditional:
      return evaluate(child[condition(child[0], env) ? 1 : 2], env);
    case ExprKind::call:
      return call_function(node, id, env);
    case ExprKind::definition:
      return define(node, id, env);
    default:
      return infix(node, id, env);
  }
}

Value Machine::infix(const ExprNode& node, uint32_t id, const Env& env) {
  const uint32_t* const child = program.children.data() + node.children;
  const Value a = evaluate(child[0], env), b = evaluate(child[1], env);
  if (a.type == Type::number && b.type == Type::number) {
    double result = 0;
    switch (node.kind) {
      case ExprKind::add:
        result = a.number + b.number;
        break;
      case ExprKind::subtract:
        result = a.number - b.number;
        break;
      case ExprKind::multiply:
        result = a.number * b.number;
        break;
      case ExprKind::divide:
        if (b.number == 0) {
          Diagnostic d;
          d.at = program.spans[child[1]];
          d.text = "division by zero: '" + std::string(d.at.text()) + "' is 0 here";
          note_writer(d, "the 0", program.origin(b));
          throw Failure(std::move(d));
        }
        result = a.number / b.number;
        break;
      default:
        return compare(node, id, a, b);
    }
    if (!std::isfinite(result)) fail(program.spans[id], "the result is too large to be a number");
    return Value::of(result).from(id);
  }
  if (node.kind == ExprKind::add && a.type == Type::string && b.type == Type::string) {
    return Value::of(keep(std::string(a.string()) + std::string(b.string()))).from(id);
  }
  if (auto wrong = operand_error(program, node, a.type, b.type, child[0], child[1])) {
    for (const Value& v : {a, b}) note_writer(*wrong, described(v.type), program.origin(v));
    throw Failure(std::move(*wrong));
  }
  return compare(node, id, a, b);
}

Value Machine::compare(const ExprNode& node, uint32_t id, const Value& a, const Value& b) {
  const auto answer = [&](bool yes) { return Value::of(yes).from(id); };
  switch (node.kind) {
    case ExprKind::equal:
      return answer(equal(a, b));
    case ExprKind::unequal:
      return answer(!equal(a, b));
    default:
      break;
  }
  if (a.type == Type::number) {
    switch (node.kind) {
      case ExprKind::less:
        return answer(a.number < b.number);
      case ExprKind::less_equal:
        return answer(a.number <= b.number);
      case ExprKind::greater:
        return answer(a.number > b.number);
      default:
        return answer(a.number >= b.number);
    }
  }
  if (a.type == Type::string) {
    const int order = a.string().compare(b.string());
    switch (node.kind) {
      case ExprKind::less:
        return answer(order < 0);
      case ExprKind::less_equal:
        return answer(order <= 0);
      case ExprKind::greater:
        return answer(order > 0);
      default:
        return answer(order >= 0);
    }
  }
  fail(program.spans[id],
       "only numbers and strings have an order, not " + std::string(described(a.type)),
       "compare with == or !=");
}

bool Machine::condition(ExprId id, const Env& env) {
  const Value value = evaluate(id, env);
  if (value.type != Type::boolean) {
    fail(program.spans[id], "expected true or false, found " + std::string(described(value.type)),
         "compare it with something: '" + std::string(program.spans[id].text()) + " > 0'");
  }
  return value.boolean;
}

double Machine::number(ExprId id, const Env& env) {
  const Value value = evaluate(id, env);
  if (value.type != Type::number) {
    Diagnostic d;
    d.at = program.spans[id];
    d.text = "expected a number, found " + std::string(described(value.type));
    note_writer(d, described(value.type), program.origin(value));
    throw Failure(std::move(d));
  }
  if (!std::isfinite(value.number)) fail(program.spans[id], "this is not a finite number");
  return value.number;
}

Value Machine::subscript(const ExprNode& node, const Env& env) {
  const uint32_t* const child = program.children.data() + node.children;
  const Value list = evaluate(child[0], env);
  if (list.type != Type::list) {
    fail(program.spans[child[0]],
         "only a list has items, not " + std::string(described(list.type)));
  }
  const double index = number(child[1], env);
  if (index < 0 || index >= list.size || index != std::floor(index)) {
    fail(program.spans[child[1]],
         "no item " + number_text(index) + " in a list of " + std::to_string(list.size),
         list.size > 0 ? "items are numbered from 0 to " + std::to_string(list.size - 1)
                       : "the list is empty");
  }
  return list.items[static_cast<std::size_t>(index)];
}

Machine::Deeper::Deeper(Machine& machine, uint32_t node, int levels)
    : machine_(machine), levels_(levels) {
  constexpr int deepest = 3000;
  if (machine_.depth_ + levels_ > deepest) {
    machine_.fail(machine_.program.spans[node],
                  "functions or variables that call each other without end",
                  "give the recursion an end with 'if ... then ... else'");
  }
  machine_.depth_ += levels_;
}

Value Machine::define(const ExprNode& node, uint32_t id, const Env& env) {
  const FunctionSlot& function = program.functions[node.first];
  const Deeper deeper(*this, id, program.depths[function.value] + 1);
  count_call(id);
  Value* const arguments = values_.take(node.count);
  for (uint32_t i = 0; i < node.count; ++i) {
    arguments[i] = evaluate(program.children[node.children + i], env);
  }
  const Value result = evaluate(
      function.value, Env{env.shape, arguments, mix(env.draws, node.salt + 1u), env.frame});
  return result;
}

void Machine::count_call(uint32_t id) {
  constexpr std::size_t most_calls = 20'000'000;
  if (++calls_ <= most_calls) return;
  fail(program.spans[id], "more than 20 million calls of functions and variables in one building");
}

Value Machine::call_function(const ExprNode& node, uint32_t id, const Env& env) {
  const Function& function = functions()[node.aux];
  if (function.random) reads |= read_bits::chance;
  if (measuring) measurer_->check_call(function, id);
  std::array<Value, 8> few;
  Value* const values = node.count <= few.size() ? few.data() : values_.take(node.count);
  for (uint32_t i = function.each ? 1 : 0; i < node.count; ++i) {
    values[i] = evaluate(program.children[node.children + i], env);
  }
  const uint64_t draw = function.random ? mix(env.draws, node.salt) : 0;
  const Value result = function.invoke({*this, {values, node.count}, draw, id, env.shape});
  // Of questions only: what is not there is infinitely far.
  if (result.type == Type::number && !std::isfinite(result.number) &&
      function.asks != Asks::others) {
    std::string of;
    for (uint32_t i = 0; i < node.count; ++i) {
      if (values[i].type == Type::number)
        of += (of.empty() ? "" : ", ") + number_text(values[i].number);
    }
    fail(program.spans[id], "'" + std::string(function.name) + "(" + of + ")' is not a number");
  }
  return result.origin == Value::unknown_origin ? result.from(id) : result;
}

const Value* Machine::keep(std::span<const Value> values) {
  Value* const kept = values_.take(values.size());
  std::copy(values.begin(), values.end(), kept);
  return kept;
}

std::string_view Machine::keep(std::string_view text) {
  if (text.size() > 1'000'000) fail({}, "a string of more than a million characters");
  char* const kept = characters_.take(text.size());
  std::copy(text.begin(), text.end(), kept);
  return {kept, text.size()};
}

}  // namespace mansard
