#pragma once

namespace planetree::tool {

/// How the tool ends, the same for all subcommands.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

}  // namespace planetree::tool
