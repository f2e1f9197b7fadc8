#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace planetree::bench {

/// Texts in rows and columns, under a title. All rows are as long as the header.
struct Table {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Lines of texts, the columns as wide as their longest one: the first `labelCount` columns on the
/// left of their place, the others on the right.
[[nodiscard]] std::string alignedLines(const std::vector<std::vector<std::string>>& lines,
                                       std::size_t labelCount);

/// In plain text, to be read in a terminal. The first column has the labels.
[[nodiscard]] std::string toText(const Table& table);

/// As it may stand in a cell of a page.
[[nodiscard]] std::string escapedForCell(const std::string& text);

/// Likewise for a page, without the title.
[[nodiscard]] std::string toMarkdown(const Table& table);

}  // namespace planetree::bench
