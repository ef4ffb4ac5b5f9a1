#include "compiler/structures/plan_parapet_gaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compiler/structures/deck_index.h"
#include "compiler/structures/plates.h"

namespace citykiln::structures {
namespace {

// Spacing of samples along an edge.
constexpr double kGapStep_m = 0.25;
// Adjacent decks keep their parapets: an edge has to lie this far inside the other deck.
constexpr double kMinOverlap_m = 0.125;
// Gaps with a shorter parapet between them are merged.
constexpr double kMinParapet_m = 1.5;

bool is_on_deck(const DeckIndex& decks, std::uint32_t own, Vec3 p) {
  for (const std::uint32_t i : boxes_about(decks.grid, in_plan(p))) {
    const DeckPiece& piece = decks.pieces[i];
    if (piece.bridge == own) continue;
    const Vec2 along = piece.to.at - piece.from.at;
    const double long_m = length(along);
    if (long_m == 0) continue;
    const double at_m = dot(in_plan(p) - piece.from.at, along) / long_m;
    const double aside_m = cross(along, in_plan(p) - piece.from.at) / long_m;
    if (at_m < 0 || at_m > long_m || aside_m > piece.left_m - kMinOverlap_m || aside_m < kMinOverlap_m - piece.right_m)
      continue;
    const double z_m = piece.from.z_m + (piece.to.z_m - piece.from.z_m) * (at_m / long_m);
    if (std::abs(z_m - p.z) < kSameSurface_m) return true;
  }
  return false;
}

// True if a place lies on a plate at its height. Walls of a plate stand on its own outline.
bool is_on_a_plate(std::span<const BoxedPlate> plates, Vec3 p) {
  return std::ranges::any_of(plates, [&](const BoxedPlate& boxed) {
    return is_on_plate(boxed, in_plan(p)) && std::abs(plate_height_m(*boxed.plate, in_plan(p)) - p.z) < kSameSurface_m;
  });
}

void add_gap(std::vector<ParapetGap>& gaps, ParapetGap gap) {
  if (!gaps.empty() && gap.from_m - gaps.back().to_m < kMinParapet_m)
    gaps.back().to_m = gap.to_m;
  else
    gaps.push_back(gap);
}

std::vector<ParapetGap> gaps_of(std::span<const BoxedPlate> plates, const DeckIndex& decks, std::uint32_t own,
                                std::span<const Rib> ribs, double edge_m) {
  std::vector<ParapetGap> gaps;
  const double first_m = std::ceil(ribs.front().along_m / kGapStep_m) * kGapStep_m, last_m = ribs.back().along_m;
  for (double at_m = first_m; at_m <= last_m; at_m += kGapStep_m)
    if (const Vec3 p = point_on(rib_at(ribs, at_m), edge_m, 0); is_on_deck(decks, own, p) || is_on_a_plate(plates, p))
      add_gap(gaps, {std::max(0.0, at_m - kGapStep_m), at_m + kGapStep_m});
  return gaps;
}

}  // namespace

std::vector<Span> find_parapet_gaps(std::vector<Span> bridges) {
  const DeckIndex decks = index_decks(bridges, 0);
  const std::vector<BoxedPlate> plates = boxed_plates(bridges);
  for (std::uint32_t b = 0; b < bridges.size(); ++b) {
    const std::vector<Rib> ribs = ribs_of(bridges[b]);
    if (ribs.empty()) continue;
    const DeckDimensions shape = deck_dimensions(bridges[b], 0);
    bridges[b].left_gaps = gaps_of(plates, decks, b, ribs, shape.left_m + kParapet_m / 2);
    bridges[b].right_gaps = gaps_of(plates, decks, b, ribs, -shape.right_m - kParapet_m / 2);
  }
  return bridges;
}

}  // namespace citykiln::structures
