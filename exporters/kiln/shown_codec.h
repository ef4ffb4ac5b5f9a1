// Encodes the members of a header that say which part of the recipes tiles show, and decodes them (MANIFEST.md,
// Header): shares of cars and people, layers, lights, the clip.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/scene/clip.h"
#include "compiler/scene/shown.h"
#include "exporters/manifest_generated.h"

namespace citykiln::exporters {

/// A share as a number: 1 to kFullShare are 1,024ths, 0 is none, kUsualShare the usual share of a table.
inline constexpr std::uint16_t kUsualShare = 0xffff, kFullShare = 1024;

/// Returns the number of a share of cars or people (cars::CarShare, people::PeopleShare).
template <typename Share>
std::uint16_t number_of(const Share& wish) {
  return wish.is_by_table ? kUsualShare : static_cast<std::uint16_t>(wish.share * kFullShare);
}
/// Returns the share of a number; std::nullopt if there is none.
template <typename Share>
std::optional<Share> share_of(std::uint16_t number) {
  if (number == kUsualShare) return Share{.is_by_table = true};
  if (number > kFullShare) return std::nullopt;
  return Share{.share = static_cast<double>(number) / kFullShare};
}

/// Returns the number of a share of lit windows; kUsualShare if none is given.
std::uint16_t number_of_lit_windows(const scene::Shown& shown);
/// Decodes what tiles show. Returns std::nullopt if a value is out of range.
std::optional<scene::Shown> decode_shown(const fbs::Header& header);

/// Adds the rings of a clip to a header that is being built, each outer ring before its holes.
std::vector<flatbuffers::Offset<fbs::ClipRing>> encode_clip(flatbuffers::FlatBufferBuilder& builder,
                                                            const scene::Clip& clip);
/// Decodes the clip. Returns std::nullopt if a ring is damaged; an empty clip if the header has none.
std::optional<scene::Clip> decode_clip(const fbs::Header& header);

}  // namespace citykiln::exporters
