// The loop over ways that the readers of tracks, waterways and barriers share.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/map/readers/feature_readers.h"
#include "compiler/map/tags/standing.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {

/// Returns the code with which a line or point is dropped that is not there, or not on the ground. Waterways
/// underground go on, since they join those above.
inline std::optional<Code> reason_without(const ReadContext& context, source::Range tags, std::string_view key) {
  Standing standing = standing_of_object(context.osm, tags, key);
  if (key == "waterway") standing.storey = Storey::kGround;
  return reason_to_drop(standing);
}

/// Calls make(way, *row, LocatedLine&&) for every way of a kind that has a length and is near the extent. Ways tagged
/// area=yes are left to locate_areas(), ways without a row to diagnose_unread(). Keeps the account "map/<account_name>"
/// and diagnoses ways that are dropped or leave the extent. O(ways).
/// @param is_of_kind  True for the ways to read.
/// @param row_of      Returns a way's row in the table of the kind, or null.
/// @param reason_of   Returns the code with which a way is dropped that is not there; nothing for others.
template <typename IsOfKind, typename RowOf, typename ReasonOf, typename Make>
void for_each_line(const ReadContext& context, const char* account_name, IsOfKind is_of_kind, RowOf row_of,
                   ReasonOf reason_of, Make make) {
  Account account;
  for (const source::Way& way : context.osm.ways) {
    if (!is_of_kind(way) || says_yes(context.tag(way.tags, "area"))) continue;
    const auto* row = row_of(way);
    const std::optional<Code> reason = reason_of(way);
    if (row == nullptr && !reason) continue;
    const OsmId id{OsmType::kWay, way.id};
    account.in += context.report.counts(id);
    LocatedLine line = located(context, way);
    if (reason)
      context.report.drop(account, *reason, id);
    else if (line.axis.size() < 2)
      context.report.drop(account, Code::kNoLength, id);
    else if (!is_near(context, line.axis))
      context.report.drop(account, Code::kOutsideBounds, id);
    else
      diagnose_cut(context, id, line.axis), make(way, *row, std::move(line)), account.out += context.report.counts(id);
  }
  context.report.account("map", account_name) = account;
}

}  // namespace citykiln::map
