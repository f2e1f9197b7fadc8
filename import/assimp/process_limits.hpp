#pragma once

#include <cstdint>

namespace planetree::importing {

/// Returns a descriptor of standard output, and lets all that is printed from then on go nowhere.
[[nodiscard]] int takeStandardOutput();

/// Bounds what this process can do to the machine: its address space, in bytes; no files written,
/// no core left behind; and it ends with its parent, whose process id is given.
void limitProcess(std::uint64_t memory, long parent);

}  // namespace planetree::importing
