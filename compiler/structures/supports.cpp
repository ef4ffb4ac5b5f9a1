#include "compiler/structures/supports.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/trig.h"

namespace citykiln::structures {
namespace {

// Wider decks stand on columns with a cap beam, others on walls.
constexpr double kMaxWallWidth_m = 7;
// Length of walls and beams as a share of the deck's width, and their thickness.
constexpr double kWallShare = 0.55, kWall_m = 0.8;
constexpr double kBeamShare = 0.8, kBeam_m = 1.25, kBeamHeight_m = 1;
constexpr double kColumnRadius_m = 0.55, kColumnSpacing_m = 8;
constexpr int kColumnSides = 8;

double width_m(const DeckDimensions& deck) { return deck.left_m + deck.right_m + 2 * kParapet_m; }
double middle_m(const DeckDimensions& deck) { return (deck.left_m - deck.right_m) / 2; }
bool has_columns(const DeckDimensions& deck) { return width_m(deck) > kMaxWallWidth_m; }

// A rectangle around a point of the rib, counter-clockwise.
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

void add_columns(const Rib& rib, const DeckDimensions& deck, double from_m, double to_m, Mesh& mesh) {
  const double long_m = kBeamShare * width_m(deck) - 2 * kBeam_m;
  const int gaps = std::max(1, static_cast<int>(long_m / kColumnSpacing_m + 0.5));
  const Vec2 left = unit(rib.out);
  for (int i = 0; i <= gaps; ++i) {
    const double left_m = middle_m(deck) + long_m * (static_cast<double>(i) / gaps - 0.5);
    add_prism(circle(rib.at + left * left_m), from_m, to_m, mesh);
  }
}

}  // namespace

PierFoot foot_of(const DeckDimensions& deck) {
  if (!has_columns(deck)) return {kWallShare * width_m(deck) / 2, kWall_m / 2};
  return {kBeamShare * width_m(deck) / 2, kBeam_m / 2};
}

void add_pier(std::span<const Rib> ribs, const DeckDimensions& deck, const Pier& pier, Mesh& mesh) {
  const Rib rib = rib_at(ribs, pier.at_m);
  const PierFoot foot = foot_of(deck);
  const auto base = rectangle(rib, middle_m(deck), foot.half_across_m, foot.half_along_m);
  // the lower side of a tilted deck rests on the pier
  const double tilt_m = std::abs(rib.tilt) * foot.half_across_m;
  const double under_m = rib.z_m + rib.tilt * middle_m(deck) - deck.thickness_m;
  const double top_m = under_m + std::min(tilt_m, deck.thickness_m / 2) + deck.thickness_m / 8;
  if (top_m <= pier.foot_m) return;
  if (!has_columns(deck)) return add_prism(base, pier.foot_m, top_m, mesh);
  const double beam_m = std::max(under_m - tilt_m - kBeamHeight_m, pier.foot_m);
  add_prism(base, beam_m, top_m, mesh);
  if (beam_m > pier.foot_m) add_columns(rib, deck, pier.foot_m, beam_m, mesh);
}

void add_abutment(std::span<const Rib> ribs, const DeckDimensions& deck, bool is_begin, Mesh& mesh) {
  const double end_m = is_begin ? ribs.front().along_m : ribs.back().along_m;
  const double inner_m =
      end_m + (is_begin ? 1 : -1) * std::min(kAbutmentLength_m, (ribs.back().along_m - ribs.front().along_m) / 4);
  const std::array pair = {rib_at(ribs, std::min(end_m, inner_m)), rib_at(ribs, std::max(end_m, inner_m))};
  const double l = deck.left_m + kParapet_m, r = -deck.right_m - kParapet_m;
  const double top_m = -deck.edge_m, bottom_m = -deck.thickness_m - kAbutment_m;
  add_tube(pair, {{l, bottom_m}, {l, top_m}, {r, top_m}, {r, bottom_m}}, mesh);
}

}  // namespace citykiln::structures
