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

// The end of a piece of a bulge; pieces are shorter near its node, where the line turns most.
double end_of_piece(int k, int pieces, int reach) {
  const double t = static_cast<double>(k) / pieces;
  return t * (1 + t) / 2 * reach / kWholeReach;
}

// The shares of the points of a chord between its ends, ascending.
class ChordShares {
 public:
  explicit ChordShares(const CurvedChord& chord)
      : chord_(chord), is_common_(chord.leave_reach + chord.arrive_reach > kWholeReach) {
    if (chord.pieces <= 1) return;
    // the end of a bulge may be that of the other, or of the chord
    const bool is_shared = chord.leave_reach + chord.arrive_reach == kWholeReach;
    if (is_common_)
      size_ = chord.pieces - 1;
    else
      left_ = chord.leave_reach == 0 ? 0 : chord.pieces - (chord.leave_reach == kWholeReach ? 1 : 0),
      size_ = left_ + (chord.arrive_reach == 0 ? 0 : chord.pieces - (is_shared ? 1 : 0));
  }

  int size() const { return size_; }
  double at(int k) const {
    if (is_common_) return static_cast<double>(k + 1) / chord_.pieces;
    if (k < left_) return end_of_piece(k + 1, chord_.pieces, chord_.leave_reach);
    return 1 - end_of_piece(size_ - k, chord_.pieces, chord_.arrive_reach);
  }

 private:
  CurvedChord chord_;
  bool is_common_;
  int left_ = 0, size_ = 0;
};

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
  const auto reach = static_cast<int>(std::min(std::floor(reach_m / length_m * kWholeReach), double{kWholeReach}));
  // few values take few bytes
  return static_cast<std::uint8_t>(reach < 4 ? reach : reach / 4 * 4);
}

// The chord whose bulges overlap with the largest common reach that keeps the limits; else each has its half.
CurvedChord with_common_reach(CurvedChord chord, double length_m, const CurveLimits& limits) {
  for (const std::uint8_t reach : kCommonReaches) {
    CurvedChord common = chord;
    common.leave_reach = common.arrive_reach = reach;
    if (reach * length_m <= limits.reach_m * kWholeReach && farthest(common) * length_m <= limits.most_m) return common;
  }
  constexpr std::uint8_t kHalf = kWholeReach / 2;
  chord.leave_reach = std::min(chord.leave_reach, kHalf), chord.arrive_reach = std::min(chord.arrive_reach, kHalf);
  return chord;
}

// True if the straight pieces keep the limits.
bool is_fine(const CurvedChord& chord, double length_m, const CurveLimits& limits) {
  double last = 0, slope = chord.leave * kSlopeUnit, allowed = limits.turn / 2;
  const auto is_fine_to = [&](double t) {
    const double from = offset_at(chord, last), to = offset_at(chord, t), next = (to - from) / (t - last);
    const double apart = std::abs(offset_at(chord, (last + t) / 2) - (from + to) / 2);
    if (apart * length_m > limits.error_m || std::abs(next - slope) > allowed) return false;
    last = t, slope = next, allowed = limits.turn;
    return true;
  };
  const ChordShares shares(chord);
  for (int k = 0; k < shares.size(); ++k)
    if (!is_fine_to(shares.at(k))) return false;
  return is_fine_to(1) && std::abs(chord.arrive * kSlopeUnit - slope) <= limits.turn / 2;
}

double shortest_piece(const CurvedChord& chord) {
  double shortest = 1, last = 0;
  const ChordShares shares(chord);
  for (int k = 0; k < shares.size(); ++k) shortest = std::min(shortest, shares.at(k) - last), last = shares.at(k);
  return std::min(shortest, 1 - last);
}

// A line in the frame of its chord, whose length is 1. Nothing is computed before it is asked for: most lines differ
// from a curve in their first point.
class InFrame {
 public:
  explicit InFrame(std::span<const Vec2> line)
      : line_(line),
        along_(line.back() - line.front()),
        squared_(dot(along_, along_)),
        rounding_(kCurveStep_m / std::sqrt(squared_)) {}

  // The number of points between the ends.
  std::size_t size() const { return line_.size() - 2; }
  double t(std::size_t i) const { return dot(line_[i + 1] - line_.front(), along_) / squared_; }
  double offset(std::size_t i) const { return cross(along_, line_[i + 1] - line_.front()) / squared_; }
  // The largest error of either.
  double rounding() const { return rounding_; }

 private:
  std::span<const Vec2> line_;
  Vec2 along_;
  double squared_, rounding_;
};

bool is_line(const CurvedChord& chord, std::span<const Vec2> line) {
  const Polyline between = points_between(chord, line.front(), line.back());
  return std::ranges::equal(between, line.subspan(1, line.size() - 2));
}

// The chord with the frame's shares, and slopes near these, that is the line.
std::optional<CurvedChord> with_slopes(CurvedChord chord, double leave, double arrive, std::span<const Vec2> line) {
  constexpr int kAround[] = {0, -1, 1, -2, 2};
  if (std::abs(leave) > 60 || std::abs(arrive) > 60) return std::nullopt;
  for (const int i : kAround)
    for (const int j : kAround) {
      chord.leave = static_cast<std::int8_t>(chord.leave_reach == 0 ? 0 : std::lround(leave) + i);
      chord.arrive = static_cast<std::int8_t>(chord.arrive_reach == 0 ? 0 : std::lround(arrive) + j);
      const bool is_whole =
          (chord.leave != 0) == (chord.leave_reach > 0) && (chord.arrive != 0) == (chord.arrive_reach > 0);
      if (is_whole && is_line(chord, line)) return chord;
      if (chord.arrive_reach == 0) break;
    }
  return std::nullopt;
}

bool has_shares(const CurvedChord& chord, const InFrame& frame) {
  const ChordShares shares(chord);
  if (static_cast<std::size_t>(shares.size()) != frame.size()) return false;
  for (int k = 0; k < shares.size(); ++k)
    if (std::abs(shares.at(k) - frame.t(static_cast<std::size_t>(k))) > frame.rounding()) return false;
  return true;
}

double height_of(int reach, double t) { return bulge(1, reach, t); }

// Bulges that overlap, with points at equal shares.
std::optional<CurvedChord> overlapping_through(const InFrame& frame, std::span<const Vec2> line) {
  CurvedChord chord{.leave = 1, .arrive = 1, .leave_reach = 64, .arrive_reach = 64};
  chord.pieces = static_cast<std::uint8_t>(frame.size() + 1);
  if (chord.pieces > kMostPieces || !has_shares(chord, frame)) return std::nullopt;
  const double first = 1.0 / chord.pieces;
  for (const std::uint8_t reach : kCommonReaches) {
    chord.leave_reach = chord.arrive_reach = reach;
    const double near = height_of(reach, first), far = height_of(reach, 1 - first);
    const double from = frame.offset(0), to = frame.offset(frame.size() - 1), area = near * near - far * far;
    // one point has the same height from both ends: any two slopes of its sum
    const double sum = from / near, leave = area == 0 ? std::ceil(sum / 2) : (from * near - to * far) / area;
    const double arrive = area == 0 ? leave - sum : (from * far - to * near) / area;
    if (const std::optional<CurvedChord> found = with_slopes(chord, leave, arrive, line)) return found;
  }
  return std::nullopt;
}

std::uint8_t reach_to(double t) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(t * kWholeReach + 0.5), 0.0, double{kWholeReach}));
}

// Bulges that do not overlap: one of `before` points, and one of `after` points.
std::optional<CurvedChord> apart_through(const InFrame& frame, std::size_t before, std::size_t after, bool is_shared,
                                         std::span<const Vec2> line) {
  const std::size_t n = frame.size();
  CurvedChord chord{.leave = before > 0, .arrive = after > 0};
  chord.pieces = static_cast<std::uint8_t>(std::max(before, after));
  if (chord.pieces < 2 || chord.pieces > kMostPieces) return std::nullopt;
  if (before > 0) chord.leave_reach = before > n ? kWholeReach : reach_to(frame.t(before - 1));
  if (after > 0) chord.arrive_reach = after > n ? kWholeReach : reach_to(1 - frame.t(n - after));
  if (is_shared) chord.arrive_reach = static_cast<std::uint8_t>(kWholeReach - chord.leave_reach);
  if (chord.leave_reach + chord.arrive_reach > kWholeReach || !has_shares(chord, frame)) return std::nullopt;
  const double leave = before > 0 ? frame.offset(0) / height_of(chord.leave_reach, frame.t(0)) : 0;
  const double arrive = after > 0 ? -frame.offset(n - 1) / height_of(chord.arrive_reach, 1 - frame.t(n - 1)) : 0;
  return with_slopes(chord, leave, arrive, line);
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
  const ChordShares shares(chord);
  for (int k = 0; k < shares.size(); ++k) {
    const double t = shares.at(k);
    const Vec2 p = snapped_to(kCurveStep_m, a + along * t + left * offset_at(chord, t));
    if (p != a && p != b && (points.empty() || points.back() != p)) points.push_back(p);
  }
  return points;
}

std::optional<CurvedChord> chord_through(std::span<const Vec2> line) {
  assert(line.size() >= 3);
  if (line.front() == line.back()) return std::nullopt;
  const InFrame frame(line);
  const std::size_t n = frame.size();
  if (const std::optional<CurvedChord> found = overlapping_through(frame, line)) return found;
  // one bulge that ends before the chord, or with it; then two, apart or with a common end
  if (const std::optional<CurvedChord> found = apart_through(frame, n, 0, false, line)) return found;
  if (const std::optional<CurvedChord> found = apart_through(frame, 0, n, false, line)) return found;
  if (const std::optional<CurvedChord> found = apart_through(frame, n + 1, 0, false, line)) return found;
  if (const std::optional<CurvedChord> found = apart_through(frame, 0, n + 1, false, line)) return found;
  if (n % 2 == 0) return apart_through(frame, n / 2, n / 2, false, line);
  return apart_through(frame, n / 2 + 1, n / 2 + 1, true, line);
}

CurvedChord fitted_chord(double length_m, int leave, int arrive, const CurveLimits& limits) {
  assert(length_m > 0 && std::abs(leave) <= 64 && std::abs(arrive) <= 64);
  CurvedChord chord{.leave = static_cast<std::int8_t>(leave),
                    .arrive = static_cast<std::int8_t>(arrive),
                    .leave_reach = reach_of(leave, length_m, limits),
                    .arrive_reach = reach_of(arrive, length_m, limits),
                    .pieces = 1};
  if (chord.leave_reach == 0) chord.leave = 0;
  if (chord.arrive_reach == 0) chord.arrive = 0;
  if (chord.leave_reach + chord.arrive_reach > kWholeReach) chord = with_common_reach(chord, length_m, limits);
  while (chord.pieces < kMostPieces && !is_fine(chord, length_m, limits)) {
    CurvedChord finer = chord;
    ++finer.pieces;
    if (shortest_piece(finer) * length_m < limits.shortest_m) break;
    chord = finer;
  }
  return chord;
}

}  // namespace citykiln
