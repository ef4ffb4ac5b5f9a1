#include "compiler/ground/correction/known_waters.h"

namespace citykiln::ground {
namespace {

void add_axis(const roads::Strip& stream, std::vector<KnownLine>& lines) {
  const std::vector<double> along_m = roads::distances_along(stream.axis, stream.start_along_m);
  for (std::size_t i = 0; i + 1 < stream.axis.size(); ++i)
    lines.push_back({stream.axis[i], stream.axis[i + 1], knot_at(stream.profile, along_m[i]).z_m,
                     knot_at(stream.profile, along_m[i + 1]).z_m, KnownKind::kWater});
}

void add_shore(const Ring& ring, double level_m, std::vector<KnownLine>& lines) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    lines.push_back({ring[i], ring[(i + 1) % ring.size()], level_m, level_m, KnownKind::kWater});
}

}  // namespace

std::vector<KnownLine> known_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams) {
  std::vector<KnownLine> lines;
  for (const roads::Strip& stream : streams)
    if (!stream.profile.empty()) add_axis(stream, lines);
  for (const LandCoverPolygon& surface : surfaces)
    if (surface.level_m)
      for (const Ring& ring : surface.rings) add_shore(ring, *surface.level_m, lines);
  return lines;
}

}  // namespace citykiln::ground
