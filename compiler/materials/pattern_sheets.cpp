// Patterns of surfaces that are spread, cast or rolled out: render, concrete, metal sheets, bitumen sheets, gravel,
// asphalt, sand.
#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"
#include "compiler/materials/pattern_fields.h"

namespace citykiln::materials {
namespace {

PatternFields blank_fields(std::uint32_t px) {
  return {flat_field(px), flat_field(px), {}, flat_field(px), flat_field(px)};
}

// The values of a pattern at a texel.
struct SheetTexel {
  double tone = 0, relief = 0, accent = 0, rough = 0;
};

template <typename Of>
PatternFields by_texel(std::uint32_t px, Of of) {
  PatternFields fields = blank_fields(px);
  for (std::uint32_t r = 0; r < px; ++r)
    for (std::uint32_t c = 0; c < px; ++c) {
      const SheetTexel t = of(c, r);
      fields.tone.at(c, r) = static_cast<float>(t.tone), fields.relief.at(c, r) = static_cast<float>(t.relief);
      fields.accent.at(c, r) = static_cast<float>(std::clamp(t.accent, 0.0, 1.0));
      fields.rough.at(c, r) = static_cast<float>(t.rough);
    }
  fields.tone = tones(fields.tone, fields.relief).tone;
  fields.relief = normalised(std::move(fields.relief), 1);
  fields.rough = tones(fields.rough, fields.rough).tone;
  return fields;
}

// The distance from the nearest of `count` lines along a side, as a share of it.
double off_lines(double at, double count) {
  const double up = at * count, part = up - std::floor(up);
  return std::min(part, 1 - part) / count;
}

// Hair cracks: the zeros of a noise, where another one is high.
double crack(double noise, double where, double width) {
  return (1 - std::min(1.0, std::abs(noise) / width)) * step(where, 0.10, 0.15);
}

}  // namespace

// Sand of up to 2 mm, floated in arcs of about half a metre, with stains that water left.
PatternFields render(std::uint32_t px, std::uint64_t key) {
  const Field sand = random_values(px, key), grain = layered_noise(px, {px / 4, px / 4}, 2, 1, key + 1),
              float_marks = layered_noise(px, {12, 26}, 3, 0.7, key + 2),
              stains = layered_noise(px, {4, 3}, 5, 0.6, key + 3), runs = layered_noise(px, {44, 4}, 2, 0.7, key + 4);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double s = sand.at(c, r) - 0.5, g = grain.at(c, r), m = float_marks.at(c, r), w = stains.at(c, r);
    const double hair = crack(w, -stains.at(r, c), 0.008);
    return {0.25 * s + 0.22 * g + 0.30 * m + 0.75 * w + 0.20 * runs.at(c, r) - 0.5 * hair,
            0.5 * s + 0.7 * g + 0.9 * m - hair, 0.75 * step(w + 0.4 * runs.at(c, r), 0.42, 0.6), s + g};
  });
}

// Panels of formwork, 1.33 × 2 m on 4 m, with four tie holes each, pores, and streaks that rain left.
PatternFields shutters(std::uint32_t px, std::uint64_t key) {
  const Field grain = layered_noise(px, {px / 4, px / 4}, 2, 1, key),
              clouds = layered_noise(px, {9, 7}, 5, 0.7, key + 1), runs = layered_noise(px, {56, 3}, 3, 0.7, key + 2),
              plies = layered_noise(px, {8, 70}, 2, 0.8, key + 3);
  const Cells pores = cells(px, 60, key + 4);
  const Field panels = random_values(8, key + 5);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double u = (c + 0.5) / px + 0.05, v = (r + 0.5) / px + 0.07, x = u * 3 - std::floor(u * 3),
                 y = v * 2 - std::floor(v * 2);
    const double edge_m = 4 * std::min(off_lines(u, 3), off_lines(v, 2)), seam = 1 - step(edge_m, 0.008, 0.010);
    const double dx = (std::min(x, 1 - x) - 0.25) * 1.333, dy = (std::min(y, 1 - y) - 0.22) * 2;
    const double hole = 1 - step(std::sqrt(dx * dx + dy * dy), 0.014, 0.010);
    const bool is_pore = pores.chance.at(c, r) > 0.93f && pores.to_edge.at(c, r) > 0.75f;
    const double own = panels.at(static_cast<std::uint32_t>(u * 3) % 3, static_cast<std::uint32_t>(v * 2) % 2) - 0.5;
    return {0.25 * grain.at(c, r) + 0.5 * clouds.at(c, r) + 0.35 * runs.at(c, r) + 0.25 * plies.at(c, r) + 0.35 * own -
                0.9 * seam - 1.6 * hole - (is_pore ? 0.7 : 0),
            0.15 * grain.at(c, r) + 0.15 * plies.at(c, r) - seam - 3 * hole - (is_pore ? 1.5 : 0),
            0.6 * step(runs.at(c, r) + 0.6 * clouds.at(c, r), 0.4, 0.5), grain.at(c, r) + clouds.at(c, r)};
  });
}

// Corrugations 77 mm apart (76.2 mm by ASTM A361: 3 inches) on 2 m; sheets lap every 0.67 m across; rust at the laps.
PatternFields corrugations(std::uint32_t px, std::uint64_t key) {
  const Field clouds = layered_noise(px, {10, 6}, 5, 0.7, key), runs = layered_noise(px, {60, 3}, 3, 0.8, key + 1),
              grain = layered_noise(px, {px / 4, px / 4}, 2, 1, key + 2);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double u = (c + 0.5) / px, v = (r + 0.5) / px, wave = direction_of(26 * u).x;
    const double lap = 1 - step(2 * off_lines(u + 0.1, 3), 0.004, 0.006),
                 end = 1 - step(2 * off_lines(v + 0.1, 1), 0.006, 0.008);
    const double screw = wave > 0.6 && off_lines(v + 0.25, 2) * 2 < 0.009 && direction_of(13 * u).x > 0.7 ? 1 : 0;
    const double rust = step(clouds.at(c, r) + 0.7 * runs.at(c, r) + 0.25 * (lap + end), 0.5, 0.5);
    return {0.12 * wave + 0.5 * clouds.at(c, r) + 0.35 * runs.at(c, r) + 0.12 * grain.at(c, r) -
                0.8 * std::max(lap, end) - screw,
            wave + 0.25 * std::max(lap, end) + 0.6 * screw + 0.02 * grain.at(c, r), rust,
            1.5 * rust + 0.5 * clouds.at(c, r)};
  });
}

// Seams 500 mm apart on 4 m (600 mm coil, as VMZINC's guide to standing seams has them), 25 mm high, with slightly
// buckled trays between, and a cross seam in each tray.
PatternFields seams(std::uint32_t px, std::uint64_t key) {
  const Field clouds = layered_noise(px, {7, 5}, 4, 0.7, key), runs = layered_noise(px, {64, 4}, 3, 0.8, key + 1),
              buckles = gradient_noise(px, {16, 10}, key + 2),
              grain = layered_noise(px, {px / 4, px / 4}, 2, 1, key + 3);
  const Field trays = random_values(8, key + 4);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double u = (c + 0.5) / px, v = (r + 0.5) / px, off_m = 4 * off_lines(u, 8);
    const double seam = 1 - step(off_m, 0.018, 0.014), foot = 1 - step(off_m, 0.035, 0.02);
    const auto tray = static_cast<std::uint32_t>(u * 8);
    const double cross = 1 - step(4 * off_lines(v + trays.at(tray, 1), 1), 0.010, 0.010);
    return {0.5 * (trays.at(tray, 0) - 0.5) + 0.45 * clouds.at(c, r) + 0.3 * runs.at(c, r) + 0.1 * grain.at(c, r) +
                0.5 * seam - 0.7 * (foot - seam) - 0.5 * cross,
            1.5 * seam + 0.25 * buckles.at(c, r) + 0.3 * cross, 0.4 * step(runs.at(c, r) + clouds.at(c, r), 0.5, 0.6),
            clouds.at(c, r) + runs.at(c, r)};
  });
}

// Bitumen sheets in rolls 1 m wide on 16 m, lapped by 80 mm (EN 13707 rolls; DIN 18531 laps), each 4 m long here, with
// dried puddles; some sheets were renewed.
PatternFields felt(std::uint32_t px, std::uint64_t key) {
  constexpr std::uint32_t kRolls = 16;
  const Field grit = random_values(px, key), clouds = layered_noise(px, {13, 13}, 5, 0.7, key + 1),
              puddles = layered_noise(px, {13, 13}, 4, 0.5, key + 2), sway = gradient_noise(px, {3, 12}, key + 3);
  const Field rolls = random_values(kRolls, key + 4);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double u = (c + 0.5) / px + 0.0006 * sway.at(c, r), v = (r + 0.5) / px, across = u * kRolls + kRolls;
    const auto roll = static_cast<std::uint32_t>(across) % kRolls;
    const double along = v * 4 + rolls.at(roll, 1), part = across - std::floor(across);
    const auto sheet = static_cast<std::uint32_t>(along) % 4;
    const double edge = 1 - step(std::min(part, 1 - part), 0.030, 0.030),
                 end = 1 - step(off_lines(along, 1) * 4, 0.030, 0.030);
    const double rim = 1 - std::min(1.0, std::abs(puddles.at(c, r) - 0.16) / 0.05),
                 puddle = step(puddles.at(c, r), 0.26, 0.24);
    const double chance = rolls.at(roll, 6 + sheet), mend = chance > 0.93 ? 1 : 0;
    const double s = grit.at(c, r) - 0.5, own = rolls.at(roll, 2 + sheet) - 0.5;
    return {0.45 * s + 0.70 * clouds.at(c, r) + 0.30 * own - 0.8 * edge - 0.7 * end + 0.35 * rim - 0.1 * mend,
            0.5 * s + 0.9 * (part < 0.08 ? 1 : 0) - edge, 0.35 * puddle + 0.15 * mend, 1.2 * s - 0.8 * puddle - edge};
  });
}

// Gravel that wind has moved about, of single texels: DIN 18531 asks for stones of 16 to 32 mm. Moss grows where it is
// thin.
PatternFields gravel_bed(std::uint32_t px, std::uint64_t key) {
  const Field stones = random_values(px, key), drifts = layered_noise(px, {10, 10}, 4, 0.7, key + 1),
              moss = layered_noise(px, {9, 9}, 5, 0.65, key + 2);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double stone = stones.at(c, r) - 0.5, drift = drifts.at(c, r);
    return {1.1 * stone + 0.9 * drift, stone + 0.5 * drift, 0.7 * step(moss.at(c, r) - 0.3 * drift, 0.30, 0.45), stone};
  });
}

namespace {

// Stones of up to 11 mm (EN 13108-1, AC 11) in bitumen, on a square of 4 m or more.
struct Stones {
  Field stone, grit, clouds, blots;
  Stones(std::uint32_t px, std::uint32_t cloud_waves, std::uint64_t key)
      : stone(random_values(px, key)),
        grit(layered_noise(px, {px / 4, px / 4}, 2, 1, key + 1)),
        clouds(layered_noise(px, {cloud_waves, cloud_waves}, 5, 0.75, key + 2)),
        blots(gradient_noise(px, {cloud_waves + 2, cloud_waves + 2}, key + 9)) {}

  // Light stones stand out where traffic wore the bitumen off them, and drops of oil are dark.
  SheetTexel at(std::uint32_t c, std::uint32_t r) const {
    const double s = stone.at(c, r), light = s * s * s * s - 0.2, g = grit.at(c, r), cloud = clouds.at(c, r);
    const double oil = step(blots.at(c, r), 0.46, 0.16);
    return {0.85 * light + 0.35 * g + 0.70 * cloud - 0.5 * oil, 0.8 * light + 0.5 * g, 0.2 * oil,
            0.6 * g - 0.6 * light + 0.6 * cloud - oil};
  }
};

// Cracks of asphalt: open ones are thin, and bands of bitumen fill others.
struct AsphaltCracks {
  Field net, where, bends;
  AsphaltCracks(std::uint32_t px, WaveCounts waves, std::uint64_t key)
      : net(layered_noise(px, waves, 5, 0.55, key)),
        where(layered_noise(px, {5, 5}, 3, 0.6, key + 1)),
        bends(layered_noise(px, {waves.across / 2 + 1, waves.along / 2 + 1}, 3, 0.35, key + 2)) {}

  void add(std::uint32_t c, std::uint32_t r, SheetTexel& t) const {
    const double tired = where.at(c, r), hair = crack(net.at(c, r), tired, 0.022);
    const double band = (1 - step(std::abs(bends.at(c, r)), 0.016, 0.012)) * step(-tired, 0.21, 0.05);
    t.tone -= 2.2 * hair, t.relief += 0.6 * band - 3 * hair, t.rough += 0.5 * hair - 1.5 * band;
    t.accent = std::max(t.accent, 0.6 * band);
  }
};

}  // namespace

PatternFields asphalt(std::uint32_t px, std::uint64_t key) {
  const Stones stones(px, 9, key);
  return by_texel(px, [&](auto c, auto r) {
    SheetTexel t = stones.at(c, r);
    t.accent = 0;
    return t;
  });
}

PatternFields worn_asphalt(std::uint32_t px, std::uint64_t key) {
  const Stones stones(px, 9, key);
  const AsphaltCracks cracks(px, {7, 7}, key + 3);
  return by_texel(px, [&](auto c, auto r) {
    SheetTexel t = stones.at(c, r);
    cracks.add(c, r, t);
    return t;
  });
}

namespace {

// The wear of a street of two lanes, as shares of its width from a gutter to the middle. Wheels of most cars are 1.5 m
// apart; streets are about 6 m wide.
struct LaneWear {
  double track = 0, oil = 0, gutter = 0, seam = 0;
};
LaneWear lane_wear(double across, double sway) {
  const double u = std::min(across, 1 - across) + sway;
  const auto bump = [&](double at, double wide) { return 1 - step(std::abs(u - at), wide / 2, wide); };
  return {std::max(bump(0.155, 0.10), bump(0.390, 0.10)), bump(0.27, 0.10), 1 - step(u, 0.045, 0.09),
          1 - step(std::abs(across - 0.5 + 0.3 * sway), 0.004, 0.004)};
}

}  // namespace

PatternFields lanes(std::uint32_t px, std::uint64_t key) {
  const Stones stones(px, 9, key);
  const AsphaltCracks cracks(px, {14, 9}, key + 3);
  const Field sway = gradient_noise(px, {1, 5}, key + 7), worn = layered_noise(px, {12, 7}, 3, 0.7, key + 8);
  return by_texel(px, [&](auto c, auto r) {
    SheetTexel t = stones.at(c, r);
    cracks.add(c, r, t);
    const double varied = 1 + 0.7 * worn.at(c, r);
    const LaneWear wear = lane_wear((c + 0.5) / px, 0.012 * sway.at(c, r));
    const double open = wear.seam * step(worn.at(c, r), -0.1, 0.2);
    t.tone += varied * (0.75 * wear.track - 0.40 * wear.oil - 0.80 * wear.gutter) - 1.3 * open;
    t.rough += 0.6 * wear.gutter - 0.8 * wear.track, t.relief -= 1.5 * open;
    return t;
  });
}

// Concrete cast in place and brushed, with pores and dark wet edges of stains.
PatternFields cast(std::uint32_t px, std::uint64_t key) {
  const Field brush = layered_noise(px, {12, px / 4}, 2, 0.8, key), grit = random_values(px, key + 1),
              clouds = layered_noise(px, {6, 6}, 5, 0.65, key + 2), stains = layered_noise(px, {7, 7}, 4, 0.6, key + 3);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double s = grit.at(c, r) - 0.5, stain = step(stains.at(c, r), 0.3, 0.5);
    const double hair = crack(clouds.at(c, r), stains.at(c, r), 0.010);
    return {0.55 * s + 0.3 * brush.at(c, r) + 0.45 * clouds.at(c, r) - 0.3 * stain - hair,
            0.5 * s + brush.at(c, r) - 2 * hair, 0.35 * stain, s + brush.at(c, r) - 0.5 * stain};
  });
}

// Wind ripples about 100 mm apart on 4 m that part and join (Sharp, "Wind Ripples", J. Geol. 1963: 50 to 250 mm).
PatternFields ripples(std::uint32_t px, std::uint64_t key) {
  const Field sway = layered_noise(px, {5, 7}, 3, 0.5, key), grit = random_values(px, key + 1),
              where = gradient_noise(px, {5, 5}, key + 2), clouds = layered_noise(px, {9, 9}, 4, 0.7, key + 3);
  return by_texel(px, [&](auto c, auto r) -> SheetTexel {
    const double turns = 38.0 * (r + 0.5) / px + 2.6 * sway.at(c, r), wave = direction_of(turns).x;
    // crests are narrower than troughs
    const double ripple = (wave + 0.25 * direction_of(2 * turns).x) * step(where.at(c, r), -0.1, 0.9),
                 s = grit.at(c, r) - 0.5;
    return {0.35 * ripple + 0.7 * s + 0.5 * clouds.at(c, r), ripple + 0.25 * s, 0.4 * step(s, 0.44, 0.05), s};
  });
}

}  // namespace citykiln::materials
