#include "compiler/map/element_text.h"

#include <algorithm>
#include <map>

#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/texts/utf8.h"
#include "compiler/map/features.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {
namespace {

std::vector<OsmId> elements_of(const Features& features) {
  std::vector<OsmId> ids;
  const auto add = [&](const auto&... kinds) {
    const auto add_kind = [&](const auto& kind) {
      for (const auto& feature : kind) ids.push_back(feature.id.osm);
    };
    (add_kind(kinds), ...);
  };
  add(features.tracks, features.footprints, features.areas, features.waterways, features.barriers, features.landforms,
      features.points, features.things, features.tree_rows, features.power_lines);
  sort_unique(ids);
  return ids;
}

template <typename Element, typename Id, typename IdOf>
source::Range tags_in(const std::vector<Element>& elements, Id id, IdOf id_of) {
  const auto found = std::ranges::lower_bound(elements, id, {}, id_of);
  return found != elements.end() && std::invoke(id_of, *found) == id ? found->tags : source::Range{};
}

// An area's tags are those of its ring where an old multipolygon relation has none itself.
source::Range tags_of(const source::OsmData& osm, OsmId id) {
  if (id.type == OsmType::kNode) return tags_in(osm.nodes, id.id, &source::Node::id);
  const source::Range of_area = tags_in(osm.areas, id, &source::Area::from);
  if (of_area.count > 0) return of_area;
  return id.type == OsmType::kWay ? tags_in(osm.ways, id.id, &source::Way::id)
                                  : tags_in(osm.relations, id.id, &source::Relation::id);
}

TagList tag_list_of(const source::OsmData& osm, source::Range tags) {
  TagList list;
  for (const source::Tag& tag : osm.tags_of(tags))
    list.add(to_valid_utf8(osm.strings[tag.key]), to_valid_utf8(osm.strings[tag.value]));
  return list;
}

// The beginning of valid UTF-8 that has at most kMostNameBytes.
std::string shortened(std::string name) {
  std::size_t end = std::min(name.size(), kMostNameBytes);
  while (end < name.size() && end > 0 && static_cast<unsigned char>(name[end]) >> 6 == 2) --end;
  name.resize(end);
  return name;
}

// The outline of each building part.
std::map<OsmId, OsmId> outlines_of_parts(const Features& features) {
  std::map<OsmId, OsmId> outlines;
  for (const Footprint& footprint : features.footprints)
    if (footprint.outline) outlines.emplace(footprint.id.osm, footprint.outline->osm);
  return outlines;
}

}  // namespace

std::vector<ElementText> element_texts(const source::OsmData& osm, const Features& features, bool keeps_tags) {
  const std::map<OsmId, OsmId> outlines = outlines_of_parts(features);
  const auto name_of = [&](OsmId id) { return osm.value_of(tags_of(osm, id), "name"); };
  std::vector<ElementText> texts;
  for (const OsmId id : elements_of(features)) {
    std::string_view name = name_of(id);
    if (const auto outline = outlines.find(id); name.empty() && outline != outlines.end())
      name = name_of(outline->second);
    ElementText text{id, shortened(to_valid_utf8(name)), keeps_tags ? tag_list_of(osm, tags_of(osm, id)) : TagList{}};
    if (!text.name.empty() || !text.tags.empty()) texts.push_back(std::move(text));
  }
  return texts;
}

const ElementText* find_text(std::span<const ElementText> texts, OsmId id) {
  const auto found = std::ranges::lower_bound(texts, id, {}, &ElementText::id);
  return found != texts.end() && found->id == id ? &*found : nullptr;
}

}  // namespace citykiln::map
