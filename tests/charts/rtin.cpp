#include "tests/charts/rtin.h"

#include <algorithm>
#include <cmath>

namespace citykiln::charts {
namespace {

struct SampleAt {
  int column = 0, row = 0;
};
SampleAt halfway(SampleAt a, SampleAt b) { return {(a.column + b.column) / 2, (a.row + b.row) / 2}; }

/// Triangles are (a, b, right angle c); their children are (c, a, middle) and (b, c, middle).
class RightTriangles {
 public:
  RightTriangles(const HeightSquare& square, const std::function<double(Vec2)>& tolerance_m)
      : square_(square), tolerance_m_(tolerance_m), ratios_(square.heights_m.size(), 0.0F) {
    // coarser middles need the final ratios of both triangles beside each finer edge
    for (depth_ = 2 * square.power - 1; depth_ >= 0; --depth_) for_both(&RightTriangles::visit_depth);
  }

  std::int64_t count() {
    for_both(&RightTriangles::count_below);
    return triangles_;
  }

 private:
  using Visit = void (RightTriangles::*)(SampleAt, SampleAt, SampleAt, int);

  void for_both(Visit visit) {
    const int last = square_.samples_per_side() - 1;
    (this->*visit)({0, 0}, {last, last}, {last, 0}, 0);
    (this->*visit)({last, last}, {0, 0}, {0, last}, 0);
  }

  float& ratio(SampleAt at) {
    return ratios_[static_cast<std::size_t>(at.row) * square_.samples_per_side() + at.column];
  }
  double height(SampleAt at) const { return square_.at(at.column, at.row); }

  void visit_depth(SampleAt a, SampleAt b, SampleAt c, int depth) {
    const SampleAt middle = halfway(a, b);
    if (depth < depth_) {
      visit_depth(c, a, middle, depth + 1);
      visit_depth(b, c, middle, depth + 1);
      return;
    }
    const double error_m = std::abs((height(a) + height(b)) / 2 - height(middle));
    const double allowed_m = tolerance_m_({static_cast<double>(middle.column), static_cast<double>(middle.row)});
    float largest = static_cast<float>(error_m / allowed_m);
    if (depth + 1 < 2 * square_.power) largest = std::max({largest, ratio(halfway(c, a)), ratio(halfway(b, c))});
    ratio(middle) = std::max(ratio(middle), largest);
  }

  void count_below(SampleAt a, SampleAt b, SampleAt c, int depth) {
    const SampleAt middle = halfway(a, b);
    if (depth == 2 * square_.power || ratio(middle) <= 1) {
      ++triangles_;
      return;
    }
    count_below(c, a, middle, depth + 1);
    count_below(b, c, middle, depth + 1);
  }

  const HeightSquare& square_;
  const std::function<double(Vec2)>& tolerance_m_;
  std::vector<float> ratios_;
  int depth_ = 0;
  std::int64_t triangles_ = 0;
};

}  // namespace

std::int64_t rtin_triangle_count(const HeightSquare& square, const std::function<double(Vec2)>& tolerance_m) {
  return RightTriangles(square, tolerance_m).count();
}

}  // namespace citykiln::charts
