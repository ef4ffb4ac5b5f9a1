// Posts that carry roofs without walls, and buildings that min_height=* lifts off the ground.
//
//     ______________
//    |______________|   bottom_m
//      |    |    |
//      |    |    |      posts: at corners, and between them
//     _|____|____|_     ground; they end below it, at post_foot_m
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"
#include "grammars/shapes/shape.h"

namespace citykiln::buildings {

/// The places where no post may stand: ways, and walls of other footprints.
struct PostObstacles {
  /// One segment of a way.
  struct Way {
    Vec2 from, to;
    double clear_m;  ///< Distance from the segment within which no post stands.
  };
  std::vector<Way> ways;
  BoxGrid way_grid;
  std::span<const map::Footprint> footprints;  ///< All footprints; owned by the caller.
  std::vector<std::uint32_t> walled;           ///< Indices into `footprints` of those with walls down to the ground.
  BoxGrid walled_grid;
};

/// Collects and indexes the ways outside of tunnels, and the footprints with walls down to the ground.
/// @param footprints  Must outlive the result.
PostObstacles index_post_obstacles(std::span<const map::Track> tracks, std::span<const map::Footprint> footprints);

/// Returns the centres of a footprint's posts, in plane metres, in the order of its border: inside each corner, and at
/// most kMostPostSpacing_m apart along long edges, one width of a post inside the border. A post is left out on a way,
/// at the wall of another footprint, which carries the building there, and within three widths of an earlier post. May
/// be empty.
/// @param footprint  Index into obstacles.footprints.
/// @param height_m   The length of the posts, which decides their width.
std::vector<Vec2> plan_posts(std::size_t footprint, const PostObstacles& obstacles, double height_m);

/// Returns the side of a square post: 1/30 of its height, at least 0.125 m and at most 0.75 m. Snapped.
double post_width_m(double height_m);

/// Returns the sides of a building's posts: four vertical faces each, from post_foot_m to bottom_m.
std::vector<grammars::Face> post_faces(const Building& building);

/// The largest distance between planned posts along an edge.
inline constexpr double kMostPostSpacing_m = 6;

}  // namespace citykiln::buildings
