// Posts below roofs without walls, and below buildings that min_height lifts where nothing carries them.
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

/// The obstacles of posts: ways, and the walls of other footprints.
struct PostObstacles {
  struct Way {
    Vec2 from, to;
    double clear_m;  ///< Distance from the line that stays free.
  };
  std::vector<Way> ways;
  BoxGrid way_grid;
  std::span<const map::Footprint> footprints;
  std::vector<std::uint32_t> walled;  ///< Indices of footprints with walls down to the ground.
  BoxGrid walled_grid;
};

/// Returns the ways outside of tunnels, and the footprints that stand on the ground.
/// @param footprints  Must outlive the result.
PostObstacles index_post_obstacles(std::span<const map::Track> tracks, std::span<const map::Footprint> footprints);

/// Returns the centres of the posts of a footprint, in the order of its border: inside each corner, and at most
/// kPostSpacing_m apart along long edges, a post's width from the border. Left out where a way passes, where another
/// footprint's wall carries the building, and where posts would touch. May be empty.
/// @param height_m  From their lower to their upper ends.
std::vector<Vec2> plan_posts(std::size_t footprint, const PostObstacles& obstacles, double height_m);

/// Returns the side of the square posts of a height: 1/30 of it, 0.125 to 0.75 m.
double post_width_m(double height_m);

/// Returns the posts of a building: four faces each, from post_foot_m to bottom_m.
std::vector<grammars::Face> post_faces(const Building& building);

/// The distance between posts.
inline constexpr double kPostSpacing_m = 6;

}  // namespace citykiln::buildings
