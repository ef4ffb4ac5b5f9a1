#include "exporters/kiln/sky_codec.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/result.h"
#include "compiler/sky/air_settings.h"

namespace citykiln::exporters {
namespace {

// Steps of 2^-20 are exact as integers.
std::vector<std::int64_t> direction_steps(Vec3 v) {
  return {std::llround(v.x * 0x1p20), std::llround(v.y * 0x1p20), std::llround(v.z * 0x1p20)};
}

// Null if the world is in the plane: the header's bytes are then equal to those without the field.
flatbuffers::Offset<fbs::Inside> inside_of(flatbuffers::FlatBufferBuilder& builder, const sky::Sky& sky) {
  if (!sky.inside) return 0;
  const sky::Inside& inside = *sky.inside;
  std::vector<flatbuffers::Offset<fbs::Line>> lines;
  for (const sky::LineLight& line : inside.lines)
    lines.push_back(fbs::CreateLine(builder, line.from.x, line.to.x, line.from.y, line.from.z, line.lumen_per_m,
                                    line.temperature_k, line.radius_m));
  return fbs::CreateInsideDirect(builder, inside.cylinder.radius_m, inside.west_m, inside.east_m, inside.fall, &lines);
}

// A direction; nothing unless it is nearly a unit vector.
std::optional<Vec3> direction_of(const flatbuffers::Vector<std::int64_t>* steps) {
  if (steps == nullptr || steps->size() != 3) return std::nullopt;
  const auto part = [&](unsigned i) { return static_cast<double>((*steps)[i]) * 0x1p-20; };
  const Vec3 v{part(0), part(1), part(2)};
  const double length2 = dot(v, v);
  return length2 > 0.99 && length2 < 1.01 ? std::optional(v) : std::nullopt;
}

// Whether values are such as compile writes.
bool is_sound(const sky::Sky& sky) {
  return sky.turbidity >= sky::kLeastTurbidity && sky.turbidity <= sky::kMostTurbidity &&
         sky.visibility_km >= sky::kHaziest_km && sky.visibility_km <= sky::kClearest_km && sky.ground_albedo >= 0 &&
         sky.ground_albedo <= 1 && sky.moon_lit >= 0 && sky.moon_lit <= 1 && std::abs(sky.ground_m) <= 20000 &&
         sky.clouds.size() <= sky::kMostCloudLayers &&
         std::ranges::all_of(sky.clouds, [](const sky::CloudLayer& layer) { return sky::is_sound(layer); });
}

std::vector<sky::CloudLayer> clouds_of(const fbs::Sky& s) {
  std::vector<sky::CloudLayer> layers;
  for (unsigned i = 0; i < (s.clouds() != nullptr ? s.clouds()->size() : 0); ++i) {
    const fbs::CloudLayer& layer = *s.clouds()->Get(i);
    layers.push_back({static_cast<sky::CloudKind>(layer.kind()),
                      layer.cover(),
                      layer.base_m(),
                      layer.top_m(),
                      {layer.wind_x(), layer.wind_y()},
                      layer.seed()});
  }
  return layers;
}

constexpr unsigned kMostLines = 64;

bool is_sound(const sky::LineLight& line) {
  constexpr double kFarthest_m = 1e7, kMostLumen = 1e15;
  const auto is_in = [](double v, double low, double high) { return v >= low && v <= high; };
  return is_in(line.from.x, -kFarthest_m, line.to.x) && line.to.x <= kFarthest_m &&
         is_in(line.from.y, -kFarthest_m, kFarthest_m) && is_in(line.from.z, -kFarthest_m, kFarthest_m) &&
         is_in(line.lumen_per_m, 0, kMostLumen) && is_in(line.temperature_k, 500, 40000) &&
         is_in(line.radius_m, 1e-3, kFarthest_m);
}

// Nothing where the values are not such as compile writes.
std::optional<sky::Inside> decode_inside(const fbs::Inside& i) {
  sky::Inside inside{.cylinder = {i.radius_m()}, .west_m = i.west_m(), .east_m = i.east_m(), .fall = i.fall()};
  const unsigned count = i.lines() != nullptr ? i.lines()->size() : 0;
  for (unsigned k = 0; k < std::min(count, kMostLines); ++k) {
    const fbs::Line& line = *i.lines()->Get(k);
    inside.lines.push_back({.from = {line.from_x(), line.y(), line.z()},
                            .to = {line.to_x(), line.y(), line.z()},
                            .lumen_per_m = line.lumen_per_m(),
                            .temperature_k = line.temperature_k(),
                            .radius_m = line.radius_m()});
  }
  const double radius_m = inside.cylinder.radius_m;
  const bool is_shaped = radius_m >= map::kLeastCylinder_m && radius_m <= map::kLargestCylinder_m &&
                         inside.west_m >= -1e7 && inside.east_m <= 1e7 && inside.west_m < inside.east_m;
  const bool has_light = count <= kMostLines && inside.fall >= 0 && inside.fall <= 16 &&
                         std::ranges::all_of(inside.lines, [](const auto& line) { return is_sound(line); });
  return is_shaped && has_light ? std::optional(std::move(inside)) : std::nullopt;
}

// No moment for an empty text.
Result<std::optional<sky::Moment>> moment_of(const flatbuffers::String* text) {
  if (text == nullptr || text->size() == 0) return std::optional<sky::Moment>();
  const Result<sky::Moment> moment = sky::parse_time(text->string_view());
  if (!moment) return moment.error();
  return std::optional(*moment);
}

}  // namespace

flatbuffers::Offset<fbs::Sky> encode_sky(flatbuffers::FlatBufferBuilder& builder, const sky::Sky& sky) {
  const auto time = builder.CreateString(sky::text_of(sky.time));
  const auto direction = [&](Vec3 v) { return builder.CreateVector(direction_steps(v)); };
  const auto sun = direction(sky.to_sun), moon = direction(sky.to_moon);
  const auto pole = direction(sky.to_pole), equinox = direction(sky.to_equinox);
  std::vector<flatbuffers::Offset<fbs::CloudLayer>> layers;
  for (const sky::CloudLayer& layer : sky.clouds)
    layers.push_back(fbs::CreateCloudLayer(builder, static_cast<std::uint8_t>(layer.kind), layer.cover, layer.base_m,
                                           layer.top_m, layer.wind.x, layer.wind.y, layer.seed));
  const auto clouds = builder.CreateVector(layers);
  const auto inside = inside_of(builder, sky);
  return fbs::CreateSky(builder, time, sun, sky.turbidity, sky.visibility_km, sky.ground_albedo, moon,
                        std::llround(sky.moon_lit * 0x1p20), pole, equinox, sky.ground_m, clouds, inside,
                        sky.clouds_are_default);
}

std::optional<sky::Sky> decode_sky(const fbs::Sky& s) {
  const auto time = moment_of(s.time());
  const auto sun = direction_of(s.to_sun()), moon = direction_of(s.to_moon());
  const auto pole = direction_of(s.to_pole()), equinox = direction_of(s.to_equinox());
  if (!time || !sun || !moon || !pole || !equinox) return std::nullopt;
  sky::Sky sky{.time = *time,
               .to_sun = *sun,
               .turbidity = s.turbidity(),
               .visibility_km = s.visibility_km(),
               .ground_albedo = s.ground_albedo(),
               .to_moon = *moon,
               .moon_lit = static_cast<double>(s.moon_lit()) * 0x1p-20,
               .to_pole = *pole,
               .to_equinox = *equinox,
               .ground_m = s.ground_m(),
               .clouds = clouds_of(s),
               .clouds_are_default = s.clouds_are_default()};
  if (s.inside() != nullptr && !(sky.inside = decode_inside(*s.inside()))) return std::nullopt;
  return is_sound(sky) ? std::optional(sky) : std::nullopt;
}

}  // namespace citykiln::exporters
