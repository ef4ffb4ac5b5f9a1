#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "compiler/things/front_kinds.h"
#include "compiler/things/street_kinds.h"
#include "compiler/verify/assumed/copies.h"
#include "compiler/verify/assumed/measure_assumed.h"
#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {
namespace {

// The distance from a piece to a door, the width of its edge that may lie on other ground, and by how much two pieces
// may overlap: positions are rounded.
constexpr double kPieceBeforeDoor_m = 1, kPieceEdge_m = 0.1, kPiecesOverlap_m = 0.02;

struct StreetPiece {
  OrientedRect plan;  // less the edge
  OsmId road{};       // or the building before which it stands
};

// The elements that assumed pieces descend from.
std::set<OsmId> owners_of_pieces(const scene::Chunk& chunk) {
  std::set<OsmId> owners;
  for (const roads::Road& road : chunk.roads) owners.insert(road.id.osm);
  for (const buildings::Building& building : chunk.buildings) owners.insert(building.id.osm);
  return owners;
}

// Refuges stand in carriageways, where they are mapped.
bool is_street_piece(std::string_view kind) {
  return kind != things::kRefuge &&
         (things::is_front_kind(kind) ||
          std::ranges::find(things::kStreetKinds, kind, &things::StreetKind::name) != std::end(things::kStreetKinds));
}

// The pieces that descend from roads and buildings; mapped ones have elements of their own.
std::vector<StreetPiece> street_pieces(const bake::BakedTile& tile, const scene::Chunk& chunk) {
  const std::set<OsmId> owners = owners_of_pieces(chunk);
  std::vector<StreetPiece> pieces;
  for (const bake::InstancedMesh& mesh : tile.instanced) {
    if (!is_street_piece(kind_of_mesh(mesh.name))) continue;
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      const OsmId road = tile.features[mesh.features[i]];
      if (owners.contains(road)) pieces.push_back({plan_of_copy(mesh, i, tile.origin, kPieceEdge_m), road});
    }
  }
  return pieces;
}

// The element on which a piece stands wrongly: below a corner or its middle.
OsmId taken_below(const OrientedRect& plan, const ground::LandCoverIndex& land_cover) {
  for (const Vec2 corner : corners_of(plan))
    if (const OsmId taken = taken_element_at(land_cover, corner); taken.type != OsmType::kNone) return taken;
  return taken_element_at(land_cover, plan.at);
}

RectIndex index_pieces(const std::vector<StreetPiece>& pieces) {
  std::vector<OrientedRect> rects;
  for (const StreetPiece& piece : pieces) rects.push_back(piece.plan);
  return index_rects(std::move(rects));
}

// True if a piece overlaps an earlier one.
bool meets_earlier(const RectIndex& index, std::uint32_t i) {
  return any_about(index.grid, box_of(index.all[i]), [&](std::uint32_t other) {
    return other < i && overlap(index.all[other], index.all[i], kPiecesOverlap_m - 2 * kPieceEdge_m);
  });
}

// The element that bars a piece: kNone for a door or another piece.
std::optional<OsmId> bar_of_piece(const RectIndex& index, std::uint32_t i, const Doors& doors,
                                  const ground::LandCoverIndex& land_cover) {
  const OsmId taken = taken_below(index.all[i], land_cover);
  if (taken.type != OsmType::kNone) return taken;
  if (is_before_door(index.all[i], doors) || meets_earlier(index, i)) return OsmId{};
  return std::nullopt;
}

}  // namespace

AssumedTests measure_street_furniture(const bake::BakedTile& tile, const scene::Chunk& chunk,
                                      const ground::LandCoverIndex& land_cover) {
  const std::vector<StreetPiece> pieces = street_pieces(tile, chunk);
  const RectIndex index = index_pieces(pieces);
  const Doors doors = doors_of(chunk, kPieceBeforeDoor_m);
  AssumedTests found{.tested = pieces.size(), .conflicts = 0, .at = {}};
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const std::optional<OsmId> bar = bar_of_piece(index, i, doors, land_cover);
    if (!bar) continue;
    if (found.conflicts++ == 0) found.at = pieces[i].plan.at, found.element = pieces[i].road, found.obstacle = *bar;
  }
  return found;
}

}  // namespace citykiln::verify
