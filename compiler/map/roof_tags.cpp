#include "compiler/map/roof_tags.h"

#include <optional>

#include "compiler/geometry/trig.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

constexpr double kHighest_m = 1000, kSteepest_deg = 85, kMostLevels = 50;

// Values of roof:shape that ask for nothing that could be built, or for what each mapper means otherwise.
constexpr std::string_view kUntold[] = {"yes", "no", "many", "unknown", "other"};

std::optional<double> number_within(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                    double most) {
  const std::string_view text = context.tag(tags, key);
  if (text.empty()) return std::nullopt;
  const auto number = number_of(text.substr(0, text.find("\xc2\xb0")));
  if (number && *number >= 0 && *number <= most) return number;
  context.report.add(Code::kBadTagValue, id);
  return std::nullopt;
}

std::optional<Vec2> tagged_direction(const ReadContext& context, OsmId id, source::Range tags) {
  const std::string_view text = context.tag(tags, "roof:direction");
  if (text.empty()) return std::nullopt;
  const auto bearing_deg = bearing_deg_of(text);
  if (bearing_deg) return direction_of((90 - *bearing_deg) / 360);
  context.report.add(Code::kBadTagValue, id);
  return std::nullopt;
}

std::optional<roofs::Form> tagged_form(const ReadContext& context, OsmId id, source::Range tags) {
  const std::string_view text = context.tag(tags, "roof:shape");
  for (const std::string_view untold : kUntold)
    if (text == untold) return std::nullopt;
  if (text.empty()) return std::nullopt;
  const auto form = roofs::form_named(text);
  if (!form) context.report.add(Code::kBadTagValue, id);
  return form;
}

double tagged_height_m(const ReadContext& context, OsmId id, source::Range tags, double level_m) {
  if (const auto height_m = tagged_length_m(context, id, tags, "roof:height", 0, kHighest_m)) return *height_m;
  return level_m * number_within(context, id, tags, "roof:levels", kMostLevels).value_or(0);
}

}  // namespace

TaggedRoof tagged_roof(const ReadContext& context, OsmId id, source::Range tags, double level_m) {
  const auto form = tagged_form(context, id, tags);
  TaggedRoof roof{form.has_value(), {form.value_or(roofs::Form::kFlat)}};
  roof.shape.height_m = tagged_height_m(context, id, tags, level_m);
  roof.shape.angle_deg = number_within(context, id, tags, "roof:angle", kSteepest_deg).value_or(0);
  roof.shape.direction = tagged_direction(context, id, tags);
  roof.shape.is_ridge_across = context.tag(tags, "roof:orientation") == "across";
  return roof;
}

}  // namespace citykiln::map
