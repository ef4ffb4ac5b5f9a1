// Ids of elements that edits add.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/edits/edit.h"

namespace citykiln::edits {

/// Ids of added elements are at most this. Elements of OpenStreetMap have positive ids, and editors count those of new
/// ones down from -1, so that none of a map is in this range.
inline constexpr std::int64_t kLargestNewId = -(std::int64_t{1} << 60);

/// Returns the id of a new element, which depends on its type and its points alone: it stays as it is when the tags of
/// the line or other lines of the file change.
/// @param ordinal  The number of earlier elements of the file with this type and these points.
OsmId new_element_id(OsmType type, bool is_area, std::span<const NewPoint> points, std::uint32_t ordinal);

/// Returns the id of a node at a place. Added ways that meet at a place have this node in common.
std::int64_t new_node_id(source::Location at);

}  // namespace citykiln::edits
