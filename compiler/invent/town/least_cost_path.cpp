#include "compiler/invent/town/least_cost_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace citykiln::invent {
namespace {

/// The directions of a path: vectors of up to three cells without a common divisor.
std::vector<std::pair<int, int>> path_directions() {
  std::vector<std::pair<int, int>> directions;
  for (int j = -3; j <= 3; ++j)
    for (int i = -3; i <= 3; ++i)
      if (std::gcd(i, j) == 1) directions.push_back({i, j});
  return directions;
}

struct Waypoint {
  double estimate = 0;
  std::uint32_t point = 0;
  // the queue has the least estimate first; ties by number, so that the order is fixed
  bool operator<(const Waypoint& o) const {
    return estimate > o.estimate || (estimate == o.estimate && point > o.point);
  }
};

// the cost of a straight piece between two lattice points
double piece_cost(const RoadCosts& costs, std::size_t from, std::size_t to, double run_m, bool is_over_water) {
  if (is_over_water) return run_m * costs.wet_cost;
  const double grade = std::abs(costs.height_m.values[to] - costs.height_m.values[from]) / run_m;
  const double ratio = grade / costs.usual_grade;
  const double cost =
      run_m * (1 + ratio * ratio * 0.7 + (grade > 0.14 ? 20 : 0) + (costs.is_closed.values[to] ? 40 : 0));
  return costs.has_road.values[from] && costs.has_road.values[to] ? cost * kSharedRoad : cost;
}

class PathSearch {
 public:
  PathSearch(const RoadCosts& costs, Vec2 from, Vec2 to)
      : costs_(costs), lattice_(costs.height_m), goal_(point_at(to)), start_(point_at(from)) {
    least_.assign(lattice_.values.size(), std::numeric_limits<double>::infinity());
    before_.assign(lattice_.values.size(), 0xffffffffu);
  }

  std::vector<Vec2> run() {
    least_[start_] = 0;
    queue_.push({0, start_});
    while (!queue_.empty()) {
      const Waypoint next = queue_.top();
      queue_.pop();
      if (next.point == goal_) return path();
      if (next.estimate > least_[next.point] + remaining(next.point)) continue;
      for (const auto& [i, j] : directions_) visit(next.point, i, j);
    }
    return {};
  }

 private:
  std::uint32_t point_at(Vec2 p) const {
    return static_cast<std::uint32_t>(lattice_.index(lattice_.column(p.x), lattice_.row(p.y)));
  }
  int column(std::uint32_t point) const { return static_cast<int>(point) % (lattice_.cells + 1); }
  int row(std::uint32_t point) const { return static_cast<int>(point) / (lattice_.cells + 1); }
  Vec2 place(std::uint32_t point) const { return lattice_.place(column(point), row(point)); }
  double remaining(std::uint32_t point) const { return kSharedRoad * distance(place(point), place(goal_)); }

  void visit(std::uint32_t from, int i, int j) {
    const int c = column(from) + i, r = row(from) + j;
    if (c < 0 || r < 0 || c > lattice_.cells || r > lattice_.cells) return;
    const auto to = static_cast<std::uint32_t>(lattice_.index(c, r));
    const double run_m = length(Vec2{i * 1.0, j * 1.0}) * lattice_.step_m;
    const Vec2 middle = (place(from) + place(to)) * 0.5;
    const bool is_wet = costs_.is_wet.values[from] || costs_.is_wet.values[to] || costs_.is_wet.nearest(middle);
    const double cost = least_[from] + piece_cost(costs_, from, to, run_m, is_wet);
    if (cost >= least_[to]) return;
    least_[to] = cost;
    before_[to] = from;
    queue_.push({cost + remaining(to), to});
  }

  std::vector<Vec2> path() const {
    std::vector<Vec2> points;
    for (std::uint32_t at = goal_; at != 0xffffffffu; at = before_[at]) points.push_back(place(at));
    std::ranges::reverse(points);
    return points;
  }

  const RoadCosts& costs_;
  const TownRaster<double>& lattice_;
  std::uint32_t goal_, start_;
  std::vector<double> least_;
  std::vector<std::uint32_t> before_;
  std::priority_queue<Waypoint> queue_;
  std::vector<std::pair<int, int>> directions_ = path_directions();
};

}  // namespace

RoadCosts road_costs(const TownPlan& plan) {
  const double side_m = plan.settings.side_m, step_m = std::clamp(side_m / 200, 12.0, 25.0);
  RoadCosts costs{TownRaster<double>(side_m, step_m), TownRaster<char>(side_m, step_m),
                  TownRaster<char>(side_m, step_m), TownRaster<char>(side_m, step_m)};
  for (int row = 0; row <= costs.height_m.cells; ++row)
    for (int column = 0; column <= costs.height_m.cells; ++column) {
      const std::size_t i = costs.height_m.index(column, row);
      const Vec2 p = costs.height_m.place(column, row);
      costs.height_m.values[i] = plan.terrain->height_m(p);
      costs.is_closed.values[i] = plan.is_station_land(p);
      costs.is_wet.values[i] = plan.water.at(p) < step_m * 0.75;
    }
  return costs;
}

std::vector<Vec2> least_cost_path(const RoadCosts& costs, Vec2 from, Vec2 to) {
  return PathSearch(costs, from, to).run();
}

}  // namespace citykiln::invent
