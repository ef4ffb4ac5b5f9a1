// Reads and writes lines with curves: each curve is stored as a CurvedChord and its end, and the
// points between are computed from these.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/curved_chord.h"
#include "exporters/kiln/member_codecs.h"

namespace citykiln::exporters {

/// A part of a line, which ends at its point `last`: a curve, or one straight segment.
struct CodedPart {
  std::size_t last = 0;
  std::optional<CurvedChord> curve{};
};

/// Returns the parts of a line with at least one point. The first part is its first point. Each
/// next one is the longest curve that begins where the part before ends, found by chord_through(),
/// else a segment. O(points).
inline std::vector<CodedPart> parts_of(std::span<const Vec2> line) {
  constexpr std::size_t kMostBetween = 2 * kMostPieces;
  std::vector<CodedPart> parts = {{0}};
  while (parts.back().last + 1 < line.size()) {
    const std::size_t from = parts.back().last;
    CodedPart next{from + 1};
    for (std::size_t n = std::min(kMostBetween + 2, line.size() - from); n > 2 && !next.curve; --n)
      if (const std::optional<CurvedChord> chord = chord_through(line.subspan(from, n))) next = {from + n - 1, chord};
    parts.push_back(next);
  }
  return parts;
}

// Reads one part, and adds its points to the line. A curve begins at the line's last point.
void read_part(auto& io, Stream kind, std::vector<Vec2>& line) {
  std::uint64_t code = io.whole("points");
  const bool is_curve = code == kCurve;
  if (is_curve && line.empty()) return io.fail(kind);
  CurvedChord chord;
  if (is_curve) chord = io.curve(), code = io.whole("points");
  Vec2 end;
  io.point_of(code, end);
  if (is_curve && io.wrong.empty())
    for (const Vec2 p : points_between(chord, line.back(), end)) line.push_back(p);
  line.push_back(end);
}

/// Writes or reads the points of a line that may have curves. A Reader fails on fewer parts than
/// `least`, and on a line that begins with a curve. An `io` that has no curves gets all points by
/// points().
/// @param kind   The stream with the number of parts.
/// @param line   At least one point if it is written.
/// @param least  The smallest number of parts that a Reader accepts.
template <typename Io>
void curved_points(Io& io, Stream kind, std::vector<Vec2>& line, std::size_t least) {
  if constexpr (Io::kReads) {
    const std::size_t size = io.count(kind, 0);
    if (size < least) return io.fail(kind);
    for (std::size_t i = 0; i < size && io.wrong.empty(); ++i) read_part(io, kind, line);
  } else if constexpr (requires(const CurvedChord& chord) { io.curve(chord); }) {
    const std::vector<CodedPart> parts = parts_of(line);
    io.count(kind, parts.size());
    for (const CodedPart& part : parts) {
      if (part.curve) io.curve(*part.curve);
      io.point(line[part.last]);
    }
  } else {
    points(io, kind, line, least);
  }
}

}  // namespace citykiln::exporters
