#include "compiler/parcels/empty_lots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/geometry/arrangement.h"
#include "compiler/parcels/lot_borders.h"

namespace citykiln::parcels {
namespace {

// Distance of places where a section may end.
constexpr double kCandidate_m = 8;
// Parts of lots have at least this share of the usual front.
constexpr double kLeastShare = 0.4;
// Lots within this factor of the usual area are not split.
constexpr double kNearUsual = 1.25;

std::uint64_t number_at(const Strips& strips, const std::vector<Line>& lines, std::uint32_t frontage, int place) {
  const Frontage& f = strips.frontages[frontage];
  const GridPoint a = grid_point(f.a), b = grid_point(f.b);
  StableId id =
      stable_id(lines[f.line].id, "section", static_cast<std::uint64_t>(a.x) ^ static_cast<std::uint64_t>(a.y) << 32);
  id = stable_id(id, "end", static_cast<std::uint64_t>(b.x) ^ static_cast<std::uint64_t>(b.y) << 32);
  return static_cast<std::uint64_t>(stable_id(id, "place", static_cast<std::uint64_t>(place)));
}

// Finds the places where sections end.
class Sections {
 public:
  Sections(const Strips& strips, const std::vector<Line>& lines) : strips_(strips) {
    for (std::uint32_t f = 0; f < strips.frontages.size(); ++f) {
      const double length = strips.frontages[f].length_m();
      const int count = length > 0 ? static_cast<int>(std::ceil(length / kCandidate_m)) : 0;
      std::vector<std::uint64_t>& of_frontage = numbers_.emplace_back();
      for (int i = 0; i < count; ++i) of_frontage.push_back(number_at(strips, lines, f, i));
    }
  }

  double place(std::uint32_t f, std::size_t i) const {
    return strips_.frontages[f].length_m() * static_cast<double>(i) / static_cast<double>(numbers_[f].size());
  }
  std::size_t count(std::uint32_t f) const { return numbers_[f].size(); }

  // True if a section ends at a place; the first place of a frontage is its first point.
  bool is_end(std::uint32_t f, std::size_t i) const {
    const std::uint64_t own = numbers_[f][i];
    return !is_less_ahead(f, i, own) && !is_less_behind(f, i, own);
  }

 private:
  bool is_less_ahead(std::uint32_t f, std::size_t i, std::uint64_t own) const {
    double from = place(f, i), walked = 0;
    const std::uint32_t first = f;
    for (std::size_t k = i + 1;; k = 0) {
      for (; k < count(f); ++k) {
        if (walked + place(f, k) - from > kSection_m) return false;
        if (numbers_[f][k] < own) return true;
      }
      walked += strips_.frontages[f].length_m() - from, from = 0;
      if (strips_.frontages[f].is_corner || walked > kSection_m) return false;
      f = strips_.frontages[f].next;
      if (f == kNone || f == first) return false;
    }
  }
  bool is_less_behind(std::uint32_t f, std::size_t i, std::uint64_t own) const {
    double walked = 0, to = place(f, i);
    const std::uint32_t first = f;
    for (std::size_t k = i;; k = count(f)) {
      for (; k-- > 0;) {
        if (walked + to - place(f, k) > kSection_m) return false;
        if (numbers_[f][k] < own) return true;
      }
      walked += to;
      const std::uint32_t before = strips_.frontages[f].previous;
      if (before == kNone || before == first || strips_.frontages[before].is_corner || walked > kSection_m)
        return false;
      f = before, to = strips_.frontages[f].length_m();
    }
  }

  const Strips& strips_;
  std::vector<std::vector<std::uint64_t>> numbers_;
};

// Cuts free spans at the ends of sections inside a frontage.
void cut_spans(const Sections& sections, std::uint32_t f, std::vector<Span>& spans) {
  std::vector<Span> cut;
  for (Span span : spans) {
    for (std::size_t i = 1; span.label == kRest && i < sections.count(f); ++i) {
      const double at = sections.place(f, i);
      if (at <= span.from_m || at >= span.to_m || !sections.is_end(f, i)) continue;
      Span first = span;
      first.to_m = span.from_m = at;
      cut.push_back(first);
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

std::vector<LotSize> label_sections(const Strips& strips, const std::vector<Line>& lines,
                                    const std::vector<LotSize>& sizes, std::uint32_t first_label, Fronts& fronts) {
  const Sections sections(strips, lines);
  for (std::uint32_t f = 0; f < fronts.size(); ++f) cut_spans(sections, f, fronts[f]);
  std::vector<LotSize> of_labels;
  const auto may_join = [&](std::uint32_t f, std::uint32_t next) {
    return next != kNone && !strips.frontages[f].is_corner && !(sections.count(next) > 0 && sections.is_end(next, 0));
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
        const auto size = std::min<std::size_t>(strips.frontages[f].size, sizes.size() - 1);
        of_labels.push_back(sizes[size]);
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
