// Splits of lots: square to the longer axis with and without regard to the frontage.
#include <utility>
#include <vector>

#include "compiler/geometry/ring_crossing.h"
#include "compiler/parcels/empty_lots.h"
#include "compiler/parcels/tight_box.h"
#include "tests/charts/hard_cases.h"

namespace citykiln::charts {
namespace {

constexpr parcels::LotSize kUsualLot{.area_m2 = 600, .frontage_m = 18, .depth_m = 40};
constexpr double kLeastFrontage_m = 0.4 * 18 - 1e-6;

/// A part of a lot: its outline, and its frontage as parts of lines.
struct LotPart {
  Ring ring;
  std::vector<parcels::FrontageEdge> frontages;
};

double frontage_m(const LotPart& part) {
  double sum = 0;
  for (const auto& [a, b] : part.frontages) sum += distance(a, b);
  return sum;
}

// The part of an edge to the left of a line; empty parts are left out.
void keep_left(std::vector<parcels::FrontageEdge>& kept, const parcels::FrontageEdge& edge, Vec2 at, Vec2 along) {
  const double from = cross(along, edge.first - at), to = cross(along, edge.second - at);
  if (from < 0 && to < 0) return;
  if (from >= 0 && to >= 0) return kept.push_back(edge);
  const Vec2 cut = edge.first + (edge.second - edge.first) * (from / (from - to));
  kept.push_back(from >= 0 ? parcels::FrontageEdge{edge.first, cut} : parcels::FrontageEdge{cut, edge.second});
}

LotPart left_of_line(const LotPart& part, Vec2 at, Vec2 along) {
  LotPart left;
  for (std::size_t i = 0, n = part.ring.size(); i < n; ++i) {
    const Vec2 p = part.ring[i], q = part.ring[(i + 1) % n];
    const double s = cross(along, p - at), t = cross(along, q - at);
    if (s >= 0) left.ring.push_back(p);
    if ((s >= 0) != (t >= 0)) left.ring.push_back(p + (q - p) * (s / (s - t)));
  }
  for (const parcels::FrontageEdge& edge : part.frontages) keep_left(left.frontages, edge, at, along);
  return left;
}

void split_without_regard(const LotPart& part, int depth, std::vector<LotPart>& leaves) {
  if (depth == 0 || part.ring.size() < 3 || signed_area_m2(part.ring) <= 1.25 * kUsualLot.area_m2)
    return leaves.push_back(part);
  const parcels::TightBox box = parcels::tight_box(part.ring);
  const Vec2 along = left_of(box.along);
  split_without_regard(left_of_line(part, box.centre, along), depth - 1, leaves);
  split_without_regard(left_of_line(part, box.centre, along * -1), depth - 1, leaves);
}

void leaves_of(const parcels::SplitTree& tree, std::uint32_t node, const LotPart& part, std::vector<LotPart>& leaves) {
  if (node == parcels::kNoIndex) return leaves.push_back(part);
  const parcels::SplitTree::Node& split = tree.nodes[node];
  leaves_of(tree, split.left, left_of_line(part, split.at, split.along), leaves);
  leaves_of(tree, split.right, left_of_line(part, split.at, split.along * -1), leaves);
}

bool are_lots(const std::vector<LotPart>& leaves, double wanted_m2) {
  double area = 0;
  for (const LotPart& leaf : leaves) {
    if (leaves.size() > 1 && frontage_m(leaf) < kLeastFrontage_m) return false;
    area += signed_area_m2(leaf.ring);
  }
  return std::abs(area - wanted_m2) <= 1e-6 * wanted_m2;
}

}  // namespace

Judged judge_lots(HardDraw& draw) {
  LotPart lot;
  const double scale = draw.between(1, 5);
  for (const Vec2 p : hard_ring(draw, {})) lot.ring.push_back(p * scale);
  const auto edges = static_cast<int>(lot.ring.size());
  for (int i = draw.whole(0, edges - 1), last = i + draw.whole(0, 1); i <= last; ++i)
    lot.frontages.emplace_back(lot.ring[i % edges], lot.ring[(i + 1) % edges]);
  const double wanted = signed_area_m2(lot.ring);
  std::vector<LotPart> textbook, ours;
  split_without_regard(lot, 12, textbook);
  const parcels::SplitTree tree = parcels::split(lot.ring, lot.frontages, kUsualLot);
  leaves_of(tree, tree.nodes.empty() ? parcels::kNoIndex : 0, lot, ours);
  return {are_lots(textbook, wanted), are_lots(ours, wanted)};
}

}  // namespace citykiln::charts
