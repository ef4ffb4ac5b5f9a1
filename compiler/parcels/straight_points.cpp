#include "compiler/parcels/straight_points.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "compiler/geometry/point_buckets.h"

namespace citykiln::parcels {
namespace {

constexpr std::int64_t kStraightSteps = static_cast<std::int64_t>(kStraight_m / kQuantum_m);

// A point of borders. Its neighbours are known if it has exactly two, along the same thing.
struct BorderPoint {
  GridPoint at;
  std::array<std::uint32_t, 2> neighbours = {kNoIndex, kNoIndex};
  bool is_plain = false;
  bool is_dropped = false;
};

class Straightener {
 public:
  Straightener(const Faces& faces, const std::vector<std::uint32_t>& regions) {
    std::vector<const FaceEdge*> borders;
    for (const FaceEdge& edge : faces.edges)
      if (edge.beyond == kNoIndex || regions[edge.face] != regions[edge.beyond]) borders.push_back(&edge);
    for (const FaceEdge* edge : borders)
      if (places_.empty() || places_.back() != edge->from) places_.push_back(edge->from);
    points_.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) points_[i].at = places_[i];
    for (std::size_t first = 0, i = 0; first < borders.size(); ++i) {
      std::size_t last = first;
      while (last < borders.size() && borders[last]->from == borders[first]->from) ++last;
      if (last - first == 2 && borders[first]->beyond != kNoIndex && borders[first + 1]->beyond != kNoIndex &&
          borders[first]->border == borders[first + 1]->border)
        points_[i].neighbours = {index_of_point(borders[first]->to), index_of_point(borders[first + 1]->to)};
      points_[i].is_plain = points_[i].neighbours[0] != kNoIndex && points_[i].neighbours[1] != kNoIndex;
      first = last;
    }
    for (const FaceEdge* edge : borders) edges_.emplace_back(edge->from, edge->to);
  }

  std::vector<GridPoint> dropped() {
    if (points_.empty()) return {};
    Box2 box;
    for (const GridPoint p : places_) box.grow({static_cast<double>(p.x), static_cast<double>(p.y)});
    const auto corner = [](Vec2 p) {
      return GridPoint{static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)};
    };
    buckets_ = bucket_points(places_, corner(box.min), corner(box.max));
    for (int round = 0; round < kStraightRounds; ++round) drop_some();
    std::vector<GridPoint> all;
    for (const BorderPoint& p : points_)
      if (p.is_dropped) all.push_back(p.at);
    return all;
  }

 private:
  std::uint32_t index_of_point(GridPoint p) const {
    const auto at = std::ranges::lower_bound(places_, p);
    return at != places_.end() && *at == p ? static_cast<std::uint32_t>(at - places_.begin()) : kNoIndex;
  }

  bool is_straight(const BorderPoint& v) const {
    if (!v.is_plain || v.is_dropped || v.neighbours[0] == v.neighbours[1]) return false;
    const GridPoint p = points_[v.neighbours[0]].at, q = points_[v.neighbours[1]].at;
    const std::int64_t x = q.x - p.x, y = q.y - p.y, area = turn(p, v.at, q);
    if ((p.x - v.at.x) * (q.x - v.at.x) + (p.y - v.at.y) * (q.y - v.at.y) >= 0) return false;
    if (static_cast<double>(area) * static_cast<double>(area) >
        static_cast<double>(kStraightSteps * kStraightSteps) * static_cast<double>(x * x + y * y))
      return false;
    return !has_edge(v.neighbours[0], v.neighbours[1]) && (area == 0 || is_empty_triangle(p, v.at, q));
  }

  bool has_edge(std::uint32_t p, std::uint32_t q) const {
    const auto leads = [&](std::uint32_t a, std::uint32_t b) {
      return points_[a].is_plain && (points_[a].neighbours[0] == b || points_[a].neighbours[1] == b);
    };
    return made_.contains(std::minmax(p, q)) || leads(p, q) || leads(q, p) ||
           std::ranges::binary_search(edges_, std::pair(points_[p].at, points_[q].at)) ||
           std::ranges::binary_search(edges_, std::pair(points_[q].at, points_[p].at));
  }

  bool is_empty_triangle(GridPoint p, GridPoint v, GridPoint q) const {
    if (turn(p, v, q) < 0) std::swap(p, q);
    return !any_near_triangle(buckets_, {p, v, q}, [&](std::uint32_t i) {
      const GridPoint r = places_[i];
      return r != p && r != v && r != q && turn(p, v, r) >= 0 && turn(v, q, r) >= 0 && turn(q, p, r) >= 0;
    });
  }

  // Drops straight points of which no neighbour with a lower number is straight; of points between the same two
  // neighbours only the first, since the border would run back along itself.
  void drop_some() {
    std::vector<bool> straight(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) straight[i] = is_straight(points_[i]);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> drops;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const auto [p, q] = points_[i].neighbours;
      if (straight[i] && !(straight[p] && p < i) && !(straight[q] && q < i)) drops.try_emplace(std::minmax(p, q), i);
    }
    for (const auto& [ends, i] : drops) {
      points_[i].is_dropped = true;
      made_.insert(ends);
      relink(ends.first, i, ends.second);
      relink(ends.second, i, ends.first);
    }
  }

  void relink(std::uint32_t at, std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t& neighbour : points_[at].neighbours)
      if (neighbour == from) {
        neighbour = to;
        return;
      }
  }

  std::vector<GridPoint> places_;  // of points_, sorted
  std::vector<BorderPoint> points_;
  std::vector<std::pair<GridPoint, GridPoint>> edges_;      // sorted
  std::set<std::pair<std::uint32_t, std::uint32_t>> made_;  // between points, instead of what was dropped
  PointBuckets buckets_;
};

}  // namespace

std::vector<GridPoint> straight_points(const Faces& faces, const std::vector<std::uint32_t>& regions) {
  return Straightener(faces, regions).dropped();
}

}  // namespace citykiln::parcels
