#include "tests/charts/assumed_place.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/assume/assume.h"
#include "compiler/assume/fit_widths.h"
#include "compiler/climate/climate_at.h"
#include "compiler/fields/add_fields.h"
#include "compiler/map/heights/resample.h"
#include "compiler/map/locate.h"
#include "compiler/roads/plan.h"
#include "compiler/source/read_osm.h"
#include "tests/charts/assumed_lands.h"

namespace citykiln::charts {
namespace {

using source::OsmData;
using source::Range;
using source::Tag;

/// A key that is left out; with a colon at its end, also all keys that begin with it.
struct LeftOutKey {
  LeftOut kind;
  std::string_view key;
};
constexpr std::array kLeftOutKeys = {LeftOutKey{LeftOut::kPavements, "sidewalk"},
                                     LeftOutKey{LeftOut::kPavements, "sidewalk:"},
                                     LeftOutKey{LeftOut::kLamps, "lit"},
                                     LeftOutKey{LeftOut::kLamps, "lit:"},
                                     LeftOutKey{LeftOut::kWidths, "width"},
                                     LeftOutKey{LeftOut::kWidths, "width:"},
                                     LeftOutKey{LeftOut::kWidths, "est_width"},
                                     LeftOutKey{LeftOut::kHeights, "height"},
                                     LeftOutKey{LeftOut::kHeights, "est_height"},
                                     LeftOutKey{LeftOut::kHeights, "building:height"},
                                     LeftOutKey{LeftOut::kHeights, "building:levels"},
                                     LeftOutKey{LeftOut::kHeights, "roof:height"},
                                     LeftOutKey{LeftOut::kHeights, "roof:levels"},
                                     LeftOutKey{LeftOut::kTrees, "tree_lined"}};

/// Elements that are left out as a whole.
struct LeftOutElement {
  LeftOut kind;
  std::string_view key, value;
};
constexpr std::array kLeftOutElements = {
    LeftOutElement{LeftOut::kLamps, "highway", "street_lamp"}, LeftOutElement{LeftOut::kTrees, "natural", "tree"},
    LeftOutElement{LeftOut::kTrees, "natural", "tree_row"}, LeftOutElement{LeftOut::kHedges, "barrier", "hedge"}};

bool is_left_out(LeftOut kind, std::string_view key) {
  return std::ranges::any_of(kLeftOutKeys, [&](const LeftOutKey& row) {
    return row.kind == kind && (row.key == key || (row.key.back() == ':' && key.starts_with(row.key)));
  });
}

/// For each string of the extract: true if tags with this key are left out.
std::vector<bool> left_out_strings(const OsmData& osm, LeftOut kind) {
  std::vector<bool> is_key;
  for (const std::string& text : osm.strings) is_key.push_back(is_left_out(kind, text));
  return is_key;
}

/// Removes tags. Areas and ways may share a range, so that the tags that stay are copied to the end.
struct TagRemover {
  OsmData& osm;
  LeftOut kind;
  std::vector<bool> is_key;

  void remove(Range& tags) {
    const auto is_this = [&](const LeftOutElement& row) {
      return row.kind == kind && osm.value_of(tags, row.key) == row.value;
    };
    if (std::ranges::any_of(kLeftOutElements, is_this)) tags.count = 0;
    const auto is_gone = [&](const Tag& tag) { return is_key[tag.key]; };
    if (std::ranges::none_of(osm.tags_of(tags), is_gone)) return;
    const Range all = tags;
    tags = {static_cast<std::uint32_t>(osm.tags.size()), 0};
    for (std::uint32_t i = all.first; i < all.first + all.count; ++i) {
      const Tag tag = osm.tags[i];
      if (is_gone(tag)) continue;
      osm.tags.push_back(tag);
      ++tags.count;
    }
  }
};

map::Features located(const Place& place, const OsmData& osm) {
  Report ignored;
  return map::locate(osm, map::Plane(place.origin), place.box, {}, ignored);
}

std::string name_of_file(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  return name.substr(0, name.find('.'));
}

// Returns the extract without the tags of a kind, at the elements that are out. An element without tags is none.
// O(tags).
OsmData without_tags(OsmData osm, LeftOut kind, const IsOut& is_out) {
  TagRemover remover{osm, kind, left_out_strings(osm, kind)};
  for (source::Node& node : osm.nodes)
    if (is_out({OsmType::kNode, node.id})) remover.remove(node.tags);
  for (source::Way& way : osm.ways)
    if (is_out({OsmType::kWay, way.id})) remover.remove(way.tags);
  for (source::Area& area : osm.areas)
    if (is_out(area.from)) remover.remove(area.tags);
  for (source::Relation& relation : osm.relations)
    if (is_out({OsmType::kRelation, relation.id})) remover.remove(relation.tags);
  return osm;
}

map::Heightfield heights_of(const Place& place, std::span<const source::Raster> heightmaps) {
  Report ignored;
  const map::Plane plane(place.origin);
  Result<map::Heightfield> heights = map::resample(heightmaps, plane, place.mapped.extent, ignored);
  return heights ? std::move(*heights) : *map::resample({}, plane, place.mapped.extent, ignored);
}

// Leaves out other areas: they lie on fields and do not divide them, but cost much where a coast is large.
void keep_farmed_areas(map::Features& features) {
  std::erase_if(features.areas, [](const map::AreaFeature& area) {
    return area.surface != map::LandCoverClass::kFarmland && area.surface != map::LandCoverClass::kMeadow;
  });
}

// Adds fields, and hedges beside roads.
void add_fields(const Place& place, Assumptions on, map::Features& features) {
  Report ignored;
  const map::Plane plane(place.origin);
  const fields::RuleAt rule_at = [&](Vec2 at) { return fields::field_rule_at(plane.backward(at)); };
  const lots::ClimateAt climate_at = [&](Vec2 at) {
    const LonLat lonlat = plane.backward(at);
    return climate::climate_at(lonlat.lon_deg, lonlat.lat_deg);
  };
  const std::function<map::CountryGroup(Vec2)> country_at = [&](Vec2 at) {
    return map::country_group_at(plane.backward(at));
  };
  const roads::RoadPlan roads = roads::plan(features, ignored);
  fields::Fields made = fields::with_fields(features,
                                            {.roads = roads.roads,
                                             .junctions = roads.junctions,
                                             .heights = place.heights,
                                             .rule_at = rule_at,
                                             .climate_at = climate_at,
                                             .country_at = country_at,
                                             .assumed = on},
                                            ignored);
  features.areas = std::move(made.areas), features.barriers = std::move(made.barriers);
}

}  // namespace

Result<Place> read_place(const std::string& path, std::span<const source::Raster> heightmaps, int threads) {
  Report ignored;
  Result<OsmData> osm = source::read_osm(path, threads, ignored);
  if (!osm) return osm.error();
  Place place;
  place.name = name_of_file(path);
  place.osm = std::move(*osm);
  place.box = map::choose_box(place.osm, {});
  place.origin = map::default_origin(place.box);
  place.mapped = located(place, place.osm);
  place.mapped.tracks = assume::fit_assumed_widths(place.mapped);
  place.heights = heights_of(place, heightmaps);
  return place;
}

map::Features guessed(const Place& place, LeftOut kind, const IsOut& is_out, Assumptions on) {
  Report ignored;
  const map::Plane plane(place.origin);
  const assume::LonLatOf lonlat_of = [&](Vec2 at) { return plane.backward(at); };
  map::Features features = located(place, without_tags(place.osm, kind, is_out));
  if (kind == LeftOut::kFields) join_fields(features);
  if (kind == LeftOut::kFrontages) hide_frontages(features);
  if (kind == LeftOut::kCourts) hide_courts(features, is_out);
  assume::Assumed assumed = assume::assume(features, {.on = on, .seed = 0, .lonlat_of = lonlat_of}, ignored);
  features.tracks = std::move(assumed.tracks), features.footprints = std::move(assumed.footprints);
  if (kind == LeftOut::kFields) keep_farmed_areas(features);
  if (kind == LeftOut::kFields || kind == LeftOut::kHedges) add_fields(place, on, features);
  return features;
}

}  // namespace citykiln::charts
