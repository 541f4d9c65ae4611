// Boolean operations on sets of polygons, by GEOS, and the finding of edge tags afterwards. The
// only files that know GEOS are this header's .cpp.
#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.hpp"

namespace mansard {

/// On the grid all points are rounded to 1e-9 m. That takes several times as long, but copes with
/// any number of edges that are equal but for rounding, where GEOS with floating numbers now and
/// then gives wrong pieces without a word.
enum class Precision { floating, grid };

/// Results carry no tags, are oriented, and have no piece thinner than 1e-9 m. Invalid polygons are
/// repaired first. When GEOS fails, nothing is united or intersected and nothing is taken away.
std::vector<Polygon> unite(std::span<const Polygon> pieces, Precision precision);
std::vector<Polygon> intersect(std::span<const Polygon> a, std::span<const Polygon> b,
                               Precision precision);
std::vector<Polygon> subtract(std::span<const Polygon> from, std::span<const Polygon> pieces,
                              Precision precision);

struct TaggedEdge {
  Vec2 from, to;
  EdgeTag tag;
};

std::vector<TaggedEdge> tagged_edges(const Polygon& polygon);

/// Gives every edge the tag of the source that it lies on for the longest stretch, within 1e-7 m;
/// of equals the first. Edges on none get EdgeTag::cut. Points that are the start of a source but
/// for rounding become that. Then drops points in the middle of straight edges whose two sides have
/// the same tag.
void take_tags(std::vector<Polygon>& polygons, std::span<const TaggedEdge> sources);

}  // namespace mansard
