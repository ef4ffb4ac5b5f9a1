#include "compiler/scene/assemble.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <optional>
#include <string_view>

#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/plan.h"
#include "compiler/roads/trim.h"
#include "compiler/scene/kinds.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::scene {
namespace {

// Indices of the objects in each tile, tiles in the order of tiles_of().
using ByTile = std::vector<std::vector<std::uint32_t>>;

// The grid of tiles over the region.
struct TileGrid {
  const Header& header;
  std::vector<TileKey> tiles;
  std::int32_t columns, rows;

  explicit TileGrid(const Header& h)
      : header(h),
        tiles(tiles_of(h)),
        columns(tiles.back().x - tiles.front().x + 1),
        rows(tiles.back().y - tiles.front().y + 1) {}

  std::int32_t column(double x) const { return clamped(x, tiles.front().x, columns); }
  std::int32_t row(double y) const { return clamped(y, tiles.front().y, rows); }
  std::size_t index(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(column) * rows + row;
  }

  // The tile of an object anchored here; the nearest one for anchors outside the region.
  std::size_t owner(Vec2 anchor) const { return index(column(anchor.x), row(anchor.y)); }
  std::size_t index_of(TileKey tile) const { return index(tile.x - tiles.front().x, tile.y - tiles.front().y); }

 private:
  std::int32_t clamped(double v, std::int32_t first, std::int32_t count) const {
    return std::clamp(static_cast<std::int32_t>(std::floor(v / header.tile_m)) - first, 0, count - 1);
  }
};

// Puts each object into the tile of its anchor.
template <typename Object, typename Anchor>
ByTile by_anchor(const TileGrid& grid, std::span<const Object> objects, Anchor anchor_of) {
  ByTile tiles(grid.tiles.size());
  for (std::uint32_t i = 0; i < objects.size(); ++i) tiles[grid.owner(anchor_of(objects[i]))].push_back(i);
  return tiles;
}

// Puts each object into the tile that bakes it.
template <typename Object, typename TileOf>
ByTile by_baking_tile(const TileGrid& grid, std::span<const Object> objects, TileOf tile_of) {
  ByTile tiles(grid.tiles.size());
  for (std::uint32_t i = 0; i < objects.size(); ++i) tiles[grid.index_of(tile_of(objects[i]))].push_back(i);
  return tiles;
}

// Puts each object into every tile that its box, widened by kHalo_m, touches.
template <typename Object, typename BoxOf>
ByTile by_touch(const TileGrid& grid, std::span<const Object> objects, BoxOf box) {
  ByTile tiles(grid.tiles.size());
  for (std::uint32_t i = 0; i < objects.size(); ++i) {
    const Box2 wide = box(objects[i]).widened(kHalo_m);
    if (wide.is_empty()) continue;
    for (std::int32_t c = grid.column(wide.min.x); c <= grid.column(wide.max.x); ++c)
      for (std::int32_t r = grid.row(wide.min.y); r <= grid.row(wide.max.y); ++r)
        if (box_of(grid.header, grid.tiles[grid.index(c, r)]).touches(wide)) tiles[grid.index(c, r)].push_back(i);
  }
  return tiles;
}

// The objects of each kind by tile, under the names of the members of Chunk.
struct Sorted {
  ByTile near_buildings;
#define ELEMENT(type, member) ByTile member;
#define PART(type, member) ByTile member;
#include "compiler/scene/kinds.inc"
};

Box2 box_of_road(const roads::Road& road) {
  return citykiln::box_of(road.axis).widened(max_offset_m(road) + kRoadHalo_m - kHalo_m);
}

Box2 box_of_strip(const roads::Strip& strip) {
  return citykiln::box_of(strip.axis).widened(ground::influence_radius_m(strip) + ground::kGrading_m);
}

// by_touch() widens by more than the reach of a landform from its edge and kGrading_m together.
Box2 box_of_landform(const ground::Landform& form) {
  return citykiln::box_of(form.axis).widened(std::max(form.left_m, form.right_m));
}
static_assert(ground::kLandformReach_m + ground::kGrading_m <= kHalo_m);

// by_touch() widens by kHalo_m, which is more than panels are wider than their lines.
Box2 box_of_pitch(const pitches::Pitch& pitch) {
  return box_of_segment(pitch.from, pitch.to).widened(pitch.width_m / 2);
}

// by_touch() widens by kHalo_m, which is more than plants need.
Box2 near_tile(const Box2& box) { return box.widened(plants::kObstacleInfluence_m - kHalo_m); }

// Adds objects to each tile, without repetitions.
void add_to(ByTile& tiles, const ByTile& more) {
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    tiles[t].insert(tiles[t].end(), more[t].begin(), more[t].end());
    sort_unique(tiles[t]);
  }
}

// Puts each line into every tile whose plants may depend on one of its segments. The box of a whole long line would
// touch tiles far away from it.
// @param half_m  Returns half the width of a line; empty for a line that belongs to no tile.
template <typename Line, typename HalfWidth>
ByTile by_segments(const TileGrid& grid, std::span<const Line> lines, HalfWidth half_m) {
  std::vector<Box2> boxes;
  std::vector<std::uint32_t> line_of;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const std::optional<double> half = half_m(lines[i]);
    for (std::size_t s = 0; half && s + 1 < lines[i].axis.size(); ++s) {
      boxes.push_back(near_tile(citykiln::box_of(std::span(lines[i].axis).subspan(s, 2)).widened(*half)));
      line_of.push_back(i);
    }
  }
  ByTile tiles = by_touch(grid, std::span<const Box2>(boxes), [](const Box2& box) { return box; });
  for (std::vector<std::uint32_t>& tile : tiles) {
    for (std::uint32_t& segment : tile) segment = line_of[segment];
    sort_unique(tile);
  }
  return tiles;
}

// Puts spans into the tiles whose ground they grade, and into the tile that bakes them.
ByTile spans_by_tile(const TileGrid& grid, std::span<const structures::Span> spans) {
  ByTile tiles = by_touch(grid, spans, [](const structures::Span& s) {
    Box2 box = citykiln::box_of(s.axis).widened(max_offset_m(s));
    for (const Vec3 corner : structures::plate_corners(s)) box.grow(in_plan(corner));
    return box.widened(ground::kGrading_m);
  });
  add_to(tiles, by_baking_tile(grid, spans, [&](const auto& span) { return baking_tile(grid.header, span); }));
  return tiles;
}

// Puts barriers into the tile of their first point, hedges into all tiles that they touch.
ByTile barriers_by_tile(const TileGrid& grid, std::span<const props::Barrier> barriers) {
  ByTile hedges = by_segments(grid, barriers, [](const props::Barrier& b) {
    return b.kind == map::BarrierKind::kHedge ? std::optional(0.0) : std::nullopt;
  });
  add_to(hedges, by_anchor(grid, barriers, [](const props::Barrier& b) { return b.axis.front(); }));
  return hedges;
}

// The place that decides to which tile an object belongs.
template <typename Object>
Vec2 anchor_of(const Object& object) {
  if constexpr (requires { object.at; })
    return object.at;
  else
    return middle_of(object);
}

// The tiles of the objects of a kind: as a rule those of their anchors.
template <typename Object>
ByTile tiles_of(const TileGrid& grid, std::span<const Object> objects) {
  return by_anchor(grid, objects, [](const Object& object) { return anchor_of(object); });
}
// Buildings belong to the tile of the middle of their box.
ByTile tiles_of(const TileGrid& grid, std::span<const buildings::Building> buildings) {
  return by_baking_tile(grid, buildings, [&](const buildings::Building& building) {
    const Box2 box = citykiln::box_of(building.footprint.outer);
    return baking_tile(grid.header, box.centre(), box);
  });
}
ByTile tiles_of(const TileGrid& grid, std::span<const ground::LandCoverPolygon> surfaces) {
  return by_touch(grid, surfaces, ground::box_of);
}
ByTile tiles_of(const TileGrid& grid, std::span<const roads::Road> roads) { return by_touch(grid, roads, box_of_road); }
ByTile tiles_of(const TileGrid& grid, std::span<const roads::Strip> streams) {
  return by_touch(grid, streams, box_of_strip);
}
ByTile tiles_of(const TileGrid& grid, std::span<const ground::Landform> forms) {
  return by_touch(grid, forms, box_of_landform);
}
ByTile tiles_of(const TileGrid& grid, std::span<const pitches::Pitch> pitches) {
  return by_touch(grid, pitches, box_of_pitch);
}
ByTile tiles_of(const TileGrid& grid, std::span<const structures::Span> spans) { return spans_by_tile(grid, spans); }
ByTile tiles_of(const TileGrid& grid, std::span<const props::Barrier> barriers) {
  return barriers_by_tile(grid, barriers);
}
ByTile tiles_of(const TileGrid& grid, std::span<const plants::Tree> trees) {
  return by_touch(grid, trees, [](const auto& t) { return near_tile({t.at, t.at}); });
}
ByTile tiles_of(const TileGrid& grid, std::span<const plants::TreeRow> rows) {
  return by_segments(grid, rows, [](const auto&) { return std::optional(0.0); });
}
ByTile tiles_of(const TileGrid& grid, std::span<const plants::PowerLineCorridor> corridors) {
  return by_segments(grid, corridors, [](const auto& c) { return std::optional(c.width_m / 2); });
}
ByTile tiles_of(const TileGrid& grid, std::span<const lots::Yard> yards) {
  return by_touch(grid, yards, [](const lots::Yard& yard) { return citykiln::box_of(yard.polygon.outer); });
}
// Junctions are sorted by their polygons; woods and plantings are where their surfaces are.
ByTile tiles_of(const TileGrid&, std::span<const roads::Junction>) { return {}; }
ByTile tiles_of(const TileGrid&, std::span<const plants::Wood>) { return {}; }
ByTile tiles_of(const TileGrid&, std::span<const plants::Planting>) { return {}; }

Sorted sort_by_tile(const TileGrid& grid, const Recipes& recipes, std::span<const ground::LandCoverPolygon> junctions) {
  Sorted sorted;
#define ELEMENT(type, member) sorted.member = tiles_of(grid, std::span<const type>(recipes.member));
#define PART(type, member) sorted.member = tiles_of(grid, std::span<const type>(recipes.member));
#include "compiler/scene/kinds.inc"
  sorted.junctions = by_touch(grid, junctions, ground::box_of);
  sorted.near_buildings =
      by_touch(grid, std::span(recipes.buildings), [](const auto& b) { return citykiln::box_of(b.footprint.outer); });
  return sorted;
}

// Kinds whose recipes are trimmed to the tile, or depend on others of the chunk: chunk_of() sets them itself.
template <typename Object>
constexpr bool kIsTrimmed = std::derived_from<Object, roads::Strip> || std::same_as<Object, roads::Road> ||
                            std::same_as<Object, ground::LandCoverPolygon> || std::same_as<Object, roads::Junction> ||
                            std::same_as<Object, plants::Wood> || std::same_as<Object, plants::Planting>;

template <typename Object>
void pick(std::span<const Object> objects, const ByTile& tiles, std::size_t t, std::vector<Object>& picked) {
  if constexpr (!kIsTrimmed<Object>)
    for (const std::uint32_t i : tiles[t]) picked.push_back(objects[i]);
}

bool covers_tile(const ground::LandCoverPolygon& surface, const Box2& tile) {
  return ground::box_of(surface).touches(tile.widened(1));
}

// True if all arms of a junction are among the chunk's roads.
bool has_all_arms(const roads::Junction& junction, const Box2& tile) {
  const Box2 needed = citykiln::box_of(junction.nodes).widened(roads::kJunctionRadius_m),
             known = tile.widened(kRoadHalo_m);
  return known.contains(needed.min) && known.contains(needed.max);
}

// The polygons of each junction and of the pavements around its corners.
struct JunctionCovers {
  std::vector<ground::LandCoverPolygon> surfaces, pavements;
};

// Returns the trimmed polygons of areas, and of the junctions and footprints for which the chunk has no recipe.
std::vector<ground::LandCoverPolygon> surfaces_for(const Recipes& recipes, const Sorted& sorted,
                                                   const JunctionCovers& junctions, std::size_t t, const Box2& tile) {
  const Box2 halo = tile.widened(kHalo_m);
  std::vector<ground::LandCoverPolygon> surfaces;
  const auto add = [&](const ground::LandCoverPolygon& whole) {
    ground::LandCoverPolygon trimmed = ground::trimmed_to(whole, halo);
    if (!trimmed.rings.empty()) surfaces.push_back(std::move(trimmed));
  };
  for (const std::uint32_t i : sorted.surfaces[t]) add(recipes.surfaces[i]);
  for (const std::uint32_t i : sorted.junctions[t]) {
    if (has_all_arms(recipes.junctions[i], tile)) continue;
    if (covers_tile(junctions.surfaces[i], tile)) add(junctions.surfaces[i]);
    if (covers_tile(junctions.pavements[i], tile)) add(junctions.pavements[i]);
  }
  const std::vector<std::uint32_t>& own = sorted.buildings[t];
  for (const std::uint32_t i : sorted.near_buildings[t])
    if (recipes.buildings[i].stands_on_ground && !std::binary_search(own.begin(), own.end(), i))
      add(footprint_surface(recipes.buildings[i]));
  std::stable_sort(surfaces.begin(), surfaces.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return surfaces;
}

template <typename Strip>
std::vector<Strip> strips_for(std::span<const Strip> strips, const std::vector<std::uint32_t>& numbers,
                              const Box2& tile, double halo_m) {
  std::vector<Strip> runs;
  for (const std::uint32_t i : numbers)
    for (Strip& run : roads::trimmed_to(strips[i], tile, halo_m)) runs.push_back(std::move(run));
  return runs;
}

// Lines are trimmed, areas whole.
std::vector<ground::Landform> landforms_for(std::span<const ground::Landform> forms,
                                            const std::vector<std::uint32_t>& numbers, const Box2& tile) {
  std::vector<ground::Landform> here;
  for (const std::uint32_t i : numbers) {
    if (is_area(forms[i].kind)) {
      here.push_back(forms[i]);
      continue;
    }
    const double margin_m = kHalo_m + std::max(forms[i].left_m, forms[i].right_m);
    for (const roads::Strip& run : roads::trimmed_to(static_cast<const roads::Strip&>(forms[i]), tile, margin_m))
      here.push_back({run, forms[i].kind});
  }
  return here;
}

std::vector<roads::Junction> junctions_for(const Recipes& recipes, const Sorted& sorted, std::size_t t,
                                           const Box2& tile) {
  std::vector<roads::Junction> complete;
  for (const std::uint32_t i : sorted.junctions[t])
    if (has_all_arms(recipes.junctions[i], tile)) complete.push_back(recipes.junctions[i]);
  return complete;
}

JunctionCovers junction_covers(const Recipes& recipes, int threads) {
  const auto arms = roads::arms_of(recipes.junctions, recipes.roads);
  const auto each = [&](auto cover_of_junction) {
    return for_each_slot<ground::LandCoverPolygon>(recipes.junctions.size(), threads, [&](std::size_t i) {
      return cover_of_junction(recipes.junctions[i], recipes.roads, arms[i]);
    });
  };
  return {each(junction_surface), each(corner_pavement_surface)};
}

// The woods or plantings of these surfaces, which are sorted by id.
template <typename Growing>
std::vector<Growing> growing_on(const std::vector<ground::LandCoverPolygon>& surfaces, std::span<const Growing> all) {
  std::vector<Growing> here;
  for (const Growing& growing : all) {
    const auto found = std::lower_bound(surfaces.begin(), surfaces.end(), growing.surface,
                                        [](const auto& s, ObjectId id) { return s.id < id; });
    if (found != surfaces.end() && found->id == growing.surface) here.push_back(growing);
  }
  return here;
}

// The texts of the elements from which the chunk's recipes are made.
std::vector<map::ElementText> texts_for(std::span<const map::ElementText> texts, const Chunk& chunk) {
  std::vector<OsmId> ids;
  for_each_element_kind(chunk, [&](std::string_view, const auto& objects) {
    for (const auto& object : objects) ids.push_back(object.id.osm);
  });
  sort_unique(ids);
  std::vector<map::ElementText> here;
  for (const OsmId id : ids)
    if (const map::ElementText* text = map::find_text(texts, id)) here.push_back(*text);
  return here;
}

Chunk chunk_of(const Recipes& recipes, const Sorted& sorted, const JunctionCovers& junctions, const TileGrid& grid,
               std::size_t t) {
  const Box2 tile = box_of(grid.header, grid.tiles[t]);
  Chunk chunk;
  chunk.tile = grid.tiles[t];
  chunk.heights = map::window_of(recipes.heights, tile.widened(kHalo_m));
#define ELEMENT(type, member) pick<type>(recipes.member, sorted.member, t, chunk.member);
#define PART(type, member) pick<type>(recipes.member, sorted.member, t, chunk.member);
#include "compiler/scene/kinds.inc"
  chunk.surfaces = surfaces_for(recipes, sorted, junctions, t, tile);
  chunk.roads = strips_for(recipes.roads, sorted.roads[t], tile, kRoadHalo_m);
  chunk.junctions = junctions_for(recipes, sorted, t, tile);
  chunk.watercourses = strips_for(recipes.watercourses, sorted.watercourses[t], tile, kHalo_m);
  chunk.landforms = landforms_for(recipes.landforms, sorted.landforms[t], tile);
  chunk.woods = growing_on(chunk.surfaces, recipes.woods);
  chunk.plantings = growing_on(chunk.surfaces, recipes.plantings);
  chunk.texts = texts_for(recipes.texts, chunk);
  return chunk;
}

}  // namespace

Scene assemble(const Recipes& recipes, const Header& header, std::span<const TileKey> only, int threads) {
  assert(header.tile_m > 0 && header.extent.width() > 0 && header.extent.height() > 0);
  const TileGrid grid(header);
  const JunctionCovers junctions = junction_covers(recipes, threads);
  const Sorted sorted = sort_by_tile(grid, recipes, junctions.surfaces);
  std::vector<std::size_t> wanted;
  for (std::size_t t = 0; t < grid.tiles.size(); ++t)
    if ((only.empty() || std::find(only.begin(), only.end(), grid.tiles[t]) != only.end()) &&
        touches_clip(header.clip, box_of(header, grid.tiles[t])))
      wanted.push_back(t);
  return {header, for_each_slot<Chunk>(wanted.size(), threads, [&](std::size_t i) {
            return chunk_of(recipes, sorted, junctions, grid, wanted[i]);
          })};
}

}  // namespace citykiln::scene
