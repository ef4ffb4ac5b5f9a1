#include "compiler/plants/prototypes/leaf_clusters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <span>

namespace citykiln::plants {
namespace {

// Cells of more cards are split without a try: a replacement would exceed the tolerance.
constexpr std::size_t kMostTried = 256;
// Pieces of a card each way that bound its distance to others.
constexpr int kPieces = 4;
constexpr int kDeepest = 24;

Vec3 weighted_centre(std::span<const Card> cards) {
  Vec3 sum;
  double area = 0;
  for (const Card& card : cards) sum = sum + card.centre() * area_of(card), area += area_of(card);
  return sum * (1 / area);
}

materials::Tint mean_tint(std::span<const Card> cards) {
  std::array<double, 3> sum{};
  double area = 0;
  for (const Card& card : cards) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += card.tint[c] * area_of(card);
    area += area_of(card);
  }
  materials::Tint tint = materials::kNoTint;
  for (std::size_t c = 0; c < 3; ++c) tint[c] = static_cast<std::uint8_t>(sum[c] / area + 0.5);
  return tint;
}

Vec3 mean_normal(std::span<const Card> cards) {
  Vec3 sum;
  for (const Card& card : cards) sum = sum + card.normal * area_of(card);
  return unit(sum);
}

// @param share  Of the cards' summed area.
Card replacement_for(std::span<const Card> cards, double share) {
  const Vec3 centre = weighted_centre(cards);
  const auto off = [&](const Card& card) { return length(card.centre() - centre); };
  Card card = *std::ranges::min_element(cards, {}, off);
  double area = 0;
  for (const Card& each : cards) area += area_of(each);
  const double larger = std::sqrt(share * area / area_of(card));
  card.across = card.across * larger, card.along = card.along * larger;
  card.corner = centre - (card.across + card.along) * 0.5;
  card.tint = mean_tint(cards);
  const Vec3 normal = mean_normal(cards);
  if (dot(normal, card.normal) > 0) card.normal = normal;
  return card;
}

// The largest distance from a rectangle to a card, at one of its corners since the distance is convex.
double farthest_m(std::span<const Vec3, 4> corners, const Card& from) {
  double farthest = 0;
  for (const Vec3 corner : corners) farthest = std::max(farthest, distance(from, corner));
  return farthest;
}

double to_nearest_m(std::span<const Vec3, 4> piece, std::span<const Card> cards) {
  double nearest = 1e300;
  for (const Card& card : cards) nearest = std::min(nearest, farthest_m(piece, card));
  return nearest;
}

double beyond_m(const Card& card, std::span<const Card> cards) {
  double worst = 0;
  const Vec3 a = card.across * (1.0 / kPieces), b = card.along * (1.0 / kPieces);
  for (int i = 0; i < kPieces; ++i)
    for (int j = 0; j < kPieces; ++j) {
      const Card piece{.corner = card.corner + a * i + b * j, .across = a, .along = b, .normal = {}};
      worst = std::max(worst, to_nearest_m(corners_of(piece), cards));
    }
  return worst;
}

// The Hausdorff distance, or any larger number than the tolerance.
double error_m_of(const Card& card, std::span<const Card> cards, double tolerance_m) {
  double worst = 0;
  for (const Card& each : cards) {
    worst = std::max(worst, farthest_m(corners_of(each), card));
    if (worst > tolerance_m) return worst;
  }
  return std::max(worst, beyond_m(card, cards));
}

// Sorts cards stably by a number below 8. Returns where each number's cards begin, and the end.
template <typename Number>
std::array<std::size_t, 9> sort_into_eight(std::span<Card> cards, Number number) {
  std::array<std::size_t, 9> starts{};
  for (const Card& card : cards) ++starts[number(card) + 1];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::array<std::size_t, 9> next = starts;
  const std::vector<Card> unsorted(cards.begin(), cards.end());
  for (const Card& card : unsorted) cards[next[number(card)]++] = card;
  return starts;
}

// A cube of space and the cards whose centres lie in it.
struct Cell {
  Vec3 low;
  double side_m = 0;
  std::span<Card> cards;
};

struct Clustering {
  double tolerance_m;
  Clusters out;

  void keep(const Card& card, double error_m) {
    out.cards.push_back(card);
    out.error_m = std::max(out.error_m, error_m);
  }

  bool take_whole(const Cell& cell) {
    if (cell.cards.size() > kMostTried || cell.side_m > 4 * tolerance_m) return false;
    if (cell.cards.front().spray != cell.cards.back().spray) return false;
    for (const double share : {1.0, 0.7}) {
      const Card card = replacement_for(cell.cards, share);
      const double error_m = error_m_of(card, cell.cards, tolerance_m);
      if (error_m > tolerance_m) continue;
      keep(card, error_m);
      return true;
    }
    return false;
  }

  void take(const Cell& cell, int depth) {
    if (cell.cards.empty()) return;
    if (cell.cards.size() == 1 || depth == kDeepest) {
      for (const Card& card : cell.cards) keep(card, 0);
      return;
    }
    if (take_whole(cell)) return;
    halve(cell, depth);
  }

  void halve(const Cell& cell, int depth) {
    const double half_m = cell.side_m / 2;
    const Vec3 middle = cell.low + Vec3{half_m, half_m, half_m};
    const auto octant = [&](const Card& card) {
      const Vec3 p = card.centre();
      return (p.x >= middle.x ? 1u : 0u) + (p.y >= middle.y ? 2u : 0u) + (p.z >= middle.z ? 4u : 0u);
    };
    const std::array<std::size_t, 9> starts = sort_into_eight(cell.cards, octant);
    for (std::size_t o = 0; o < 8; ++o) {
      const Vec3 low = cell.low + Vec3{o & 1 ? half_m : 0, o & 2 ? half_m : 0, o & 4 ? half_m : 0};
      take({low, half_m, cell.cards.subspan(starts[o], starts[o + 1] - starts[o])}, depth + 1);
    }
  }
};

}  // namespace

Clusters cluster(const Foliage& foliage, double tolerance_m) {
  assert(tolerance_m > 0);
  std::vector<Card> cards = foliage.cards;
  // sprays are clustered apart: no card replaces both leaves and fruit
  std::ranges::stable_sort(cards, {}, &Card::spray);
  const auto [low, high] = bounds_of(cards);
  const double side_m = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) * (1 + 0x1p-20);
  Clustering clustering{tolerance_m, {}};
  for (auto rest = std::span(cards); !rest.empty();) {
    const auto other = std::ranges::find_if(rest, [&](const Card& c) { return c.spray != rest.front().spray; });
    const auto count = static_cast<std::size_t>(other - rest.begin());
    clustering.take({low, side_m, rest.first(count)}, 0);
    rest = rest.subspan(count);
  }
  return std::move(clustering.out);
}

}  // namespace citykiln::plants
