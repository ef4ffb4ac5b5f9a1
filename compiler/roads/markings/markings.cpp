#include "compiler/roads/markings/markings.h"

#include <algorithm>

#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

Marks paint_of(const Pattern& pattern) {
  Marks marks;
  if (pattern.stretch == Stretch::kZebra) {
    add_zebra(pattern, marks);
    return marks;
  }
  if (pattern.stretch == Stretch::kCrossing) {
    add_crossing(pattern, marks);
    return marks;
  }
  add_tints(pattern, marks);
  add_hatching(pattern, marks);
  add_bays(pattern, marks);
  add_lane_lines(pattern, marks);
  if (pattern.stretch != Stretch::kEnd) return marks;
  add_stop_lines(pattern, marks);
  add_arrows(pattern, marks);
  add_symbols(pattern, marks);
  return marks;
}

// Lines about the sides of lanes that are narrower than the line are cut at the strip's sides.
void keep_between(double low_m, double high_m, Marks& marks) {
  for (Mark& mark : marks)
    for (Vec2& p : mark.ring) p.x = std::clamp(p.x, low_m, high_m);
}

}  // namespace

Marks marks_of(const Pattern& pattern) {
  if (!(width_m(pattern) > 0)) return {};
  if (pattern.stretch == Stretch::kStart)
    return turned_round(marks_of(turned_round(pattern)), width_m(pattern), length_m(pattern));
  Marks marks;
  if (takes_paint(pattern)) marks = paint_of(pattern);
  if (length_m(pattern) == kPatternLength_m) add_rails(pattern, marks);
  keep_between(0, width_m(pattern), marks);
  return marks;
}

bool is_marked(const Pattern& pattern) { return !marks_of(pattern).empty(); }

materials::Sheet::Texel base_colour_of(const Pattern& pattern) {
  const bool is_level_crossing = pattern.stretch == Stretch::kLevelCrossing;
  const materials::Material material =
      is_level_crossing ? materials::Material::kAsphalt : map::values_of(pattern.surface).material;
  materials::Sheet::Texel colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] = materials::srgb_of_linear(materials::values_of(material).base_colour[i]);
  return colour;
}

}  // namespace citykiln::roads
