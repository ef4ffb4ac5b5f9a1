#include "compiler/source/osm_data.h"

namespace citykiln::source {

std::string_view OsmData::value_of(Range element_tags, std::string_view key) const {
  for (const Tag& tag : tags_of(element_tags)) {
    if (strings[tag.key] == key) return strings[tag.value];
  }
  return {};
}

}  // namespace citykiln::source
