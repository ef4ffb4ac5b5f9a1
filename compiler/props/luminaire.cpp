#include "compiler/props/luminaire.h"

#include <algorithm>
#include <cassert>
#include <numbers>

namespace citykiln::props {
namespace {

struct LuminaireRow {
  LampKind kind;
  double up_to_m;
  float lumen, temperature_k;
};

constexpr LuminaireRow kRows[] = {
#define LUMINAIRE(kind, up_to_m, lumen, temperature_k) {LampKind::kind, up_to_m, lumen, temperature_k},
#include "compiler/props/luminaires.inc"
#undef LUMINAIRE
};

const LuminaireRow& row_of(LampKind kind, double height_m) {
  const LuminaireRow* last = kRows;
  for (const LuminaireRow& row : kRows) {
    if (row.kind != kind) continue;
    last = &row;
    if (height_m <= row.up_to_m) break;
  }
  return *last;
}

Beam beam_of(LampKind kind, map::LampMount mount) {
  const bool is_down =
      mount == map::LampMount::kHighMast || mount == map::LampMount::kWall || mount == map::LampMount::kSuspended;
  return is_down || kind == LampKind::kArm ? Beam::kDown : Beam::kLantern;
}

// The middle of the glass of a lamp of 1 m (lamp_mesh.cpp): along its arm, and above the ground.
constexpr Vec2 kPostTopGlass_m{0, 0.93}, kArmGlass_m{0.172, 0.983};

// Chromaticity on the Planckian locus, CIE 1931.
Vec2 planckian(double temperature_k) {
  const double t = std::clamp(temperature_k, 1667.0, 25000.0) / 1000, u = 1 / t;
  const double x = t <= 4 ? ((-0.2661239 * u - 0.2343589) * u + 0.8776956) * u + 0.179910
                          : ((-3.0258469 * u + 2.1070379) * u + 0.2226347) * u + 0.240390;
  const double y = t <= 2.222 ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                   : t <= 4   ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                              : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  return {x, y};
}

}  // namespace

Luminaire luminaire_of(LampKind kind, double height_m, const map::LampTags& tags) {
  assert(height_m >= 0 && tags.count >= 1);
  const LuminaireRow& row = row_of(kind, height_m);
  const map::LampTypeValues& type = map::values_of(tags.type);
  Luminaire luminaire{.temperature_k = row.temperature_k, .beam = beam_of(kind, tags.mount)};
  if (type.temperature_k > 0) luminaire.temperature_k = type.temperature_k;
  if (tags.temperature_k > 0) luminaire.temperature_k = tags.temperature_k;
  const float one =
      tags.lumen > 0 ? static_cast<float>(tags.lumen) : std::min(row.lumen, static_cast<float>(type.most_lm));
  luminaire.lumen = one * tags.count;
  return luminaire;
}

LampKind kind_of(map::LampMount mount, LampKind otherwise) {
  if (mount == map::LampMount::kStraightMast) return LampKind::kPostTop;
  return mount == map::LampMount::kBentMast ? LampKind::kArm : otherwise;
}

double beam_sr(Beam beam) { return beam == Beam::kDown ? std::numbers::pi : 2 * std::numbers::pi * (1 + kLanternRise); }

Vec3 glass_of(const Placement& lamp, LampKind kind) {
  const Vec2 glass = (kind == LampKind::kArm ? kArmGlass_m : kPostTopGlass_m) * lamp.scale;
  return {lamp.at.x + lamp.cos_yaw * glass.x, lamp.at.y + lamp.sin_yaw * glass.x, lamp.at.z + glass.y};
}

std::array<float, 3> black_body_colour(double temperature_k) {
  const Vec2 at = planckian(temperature_k);
  const double x = at.x / at.y, z = (1 - at.x - at.y) / at.y;
  // IEC 61966-2-1
  const double red = 3.2404542 * x - 1.5371385 - 0.4985314 * z, green = -0.9692660 * x + 1.8760108 + 0.0415560 * z,
               blue = 0.0556434 * x - 0.2040259 + 1.0572252 * z;
  const double r = std::max(0.0, red), g = std::max(0.0, green), b = std::max(0.0, blue);
  const double luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return {static_cast<float>(r / luminance), static_cast<float>(g / luminance), static_cast<float>(b / luminance)};
}

}  // namespace citykiln::props
