// Encodes the sky of a header, and decodes it (MANIFEST.md, Header).
#pragma once

#include <optional>

#include "compiler/sky/recipe.h"
#include "exporters/manifest_generated.h"

namespace citykiln::exporters {

/// Adds a sky to a header that is being built. Directions are rounded to steps of 2^-20.
flatbuffers::Offset<fbs::Sky> encode_sky(flatbuffers::FlatBufferBuilder& builder, const sky::Sky& sky);

/// Decodes a sky. Returns std::nullopt where its values are not such as compile writes.
std::optional<sky::Sky> decode_sky(const fbs::Sky& sky);

}  // namespace citykiln::exporters
