#include "compiler/contract/findings/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/contract/texts/utf8.h"

namespace citykiln {
namespace {

struct CodeRow {
  std::string_view name;
  Severity severity;
  std::string_view text;
};

constexpr CodeRow kCodes[] = {
#define CODE(name, severity, text) {#name, Severity::severity, text},
#include "compiler/contract/findings/diagnosis_codes.inc"
#undef CODE
};

const CodeRow& row_of(Code code) { return kCodes[static_cast<std::size_t>(code)]; }

}  // namespace

std::string_view name_of(Code code) { return row_of(code).name.substr(1); }
std::string_view text_of(Code code) { return row_of(code).text; }
Severity severity_of(Code code) { return row_of(code).severity; }

std::string_view name_of(Severity severity) {
  constexpr std::array<std::string_view, 3> kNames = {"note", "mended", "dropped"};
  return kNames[static_cast<std::size_t>(severity)];
}

bool Account::balances() const {
  std::uint64_t lost = 0;
  for (const auto& [code, count] : dropped) lost += count;
  return in + split == out + merged + without_body + lost;
}

std::string tag_text(std::string_view key, std::string_view value) {
  return to_valid_utf8(fmt::format("{}={}", key, value));
}

void Report::add_tag(Code code, OsmId object, std::string_view key, std::string_view value) {
  if (!counts(object)) return;
  Diagnosis& diagnosis = diagnoses_.emplace_back(Diagnosis{code, object});
  diagnosis.tag = tag_text(key, value);
}

void Report::drop(Account& account, const Diagnosis& diagnosis) {
  if (!counts(diagnosis.object)) return;
  add(diagnosis);
  ++account.dropped[diagnosis.code];
}

Account& Report::account(std::string_view stage, std::string_view kind) {
  return ledger_[std::string(stage) + "/" + std::string(kind)];
}

void Report::append(const Report& other) {
  diagnoses_.insert(diagnoses_.end(), other.diagnoses_.begin(), other.diagnoses_.end());
  for (std::size_t i = 0; i < assumed_.size(); ++i) assumed_[i] += other.assumed_[i];
  for (const auto& [name, theirs] : other.ledger_) {
    Account& ours = ledger_[name];
    ours.in += theirs.in;
    ours.split += theirs.split;
    ours.out += theirs.out;
    ours.merged += theirs.merged;
    ours.without_body += theirs.without_body;
    for (const auto& [code, count] : theirs.dropped) ours.dropped[code] += count;
  }
}

std::map<Code, std::uint64_t> Report::counts() const {
  std::map<Code, std::uint64_t> counts;
  for (const Diagnosis& diagnosis : diagnoses_) ++counts[diagnosis.code];
  return counts;
}

bool Report::balances() const {
  return std::all_of(ledger_.begin(), ledger_.end(), [](const auto& entry) { return entry.second.balances(); });
}

}  // namespace citykiln
