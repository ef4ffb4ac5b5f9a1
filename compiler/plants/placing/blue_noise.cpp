#include "compiler/plants/placing/blue_noise.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"

namespace citykiln::plants {
namespace {

// Cell width; fine enough for the highest density on the steepest ground.
constexpr double kLattice_m = 2;

// Candidates per spacing² of ground. More give denser samples, but kRounds do not decide them.
constexpr double kCandidates = 2.5;

// Samples per spacing² of ground, and their increase per tree a hectare, as the lattice itself keeps dense candidates
// apart. Measured (blue_noise_test.cpp).
constexpr double kBlueNoiseSamples = 0.4925, kMoreSamples = 6.5e-5;

// Cells along a side of a block, which LeastSpacing can skip as a whole.
constexpr int kBlock = 16;

// Side of a grid bucket; at least kWidest_m, so that neighbours lie in adjacent buckets.
constexpr double kBucket_m = 8;

enum class State : std::uint8_t { kUndecided, kAccepted, kRejected };

struct Candidate {
  Sample sample;
  std::uint64_t priority = 0;
  float share_draw = 0;  // the sample is kept if this is below its density's share
};

struct CellDraws {
  Vec2 at;
  double keep, share;
  std::uint64_t priority;
};

// The random draws of a lattice cell: the candidate's place, whether it is kept, its priority.
CellDraws draws_for(std::uint64_t seed, std::int64_t column, std::int64_t row) {
  constexpr std::uint32_t kPurpose = 0x517e;
  const std::array<std::uint32_t, 2> key = {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
  const auto bits =
      philox4x32_10({static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), kPurpose, 0}, key);
  const auto unit = [](std::uint32_t word) { return word * 0x1p-32; };
  // the low bits of the first draw barely move the place, so they serve as the share's draw
  return {snapped(Vec2{(static_cast<double>(column) + unit(bits[0])) * kLattice_m,
                       (static_cast<double>(row) + unit(bits[1])) * kLattice_m}),
          unit(bits[2]), (bits[0] & 0xffffu) * 0x1p-16, std::uint64_t{bits[3]} << 32 | bits[1]};
}

// The probability that a cell's candidate is kept.
double chance_of(double spacing_m, double normal_z) {
  return kCandidates * kLattice_m * kLattice_m / (spacing_m * spacing_m * normal_z);
}

StableId id_of_cell(std::int64_t column, std::int64_t row) {
  const auto number = static_cast<std::uint64_t>(column) << 32 ^ (static_cast<std::uint64_t>(row) & 0xffffffffu);
  return stable_id(StableId{number}, "site", 0);
}

struct Cells {
  std::int64_t first_column, first_row, last_column, last_row;
};

Cells cells_in(const Box2& box) {
  const auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v / kLattice_m)); };
  return {cell(box.min.x), cell(box.min.y), cell(box.max.x), cell(box.max.y)};
}

// Appends the candidates of one block.
// @param most  Upper bound of chance_of() in the block.
void find_candidates(std::uint64_t seed, const Cells& cells, const Box2& influence, double most,
                     const DensityAt& density_at, std::vector<Candidate>& candidates) {
  for (std::int64_t row = cells.first_row; row <= cells.last_row; ++row)
    for (std::int64_t column = cells.first_column; column <= cells.last_column; ++column) {
      const CellDraws draws = draws_for(seed, column, row);
      if (draws.keep >= most || !influence.contains(draws.at)) continue;
      const SampleDensity density = density_at(draws.at);
      if (density.spacing_m <= 0 || density.normal_z < kLeastNormal_z) continue;
      if (draws.keep >= chance_of(density.spacing_m, density.normal_z)) continue;
      candidates.push_back(
          {{draws.at, id_of_cell(column, row), density}, draws.priority, static_cast<float>(draws.share)});
    }
}

std::vector<Candidate> candidates_in(std::uint64_t seed, const Box2& influence, const LeastSpacing& least_spacing,
                                     const DensityAt& density_at) {
  std::vector<Candidate> candidates;
  const Cells all = cells_in(influence);
  for (std::int64_t row = all.first_row; row <= all.last_row; row += kBlock)
    for (std::int64_t column = all.first_column; column <= all.last_column; column += kBlock) {
      const Cells block{column, row, std::min(column + kBlock - 1, all.last_column),
                        std::min(row + kBlock - 1, all.last_row)};
      const auto metres = [](std::int64_t cell) { return static_cast<double>(cell) * kLattice_m; };
      const Box2 box{{metres(block.first_column), metres(block.first_row)},
                     {metres(block.last_column + 1), metres(block.last_row + 1)}};
      const double spacing_m = least_spacing(box);
      if (spacing_m > 0)
        find_candidates(seed, block, influence, chance_of(spacing_m, kLeastNormal_z), density_at, candidates);
    }
  return candidates;
}

bool are_close(const Sample& a, const Sample& b) {
  const Vec3 apart = at_height(b.at - a.at, b.density.height_m - a.density.height_m);
  const double spacing_m = (a.density.spacing_m + b.density.spacing_m) / 2;
  return dot(apart, apart) < spacing_m * spacing_m;
}

// Candidates by grid bucket, as ranges of `members`.
struct Buckets {
  Vec2 corner;
  int columns, rows;
  std::vector<std::uint32_t> starts, members;

  int column(double x) const { return static_cast<int>((x - corner.x) / kBucket_m); }
  int row(double y) const { return static_cast<int>((y - corner.y) / kBucket_m); }
  std::size_t index(int c, int r) const { return static_cast<std::size_t>(r) * columns + c; }
};

Buckets bucket_all(std::span<const Candidate> candidates, const Box2& box) {
  Buckets buckets{
      box.min, static_cast<int>(box.width() / kBucket_m) + 1, static_cast<int>(box.height() / kBucket_m) + 1, {}, {}};
  const auto bucket_of = [&](const Candidate& c) {
    return buckets.index(buckets.column(c.sample.at.x), buckets.row(c.sample.at.y));
  };
  buckets.starts.assign(buckets.index(0, buckets.rows) + 1, 0);
  for (const Candidate& c : candidates) ++buckets.starts[bucket_of(c) + 1];
  for (std::size_t i = 1; i < buckets.starts.size(); ++i) buckets.starts[i] += buckets.starts[i - 1];
  buckets.members.resize(candidates.size());
  std::vector<std::uint32_t> next(buckets.starts.begin(), buckets.starts.end() - 1);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) buckets.members[next[bucket_of(candidates[i])]++] = i;
  return buckets;
}

// For each candidate, those within its spacing, as ranges of `members`.
struct Rivals {
  std::vector<std::uint32_t> starts, members;

  std::span<const std::uint32_t> of(std::size_t i) const {
    return std::span(members).subspan(starts[i], starts[i + 1] - starts[i]);
  }
};

Rivals rivals_of(std::span<const Candidate> candidates, const Box2& box) {
  const Buckets buckets = bucket_all(candidates, box);
  Rivals rivals{{0}, {}};
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    const Vec2 p = candidates[i].sample.at;
    const int c = buckets.column(p.x), r = buckets.row(p.y);
    const int first = std::max(c - 1, 0), last = std::min(c + 1, buckets.columns - 1);
    for (int y = std::max(r - 1, 0); y <= std::min(r + 1, buckets.rows - 1); ++y)
      for (std::uint32_t k = buckets.starts[buckets.index(first, y)]; k < buckets.starts[buckets.index(last, y) + 1];
           ++k) {
        const std::uint32_t j = buckets.members[k];
        if (j != i && are_close(candidates[i].sample, candidates[j].sample)) rivals.members.push_back(j);
      }
    rivals.starts.push_back(static_cast<std::uint32_t>(rivals.members.size()));
  }
  return rivals;
}

// The state of a candidate after a round, from the states before it.
State decide(std::span<const Candidate> candidates, const Rivals& rivals, std::span<const State> states,
             std::uint32_t i) {
  State state = State::kAccepted;
  for (const std::uint32_t j : rivals.of(i)) {
    if (states[j] == State::kAccepted) return State::kRejected;
    if (states[j] == State::kUndecided && candidates[j].priority > candidates[i].priority) state = State::kUndecided;
  }
  return state;
}

std::vector<State> decide_all(std::span<const Candidate> candidates, const Rivals& rivals) {
  std::vector<State> states(candidates.size(), State::kUndecided), next;
  std::vector<std::uint32_t> undecided(candidates.size());
  for (std::uint32_t i = 0; i < undecided.size(); ++i) undecided[i] = i;
  for (int round = 0; round < kRounds; ++round) {
    next.clear();
    for (const std::uint32_t i : undecided) next.push_back(decide(candidates, rivals, states, i));
    std::vector<std::uint32_t> left;
    for (std::size_t k = 0; k < undecided.size(); ++k) {
      states[undecided[k]] = next[k];
      if (next[k] == State::kUndecided) left.push_back(undecided[k]);
    }
    undecided = std::move(left);
  }
  return states;
}

}  // namespace

SampleDensity density_for(double trees_per_ha) {
  constexpr double kHectare_m2 = 10000;
  const double wanted = std::clamp(trees_per_ha, kLeastTreesPerHa, kMostTreesPerHa);
  const double spacing_m = std::sqrt((kBlueNoiseSamples + kMoreSamples * wanted) * kHectare_m2 / wanted);
  if (spacing_m <= kWidest_m) return {spacing_m};
  return {kWidest_m, (kWidest_m / spacing_m) * (kWidest_m / spacing_m)};
}

std::vector<Sample> blue_noise(std::uint64_t seed, const Box2& box, const LeastSpacing& least_spacing,
                               const DensityAt& density_at) {
  assert(!box.is_empty());
  const Box2 influence = box.widened(kSampleInfluence_m);
  const std::vector<Candidate> candidates = candidates_in(seed, influence, least_spacing, density_at);
  const std::vector<State> states = decide_all(candidates, rivals_of(candidates, influence));
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& c = candidates[i];
    const bool is_here = box.contains_half_open(c.sample.at);
    if (is_here && states[i] == State::kAccepted && c.share_draw < c.sample.density.share) samples.push_back(c.sample);
  }
  return samples;
}

}  // namespace citykiln::plants
