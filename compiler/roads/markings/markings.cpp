#include "compiler/roads/markings/markings.h"

#include <algorithm>

#include "compiler/roads/markings/drainage.h"
#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

Marks paint_of(const MarkingLayout& layout) {
  Marks marks;
  if (layout.stretch == StretchKind::kZebra) {
    add_zebra(layout, marks);
    return marks;
  }
  if (layout.stretch == StretchKind::kCrossing) {
    add_crossing(layout, marks);
    return marks;
  }
  if (is_hump(layout.stretch)) {
    add_hump(layout, marks);
    return marks;
  }
  add_tints(layout, marks);
  add_hatching(layout, marks);
  add_bays(layout, marks);
  add_lane_lines(layout, marks);
  if (layout.stretch != StretchKind::kEnd) return marks;
  add_stop_lines(layout, marks);
  add_arrows(layout, marks);
  add_symbols(layout, marks);
  return marks;
}

// Clips lines to the strip: a lane may be narrower than the line at its side.
void keep_between(double low_m, double high_m, Marks& marks) {
  for (Mark& mark : marks)
    for (Vec2& p : mark.ring) p.x = std::clamp(p.x, low_m, high_m);
}

}  // namespace

Marks marks_of(const MarkingLayout& layout) {
  if (!(width_m(layout) > 0)) return {};
  if (layout.panel_m > 0) return layout.panel;
  if (layout.stretch == StretchKind::kStart)
    return turned_round(marks_of(turned_round(layout)), width_m(layout), length_m(layout));
  Marks marks;
  if (takes_paint(layout)) marks = paint_of(layout);
  if (length_m(layout) == kLayoutLength_m) add_rails(layout, marks);
  keep_between(0, width_m(layout), marks);
  return marks;
}

bool needs_column(const MarkingLayout& layout) { return !marks_of(layout).empty() || !drainage_of(layout).empty(); }

materials::TextureImage::Texel base_colour_of(const MarkingLayout& layout) {
  const bool is_level_crossing = layout.stretch == StretchKind::kLevelCrossing;
  const materials::Material material =
      is_level_crossing ? materials::Material::kAsphalt : map::values_of(layout.surface).material;
  materials::TextureImage::Texel colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] = materials::srgb_of_linear(materials::values_of(material).base_colour[i]);
  return colour;
}

}  // namespace citykiln::roads
