#include "grammars/roofs/strips.h"

#include <algorithm>
#include <cmath>

#include "grammars/roofs/section.h"

namespace citykiln::roofs {
namespace {

// A row's bays are about as wide as these: halls with northlights, houses in a row.
constexpr double kSawBay_m = 6, kGableBay_m = 8;
// A saltbox has its ridge near the front; a double one is level between its slopes. Shares of the width from the back.
constexpr double kSaltboxRidge = 0.68, kDoubleSaltboxSlope = 0.3;

bool is_row(Form form) { return form == Form::kSawtooth || form == Form::kGabledRow; }

// What strips follow each other along: across the frame, or, of a row, along it. From 0 at the back.
struct Run {
  Vec2 origin, along;
  double length_m;
};

Run run_of(Form form, const OrientedBox& frame, bool has_direction) {
  if (is_row(form) && !has_direction) return {frame.place(frame.from_m, frame.back_m), frame.along, frame.length_m()};
  return {frame.place(frame.from_m, frame.back_m), frame.across, frame.width_m()};
}

double bays_of(Form form, double length_m) {
  return std::max(2.0, std::floor(length_m / (form == Form::kSawtooth ? kSawBay_m : kGableBay_m) + 0.5));
}

// A section and its mirror image: from the back over the ridge to the front.
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

// Teeth rise along the run and end upright: two corners in one place.
Section row_of_teeth(double bays) {
  Section section;
  for (double i = 0; i < bays; ++i) {
    section.corners.push_back({i / bays, 0});
    section.corners.push_back({(i + 1) / bays, 1});
  }
  return section;
}

Section section_across(Form form, double run_m, double rise_m, double tolerance_m) {
  switch (form) {
    case Form::kSkillion:
      return {{{0, 1}, {1, 0}}, 0};
    case Form::kSaltbox:
      return {{{0, 0}, {kSaltboxRidge, 1}, {1, 0}}, 0};
    case Form::kDoubleSaltbox:
      return {{{0, 0}, {kDoubleSaltboxSlope, 1}, {1 - kDoubleSaltboxSlope, 1}, {1, 0}}, 0};
    case Form::kGabledRow:
      return row_of_gables(bays_of(form, run_m));
    case Form::kSawtooth:
      return row_of_teeth(bays_of(form, run_m));
    default:
      return mirrored(section_along(form, run_m / 2, rise_m, tolerance_m));
  }
}

Facet strip(const Run& run, Vec2 low, Vec2 high, double rise_m, double from_m, double to_m, double half_m) {
  const double slope = rise_m * (high.y - low.y) / ((high.x - low.x) * run.length_m);
  const auto place = [&](double along_m, double aside_m) {
    return run.origin + run.along * along_m + left_of(run.along) * aside_m;
  };
  return {{place(from_m, -half_m), place(to_m, -half_m), place(to_m, half_m), place(from_m, half_m)},
          {place(low.x * run.length_m, 0), run.along * slope, low.y * rise_m},
          0,
          0};
}

std::vector<Facet> facets_along(const Run& run, const Section& section, double rise_m, double reach_m, double half_m) {
  std::vector<Facet> facets;
  for (std::size_t k = 0; k + 1 < section.corners.size(); ++k) {
    const Vec2 low = section.corners[k], high = section.corners[k + 1];
    if (high.x <= low.x) continue;
    const double from_m = k == 0 ? -reach_m : low.x * run.length_m;
    const double to_m = k + 2 == section.corners.size() ? run.length_m + reach_m : high.x * run.length_m;
    facets.push_back(strip(run, low, high, rise_m, from_m, to_m, half_m));
    facets.back().face = static_cast<std::uint32_t>(facets.size()) - 1;
  }
  return facets;
}

// Two gabled roofs of one width: each side of each, where it is higher than the other roof.
std::vector<Facet> crossing(const OrientedBox& frame, double rise_m, double reach_m) {
  const double half_m = std::min(frame.width_m(), frame.length_m()) / 2;
  const double slope = rise_m / half_m, far_m = frame.width_m() + frame.length_m() + reach_m;
  const Vec2 middle = frame.place((frame.from_m + frame.to_m) / 2, (frame.back_m + frame.front_m) / 2);
  std::vector<Facet> facets;
  for (const Vec2 ridge : {frame.along, frame.across, frame.along * -1, frame.across * -1})
    for (const double side : {1.0, -1.0}) {
      // the half arm that the ridge runs out along, to its left or right
      const Vec2 aside = left_of(ridge) * side, end = middle + ridge * far_m, corner = end + aside * far_m;
      Ring ring = side > 0 ? Ring{middle, end, corner} : Ring{middle, corner, end};
      facets.push_back(
          {std::move(ring), {middle, aside * -slope, rise_m}, 0, static_cast<std::uint32_t>(facets.size())});
    }
  return facets;
}

}  // namespace

double strip_span_m(Form form, const OrientedBox& frame, bool has_direction) {
  const double run_m = run_of(form, frame, has_direction).length_m;
  if (form == Form::kSkillion) return run_m;
  if (form == Form::kSawtooth) return run_m / bays_of(form, run_m);
  if (form == Form::kGabledRow) return run_m / bays_of(form, run_m) / 2;
  if (form == Form::kDoubleSaltbox) return run_m * kDoubleSaltboxSlope;
  if (form == Form::kCrossGabled) return std::min(frame.width_m(), frame.length_m()) / 2;
  return run_m / 2;
}

Strips strips(Form form, const OrientedBox& frame, bool has_direction, double rise_m, double reach_m,
              double tolerance_m) {
  if (form == Form::kCrossGabled) return {crossing(frame, rise_m, reach_m), 0};
  const Run run = run_of(form, frame, has_direction);
  const Section section = section_across(form, run.length_m, rise_m, tolerance_m);
  const double far_m = frame.width_m() + frame.length_m() + reach_m;
  Strips made{facets_along(run, section, rise_m, reach_m, far_m), section.error_m};
  // teeth step down to each other, all else hangs together
  for (Facet& facet : made.facets) facet.sheet = form == Form::kSawtooth ? facet.face : 0;
  return made;
}

}  // namespace citykiln::roofs
