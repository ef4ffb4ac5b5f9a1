#include "compiler/verify/heights/explain_earthworks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/trig.h"
#include "compiler/ground/landforms/landform_index.h"

namespace citykiln::verify {
namespace {

constexpr double kRadii_m[] = {32, 64, 96, 128};
constexpr int kRingPlaces = 64;
// The share of the depth by which the land on the ring may differ from the line.
constexpr double kLevelShare = 0.25;

// Findings about the heights of a line.
constexpr Code kAboutHeights[] = {Code::kTooSteep,         Code::kTunnelLowered,      Code::kClearanceNotMet,
                                  Code::kLayersContradict, Code::kLayerWithoutBridge, Code::kRiverOffTerrain,
                                  Code::kWaterwayReversed, Code::kWaterwayCycle,      Code::kLakeLevelMoved,
                                  Code::kSeaLevelOffShore, Code::kBridgeWithoutGround};

std::set<OsmId> with_findings(std::span<const outputs::Finding> findings) {
  std::set<OsmId> ids;
  for (const outputs::Finding& finding : findings) {
    const Diagnosis& d = finding.diagnosis;
    if (std::ranges::find(kAboutHeights, d.code) != std::end(kAboutHeights)) ids.insert(d.object), ids.insert(d.other);
  }
  return ids;
}

// The chunks of a scene by place.
struct LandOfScene {
  const scene::Scene& scene;
  std::map<scene::TileKey, ground::LandformIndex> landforms{};

  const scene::Chunk* chunk_at(Vec2 p) const {
    if (!scene.header.extent.contains(p)) return nullptr;
    const auto number = [&](double at_m) { return static_cast<std::int32_t>(std::floor(at_m / scene.header.tile_m)); };
    const auto found =
        std::ranges::lower_bound(scene.chunks, scene::TileKey{number(p.x), number(p.y)}, {}, &scene::Chunk::tile);
    return found != scene.chunks.end() && found->tile == scene::TileKey{number(p.x), number(p.y)} ? &*found : nullptr;
  }

  // The height of the line at an earthwork in a chunk.
  double line_m(const Earthwork& e, const scene::Chunk& chunk) {
    const auto [index, is_new] = landforms.try_emplace(chunk.tile);
    if (is_new) index->second = ground::index_landforms(chunk.landforms);
    return with_landforms_m(index->second, e.at, height_m_at(chunk.heights, e.at)) - e.depth_m;
  }
};

bool is_near_landform(const scene::Chunk& chunk, Vec2 p) {
  return std::ranges::any_of(chunk.landforms, [&](const ground::Landform& form) {
    return form.kind != ground::LandformKind::kLevel && distance_to_polyline(form.axis, p) <= ground::kLandformReach_m;
  });
}

bool is_near_mouth(const scene::Chunk& chunk, Vec2 p) {
  const auto is_near = [&](const structures::Span& span) {
    return std::min(distance(span.axis.front(), p), distance(span.axis.back(), p)) <= kMouthNear_m;
  };
  return std::ranges::any_of(chunk.bridges, is_near) || std::ranges::any_of(chunk.tunnels, is_near);
}

// True if the terrain on a whole ring about the place is at the height of the line.
bool is_level_on_ring(const LandOfScene& land, Vec2 centre, double radius_m, double line_m, double within_m) {
  for (int k = 0; k < kRingPlaces; ++k) {
    const Vec2 p = centre + direction_of(static_cast<double>(k) / kRingPlaces) * radius_m;
    const scene::Chunk* chunk = land.chunk_at(p);
    if (chunk == nullptr || std::abs(height_m_at(chunk->heights, p) - line_m) > within_m) return false;
  }
  return true;
}

EarthworkReason reason_of(const Earthwork& e, LandOfScene& land, const std::set<OsmId>& found) {
  if (found.contains(e.id)) return EarthworkReason::kFinding;
  const scene::Chunk* chunk = land.chunk_at(e.at);
  if (chunk == nullptr) return EarthworkReason::kNone;
  if (is_near_landform(*chunk, e.at)) return EarthworkReason::kLandform;
  if (is_near_mouth(*chunk, e.at)) return EarthworkReason::kMouth;
  const double line_m = land.line_m(e, *chunk);
  const bool stands_alone = std::ranges::any_of(kRadii_m, [&](double radius_m) {
    return is_level_on_ring(land, e.at, radius_m, line_m, kLevelShare * std::abs(e.depth_m));
  });
  return stands_alone ? EarthworkReason::kStandsAlone : EarthworkReason::kNone;
}

}  // namespace

std::string_view name_of(EarthworkReason reason) {
  switch (reason) {
    case EarthworkReason::kFinding:
      return "finding";
    case EarthworkReason::kLandform:
      return "landform";
    case EarthworkReason::kMouth:
      return "mouth";
    case EarthworkReason::kNone:
      return "none";
    case EarthworkReason::kStandsAlone:
      return "stands alone";
  }
  return "";
}

std::vector<DeepEarthwork> explain_earthworks(const scene::Scene& scene, std::span<const Earthwork> earthworks,
                                              std::span<const outputs::Finding> findings) {
  const std::set<OsmId> found = with_findings(findings);
  LandOfScene land{scene};
  std::vector<DeepEarthwork> deep;
  for (const Earthwork& e : over_their_limits(earthworks)) deep.push_back({e, reason_of(e, land, found)});
  return deep;
}

}  // namespace citykiln::verify
