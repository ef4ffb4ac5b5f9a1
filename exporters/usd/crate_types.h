// The parts of the crate format (.usdc), version 0.8, that citykiln writes and reads. Source: OpenUSD, "USDC File
// Format Specification".
//
//     88 bytes       "PXR-USDC", version, offset of the table of contents
//     values         scalars and arrays, each at a multiple of 8
//     TOKENS         all texts, LZ4
//     STRINGS        numbers of tokens that are texts: all
//     FIELDS         pairs of a name (a token) and a value (8 bytes: flags, type, and 48 bits of value or offset)
//     FIELDSETS      lists of fields, each ended by -1
//     PATHS          the tree of prims and properties, depth first
//     SPECS          a path, a list of fields and a type for each prim and property
//     contents       name, offset and size of the sections
#pragma once

#include <cstdint>

namespace citykiln::exporters {

inline constexpr char kCrateMagic[9] = "PXR-USDC";
inline constexpr std::uint64_t kCrateBootstrapBytes = 88, kCrateSectionNameBytes = 16;

enum class CrateType : std::uint8_t {
  kBool = 1,
  kInt = 3,
  kInt64 = 5,
  kFloat = 8,
  kDouble = 9,
  kString = 10,
  kToken = 11,
  kAssetPath = 12,
  kQuath = 18,
  kVec2f = 20,
  kVec3d = 23,
  kVec3f = 24,
  kVec4f = 28,
  kDictionary = 31,
  kTokenListOp = 32,
  kPathListOp = 34,
  kTokenVector = 41,
  kSpecifier = 42,
  kVariability = 44
};

enum class CrateSpec : std::int32_t { kAttribute = 1, kPrim = 6, kPseudoRoot = 7, kRelationship = 8 };

inline constexpr std::uint64_t kCrateArray = std::uint64_t{1} << 63, kCrateInlined = std::uint64_t{1} << 62,
                               kCrateCompressed = std::uint64_t{1} << 61, kCratePayload = (std::uint64_t{1} << 48) - 1;

/// The least number of integers in an array that is compressed.
inline constexpr std::size_t kCrateLeastCompressed = 16;

/// Flags of lists of tokens and paths.
inline constexpr std::uint8_t kListExplicit = 0x03, kListPrepended = 0x20;

/// Jumps in PATHS, one for each entry. Entries are in depth-first order, so that the first child of a prim follows it.
/// kJumpSibling: no child, the next entry is a sibling. kJumpChild: a child follows, and there is no further sibling.
/// kJumpLeaf: neither. A number above 0: a child follows, and the next sibling is that many entries on.
inline constexpr std::int32_t kJumpSibling = 0, kJumpChild = -1, kJumpLeaf = -2;

}  // namespace citykiln::exporters
