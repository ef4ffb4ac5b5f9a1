#include "compiler/invent/tiles/connect_roads.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "compiler/invent/land/noise.h"

namespace citykiln::invent {
namespace {

using SideLabels = std::array<std::uint8_t, kSides>;
constexpr int kBesideX[kSides] = {0, -1, 0, 1}, kBesideY[kSides] = {1, 0, -1, 0};

class RoadConnector {
 public:
  RoadConnector(const TileSet& set, std::uint64_t seed, TileGrid& grid)
      : set_(set), seed_(seed), grid_(grid), cells_(static_cast<std::uint32_t>(grid.tiles.size())) {
    for (std::size_t i = 0; i < set.turned.size(); ++i)
      by_sides_[set.turned[i].sides].push_back(static_cast<std::uint8_t>(i));
  }

  RoadParts connect() {
    label_parts();
    RoadParts parts{sizes_.size(), sizes_.size()};
    if (sizes_.size() < 2) return parts;
    // every part is connected to the largest one, or to another that is connected later
    const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(sizes_) - sizes_.begin());
    for (std::uint32_t part = 0; part < sizes_.size(); ++part)
      if (root(part) != root(largest) && connect_part(part)) --parts.after;
    return parts;
  }

 private:
  static constexpr std::uint32_t kNoPart = 0xffffffff;
  /// A cell that a chain enters from a neighbour, and the step before it.
  struct ChainStep {
    std::uint32_t cell;
    int from_side;  ///< The side of this cell through which the chain enters.
    int before;     ///< Index of the step before, -1 for the cell of the part itself.
    std::uint32_t road_cell;
  };

  const SideLabels& sides(std::uint32_t cell) const { return set_.turned[grid_.tiles[cell]].sides; }
  bool is_road(std::uint8_t label) const { return std::ranges::find(set_.roads, label) != set_.roads.end(); }
  bool has_road(std::uint32_t cell) const {
    return std::ranges::any_of(sides(cell), [&](std::uint8_t l) { return is_road(l); });
  }
  std::optional<std::uint32_t> beside(std::uint32_t cell, int side) const {
    const int x = static_cast<int>(cell % grid_.columns) + kBesideX[side],
              y = static_cast<int>(cell / grid_.columns) + kBesideY[side];
    if (x < 0 || y < 0 || x >= grid_.columns || y >= grid_.rows) return std::nullopt;
    return static_cast<std::uint32_t>(y * grid_.columns + x);
  }

  void label_parts() {
    part_of_.assign(cells_, kNoPart);
    for (std::uint32_t cell = 0; cell < cells_; ++cell) {
      if (part_of_[cell] != kNoPart || !has_road(cell)) continue;
      sizes_.push_back(flood(cell, static_cast<std::uint32_t>(sizes_.size())));
    }
    above_.resize(sizes_.size());
    for (std::uint32_t i = 0; i < above_.size(); ++i) above_[i] = i;
  }

  std::size_t flood(std::uint32_t first, std::uint32_t part) {
    std::vector<std::uint32_t> reached = {first};
    part_of_[first] = part;
    for (std::size_t at = 0; at < reached.size(); ++at)
      for (int side = 0; side < kSides; ++side) {
        const auto next = is_road(sides(reached[at])[side]) ? beside(reached[at], side) : std::nullopt;
        if (!next || part_of_[*next] != kNoPart) continue;
        part_of_[*next] = part;
        reached.push_back(*next);
      }
    cells_of_.push_back(reached);
    return reached.size();
  }

  std::uint32_t root(std::uint32_t part) const {
    while (above_[part] != part) part = above_[part];
    return part;
  }

  /// The labels of a cell with roads on one or two more sides, if the set has such a tile.
  std::optional<SideLabels> with_roads(std::uint32_t cell, int side, int other) const {
    SideLabels labels = sides(cell);
    for (const int s : {side, other})
      if (s >= 0) labels[s] = set_.roads.front();
    if (!by_sides_.contains(labels)) return std::nullopt;
    return labels;
  }

  bool connect_part(std::uint32_t part) {
    std::vector<ChainStep> steps;
    std::vector<bool> is_entered(cells_, false);
    const auto leave = [&](std::uint32_t cell, int side, int before, std::uint32_t road_cell) {
      const auto next = beside(cell, side);
      const int enters = (side + 2) % kSides;
      if (!next || is_road(sides(cell)[side]) || is_entered[*next]) return;
      // cells of other parts may be entered from several sides, one of which may have a tile
      is_entered[*next] = part_of_[*next] == kNoPart;
      steps.push_back({*next, enters, before, road_cell});
    };
    for (const std::uint32_t cell : cells_of_[part])
      for (int side = 0; side < kSides; ++side)
        if (with_roads(cell, side, -1)) leave(cell, side, -1, cell);
    for (std::size_t at = 0; at < steps.size(); ++at) {
      const ChainStep step = steps[at];
      if (part_of_[step.cell] != kNoPart) {
        if (root(part_of_[step.cell]) == root(part) || !with_roads(step.cell, step.from_side, -1)) continue;
        lay_chain(steps, at);
        above_[root(part)] = root(part_of_[step.cell]);
        return true;
      }
      for (int side = 0; side < kSides; ++side)
        if (side != step.from_side && with_roads(step.cell, step.from_side, side))
          leave(step.cell, side, static_cast<int>(at), step.road_cell);
    }
    return false;
  }

  void lay_chain(const std::vector<ChainStep>& steps, std::size_t last) {
    const std::uint32_t part = part_of_[steps[last].road_cell];
    int leaves = -1;
    for (int at = static_cast<int>(last); at >= 0; at = steps[at].before) {
      const ChainStep& step = steps[at];
      set_sides(step.cell, *with_roads(step.cell, step.from_side, leaves));
      if (part_of_[step.cell] == kNoPart) part_of_[step.cell] = part, cells_of_[part].push_back(step.cell);
      leaves = (step.from_side + 2) % kSides;
    }
    set_sides(steps[last].road_cell, *with_roads(steps[last].road_cell, leaves, -1));
  }

  void set_sides(std::uint32_t cell, const SideLabels& labels) {
    const std::vector<std::uint8_t>& tiles = by_sides_.at(labels);
    double sum = 0;
    for (const std::uint8_t tile : tiles) sum += set_.tiles[set_.turned[tile].tile].weight;
    double left = static_cast<double>(hash_of(cell, 77, seed_) >> 11) * 0x1p-53 * sum;
    for (const std::uint8_t tile : tiles) {
      grid_.tiles[cell] = tile;
      left -= set_.tiles[set_.turned[tile].tile].weight;
      if (left < 0) return;
    }
  }

  const TileSet& set_;
  std::uint64_t seed_;
  TileGrid& grid_;
  std::uint32_t cells_;
  std::map<SideLabels, std::vector<std::uint8_t>> by_sides_;
  std::vector<std::uint32_t> part_of_, above_;
  std::vector<std::size_t> sizes_;
  std::vector<std::vector<std::uint32_t>> cells_of_;
};

}  // namespace

RoadParts connect_roads(const TileSet& set, std::uint64_t seed, TileGrid& grid) {
  if (set.roads.empty()) return {};
  return RoadConnector(set, seed, grid).connect();
}

}  // namespace citykiln::invent
