#include "compiler/parcels/empty_lots.h"

#include <algorithm>

#include "compiler/parcels/lot_borders.h"
#include "compiler/parcels/tight_box.h"

namespace citykiln::parcels {
namespace {

// Parts of lots have at least this share of the usual frontage.
constexpr double kLeastShare = 0.4;
// Lots within this factor of the usual area are not split.
constexpr double kNearUsual = 1.25;

// A part of a lot while it is split: its outline, which may touch itself, and its frontages.
struct Part {
  Ring ring;
  std::vector<FrontageEdge> frontages;

  double frontage_m() const {
    double sum = 0;
    for (const FrontageEdge& edge : frontages) sum += distance(edge.first, edge.second);
    return sum;
  }
};

// The part to the left of a line, by Sutherland and Hodgman 1974.
Part left_part(const Part& part, Vec2 at, Vec2 along) {
  Part left;
  const auto side = [&](Vec2 p) { return cross(along, p - at); };
  const auto meet = [&](Vec2 p, Vec2 q) { return p + (q - p) * (side(p) / (side(p) - side(q))); };
  for (std::size_t i = 0, n = part.ring.size(); i < n; ++i) {
    const Vec2 p = part.ring[i], q = part.ring[(i + 1) % n];
    if (side(p) >= 0) left.ring.push_back(p);
    if ((side(p) >= 0) != (side(q) >= 0)) left.ring.push_back(meet(p, q));
  }
  for (const auto& [p, q] : part.frontages) {
    if (side(p) < 0 && side(q) < 0) continue;
    const Vec2 from = side(p) < 0 ? meet(p, q) : p, to = side(q) < 0 ? meet(p, q) : q;
    left.frontages.emplace_back(from, to);
  }
  return left;
}

class Splitter {
 public:
  Splitter(const LotSize& size, SplitTree& tree) : size_(size), tree_(tree) {}

  std::uint32_t split(const Part& part, int depth) {
    if (depth == 0 || part.ring.size() < 3 || signed_area_m2(part.ring) <= size_.area_m2 * kNearUsual) return kNoIndex;
    const TightBox box = tight_box(part.ring);
    for (const Vec2 axis : {box.along, left_of(box.along)}) {
      const Vec2 along = left_of(axis);
      const Part left = left_part(part, box.centre, along), right = left_part(part, box.centre, along * -1);
      if (std::min(left.frontage_m(), right.frontage_m()) < size_.frontage_m * kLeastShare) continue;
      const auto node = static_cast<std::uint32_t>(tree_.nodes.size());
      tree_.nodes.push_back({box.centre, along});
      add_cuts(part.ring, box.centre, along);
      const std::uint32_t l = split(left, depth - 1), r = split(right, depth - 1);
      tree_.nodes[node].left = l, tree_.nodes[node].right = r;
      return node;
    }
    return kNoIndex;
  }

 private:
  // The parts of the line inside the ring.
  void add_cuts(const Ring& ring, Vec2 at, Vec2 along) {
    std::vector<double> places;
    for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
      const Vec2 p = ring[i], q = ring[(i + 1) % n];
      const double s = cross(along, p - at), t = cross(along, q - at);
      if ((s >= 0) != (t >= 0)) places.push_back(dot(p + (q - p) * (s / (s - t)) - at, along));
    }
    std::ranges::sort(places);
    for (std::size_t i = 0; i + 1 < places.size(); i += 2)
      tree_.cuts.emplace_back(at + along * (places[i] - kOverlap_m), at + along * (places[i + 1] + kOverlap_m));
  }

  const LotSize& size_;
  SplitTree& tree_;
};

}  // namespace

SplitTree split(const Ring& lot, const std::vector<FrontageEdge>& frontages, const LotSize& size) {
  SplitTree tree;
  // 2^12 parts: more than a section can have
  Splitter(size, tree).split({lot, frontages}, 12);
  return tree;
}

std::uint32_t leaf_at(const SplitTree& tree, Vec2 p) {
  if (tree.nodes.empty()) return 0;
  for (std::uint32_t i = 0;;) {
    const SplitTree::Node& node = tree.nodes[i];
    const bool is_left = cross(node.along, p - node.at) >= 0;
    const std::uint32_t next = is_left ? node.left : node.right;
    if (next == kNoIndex) return 2 * i + (is_left ? 0 : 1);
    i = next;
  }
}

}  // namespace citykiln::parcels
