// Made input that breaks textbook methods, and what two methods make of a case.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln::charts {

/// The random numbers of a case.
class HardDraw {
 public:
  explicit HardDraw(std::uint64_t seed) : draw_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(draw_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(draw_); }
  /// A number whose logarithm is even between those of two numbers.
  double of_any_size(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

 private:
  std::mt19937_64 draw_;
};

/// Results of both methods on a case: true if the result is right.
struct Judged {
  bool textbook = false, ours = false;
};

/// A ring around a place, with a share of hard corners: repeated points, points on edges, needles of one step of the
/// grid.
Ring hard_ring(HardDraw& draw, Vec2 middle);

/// A method with its textbook form and the input that breaks it.
struct HardMethod {
  const char* name;
  const char* textbook;
  const char* ours;
  Judged (*judge)(HardDraw& draw);
  int cases;
};

/// Tests samples of one lamp of many: at most 64, at least 3 m high, some at one place, with fluxes over seven orders
/// of magnitude. A case fails if one sample has a standard deviation over three times the light, or if a lamp that
/// lights the place has no chance.
Judged judge_lights(HardDraw& draw);
/// Tests the same with a tenth of the lamps within 0.18 m of the lit place.
Judged judge_near_lights(HardDraw& draw);
/// Tests turtles after up to 2^20 equal turns and steps against the closed form of a repeated rotation. A case fails if
/// the end is farther from it than a millionth of the way walked.
Judged judge_turtle(HardDraw& draw);
/// Tests L-systems that grow without end or divide by nearly 0. A case fails if a length is not finite, or if the
/// string exceeds the memory of 2^31 modules.
Judged judge_growth(HardDraw& draw);
/// Tests splits of lots whose frontage is one edge or two. A case fails if a part has less than 0.4 times the usual
/// frontage, or if the parts do not have the lot's area.
Judged judge_lots(HardDraw& draw);
/// Tests terrain meshes of 16 by 16 samples with spikes and ridges of one sample. A case fails if a sample is farther
/// from the mesh than the tolerance, or if a triangle has no area.
Judged judge_refinement(HardDraw& draw);
/// Tests hipped roofs on crosses, combs and regular polygons, where many events of the skeleton coincide, and on
/// hard_ring(). A case fails if the roof is missing or flat, does not cover the footprint in plan, or rises to 64 m.
Judged judge_symmetric_roof(HardDraw& draw);

}  // namespace citykiln::charts
