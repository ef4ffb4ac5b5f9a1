#include "compiler/map/tags/layer_tags.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "compiler/contract/texts/utf8.h"

namespace citykiln::map {
namespace {

constexpr std::array<std::string_view, 9> kKeys = {"bridge", "tunnel",   "layer",   "level",    "covered",
                                                   "indoor", "location", "incline", "maxheight"};

std::string layer_text_of(const source::OsmData& osm, source::Range tags) {
  std::string text;
  for (const std::string_view key : kKeys) {
    const std::string_view value = osm.value_of(tags, key);
    if (value.empty()) continue;
    if (!text.empty()) text += ' ';
    text.append(key).append("=").append(value);
  }
  return to_valid_utf8(text);
}

}  // namespace

LayerTags layer_tags_of(const source::OsmData& osm, const Report& report) {
  LayerTags tags;
  const auto add = [&](OsmId object) {
    const auto way = std::ranges::lower_bound(osm.ways, object.id, {}, &source::Way::id);
    if (object.type == OsmType::kWay && way != osm.ways.end() && way->id == object.id)
      tags.try_emplace(object, layer_text_of(osm, way->tags));
  };
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (diagnosis.other.type != OsmType::kNone) add(diagnosis.object), add(diagnosis.other);
  return tags;
}

}  // namespace citykiln::map
