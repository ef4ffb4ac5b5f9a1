// The layout "shared": prototype meshes and images of a .glb are separate files, to which many tiles refer.
//
//     glb/0_0_L1.glb                    refers to
//     glb/shared/<hash>_<bytes>.bin     the mesh of a plant or lamp
//     glb/shared/<hash>_<bytes>.png     the image of a material or of a plant's cards
//
// Shared files depend only on the prototype, the tolerance and the compression, never on the tiles of a run. So tiles
// that are compiled separately refer to the same files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

struct GlbParts;  // glb_parts.h, with the JSON library

/// A file that tiles share.
struct SharedFile {
  std::string name;  ///< The path relative to the .glb's folder: "shared/0123456789abcdef_4096.bin".
  std::vector<std::byte> bytes;
};

/// A .glb and the files that it refers to.
struct SharedGlb {
  std::vector<std::byte> glb;     ///< The .glb with URIs in place of the bytes of `files`.
  std::vector<SharedFile> files;  ///< In the order of their first use, each once. Equal names mean equal bytes.
};

/// Splits a .glb: the meshes of instanced nodes but stands, and all images but the tile's own atlases, become shared
/// files.
/// Returns the files as bytes; the caller writes them.
/// @param glb  The output of build_glb(), with or without compression of its meshes.
SharedGlb share_prototypes(GlbParts glb);

/// True if a .glb may refer to a file by this URI: "shared/", then letters, digits, "_" and ".". No other files are
/// ever opened.
bool is_shared_uri(std::string_view uri);

/// Embeds all files that a .glb refers to. Returns the same bytes if there are none. Errors: a URI that is not
/// is_shared_uri(), a missing file, a symbolic link, a file whose length differs from the .glb's statement, a URI that
/// appears twice. share_prototypes() writes each URI once, so repeated ones come from damaged files; refusing them
/// bounds the result by the sizes of the files.
///
/// @param folder  The folder of the .glb.
/// @param name    The name of the file in error messages.
Result<std::vector<std::byte>> with_shared_files(std::vector<std::byte> glb, const std::string& folder,
                                                 const std::string& name);

}  // namespace citykiln::exporters
