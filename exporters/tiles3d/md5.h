// MD5, by which an archive of 3D Tiles finds its files. It distinguishes names; it does not prevent forgery.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace citykiln::exporters {

/// Returns the MD5 of a text, in the order in which `md5sum` prints it. Source: R. Rivest, "The MD5 Message-Digest
/// Algorithm", RFC 1321.
std::array<std::byte, 16> md5(std::string_view text);

}  // namespace citykiln::exporters
