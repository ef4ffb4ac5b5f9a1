#include "compiler/invent/tiles/arrange_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <queue>

#include "compiler/invent/land/noise.h"

namespace citykiln::invent {
namespace {

/// A set of turned tiles.
struct TileBits {
  std::array<std::uint64_t, kMostTurned / 64> words{};
  bool operator==(const TileBits&) const = default;
  void insert(std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }
  void erase(std::size_t i) { words[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
  bool holds(std::size_t i) const { return (words[i / 64] >> (i % 64) & 1) != 0; }
  int count() const { return std::popcount(words[0]) + std::popcount(words[1]); }
};
TileBits operator&(const TileBits& a, const TileBits& b) {
  return {{a.words[0] & b.words[0], a.words[1] & b.words[1]}};
}
TileBits operator|(const TileBits& a, const TileBits& b) {
  return {{a.words[0] | b.words[0], a.words[1] | b.words[1]}};
}
bool is_empty(const TileBits& bits) { return (bits.words[0] | bits.words[1]) == 0; }

// tiles in whose range the noise lies are so much more frequent
constexpr double kInRange = 8;
// decisions older than this are final, which bounds memory
constexpr std::size_t kMostChanges = 1U << 22;
constexpr std::size_t kBacktracksPerCell = 50, kFreeBacktracks = 100'000;

constexpr int kStepX[kSides] = {0, -1, 0, 1}, kStepY[kSides] = {1, 0, -1, 0};
int opposite(int side) { return (side + 2) % kSides; }

class Arranger {
 public:
  Arranger(const TileSet& set, const TileGridRequest& request) : set_(set), request_(request) {
    for (std::size_t i = 0; i < set.turned.size(); ++i) {
      all_.insert(i);
      for (int side = 0; side < kSides; ++side) with_label_[side][set.turned[i].sides[side]].insert(i);
    }
    domains_.assign(static_cast<std::size_t>(request.columns) * request.rows, all_);
  }

  bool fix_cells(double share) {
    // arcs are made consistent first: a set may exclude tiles everywhere
    for (std::uint32_t cell = 0; cell < domains_.size(); ++cell) changed_.push_back(cell);
    if (!propagate()) return false;
    for (std::uint32_t cell = 0; cell < domains_.size(); ++cell)
      if (unit_of(cell, 1) < share) fix(cell);
    changes_.clear();
    return true;
  }

  /// False if there is no arrangement, or none was found in time.
  bool fill() {
    const std::size_t limit = kFreeBacktracks + kBacktracksPerCell * domains_.size();
    for (std::uint32_t next = 0;;) {
      std::uint32_t cell = most_constrained();
      if (cell == kNoCell) {
        while (next < domains_.size() && domains_[next].count() == 1) ++next;
        if (next == domains_.size()) return true;
        cell = next;
      }
      const std::size_t chosen = draw(cell);
      decisions_.push_back({cell, static_cast<std::uint8_t>(chosen), changes_.size()});
      if (!restrict_to(cell, chosen) && !take_back()) return false;
      if (grid_.backtracks > limit) return false;
      // cells before `next` may have been taken back
      if (was_taken_back_) next = 0, was_taken_back_ = false;
      forget_old_changes();
    }
  }

  TileGrid take() {
    grid_.columns = request_.columns, grid_.rows = request_.rows;
    for (const TileBits& domain : domains_) grid_.tiles.push_back(first_of(domain));
    return std::move(grid_);
  }

 private:
  static constexpr std::uint32_t kNoCell = 0xffffffff;
  struct Change {
    std::uint32_t cell;
    TileBits before;
  };
  struct Decision {
    std::uint32_t cell;
    std::uint8_t tile;
    std::size_t changes;
  };
  struct Constrained {
    std::uint32_t count_and_order, cell;
    auto operator<=>(const Constrained&) const = default;
  };

  static std::uint8_t first_of(const TileBits& domain) {
    return static_cast<std::uint8_t>(domain.words[0] != 0 ? std::countr_zero(domain.words[0])
                                                          : 64 + std::countr_zero(domain.words[1]));
  }

  int column(std::uint32_t cell) const { return static_cast<int>(cell % request_.columns); }
  int row(std::uint32_t cell) const { return static_cast<int>(cell / request_.columns); }
  double noise(std::uint32_t cell) const {
    return fractal_noise(Vec2{column(cell) + 0.5, row(cell) + 0.5} * (1 / request_.noise_cells), 2, request_.seed);
  }
  /// A number from 0 to 1 for a cell and a purpose.
  double unit_of(std::uint32_t cell, std::uint64_t purpose) const {
    return static_cast<double>(hash_of(cell, static_cast<std::int64_t>(purpose), request_.seed) >> 11) * 0x1p-53;
  }

  void fix(std::uint32_t cell) {
    const std::size_t mark = changes_.size();
    if (restrict_to(cell, draw(cell))) {
      ++grid_.fixed;
      return;
    }
    undo_to(mark);
    ++grid_.not_fixed;
  }

  std::size_t draw(std::uint32_t cell) {
    const double value = noise(cell);
    std::array<double, kMostTurned> weights{};
    double sum = 0;
    for (std::size_t i = 0; i < set_.turned.size(); ++i) {
      if (!domains_[cell].holds(i)) continue;
      const Tile& tile = set_.tiles[set_.turned[i].tile];
      const bool is_in_range = tile.low_noise <= value && value <= tile.high_noise;
      sum += weights[i] = tile.weight / tile.turns * (is_in_range ? kInRange : 1);
    }
    double left = unit_of(cell, 2 + draws_++) * sum;
    std::size_t chosen = first_of(domains_[cell]);
    for (std::size_t i = 0; i < set_.turned.size(); ++i) {
      if (weights[i] == 0) continue;
      chosen = i;
      left -= weights[i];
      if (left < 0) break;
    }
    return chosen;
  }

  bool restrict_to(std::uint32_t cell, std::size_t tile) {
    TileBits one;
    one.insert(tile);
    set_domain(cell, one);
    return propagate();
  }

  void set_domain(std::uint32_t cell, const TileBits& domain) {
    changes_.push_back({cell, domains_[cell]});
    domains_[cell] = domain;
    changed_.push_back(cell);
    offer(cell);
  }

  void offer(std::uint32_t cell) {
    const int count = domains_[cell].count();
    if (count > 1)
      constrained_.push({static_cast<std::uint32_t>(count) << 24 |
                             static_cast<std::uint32_t>(hash_of(cell, 0, request_.seed) & 0xffffff),
                         cell});
  }

  /// Removes tiles without a possible neighbour until nothing changes; false if a cell has none left.
  bool propagate() {
    bool is_possible = true;
    for (std::size_t at = 0; at < changed_.size() && is_possible; ++at) {
      const std::uint32_t cell = changed_[at];
      for (int side = 0; side < kSides && is_possible; ++side) is_possible = propagate_to(cell, side);
    }
    changed_.clear();
    return is_possible;
  }

  bool propagate_to(std::uint32_t cell, int side) {
    const int x = column(cell) + kStepX[side], y = row(cell) + kStepY[side];
    if (x < 0 || y < 0 || x >= request_.columns || y >= request_.rows) return true;
    const auto neighbour = static_cast<std::uint32_t>(y * request_.columns + x);
    TileBits possible;
    for (std::size_t label = 0; label < set_.labels.size(); ++label)
      if (!is_empty(domains_[cell] & with_label_[side][label]))
        possible = possible | with_label_[opposite(side)][label];
    const TileBits left = domains_[neighbour] & possible;
    if (left == domains_[neighbour]) return true;
    set_domain(neighbour, left);
    return !is_empty(left);
  }

  /// Takes decisions back until the cells are consistent again. False if none is left.
  bool take_back() {
    was_taken_back_ = true;
    while (true) {
      ++grid_.contradictions;
      pressure_ += 1;
      // one decision, and twice as many after each further eight contradictions without progress
      std::size_t count = std::size_t{1} << std::min(static_cast<int>(pressure_ / 8), 14);
      if (decisions_.empty()) return false;
      Decision last{};
      const bool is_single = count == 1;
      for (; count > 0 && !decisions_.empty(); --count) {
        last = decisions_.back();
        decisions_.pop_back();
        ++grid_.backtracks;
      }
      undo_to(last.changes);
      // several decisions are drawn anew; a single one is known to be wrong
      if (!is_single) return true;
      TileBits rest = domains_[last.cell];
      rest.erase(last.tile);
      set_domain(last.cell, rest);
      if (!is_empty(rest) && propagate()) return true;
      changed_.clear();
    }
  }

  void undo_to(std::size_t mark) {
    while (changes_.size() > mark) {
      domains_[changes_.back().cell] = changes_.back().before;
      offer(changes_.back().cell);
      changes_.pop_back();
    }
  }

  /// The cell with the fewest possible tiles among those with fewer than at first.
  std::uint32_t most_constrained() {
    pressure_ = std::max(0.0, pressure_ - 0.25);
    while (!constrained_.empty()) {
      const Constrained top = constrained_.top();
      constrained_.pop();
      const int count = domains_[top.cell].count();
      if (count > 1 && static_cast<std::uint32_t>(count) == top.count_and_order >> 24) return top.cell;
    }
    return kNoCell;
  }

  void forget_old_changes() {
    if (changes_.size() < kMostChanges || decisions_.size() < 2) return;
    const std::size_t kept = decisions_.size() / 2, first = decisions_[kept].changes;
    changes_.erase(changes_.begin(), changes_.begin() + static_cast<std::ptrdiff_t>(first));
    decisions_.erase(decisions_.begin(), decisions_.begin() + static_cast<std::ptrdiff_t>(kept));
    for (Decision& decision : decisions_) decision.changes -= first;
  }

  const TileSet& set_;
  const TileGridRequest& request_;
  TileBits all_;
  std::array<std::array<TileBits, kMostLabels>, kSides> with_label_{};
  std::vector<TileBits> domains_;
  std::vector<std::uint32_t> changed_;
  std::vector<Change> changes_;
  std::vector<Decision> decisions_;
  std::priority_queue<Constrained, std::vector<Constrained>, std::greater<>> constrained_;
  std::uint64_t draws_ = 0;
  double pressure_ = 0;
  bool was_taken_back_ = false;
  TileGrid grid_;
};

}  // namespace

Result<TileGrid> arrange_tiles(const TileSet& set, const TileGridRequest& request) {
  std::size_t contradictions = 0, backtracks = 0;
  // cells that were fixed may exclude each other from afar: then fewer are
  for (const double part : {1.0, 0.5, 0.0}) {
    Arranger arranger(set, request);
    if (!arranger.fix_cells(request.fixed_share * part)) break;
    const bool is_filled = arranger.fill();
    TileGrid grid = arranger.take();
    contradictions += grid.contradictions, backtracks += grid.backtracks;
    grid.contradictions = contradictions, grid.backtracks = backtracks;
    if (is_filled) return grid;
  }
  return Error{"", fmt::format("no arrangement of {} x {} tiles was found; {} contradictions, {} decisions taken back",
                               request.columns, request.rows, contradictions, backtracks)};
}

}  // namespace citykiln::invent
