#include "grammars/derivation/context_query.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"

namespace citykiln::grammars {
namespace {

constexpr double kOn_m = 0.01;

enum class Side : std::uint8_t { kOutside, kOn, kWithin };

Side side_of_neighbour(const Neighbour& neighbour, Vec3 p) {
  if (p.z < neighbour.bottom_m - kOn_m || p.z > neighbour.top_m + kOn_m) return Side::kOutside;
  double border_m = distance_to_ring(neighbour.outline.outer, in_plan(p));
  for (const Ring& hole : neighbour.outline.holes) border_m = std::min(border_m, distance_to_ring(hole, in_plan(p)));
  if (border_m <= kOn_m) return Side::kOn;
  if (!contains(neighbour.outline, in_plan(p))) return Side::kOutside;
  const bool on_end = std::abs(p.z - neighbour.bottom_m) <= kOn_m || std::abs(p.z - neighbour.top_m) <= kOn_m;
  return on_end ? Side::kOn : Side::kWithin;
}

std::vector<Vec3> points_of(const Shape& shape) {
  std::vector<Vec3> points;
  for (const Face& face : shape.faces) {
    Vec3 sum;
    for (std::size_t i = 0; i < face.outer.size(); ++i) {
      points.push_back(face.outer[i]);
      points.push_back((face.outer[i] + face.outer[(i + 1) % face.outer.size()]) * 0.5);
      sum = sum + face.outer[i];
    }
    points.push_back(sum * (1.0 / static_cast<double>(face.outer.size())));
  }
  return points;
}

struct Tally {
  std::size_t within = 0, on = 0, all = 0;
};

Tally tally_of(const Neighbour& neighbour, const std::vector<Vec3>& points) {
  Tally tally{0, 0, points.size()};
  for (const Vec3 p : points) {
    const Side side = side_of_neighbour(neighbour, p);
    tally.within += side == Side::kWithin;
    tally.on += side == Side::kOn;
  }
  return tally;
}

bool answer(ContextQuery query, const std::vector<Neighbour>& neighbours, const std::vector<Vec3>& points) {
  bool inside = false, overlaps = false, touches = false, within = false;
  for (const Neighbour& neighbour : neighbours) {
    const Tally tally = tally_of(neighbour, points);
    inside |= tally.all > 0 && tally.within + tally.on == tally.all;
    overlaps |= tally.within > 0 && tally.within + tally.on < tally.all;
    touches |= tally.on > 0;
    within |= tally.within > 0;
  }
  if (query == ContextQuery::kHasEntrance || query == ContextQuery::kIsLit) return false;
  if (query == ContextQuery::kInside) return inside;
  if (query == ContextQuery::kOverlaps) return overlaps && !inside;
  return touches && !within && !inside;
}

// The part of a front inside the scope.
std::optional<FrontInShape> part_in(const Scope& scope, const FrontLine& front) {
  constexpr double kOffPlane_m = 0.25, kStrip_m = 0.25, kLeastWidth_m = 1;
  const Vec2 origin = in_plan(scope.origin), x = in_plan(scope.axis[0]), z = in_plan(scope.axis[2]);
  if (std::abs(dot(front.from - origin, z)) > kOffPlane_m || std::abs(dot(front.to - origin, z)) > kOffPlane_m)
    return std::nullopt;
  double start_m = dot(front.from - origin, x), end_m = dot(front.to - origin, x);
  if (start_m < kStrip_m) start_m = 0;
  if (end_m > scope.size_m[0] - kStrip_m) end_m = scope.size_m[0];
  if (end_m - start_m < kLeastWidth_m) return std::nullopt;
  return FrontInShape{start_m, end_m - start_m, front.kind, front.colour, front.is_lit};
}

}  // namespace

AnswerContextQuery answer_from_neighbours(std::vector<Neighbour> neighbours) {
  return [neighbours = std::move(neighbours)](ContextQuery query, const Shape& shape) {
    return answer(query, neighbours, points_of(shape));
  };
}

AnswerContextQuery answer_from_entrances(std::vector<Vec2> places) {
  return [places = std::move(places)](ContextQuery query, const Shape& shape) {
    constexpr double kOutOfPlane_m = 1;
    const Scope& scope = shape.scope;
    const Vec2 origin = in_plan(scope.origin), x = in_plan(scope.axis[0]), z = in_plan(scope.axis[2]);
    return query == ContextQuery::kHasEntrance && std::any_of(places.begin(), places.end(), [&](Vec2 position) {
             const double along_m = dot(position - origin, x);
             return along_m >= 0 && along_m < scope.size_m[0] && std::abs(dot(position - origin, z)) < kOutOfPlane_m;
           });
  };
}

FindFront find_among_fronts(std::vector<FrontLine> fronts) {
  return [fronts = std::move(fronts)](const Shape& shape) {
    std::optional<FrontInShape> first;
    for (const FrontLine& front : fronts) {
      const std::optional<FrontInShape> part = part_in(shape.scope, front);
      if (part && (!first || part->start_m < first->start_m)) first = part;
    }
    return first;
  };
}

}  // namespace citykiln::grammars
