#include "compiler/materials/texture_pattern.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>

#include "compiler/geometry/trig.h"
#include "compiler/materials/pattern_fields.h"

namespace citykiln::materials {
namespace {

// 16 rows per side: 0.5 m apart on 8 m.
PatternFields rows(std::uint32_t px, std::uint64_t key) {
  constexpr double kRows = 16;
  const Field clods = fine(layered_noise(px, {32, 16}, 5, 0.9, key)), sway = gradient_noise(px, {4, 2}, key + 10);
  const auto ridge = [&](std::uint32_t c, std::uint32_t r) {
    return direction_of((c + 0.5) / px * kRows + 0.10 * sway.at(c, r)).x;
  };
  const Field relief = combined(px, [&](auto c, auto r) { return ridge(c, r) + 0.5 * clods.at(c, r); });
  return tones(combined(px, [&](auto c, auto r) { return 0.22 * ridge(c, r) + clods.at(c, r); }), relief);
}

PatternFields mottled(std::uint32_t px, std::uint64_t key) {
  const Field patches = layered_noise(px, {14, 14}, 6, 0.9, key);
  const Cells pebbles = cells(px, 100, key + 10);
  return fine_tones(combined(px, [&](auto c, auto r) { return patches.at(c, r) + 0.35 * pebbles.chance.at(c, r); }));
}

PatternFields grains(std::uint32_t px, std::uint64_t key) {
  const Field clouds = layered_noise(px, {4, 4}, 3, 0.8, key),
              detail = layered_noise(px, {px / 4, px / 4}, 2, 1, key + 10);
  return fine_tones(combined(px, [&](auto c, auto r) { return 0.3 * clouds.at(c, r) + detail.at(c, r); }));
}

PatternFields stones(std::uint32_t px, std::uint64_t key) {
  const Cells large = cells(px, 56, key);
  const Field detail = layered_noise(px, {px / 4, px / 4}, 2, 1, key + 10);
  return fine_tones(combined(px, [&](auto c, auto r) {
    return 0.7 * large.chance.at(c, r) + 1.1 * std::min(large.to_edge.at(c, r), 0.45f) + 0.25 * detail.at(c, r);
  }));
}

// Ridged noise (Musgrave, in Ebert et al., "Texturing and Modeling", 2003), broken by the edges of cells.
PatternFields crags(std::uint32_t px, std::uint64_t key) {
  Field ridges = flat_field(px);
  double height = 1;
  for (std::uint32_t waves = 5; waves <= px / 4; waves *= 2, height *= 0.68) {
    const Field layer = gradient_noise(px, {waves, 2 * waves <= px / 4 ? waves + waves / 2 : waves}, key + waves);
    for (std::size_t i = 0; i < ridges.values.size(); ++i)
      ridges.values[i] += static_cast<float>(height * (0.35 - std::abs(layer.values[i])));
  }
  const Cells blocks = cells(px, 9, key);
  const Field relief = combined(px, [&](auto c, auto r) {
    return ridges.at(c, r) + 0.16 * blocks.chance.at(c, r) + 0.5 * std::min(blocks.to_edge.at(c, r), 0.12f);
  });
  return fine_tones(relief);
}

// A sum of plane waves with whole numbers of periods per side, mostly of similar direction; shorter waves are lower.
PatternFields waves(std::uint32_t px, std::uint64_t) {
  struct Train {
    int across, along;
    double phase, height;
  };
  constexpr std::array<Train, 10> kTrains = {{{2, 1, 0.00, 0.40},
                                              {1, 3, 0.27, 0.30},
                                              {4, 2, 0.65, 0.34},
                                              {3, 5, 0.14, 0.36},
                                              {7, 1, 0.84, 0.27},
                                              {6, 7, 0.35, 0.21},
                                              {2, 10, 0.52, 0.18},
                                              {13, 5, 0.76, 0.14},
                                              {10, 13, 0.08, 0.12},
                                              {18, -3, 0.44, 0.10}}};
  const Field relief = combined(px, [&](auto c, auto r) {
    double height = 0;
    for (const Train& t : kTrains)
      height += t.height * direction_of((c + 0.5) / px * t.across + (r + 0.5) / px * t.along + t.phase).x;
    return height;
  });
  return {flat_field(px), normalised(relief, 1)};
}

// |noise| / width, at most 1: a valley around the zeros of the noise.
double off_zero(double noise, double width) { return std::min(1.0, std::abs(noise) / width); }

PatternFields furrows(std::uint32_t px, std::uint64_t key) {
  const Field wide = gradient_noise(px, {11, 3}, key), narrow = gradient_noise(px, {21, 5}, key + 1),
              cracks = gradient_noise(px, {12, 14}, key + 2), detail = layered_noise(px, {32, 12}, 3, 0.8, key + 10);
  const Field relief = combined(px, [&](auto c, auto r) {
    const double ridge = off_zero(wide.at(c, r), 0.26) * (0.55 + 0.45 * off_zero(narrow.at(c, r), 0.24));
    return ridge - 0.22 * (1 - off_zero(cracks.at(c, r), 0.05)) * ridge + 0.16 * detail.at(c, r);
  });
  return fine_tones(relief);
}

PatternFields streaks(std::uint32_t px, std::uint64_t key) {
  const Field across = layered_noise(px, {5, 18}, 3, 0.8, key), detail = layered_noise(px, {24, 24}, 2, 1, key + 10);
  return fine_tones(combined(px, [&](auto c, auto r) { return across.at(c, r) + 0.7 * detail.at(c, r); }));
}

PatternFields lenticels(std::uint32_t px, std::uint64_t key) {
  const Field dashes = gradient_noise(px, {9, 44}, key), bands = layered_noise(px, {4, 30}, 3, 0.9, key + 1);
  const Cells scars = cells(px, 8, key + 2);
  return fine_tones(combined(px, [&](auto c, auto r) {
    const double scar = step(scars.chance.at(c, r), 0.94, 0.01) * step(scars.to_edge.at(c, r), 0.3, 0.3);
    return 0.35 * bands.at(c, r) - 1.3 * std::max(step(dashes.at(c, r), 0.36, 0.12), scar);
  }));
}

// Cells repeated twice across, so that they are twice as high as wide.
PatternFields plates(std::uint32_t px, std::uint64_t key) {
  const Cells large = cells(px, 7, key);
  const Field sway = gradient_noise(px, {9, 7}, key + 1), detail = layered_noise(px, {14, 30}, 3, 0.9, key + 10);
  return fine_tones(combined(px, [&](auto c, auto r) {
    const auto moved = static_cast<std::uint32_t>(2 * c + px + static_cast<int>(0.05 * px * sway.at(c, r))) % px;
    return 1.6 * std::min(large.to_edge.at(moved, r), 0.3f) + 0.3 * large.chance.at(moved, r) + 0.3 * detail.at(c, r);
  }));
}

PatternFields flakes(std::uint32_t px, std::uint64_t key) {
  const Cells patches = cells(px, 20, key);
  const Field along = layered_noise(px, {16, 16}, 3, 0.8, key + 1),
              across = layered_noise(px, {16, 16}, 3, 0.8, key + 2),
              detail = layered_noise(px, {32, 32}, 2, 1, key + 10);
  return fine_tones(combined(px, [&](auto c, auto r) {
    const auto moved = [&](std::uint32_t at, const Field& by) {
      return (at + px + static_cast<std::uint32_t>(static_cast<int>(0.035 * px * by.at(c, r)) + int(px))) % px;
    };
    const double chance = patches.chance.at(moved(c, along), moved(r, across));
    return std::floor(chance * 3) / 2 + 0.16 * detail.at(c, r);
  }));
}

PatternFields scars(std::uint32_t px, std::uint64_t key) {
  constexpr double kScars = 16;
  const Field sway = gradient_noise(px, {5, 4}, key), fibres = layered_noise(px, {40, 8}, 3, 0.9, key + 10);
  return fine_tones(combined(px, [&](auto c, auto r) {
    const double place = (r + 0.5) / px * kScars + 0.6 * sway.at(c, r), up = place - std::floor(place);
    return 0.5 * std::min(1.0, 5 * std::min(up, 1 - up)) + 0.5 * fibres.at(c, r);
  }));
}

// The opacity of a texel between bars. Texels of 1/2 or more are no holes. A mip level holds means, of which the thin
// bars would soon be less than 1/2 everywhere: around every fourth bar the holes are nearly 1/2, so that its texels
// stay on levels of 16 and 32 times the size, about as large a share as the bars are.
double opacity_between_bars(std::uint32_t column) {
  constexpr std::uint32_t kAround = 4;
  if (column / kBarPitch_px % kAround != 0) return 0;
  return column % kBarPitch_px < kBarPitch_px / 2 ? 124 / 255.0 : 88 / 255.0;
}

// Constant brightness, since bars are painted.
PatternFields bars(std::uint32_t px, std::uint64_t) {
  const auto opacity = [](std::uint32_t column, std::uint32_t row) {
    const std::uint32_t across = column % kBarPitch_px;
    const bool is_bar = across >= kBarBegin_px && across < kBarBegin_px + kBar_px && row >= kBarsFrom_px;
    return is_bar || row >= kRailFrom_px ? 1.0 : opacity_between_bars(column);
  };
  return {flat_field(px), flat_field(px), combined(px, opacity)};
}

// Patterns of fences are of 512 texels. Boards differ, and have grain along them.
constexpr std::uint32_t kPaling_px = 32;

PatternFields palings(std::uint32_t px, std::uint64_t key) {
  constexpr double kOfBoard[16] = {0.1, -0.5, 0.4,  -0.1, 0.7,  -0.3, 0.0,  -0.8,
                                   0.5, 0.2,  -0.4, 0.9,  -0.2, 0.3,  -0.6, 0.1};
  constexpr std::uint32_t kGap_px = 2;
  const Field grain = layered_noise(px, {64, 4}, 3, 0.9, key);
  PatternFields fields = fine_tones(combined(px, [&](std::uint32_t c, std::uint32_t r) {
    return 0.6 * kOfBoard[c / kPaling_px % 16] + 0.4 * grain.at(c, r);
  }));
  fields.opacity = combined(px, [](std::uint32_t c, std::uint32_t) { return c % kPaling_px < kGap_px ? 0.0 : 1.0; });
  return fields;
}

PatternFields pickets(std::uint32_t px, std::uint64_t) {
  constexpr std::uint32_t kPicket_px = 20;
  const auto is_rail = [](std::uint32_t r) { return (r >= 450 && r < 468) || (r >= 296 && r < 314); };
  const auto opacity = [&](std::uint32_t c, std::uint32_t r) {
    const std::uint32_t across = c % kPaling_px, aside = across < 10 ? 10 - across : across - 9;
    return is_rail(r) || (across < kPicket_px && r + aside < kFenceTop_px + 1) ? 1.0 : 0.0;
  };
  return {flat_field(px), flat_field(px), combined(px, opacity)};
}

// Holes are nearly 1/2 in bands, as they are between bars: wires alone would be less than 1/2 on every mip level.
PatternFields chain_link(std::uint32_t px, std::uint64_t) {
  constexpr std::uint32_t kMesh_px = 16, kWire_px = 2, kPost_px = 12, kRail_px = 10, kBand_px = 128;
  const auto opacity = [](std::uint32_t c, std::uint32_t r) {
    const bool is_wire = (c + r) % kMesh_px < kWire_px || (c + 512 - r) % kMesh_px < kWire_px;
    const bool is_frame = c < kPost_px || (r >= kFenceTop_px - kRail_px && r < kFenceTop_px);
    if (is_wire || is_frame) return 1.0;
    return c % kBand_px < kBand_px / 2 ? 100 / 255.0 : 60 / 255.0;
  };
  return {flat_field(px), flat_field(px), combined(px, opacity)};
}

using Generator = PatternFields (*)(std::uint32_t side_px, std::uint64_t key);

template <Bond kBond, std::uint32_t kAcross, std::uint32_t kAlong>
PatternFields laid(std::uint32_t px, std::uint64_t key) {
  return bricks(kBond, kAcross, kAlong, px, key);
}

// In the order of TexturePattern.
constexpr Generator kGenerators[] = {blades,
                                     tufts,
                                     rows,
                                     litter,
                                     mottled,
                                     grains,
                                     stones,
                                     crags,
                                     slabs,
                                     ashlar,
                                     laid<Bond::kRunning, 8, 24>,
                                     laid<Bond::kRunning, 10, 30>,
                                     laid<Bond::kEnglish, 9, 26>,
                                     laid<Bond::kFlemish, 9, 26>,
                                     laid<Bond::kStack, 8, 24>,
                                     laid<Bond::kHeader, 9, 26>,
                                     rubble,
                                     setts,
                                     kerbs,
                                     pantiles,
                                     slates,
                                     shingles,
                                     boards,
                                     thatch,
                                     render,
                                     shutters,
                                     cast,
                                     corrugations,
                                     seams,
                                     felt,
                                     gravel_bed,
                                     asphalt,
                                     worn_asphalt,
                                     lanes,
                                     ripples,
                                     waves,
                                     bars,
                                     palings,
                                     pickets,
                                     chain_link,
                                     furrows,
                                     streaks,
                                     lenticels,
                                     plates,
                                     flakes,
                                     scars};
static_assert(std::size(kGenerators) == static_cast<std::size_t>(TexturePattern::kScars) + 1);

}  // namespace

PatternFields generate_pattern(TexturePattern pattern, std::uint32_t side_px, std::uint64_t key) {
  assert(side_px > 0);
  return kGenerators[static_cast<std::size_t>(pattern)](side_px, key);
}

Field downsampled(const Field& field, std::uint32_t side_px) {
  assert(side_px > 0 && field.side_px % side_px == 0);
  const std::uint32_t block = field.side_px / side_px;
  if (block <= 1) return field;
  return combined(side_px, [&](auto column, auto row) {
    double sum = 0;
    for (std::uint32_t j = 0; j < block; ++j)
      for (std::uint32_t i = 0; i < block; ++i) sum += field.at(column * block + i, row * block + j);
    return sum / (static_cast<double>(block) * block);
  });
}

}  // namespace citykiln::materials
