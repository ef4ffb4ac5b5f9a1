// The report of a run: diagnoses of data that was mended, approximated or dropped, and the ledger, which counts the
// objects that go into each stage and come out of it.
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

#include "compiler/contract/findings/assumption.h"
#include "compiler/contract/stable_id.h"

namespace citykiln {

/// The effect of a finding: nothing was lost, the object was changed, or the object is not in the outputs.
enum class Severity : std::uint8_t { kNote, kMended, kDropped };

/// The rows of diagnosis_codes.inc.
enum class Code : std::uint8_t {
#define CODE(name, severity, text) name,
#include "compiler/contract/findings/diagnosis_codes.inc"
#undef CODE
};

std::string_view name_of(Code code);  ///< "MissingNode".
std::string_view text_of(Code code);  ///< The text of the row, without a full stop.
Severity severity_of(Code code);
std::string_view name_of(Severity severity);  ///< "note", "mended", "dropped".

/// Returns "key=value" as valid UTF-8; other bytes are replaced.
std::string tag_text(std::string_view key, std::string_view value);

/// One finding about the data.
struct Diagnosis {
  Code code;
  OsmId object;
  double size = 0;                              ///< In the unit that the code's text states; 0 if it states none.
  std::optional<std::array<double, 2>> at_m{};  ///< The place, in metres in the plane; empty: where `object` is.
  OsmId other{};  ///< The second object of a finding about two objects; else of OsmType::kNone.
  /// The tag of a finding about a tag, such as "width=wide", or the tag that says what a dropped object is, such as
  /// "man_made=mast", or the place and fault of a rule; else empty. Valid UTF-8.
  std::string tag{};
};

/// The counts of one kind of objects in one stage. They balance if in + split = out + merged + without_body + dropped.
struct Account {
  std::uint64_t in = 0;
  std::uint64_t split = 0;  ///< Objects added where one became several.
  std::uint64_t out = 0;
  std::uint64_t merged = 0;        ///< Objects that became part of another, such as a building's parts.
  std::uint64_t without_body = 0;  ///< Elements that nothing is built of, such as boundaries, routes and addresses.
  std::map<Code, std::uint64_t> dropped;

  bool balances() const;
};

/// The diagnoses and the ledger of a run. Parallel loops fill one Report per slot and append them in order.
///
/// A report can be limited to a set of objects (limit_to). It then ignores diagnoses and drops of all other objects and
/// what is assumed of them, and diagnoses without an object (add_at). A plan in regions uses this: each region reports
/// the objects that it owns, and the reports of all regions add up to the report of a single run.
class Report {
 public:
  void add(const Diagnosis& diagnosis) {
    if (counts(diagnosis.object)) diagnoses_.push_back(diagnosis);
  }
  void add(Code code, OsmId object, double size = 0) { add({code, object, size}); }

  /// Adds a diagnosis of two objects.
  void add_pair(Code code, OsmId object, OsmId other, double size) { add({code, object, size, {}, other}); }

  /// Adds a diagnosis of a tag of an object. Bytes of the value that are not UTF-8 are replaced.
  void add_tag(Code code, OsmId object, std::string_view key, std::string_view value);

  /// Adds a diagnosis of a place (x, y in the plane) that belongs to no single object.
  void add_at(Code code, std::array<double, 2> at_m, double size) { add({code, {}, size, at_m}); }

  /// Limits later diagnoses, drops and calls of count_assumed() to these objects, sorted by id. Diagnoses without an
  /// object are ignored. account(), append() and add_assumed() are not limited: callers ask counts(). Earlier diagnoses
  /// are kept.
  void limit_to(std::vector<OsmId> objects) { limit_ = std::move(objects); }
  /// Adds objects, in any order, to those that a limit lets through. Without a limit nothing changes.
  void count_also(const std::vector<OsmId>& objects) {
    if (!limit_) return;
    limit_->insert(limit_->end(), objects.begin(), objects.end());
    std::ranges::sort(*limit_);
  }
  /// Ends the limit.
  void lift_limit() { limit_.reset(); }
  /// True if the object is diagnosed and counted. O(1) without a limit, O(log n) with a limit of n objects.
  bool counts(OsmId object) const { return !limit_ || std::ranges::binary_search(*limit_, object); }

  /// Adds the diagnosis and counts its object as dropped in `account`.
  void drop(Account& account, const Diagnosis& diagnosis);
  void drop(Account& account, Code code, OsmId object, double size = 0) { drop(account, {code, object, size}); }

  /// Returns the account of a kind of features ("building") in a stage ("map"), and creates it if it is missing. Valid
  /// as long as the report.
  Account& account(std::string_view stage, std::string_view kind);

  /// Counts an object of which something is assumed.
  void count_assumed(Assumption assumption, OsmId object) {
    if (counts(object)) ++assumed_[static_cast<std::size_t>(assumption)];
  }
  /// Counts objects of another report.
  void add_assumed(Assumption assumption, std::uint64_t objects) {
    assumed_[static_cast<std::size_t>(assumption)] += objects;
  }
  /// Returns the number of objects of which this is assumed.
  std::uint64_t assumed(Assumption assumption) const { return assumed_[static_cast<std::size_t>(assumption)]; }

  /// Appends the diagnoses and adds the counts of another report.
  void append(const Report& other);

  const std::vector<Diagnosis>& diagnoses() const { return diagnoses_; }
  /// Removes the diagnoses for which is_gone(diagnosis) is true; the ledger stays.
  template <typename IsGone>
  void remove_diagnoses_if(IsGone is_gone) {
    std::erase_if(diagnoses_, is_gone);
  }

  /// Returns the accounts by "stage/kind".
  const std::map<std::string, Account, std::less<>>& ledger() const { return ledger_; }
  /// Returns the number of diagnoses of each code.
  std::map<Code, std::uint64_t> counts() const;
  bool balances() const;

 private:
  std::vector<Diagnosis> diagnoses_;
  std::optional<std::vector<OsmId>> limit_;
  std::map<std::string, Account, std::less<>> ledger_;
  std::array<std::uint64_t, static_cast<std::size_t>(Assumption::kCount)> assumed_{};
};

}  // namespace citykiln
