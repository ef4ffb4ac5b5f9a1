#include "compiler/bake/cells/bake_cell.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "compiler/bake/bake_level.h"
#include "compiler/bake/ground/ground_beyond.h"
#include "compiler/bake/parts/bake_instances.h"
#include "compiler/bake/view_markings.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/map/locate.h"
#include "compiler/props/generate.h"
#include "compiler/scene/shown_chunk.h"

namespace citykiln::bake {

std::size_t cell_at(const Box2& tile, Vec2 place) {
  const auto columns = static_cast<std::size_t>(tile.width() / map::kCell_m),
             rows = static_cast<std::size_t>(tile.height() / map::kCell_m);
  const auto index = [](double from_m, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(std::floor(from_m / map::kCell_m), 0.0, static_cast<double>(count - 1)));
  };
  return index(place.x - tile.min.x, columns) * rows + index(place.y - tile.min.y, rows);
}

// The objects that one cell bakes at one level, as indices among the chunk's objects.
struct CellObjects {
#define ELEMENT(type, member) std::vector<std::uint32_t> member{};
#define PART(type, member)
#include "compiler/scene/kinds.inc"
  std::shared_ptr<SharedByLevels> placed{};  // graded terrain, and the cell's own plants, lamps, pits and stairs
};

// By index among the tile's parts.
using CellParts = std::map<std::size_t, CellObjects>;

// The sizes that prototypes have for one part of the tile.
struct PartSizes {
  std::map<plants::Prototype, double> plants_m{};
  std::map<props::LampKind, double> lamps_m{};
};

namespace {

template <typename Key>
void raise(std::map<Key, double>& tallest_m, Key key, double height_m) {
  double& most = tallest_m[key];
  most = std::max(most, height_m);
}

}  // namespace

struct CellTile {
  const scene::Header& header;
  std::shared_ptr<const scene::Chunk> shown;  // `chunk` is in it
  const scene::Chunk& chunk;
  const ViewLevels& view;
  std::shared_ptr<const PrototypeCache> prototypes;
  Box2 box = scene::box_of(header, chunk.tile);
  std::vector<int> parts = levels_of_parts(view, header, chunk);
  std::vector<ViewCell> cells = cells_of(view, box);
  std::vector<Box2> beyond = ground_beyond(header, chunk);
  std::vector<TileLevel> levels{};  // one per part: land cover and markings
  std::vector<std::shared_ptr<const ground::GradedTerrain>> graded{};
  std::vector<PartSizes> sizes{};    // one per part
  std::vector<CellParts> objects{};  // one per cell
};

namespace {

// Sorts the objects of a tile into its cells.
class Sorter {
 public:
  explicit Sorter(CellTile& tile) : tile_(tile) {
    tile.objects.resize(tile.cells.size()), tile.sizes.resize(tile.parts.size());
    for (std::size_t part = 0; part < tile.levels.size(); ++part) shared_.push_back(tile.levels[part].shared);
  }

  void sort() {
    const scene::Chunk& chunk = tile_.chunk;
#define ELEMENT(type, member) number(chunk.member, &CellObjects::member);
#define PART(type, member)
#include "compiler/scene/kinds.inc"
    // levels with and without road surfaces have one each
    for (std::size_t part = 0; part < shared_.size(); ++part)
      if (part == 0 || shared_[part] != shared_[part - 1]) sort_placed(*shared_[part]);
    drop_small_plants();
  }

 private:
  std::size_t part_of(const Bounds& bounds) const { return part_at(tile_.parts, level_for(tile_.view.view, bounds)); }

  template <typename Object>
  void number(const std::vector<Object>&, std::vector<std::uint32_t> CellObjects::*) {}
  template <Bounded Object>
  void number(const std::vector<Object>& all, std::vector<std::uint32_t> CellObjects::*list) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Bounds bounds = bounds_in(tile_.chunk, all[i]);
      CellObjects& objects = tile_.objects[cell_at(tile_.box, bounds.plan.centre())][part_of(bounds)];
      (objects.*list).push_back(static_cast<std::uint32_t>(i));
    }
  }

  // The place for an object of `shared`; null where its part has other ones.
  SharedByLevels* place(const SharedByLevels& shared, const Bounds& bounds, Vec2 at) {
    const std::size_t part = part_of(bounds);
    if (shared_[part].get() != &shared) return nullptr;
    std::shared_ptr<SharedByLevels>& placed = tile_.objects[cell_at(tile_.box, at)][part].placed;
    if (!placed) placed = std::make_shared<SharedByLevels>(SharedByLevels{.graded = shared.graded});
    return placed.get();
  }

  void sort_placed(const SharedByLevels& shared) {
    sort_plants(shared, shared.trees, &SharedByLevels::trees);
    sort_plants(shared, shared.blades, &SharedByLevels::blades);
    for (const props::StreetLamp& lamp : shared.lamps.standing) {
      const Bounds bounds = bounds_of(props::place(lamp, *shared.graded));
      SharedByLevels* own = place(shared, bounds, lamp.at);
      if (own == nullptr) continue;
      own->lamps.standing.push_back(lamp);
      raise(tile_.sizes[part_of(bounds)].lamps_m, lamp.kind, props::place(lamp, *shared.graded).scale);
    }
    for (const PlacedThing& thing : shared.things)
      if (SharedByLevels* own = place(shared, bounds_of(thing), in_plan(thing.placement.at)))
        own->things.push_back(thing);
    for (const props::TreePit& pit : shared.pits) {
      const Bounds bounds = bounds_of_pit(pit, *shared.graded);
      if (SharedByLevels* own = place(shared, bounds, pit.at)) own->pits.push_back(pit);
    }
    for (const structures::Stairs& stairs : shared.stairs) {
      const Bounds bounds = bounds_of(stairs);
      if (SharedByLevels* own = place(shared, bounds, bounds.plan.centre())) own->stairs.push_back(stairs);
    }
  }

  void sort_plants(const SharedByLevels& shared, const plants::PlacedPlants& all,
                   plants::PlacedPlants SharedByLevels::*list) {
    for (const auto& [prototype, placements] : all)
      for (const Placement& p : placements) {
        const Bounds bounds = bounds_of(p);
        const double tolerance_m = tile_.levels[part_of(bounds)].tolerance_m;
        if (list == &SharedByLevels::blades && !has_detail(Detail::kGrassBlades, tolerance_m)) continue;
        SharedByLevels* own = place(shared, bounds, in_plan(p.at));
        if (own == nullptr) continue;
        (own->*list)[prototype].push_back(p);
        raise(tile_.sizes[part_of(bounds)].plants_m, merged_variant(prototype, tolerance_m), p.scale);
      }
  }

  // Far plants that their tolerance drops would be most of the memory.
  void drop_small_plants() {
    for (std::size_t part = 0; part < tile_.parts.size(); ++part) {
      const double tolerance_m = tile_.levels[part].tolerance_m;
      const auto is_dropped = [&](const auto& placed) {
        const plants::Prototype merged = merged_variant(placed.first, tolerance_m);
        const double height_m = prototype_height_m(tile_.sizes[part].plants_m.at(merged));
        if (tolerance_m >= height_m) return true;
        return tile_.prototypes->prototype(merged, height_m, tolerance_m).primitives.empty();
      };
      for (CellParts& parts : tile_.objects)
        if (const auto own = parts.find(part); own != parts.end() && own->second.placed)
          std::erase_if(own->second.placed->trees, is_dropped), std::erase_if(own->second.placed->blades, is_dropped);
    }
  }

  CellTile& tile_;
  std::vector<std::shared_ptr<const SharedByLevels>> shared_;
};

template <typename Object>
std::vector<Object> chosen(const std::vector<Object>& all, const std::vector<std::uint32_t>& numbers) {
  std::vector<Object> some;
  for (const std::uint32_t i : numbers) some.push_back(all[i]);
  return some;
}

// A chunk of the cell's objects alone.
scene::Chunk chunk_of(const scene::Chunk& all, const CellObjects& objects) {
  scene::Chunk chunk;
  chunk.tile = all.tile, chunk.heights = all.heights;
#define ELEMENT(type, member) chunk.member = chosen(all.member, objects.member);
#define PART(type, member)
#include "compiler/scene/kinds.inc"
  return chunk;
}

TileLevel level_of(const CellTile& tile, std::size_t cell, std::size_t part, const CellObjects& objects) {
  TileLevel level = tile.levels[part];
  level.shared = objects.placed ? std::shared_ptr<const SharedByLevels>(objects.placed)
                                : std::make_shared<SharedByLevels>(SharedByLevels{.graded = tile.graded[part]});
  if (tile.cells[cell].number != tile.parts[part]) return level;
  std::vector<Box2> beyond;
  std::ranges::copy_if(tile.beyond, std::back_inserter(beyond),
                       [&](const Box2& box) { return cell_beside(tile.cells, box) == cell; });
  generate_ground(level, {tile.cells[cell]}, beyond, 1);
  return level;
}

std::size_t bytes_of(const std::vector<ground::LandCoverPolygon>& polygons) {
  std::size_t bytes = 0;
  for (const ground::LandCoverPolygon& polygon : polygons) {
    bytes += sizeof(polygon);
    for (const Ring& ring : polygon.rings) bytes += sizeof(ring) + ring.capacity() * sizeof(Vec2);  // NOLINT
  }
  return bytes;
}

std::size_t bytes_of(const scene::LandCover& cover) {
  return bytes_of(cover.surfaces) + cover.pieces.capacity() * sizeof(roads::Piece) +
         cover.layouts.capacity() * sizeof(roads::MarkingLayout);
}

// Edges of polygons are indexed by bucket, a few times each.
std::size_t bytes_of(const ground::GradedTerrain& graded) {
  return graded.terrain.heights.capacity() * sizeof(std::int32_t) +
         6 * (bytes_of(graded.paved) + bytes_of(graded.wet)) +
         graded.roads.segments.capacity() * (sizeof(ground::GradedSegment) + sizeof(ground::SegmentLine)) * 2;
}

std::size_t bytes_of(const CellObjects& objects) {
  std::size_t bytes = sizeof(CellObjects);
  if (!objects.placed) return bytes;
  for (const auto* plants : {&objects.placed->trees, &objects.placed->blades})
    for (const auto& [prototype, placements] : *plants) bytes += placements.capacity() * sizeof(Placement);
  for (const structures::Stairs& stairs : objects.placed->stairs)
    for (const Mesh* mesh : {&stairs.mesh, &stairs.rails})
      bytes += mesh->positions.capacity() * sizeof(Vec3) + mesh->triangles.capacity() * sizeof(Triangle);
  bytes += objects.placed->things.capacity() * sizeof(PlacedThing);
  return bytes + sizeof(SharedByLevels) + objects.placed->lamps.standing.capacity() * sizeof(props::StreetLamp);
}

BakedCellPart bake_part(const CellTile& tile, std::size_t cell, std::size_t number, const CellObjects& objects) {
  const scene::Chunk chunk = chunk_of(tile.chunk, objects);
  const TilePart part{tile.view, tile.parts, tile.parts[number]};
  BakedCellPart baked;
  const CellBaking cell_baking{tile.sizes[number].plants_m, tile.sizes[number].lamps_m, baked.plants};
  const LevelRequest request{.header = tile.header,
                             .chunk = chunk,
                             .part = &part,
                             .cell = &cell_baking,
                             .most_instances = std::numeric_limits<std::size_t>::max()};
  TileLevel level = level_of(tile, cell, number, objects);
  Report ignored;
  baked.tile = bake_level(request, level, *tile.prototypes, 1, ignored);
  return baked;
}

bool holds_nothing(const BakedCellPart& part) {
  return part.tile.primitives.empty() && part.tile.instanced.empty() && part.plants.empty();
}

}  // namespace

std::shared_ptr<const CellTile> prepare_cells(const scene::Header& header, const scene::Chunk& all,
                                              const ViewLevels& view,
                                              std::shared_ptr<const PrototypeCache> prototypes) {
  assert(prototypes);
  const std::shared_ptr<const scene::Chunk> shown = scene::shared_shown_chunk(header, all);
  const scene::Chunk& chunk = *shown;
  const auto tile = std::make_shared<CellTile>(CellTile{header, shown, chunk, view, std::move(prototypes)});
  tile->levels = bare_levels_for_view(header, chunk, view, tile->parts);
  const std::shared_ptr<const Markings> markings = markings_for_view(header, chunk, view, tile->parts, tile->levels);
  Sorter(*tile).sort();
  for (TileLevel& level : tile->levels) {
    tile->graded.push_back(level.shared->graded);
    level.shared = nullptr, level.markings = markings;
  }
  // the ground of a cell is baked even where no object is
  for (std::size_t cell = 0; cell < tile->cells.size(); ++cell)
    tile->objects[cell][part_at(tile->parts, tile->cells[cell].number)];
  return tile;
}

std::size_t bytes_of(const CellTile& tile) {
  std::size_t bytes = tile.levels.front().markings->atlas.texels.size() * 3;
  std::set<const void*> counted;
  for (const TileLevel& level : tile.levels)
    if (counted.insert(level.cover.get()).second) bytes += bytes_of(*level.cover);
  for (const auto& graded : tile.graded)
    if (counted.insert(graded.get()).second) bytes += bytes_of(*graded);
  for (const CellParts& parts : tile.objects)
    for (const auto& [part, objects] : parts) bytes += bytes_of(objects);
  return bytes;
}

BakedCell bake_cell(const CellTile& tile, std::size_t cell) {
  assert(cell < tile.cells.size());
  BakedCell baked{.parts = {},
                  .markings = tile.levels.front().markings,
                  .texture_m = tolerance_m_of(tile.view.view, tile.view.finest)};
  for (const auto& [part, objects] : tile.objects[cell]) {
    BakedCellPart one = bake_part(tile, cell, part, objects);
    if (!holds_nothing(one)) baked.parts.push_back(std::move(one));
  }
  return baked;
}

}  // namespace citykiln::bake
