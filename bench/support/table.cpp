#include "bench/support/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace planetree::bench {

namespace {

std::string markdownRow(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells)
    row += fmt::format(" {} |", escapedForCell(cell));
  return row + "\n";
}

}  // namespace

std::string escapedForCell(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|')
      safe += '\\';
    safe += c;
  }
  return safe;
}

std::string alignedLines(const std::vector<std::vector<std::string>>& lines,
                         std::size_t labelCount) {
  std::vector<std::size_t> widths;
  for (const auto& line : lines) {
    widths.resize(std::max(widths.size(), line.size()), 0);
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0)
        text += "  ";
      if (i < labelCount)
        fmt::format_to(std::back_inserter(text), "{:<{}}", line[i], widths[i]);
      else
        fmt::format_to(std::back_inserter(text), "{:>{}}", line[i], widths[i]);
    }
    text += '\n';
  }
  return text;
}

std::string toText(const Table& table) {
  std::vector<std::vector<std::string>> lines = {table.header};
  lines.insert(lines.end(), table.rows.begin(), table.rows.end());
  return table.title + "\n" + alignedLines(lines, 1);
}

std::string toMarkdown(const Table& table) {
  std::vector<std::string> rule(table.header.size(), "---:");
  rule.front() = "---";
  std::string text = markdownRow(table.header) + markdownRow(rule);
  for (const auto& row : table.rows)
    text += markdownRow(row);
  return text;
}

}  // namespace planetree::bench
