// Says from the tags of an element whether it stands, and where: the one place that reads lifecycle words, level,
// location, indoor, layer and storeys below the ground for this.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/contract/report.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Whether an object stands.
enum class Presence : std::uint8_t {
  kStands,
  kShell,  ///< Walls alone: a ruin, or a building under construction.
  kGone    ///< Demolished, or not built yet.
};

/// Where an object is.
enum class Storey : std::uint8_t {
  kGround,
  kUnderground,
  kIndoor,  ///< Inside a building.
  kAbove    ///< On an upper storey or a roof.
};

/// The answer for one element.
struct Standing {
  Presence presence = Presence::kStands;
  Storey storey = Storey::kGround;
};

/// The lowest and the highest storey of level=*; 0 is the ground floor.
struct Levels {
  double lowest = 0, highest = 0;
};
/// Returns the storeys of a text such as "-1", "0;1", "-2--1", "1-3"; nothing if it cannot be read.
std::optional<Levels> levels_of(std::string_view text);

/// Returns the presence by lifecycle.inc: by the value of `key`, by a word as a key with the value yes, by
/// historic=ruins of a building, and by an end_date up to kLastEnd.
Presence presence_of(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns whether and where a building or part of one stands. Stated storeys above the ground, or a height, win over a
/// negative layer; level, location, tunnel, and storeys that are all below the ground win over these.
/// @param key  "building" or "building:part".
Standing standing_of_building(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns whether and where an area of land or water stands. A layer alone moves only surfaces made by people, such as
/// platforms and pitches: water and woods with a layer are on the ground.
/// @param key  The key that gives the area its class.
Standing standing_of_area(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns whether and where a line or a point stands. A layer moves neither.
/// @param key  The key that gives the object its class.
Standing standing_of_thing(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns the value of a key, else that of its prefixes for what still has a body: disused:, abandoned:, ruins:,
/// construction:. Empty if none is tagged.
std::string_view standing_value(const source::OsmData& osm, source::Range tags, std::string_view key);

/// True if tags state that something of a building is above the ground: a height, or storeys.
bool states_height(const source::OsmData& osm, source::Range tags);

/// True if a shell is a ruin, false if it is under construction.
bool is_ruin(const source::OsmData& osm, source::Range tags);

/// Returns the code with which an object is dropped that is not on the ground; nothing for one that stands there.
std::optional<Code> reason_to_drop(Standing standing);

/// An object with an end_date in a later year is still there: its end is a plan.
inline constexpr int kLastEnd = 2024;

}  // namespace citykiln::map
