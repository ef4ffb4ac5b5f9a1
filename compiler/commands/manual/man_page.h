// The manual page citykiln(1), made from the tables of the verbs, so that it lists every option.
#pragma once

#include <span>
#include <string>

#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// Returns the manual page in the language of man(7). It has a section for each verb with its options and examples, and
/// no date, so the same tables give the same bytes. Hidden verbs are left out.
std::string man_page(std::span<const Verb> verbs);

/// Returns the manual page of one verb, citykiln-VERB(1): its usage, options and examples, and the options of all
/// verbs.
std::string man_page_of(const Verb& verb);

}  // namespace citykiln::commands
