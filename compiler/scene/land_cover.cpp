#include "compiler/scene/land_cover.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "compiler/buildings/meshes/passageways.h"
#include "compiler/contract/derived_id.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/ground/plan.h"
#include "compiler/pitches/panels.h"
#include "compiler/roads/junctions/corner_pavements.h"
#include "compiler/roads/junctions/through_road.h"
#include "compiler/roads/network.h"
#include "compiler/roads/pieces/drive_kerbs.h"
#include "compiler/roads/pieces/dropped_kerbs.h"
#include "compiler/roads/pieces/islands.h"
#include "compiler/roads/pieces/lane_changes.h"
#include "compiler/roads/pieces/lane_strips.h"
#include "compiler/scene/box_junctions.h"
#include "compiler/scene/drive_mouths.h"

namespace citykiln::scene {
namespace {

using ground::LandCoverPolygon;

// Joins neighbours of equal id, class and piece, such as the parts of a trimmed road, to one polygon.
void join_equal(std::vector<LandCoverPolygon>& surfaces) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < surfaces.size(); ++i) {
    LandCoverPolygon& last = surfaces[kept];
    if (last.id == surfaces[i].id && last.surface == surfaces[i].surface && last.piece == surfaces[i].piece) {
      last.rings.insert(last.rings.end(), surfaces[i].rings.begin(), surfaces[i].rings.end());
    } else if (++kept != i) {
      surfaces[kept] = std::move(surfaces[i]);
    }
  }
  surfaces.resize(std::min(surfaces.size(), kept + 1));
}

void add(LandCoverPolygon surface, std::vector<LandCoverPolygon>& surfaces) {
  if (!surface.rings.empty()) surfaces.push_back(std::move(surface));
}

LandCoverPolygon island_surface(const roads::TrafficIsland& island) {
  return {island_id(island.id), island.surface, ground::kStripArea_m2, {island.ring}};
}

std::vector<LandCoverPolygon> surfaces_without_roads(const CoverRecipes& recipes) {
  std::vector<LandCoverPolygon> surfaces(recipes.areas.begin(), recipes.areas.end());
  const auto arms = roads::arms_of(recipes.junctions, recipes.roads);
  for (std::size_t j = 0; j < recipes.junctions.size(); ++j) {
    // in a foreign manifest a junction may have no road
    if (arms[j].empty() || arms[j].size() != recipes.junctions[j].cuts.size()) continue;
    add(junction_surface(recipes.junctions[j], recipes.roads, arms[j]), surfaces);
    add(corner_pavement_surface(recipes.junctions[j], recipes.roads, arms[j]), surfaces);
  }
  for (const roads::TrafficIsland& island : roads::islands_of(recipes.roads)) add(island_surface(island), surfaces);
  for (const roads::Strip& stream : recipes.watercourses) add(ground::surface_of(stream), surfaces);
  for (const ground::Landform& form : recipes.landforms)
    if (form.surface != map::LandCoverClass::kUnknown) add(ground::surface_of(form), surfaces);
  for (const LandCoverPolygon& footprint : recipes.footprints) add(footprint, surfaces);
  return surfaces;
}

CoverRecipes cover_recipes_of(const Chunk& chunk) {
  CoverRecipes recipes{.areas = chunk.surfaces,
                       .roads = chunk.roads,
                       .junctions = chunk.junctions,
                       .watercourses = chunk.watercourses,
                       .landforms = chunk.landforms,
                       .footprints = {}};
  for (const buildings::Building& building : chunk.buildings)
    if (building.stands_on_ground) recipes.footprints.push_back(footprint_surface(building));
  return recipes;
}

void sort_and_join(std::vector<LandCoverPolygon>& surfaces) {
  std::ranges::stable_sort(surfaces, {},
                           [](const LandCoverPolygon& s) { return std::tuple(s.id, s.surface, s.piece); });
  join_equal(surfaces);
}

// Adds a road's pieces and returns the first unused run.
std::uint32_t add_pieces(const roads::Road& road, roads::RoadPieces&& made, std::uint32_t first_run, LandCover& cover) {
  const auto first_pattern = static_cast<std::uint32_t>(cover.layouts.size());
  std::uint32_t next_run = first_run;
  std::ranges::move(made.layouts, std::back_inserter(cover.layouts));
  for (roads::Piece& piece : made.pieces) {
    if (piece.layout != roads::kNoMarkingLayout) piece.layout += first_pattern;
    piece.run += first_run;
    next_run = std::max(next_run, piece.run + 1);
    cover.surfaces.push_back({road.id, piece.surface, ground::kStripArea_m2, {piece.ring}});
    cover.pieces.push_back(std::move(piece));
    cover.surfaces.back().piece = static_cast<std::uint32_t>(cover.pieces.size());
    cover.surfaces.back().is_graded = !road.profile.empty();
  }
  return next_run;
}

// The polygon of a pitch's area; null if the chunk has none.
const LandCoverPolygon* area_of(const pitches::Pitch& pitch, std::span<const LandCoverPolygon> surfaces) {
  const auto area = std::ranges::lower_bound(surfaces, pitch.id, {}, &LandCoverPolygon::id);
  return area != surfaces.end() && area->id == pitch.id ? &*area : nullptr;
}

// Adds the panels of a pitch that touch a box as pieces, and returns the first unused run.
std::uint32_t add_panels(const pitches::Pitch& pitch, const LandCoverPolygon& area, const Box2& box, double tolerance_m,
                         std::uint32_t first_run, LandCover& cover) {
  std::vector<roads::MarkingLayout> layouts;
  const auto first_layout = static_cast<std::uint32_t>(cover.layouts.size());
  for (pitches::Panel& panel : pitches::panels_of(pitch, area.surface, tolerance_m)) {
    if (!box_of(panel.ring).touches(box)) continue;
    std::vector<Ring> rings = pitches::rings_within(panel, area.rings);
    if (rings.empty()) continue;
    const auto layout = static_cast<std::uint32_t>(std::ranges::find(layouts, panel.layout) - layouts.begin());
    if (layout == layouts.size()) layouts.push_back(std::move(panel.layout));
    cover.pieces.push_back({.surface = area.surface,
                            .ring = std::move(panel.ring),
                            .frame = panel.frame,
                            .layout = first_layout + layout,
                            .run = first_run + layout});
    cover.surfaces.push_back({pitch.id, area.surface, ground::kStripArea_m2, std::move(rings)});
    cover.surfaces.back().piece = static_cast<std::uint32_t>(cover.pieces.size());
  }
  std::ranges::move(layouts, std::back_inserter(cover.layouts));
  return first_run + static_cast<std::uint32_t>(cover.layouts.size()) - first_layout;
}

// The class of the least of the roads that meet, below whose strips the others' lie.
map::LandCoverClass least_surface(std::span<const roads::Road> roads, std::span<const roads::Arm> arms) {
  const auto priority = [&](const roads::Arm& arm) { return roads::priority_of(roads[arm.road]); };
  return roads[std::ranges::min(arms, {}, priority).road].surface;
}

}  // namespace

ground::LandCoverPolygon junction_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                          std::span<const roads::Arm> arms) {
  assert(!arms.empty() && arms.size() == junction.cuts.size());
  const roads::Road& main = roads::main_road(roads, arms);
  const bool is_change = roads::is_lane_change(junction, roads, arms);
  const bool is_passed = is_change || roads::has_through_road(junction, roads, arms);
  ground::LandCoverPolygon surface{junction_id(main.id), is_change ? least_surface(roads, arms) : main.surface,
                                   is_passed ? ground::kPassedJunctionArea_m2 : ground::kJunctionArea_m2,
                                   roads::stroke(junction, roads, arms)};
  surface.is_graded =
      std::ranges::any_of(arms, [&](const roads::Arm& arm) { return !roads[arm.road].profile.empty(); });
  return surface;
}

ground::LandCoverPolygon corner_pavement_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                                 std::span<const roads::Arm> arms) {
  assert(!arms.empty() && arms.size() == junction.cuts.size());
  return {junction_id(roads::main_road(roads, arms).id), map::LandCoverClass::kPavement, ground::kStripArea_m2,
          roads::stroke_corner_pavements(junction, roads, arms)};
}

ground::LandCoverPolygon footprint_surface(ObjectId id, const Polygon& footprint) {
  ground::LandCoverPolygon surface{.id = id,
                                   .surface = map::LandCoverClass::kBuilding,
                                   .area_m2 = static_cast<std::uint32_t>(std::min(area_m2(footprint), 4.0e9)),
                                   .rings = {footprint.outer}};
  surface.rings.insert(surface.rings.end(), footprint.holes.begin(), footprint.holes.end());
  return surface;
}

ground::LandCoverPolygon footprint_surface(const buildings::Building& building) {
  ground::LandCoverPolygon surface = footprint_surface(building.id, building.footprint);
  // a clockwise ring lowers the winding number to 0 or less
  for (const buildings::Passageway& passageway : building.passageways)
    for (Ring& ring : buildings::opening_rings(passageway)) {
      std::ranges::reverse(ring);
      surface.rings.push_back(std::move(ring));
    }
  return surface;
}

std::vector<LandCoverPolygon> coarse_land_cover(const CoverRecipes& recipes) {
  std::vector<LandCoverPolygon> surfaces = surfaces_without_roads(recipes);
  const std::vector<roads::StripEnds> ends = roads::ends_of(recipes.roads);
  for (std::size_t i = 0; i < recipes.roads.size(); ++i) {
    add(ground::surface_of(recipes.roads[i], ends[i]), surfaces);
    add(ground::pavement_of(recipes.roads[i], ends[i]), surfaces);
  }
  sort_and_join(surfaces);
  return surfaces;
}

std::vector<LandCoverPolygon> coarse_land_cover(const Chunk& chunk) {
  return coarse_land_cover(cover_recipes_of(chunk));
}

namespace {

// Adds the kerbs round corners, where kerbs are wide enough to be seen.
void add_corner_kerbs(const Chunk& chunk, double tolerance_m, std::vector<LandCoverPolygon>& surfaces) {
  if (roads::kKerb_m < tolerance_m) return;
  const auto arms = roads::arms_of(chunk.junctions, chunk.roads);
  for (std::size_t j = 0; j < chunk.junctions.size(); ++j) {
    // in a foreign manifest a junction may have no road
    if (arms[j].empty() || arms[j].size() != chunk.junctions[j].cuts.size()) continue;
    add({junction_id(roads::main_road(chunk.roads, arms[j]).id), map::LandCoverClass::kKerb, ground::kStripArea_m2,
         roads::stroke_corner_kerbs(chunk.junctions[j], chunk.roads, arms[j], roads::kKerb_m)},
        surfaces);
  }
}

}  // namespace

vacant::Plots plots_of(const Header& header, const Chunk& chunk) {
  if (!header.has_street_furniture) return {};
  const Box2 tile = box_of(header, chunk.tile);
  const std::vector<LandCoverPolygon> surfaces = coarse_land_cover(chunk);
  const ground::LandCoverIndex index = ground::index_land_cover(surfaces, tile.widened(kHalo_m));
  return vacant::plots_of({chunk.surfaces, chunk.roads, chunk.buildings, index, tile, header.seed});
}

LandCover land_cover_of(const Header& header, const Chunk& chunk, double tolerance_m) {
  assert(tolerance_m > 0);
  std::vector<LandCoverPolygon> plots = plots_of(header, chunk).surfaces;
  add(beyond_clip(header.clip, box_of(header, chunk.tile).widened(kHalo_m)), plots);
  if (!has_detail(Detail::kRoadSurfaces, tolerance_m)) {
    LandCover cover{coarse_land_cover(chunk), {}, {}};
    std::ranges::move(plots, std::back_inserter(cover.surfaces));
    sort_and_join(cover.surfaces);
    return cover;
  }
  LandCover cover{surfaces_without_roads(cover_recipes_of(chunk)), {}, {}};
  std::ranges::move(plots, std::back_inserter(cover.surfaces));
  add_corner_kerbs(chunk, tolerance_m, cover.surfaces);
  const std::vector<roads::StripEnds> ends = roads::ends_of(chunk.roads);
  const auto changes = roads::lane_changes_of(chunk.roads, chunk.junctions);
  const auto gaps = roads::junction_intervals_of(chunk.roads, chunk.junctions);
  const std::vector<roads::DriveMouth> mouths = drive_mouths_of(header, chunk);
  std::uint32_t next_run = 0;
  for (std::size_t i = 0; i < chunk.roads.size(); ++i) {
    const roads::Road& road = chunk.roads[i];
    auto stretches = roads::with_dropped_kerbs(road, roads::stretches_of(road, gaps[i], header.tile_m), gaps[i],
                                               header.has_street_furniture);
    stretches = roads::cut_at_drives(stretches, roads::drive_kerbs_of(road, stretches, gaps[i], mouths));
    next_run = add_pieces(road, roads::pieces_of(road, ends[i], stretches, changes[i], header.tile_m, tolerance_m),
                          next_run, cover);
  }
  const Box2 tile = box_of(header, chunk.tile).widened(1);
  for (const pitches::Pitch& pitch : chunk.pitches)
    if (const LandCoverPolygon* area = area_of(pitch, chunk.surfaces))
      next_run = add_panels(pitch, *area, tile, tolerance_m, next_run, cover);
  add_box_junctions(chunk.roads, chunk.junctions, next_run, cover);
  sort_and_join(cover.surfaces);
  return cover;
}

}  // namespace citykiln::scene
