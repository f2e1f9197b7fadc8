#pragma once

#include <string>

namespace planetree::tool {

/// Prints a page for people on standard output. Throws what `writeFile` throws.
void printPage(const std::string& page);

}  // namespace planetree::tool
