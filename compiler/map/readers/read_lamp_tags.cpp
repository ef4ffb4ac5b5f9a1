#include "compiler/map/readers/read_lamp_tags.h"

#include <iterator>

#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

constexpr LampTypeValues kTypeValues[] = {
#define LAMP_TYPE(name, temperature_k, most_lm) {temperature_k, most_lm},
#include "compiler/map/lamps/lamp_types.inc"
#undef LAMP_TYPE
};
static_assert(std::size(kTypeValues) == static_cast<std::size_t>(LampType::kCount));

struct TypeRow {
  std::string_view value;
  LampType type;
};
constexpr TypeRow kTypes[] = {
#define TYPE(value, type) {value, LampType::type},
#include "compiler/map/lamps/lamp_values.inc"
#undef TYPE
};

struct MountRow {
  std::string_view value;
  LampMount mount;
};
constexpr MountRow kMounts[] = {
#define MOUNT(value, mount) {value, LampMount::mount},
#include "compiler/map/lamps/lamp_values.inc"
#undef MOUNT
};

struct ColourRow {
  std::string_view value;
  std::uint16_t temperature_k;
};
constexpr ColourRow kLightColours[] = {
#define COLOUR(value, temperature_k) {value, temperature_k},
#include "compiler/map/lamps/lamp_values.inc"
#undef COLOUR
};

// "3000 K", "3000K" or a name of kLightColours.
std::uint16_t temperature_of(const ReadContext& context, OsmId id, std::string_view text) {
  if (const ColourRow* row = row_with(kLightColours, text)) return row->temperature_k;
  if (!text.ends_with('K')) return 0;
  text.remove_suffix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return static_cast<std::uint16_t>(number_within(context, id, "light:colour", text, 1000, 20000).value_or(0));
}

std::uint32_t lumen_of(const ReadContext& context, OsmId id, std::string_view key, std::string_view text) {
  if (text.ends_with("lm")) text.remove_suffix(2);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return static_cast<std::uint32_t>(number_within(context, id, key, text, 1, 1e6).value_or(0));
}

}  // namespace

const LampTypeValues& values_of(LampType type) { return kTypeValues[static_cast<std::size_t>(type)]; }

LampTags read_lamp_tags(const ReadContext& context, OsmId id, source::Range tags) {
  const auto tagged_of = [&](std::string_view key, std::string_view other) {
    return context.tag(tags, key).empty() ? other : key;
  };
  LampTags lamp;
  if (const TypeRow* row = row_with(kTypes, context.tag(tags, tagged_of("lamp_type", "light:method"))))
    lamp.type = row->type;
  if (const MountRow* row = row_with(kMounts, context.tag(tags, "lamp_mount"))) lamp.mount = row->mount;
  const auto count = number_within(context, id, "light:count", context.tag(tags, "light:count"), 1, kMostLuminaires);
  lamp.count = static_cast<std::uint8_t>(count.value_or(1));
  lamp.temperature_k = temperature_of(context, id, context.tag(tags, "light:colour"));
  const std::string_view lumen_key = tagged_of("light:lumen", "luminous_flux");
  lamp.lumen = lumen_of(context, id, lumen_key, context.tag(tags, lumen_key));
  return lamp;
}

}  // namespace citykiln::map
