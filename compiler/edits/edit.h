// The edits of a map as plain data: for each line of a file of edits the elements that it means, and what it does to
// them. edits.md describes the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/lonlat.h"
#include "compiler/geometry/vec.h"
#include "compiler/source/osm_data.h"

namespace citykiln::edits {

/// The kinds of conditions.
enum class ConditionKind : std::uint8_t { kIds, kTag, kBox, kNear };

/// The types of elements that a condition on a tag accepts: a sum of bits. An area is a closed way of four nodes or
/// more, the first of which is repeated, or a relation of type multipolygon or boundary.
using ElementTypes = std::uint8_t;
inline constexpr ElementTypes kNodes = 1, kWays = 2, kRelations = 4, kAreas = 8;
inline constexpr ElementTypes kAnyType = kNodes | kWays | kRelations;

/// The places at most radius_m from a place (circle_about()).
struct Circle {
  source::Location centre{};
  double radius_m = 0;
  double east_m = 0;  ///< The length of 1e-7 degrees of longitude at the centre, in metres.
};

/// One word of a filter.
struct Condition {
  ConditionKind kind = ConditionKind::kTag;
  bool is_negated = false;   ///< True if the condition fits all other elements.
  std::vector<OsmId> ids{};  ///< For kIds: sorted.
  // of kTag
  ElementTypes types = kAnyType;
  std::string key{};
  std::vector<std::string> values{};  ///< "*" at the begin or end stands for any text. Empty: every value.
  bool is_other = false;              ///< True if the value must be none of `values`, but the key must be there.
  // of kBox and kNear
  source::LonLatBox box{};
  Circle circle{};
};

/// Elements that fit all conditions; never empty.
using Filter = std::vector<Condition>;

/// The changes to elements. Tags are removed before others are set. A node is moved before it is placed, so `placed`
/// overrides `moved_m`.
struct Changes {
  bool is_dropped = false;
  std::vector<std::pair<std::string, std::string>> set{};  ///< Key and value, in the order of the line.
  std::vector<std::string> removed{};                      ///< Keys; "*" at the begin or end stands for any text.
  std::optional<Vec2> moved_m{};                           ///< East and north.
  std::optional<source::Location> placed{};                ///< The new place of a node.

  bool changes_tags() const { return !set.empty() || !removed.empty(); }
  bool changes_places() const { return moved_m || placed; }
};

/// A point of a new element: a node of the map, or a place.
struct NewPoint {
  std::optional<std::int64_t> node{};  ///< Its id in the map.
  source::Location at{};               ///< The place, if no node is named.
};

/// An element that an edit adds.
struct NewElement {
  OsmId id;                        ///< A node or a way, with an id by new_element_id().
  bool is_area = false;            ///< True for an area: a closed way.
  std::vector<NewPoint> points{};  ///< One of a node, at least two of a way, at least three of an area.
  std::vector<std::pair<std::string, std::string>> tags{};
};

/// One line of a file: changes to the elements that fit a filter, or a new element.
struct Edit {
  std::uint32_t line = 0, column = 0;  ///< The place of its first word, counted from 1; columns count characters.
  Filter filter{};                     ///< Empty for a new element.
  Changes changes{};
  std::optional<NewElement> added{};
};

/// A file of edits.
struct Edits {
  std::string name;         ///< The file's name without its folder.
  std::uint64_t hash = 0;   ///< A hash of its text.
  std::vector<Edit> lines;  ///< In the order of the file.
};

/// Returns the text that names the file among the sources of a manifest: "mends.edits (12 edits, 0123456789abcdef)".
/// Files of other texts have other hashes.
std::string source_text(const Edits& edits);

/// Returns the place of an edit for findings: "mends.edits:3:1".
std::string place_text(const Edits& edits, const Edit& edit);

/// The largest distance from its place in the map at which a node can be placed, in metres. A place farther away is not
/// for this node: its line has no effect.
inline constexpr double kFarthestPlace_m = 1000;

/// Returns a bound of the distance by which the edits move any node, in metres: the sum of all offsets, since all lines
/// may mean one node, and kFarthestPlace_m if a node is placed.
double longest_move_m(const Edits& edits);

}  // namespace citykiln::edits
