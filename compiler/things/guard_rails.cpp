#include "compiler/things/guard_rails.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::things {
namespace {

constexpr double kGuardStep_m = 4, kGuardOff_m = 0.5, kGuardBucket_m = 64;
// The room beside the carriageways of other roads, whose corners are wider than they are: more than half a step.
constexpr double kOffRoad_m = 3;
constexpr double kGuardHeight_m = 0.75, kGuardThickness_m = 0.25;
// Roads this near to buildings are those of towns.
constexpr double kOffTown_m = 25;
// The terrain before grading falls at least this much where a drop is.
constexpr double kLeastFall = 0.15;
constexpr std::uint32_t kFirstGuard = 1u << 15;

// A segment beside which no guard rail stands.
struct GuardObstacle {
  Vec2 a, b;
  double radius_m = 0;
  OsmId way{};
  double own_m = 0;  // the radius for rails of the way itself, which stand kGuardOff_m beside its carriageway
};

struct GuardObstacles {
  std::vector<GuardObstacle> all;
  BoxGrid grid;

  void add(std::span<const Vec2> line, double radius_m, OsmId way = {}, double own_m = 0) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) all.push_back({line[i], line[i + 1], radius_m, way, own_m});
  }
};

GuardObstacles guard_obstacles(const map::FeatureView& features, std::span<const roads::Road> roads) {
  GuardObstacles found;
  for (const map::Barrier& barrier : features.barriers)
    if (barrier.kind != map::BarrierKind::kKerb) found.add(barrier.axis, 3);
  for (const map::Footprint& footprint : features.footprints) {
    if (footprint.polygon.outer.empty()) continue;
    Ring ring = footprint.polygon.outer;
    ring.push_back(ring.front());
    found.add(ring, kOffTown_m);
  }
  for (const roads::Road& road : roads)
    found.add(road.axis, roads::max_offset_m(road) + kOffRoad_m, road.id.osm,
              std::min(roads::left_m(road), roads::right_m(road)) + kGuardOff_m / 2);
  std::vector<Box2> boxes;
  for (const GuardObstacle& o : found.all) boxes.push_back(box_of_segment(o.a, o.b).widened(o.radius_m));
  if (!boxes.empty()) found.grid = grid_of(boxes, kGuardBucket_m);
  return found;
}

bool is_guarded(const roads::Road& road) {
  const bool has_pavement = std::ranges::any_of(road.section.lanes, &map::Lane::is_raised);
  return map::is_street(road.surface) && road.surface != map::LandCoverClass::kPedestrianStreet && !has_pavement;
}

class GuardPlanner {
 public:
  GuardPlanner(const map::FeatureView& features, std::span<const roads::Road> roads,
               const ground::GradedTerrain& ground)
      : extent_(features.extent.widened(-kGuardWithin_m)),
        ground_(ground),
        obstacles_(guard_obstacles(features, roads)) {}

  std::vector<props::Barrier> rails_of(const roads::Road& road) const {
    std::vector<props::Barrier> rails;
    for (const double side : {1.0, -1.0}) add_side(road, side, rails);
    return rails;
  }

 private:
  bool is_drop(Vec2 edge, Vec2 out, OsmId own) const {
    const Vec2 beyond = edge + out * kGuardWithin_m;
    if (!extent_.contains(edge) || !extent_.contains(beyond)) return false;
    const Vec3 normal = map::normal_at(ground_.terrain, beyond);
    if (length(in_plan(normal)) < kLeastFall * normal.z || is_barred(edge, own)) return false;
    return land_m(ground_, edge) - land_m(ground_, beyond) >= kGuardedFall_m;
  }

  bool is_barred(Vec2 edge, OsmId own) const {
    return any_about(obstacles_.grid, Box2{edge, edge}, [&](std::uint32_t i) {
      const GuardObstacle& o = obstacles_.all[i];
      return distance_to_segment(o.a, o.b, edge) < (o.way == own ? o.own_m : o.radius_m);
    });
  }

  void add_side(const roads::Road& road, double side, std::vector<props::Barrier>& rails) const {
    const double off_m = (side > 0 ? roads::left_m(road) : roads::right_m(road)) + kGuardOff_m;
    Polyline run;
    const auto finish = [&] {
      if (run.size() >= 2 && length_m(run) >= kShortestGuard_m)
        rails.push_back({.id = roadside_id(road.id, kFirstGuard + static_cast<std::uint32_t>(rails.size())),
                         .axis = run,
                         .kind = map::BarrierKind::kGuardRail,
                         .height_m = kGuardHeight_m,
                         .width_m = kGuardThickness_m});
      run.clear();
    };
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      const Vec2 from = road.axis[i], to = road.axis[i + 1], out = left_of(unit(to - from)) * side;
      const int steps = 1 + static_cast<int>(distance(from, to) / kGuardStep_m);
      for (int k = 0; k <= steps; ++k) {
        const Vec2 edge = from + (to - from) * (static_cast<double>(k) / steps) + out * off_m;
        is_drop(edge, out, road.id.osm) ? add_guard_point(run, edge) : finish();
      }
    }
    finish();
  }

  // Points on the line between their neighbours are left out.
  static void add_guard_point(Polyline& run, Vec2 at) {
    const Vec2 p = snapped_to(map::kMapStep_m, at);
    if (!run.empty() && distance(run.back(), p) < 1) return;
    if (run.size() > 1 && distance_to_segment(run[run.size() - 2], p, run.back()) < 0.05) run.pop_back();
    run.push_back(p);
  }

  Box2 extent_;
  const ground::GradedTerrain& ground_;
  GuardObstacles obstacles_;
};

}  // namespace

std::vector<props::Barrier> assumed_guard_rails(const map::FeatureView& features, std::span<const roads::Road> roads,
                                                const ground::GradedTerrain& ground, Report& report) {
  const GuardPlanner planner(features, roads, ground);
  std::vector<props::Barrier> rails;
  for (const roads::Road& road : roads) {
    if (!is_guarded(road) || road.axis.size() < 2) continue;
    const std::vector<props::Barrier> own = planner.rails_of(road);
    if (own.empty()) continue;
    report.count_assumed(Assumption::kRoadsides, road.id.osm);
    rails.insert(rails.end(), own.begin(), own.end());
  }
  std::ranges::sort(rails, {}, [](const props::Barrier& b) { return std::tie(b.id, b.axis); });
  return rails;
}

}  // namespace citykiln::things
