#include "compiler/geometry/curved_chord.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "compiler/geometry/snap.h"

namespace citykiln {
namespace {

double bulge(int slope, int reach, double t) {
  const double share = static_cast<double>(reach) / kWholeReach;
  if (reach == 0 || t >= share) return 0;
  const double rest = 1 - t / share;
  return slope * kSlopeUnit * t * rest * rest;
}

// Ends of the pieces of a bulge, which are shorter near its node, where the line turns most.
void append_bulge(int reach, int pieces, std::vector<double>& shares) {
  for (int k = 1; k <= pieces; ++k) {
    const double t = static_cast<double>(k) / pieces;
    shares.push_back(t * (1 + t) / 2 * reach / kWholeReach);
  }
}

// The shares of the points between the ends, ascending.
std::vector<double> shares_of(const CurvedChord& chord) {
  std::vector<double> shares;
  if (chord.pieces <= 1) return shares;
  if (chord.leave_reach + chord.arrive_reach > kWholeReach) {
    for (int k = 1; k < chord.pieces; ++k) shares.push_back(static_cast<double>(k) / chord.pieces);
    return shares;
  }
  std::vector<double> from_end;
  if (chord.leave_reach > 0) append_bulge(chord.leave_reach, chord.pieces, shares);
  if (chord.arrive_reach > 0) append_bulge(chord.arrive_reach, chord.pieces, from_end);
  for (auto t = from_end.rbegin(); t != from_end.rend(); ++t) shares.push_back(1 - *t);
  std::erase_if(shares, [](double t) { return t <= 0 || t >= 1; });
  return shares;
}

double farthest(const CurvedChord& chord) {
  constexpr int kSamples = 32;
  double most = 0;
  for (int k = 1; k < kSamples; ++k) most = std::max(most, std::abs(offset_at(chord, k / double{kSamples})));
  return most;
}

std::uint8_t reach_of(int slope, double length_m, const CurveLimits& limits) {
  if (slope == 0) return 0;
  // a bulge is 4/27 of slope times reach high
  const double reach_m = std::min(limits.reach_m, 27.0 / 4 * limits.most_m / (std::abs(slope) * kSlopeUnit));
  return static_cast<std::uint8_t>(std::clamp(std::floor(reach_m / length_m * kWholeReach), 1.0, double{kWholeReach}));
}

// True if the straight pieces keep the limits.
bool is_fine(const CurvedChord& chord, double length_m, const CurveLimits& limits) {
  std::vector<double> shares = shares_of(chord);
  shares.push_back(1);
  double last = 0, slope = chord.leave * kSlopeUnit, allowed = limits.turn / 2;
  for (const double t : shares) {
    if (t == last) continue;
    const double from = offset_at(chord, last), to = offset_at(chord, t), next = (to - from) / (t - last);
    const double apart = std::abs(offset_at(chord, (last + t) / 2) - (from + to) / 2);
    if (apart * length_m > limits.error_m || std::abs(next - slope) > allowed) return false;
    last = t, slope = next, allowed = limits.turn;
  }
  return std::abs(chord.arrive * kSlopeUnit - slope) <= limits.turn / 2;
}

double shortest_piece(const CurvedChord& chord) {
  double shortest = 1, last = 0;
  std::vector<double> shares = shares_of(chord);
  shares.push_back(1);
  for (const double t : shares) {
    if (t != last) shortest = std::min(shortest, t - last);
    last = t;
  }
  return shortest;
}

}  // namespace

double offset_at(const CurvedChord& chord, double t) {
  return bulge(chord.leave, chord.leave_reach, t) - bulge(chord.arrive, chord.arrive_reach, 1 - t);
}

CurvedChord reversed(const CurvedChord& chord) {
  return {.leave = chord.arrive,
          .arrive = chord.leave,
          .leave_reach = chord.arrive_reach,
          .arrive_reach = chord.leave_reach,
          .pieces = chord.pieces};
}

Polyline points_between(const CurvedChord& chord, Vec2 a, Vec2 b) {
  if (b < a) {
    // both directions compute the same, so that they round alike
    Polyline points = points_between(reversed(chord), b, a);
    std::ranges::reverse(points);
    return points;
  }
  Polyline points;
  const Vec2 along = b - a, left = left_of(along);
  for (const double t : shares_of(chord)) {
    const Vec2 p = snapped_to(kCurveStep_m, a + along * t + left * offset_at(chord, t));
    if (p != a && p != b && (points.empty() || points.back() != p)) points.push_back(p);
  }
  return points;
}

CurvedChord fitted_chord(double length_m, int leave, int arrive, const CurveLimits& limits) {
  assert(length_m > 0 && std::abs(leave) <= 64 && std::abs(arrive) <= 64);
  CurvedChord chord{.leave = static_cast<std::int8_t>(leave),
                    .arrive = static_cast<std::int8_t>(arrive),
                    .leave_reach = reach_of(leave, length_m, limits),
                    .arrive_reach = reach_of(arrive, length_m, limits),
                    .pieces = 1};
  const auto shorter = [](std::uint8_t reach) { return static_cast<std::uint8_t>(reach > 1 ? reach * 7 / 8 : reach); };
  while (farthest(chord) * length_m > limits.most_m && (chord.leave_reach > 1 || chord.arrive_reach > 1))
    chord.leave_reach = shorter(chord.leave_reach), chord.arrive_reach = shorter(chord.arrive_reach);
  constexpr std::uint8_t kMostPieces = 8;
  while (chord.pieces < kMostPieces && !is_fine(chord, length_m, limits)) {
    CurvedChord finer = chord;
    ++finer.pieces;
    if (shortest_piece(finer) * length_m < limits.shortest_m) break;
    chord = finer;
  }
  return chord;
}

}  // namespace citykiln
