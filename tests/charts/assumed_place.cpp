#include "tests/charts/assumed_place.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/assume/assume.h"
#include "compiler/assume/fit_widths.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"

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
                                     LeftOutKey{LeftOut::kHeights, "roof:levels"}};

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
  std::vector<bool> is_key;

  void remove(Range& tags) {
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

// Returns the extract without the tags of a kind, at the elements that are out. A street lamp without tags is none.
// O(tags).
OsmData without_tags(OsmData osm, LeftOut kind, const IsOut& is_out) {
  TagRemover remover{osm, left_out_strings(osm, kind)};
  for (source::Node& node : osm.nodes) {
    if (!is_out({OsmType::kNode, node.id})) continue;
    if (kind == LeftOut::kLamps && osm.value_of(node.tags, "highway") == "street_lamp") node.tags.count = 0;
    remover.remove(node.tags);
  }
  for (source::Way& way : osm.ways)
    if (is_out({OsmType::kWay, way.id})) remover.remove(way.tags);
  for (source::Area& area : osm.areas)
    if (is_out(area.from)) remover.remove(area.tags);
  for (source::Relation& relation : osm.relations)
    if (is_out({OsmType::kRelation, relation.id})) remover.remove(relation.tags);
  return osm;
}

}  // namespace

Result<Place> read_place(const std::string& path, int threads) {
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
  return place;
}

map::Features guessed(const Place& place, LeftOut kind, const IsOut& is_out, Assumptions on) {
  Report ignored;
  map::Features features = located(place, without_tags(place.osm, kind, is_out));
  assume::Assumed assumed = assume::assume(features, {.on = on, .seed = 0}, ignored);
  features.tracks = std::move(assumed.tracks), features.footprints = std::move(assumed.footprints);
  return features;
}

}  // namespace citykiln::charts
