#include "compiler/assume/frontages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compiler/assume/cut_way.h"
#include "compiler/assume/footway_strips.h"
#include "compiler/assume/pavements.h"
#include "compiler/assume/side_rays.h"
#include "compiler/geometry/segment.h"

namespace citykiln::assume {
namespace {

using map::LandCoverClass;
using map::Lane;
using map::LaneKind;
using map::Track;

constexpr double kInfinite_m = std::numeric_limits<double>::infinity();
// Widths are multiples of this, so that tags can state them.
constexpr double kStripStep_m = 0.25;
// Cross streets open up to a quarter of a short block.
constexpr double kLeastClosed = 0.4, kMostOpen = 0.4;
// Houses are open where fewer samples are closed, and fewer see a town house behind a broad pavement.
constexpr double kOpenHouses = 0.25, kOfTown = 0.4;
// A fifth of the walls may stand farther back: before them a front yard is paved (lots/yard_rules.h).
constexpr double kWallQuantile = 0.8;

// The distance from the kerb along a ray to a line; nothing if they do not meet.
std::optional<double> beyond_kerb_m(const SideRay& ray, const MappedLine& line) {
  const double most_m = ray.kerb_m + kOpenFrontage_m;
  const auto shares = crossing_shares(ray.at, ray.at + ray.out * most_m, line.a, line.b);
  if (!shares) return std::nullopt;
  return std::max(0.0, shares->first * most_m - ray.kerb_m - line.half_m);
}

bool is_before_walls(const SideRay& ray, const MappedLine& line) {
  if (line.kind == MappedLine::Kind::kCarPark) return true;
  return line.kind == MappedLine::Kind::kWall && std::abs(dot(unit(line.b - line.a), ray.along)) > kAlong;
}

// The walls that samples of one side see.
struct FrontSide {
  std::vector<double> walls_m;  // of the closed ones
  std::size_t samples = 0, open = 0, town = 0;

  void look(const Surroundings& surroundings, std::span<const std::uint32_t> near, const SideRay& ray) {
    double wall_m = kInfinite_m, before_m = kInfinite_m;
    bool is_of_town = false;
    for (const std::uint32_t n : near) {
      const MappedLine& line = surroundings.lines[n];
      const bool is_wall = line.kind == MappedLine::Kind::kBuilding;
      if (!is_wall && !is_before_walls(ray, line)) continue;
      const auto away_m = beyond_kerb_m(ray, line);
      if (away_m && is_wall && *away_m < wall_m) wall_m = *away_m, is_of_town = line.is_town_house;
      if (away_m && !is_wall) before_m = std::min(before_m, *away_m);
    }
    ++samples, open += wall_m == kInfinite_m, town += is_of_town;
    const bool is_near = wall_m <= (is_of_town ? kFrontage_m : kNoGarden_m);
    if (is_near && wall_m <= before_m) walls_m.push_back(wall_m);
  }
};

Frontage frontage_of(FrontSide side) {
  if (side.samples == 0) return {.open = 1};
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(side.samples); };
  Frontage frontage{.closed = share(side.walls_m.size()), .open = share(side.open), .town = share(side.town)};
  if (side.walls_m.empty()) return frontage;
  const auto last = static_cast<double>(side.walls_m.size() - 1);
  const auto upper = side.walls_m.begin() + static_cast<std::ptrdiff_t>(kWallQuantile * last);
  std::ranges::nth_element(side.walls_m, upper);
  frontage.wall_m = *upper;
  return frontage;
}

// True for areas that are mapped more finely than land use, which nothing assumed covers.
bool is_fine(const MappedLand& land) {
  return land.is_square || land.land == LandUse::kGreen || land.land == LandUse::kWood ||
         land.land == LandUse::kFarmland || land.land == LandUse::kWater || land.land == LandUse::kParking;
}

// The least distance from the axis of what an edge has beside a straight piece of the axis, beyond half the distance to
// the kerb.
double edge_beside_m(Vec2 a, Vec2 b, Vec2 from, Vec2 along, double length_m, Vec2 out, double kerb_m) {
  const Vec2 p{dot(a - from, along), dot(a - from, out)}, q{dot(b - from, along), dot(b - from, out)};
  const double low = std::max(0.0, std::min(p.x, q.x)), high = std::min(length_m, std::max(p.x, q.x));
  if (low > high) return kInfinite_m;
  const auto y_at = [&](double x) {
    return p.x == q.x ? std::min(p.y, q.y) : p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x));
  };
  const double least_m = std::min(y_at(low), y_at(high)), most_m = std::max(y_at(low), y_at(high));
  return most_m < kerb_m / 2 ? kInfinite_m : std::max(least_m, 0.0);
}

// The room beyond the kerb before finely mapped areas on a side.
double room_before_areas(const Surroundings& surroundings, const Track& stretch, bool is_left, double most_m) {
  const double kerb_m = is_left ? left_kerb_m(stretch.section) : right_kerb_m(stretch.section);
  double least_m = kInfinite_m;
  for (std::size_t i = 0; i + 1 < stretch.axis.size(); ++i) {
    const Vec2 a = stretch.axis[i], b = stretch.axis[i + 1], along = unit(b - a);
    const Vec2 out = is_left ? left_of(along) : left_of(along) * -1.0;
    const Box2 box = box_of_segment(a, b).widened(kerb_m + most_m);
    for (const std::uint32_t n : boxes_about(surroundings.area_grid, box)) {
      if (!is_fine(surroundings.areas[n])) continue;
      const Ring& ring = surroundings.areas[n].area->polygon.outer;
      for (std::size_t e = 0; e < ring.size(); ++e)
        least_m = std::min(least_m,
                           edge_beside_m(ring[e], ring[(e + 1) % ring.size()], a, along, distance(a, b), out, kerb_m));
    }
  }
  return std::max(0.0, least_m - kerb_m);
}

double in_steps(double width_m) { return std::floor(width_m / kStripStep_m) * kStripStep_m; }

bool may_be_fronted(const Track& track) {
  return track.passage == map::Passage::kGround && !track.is_rail && !track.is_indoor && !track.is_through_building &&
         !track.is_transition && !track.is_roundabout && track.section.axis_drift == 0;
}

bool may_have_pavements(const Track& track) {
  return may_be_fronted(track) && !track.is_link && has_usual_pavements(track.surface, track.country);
}

bool may_have_wide_pavement(const Track& track) {
  return may_have_pavements(track) && track.fixed_pavements != map::kBothSides;
}

// True for ways without kerbs that may become wider: nothing but one kind of lane, of a width that no tag states.
bool may_be_wide_lane(const Track& track) {
  const bool is_lane =
      track.surface == LandCoverClass::kPedestrianStreet || track.surface == LandCoverClass::kPavedFootPath ||
      track.surface == LandCoverClass::kServiceRoad ||
      (track.surface == LandCoverClass::kResidentialRoad && !has_usual_pavements(track.surface, track.country));
  return is_lane && may_be_fronted(track) && !track.has_tagged_width && !track.has_tagged_placement &&
         std::ranges::none_of(track.section.lanes, [](const Lane& lane) {
           return lane.is_raised || is_soft(lane.kind) || lane.kind == LaneKind::kCycle;
         });
}

// The walls of a stretch, and the room before everything else that is mapped; measured where both are needed.
struct FrontedStretch {
  const Surroundings& surroundings;
  const Track& stretch;
  BothFrontages fronts = frontages_beside(surroundings, stretch);
  std::optional<Room> room = {};

  const Frontage& front(std::uint8_t side) const { return side == map::kLeftSide ? fronts.left : fronts.right; }

  // The room beyond the kerb before other ways and finely mapped areas, at most kFrontage_m.
  double room_m(std::uint8_t side) {
    const bool is_left = side == map::kLeftSide;
    if (!room) room = room_over_footways(surroundings, stretch);
    const double width_m = std::min(is_left ? room->left_m : room->right_m, kFrontage_m);
    if (width_m < kStripStep_m) return 0;
    return std::min(width_m, room_before_areas(surroundings, stretch, is_left, kFrontage_m));
  }

  // The width of a strip from the kerb to the walls of a side; 0 unless it is closed.
  double strip_m(std::uint8_t side) {
    return is_closed(front(side)) ? in_steps(std::min(front(side).wall_m, room_m(side))) : 0;
  }
};

// The raised lanes of a side, from the outermost one to the kerb.
std::vector<Lane> raised_lanes(const map::CrossSection& section, std::uint8_t side) {
  std::vector<Lane> lanes = section.lanes;
  if (side == map::kRightSide) std::ranges::reverse(lanes);
  lanes.erase(std::ranges::find(lanes, false, &Lane::is_raised), lanes.end());
  return lanes;
}

map::CrossSection with_raised_lanes(map::CrossSection section, std::uint8_t side, std::vector<Lane> raised) {
  std::vector<Lane>& lanes = section.lanes;
  if (side == map::kRightSide) std::ranges::reverse(lanes);
  lanes.erase(lanes.begin(), std::ranges::find(lanes, false, &Lane::is_raised));
  lanes.insert(lanes.begin(), raised.begin(), raised.end());
  if (side == map::kRightSide) std::ranges::reverse(lanes);
  return section;
}

bool is_pavement_lane(const Lane& lane) { return lane.kind == LaneKind::kSidewalk; }

// True if a tagged verge or a cycle track lies outside of the pavement, which then cannot reach a wall.
bool is_pavement_inside(const std::vector<Lane>& raised) {
  return std::ranges::any_of(raised, is_pavement_lane) && !is_pavement_lane(raised.front());
}

// Makes the pavement of a side reach from the kerb to a distance; false if nothing changes.
bool widen_pavement(Track& track, std::uint8_t side, double width_m) {
  std::vector<Lane> raised = raised_lanes(track.section, side);
  if ((track.tagged_verges & side) == 0)
    std::erase_if(raised, [](const Lane& lane) { return lane.kind == LaneKind::kVerge; });
  if (is_pavement_inside(raised)) return false;
  double others_m = 0;
  const bool has_pavement = !raised.empty() && is_pavement_lane(raised.front());
  for (std::size_t i = has_pavement ? 1 : 0; i < raised.size(); ++i) others_m += raised[i].width_m;
  const double own_m = width_m - others_m;
  if (own_m < kNarrowestPavement_m || (has_pavement && own_m <= raised.front().width_m)) return false;
  if (!has_pavement) raised.insert(raised.begin(), Lane{});
  raised.front() = map::pavement_lane(own_m);
  track.section = with_raised_lanes(std::move(track.section), side, std::move(raised));
  track.assumed_sides |= side;
  return true;
}

// Widens the outermost lane of a side.
void widen_lane(Track& track, std::uint8_t side, double by_m) {
  const bool is_left = side == map::kLeftSide;
  (is_left ? track.section.lanes.front() : track.section.lanes.back()).width_m += by_m;
  if (is_left) track.section.axis_offset_m += by_m;
  track.closed_sides |= side;
}

// Lays the strip between the kerb and a footway beside it: a pavement that covers the footway, or a verge.
bool lay_footway_strip(Track& stretch, std::uint8_t side, const FootwayStrip& strip, bool is_verge, double room_m) {
  if (!is_verge) return widen_pavement(stretch, side, in_steps(std::min(strip.far_m, room_m)));
  const double width_m = in_steps(std::min(strip.near_m, room_m));
  if (width_m < kStripStep_m || (stretch.tagged_verges & side) != 0 || !raised_lanes(stretch.section, side).empty())
    return false;
  stretch.section = with_verge(std::move(stretch.section), side, width_m);
  stretch.assumed_sides |= side;
  return true;
}

// Marks the sides of closed frontages that have a pavement, of whatever width.
void mark_closed_sides(const BothFrontages& fronts, Track& stretch) {
  for (const std::uint8_t side : {map::kLeftSide, map::kRightSide})
    if (is_closed(side == map::kLeftSide ? fronts.left : fronts.right) &&
        std::ranges::any_of(raised_lanes(stretch.section, side), is_pavement_lane))
      stretch.closed_sides |= side;
}

bool pave_beside_street(const Surroundings& surroundings, Track& stretch) {
  const Track mapped = stretch;
  FrontedStretch fronted{surroundings, mapped};
  std::optional<BothFootwayStrips> strips;
  bool is_any = false;
  for (const std::uint8_t side : {map::kLeftSide, map::kRightSide}) {
    if ((stretch.fixed_pavements & side) != 0) continue;
    if (widen_pavement(stretch, side, fronted.strip_m(side))) {
      is_any = true;
      continue;
    }
    if (!strips) strips = footway_strips(surroundings, mapped);
    const FootwayStrip& strip = side == map::kLeftSide ? strips->left : strips->right;
    const Frontage& front = fronted.front(side);
    const bool is_verge = strip.may_be_verge && front.closed < kOpenHouses && front.town < kOfTown;
    if (strip.far_m > 0) is_any |= lay_footway_strip(stretch, side, strip, is_verge, fronted.room_m(side));
  }
  mark_closed_sides(fronted.fronts, stretch);
  return is_any;
}

// Pedestrian streets reach the walls however far these are, other ways without kerbs only near walls on both sides.
bool pave_between_walls(const Surroundings& surroundings, Track& stretch) {
  FrontedStretch fronted{surroundings, stretch};
  const double most_m = stretch.surface == LandCoverClass::kPedestrianStreet ? kFrontage_m : kBesideLane_m;
  const auto is_near = [&](const Frontage& front) { return is_closed(front) && front.wall_m <= most_m; };
  if (!is_near(fronted.fronts.left) || !is_near(fronted.fronts.right)) return false;
  const double left_m = fronted.strip_m(map::kLeftSide), right_m = fronted.strip_m(map::kRightSide);
  if (left_m > 0) widen_lane(stretch, map::kLeftSide, left_m);
  if (right_m > 0) widen_lane(stretch, map::kRightSide, right_m);
  return left_m > 0 || right_m > 0;
}

}  // namespace

bool is_closed(const Frontage& frontage) { return frontage.closed >= kLeastClosed && frontage.open <= kMostOpen; }

BothFrontages frontages_beside(const Surroundings& surroundings, const Track& stretch) {
  FrontSide left, right;
  const double about_m = farther_kerb_m(stretch.section) + kOpenFrontage_m;
  for_each_side_ray(surroundings, stretch, about_m, [&](const SideRay& ray, std::span<const std::uint32_t> near) {
    (ray.is_left ? left : right).look(surroundings, near, ray);
  });
  return {frontage_of(std::move(left)), frontage_of(std::move(right))};
}

std::vector<Track> assume_frontages(const map::FeatureView& features, std::span<const Track> mapped, Report& report) {
  const Surroundings surroundings = index_surroundings(features, mapped);
  const CommonNodes common = common_nodes_of(features.tracks);
  const auto cut = [&](const Track& track) {
    const bool is_walked = track.surface == LandCoverClass::kPedestrianStreet && may_be_wide_lane(track);
    const bool may_be_cut = (may_have_wide_pavement(track) || is_walked) && !track.is_piece;
    return may_be_cut ? cut_way(track, kLongestWhole_m, kStretch_m, common) : std::vector{track};
  };
  const auto change = [&](Track& stretch) {
    if (length_m(stretch.axis) > kLongestWhole_m) return false;
    if (may_have_wide_pavement(stretch)) return pave_beside_street(surroundings, stretch);
    if (may_have_pavements(stretch)) return mark_closed_sides(frontages_beside(surroundings, stretch), stretch), false;
    return may_be_wide_lane(stretch) && pave_between_walls(surroundings, stretch);
  };
  return with_changed_stretches(features.tracks, Assumption::kPavements, "frontage_track", cut, change, report);
}

}  // namespace citykiln::assume
