#include "compiler/plants/prototypes/leaf_clusters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>

#include "compiler/plants/prototypes/sprays.h"

namespace citykiln::plants {
namespace {

// Finds cards by position, with a grid of their centres. A card is a rectangle with a picture of leaves (foliage.h).

// Cards, and the sorted grid cells of their centres.
struct CardIndex {
  struct Entry {
    std::uint64_t cell;
    std::uint32_t card;
    auto operator<=>(const Entry&) const = default;
  };
  std::span<const Card> cards;
  double cell_m = 1;
  std::vector<Entry> entries{};
};

// Returns the number of the grid cell that contains a position, in the order of layers, rows and columns.
// @param dy, dz  Offset in rows and layers to another cell.
std::uint64_t grid_cell(Vec3 place, double cell_m, int dy = 0, int dz = 0) {
  constexpr double kOffset = 1 << 20;
  const auto step = [&](double v) { return static_cast<std::uint64_t>(std::floor(v / cell_m) + kOffset); };
  return (step(place.z) + static_cast<std::uint64_t>(dz)) << 42 |
         (step(place.y) + static_cast<std::uint64_t>(dy)) << 21 | step(place.x);
}

// Builds the index. O(n log n).
// @param cards  Must outlive the index; their centres are within 2^19 cells of the origin.
CardIndex index_cards(std::span<const Card> cards, double cell_m) {
  assert(cell_m > 0);
  CardIndex index{cards, cell_m};
  for (std::uint32_t i = 0; i < cards.size(); ++i) index.entries.push_back({grid_cell(cards[i].centre(), cell_m), i});
  std::ranges::sort(index.entries);
  return index;
}

// True if a card fulfils a condition, among the cards whose centres lie in the grid cell of `place` or in a cell
// beside it.
template <typename Condition>
bool any_near(const CardIndex& index, Vec3 place, Condition condition) {
  for (const int dz : {0, -1, 1})
    for (const int dy : {0, -1, 1}) {
      const std::uint64_t cell = grid_cell(place, index.cell_m, dy, dz);
      auto entry = std::ranges::lower_bound(index.entries, cell - 1, {}, &CardIndex::Entry::cell);
      for (; entry != index.entries.end() && entry->cell <= cell + 1; ++entry)
        if (condition(index.cards[entry->card])) return true;
    }
  return false;
}

// Width of a cell's card, in widths of the cell.
constexpr double kCardWidth = 1.25;
// Pieces of a card each way that bound its distance to others.
constexpr int kCardPieces = 4;

// A range of the sorted cards, and the card that replaces it.
struct Cell {
  std::size_t first, count;
  Card card{};
};

std::span<const Card> cards_of(const Cell& cell, const std::vector<Card>& cards) {
  return std::span(cards).subspan(cell.first, cell.count);
}

double summed_area(std::span<const Card> cards) {
  return std::accumulate(cards.begin(), cards.end(), 0.0, [](double sum, const Card& c) { return sum + area_of(c); });
}

Vec3 weighted_centre(std::span<const Card> cards) {
  Vec3 sum;
  for (const Card& card : cards) sum = sum + card.centre() * area_of(card);
  return sum * (1 / summed_area(cards));
}

materials::Tint mean_tint(std::span<const Card> cards) {
  std::array<double, 3> sum{};
  for (const Card& card : cards)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += card.tint[c] * area_of(card);
  materials::Tint tint = materials::kNoTint;
  const double area = summed_area(cards);
  for (std::size_t c = 0; c < 3; ++c) tint[c] = static_cast<std::uint8_t>(sum[c] / area + 0.5);
  return tint;
}

Vec3 mean_normal(std::span<const Card> cards) {
  Vec3 sum;
  for (const Card& card : cards) sum = sum + card.normal * area_of(card);
  return unit(sum);
}

// @param cards       At least two.
// @param has_leaves  False for fruit and blades.
Card replacement_for(std::span<const Card> cards, double widest_m, bool has_leaves) {
  const Vec3 centre = weighted_centre(cards);
  Card card = *std::ranges::min_element(cards, {}, [&](const Card& c) { return length(c.centre() - centre); });
  const double area = summed_area(cards), most = std::max(widest_m * widest_m, area_of(card));
  // many leaves are shown as many: one large spray in their place would be seen as such
  card.is_clump = has_leaves || area > most;
  const double larger = std::sqrt((card.is_clump ? std::min(area / kClumpLeaves, most) : area) / area_of(card));
  card.across = card.across * larger, card.along = card.along * larger;
  card.corner = centre - (card.across + card.along) * 0.5;
  card.tint = mean_tint(cards);
  const Vec3 normal = mean_normal(cards);
  if (dot(normal, card.normal) > 0) card.normal = normal;
  return card;
}

struct Clustering {
  double width_m;  // of a cell; leaves move by at most as much
  std::span<const std::string> sprays;
  std::vector<Card> cards;    // sorted so that each cell is a range
  std::vector<Cell> cells{};  // all of the foliage

  Cell cell_of(std::size_t first, std::size_t count) const {
    Cell cell{first, count};
    const std::span<const Card> own = cards_of(cell, cards);
    const std::string& spray = sprays[own.front().spray];
    const bool has_leaves = !spray.empty() && !is_fruit(spray);
    cell.card = count == 1 ? own.front() : replacement_for(own, kCardWidth * width_m, has_leaves);
    return cell;
  }

  // Sorts a range into two halves of its bounds along their longest side. Returns the size of the first half, 0 if all
  // centres are equal.
  std::size_t halve(std::size_t first, std::size_t count) {
    const auto [low, high] = bounds_of(std::span(cards).subspan(first, count));
    const Vec3 wide = high - low;
    const auto axis = wide.x >= std::max(wide.y, wide.z) ? &Vec3::x : wide.y >= wide.z ? &Vec3::y : &Vec3::z;
    const double middle = (low.*axis + high.*axis) / 2;
    const auto begin = cards.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    const auto second = std::stable_partition(begin, end, [&](const Card& c) { return c.centre().*axis < middle; });
    return static_cast<std::size_t>(second - begin);
  }

  bool is_small(std::size_t first, std::size_t count) const {
    const auto [low, high] = bounds_of(std::span(cards).subspan(first, count));
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z}) <= width_m;
  }

  void divide(std::size_t first, std::size_t count) {
    const std::size_t half = count == 1 || is_small(first, count) ? 0 : halve(first, count);
    if (half == 0) return cells.push_back(cell_of(first, count));
    divide(first, half);
    divide(first + half, count - half);
  }
};

// The distance of the farthest point of the ellipse in a card, where its picture shows leaves, from another card; a
// bound from the octagon about it, since the distance is convex.
double distance_m(const Card& card, const Card& other) {
  constexpr double kCorner = 0.41421356237309503;
  const Vec3 centre = card.centre(), a = card.across * 0.5, b = card.along * 0.5;
  double farthest = 0;
  for (const double u : {-1.0, 1.0})
    for (const double v : {-kCorner, kCorner})
      farthest = std::max({farthest, distance(other, centre + a * u + b * v), distance(other, centre + a * v + b * u)});
  return farthest;
}

// The distance of a card from the nearest of its own cell's and of all cards about it; where that is at most `known`,
// any number that is.
double nearest_m(const Card& card, std::span<const Card> own, const CardIndex& all, double known) {
  double nearest = 1e300;
  const auto is_known = [&](const Card& other) {
    return (nearest = std::min(nearest, distance_m(card, other))) <= known;
  };
  if (!std::ranges::any_of(own, is_known)) any_near(all, card.centre(), is_known);
  return nearest;
}

// The given cards and those that replace them.
struct Indices {
  CardIndex given, made;
};

// The larger of `known` and of the distance between a cell's cards and the new ones, both ways; from pieces of the new
// card, without those at its corners, which show no leaves.
double cluster_error_m(const Cell& cell, const std::vector<Card>& cards, const Indices& indices, double known) {
  if (cell.count == 1) return known;
  const std::span<const Card> own = cards_of(cell, cards);
  for (const Card& card : own) known = std::max(known, nearest_m(card, std::span(&cell.card, 1), indices.made, known));
  const Vec3 a = cell.card.across * (1.0 / kCardPieces), b = cell.card.along * (1.0 / kCardPieces);
  const auto is_end = [](int i) { return i == 0 || i + 1 == kCardPieces; };
  for (int i = 0; i < kCardPieces; ++i)
    for (int j = 0; j < kCardPieces; ++j) {
      if (is_end(i) && is_end(j)) continue;
      const Card piece{.corner = cell.card.corner + a * i + b * j, .across = a, .along = b, .normal = {}};
      known = std::max(known, nearest_m(piece, own, indices.given, known));
    }
  return known;
}

std::vector<Card> replacements(const std::vector<Cell>& cells) {
  std::vector<Card> cards;
  for (const Cell& cell : cells) cards.push_back(cell.card);
  return cards;
}

// Halves the cells whose error exceeds the width. Returns the largest error of the others, or nothing if there was one.
std::optional<double> refine(Clustering& state) {
  const std::vector<Card> made = replacements(state.cells);
  const Indices indices{index_cards(state.cards, state.width_m), index_cards(made, state.width_m)};
  double error_m = 0;
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < state.cells.size(); ++i) {
    const double here_m = cluster_error_m(state.cells[i], state.cards, indices, error_m);
    if (here_m > state.width_m)
      wrong.push_back(i);
    else
      error_m = here_m;
  }
  for (const std::size_t i : wrong) {
    const auto [first, count, card] = state.cells[i];
    std::size_t half = state.halve(first, count);
    if (half == 0) half = count / 2;
    state.cells[i] = state.cell_of(first, half);
    state.cells.push_back(state.cell_of(first + half, count - half));
  }
  return wrong.empty() ? std::optional(error_m) : std::nullopt;
}

}  // namespace

Clusters cluster(const Foliage& foliage, double width_m) {
  assert(width_m > 0);
  Clustering state{width_m, foliage.sprays, foliage.cards};
  // sprays are clustered apart: no card replaces both leaves and fruit
  std::ranges::stable_sort(state.cards, {}, &Card::spray);
  for (std::size_t first = 0; first < state.cards.size();) {
    const auto begin = state.cards.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = std::find_if(begin, state.cards.end(), [&](const Card& c) { return c.spray != begin->spray; });
    const auto count = static_cast<std::size_t>(end - begin);
    state.divide(first, count);
    first += count;
  }
  std::optional<double> error_m;
  while (!error_m) error_m = refine(state);
  return {replacements(state.cells), *error_m};
}

}  // namespace citykiln::plants
