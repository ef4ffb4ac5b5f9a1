#include "compiler/structures/plan.h"

#include <algorithm>

#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

Vec3 on_profile(Vec2 at, const Profile& profile, double at_m) {
  return at_height(at, profile.empty() ? 0 : snapped(knot_at(profile, at_m).z_m));
}

// The track's axis and, between its points, the profile's knots.
std::vector<Vec3> axis_of(const Polyline& axis, const Profile& profile) {
  // a knot nearer to a point is as good as on it
  constexpr double kApart_m = 0.25;
  std::vector<Vec3> points = {on_profile(axis.front(), profile, 0)};
  auto knot = profile.begin();
  double passed_m = 0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const double length_m = snapped(distance(axis[i], axis[i + 1]));
    const Vec2 step = (axis[i + 1] - axis[i]) * (1 / length_m);
    for (; knot != profile.end() && knot->at_m < passed_m + length_m - kApart_m; ++knot) {
      if (knot->at_m < passed_m + kApart_m) continue;
      points.push_back(at_height(snapped(axis[i] + step * (knot->at_m - passed_m)), knot->z_m));
    }
    passed_m += length_m;
    points.push_back(on_profile(axis[i + 1], profile, passed_m));
  }
  return points;
}

Span span_of(const map::Track& track, const Profile& profile) {
  return {track.id, axis_of(track.axis, profile), track.surface, map::carriageway_width_m(track.section)};
}

void count(Report& report, const char* kind, std::size_t spans) {
  Account& account = report.account("structures", kind);
  account.in += spans;
  account.out += spans;
}

}  // namespace

Structures plan(const map::Features& features, std::span<const Profile> off_ground, Report& report) {
  Structures structures;
  std::size_t next = 0;
  for (const map::Track& track : features.tracks) {
    if (track.passage == map::Passage::kGround) continue;
    const bool is_bridge = track.passage == map::Passage::kBridge;
    (is_bridge ? structures.bridges : structures.tunnels).push_back(span_of(track, off_ground[next++]));
    if (!is_bridge) report.add(Code::kTunnelNotMeshed, track.id.osm);
  }
  std::ranges::sort(structures.bridges, {}, &Span::id);
  std::ranges::sort(structures.tunnels, {}, &Span::id);
  count(report, "bridge", structures.bridges.size());
  count(report, "tunnel", structures.tunnels.size());
  return structures;
}

}  // namespace citykiln::structures
