// Diagnoses elements that no reader of features has read, so that no visible thing is missing without a diagnosis.
#pragma once

#include "compiler/map/features.h"
#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// Diagnoses kUnknownKind, with the tag that says its kind, for each visible thing (has_body() in
/// source/areas/bodies.h) that touches the extent, is no feature and was not dropped before. Power lines are diagnosed
/// too, since only their corridors are features. Call it after all readers.
///
/// Other elements are counted as without_body, and ways with the tag of a multipolygon that they belong to as merged.
/// Elements without tags, coastlines and relations with boundary=* are skipped. Ledger "map/unread". O(n log n).
void diagnose_unread(const ReadContext& context, const Features& features);

}  // namespace citykiln::map
