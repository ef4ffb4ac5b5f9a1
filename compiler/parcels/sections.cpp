#include "compiler/parcels/sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace citykiln::parcels {
namespace {

// Appends the distances along a → b at which a coordinate passes a multiple of kSection_m.
void add_crossings(double a, double b, double length_m, std::vector<double>& places) {
  const auto [low, high] = std::minmax(a, b);
  for (double at = std::ceil(low / kSection_m) * kSection_m; at < high; at += kSection_m)
    if (at > low) places.push_back(length_m * (at - a) / (b - a));
}

// Cuts free spans where a frontage leaves a cell, except near a corner or a building's land.
void cut_spans(const Strips& strips, std::uint32_t f, double front_m, std::vector<Span>& spans) {
  const Frontage& frontage = strips.frontages[f];
  const double length = frontage.length_m();
  std::vector<double> places;
  add_crossings(frontage.a.x, frontage.b.x, length, places);
  add_crossings(frontage.a.y, frontage.b.y, length, places);
  std::ranges::sort(places);
  const bool goes_on = frontage.next != kNoIndex && !frontage.is_corner;
  const bool comes_from = frontage.previous != kNoIndex && !strips.frontages[frontage.previous].is_corner;
  std::vector<Span> cut;
  for (Span span : spans) {
    const double first = span.from_m > 0 || !comes_from ? span.from_m + front_m : 0;
    const double last = span.to_m < length || !goes_on ? span.to_m - front_m : length;
    for (const double at : places) {
      if (span.label != kRest || at <= std::max(first, span.from_m) || at >= last) continue;
      Span part = span;
      part.to_m = span.from_m = at;
      cut.push_back(part);
    }
    cut.push_back(span);
  }
  spans = std::move(cut);
}

}  // namespace

std::vector<LotSize> label_sections(const Strips& strips, const std::vector<LotSize>& sizes, std::uint32_t first_label,
                                    Fronts& fronts) {
  const auto size_at = [&](std::uint32_t f) {
    return sizes[std::min<std::size_t>(strips.frontages[f].size, sizes.size() - 1)];
  };
  for (std::uint32_t f = 0; f < fronts.size(); ++f) cut_spans(strips, f, size_at(f).front_m, fronts[f]);
  std::vector<LotSize> of_labels;
  const auto may_join = [&](std::uint32_t f, std::uint32_t next) {
    return next != kNoIndex && !strips.frontages[f].is_corner;
  };
  // labels run on along the street: begin where a section begins, then at what is left, which are loops
  for (const bool is_loop : {false, true})
    for (std::uint32_t f = 0; f < fronts.size(); ++f)
      for (std::size_t i = 0; i < fronts[f].size(); ++i) {
        if (fronts[f][i].label != kRest) continue;
        const std::uint32_t before = strips.frontages[f].previous;
        if (!is_loop && i == 0 && before != kNoIndex && may_join(before, f) &&
            (fronts[before].empty() || fronts[before].back().label == kRest))
          continue;
        const auto label = static_cast<std::uint32_t>(first_label + of_labels.size());
        of_labels.push_back(size_at(f));
        std::uint32_t at = f;
        for (std::size_t k = i;;) {
          if (!fronts[at].empty()) {
            if (fronts[at][k].label != kRest) break;
            fronts[at][k].label = label;
            if (k + 1 < fronts[at].size()) break;
          }
          const std::uint32_t next = strips.frontages[at].next;
          if (!may_join(at, next) || next == f) break;
          at = next, k = 0;
        }
      }
  return of_labels;
}

}  // namespace citykiln::parcels
