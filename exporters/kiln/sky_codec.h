// Converts between sky::Sky and the sky in the header of a manifest (MANIFEST.md, Header).
#pragma once

#include <optional>

#include "compiler/sky/recipe.h"
#include "exporters/manifest_generated.h"

namespace citykiln::exporters {

/// Writes a sky for a header that is being built and returns its place; call it while no other table is open.
/// Directions and the lit share of the moon are in steps of 2^-20, of which sky::Sky holds multiples; nothing else is
/// rounded.
flatbuffers::Offset<fbs::Sky> encode_sky(flatbuffers::FlatBufferBuilder& builder, const sky::Sky& sky);

/// Reads a sky from a verified buffer. Empty if a value is missing or outside of what compile writes, such as the time,
/// the length of a direction, the haze or the number of clouds.
std::optional<sky::Sky> decode_sky(const fbs::Sky& sky);

}  // namespace citykiln::exporters
