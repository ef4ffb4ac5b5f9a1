// Queries about the surroundings of a shape, for the functions inside(), overlaps(), touches(), has_entrance() and
// is_lit(), and the front_…() functions.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// The function that a rule calls: inside(), overlaps(), touches(), has_entrance() or is_lit().
enum class ContextQuery : std::uint8_t { kInside, kOverlaps, kTouches, kHasEntrance, kIsLit };

/// A function that answers a query during a derivation. Must be a pure function.
using AnswerContextQuery = std::function<bool(ContextQuery, const Shape&)>;

/// The part of a shop front in a shape.
struct FrontInShape {
  double start_m = 0, width_m = 0;  ///< Along the scope's x axis.
  std::string kind;                 ///< Its kind, such as "cafe".
  std::string colour;               ///< The colour of its fascia, "#rrggbb".
  bool is_lit = false;              ///< Lamps are on behind it.
};
/// A function that returns the first front of a shape along the scope's x axis. Must be a pure function.
using FindFront = std::function<std::optional<FrontInShape>(const Shape&)>;

/// A shop front as a line in plan.
struct FrontLine {
  Vec2 from, to;  ///< Plane metres; from left to right as seen from outside.
  std::string kind, colour;
  bool is_lit = false;
};

/// A neighbouring building as a prism.
struct Neighbour {
  Polygon outline;  ///< Plane metres.
  double bottom_m = 0, top_m = 0;
};

/// Returns a function that compares prisms with the vertices of a shape and the midpoints of its edges and faces.
/// kInside: all these points are in or on one prism. kOverlaps: some but not all points are inside a prism. kTouches:
/// some points are on the surface of a prism and no point is inside a prism. "On" means within 1 cm, the accuracy at
/// which outlines of neighbours agree. O(points of the shape · points of the outlines).
AnswerContextQuery answer_from_neighbours(std::vector<Neighbour> neighbours);

/// Returns a function that answers kHasEntrance: true if one of the positions is between the start (inclusive) and the
/// end (exclusive) of the scope's x axis and within 1 m of its xy plane. Exactly one of adjacent pieces has the
/// entrance.
AnswerContextQuery answer_from_entrances(std::vector<Vec2> positions);

/// Returns a function that finds fronts whose ends lie within 0.25 m of the scope's xy plane. A front that the scope
/// cuts counts with the part inside, if that is at least 1 m wide; an end less than 0.25 m from the scope's is moved
/// there.
FindFront find_among_fronts(std::vector<FrontLine> fronts);

}  // namespace citykiln::grammars
