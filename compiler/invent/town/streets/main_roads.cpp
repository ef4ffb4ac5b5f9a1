#include "compiler/invent/town/streets/main_roads.h"

#include <algorithm>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/trig.h"
#include "compiler/invent/town/draws.h"
#include "compiler/invent/town/least_cost_path.h"
#include "compiler/invent/town/streets/road_curve.h"

namespace citykiln::invent {
namespace {

/// Roads that come nearer to each other than this are joined.
constexpr double kJoinRoads_m = 42;
/// The distance between vertices of main roads.
constexpr double kRoadStep_m = 13;

class MainRoads {
 public:
  explicit MainRoads(const TownPlan& plan) : plan_(plan), graph_(plan.settings.side_m), costs_(road_costs(plan)) {}

  StreetGraph build() {
    add_exits();
    for (std::size_t i = 1; i < plan_.centres.size(); ++i) join_centre(i);
    return std::move(graph_);
  }

 private:
  int exit_count() const {
    Draws draws(plan_.settings.seed, "exits", 0);
    switch (plan_.settings.kind) {
      case TownKind::kVillage:
        return 3 + static_cast<int>(draws.below(2));
      case TownKind::kTown:
        return 4 + static_cast<int>(draws.below(3));
      default:
        return 6 + static_cast<int>(draws.below(3));
    }
  }

  StreetClass exit_class(int exit) const {
    if (plan_.settings.kind == TownKind::kVillage) return exit < 2 ? StreetClass::kSecondary : StreetClass::kTertiary;
    if (plan_.settings.kind == TownKind::kTown) return exit < 2 ? StreetClass::kPrimary : StreetClass::kSecondary;
    return StreetClass::kPrimary;
  }

  // where a ray from the main centre leaves the square; dry if the border is dry near it
  Vec2 exit_place(double turns) const {
    Vec2 place;
    for (int i = 0; i < 9; ++i) {
      const double turned = turns + ((i + 1) / 2) * (i % 2 ? 0.012 : -0.012);
      place = border_place(plan_.centres[0].position, direction_of(turned));
      if (plan_.water.at(place) > 40) break;
    }
    return place;
  }

  Vec2 border_place(Vec2 from, Vec2 direction) const {
    const double half = plan_.half_m();
    const double x = direction.x > 0 ? half - from.x : half + from.x,
                 y = direction.y > 0 ? half - from.y : half + from.y;
    const double by_x = std::abs(direction.x) > 1e-9 ? x / std::abs(direction.x) : 1e12;
    const double by_y = std::abs(direction.y) > 1e-9 ? y / std::abs(direction.y) : 1e12;
    const Vec2 p = from + direction * std::min(by_x, by_y);
    return {std::clamp(p.x, -half, half), std::clamp(p.y, -half, half)};
  }

  void add_exits() {
    const int count = exit_count();
    Draws draws(plan_.settings.seed, "exit", 0);
    const double first = draws.unit();
    // opposite exits first: they make a road through the town
    std::vector<int> order;
    for (int i = 0; i < count; ++i)
      if (std::ranges::find(order, i) == order.end()) {
        order.push_back(i);
        const int opposite = (i + count / 2) % count;
        if (std::ranges::find(order, opposite) == order.end()) order.push_back(opposite);
      }
    for (int i = 0; i < count; ++i) {
      const double turns = first + (order[static_cast<std::size_t>(i)] + draws.between(-0.22, 0.22)) / count;
      add_road(exit_place(turns), plan_.centres[0].position, exit_class(i));
    }
  }

  // joins a centre to its nearest ones such that no other centre is nearer to both (a relative neighbourhood graph)
  void join_centre(std::size_t i) {
    const StreetClass kind = plan_.settings.kind == TownKind::kCity ? StreetClass::kSecondary : StreetClass::kTertiary;
    const Vec2 p = plan_.centres[i].position;
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 q = plan_.centres[j].position;
      const double apart_m = distance(p, q);
      if (apart_m > 4500) continue;
      const bool is_neighbour = std::ranges::none_of(plan_.centres, [&](const Centre& c) {
        return c.position != p && c.position != q && distance(c.position, p) < apart_m &&
               distance(c.position, q) < apart_m;
      });
      if (is_neighbour || joined_[i] == 0) {
        add_road(p, q, kind);
        joined_[i] = 1;
      }
    }
  }

  void add_road(Vec2 from, Vec2 to, StreetClass street_class) {
    graph_.streets.push_back({street_class});
    const auto street = static_cast<std::uint32_t>(graph_.streets.size() - 1);
    Polyline path = least_cost_path(costs_, from, to);
    if (path.size() < 2) return;
    path.front() = from;
    path.back() = to;
    for (const Polyline& run : new_runs(path)) lay_run(run, street);
  }

  // the nearest place on the roads that are there; nothing if it is farther than kJoinRoads_m
  std::optional<StreetHit> road_near(Vec2 p) const {
    std::optional<StreetHit> nearest;
    double least_m = kJoinRoads_m;
    Box2 box;
    box.grow(p);
    for (const std::uint32_t s : graph_.near(box.widened(kJoinRoads_m))) {
      const StreetSegment& segment = graph_.segments()[s];
      if (segment.is_bridge) continue;
      const Vec2 foot = nearest_point(graph_.position(segment.a), graph_.position(segment.b), p);
      if (distance(foot, p) < least_m) {
        least_m = distance(foot, p);
        nearest = StreetHit{s, 0, foot};
      }
    }
    return nearest;
  }

  // the parts of a path that are not beside roads that are there, each with its feet on these roads at its ends
  std::vector<Polyline> new_runs(const Polyline& path) const {
    std::vector<Polyline> runs;
    Polyline run;
    std::optional<Vec2> foot;
    for (const Vec2 p : with_even_steps(path, kRoadStep_m)) {
      const std::optional<StreetHit> road = road_near(p);
      if (!road) {
        if (run.empty() && foot) run.push_back(*foot);
        run.push_back(p);
        continue;
      }
      if (!run.empty()) {
        run.push_back(road->place);
        runs.push_back(std::move(run));
        run.clear();
      }
      foot = road->place;
    }
    if (!run.empty()) runs.push_back(std::move(run));
    std::erase_if(runs, [](const Polyline& r) { return length_m(r) < 2.5 * kJoinRoads_m; });
    return runs;
  }

  void mark_road(const Polyline& curve) {
    for (const Vec2 p : with_even_steps(curve, costs_.has_road.step_m / 2)) costs_.has_road.nearest(p) = 1;
  }

  void lay_run(const Polyline& run, std::uint32_t street) {
    const Polyline smooth = without_corners(simplified_path(run, costs_.height_m.step_m * 0.9), 3);
    const Polyline curve = with_even_steps(smooth, kRoadStep_m);
    mark_road(curve);
    std::uint32_t at = vertex_at(curve.front());
    for (std::size_t i = 1; i < curve.size(); ++i) {
      // points over water are left out: one segment crosses it
      bool is_bridge = false;
      while (i + 1 < curve.size() && plan_.water.at(curve[i]) < 12) {
        is_bridge = true;
        ++i;
      }
      at = lay_street(graph_, at, curve[i], street, 6, is_bridge);
    }
  }

  // the vertex at a place: one that is there, a new one on a road, or a new one
  std::uint32_t vertex_at(Vec2 p) {
    const std::uint32_t near_vertex = graph_.nearest_vertex(p, 7);
    if (near_vertex != kNoStreetVertex) return near_vertex;
    const std::optional<StreetHit> road = road_near(p);
    return road && distance(road->place, p) < 2 ? graph_.split(road->segment, road->place) : graph_.add_vertex(p);
  }

  const TownPlan& plan_;
  StreetGraph graph_;
  RoadCosts costs_;
  std::vector<char> joined_ = std::vector<char>(plan_.centres.size());
};

}  // namespace

StreetGraph main_roads(const TownPlan& plan) { return MainRoads(plan).build(); }

}  // namespace citykiln::invent
