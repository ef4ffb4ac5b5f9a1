// Closes the outline of an area along a box beyond which parts of the outline are missing.
//
// Lines of the outline lead from side to side of the box. They divide it into two parts, as a map of two colours, and
// the area is one of them: the even part has the south-western corner of the box, and beyond each line is the other
// part. Evidence says which.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/source/mended_rings.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// A box on OSM's grid.
struct LocationBox {
  Location low, high;  ///< The south-western and the north-eastern corner.
};

/// Returns the box on OSM's grid; nothing for boxes near the poles or 180°, or wider than 20°.
std::optional<LocationBox> location_box(const LonLatBox& box);

/// True if the place is inside the box, not on its sides.
bool is_strictly_inside(const LocationBox& box, Location at);

/// The outline of an area inside a box.
struct CutLines {
  LocationBox box;
  std::vector<BrokenLine> rings;  ///< Closed, inside the box.
  std::vector<BrokenLine> lines;  ///< From side to side of the box; only their ends touch it.
};

/// Joins the lines of an area and cuts them at the box. An end inside the box that is nearer to a side than its last
/// segment is long (or than 30 m), and than an eighth of the box, is led on to the nearest side.
///
/// Nothing is returned if another end is inside the box, if no line is open although a ring is an outer one (the area
/// needs no closing), or if nothing is inside the box. The order and the directions of lines do not matter.
std::optional<CutLines> cut_at_box(std::vector<BrokenLine> lines, const LocationBox& box);

/// Tells the two parts of a box from each other.
class PartsOfBox {
 public:
  explicit PartsOfBox(const CutLines& cut);

  /// True if the place, inside the box, is in the odd part. A place on a line is in the part east of it. Exact. Cost:
  /// the segments at its latitude.
  bool is_odd(Location at) const;

  /// True if the place is a vertex of a line.
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

/// The votes for the area being the even or the odd part.
struct PartVotes {
  std::int64_t even = 0, odd = 0;
};

/// Adds `weight` for the part, or, if it is negative, for the other part.
void add_vote(PartVotes& votes, bool is_odd, int weight);

/// Returns the votes of rings: what surrounds an inner ring is in the area, what is inside an outer one too.
PartVotes votes_of_rings(const CutLines& cut, const PartsOfBox& parts);

/// Returns the votes of inner lines: each cuts off a side on which no outer line ends, and the area is not there.
PartVotes votes_of_inner_lines(const CutLines& cut);

/// The part that has less than a quarter of the box's sides, if there are two lines or more: that of a river that
/// crosses the box. 1 vote at most.
PartVotes votes_of_river(const CutLines& cut);

/// Returns the rings of the area: the lines, closed along the box widened by kClosedBeyond_m, and the rings inside.
/// Each ring of the outline is there once; inner ones have the role.
///
/// Nothing is returned if it is doubtful which part the area is: if, with the votes of rings and of inner lines, no
/// part has at least `least` votes and three times those of the other, or if more than a quarter of the rings say the
/// reverse.
std::optional<std::vector<BrokenLine>> close_along_box(const CutLines& cut, const PartsOfBox& parts,
                                                       const PartVotes& votes, std::int64_t least);

/// Areas are closed this far outside the map's box, as the sea is, which puts the sides out of sight: the extent is
/// rounded up to cells of 128 m.
inline constexpr double kClosedBeyond_m = 512;

}  // namespace citykiln::source
