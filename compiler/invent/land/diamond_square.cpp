#include "compiler/invent/land/diamond_square.h"

#include "compiler/contract/random_sequence.h"

namespace citykiln::invent {
namespace {

class Displaced {
 public:
  Displaced(const DiamondSquare& settings, std::uint64_t seed)
      : count_((1 << settings.power) + 1),
        heights_(static_cast<std::size_t>(count_) * count_, 0.0),
        random_(seed, {}, "diamond_square") {
    for (const int row : {0, count_ - 1})
      for (const int column : {0, count_ - 1})
        at(column, row) = settings.initial_height_m + displacement(column, row, settings.corner_spread_m);
  }

  void displace_level(int side, double spread_m) {
    const int half = side / 2;
    for (int row = half; row < count_; row += side)
      for (int column = half; column < count_; column += side) set_middle(column, row, half, spread_m);
    for (int row = 0; row < count_; row += half)
      for (int column = (row + half) % side; column < count_; column += side) set_edge(column, row, half, spread_m);
  }

  int side() const { return count_ - 1; }
  std::vector<double> take() { return std::move(heights_); }

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * count_ + column; }
  double& at(int column, int row) { return heights_[index(column, row)]; }

  double displacement(int column, int row, double spread_m) const {
    return random_.between(-spread_m, spread_m, static_cast<std::uint32_t>(index(column, row)));
  }

  void set_middle(int column, int row, int half, double spread_m) {
    const double sum = at(column - half, row - half) + at(column + half, row - half) + at(column - half, row + half) +
                       at(column + half, row + half);
    at(column, row) = sum / 4 + displacement(column, row, spread_m);
  }

  void set_edge(int column, int row, int half, double spread_m) {
    double sum = 0;
    int beside = 0;
    constexpr int kBeside[4][2] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}};
    for (const auto& [i, j] : kBeside) {
      const int x = column + i * half, y = row + j * half;
      if (x >= 0 && y >= 0 && x < count_ && y < count_) sum += at(x, y), ++beside;
    }
    at(column, row) = sum / beside + displacement(column, row, spread_m);
  }

  int count_;
  std::vector<double> heights_;
  RandomSequence random_;
};

}  // namespace

std::vector<double> diamond_square(const DiamondSquare& settings, std::uint64_t seed) {
  Displaced lattice(settings, seed);
  double spread_m = settings.spread_m;
  for (int side = lattice.side(); side > 1; side /= 2, spread_m *= settings.reduction)
    lattice.displace_level(side, spread_m);
  return lattice.take();
}

}  // namespace citykiln::invent
