// Names, numbers, texts, expressions, arguments.
#include <algorithm>
#include <charconv>
#include <limits>

#include "grammar/build.hpp"
#include "grammar/in_quotes.hpp"
#include "grammar/trail.hpp"
#include "grammar/utf8.hpp"

namespace mansard {

using namespace syntax;  // NOLINT: this file is about them

// 1r and 30% are read like values, so that a misplaced one is told by its own words.
ExprPtr TreeBuilder::expr(const Node& node) {
  if (node.tag == Tag::amount) {
    const bool share = words(node).back() == 'r';
    wrong(span(node),
          in_quotes(words(node)) +
              (share ? " is a share of a split" : " is a percentage of a scope") +
              " and can only stand as a whole size",
          share ? "" : "the remainder of a division is mod(a, b)");
  }
  return bare_expr(node);
}

ExprPtr TreeBuilder::bare_expr(const Node& node) {
  switch (node.tag) {
    case Tag::amount:
      return bare_expr(*child(node));
    case Tag::parenthesis: {
      ExprPtr inner = expr(*child(node));
      inner->at = span(node);
      return inner;
    }
    case Tag::number:
      return number(node);
    case Tag::text:
      return text(node);
    case Tag::boolean:
      return make(node, Boolean{words(node) == "true"});
    case Tag::list: {
      List list;
      for (const Node* item = child(node); item; item = next(*item)) {
        list.items.push_back(expr(*item));
      }
      return make(node, std::move(list));
    }
    case Tag::name:
      return make(node, Reference{{}, {name(node)}});
    case Tag::qualified:
    case Tag::reference:
      return make(node, reference(node));
    case Tag::call: {
      const Node& callee = *child(node);
      return make(node, Call{reference(callee), args(*next(callee))});
    }
    case Tag::subscript:
      return subscript(node);
    case Tag::unary:
      return unary(node);
    case Tag::conditional:
      return conditional(node);
    default:
      return chain(node);
  }
}

ExprPtr TreeBuilder::subscript(const Node& node) {
  const Node* at = child(node);
  ExprPtr list = expr(*at);
  std::size_t depth = 0;
  for (at = next(*at); at; at = next(*at)) {
    if (++depth > Trail::max_depth) {
      wrong(span(*at), "more than " + std::to_string(Trail::max_depth) + " indices in a row");
      break;
    }
    Span all{&source_, node.begin, at->end};
    ExprPtr index = expr(*child(*at));
    list = std::make_unique<Expr>(Expr{all, Subscript{std::move(list), std::move(index)}});
  }
  return list;
}

ExprPtr TreeBuilder::unary(const Node& node) {
  Unary unary;
  const Node* at = child(node);
  for (; at->tag == Tag::op; at = next(*at)) {
    unary.operators.push_back(words(*at) == "-" ? Prefix::minus : Prefix::invert);
  }
  unary.operand = expr(*at);
  return make(node, std::move(unary));
}

namespace {

Infix infix(std::string_view sign) {
  struct Row {
    std::string_view sign;
    Infix infix;
  };
  constexpr std::array rows{
      Row{"+", Infix::add},      Row{"-", Infix::subtract}, Row{"*", Infix::multiply},
      Row{"/", Infix::divide},   Row{"<", Infix::less},     Row{"<=", Infix::less_equal},
      Row{">", Infix::greater},  Row{"==", Infix::equal},   Row{">=", Infix::greater_equal},
      Row{"!=", Infix::unequal}, Row{"&&", Infix::and_},    Row{"||", Infix::or_}};
  return std::find_if(rows.begin(), rows.end(), [&](Row r) { return r.sign == sign; })->infix;
}

}  // namespace

ExprPtr TreeBuilder::chain(const Node& node) {
  Chain chain;
  for (const Node* at = child(node); at; at = next(*at)) {
    if (at->tag == Tag::op) {
      chain.operators.push_back(infix(words(*at)));
      chain.operator_spans.push_back(span(*at));
    } else {
      chain.operands.push_back(expr(*at));
    }
  }
  return make(node, std::move(chain));
}

ExprPtr TreeBuilder::conditional(const Node& node) {
  const Node& condition = *child(node);
  const Node& then = *next(condition);
  ExprPtr c = expr(condition), t = expr(then), o = expr(*next(then));
  return make(node, Conditional{std::move(c), std::move(t), std::move(o)});
}

ExprPtr TreeBuilder::number(const Node& node) {
  double value = 0;
  const std::string_view digits = words(node);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    // Too small is nought; too large is nothing that could be built.
    const bool tiny = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
    if (!tiny) wrong(span(node), "the number is too large");
    value = 0;
  }
  return make(node, Number{value});
}

ExprPtr TreeBuilder::text(const Node& node) { return make(node, Text{unescaped(node)}); }

namespace {

char32_t hex(std::string_view digits) {
  uint32_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  return value;
}

bool leads(char32_t c) { return c >= 0xD800 && c < 0xDC00; }
bool trails(char32_t c) { return c >= 0xDC00 && c < 0xE000; }

}  // namespace

// A pair of \u escapes above U+FFFF is one character, as in JSON.
std::string TreeBuilder::unescaped(const Node& node) {
  const std::string_view all = words(node), inner = all.substr(1, all.size() - 2);
  std::string value;
  value.reserve(inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != '\\') {
      value += inner[i];
    } else if (inner[i + 1] != 'u') {
      value += inner[++i];
    } else {
      const auto begin = static_cast<uint32_t>(node.begin + 1 + i);
      char32_t c = hex(inner.substr(i + 2, 4));
      i += 5;
      if (leads(c) && inner.substr(i + 1, 2) == "\\u" && trails(hex(inner.substr(i + 3, 4)))) {
        c = 0x10000 + ((c - 0xD800) << 10) + (hex(inner.substr(i + 3, 4)) - 0xDC00);
        i += 6;
      }
      if (c == 0 || leads(c) || trails(c)) {
        wrong({&source_, begin, begin + 6},
              in_quotes(inner.substr(begin - node.begin - 1, 6)) + " is no character");
      } else {
        encode(c, value);
      }
    }
  }
  return value;
}

Reference TreeBuilder::reference(const Node& node) {
  if (node.tag == Tag::name) return {{}, {name(node)}};
  Reference reference;
  const Node* first = child(node);
  if (node.tag == Tag::reference && first->tag == Tag::qualified) {
    reference = this->reference(*first);
    first = next(*first);
  } else if (node.tag == Tag::qualified) {
    reference.style = name(*first);
    first = next(*first);
  }
  for (const Node* at = first; at; at = next(*at)) reference.names.push_back(name(*at));
  return reference;
}

Size TreeBuilder::size(const Node& node) {
  switch (node.tag) {
    case Tag::dont_care:
      return {SizeKind::dont_care, nullptr, span(node)};
    case Tag::floating:
      return {SizeKind::floating, expr(*child(node)), span(node)};
    case Tag::amount:
      return {words(node).back() == '%' ? SizeKind::percent : SizeKind::relative,
              bare_expr(*child(node)), span(node)};
    default:
      return {SizeKind::absolute, expr(node), span(node)};
  }
}

std::vector<Arg> TreeBuilder::args(const Node& node) {
  std::vector<Arg> args;
  for (const Node* at = child(node); at; at = next(*at)) {
    if (at->tag == Tag::named) {
      const Node& word = *child(*at);
      args.push_back({name(word), size(*next(word)), span(*at)});
    } else {
      args.push_back({{}, size(*at), span(*at)});
    }
  }
  return args;
}

}  // namespace mansard
