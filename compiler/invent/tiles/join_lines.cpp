#include "compiler/invent/tiles/join_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace citykiln::invent {
namespace {

// turns by more than a right angle are new lines
constexpr double kLeastCosine = -1e-9;

/// An end of a line: 2 i is its first point, 2 i + 1 its last.
using LineEnd = std::size_t;

/// The direction in which the line leaves its end.
Vec2 leaving(const InventedLine& line, bool is_last) {
  const Polyline& axis = line.axis;
  return is_last ? unit(axis[axis.size() - 2] - axis.back()) : unit(axis[1] - axis.front());
}

class LineJoiner {
 public:
  LineJoiner(const std::vector<InventedLine>& lines, const std::vector<InventedPoint>& points)
      : lines_(lines), partner_(lines.size() * 2, kNone) {
    std::map<Vec2, std::vector<LineEnd>> ends;
    for (const InventedPoint& point : points) ++uses_[point.position];
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const Vec2 p : lines[i].axis) ++uses_[p];
      if (lines[i].axis.front() == lines[i].axis.back()) continue;
      ends[lines[i].axis.front()].push_back(2 * i);
      ends[lines[i].axis.back()].push_back(2 * i + 1);
    }
    for (const auto& [place, there] : ends) pair_up(there);
  }

  std::vector<InventedLine> joined() {
    std::vector<InventedLine> all;
    std::vector<bool> is_done(lines_.size(), false);
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (!is_done[i]) all.push_back(chain_of(i, is_done));
    return all;
  }

 private:
  static constexpr LineEnd kNone = static_cast<LineEnd>(-1);

  void pair_up(const std::vector<LineEnd>& ends) {
    struct Pair {
      double turn;
      LineEnd a, b;
      auto operator<=>(const Pair&) const = default;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const InventedLine &a = lines_[ends[i] / 2], &b = lines_[ends[j] / 2];
        const double cosine = -dot(leaving(a, ends[i] % 2 == 1), leaving(b, ends[j] % 2 == 1));
        if (ends[i] / 2 != ends[j] / 2 && a.tags == b.tags && cosine >= kLeastCosine)
          pairs.push_back({-cosine, ends[i], ends[j]});
      }
    std::ranges::sort(pairs);
    for (const Pair& pair : pairs)
      if (partner_[pair.a] == kNone && partner_[pair.b] == kNone) partner_[pair.a] = pair.b, partner_[pair.b] = pair.a;
  }

  InventedLine chain_of(std::size_t line, std::vector<bool>& is_done) {
    LineEnd start = 2 * line;
    // back to the first line of the chain, or around a loop to where it began
    while (partner_[start] != kNone && partner_[start] / 2 != line) start = partner_[start] ^ 1;
    InventedLine chain{{}, lines_[line].tags};
    std::vector<int> own_uses;
    for (LineEnd at = start; at != kNone && !is_done[at / 2]; at = partner_[at ^ 1]) {
      is_done[at / 2] = true;
      Polyline part = lines_[at / 2].axis;
      if (at % 2 == 1) std::ranges::reverse(part);
      if (!own_uses.empty()) ++own_uses.back();
      chain.axis.insert(chain.axis.end(), part.begin() + (chain.axis.empty() ? 0 : 1), part.end());
      own_uses.resize(chain.axis.size(), 1);
    }
    drop_straight_points(chain.axis, own_uses);
    return chain;
  }

  void drop_straight_points(Polyline& axis, const std::vector<int>& own_uses) const {
    Polyline kept;
    for (std::size_t i = 0; i < axis.size(); ++i) {
      const bool is_inner = i > 0 && i + 1 < axis.size();
      const bool is_shared = uses_.at(axis[i]) > own_uses[i];
      if (is_inner && !is_shared && std::abs(cross(axis[i] - kept.back(), axis[i + 1] - axis[i])) < 1e-6) continue;
      kept.push_back(axis[i]);
    }
    axis = std::move(kept);
  }

  const std::vector<InventedLine>& lines_;
  std::vector<LineEnd> partner_;
  std::map<Vec2, int> uses_;
};

}  // namespace

std::vector<InventedLine> join_lines(const std::vector<InventedLine>& lines, const std::vector<InventedPoint>& points) {
  return LineJoiner(lines, points).joined();
}

}  // namespace citykiln::invent
