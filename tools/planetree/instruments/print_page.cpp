#include "instruments/print_page.hpp"

#include "output_file.hpp"

#include <span>

namespace planetree::tool {

void printPage(const std::string& page) {
  writeFile(kStandardOutput, std::as_bytes(std::span(page)));
}

}  // namespace planetree::tool
