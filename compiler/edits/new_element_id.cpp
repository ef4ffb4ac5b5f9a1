#include "compiler/edits/new_element_id.h"

namespace citykiln::edits {
namespace {

std::int64_t as_new_id(StableId hash) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << 60) - 1;
  return kLargestNewId - static_cast<std::int64_t>(static_cast<std::uint64_t>(hash) & kMask);
}

StableId with_point(StableId before, const NewPoint& point) {
  if (point.node) return stable_id(before, "node", static_cast<std::uint64_t>(*point.node));
  const auto lon = static_cast<std::uint32_t>(point.at.lon_e7), lat = static_cast<std::uint32_t>(point.at.lat_e7);
  return stable_id(before, "place", std::uint64_t{lon} << 32 | lat);
}

}  // namespace

OsmId new_element_id(OsmType type, bool is_area, std::span<const NewPoint> points, std::uint32_t ordinal) {
  StableId hash = stable_id(StableId{}, is_area ? "area" : "element", ordinal);
  for (const NewPoint& point : points) hash = with_point(hash, point);
  return {type, as_new_id(hash)};
}

std::int64_t new_node_id(source::Location at) {
  return as_new_id(with_point(stable_id(StableId{}, "added", 0), {std::nullopt, at}));
}

}  // namespace citykiln::edits
