// Finds what the table of things describes among the nodes, ways and areas of an extract.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/read_context.h"
#include "compiler/map/things/thing_table.h"

namespace citykiln::map {

/// A row, and the value of the first tag that it tests; a null row if none fits.
struct MatchedThing {
  const ThingRow* row = nullptr;
  std::string_view value;
};

/// A thing on the map, and the first row that fits it.
struct FoundThing {
  ObjectId id;
  source::Range tags;
  source::Location where;  ///< A point of its element.
  MatchedThing match;
  Vec2 at;                                        ///< Its middle, snapped.
  double width_m = 0, depth_m = 0, height_m = 0;  ///< By the outline, else by tags, else by the row.
  bool has_height = false;                        ///< True if tags say height_m.
  std::optional<Vec2> along{};                    ///< The direction of its width if an outline says it.
  bool is_another = false;                        ///< True for a second thing of one element.
};

/// Returns the nodes that have a row in the table and are no trees or lamps, and the ways and areas that have one and
/// are no feature of another kind; outline_places.h says where on these things stand. Areas wider than 128 m have
/// none. A size that cannot be read is diagnosed kBadTagValue. O(elements · rows of their keys).
std::vector<FoundThing> find_things(const ReadContext& context, const ThingTable& table, const Features& features);

}  // namespace citykiln::map
