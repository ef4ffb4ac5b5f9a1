// The tags of an element as pairs of texts, for outputs.
#pragma once

#include <compare>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace citykiln::map {

/// A tag whose texts are those of a list.
struct TagView {
  std::string_view key, value;
  bool operator==(const TagView&) const = default;
};

/// All tags of an element, in one block of memory: a country has millions of them.
class TagList {
 public:
  TagList() = default;
  TagList(std::initializer_list<TagView> tags) {
    for (const TagView& tag : tags) add(tag.key, tag.value);
  }

  /// Appends a tag. Its texts have no zero bytes.
  void add(std::string_view key, std::string_view value);

  bool empty() const { return texts_.empty(); }
  /// Returns the tags in the order in which they were added. They are valid until the list changes.
  std::vector<TagView> views() const;

  bool operator==(const TagList&) const = default;
  std::strong_ordering operator<=>(const TagList&) const = default;

 private:
  std::string texts_;  ///< Keys and values in turn, each with a zero byte behind it.
};

}  // namespace citykiln::map
