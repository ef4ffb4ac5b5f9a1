// Reads the tags of a street lamp.
#pragma once

#include "compiler/map/lamps/lamp_tags.h"
#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// Returns lamp_type (or light:method), lamp_mount, light:count, light:colour and light:lumen (or luminous_flux) of a
/// lamp. Unknown types, mounts and names of colours are ignored. Diagnosed: kBadTagValue for counts, temperatures and
/// lumen that are no numbers or out of range.
LampTags read_lamp_tags(const ReadContext& context, OsmId id, source::Range tags);

}  // namespace citykiln::map
