// The results of `check`: guarantees that hold or fail, and measures without a limit.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/mesh/reference.h"
#include "compiler/verify/heights/explain_earthworks.h"
#include "compiler/verify/heights/measure_clearances.h"
#include "compiler/verify/heights/measure_earthworks.h"
#include "compiler/verify/heights/measure_lines.h"
#include "compiler/verify/measure_ways.h"
#include "compiler/verify/standing/measure_blank_walls.h"

namespace citykiln::verify {

// Measures the reference ground of cells against the graded terrain. The graded terrain is a function of the place: the
// terrain after roads and water have cut into it. The reference is its triangulation at full detail, against which
// errors of coarser meshes are certified.

/// The deviations of the reference at sampled places.
struct ReferenceErrors {
  std::uint64_t places = 0;
  std::uint64_t over = 0;  ///< Places that deviate by more than 2 · ground::kReferenceError_m.
  double largest_m = 0;    ///< Near a vertical face, up to its height.
  Vec2 at;                 ///< The place of the largest deviation.
};

/// Combines two measurements: adds counts and keeps the larger deviation.
ReferenceErrors combined(const ReferenceErrors& a, const ReferenceErrors& b);

/// Returns the reference of the cell that contains a place.
using ReferenceAt = std::function<const ground::Reference&(Vec2)>;

/// Samples one random place in each square of a grid over the box, on the height layer of the land cover there. Skips
/// standing water. O(samples).
/// @param a_side  Squares along each side of the box.
ReferenceErrors measure_reference_errors(const ground::GradedTerrain& graded,
                                         std::span<const ground::LandCoverPolygon> surfaces,
                                         const ReferenceAt& reference_at, const Box2& box, int a_side);

/// A test that failed.
struct Failure {
  /// A line of text for the report.
  std::string text;
  std::optional<Vec2> at{};  ///< The place, in plane metres; empty if unknown.
  std::vector<OsmId> ids{};  ///< The elements concerned.
  double size = 0;           ///< The amount of the violation, in the text's unit; 0 if the text states none.
  std::string file{};        ///< The file of the tile, relative to the run's folder.

  // implicit, since most failures are only a text
  Failure(std::string line) : text(std::move(line)) {}  // NOLINT
  Failure(const char* line) : text(line) {}             // NOLINT
  Failure(std::string line, Vec2 place, std::vector<OsmId> of, double how_far, std::string in_file = {})
      : text(std::move(line)), at(place), ids(std::move(of)), size(how_far), file(std::move(in_file)) {}
};

/// A guarantee, the number of its tests, and the tests that failed.
struct Check {
  std::string claim;  ///< The guarantee as a sentence.
  std::uint64_t tests = 0;
  std::vector<Failure> failures;

  /// Counts one test, and stores the failure if the test does not hold. test_all() counts several.
  void test(bool holds, const Failure& failure) { test_all(1, holds, failure); }

  void test_all(std::uint64_t count, bool hold, const Failure& failure) {
    tests += count;
    if (!hold) failures.push_back(failure);
  }
};

/// The guarantees that `check` tests, and the measures that it reports.
struct CheckResults {
  Check files{
      "every file that files.json lists is there with its size and hash, and report.json names the same", 0, {}};
  Check stale{"no file with a name of a run's file is left of an earlier run", 0, {}};
  Check ledger{"every account of the ledger balances: in + split = out + merged + without_body + dropped", 0, {}};
  Check glb_bytes{"every .glb has exactly the bytes that baking the manifest gives", 0, {}};
  Check bend{"inside of a cylinder, every vertex of a .glb maps back to that of its recipe", 0, {}};
  Check area{"the ground's faces cover the plan area of the tile exactly once", 0, {}};
  Check height{"the ground is within error_m of the graded terrain", 0, {}};
  Check seams{"neighbouring tiles have the same border edges", 0, {}};
  Check jumps{"roads, bridges and tunnels have equal heights where they meet, within 1 cm", 0, {}};
  Check roads{"the ground is within error_m of the roads' height profiles", 0, {}};
  Check rivers{"no watercourse flows uphill", 0, {}};
  Check lakes{"lakes are level", 0, {}};
  Check footing{"the gap below every corner of a building is at most 5 cm, or error_m if that is more", 0, {}};
  Check standing{
      "no building on the ground has its floor a storey above the ground on all sides, or its top below it", 0, {}};
  Check openings{"no wall stands in a building's opening for a way, at levels up to 2.5 m", 0, {}};
  Check land{"no road, railway or watercourse is cut deep into a peak, or high over a hole, that stands alone", 0, {}};
  Check on_earth{"all heights lie between -500 and 9,000 m", 0, {}};
  Check areas{"no mapped area is hidden by a larger one that it lies in", 0, {}};
  Check tracks{"no railway or tramway runs below a carriageway, except where they cross", 0, {}};
  Check decks{"every bridge that the map has as an area has a deck", 0, {}};
  Check parts{"no building part differs in use, colour or material from its outline unless its tags say so", 0, {}};
  Check trunks{"no tree trunk stands in a road, a railway, a building or water", 0, {}};
  Check things{"no thing stands in a road, a railway, a building or water unless it is mapped there", 0, {}};
  Check wires{"no wire hangs lower than 4.5 m, less the tile's error, above a carriageway or railway", 0, {}};
  Check assumed_pavements{"no assumed pavement lies in water, a building, a railway or another road", 0, {}};
  Check assumed_lamps{"no assumed lamp stands on a carriageway, a railway, a building or water", 0, {}};
  Check parked_cars{
      "no parked car stands before a door, in a building, a railway or water, or off the paved ground", 0, {}};
  Check street_cars{"no car of a street, moving or parked, stands off its carriageway or in another car", 0, {}};
  Check street_furniture{
      "no assumed street furniture stands in a carriageway, a railway, a building or water, before a door or in other "
      "furniture",
      0,
      {}};
  Check people{"nobody stands in a carriageway, a railway, a building or water, or in a thing or lamp", 0, {}};
  Check assumed_railings{
      "no assumed railing stands in a carriageway, on steps, across a way, before a door, in a building or water",
      0,
      {}};
  Check assumed_masts{"no assumed mast stands in a carriageway, a building, water or the clearance of a track", 0, {}};
  Check assumed_yards{
      "no tree of an assumed yard stands in a building, way, water or barrier or below a power line, and no yard lies "
      "on mapped land",
      0,
      {}};
  Check assumed_hedges{
      "no assumed hedge, wall or guard rail stands in a carriageway, a railway, a building or water", 0, {}};
  Check assumed_houses{
      "no house that fills a lot stands on a road, a railway, a path, water or another building", 0, {}};
  Check assumed_fronts{"every assumed shop front lies on a free part of its wall", 0, {}};
  // only for runs that wrote USD
  Check usd_layers{"every USD layer holds together: indices, extents, prototypes, materials, textures", 0, {}};
  Check usd_same{"USD has the meshes, instances, ids and errors of the .glb or the recipes", 0, {}};
  Check usd_scene{"the USD scene has every tile at its place, and every tile its levels", 0, {}};
  Check tileset{
      "3D Tiles follow the specification, stand at the origin, and all contents are there and name the sources", 0, {}};
  Check tileset_boxes{"bounding volumes contain their contents and children", 0, {}};
  Check tileset_errors{"geometricError falls from parent to child and is at least the content's error_m", 0, {}};
  Check tileset_seams{
      "neighbouring contents of one level share a vertex, the highest of one of them, at each place of their border",
      0,
      {}};
  // reported without a limit
  std::vector<std::string> unlisted;  ///< Other files in the folder that the run did not write; folders end in "/".
  bool has_unfinished_run = false;    ///< A later run into the folder was interrupted.
  Grades grades;
  ReferenceErrors reference_errors;
  Clearances clearances;
  std::vector<CrossingStep> crossing_steps;    ///< Ways that cross on the ground at different heights.
  std::vector<Earthwork> earthworks;           ///< One cut and one fill per way, the largest first.
  std::vector<DeepEarthwork> deep_earthworks;  ///< Earthworks beyond the limit of their kind.
  std::vector<WayIntoWall> ways_into_walls;    ///< Ways that run into buildings without an opening for them.
  std::vector<BlankWall> blank_walls;          ///< Measured at the finest level.
};

/// Returns the guarantees in the order of printing; those of USD only if they were tested.
std::vector<const Check*> all_of(const CheckResults& results);

/// Adds the results of one tile. Failures are appended.
void add(CheckResults& results, const CheckResults& of_tile);

}  // namespace citykiln::verify
