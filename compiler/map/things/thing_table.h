// The table of things: what stands in streets and fields, by the tags of the map. The format is explained in
// grammars/things/README.md.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/map/tag_tests.h"

namespace citykiln::map {

/// The support of a thing, and where it may stand.
enum class Stand : std::uint8_t {
  kGround,    ///< On the ground, beside carriageways.
  kPole,      ///< On a pole of its own, beside carriageways.
  kWall,      ///< On the wall of a building within 5 m.
  kOverRoad,  ///< Where it is mapped, above a road, which its rule leaves free.
  kInWay,     ///< Where it is mapped, also in a carriageway: bollards, lift gates.
  kRoof,      ///< On the roof of the building where it is mapped, else as kGround: flagpoles, antennas.
  /// Like kRoof, but a thing that is tagged higher than the roof stands on the ground and goes through the roof:
  /// chimneys.
  kThroughRoof
};

/// The direction that a thing faces where no tag states one.
enum class Facing : std::uint8_t {
  kTag,       ///< South, if direction=* is not tagged.
  kStreet,    ///< The nearest road or path within 30 m.
  kAlong,     ///< The traffic on the way that it belongs to, else on the nearest road.
  kPlatform,  ///< The nearest road or railway within 30 m.
  kArms,      ///< The traffic, as kAlong; on a node of a junction that of each arm, by one thing each.
  kAny        ///< A random direction.
};

/// A length that a tag may state.
struct TaggedLength {
  std::string key;  ///< "" for none.
  double default_m = 0;
};

/// A row of the table.
struct ThingRow {
  std::string name;
  TagTests tags{};     ///< It fits if all tests of one of these lists do.
  std::string rule{};  ///< Rule file without ".cga".
  TaggedLength width{}, depth{}, height{};
  Stand stand{};
  Facing facing{};
  double clear_m = 0;                ///< The radius around it without walls, carriageways and water.
  std::optional<double> detail_m{};  ///< It is there below this tolerance, or below its height if that is larger.
  std::string class_name{};          ///< The class in property tables: "Bench".
  std::string line{};                ///< The row as it is written.
};

/// The column of tags of a row for equipment of sports pitches, which is not mapped.
inline constexpr std::string_view kNoTags = "-";

using ThingTable = std::vector<ThingRow>;

/// Reads a table: one row a line, columns separated by blanks; "#" begins a comment. Errors, with file and line: a
/// wrong number of columns, a name that is used twice, a column that cannot be read.
Result<ThingTable> read_thing_table(std::string_view text, const std::string& file);

/// Returns the rows of `own`, then those of `shipped` whose names `own` does not have.
ThingTable merged(ThingTable own, const ThingTable& shipped);

/// Returns fitting_value() of the row's tests; nothing if the row does not fit. The first test of each list is of a
/// value that is there, so a row can only fit an element with one of these keys.
/// @param value_of  Returns the value of a key, "" if it is not tagged.
std::optional<std::string_view> matched_value(const ThingRow& row,
                                              const std::function<std::string_view(std::string_view)>& value_of);

}  // namespace citykiln::map
