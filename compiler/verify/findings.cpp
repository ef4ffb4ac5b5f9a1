#include "compiler/verify/findings.h"

namespace citykiln::verify {
namespace {

// In the order in which they are told.
constexpr Finding Findings::*kPromises[] = {&Findings::ledger, &Findings::forms,   &Findings::area,  &Findings::height,
                                            &Findings::seams,  &Findings::jumps,   &Findings::roads, &Findings::rivers,
                                            &Findings::lakes,  &Findings::footing, &Findings::trunks};

}  // namespace

std::vector<const Finding*> all_of(const Findings& findings) {
  std::vector<const Finding*> all;
  for (const auto promise : kPromises) all.push_back(&(findings.*promise));
  return all;
}

void add(Findings& findings, const Findings& of_tile) {
  for (const auto promise : kPromises) {
    Finding& all = findings.*promise;
    const Finding& here = of_tile.*promise;
    all.tests += here.tests;
    all.breaches.insert(all.breaches.end(), here.breaches.begin(), here.breaches.end());
  }
  findings.following = worse(findings.following, of_tile.following);
}

}  // namespace citykiln::verify
