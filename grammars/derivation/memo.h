// Memoised derivation: the first of the shapes that differ only by a rigid motion is derived, and its result is copied
// to the others. A node is one application of a rule body to a shape; a memo entry is the stored result of a node.
//
//   ┌──┬──┬──┐      A node becomes a memo entry if its result depends only on its key: body, arguments, the shape in
//   │A │A'│A'│      coordinates of its scope, the direction of the vertical, appearance. A node that uses its position,
//   └──┴──┴──┘      neighbours, warnings or the value of a random number does not, but the nodes below it may. Random
//                   numbers that only select between branches are allowed: each outcome is an entry of its own, which
//                   stores the intervals of its random numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "grammars/derivation/subtree_copy.h"

namespace citykiln::grammars {

struct Body;
struct Run;
struct Execution;

/// The largest difference between measures of shapes that count as equal: 1 µm, above rounding error and below any
/// visible difference.
inline constexpr double kSame_m = 0x1p-20;

/// The stored result of a node.
struct MemoEntry {
  Subtree subtree;
  bool ready = false;  ///< The node has been derived, and its result depends only on its key and its random draws.
  /// 1 + the index in Memo::entries of the next entry with the same key and other random draws; 0 for none.
  std::uint32_t next = 0;
};

/// A 128-bit hash of all that a node's result depends on. Two different nodes collide with probability 2^-128.
struct MemoKey {
  std::uint64_t a = 0x243f6a8885a308d3u, b = 0x13198a2e03707344u;
  /// Adds integers to the hash.
  void add(std::int64_t word);
  void add(std::int64_t x, std::int64_t y, std::int64_t z);
  bool operator==(const MemoKey&) const = default;
};

/// A hash table from keys to entries of Memo::entries, by linear probing. The number of slots (places of the table) is
/// a power of two, and at most half of them are in use.
struct MemoIndex {
  struct Slot {
    MemoKey key;
    std::uint32_t first = 0;  ///< 1 + the index of the key's first entry in Memo::entries; 0: the slot is free.
  };
  std::vector<Slot> slots = std::vector<Slot>(512);
  std::size_t taken = 0;  ///< The number of slots in use.

  /// Returns Slot::first of the key. If the key is new, it is added with 0, which the caller must replace. The
  /// reference is valid until the next call.
  std::uint32_t& operator[](const MemoKey& key);
};

/// Statistics of the nodes of one body, by which recording ends where copies are rare.
struct BodyRecord {
  bool never = false;  ///< Nodes of the body are no longer recorded.
  /// The numbers of nodes that were derived, copied, and too small to be worth recording.
  std::uint32_t misses = 0, hits = 0, small_ones = 0;
};

/// A node that is being derived and may become a memo entry.
struct OpenNode {
  std::uint32_t node = 0;
  int depth = 0;
  int deepest = 0;            ///< The greatest depth of rules within the node.
  bool is_repeatable = true;  ///< The result depends only on the key and random draws until now.
};

/// All memo entries of a derivation, and the state of recording.
struct Memo {
  std::vector<MemoEntry> entries;
  MemoIndex first_of;  ///< The first entry of each key.
  /// The indices of entries whose terminals are still in the derivation, in the order of the terminals.
  std::vector<std::uint32_t> seen;
  std::vector<RemovedTerminals> removed;
  std::vector<OpenNode> open;      ///< The nodes being recorded, each a descendant of the one before it.
  std::vector<BodyRecord> bodies;  ///< By Body::number.
};

/// The memo entry found for a node, or the state from which a new entry is recorded.
struct Recording {
  std::uint32_t entry = 0;  ///< 1 + index into Memo::entries; 0: the node is not recorded.
  bool known = false;       ///< The entry is complete, so the node is copied instead of derived.
  SubtreeRows before;       ///< The sizes of the run's tables before the node.
};

/// Looks up the memo entry of a node, and begins a new entry if there is none. Must be called before any operation has
/// changed the node's shape.
/// @param body  The body that is applied to the shape.
Recording begin_recording(Execution& execution, const Body& body);

/// Updates the greatest depth of rules (OpenNode::deepest) for the nodes being recorded.
void note_depth(Memo& memo, int depth);

/// Copies the result of the recording's entry to the node's shape, and returns the trace of the copy: its displacement
/// and appearances.
/// @param recording  Its entry is known.
NodeTrace repeat(Execution& execution, const Recording& recording);

/// Stores the result of a derived node in its memo entry. Recordings must end in the reverse order of their beginnings.
/// @param trace  The trace of the node: its displacement and appearances.
void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace);

/// Removes the terminals from index `first` to the last from the derivation. Memo entries of these terminals keep a
/// copy.
void remove_terminals_from(Run& run, std::size_t first);

}  // namespace citykiln::grammars
