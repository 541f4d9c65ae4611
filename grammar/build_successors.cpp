// What stands to the right of an arrow.
#include "grammar/build.hpp"

namespace mansard {

using namespace syntax;  // NOLINT: this file is about them

Body TreeBuilder::body(const Node& node) {
  Body body;
  for (const Node* at = child(node); at; at = next(*at)) body.push_back(element(*at));
  return body;
}

Element TreeBuilder::element(const Node& node) {
  switch (node.tag) {
    case Tag::push:
      return {span(node), Push{body(*child(node))}};
    case Tag::super_:
      return {span(node), Super{}};
    case Tag::if_:
      return {span(node), if_chain(node)};
    default:
      return {span(node), emit(node)};
  }
}

If TreeBuilder::if_chain(const Node& node) {
  If chain;
  for (const Node* at = child(node); at; at = next(*at)) {
    IfArm arm;
    if (at->tag != Tag::body) {
      arm.condition = expr(*at);
      at = next(*at);
    }
    arm.body = body(*at);
    chain.arms.push_back(std::move(arm));
  }
  return chain;
}

Emit TreeBuilder::emit(const Node& node) {
  Emit emit;
  for (const Node* at = child(node); at; at = next(*at)) {
    switch (at->tag) {
      case Tag::of_style:
        emit.style_of = expr(*child(*at));
        break;
      case Tag::qualified:
        emit.style = name(*child(*at));
        emit.name = name(*next(*child(*at)));
        break;
      case Tag::args:
        emit.args = args(*at);
        emit.args_at = span(*at);
        break;
      case Tag::index:
        emit.index = expr(*child(*at));
        break;
      case Tag::parts:
        emit.parts = parts(*at);
        break;
      default:
        emit.name = name(*at);
    }
  }
  return emit;
}

Parts TreeBuilder::parts(const Node& node) {
  Parts parts;
  parts.at = span(node);
  for (const Node* at = child(node); at; at = next(*at)) {
    if (at->tag == Tag::star) {
      parts.starred = true;
    } else {
      parts.parts.push_back(part(*at));
    }
  }
  return parts;
}

Part TreeBuilder::part(const Node& node) {
  Part part;
  part.at = span(node);
  for (const Node* at = child(node); at; at = next(*at)) {
    if (at->tag == Tag::label) {
      part.label = label(*at);
    } else if (at->tag == Tag::group) {
      for (const Node* inner = child(*at); inner; inner = next(*inner)) {
        part.group.push_back(this->part(*inner));
      }
    } else {
      part.body = body(*at);
    }
  }
  return part;
}

// A label's colon does not belong to its size.
Size TreeBuilder::label(const Node& node) {
  const Node& inner = *child(node);
  if (inner.tag != Tag::word) return size(inner);
  return {SizeKind::absolute, make(inner, Reference{{}, {name(inner)}}), span(inner)};
}

}  // namespace mansard
