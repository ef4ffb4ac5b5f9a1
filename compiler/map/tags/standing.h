// Decides from the tags of an element whether the object exists, and whether it is on the ground, below or above it, or
// inside a building. Only this file reads lifecycle words (such as "razed"), level, location, indoor, layer and
// underground storeys for this, except that tracks also read level and indoor by themselves (Track::is_indoor).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/contract/findings/report.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Whether an object exists.
enum class Presence : std::uint8_t {
  kStands,  ///< It exists, in use or not.
  kShell,   ///< Walls alone: a ruin, or a building under construction.
  kGone     ///< Demolished, or not built yet.
};

/// Where an object is, relative to the ground and to buildings.
enum class Storey : std::uint8_t {
  kGround,
  kUnderground,
  kIndoor,  ///< Inside a building.
  kAbove    ///< On an upper storey or a roof.
};

/// Whether and where an object stands.
struct Standing {
  Presence presence = Presence::kStands;
  Storey storey = Storey::kGround;
};

/// The lowest and the highest storey of level=*; 0 is the ground floor.
struct Levels {
  double lowest = 0, highest = 0;
};
/// Returns the lowest and the highest storey in a text such as "-1", "0;1", "-2--1" (-2 to -1) or "1-3"; nothing if the
/// text is empty or any of it cannot be read.
std::optional<Levels> levels_of(std::string_view text);

/// Returns whether an object exists. Words of lifecycle.inc count as the value of `key` and as a key with the value
/// yes; ruins: and construction: count as prefixes of `key`; historic=ruins makes a building a shell. An end_date up to
/// kLastPastYear means that the object is gone, a start_date from kFirstFutureYear on that it is not built yet.
/// @param key  The key that says what the object is, such as "building".
Presence presence_of(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns whether and where a building or part of one stands. It is underground by level, by location, by tunnel=*
/// (except building_passage), or if all its storeys are below the ground and no height is tagged. A negative layer
/// counts only if neither a height nor storeys above the ground are tagged. Buildings on roofs, parts on upper storeys,
/// and whole buildings tagged as indoor count as kGround, since each is a body of its own.
/// @param key  "building" or "building:part".
Standing standing_of_building(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns whether and where an area of land or water stands. A layer alone moves only surfaces made by people, such as
/// platforms and pitches. Water and woods with a layer are on the ground: it is for the order of drawing.
/// @param key  The key that gives the area its class.
Standing standing_of_area(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns whether and where a line or a point stands. The layer of barriers counts: they stand on bridges and roofs.
/// Layers of others are ignored.
/// @param key  The key that gives the object its class.
Standing standing_of_object(const source::OsmData& osm, source::Range tags, std::string_view key);

/// Returns the value of a key, else that of the key with a prefix for objects that can still be seen: disused:,
/// abandoned:, ruins:, construction:. Empty if none is tagged.
std::string_view standing_value(const source::OsmData& osm, source::Range tags, std::string_view key);

/// True if tags state that a building rises above the ground: height or building:levels above 0.
bool states_height(const source::OsmData& osm, source::Range tags);

/// True if the tags of a shell say that it is a ruin, false if it is under construction.
bool is_ruin(const source::OsmData& osm, source::Range tags);

/// True if location=* says that an object is on a roof.
bool is_located_on_roof(const source::OsmData& osm, source::Range tags);

/// Returns the code for dropping an object that is gone, or not on the ground; nothing for one that stands there.
std::optional<Code> reason_to_drop(Standing standing);

/// The last year of end_date in which an object counts as gone. A later end is a plan, and the object still stands.
inline constexpr int kLastPastYear = 2024;
/// The first year of start_date in which an object counts as planned. A constant, since outputs do not depend on the
/// day of a run.
inline constexpr int kFirstFutureYear = 2027;

}  // namespace citykiln::map
