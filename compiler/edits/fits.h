// Decides whether an element fits a filter. The element is a type with these members, so that elements of OsmData and
// of a file that is being cut are tested by the same code:
//
//     OsmId id() const;
//     bool is_area() const;
//     std::optional<std::string_view> value_of(std::string_view key) const;   nothing if it has no such tag
//     bool any_place(auto is_wanted) const;                                   true if is_wanted(Location) of any node
#pragma once

#include <algorithm>
#include <string_view>

#include "compiler/edits/edit.h"
#include "compiler/edits/offsets.h"

namespace citykiln::edits {

/// True if a text is the pattern, whose "*" at the begin or end stands for any text.
inline bool fits_pattern(std::string_view pattern, std::string_view text) {
  const bool is_open_before = pattern.starts_with('*'), is_open_after = pattern.size() > 1 && pattern.ends_with('*');
  if (is_open_before) pattern.remove_prefix(1);
  if (is_open_after) pattern.remove_suffix(1);
  if (is_open_before && is_open_after) return text.find(pattern) != std::string_view::npos;
  if (is_open_before) return text.ends_with(pattern);
  return is_open_after ? text.starts_with(pattern) : text == pattern;
}

/// True if an element is of one of these types.
template <typename Element>
bool has_type(const Element& element, ElementTypes types) {
  const ElementTypes own = element.id().type == OsmType::kNode  ? kNodes
                           : element.id().type == OsmType::kWay ? kWays
                                                                : kRelations;
  return (types & own) != 0 || ((types & kAreas) != 0 && element.is_area());
}

template <typename Element>
bool fits_tag(const Condition& condition, const Element& element) {
  if (!has_type(element, condition.types)) return false;
  const auto value = element.value_of(condition.key);
  if (!value || condition.values.empty()) return value.has_value();
  const auto is_value = [&](const std::string& pattern) { return fits_pattern(pattern, *value); };
  return std::ranges::any_of(condition.values, is_value) != condition.is_other;
}

inline bool is_in(const source::LonLatBox& box, source::Location at) {
  return at.lon_deg() >= box.west && at.lon_deg() <= box.east && at.lat_deg() >= box.south && at.lat_deg() <= box.north;
}

/// True if an element fits one condition.
template <typename Element>
bool fits_condition(const Condition& condition, const Element& element) {
  const auto holds = [&] {
    switch (condition.kind) {
      case ConditionKind::kIds:
        return std::ranges::binary_search(condition.ids, element.id());
      case ConditionKind::kTag:
        return fits_tag(condition, element);
      case ConditionKind::kBox:
        return element.any_place([&](source::Location at) { return is_in(condition.box, at); });
      case ConditionKind::kNear:
        break;
    }
    return element.any_place([&](source::Location at) { return is_in(condition.circle, at); });
  };
  return holds() != condition.is_negated;
}

/// True if an element fits all conditions of a line, and is not too far from the place that the line gives it.
template <typename Element>
bool fits(const Edit& edit, const Element& element) {
  const auto& placed = edit.changes.placed;
  const auto is_near = [&](source::Location at) { return is_in(circle_about(*placed, kFarthestPlace_m), at); };
  return std::ranges::all_of(edit.filter, [&](const Condition& each) { return fits_condition(each, element); }) &&
         (!placed || element.any_place(is_near));
}

}  // namespace citykiln::edits
