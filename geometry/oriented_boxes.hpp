// Whether two boxes that stand at any angle to each other come into contact.
#pragma once

#include "geometry/scope.hpp"

namespace mansard {

/// Whether the boxes of two scopes overlap, touch, or lie within `by` metres of each other along
/// each of the directions that could part them (Gottschalk et al. 1996): the same however both are
/// turned.
bool meet(const Scope& a, const Scope& b, double by);

}  // namespace mansard
