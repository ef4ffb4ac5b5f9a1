// Patterns of single strokes that lie over each other: grass, herbs, fallen leaves, straw.
#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"
#include "compiler/materials/pattern_fields.h"

namespace citykiln::materials {
namespace {

// Random numbers in order.
class Draws {
 public:
  explicit Draws(std::uint64_t key) : table_(random_values(256, key)) {}
  double next() { return table_.values[at_++ % table_.values.size()]; }

 private:
  Field table_;
  std::size_t at_ = 0;
};

// The top of the strokes at each texel: its height, its shade and its share of the accent.
struct Pile {
  explicit Pile(std::uint32_t side_px)
      : px(side_px), height(flat_field(side_px)), shade(flat_field(side_px)), accent(flat_field(side_px)) {}
  std::uint32_t px;
  Field height, shade, accent;
};

// A leaf or blade: a line from its foot to its tip, widest in the middle.
struct Stroke {
  Vec2 from_px, along;  // unit direction
  double length_px, half_px, bend;
  double height, rise, shade, accent;
};

std::uint32_t wrapped(double at, std::uint32_t px) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(at)) & static_cast<std::int64_t>(px - 1));
}

// Sides are powers of two.
void lay_stroke(const Stroke& s, Pile& pile) {
  const Vec2 aside{-s.along.y, s.along.x};
  const int steps = std::max(2, static_cast<int>(s.length_px * 1.3));
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps, half = s.half_px * std::min(1.0, 2.2 * (1 - t) * (0.4 + t)) + 0.3;
    const Vec2 middle = s.from_px + s.along * (t * s.length_px) + aside * (s.bend * t * t * s.length_px);
    const int across = static_cast<int>(half + 0.5);
    for (int k = -across; k <= across; ++k) {
      const std::uint32_t c = wrapped(middle.x + aside.x * k, pile.px), r = wrapped(middle.y + aside.y * k, pile.px);
      const double height = s.height + s.rise * t - 0.03 * std::abs(k);
      if (height < pile.height.at(c, r)) continue;
      pile.height.at(c, r) = static_cast<float>(height);
      pile.shade.at(c, r) = static_cast<float>(s.shade + 0.25 * t - (k == 0 && across > 1 ? 0.25 : 0));
      pile.accent.at(c, r) = static_cast<float>(s.accent);
    }
  }
}

struct Growth {
  int strokes;
  double length_px, half_px;
  double dry_share;  ///< The share of strokes with the colour of the accent.
};

void grow(const Growth& growth, const Field& where, Draws& draws, Pile& pile) {
  for (int i = 0; i < growth.strokes; ++i) {
    const Vec2 from{draws.next() * pile.px, draws.next() * pile.px};
    const double local = where.at(wrapped(from.x, pile.px), wrapped(from.y, pile.px));
    const bool is_dry = draws.next() < growth.dry_share * (1 - 1.6 * local);
    const Vec2 along = direction_of(draws.next());
    lay_stroke(
        {from, along, growth.length_px * (0.5 + draws.next()), growth.half_px * (0.7 + 0.6 * draws.next()),
         0.5 * (draws.next() - 0.5), draws.next() * 0.7, 0.3, draws.next() - 0.5 + 0.6 * local, is_dry ? 0.9 : 0.0},
        pile);
  }
}

// Clover: three round leaflets, lying above short grass in patches.
void add_clover(int leaves, double leaflet_px, const Field& where, Draws& draws, Pile& pile) {
  for (int i = 0; i < leaves; ++i) {
    const Vec2 at{draws.next() * pile.px, draws.next() * pile.px};
    const double turn = draws.next(), shade = -0.5 + 0.5 * draws.next();
    if (where.at(wrapped(at.x, pile.px), wrapped(at.y, pile.px)) < 0.22) continue;
    for (int leaflet = 0; leaflet < 3; ++leaflet)
      lay_stroke({at, direction_of(turn + leaflet / 3.0), 1.6 * leaflet_px, leaflet_px / 2, 0, 0.9, 0.1, shade, 0},
                 pile);
  }
}

PatternFields seen_from_above(const Pile& pile, const Field& ground, double ground_accent) {
  PatternFields f{flat_field(pile.px), flat_field(pile.px), {}, flat_field(pile.px), flat_field(pile.px)};
  for (std::size_t i = 0; i < pile.height.values.size(); ++i) {
    const double high = pile.height.values[i];
    const bool is_bare = high <= 0;
    f.tone.values[i] =
        static_cast<float>(is_bare ? -0.9 + 0.4 * ground.values[i]
                                   : 0.6 * (high - 0.6) + 0.7 * pile.shade.values[i] + 0.35 * ground.values[i]);
    f.relief.values[i] = static_cast<float>(high + 0.1 * ground.values[i]);
    f.accent.values[i] = is_bare ? static_cast<float>(ground_accent) : pile.accent.values[i];
    f.rough.values[i] = static_cast<float>(-high);
  }
  f.tone = fine_tones(f.tone, f.relief).tone;
  f.relief = normalised(std::move(f.relief), 1);
  f.rough = tones(f.rough, f.rough).tone;
  return f;
}

}  // namespace

// Mown blades of about 40 mm on 2 m, mixed with clover; a tenth of them are dry.
PatternFields blades(std::uint32_t px, std::uint64_t key) {
  const Field clumps = layered_noise(px, {7, 7}, 4, 0.7, key), clover = layered_noise(px, {6, 6}, 3, 0.6, key + 1);
  Draws draws(key + 2);
  Pile pile(px);
  const double scale = px / 512.0;
  grow({static_cast<int>(16000 * scale * scale), 11 * scale, 0.5, 0.14}, clumps, draws, pile);
  add_clover(static_cast<int>(2400 * scale * scale), 3.2 * scale, clover, draws, pile);
  return seen_from_above(pile, clumps, 0.35);
}

// Long stems and broad leaves of about 0.2 m on 4 m, in tussocks.
PatternFields tufts(std::uint32_t px, std::uint64_t key) {
  const Field clumps = layered_noise(px, {10, 10}, 4, 0.8, key);
  Draws draws(key + 2);
  Pile pile(px);
  const double scale = px / 512.0;
  grow({static_cast<int>(9000 * scale * scale), 20 * scale, 0.6, 0.22}, clumps, draws, pile);
  grow({static_cast<int>(1500 * scale * scale), 9 * scale, 1.8, 0.05}, clumps, draws, pile);
  return seen_from_above(pile, clumps, 0.25);
}

// Leaves of about 80 mm and twigs on 4 m; nine of ten leaves are of last year.
PatternFields litter(std::uint32_t px, std::uint64_t key) {
  const Field clumps = layered_noise(px, {9, 9}, 4, 0.7, key);
  Draws draws(key + 2);
  Pile pile(px);
  const double scale = px / 512.0;
  grow({static_cast<int>(5200 * scale * scale), 10 * scale, 2.6 * scale, 0.75}, clumps, draws, pile);
  grow({static_cast<int>(260 * scale * scale), 34 * scale, 0.6, 0.2}, clumps, draws, pile);
  return seen_from_above(pile, clumps, 0.1);
}

// Reeds along v, in courses whose ends show, on 2 m.
PatternFields thatch(std::uint32_t px, std::uint64_t key) {
  const Field fibre = layered_noise(px, {64, 8}, 3, 0.9, key), courses = layered_noise(px, {14, 5}, 3, 0.7, key + 1),
              weather = layered_noise(px, {10, 10}, 4, 0.8, key + 2);
  const Field relief = combined(px, [&](auto c, auto r) {
    const double up = (r + 0.5) / px * 5 + 0.25 * courses.at(c, r), part = up - std::floor(up);
    return 0.9 * fibre.at(c, r) + 0.7 * (1 - part) * step(part, 0.04, 0.08);
  });
  const Field tone = combined(px, [&](auto c, auto r) { return relief.at(c, r) + 0.5 * weather.at(c, r); });
  PatternFields f = fine_tones(tone, relief);
  f.accent = combined(px, [&](auto c, auto r) { return 0.7 * step(weather.at(c, r), 0.3, 0.6); });
  return f;
}

}  // namespace citykiln::materials
