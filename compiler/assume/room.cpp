#include "compiler/assume/room.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace citykiln::assume {
namespace {

using LineKind = MappedLine::Kind;

// Shorter pieces of an axis are parts of a bend.
constexpr double kTight_m = 8;
// Walls in bends that leave less leave no room.
constexpr double kLeastInBends_m = 2;

// Shares of a line from its first point to its last one.
struct Part {
  double from = 0, to = 1;
  bool is_empty() const { return from >= to; }
};

// The part of a line on which a linear function with these values at its ends is not negative.
Part part_above(Part part, double at_first, double at_last) {
  if (at_first < 0 && at_last < 0) return {1, 0};
  if (at_first >= 0 && at_last >= 0) return part;
  const double share = at_first / (at_first - at_last);
  return at_first < 0 ? Part{std::max(part.from, share), part.to} : Part{part.from, std::min(part.to, share)};
}

// The part of a line that lies between the perpendiculars in two points of the axis.
Part part_between(const MappedLine& line, Vec2 from, Vec2 from_along, Vec2 to, Vec2 to_along) {
  const Part beyond = part_above({}, dot(line.a - from, from_along), dot(line.b - from, from_along));
  return part_above(beyond, dot(to - line.a, to_along), dot(to - line.b, to_along));
}

// The parts of a line outside of the disks around these places.
std::vector<Part> parts_outside(const MappedLine& line, const std::vector<Vec2>& places, double radius_m) {
  std::vector<Part> parts = {{}};
  const Vec2 d = line.b - line.a;
  for (const Vec2 place : places) {
    const double square = dot(d, d), half = dot(line.a - place, d);
    const double root = half * half - square * (dot(line.a - place, line.a - place) - radius_m * radius_m);
    if (square <= 0 || root <= 0) continue;
    const Part inside{(-half - std::sqrt(root)) / square, (-half + std::sqrt(root)) / square};
    std::vector<Part> outside;
    for (const Part& part : parts)
      for (const Part& rest :
           {Part{part.from, std::min(part.to, inside.from)}, {std::max(part.from, inside.to), part.to}})
        if (!rest.is_empty()) outside.push_back(rest);
    parts = std::move(outside);
  }
  return parts;
}

Part both(const Part& one, const Part& other) { return {std::max(one.from, other.from), std::min(one.to, other.to)}; }

// The range of distances of a part of a line from the axis, to one side.
struct Range {
  double least_m = std::numeric_limits<double>::infinity(), most_m = -std::numeric_limits<double>::infinity();
  void add(double m) { least_m = std::min(least_m, m), most_m = std::max(most_m, m); }
};

// The distance of a point to one side of two pieces of the axis that meet in a corner: the greater one, as the edges of
// a strip meet in a mitre.
struct CornerSide {
  Vec2 corner, out, next_out;
  double before_m(Vec2 p) const { return dot(p - corner, out); }
  double after_m(Vec2 p) const { return dot(p - corner, next_out); }
  double away_m(Vec2 p) const { return std::max(before_m(p), after_m(p)); }
};

Range range_of(const MappedLine& line, const Part& part, const CornerSide& side) {
  Range range;
  if (part.is_empty()) return range;
  const auto at = [&](double share) { return line.a + (line.b - line.a) * share; };
  const Vec2 first = at(part.from), last = at(part.to);
  range.add(side.away_m(first)), range.add(side.away_m(last));
  // where both are equal
  const double before = side.before_m(first) - side.after_m(first), after = side.before_m(last) - side.after_m(last);
  if (before * after < 0) range.add(side.away_m(first + (last - first) * (before / (before - after))));
  return range;
}

// The room that a line leaves beyond the kerb, by its distances from the axis: none if it crosses the kerb, and all if
// it stays within the carriageway.
double room_before(const Range& range, double kerb_m, double half_m) {
  if (range.most_m + half_m <= kerb_m) return std::numeric_limits<double>::infinity();
  return std::max(0.0, range.least_m - half_m - kerb_m);
}

// True if the border of an area lies between axis and kerb, at least at one place, and the area beyond it. Rings have
// their area on the left.
bool covers_kerb(const MappedLine& line, const Range& range, Vec2 out, double kerb_m) {
  const bool is_area = line.kind == LineKind::kWater || line.kind == LineKind::kSquare;
  return is_area && range.most_m > 0 && range.most_m <= kerb_m && cross(line.b - line.a, out) > 0;
}

bool limits_strips(const MappedLine& line) { return line.kind != LineKind::kWall && line.kind != LineKind::kCarPark; }

bool limits_over_footways(const MappedLine& line) {
  return limits_strips(line) && (line.kind != LineKind::kPath || !may_lie_on_pavement(*line.way));
}

bool runs_beside(const MappedLine& line, Vec2 along) {
  return line.kind != LineKind::kPath || std::abs(dot(unit(line.b - line.a), along)) > kAlong;
}

bool has_vertex(const map::Track& way, Vec2 p) { return std::ranges::find(way.axis, p) != way.axis.end(); }

// True if a way has a place, or begins or ends near it on a way that has it: streets are cut near junctions.
bool meets_at(const Surroundings& surroundings, const map::Track& way, Vec2 place) {
  if (has_vertex(way, place)) return true;
  for (const Vec2 end : {way.axis.front(), way.axis.back()}) {
    if (distance(end, place) >= kJunctionReach_m) continue;
    for (const std::uint32_t n : boxes_about(surroundings.line_grid, place)) {
      const map::Track* between = surroundings.lines[n].way;
      if (between != nullptr && has_vertex(*between, place) && has_vertex(*between, end)) return true;
    }
  }
  return false;
}

// A stretch with the places where other ways meet it.
struct Measured {
  const Surroundings& surroundings;
  const map::Track& stretch;
  double least_before_walls_m = kLeastBeforeWalls_m;
  std::map<const map::Track*, std::vector<Vec2>> meeting = {};  // only looked up
  Room room = {};

  const std::vector<Vec2>& places_of(const map::Track* way) {
    const auto [found, is_new] = meeting.try_emplace(way);
    if (is_new && way != nullptr)
      for (const Vec2 p : stretch.axis)
        if (meets_at(surroundings, *way, p)) found->second.push_back(p);
    return found->second;
  }

  // @param is_tight  True in bends, where roads are not narrowed before each wall.
  void limit(const MappedLine& line, const Part& within, const CornerSide& side, bool is_tight, double kerb_m,
             double& room_m) {
    if (within.is_empty()) return;
    for (const Part& part : parts_outside(line, places_of(line.way), std::max(0.0, kJunctionReach_m - line.half_m))) {
      const Range range = range_of(line, both(within, part), side);
      const double left_m = room_before(range, kerb_m, line.half_m);
      if (covers_kerb(line, range, side.out, kerb_m)) room_m = 0;
      const bool is_wall = line.kind == LineKind::kBuilding;
      if (is_wall && left_m < (is_tight ? kLeastInBends_m : least_before_walls_m)) room_m = 0;
      if (!is_wall || is_tight) room_m = std::min(room_m, left_m);
    }
  }

  void limit_both(const MappedLine& line, const Part& within, Vec2 corner, Vec2 left, Vec2 next_left, bool is_tight) {
    limit(line, within, {corner, left, next_left}, is_tight, left_kerb_m(stretch.section), room.left_m);
    limit(line, within, {corner, left * -1.0, next_left * -1.0}, is_tight, right_kerb_m(stretch.section), room.right_m);
  }
};

// The wedge at a bend, on its outer side.
void limit_at_bend(Measured& measured, const MappedLine& line, Vec2 before, Vec2 corner, Vec2 after) {
  const Vec2 in = unit(corner - before), out = unit(after - corner);
  if (!runs_beside(line, in) && !runs_beside(line, out)) return;
  const Part within = part_between(line, corner, in, corner, out);
  const map::CrossSection& section = measured.stretch.section;
  const double turn = cross(in, out);
  const CornerSide side{corner, left_of(in), left_of(out)};
  const CornerSide right{corner, left_of(in) * -1.0, left_of(out) * -1.0};
  if (turn < 0) measured.limit(line, within, side, false, left_kerb_m(section), measured.room.left_m);
  if (turn > 0) measured.limit(line, within, right, false, right_kerb_m(section), measured.room.right_m);
}

// Lines farther away are found or not, by the widest road of the map.
double capped(double room_m) { return room_m < kWidestStrip_m ? room_m : std::numeric_limits<double>::infinity(); }

Room room_before(const Surroundings& surroundings, const map::Track& stretch, bool (*limits)(const MappedLine&),
                 double least_before_walls_m) {
  Measured measured{surroundings, stretch, least_before_walls_m};
  const Polyline& axis = stretch.axis;
  const double reach_m = std::max(left_kerb_m(stretch.section), right_kerb_m(stretch.section)) + kWidestStrip_m +
                         surroundings.widest_half_m;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const Vec2 along = unit(axis[i + 1] - axis[i]), left = left_of(along);
    for (const std::uint32_t n :
         boxes_about(surroundings.line_grid, box_of_segment(axis[i], axis[i + 1]).widened(reach_m))) {
      const MappedLine& line = surroundings.lines[n];
      if (!limits(line) || line.element.osm == stretch.id.osm) continue;
      if (i + 2 < axis.size()) limit_at_bend(measured, line, axis[i], axis[i + 1], axis[i + 2]);
      if (!runs_beside(line, along)) continue;
      // a wide line reaches beyond its axis, and over the ends of the stretch
      const Vec2 before = i == 0 ? along * line.half_m : Vec2{},
                 after = i + 2 == axis.size() ? along * line.half_m : Vec2{};
      const Part within = part_between(line, axis[i] - before, along, axis[i + 1] + after, along);
      measured.limit_both(line, within, axis[i], left, left, distance(axis[i], axis[i + 1]) < kTight_m);
    }
  }
  return {capped(measured.room.left_m), capped(measured.room.right_m)};
}

}  // namespace

Room room_beside(const Surroundings& surroundings, const map::Track& stretch) {
  return room_before(surroundings, stretch, limits_strips, kLeastBeforeWalls_m);
}

Room room_over_footways(const Surroundings& surroundings, const map::Track& stretch) {
  return room_before(surroundings, stretch, limits_over_footways, kLeastBeforeRows_m);
}

bool may_lie_on_pavement(const map::Track& way) {
  return is_footway(way) || way.surface == map::LandCoverClass::kCyclePath;
}

bool is_footway(const map::Track& way) {
  return way.surface == map::LandCoverClass::kPavedFootPath ||
         (way.surface == map::LandCoverClass::kFootPath && !way.has_tagged_surface);
}

}  // namespace citykiln::assume
