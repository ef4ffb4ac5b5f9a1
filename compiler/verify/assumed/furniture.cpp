#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

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
  OsmId road{};
};

// The pieces that descend from roads; mapped ones have elements of their own.
std::vector<StreetPiece> street_pieces(const bake::BakedTile& tile, const scene::Chunk& chunk) {
  std::set<OsmId> roads;
  for (const roads::Road& road : chunk.roads) roads.insert(road.id.osm);
  std::vector<StreetPiece> pieces;
  for (const bake::InstancedMesh& mesh : tile.instanced) {
    if (std::ranges::find(things::kStreetKinds, kind_of_mesh(mesh.name), &things::StreetKind::name) ==
        std::end(things::kStreetKinds))
      continue;
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      const OsmId road = tile.features[mesh.features[i]];
      if (roads.contains(road)) pieces.push_back({plan_of_copy(mesh, i, tile.origin, kPieceEdge_m), road});
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
