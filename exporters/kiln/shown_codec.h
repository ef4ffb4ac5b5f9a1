// Converts between members of a manifest's header and what they say that tiles show (MANIFEST.md, Header): shares of
// cars and people, lit windows, the clip. Layers, the density of woods and lamps are decoded here and written by
// manifest.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/scene/clip.h"
#include "compiler/scene/shown.h"
#include "exporters/manifest_generated.h"

namespace citykiln::exporters {

/// The stored form of a share: 0 to kFullShare are 1,024ths, kUsualShare says that tables decide by place and hour.
/// Other values are invalid.
inline constexpr std::uint16_t kUsualShare = 0xffff, kFullShare = 1024;

/// Encodes a share of cars or people (cars::CarShare, people::PeopleShare): a multiple of 1/1,024.
template <typename Share>
std::uint16_t encode_share(const Share& wish) {
  return wish.is_by_table ? kUsualShare : static_cast<std::uint16_t>(wish.share * kFullShare);
}
/// Decodes a share; empty if the stored value is neither kUsualShare nor at most kFullShare.
template <typename Share>
std::optional<Share> decode_share(std::uint16_t number) {
  if (number == kUsualShare) return Share{.is_by_table = true};
  if (number > kFullShare) return std::nullopt;
  return Share{.share = static_cast<double>(number) / kFullShare};
}

/// Encodes Shown::lit_windows; kUsualShare if that is empty.
std::uint16_t encode_lit_windows(const scene::Shown& shown);
/// Decodes layers, density of woods, lamps and lit windows. Empty if one of them is out of range.
std::optional<scene::Shown> decode_shown(const fbs::Header& header);

/// Adds the rings of a clip to a header that is being built, each outer ring before its holes.
std::vector<flatbuffers::Offset<fbs::ClipRing>> encode_clip(flatbuffers::FlatBufferBuilder& builder,
                                                            const scene::Clip& clip);
/// Decodes the clip; a clip without rings if the header has none. Empty if a ring has fewer than 3 points or unequal
/// numbers of x and y, or if a hole comes first. Whether rings cross is not tested.
std::optional<scene::Clip> decode_clip(const fbs::Header& header);

}  // namespace citykiln::exporters
