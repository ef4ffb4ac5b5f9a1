// The layout "shared": meshes of prototypes and images of a .glb in files of their own, which many tiles refer to.
//
//     glb/0_0_L1.glb                    refers to
//     glb/shared/<hash>_<bytes>.bin     the mesh of a plant or lamp
//     glb/shared/<hash>_<bytes>.png     the image of a material or of a plant's cards
//
// What is shared depends on the shipped tables only: on the prototype, the tolerance and the compression, never on
// the tiles of a run. So tiles that are compiled apart refer to the same files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

struct GlbParts;  // glb_parts.h, with the JSON library

struct SharedFile {
  std::string name;  ///< Relative to the folder of the .glb, "shared/0123456789abcdef_4096.bin".
  std::vector<std::byte> bytes;
};

struct SharedGlb {
  std::vector<std::byte> glb;
  std::vector<SharedFile> files;  ///< By their first use; each name once. Equal names mean equal bytes.
};

/// Joins a .glb whose meshes of instanced nodes, and all images but the tile's own atlases, are moved into files.
/// @param glb  As build_glb() made it, packed or not.
SharedGlb share_prototypes(GlbParts glb);

/// Whether a .glb may refer to a file by this URI: "shared/", then letters, digits, "_" and ".", no other folder. Only
/// these are ever opened.
bool is_shared_uri(std::string_view uri);

/// Returns the .glb with all files embedded that it refers to; the same bytes where there are none. Errors, in one
/// line: a URI that is not is_shared_uri(), a missing file, a symbolic link, a file that is not as long as the .glb
/// says, one file twice. Reads no more than the files, each once.
/// @param folder  That of the .glb. @param name  The file's name in error messages.
Result<std::vector<std::byte>> with_shared_files(std::vector<std::byte> glb, const std::string& folder,
                                                 const std::string& name);

}  // namespace citykiln::exporters
