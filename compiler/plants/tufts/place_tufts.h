// Places tufts of grass and flowers on lawns, verges and meadows beside the ground that people walk on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/climate/climate_field.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/plants/season.h"
#include "compiler/plants/tufts/tuft_form.h"

namespace citykiln::plants {

/// Tufts are densest up to kDenseTufts_m from walked ground, and thin out up to kTuftReach_m.
inline constexpr double kTuftReach_m = 8, kDenseTufts_m = 3;
/// The least distance of a tuft's foot from walked ground, over whose border its blades hang.
inline constexpr double kTuftClearance_m = 0.03125;

/// A piece of a wall or hedge, in which no tuft stands.
struct TuftObstacle {
  Vec2 from, to;
  double half_width_m = 0;
};

/// The ground of tufts.
struct TuftGround {
  const ground::LandCoverIndex& cover;   ///< Covers the box in which tufts are placed.
  const ground::LandCoverIndex& walked;  ///< Walked ground alone: covers the box widened by kTuftReach_m.
  const ground::GradedTerrain& graded;
  const climate::ClimateField& climate;
  climate::LocalMonth local_month{6};
  Month month = kMidsummer;  ///< Decides which plants are in flower.
  std::uint64_t seed = 0;
  /// The probability with which a place farther than kTuftReach_m from walked ground has its tuft, 0 to 1.
  double far_share = 0;
  /// Walls and hedges: a tuft stands at least half of its height away from them.
  std::span<const TuftObstacle> obstacles{};
};

/// A tuft. Placement::scale is its height in metres, Placement::feature the element of its land cover.
struct Tuft {
  TuftForm form{};
  std::uint8_t variant = 0;   ///< Below kTuftVariants.
  std::uint32_t surface = 0;  ///< Its land cover: an index in LandCoverIndex::surfaces.
  Placement placement;
};

/// True for ground beside which tufts stand: roads, paths, squares, drives, and buildings.
bool is_walked(map::LandCoverClass cover);

/// Returns the polygons of walked ground that touch a box.
std::vector<ground::LandCoverPolygon> walked_ground(std::span<const ground::LandCoverPolygon> surfaces,
                                                    const Box2& box);

/// Returns the tufts in a half-open box: at most one for each square with the side `spacing_m`, fewer far from walked
/// ground, fewer on dry grass, none on bare ground. A tuft does not depend on the box, so boxes may be divided in any
/// way. O(box / spacing² · edges near).
std::vector<Tuft> place_tufts(const TuftGround& land, const Box2& box, double spacing_m);

}  // namespace citykiln::plants
