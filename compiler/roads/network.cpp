#include "compiler/roads/network.h"

#include <algorithm>
#include <cmath>

namespace citykiln::roads {
namespace {

// A road passes a place: which of its vertices lies there.
struct Passing {
  Vec2 at;
  Family family;
  std::uint32_t road, vertex;
  auto operator<=>(const Passing&) const = default;
};

std::vector<Passing> passings_of(std::span<const Road> roads) {
  std::vector<Passing> passings;
  for (std::uint32_t road = 0; road < roads.size(); ++road) {
    const Family family = family_of(roads[road].surface);
    if (family == Family::kOther) continue;
    for (std::uint32_t vertex = 0; vertex < roads[road].axis.size(); ++vertex)
      passings.push_back({roads[road].axis[vertex], family, road, vertex});
  }
  std::sort(passings.begin(), passings.end());
  return passings;
}

void add_arms(std::span<const Road> roads, std::uint32_t road, std::uint32_t vertex, std::vector<Arm>& arms) {
  if (vertex > 0) arms.push_back({road, vertex, -1});
  if (vertex + 1 < roads[road].axis.size()) arms.push_back({road, vertex, 1});
}

Vec2 direction(std::span<const Road> roads, const Arm& arm) {
  const Polyline& axis = roads[arm.road].axis;
  return unit(axis[static_cast<std::size_t>(static_cast<std::int64_t>(arm.vertex) + arm.step)] - axis[arm.vertex]);
}

// Two arms of two roads that a driver takes for one road.
bool go_on(std::span<const Road> roads, const Arm& a, const Arm& b) {
  // the same road's own bend is part of its strip
  if (a.road == b.road) return true;
  constexpr double kSameWidth_m = 0.25;
  return std::abs(roads[a.road].width_m - roads[b.road].width_m) < kSameWidth_m &&
         dot(direction(roads, a), direction(roads, b)) < 0;
}

bool is_node(std::span<const Road> roads, const std::vector<Arm>& arms) {
  return arms.size() > 2 || (arms.size() == 2 && !go_on(roads, arms[0], arms[1]));
}

}  // namespace

Family family_of(map::SurfaceClass surface) {
  using map::SurfaceClass;
  using map::SurfaceGroup;
  if (surface == SurfaceClass::kRunway) return Family::kOther;
  if (surface == SurfaceClass::kFarmTrack) return Family::kStreet;
  const SurfaceGroup group = map::values_of(surface).group;
  return group == SurfaceGroup::kRoad ? Family::kStreet : group == SurfaceGroup::kPath ? Family::kPath : Family::kOther;
}

std::vector<Node> find_nodes(std::span<const Road> roads) {
  const std::vector<Passing> passings = passings_of(roads);
  std::vector<Node> nodes;
  std::vector<Arm> arms;
  for (std::size_t first = 0; first < passings.size();) {
    arms.clear();
    std::size_t i = first;
    const Passing& here = passings[first];
    for (; i < passings.size() && passings[i].at == here.at && passings[i].family == here.family; ++i)
      add_arms(roads, passings[i].road, passings[i].vertex, arms);
    if (is_node(roads, arms)) nodes.push_back({here.at, here.family, arms});
    first = i;
  }
  return nodes;
}

std::vector<Arm> arms_at(std::span<const Road> roads, std::span<const Vec2> places, Family family) {
  std::vector<std::vector<Arm>> by_place(places.size());
  for (std::uint32_t road = 0; road < roads.size(); ++road) {
    if (family_of(roads[road].surface) != family) continue;
    for (std::uint32_t vertex = 0; vertex < roads[road].axis.size(); ++vertex) {
      const auto place = std::ranges::lower_bound(places, roads[road].axis[vertex]);
      if (place == places.end() || *place != roads[road].axis[vertex]) continue;
      add_arms(roads, road, vertex, by_place[static_cast<std::size_t>(place - places.begin())]);
    }
  }
  std::vector<Arm> arms;
  for (const std::vector<Arm>& here : by_place) arms.insert(arms.end(), here.begin(), here.end());
  return arms;
}

Polyline walk(std::span<const Road> roads, const Arm& arm, double length_m) {
  const Polyline& axis = roads[arm.road].axis;
  Polyline path = {axis[arm.vertex]};
  double left_m = length_m;
  for (std::int64_t v = static_cast<std::int64_t>(arm.vertex) + arm.step;
       v >= 0 && v < static_cast<std::int64_t>(axis.size()); v += arm.step) {
    const Vec2 next = axis[static_cast<std::size_t>(v)];
    const double step_m = distance(path.back(), next);
    if (step_m >= left_m) {
      path.push_back(path.back() + (next - path.back()) * (left_m / step_m));
      return path;
    }
    left_m -= step_m;
    path.push_back(next);
  }
  return path;
}

}  // namespace citykiln::roads
