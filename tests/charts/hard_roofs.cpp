// Hipped roofs on footprints where many events of the straight skeleton coincide.
#include <algorithm>

#include "compiler/geometry/snap.h"
#include "grammars/roofs/generate_roof.h"
#include "tests/charts/hard_cases.h"

namespace citykiln::charts {
namespace {

// A comb: teeth and gaps of one width, so that all teeth end at once.
Ring comb(HardDraw& draw) {
  const int teeth = draw.whole(1, 5);
  const double width = draw.between(2, 6), depth = width * draw.whole(1, 3);
  Ring ring{{0, 0}, {(2 * teeth - 1) * width, 0}};
  for (int i = teeth; i-- > 0;) {
    const double left = 2 * i * width;
    ring.push_back({left + width, width + depth}), ring.push_back({left, width + depth});
    if (i > 0) ring.push_back({left, width}), ring.push_back({left - width, width});
  }
  return ring;
}

Ring cross_of_equal_arms(HardDraw& draw) {
  const double half = draw.between(2, 5), arm = half * draw.whole(2, 4);
  return {{-half, -arm}, {half, -arm}, {half, -half}, {arm, -half}, {arm, half},   {half, half},
          {half, arm},   {-half, arm}, {-half, half}, {-arm, half}, {-arm, -half}, {-half, -half}};
}

Ring regular(HardDraw& draw) {
  const int corners = draw.whole(3, 24);
  const double radius = draw.between(4, 20);
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back({radius * std::cos(6.283185307 * i / corners), radius * std::sin(6.283185307 * i / corners)});
  return ring;
}

// Written on the grid of footprints, parallel to the axes or turned by any angle.
Ring turned(const Ring& ring, double angle, Vec2 middle) {
  const Vec2 along{std::cos(angle), std::sin(angle)};
  Ring out;
  for (const Vec2 p : ring) out.push_back(snapped(middle + along * p.x + left_of(along) * p.y));
  return without_repeats(out);
}

Ring hard_footprint(HardDraw& draw) {
  const int kind = draw.whole(0, 3);
  if (kind == 3) return without_repeats(hard_ring(draw, {}));
  const Ring ring = kind == 0 ? comb(draw) : kind == 1 ? cross_of_equal_arms(draw) : regular(draw);
  const double angle = draw.whole(0, 1) * draw.between(0, 6.28);
  return turned(ring, angle, {draw.between(-5000, 5000), draw.between(-5000, 5000)});
}

double plan_m2(const roofs::Roof& roof) {
  double sum = 0;
  for (std::size_t i = 0; i < roof.triangles.size(); ++i) {
    if (roof.parts[i] != roofs::RoofPart::kRoof) continue;
    const auto [a, b, c] = roof.triangles[i];
    const auto at = [&](std::uint32_t v) { return Vec2{roof.positions[v].x, roof.positions[v].y}; };
    sum += twice_area(at(a), at(b), at(c)) / 2;
  }
  return sum;
}

}  // namespace

Judged judge_symmetric_roof(HardDraw& draw) {
  const Polygon footprint{hard_footprint(draw), {}};
  const double wanted = signed_area_m2(footprint.outer), border = length_m(footprint.outer);
  roofs::RoofShape shape;
  shape.form = roofs::RoofForm::kHipped;
  const auto is_right = [&](const roofs::Roof& roof) {
    const double off = std::abs(plan_m2(roof) - wanted);
    // 64 m: more than the half width of any footprint here
    return off <= 1e-3 * wanted + 4 * kQuantum_m * border && roof.height_m > 0 && roof.height_m < 64;
  };
  Report report;
  const roofs::Roof roof = roofs::generate_roof(footprint, shape, 0.02, {}, report);
  const auto textbook = roofs::roof_by_skeleton(footprint, shape, 0.02, SkeletonKernel::kInexact);
  return {textbook && is_right(*textbook), report.diagnoses().empty() && is_right(roof)};
}

}  // namespace citykiln::charts
