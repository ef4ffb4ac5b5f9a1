#include "compiler/map/buildings/roof_tags.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>

#include "compiler/geometry/trig.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

constexpr double kHighestRoof_m = 1000, kSteepest_deg = 85, kMostRoofLevels = 50;

// Values of roof:shape without a definite shape.
constexpr std::string_view kIndefinite[] = {"yes", "no", "many", "unknown", "other"};

std::optional<double> tagged_number(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                    double most) {
  const std::string_view text = context.tag(tags, key);
  return number_within(context, id, key, text.substr(0, text.find("\xc2\xb0")), 0, most);
}

std::optional<Vec2> tagged_direction(const ReadContext& context, OsmId id, source::Range tags) {
  const auto bearing_deg = parsed_tag(context, id, tags, "roof:direction", bearing_deg_of);
  return bearing_deg ? std::optional(direction_of((90 - *bearing_deg) / 360)) : std::nullopt;
}

std::optional<roofs::Form> tagged_form(const ReadContext& context, OsmId id, source::Range tags) {
  const std::string_view text = context.tag(tags, "roof:shape");
  if (std::ranges::find(kIndefinite, text) != std::end(kIndefinite)) return std::nullopt;
  return parsed_text(context, id, "roof:shape", text, roofs::form_named);
}

double tagged_roof_height_m(const ReadContext& context, OsmId id, source::Range tags, double level_m) {
  if (const auto height_m = tagged_length_m(context, id, tags, "roof:height", 0, kHighestRoof_m)) return *height_m;
  return level_m * tagged_number(context, id, tags, "roof:levels", kMostRoofLevels).value_or(0);
}

}  // namespace

TaggedRoof tagged_roof(const ReadContext& context, OsmId id, source::Range tags, double level_m) {
  assert(level_m > 0);
  const auto form = tagged_form(context, id, tags);
  TaggedRoof roof{form.has_value(), {form.value_or(roofs::Form::kFlat)}};
  roof.shape.height_m = tagged_roof_height_m(context, id, tags, level_m);
  roof.shape.angle_deg = tagged_number(context, id, tags, "roof:angle", kSteepest_deg).value_or(0);
  roof.shape.direction = tagged_direction(context, id, tags);
  roof.shape.is_ridge_across = context.tag(tags, "roof:orientation") == "across";
  return roof;
}

}  // namespace citykiln::map
