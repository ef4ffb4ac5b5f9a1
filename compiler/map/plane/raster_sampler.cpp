#include "compiler/map/plane/raster_sampler.h"

#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/precise_plane.h"

namespace citykiln::map {
namespace {

// Share of a grain. Positions are off by at most 1.6e-9 m (measured against long double), so on a slope of 100 to 1 a
// height is off by a hundred thousandth of a quantum.
constexpr double kNearGrainTie = 1e-5;

template <typename Real>
std::optional<Real> first_height_m(std::span<const RasterSampler> samplers, Real lon_deg, Real lat_deg) {
  for (const RasterSampler& sampler : samplers)
    if (const auto height = sampler.height_m<Real>(lon_deg, lat_deg)) return height;
  return std::nullopt;
}

}  // namespace

Result<std::vector<RasterSampler>> samplers_of(std::span<const source::Raster> rasters) {
  std::vector<RasterSampler> samplers;
  for (const source::Raster& raster : rasters) {
    auto to_system = source::to_system_of(raster);
    if (!to_system) return to_system.error();
    samplers.emplace_back(raster, *to_system);
  }
  return samplers;
}

std::optional<std::int32_t> quantised_height(std::span<const RasterSampler> samplers, const Plane& plane, Vec2 p,
                                             std::int32_t grain) {
  const double grain_m = grain * kHeightQuantum_m;
  const LonLat place = plane.backward(p);
  const auto height = first_height_m<double>(samplers, place.lon_deg, place.lat_deg);
  if (!height) return std::nullopt;
  const double grains = *height / grain_m + 0.5;
  if (std::abs(grains - std::round(grains)) > kNearGrainTie)
    return static_cast<std::int32_t>(std::floor(grains)) * grain;
  const PreciseLonLat precise = precise_backward(plane.origin(), p, place);
  const auto exact = first_height_m<long double>(samplers, precise.lon_deg, precise.lat_deg);
  return static_cast<std::int32_t>(floorl(exact.value_or(*height) / grain_m + 0.5L)) * grain;
}

}  // namespace citykiln::map
