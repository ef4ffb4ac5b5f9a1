// Rings of points in space.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::grammars {

/// The points of a closed polygon in order, without a repeated first point at the end. Four points are stored inline,
/// because most faces are quadrilaterals. Converts to std::span<const Vec3>, which boost::container::small_vector does
/// not.
class Ring3 {
 public:
  using value_type = Vec3;
  using iterator = Vec3*;
  using const_iterator = const Vec3*;

  Ring3() = default;
  Ring3(std::initializer_list<Vec3> points) { append(points.begin(), points.end()); }
  template <typename Iterator>
  Ring3(Iterator from, Iterator to) {
    append(from, to);
  }

  std::size_t size() const { return many_.empty() ? few_count_ : many_.size(); }
  bool empty() const { return size() == 0; }
  Vec3* data() { return many_.empty() ? few_.data() : many_.data(); }
  const Vec3* data() const { return many_.empty() ? few_.data() : many_.data(); }
  Vec3* begin() { return data(); }
  Vec3* end() { return data() + size(); }
  const Vec3* begin() const { return data(); }
  const Vec3* end() const { return data() + size(); }
  auto rbegin() const { return std::make_reverse_iterator(end()); }
  auto rend() const { return std::make_reverse_iterator(begin()); }
  Vec3& operator[](std::size_t i) { return data()[i]; }
  const Vec3& operator[](std::size_t i) const { return data()[i]; }
  const Vec3& front() const { return *begin(); }
  const Vec3& back() const { return *(end() - 1); }

  void reserve(std::size_t count) {
    if (count > few_.size()) many_.reserve(count);
  }
  void push_back(Vec3 p) {
    if (many_.empty() && few_count_ < few_.size()) {
      few_[few_count_++] = p;
    } else {
      if (many_.empty()) many_.assign(few_.begin(), few_.begin() + few_count_);
      few_count_ = 0;
      many_.push_back(p);
    }
  }
  void pop_back() {
    assert(!empty());
    if (many_.empty()) {
      --few_count_;
    } else {
      many_.pop_back();
    }
  }
  template <typename Iterator>
  void append(Iterator from, Iterator to) {
    for (; from != to; ++from) push_back(*from);
  }

  friend bool operator==(const Ring3& a, const Ring3& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

 private:
  std::array<Vec3, 4> few_;
  std::size_t few_count_ = 0;
  std::vector<Vec3> many_;  ///< All points, if there are more than four.
};

}  // namespace citykiln::grammars
