#include "compiler/invent/land/fill_pits.h"

#include <queue>
#include <utility>

namespace citykiln::invent {
namespace {

/// Visits points from the border inwards. A point higher than the one it was reached from drains to that one, whatever
/// the order; only points with lower ones behind them have to wait until their height is the lowest (Zhou et al. 2016).
class PitFilling {
 public:
  explicit PitFilling(Lattice& lattice) : lattice_(lattice), is_reached_(lattice.size(), false) {}

  void run() {
    for (std::size_t i = 0; i < lattice_.size(); ++i)
      if (lattice_.is_on_border(i)) waiting_.emplace(lattice_.heights_m[i], i), is_reached_[i] = true;
    while (!waiting_.empty()) {
      const std::size_t i = waiting_.top().second;
      waiting_.pop();
      reach_neighbours(i);
      while (!slope_.empty()) {
        const std::size_t up = slope_.back();
        slope_.pop_back();
        climb(up);
      }
    }
  }

 private:
  void reach_neighbours(std::size_t i) {
    lattice_.for_each_neighbour(i, [&, least_m = lattice_.heights_m[i] + kPitFall_m](std::size_t j, double) {
      if (is_reached_[j]) return;
      is_reached_[j] = true;
      if (lattice_.heights_m[j] >= least_m) return slope_.push_back(j);
      lattice_.heights_m[j] = least_m;
      waiting_.emplace(least_m, j);
    });
  }

  void climb(std::size_t i) {
    bool has_lower = false;
    lattice_.for_each_neighbour(i, [&, least_m = lattice_.heights_m[i] + kPitFall_m](std::size_t j, double) {
      if (is_reached_[j]) return;
      if (lattice_.heights_m[j] < least_m) {
        has_lower = true;
        return;
      }
      is_reached_[j] = true;
      slope_.push_back(j);
    });
    if (has_lower) waiting_.emplace(lattice_.heights_m[i], i);
  }

  // lowest first; equal heights in the order of points
  using Entry = std::pair<double, std::size_t>;
  Lattice& lattice_;
  std::vector<bool> is_reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
  std::vector<std::size_t> slope_;
};

}  // namespace

void fill_pits(Lattice& lattice) { PitFilling(lattice).run(); }

}  // namespace citykiln::invent
