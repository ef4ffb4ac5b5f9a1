#include "compiler/map/buildings/building_tags.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/buildings/part_heights.h"
#include "compiler/map/tagged_words.h"
#include "compiler/map/tags/read_context.h"
#include "compiler/map/tags/standing.h"
#include "compiler/map/tags/tag_values.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::map {
namespace {

// ---- roofs ----------------------------------------------------------------------------------------------------------

struct TaggedRoof {
  bool has_shape = false;  // True if roof:shape is tagged.
  roofs::RoofShape shape;
};

constexpr double kHighestRoof_m = 1000, kSteepest_deg = 85, kMostRoofLevels = 50;

std::optional<double> tagged_number(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                    double most) {
  const std::string_view text = context.tag(tags, key);
  return number_within(context, id, key, text.substr(0, text.find("\xc2\xb0")), 0, most);
}

std::optional<Vec2> tagged_direction(const ReadContext& context, OsmId id, source::Range tags) {
  const auto bearing_deg = parsed_tag(context, id, tags, "roof:direction", bearing_deg_of);
  return bearing_deg ? std::optional(direction_of((90 - *bearing_deg) / 360)) : std::nullopt;
}

std::optional<roofs::RoofForm> tagged_form(const ReadContext& context, OsmId id, source::Range tags) {
  const std::string_view text = context.tag(tags, "roof:shape");
  // words without a definite shape
  if (std::ranges::any_of(words_of(text), is_indefinite)) return first_known(text, roofs::form_named);
  return parsed_text(context, id, "roof:shape", text,
                     [](std::string_view value) { return first_known(value, roofs::form_named); });
}

double tagged_roof_height_m(const ReadContext& context, OsmId id, source::Range tags, double level_m) {
  if (const auto height_m = tagged_length_m(context, id, tags, "roof:height", 0, kHighestRoof_m)) return *height_m;
  return level_m * tagged_number(context, id, tags, "roof:levels", kMostRoofLevels).value_or(0);
}

// Returns the roof by roof:shape, roof:height (else roof:levels of level_m each), roof:angle, roof:direction and
// roof:orientation. Diagnosed and ignored: unknown shapes and unreadable numbers, kBadTagValue.
TaggedRoof tagged_roof(const ReadContext& context, OsmId id, source::Range tags, double level_m) {
  assert(level_m > 0);
  const auto form = tagged_form(context, id, tags);
  TaggedRoof roof{form.has_value(), {form.value_or(roofs::RoofForm::kFlat)}};
  roof.shape.height_m = tagged_roof_height_m(context, id, tags, level_m);
  roof.shape.angle_deg = tagged_number(context, id, tags, "roof:angle", kSteepest_deg).value_or(0);
  roof.shape.direction = tagged_direction(context, id, tags);
  roof.shape.is_ridge_across = in_lower_case(context.tag(tags, "roof:orientation")) == "across";
  return roof;
}

// Minimum height: parts of monuments are a few decimetres high.
constexpr double kLowest_m = 0.1, kHighestBuilding_m = 1000, kMostBuildingLevels = 250;

// A roof that is mapped as a part without thickness.
constexpr double kSlab_m = 0.25;

// The colour of the first key that is tagged.
std::optional<Srgb> tagged_colour(const ReadContext& context, OsmId id, source::Range tags, std::string_view british,
                                  std::string_view american) {
  return parsed_tag(context, id, tags, context.tag(tags, british).empty() ? american : british, colour_of);
}

std::optional<double> tagged_levels(const ReadContext& context, OsmId id, source::Range tags, std::string_view key) {
  return number_within(context, id, key, context.tag(tags, key), 0, kMostBuildingLevels);
}

// Default heights by area: sheds, houses of two storeys with a roof, town blocks of four to five storeys.
double height_by_area_m(double area_m2) {
  return area_m2 < 25 ? 2.8 : area_m2 < 70 ? 4.5 : area_m2 < 220 ? 7.5 : area_m2 < 700 ? 11 : 13;
}

std::optional<double> tagged_building_height_m(const ReadContext& context, OsmId id, source::Range tags) {
  const auto height_m = tagged_length_m(context, id, tags, "height", kLowest_m, kHighestBuilding_m);
  return height_m ? height_m : tagged_length_m(context, id, tags, "building:height", kLowest_m, kHighestBuilding_m);
}

// A roof whose tags say that there are no storeys below it.
constexpr double kNoWall_m = 0.25;

double untagged_height_m(const Footprint& footprint, double level_m, double class_height_m, double area_m2) {
  if (footprint.levels > 0) return std::max(1.0, footprint.levels * level_m);
  if (!footprint.has_default_height) return kNoWall_m;
  if (footprint.min_height_m > 0 && footprint.roof.height_m > 0) return 1;  // mostly roof
  return class_height_m > 0 ? class_height_m : height_by_area_m(area_m2);
}

// Buildings that span a street, and how high above it they begin where no tag says so: over the traffic below.
constexpr std::string_view kSkywalks[] = {"bridge", "skyway", "skywalk", "skybridge", "walkway"};
constexpr double kSkywalk_m = 5;

bool is_skywalk(const ReadContext& context, source::Range tags) {
  const std::string_view value = context.tag(tags, "building"), part = context.tag(tags, "building:part");
  const auto is_named = [](std::string_view text) { return std::ranges::find(kSkywalks, text) != std::end(kSkywalks); };
  const bool is_on_bridge = says_yes(context.tag(tags, "bridge")) && (says_yes(value) || says_yes(part));
  return (is_named(value) || is_named(part) || is_on_bridge) && context.tag(tags, "min_height").empty() &&
         context.tag(tags, "building:min_level").empty();
}

double lowest_level(const ReadContext& context, source::Range tags) {
  const std::optional<Levels> levels = levels_of(context.tag(tags, "level"));
  return levels ? levels->lowest : 0;
}

// Lifts a skywalk: its storeys, of which it has at least one, lie above the street, at its level if that is higher.
void lift_skywalk(double level, bool has_height, Footprint& footprint) {
  footprint.min_height_m = snapped(std::max(kSkywalk_m, level * footprint.storey_m));
  if (!has_height)
    footprint.height_m = snapped(footprint.min_height_m + std::max(1.0, footprint.levels) * footprint.storey_m);
}

void read_min_height(const ReadContext& context, OsmId id, source::Range tags, Footprint& footprint) {
  const auto height_m = tagged_length_m(context, id, tags, "min_height", 0, kHighestBuilding_m);
  if (!height_m) footprint.min_levels = tagged_levels(context, id, tags, "building:min_level").value_or(0);
  footprint.min_height_m = snapped(height_m.value_or(footprint.min_levels * footprint.storey_m));
}

// A height below min_height is that of the part alone; an equal one is the place of a slab, or of one storey. Where no
// tag states a height, min_height is ignored: nothing says that something is up there.
void mend_height(bool is_in_metres, double level_m, Footprint& footprint) {
  const bool is_equal = footprint.height_m == footprint.min_height_m;
  const double own_m = !is_equal ? footprint.height_m : is_in_metres ? kSlab_m : level_m;
  const bool is_stated = is_in_metres || footprint.levels > 0 || footprint.roof.height_m > 0;
  footprint.height_m = snapped(footprint.min_height_m + own_m);
  if (is_stated && footprint.height_m <= kHighestBuilding_m) return;
  footprint.height_m = snapped(own_m), footprint.min_height_m = 0;
}

void read_heights(const ReadContext& context, OsmId id, source::Range tags, const BuildingValues& values,
                  double area_m2, Footprint& footprint) {
  const auto height_m = tagged_building_height_m(context, id, tags);
  const auto levels = tagged_levels(context, id, tags, "building:levels");
  footprint.levels = levels.value_or(0);
  footprint.has_roof_in_height = height_m.has_value();
  // a roof without storeys below it stands on the ground
  const bool is_all_roof = levels == 0 && footprint.roof.height_m > 0 && !footprint.is_open;
  footprint.has_default_height = !height_m && footprint.levels == 0 && !is_all_roof;
  footprint.height_m = snapped(height_m.value_or(0));
  const double storey_m = measured_storey_m(footprint);
  footprint.storey_m = storey_m > 0 ? storey_m : values.level_m;
  read_min_height(context, id, tags, footprint);
  // compared as stored
  if (!height_m) footprint.height_m = snapped(untagged_height_m(footprint, values.level_m, values.height_m, area_m2));
  if (is_skywalk(context, tags)) lift_skywalk(lowest_level(context, tags), height_m.has_value(), footprint);
  if (footprint.min_height_m < footprint.height_m) return;
  context.report.add(Code::kMinHeightNotBelowHeight, id, footprint.min_height_m - footprint.height_m);
  mend_height(height_m.has_value(), values.level_m, footprint);
}

// Amenities with a ground floor of wide windows, like shops.
constexpr std::string_view kServing[] = {"restaurant", "cafe", "bar",      "pub",        "fast_food",
                                         "ice_cream",  "bank", "pharmacy", "marketplace"};

bool is_open(const ReadContext& context, source::Range tags, BuildingClass building) {
  return building == BuildingClass::kRoof || building == BuildingClass::kShelter || context.tag(tags, "wall") == "no" ||
         context.tag(tags, "walls") == "no";
}

// Values of shelter_type=* that have walls.
constexpr std::string_view kWalled[] = {"basic_hut", "weather_shelter", "field_shelter", "wildlife_hide",
                                        "changing_rooms"};

struct StructureRow {
  std::string_view key, value, building;
};
constexpr StructureRow kStructures[] = {
#define STRUCTURE(key, value, building) {key, value, building},
#include "compiler/map/buildings/structure_values.inc"
#undef STRUCTURE
};

bool is_covered_platform(const ReadContext& context, source::Range tags) {
  const bool is_platform =
      context.tag(tags, "railway") == "platform" || context.tag(tags, "public_transport") == "platform";
  return is_platform && context.tag(tags, "covered") == "yes";
}

// The value of building=* that a structure without it has; empty for everything else.
std::string_view structure_value(const ReadContext& context, source::Range tags) {
  const auto row = std::ranges::find_if(
      kStructures, [&](const StructureRow& each) { return context.tag(tags, each.key) == each.value; });
  if (row == std::end(kStructures)) return is_covered_platform(context, tags) ? "roof" : "";
  const std::string_view type = context.tag(tags, "shelter_type");
  return std::ranges::find(kWalled, type) != std::end(kWalled) ? "hut" : row->building;
}

// The value of building=*; of a house under construction its class, if that is tagged; of a disused one that of
// disused:building=*.
std::string_view outline_value(const ReadContext& context, source::Range tags) {
  const std::string_view text = standing_value(context.osm, tags, "building");
  const std::string_view planned = context.tag(tags, "construction");
  return text == "construction" && says_yes(planned) ? planned : text;
}

}  // namespace

BuildingValue building_value(const ReadContext& context, source::Range tags) {
  const std::string_view outline = outline_value(context, tags), part = context.tag(tags, "building:part");
  if (says_yes(outline)) {
    // what is tagged building=yes may be a shelter; a value of its own says more
    const std::string_view structure = outline == "yes" ? structure_value(context, tags) : "";
    return {structure.empty() ? outline : structure};
  }
  if (says_yes(part)) return {part, true};
  return {outline == "no" ? "" : structure_value(context, tags)};
}

bool is_bridge_support(const ReadContext& context, source::Range tags) {
  return says_yes(context.tag(tags, "bridge:support"));
}

bool is_shop(const ReadContext& context, source::Range tags) {
  const std::string_view shop = context.tag(tags, "shop"), amenity = context.tag(tags, "amenity");
  const bool is_served = std::find(std::begin(kServing), std::end(kServing), amenity) != std::end(kServing);
  return is_served || (says_yes(shop) && shop != "vacant");
}

Footprint read_building_tags(const ReadContext& context, OsmId id, source::Range tags, std::string_view value,
                             double area_m2) {
  Footprint footprint;
  const BuildingClass building = building_class_of(value);
  const BuildingValues& values = values_of(building);
  footprint.building_class = static_cast<std::uint8_t>(building);
  const TaggedRoof roof = tagged_roof(context, id, tags, values.level_m);
  footprint.has_roof_shape = roof.has_shape, footprint.roof = roof.shape;
  footprint.is_open = is_open(context, tags, building);
  read_heights(context, id, tags, values, area_m2, footprint);
  footprint.wall_colour = tagged_colour(context, id, tags, "building:colour", "building:color");
  footprint.roof_colour = tagged_colour(context, id, tags, "roof:colour", "roof:color");
  footprint.wall_material = wall_material_of(context.tag(tags, "building:material"));
  footprint.roof_material = roof_material_of(context.tag(tags, "roof:material"));
  footprint.year = parsed_tag(context, id, tags, "start_date", year_of).value_or(0);
  footprint.layer = tagged_layer(context, id, tags);
  footprint.has_tagged_layer = !context.tag(tags, "layer").empty();
  footprint.has_shop = is_shop(context, tags);
  footprint.style_name = context.tag(tags, "citykiln:style");
  return footprint;
}

}  // namespace citykiln::map
