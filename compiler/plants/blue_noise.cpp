#include "compiler/plants/blue_noise.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/draw.h"
#include "compiler/geometry/snap.h"

namespace citykiln::plants {
namespace {

// Lattice cells in spacings: so that two in three rounds' candidates are there to choose from, and few cells to ask.
constexpr double kLatticeShare = 0.62;
constexpr int kMostRounds = 12;

enum class State : std::uint8_t { kNone, kUndecided, kAccepted, kRejected };

struct Candidate {
  Site site;
  std::uint64_t priority = 0;
  State state = State::kNone;
};

// The candidates of the lattice cells that the box touches.
struct Lattice {
  double cell_m;
  std::int64_t first_column, first_row;
  int columns, rows;
  std::vector<Candidate> candidates;

  Candidate& at(int c, int r) { return candidates[static_cast<std::size_t>(r) * columns + c]; }
  const Candidate& at(int c, int r) const { return candidates[static_cast<std::size_t>(r) * columns + c]; }
};

Candidate candidate_of(std::uint64_t seed, StableId owner, std::int64_t column, std::int64_t row, double cell_m) {
  const auto number = static_cast<std::uint64_t>(column) << 32 ^ (static_cast<std::uint64_t>(row) & 0xffffffffu);
  Candidate candidate;
  candidate.site.id = stable_id(owner, "site", number);
  const Draw draw(seed, candidate.site.id, "site");
  candidate.site.at = snapped(
      Vec2{(static_cast<double>(column) + draw.unit(0)) * cell_m, (static_cast<double>(row) + draw.unit(1)) * cell_m});
  candidate.priority = static_cast<std::uint64_t>(stable_id(candidate.site.id, "priority", seed));
  return candidate;
}

Lattice candidates_in(std::uint64_t seed, StableId owner, double cell_m, const Box2& box, const Allowed& allowed) {
  Lattice lattice{cell_m,
                  static_cast<std::int64_t>(std::floor(box.min.x / cell_m)),
                  static_cast<std::int64_t>(std::floor(box.min.y / cell_m)),
                  0,
                  0,
                  {}};
  lattice.columns =
      static_cast<int>(static_cast<std::int64_t>(std::floor(box.max.x / cell_m)) - lattice.first_column) + 1;
  lattice.rows = static_cast<int>(static_cast<std::int64_t>(std::floor(box.max.y / cell_m)) - lattice.first_row) + 1;
  lattice.candidates.reserve(static_cast<std::size_t>(lattice.columns) * lattice.rows);
  for (int r = 0; r < lattice.rows; ++r)
    for (int c = 0; c < lattice.columns; ++c) {
      Candidate candidate = candidate_of(seed, owner, lattice.first_column + c, lattice.first_row + r, cell_m);
      if (box.contains(candidate.site.at) && allowed(candidate.site.at, candidate.site.height_m))
        candidate.state = State::kUndecided;
      lattice.candidates.push_back(candidate);
    }
  return lattice;
}

bool are_close(const Site& a, const Site& b, double spacing_m) {
  const Vec3 apart = at_height(b.at - a.at, b.height_m - a.height_m);
  return dot(apart, apart) < spacing_m * spacing_m;
}

// Calls visit(candidate) for the others that may be within spacing; stops when it returns false.
template <typename Visit>
void for_each_near(const Lattice& lattice, int c, int r, double spacing_m, Visit visit) {
  const int reach = static_cast<int>(std::ceil(spacing_m / lattice.cell_m));
  for (int y = std::max(0, r - reach); y <= std::min(lattice.rows - 1, r + reach); ++y)
    for (int x = std::max(0, c - reach); x <= std::min(lattice.columns - 1, c + reach); ++x)
      if ((x != c || y != r) && !visit(lattice.at(x, y))) return;
}

// What a candidate becomes in this round, from what all were before it.
State decide(const Lattice& lattice, int c, int r, double spacing_m) {
  const Candidate& self = lattice.at(c, r);
  State state = State::kAccepted;
  for_each_near(lattice, c, r, spacing_m, [&](const Candidate& other) {
    const bool matters =
        other.state == State::kAccepted || (other.state == State::kUndecided && other.priority > self.priority);
    if (!matters || !are_close(self.site, other.site, spacing_m)) return true;
    state = other.state == State::kAccepted ? State::kRejected : State::kUndecided;
    return state != State::kRejected;
  });
  return state;
}

}  // namespace

Sites blue_noise(std::uint64_t seed, StableId owner, double spacing_m, const Box2& box, double reach_m,
                 const Allowed& allowed) {
  Lattice lattice = candidates_in(seed, owner, spacing_m * kLatticeShare, box.widened(reach_m), allowed);
  const int rounds = std::min(kMostRounds, static_cast<int>(reach_m / spacing_m));
  for (int round = 0; round < rounds; ++round) {
    std::vector<State> next(lattice.candidates.size());
    for (int r = 0; r < lattice.rows; ++r)
      for (int c = 0; c < lattice.columns; ++c) {
        const State now = lattice.at(c, r).state;
        next[static_cast<std::size_t>(r) * lattice.columns + c] =
            now == State::kUndecided ? decide(lattice, c, r, spacing_m) : now;
      }
    for (std::size_t i = 0; i < next.size(); ++i) lattice.candidates[i].state = next[i];
  }
  Sites sites;
  for (const Candidate& candidate : lattice.candidates) {
    const Vec2 p = candidate.site.at;
    const bool is_here = p.x >= box.min.x && p.y >= box.min.y && p.x < box.max.x && p.y < box.max.y;
    if (!is_here) continue;
    if (candidate.state == State::kAccepted) sites.accepted.push_back(candidate.site);
    if (candidate.state == State::kUndecided) ++sites.undecided;
  }
  return sites;
}

}  // namespace citykiln::plants
