// Arguments and parts of an operation being carried out.
#include <cmath>

#include "interpreter/context.hpp"
#include "interpreter/messages.hpp"

namespace mansard {

void Context::go_on(const CallPart& given_part, std::size_t i, Shape& piece) {
  if (++machine.parts > machine.options.max_shapes) {
    machine.fail(
        call.at,
        "more than " + std::to_string(machine.options.max_shapes) + " parts in one building",
        "are the sizes in metres? --max-shapes allows more");
  }
  const Scope frame = piece.scope;
  const Env inner{&piece, env.parameters, mix(env.draws, mix(call.salt, i)), &frame};
  if (!apart_) return machine.run(given_part.body, piece, inner);
  const Machine::Apart numbered(machine, stream_of(given_part, piece));
  machine.run(given_part.body, piece, inner);
}

void Context::look_apart() {
  apart_ = true;
  stream_ = machine.stream_of_split();
}

void Context::count_apart() {
  if (!call.measures) return;
  look_apart();
  machine.count_split();
}

uint64_t Context::stream_of(const CallPart& given_part, const Shape& piece) const {
  return mix(stream_, mix(given_part.stream, call.parts_repeat ? piece.split_index : 0));
}

void Context::part(std::size_t i, Shape& piece) {
  const std::size_t which = call.parts.size() == 1 ? 0 : i;
  go_on(call.parts[which], i, piece);
}

void Context::named_part(std::size_t i, Shape& piece) {
  if (wants(i)) go_on(call.parts[call.part_of[i]], pieces_[i]++, piece);
}

void Context::become(Shape& piece) {
  if (call.has_parts) {
    go_on(call.parts[0], 0, piece);
  } else if (&piece != &shape) {
    shape = piece;
  }
}

Span Context::at(std::size_t i) const {
  return given(i) ? machine.program.spans[call.args[i].value] : call.at;
}

Value Context::value(std::size_t i) { return machine.evaluate(call.args[i].value, env); }

void Context::wrong_type(std::size_t i, const Value& value, std::string_view expected) {
  Diagnostic d;
  d.at = at(i);
  d.text = "'" + std::string(call.operation->name) + "' expects " + std::string(expected) +
           " for '" + std::string(call.operation->parameter_name(i)) + "', not " +
           std::string(described(value.type));
  note_writer(d, described(value.type), machine.program.origin(value));
  throw Failure(std::move(d));
}

void Context::fail(std::size_t i, std::string text, std::string help) {
  machine.fail(at(i), std::move(text), std::move(help));
}

double Context::number(std::size_t i) {
  const Value v = value(i);
  if (v.type != Type::number) wrong_type(i, v, "a number");
  if (!std::isfinite(v.number)) fail(i, "this is not a finite number");
  return v.number;
}

template <>
double Context::take<double>(std::size_t i) {
  return number(i);
}

template <>
Length Context::take<Length>(std::size_t i) {
  const bool share = call.args[i].kind == syntax::SizeKind::percent;
  return {share ? number(i) / 100 : number(i), share};
}

template <>
bool Context::take<bool>(std::size_t i) {
  const Value v = value(i);
  if (v.type != Type::boolean) wrong_type(i, v, "true or false");
  return v.boolean;
}

template <>
std::string_view Context::take<std::string_view>(std::size_t i) {
  const Value v = value(i);
  if (v.type != Type::string) wrong_type(i, v, "a string");
  return v.string();
}

template <>
Value Context::take<Value>(std::size_t i) {
  return value(i);
}

template <>
Edges Context::take<Edges>(std::size_t i) {
  const Value v = value(i);
  if (v.type == Type::boolean || v.type == Type::symbol) {
    wrong_type(i, v, "the word or number of an edge, or a list of them");
  }
  return {v};
}

template <>
Sizes Context::take<Sizes>(std::size_t) {
  return {call.operation->count};
}

template <>
Values Context::take<Values>(std::size_t) {
  return {call.operation->count};
}

template <>
Score Context::take<Score>(std::size_t i) {
  return {i};
}

template <>
Setting Context::take<Setting>(std::size_t) {
  return {};
}

}  // namespace mansard
