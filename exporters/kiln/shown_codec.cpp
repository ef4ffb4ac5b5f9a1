#include "exporters/kiln/shown_codec.h"

#include <utility>
#include <vector>

#include "compiler/map/plane/plane.h"

namespace citykiln::exporters {
namespace {

static_assert(scene::kWoodDensityStep * kFullShare == 1 && scene::kLitWindowsStep * kFullShare == 1);

// A coordinate of the clip as a number of steps, and back.
std::int32_t clip_steps(double coordinate_m) { return static_cast<std::int32_t>(coordinate_m / map::kMapStep_m); }

flatbuffers::Offset<fbs::ClipRing> clip_ring_of(flatbuffers::FlatBufferBuilder& builder, const Ring& ring,
                                                bool is_hole) {
  std::vector<std::int32_t> x, y;
  for (const Vec2 p : ring) x.push_back(clip_steps(p.x)), y.push_back(clip_steps(p.y));
  return fbs::CreateClipRingDirect(builder, is_hole, &x, &y);
}

}  // namespace

std::uint16_t encode_lit_windows(const scene::Shown& shown) {
  return shown.lit_windows ? static_cast<std::uint16_t>(*shown.lit_windows * kFullShare) : kUsualShare;
}

std::optional<scene::Shown> decode_shown(const fbs::Header& h) {
  scene::Shown shown{.left_out = h.left_out(),
                     .wood_density = static_cast<double>(h.wood_density()) / kFullShare,
                     .lamps = static_cast<scene::LampLight>(h.lamps())};
  if (shown.wood_density > scene::kDensestWoods || h.lamps() > static_cast<std::uint8_t>(scene::LampLight::kOff))
    return std::nullopt;
  if (h.lit_windows() == kUsualShare) return shown;
  if (h.lit_windows() > kFullShare) return std::nullopt;
  shown.lit_windows = static_cast<double>(h.lit_windows()) / kFullShare;
  return shown;
}

std::vector<flatbuffers::Offset<fbs::ClipRing>> encode_clip(flatbuffers::FlatBufferBuilder& builder,
                                                            const scene::Clip& clip) {
  std::vector<flatbuffers::Offset<fbs::ClipRing>> rings;
  for (const Polygon& polygon : clip) {
    rings.push_back(clip_ring_of(builder, polygon.outer, false));
    for (const Ring& hole : polygon.holes) rings.push_back(clip_ring_of(builder, hole, true));
  }
  return rings;
}

std::optional<scene::Clip> decode_clip(const fbs::Header& h) {
  scene::Clip clip;
  if (h.clip() == nullptr) return clip;
  for (const fbs::ClipRing* ring : *h.clip()) {
    const bool is_ring = ring->x() != nullptr && ring->y() != nullptr && ring->x()->size() == ring->y()->size();
    if (!is_ring || ring->x()->size() < 3 || (ring->is_hole() && clip.empty())) return std::nullopt;
    Ring points;
    for (flatbuffers::uoffset_t i = 0; i < ring->x()->size(); ++i)
      points.push_back(Vec2{static_cast<double>(ring->x()->Get(i)), static_cast<double>(ring->y()->Get(i))} *
                       map::kMapStep_m);
    if (ring->is_hole())
      clip.back().holes.push_back(std::move(points));
    else
      clip.push_back({std::move(points), {}});
  }
  return clip;
}

}  // namespace citykiln::exporters
