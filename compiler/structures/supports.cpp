#include "compiler/structures/supports.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/trig.h"

namespace citykiln::structures {
namespace {

// Decks broader than this stand on columns under a beam.
constexpr double kBroad_m = 7;
// A wall's share of the deck's width and its thickness; a beam's likewise; columns, and how far apart they stand.
constexpr double kWallShare = 0.55, kWall_m = 0.8;
constexpr double kBeamShare = 0.8, kBeam_m = 1.25, kBeamHigh_m = 1;
constexpr double kColumnRadius_m = 0.55, kColumnsApart_m = 8;
constexpr int kColumnSides = 8;

double width_m(const DeckDimensions& shape) { return shape.left_m + shape.right_m + 2 * kParapet_m; }
double middle_m(const DeckDimensions& shape) { return (shape.left_m - shape.right_m) / 2; }
bool is_broad(const DeckDimensions& shape) { return width_m(shape) > kBroad_m; }

// A rectangle about a place of the rib's line, counter-clockwise.
std::array<Vec2, 4> rectangle(const Rib& rib, double left_m, double half_across_m, double half_along_m) {
  const Vec2 left = unit(rib.out), at = rib.at + left * left_m;
  const Vec2 across = left * half_across_m, along = left_of(left) * half_along_m;
  return {at - across - along, at + across - along, at + across + along, at - across + along};
}

std::vector<Vec2> circle(Vec2 centre) {
  std::vector<Vec2> ring;
  for (int i = 0; i < kColumnSides; ++i)
    ring.push_back(centre + direction_of(static_cast<double>(i) / kColumnSides) * kColumnRadius_m);
  return ring;
}

void add_columns(const Rib& rib, const DeckDimensions& shape, double from_m, double to_m, Mesh& mesh) {
  const double long_m = kBeamShare * width_m(shape) - 2 * kBeam_m;
  const int gaps = std::max(1, static_cast<int>(long_m / kColumnsApart_m + 0.5));
  const Vec2 left = unit(rib.out);
  for (int i = 0; i <= gaps; ++i) {
    const double left_m = middle_m(shape) + long_m * (static_cast<double>(i) / gaps - 0.5);
    add_box(circle(rib.at + left * left_m), from_m, to_m, mesh);
  }
}

}  // namespace

PierFoot foot_of(const DeckDimensions& shape) {
  if (!is_broad(shape)) return {kWallShare * width_m(shape) / 2, kWall_m / 2};
  return {kBeamShare * width_m(shape) / 2, kBeam_m / 2};
}

void add_pier(std::span<const Rib> ribs, const DeckDimensions& shape, const Pier& pier, Mesh& mesh) {
  const Rib rib = rib_at(ribs, pier.at_m);
  const PierFoot foot = foot_of(shape);
  const auto base = rectangle(rib, middle_m(shape), foot.half_across_m, foot.half_along_m);
  // a deck that leans lies on the pier with its lower side
  const double leans_m = std::abs(rib.tilt) * foot.half_across_m;
  const double under_m = rib.z_m + rib.tilt * middle_m(shape) - shape.thickness_m;
  const double top_m = under_m + std::min(leans_m, shape.thickness_m / 2) + shape.thickness_m / 8;
  if (top_m <= pier.foot_m) return;
  if (!is_broad(shape)) return add_box(base, pier.foot_m, top_m, mesh);
  const double beam_m = std::max(under_m - leans_m - kBeamHigh_m, pier.foot_m);
  add_box(base, beam_m, top_m, mesh);
  if (beam_m > pier.foot_m) add_columns(rib, shape, pier.foot_m, beam_m, mesh);
}

void add_abutment(std::span<const Rib> ribs, const DeckDimensions& shape, bool is_begin, Mesh& mesh) {
  const double end_m = is_begin ? ribs.front().along_m : ribs.back().along_m;
  const double inner_m =
      end_m + (is_begin ? 1 : -1) * std::min(kAbutmentLength_m, (ribs.back().along_m - ribs.front().along_m) / 4);
  const std::array pair = {rib_at(ribs, std::min(end_m, inner_m)), rib_at(ribs, std::max(end_m, inner_m))};
  const double l = shape.left_m + kParapet_m, r = -shape.right_m - kParapet_m;
  const double top_m = -shape.edge_m, bottom_m = -shape.thickness_m - kAbutment_m;
  add_tube(pair, {{l, bottom_m}, {l, top_m}, {r, top_m}, {r, bottom_m}}, mesh);
}

}  // namespace citykiln::structures
