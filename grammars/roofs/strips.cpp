#include "grammars/roofs/strips.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "grammars/roofs/section.h"

namespace citykiln::roofs {
namespace {

// The approximate widths of bays: of halls with northlights, and of houses in a row.
constexpr double kSawBay_m = 6, kGableBay_m = 8;
// The ridge of a saltbox, and the end of the first slope of a double one: shares of the width from the back.
constexpr double kSaltboxRidge = 0.68, kDoubleSaltboxSlope = 0.3;

bool is_row(RoofForm form) { return form == RoofForm::kSawtooth || form == RoofForm::kGabledRow; }

// The axis along which strips follow each other: across the box, or along it for rows. From 0 at the back.
struct StripAxis {
  Vec2 origin, along;
  double length_m;
};

StripAxis axis_of(RoofForm form, const OrientedBox& box, bool has_direction) {
  if (is_row(form) && !has_direction) return {box.position(box.from_m, box.back_m), box.along, box.length_m()};
  return {box.position(box.from_m, box.back_m), box.across, box.width_m()};
}

double bays_of(RoofForm form, double length_m) {
  return std::max(2.0, std::floor(length_m / (form == RoofForm::kSawtooth ? kSawBay_m : kGableBay_m) + 0.5));
}

// A section and its mirror image, from the back over the ridge to the front.
Section mirrored(const Section& half) {
  Section whole = half;
  for (Vec2& corner : whole.corners) corner.x /= 2;
  for (std::size_t i = half.corners.size() - 1; i-- > 0;)
    whole.corners.push_back({1 - half.corners[i].x / 2, half.corners[i].y});
  return whole;
}

Section row_of_gables(double bays) {
  Section section{{{0, 0}}, 0};
  for (double i = 0; i < bays; ++i) {
    section.corners.push_back({(i + 0.5) / bays, 1});
    section.corners.push_back({(i + 1) / bays, 0});
  }
  return section;
}

// Teeth rise along the axis and end vertically: two corners at one position.
Section row_of_teeth(double bays) {
  Section section;
  for (double i = 0; i < bays; ++i) {
    section.corners.push_back({i / bays, 0});
    section.corners.push_back({(i + 1) / bays, 1});
  }
  return section;
}

Section section_across(RoofForm form, double run_m, double rise_m, double tolerance_m) {
  switch (form) {
    case RoofForm::kSkillion:
      return {{{0, 1}, {1, 0}}, 0};
    case RoofForm::kSaltbox:
      return {{{0, 0}, {kSaltboxRidge, 1}, {1, 0}}, 0};
    case RoofForm::kDoubleSaltbox:
      return {{{0, 0}, {kDoubleSaltboxSlope, 1}, {1 - kDoubleSaltboxSlope, 1}, {1, 0}}, 0};
    case RoofForm::kGabledRow:
      return row_of_gables(bays_of(form, run_m));
    case RoofForm::kSawtooth:
      return row_of_teeth(bays_of(form, run_m));
    default:
      return mirrored(section_along(form, run_m / 2, rise_m, tolerance_m));
  }
}

Facet strip(const StripAxis& axis, Vec2 low, Vec2 high, double rise_m, double from_m, double to_m, double half_m) {
  const double slope = rise_m * (high.y - low.y) / ((high.x - low.x) * axis.length_m);
  const auto position = [&](double along_m, double aside_m) {
    return axis.origin + axis.along * along_m + left_of(axis.along) * aside_m;
  };
  return {
      .ring = {position(from_m, -half_m), position(to_m, -half_m), position(to_m, half_m), position(from_m, half_m)},
      .plane = {position(low.x * axis.length_m, 0), axis.along * slope, low.y * rise_m}};
}

std::vector<Facet> facets_along(const StripAxis& axis, const Section& section, double rise_m, double reach_m,
                                double half_m) {
  std::vector<Facet> facets;
  for (std::size_t k = 0; k + 1 < section.corners.size(); ++k) {
    const Vec2 low = section.corners[k], high = section.corners[k + 1];
    if (high.x <= low.x) continue;
    const double from_m = k == 0 ? -reach_m : low.x * axis.length_m;
    const double to_m = k + 2 == section.corners.size() ? axis.length_m + reach_m : high.x * axis.length_m;
    facets.push_back(strip(axis, low, high, rise_m, from_m, to_m, half_m));
    facets.back().face = static_cast<std::uint32_t>(facets.size()) - 1;
  }
  return facets;
}

// Two gabled roofs of equal width: the parts of each that are higher than the other.
std::vector<Facet> crossing(const OrientedBox& box, double rise_m, double reach_m) {
  const double half_m = std::min(box.width_m(), box.length_m()) / 2;
  const double slope = rise_m / half_m, far_m = box.width_m() + box.length_m() + reach_m;
  const Vec2 middle = box.position((box.from_m + box.to_m) / 2, (box.back_m + box.front_m) / 2);
  std::vector<Facet> facets;
  for (const Vec2 ridge : {box.along, box.across, box.along * -1, box.across * -1})
    for (const double side : {1.0, -1.0}) {
      // half an arm, to the left or right of its ridge
      const Vec2 aside = left_of(ridge) * side, end = middle + ridge * far_m, corner = end + aside * far_m;
      Ring ring = side > 0 ? Ring{middle, end, corner} : Ring{middle, corner, end};
      facets.push_back({.ring = std::move(ring),
                        .plane = {middle, aside * -slope, rise_m},
                        .face = static_cast<std::uint32_t>(facets.size())});
    }
  return facets;
}

}  // namespace

double strip_span_m(RoofForm form, const OrientedBox& box, bool has_direction) {
  const double run_m = axis_of(form, box, has_direction).length_m;
  if (form == RoofForm::kSkillion) return run_m;
  if (form == RoofForm::kSawtooth) return run_m / bays_of(form, run_m);
  if (form == RoofForm::kGabledRow) return run_m / bays_of(form, run_m) / 2;
  if (form == RoofForm::kDoubleSaltbox) return run_m * kDoubleSaltboxSlope;
  if (form == RoofForm::kCrossGabled) return std::min(box.width_m(), box.length_m()) / 2;
  return run_m / 2;
}

Strips strips(RoofForm form, const OrientedBox& box, bool has_direction, double rise_m, double reach_m,
              double tolerance_m) {
  assert(rise_m > 0 && reach_m > 0 && tolerance_m > 0);
  if (form == RoofForm::kCrossGabled) return {crossing(box, rise_m, reach_m), 0};
  const StripAxis axis = axis_of(form, box, has_direction);
  const Section section = section_across(form, axis.length_m, rise_m, tolerance_m);
  const double far_m = box.width_m() + box.length_m() + reach_m;
  Strips made{facets_along(axis, section, rise_m, reach_m, far_m), section.error_m};
  // between teeth there are walls, all other facets meet
  for (Facet& facet : made.facets) facet.surface = form == RoofForm::kSawtooth ? facet.face : 0;
  return made;
}

}  // namespace citykiln::roofs
