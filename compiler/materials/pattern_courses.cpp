// Patterns of units laid in courses: bricks, stones, slabs, tiles, boards.
#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"
#include "compiler/materials/pattern_fields.h"

namespace citykiln::materials {
namespace {

// The units that a square is laid with: `across` stretchers a course, `along` courses.
struct Coursing {
  Bond bond;
  std::uint32_t across, along;
  double lift = 0;  ///< Share of a course by which all are raised.
};

// A place on a unit: its position from the unit's lower left corner (0 … 1 each way), the distance from the nearest
// joint as a share of the square's side, and the numbers of the unit.
struct Place {
  double x, y, edge;
  std::uint32_t column, row;
};

double fraction(double value) { return value - std::floor(value); }

// The unit of a course that begins at shares `from` and ends at `to` of a period, at the share `at` of it.
struct Span {
  double from, to;
  bool is_second;
};

// Flemish bond: a stretcher and a header, which takes a third of both.
Span flemish_span(double at) {
  constexpr double kStretcher = 2.0 / 3;
  return at < kStretcher ? Span{0, kStretcher, false} : Span{kStretcher, 1, true};
}

// The number of periods that a course has across, and the share of a period by which it is shifted.
struct Course {
  double periods, shift;
};
Course course_of(const Coursing& c, std::uint32_t row) {
  const bool is_odd = row % 2 == 1;
  switch (c.bond) {
    case Bond::kStack:
      return {1.0 * c.across, 0};
    case Bond::kHeader:
      return {2.0 * c.across, is_odd ? 0.5 : 0};
    case Bond::kEnglish:  // a header is centred over the middle of a stretcher
      return is_odd ? Course{2.0 * c.across, 0.5} : Course{1.0 * c.across, 0};
    case Bond::kFlemish:  // a header is centred over the middle of a stretcher
      return {c.across * 2.0 / 3, is_odd ? 0.5 : 0};
    case Bond::kRunning:
      break;
  }
  return {1.0 * c.across, is_odd ? 0.5 : 0};
}

Place place_at(double u, double v, const Coursing& c) {
  const double up = fraction(v + c.lift / c.along) * c.along;
  const std::uint32_t row = std::min(static_cast<std::uint32_t>(up), c.along - 1);
  const auto [periods, shift] = course_of(c, row);
  const double over = fraction(u) * periods + shift;
  const auto column = static_cast<std::uint32_t>(over) % static_cast<std::uint32_t>(periods + 0.5);
  const Span span = c.bond == Bond::kFlemish ? flemish_span(fraction(over)) : Span{0, 1, false};
  const double x = (fraction(over) - span.from) / (span.to - span.from), y = up - row;
  const double edge = std::min(std::min(x, 1 - x) * (span.to - span.from) / periods, std::min(y, 1 - y) / c.along);
  return {x, y, edge, 2 * column + (span.is_second ? 1 : 0), row};
}

// Random numbers of units.
struct Chances {
  explicit Chances(std::uint64_t key) : table(random_values(128, key)) {}
  float of(const Place& p, std::uint32_t use = 0) const { return table.at((p.column + 37 * use) % 128, p.row % 128); }
  Field table;
};

template <typename At>
PatternFields by_place(std::uint32_t px, const Coursing& c, double sway, std::uint64_t key, At at) {
  const Field across = layered_noise(px, {20, 20}, 3, 0.7, key + 21),
              along = layered_noise(px, {20, 20}, 3, 0.7, key + 22);
  PatternFields fields{flat_field(px), flat_field(px), {}, flat_field(px), flat_field(px)};
  for (std::uint32_t row = 0; row < px; ++row)
    for (std::uint32_t column = 0; column < px; ++column) {
      const double u = (column + 0.5) / px + sway * across.at(column, row),
                   v = (row + 0.5) / px + sway * along.at(column, row);
      at(place_at(u + 1, v + 1, c), column, row, fields);
    }
  return fields;
}

PatternFields finished(PatternFields fields, bool keep_wide = true) {
  fields.tone = keep_wide ? tones(fields.tone, fields.relief).tone : fine_tones(fields.tone, fields.relief).tone;
  fields.relief = normalised(std::move(fields.relief), 1);
  fields.rough = tones(fields.rough, fields.rough).tone;
  return fields;
}

}  // namespace

// Joints are 10 mm wide on 2 m, and lie 4 mm behind the bricks.
PatternFields bricks(Bond bond, std::uint32_t across, std::uint32_t along, std::uint32_t px, std::uint64_t key) {
  constexpr double kHalfJoint = 0.005 / 2, kSoft = 0.004 / 2;
  const Field grain = layered_noise(px, {px / 8, px / 8}, 3, 1, key),
              clouds = layered_noise(px, {18, 18}, 3, 0.8, key + 1);
  const Chances chances(key + 10);
  return finished(by_place(px, {bond, across, along}, 0.0006, key, [&](const Place& p, auto c, auto r, auto& f) {
    const double inside = step(p.edge, kHalfJoint + kSoft / 2, kSoft), chance = chances.of(p), burnt = chances.of(p, 1);
    const double own = 0.9 * (chance - 0.5) - 1.1 * step(burnt, 0.93, 0.04) + 0.5 * clouds.at(c, r);
    f.tone.at(c, r) = static_cast<float>(inside * own + (0.25 + 0.2 * inside) * grain.at(c, r));
    f.relief.at(c, r) = static_cast<float>(inside + 0.12 * grain.at(c, r) + 0.1 * chance);
    f.accent.at(c, r) = static_cast<float>(1 - inside);
    f.rough.at(c, r) = static_cast<float>(grain.at(c, r) - 0.3 * inside * chance);
  }));
}

// Blocks of 667 × 333 mm on 4 m with drafted edges and joints of 5 mm, darkened by dirt.
PatternFields ashlar(std::uint32_t px, std::uint64_t key) {
  const Field grain = layered_noise(px, {px / 8, px / 8}, 3, 1, key),
              beds = layered_noise(px, {8, 40}, 4, 0.8, key + 1);
  const Chances chances(key + 10);
  return finished(by_place(px, {Bond::kRunning, 6, 12}, 0.0003, key, [&](const Place& p, auto c, auto r, auto& f) {
    const double inside = step(p.edge, 0.0018, 0.0018), draft = step(p.edge, 0.006, 0.004), chance = chances.of(p);
    f.tone.at(c, r) = static_cast<float>(0.8 * (chance - 0.5) + 0.35 * grain.at(c, r) + 0.5 * beds.at(c, r) +
                                         1.3 * (inside - 1) + 0.12 * draft);
    f.relief.at(c, r) = static_cast<float>(1.2 * inside + 0.3 * draft + 0.12 * beds.at(c, r) + 0.08 * grain.at(c, r));
    f.accent.at(c, r) = static_cast<float>(0.6 * (1 - inside) + 0.8 * step(chances.of(p, 1), 0.85, 0.3) * inside * 0.5);
    f.rough.at(c, r) = static_cast<float>(grain.at(c, r) + beds.at(c, r));
  }));
}

// Stones of about 0.3 m on 4 m, split from the bed, in mortar flush with half their rounding.
PatternFields rubble(std::uint32_t px, std::uint64_t key) {
  const Cells stones = cells(px, 13, key);
  const Field grain = layered_noise(px, {px / 8, px / 8}, 3, 1, key + 1),
              faces = layered_noise(px, {24, 24}, 4, 0.8, key + 2);
  const Field sway = layered_noise(px, {26, 26}, 3, 0.7, key + 3);
  PatternFields f{flat_field(px), flat_field(px), {}, flat_field(px), flat_field(px)};
  for (std::uint32_t r = 0; r < px; ++r)
    for (std::uint32_t c = 0; c < px; ++c) {
      const double edge = stones.to_edge.at(c, r) + 0.10 * sway.at(c, r), inside = step(edge, 0.13, 0.10);
      const double chance = stones.chance.at(c, r);
      f.tone.at(c, r) = static_cast<float>(inside * (1.1 * (chance - 0.5) + 0.6 * faces.at(c, r)) +
                                           0.3 * grain.at(c, r) + 0.6 * std::min(edge, 0.3) * inside);
      f.relief.at(c, r) = static_cast<float>(1.4 * std::min(std::max(edge, 0.05), 0.32) * 3 + 0.25 * faces.at(c, r) +
                                             0.06 * grain.at(c, r) + 0.3 * inside * chance);
      f.accent.at(c, r) = static_cast<float>(1 - inside);
      f.rough.at(c, r) = static_cast<float>(grain.at(c, r));
    }
  return finished(std::move(f));
}

// Slabs of 0.5 m (EN 1339) on 2 m, half bond, joints of 4 mm full of dirt; trodden spots, and slabs that were replaced.
PatternFields slabs(std::uint32_t px, std::uint64_t key) {
  const Field grain = layered_noise(px, {px / 4, px / 4}, 2, 1, key),
              clouds = layered_noise(px, {14, 14}, 4, 0.8, key + 1);
  const Cells spots = cells(px, 15, key + 2);
  const Chances chances(key + 10);
  return finished(by_place(px, {Bond::kRunning, 4, 4}, 0.0004, key, [&](const Place& p, auto c, auto r, auto& f) {
    const double inside = step(p.edge, 0.0026, 0.0022), chance = chances.of(p);
    const double dirt = 1 - step(p.edge, 0.012, 0.02);
    const bool is_gum = spots.chance.at(c, r) > 0.86f && spots.to_edge.at(c, r) > 0.72f;
    f.tone.at(c, r) = static_cast<float>(0.7 * (chance - 0.5) + 0.45 * grain.at(c, r) + 0.55 * clouds.at(c, r) -
                                         0.5 * dirt - (is_gum ? 0.8 : 0));
    f.relief.at(c, r) = static_cast<float>(inside + 0.25 * (chance - 0.5) + 0.05 * grain.at(c, r));
    f.accent.at(c, r) = static_cast<float>(1 - inside);
    f.rough.at(c, r) = static_cast<float>(grain.at(c, r) - 0.8 * clouds.at(c, r) - (is_gum ? 2 : 0));
  }));
}

// Setts of 100 mm (EN 1342) on 2 m in rows, worn round, with sand in the joints.
PatternFields setts(std::uint32_t px, std::uint64_t key) {
  const Field grain = layered_noise(px, {px / 4, px / 4}, 2, 1, key),
              faces = layered_noise(px, {40, 40}, 3, 0.8, key + 1);
  const Chances chances(key + 10);
  return finished(by_place(px, {Bond::kRunning, 18, 20}, 0.004, key, [&](const Place& p, auto c, auto r, auto& f) {
    // corners are round
    const double x = 2 * p.x - 1, y = 2 * p.y - 1, corner = x * x * y * y;
    const double edge = p.edge - 0.012 * corner, inside = step(edge, 0.0045, 0.004), chance = chances.of(p);
    const double dome = 1 - 0.5 * (x * x + y * y);
    f.tone.at(c, r) = static_cast<float>(inside * (1.0 * (chance - 0.5) + 0.5 * dome) + 0.4 * grain.at(c, r) +
                                         0.3 * faces.at(c, r) * inside);
    f.relief.at(c, r) = static_cast<float>(inside * (1 + 0.7 * dome + 0.4 * (chance - 0.5)) + 0.12 * faces.at(c, r));
    f.accent.at(c, r) = static_cast<float>(1 - inside);
    f.rough.at(c, r) = static_cast<float>(0.5 * grain.at(c, r) - inside * dome);
  }));
}

// Kerb stones 1 m long (EN 1340) on 2 m; v runs along the kerb.
PatternFields kerbs(std::uint32_t px, std::uint64_t key) {
  const Field grain = layered_noise(px, {px / 4, px / 4}, 2, 1, key),
              clouds = layered_noise(px, {20, 12}, 3, 0.8, key + 1);
  PatternFields f{flat_field(px), flat_field(px), {}, flat_field(px), flat_field(px)};
  for (std::uint32_t r = 0; r < px; ++r)
    for (std::uint32_t c = 0; c < px; ++c) {
      const double along = fraction((r + 0.5) / px * 2), edge = std::min(along, 1 - along),
                   inside = step(edge, 0.006, 0.006);
      const double own = r < px / 2 ? 0.1 : -0.1;
      f.tone.at(c, r) =
          static_cast<float>(0.5 * grain.at(c, r) + 0.5 * clouds.at(c, r) + own - 0.3 * (1 - step(edge, 0.02, 0.03)));
      f.relief.at(c, r) = static_cast<float>(2 * inside + 0.2 * grain.at(c, r));
      f.accent.at(c, r) = static_cast<float>(1 - inside);
      f.rough.at(c, r) = static_cast<float>(grain.at(c, r));
    }
  return finished(std::move(f));
}

// Interlocking tiles of 200 × 333 mm cover (DIN EN 1304, 15 a m²) on 2 m: a roll and a pan each, lapped down the slope.
PatternFields pantiles(std::uint32_t px, std::uint64_t key) {
  const Field grain = layered_noise(px, {px / 8, px / 8}, 3, 1, key),
              moss = layered_noise(px, {22, 22}, 4, 0.8, key + 1);
  const Chances chances(key + 10);
  return finished(by_place(px, {Bond::kStack, 10, 6}, 0.0006, key, [&](const Place& p, auto c, auto r, auto& f) {
    const double roll = direction_of(p.x).x, lap = step(p.y, 0.03, 0.05), chance = chances.of(p);
    // a tile is thicker at its lower end, where it lies on the next one; its shadow falls on the head of that one
    const double shade = 1 - step(1 - p.y, 0.05, 0.09);
    f.tone.at(c, r) = static_cast<float>(0.9 * (chance - 0.5) + 0.3 * roll - 1.1 * shade + 0.3 * grain.at(c, r) +
                                         0.5 * moss.at(c, r));
    f.relief.at(c, r) = static_cast<float>(roll + 0.9 * lap * (1 - p.y));
    f.accent.at(c, r) = static_cast<float>(0.8 * step(moss.at(c, r) + 0.35 * shade, 0.52, 0.3));
    f.rough.at(c, r) = static_cast<float>(grain.at(c, r) + moss.at(c, r));
  }));
}

// Slates 250 mm wide at a gauge of 200 mm (EN 12326, 500 × 250 mm with a lap of 100 mm) on 2 m.
PatternFields slates(std::uint32_t px, std::uint64_t key) {
  const Field grain = layered_noise(px, {30, 50}, 4, 0.9, key), moss = layered_noise(px, {18, 18}, 4, 0.8, key + 1);
  const Chances chances(key + 10);
  return finished(by_place(px, {Bond::kRunning, 8, 10}, 0.0012, key, [&](const Place& p, auto c, auto r, auto& f) {
    const double side = step(std::min(p.x, 1 - p.x), 0.012, 0.012), lap = step(p.y, 0.03, 0.04), chance = chances.of(p);
    const double shade = 1 - step(1 - p.y, 0.03, 0.06);
    f.tone.at(c, r) = static_cast<float>(1.3 * (chance - 0.5) - 1.2 * (1 - side) - 1.2 * shade + 0.35 * grain.at(c, r) +
                                         0.3 * moss.at(c, r));
    f.relief.at(c, r) =
        static_cast<float>(side * lap * (1.2 - p.y) + 0.12 * grain.at(c, r) + 0.25 * chance * (1 - p.y));
    f.accent.at(c, r) =
        static_cast<float>(0.7 * step(moss.at(c, r), 0.62, 0.2) + 0.5 * step(chances.of(p, 1), 0.8, 0.2));
    f.rough.at(c, r) = static_cast<float>(grain.at(c, r) + chances.of(p, 2));
  }));
}

// Shingles of random width, 100 to 250 mm, with an exposure of 125 mm (5 inches) on 2 m, split along the grain.
PatternFields shingles(std::uint32_t px, std::uint64_t key) {
  const Field fibre = layered_noise(px, {96, 6}, 3, 0.9, key), wear = layered_noise(px, {16, 16}, 3, 0.8, key + 1);
  const Chances chances(key + 10);
  return finished(by_place(px, {Bond::kRunning, 12, 16}, 0.0008, key, [&](const Place& p, auto c, auto r, auto& f) {
    // the joint before the unit and that after it move by up to a quarter of its width
    const double before = 0.5 * (chances.of(p, 1) - 0.5);
    const bool is_before = p.x < 0.25 + before;
    const double side = std::abs(p.x - 0.25 - before), chance = chances.of(p, is_before ? 2 : 0);
    const double gap = step(side, 0.02, 0.025), shade = 1 - step(1 - p.y, 0.05, 0.1);
    f.tone.at(c, r) = static_cast<float>(1.2 * (chance - 0.5) - 1.4 * (1 - gap) - 1.2 * shade + 0.55 * fibre.at(c, r) +
                                         0.4 * wear.at(c, r));
    f.relief.at(c, r) = static_cast<float>(gap * (1.2 - p.y) + 0.12 * fibre.at(c, r));
    f.accent.at(c, r) = static_cast<float>(0.6 * step(wear.at(c, r) + 0.4 * (chance - 0.5), 0.35, 0.5));
    f.rough.at(c, r) = static_cast<float>(fibre.at(c, r));
  }));
}

// Lapped boards with an exposure of 154 mm (6 inches) on 2 m, about 2 m long, with grain and knots.
PatternFields boards(std::uint32_t px, std::uint64_t key) {
  const Field fibre = layered_noise(px, {5, 110}, 2, 0.8, key), streaks = layered_noise(px, {3, 40}, 3, 0.8, key + 1),
              wear = layered_noise(px, {14, 14}, 4, 0.8, key + 2);
  const Chances chances(key + 10);
  return finished(by_place(px, {Bond::kStack, 1, 13, 0.5}, 0.0003, key, [&](const Place& p, auto c, auto r, auto& f) {
    const double joint_at = chances.of(p, 1), joint = step(std::abs(p.x - joint_at), 0.002, 0.002);
    const double shade = 1 - step(1 - p.y, 0.04, 0.07), chance = chances.of(p);
    f.tone.at(c, r) = static_cast<float>(0.5 * (chance - 0.5) - 1.0 * (1 - joint) - 1.5 * shade + 0.4 * fibre.at(c, r) +
                                         0.5 * streaks.at(c, r) + 0.35 * wear.at(c, r));
    f.relief.at(c, r) = static_cast<float>(joint * step(p.y, 0.02, 0.04) * (1.2 - p.y) + 0.06 * fibre.at(c, r));
    f.accent.at(c, r) = static_cast<float>(0.5 * step(wear.at(c, r) + 0.4 * streaks.at(c, r), 0.45, 0.4));
    f.rough.at(c, r) = static_cast<float>(fibre.at(c, r) + wear.at(c, r));
  }));
}

}  // namespace citykiln::materials
