#include "compiler/invent/tiles/join_covers.h"

#include <algorithm>

namespace citykiln::invent {
namespace {

/// Directions of edges, counter-clockwise.
enum Heading : std::uint8_t { kEastward, kNorthward, kWestward, kSouthward };
constexpr int kAheadX[4] = {1, 0, -1, 0}, kAheadY[4] = {0, 1, 0, -1};

/// Walks along the borders of labels with the label on the left.
class CoverTracer {
 public:
  CoverTracer(const std::vector<std::uint32_t>& labels, int columns)
      : labels_(labels), columns_(columns), rows_(static_cast<int>(labels.size()) / columns) {
    is_walked_.assign(static_cast<std::size_t>(columns_ + 1) * (rows_ + 1) * 4, false);
  }

  struct LabelledRing {
    std::uint32_t label;
    Ring ring;
  };
  std::vector<LabelledRing> rings() {
    std::vector<LabelledRing> all;
    for (int y = 0; y <= rows_; ++y)
      for (int x = 0; x <= columns_; ++x)
        for (const Heading heading : {kEastward, kWestward})
          if (is_border(x, y, heading) && !is_walked_[index(x, y, heading)])
            all.push_back({left_of_edge(x, y, heading), ring_from(x, y, heading)});
    return all;
  }

 private:
  std::uint32_t label(int x, int y) const {
    return x < 0 || y < 0 || x >= columns_ || y >= rows_ ? 0 : labels_[static_cast<std::size_t>(y) * columns_ + x];
  }
  std::size_t index(int x, int y, int heading) const {
    return (static_cast<std::size_t>(y) * (columns_ + 1) + x) * 4 + heading;
  }
  std::uint32_t left_of_edge(int x, int y, int heading) const {
    constexpr int kX[4] = {0, -1, -1, 0}, kY[4] = {0, 0, -1, -1};
    return label(x + kX[heading], y + kY[heading]);
  }
  std::uint32_t right_of_edge(int x, int y, int heading) const {
    constexpr int kX[4] = {0, 0, -1, -1}, kY[4] = {-1, 0, 0, -1};
    return label(x + kX[heading], y + kY[heading]);
  }
  bool is_border(int x, int y, int heading) const {
    const std::uint32_t own = left_of_edge(x, y, heading);
    return own != 0 && own != right_of_edge(x, y, heading);
  }

  Ring ring_from(int x, int y, int heading) {
    const std::uint32_t own = left_of_edge(x, y, heading);
    Ring ring;
    int last = -1;
    while (!is_walked_[index(x, y, heading)]) {
      is_walked_[index(x, y, heading)] = true;
      if (heading != last) ring.push_back({static_cast<double>(x), static_cast<double>(y)});
      last = heading;
      x += kAheadX[heading], y += kAheadY[heading];
      // left before straight before right: cells that touch at a corner are apart
      for (const int turn : {1, 0, 3}) {
        const int next = (heading + turn) % 4;
        if (left_of_edge(x, y, next) != own || !is_border(x, y, next)) continue;
        heading = next;
        break;
      }
    }
    // the ring begins within a straight edge if it was entered there
    if (ring.size() > 2 && heading == last && cross(ring[1] - ring[0], ring[0] - ring.back()) == 0)
      ring.erase(ring.begin());
    return ring;
  }

  const std::vector<std::uint32_t>& labels_;
  int columns_, rows_;
  std::vector<bool> is_walked_;
};

}  // namespace

std::vector<std::vector<Polygon>> join_covers(const std::vector<std::uint32_t>& labels, int columns,
                                              std::uint32_t count) {
  std::vector<std::vector<Polygon>> covers(count);
  std::vector<CoverTracer::LabelledRing> holes;
  for (CoverTracer::LabelledRing& found : CoverTracer(labels, columns).rings()) {
    if (signed_area_m2(found.ring) > 0)
      covers[found.label].push_back({std::move(found.ring), {}});
    else
      holes.push_back(std::move(found));
  }
  for (CoverTracer::LabelledRing& hole : holes) {
    // a place inside the label's cell beside the hole's first edge
    const Vec2 ahead = unit(hole.ring[1] - hole.ring[0]);
    const Vec2 inside = hole.ring[0] + ahead * 0.5 + left_of(ahead) * 0.5;
    for (Polygon& polygon : covers[hole.label])
      if (box_of(polygon.outer).contains(inside) && winding_number(polygon.outer, inside) != 0) {
        polygon.holes.push_back(std::move(hole.ring));
        break;
      }
  }
  return covers;
}

}  // namespace citykiln::invent
