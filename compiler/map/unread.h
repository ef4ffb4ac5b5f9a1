// Diagnoses what no reader of features has read, so that nothing with a body is silently absent.
#pragma once

#include "compiler/map/features.h"
#include "compiler/map/read_context.h"

namespace citykiln::map {

/// Diagnoses kUnknownKind, with the tag that says its kind, for each element within the extent that is a thing with a
/// body (source/bodies.h) and neither a feature nor dropped already. Power lines count, since only their corridors are
/// features. Elements without a body are counted. Ways with the tag of a multipolygon that they belong to count as
/// merged. Ledger "map/unread". O(n log n).
void diagnose_unread(const ReadContext& context, const Features& features);

}  // namespace citykiln::map
