// The distance to the nearest of many triangles, without approximation: boxes in a tree, halved along their longest
// side.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "tests/grammars/roofs/body.h"

namespace citykiln::buildings {

struct Corners {
  Vec3 a, b, c;
};

class NearestTriangle {
 public:
  explicit NearestTriangle(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
    nodes_.reserve(2 * triangles_.size() / kLeaf + 2);
    if (!triangles_.empty()) build(0, triangles_.size());
  }

  /// The distance to the nearest triangle. The search ends early once a triangle within `enough_m` is found.
  double distance_m(Vec3 p, double enough_m = 0) const {
    double best_m = std::numeric_limits<double>::infinity();
    if (!nodes_.empty()) search(0, p, enough_m, best_m);
    return best_m;
  }

 private:
  static constexpr std::size_t kLeaf = 4;

  struct Node {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    std::size_t first = 0, last = 0;  // range of its triangles
    std::size_t second = 0;           // the first child is the next node
  };

  static Vec3 middle_of(const Corners& t) { return (t.a + t.b + t.c) * (1 / 3.0); }

  static void grow(Node& node, Vec3 p) {
    node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y), std::min(node.low.z, p.z)};
    node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y), std::max(node.high.z, p.z)};
  }

  std::size_t build(std::size_t first, std::size_t last) {
    Node node;
    node.first = first, node.last = last;
    for (std::size_t i = first; i < last; ++i)
      for (const Vec3 p : {triangles_[i].a, triangles_[i].b, triangles_[i].c}) grow(node, p);
    const std::size_t at = nodes_.size();
    nodes_.push_back(node);
    if (last - first <= kLeaf) return at;
    const Vec3 size = node.high - node.low;
    const auto key = [&](const Corners& t) {
      const Vec3 m = middle_of(t);
      return size.x >= size.y && size.x >= size.z ? m.x : size.y >= size.z ? m.y : m.z;
    };
    const std::size_t half = (first + last) / 2;
    const auto begin = triangles_.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(half),
                     begin + static_cast<std::ptrdiff_t>(last),
                     [&](const Corners& s, const Corners& t) { return key(s) < key(t); });
    build(first, half);
    const std::size_t second = build(half, last);
    nodes_[at].second = second;
    return at;
  }

  static double to_box_m(const Node& node, Vec3 p) {
    const auto out = [](double low, double high, double v) { return std::max({low - v, 0.0, v - high}); };
    return length(
        Vec3{out(node.low.x, node.high.x, p.x), out(node.low.y, node.high.y, p.y), out(node.low.z, node.high.z, p.z)});
  }

  void search(std::size_t at, Vec3 p, double enough_m, double& best_m) const {
    const Node& node = nodes_[at];
    if (node.second == 0) {
      for (std::size_t i = node.first; i < node.last; ++i)
        best_m = std::min(best_m, roofs::distance_to_triangle(p, triangles_[i].a, triangles_[i].b, triangles_[i].c));
      return;
    }
    std::size_t near = at + 1, far = node.second;
    if (to_box_m(nodes_[far], p) < to_box_m(nodes_[near], p)) std::swap(near, far);
    for (const std::size_t child : {near, far})
      if (best_m > enough_m && to_box_m(nodes_[child], p) < best_m) search(child, p, enough_m, best_m);
  }

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace citykiln::buildings
