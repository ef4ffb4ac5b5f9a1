#include "grammars/roofs/expected_rise.h"

#include <algorithm>
#include <cmath>

#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_input.h"
#include "grammars/roofs/strips.h"

namespace citykiln::roofs {
namespace {

bool is_strip(Form form) {
  switch (form) {
    case Form::kSkillion:
    case Form::kSaltbox:
    case Form::kDoubleSaltbox:
    case Form::kSawtooth:
    case Form::kGabledRow:
    case Form::kCrossGabled:
      return true;
    default:
      return false;
  }
}

// Of the rectangle with this area and perimeter; of what is rounder than a square, the square's.
double equivalent_width_m(const Polygon& footprint) {
  const Ring& ring = footprint.outer;
  const double half = (length_m(ring) + distance(ring.back(), ring.front())) / 2, area = std::abs(area_m2(footprint));
  return (half - std::sqrt(std::max(0.0, half * half - 4 * area))) / 2;
}

}  // namespace

double expected_rise_m(const Polygon& footprint, const RoofShape& shape) {
  if (shape.form == Form::kFlat || footprint.outer.size() < 3) return 0;
  if (!is_strip(shape.form)) return rise_of(shape, equivalent_width_m(footprint) / 2);
  const OrientedBox frame = frame_of(footprint.outer, shape.direction, shape.is_ridge_across);
  return rise_of(shape, strip_span_m(shape.form, frame, shape.direction.has_value()));
}

}  // namespace citykiln::roofs
