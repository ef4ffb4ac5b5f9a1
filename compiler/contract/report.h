// Diagnoses of what was mended, approximated or dropped, and the ledger that counts objects through all stages.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/contract/stable_id.h"

namespace citykiln {

enum class Severity : std::uint8_t { kNote, kMended, kDropped };

enum class Code : std::uint8_t {
#define CODE(name, severity, text) name,
#include "compiler/contract/diagnosis_codes.inc"
#undef CODE
};

std::string_view name_of(Code code);  ///< "MissingNode".
std::string_view text_of(Code code);  ///< The meaning, without a full stop.
Severity severity_of(Code code);
std::string_view name_of(Severity severity);  ///< "note", "mended", "dropped".

struct Diagnosis {
  Code code;
  OsmId object;
  double size = 0;                              ///< In the unit that the code's text states; 0 if it states none.
  std::optional<std::array<double, 2>> at_m{};  ///< Where, in the plane; none: where the object is.
  OsmId other{};                                ///< The other of two objects that it is about; none: it is about one.
  std::string tag{};                            ///< "width=wide": of a tag that it is about, valid UTF-8.
};

/// An account of the ledger: the objects of one kind in one stage. It balances if in + split = out + merged + dropped.
struct Account {
  std::uint64_t in = 0;
  std::uint64_t split = 0;  ///< Additional objects, where one became several.
  std::uint64_t out = 0;
  std::uint64_t merged = 0;  ///< Objects that became part of another (a building's outline of its parts).
  std::map<Code, std::uint64_t> dropped;

  bool balances() const;
};

/// The diagnoses and the ledger of a run. Parallel loops fill one Report for each slot and append them in order.
///
/// A report can be limited to some objects (limit_to). Then the others are neither diagnosed nor counted: a region of a
/// plan reports the objects that it owns, and the reports of all regions add up to that of one run.
class Report {
 public:
  void add(const Diagnosis& diagnosis) {
    if (counts(diagnosis.object)) diagnoses_.push_back(diagnosis);
  }
  void add(Code code, OsmId object, double size = 0) { add({code, object, size}); }

  /// Adds a diagnosis of two objects.
  void add_pair(Code code, OsmId object, OsmId other, double size) { add({code, object, size, {}, other}); }

  /// Adds a diagnosis of a tag of an object. The value may be of any bytes; what is not UTF-8 is replaced.
  void add_tag(Code code, OsmId object, std::string_view key, std::string_view value);

  /// Adds a diagnosis of a place (x, y in the plane) that no one object explains.
  void add_at(Code code, std::array<double, 2> at_m, double size) { add({code, {}, size, at_m}); }

  /// From now on counts only these objects, sorted by id. What is there already stays.
  void limit_to(std::vector<OsmId> objects) { limit_ = std::move(objects); }
  /// Counts all objects again.
  void lift_limit() { limit_.reset(); }
  /// Whether an object is diagnosed and counted. O(1), or O(log n) for n objects of a limit.
  bool counts(OsmId object) const { return !limit_ || std::ranges::binary_search(*limit_, object); }

  /// Adds the diagnosis and counts the object as dropped from `account`.
  void drop(Account& account, Code code, OsmId object, double size = 0);

  /// The account of a feature kind ("building") in a stage ("map"), created if missing. Valid as long as the report.
  Account& account(std::string_view stage, std::string_view kind);

  void append(const Report& other);

  const std::vector<Diagnosis>& diagnoses() const { return diagnoses_; }
  /// Keyed by "stage/kind".
  const std::map<std::string, Account, std::less<>>& ledger() const { return ledger_; }
  std::map<Code, std::uint64_t> counts() const;
  bool balances() const;

 private:
  std::vector<Diagnosis> diagnoses_;
  std::optional<std::vector<OsmId>> limit_;
  std::map<std::string, Account, std::less<>> ledger_;
};

}  // namespace citykiln
