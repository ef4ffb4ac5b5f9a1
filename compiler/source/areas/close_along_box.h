// Closes the outline of an area that an extract has cut: the lines of the outline outside the extract's box are
// missing.
//
// The remaining lines lead from side to side of the box. They divide it into two parts, the even and the odd part, like
// a map in two colours: each line separates an even piece from an odd one, and the south-western corner is in the even
// part. One of the parts is the area; votes decide which.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/source/areas/mended_rings.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// A box on OSM's grid of 1e-7 degrees.
struct LocationBox {
  Location low, high;  ///< The south-western and the north-eastern corner.
};

/// Returns the box rounded to OSM's grid; nothing if it is empty, 20° wide or high, beyond 85° north or south, or
/// within 0.1° of the meridian of 180°.
std::optional<LocationBox> location_box(const LonLatBox& box);

/// True if a place is inside the box and not on its sides.
bool is_strictly_inside(const LocationBox& box, Location at);

/// The remaining outline of an area, inside a box.
struct CutLines {
  LocationBox box;
  std::vector<AreaLine> rings;  ///< Closed, inside the box.
  std::vector<AreaLine> lines;  ///< From side to side of the box; only their ends touch it.
};

/// Joins the lines of an area at common ends and cuts them at the box. A loose end inside the box is extended to the
/// nearest side, if that is no farther away than its last segment is long (or 30 m, if longer), and than an eighth of
/// the box's shorter side.
///
/// Returns nothing if another end is inside the box, if all lines are closed and one is an outer ring (the area needs
/// no closing), or if nothing is inside the box. The order and the directions of lines do not matter.
std::optional<CutLines> cut_at_box(std::vector<AreaLine> lines, const LocationBox& box);

/// Tells in which part of a box a place is.
class PartsOfBox {
 public:
  explicit PartsOfBox(const CutLines& cut);

  /// True if a place inside the box is in the odd part. A place on a line is in the part west of it. Exact. Cost: the
  /// segments at its latitude.
  bool is_odd(Location at) const;

  /// True if the place is a vertex of a line or ring.
  bool is_vertex(Location at) const;

 private:
  struct Segment {
    Location a, b;
  };
  std::size_t row_of(std::int32_t lat_e7) const;

  LocationBox box_;
  std::vector<std::vector<Segment>> rows_;
  std::vector<std::int64_t> ends_;  // along the sides, sorted
  std::vector<Location> vertices_;  // sorted
};

/// The votes for either part being the area.
struct PartVotes {
  std::int64_t even = 0, odd = 0;
};

/// Adds `weight` votes for the part, or, if `weight` is negative, -weight votes for the other part.
void add_vote(PartVotes& votes, bool is_odd, int weight);

/// Returns one vote for a part along less than a quarter of the box's sides, if there are two lines or more: a river
/// that crosses the box is narrow.
PartVotes votes_of_river(const CutLines& cut);

/// Returns the rings of the area: the lines, joined outside the box along its sides moved out by kClosedBeyond_m, and
/// the rings inside the box. Each ring occurs once; is_inner is set for inner ones.
///
/// Returns nothing if the votes are not clear. The area is the part with more votes, those of rings and inner lines
/// added, three each: the part around an inner ring is the area, the part around an outer ring is not; if outer lines
/// end on one side only of an inner line, the part beside it on its other side is not the area. It needs at least
/// `least` votes and three times those of the other part, and among the votes of rings three times those of the other
/// part, too.
std::optional<std::vector<AreaLine>> close_along_box(const CutLines& cut, const PartsOfBox& parts,
                                                     const PartVotes& votes, std::int64_t least);

/// The distance outside the map's box at which areas are closed. The sides are out of sight there, since the extent
/// ends less than a cell (128 m) outside the box. The sea is closed 256 m outside the extent (map/locate_sea).
inline constexpr double kClosedBeyond_m = 512;

}  // namespace citykiln::source
