#include "grammars/roofs/expected_rise.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_input.h"
#include "grammars/roofs/strips.h"

namespace citykiln::roofs {
namespace {

bool is_strip(RoofForm form) { return form_row(form).method == Method::kStrips || form == RoofForm::kCrossGabled; }

// The width of the rectangle with the area and perimeter of the footprint; of a square if there is none.
double equivalent_width_m(const Polygon& footprint) {
  const Ring& ring = footprint.outer;
  const double half = (length_m(ring) + distance(ring.back(), ring.front())) / 2, area = std::abs(area_m2(footprint));
  return (half - std::sqrt(std::max(0.0, half * half - 4 * area))) / 2;
}

}  // namespace

double expected_rise_m(const Polygon& footprint, const RoofShape& shape) {
  assert(shape.form < RoofForm::kCount);
  if (shape.form == RoofForm::kFlat || footprint.outer.size() < 3) return 0;
  if (!is_strip(shape.form)) return rise_of(shape, equivalent_width_m(footprint) / 2);
  const OrientedBox box = oriented_box(footprint.outer, shape.direction, shape.is_ridge_across);
  return rise_of(shape, strip_span_m(shape.form, box, shape.direction.has_value()));
}

}  // namespace citykiln::roofs
