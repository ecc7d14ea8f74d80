#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/application.hpp"

namespace umbral::grader {

/// A page in Markdown that tells of unit by unit, in rows "| topic/unit | … |" of its first table or in sections
/// "## topic/unit", with what another such page says of units that the fresh one says nothing of. The beginning is the
/// fresh one's; units come in this order, and any that are not in it are left out.
[[nodiscard]] std::string with_other_units(std::string_view fresh, std::string_view kept,
                                           std::span<const std::string> order);

/// Writes such a page. What a file there already says of other units stays. Throws UsageError if it cannot be written.
void write_unit_page(const Application& application, const std::string& file, const std::string& page);

}
