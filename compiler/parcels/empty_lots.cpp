#include "compiler/parcels/empty_lots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/parcels/lot_borders.h"

namespace citykiln::parcels {
namespace {

// Parts of lots have at least this share of the usual front.
constexpr double kLeastShare = 0.4;
// Lots within this factor of the usual area are not split.
constexpr double kNearUsual = 1.25;

// Appends the distances along a → b at which a coordinate passes a multiple of kSection_m.
void add_crossings(double a, double b, double length_m, std::vector<double>& places) {
  const auto [low, high] = std::minmax(a, b);
  for (double at = std::ceil(low / kSection_m) * kSection_m; at < high; at += kSection_m)
    if (at > low) places.push_back(length_m * (at - a) / (b - a));
}

// Cuts free spans where a frontage leaves a cell, except near a corner or a building's land.
void cut_spans(const Strips& strips, std::uint32_t f, double front_m, std::vector<Span>& spans) {
  const Frontage& frontage = strips.frontages[f];
  const double length = frontage.length_m();
  std::vector<double> places;
  add_crossings(frontage.a.x, frontage.b.x, length, places);
  add_crossings(frontage.a.y, frontage.b.y, length, places);
  std::ranges::sort(places);
  const bool goes_on = frontage.next != kNone && !frontage.is_corner;
  const bool comes_from = frontage.previous != kNone && !strips.frontages[frontage.previous].is_corner;
  std::vector<Span> cut;
  for (Span span : spans) {
    const double first = span.from_m > 0 || !comes_from ? span.from_m + front_m : 0;
    const double last = span.to_m < length || !goes_on ? span.to_m - front_m : length;
    for (const double at : places) {
      if (span.label != kRest || at <= std::max(first, span.from_m) || at >= last) continue;
      Span part = span;
      part.to_m = span.from_m = at;
      cut.push_back(part);
    }
    cut.push_back(span);
  }
  spans = std::move(cut);
}

// A part of a lot while it is split: its outline, which may touch itself, and its fronts.
struct Part {
  Ring ring;
  std::vector<FrontEdge> fronts;

  double front_m() const {
    double sum = 0;
    for (const FrontEdge& edge : fronts) sum += distance(edge.first, edge.second);
    return sum;
  }
};

// The part to the left of a line, by Sutherland and Hodgman 1974.
Part left_part(const Part& part, Vec2 at, Vec2 along) {
  Part left;
  const auto side = [&](Vec2 p) { return cross(along, p - at); };
  const auto meet = [&](Vec2 p, Vec2 q) { return p + (q - p) * (side(p) / (side(p) - side(q))); };
  for (std::size_t i = 0, n = part.ring.size(); i < n; ++i) {
    const Vec2 p = part.ring[i], q = part.ring[(i + 1) % n];
    if (side(p) >= 0) left.ring.push_back(p);
    if ((side(p) >= 0) != (side(q) >= 0)) left.ring.push_back(meet(p, q));
  }
  for (const auto& [p, q] : part.fronts) {
    if (side(p) < 0 && side(q) < 0) continue;
    const Vec2 from = side(p) < 0 ? meet(p, q) : p, to = side(q) < 0 ? meet(p, q) : q;
    left.fronts.emplace_back(from, to);
  }
  return left;
}

// The smallest rectangle about a ring with a side along one of its edges.
struct TightBox {
  Vec2 centre, along;  // along: the longer axis
  double long_m = 0, short_m = 0;
};

TightBox tight_box(const Ring& ring) {
  TightBox best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 u = unit(ring[(i + 1) % ring.size()] - ring[i]), v = left_of(u);
    if (u == Vec2{}) continue;
    Box2 box;
    for (const Vec2 p : ring) box.grow({dot(p, u), dot(p, v)});
    if (box.width() * box.height() >= least * (1 - 1e-9)) continue;
    least = box.width() * box.height();
    const Vec2 c = box.centre();
    best = {u * c.x + v * c.y, box.width() >= box.height() ? u : v, std::max(box.width(), box.height()),
            std::min(box.width(), box.height())};
  }
  return best;
}

class Splitter {
 public:
  Splitter(const LotSize& size, SplitTree& tree) : size_(size), tree_(tree) {}

  std::uint32_t split(const Part& part, int depth) {
    if (depth == 0 || part.ring.size() < 3 || signed_area_m2(part.ring) <= size_.area_m2 * kNearUsual) return kNone;
    const TightBox box = tight_box(part.ring);
    for (const Vec2 axis : {box.along, left_of(box.along)}) {
      const Vec2 along = left_of(axis);
      const Part left = left_part(part, box.centre, along), right = left_part(part, box.centre, along * -1);
      if (std::min(left.front_m(), right.front_m()) < size_.front_m * kLeastShare) continue;
      const auto node = static_cast<std::uint32_t>(tree_.nodes.size());
      tree_.nodes.push_back({box.centre, along});
      add_cuts(part.ring, box.centre, along);
      const std::uint32_t l = split(left, depth - 1), r = split(right, depth - 1);
      tree_.nodes[node].left = l, tree_.nodes[node].right = r;
      return node;
    }
    return kNone;
  }

 private:
  // The parts of the line inside the ring.
  void add_cuts(const Ring& ring, Vec2 at, Vec2 along) {
    std::vector<double> places;
    for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
      const Vec2 p = ring[i], q = ring[(i + 1) % n];
      const double s = cross(along, p - at), t = cross(along, q - at);
      if ((s >= 0) != (t >= 0)) places.push_back(dot(p + (q - p) * (s / (s - t)) - at, along));
    }
    std::ranges::sort(places);
    for (std::size_t i = 0; i + 1 < places.size(); i += 2)
      tree_.cuts.emplace_back(at + along * (places[i] - kOverlap_m), at + along * (places[i + 1] + kOverlap_m));
  }

  const LotSize& size_;
  SplitTree& tree_;
};

}  // namespace

std::vector<LotSize> label_sections(const Strips& strips, const std::vector<LotSize>& sizes, std::uint32_t first_label,
                                    Fronts& fronts) {
  const auto size_at = [&](std::uint32_t f) {
    return sizes[std::min<std::size_t>(strips.frontages[f].size, sizes.size() - 1)];
  };
  for (std::uint32_t f = 0; f < fronts.size(); ++f) cut_spans(strips, f, size_at(f).front_m, fronts[f]);
  std::vector<LotSize> of_labels;
  const auto may_join = [&](std::uint32_t f, std::uint32_t next) {
    return next != kNone && !strips.frontages[f].is_corner;
  };
  // labels run on along the street: begin where a section begins, then at what is left, which are loops
  for (const bool is_loop : {false, true})
    for (std::uint32_t f = 0; f < fronts.size(); ++f)
      for (std::size_t i = 0; i < fronts[f].size(); ++i) {
        if (fronts[f][i].label != kRest) continue;
        const std::uint32_t before = strips.frontages[f].previous;
        if (!is_loop && i == 0 && before != kNone && may_join(before, f) &&
            (fronts[before].empty() || fronts[before].back().label == kRest))
          continue;
        const auto label = static_cast<std::uint32_t>(first_label + of_labels.size());
        of_labels.push_back(size_at(f));
        std::uint32_t at = f;
        for (std::size_t k = i;;) {
          if (!fronts[at].empty()) {
            if (fronts[at][k].label != kRest) break;
            fronts[at][k].label = label;
            if (k + 1 < fronts[at].size()) break;
          }
          const std::uint32_t next = strips.frontages[at].next;
          if (!may_join(at, next) || next == f) break;
          at = next, k = 0;
        }
      }
  return of_labels;
}

SplitTree split(const Ring& lot, const std::vector<FrontEdge>& fronts, const LotSize& size) {
  SplitTree tree;
  // 2^12 parts: more than a section can have
  Splitter(size, tree).split({lot, fronts}, 12);
  return tree;
}

std::uint32_t leaf_at(const SplitTree& tree, Vec2 p) {
  if (tree.nodes.empty()) return 0;
  for (std::uint32_t i = 0;;) {
    const SplitTree::Node& node = tree.nodes[i];
    const bool is_left = cross(node.along, p - node.at) >= 0;
    const std::uint32_t next = is_left ? node.left : node.right;
    if (next == kNone) return 2 * i + (is_left ? 0 : 1);
    i = next;
  }
}

}  // namespace citykiln::parcels
