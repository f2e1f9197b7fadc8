#pragma once

#include <string>

namespace planetree::tool {

/// Prints a page for people on standard output. A reader who leaves early, as `head` does, has seen
/// enough, and that is no failure. Throws `Error` with `FileNotWritable`.
void printPage(const std::string& page);

}  // namespace planetree::tool
